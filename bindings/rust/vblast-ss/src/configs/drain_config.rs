// Written by bindings/rust/generate.py from the public headers: do not edit.
use super::defaults;
use crate::sys;

/// Configuration of a drain. Fill it with vbss_drain_config_init, then change fields.
#[derive(Debug, Clone)]
pub struct DrainConfig {
    pub(crate) raw: sys::vbss_drain_config,
}

impl Default for DrainConfig {
    fn default() -> Self {
        DrainConfig { raw: defaults(sys::vbss_drain_config_init) }
    }
}

impl DrainConfig {
    /// The defaults of the library.
    pub fn new() -> Self {
        Self::default()
    }

    /// Method; default VBSS_METHOD_IMPLICIT.
    pub fn method(mut self, value: sys::vbss_method) -> Self {
        self.raw.method = value;
        self
    }

    /// Method IMPLICIT: mesh; default VBSS_DRAIN_MESH_137.
    pub fn mesh(mut self, value: sys::vbss_drain_mesh) -> Self {
        self.raw.mesh = value;
        self
    }

    /// Method IMPLICIT: divisions of each cell in each direction, 1 to 4; default 1.
    pub fn mesh_divisions(mut self, value: u32) -> Self {
        self.raw.mesh_divisions = value;
        self
    }

    /// Largest number of attachments, 0 to 256; default 8.
    pub fn attachment_capacity(mut self, value: u32) -> Self {
        self.raw.attachment_capacity = value;
        self
    }

    /// Method IMPLICIT: largest number of linearisations in a step, 1 to 50; default 1. A step with a larger
    /// limit stops at position_tolerance; this serves reference solutions.
    pub fn iteration_limit(mut self, value: u32) -> Self {
        self.raw.iteration_limit = value;
        self
    }

    /// Method IMPLICIT: how often a step may be halved, 0 to 10; default 4.
    pub fn halving_limit(mut self, value: u32) -> Self {
        self.raw.halving_limit = value;
        self
    }

    /// Radius of the middle surface, m, 1e-4 to 1; default 6.5e-3.
    pub fn radius(mut self, value: f64) -> Self {
        self.raw.radius = value;
        self
    }

    /// Length of the tube, m, 2 to 7 radii; default 32e-3.
    pub fn length(mut self, value: f64) -> Self {
        self.raw.length = value;
        self
    }

    /// Thickness of the wall, m, 0.01 to 0.3 radii, or with a surface 1e-6 to 0.1; default 1e-3.
    pub fn thickness(mut self, value: f64) -> Self {
        self.raw.thickness = value;
        self
    }

    /// Length of the slit, m, one radius to 0.7 lengths; default 10e-3.
    pub fn slit_length(mut self, value: f64) -> Self {
        self.raw.slit_length = value;
        self
    }

    /// Width of the slit at its middle, along the surface, m, 0 to 0.4 slit lengths and one radius; default
    /// 3e-3.
    pub fn slit_opening(mut self, value: f64) -> Self {
        self.raw.slit_opening = value;
        self
    }

    /// Arc from the middle of the slit to each mark, along the surface before the slit was opened, m. It is
    /// longer than half the opening and lies between 20 and 90 degrees. Default 4.5e-3.
    pub fn mark_arc(mut self, value: f64) -> Self {
        self.raw.mark_arc = value;
        self
    }

    /// Method IMPLICIT: Young's modulus, Pa, 1e3 to 1e12; default 1.2e6 (not verified for real
    /// drains).
    pub fn young_modulus(mut self, value: f64) -> Self {
        self.raw.young_modulus = value;
        self
    }

    /// Method IMPLICIT: Poisson's ratio, 0 to 0.49; default 0.47.
    pub fn poisson_ratio(mut self, value: f64) -> Self {
        self.raw.poisson_ratio = value;
        self
    }

    /// Density, kg/m^3, 1 to 1e5; default 950.
    pub fn density(mut self, value: f64) -> Self {
        self.raw.density = value;
        self
    }

    /// Drag coefficient, 1/s, 0 to 1e6; default 20. The force is -drag * mass * velocity.
    pub fn drag(mut self, value: f64) -> Self {
        self.raw.drag = value;
        self
    }

