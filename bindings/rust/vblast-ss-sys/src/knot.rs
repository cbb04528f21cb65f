// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_char};
#[allow(unused_imports)]
use crate::*;


/// Method of a detector: a VBSS_KNOT_METHOD_ constant.
pub type vbss_knot_method = i32;

/// Object in the jaws of a tool: a VBSS_KNOT_HELD_ constant.
pub type vbss_knot_held = i32;

/// Certainty of a throw: a VBSS_KNOT_VERDICT_ constant. Each verdict is revoked, with an event,
/// when the geometry no longer shows it.
pub type vbss_knot_verdict = i32;

/// Reason for an uncertain reading: a VBSS_KNOT_REASON_ constant.
pub type vbss_knot_reason = i32;

/// Name of a knot; its mirror image has the same name. A VBSS_KNOT_NAME_ constant.
pub type vbss_knot_name = i32;

/// Kind of an event: a VBSS_KNOT_EVENT_ constant.
pub type vbss_knot_event = i32;

/// An array of a detector: a VBSS_KNOT_VIEW_ constant.
pub type vbss_knot_field = i32;

// The constants of vbss_knot_method.
/// Winding numbers, and the topology of the closed thread.
pub const VBSS_KNOT_METHOD_TOPOLOGY: vbss_knot_method = 0;
/// Loops in a projection, as in the paper.
pub const VBSS_KNOT_METHOD_PROJECTION: vbss_knot_method = 1;

// The constants of vbss_knot_held.
/// The jaws are empty.
pub const VBSS_KNOT_HELD_NOTHING: vbss_knot_held = 0;
/// The jaws hold the thread at a place.
pub const VBSS_KNOT_HELD_THREAD: vbss_knot_held = 1;
/// The jaws hold the needle, which is at the last point of the polyline.
pub const VBSS_KNOT_HELD_NEEDLE: vbss_knot_held = 2;

// The constants of vbss_knot_verdict.
/// There is no throw.
pub const VBSS_KNOT_VERDICT_NONE: vbss_knot_verdict = 0;
/// The thread winds round a tool.
pub const VBSS_KNOT_VERDICT_WRAPPING: vbss_knot_verdict = 1;
/// The throw is tied if the tools withdraw with their load.
pub const VBSS_KNOT_VERDICT_PASSED: vbss_knot_verdict = 2;
/// The ends have passed through; invariants agree.
pub const VBSS_KNOT_VERDICT_FORMED: vbss_knot_verdict = 3;
/// The type is proved, the ends are clear, the order is known.
pub const VBSS_KNOT_VERDICT_CERTIFIED: vbss_knot_verdict = 4;
/// The verdict is uncertain; `reason` says why.
pub const VBSS_KNOT_VERDICT_UNCERTAIN: vbss_knot_verdict = 5;

// The constants of vbss_knot_reason.
/// The reading is certain.
pub const VBSS_KNOT_REASON_NONE: vbss_knot_reason = 0;
/// Closures differ: an end lies inside the knot.
pub const VBSS_KNOT_REASON_ENDS: vbss_knot_reason = 1;
/// The thread touches itself in every projection.
pub const VBSS_KNOT_REASON_DEGENERATE: vbss_knot_reason = 2;
/// The diagram has more crossings than the detector's capacity, or is too wide for the Jones
/// polynomial that must confirm the result.
pub const VBSS_KNOT_REASON_CAPACITY: vbss_knot_reason = 3;
/// Twist regions and invariants differ.
pub const VBSS_KNOT_REASON_CONFLICT: vbss_knot_reason = 4;

