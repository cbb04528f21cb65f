// Written by bindings/rust/generate.py from the public headers: do not edit.
use super::defaults;
use crate::sys;

/// Configuration of a needle. Fill it with vbss_needle_config_init, then change fields.
#[derive(Debug, Clone)]
pub struct NeedleConfig {
    pub(crate) raw: sys::vbss_needle_config,
}

impl Default for NeedleConfig {
    fn default() -> Self {
        NeedleConfig { raw: defaults(sys::vbss_needle_config_init) }
    }
}

impl NeedleConfig {
    /// The defaults of the library.
    pub fn new() -> Self {
        Self::default()
    }

    /// Must be that of the scene; default VBSS_METHOD_IMPLICIT.
    pub fn method(mut self, value: sys::vbss_method) -> Self {
        self.raw.method = value;
        self
    }

    /// Capsules along the arc, 2 to 64; default 8.
    pub fn segment_count(mut self, value: u32) -> Self {
        self.raw.segment_count = value;
        self
    }

    /// Radius of the arc's centre line, m, 1e-4 to 1; default 10.5e-3, the paper's radius.
    pub fn radius(mut self, value: f64) -> Self {
        self.raw.radius = value;
        self
    }

    /// Radius of the wire, m, 1e-6 to radius / 5; default 0.35e-3 (not verified).
    pub fn wire_radius(mut self, value: f64) -> Self {
        self.raw.wire_radius = value;
        self
    }

    /// Angle from tip to swage, rad, 0.1 to 6; default pi.
    pub fn arc(mut self, value: f64) -> Self {
        self.raw.arc = value;
        self
    }

    /// Density, kg/m^3, 1 to 1e5; default 7900, steel.
    pub fn density(mut self, value: f64) -> Self {
        self.raw.density = value;
        self
    }

    /// Coefficient of friction with other bodies of a scene, 0 to 10; default 0.2.
    pub fn friction(mut self, value: f64) -> Self {
        self.raw.friction = value;
        self
    }

    /// Decay rate of linear and angular momentum, 1/s, 0 to 1e6; default 0.
    pub fn drag(mut self, value: f64) -> Self {
        self.raw.drag = value;
        self
    }

    /// Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default 0.
    pub fn gravity(mut self, value: [f64; 3]) -> Self {
        self.raw.gravity = value;
        self
    }

    /// Position of the frame's origin, m, each coordinate at most 1e3 in magnitude; default 0.
    pub fn position(mut self, value: [f64; 3]) -> Self {
        self.raw.position = value;
        self
    }

    /// Orientation w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0.
    pub fn orientation(mut self, value: [f64; 4]) -> Self {
        self.raw.orientation = value;
        self
    }

    /// Velocity of the origin, m/s, each component at most 1e5 in magnitude; default 0.
    pub fn velocity(mut self, value: [f64; 3]) -> Self {
        self.raw.velocity = value;
        self
    }

    /// Angular velocity, rad/s, each component at most 1e6 in magnitude; default 0.
    pub fn angular_velocity(mut self, value: [f64; 3]) -> Self {
        self.raw.angular_velocity = value;
        self
    }
}
