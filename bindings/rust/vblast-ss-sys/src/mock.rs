// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_void};
#[allow(unused_imports)]
use crate::*;


/// Fault of a mock: a VBSS_MOCK_FAULT_ constant.
pub type vbss_mock_fault = i32;

/// An array: a VBSS_MOCK_VIEW_ constant.
pub type vbss_mock_field = i32;

// The constants of vbss_mock_fault; t0: start of the fault, v: its value.
/// A NaN in the position (v = 0), orientation (1), velocity (2), jaw and jaw_raw (3), or
/// time (4).
pub const VBSS_MOCK_FAULT_NAN: vbss_mock_fault = 1;
/// Each read repeats the sample of t0.
pub const VBSS_MOCK_FAULT_STALL: vbss_mock_fault = 2;
/// Reads and writes fail, with VBSS_DEVICE_FLAG_LOST.
pub const VBSS_MOCK_FAULT_DISCONNECT: vbss_mock_fault = 3;
/// Only one new sample every v s.
pub const VBSS_MOCK_FAULT_RATE: vbss_mock_fault = 4;
/// Samples of v s ago.
pub const VBSS_MOCK_FAULT_LATE: vbss_mock_fault = 5;
/// In every second interval of v s, samples of v s ago, so that their order is broken.
pub const VBSS_MOCK_FAULT_SHUFFLE: vbss_mock_fault = 6;
/// Orientations of length v.
pub const VBSS_MOCK_FAULT_NORM: vbss_mock_fault = 7;
/// The x coordinate is larger by v m.
pub const VBSS_MOCK_FAULT_JUMP: vbss_mock_fault = 8;
/// A temperature of v.
pub const VBSS_MOCK_FAULT_TEMPERATURE: vbss_mock_fault = 9;
/// A raw opening of v, like that of a broken wire.
pub const VBSS_MOCK_FAULT_JAW: vbss_mock_fault = 10;
/// VBSS_DEVICE_FLAG_STOP.
pub const VBSS_MOCK_FAULT_STOP: vbss_mock_fault = 11;
/// VBSS_DEVICE_FLAG_FAULT.
pub const VBSS_MOCK_FAULT_REFUSAL: vbss_mock_fault = 12;
/// Reads fail.
pub const VBSS_MOCK_FAULT_READ_FAILS: vbss_mock_fault = 13;
/// Writes fail.
pub const VBSS_MOCK_FAULT_WRITE_FAILS: vbss_mock_fault = 14;

// The constants of vbss_mock_field.
/// (n x 9) F64: now, force, torque, solenoid, flags of each write since vbss_mock_clear_rows.
pub const VBSS_MOCK_VIEW_ROWS: vbss_mock_field = 1;

/// Sample of a mock as a function of time.
///
/// @param user         the config's `user`
/// @param time         time of the sample, s: the host's clock, or earlier by a fault
/// @param sample  `time` is set, all else is cleared, orientation (1, 0, 0, 0)
pub type vbss_mock_measure_fn = Option<unsafe extern "C" fn(user: *mut c_void, time: f64, sample: *mut vbss_device_sample)>;

/// An adapter without hardware: driven by a function of time or by samples, with faults on demand.
#[repr(C)]
pub struct vbss_mock {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of a mock. Fill it with vbss_mock_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_mock_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Largest number of faults, 0 to 4096; default 16.
    pub fault_capacity: u32,
    /// Largest number of stored rows, one for each write, 0 to 2^20; default 1024.
    pub row_capacity: u32,
    /// Zero.
    pub reserved: u32,
    /// Function of time for samples; NULL (default): the sample of vbss_mock_set_sample.
    pub measure: vbss_mock_measure_fn,
    /// Argument of measure; may be NULL.
    pub user: *mut c_void,
    /// Capabilities; NULL (default): 6 and 3 degrees of freedom, 3.3 N, 400 N/m, 4 N s/m, 1 kHz,
    /// a box of 0.15 m, all signals and outputs. The library copies them.
    pub capabilities: *const vbss_device_capabilities,
}

/// Counters of a mock.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_mock_statistics {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// 1: the mock is open.
    pub open: i32,
    /// Number of calls that opened it.
    pub opens: u64,
    /// Number of reads.
    pub reads: u64,
    /// Number of writes, also those that failed.
    pub writes: u64,
    /// Rows beyond row_capacity.
    pub rows_lost: u64,
}

extern "C" {
    /// Fills a mock's configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_mock_config_init(config: *mut vbss_mock_config, struct_size: u32) -> vbss_result;
    /// Creates a mock.
    ///
    /// @param context    owner
    /// @param config     the configuration; NULL for the defaults
    /// @param mock  the new mock; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_mock_create(context: *mut vbss_context, config: *const vbss_mock_config, mock: *mut *mut vbss_mock) -> vbss_result;
    /// Destroys a mock. A device that uses it reports it as lost.
    ///
    /// @param mock  the mock; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_mock_destroy(mock: *mut vbss_mock) -> vbss_result;
    /// Fills an adapter table for the mock, for one device at a time.
    ///
    /// @param mock             the mock
    /// @param\[in,out\] adapter an initialised table; the call sets every field
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_mock_get_adapter(mock: *mut vbss_mock, adapter: *mut vbss_device_adapter) -> vbss_result;
    /// Sets the sample that later reads return, unless the mock has a function of time. Reads return it
    /// unchecked, even with invalid numbers; faults act on it afterwards.
    ///
    /// @param mock    the mock
    /// @param sample  an initialised sample
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_mock_set_sample(mock: *mut vbss_mock, sample: *const vbss_device_sample) -> vbss_result;
    /// Adds a fault. STALL, RATE, LATE and SHUFFLE need a function of time; faults act in the order they were added.
    ///
    /// @param mock   the mock
    /// @param fault  the fault
    /// @param from   first `now` with the fault, s
    /// @param until  first `now` without the fault, s, not before `from`; up to 1e9
    /// @param value  value of the fault; RATE, SHUFFLE: 1e-6 to 1e3, LATE: 0 to 1e3, NAN: 0 to 4,
    /// others: up to 1e9
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_INCOMPATIBLE
    /// (there is no function of time), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_mock_add_fault(mock: *mut vbss_mock, fault: vbss_mock_fault, from: f64, until: f64, value: f64) -> vbss_result;
    /// Removes all faults.
    ///
    /// @param mock  the mock
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_mock_clear_faults(mock: *mut vbss_mock) -> vbss_result;
    /// Clears the rows of the writes.
    ///
    /// @param mock  the mock
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_mock_clear_rows(mock: *mut vbss_mock) -> vbss_result;
    /// Returns a view of the rows of the writes.
    ///
    /// @param mock         the mock
    /// @param field        the array
    /// @param view    receives the view; valid until the next write or change
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_OUT_OF_RANGE (no such field)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_mock_get_view(mock: *mut vbss_mock, field: vbss_mock_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
    /// Returns the counters since creation.
    ///
    /// @param mock             the mock
    /// @param statistics  receives them
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_mock_get_statistics(mock: *mut vbss_mock, statistics: *mut vbss_mock_statistics, struct_size: u32) -> vbss_result;
}
