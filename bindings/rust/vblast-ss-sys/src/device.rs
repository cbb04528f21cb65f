// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_char};
#[allow(unused_imports)]
use crate::*;


/// Interpretation of the times of samples: a VBSS_DEVICE_CLOCK_ constant.
pub type vbss_device_clock = i32;

/// Status of a device: a VBSS_DEVICE_STATUS_ constant.
pub type vbss_device_status = i32;

// The constants of vbss_device_clock.
/// The adapter's clock has its own origin. The age of a sample is the time since the first read
/// that returned it.
pub const VBSS_DEVICE_CLOCK_OWN: vbss_device_clock = 0;
/// The adapter uses the host's clock. The age of a sample follows from its own time, so that
/// delays are known.
pub const VBSS_DEVICE_CLOCK_SHARED: vbss_device_clock = 1;

// The constants of vbss_device_status.
/// There is no pose yet.
pub const VBSS_DEVICE_STATUS_WAITING: vbss_device_status = 0;
/// The pose is current.
pub const VBSS_DEVICE_STATUS_READY: vbss_device_status = 1;
/// The pose is stale; the last one is held.
pub const VBSS_DEVICE_STATUS_STALE: vbss_device_status = 2;
/// An adapter reports that its hardware is missing.
pub const VBSS_DEVICE_STATUS_LOST: vbss_device_status = 3;

// Bits of the events of a read.
/// An adapter's hardware is missing.
pub const VBSS_DEVICE_EVENT_LOST: u32 = 1;
/// An adapter's hardware is back.
pub const VBSS_DEVICE_EVENT_FOUND: u32 = 2;
/// The pose became stale.
pub const VBSS_DEVICE_EVENT_STALE: u32 = 4;
/// The pose is current again, or came for the first time.
pub const VBSS_DEVICE_EVENT_FRESH: u32 = 8;
/// The opening became stale.
pub const VBSS_DEVICE_EVENT_JAW_STALE: u32 = 16;
/// The opening is current again, or came for the first time.
pub const VBSS_DEVICE_EVENT_JAW_FRESH: u32 = 32;
/// A sample or raw opening was refused.
pub const VBSS_DEVICE_EVENT_REFUSED: u32 = 64;
/// An adapter returned no sample.
pub const VBSS_DEVICE_EVENT_FAILED: u32 = 128;
/// The device latched the emergency stop.
pub const VBSS_DEVICE_EVENT_STOPPED: u32 = 256;
/// A device began to refuse forces.
pub const VBSS_DEVICE_EVENT_FAULT: u32 = 512;
/// The clock of an adapter restarted.
pub const VBSS_DEVICE_EVENT_RESTARTED: u32 = 1024;
/// The kind of tool has changed.
pub const VBSS_DEVICE_EVENT_TOOL: u32 = 2048;
/// An adapter became too slow to switch outputs off in time.
pub const VBSS_DEVICE_EVENT_SLOW: u32 = 4096;
/// The opening is held until the handle has passed it.
pub const VBSS_DEVICE_EVENT_JAW_HELD: u32 = 8192;
/// The handle took over the opening.
pub const VBSS_DEVICE_EVENT_JAW_TAKEN: u32 = 16384;

