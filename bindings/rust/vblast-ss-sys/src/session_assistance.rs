// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// Assistance of a session. Fill it with vbss_session_assistance_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_session_assistance {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// VBSS_SESSION_AID_ bits of the aids that are on; default 0.
    pub aids: u32,
    /// Simulated time per time of the host, 0.25 to 1; default 0.5.
    pub time_scale: f64,
    /// Direction of ARC and WIND, of any length from 1e-9 to 1e3. Default 0, 0, 0: from the first mark of
    /// the stitch to the second one.
    pub direction: [f64; 3],
    /// Step of the roll, rad, 0.01 to 3.2; default pi / 4.
    pub roll_step: f64,
    /// Speed below which a hand sinks unintentionally, m/s, 0 to 1; default 4e-3.
    pub sink_speed: f64,
    /// Distance within which a hand rests, m, 0 to 1; default 2e-3.
    pub hold_distance: f64,
    /// Time after which a hand that rests is idle, s, 0 to 10; default 0.7.
    pub hold_time: f64,
}

/// Input of a hand. Fill it with vbss_session_hand_init, then set its fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_session_hand {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// 1: the hand is now at this pose and its tool does not move: later movements start here. `opening`
    /// is ignored. Default 0.
    pub is_origin: u32,
    /// Position of the tool's tip, m, each coordinate at most 1e3 in magnitude.
    pub position: [f64; 3],
    /// Orientation of the tool, w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0.
    pub orientation: [f64; 4],
    /// Opening of the handle, 0 (closed) to 1 (open); default 0.
    pub opening: f64,
}

extern "C" {
    /// Fills a struct with the default assistance: all aids are off.
    ///
    /// @param assistance  the struct to fill
    /// @param struct_size      `sizeof *assistance` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_session_assistance_init(assistance: *mut vbss_session_assistance, struct_size: u32) -> vbss_result;
    /// Fills the input of a hand with the defaults.
    ///
    /// @param hand    the struct to fill
    /// @param struct_size  `sizeof *hand` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_session_hand_init(hand: *mut vbss_session_hand, struct_size: u32) -> vbss_result;
    /// Switches aids on and off, from the next step on.
    ///
    /// @param session     the session; it follows no replay
    /// @param assistance  the aids and their settings; NULL switches all aids off and keeps the settings
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_WRONG_STATE (the session follows
    /// a replay) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_set_assistance(session: *mut vbss_session, assistance: *const vbss_session_assistance) -> vbss_result;
    /// Returns the assistance that was set. In a replay, the aids are those of the log, and the settings
    /// are the defaults.
    ///
    /// @param session          the session
    /// @param assistance  receives the aids and their settings
    /// @param struct_size      `sizeof *assistance` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_get_assistance(session: *mut vbss_session, assistance: *mut vbss_session_assistance, struct_size: u32) -> vbss_result;
    /// Passes the input of a hand for the next step, which moves its tool there as the aids permit. Without
    /// a call before a step the tool keeps its target. A device of the hand takes precedence. The call
    /// allocates nothing.
    ///
    /// @param session  the session; it follows no replay
    /// @param tool     VBSS_METRICS_TOOL_LEFT or VBSS_METRICS_TOOL_RIGHT
    /// @param hand     the input of the hand
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_WRONG_STATE (the session follows a replay) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_move_hand(session: *mut vbss_session, tool: vbss_metrics_tool, hand: *const vbss_session_hand) -> vbss_result;
}
