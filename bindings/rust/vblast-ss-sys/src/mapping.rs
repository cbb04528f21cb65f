// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


// Bits for the buttons of a mouse.
/// Movements of the mouse turn the tool instead of shifting it.
pub const VBSS_MAPPING_MOUSE_TURN: u32 = 1;
/// The jaws close; otherwise they open.
pub const VBSS_MAPPING_MOUSE_CLOSE: u32 = 2;

/// Mapping from mouse, keyboard or gamepad to a pose. Fill it with vbss_mapping_config_init,
/// then change fields. Rotations are about axes of the pose's frame.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_mapping_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Gamepad: power of the deflection, 1 to 4; default 2.
    pub pad_curve: u32,
    /// Direction to the right of the screen, unit to 1e-6; default x.
    pub right: [f64; 3],
    /// Direction to the top of the screen, normal to `right`; default y. Right x up points towards the user.
    pub up: [f64; 3],
    /// Lower corner of the box to which positions are confined, m; default -0.1.
    pub low: [f64; 3],
    /// Upper corner of the box, m, each coordinate at most 1e3 in magnitude; default 0.1.
    pub high: [f64; 3],
    /// Mouse: metres per count; default 1e-4.
    pub mouse_metres: f64,
    /// Mouse: metres away from the user per notch of the wheel; default 2e-3.
    pub mouse_depth: f64,
    /// Mouse, turning: rad per count; default 5e-3.
    pub mouse_radians: f64,
    /// Mouse, turning: rad about the direction of depth per notch; default 0.1.
    pub mouse_roll: f64,
    /// Mouse: speed at which the jaws close and open, 1/s, 0 to 1e3; default 4.
    pub jaw_rate: f64,
    /// Keyboard: metres per press; default 1e-3.
    pub key_metres: f64,
    /// Keyboard: rad per press; default 0.05.
    pub key_radians: f64,
    /// Keyboard: change of the opening per press; default 0.1.
    pub key_jaw: f64,
    /// Gamepad: m/s at full deflection; default 0.1.
    pub pad_speed: f64,
    /// Gamepad: rad/s at full deflection; default 1.
    pub pad_turning: f64,
    /// Gamepad: deflection that counts as zero, 0 to 0.9; default 0.15.
    pub pad_dead: f64,
}

extern "C" {
    /// Fills a mapping with the defaults.
    ///
    /// @param config  the mapping to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_mapping_config_init(config: *mut vbss_mapping_config, struct_size: u32) -> vbss_result;
    /// Applies a motion of a mouse. It shifts the tool in the plane of the screen and, by the wheel, in
    /// depth. With VBSS_MAPPING_MOUSE_TURN the side of the tool that faces the user follows the mouse,
    /// and the wheel rolls the tool.
    ///
    /// @param config          the mapping; NULL for the defaults
    /// @param motion          counts to the right, counts up, notches of the wheel away from the user; each at most 1e6
    /// @param buttons         VBSS_MAPPING_MOUSE_ bits
    /// @param h               time since the last call, s, 0 to 10
    /// @param\[in,out\] sample  an initialised sample
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
    /// VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_mapping_mouse(config: *const vbss_mapping_config, motion: *const f64, buttons: u32, h: f64, sample: *mut vbss_device_sample) -> vbss_result;
    /// Applies presses of keys.
    ///
    /// @param config          the mapping; NULL for the defaults
    /// @param presses         presses since the last call, negative for the opposite key: right, up,
    /// towards the user, turns about these three, opening; each at most 1e6
    /// @param h               time since the last call, s, 0 to 10
    /// @param\[in,out\] sample  an initialised sample
    /// @return as vbss_mapping_mouse
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_mapping_keyboard(config: *const vbss_mapping_config, presses: *const f64, h: f64, sample: *mut vbss_device_sample) -> vbss_result;
    /// Applies the state of a gamepad: its axes set rates, with a dead zone and a curve.
    ///
    /// @param config          the mapping; NULL for the defaults
    /// @param axes            -1 to 1: right, up, towards the user, turns about these three; larger
    /// values count as full deflection
    /// @param opening         opening of the jaws, 0 to 1, such as the value of a trigger
    /// @param h               time since the last call, s, 0 to 10
    /// @param\[in,out\] sample  an initialised sample
    /// @return as vbss_mapping_mouse
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_mapping_gamepad(config: *const vbss_mapping_config, axes: *const f64, opening: f64, h: f64, sample: *mut vbss_device_sample) -> vbss_result;
}
