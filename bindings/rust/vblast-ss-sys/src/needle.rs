// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// A known needle: a VBSS_NEEDLE_PRESET_ constant.
pub type vbss_needle_preset = i32;

/// An array to view: a VBSS_NEEDLE_VIEW_ constant.
pub type vbss_needle_field = i32;

// The constants of vbss_needle_preset.
/// Half circle of radius 10.5 mm (Qi et al. 2017): the defaults.
pub const VBSS_NEEDLE_PRESET_VBLAST: vbss_needle_preset = 0;
/// Half circle of 26 mm, radius 8.28 mm (not verified).
pub const VBSS_NEEDLE_PRESET_SH: vbss_needle_preset = 1;

// The constants of vbss_needle_field.
/// x 3: ends of the capsules' axes, m, from the tip to the swage; segment_count + 1 rows.
pub const VBSS_NEEDLE_VIEW_POINTS: vbss_needle_field = 0;

/// A needle.
#[repr(C)]
pub struct vbss_needle {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of a needle. Fill it with vbss_needle_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_needle_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Must be that of the scene; default VBSS_METHOD_IMPLICIT.
    pub method: vbss_method,
    /// Capsules along the arc, 2 to 64; default 8.
    pub segment_count: u32,
    /// Zero.
    pub reserved: u32,
    /// Radius of the arc's centre line, m, 1e-4 to 1; default 10.5e-3, the paper's radius.
    pub radius: f64,
    /// Radius of the wire, m, 1e-6 to radius / 5; default 0.35e-3 (not verified).
    pub wire_radius: f64,
    /// Angle from tip to swage, rad, 0.1 to 6; default pi.
    pub arc: f64,
    /// Density, kg/m^3, 1 to 1e5; default 7900, steel.
    pub density: f64,
    /// Coefficient of friction with other bodies of a scene, 0 to 10; default 0.2.
    pub friction: f64,
    /// Decay rate of linear and angular momentum, 1/s, 0 to 1e6; default 0.
    pub drag: f64,
    /// Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default 0.
    pub gravity: [f64; 3],
    /// Position of the frame's origin, m, each coordinate at most 1e3 in magnitude; default 0.
    pub position: [f64; 3],
    /// Orientation w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0.
    pub orientation: [f64; 4],
    /// Velocity of the origin, m/s, each component at most 1e5 in magnitude; default 0.
    pub velocity: [f64; 3],
    /// Angular velocity, rad/s, each component at most 1e6 in magnitude; default 0.
    pub angular_velocity: [f64; 3],
}

/// Pose and velocity of a needle.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_needle_state {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Number of the needle in its scene; 0: not in a scene.
    pub body: u32,
    /// Position of the frame's origin, m.
    pub position: [f64; 3],
    /// Orientation, unit quaternion w, x, y, z.
    pub orientation: [f64; 4],
    /// Velocity of the origin, m/s.
    pub velocity: [f64; 3],
    /// Angular velocity, rad/s.
    pub angular_velocity: [f64; 3],
    /// Position of the tip, m.
    pub tip: [f64; 3],
    /// Unit vector out of the tip.
    pub tip_direction: [f64; 3],
    /// Position of the swage, m.
    pub swage: [f64; 3],
    /// Unit vector of the thread, away from the needle.
    pub swage_direction: [f64; 3],
}

/// Mass and inertia of a needle.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_needle_mass {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Mass, kg.
    pub mass: f64,
    /// Length of the centre line, m.
    pub length: f64,
    /// Centre of mass in the needle's frame, m.
    pub centre: [f64; 3],
    /// Principal moments about it, kg m^2.
    pub inertia: [f64; 3],
    /// Their unit axes in the needle's frame, in the same order.
    pub axes: [[f64; 3]; 3],
}

/// Energies, J.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_needle_energies {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Kinetic energy of translation and rotation.
    pub kinetic: f64,
    /// Potential energy, zero at the world's origin.
    pub gravity: f64,
    /// Their sum.
    pub total: f64,
}

