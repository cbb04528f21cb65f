// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_char};
#[allow(unused_imports)]
use crate::*;


/// Goal of a trainee: a VBSS_SESSION_GOAL_ constant.
pub type vbss_session_goal = i32;

/// Mistake of a trainee: a VBSS_SESSION_MISTAKE_ constant.
pub type vbss_session_mistake = i32;

// The constants of vbss_session_goal. "The hand" is vbss_session_coaching.tool. Each comment
// says which geometry is given, and which numbers become zero when the goal is met.
/// There is no goal: before the first step, or after the end.
pub const VBSS_SESSION_GOAL_NONE: vbss_session_goal = 0;
/// The hand takes the needle. POINT: on the needle; DIRECTION: of the jaws. `distance` of the
/// tool's tip from the point; `angle` between jaws and direction.
pub const VBSS_SESSION_GOAL_TAKE_NEEDLE: vbss_session_goal = 1;
/// The hand brings the needle's tip to mark `number` (0 left, 1 right). POINT: the mark;
/// DIRECTION: into the wall. `distance` of the tip from the mark; `angle` between tip and
/// direction.
pub const VBSS_SESSION_GOAL_REACH_MARK: vbss_session_goal = 2;
/// The hand pushes the tip through the wall at mark `number`. Geometry and numbers as for REACH_MARK,
/// and ARC: the needle's own arc.
pub const VBSS_SESSION_GOAL_PIERCE: vbss_session_goal = 3;
/// The hand turns the needle along its own arc to mark `number`. POINT: the mark; ARC: from the
/// tip to beside the mark. `angle` of the arc; `distance` of the tip from the mark; `offset`: how
/// far the arc misses the mark.
pub const VBSS_SESSION_GOAL_DRIVE: vbss_session_goal = 4;
/// The tip is out: the hand turns the needle on until it can be taken there. ARC; `length` that
/// must still come out.
pub const VBSS_SESSION_GOAL_EXPOSE_TIP: vbss_session_goal = 5;
/// The hand takes the needle beyond the second hole. POINT, DIRECTION, `distance` and `angle` as
/// for TAKE_NEEDLE.
pub const VBSS_SESSION_GOAL_TAKE_TIP: vbss_session_goal = 6;
/// The hand opens its jaws and releases the needle, which the other one holds. POINT: the tool's
/// tip.
pub const VBSS_SESSION_GOAL_RELEASE_NEEDLE: vbss_session_goal = 7;
/// The hand turns the needle out of the drain along its arc. ARC; `length` of needle that is
/// still in front of the second hole.
pub const VBSS_SESSION_GOAL_DRAW_NEEDLE: vbss_session_goal = 8;
/// The hand draws the thread through. POINT: the second hole; DIRECTION: to pull; `length` of tail
/// beyond `tail_high`.
pub const VBSS_SESSION_GOAL_DRAW_THREAD: vbss_session_goal = 9;
/// The tail is too short: the hand draws it back. POINT: on the tail, beside the first hole;
/// DIRECTION: to pull; `length` that is missing; `distance` of the tool's tip from the point.
pub const VBSS_SESSION_GOAL_LENGTHEN_TAIL: vbss_session_goal = 10;
/// The hand winds the needle's limb round the other tool for throw `number` (0, 1, 2). POINT: where
/// the other tool's tip shall be, over the drain at rest; DIRECTION: in which its jaws shall point; ARC: about its jaws,
/// `arc_angle` with the turns that are missing; `turns` that are missing; `distance` of the other
/// tool's tip from the point, which need not become zero.
pub const VBSS_SESSION_GOAL_WIND: vbss_session_goal = 11;
/// The hand, with the turns on its jaws, takes the tail near its end. POINT: on the tail;
/// DIRECTION: along the tail, from its end. `distance` of the tool's tip from the point.
pub const VBSS_SESSION_GOAL_TAKE_TAIL: vbss_session_goal = 12;
/// The hand opens its jaws and releases the thread. POINT: the tool's tip.
pub const VBSS_SESSION_GOAL_RELEASE_TAIL: vbss_session_goal = 13;
/// The hand draws the tail through the turns. POINT: the slit; DIRECTION: to pull; ARC: from the tool's
/// tip over the slit down to its own side, where the arc is no longer given; `turns` that are still on its
/// jaws.
pub const VBSS_SESSION_GOAL_DRAW_TAIL: vbss_session_goal = 14;
/// Both hands pull throw `number` down, the hand in DIRECTION and the other one opposite, each with
/// `pull_force`. If the slit is open under a second or third throw that hangs loose, DIRECTION is to the
/// other hand's side: from there the throw draws the one below tight. POINT: the slit; `force` that the weaker end misses to that; `length`: gap of the
/// slit beyond `seat_gap`.
pub const VBSS_SESSION_GOAL_SEAT: vbss_session_goal = 15;
/// The hand takes the needle from the other one after throw `number`. POINT, DIRECTION, `distance`
/// and `angle` as for TAKE_NEEDLE.
pub const VBSS_SESSION_GOAL_HAND_OVER: vbss_session_goal = 16;
/// The hand exchanges its tool for shears.
pub const VBSS_SESSION_GOAL_TAKE_SHEARS: vbss_session_goal = 17;
/// The hand cuts tail `number` (0: the short one, 1: the needle's). POINT: where to cut; DIRECTION:
/// along the tail, from the knot. `distance` of the shears' tip from the point.
pub const VBSS_SESSION_GOAL_CUT: vbss_session_goal = 18;

