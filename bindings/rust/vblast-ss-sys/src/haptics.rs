// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_char, c_void};
#[allow(unused_imports)]
use crate::*;


/// State of an arm or a line: a VBSS_HAPTICS_STATE_ constant.
pub type vbss_haptics_state = i32;

/// Wiring of a potentiometer: a VBSS_NIDAQMX_TERMINAL_ constant.
pub type vbss_nidaqmx_terminal = i32;

// The constants of vbss_haptics_state.
/// There is no measurement yet.
pub const VBSS_HAPTICS_STATE_WAITING: vbss_haptics_state = 0;
/// The hardware works.
pub const VBSS_HAPTICS_STATE_RUNNING: vbss_haptics_state = 1;
/// It measures, but accepts no forces for now: motors warm, force or speed too high.
pub const VBSS_HAPTICS_STATE_REFUSING: vbss_haptics_state = 2;
/// It accepts no forces until it is calibrated: put the stylus into the inkwell. An arm whose
/// pose has been constant to the bit for 1 s is in this state, too: it is uncalibrated, its
/// encoders give no data, or no hand holds it. It accepts forces again when its pose changes.
pub const VBSS_HAPTICS_STATE_UNCALIBRATED: vbss_haptics_state = 3;
/// The hardware is missing: unplugged, or its driver has failed.
pub const VBSS_HAPTICS_STATE_LOST: vbss_haptics_state = 4;

// The constants of vbss_nidaqmx_terminal.
/// Against ground: 11 bits of a USB-6008.
pub const VBSS_NIDAQMX_TERMINAL_SINGLE_ENDED: vbss_nidaqmx_terminal = 0;
/// Between two inputs: 12 bits.
pub const VBSS_NIDAQMX_TERMINAL_DIFFERENTIAL: vbss_nidaqmx_terminal = 1;

/// A function of the host that the vendor's servo thread calls at the end of each tick, after it has
/// applied the forces. A host can step its scene here; the new forces are applied in the next tick.
/// From the first call to the return of vbss_openhaptics_destroy only this function may use the
/// context of the devices. It must not destroy the arms and must not wait.
///
/// @param user  the config's `user`
/// @param now   number of ticks times the length of a tick, s: a clock for devices
pub type vbss_openhaptics_tick_fn = Option<unsafe extern "C" fn(user: *mut c_void, now: f64)>;

/// One or two haptic arms under one servo.
#[repr(C)]
pub struct vbss_openhaptics {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// One or two handles: a potentiometer and a solenoid each.
#[repr(C)]
pub struct vbss_nidaqmx {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of the arms. Fill it with vbss_openhaptics_config_init, then change fields. The
/// library copies the texts.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_openhaptics_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Number of arms, 1 (default) or 2.
    pub device_count: u32,
    /// Rate of the servo, Hz, 100 to 8000; default 1000. The vendor accepts 500, 1000 and 2000, and
    /// other rates for some arms.
    pub rate: u32,
    /// Zero.
    pub reserved: u32,
    /// Path or name of the vendor's library; NULL (default): `libHD.so`, `libHD.so.3.4` or
    /// `libHD.so.3.0`; `hd.dll`; or `libHD.dylib`.
    pub library: *const c_char,
    /// Name of the first arm in the vendor's set-up; NULL (default): its default device, or the one
    /// called `Default Device` or `Default PHANToM`.
    pub first_name: *const c_char,
    /// Name of the second arm in the vendor's set-up; default `Device2`.
    pub second_name: *const c_char,
    /// Limits of the output stage in the servo, lowered to the limits that the arms report; NULL
    /// (default): the initialised ones. The library copies them.
    pub output: *const vbss_output_config,
    /// Function called in each tick; NULL (default): the host steps in its own thread.
    pub tick: vbss_openhaptics_tick_fn,
    /// Pointer that `tick` receives; may be NULL.
    pub user: *mut c_void,
}

/// Status and counts of an arm.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_openhaptics_status {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// State of the arm.
    pub state: vbss_haptics_state,
    /// Last error code of the vendor's library for this arm; 0: none.
    pub error: u32,
    /// The vendor's internal number of that error.
    pub internal_error: i32,
    /// Number of ticks of the servo.
    pub ticks: u64,
    /// Ticks that began later than one tick length after the tick before.
    pub late_ticks: u64,
    /// Ticks without a pose.
    pub failed_ticks: u64,
    /// Errors that the vendor's library reported for this arm.
    pub errors: u64,
    /// Outputs of the host that the servo has received.
    pub orders: u64,
    /// Ticks with forces ramped down because the host was silent.
    pub silent_ticks: u64,
    /// Temperature of the hottest motor, 0 to 1.
    pub temperature: f64,
    /// Longest time from the beginning of a tick to the end of the library's work in it, s.
    pub longest_tick: f64,
    /// Force last applied, in the device's frame, N.
    pub force: [f64; 3],
    /// 1: the pose has been constant to the bit for 1 s.
    pub is_constant: u32,
    /// Zero.
    pub reserved: u32,
}

