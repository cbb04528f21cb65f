// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_void};
#[allow(unused_imports)]
use crate::*;


/// Phase of the task: a VBSS_SESSION_PHASE_ constant. The metrics' phases have the same numbers.
pub type vbss_session_phase = i32;

/// Stage of a throw: a VBSS_SESSION_STAGE_ constant.
pub type vbss_session_stage = i32;

/// Reason why the task has failed: a VBSS_SESSION_FAILURE_ constant.
pub type vbss_session_failure = i32;

/// Kind of an event: a VBSS_SESSION_EVENT_ constant.
pub type vbss_session_event_kind = i32;

/// Exercise of a session: a VBSS_SESSION_EXERCISE_ constant.
pub type vbss_session_exercise = i32;

/// Measure of the slit's gap: a VBSS_SESSION_GAP_ constant.
pub type vbss_session_gap = i32;

// The constants of vbss_session_phase, in the order of the task.
/// No step was made; the needle has not appeared.
pub const VBSS_SESSION_PHASE_IDLE: vbss_session_phase = 0;
/// A tool must take the needle.
pub const VBSS_SESSION_PHASE_LOADING: vbss_session_phase = 1;
/// A tool holds the needle and approaches the first mark.
pub const VBSS_SESSION_PHASE_APPROACH: vbss_session_phase = 2;
/// The needle's tip is in the drain, on its way to the second mark.
pub const VBSS_SESSION_PHASE_IN_DRAIN: vbss_session_phase = 3;
/// The tip is out again; the thread is drawn until the tail has its length.
pub const VBSS_SESSION_PHASE_PULL_THROUGH: vbss_session_phase = 4;
/// The first throw must be tied and seated.
pub const VBSS_SESSION_PHASE_THROW_1: vbss_session_phase = 5;
/// The needle must change hands after the first throw.
pub const VBSS_SESSION_PHASE_TRANSFER_1: vbss_session_phase = 6;
/// The second throw must be tied and seated.
pub const VBSS_SESSION_PHASE_THROW_2: vbss_session_phase = 7;
/// The needle must change hands after the second throw.
pub const VBSS_SESSION_PHASE_TRANSFER_2: vbss_session_phase = 8;
/// The third throw must be tied and seated.
pub const VBSS_SESSION_PHASE_THROW_3: vbss_session_phase = 9;
/// Both tails must be cut.
pub const VBSS_SESSION_PHASE_CUT: vbss_session_phase = 10;
/// Both tails are cut; final.
pub const VBSS_SESSION_PHASE_DONE: vbss_session_phase = 11;
/// The task has failed; final. See vbss_session_failure.
pub const VBSS_SESSION_PHASE_FAILED: vbss_session_phase = 12;

// The constants of vbss_session_stage.
/// The throw has not begun.
pub const VBSS_SESSION_STAGE_NONE: vbss_session_stage = 0;
/// The thread winds round a tool.
pub const VBSS_SESSION_STAGE_WRAP: vbss_session_stage = 1;
/// The thread winds round a tool that holds the tail near its end.
pub const VBSS_SESSION_STAGE_GRASPED: vbss_session_stage = 2;
/// The throw is tied if the tools withdraw.
pub const VBSS_SESSION_STAGE_PASSED: vbss_session_stage = 3;
/// The throw is tied and must be pulled down.
pub const VBSS_SESSION_STAGE_SEATING: vbss_session_stage = 4;
/// The throw lies on the tissue.
pub const VBSS_SESSION_STAGE_SEATED: vbss_session_stage = 5;

// The constants of vbss_session_failure.
/// The task has not failed.
pub const VBSS_SESSION_FAILURE_NONE: vbss_session_failure = 0;
/// The time limit has passed.
pub const VBSS_SESSION_FAILURE_TIMEOUT: vbss_session_failure = 1;
/// The drain was torn off its anchors.
pub const VBSS_SESSION_FAILURE_AVULSED: vbss_session_failure = 2;
/// The thread was cut before the third throw was seated.
pub const VBSS_SESSION_FAILURE_CUT_EARLY: vbss_session_failure = 3;
/// The thread was cut inside the knot, or between the two holes.
pub const VBSS_SESSION_FAILURE_CUT_KNOT: vbss_session_failure = 4;
/// The thread broke: its tension exceeded `break_force`.
pub const VBSS_SESSION_FAILURE_BROKEN: vbss_session_failure = 5;
/// Thread, needle, drain or a tool was removed from the scene.
pub const VBSS_SESSION_FAILURE_LOST: vbss_session_failure = 6;