// The constants of vbss_session_mistake. "Ends" gives the condition under which a mistake ends.
/// There is no mistake.
pub const VBSS_SESSION_MISTAKE_NONE: vbss_session_mistake = 0;
/// No hand holds the needle, and it is in no wall. Ends: a hand holds it.
pub const VBSS_SESSION_MISTAKE_NEEDLE_DROPPED: vbss_session_mistake = 1;
/// The first hole is more than 1 mm from its mark. Ends: the needle leaves the hole.
pub const VBSS_SESSION_MISTAKE_ENTRY_MISSED: vbss_session_mistake = 2;
/// The second hole is more than 1 mm from its mark. Ends: the needle leaves the hole.
pub const VBSS_SESSION_MISTAKE_EXIT_MISSED: vbss_session_mistake = 3;
/// A wall is pierced beside the stitch. Ends: that hole is empty.
pub const VBSS_SESSION_MISTAKE_STRAY_HOLE: vbss_session_mistake = 4;
/// The needle was drawn back out of the first hole. Ends: it is pierced again.
pub const VBSS_SESSION_MISTAKE_NEEDLE_WITHDRAWN: vbss_session_mistake = 5;
/// The thread was pulled out of the stitch. Ends: the needle is in a wall again.
pub const VBSS_SESSION_MISTAKE_THREAD_PULLED_OUT: vbss_session_mistake = 6;
/// The tail is shorter than `tail_low`. Ends: it is longer, or a throw is begun.
pub const VBSS_SESSION_MISTAKE_TAIL_SHORT: vbss_session_mistake = 7;
/// The first throw was begun with a tail longer than `tail_high`. Ends: the turns are off.
pub const VBSS_SESSION_MISTAKE_TAIL_LONG: vbss_session_mistake = 8;
/// The turns progress towards the handle and tie nothing. Ends: they no longer do.
pub const VBSS_SESSION_MISTAKE_TOWARD_HANDLE: vbss_session_mistake = 9;
/// The limb is wound in the sense of the throw before: a granny. Ends: it is unwound.
pub const VBSS_SESSION_MISTAKE_WRONG_SENSE: vbss_session_mistake = 10;
/// Turns came off the jaws before the tail was taken, but for those that had to be unwound. Ends: they are wound
/// again.
pub const VBSS_SESSION_MISTAKE_TURNS_LOST: vbss_session_mistake = 11;
/// The tail was taken with too few turns on the jaws. Ends: it is released, or tied all the
/// same.
pub const VBSS_SESSION_MISTAKE_TOO_FEW_TURNS: vbss_session_mistake = 12;
/// The tail is held too far from its end, and a bight of it would be drawn through. Ends: it is
/// released, or held near its end.
pub const VBSS_SESSION_MISTAKE_BIGHT: vbss_session_mistake = 13;
/// The tail was dropped before the throw was tied. Ends: it is held again, or the turns are
/// off.
pub const VBSS_SESSION_MISTAKE_TAIL_DROPPED: vbss_session_mistake = 14;
/// A tied throw came undone. Ends: as many throws are tied again.
pub const VBSS_SESSION_MISTAKE_THROW_UNDONE: vbss_session_mistake = 15;
/// A throw is tied in the sense of the one before. Ends: it comes undone.
pub const VBSS_SESSION_MISTAKE_GRANNY: vbss_session_mistake = 16;
/// The first throw is tied with one wrap. Ends: it comes undone.
pub const VBSS_SESSION_MISTAKE_TOO_FEW_WRAPS: vbss_session_mistake = 17;
/// A throw is tied with more wraps than it needs. Ends: it comes undone.
pub const VBSS_SESSION_MISTAKE_TOO_MANY_WRAPS: vbss_session_mistake = 18;
/// There is a knot in one limb alone. Ends: it is open.
pub const VBSS_SESSION_MISTAKE_STRAY_KNOT: vbss_session_mistake = 19;
/// The first throw, while it is alone, has capsized into a half hitch, which slides. Ends: it is flat
/// again.
pub const VBSS_SESSION_MISTAKE_CAPSIZED: vbss_session_mistake = 20;
/// One end of an unseated throw is pulled and the other is not, or gives way, so that the tail of the first throw
/// becomes 15 mm longer than `tail_high`. Ends: both or neither are, or the throw is seated.
pub const VBSS_SESSION_MISTAKE_ONE_SIDED: vbss_session_mistake = 21;
/// A throw has been tied for 5 s, and both of its ends are slack. Ends: both ends are tense, or the
/// throw is seated.
pub const VBSS_SESSION_MISTAKE_SLACK: vbss_session_mistake = 22;
/// The slit has opened under a seated throw. Ends: the throw is seated, or the next one is tied on it.
pub const VBSS_SESSION_MISTAKE_SLIT_OPENED: vbss_session_mistake = 23;
/// The walls of the slit have slipped past each other. Ends: they meet again.
pub const VBSS_SESSION_MISTAKE_WALLS_CROSSED: vbss_session_mistake = 24;
/// An anchor of the drain bears more than 0.8 of its strength. Ends: it bears less.
pub const VBSS_SESSION_MISTAKE_DRAIN_TEARING: vbss_session_mistake = 25;
/// The tension of the thread exceeds 6 N. Ends: it falls below.
pub const VBSS_SESSION_MISTAKE_PULLED_HARD: vbss_session_mistake = 26;
/// A throw is tied, and the needle has not changed hands before. Ends: it comes undone.
pub const VBSS_SESSION_MISTAKE_TRANSFER_MISSED: vbss_session_mistake = 27;
/// The time limit has passed. Does not end.
pub const VBSS_SESSION_MISTAKE_TIME_UP: vbss_session_mistake = 28;
/// The drain is torn off. Does not end.
pub const VBSS_SESSION_MISTAKE_DRAIN_TORN: vbss_session_mistake = 29;
/// Cut before the third throw. Does not end.
pub const VBSS_SESSION_MISTAKE_CUT_EARLY: vbss_session_mistake = 30;
/// Cut in the knot or stitch. Does not end.
pub const VBSS_SESSION_MISTAKE_CUT_KNOT: vbss_session_mistake = 31;
/// The thread has broken. Does not end.
pub const VBSS_SESSION_MISTAKE_THREAD_BROKEN: vbss_session_mistake = 32;
/// One more than the largest mistake.
pub const VBSS_SESSION_MISTAKE_COUNT: vbss_session_mistake = 33;

