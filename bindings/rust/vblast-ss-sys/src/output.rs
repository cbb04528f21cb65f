// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


// Bits for the actions of an output stage in a step.
/// A number was NaN or infinite: all off.
pub const VBSS_OUTPUT_FLAG_NOT_FINITE: u32 = 1;
/// The device refuses forces: all off.
pub const VBSS_OUTPUT_FLAG_FAULT: u32 = 2;
/// The force was above the largest magnitude.
pub const VBSS_OUTPUT_FLAG_CLAMPED: u32 = 4;
/// The force was above the limit of the past load.
pub const VBSS_OUTPUT_FLAG_CONTINUOUS: u32 = 8;
/// The force was above the limit of the temperature.
pub const VBSS_OUTPUT_FLAG_WARM: u32 = 16;
/// The force rose faster than the limit.
pub const VBSS_OUTPUT_FLAG_SLEWED: u32 = 32;
/// The pose is too old: ramp to zero.
pub const VBSS_OUTPUT_FLAG_INPUT_STALE: u32 = 64;
/// The command is too old: ramp to zero.
pub const VBSS_OUTPUT_FLAG_COMMAND_STALE: u32 = 128;
/// The emergency stop is latched: all off.
pub const VBSS_OUTPUT_FLAG_STOPPED: u32 = 256;
/// The step came later than the watchdog allows.
pub const VBSS_OUTPUT_FLAG_LATE: u32 = 512;
/// The command asks for the solenoid, but it is off for one of these reasons. Devices switch it off also while
/// the clutch is engaged, the opening is stale, or an adapter is lost or has just failed.
pub const VBSS_OUTPUT_FLAG_SOLENOID_OFF: u32 = 1024;
/// The solenoid was on for too long.
pub const VBSS_OUTPUT_FLAG_SOLENOID_SPENT: u32 = 2048;
/// Devices: an adapter did not accept the result.
pub const VBSS_OUTPUT_FLAG_NOT_WRITTEN: u32 = 4096;

/// An output stage on its own, for hosts with their own device layer.
#[repr(C)]
pub struct vbss_output {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Limits of an output stage. Fill it with vbss_output_config_init, then change fields. A
/// device lowers them to the capabilities of its adapters, and its timeouts are at least 2.5 of
/// their periods.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_output_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Largest force, N, 0 to 1e3; default 3.
    pub max_force: f64,
    /// Largest torque, N m, 0 to 1e3; default 0.1.
    pub max_torque: f64,
    /// Permitted root mean square of the force over an unlimited time, N, 0 to 1e3; default 0.88, a value often
    /// given for the Touch, without a known public source.
    pub continuous_force: f64,
    /// Permitted root mean square of the torque, N m; default 0.03, chosen.
    pub continuous_torque: f64,
    /// Time constant of these means, s, 1e-3 to 1e4; default 10, chosen.
    pub load_time: f64,
    /// Temperature above which forces are reduced, 0 to 1; default 0.7.
    pub warm: f64,
    /// Temperature at which forces are zero, above `warm`, to 2; default 1.
    pub hot: f64,
    /// Fastest rise or turn, N/s, 1e-3 to 1e9; default 500. No limit for a fall.
    pub force_rise: f64,
    /// Fastest rise or turn of the torque, N m/s; default 20.
    pub torque_rise: f64,
    /// Age at which a pose is stale, s, 1e-4 to 10; default 0.005.
    pub input_timeout: f64,
    /// Age at which a command is stale, s, 1e-4 to 10; default 0.005.
    pub command_timeout: f64,
    /// Length of the ramp to zero, s, 0 to 10; default 0.005.
    pub ramp_time: f64,
    /// Longest time of the solenoid on, s, 0 to 1e4; default 1, chosen.
    pub solenoid_time: f64,
    /// Largest long-term share of time of the solenoid on, 0 to 0.99; default 0.25, chosen.
    pub solenoid_duty: f64,
}

/// Command to an output stage. Fill it with vbss_output_command_init, then set its fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_output_command {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// 1: on; default 0.
    pub solenoid: u32,
    /// 1: the device refuses forces; default 0.
    pub fault: u32,
    /// Zero.
    pub reserved: u32,
    /// Force, N; for a device, in the world's frame. A flag reports numbers that are not finite.
    pub force: [f64; 3],
    /// Torque, N m; for a device, in the world's frame.
    pub torque: [f64; 3],
    /// Age of the command, s, such as that of the anchor it was computed from; default 0.
    pub age: f64,
    /// Age of the pose, s; default 0. A device uses the age of its own pose if that is older.
    pub input_age: f64,
    /// Temperature of the motors; default 0. A device uses its own value if that is higher.
    pub temperature: f64,
}

