// Written by bindings/rust/generate.py from the public headers: do not edit.
use super::defaults;
use crate::sys;

/// Configuration of a grasper. Fill it with vbss_grasper_config_init, then change fields.
#[derive(Debug, Clone)]
pub struct GrasperConfig {
    pub(crate) raw: sys::vbss_grasper_config,
}

impl Default for GrasperConfig {
    fn default() -> Self {
        GrasperConfig { raw: defaults(sys::vbss_grasper_config_init) }
    }
}

impl GrasperConfig {
    /// The defaults of the library.
    pub fn new() -> Self {
        Self::default()
    }

    /// Must be that of the scene; default VBSS_METHOD_IMPLICIT.
    pub fn method(mut self, value: sys::vbss_method) -> Self {
        self.raw.method = value;
        self
    }

    /// Initial kind; default VBSS_GRASPER_KIND_NEEDLE_DRIVER.
    pub fn kind(mut self, value: sys::vbss_grasper_kind) -> Self {
        self.raw.kind = value;
        self
    }

    /// 1: the shaft goes through `trocar`; default 0: free.
    pub fn has_trocar(mut self, value: i32) -> Self {
        self.raw.has_trocar = value;
        self
    }

    /// Point of entry of the shaft, m, each at most 1e3; default 0.
    pub fn trocar(mut self, value: [f64; 3]) -> Self {
        self.raw.trocar = value;
        self
    }

    /// Length of a driver's jaws, pivot to tip, m, 1e-4 to 1; default 13e-3.
    pub fn driver_length(mut self, value: f64) -> Self {
        self.raw.driver_length = value;
        self
    }

    /// Radius of each jaw, m, 1e-6 to 0.1, below the length; default 0.5e-3.
    pub fn driver_radius(mut self, value: f64) -> Self {
        self.raw.driver_radius = value;
        self
    }

    /// Angle between jaws and shaft, rad, -1.5 to 1.5; default 0.
    pub fn driver_bend(mut self, value: f64) -> Self {
        self.raw.driver_bend = value;
        self
    }

    /// Angle of each jaw from the middle when the handle is open, rad, 1e-3 to 1.2; default 0.35.
    pub fn driver_opening(mut self, value: f64) -> Self {
        self.raw.driver_opening = value;
        self
    }

    /// Length of the blades of shears, pivot to tip, m, 1e-4 to 1; default 15e-3.
    pub fn shears_length(mut self, value: f64) -> Self {
        self.raw.shears_length = value;
        self
    }

    /// Radius of each blade, m, 1e-6 to 0.1, below the length; default 0.5e-3.
    pub fn shears_radius(mut self, value: f64) -> Self {
        self.raw.shears_radius = value;
        self
    }

    /// Angle between blades and shaft, rad, -1.5 to 1.5; default 0.
    pub fn shears_bend(mut self, value: f64) -> Self {
        self.raw.shears_bend = value;
        self
    }

    /// Angle of each blade from the middle when the handle is open, rad, 1e-3 to 1.2; default
    /// 0.35.
    pub fn shears_opening(mut self, value: f64) -> Self {
        self.raw.shears_opening = value;
        self
    }

    /// Length from the pivot back to the bend, m, 0 to 1; default 0.
    pub fn driver_neck(mut self, value: f64) -> Self {
        self.raw.driver_neck = value;
        self
    }

    /// Length from the pivot of the blades back to the bend, m, 0 to 1; default 0.
    pub fn shears_neck(mut self, value: f64) -> Self {
        self.raw.shears_neck = value;
        self
    }

    /// Radius of either neck, m, 1e-6 to 0.1; default 1.2e-3.
    pub fn neck_radius(mut self, value: f64) -> Self {
        self.raw.neck_radius = value;
        self
    }

    /// Length from the bend on, m, 1e-3 to 10; default 0.15.
    pub fn shaft_length(mut self, value: f64) -> Self {
        self.raw.shaft_length = value;
        self
    }

    /// Radius of the shaft, m, 1e-6 to 0.1; default 2.5e-3.
    pub fn shaft_radius(mut self, value: f64) -> Self {
        self.raw.shaft_radius = value;
        self
    }

    /// Coefficient for contacts outside the grasp, 0 to 10; default 0.15.
    pub fn friction(mut self, value: f64) -> Self {
        self.raw.friction = value;
        self
    }