/// A device: one or two adapters, calibration, and the output stage.
#[repr(C)]
pub struct vbss_device {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Transform from the device to the world. Fill it with vbss_device_calibration_init, then change
/// fields. Let p be a position and R an orientation of the device, f a force of the world, and C the
/// rotation times the matrix of `axes`:
///
/// position     offset + C scale p, then the clutch's shift, then into the workspace
/// orientation  C R C^T mount: at the device's identity the tool is oriented as `mount`
/// force        to the device: force_scale C^T f
///
/// A stiffness k in the world is felt as k scale force_scale.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_device_calibration {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// World axis i is device axis |axes\[i\]| (1 to 3), reversed if negative; default 1, 2, 3. A
    /// left-handed choice mirrors.
    pub axes: [i32; 3],
    /// Rotation applied after `axes`, row by row, orthonormal to 1e-6; default identity.
    pub rotation: [f64; 9],
    /// World metres per device metre, 1e-3 to 1e3; default 1.
    pub scale: f64,
    /// Offset, m, each coordinate at most 1e3 in magnitude; default 0.
    pub offset: [f64; 3],
    /// Orientation of the tool frame in the handle's frame, w, x, y, z, any length; default 1, 0,
    /// 0, 0.
    pub mount: [f64; 4],
    /// Lower corner of the box to which poses are confined, world, m; default -1.
    pub workspace_low: [f64; 3],
    /// Upper corner of the box, above the lower one, at most 1e3 in magnitude; default 1.
    pub workspace_high: [f64; 3],
    /// Device force per world force, 1e-3 to 1e3; default 1.
    pub force_scale: f64,
    /// `jaw_raw` of the closed handle; default 0.
    pub jaw_closed: f64,
    /// `jaw_raw` of the open handle, at least 1e-9 away from jaw_closed, above or below; default
    /// 1.
    pub jaw_open: f64,
    /// Largest distance of a raw value outside the range from closed to open, as a share of the
    /// range, 0 to 10; default 0.25. A value farther outside is refused, because the sensor must be
    /// broken.
    pub jaw_margin: f64,
    /// Backlash: largest movement of the opening that is ignored, 0 to 0.5; default 0.02.
    pub jaw_play: f64,
    /// Time constant of the opening's filter, s, 0 to 10; default 0.01.
    pub jaw_time: f64,
    /// Opening at and below which the jaws become closed, 0 to 1; default 0.05.
    pub jaw_close_at: f64,
    /// Opening at and above which closed jaws become open, jaw_close_at to 1; default 0.1.
    pub jaw_open_at: f64,
}

/// Configuration of a device. Fill it with vbss_device_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_device_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Kind of tool, where no adapter reports one; default VBSS_DEVICE_TOOL_NEEDLE_DRIVER.
    pub tool: vbss_device_tool,
    /// VBSS_DEVICE_HAS_ bits of the signals that come from the second adapter, if there is one;
    /// default the jaw. A bit of the pose (position, orientation, velocities) selects the whole
    /// pose; either bit of the opening selects both.
    pub second_signals: u32,
    /// Interpretation of sample times; default VBSS_DEVICE_CLOCK_OWN.
    pub clock: vbss_device_clock,
    /// 1 (default): a lost adapter latches the emergency stop; 0: its samples only become stale.
    pub stop_when_lost: u32,
    /// 1: the clutch holds the orientation too; 0 (default): the orientation always follows the
    /// hand.
    pub clutch_orientation: u32,
    /// 1: the reported opening never jumps. It is held while the clutch is held, and after
    /// vbss_device_restore, a change of tool or vbss_device_hold_jaw, until the handle has passed
    /// it. A session also holds it in its first step and after vbss_session_restore. 0 (default):
    /// the opening always follows the handle.
    pub jaw_takeover: u32,
    /// Zero.
    pub reserved: u32,
    /// Age at which the jaw's opening is stale, s, 1e-4 to 1e3; default 0.1. The pose uses
    /// input_timeout of the output stage.
    pub jaw_timeout: f64,
    /// Time constant of estimated velocities, s, 0 to 10; default 0.005.
    pub velocity_time: f64,
    /// Largest |1 - length| of an orientation that is accepted and normalised, 0 to 0.5; default
    /// 1e-3.
    pub norm_tolerance: f64,
    /// Upper limit of couplings, N/m, 0 to 1e6; default 400. The device only reports it.
    pub max_stiffness: f64,
    /// Upper limit of couplings, N s/m, 0 to 1e6; default 4. The device only reports it.
    pub max_damping: f64,
    /// Calibration; NULL (default): the initialised one. The library copies it.
    pub calibration: *const vbss_device_calibration,
    /// Output stage; NULL (default): the initialised one. The library copies it.
    pub output: *const vbss_output_config,
}