/// Counters of an output stage. Each counter of a flag is the number of steps with that flag.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_output_statistics {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Steps so far.
    pub steps: u64,
    /// Steps with VBSS_OUTPUT_FLAG_NOT_FINITE.
    pub not_finite: u64,
    /// Steps with VBSS_OUTPUT_FLAG_FAULT.
    pub faults: u64,
    /// Steps with VBSS_OUTPUT_FLAG_CLAMPED.
    pub clamped: u64,
    /// Steps with VBSS_OUTPUT_FLAG_CONTINUOUS.
    pub continuous: u64,
    /// Steps with VBSS_OUTPUT_FLAG_WARM.
    pub warm: u64,
    /// Steps with VBSS_OUTPUT_FLAG_SLEWED.
    pub slewed: u64,
    /// Steps with VBSS_OUTPUT_FLAG_INPUT_STALE.
    pub input_stale: u64,
    /// Steps with VBSS_OUTPUT_FLAG_COMMAND_STALE.
    pub command_stale: u64,
    /// Steps with VBSS_OUTPUT_FLAG_STOPPED.
    pub stopped: u64,
    /// Steps with VBSS_OUTPUT_FLAG_LATE.
    pub late: u64,
    /// Steps with VBSS_OUTPUT_FLAG_SOLENOID_OFF.
    pub solenoid_off: u64,
    /// Steps with VBSS_OUTPUT_FLAG_SOLENOID_SPENT.
    pub solenoid_spent: u64,
    /// Ramps that the watchdog started.
    pub watchdogs: u64,
    /// Times that the emergency stop was latched.
    pub stops: u64,
    /// Times that the solenoid was switched on.
    pub pulses: u64,
    /// Largest force in a result, N.
    pub largest_force: f64,
    /// Largest torque in a result, N m.
    pub largest_torque: f64,
    /// Total time of the solenoid on, s.
    pub solenoid_on: f64,
}

/// Result of an output stage, for the hardware. In a call of an adapter it is followed by zeros up to 4096
/// bytes.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_output_result {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// VBSS_OUTPUT_FLAG_ bits: actions of the stage.
    pub flags: u32,
    /// 1: on, 0: off.
    pub solenoid: u32,
    /// Zero.
    pub reserved: u32,
    /// Force, N; for an adapter, in the device's frame.
    pub force: [f64; 3],
    /// Torque, N m; for an adapter, in the device's frame.
    pub torque: [f64; 3],
    /// Mean square force over the square of its limit; 1: at the limit.
    pub force_load: f64,
    /// Mean square torque over the square of its limit.
    pub torque_load: f64,
    /// Time that the solenoid may stay on from now on, s.
    pub solenoid_left: f64,
    /// Time after which an adapter without a new call switches all outputs off itself, s.
    pub expires: f64,
}

extern "C" {
    /// Fills the limits of an output stage with the defaults.
    ///
    /// @param config  the limits to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_output_config_init(config: *mut vbss_output_config, struct_size: u32) -> vbss_result;
    /// Fills a command with the defaults: all off, ages zero.
    ///
    /// @param command  the command to fill
    /// @param struct_size   `sizeof *command` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_output_command_init(command: *mut vbss_output_command, struct_size: u32) -> vbss_result;
    /// Creates an output stage.
    ///
    /// @param context      owner
    /// @param config       its limits; NULL for the defaults
    /// @param output  the new stage; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_output_create(context: *mut vbss_context, config: *const vbss_output_config, output: *mut *mut vbss_output) -> vbss_result;
    /// Destroys an output stage.
    ///
    /// @param output  the stage; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_output_destroy(output: *mut vbss_output) -> vbss_result;
    /// Applies the limits to a command. The call allocates nothing.
    ///
    /// @param output       the stage
    /// @param h            time since the last step, s, 0 to 1e6
    /// @param command      the command; NULL: no new command since the last one, which ages together with its pose
    /// @param result  receives the limited result
    /// @param struct_size  `sizeof *result` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE (h), VBSS_ERROR_ARITHMETIC_MODE
    /// or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_output_step(output: *mut vbss_output, h: f64, command: *const vbss_output_command, result: *mut vbss_output_result, struct_size: u32) -> vbss_result;
    /// Latches the emergency stop: all results are zero until vbss_output_clear_emergency_stop.
    ///
    /// @param output  the stage
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_output_latch_emergency_stop(output: *mut vbss_output) -> vbss_result;
    /// Clears the emergency stop.
    ///
    /// @param output  the stage
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_output_clear_emergency_stop(output: *mut vbss_output) -> vbss_result;
    /// Returns the counters since creation.
    ///
    /// @param output           the stage
    /// @param statistics  receives them
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_output_get_statistics(output: *mut vbss_output, statistics: *mut vbss_output_statistics, struct_size: u32) -> vbss_result;
}
