// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// Discretisation of bending: a VBSS_THREAD_BENDING_ constant. Method VBLAST has its own bending.
pub type vbss_thread_bending = i32;

/// Kind of a thread's mesh: a VBSS_THREAD_MESH_ constant.
pub type vbss_thread_mesh = i32;

/// Material of a thread: a VBSS_THREAD_PRESET_ constant.
pub type vbss_thread_preset = i32;

/// Material of a suture: a VBSS_THREAD_MATERIAL_ constant.
pub type vbss_thread_material = i32;

/// Size of a suture by USP <861>: a VBSS_THREAD_USP_ constant.
pub type vbss_thread_usp_size = i32;

/// Kind of an attachment: a VBSS_THREAD_ATTACHMENT_ constant.
pub type vbss_thread_attachment_kind = i32;

/// An array of a thread: a VBSS_THREAD_VIEW_ constant.
pub type vbss_thread_field = i32;

// The constants of vbss_thread_bending.
/// Fourth order: the energy of the cubic spline through the nodes, truncated to neighbours
/// three apart. The length of a segment is that of its arc.
pub const VBSS_THREAD_BENDING_SPLINE: vbss_thread_bending = 0;
/// Second order: each node couples with its two neighbours only. The length of a segment is its
/// chord.
pub const VBSS_THREAD_BENDING_LOCAL: vbss_thread_bending = 1;

// The constants of vbss_thread_mesh.
/// Nodes and rest lengths stay as they were created.
pub const VBSS_THREAD_MESH_FIXED: vbss_thread_mesh = 0;
/// Method IMPLICIT, docs/explanation/adaptive.md: between two steps the thread divides segments where it is
/// bent or near another body, and removes nodes where it is straight and has clearance. This
/// renumbers nodes, segments, attachments, pins, grasps and contacts.
pub const VBSS_THREAD_MESH_ADAPTIVE: vbss_thread_mesh = 1;

// The constants of vbss_thread_preset.
/// 2-0 silk: 0.32 mm, 1.05e-4 kg/m, EA = 700 N (8.7 GPa), EI = 2.7e-8 N m^2. Diameter by USP
/// <861> (0.30 to 0.339 mm), density of a solid braid; EI is that of the paper's thread,
/// scaled with the fourth power of the radius, and uncertain by a factor of five.
pub const VBSS_THREAD_PRESET_SILK_2_0: vbss_thread_preset = 0;
/// The thread of VBLaST-SS: 0.25 mm, 6.4e-5 kg/m, EA = 427 N, EI = 1e-8 N m^2.
pub const VBSS_THREAD_PRESET_VBLAST: vbss_thread_preset = 1;

// The constants of vbss_thread_material. docs/reference/sutures.md has sources and uncertainties.
/// Braided silk.
pub const VBSS_THREAD_MATERIAL_SILK: vbss_thread_material = 0;
/// Braided polyglactin 910, absorbable.
pub const VBSS_THREAD_MATERIAL_POLYGLACTIN: vbss_thread_material = 1;
/// Polypropylene monofilament.
pub const VBSS_THREAD_MATERIAL_POLYPROPYLENE: vbss_thread_material = 2;
/// Nylon monofilament.
pub const VBSS_THREAD_MATERIAL_NYLON: vbss_thread_material = 3;