/// Result of a read, in the world's frame.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_device_input {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Status of the device.
    pub status: vbss_device_status,
    /// VBSS_DEVICE_HAS_ bits of the known values; estimated velocities count.
    pub valid: u32,
    /// VBSS_DEVICE_HAS_ bits of the values that are stale and held; stale velocities are zero.
    pub stale: u32,
    /// VBSS_DEVICE_EVENT_ bits.
    pub events: u32,
    /// Bits 1, 2, 4: the workspace limits x, y, z.
    pub clamped: u32,
    /// Buttons as last reported, one bit each.
    pub buttons: u32,
    /// Buttons that were up in the last read and are down now.
    pub pressed: u32,
    /// Buttons that were down in the last read and are up now.
    pub released: u32,
    /// Kind of tool.
    pub tool: vbss_device_tool,
    /// 1: the jaws count as closed.
    pub jaw_closed: i32,
    /// 1: the clutch is held, so the pose stays and there is no force.
    pub clutched: i32,
    /// 1: the emergency stop is latched.
    pub stopped: i32,
    /// 1: `jaw` is held until the handle has passed it.
    pub jaw_held: u32,
    /// Time of the pose, by the adapter's clock, s.
    pub time: f64,
    /// Age of the pose, s; -1: there is none.
    pub age: f64,
    /// Age of the opening, s; -1: there is none.
    pub jaw_age: f64,
    /// Position, m.
    pub position: [f64; 3],
    /// Orientation from tool to world, unit quaternion w, x, y, z.
    pub orientation: [f64; 4],
    /// Velocity, m/s.
    pub velocity: [f64; 3],
    /// Angular velocity in the world's frame, rad/s.
    pub angular_velocity: [f64; 3],
    /// Opening, 0 (closed) to 1 (open).
    pub jaw: f64,
    /// Raw opening as last reported.
    pub jaw_raw: f64,
    /// Temperature as last reported, 0 to 1.
    pub temperature: f64,
}

/// Counts of a device since creation. Entry \[0\] is of the first adapter and \[1\] of the second.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_device_statistics {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Calls of vbss_device_read.
    pub reads: u64,
    /// Calls of vbss_device_write.
    pub writes: u64,
    /// Samples accepted.
    pub accepted: [u64; 2],
    /// Samples whose time had not advanced.
    pub repeated: [u64; 2],
    /// Samples refused because they are older than the one before.
    pub out_of_order: [u64; 2],
    /// Samples refused because of a NaN or an infinity.
    pub not_finite: [u64; 2],
    /// Samples refused because a field is out of range.
    pub out_of_range: [u64; 2],
    /// Samples refused because of an orientation outside norm_tolerance.
    pub not_unit: [u64; 2],
    /// Reads without a sample.
    pub failed_reads: [u64; 2],
    /// Outputs that an adapter did not accept.
    pub failed_writes: [u64; 2],
    /// Times the hardware was lost.
    pub lost: [u64; 2],
    /// Times the hardware began to refuse forces.
    pub faults: [u64; 2],
    /// Times the adapter's clock restarted.
    pub restarts: [u64; 2],
    /// Raw openings refused because they are outside jaw_margin.
    pub jaw_refused: u64,
    /// Times the pose became stale.
    pub pose_stale: u64,
    /// Reads with a stale pose.
    pub pose_stale_reads: u64,
    /// Times the opening became stale.
    pub jaw_stale: u64,
    /// Reads in which the workspace limited the pose.
    pub clamped_reads: u64,
    /// Times the clutch was held.
    pub clutches: u64,
    /// Largest age of a pose, s.
    pub oldest_pose: f64,
}