    /// Pressure of the jaws on a grasped body when the handle is closed, N, 0 to 1e4; default 8.
    pub fn closing_force(mut self, value: f64) -> Self {
        self.raw.closing_force = value;
        self
    }

    /// Angle by which the jaws of a closed handle would close further without a grasped body, rad, 1e-3
    /// to 1. The pressure grows over this angle from zero to closing_force. Default 0.1.
    pub fn closing_angle(mut self, value: f64) -> Self {
        self.raw.closing_angle = value;
        self
    }

    /// Largest speed of each jaw, rad/s, 1e-2 to 1e3; default 8.
    pub fn jaw_speed(mut self, value: f64) -> Self {
        self.raw.jaw_speed = value;
        self
    }

    /// Coefficient of each face in the grasp, 0 to 10; default 0.5.
    pub fn grip_friction(mut self, value: f64) -> Self {
        self.raw.grip_friction = value;
        self
    }

    /// Length of thread that a grasp holds, m, 1e-5 to 1e-1; default 1e-3.
    pub fn grip_length(mut self, value: f64) -> Self {
        self.raw.grip_length = value;
        self
    }

    /// Stiffness of the whole clamp of a thread along the faces, N/m, 1 to 1e6; default 3000. From face to
    /// face it is 64 times as stiff.
    pub fn grip_stiffness(mut self, value: f64) -> Self {
        self.raw.grip_stiffness = value;
        self
    }

    /// Mass of the proxy, kg, 1e-4 to 1e2; default 0.02. It is at the tip, with a radius of gyration of
    /// 30 mm.
    pub fn mass(mut self, value: f64) -> Self {
        self.raw.mass = value;
        self
    }

    /// Stiffness of the virtual coupling, N/m, 0 to 1e9. The default of 400 suits haptic arms; scripted
    /// hands may use 2000 with a damping of 10 N s/m.
    pub fn stiffness(mut self, value: f64) -> Self {
        self.raw.stiffness = value;
        self
    }

    /// Damping of the virtual coupling, N s/m, 0 to 1e6; default 5. If a hand receives its force a time d
    /// after its pose was read, and holds it for h, the damping must be at least stiffness (d + h / 2).
    /// Otherwise the coupling adds energy to a hand that presses on a rigid obstacle. At an elastic one the
    /// hand itself needs a little damping, which docs/reference/device-layer.md derives.
    pub fn damping(mut self, value: f64) -> Self {
        self.raw.damping = value;
        self
    }

    /// Rotational stiffness of the coupling, N m/rad, 0 to 1e9; default 5.
    pub fn turning_stiffness(mut self, value: f64) -> Self {
        self.raw.turning_stiffness = value;
        self
    }

    /// Rotational damping of the coupling, N m s/rad, 0 to 1e6; default 0.05.
    pub fn turning_damping(mut self, value: f64) -> Self {
        self.raw.turning_damping = value;
        self
    }

    /// Tools are exchanged only with empty jaws and with the tip farther than exchange_distance from this
    /// point, m, each at most 1e3; default 0.
    pub fn exchange_centre(mut self, value: [f64; 3]) -> Self {
        self.raw.exchange_centre = value;
        self
    }

    /// Distance, m, 0 to 1e3; default 0: no limit.
    pub fn exchange_distance(mut self, value: f64) -> Self {
        self.raw.exchange_distance = value;
        self
    }

    /// Stiffness of the clamp on either, equal in all directions, N/m, 1 to 1e7; default 3e4.
    pub fn needle_stiffness(mut self, value: f64) -> Self {
        self.raw.needle_stiffness = value;
        self
    }

    /// Rotational stiffness of the clamp on a needle about the normal of the jaws' faces, N m/rad, 1e-6 to
    /// 1e4; default 0.5. About axes in the faces it is half of this.
    pub fn needle_turning_stiffness(mut self, value: f64) -> Self {
        self.raw.needle_turning_stiffness = value;
        self
    }

    /// Torque at which a needle turns in the jaws of a closed handle, N m, 0 to 1e2; default 0.03 (not
    /// verified). The torque is proportional to the pressure of the jaws.
    pub fn needle_torque(mut self, value: f64) -> Self {
        self.raw.needle_torque = value;
        self
    }

    /// See vbss_grasper_state::solenoid; 0 to 1; default 0.2.
    pub fn solenoid_opening(mut self, value: f64) -> Self {
        self.raw.solenoid_opening = value;
        self
    }
}