// The constants of vbss_thread_usp_size, with the middle of the range of the diameter, mm.
/// 0.025 (0.020 to 0.029).
pub const VBSS_THREAD_USP_10_0: vbss_thread_usp_size = -10;
/// 0.035 (0.030 to 0.039).
pub const VBSS_THREAD_USP_9_0: vbss_thread_usp_size = -9;
/// 0.045 (0.040 to 0.049).
pub const VBSS_THREAD_USP_8_0: vbss_thread_usp_size = -8;
/// 0.06 (0.050 to 0.069).
pub const VBSS_THREAD_USP_7_0: vbss_thread_usp_size = -7;
/// 0.085 (0.070 to 0.099).
pub const VBSS_THREAD_USP_6_0: vbss_thread_usp_size = -6;
/// 0.125 (0.100 to 0.149).
pub const VBSS_THREAD_USP_5_0: vbss_thread_usp_size = -5;
/// 0.175 (0.150 to 0.199).
pub const VBSS_THREAD_USP_4_0: vbss_thread_usp_size = -4;
/// 0.225 (0.200 to 0.249).
pub const VBSS_THREAD_USP_3_0: vbss_thread_usp_size = -3;
/// 0.32 (0.300 to 0.339).
pub const VBSS_THREAD_USP_2_0: vbss_thread_usp_size = -2;
/// 0.375 (0.350 to 0.399).
pub const VBSS_THREAD_USP_0: vbss_thread_usp_size = 0;
/// 0.45 (0.400 to 0.499).
pub const VBSS_THREAD_USP_1: vbss_thread_usp_size = 1;
/// 0.55 (0.500 to 0.599).
pub const VBSS_THREAD_USP_2: vbss_thread_usp_size = 2;

// The constants of vbss_thread_attachment_kind.
/// The node is held at `position`.
pub const VBSS_THREAD_ATTACHMENT_PIN: vbss_thread_attachment_kind = 0;
/// The node is held at `position`, and the thread's direction there is `direction`.
pub const VBSS_THREAD_ATTACHMENT_CLAMP: vbss_thread_attachment_kind = 1;
/// `force` pulls at the node.
pub const VBSS_THREAD_ATTACHMENT_FORCE: vbss_thread_attachment_kind = 2;
/// A spring-damper from `position` to the node.
pub const VBSS_THREAD_ATTACHMENT_SPRING: vbss_thread_attachment_kind = 3;
/// `mass` is fixed to the node; it has inertia and weight.
pub const VBSS_THREAD_ATTACHMENT_MASS: vbss_thread_attachment_kind = 4;
/// Threads with torsional_stiffness: holds the section at the node, which moves freely;
/// vbss_thread_set_roll turns it. A CLAMP does this, too.
pub const VBSS_THREAD_ATTACHMENT_ROLL: vbss_thread_attachment_kind = 5;

// The constants of vbss_thread_field. n is the number of nodes.
/// n x 3 doubles, m.
pub const VBSS_THREAD_VIEW_POSITIONS: vbss_thread_field = 0;
/// n x 3 doubles, m/s.
pub const VBSS_THREAD_VIEW_VELOCITIES: vbss_thread_field = 1;
/// n - 1 doubles, m.
pub const VBSS_THREAD_VIEW_REST_LENGTHS: vbss_thread_field = 2;
/// n - 1 doubles, m: chords, or arcs with BENDING_SPLINE.
pub const VBSS_THREAD_VIEW_LENGTHS: vbss_thread_field = 3;
/// n - 1 doubles, N: force along each segment at the end of the last step, due to stretching
/// and bending.
pub const VBSS_THREAD_VIEW_TENSIONS: vbss_thread_field = 4;
/// n x 3 doubles, 1/m: from the node to the centre of curvature.
pub const VBSS_THREAD_VIEW_CURVATURES: vbss_thread_field = 5;
/// First node of each section, uint32_t; the last ends at node n - 1.
pub const VBSS_THREAD_VIEW_SECTIONS: vbss_thread_field = 6;
/// n - 1 doubles, m: sagitta of each segment, the shape error due to the mesh. It is rest
/// length^2 / 8 times the larger curvature at the two nodes. Fixed meshes have it too.
pub const VBSS_THREAD_VIEW_SAGITTAS: vbss_thread_field = 7;
/// n x 3 doubles, 1/m: plastic curvature at each node, towards the centre of curvature; at a
/// clamp as VBSS_THREAD_VIEW_CURVATURES. No entries in a thread without memory of bends.
pub const VBSS_THREAD_VIEW_PLASTIC_CURVATURES: vbss_thread_field = 8;
/// The same for the viscous curvature: that at which the viscous branch has no moment.
pub const VBSS_THREAD_VIEW_VISCOUS_CURVATURES: vbss_thread_field = 9;
/// n - 1 doubles, rad/m: twist per length of each segment; between a holder and a free end 0, with
/// friction_torque rest_twist where no contact resists. No entries in a thread without torsional_stiffness.
pub const VBSS_THREAD_VIEW_TWISTS: vbss_thread_field = 10;
/// n - 1 x 3 doubles: a unit vector across each segment, at its middle, that is fixed to the material;
/// for display. No entries in a thread without torsional_stiffness.
pub const VBSS_THREAD_VIEW_MATERIAL_DIRECTORS: vbss_thread_field = 11;