/// Configuration of the lines. Fill it with vbss_nidaqmx_config_init, then change fields. The
/// library copies the texts; a name has at most 127 bytes.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_nidaqmx_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Number of handles, 1 or 2 (default).
    pub handle_count: u32,
    /// Path or name of the vendor's library; NULL (default): `libnidaqmx.so.1` or, without it,
    /// `libnidaqmxbase.so`; `nicaiu.dll` on Windows. NI-DAQmx Base is recognised by its
    /// functions. It needs all lines on one port, such as `Dev1/port0/line0` and
    /// `Dev1/port0/line1`, and the other lines of that port stay high.
    pub library: *const c_char,
    /// Analog input of the first handle; default `Dev1/ai0`.
    pub first_input: *const c_char,
    /// Analog input of the second handle; default `Dev1/ai1`.
    pub second_input: *const c_char,
    /// Digital line of the first solenoid; NULL: there are no solenoids; default
    /// `Dev1/port0/line0`.
    pub first_line: *const c_char,
    /// Digital line of the second solenoid; default `Dev1/port0/line1`.
    pub second_line: *const c_char,
    /// Wiring of the potentiometers; default VBSS_NIDAQMX_TERMINAL_SINGLE_ENDED.
    pub terminal: vbss_nidaqmx_terminal,
    /// 1 (default): a low line switches the solenoid's current on, so undriven lines, which are
    /// pulled high, keep it off. 0: a high line switches it on.
    pub active_low: u32,
    /// 1 (default): a thread of the library moves the data; 0: the host calls vbss_nidaqmx_poll.
    pub own_thread: u32,
    /// Zero.
    pub reserved: u32,
    /// Lowest input voltage, V, -10 to 10; default -10.
    pub low: f64,
    /// Highest input voltage, V, above `low`, to 10; default 10.
    pub high: f64,
    /// Time between two samples, s, 5e-4 to 1; default 0.002.
    pub period: f64,
    /// Longest wait of a call for the hardware, s, 1e-3 to 10, or 0 (default): the library
    /// chooses it. It starts with 0.004 s and doubles the wait up to 0.064 s while calls time
    /// out. A wait that the host sets does not change; the error text of the handle reports when
    /// it is too short.
    pub timeout: f64,
}

/// Status and counts of the lines.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_nidaqmx_status {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// State of the lines. REFUSING: the last read failed, or the lines are being reopened after a
    /// transient error; solenoids are off. LOST: a permanent error; the library reopens the lines
    /// when it can.
    pub state: vbss_haptics_state,
    /// Last error code of the vendor's library; 0: none.
    pub error: i32,
    /// Bits 1, 2: the first, the second solenoid is on.
    pub solenoids: u32,
    /// Rounds of one write and one read.
    pub cycles: u64,
    /// Reads without a sample.
    pub failed_reads: u64,
    /// Writes that failed.
    pub failed_writes: u64,
    /// Calls that succeeded with a warning.
    pub warnings: u64,
    /// Rounds in which a solenoid was switched off because the host was silent.
    pub silent_cycles: u64,
    /// Reads and writes that timed out.
    pub timeouts: u64,
    /// Times the lines were reopened after an error.
    pub reopened: u64,
    /// Rounds so slow that a solenoid would switch off later than its command expires.
    pub late_rounds: u64,
    /// Current longest wait of a call for the hardware, s.
    pub timeout: f64,
    /// Time from round to round, mean over about the last 16 rounds, s.
    pub round_time: f64,
    /// Longest time from the host's last command until a solenoid is off, at the current round
    /// time, s; 0: unknown. A command expires after vbss_output_result::expires, 10 ms by default;
    /// rounds longer than half of that are too slow.
    pub off_time: f64,
}