// The constants of vbss_knot_name. Numbers are the wraps of the throws. After "=" the next throw
// has the opposite handedness, after "x" the same one.
/// There is no knot.
pub const VBSS_KNOT_NAME_NONE: vbss_knot_name = 0;
/// One throw of one wrap: 3_1.
pub const VBSS_KNOT_NAME_SINGLE: vbss_knot_name = 1;
/// One throw of two wraps, the surgeon's first: 5_1.
pub const VBSS_KNOT_NAME_DOUBLE: vbss_knot_name = 2;
/// One throw of three wraps: 7_1.
pub const VBSS_KNOT_NAME_TRIPLE: vbss_knot_name = 3;
/// Square knot, 1=1.
pub const VBSS_KNOT_NAME_SQUARE: vbss_knot_name = 4;
/// Granny knot, 1x1.
pub const VBSS_KNOT_NAME_GRANNY: vbss_knot_name = 5;
/// Surgeon's knot, 2=1.
pub const VBSS_KNOT_NAME_SURGEONS: vbss_knot_name = 6;
/// Granny form of the surgeon's knot, 2x1.
pub const VBSS_KNOT_NAME_SURGEONS_GRANNY: vbss_knot_name = 7;
/// The FLS knot, 2=1=1.
pub const VBSS_KNOT_NAME_FLS: vbss_knot_name = 8;
/// Another stack of throws; see vbss_knot_detector_get_notation.
pub const VBSS_KNOT_NAME_STACK: vbss_knot_name = 9;
/// A knot that is not a stack of throws.
pub const VBSS_KNOT_NAME_OTHER: vbss_knot_name = 10;

// Bits for the differences of a knot from the FLS knot 2=1=1.
/// The first throw does not have two wraps.
pub const VBSS_KNOT_FAULT_FIRST: u32 = 1;
/// A later throw does not have one wrap.
pub const VBSS_KNOT_FAULT_LATER: u32 = 2;
/// There are fewer than three throws.
pub const VBSS_KNOT_FAULT_FEW: u32 = 4;
/// There are more than three throws.
pub const VBSS_KNOT_FAULT_MANY: u32 = 8;
/// A throw has the same handedness as the one before.
pub const VBSS_KNOT_FAULT_GRANNY: u32 = 16;
/// There is a knot in one limb alone.
pub const VBSS_KNOT_FAULT_STRAY: u32 = 32;
/// A throw has turned into a half hitch, which slides.
pub const VBSS_KNOT_FAULT_HITCH: u32 = 64;
/// The order of the throws is not known.
pub const VBSS_KNOT_FAULT_ORDER: u32 = 128;
/// The knot is not a stack of throws.
pub const VBSS_KNOT_FAULT_TYPE: u32 = 256;
/// The reading is uncertain.
pub const VBSS_KNOT_FAULT_UNCERTAIN: u32 = 512;

// Bits of the flags of a throw.
/// Its places on the limbs are known.
pub const VBSS_KNOT_THROW_LOCATED: u32 = 1;
/// Its position in the stack is known: sub-chains show it. In vbss_knot_detector_step it is
/// also known if an earlier reading had the throws in this order and at most one was added.
pub const VBSS_KNOT_THROW_ORDERED: u32 = 2;
/// The throw has the same handedness as the throw before.
pub const VBSS_KNOT_THROW_GRANNY: u32 = 4;
/// The throw lies in one limb alone and not round the other limb.
pub const VBSS_KNOT_THROW_STRAY: u32 = 8;
/// |slip| is at least `slip_limit`.
pub const VBSS_KNOT_THROW_HITCH: u32 = 16;
/// The tail is shorter than tail_least, or the throw is undone if the tools withdraw.
pub const VBSS_KNOT_THROW_REVOCABLE: u32 = 32;

// The constants of vbss_knot_event. In the view three numbers follow each event; each comment
// lists them after its colon.
/// The thread winds round a tool: tool, 1 + (turns > 0), 0.
pub const VBSS_KNOT_EVENT_WRAPPED: vbss_knot_event = 1;
/// The thread no longer winds round a tool: tool, 0, 0.
pub const VBSS_KNOT_EVENT_UNWRAPPED: vbss_knot_event = 2;
/// The thread winds towards the handle: tool, 0, 0.
pub const VBSS_KNOT_EVENT_WRONG_DIRECTION: vbss_knot_event = 3;
/// A throw is tied as soon as the tools withdraw: tool, wraps, 1 + (right-handed).
pub const VBSS_KNOT_EVENT_PASSED: vbss_knot_event = 4;
/// A throw is formed: its number from 0, wraps, 1 + (right-handed).
pub const VBSS_KNOT_EVENT_FORMED: vbss_knot_event = 5;
/// A throw is certified: its number from 0, wraps, 1 + (right-handed).
pub const VBSS_KNOT_EVENT_CERTIFIED: vbss_knot_event = 6;
/// A throw is gone or uncertain: number, wraps, 1 + (right-handed).
pub const VBSS_KNOT_EVENT_REVOKED: vbss_knot_event = 7;
/// A knot lies in one limb: number, wraps, 1 + (right-handed).
pub const VBSS_KNOT_EVENT_STRAY: vbss_knot_event = 8;
/// The reading is uncertain: vbss_knot_reason, 0, 0.
pub const VBSS_KNOT_EVENT_UNCERTAIN: vbss_knot_event = 9;
/// A reading of the topology has ended: throws, name, verdict.
pub const VBSS_KNOT_EVENT_READ: vbss_knot_event = 10;
/// Events exceeded the capacity: number of lost events, 0, 0.
pub const VBSS_KNOT_EVENT_LOST: vbss_knot_event = 11;