/// A suture thread.
#[repr(C)]
pub struct vbss_thread {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of a thread. Fill it with vbss_thread_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_thread_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Method; default VBSS_METHOD_IMPLICIT.
    pub method: vbss_method,
    /// Method IMPLICIT: discretisation of bending; default VBSS_THREAD_BENDING_SPLINE.
    pub bending: vbss_thread_bending,
    /// Number of segments, 1 to 65536; default 120.
    pub segment_count: u32,
    /// Largest number of attachments, 0 to 256; default 8.
    pub attachment_capacity: u32,
    /// Largest number of cuts of this thread and its pieces, 0 to 64; default 0.
    pub cut_capacity: u32,
    /// Length, m, 1e-6 to 1e3, at least 1e-7 per segment; default 0.15; ignored with
    /// rest_lengths.
    pub length: f64,
    /// Radius, m, 1e-7 to 0.1; default of VBSS_THREAD_PRESET_VBLAST. Contact in a scene and display
    /// use it; a thread alone does not.
    pub radius: f64,
    /// Mass per length, kg/m, 1e-9 to 1e3; default of that preset.
    pub linear_density: f64,
    /// Axial stiffness EA, N, 1e-6 to 1e9; default of that preset.
    pub axial_stiffness: f64,
    /// Bending stiffness EI, N m^2, 0 to 1e3; default of that preset.
    pub bending_stiffness: f64,
    /// Curvature at rest, 1/m, 0 to 1e4; default 0. Its plane is free, because such a thread has no
    /// twist: it does not work with torsional_stiffness.
    pub rest_curvature: f64,
    /// Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default (0,
    /// -9.81, 0).
    pub gravity: [f64; 3],
    /// Drag coefficient, 1/s, 0 to 1e6; default 0. The force is -drag * mass * velocity.
    pub drag: f64,
    /// Method IMPLICIT: decay rate of the motion relative to the rigid motion of each section, 1/s,
    /// 0 to 1e6; default 0. It conserves linear and angular momentum.
    pub damping: f64,
    /// Position of node 0, m, each coordinate at most 1e3 in magnitude; default (0, 0, 0); ignored
    /// with positions.
    pub start: [f64; 3],
    /// Direction from node 0 on, of any length from 1e-100 to 1e100; default (1, 0, 0); ignored
    /// with positions.
    pub direction: [f64; 3],
    /// Rest length of each segment, m, 1e-7 to 1e2; segment_count values, or NULL (default) for
    /// length / segment_count each. vbss_thread_grade_lengths fills such an array. The library copies
    /// it.
    pub rest_lengths: *const f64,
    /// Positions of the nodes, m, each at most 1e3; 3 (segment_count + 1) values, or NULL
    /// (default) for a straight thread from start along direction. The library copies them.
    pub positions: *const f64,
    /// Method IMPLICIT: spectral radius at infinite frequency of the time integration, 0 (strongest
    /// damping) to 1 (none); default 0.3. Above 0.5 stiff motion may gain energy.
    pub spectral_radius: f64,
    /// Method IMPLICIT: largest stretch error that a step may leave, 1e-12 to 1e-2; default 1e-6.
    pub stretch_tolerance: f64,
    /// Method IMPLICIT: largest distance by which a further linearisation would move a node, m, 1e-12
    /// to 1; an estimate; default 1e-6.
    pub position_tolerance: f64,
    /// Method IMPLICIT: largest number of linearisations of an attempt, 1 to 100; default 40. Smooth
    /// motion takes one or two. The worst known case (ends shaken by 3 mm every ms) takes 300 in a
    /// step with its halves.
    pub iteration_limit: u32,
    /// Method IMPLICIT: how often a step is halved before its state is accepted unconverged, 0 to
    /// 10; default 5. `forced` counts such states and should stay zero.
    pub halving_limit: u32,
    /// Method VBLAST: its parameters; NULL (default): their defaults. The library copies them.
    pub baseline: *const vbss_baseline_config,
    /// Default VBSS_THREAD_MESH_FIXED, which ignores the following fields.
    pub mesh: vbss_thread_mesh,
    /// ADAPTIVE: largest number of nodes, segment_count + 1 to 65537; default 0: four times the
    /// initial number of segments, at most 65536. A scene must have capacity for all of them when
    /// the thread is added.
    pub node_capacity: u32,
    /// ADAPTIVE: length of the finest segments, m, 1e-7 to coarsest_length; default 3e-4, 1.2
    /// diameters of the paper's thread, at which a tight knot is converged. Because segments are
    /// halved, the finest ones have 0.63 to 1.25 times this length. Choose initial lengths of
    /// this length times a power of two.
    pub finest_length: f64,
    /// ADAPTIVE: a node is not removed if that leaves a segment longer than 1.25 times this
    /// length, m, at most 1e2; default 2e-3.
    pub coarsest_length: f64,
    /// ADAPTIVE: curvature times length, rad, above which a segment is divided, 0.01 to 1; default 0.25.
    pub refine_angle: f64,
    /// ADAPTIVE: curvature times length, rad, below which a node may be removed, 0 to half of
    /// refine_angle; default 0.05.
    pub coarsen_angle: f64,
    /// ADAPTIVE, in a scene: gap, m, to another strand below which a segment is divided down to finest_length, and
    /// to a tool down to a quarter of its radius; 0 to 0.1; default 1e-3. The floor does not count.
    pub near_distance: f64,
    /// ADAPTIVE, in a scene: a node is removed only if no other body is within this gap, m,
    /// near_distance to 0.1; default 3e-3.
    pub clear_distance: f64,
    /// ADAPTIVE: largest number of divisions and removals after a step, 0 to 64; default 4.
    pub mesh_operations: u32,
    /// 1: contacts of a scene resist rolling of the thread about itself by their friction, so that a tight
    /// knot holds twist on either side of itself; 0 (default): they let it roll. Needs
    /// torsional_stiffness. docs/explanation/twist.md has the model.
    pub friction_torque: u32,
    /// Method IMPLICIT: elastic curvature beyond which bending is plastic, 1/m, 0 to 1e6; default 0:
    /// bending is elastic. The bending moment at yield is EI times this curvature.
    /// docs/explanation/bending-memory.md has the model. Memory of bends, plastic or viscous, needs
    /// VBSS_THREAD_MESH_FIXED and a rest_curvature of 0.
    pub yield_curvature: f64,
    /// Stiffness of bending beyond yield as a fraction of EI, 0 (ideally plastic) to 0.999; default
    /// 0. The hardening is linear and kinematic.
    pub yield_hardening: f64,
    /// Method IMPLICIT: stiffness of the viscous branch of bending as a fraction of EI, 0 to 1e3;
    /// default 0: there is none. A fast bend has the stiffness EI (1 + relaxation_ratio), a slow one
    /// EI.
    pub relaxation_ratio: f64,
    /// Time in which the moment of the viscous branch decays to 1/e at constant curvature, s, 1e-6 to
    /// 1e9; default 1.
    pub relaxation_time: f64,
    /// Method IMPLICIT: torsional stiffness GJ, N m^2, 0 to 1e3; default 0: the thread has no twist.
    /// docs/explanation/twist.md has the model. Twist needs VBSS_THREAD_MESH_FIXED, a rest_curvature of 0 and
    /// bends without memory.
    pub torsional_stiffness: f64,
    /// Twist per length at which there is no torque, rad/m, -1e5 to 1e5; default 0; needs
    /// torsional_stiffness.
    pub rest_twist: f64,
}

