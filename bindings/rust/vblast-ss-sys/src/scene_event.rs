// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// Kind of an event: a VBSS_SCENE_EVENT_ constant.
pub type vbss_scene_event_kind = i32;

// The constants of vbss_scene_event_kind.
/// Two bodies have come into contact, or a body with itself.
pub const VBSS_SCENE_EVENT_TOUCH: vbss_scene_event_kind = 1;
/// Two bodies in contact have separated.
pub const VBSS_SCENE_EVENT_PART: vbss_scene_event_kind = 2;
/// A part of a step was truncated: the bodies moved as far as the guard allows, and the rest of
/// the part was left out (vbss_scene_statistics::clamped). The two bodies are those that the guard
/// found; 0: unknown, or the floor.
pub const VBSS_SCENE_EVENT_TRUNCATED: vbss_scene_event_kind = 3;
/// Jaws have grasped a thread, a needle or a drain.
pub const VBSS_SCENE_EVENT_GRASP: vbss_scene_event_kind = 5;
/// Jaws have opened and released a body.
pub const VBSS_SCENE_EVENT_RELEASE: vbss_scene_event_kind = 6;
/// A body was pulled out of the jaws. The value is the force of the jaws on it.
pub const VBSS_SCENE_EVENT_TORN: vbss_scene_event_kind = 7;
/// A body begins to slide through the jaws, or to turn in them. The value is the force of the jaws
/// on it.
pub const VBSS_SCENE_EVENT_SLIP: vbss_scene_event_kind = 8;
/// A grasp exceeded grasp_capacity, so the thread is not held.
pub const VBSS_SCENE_EVENT_GRASP_LOST: vbss_scene_event_kind = 9;
/// A thread was cut. The piece is 0 if the thread had no cuts left and stayed whole.
pub const VBSS_SCENE_EVENT_CUT: vbss_scene_event_kind = 10;
/// An instrument was exchanged. The id is its new vbss_grasper_kind; the position is that of the
/// grasper's frame.
pub const VBSS_SCENE_EVENT_EXCHANGED: vbss_scene_event_kind = 11;
/// An instrument was not exchanged. The id is the wanted vbss_grasper_kind.
pub const VBSS_SCENE_EVENT_NOT_EXCHANGED: vbss_scene_event_kind = 12;
/// A needle's tip has entered a wall (VBLAST: has gone through it). The value is the force of the
/// wall along the tip; 0 with method VBLAST, and where a fold of the wall came onto the needle.
pub const VBSS_SCENE_EVENT_PUNCTURE: vbss_scene_event_kind = 13;
/// The tip has left the hole backwards.
pub const VBSS_SCENE_EVENT_WITHDRAWN: vbss_scene_event_kind = 14;
/// The needle and its swage have passed through the hole, and the thread follows.
pub const VBSS_SCENE_EVENT_PASSED: vbss_scene_event_kind = 15;
/// A hole exceeded hole_capacity, so the wall is not pierced.
pub const VBSS_SCENE_EVENT_HOLE_LOST: vbss_scene_event_kind = 16;
/// The swage has come back through the hole, and the needle is in it again.
pub const VBSS_SCENE_EVENT_RETURNED: vbss_scene_event_kind = 17;
/// An end of a thread has left the hole.
pub const VBSS_SCENE_EVENT_UNTHREADED: vbss_scene_event_kind = 18;
/// Two bodies hold each other back: both bodies of vbss_scene_blocker, its cause. Reported once
/// until they have moved freely again.
pub const VBSS_SCENE_EVENT_BLOCKED: vbss_scene_event_kind = 19;
/// Two bodies have moved freely for 0.1 s after BLOCKED.
pub const VBSS_SCENE_EVENT_UNBLOCKED: vbss_scene_event_kind = 20;
/// The rest of a step was left out for the bodies that did not come to its end, or a whole step
/// because too many waited (vbss_scene_statistics::paused). The two bodies are those that hold
/// each other back; 0: unknown, or the floor. Several groups of bodies of a step may each have
/// such an event; vbss_scene_statistics::time_paused counts the longest.
pub const VBSS_SCENE_EVENT_PAUSED: vbss_scene_event_kind = 21;
/// More steps than after the call before are suspended or have not begun: work waits for a later
/// call, and no time is left out (vbss_scene_statistics::behind, and `call_budget_us`).
pub const VBSS_SCENE_EVENT_DEFERRED: vbss_scene_event_kind = 22;
/// No step waits any more after DEFERRED.
pub const VBSS_SCENE_EVENT_CAUGHT_UP: vbss_scene_event_kind = 23;
/// A step that two calls had suspended was completed without the budget of a call, because other bodies
/// waited (vbss_scene_statistics::overdue). This call took longer than it should.
pub const VBSS_SCENE_EVENT_OVERDUE: vbss_scene_event_kind = 24;
/// A thread begins to tear the wall at its hole (vbss_drain_config::tear_energy). Reported again after the
/// force has fallen below half of the one that tears.
pub const VBSS_SCENE_EVENT_TEARING: vbss_scene_event_kind = 25;
/// A thread has torn out: it has cut through the wall up to a free edge and left it there, and the hole
/// is gone.
pub const VBSS_SCENE_EVENT_TORN_OUT: vbss_scene_event_kind = 26;

// Bits of `flags` of an event.
/// The event has a position.
pub const VBSS_SCENE_EVENT_FLAG_POSITION: u32 = 1;

/// An event of a scene. vbss_scene_event_kind says which fields a kind uses. All numbers are finite.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_event {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Kind of the event.
    pub kind: vbss_scene_event_kind,
    /// Number of the first body; 0: the floor, or none.
    pub body_a: u32,
    /// Number of the second body; 0: the floor, or none.
    pub body_b: u32,
    /// Identifier, as the kind says; 0: none.
    pub id: u32,
    /// VBSS_SCENE_EVENT_FLAG_ bits.
    pub flags: u32,
    /// vbss_scene_statistics::steps after the call of vbss_scene_step that reported the event. An event
    /// between two steps has the number of the step before.
    pub step: u64,
    /// vbss_scene_statistics::time after that call, s.
    pub time: f64,
    /// Value, in the unit of the kind; 0: the kind has none.
    pub value: f64,
    /// Arc length along a thread or needle, m; 0: the kind has none.
    pub arc_length: f64,
    /// Position in the world, m; zero without VBSS_SCENE_EVENT_FLAG_POSITION.
    pub position: [f64; 3],
}

extern "C" {
    /// Takes the oldest events out of the scene's list, in the order in which they happened. Events beyond
    /// `capacity` stay in the list. When the call writes fewer events than `capacity`, the list is empty. The
    /// call changes nothing else of the scene, and allocates nothing.
    ///
    /// @param scene        the scene
    /// @param events  receives the events, one every `struct_size` bytes; NULL with capacity 0 asks
    /// for the number of events in the list, and takes none
    /// @param struct_size  `sizeof *events` as the caller was compiled
    /// @param capacity     room in `events`, in events
    /// @param count   receives the number of events taken; with `events` NULL, of those in the list
    /// @param lost    receives the number of events that were lost since the last call that took
    /// events, because the list was full; NULL: not wanted, and the count goes on. A call with
    /// `events` NULL does not reset it.
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT (`count`, or `events` with a
    /// capacity), VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_take_events(scene: *mut vbss_scene, events: *mut vbss_scene_event, struct_size: u32, capacity: u32, count: *mut u32, lost: *mut u64) -> vbss_result;
}
