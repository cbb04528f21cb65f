// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


// Bits of the aids. "Along the direction" means: by the component of the hand's movement along
// vbss_session_assistance.direction.
/// A hand that holds the needle turns it about the centre of its arc and moves it in no other way.
/// Movement along the direction drives the tip forward by the same length of arc. Turns of the hand
/// are ignored. Acts before the first throw.
pub const VBSS_SESSION_AID_ARC: u32 = 1;
/// A hand that holds the needle goes round the jaws of the other tool. Movement along the
/// direction winds in the sense that the next throw needs. The radius stays, between 8 mm and
/// 45 mm. Turns of the hand turn the tool as without the aid. Acts in the phases of throws.
pub const VBSS_SESSION_AID_WIND: u32 = 2;
/// The roll of each tool about its shaft is the nearest multiple of `roll_step` from the roll in
/// which the jaws open along the slit.
pub const VBSS_SESSION_AID_SNAP_ROLL: u32 = 4;
/// Each step of the session is `pace` times as long as the host asks for.
pub const VBSS_SESSION_AID_SLOW_MOTION: u32 = 8;
/// A hand that sinks slower than `sink_speed` leaves its tool at the same height, for arms
/// without support.
pub const VBSS_SESSION_AID_HOVER: u32 = 16;
/// The tool and the jaws of a hand that has moved less than `hold_distance` for `hold_time` stay where
/// they are, until the hand leaves this distance.
pub const VBSS_SESSION_AID_AUTO_HOLD: u32 = 32;
/// All aids.
pub const VBSS_SESSION_AID_ALL: u32 = 63;

/// Assistance of a session. Fill it with vbss_session_assistance_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_session_assistance {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// VBSS_SESSION_AID_ bits of the aids that are on; default 0.
    pub aids: u32,
    /// Simulated time per time of the host, 0.25 to 1; default 0.5.
    pub pace: f64,
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