/// An attachment acts on one node. Fill it with vbss_thread_attachment_init.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_thread_attachment {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Kind; default VBSS_THREAD_ATTACHMENT_PIN.
    pub kind: vbss_thread_attachment_kind,
    /// Node, 0 to segment_count; default 0.
    pub node: u32,
    /// Zero.
    pub reserved: u32,
    /// PIN, CLAMP: target of the node in the next step; SPRING: its fixed end; m, each coordinate
    /// at most 1e3 in magnitude.
    pub position: [f64; 3],
    /// CLAMP: direction of the thread towards higher nodes, of any length from 1e-100 to 1e100;
    /// default (1, 0, 0). A thread with another direction turns there in the next step.
    pub direction: [f64; 3],
    /// FORCE: force, N, each component at most 1e6 in magnitude.
    pub force: [f64; 3],
    /// SPRING: stiffness, N/m, 0 to 1e9.
    pub stiffness: f64,
    /// SPRING: damping of the velocity relative to the moving end, N s/m, 0 to 1e6.
    pub damping: f64,
    /// MASS: mass, kg, 0 to 1e3.
    pub mass: f64,
}

/// Reaction of an attachment in the last step.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_thread_reaction {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// The node, as cuts have renumbered it.
    pub node: u32,
    /// Force of the attachment on the thread at the end of the step, N.
    pub force: [f64; 3],
    /// CLAMP, ROLL: torque of the attachment on the thread, N m; else 0.
    pub torque: [f64; 3],
}

