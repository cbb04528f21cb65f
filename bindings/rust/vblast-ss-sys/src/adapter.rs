// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_char, c_void};
#[allow(unused_imports)]
use crate::*;


/// Kind of tool that a device holds: a VBSS_DEVICE_TOOL_ constant.
pub type vbss_device_tool = i32;

// Bits for the parts of a sample.
/// `position` is valid.
pub const VBSS_DEVICE_HAS_POSITION: u32 = 1;
/// `orientation` is valid.
pub const VBSS_DEVICE_HAS_ORIENTATION: u32 = 2;
/// `velocity` is valid.
pub const VBSS_DEVICE_HAS_VELOCITY: u32 = 4;
/// `angular_velocity` is valid.
pub const VBSS_DEVICE_HAS_ANGULAR_VELOCITY: u32 = 8;
/// `jaw_raw` is valid.
pub const VBSS_DEVICE_HAS_JAW_RAW: u32 = 16;
/// `jaw` is valid and replaces `jaw_raw`.
pub const VBSS_DEVICE_HAS_JAW: u32 = 32;
/// `buttons` is valid.
pub const VBSS_DEVICE_HAS_BUTTONS: u32 = 64;
/// `tool` is valid.
pub const VBSS_DEVICE_HAS_TOOL: u32 = 128;
/// `temperature` is valid.
pub const VBSS_DEVICE_HAS_TEMPERATURE: u32 = 256;

// Bits for the outputs of a device.
/// Force on the hand.
pub const VBSS_DEVICE_OUT_FORCE: u32 = 1;
/// Torque on the hand.
pub const VBSS_DEVICE_OUT_TORQUE: u32 = 2;
/// Solenoid in the handle.
pub const VBSS_DEVICE_OUT_SOLENOID: u32 = 4;

// Bits for the state that a device reports with a sample.
/// The hardware is missing: unplugged, or its driver has failed.
pub const VBSS_DEVICE_FLAG_LOST: u32 = 1;
/// Emergency stop; it latches as vbss_device_latch_emergency_stop does.
pub const VBSS_DEVICE_FLAG_STOP: u32 = 2;
/// The hardware refuses forces for now; all outputs are off while this bit is set.
pub const VBSS_DEVICE_FLAG_FAULT: u32 = 4;
/// The hardware is too slow to switch outputs off within vbss_output_result::expires. `explain`
/// gives its speed.
pub const VBSS_DEVICE_FLAG_SLOW: u32 = 8;

// The constants of vbss_device_tool.
/// No tool.
pub const VBSS_DEVICE_TOOL_NONE: vbss_device_tool = 0;
/// A needle driver.
pub const VBSS_DEVICE_TOOL_NEEDLE_DRIVER: vbss_device_tool = 1;
/// Shears.
pub const VBSS_DEVICE_TOOL_SHEARS: vbss_device_tool = 2;

/// Opens the hardware. Unlike `read` and `write`, it may block.
///
/// @param user  the table's `user`
/// @return VBSS_OK, or any other number if the hardware could not be opened
pub type vbss_device_open_fn = Option<unsafe extern "C" fn(user: *mut c_void) -> vbss_result>;

/// Closes the hardware. The library has switched its outputs off before.
///
/// @param user  the table's `user`
pub type vbss_device_close_fn = Option<unsafe extern "C" fn(user: *mut c_void)>;

/// Reports the capabilities of the hardware. The library calls it once, after `open`.
///
/// @param user               the table's `user`
/// @param capabilities  cleared except for struct_size
/// @return VBSS_OK, or any other number if the capabilities are not available; the device is not
/// created then
pub type vbss_device_describe_fn = Option<unsafe extern "C" fn(user: *mut c_void, capabilities: *mut vbss_device_capabilities) -> vbss_result>;

