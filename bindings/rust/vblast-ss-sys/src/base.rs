// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_char, c_void};
#[allow(unused_imports)]
use crate::*;

pub const VBSS_VERSION_MAJOR: u32 = 1;
pub const VBSS_VERSION_MINOR: u32 = 0;
pub const VBSS_VERSION_PATCH: u32 = 0;

/// Status of a call: VBSS_OK (0) or a negative VBSS_ERROR_ constant. Refusals differ by what the host
/// can do about them (docs/reference/abi.md). VBSS_ERROR_OUT_OF_RANGE concerns numbers alone, also constants
/// that do not exist, and indices of nodes, edges and triangles.
pub type vbss_result = i32;

/// Importance of a log message: a VBSS_LOG_ constant; a larger number is less important.
pub type vbss_log_level = i32;

/// Method of computation of an object: a VBSS_METHOD_ constant.
pub type vbss_method = i32;

/// Type of the values of a view: a VBSS_VIEW_TYPE_ constant.
pub type vbss_view_type = i32;

// The constants of vbss_result, one for each row of VBSS_RESULTS.
/// success
pub const VBSS_OK: vbss_result = 0;
/// a required pointer is NULL
pub const VBSS_ERROR_NULL_ARGUMENT: vbss_result = -1;
/// an argument is outside its range
pub const VBSS_ERROR_OUT_OF_RANGE: vbss_result = -2;
/// an argument is NaN or infinite
pub const VBSS_ERROR_NOT_FINITE: vbss_result = -3;
/// struct_size is no size that the struct has had or could have
pub const VBSS_ERROR_STRUCT_SIZE: vbss_result = -4;
/// a field unknown to this library version is not zero
pub const VBSS_ERROR_UNKNOWN_FIELD: vbss_result = -5;
/// the handle is NULL, destroyed or of another type
pub const VBSS_ERROR_INVALID_HANDLE: vbss_result = -6;
/// the allocator gave no usable block
pub const VBSS_ERROR_OUT_OF_MEMORY: vbss_result = -7;
/// a capacity fixed at creation or a given buffer is exhausted
pub const VBSS_ERROR_CAPACITY: vbss_result = -8;
/// another thread, or the caller of this callback, uses the context
pub const VBSS_ERROR_BUSY: vbss_result = -9;
/// rounding is not to nearest or subnormal numbers are flushed to zero
pub const VBSS_ERROR_ARITHMETIC_MODE: vbss_result = -10;
/// the data end too early
pub const VBSS_ERROR_TRUNCATED: vbss_result = -11;
/// the data are damaged or not what this call reads
pub const VBSS_ERROR_CORRUPT: vbss_result = -12;
/// the data were written by a newer version of the library
pub const VBSS_ERROR_DATA_VERSION: vbss_result = -13;
/// not allowed while the object belongs to a scene
pub const VBSS_ERROR_IN_SCENE: vbss_result = -14;
/// a device failed, or is not there
pub const VBSS_ERROR_DEVICE: vbss_result = -15;
/// the host's clock does not advance
pub const VBSS_ERROR_CLOCK_STOPPED: vbss_result = -16;
/// the host's clock runs backwards or jumps
pub const VBSS_ERROR_CLOCK_JUMPED: vbss_result = -17;
/// the host's clock is too coarse
pub const VBSS_ERROR_CLOCK_COARSE: vbss_result = -18;
/// the object, entry or step that an argument names does not exist
pub const VBSS_ERROR_NOT_FOUND: vbss_result = -19;
/// the object is not in a state that allows the call
pub const VBSS_ERROR_WRONG_STATE: vbss_result = -20;
/// an object or a setting does not fit the others of the call
pub const VBSS_ERROR_INCOMPATIBLE: vbss_result = -21;
/// something else already uses what an argument names
pub const VBSS_ERROR_IN_USE: vbss_result = -22;

