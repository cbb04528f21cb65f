// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// Kind of a tool: a VBSS_GRASPER_KIND_ constant.
pub type vbss_grasper_kind = i32;

/// A known tool: a VBSS_GRASPER_PRESET_ constant.
pub type vbss_grasper_preset = i32;

/// An array to view: a VBSS_GRASPER_VIEW_ constant.
pub type vbss_grasper_field = i32;

// The constants of vbss_grasper_kind.
/// Jaws that hold.
pub const VBSS_GRASPER_KIND_NEEDLE_DRIVER: vbss_grasper_kind = 1;
/// Blades that cut.
pub const VBSS_GRASPER_KIND_SHEARS: vbss_grasper_kind = 2;

// The constants of vbss_grasper_preset.
/// A needle driver with straight jaws: the defaults.
pub const VBSS_GRASPER_PRESET_STRAIGHT: vbss_grasper_preset = 0;
/// Jaws on a neck of 5 mm, bent by 0.8 rad. Rolled about its shaft, the tool points its jaws at the
/// other tool, which can then go round them without meeting the shaft.
pub const VBSS_GRASPER_PRESET_ANGLED: vbss_grasper_preset = 1;

// The constants of vbss_grasper_field.
/// x 7: start and end of the axis, radius, m. Order: shaft, jaw at +x, jaw at -x, neck.
pub const VBSS_GRASPER_VIEW_CAPSULES: vbss_grasper_field = 0;