// Bits for the geometry that a goal has.
/// `point` is given.
pub const VBSS_SESSION_GEOMETRY_POINT: u32 = 1;
/// `direction` is given.
pub const VBSS_SESSION_GEOMETRY_DIRECTION: u32 = 2;
/// The fields `arc_` are given.
pub const VBSS_SESSION_GEOMETRY_ARC: u32 = 4;
/// `pull_force` is given; the pull is along `direction`.
pub const VBSS_SESSION_GEOMETRY_PULL: u32 = 8;

/// Goal and mistakes of a session that coaches. A number that the goal does not use is zero.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_session_coaching {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// The next goal.
    pub goal: vbss_session_goal,
    /// The hand that acts; NONE: no goal, or the session's third tool.
    pub tool: vbss_metrics_tool,
    /// Mark, throw or tail of the goal, as its comment says; otherwise 0.
    pub number: u32,
    /// The goal as an English sentence: a constant string, never NULL.
    pub sentence: *const c_char,
    /// The newest mistake that has not ended. One that cannot be mended is given for 5 s, those of a
    /// failure for good.
    pub mistake: vbss_session_mistake,
    /// 1: the mistake can still be mended.
    pub is_mendable: u32,
    /// The mistake as a sentence: constant, "" without one.
    pub mistake_sentence: *const c_char,
    /// How to mend the mistake, or how to go on: a constant string, "" without one.
    pub remedy: *const c_char,
    /// Bit m: mistake m has not ended.
    pub mistakes: u64,
    /// VBSS_SESSION_GEOMETRY_ bits of the fields below.
    pub geometry: u32,
    /// Zero.
    pub reserved: u32,
    /// Where to go or to pull from, m.
    pub point: [f64; 3],
    /// Unit vector.
    pub direction: [f64; 3],
    /// Centre of the arc or circle to follow, m.
    pub arc_centre: [f64; 3],
    /// Unit axis; the arc goes about it by the right-hand rule.
    pub arc_axis: [f64; 3],
    /// Where the arc starts, m.
    pub arc_start: [f64; 3],
    /// Radius of the arc, m.
    pub arc_radius: f64,
    /// Angle that is left, rad, 0 or more; several turns for a winding.
    pub arc_angle: f64,
    /// Force to pull with at each end, N.
    pub pull_force: f64,
    /// Distance to go, m.
    pub distance: f64,
    /// Angle to turn by, rad.
    pub angle: f64,
    /// DRIVE: distance by which the arc misses the mark, m.
    pub offset: f64,
    /// Turns that are missing, or that must come off.
    pub turns: f64,
    /// Force that is missing, N.
    pub force: f64,
    /// Length or gap that is missing, m.
    pub length: f64,
    /// Time since the goal began, s.
    pub goal_time: f64,
    /// Session time at which `mistake` was seen, s.
    pub mistake_time: f64,
}

extern "C" {
    /// Returns the coach's goal with its geometry, and the newest mistake, for the state after the last
    /// step. The call computes the geometry from the scene. It changes nothing and allocates nothing.
    ///
    /// @param session        the session; its configuration has `coaching` 1
    /// @param coaching  receives goal, sentences, geometry and numbers
    /// @param struct_size    `sizeof *coaching` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_WRONG_STATE (the session does not coach)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_get_coaching(session: *mut vbss_session, coaching: *mut vbss_session_coaching, struct_size: u32) -> vbss_result;
    /// Returns a mistake as an English sentence, for example to list the events of a session.
    ///
    /// @param mistake  the mistake
    /// @return a constant string, never NULL; "" for NONE and for a number that is no mistake
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_session_mistake_string(mistake: vbss_session_mistake) -> *const c_char;
    /// Returns how to mend a mistake, or how to go on after it, as an English sentence.
    ///
    /// @param mistake  the mistake
    /// @return a constant string, never NULL; "" for NONE and for a number that is no mistake
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_session_remedy_string(mistake: vbss_session_mistake) -> *const c_char;
}