/// Returns the newest sample without waiting. It may return a sample again, with an unchanged time.
///
/// @param user         the table's `user`
/// @param now          the host's clock, s
/// @param sample  cleared except for struct_size and orientation (1, 0, 0, 0)
/// @return VBSS_OK, or any other number if there is no sample now
pub type vbss_device_read_fn = Option<unsafe extern "C" fn(user: *mut c_void, now: f64, sample: *mut vbss_device_sample) -> vbss_result>;

/// Writes the outputs without waiting.
///
/// @param user    the table's `user`
/// @param now     the host's clock, s
/// @param output  the outputs; all numbers are finite; parts that this adapter does not have are
/// zero
/// @return VBSS_OK, or any other number if the outputs were not written
pub type vbss_device_write_fn = Option<unsafe extern "C" fn(user: *mut c_void, now: f64, output: *const vbss_output_result) -> vbss_result>;

/// Describes the last failure in words.
///
/// @param user       the table's `user`
/// @param text  receives UTF-8 text and a final zero
/// @param bytes      size of `text`
pub type vbss_device_explain_fn = Option<unsafe extern "C" fn(user: *mut c_void, text: *mut c_char, bytes: u32)>;

/// Writes like vbss_device_write_fn, and replaces it when there is a coupling and forces are on.
/// The output has the coupling's force at the pose that was read last. Until `expires` has passed,
/// the adapter may apply the coupling's force at newer poses, within the limits of the output stage.
///
/// @param user      the table's `user`
/// @param now       the host's clock, s
/// @param output    the outputs; all numbers are finite
/// @param coupling  the coupling, in the device's frame
/// @return VBSS_OK, or any other number if the outputs were not written
pub type vbss_device_couple_fn = Option<unsafe extern "C" fn(user: *mut c_void, now: f64, output: *const vbss_output_result, coupling: *const vbss_device_coupling) -> vbss_result>;

/// A sample of an adapter. The library passes a cleared one; the adapter fills the fields that it
/// has and sets their bits in `valid`. The library's memory has 4096 bytes, so an adapter with a
/// newer header may fill fields that an older library does not know. The library ignores them, and
/// unknown bits.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_device_sample {
    /// Size of this struct in bytes, as the library knows it.
    pub struct_size: u32,
    /// VBSS_DEVICE_HAS_ bits.
    pub valid: u32,
    /// VBSS_DEVICE_FLAG_ bits; evaluated even if the read fails.
    pub flags: u32,
    /// Pressed buttons, one bit each.
    pub buttons: u32,
    /// Kind of tool.
    pub tool: vbss_device_tool,
    /// Zero.
    pub reserved: u32,
    /// Time of the measurement, s, by any clock that never runs backwards.
    pub time: f64,
    /// Position, m, each coordinate at most 1e3 in magnitude.
    pub position: [f64; 3],
    /// Orientation from handle to device frame, unit quaternion w, x, y, z.
    pub orientation: [f64; 4],
    /// Velocity, m/s, each component at most 1e3 in magnitude.
    pub velocity: [f64; 3],
    /// Angular velocity in the device's frame, rad/s, each component at most 1e4 in magnitude.
    pub angular_velocity: [f64; 3],
    /// Opening in the sensor's unit, such as V, at most 1e6 in magnitude.
    pub jaw_raw: f64,
    /// Opening, 0 (closed) to 1 (open).
    pub jaw: f64,
    /// Temperature of the hottest motor, 0 (cold) to 1 (about to fail).
    pub temperature: f64,
}

/// Capabilities of a device; 0 means unknown. The library passes a cleared struct of 4096 bytes, as
/// with vbss_device_sample.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_device_capabilities {
    /// Size of this struct in bytes.
    pub struct_size: u32,
    /// VBSS_DEVICE_HAS_ bits that samples may have.
    pub signals: u32,
    /// VBSS_DEVICE_OUT_ bits of the available outputs.
    pub outputs: u32,
    /// Degrees of freedom that are measured.
    pub input_dof: u32,
    /// Degrees of freedom that are driven.
    pub output_dof: u32,
    /// Zero.
    pub reserved: u32,
    /// Peak force, N.
    pub max_force: f64,
    /// Largest continuous force, N.
    pub max_continuous_force: f64,
    /// Peak torque, N m.
    pub max_torque: f64,
    /// Largest continuous torque, N m.
    pub max_continuous_torque: f64,
    /// Largest stiffness that does not make the arm buzz, N/m.
    pub max_stiffness: f64,
    /// Largest damping that does not make the arm buzz, N s/m.
    pub max_damping: f64,
    /// Sample rate, Hz.
    pub update_rate: f64,
    /// Lower corner of the reachable box, device frame, m.
    pub workspace_low: [f64; 3],
    /// Upper corner of the reachable box; equal to `workspace_low` if unknown.
    pub workspace_high: [f64; 3],
}