// The constants of vbss_session_event_kind. A comment that says "Undone" describes the event with
// `undone` 1, which reports that the fact has ceased.
/// The needle has appeared, and the clock starts.
pub const VBSS_SESSION_EVENT_APPEARED: vbss_session_event_kind = 1;
/// The phase `number` begins. Undone: the task has fallen back to this phase.
pub const VBSS_SESSION_EVENT_PHASE: vbss_session_event_kind = 2;
/// `tool` holds the needle. Undone: it has released the needle.
pub const VBSS_SESSION_EVENT_TAKEN: vbss_session_event_kind = 3;
/// Before the stitch: no tool holds the needle, and it is in no wall.
pub const VBSS_SESSION_EVENT_DROPPED: vbss_session_event_kind = 4;
/// Mark `number` (0: in, 1: out) was pierced, `amount` mm off; `position` is that of the hole.
/// Undone: the needle has left the hole, or the thread's end has slipped through it.
pub const VBSS_SESSION_EVENT_PUNCTURE: vbss_session_event_kind = 5;
/// A wall was pierced elsewhere, as hole `number`. Undone: the hole is empty again.
pub const VBSS_SESSION_EVENT_STRAY: vbss_session_event_kind = 6;
/// The swage has passed through hole `number` (0, 1), and the thread follows. Undone: it has
/// come back.
pub const VBSS_SESSION_EVENT_THREADED: vbss_session_event_kind = 7;
/// The tail has a permitted length, `amount` m. Undone: it no longer has.
pub const VBSS_SESSION_EVENT_TAIL: vbss_session_event_kind = 8;
/// Throw `number` (0, 1, ...) has reached `stage`, forwards or backwards.
pub const VBSS_SESSION_EVENT_STAGE: vbss_session_event_kind = 9;
/// Throw `number` is tied, with `wraps`, `handedness` and `relation`; a repeated event corrects
/// them. Undone: the throw came undone.
pub const VBSS_SESSION_EVENT_THROW: vbss_session_event_kind = 10;
/// Throw `number` is seated; the slit gapes `amount` m. Undone: it is no longer seated.
pub const VBSS_SESSION_EVENT_SEATED: vbss_session_event_kind = 11;
/// `tool` has taken over the needle after throw `number`.
pub const VBSS_SESSION_EVENT_TRANSFER: vbss_session_event_kind = 12;
/// Throw `number` is tied, but the needle has not changed hands since the throw before. Undone:
/// the throw came undone.
pub const VBSS_SESSION_EVENT_TRANSFER_MISSED: vbss_session_event_kind = 13;
/// The knot has had the fault `number`, a VBSS_KNOT_FAULT_ bit, for `throw_dwell`. HITCH (a
/// throw has capsized) takes 20 times `throw_dwell`, because its measure oscillates while a
/// throw is drawn tight. Undone: the fault has been absent for the same time.
pub const VBSS_SESSION_EVENT_FAULT: vbss_session_event_kind = 14;
/// Tail `number` (0: the short one, 1: the needle's) was cut; its remaining length is `amount`
/// m.
pub const VBSS_SESSION_EVENT_CUT: vbss_session_event_kind = 15;
/// The task is complete.
pub const VBSS_SESSION_EVENT_DONE: vbss_session_event_kind = 16;
/// The task has failed; `number` is a vbss_session_failure.
pub const VBSS_SESSION_EVENT_FAILED: vbss_session_event_kind = 17;
/// More than `lost_share` of the time since the needle's appearance is lost: `amount` s. Times
/// and score do not compare with those of other trials. Undone: the share has fallen below half
/// of `lost_share`.
pub const VBSS_SESSION_EVENT_TIME_LOST: vbss_session_event_kind = 18;
/// Only with `coaching`: the goal of the hand `tool` is now `number`, a VBSS_SESSION_GOAL_
/// constant (session_coaching.h).
pub const VBSS_SESSION_EVENT_GOAL: vbss_session_event_kind = 19;
/// Only with `coaching`: the mistake `number`, a VBSS_SESSION_MISTAKE_ constant, is made. Undone:
/// it is mended or past.
pub const VBSS_SESSION_EVENT_MISTAKE: vbss_session_event_kind = 20;
/// The aid `number`, a VBSS_SESSION_AID_ bit, was switched on: the task is
/// assisted and gets no score. `amount` is 1 for the first time, then 0. Undone: the aid was switched
/// off.
pub const VBSS_SESSION_EVENT_AID: vbss_session_event_kind = 21;
/// Only with `exercise`: the exercise `number` has ended; `amount` is 1 if it is passed, and 0 if it is
/// not (session_exercise.h).
pub const VBSS_SESSION_EVENT_EXERCISE: vbss_session_event_kind = 22;