    /// Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default 0,
    /// because the rest shape is that of a drain that lies on its block.
    pub fn gravity(mut self, value: [f64; 3]) -> Self {
        self.raw.gravity = value;
        self
    }

    /// Origin of the drain's frame in the world, m, each at most 1e3; default 0.
    pub fn position(mut self, value: [f64; 3]) -> Self {
        self.raw.position = value;
        self
    }

    /// Quaternion (w, x, y, z) of any length from 1e-100 to 1e100; default (1, 0, 0, 0).
    pub fn orientation(mut self, value: [f64; 4]) -> Self {
        self.raw.orientation = value;
        self
    }

    /// Method IMPLICIT: strength of the glue of the strip, Pa, 1 to 1e12; default 5e4 (not verified). The anchor
    /// of a node tears off permanently above this stress times the node's area of the strip. Each step tears
    /// off at most one anchor: the one with the largest overload.
    pub fn tear_stress(mut self, value: f64) -> Self {
        self.raw.tear_stress = value;
        self
    }

    /// Method IMPLICIT: largest increment of the last linearisation, m, 1e-15 to 1; default 1e-6.
    pub fn position_tolerance(mut self, value: f64) -> Self {
        self.raw.position_tolerance = value;
        self
    }

    /// Method IMPLICIT: a step in which a node would move farther than this gets one more linearisation. A step
    /// in which it would move four times as far is halved. m, 1e-9 to 1; default 1e-3.
    pub fn move_limit(mut self, value: f64) -> Self {
        self.raw.move_limit = value;
        self
    }

    /// In a scene: coefficient of friction with threads, 0 to 10. Friction with other bodies, the floor and
    /// the drain itself uses the geometric mean of both coefficients. Default 0.3 (not verified).
    pub fn friction(mut self, value: f64) -> Self {
        self.raw.friction = value;
        self
    }

    /// Force along the direction of a tip at which it enters a wall, N, 1e-3 to 1e3; default 1 (the
    /// published range for both walls of a Penrose drain is 0.85 to 2.92).
    pub fn puncture_force(mut self, value: f64) -> Self {
        self.raw.puncture_force = value;
        self
    }

    /// Friction of a hole with a needle that slides in it, N, 1e-6 to 1e3; default 0.25 (not verified).
    pub fn hole_force(mut self, value: f64) -> Self {
        self.raw.hole_force = value;
        self
    }

    /// Coefficient of the additional friction from the force across the suture, 0 to 10; default 0.3 (not
    /// verified).
    pub fn hole_friction(mut self, value: f64) -> Self {
        self.raw.hole_friction = value;
        self
    }

    /// Stiffness of a hole across and along the suture in it, N/m, 1 to 1e7; default 2e4.
    pub fn hole_stiffness(mut self, value: f64) -> Self {
        self.raw.hole_stiffness = value;
        self
    }

    /// Damping of sliding in a hole, N s/m, 0 to 1e3; default 0.05.
    pub fn hole_damping(mut self, value: f64) -> Self {
        self.raw.hole_damping = value;
        self
    }

    /// Length of a tip's path through the wall over which the force against its advance falls from puncture_force
    /// to hole_force, and that against drawing it back grows from 0 to hole_force; m, 0 to 0.1; default 0.5e-3.
    pub fn tip_length(mut self, value: f64) -> Self {
        self.raw.tip_length = value;
        self
    }

    /// Friction of a hole with a slack thread in it, N, 1e-6 to 1e3; default 0.02 (not verified). A tight
    /// thread has capstan friction: docs/explanation/stitch.md.
    pub fn thread_force(mut self, value: f64) -> Self {
        self.raw.thread_force = value;
        self
    }

    /// In a scene, method IMPLICIT: energy for each square metre of cut, J/m^2, 1 to 1e7; 0 (default): threads
    /// do not tear the wall at their holes. With it, a thread cuts through the wall when the force across
    /// it in the plane of the wall exceeds this energy times the thickness (of the triangle, where the surface
    /// states it): docs/explanation/tearing.md has published values. The mesh stays whole: the cut behind
    /// the thread is not opened.
    pub fn tear_energy(mut self, value: f64) -> Self {
        self.raw.tear_energy = value;
        self
    }
}