/// Energies of a thread, J.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_thread_energies {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Kinetic energy, attached masses included.
    pub kinetic: f64,
    /// Elastic energy of EA.
    pub stretching: f64,
    /// Elastic energy of bending; with memory what hardening stores, too.
    pub bending: f64,
    /// Potential, zero at the origin; attached masses included.
    pub gravity: f64,
    /// Sum of the four and of `twisting`.
    pub total: f64,
    /// Energy that plastic and viscous bending have dissipated since creation, or since the cut that
    /// made this piece; not part of the total; never decreases.
    pub dissipated: f64,
    /// Elastic energy of twist.
    pub twisting: f64,
}

/// Momentum of a thread, attached masses included.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_thread_momentum {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass, m.
    pub centre: [f64; 3],
    /// Linear momentum, kg m/s.
    pub linear: [f64; 3],
    /// Angular momentum about the origin, kg m^2/s.
    pub angular: [f64; 3],
}

/// Counters since creation, and results of the last step. vbss_thread_get_baseline_statistics returns
/// what method VBLAST counts beside these.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_thread_statistics {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// IMPLICIT: linearisations of the last step.
    pub last_iterations: u32,
    /// Calls of vbss_thread_step that succeeded.
    pub steps: u64,
    /// IMPLICIT: linearisations.
    pub iterations: u64,
    /// Accepted parts of steps; equal to steps if none was divided.
    pub substeps: u64,
    /// IMPLICIT: substeps made by backward Euler.
    pub first_order: u64,
    /// IMPLICIT: attempts that were rejected and halved.
    pub rejections: u64,
    /// IMPLICIT: substeps accepted unconverged, at the last halving.
    pub forced: u64,
    /// IMPLICIT: linearisations repeated with less compression, parts that started from the old positions because
    /// the prediction was unusable, and parts in which the force of rest curvature was kept constant.
    pub softened: u64,
    /// IMPLICIT: max |length / rest length - 1 - T / EA| after the last step; VBLAST: max |length / rest
    /// length - 1|.
    pub last_stretch_error: f64,
    /// Largest stretch error after any part of a step.
    pub stretch_error: f64,
    /// max (length / rest length - 1) after the last step.
    pub last_stretch: f64,
    /// Simulated time, s.
    pub time: f64,
    /// Segments divided.
    pub refined: u64,
    /// Nodes removed.
    pub coarsened: u64,
    /// Divisions whose new node is on the chord instead of the arc, for lack of clearance.
    pub laid_on_chord: u64,
    /// Divisions refused because thread or scene had no free node.
    pub refused_capacity: u64,
    /// Changes refused at or beside attachments, pins, grasps or the ends at a cut.
    pub refused_held: u64,
    /// Removals refused because another body was too near.
    pub refused_near: u64,
    /// Present number of nodes; also for a fixed mesh.
    pub nodes: u32,
    /// Largest number of nodes so far; 0 for a fixed mesh.
    pub most_nodes: u32,
    /// Largest of VBSS_THREAD_VIEW_SAGITTAS, m; also for a fixed mesh.
    pub sagitta: f64,
}

