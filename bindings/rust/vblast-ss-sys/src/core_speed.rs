// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_void};
#[allow(unused_imports)]
use crate::*;


/// Reads a clock of the host. The function must return (no longjmp, no exception). Its calls that
/// would change the context return VBSS_ERROR_BUSY.
///
/// @param user  the pointer that the host has passed with the function; may be NULL
/// @return time since any fixed moment, s; it never runs backwards
pub type vbss_core_speed_clock_fn = Option<unsafe extern "C" fn(user: *mut c_void) -> f64>;

/// Speed of the processor core on which a measurement ran.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_core_speed {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Number of timed steps of the fixed scene.
    pub steps: u32,
    /// Speed for vbss_solver_options::operations_per_us, operations per us; > 0. A few hundred on a
    /// core of 2.6 GHz. A quarter of the steps were at least as fast. Steps that other programs have
    /// interrupted do not affect it, as long as they are fewer than three quarters.
    pub operations_per_us: f64,
    /// Median time of the steps divided by their lower quartile, at least 1. A value far above 1
    /// means that other programs have often interrupted the measurement.
    pub spread: f64,
    /// Time of all timed steps on the host's clock, s.
    pub duration: f64,
}

extern "C" {
    /// Measures the speed of the core on which the call runs. The call creates a small fixed scene in
    /// the context, makes 64 steps, times 48 of them, and destroys the scene. This takes some 40 ms on a
    /// core of 2.6 GHz, and proportionally longer on a slower one. The host passes a clock, as the library reads
    /// none itself: a monotonic clock, or better one of the thread's CPU time. No existing object changes,
    /// and no later result depends on the call.
    ///
    /// The status names a clock that cannot measure. A few late readings are no fault of a clock, as
    /// other programs may interrupt the host.
    ///
    /// @param context      the context, in whose memory the fixed scene lives during the call
    /// @param clock        the clock
    /// @param user         pointer that the clock receives; may be NULL
    /// @param speed   receives the speed
    /// @param struct_size  `sizeof *speed` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_NOT_FINITE (a reading of the clock), VBSS_ERROR_CLOCK_STOPPED (all readings are
    /// equal), VBSS_ERROR_CLOCK_JUMPED (a reading is before the previous one, or more than 1 s
    /// after it), VBSS_ERROR_CLOCK_COARSE (the clock does not resolve a tenth of a step, some
    /// 0.05 ms),
    /// VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_core_speed_measure(context: *mut vbss_context, clock: vbss_core_speed_clock_fn, user: *mut c_void, speed: *mut vbss_core_speed, struct_size: u32) -> vbss_result;
}
