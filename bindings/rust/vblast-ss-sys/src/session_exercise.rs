// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_char};
#[allow(unused_imports)]
use crate::*;


/// Outcome of an exercise: a VBSS_SESSION_OUTCOME_ constant.
pub type vbss_session_outcome = i32;

/// Kind of a measure: a VBSS_SESSION_MEASURE_ constant.
pub type vbss_session_measure_kind = i32;

// The constants of vbss_session_outcome.
/// There is no exercise, or it has not ended.
pub const VBSS_SESSION_OUTCOME_NONE: vbss_session_outcome = 0;
/// The goal is reached, and each measure is within its mark.
pub const VBSS_SESSION_OUTCOME_PASSED: vbss_session_outcome = 1;
/// A measure misses its mark, or the goal was not reached.
pub const VBSS_SESSION_OUTCOME_FAILED: vbss_session_outcome = 2;

// The constants of vbss_session_measure_kind. Each comment ends with the exercises and the pass mark.
/// Time of the exercise, s. All; TAKE_NEEDLE and CUT at most 60, PASS_MARK and throws at most 120. At
/// this time the exercise ends.
pub const VBSS_SESSION_MEASURE_TIME: vbss_session_measure_kind = 1;
/// Where the needle is held, as a share of its length from the tip. TAKE_NEEDLE: 0.47 to 0.7; courses
/// ask for half to two thirds.
pub const VBSS_SESSION_MEASURE_GRASP_SHARE: vbss_session_measure_kind = 2;
/// Angle between the jaws that hold the needle and the normal of the needle's plane, rad.
/// TAKE_NEEDLE: at most 30 degrees.
pub const VBSS_SESSION_MEASURE_GRASP_ANGLE: vbss_session_measure_kind = 3;
/// Number of times that the needle was dropped. TAKE_NEEDLE: 0.
pub const VBSS_SESSION_MEASURE_DROPS: vbss_session_measure_kind = 4;
/// Distance of the first hole from its mark on the surface of the drain, m. PASS_MARK: at most 1 mm,
/// the published accuracy of proficient trainees.
pub const VBSS_SESSION_MEASURE_DEVIATION: vbss_session_measure_kind = 5;
/// Angle between the needle's tip and the normal of the wall as the first hole is made, rad.
/// PASS_MARK: at most 30 degrees; courses ask for 0.
pub const VBSS_SESSION_MEASURE_ENTRY_ANGLE: vbss_session_measure_kind = 6;
/// Number of holes beside the stitch. PASS_MARK: 0.
pub const VBSS_SESSION_MEASURE_STRAYS: vbss_session_measure_kind = 7;
/// Wraps of the throw. SINGLE_THROW and SQUARE_THROW: 1; DOUBLE_THROW: 2.
pub const VBSS_SESSION_MEASURE_WRAPS: vbss_session_measure_kind = 8;
/// 1: the throw is square to the one before; 0: it is not, or this is not known. SQUARE_THROW: 1.
pub const VBSS_SESSION_MEASURE_SQUARE: vbss_session_measure_kind = 9;
/// Largest gap along the slit at the outcome, m. Throws: at most 1 mm.
pub const VBSS_SESSION_MEASURE_GAP: vbss_session_measure_kind = 10;
/// Largest tension of the thread during the exercise that lasts for the session's `dwell` of simulated
/// time, N: the largest of the minima of successive intervals of that length. Throws: at most 6.1 N,
/// the published maximum while experts tie on a drain.
pub const VBSS_SESSION_MEASURE_TENSION: vbss_session_measure_kind = 11;
/// Remaining length of the short tail, m. CUT: 2 to 8 mm; courses ask for 3 to 5 mm.
pub const VBSS_SESSION_MEASURE_SHORT_TAIL: vbss_session_measure_kind = 12;
/// Remaining length of the needle's tail, m. CUT: 2 to 8 mm.
pub const VBSS_SESSION_MEASURE_LONG_TAIL: vbss_session_measure_kind = 13;

/// The exercise of a session and its outcome.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_session_exercise_state {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// The exercise; NONE: the session runs the whole task.
    pub exercise: vbss_session_exercise,
    /// The outcome.
    pub outcome: vbss_session_outcome,
    /// Number of measures; 0 without an exercise.
    pub measure_count: u32,
    /// Bit i: measure i is not known yet, or is outside its pass mark.
    pub missed: u32,
    /// VBSS_SESSION_AID_ bits of the aids that were on; 0: the exercise was not assisted.
    pub aids_used: u32,
    /// Name, such as "take_needle": a constant string, "" for NONE.
    pub name: *const c_char,
    /// The goal as an English sentence: a constant string, "" for NONE.
    pub sentence: *const c_char,
    /// Time since the start, until the outcome or now, s.
    pub time: f64,
}

/// A measure of an exercise. It is met if it is known, and `low` <= `value` <= `high`.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_session_measure {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Kind of the measure, which says its unit.
    pub kind: vbss_session_measure_kind,
    /// 1: `value` is known; 0: not yet, and `value` is zero.
    pub is_known: u32,
    /// 1: the value is known and within the pass mark.
    pub is_met: u32,
    /// Short English name: a constant string, never NULL.
    pub name: *const c_char,
    /// The value; its unit is that of the kind.
    pub value: f64,
    /// Smallest value that passes.
    pub low: f64,
    /// Largest value that passes.
    pub high: f64,
}

extern "C" {
    /// Begins the task at the place that another session had reached. The session takes over the facts of the
    /// saved state: holder, stitch, tail, throws, seats, transfers, cuts and phase. Clock, events, metrics, aids,
    /// mistakes and exercise begin as in a new session. The host first restores the scene (vbss_scene_restore) as
    /// it was saved at the same step. The call comes before the first step. A session that shall be logged gets
    /// its record after the call (vbss_session_set_record).
    ///
    /// @param session  a session that has made no step
    /// @param bytes    state of a session (vbss_session_save); its configuration has the same values, except for
    /// `exercise`
    /// @param count    size of `bytes`
    /// @return VBSS_OK, VBSS_ERROR_WRONG_STATE (the session has made a step, or has a record or a replay), or a
    /// result of vbss_session_restore; on failure nothing has changed
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_begin_at(session: *mut vbss_session, bytes: *const u8, count: u64) -> vbss_result;
    /// Returns the exercise of a session and its outcome.
    ///
    /// @param session      the session
    /// @param state   receives the exercise; all zero and "" for a session without one
    /// @param struct_size  `sizeof *state` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_get_exercise(session: *mut vbss_session, state: *mut vbss_session_exercise_state, struct_size: u32) -> vbss_result;
    /// Returns a measure of the exercise, as it is now or as it was at the outcome.
    ///
    /// @param session       the session
    /// @param index         0 to vbss_session_exercise_state.measure_count - 1
    /// @param measure  receives the measure
    /// @param struct_size   `sizeof *measure` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (the exercise has no such measure)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_get_measure(session: *mut vbss_session, index: u32, measure: *mut vbss_session_measure, struct_size: u32) -> vbss_result;
    /// Returns the name of an exercise, for command lines and files.
    ///
    /// @param exercise  the exercise
    /// @return a constant string of lower-case letters and "_", never NULL; "" for NONE and for a number that is
    /// no exercise
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_session_exercise_name(exercise: vbss_session_exercise) -> *const c_char;
    /// Returns the goal of an exercise as an English sentence.
    ///
    /// @param exercise  the exercise
    /// @return a constant string, never NULL; "" for NONE and for a number that is no exercise
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_session_exercise_string(exercise: vbss_session_exercise) -> *const c_char;
}