// The constants of vbss_knot_field.
/// x 4 uint32_t: vbss_knot_event and its three numbers, of the last step.
pub const VBSS_KNOT_VIEW_EVENTS: vbss_knot_field = 0;
/// PROJECTION, x 4 uint32_t: tool, the two segments of the intersecting pair, 1 if the tool is
/// inside; all loops of the last step.
pub const VBSS_KNOT_VIEW_LOOPS: vbss_knot_field = 1;

/// Finds knots in a thread, step by step.
#[repr(C)]
pub struct vbss_knot_detector {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of a detector. Fill it with vbss_knot_detector_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_knot_detector_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Method; default VBSS_KNOT_METHOD_TOPOLOGY.
    pub method: vbss_knot_method,
    /// Largest number of points of the polyline, 2 to 8192; default 1024.
    pub point_capacity: u32,
    /// Largest number of tools, 0 to 16; default 4.
    pub tool_capacity: u32,
    /// Largest number of crossings of a diagram before it is simplified, 8 to 2048; default 512. A
    /// quarter as many may remain afterwards.
    pub crossing_capacity: u32,
    /// Largest number of directions of projection to try, 1 to 64; default 6.
    pub direction_limit: u32,
    /// Number of directions in which the ends are closed besides straight outward, 0 to 16; default
    /// 8.
    pub closure_count: u32,
    /// Largest number of these closures that may contradict the outward closure, 0 to 16; default
    /// 2. With more an end lies inside the knot, and the verdict is uncertain.
    pub closure_tolerance: u32,
    /// TOPOLOGY: largest number of operations (about a nanosecond each) in a step, exceeded at most
    /// by the last indivisible operation, 100 to 1e9; default 8000.
    pub step_budget: u32,
    /// TOPOLOGY: number of steps from the start of a reading to the start of the next one, if the
    /// first has ended; 0: read at events only; default 20.
    pub interval: u32,
    /// Largest number of events of a step that are kept, 8 to 4096; default 64.
    pub event_capacity: u32,
    /// Zero.
    pub reserved: u32,
    /// Largest length beyond the jaws with which the thread counts as held near its end, m, 0 to 1;
    /// default 0.03. A longer one is a bight.
    pub tail_reach: f64,
    /// Length below which a tail can slip back and undo its throw, m, 0 to 1; default 0.003.
    pub tail_least: f64,
    /// Signed turns about a tool from which the thread is wrapped round it, 0.1 to 2; default 0.75.
    /// The wrap ends a quarter of a turn lower.
    pub wrap_turns: f64,
    /// Magnitude of a throw's slip measure from which it is a half hitch, 0 to 1; default 0.45.
    pub slip_limit: f64,
    /// PROJECTION: position of the plane on the tool's axis, m from the tip towards the handle, -1
    /// to 1; default -0.002, ahead of the tip.
    pub plane_offset: f64,
    /// PROJECTION: seed of the directions of its rays; default 1.
    pub seed: u64,
}

/// A tool: a chain of capsules between successive points of its axis.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_knot_tool {
    /// Number of points of the axis, 2 to 4.
    pub point_count: u32,
    /// Object in the jaws.
    pub held: vbss_knot_held,
    /// Points from the handle (or trocar) to the tip, m; successive points differ.
    pub axis: [[f64; 3]; 4],
    /// Radius of each capsule, m, 0 to 1.
    pub radius: [f64; 3],
    /// THREAD: place of the jaws on the polyline; otherwise ignored.
    pub held_place: f64,
}