/// A virtual coupling between the hand and the tool. The force on the hand is
///
/// force + stiffness (position - p) + damping (velocity - v)
///
/// with p and v the hand's position and velocity. Fill it with vbss_device_coupling_init, then set
/// its fields. A device computes this force in each write, from the pose that was read last. An
/// adapter with its own servo (haptics.h) recomputes it in every tick from the pose just measured.
/// The simulation then adds no delay between the hand and its spring.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_device_coupling {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Position of the tool that is coupled to the hand, m, each coordinate at most 1e3 in
    /// magnitude.
    pub position: [f64; 3],
    /// Velocity of the tool, m/s, each component at most 1e3 in magnitude; default 0.
    pub velocity: [f64; 3],
    /// Force that is added, N, each component at most 1e3 in magnitude; default 0.
    pub force: [f64; 3],
    /// Stiffness, N/m, 0 to 1e6; default 0.
    pub stiffness: f64,
    /// Damping, N s/m, 0 to 1e6; default 0.
    pub damping: f64,
}

/// An adapter. Fill it with vbss_device_adapter_init, then set the functions that exist. The
/// library calls them on the thread that calls the device. They must return (no longjmp, no
/// exception) and must not change the context.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_device_adapter {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Name in messages; NULL (default): "device". At most 31 bytes are kept.
    pub name: *const c_char,
    /// Pointer that the functions receive; may be NULL.
    pub user: *mut c_void,
    /// Opens the hardware; NULL (default): nothing to open.
    pub open: vbss_device_open_fn,
    /// Closes the hardware; NULL (default): nothing to close.
    pub close: vbss_device_close_fn,
    /// Reports the capabilities; NULL (default): all signals, and the outputs that there are
    /// functions for.
    pub describe: vbss_device_describe_fn,
    /// Reads a sample; NULL (default) only beside another adapter, and if `write` is set.
    pub read: vbss_device_read_fn,
    /// Writes outputs; NULL (default): no outputs.
    pub write: vbss_device_write_fn,
    /// Describes failures; NULL (default): no texts.
    pub explain: vbss_device_explain_fn,
    /// Writes outputs with a coupling; NULL (default): the adapter has no servo.
    pub couple: vbss_device_couple_fn,
}

extern "C" {
    /// Fills an adapter with the defaults without functions.
    ///
    /// @param adapter  the table to fill
    /// @param struct_size   `sizeof *adapter` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_device_adapter_init(adapter: *mut vbss_device_adapter, struct_size: u32) -> vbss_result;
    /// Fills a sample with the defaults: no valid part, orientation (1, 0, 0, 0).
    ///
    /// @param sample  the sample to fill
    /// @param struct_size  `sizeof *sample` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_device_sample_init(sample: *mut vbss_device_sample, struct_size: u32) -> vbss_result;
    /// Fills capabilities with the defaults: all unknown.
    ///
    /// @param capabilities  the capabilities to fill
    /// @param struct_size        `sizeof *capabilities` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_device_capabilities_init(capabilities: *mut vbss_device_capabilities, struct_size: u32) -> vbss_result;
    /// Fills a coupling with the defaults: no force.
    ///
    /// @param coupling  the coupling to fill
    /// @param struct_size    `sizeof *coupling` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_device_coupling_init(coupling: *mut vbss_device_coupling, struct_size: u32) -> vbss_result;
}