extern "C" {
    /// Fills a configuration of arms with the defaults: one arm, the vendor's default device.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_openhaptics_config_init(config: *mut vbss_openhaptics_config, struct_size: u32) -> vbss_result;
    /// Loads the vendor's library, opens the arms and starts the servo. There is no force until the host
    /// writes to a device.
    ///
    /// @param context           owner
    /// @param config            configuration; NULL for the defaults
    /// @param openhaptics  the arms; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_DEVICE (no such library, no such arm, or the servo does not start:
    /// the error text says which), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT,
    /// VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE,
    /// VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on failure everything
    /// is closed again
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_openhaptics_create(context: *mut vbss_context, config: *const vbss_openhaptics_config, openhaptics: *mut *mut vbss_openhaptics) -> vbss_result;
    /// Switches forces off, stops the servo and closes the arms. Their devices report them as lost.
    ///
    /// @param openhaptics  the arms; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_openhaptics_destroy(openhaptics: *mut vbss_openhaptics) -> vbss_result;
    /// Returns an arm as an adapter for one device at a time.
    ///
    /// @param openhaptics      the arms
    /// @param which            0 or 1
    /// @param\[in,out\] adapter an initialised table; the call sets every field
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such arm)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_openhaptics_get_adapter(openhaptics: *mut vbss_openhaptics, which: u32, adapter: *mut vbss_device_adapter) -> vbss_result;
    /// Returns the status of an arm after its newest tick.
    ///
    /// @param openhaptics  the arms
    /// @param which        0 or 1
    /// @param status      receives the status
    /// @param struct_size  `sizeof *status` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such arm)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_openhaptics_get_status(openhaptics: *mut vbss_openhaptics, which: u32, status: *mut vbss_openhaptics_status, struct_size: u32) -> vbss_result;
    /// Returns model and serial number of an arm from the vendor's library.
    ///
    /// @param openhaptics  the arms
    /// @param which        0 or 1
    /// @param model   its model, never NULL, valid as long as the arms exist; the argument may be
    /// NULL
    /// @param serial  its serial number, never NULL, valid as long as the arms exist; the argument
    /// may be NULL
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NOT_FOUND (no such arm)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_openhaptics_get_identity(openhaptics: *mut vbss_openhaptics, which: u32, model: *mut *const c_char, serial: *mut *const c_char) -> vbss_result;
    /// Fills a configuration of lines with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_nidaqmx_config_init(config: *mut vbss_nidaqmx_config, struct_size: u32) -> vbss_result;
    /// Loads the vendor's library, opens the lines with solenoids off, and starts their thread.
    ///
    /// @param context       owner
    /// @param config        configuration; NULL for the defaults
    /// @param nidaqmx  the lines; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_DEVICE (no such library, no such line, or no thread: the error text
    /// says which), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT (also: a name is NULL),
    /// VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE,
    /// VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on failure everything
    /// is closed again
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_nidaqmx_create(context: *mut vbss_context, config: *const vbss_nidaqmx_config, nidaqmx: *mut *mut vbss_nidaqmx) -> vbss_result;
    /// Switches solenoids off, ends the thread and closes the lines. Their devices report them as lost.
    ///
    /// @param nidaqmx  the lines; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_nidaqmx_destroy(nidaqmx: *mut vbss_nidaqmx) -> vbss_result;
    /// Returns a handle as an adapter for one device at a time, with `jaw_raw` in V and its solenoid.
    ///
    /// @param nidaqmx          the lines
    /// @param which            0 or 1
    /// @param\[in,out\] adapter an initialised table; the call sets every field
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such handle)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_nidaqmx_get_adapter(nidaqmx: *mut vbss_nidaqmx, which: u32, adapter: *mut vbss_device_adapter) -> vbss_result;
    /// Makes one round in place of the library's thread: writes the newest outputs and reads one sample.
    /// The call waits for the hardware, up to twice `timeout`.
    ///
    /// @param nidaqmx  the lines, created without a thread
    /// @param now      a clock that never runs backwards, s, at most 1e9 in magnitude; when it does,
    /// solenoids are switched off
    /// @return VBSS_OK (also when the hardware fails, which the status reports),
    /// VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_WRONG_STATE (there is a thread),
    /// VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE, all without an error text
    /// @threads any one thread, also while another uses the context, except during the destruction of
    /// the lines
    /// @since 1.0
    pub fn vbss_nidaqmx_poll(nidaqmx: *mut vbss_nidaqmx, now: f64) -> vbss_result;
    /// Returns the status of the lines after their newest round.
    ///
    /// @param nidaqmx      the lines
    /// @param status      receives the status
    /// @param struct_size  `sizeof *status` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_nidaqmx_get_status(nidaqmx: *mut vbss_nidaqmx, status: *mut vbss_nidaqmx_status, struct_size: u32) -> vbss_result;
    /// Lists the devices of the vendor's driver: a line of text for each, with its name and its product.
    ///
    /// @param context    the context for errors
    /// @param library    path or name of the vendor's library; NULL as in vbss_nidaqmx_config
    /// @param text  receives UTF-8 text and a final zero, truncated to `bytes`
    /// @param bytes      size of `text`, at least 1
    /// @return VBSS_OK, VBSS_ERROR_DEVICE (no such library, it failed, it knows no device, or it is NI-DAQmx Base, which
    /// has no list), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_nidaqmx_list_devices(context: *mut vbss_context, library: *const c_char, text: *mut c_char, bytes: u32) -> vbss_result;
}