extern "C" {
    /// Fills a configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_needle_config_init(config: *mut vbss_needle_config, struct_size: u32) -> vbss_result;
    /// Sets radius, wire radius and arc to those of a known needle.
    ///
    /// @param\[in,out\] config  an initialised configuration
    /// @param preset          the known needle
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_OUT_OF_RANGE (no
    /// such preset)
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_needle_config_preset(config: *mut vbss_needle_config, preset: vbss_needle_preset) -> vbss_result;
    /// Sets radius, wire radius and arc to those of a needle as catalogues describe it. docs/reference/sutures.md lists
    /// common needles.
    ///
    /// @param\[in,out\] config  an initialised configuration
    /// @param circle          share of a circle, 0.05 to 0.9: 0.5 for a half circle
    /// @param length          length along the arc, m, 1e-3 to 1
    /// @param wire_diameter   diameter of the wire, m, 1e-5 to 0.4 of the arc's radius
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_NOT_FINITE or
    /// VBSS_ERROR_OUT_OF_RANGE; the configuration is then unchanged
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_needle_config_shape(config: *mut vbss_needle_config, circle: f64, length: f64, wire_diameter: f64) -> vbss_result;
    /// Creates a needle with the pose and velocity of its configuration.
    ///
    /// @param context      owner
    /// @param config       configuration; NULL for the defaults
    /// @param needle  the new needle; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_create(context: *mut vbss_context, config: *const vbss_needle_config, needle: *mut *mut vbss_needle) -> vbss_result;
    /// Destroys a needle.
    ///
    /// @param needle  the needle; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_destroy(needle: *mut vbss_needle) -> vbss_result;
    /// Destroys a needle now, or when it leaves the scene that it belongs to: on vbss_scene_remove and on
    /// vbss_scene_destroy. Until then the handle is valid. A host that has discarded all bodies of a
    /// scene needs to destroy only the scene.
    ///
    /// @param needle  the needle; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_discard(needle: *mut vbss_needle) -> vbss_result;
    /// Makes one step of free flight under gravity and drag, without contacts. Angular momentum is
    /// conserved up to rounding; the rotation is of second order (the splitting of docs/explanation/needle.md). A
    /// needle turns by at most a quarter of a turn in a step; a faster one slows down.
    ///
    /// @param needle  the needle
    /// @param h       length of the step, s, 1e-7 to 0.1
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE (h, or
    /// the state would be: nothing has changed), VBSS_ERROR_IN_SCENE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_step(needle: *mut vbss_needle, h: f64) -> vbss_result;
    /// Sets the pose and velocity of a needle that is not in a scene.
    ///
    /// @param needle            the needle
    /// @param position          position of the frame's origin, m, each coordinate at most 1e3 in
    /// magnitude
    /// @param orientation       w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps it
    /// @param velocity          velocity of the frame's origin, m/s, each component at most 1e5 in
    /// magnitude; NULL: zero
    /// @param angular_velocity  rad/s, each component at most 1e6 in magnitude; NULL: zero
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE,
    /// VBSS_ERROR_NOT_FINITE, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_set_state(needle: *mut vbss_needle, position: *const f64, orientation: *const f64, velocity: *const f64, angular_velocity: *const f64) -> vbss_result;
    /// Returns pose and velocity of a needle.
    ///
    /// @param needle       the needle
    /// @param state   receives the numbers
    /// @param struct_size  `sizeof *state` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_get_state(needle: *mut vbss_needle, state: *mut vbss_needle_state, struct_size: u32) -> vbss_result;
    /// Returns mass and inertia of a needle.
    ///
    /// @param needle       the needle
    /// @param mass    receives the numbers
    /// @param struct_size  `sizeof *mass` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_get_mass(needle: *mut vbss_needle, mass: *mut vbss_needle_mass, struct_size: u32) -> vbss_result;
    /// Returns a point on the exact centre line, and the direction toward the tip there. Beyond the ends the line
    /// continues straight.
    ///
    /// @param needle          the needle
    /// @param arc_length      from the tip towards the swage, m, at most 10 in magnitude
    /// @param position position on the centre line, m
    /// @param direction unit vector; may be NULL
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE or
    /// VBSS_ERROR_NOT_FINITE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_get_place(needle: *mut vbss_needle, arc_length: f64, position: *mut f64, direction: *mut f64) -> vbss_result;
    /// Returns the energies of a needle.
    ///
    /// @param needle         the needle
    /// @param energies  receives the numbers
    /// @param struct_size    `sizeof *energies` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_get_energies(needle: *mut vbss_needle, energies: *mut vbss_needle_energies, struct_size: u32) -> vbss_result;
    /// Returns a view of one of the needle's arrays after the last step.
    ///
    /// @param needle       the needle
    /// @param field        the array
    /// @param view    receives the view
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_OUT_OF_RANGE (no such field)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_get_view(needle: *mut vbss_needle, field: vbss_needle_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
    /// Saves the needle's state.
    ///
    /// @param needle        the needle
    /// @param bytes    receives the state; NULL with capacity 0 asks for its size, which logs no error
    /// @param capacity      size of `bytes`
    /// @param written  bytes written, or bytes needed with VBSS_ERROR_CAPACITY
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_save(needle: *mut vbss_needle, bytes: *mut u8, capacity: u64, written: *mut u64) -> vbss_result;
    /// Restores a saved state into this needle or an equally configured one. On failure the needle is
    /// unchanged.
    ///
    /// @param needle  the needle
    /// @param bytes   the state that vbss_needle_save wrote
    /// @param count   its size
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
    /// VBSS_ERROR_CORRUPT (also of another configuration), VBSS_ERROR_CAPACITY,
    /// VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_restore(needle: *mut vbss_needle, bytes: *const u8, count: u64) -> vbss_result;
    /// Returns the XXH64 of the needle's state; equal states have equal hashes on every machine.
    ///
    /// @param needle     the needle
    /// @param hash  the hash
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_needle_get_hash(needle: *mut vbss_needle, hash: *mut u64) -> vbss_result;
}