/// Input of a detector. Fill it with vbss_knot_input_init, then set its fields. The library copies
/// all of it.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_knot_input {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Number of points, 2 to point_capacity; the default 0 is refused.
    pub point_count: u32,
    /// x, y, z of each point from the tail's end on, m, each coordinate at most 1e3 in magnitude.
    pub points: *const f64,
    /// Distance from one point to the next, bytes, at least 24; default 24.
    pub stride_bytes: u32,
    /// Number of tools, 0 (default) to tool_capacity.
    pub tool_count: u32,
    /// Array of tool_count tools; may be NULL without tools.
    pub tools: *const vbss_knot_tool,
    /// Number of points where the thread goes through tissue. 0 (default): not known; 1: one point;
    /// 2: in at the first, out at the second. Without tissue no throw is stray, and throws are
    /// listed in the order in which they nest.
    pub hole_count: u32,
    /// 1: the points start at the long limb's end, and places count from there; default 0.
    pub reversed: u32,
    /// Positions of the holes, m.
    pub holes: [[f64; 3]; 2],
    /// Places of the holes on the polyline; negative (default): the place nearest to `holes`.
    pub hole_places: [f64; 2],
    /// Direction away from the knot into the tissue, of any length; zero (default): from the middle
    /// of the thread to the middle of the holes.
    pub away: [f64; 3],
    /// 1: the thread may have passed through itself or a tool since the last step, for example
    /// without a collision guard, so the topology is read again; default 0.
    pub may_have_passed: u32,
    /// Zero.
    pub reserved: u32,
}

/// A throw of a knot. Throws are counted from the tissue outward.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_knot_throw {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Certainty, FORMED or CERTIFIED.
    pub verdict: vbss_knot_verdict,
    /// Number of wraps, from 1 on.
    pub wraps: i32,
    /// +1 right-handed, -1 left-handed.
    pub handedness: i32,
    /// VBSS_KNOT_THROW_ bits.
    pub flags: u32,
    /// Zero.
    pub reserved: u32,
    /// LOCATED: first and last place on the tail limb, ascending.
    pub tail_places: [f64; 2],
    /// LOCATED: first and last place on the long limb, ascending.
    pub long_places: [f64; 2],
    /// LOCATED: (cT - cL) / (cT + cL), with the mean curvature cT of the tail limb and cL of the
    /// long limb where the two cross, seen from all directions. 0: a flat half knot; +1: the tail is
    /// hitched round a straight long limb; -1: the reverse.
    pub slip: f64,
    /// LOCATED: length of thread between the throw and the tail's end, m.
    pub tail_length: f64,
    /// Step of the detector in which the throw was first found.
    pub formed_step: u64,
    /// Step of the input that last confirmed the throw.
    pub reading_step: u64,
}

/// Winding of the thread about one tool. Both methods update it in every step.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_knot_winding {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// 1: |turns| of the longest run has reached wrap_turns, and has not since fallen a quarter of
    /// a turn below.
    pub wrapped: i32,
    /// Signed turns about the axis, seen from the tip to the handle, walking from the tail's end to
    /// the long limb's. All thread beside the tool counts; thread beyond the tip or the handle does
    /// not.
    pub turns: f64,
    /// Turns of the run that winds most. A run is thread beside the tool without a gap.
    pub run_turns: f64,
    /// First and last place of that run.
    pub run_places: [f64; 2],
    /// Distance of these places from the tip along the axis, m.
    pub run_heights: [f64; 2],
    /// Direction along the tool in which the run winds, from its end nearer to the tissue to the
    /// other. +1: towards the tip, as a throw needs; -1: towards the handle, which ties nothing; 0:
    /// less than the thread's width either way, or not wrapped.
    pub sense: i32,
    /// Number of runs.
    pub runs: u32,
}