// The constants of vbss_session_exercise. session_exercise.h has their starts, goals and measures.
/// No exercise: the whole task.
pub const VBSS_SESSION_EXERCISE_NONE: vbss_session_exercise = 0;
/// The needle is taken up.
pub const VBSS_SESSION_EXERCISE_TAKE_NEEDLE: vbss_session_exercise = 1;
/// The needle is pushed through the wall at a mark.
pub const VBSS_SESSION_EXERCISE_PASS_MARK: vbss_session_exercise = 2;
/// A throw of one wrap is tied and seated.
pub const VBSS_SESSION_EXERCISE_SINGLE_THROW: vbss_session_exercise = 3;
/// A throw of two wraps is tied and seated.
pub const VBSS_SESSION_EXERCISE_DOUBLE_THROW: vbss_session_exercise = 4;
/// A throw that is square to the first one is tied and seated.
pub const VBSS_SESSION_EXERCISE_SQUARE_THROW: vbss_session_exercise = 5;
/// Both tails are cut.
pub const VBSS_SESSION_EXERCISE_CUT: vbss_session_exercise = 6;
/// One more than the largest exercise.
pub const VBSS_SESSION_EXERCISE_COUNT: vbss_session_exercise = 7;

// Bits of the aids (session_assistance.h). "Along the direction" means: by the component of the hand's movement along
// vbss_session_assistance.direction.
/// A hand that holds the needle turns it about the centre of its arc and moves it in no other way.
/// Movement along the direction drives the tip forward by the same length of arc. Turns of the hand
/// are ignored. Acts before the first throw.
pub const VBSS_SESSION_AID_ARC: u32 = 1;
/// A hand that holds the needle takes the needle's end with the thread round the jaws of the other
/// tool. Movement along the direction winds in the sense that the next throw needs. The radius,
/// between 8 mm and 45 mm, is 0.92 of the one at which the thread is taut, or stays if there is no
/// stitch. With a coach it allows for the turns on the jaws. Turns of the hand turn the tool
/// as without the aid. Acts in the phases of throws.
pub const VBSS_SESSION_AID_WIND: u32 = 2;
/// The roll of each tool about its shaft is the nearest multiple of `roll_step` from the roll in
/// which the jaws open along the slit.
pub const VBSS_SESSION_AID_SNAP_ROLL: u32 = 4;
/// Each step of the session is `time_scale` times as long as the host asks for.
pub const VBSS_SESSION_AID_SLOW_MOTION: u32 = 8;
/// A hand that sinks slower than `sink_speed` leaves its tool at the same height, for arms
/// without support.
pub const VBSS_SESSION_AID_HOVER: u32 = 16;
/// The tool and the jaws of a hand that has moved less than `hold_distance` for `hold_time` stay where
/// they are, until the hand leaves this distance.
pub const VBSS_SESSION_AID_AUTO_HOLD: u32 = 32;
/// The tool of a hand that has rested for 0.1 s follows the tool of the other hand while that one moves, for
/// inputs that move one hand at a time. It needs a coach and acts by the coach's goal, while the thread is held
/// at both ends. TAKE_TAIL, and DRAW_TAIL after the first throw, with turns on the jaws: the needle goes along
/// with them and above them, so that the thread stays as long from the slit over the jaws to the needle; it comes nearer while its end of the thread bears more than 0.05 N. SEAT, RELEASE_TAIL: the tool moves
/// opposite to the other one at its own height. It moves up to twice as far, or gives way, so that both ends bear
/// as much. The tool stays within 0.15 m of the slit. It is not turned, and its jaws do not move.
pub const VBSS_SESSION_AID_FOLLOW: u32 = 64;
/// All aids.
pub const VBSS_SESSION_AID_ALL: u32 = 127;