// The constants of vbss_log_level.
/// As a limit: no messages at all.
pub const VBSS_LOG_NONE: vbss_log_level = 0;
/// A call failed; the message is its error text.
pub const VBSS_LOG_ERROR: vbss_log_level = 1;
/// A setting is probably not the intended one.
pub const VBSS_LOG_WARNING: vbss_log_level = 2;
/// Rare milestones, such as the creation of a context.
pub const VBSS_LOG_INFO: vbss_log_level = 3;

// The constants of vbss_method.
/// The library's own method, the default.
pub const VBSS_METHOD_IMPLICIT: vbss_method = 0;
/// The method of VBLaST-SS (Qi et al. 2017), as a baseline.
pub const VBSS_METHOD_VBLAST: vbss_method = 1;

// The constants of vbss_view_type.
/// double
pub const VBSS_VIEW_TYPE_F64: vbss_view_type = 1;
/// uint32_t
pub const VBSS_VIEW_TYPE_U32: vbss_view_type = 2;
/// float, of 32 bits; only in meshes for drawing
pub const VBSS_VIEW_TYPE_F32: vbss_view_type = 3;

/// Allocates memory for a context. The function must return (no longjmp, no exception). Its calls
/// that would change the same context return VBSS_ERROR_BUSY.
///
/// @param user       the context's allocator_user; may be NULL
/// @param size       bytes wanted, > 0
/// @param alignment  alignment in bytes, a power of two
/// @return the block, or NULL when there is no memory; its contents are arbitrary; the library
/// releases a block that is not aligned and treats it as NULL
pub type vbss_allocate_fn = Option<unsafe extern "C" fn(user: *mut c_void, size: u64, alignment: u64) -> *mut c_void>;

/// Releases a block of a vbss_allocate_fn. The function must return (no longjmp, no exception). Its
/// calls that would change the same context return VBSS_ERROR_BUSY.
///
/// @param user       the context's allocator_user; may be NULL
/// @param block      the block, never NULL
/// @param size       its size at allocation, bytes
/// @param alignment  its alignment at allocation, bytes
pub type vbss_deallocate_fn = Option<unsafe extern "C" fn(user: *mut c_void, block: *mut c_void, size: u64, alignment: u64)>;

/// Receives log messages, on the thread that called the library. The function must return (no
/// longjmp, no exception). Its calls that would change the same context return VBSS_ERROR_BUSY.
///
/// @param user     the context's log_user; may be NULL
/// @param level    importance
/// @param message  UTF-8 text without a newline, valid during the call only
pub type vbss_log_fn = Option<unsafe extern "C" fn(user: *mut c_void, level: vbss_log_level, message: *const c_char)>;

/// A read-only array inside the library. Item i starts `i * stride_bytes` after data and has
/// `components` contiguous values of the type. It is valid until the next step, edit or destruction
/// of its object; a step or an edit changes the generation.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_view {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Type of each value.
    pub r#type: vbss_view_type,
    /// Number of values in an item, such as 3 for a vector.
    pub components: u32,
    /// Distance from one item to the next, bytes.
    pub stride_bytes: u32,
    /// Number of items.
    pub count: u64,
    /// The first item; never NULL.
    pub data: *const c_void,
    /// Number that changes with every step or edit of the object.
    pub generation: u64,
}

/// Owner of all objects, their memory and their error texts. One thread at a time may use it; the
/// library detects a second one (VBSS_ERROR_BUSY).
#[repr(C)]
pub struct vbss_context {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of a context. Fill it with vbss_context_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_context_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Least important level that is sent; default VBSS_LOG_WARNING.
    pub log_level: vbss_log_level,
    /// Allocator; NULL (default): the C library; set both functions or neither.
    pub allocate: vbss_allocate_fn,
    /// Counterpart of allocate; NULL (default): the C library; set both functions or neither.
    pub deallocate: vbss_deallocate_fn,
    /// Pointer that allocate and release receive; may be NULL.
    pub allocator_user: *mut c_void,
    /// Function for log messages; NULL (default): messages are dropped.
    pub log: vbss_log_fn,
    /// Pointer that log receives; may be NULL.
    pub log_user: *mut c_void,
}