/// State of a detector.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_knot_state {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Name of the knot.
    pub name: vbss_knot_name,
    /// Verdict of the least certain throw; UNCERTAIN when the reading is; NONE without a knot.
    pub verdict: vbss_knot_verdict,
    /// Reason why the reading is uncertain.
    pub reason: vbss_knot_reason,
    /// Number of tied throws, at most 8.
    pub throw_count: u32,
    /// Differences from the FLS knot: VBSS_KNOT_FAULT_ bits.
    pub faults: u32,
    /// Verdict of the throw that is being tied: NONE, WRAPPING or PASSED.
    pub next_verdict: vbss_knot_verdict,
    /// Its wraps if the tools withdrew now; 0: no throw would be tied.
    pub next_wraps: i32,
    /// Its handedness, +1 or -1; 0 without such a throw.
    pub next_handedness: i32,
    /// The tool that the thread winds round, from 0.
    pub next_tool: u32,
    /// PROJECTION: loops round a tool that one segment crosses.
    pub loops: u32,
    /// PROJECTION: number of crossings of loops that tie nothing.
    pub undone: u32,
    /// Number of crossings of the simplest diagram found.
    pub crossings: u32,
    /// 1: the diagram was decomposed into twist regions.
    pub certified: i32,
    /// Signature sigma; -2 for the right-handed 3_1.
    pub signature: i32,
    /// Levine-Tristram signature at 0.27 pi.
    pub signature_tristram: i32,
    /// Determinant |Delta(-1)|.
    pub determinant: i64,
    /// Vassiliev invariant of degree 2 (coefficient of z^2 of the Conway polynomial).
    pub v2: i64,
    /// Vassiliev invariant of degree 3; 1 for the right-handed 3_1.
    pub v3: i64,
    /// Number of other closures that were compared.
    pub closures: u32,
    /// Number of other closures that gave the same result.
    pub closures_agreeing: u32,
    /// 1: both ends are outermost, so that all closures agree.
    pub ends_free: i32,
    /// Zero.
    pub reserved: u32,
    /// Number of calls of vbss_knot_detector_step and vbss_knot_detector_judge.
    pub steps: u64,
    /// Step whose input the last reading used; 0: there was no reading.
    pub reading_step: u64,
}

/// Counts since creation or reset.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_knot_detector_statistics {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Zero.
    pub reserved: u32,
    /// Finished readings of the topology.
    pub readings: u64,
    /// Closed curves that were read.
    pub closures: u64,
    /// Closed curves that were decomposed into twist regions.
    pub certified: u64,
    /// Readings that ended uncertain.
    pub uncertain: u64,
    /// Diagrams that were made.
    pub projections: u64,
    /// Diagrams rejected because a crossing was not certain.
    pub degenerate: u64,
    /// Diagrams rejected because of too many crossings.
    pub overflows: u64,
    /// Vertices removed by proved moves.
    pub removed: u64,
    /// Operations used by readings.
    pub work: u64,
    /// Largest number of operations in a step.
    pub most_step_work: u64,
    /// Largest number of operations of a reading.
    pub most_work: u64,
    /// Verdicts that were revoked.
    pub revoked: u64,
}