// The constants of vbss_session_gap.
/// Gap between the lips, which are as high as the wall: vbss_drain_gap.opening. A wall that
/// rises counts as closed when it meets the face of the other wall. A drain of
/// VBSS_METHOD_VBLAST uses EDGES instead.
pub const VBSS_SESSION_GAP_LIPS: vbss_session_gap = 0;
/// Gap between the edges in the middle of the wall: vbss_drain_gap.gap, the paper's measure.
pub const VBSS_SESSION_GAP_EDGES: vbss_session_gap = 1;

/// A function of the host that receives each event, at the end of its step. It may read all objects
/// of the context and must not change any.
///
/// @param user   the config's `user`
/// @param event  the event; valid during the call
pub type vbss_session_event_fn = Option<unsafe extern "C" fn(user: *mut c_void, event: *const vbss_session_event)>;

/// A run of the suturing task on a scene.
#[repr(C)]
pub struct vbss_session {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// An event of a session.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_session_event {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Kind of the event.
    pub kind: vbss_session_event_kind,
    /// Tool of the event; VBSS_METRICS_TOOL_NONE: none, or not known.
    pub tool: vbss_metrics_tool,
    /// Meaning depends on the kind.
    pub number: u32,
    /// 1: the fact has ceased.
    pub undone: u32,
    /// STAGE: the stage that the throw has reached.
    pub stage: vbss_session_stage,
    /// THROW: number of wraps, 1 single, 2 double, ...
    pub wraps: i32,
    /// THROW: +1 right-handed, -1 left-handed.
    pub handedness: i32,
    /// THROW: relation to the throw before.
    pub relation: vbss_metrics_relation,
    /// The phase after the step of the event.
    pub phase: vbss_session_phase,
    /// Ordinal number of the event, from 0 on.
    pub ordinal: u64,
    /// Step of the session, from 1 on.
    pub step: u64,
    /// Time since the needle's appearance, s, on the clock of the hands.
    pub time: f64,
    /// Position of the tool's tip, or as the kind says, m.
    pub position: [f64; 3],
    /// Force on the tool's hand, N; zero without a tool.
    pub force: [f64; 3],
    /// Meaning depends on the kind.
    pub amount: f64,
}