/// A tool with two jaws.
#[repr(C)]
pub struct vbss_grasper {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of a grasper. Fill it with vbss_grasper_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_grasper_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Must be that of the scene; default VBSS_METHOD_IMPLICIT.
    pub method: vbss_method,
    /// Initial kind; default VBSS_GRASPER_KIND_NEEDLE_DRIVER.
    pub kind: vbss_grasper_kind,
    /// 1: the shaft goes through `trocar`; default 0: free.
    pub has_trocar: i32,
    /// Point of entry of the shaft, m, each at most 1e3; default 0.
    pub trocar: [f64; 3],
    /// Length of a driver's jaws, pivot to tip, m, 1e-4 to 1; default 13e-3.
    pub driver_length: f64,
    /// Radius of each jaw, m, 1e-6 to 0.1, below the length; default 0.5e-3.
    pub driver_radius: f64,
    /// Angle between jaws and shaft, rad, -1.5 to 1.5; default 0.
    pub driver_bend: f64,
    /// Angle of each jaw from the middle when the handle is open, rad, 1e-3 to 1.2; default 0.35.
    pub driver_opening: f64,
    /// Length of the blades of shears, pivot to tip, m, 1e-4 to 1; default 15e-3.
    pub shears_length: f64,
    /// Radius of each blade, m, 1e-6 to 0.1, below the length; default 0.5e-3.
    pub shears_radius: f64,
    /// Angle between blades and shaft, rad, -1.5 to 1.5; default 0.
    pub shears_bend: f64,
    /// Angle of each blade from the middle when the handle is open, rad, 1e-3 to 1.2; default
    /// 0.35.
    pub shears_opening: f64,
    /// Length from the pivot back to the bend, m, 0 to 1; default 0.
    pub driver_neck: f64,
    /// Length from the pivot of the blades back to the bend, m, 0 to 1; default 0.
    pub shears_neck: f64,
    /// Radius of either neck, m, 1e-6 to 0.1; default 1.2e-3.
    pub neck_radius: f64,
    /// Length from the bend on, m, 1e-3 to 10; default 0.15.
    pub shaft_length: f64,
    /// Radius of the shaft, m, 1e-6 to 0.1; default 2.5e-3.
    pub shaft_radius: f64,
    /// Coefficient for contacts outside the grasp, 0 to 10; default 0.15.
    pub friction: f64,
    /// Pressure of the jaws on a grasped body when the handle is closed, N, 0 to 1e4; default 8.
    pub closing_force: f64,
    /// Angle by which the jaws of a closed handle would close further without a grasped body, rad, 1e-3
    /// to 1. The pressure grows over this angle from zero to closing_force. Default 0.1.
    pub closing_angle: f64,
    /// Largest speed of each jaw, rad/s, 1e-2 to 1e3; default 8.
    pub jaw_speed: f64,
    /// Coefficient of each face in the grasp, 0 to 10; default 0.5.
    pub grip_friction: f64,
    /// Length of thread that a grasp holds, m, 1e-5 to 1e-1; default 1e-3.
    pub grip_length: f64,
    /// Stiffness of the whole clamp of a thread along the faces, N/m, 1 to 1e6; default 3000. From face to
    /// face it is 64 times as stiff.
    pub grip_stiffness: f64,
    /// Mass of the proxy, kg, 1e-4 to 1e2; default 0.02. It is at the tip, with a radius of gyration of
    /// 30 mm.
    pub mass: f64,
    /// Stiffness of the virtual coupling, N/m, 0 to 1e9. The default of 400 suits haptic arms; scripted
    /// hands may use 2000 with a damping of 10 N s/m.
    pub stiffness: f64,
    /// Damping of the virtual coupling, N s/m, 0 to 1e6; default 5. If a hand receives its force a time d
    /// after its pose was read, and holds it for h, the damping must be at least stiffness (d + h / 2).
    /// Otherwise the coupling adds energy to a hand that presses on a rigid obstacle. At an elastic one the
    /// hand itself needs a little damping, which docs/reference/device-layer.md derives.
    pub damping: f64,
    /// Rotational stiffness of the coupling, N m/rad, 0 to 1e9; default 5.
    pub turning_stiffness: f64,
    /// Rotational damping of the coupling, N m s/rad, 0 to 1e6; default 0.05.
    pub turning_damping: f64,
    /// Tools are exchanged only with empty jaws and with the tip farther than exchange_distance from this
    /// point, m, each at most 1e3; default 0.
    pub exchange_centre: [f64; 3],
    /// Distance, m, 0 to 1e3; default 0: no limit.
    pub exchange_distance: f64,
    /// VBLAST: its parameters; NULL (default): their defaults. The library copies them.
    pub baseline: *const vbss_baseline_config,
    /// Stiffness of the clamp on either, equal in all directions, N/m, 1 to 1e7; default 3e4.
    pub needle_stiffness: f64,
    /// Rotational stiffness of the clamp on a needle about the normal of the jaws' faces, N m/rad, 1e-6 to
    /// 1e4; default 0.5. About axes in the faces it is half of this.
    pub needle_turning_stiffness: f64,
    /// Torque at which a needle turns in the jaws of a closed handle, N m, 0 to 1e2; default 0.03 (not
    /// verified). The torque is proportional to the pressure of the jaws.
    pub needle_torque: f64,
    /// See vbss_grasper_state::solenoid; 0 to 1; default 0.2.
    pub solenoid_opening: f64,
}

/// Pose of a grasper, and the forces that act on it.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_grasper_state {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Present kind.
    pub kind: vbss_grasper_kind,
    /// Number of the grasper in its scene; 0: not in a scene.
    pub body: u32,
    /// Number of grasps: places of threads, a needle, a wall.
    pub grasp_count: u32,
    /// Position of the tip, m.
    pub position: [f64; 3],
    /// Unit quaternion, w, x, y, z.
    pub orientation: [f64; 4],
    /// Velocity of the tip, m/s.
    pub velocity: [f64; 3],
    /// Angular velocity, rad/s.
    pub angular_velocity: [f64; 3],
    /// Target of the tip, m.
    pub target_position: [f64; 3],
    /// Target, after the trocar has turned it.
    pub target_orientation: [f64; 4],
    /// Opening of the handle that the host set.
    pub opening: f64,
    /// Angle of each jaw from the middle, rad.
    pub jaw_angle: f64,
    /// Pressure of the jaws on all grasped bodies, N.
    pub pressure: f64,
    /// Force on the hand at the tip, which a device shall exert, N: a command for vbss_device_write. A
    /// device that gets the pose of the tool by vbss_device_write_coupled has this force already. VBLAST:
    /// the force of stretched threads that it carries.
    pub hand_force: [f64; 3],
    /// Torque on the hand about the tip, N m; VBLAST: 0.
    pub hand_torque: [f64; 3],
    /// Number of the held needle in its scene; 0: none.
    pub needle: u32,
    /// Number of the drain whose wall it holds; 0: none.
    pub drain: u32,
    /// 1: a solenoid shall lock the handle (vbss_output_command::solenoid). It is set once the tool holds a
    /// needle and the opening of the handle is below solenoid_opening, and cleared when the tool holds no
    /// needle.
    pub solenoid: u32,
    /// Zero.
    pub reserved: u32,
}

