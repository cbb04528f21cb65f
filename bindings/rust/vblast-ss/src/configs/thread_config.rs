// Written by bindings/rust/generate.py from the public headers: do not edit.
use super::defaults;
use super::ThreadArrays;
use crate::sys;

/// Configuration of a thread. Fill it with vbss_thread_config_init, then change fields.
#[derive(Debug, Clone)]
pub struct ThreadConfig<'a> {
    pub(crate) raw: sys::vbss_thread_config,
    pub(crate) arrays: ThreadArrays<'a>,
}

impl Default for ThreadConfig<'_> {
    fn default() -> Self {
        ThreadConfig { raw: defaults(sys::vbss_thread_config_init), arrays: Default::default() }
    }
}

impl ThreadConfig<'_> {
    /// The defaults of the library.
    pub fn new() -> Self {
        Self::default()
    }

    /// Method; default VBSS_METHOD_IMPLICIT.
    pub fn method(mut self, value: sys::vbss_method) -> Self {
        self.raw.method = value;
        self
    }

    /// Method IMPLICIT: discretisation of bending; default VBSS_THREAD_BENDING_SPLINE.
    pub fn bending(mut self, value: sys::vbss_thread_bending) -> Self {
        self.raw.bending = value;
        self
    }

    /// Number of segments, 1 to 65536; default 120.
    pub fn segment_count(mut self, value: u32) -> Self {
        self.raw.segment_count = value;
        self
    }

    /// Largest number of attachments, 0 to 256; default 8.
    pub fn attachment_capacity(mut self, value: u32) -> Self {
        self.raw.attachment_capacity = value;
        self
    }

    /// Largest number of cuts of this thread and its pieces, 0 to 64; default 0.
    pub fn cut_capacity(mut self, value: u32) -> Self {
        self.raw.cut_capacity = value;
        self
    }

    /// Length, m, 1e-6 to 1e3, at least 1e-7 per segment; default 0.15; ignored with
    /// rest_lengths.
    pub fn length(mut self, value: f64) -> Self {
        self.raw.length = value;
        self
    }

    /// Radius, m, 1e-7 to 0.1; default of VBSS_THREAD_PRESET_VBLAST. Contact in a scene and display
    /// use it; a thread alone does not.
    pub fn radius(mut self, value: f64) -> Self {
        self.raw.radius = value;
        self
    }

    /// Mass per length, kg/m, 1e-9 to 1e3; default of that preset.
    pub fn linear_density(mut self, value: f64) -> Self {
        self.raw.linear_density = value;
        self
    }

    /// Axial stiffness EA, N, 1e-6 to 1e9; default of that preset.
    pub fn axial_stiffness(mut self, value: f64) -> Self {
        self.raw.axial_stiffness = value;
        self
    }

    /// Bending stiffness EI, N m^2, 0 to 1e3; default of that preset.
    pub fn bending_stiffness(mut self, value: f64) -> Self {
        self.raw.bending_stiffness = value;
        self
    }

    /// Curvature at rest, 1/m, 0 to 1e4; default 0. Its plane is free, because such a thread has no
    /// twist: it does not work with torsional_stiffness.
    pub fn rest_curvature(mut self, value: f64) -> Self {
        self.raw.rest_curvature = value;
        self
    }

    /// Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default (0,
    /// -9.81, 0).
    pub fn gravity(mut self, value: [f64; 3]) -> Self {
        self.raw.gravity = value;
        self
    }

    /// Drag coefficient, 1/s, 0 to 1e6; default 0. The force is -drag * mass * velocity.
    pub fn drag(mut self, value: f64) -> Self {
        self.raw.drag = value;
        self
    }

    /// Method IMPLICIT: decay rate of the motion relative to the rigid motion of each section, 1/s,
    /// 0 to 1e6; default 0. It conserves linear and angular momentum.
    pub fn damping(mut self, value: f64) -> Self {
        self.raw.damping = value;
        self
    }

    /// Position of node 0, m, each coordinate at most 1e3 in magnitude; default (0, 0, 0); ignored
    /// with positions.
    pub fn start(mut self, value: [f64; 3]) -> Self {
        self.raw.start = value;
        self
    }

    /// Direction from node 0 on, of any length from 1e-100 to 1e100; default (1, 0, 0); ignored
    /// with positions.
    pub fn direction(mut self, value: [f64; 3]) -> Self {
        self.raw.direction = value;
        self
    }

    /// Method IMPLICIT: spectral radius at infinite frequency of the time integration, 0 (strongest
    /// damping) to 1 (none); default 0.3. Above 0.5 stiff motion may gain energy.
    pub fn spectral_radius(mut self, value: f64) -> Self {
        self.raw.spectral_radius = value;
        self
    }

    /// Method IMPLICIT: largest stretch error that a step may leave, 1e-12 to 1e-2; default 1e-6.
    pub fn stretch_tolerance(mut self, value: f64) -> Self {
        self.raw.stretch_tolerance = value;
        self
    }

    /// Method IMPLICIT: largest distance by which a further linearisation would move a node, m, 1e-12
    /// to 1; an estimate; default 1e-6.
    pub fn position_tolerance(mut self, value: f64) -> Self {
        self.raw.position_tolerance = value;
        self
    }

    /// Method IMPLICIT: largest number of linearisations of an attempt, 1 to 100; default 40. Smooth
    /// motion takes one or two. The worst known case (ends shaken by 3 mm every ms) takes 300 in a
    /// step with its halves.
    pub fn iteration_limit(mut self, value: u32) -> Self {
        self.raw.iteration_limit = value;
        self
    }

    /// Method IMPLICIT: how often a step is halved before its state is accepted unconverged, 0 to
    /// 10; default 5. `forced` counts such states and should stay zero.
    pub fn halving_limit(mut self, value: u32) -> Self {
        self.raw.halving_limit = value;
        self
    }

    /// Default VBSS_THREAD_MESH_FIXED, which ignores the following fields.
    pub fn mesh(mut self, value: sys::vbss_thread_mesh) -> Self {
        self.raw.mesh = value;
        self
    }

    /// ADAPTIVE: largest number of nodes, segment_count + 1 to 65537; default 0: four times the
    /// initial number of segments, at most 65536. A scene must have capacity for all of them when
    /// the thread is added.
    pub fn node_capacity(mut self, value: u32) -> Self {
        self.raw.node_capacity = value;
        self
    }

    /// ADAPTIVE: length of the finest segments, m, 1e-7 to coarsest_length; default 3e-4, 1.2
    /// diameters of the paper's thread, at which a tight knot is converged. Because segments are
    /// halved, the finest ones have 0.63 to 1.25 times this length. Choose initial lengths of
    /// this length times a power of two.
    pub fn finest_length(mut self, value: f64) -> Self {
        self.raw.finest_length = value;
        self
    }

    /// ADAPTIVE: a node is not removed if that leaves a segment longer than 1.25 times this
    /// length, m, at most 1e2; default 2e-3.
    pub fn coarsest_length(mut self, value: f64) -> Self {
        self.raw.coarsest_length = value;
        self
    }

    /// ADAPTIVE: curvature times length, rad, above which a segment is divided, 0.01 to 1; default 0.25.
    pub fn refine_angle(mut self, value: f64) -> Self {
        self.raw.refine_angle = value;
        self
    }

    /// ADAPTIVE: curvature times length, rad, below which a node may be removed, 0 to half of
    /// refine_angle; default 0.05.
    pub fn coarsen_angle(mut self, value: f64) -> Self {
        self.raw.coarsen_angle = value;
        self
    }

    /// ADAPTIVE, in a scene: gap, m, to another strand below which a segment is divided down to finest_length, and
    /// to a tool down to a quarter of its radius; 0 to 0.1; default 1e-3. The floor does not count.
    pub fn near_distance(mut self, value: f64) -> Self {
        self.raw.near_distance = value;
        self
    }

    /// ADAPTIVE, in a scene: a node is removed only if no other body is within this gap, m,
    /// near_distance to 0.1; default 3e-3.
    pub fn clear_distance(mut self, value: f64) -> Self {
        self.raw.clear_distance = value;
        self
    }

    /// ADAPTIVE: largest number of divisions and removals after a step, 0 to 64; default 4.
    pub fn mesh_operations(mut self, value: u32) -> Self {
        self.raw.mesh_operations = value;
        self
    }

    /// 1: contacts of a scene resist rolling of the thread about itself by their friction, so that a tight
    /// knot holds twist on either side of itself; 0 (default): they let it roll. Needs
    /// torsional_stiffness. docs/explanation/twist.md has the model.
    pub fn friction_torque(mut self, value: u32) -> Self {
        self.raw.friction_torque = value;
        self
    }

    /// Method IMPLICIT: elastic curvature beyond which bending is plastic, 1/m, 0 to 1e6; default 0:
    /// bending is elastic. The bending moment at yield is EI times this curvature.
    /// docs/explanation/bending-memory.md has the model. Memory of bends, plastic or viscous, needs
    /// VBSS_THREAD_MESH_FIXED and a rest_curvature of 0.
    pub fn yield_curvature(mut self, value: f64) -> Self {
        self.raw.yield_curvature = value;
        self
    }

    /// Stiffness of bending beyond yield as a fraction of EI, 0 (ideally plastic) to 0.999; default
    /// 0. The hardening is linear and kinematic.
    pub fn yield_hardening(mut self, value: f64) -> Self {
        self.raw.yield_hardening = value;
        self
    }

    /// Method IMPLICIT: stiffness of the viscous branch of bending as a fraction of EI, 0 to 1e3;
    /// default 0: there is none. A fast bend has the stiffness EI (1 + relaxation_ratio), a slow one
    /// EI.
    pub fn relaxation_ratio(mut self, value: f64) -> Self {
        self.raw.relaxation_ratio = value;
        self
    }

    /// Time in which the moment of the viscous branch decays to 1/e at constant curvature, s, 1e-6 to
    /// 1e9; default 1.
    pub fn relaxation_time(mut self, value: f64) -> Self {
        self.raw.relaxation_time = value;
        self
    }

    /// Method IMPLICIT: torsional stiffness GJ, N m^2, 0 to 1e3; default 0: the thread has no twist.
    /// docs/explanation/twist.md has the model. Twist needs VBSS_THREAD_MESH_FIXED, a rest_curvature of 0 and
    /// bends without memory.
    pub fn torsional_stiffness(mut self, value: f64) -> Self {
        self.raw.torsional_stiffness = value;
        self
    }

    /// Twist per length at which there is no torque, rad/m, -1e5 to 1e5; default 0; needs
    /// torsional_stiffness.
    pub fn rest_twist(mut self, value: f64) -> Self {
        self.raw.rest_twist = value;
        self
    }
}