/// Configuration of a session. Fill it with vbss_session_config_init, then set the numbers of the
/// bodies.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_session_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Number of the thread in the scene. Its node 0 is at the swage; its last node is the end of
    /// the tail.
    pub thread: u32,
    /// Number of the needle in the scene.
    pub needle: u32,
    /// Number of the drain in the scene.
    pub drain: u32,
    /// Numbers of the left and the right grasper in the scene.
    pub tools: [u32; 2],
    /// Number of a third grasper, which cuts; default 0: a tool is exchanged for shears.
    pub shears: u32,
    /// Largest number of events that are kept, the newest ones; 8 to 65536; default 1024.
    pub event_capacity: u32,
    /// Number of steps between inputs of the knot detector, 1 to 1000; default 4. The detector's
    /// own step_budget bounds the work of an input.
    pub knot_interval: u32,
    /// Number of steps between hashes of the task in the log, for replays to compare; 1 to 1e9;
    /// default 100. Steps with events are hashed too. Used only with a record.
    pub hash_interval: u32,
    /// Devices of the left and the right hand; NULL (default): the host moves that tool.
    pub devices: [*mut vbss_device; 2],
    /// Knot detector, with capacity for the thread and all tools; NULL (default): throws are not
    /// detected.
    pub knots: *mut vbss_knot_detector,
    /// Metrics; NULL (default): nothing is measured.
    pub metrics: *mut vbss_metrics,
    /// Record of the scene; NULL (default): nothing is logged. Each step of the session attaches it
    /// (vbss_scene_set_recorder). To log edits before the first step, the host attaches it.
    pub record: *mut vbss_record,
    /// Replay that has begun with the scene, in place of devices and record; NULL (default):
    /// none.
    pub replay: *mut vbss_replay,
    /// Function that receives the events; NULL (default): none.
    pub listen: vbss_session_event_fn,
    /// Pointer that `listen` receives; may be NULL.
    pub user: *mut c_void,
    /// Time limit from the needle's appearance on, s, 1e-3 to 1e6; default 600.
    pub time_limit: f64,
    /// Time for which a fact must differ before it changes, s, 0 to 10; default 0.05.
    pub dwell: f64,
    /// Dwell time of throws and of faults of the knot, s, 0 to 10; default 0.1. A half hitch takes
    /// 20 times as long.
    pub throw_dwell: f64,
    /// Shortest permitted tail, m, 0 to 1; default 15e-3.
    pub tail_low: f64,
    /// Longest permitted tail, m, tail_low to 1; default 20e-3.
    pub tail_high: f64,
    /// Hysteresis of both limits: a tail that is set stays set up to this far beyond them, m, 0 to
    /// 1; default 1e-3.
    pub tail_margin: f64,
    /// Largest distance from the end at which a tail counts as grasped, m, 0 to 1; default 0.01.
    pub tail_reach: f64,
    /// Largest gap of the slit at which a throw becomes seated, m, 0 to 1; default 0.5e-3. Edges
    /// that have crossed do not gape.
    pub seat_gap: f64,
    /// Gap at which a throw is no longer seated, m, seat_gap to 1; default 1e-3.
    pub seat_release: f64,
    /// Tension of both limbs that seats a throw, N, 0 to 1e3; default 0.5.
    pub seat_force: f64,
    /// Share of torn anchors at which the drain counts as torn off, 0 to 1; default 0.5.
    pub avulsed_share: f64,
    /// Tension at which the thread breaks, N, 0 to 1e6; default 0: it never breaks.
    pub break_force: f64,
    /// Measure of the gap that seats throws and that status, events and metrics report; default
    /// LIPS.
    pub gap_measure: vbss_session_gap,
    /// 1: the session coaches (session_coaching.h); default 0. The hashes in logs do not depend on it, but
    /// the state of a session that coaches can be restored only to one that coaches, too.
    pub coaching: u32,
    /// Share of lost time above which TIME_LOST is an event and `is_lossy` is set, 0 to 1; default
    /// 0.02. A trial shorter than 1 s counts as 1 s.
    pub lost_share: f64,
    /// Exercise that the session trains in place of the whole task (session_exercise.h); default
    /// NONE. The state of an exercise can be restored only to a session with the same one.
    pub exercise: vbss_session_exercise,
    /// Zero.
    pub reserved: u32,
}