/// Memory and objects of a context.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_context_statistics {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Memory currently allocated, bytes.
    pub bytes_allocated: u64,
    /// Largest value of bytes_allocated so far, bytes.
    pub bytes_peak: u64,
    /// Successful calls of the allocator so far.
    pub allocation_count: u64,
    /// Objects created and not yet destroyed.
    pub objects_alive: u64,
    /// Objects created so far; the last creation ordinal.
    pub objects_created: u64,
}

extern "C" {
    /// Returns the version of the running library, in the form of VBSS_VERSION_NUM.
    ///
    /// @return 10000 major + 100 minor + patch
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_version() -> u32;
    /// Returns build information: version with its suffix, source revision, compiler, and the flags that matter for
    /// reproducible results.
    ///
    /// @return a constant text, never NULL
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_build_info() -> *const c_char;
    /// Returns the name of a status, such as "VBSS_ERROR_CAPACITY".
    ///
    /// @param result  any number
    /// @return a constant text, never NULL; "unknown result" for any other number
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_result_name(result: vbss_result) -> *const c_char;
    /// Returns a description of a status.
    ///
    /// @param result  any number
    /// @return a constant text, never NULL; "unknown result" for any other number
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_result_string(result: vbss_result) -> *const c_char;
    /// Checks whether the calling thread rounds to nearest and keeps subnormal numbers. Hosts linked
    /// with fast-math flags often flush them to zero. The library computes in its own mode, so the
    /// answer concerns the arithmetic of the host only, such as the computation of poses.
    ///
    /// @return VBSS_OK or VBSS_ERROR_ARITHMETIC_MODE
    /// @threads any thread, any time; the answer is for the calling thread
    /// @since 1.0
    pub fn vbss_arithmetic_check() -> vbss_result;
    /// Fills a context configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_context_config_init(config: *mut vbss_context_config, struct_size: u32) -> vbss_result;
    /// Creates a context.
    ///
    /// @param config        configuration; NULL for the defaults
    /// @param context  the new context; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
    /// VBSS_ERROR_OUT_OF_RANGE (log_level, or only one of allocate and release) or
    /// VBSS_ERROR_OUT_OF_MEMORY
    /// @threads any thread; contexts are independent of each other
    /// @since 1.0
    pub fn vbss_context_create(config: *const vbss_context_config, context: *mut *mut vbss_context) -> vbss_result;
    /// Destroys a context and every object in it, youngest first. Afterwards neither the context nor any
    /// of its handles may be used.
    ///
    /// @param context  the context; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY (called from a callback of its own, or
    /// while another thread is inside)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_context_destroy(context: *mut vbss_context) -> vbss_result;
    /// Returns the last failure in this context. A successful call does not clear it. The following
    /// failures are reported by their status alone: a call inside a callback of the context, a call from
    /// a second thread, and a size query (a call of a save function without a buffer).
    ///
    /// @param context      the context
    /// @param result  its status, VBSS_OK when nothing has failed yet; may be NULL
    /// @param text    its text, which names the argument and the value that was refused; empty when
    /// nothing has failed yet; valid until the next failure in this context; may be
    /// NULL
    /// @return VBSS_OK or VBSS_ERROR_INVALID_HANDLE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_context_get_last_error(context: *const vbss_context, result: *mut vbss_result, text: *mut *const c_char) -> vbss_result;
    /// Returns the memory and objects of a context.
    ///
    /// @param context          the context
    /// @param statistics  receives the statistics
    /// @param struct_size      `sizeof *statistics` as the caller was compiled; fields that the library
    /// does not know become zero
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_context_get_statistics(context: *mut vbss_context, statistics: *mut vbss_context_statistics, struct_size: u32) -> vbss_result;
}