extern "C" {
    /// Fills a thread configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_thread_config_init(config: *mut vbss_thread_config, struct_size: u32) -> vbss_result;
    /// Sets radius, linear density, EA and EI of a configuration to those of a known thread.
    ///
    /// @param\[in,out\] config  an initialised configuration
    /// @param preset          the known thread
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_OUT_OF_RANGE (no
    /// such preset)
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_thread_config_preset(config: *mut vbss_thread_config, preset: vbss_thread_preset) -> vbss_result;
    /// Sets radius, linear density, EA and EI of a configuration to those of a suture. They follow from the
    /// diameter of the size and from density, modulus of elasticity and modulus of bending of the material
    /// (docs/reference/sutures.md): a braid bends far more easily than a solid rod, a monofilament like one.
    ///
    /// @param\[in,out\] config  an initialised configuration
    /// @param material        the material
    /// @param size            the size
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_OUT_OF_RANGE (no
    /// such material or size)
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_thread_config_suture(config: *mut vbss_thread_config, material: vbss_thread_material, size: vbss_thread_usp_size) -> vbss_result;
    /// Divides a length into segments that are fine about one place and grow away from it by a constant
    /// ratio, up to the largest length. The lengths sum to `length` up to rounding. For this the ratio
    /// is lowered on either side. Segments that are too long even when equal are scaled, to no less than
    /// half. A place closer to an end than half the finest length is moved to the end.
    ///
    /// @param length the length, m, 1e-6 to 1e3
    /// @param centre             arc length of the fine place, m, 0 to length
    /// @param finest             length of the segments there, m, 2e-7 to coarsest
    /// @param coarsest           largest length, m, at most length
    /// @param ratio              largest ratio of neighbours, 1 to 2
    /// @param rest_lengths  receives the lengths, m; may be NULL when capacity is 0
    /// @param capacity           size of `rest_lengths`
    /// @param count         number of segments, also when they do not fit; 0 above 65536
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE or
    /// VBSS_ERROR_CAPACITY (more than capacity, or more than 65536)
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_thread_grade_lengths(length: f64, centre: f64, finest: f64, coarsest: f64, ratio: f64, rest_lengths: *mut f64, capacity: u32, count: *mut u32) -> vbss_result;
    /// Creates a thread at rest.
    ///
    /// @param context      owner
    /// @param config       the configuration; NULL for the defaults
    /// @param thread  the new thread; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_INCOMPATIBLE (an adaptive
    /// mesh with method VBLAST; memory of bends with method VBLAST, an adaptive mesh or a rest
    /// curvature; torsional_stiffness with one of these three or with memory of bends; rest_twist
    /// without torsional_stiffness), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_create(context: *mut vbss_context, config: *const vbss_thread_config, thread: *mut *mut vbss_thread) -> vbss_result;
    /// Destroys a thread; pieces cut from it remain.
    ///
    /// @param thread  the thread; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_destroy(thread: *mut vbss_thread) -> vbss_result;
    /// Destroys a thread now, or when it leaves the scene that it belongs to: on vbss_scene_remove and on
    /// vbss_scene_destroy; pieces cut from it remain. Until then the handle is valid. A host that has discarded all bodies of a
    /// scene needs to destroy only the scene.
    ///
    /// @param thread  the thread; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_discard(thread: *mut vbss_thread) -> vbss_result;
    /// Advances a thread by one step. The call allocates nothing. If the new state is not finite, the
    /// call fails and the thread keeps its state from before the step. With method VBLAST the call also
    /// fails if a segment has become longer than 100 times the length of the thread plus the distance
    /// that its attachments span: the explicit steps have diverged, and the error text states it. A
    /// thread with an adaptive mesh then adapts it by its curvature alone, because only a scene knows
    /// the distance to other bodies.
    ///
    /// @param thread  the thread
    /// @param h length of the step, s, 1e-7 to 0.1
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FINITE (h, or the state would be),
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_step(thread: *mut vbss_thread, h: f64) -> vbss_result;
    /// Sets positions and velocities of the nodes. Nodes held by attachments move to their targets in the next step.
    /// Plastic and viscous curvatures stay, in the plane of the new bend at each node and on the same side of it.
    /// The twist between two holders of the section stays.
    ///
    /// @param thread      the thread
    /// @param positions   3 doubles per node, m, each at most 1e3 in magnitude; NULL keeps them
    /// @param velocities  3 doubles per node, m/s, each at most 1e5 in magnitude; NULL keeps them
    /// @param node_count  number of nodes in the arrays, equal to the thread's
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_set_state(thread: *mut vbss_thread, positions: *const f64, velocities: *const f64, node_count: u32) -> vbss_result;
    /// Fills an attachment with the defaults.
    ///
    /// @param attachment  the attachment to fill
    /// @param struct_size      `sizeof *attachment` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_thread_attachment_init(attachment: *mut vbss_thread_attachment, struct_size: u32) -> vbss_result;
    /// Attaches something to a node. A node takes one PIN or CLAMP, one CLAMP or ROLL, and any number of the others. All fields
    /// must be in their ranges, also those that the kind does not read.
    ///
    /// @param thread      the thread
    /// @param attachment the attachment
    /// @param id     identifier of the attachment, from 1 on, never reused in this thread
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_IN_USE (the node is held
    /// already), VBSS_ERROR_INCOMPATIBLE (a ROLL on a thread without twist), VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_attach(thread: *mut vbss_thread, attachment: *const vbss_thread_attachment, id: *mut u32) -> vbss_result;
    /// Sets the target of an attachment for the end of the next step. The attachment moves there at
    /// constant velocity during the step, and then stays.
    ///
    /// @param thread     the thread
    /// @param id         the attachment, not a MASS
    /// @param target     PIN, CLAMP, SPRING: position, m; FORCE: the force, N, which changes at once
    /// @param direction  CLAMP: as in vbss_thread_attachment; NULL keeps it
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such attachment), VBSS_ERROR_INCOMPATIBLE (a MASS), VBSS_ERROR_OUT_OF_RANGE,
    /// VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_set_attachment_target(thread: *mut vbss_thread, id: u32, target: *const f64, direction: *const f64) -> vbss_result;
    /// Sets the roll of a CLAMP or ROLL for the end of the next step: the angle by which it has turned the
    /// section about the thread since it was attached. The section rolls at constant speed during the step, and then
    /// stays. A change of the thread's direction takes the section along without spin. A new holder has the roll 0
    /// and leaves the twist of the thread as it is. The twist between a holder and a free end is zero.
    ///
    /// @param thread  the thread, with torsional_stiffness above 0
    /// @param id      the attachment, a CLAMP or ROLL
    /// @param roll    angle, rad, -1e6 to 1e6, any number of turns; positive by the right-hand rule about the
    /// direction towards higher nodes
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such attachment),
    /// VBSS_ERROR_INCOMPATIBLE (another kind, or a thread without twist), VBSS_ERROR_OUT_OF_RANGE,
    /// VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_set_roll(thread: *mut vbss_thread, id: u32, roll: f64) -> vbss_result;
    /// Removes an attachment. The twist between its neighbours is the sum of those on either side, or zero at a
    /// free end.
    ///
    /// @param thread  the thread
    /// @param id      the attachment
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such attachment) or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_detach(thread: *mut vbss_thread, id: u32) -> vbss_result;
    /// Returns the reaction of an attachment in the last step, regardless of later changes; zero before
    /// its first step. While a scene has a suspended step (vbss_solver_options::call_budget_us), the last step
    /// may be some calls ago. A host that feeds a spring's force back to a hand should then compute it
    /// as stiffness times the current distance of both ends; a delayed force lets the hand wind the
    /// thread up.
    ///
    /// @param thread         the thread
    /// @param id             the attachment
    /// @param reaction  receives the reaction
    /// @param struct_size    `sizeof *reaction` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such attachment)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_get_reaction(thread: *mut vbss_thread, id: u32, reaction: *mut vbss_thread_reaction, struct_size: u32) -> vbss_result;
    /// Cuts a thread in two. The segment at the place is divided, unless a node is within 1 % of a
    /// segment or 1e-7 m of it, which is then doubled. The thread keeps the part with node 0; the piece is a thread
    /// of its own with the same material and settings, its node 0 at the cut. Attachments go with their
    /// nodes and keep their ids; one on a doubled node stays with the thread. Plastic and viscous curvatures
    /// stay with their nodes; a node inside a divided segment begins without. Memory was reserved by
    /// cut_capacity, which both parts share.
    ///
    /// @param thread      the thread
    /// @param arc_length  place of the cut, m from node 0, measured in rest lengths, inside the thread
    /// @param piece  the far part; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_OUT_OF_RANGE (not inside, or within 1 % of a segment of an end),
    /// VBSS_ERROR_CAPACITY (no cuts left) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_cut(thread: *mut vbss_thread, arc_length: f64, piece: *mut *mut vbss_thread) -> vbss_result;
    /// Returns a view of one of the thread's arrays.
    ///
    /// @param thread       the thread
    /// @param field the array
    /// @param view    receives the view
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_OUT_OF_RANGE (no such field)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_get_view(thread: *mut vbss_thread, field: vbss_thread_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
    /// Returns the thread's energies.
    ///
    /// @param thread         the thread
    /// @param energies  receives the numbers
    /// @param struct_size    `sizeof *energies` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_get_energies(thread: *mut vbss_thread, energies: *mut vbss_thread_energies, struct_size: u32) -> vbss_result;
    /// Returns the thread's momentum.
    ///
    /// @param thread         the thread
    /// @param momentum  receives the numbers
    /// @param struct_size    `sizeof *momentum` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_get_momentum(thread: *mut vbss_thread, momentum: *mut vbss_thread_momentum, struct_size: u32) -> vbss_result;
    /// Returns the thread's counters.
    ///
    /// @param thread           the thread
    /// @param statistics  receives the numbers
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_get_statistics(thread: *mut vbss_thread, statistics: *mut vbss_thread_statistics, struct_size: u32) -> vbss_result;
    /// Returns what method VBLAST counts in a thread.
    ///
    /// @param thread          the thread
    /// @param statistics  receives the counters
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INCOMPATIBLE if the thread uses another method, VBSS_ERROR_INVALID_HANDLE,
    /// VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_get_baseline_statistics(thread: *mut vbss_thread, statistics: *mut vbss_baseline_statistics, struct_size: u32) -> vbss_result;
    /// Saves the thread's state. A thread that restores it continues with identical bits, on any machine.
    ///
    /// @param thread        the thread
    /// @param bytes    receives the state; NULL with capacity 0 asks for its size, which logs no error
    /// @param capacity      size of the buffer
    /// @param written  bytes of the state, also when it does not fit
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_save(thread: *mut vbss_thread, bytes: *mut u8, capacity: u64, written: *mut u64) -> vbss_result;
    /// Restores a saved state into this thread or an equally configured one. Later cuts are not undone
    /// in the pieces, which are separate threads. On failure the thread is unchanged.
    ///
    /// @param thread  the thread
    /// @param bytes   the state
    /// @param count   its size
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
    /// VBSS_ERROR_CORRUPT, VBSS_ERROR_CAPACITY, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY
    /// or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_restore(thread: *mut vbss_thread, bytes: *const u8, count: u64) -> vbss_result;
    /// Returns the XXH64 of the thread's state, its counters included; equal states have equal hashes on
    /// every machine.
    ///
    /// @param thread     the thread
    /// @param hash  the hash
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_thread_get_hash(thread: *mut vbss_thread, hash: *mut u64) -> vbss_result;
}