/// Status of a session.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_session_status {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Phase of the task.
    pub phase: vbss_session_phase,
    /// Stage of the throw in progress; NONE if there is none.
    pub stage: vbss_session_stage,
    /// Reason of the failure; NONE if the task has not failed.
    pub failure: vbss_session_failure,
    /// The tool that holds the needle, the first of two; VBSS_METRICS_TOOL_NONE: none.
    pub holder: vbss_metrics_tool,
    /// Bits: 1 the hole in exists, 2 the hole out exists.
    pub punctured: u32,
    /// Bits: 1 the thread goes through the hole in, 2 through the hole out.
    pub threaded: u32,
    /// 1: the tail has a permitted length.
    pub tail_set: u32,
    /// Number of tied throws.
    pub throws: u32,
    /// Number of seated throws, counted from the tissue.
    pub seated: u32,
    /// Number of needle transfers between throws, at most two.
    pub transfers: u32,
    /// Bits: 1 the short tail is cut, 2 the needle's tail is cut.
    pub cut: u32,
    /// Faults of the knot, VBSS_KNOT_FAULT_ bits, as last reported by events.
    pub faults: u32,
    /// Number of events that did not fit into the metrics.
    pub metrics_lost: u32,
    /// Number of steps.
    pub steps: u64,
    /// Ordinal of the oldest event that is kept; this is also the number of lost events.
    pub first_event: u64,
    /// Number of events.
    pub event_count: u64,
    /// Time since the needle's appearance until the end or now, s, on the clock of the hands. It
    /// includes `time_lost`.
    pub time: f64,
    /// Length of the short tail from the hole on, m; 0 without a tail.
    pub tail: f64,
    /// Gap of the slit's middle by `gap_measure`, m.
    pub gap: f64,
    /// Largest tension of the short limb and of the needle's limb, N.
    pub tension: [f64; 2],
    /// Deviation of each hole from its mark, mm.
    pub deviation_mm: [f64; 2],
    /// Part of `time` that the scene has left out, s. It counts paused steps
    /// (vbss_scene_statistics::time_paused) and truncated substeps (VBSS_SCENE_EVENT_TRUNCATED), from
    /// the second step on.
    pub time_lost: f64,
    /// Time that was simulated, s: `time` minus `time_lost`. Up to two steps of it may still be
    /// deferred (vbss_scene_statistics::behind).
    pub time_simulated: f64,
    /// 1: more than `lost_share` of the time is lost, with hysteresis.
    pub is_lossy: u32,
    /// Zero.
    pub reserved: u32,
    /// VBSS_SESSION_AID_ bits of the aids in the last step.
    pub aids: u32,
    /// Bits of all aids that were on during the task; 0: it is not assisted.
    pub aids_used: u32,
}