extern "C" {
    /// Fills a configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_grasper_config_init(config: *mut vbss_grasper_config, struct_size: u32) -> vbss_result;
    /// Sets length, radius, bend, opening and neck of the driver's jaws to those of a known tool.
    ///
    /// @param\[in,out\] config  an initialised configuration
    /// @param preset          the known tool
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_OUT_OF_RANGE (no
    /// such preset)
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_grasper_config_preset(config: *mut vbss_grasper_config, preset: vbss_grasper_preset) -> vbss_result;
    /// Creates a grasper with open jaws. Its tip is at the origin until the host moves it.
    ///
    /// @param context       owner
    /// @param config        the configuration; NULL for the defaults
    /// @param grasper  the new grasper; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_grasper_create(context: *mut vbss_context, config: *const vbss_grasper_config, grasper: *mut *mut vbss_grasper) -> vbss_result;
    /// Destroys a grasper.
    ///
    /// @param grasper  the grasper; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_grasper_destroy(grasper: *mut vbss_grasper) -> vbss_result;
    /// Destroys a grasper now, or when it leaves the scene that it belongs to: on vbss_scene_remove and on
    /// vbss_scene_destroy. Until then the handle is valid. A host that has discarded all bodies of a
    /// scene needs to destroy only the scene.
    ///
    /// @param grasper  the grasper; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_grasper_discard(grasper: *mut vbss_grasper) -> vbss_result;
    /// Sets the pose that the tool reaches at the end of the next step. Before the tool is added to a
    /// scene, the call sets its initial pose. With a trocar, the tip moves to the given position. The
    /// given orientation is turned along the shortest path until the shaft passes through the trocar, so
    /// only its roll about the shaft is free.
    ///
    /// @param grasper      the grasper
    /// @param position     target of the tip, m, each at most 1e3
    /// @param orientation  target, w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps the last one
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE
    /// (also: the trocar is nearer to the tip than the lateral reach of the bent jaws),
    /// VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_grasper_set_target(grasper: *mut vbss_grasper, position: *const f64, orientation: *const f64) -> vbss_result;
    /// Sets how far the handle is open from the next step on. The jaws follow with at most jaw_speed.
    ///
    /// @param grasper  the grasper
    /// @param opening  opening, 0 (closed) to 1 (open)
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_grasper_set_opening(grasper: *mut vbss_grasper, opening: f64) -> vbss_result;
    /// Requests another kind of tool. The next step of the scene exchanges the tool or refuses the
    /// request, with an event either way. It refuses while the tool holds a body, where
    /// exchange_distance forbids the exchange, and where the tip is too near to the trocar for the other
    /// jaws. A refused request is not repeated.
    ///
    /// @param grasper  the grasper
    /// @param kind     the new kind; the present kind changes nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_grasper_exchange(grasper: *mut vbss_grasper, kind: vbss_grasper_kind) -> vbss_result;
    /// Returns the pose of a grasper and the forces that act on it.
    ///
    /// @param grasper      the grasper
    /// @param state   receives the numbers
    /// @param struct_size  `sizeof *state` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_grasper_get_state(grasper: *mut vbss_grasper, state: *mut vbss_grasper_state, struct_size: u32) -> vbss_result;
    /// Returns a view of one of the grasper's arrays after the last step.
    ///
    /// @param grasper      the grasper
    /// @param field        the array
    /// @param view    receives the address and the shape of the array
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_OUT_OF_RANGE (no such field)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_grasper_get_view(grasper: *mut vbss_grasper, field: vbss_grasper_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
}