extern "C" {
    /// Fills a calibration with the defaults: the device's frame is the world's.
    ///
    /// @param calibration  the calibration to fill
    /// @param struct_size       `sizeof *calibration` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_device_calibration_init(calibration: *mut vbss_device_calibration, struct_size: u32) -> vbss_result;
    /// Fills a device's configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_device_config_init(config: *mut vbss_device_config, struct_size: u32) -> vbss_result;
    /// Creates a device: copies the tables of its adapters, opens them and asks for their capabilities.
    ///
    /// @param context      owner
    /// @param first        the adapter of the pose; must have `read`
    /// @param second       an adapter for the signals in `second_signals` and for outputs, or NULL. The
    /// second adapter drives the solenoid if it has one. The first one drives forces if it can.
    /// @param config       configuration; NULL for the defaults
    /// @param device  the new device; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_DEVICE (an adapter could not be opened or described; the error text
    /// quotes it), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE (also in
    /// capabilities), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on failure no adapter is open
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_create(context: *mut vbss_context, first: *const vbss_device_adapter, second: *const vbss_device_adapter, config: *const vbss_device_config, device: *mut *mut vbss_device) -> vbss_result;
    /// Switches all outputs off, closes the adapters and destroys the device.
    ///
    /// @param device  the device; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_destroy(device: *mut vbss_device) -> vbss_result;
    /// Reads each adapter once. The call succeeds even if the hardware fails: status, stale, events and
    /// statistics report faults. The library also logs a warning when the hardware is lost, is back, has
    /// stopped, refuses forces or restarts its clock. The call allocates nothing.
    ///
    /// @param device       the device
    /// @param now          the host's clock, s; not before the `now` of an earlier call. If it is
    /// earlier or out of range, the call returns an error and switches all outputs off
    /// @param input   receives the input
    /// @param struct_size  `sizeof *input` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_ARITHMETIC_MODE or
    /// VBSS_ERROR_BUSY; after an error no adapter was read
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_read(device: *mut vbss_device, now: f64, input: *mut vbss_device_input, struct_size: u32) -> vbss_result;
    /// Passes a command through the output stage and writes the result to the adapters. While the clutch
    /// is held, forces and solenoid are off. Two writes more than 0.1 s apart mean that the clock has
    /// jumped or the host was suspended: all outputs are then off for vbss_output_result::expires. The
    /// call allocates nothing.
    ///
    /// @param device       the device
    /// @param now          the host's clock, s; not before the `now` of an earlier call. If it is
    /// earlier or out of range, the call returns an error and switches all outputs off
    /// @param command      the wanted outputs, forces in the world's frame; NULL: no new command, so
    /// that the last one ages
    /// @param result  receives the outputs as written, in the device's frame; may be NULL
    /// @param struct_size  `sizeof *result` as the caller was compiled
    /// @return as vbss_device_read, or VBSS_ERROR_UNKNOWN_FIELD; after an error nothing was written,
    /// except zeros for a wrong `now`
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_write(device: *mut vbss_device, now: f64, command: *const vbss_output_command, result: *mut vbss_output_result, struct_size: u32) -> vbss_result;
    /// Writes like vbss_device_write, with the force of a virtual coupling. The coupling acts relative to
    /// the pose that was read last; where the workspace limits that pose, it also limits the coupling. An
    /// adapter with its own servo receives the coupling in its frame, unless forces are off. It then
    /// applies the coupling without the host until `command_timeout` of its output stage has passed.
    ///
    /// A device gets the force of a tool's spring in one way only. Use this function with the pose of the
    /// tool, or vbss_device_write with vbss_grasper_state::hand_force. Both at once would be twice the
    /// spring, so this call refuses a command with a force. docs/reference/device-layer.md says which one suits which
    /// device.
    ///
    /// @param device       the device
    /// @param now          the host's clock, s; not before the `now` of an earlier call. If it is
    /// earlier or out of range, the call returns an error and switches all outputs off
    /// @param command      the other wanted outputs, torque in the world's frame; its force must be 0.
    /// vbss_device_coupling::force has other forces than that of the spring
    /// @param coupling     pose of the tool and the coupling to the hand, in the world's frame
    /// @param result  receives the outputs as written, in the device's frame; may be NULL
    /// @param struct_size  `sizeof *result` as the caller was compiled
    /// @return as vbss_device_write (VBSS_ERROR_OUT_OF_RANGE also: the command has a force), or
    /// VBSS_ERROR_NULL_ARGUMENT
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_write_coupled(device: *mut vbss_device, now: f64, command: *const vbss_output_command, coupling: *const vbss_device_coupling, result: *mut vbss_output_result, struct_size: u32) -> vbss_result;
    /// Emergency stop: writes zeros at once and latches. All outputs stay off until
    /// vbss_device_clear_emergency_stop.
    ///
    /// @param device  the device
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_latch_emergency_stop(device: *mut vbss_device) -> vbss_result;
    /// Clears the emergency stop. Forces rise from zero. If its cause persists, the next read latches
    /// it again.
    ///
    /// @param device  the device
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_clear_emergency_stop(device: *mut vbss_device) -> vbss_result;
    /// Holds or releases the clutch. While it is held, the pose stays and the hand moves freely. After
    /// the release the pose follows the hand from where it stayed.
    ///
    /// @param device  the device
    /// @param held    1: hold, 0: release; no effect if it is already so
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_set_clutch(device: *mut vbss_device, held: i32) -> vbss_result;
    /// Shifts and turns the calibrated pose so that the last sample corresponds to a given pose, and
    /// releases the clutch.
    ///
    /// @param device       the device
    /// @param position     position of the tool, world, m, each coordinate at most 1e3 in magnitude;
    /// NULL keeps it
    /// @param orientation  quaternion w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps it
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_WRONG_STATE (there is no pose yet),
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_recentre(device: *mut vbss_device, position: *const f64, orientation: *const f64) -> vbss_result;
    /// Holds the opening that reads report until the handle has passed it, or has come within 0.04 of
    /// it. A host calls this when the jaws and the handle differ, for example after it has restored a
    /// scene.
    ///
    /// @param device   the device; its configuration has `jaw_takeover`
    /// @param opening  opening of the jaws, 0 (closed) to 1 (open)
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_INCOMPATIBLE (the
    /// configuration has no `jaw_takeover`), VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_hold_jaw(device: *mut vbss_device, opening: f64) -> vbss_result;
    /// Replaces the calibration from the next read on. The call resets the shifts of the clutch and of
    /// vbss_device_recentre and the filter of the opening.
    ///
    /// @param device       the device
    /// @param calibration  the calibration; NULL for the defaults
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_set_calibration(device: *mut vbss_device, calibration: *const vbss_device_calibration) -> vbss_result;
    /// Returns the capabilities of the hardware.
    ///
    /// @param device             the device
    /// @param which              0 or 1: capabilities that the first or second adapter reports; 2: both
    /// together, within the limits of the configuration
    /// @param capabilities  receives the capabilities
    /// @param struct_size        `sizeof *capabilities` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such adapter)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_get_capabilities(device: *mut vbss_device, which: u32, capabilities: *mut vbss_device_capabilities, struct_size: u32) -> vbss_result;
    /// Returns the last failure of an adapter.
    ///
    /// @param device       the device
    /// @param which        0 or 1: the first or second adapter
    /// @param result  the result of its function, VBSS_OK when nothing has failed yet; may be NULL
    /// @param text    its explanation, never NULL, valid until the next call that reads, writes or
    /// restores the device; the argument may be NULL
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NOT_FOUND (no such adapter)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_get_error(device: *mut vbss_device, which: u32, result: *mut vbss_result, text: *mut *const c_char) -> vbss_result;
    /// Returns the input statistics of a device.
    ///
    /// @param device           the device
    /// @param statistics  receives them
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_get_statistics(device: *mut vbss_device, statistics: *mut vbss_device_statistics, struct_size: u32) -> vbss_result;
    /// Returns the statistics of the device's output stage.
    ///
    /// @param device           the device
    /// @param statistics  receives them
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_get_output_statistics(device: *mut vbss_device, statistics: *mut vbss_output_statistics, struct_size: u32) -> vbss_result;
    /// Saves the device layer: calibration, clutch, filters, ages, output stage, latch and statistics.
    /// The state of the adapters is not saved.
    ///
    /// @param device        the device
    /// @param bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
    /// @param capacity      size of `bytes`
    /// @param written  bytes written, or bytes needed with VBSS_ERROR_CAPACITY
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_save(device: *mut vbss_device, bytes: *mut u8, capacity: u64, written: *mut u64) -> vbss_result;
    /// Restores a snapshot of a device with the same configuration and capabilities, completely or not
    /// at all. The call also restores the latch of the emergency stop. With a hand on the device, call
    /// vbss_device_latch_emergency_stop afterwards.
    ///
    /// @param device  the device
    /// @param bytes   the snapshot
    /// @param count   its size
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
    /// VBSS_ERROR_CORRUPT (also: the snapshot is of another device), VBSS_ERROR_DATA_VERSION,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on failure nothing has changed
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_restore(device: *mut vbss_device, bytes: *const u8, count: u64) -> vbss_result;
    /// Returns a hash of the device layer; equal histories give equal hashes on every machine.
    ///
    /// @param device     the device
    /// @param hash  receives the hash
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_device_get_hash(device: *mut vbss_device, hash: *mut u64) -> vbss_result;
}