extern "C" {
    /// Fills a configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_knot_detector_config_init(config: *mut vbss_knot_detector_config, struct_size: u32) -> vbss_result;
    /// Fills an input with the defaults; the host sets the points.
    ///
    /// @param input   the input to fill
    /// @param struct_size  `sizeof *input` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_knot_input_init(input: *mut vbss_knot_input, struct_size: u32) -> vbss_result;
    /// Creates a detector without a history and allocates all memory that it needs.
    ///
    /// @param context        owner
    /// @param config   configuration; NULL for the defaults
    /// @param detector  the new detector; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_create(context: *mut vbss_context, config: *const vbss_knot_detector_config, detector: *mut *mut vbss_knot_detector) -> vbss_result;
    /// Destroys a detector.
    ///
    /// @param detector  the detector; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_destroy(detector: *mut vbss_knot_detector) -> vbss_result;
    /// Processes the thread and the tools of a step: updates the winding, works on the topology within
    /// the work limit, begins a new reading when it is due, and reports changes as events. The call
    /// allocates nothing.
    ///
    /// @param detector  the detector
    /// @param input     the input; the same tools in the same order in every step
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_CAPACITY (points, tools), VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; after
    /// an error the detector is unchanged
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_step(detector: *mut vbss_knot_detector, input: *const vbss_knot_input) -> vbss_result;
    /// Processes an input like vbss_knot_detector_step, but without a work limit: it abandons an
    /// unfinished reading and reads this input to the end.
    ///
    /// @param detector  the detector
    /// @param input     the input
    /// @return as vbss_knot_detector_step
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_judge(detector: *mut vbss_knot_detector, input: *const vbss_knot_input) -> vbss_result;
    /// Resets a detector to its state after creation, with its statistics and its count of steps.
    ///
    /// @param detector  the detector
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_reset(detector: *mut vbss_knot_detector) -> vbss_result;
    /// Returns the state of a detector.
    ///
    /// @param detector     the detector
    /// @param state   receives the state
    /// @param struct_size  `sizeof *state` as the caller was compiled; fields that the library does not
    /// know become zero
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_get_state(detector: *mut vbss_knot_detector, state: *mut vbss_knot_state, struct_size: u32) -> vbss_result;
    /// Returns one throw of the knot.
    ///
    /// @param detector     the detector
    /// @param number       0 (nearest to the tissue) to throw_count - 1
    /// @param knot_throw  receives the throw
    /// @param struct_size  `sizeof *knot_throw` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such throw)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_get_throw(detector: *mut vbss_knot_detector, number: u32, knot_throw: *mut vbss_knot_throw, struct_size: u32) -> vbss_result;
    /// Returns the winding of the thread about one tool.
    ///
    /// @param detector      the detector
    /// @param tool          index of the tool, 0 to tool_count - 1 of the last input
    /// @param winding  receives the winding
    /// @param struct_size   `sizeof *winding` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such tool)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_get_winding(detector: *mut vbss_knot_detector, tool: u32, winding: *mut vbss_knot_winding, struct_size: u32) -> vbss_result;
    /// Returns the knot in the notation of surgeons, such as "2=1=1": the wraps of each throw from the
    /// tissue outward. "=" precedes a throw of opposite handedness, and "x" one of the same handedness.
    /// "+" joins throws whose order is not known. "?" is a knot that is not a stack of throws, and ""
    /// means that there is no knot.
    ///
    /// @param detector   the detector
    /// @param text  receives the text and a final zero
    /// @param capacity   size of `text`, bytes; 32 always suffice
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_get_notation(detector: *mut vbss_knot_detector, text: *mut c_char, capacity: u64) -> vbss_result;
    /// Returns a view of an array.
    ///
    /// @param detector     the detector
    /// @param field        the array
    /// @param view    receives the view
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_OUT_OF_RANGE (no such field)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_get_view(detector: *mut vbss_knot_detector, field: vbss_knot_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
    /// Returns counts since creation or reset.
    ///
    /// @param detector         the detector
    /// @param statistics  receives them
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_get_statistics(detector: *mut vbss_knot_detector, statistics: *mut vbss_knot_detector_statistics, struct_size: u32) -> vbss_result;
    /// Saves the state of a detector, with an unfinished reading.
    ///
    /// @param detector      the detector
    /// @param bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
    /// @param capacity      size of `bytes`
    /// @param written  bytes written, or bytes needed with VBSS_ERROR_CAPACITY
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_save(detector: *mut vbss_knot_detector, bytes: *mut u8, capacity: u64, written: *mut u64) -> vbss_result;
    /// Restores a snapshot of a detector with the same configuration, completely or not at all. An
    /// unfinished reading is repeated up to the point where it was.
    ///
    /// @param detector  the detector
    /// @param bytes     the snapshot
    /// @param count     its size
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
    /// VBSS_ERROR_CORRUPT (also: the snapshot is of another configuration),
    /// VBSS_ERROR_DATA_VERSION, VBSS_ERROR_CAPACITY (the snapshot exceeds the detector's
    /// capacity), VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; on
    /// failure nothing has changed
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_restore(detector: *mut vbss_knot_detector, bytes: *const u8, count: u64) -> vbss_result;
    /// Returns a hash of the detector's state; equal histories give equal hashes on every machine.
    ///
    /// @param detector   the detector
    /// @param hash  receives the hash
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_knot_detector_get_hash(detector: *mut vbss_knot_detector, hash: *mut u64) -> vbss_result;
}