extern "C" {
    /// Fills a configuration with the defaults; the host sets the numbers of the bodies.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_session_config_init(config: *mut vbss_session_config, struct_size: u32) -> vbss_result;
    /// Creates a session over a scene. The host keeps scene, devices, detector, metrics, record and
    /// replay; they must live as long as the session is stepped. The call allocates all memory that
    /// steps need.
    ///
    /// @param scene         the scene
    /// @param config        the configuration; not NULL, because a session needs bodies
    /// @param session  the new session; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of a device, detector, metrics, record or
    /// replay, or one of another context), VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FOUND (no such body),
    /// VBSS_ERROR_INCOMPATIBLE (a body of another kind, a record or replay of another scene, or
    /// both a record and a replay), VBSS_ERROR_IN_USE (a tool is given twice),
    /// VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY (the detector's capacity is too small for the
    /// thread or the tools), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_create(scene: *mut vbss_scene, config: *const vbss_session_config, session: *mut *mut vbss_session) -> vbss_result;
    /// Destroys a session; the host keeps its scene and all other objects.
    ///
    /// @param session  the session; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_destroy(session: *mut vbss_session) -> vbss_result;
    /// Makes one step of the task. The call allocates nothing. When devices cannot be read or the scene
    /// refuses the step, the task is unchanged, but tools may have new targets. Failures after the
    /// scene's step (an object was destroyed or is full) are returned too, and the step counts.
    ///
    /// @param session  the session
    /// @param now      the host's clock, s, for devices; ignored without devices
    /// @param h        length of the step, s, 1e-7 to 0.1; ignored with a replay, which sets it
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of a device, detector, metrics, record or
    /// replay), or a result of vbss_device_read, vbss_scene_set_recorder or
    /// vbss_scene_step, vbss_knot_detector_step, vbss_metrics_add_sample or vbss_device_write.
    /// VBSS_ERROR_WRONG_STATE if the scene was stepped or restored past the session. With a
    /// replay also the results of vbss_replay_step, VBSS_ERROR_WRONG_STATE at its end,
    /// VBSS_ERROR_INCOMPATIBLE if it has begun with another scene since, and VBSS_ERROR_CORRUPT
    /// when the hash of the scene or of the session differs from the recorded one
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_step(session: *mut vbss_session, now: f64, h: f64) -> vbss_result;
    /// Moves a session that follows a replay, and its scene, to just after a step of the log. The call
    /// restores the newest states of both at or before the step, then replays the steps that follow with
    /// the comparisons of vbss_session_step. Later steps have the same bits as without the seek.
    /// `listen` does not receive the events of the seek; kept events can be read. When the log does not
    /// have the step, or no such state can be restored, session, scene and replay are unchanged.
    ///
    /// @param session  the session; its replay has begun with its scene
    /// @param step     number of the step in the log, from 1 on; 0: the initial state
    /// @return VBSS_OK, VBSS_ERROR_WRONG_STATE (the session follows no replay), VBSS_ERROR_INCOMPATIBLE
    /// (the replay has begun with another scene since), VBSS_ERROR_NOT_FOUND (the log ends
    /// before the step, or has no state of a session at or before it), or a result of
    /// vbss_replay_seek, vbss_session_restore or vbss_session_step
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_seek(session: *mut vbss_session, step: u64) -> vbss_result;
    /// Sets the record to which the session writes, for example after a replay has ended and
    /// vbss_record_resume was called. The session leaves the replay that it followed. A record that has
    /// just begun receives the state of the session, so that later steps can be replayed. The call attaches
    /// the record to the scene (vbss_scene_set_recorder) in place of the session's earlier one.
    ///
    /// @param session  the session
    /// @param record   a record of the session's scene; NULL: none
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of the record or another object),
    /// VBSS_ERROR_INCOMPATIBLE (the record belongs to another scene), VBSS_ERROR_WRONG_STATE (it has
    /// ended, or does not know the state of the scene) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_set_record(session: *mut vbss_session, record: *mut vbss_record) -> vbss_result;
    /// Returns the status of a session.
    ///
    /// @param session      the session
    /// @param status  receives the status
    /// @param struct_size  `sizeof *status` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_get_status(session: *mut vbss_session, status: *mut vbss_session_status, struct_size: u32) -> vbss_result;
    /// Returns an event.
    ///
    /// @param session      the session
    /// @param index        first_event to event_count - 1
    /// @param event   receives the event
    /// @param struct_size  `sizeof *event` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (the event has not happened yet, or is lost)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_get_event(session: *mut vbss_session, index: u64, event: *mut vbss_session_event, struct_size: u32) -> vbss_result;
    /// Saves the state of the task, of its knot detector and of its metrics. The host saves the scene
    /// separately (vbss_scene_save), at the same step. Devices and records are not saved.
    ///
    /// @param session       the session
    /// @param bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
    /// @param capacity      size of `bytes`
    /// @param written  bytes written, or bytes needed with VBSS_ERROR_CAPACITY
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of the detector or the metrics),
    /// VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_save(session: *mut vbss_session, bytes: *mut u8, capacity: u64, written: *mut u64) -> vbss_result;
    /// Restores a snapshot of a session with the same configuration, completely or not at all. Restore
    /// its scene first.
    ///
    /// @param session  the session
    /// @param bytes    the snapshot
    /// @param count    its size
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of the detector or the metrics),
    /// VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT (also: the snapshot is
    /// of another session, or the scene is at another step), VBSS_ERROR_DATA_VERSION,
    /// VBSS_ERROR_CAPACITY (the snapshot exceeds the detector's capacity),
    /// VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; on failure
    /// nothing has changed
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_restore(session: *mut vbss_session, bytes: *const u8, count: u64) -> vbss_result;
    /// Returns a hash of the state that vbss_session_save saves, but for the settings and the
    /// intermediate state of aids, which a replay does not have. Equal histories give equal hashes on
    /// every machine. With metrics the cost grows with the length of the trial; do not call it in every
    /// step.
    ///
    /// @param session    the session
    /// @param hash  receives the hash
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: that of the detector or the metrics) or
    /// VBSS_ERROR_NULL_ARGUMENT
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_session_get_hash(session: *mut vbss_session, hash: *mut u64) -> vbss_result;
}
