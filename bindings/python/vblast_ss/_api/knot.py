"""knot.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char, c_double, c_int32, c_int64, c_uint32, c_uint64, c_uint8
from enum import IntEnum, IntFlag
from typing import Any, ClassVar, NamedTuple

from .base import vbss_context, vbss_view


class KnotMethod(IntEnum):
    """The constants of vbss_knot_method."""
    TOPOLOGY = 0
    """Winding numbers, and the topology of the closed thread."""
    PROJECTION = 1
    """Loops in a projection, as in the paper."""


class KnotHeld(IntEnum):
    """The constants of vbss_knot_held."""
    NOTHING = 0
    """The jaws are empty."""
    THREAD = 1
    """The jaws hold the thread at a place."""
    NEEDLE = 2
    """The jaws hold the needle, which is at the last point of the polyline."""


class KnotVerdict(IntEnum):
    """The constants of vbss_knot_verdict."""
    NONE = 0
    """There is no throw."""
    WRAPPING = 1
    """The thread winds round a tool."""
    PASSED = 2
    """The throw is tied if the tools withdraw with their load."""
    FORMED = 3
    """The ends have passed through; invariants agree."""
    CERTIFIED = 4
    """The type is proved, the ends are clear, the order is known."""
    UNCERTAIN = 5
    """The verdict is uncertain; `reason` says why."""


class KnotReason(IntEnum):
    """The constants of vbss_knot_reason."""
    NONE = 0
    """The reading is certain."""
    ENDS = 1
    """Closures differ: an end lies inside the knot."""
    DEGENERATE = 2
    """The thread touches itself in every projection."""
    CAPACITY = 3
    """The diagram has more crossings than the detector's capacity, or is too wide for the Jones
    polynomial that must confirm the result."""
    CONFLICT = 4
    """Twist regions and invariants differ."""


class KnotName(IntEnum):
    """The constants of vbss_knot_name. Numbers are the wraps of the throws. After "=" the next
    throw has the opposite handedness, after "x" the same one."""
    NONE = 0
    """There is no knot."""
    SINGLE = 1
    """One throw of one wrap: 3_1."""
    DOUBLE = 2
    """One throw of two wraps, the surgeon's first: 5_1."""
    TRIPLE = 3
    """One throw of three wraps: 7_1."""
    SQUARE = 4
    """Square knot, 1=1."""
    GRANNY = 5
    """Granny knot, 1x1."""
    SURGEONS = 6
    """Surgeon's knot, 2=1."""
    SURGEONS_GRANNY = 7
    """Granny form of the surgeon's knot, 2x1."""
    FLS = 8
    """The FLS knot, 2=1=1."""
    STACK = 9
    """Another stack of throws; see vbss_knot_detector_get_notation."""
    OTHER = 10
    """A knot that is not a stack of throws."""


class KnotFaultBits(IntFlag):
    """Bits for the differences of a knot from the FLS knot 2=1=1."""
    FIRST = 1
    """The first throw does not have two wraps."""
    LATER = 2
    """A later throw does not have one wrap."""
    FEW = 4
    """There are fewer than three throws."""
    MANY = 8
    """There are more than three throws."""
    GRANNY = 16
    """A throw has the same handedness as the one before."""
    STRAY = 32
    """There is a knot in one limb alone."""
    HITCH = 64
    """A throw has turned into a half hitch, which slides."""
    ORDER = 128
    """The order of the throws is not known."""
    TYPE = 256
    """The knot is not a stack of throws."""
    UNCERTAIN = 512
    """The reading is uncertain."""


class KnotThrowBits(IntFlag):
    """Bits of the flags of a throw."""
    LOCATED = 1
    """Its places on the limbs are known."""
    ORDERED = 2
    """Its position in the stack is known: sub-chains show it. In vbss_knot_detector_step it is
    also known if an earlier reading had the throws in this order and at most one was added."""
    GRANNY = 4
    """The throw has the same handedness as the throw before."""
    STRAY = 8
    """The throw lies in one limb alone and not round the other limb."""
    HITCH = 16
    """|slip| is at least `slip_limit`."""
    REVOCABLE = 32
    """The tail is shorter than tail_least, or the throw is undone if the tools withdraw."""


class KnotEvent(IntEnum):
    """The constants of vbss_knot_event. In the view three numbers follow each event; each comment
    lists them after its colon."""
    WRAPPED = 1
    """The thread winds round a tool: tool, 1 + (turns > 0), 0."""
    UNWRAPPED = 2
    """The thread no longer winds round a tool: tool, 0, 0."""
    WRONG_DIRECTION = 3
    """The thread winds towards the handle: tool, 0, 0."""
    PASSED = 4
    """A throw is tied as soon as the tools withdraw: tool, wraps, 1 + (right-handed)."""
    FORMED = 5
    """A throw is formed: its number from 0, wraps, 1 + (right-handed)."""
    CERTIFIED = 6
    """A throw is certified: its number from 0, wraps, 1 + (right-handed)."""
    REVOKED = 7
    """A throw is gone or uncertain: number, wraps, 1 + (right-handed)."""
    STRAY = 8
    """A knot lies in one limb: number, wraps, 1 + (right-handed)."""
    UNCERTAIN = 9
    """The reading is uncertain: vbss_knot_reason, 0, 0."""
    READ = 10
    """A reading of the topology has ended: throws, name, verdict."""
    LOST = 11
    """Events exceeded the capacity: number of lost events, 0, 0."""


class KnotField(IntEnum):
    """The constants of vbss_knot_field."""
    EVENTS = 0
    """x 4 uint32_t: vbss_knot_event and its three numbers, of the last step."""
    LOOPS = 1
    """PROJECTION, x 4 uint32_t: tool, the two segments of the intersecting pair, 1 if the tool is
    inside; all loops of the last step."""


class vbss_knot_detector(ctypes.Structure):
    """Finds knots in a thread, step by step."""


class vbss_knot_detector_config(ctypes.Structure):
    """Configuration of a detector. Fill it with vbss_knot_detector_config_init, then change
    fields.

    method: Method; default VBSS_KNOT_METHOD_TOPOLOGY.

    point_capacity: Largest number of points of the polyline, 2 to 8192; default 1024.

    tool_capacity: Largest number of tools, 0 to 16; default 4.

    crossing_capacity: Largest number of crossings of a diagram before it is simplified, 8 to
    2048; default 512. A quarter as many may remain afterwards.

    direction_limit: Largest number of directions of projection to try, 1 to 64; default 6.

    closure_count: Number of directions in which the ends are closed besides straight outward, 0
    to 16; default 8.

    closure_tolerance: Largest number of these closures that may contradict the outward closure,
    0 to 16; default 2. With more an end lies inside the knot, and the verdict is uncertain.

    step_budget: TOPOLOGY: largest number of operations (about a nanosecond each) in a step,
    exceeded at most by the last indivisible operation, 100 to 1e9; default 8000.

    interval: TOPOLOGY: number of steps from the start of a reading to the start of the next
    one, if the first has ended; 0: read at events only; default 20.

    event_capacity: Largest number of events of a step that are kept, 8 to 4096; default 64.

    tail_reach: Largest length beyond the jaws with which the thread counts as held near its
    end, m, 0 to 1; default 0.03. A longer one is a bight.

    tail_least: Length below which a tail can slip back and undo its throw, m, 0 to 1; default
    0.003.

    wrap_turns: Signed turns about a tool from which the thread is wrapped round it, 0.1 to 2;
    default 0.75. The wrap ends a quarter of a turn lower.

    slip_limit: Magnitude of a throw's slip measure from which it is a half hitch, 0 to 1;
    default 0.45.

    plane_offset: PROJECTION: position of the plane on the tool's axis, m from the tip towards
    the handle, -1 to 1; default -0.002, ahead of the tip.

    seed: PROJECTION: seed of the directions of its rays; default 1."""
    struct_size: int
    method: int
    point_capacity: int
    tool_capacity: int
    crossing_capacity: int
    direction_limit: int
    closure_count: int
    closure_tolerance: int
    step_budget: int
    interval: int
    event_capacity: int
    reserved: int
    tail_reach: float
    tail_least: float
    wrap_turns: float
    slip_limit: float
    plane_offset: float
    seed: int
    _kinds_: ClassVar[dict[str, Any]] = {"method": KnotMethod}
    _fields_ = [
        ("struct_size", c_uint32),
        ("method", c_int32),
        ("point_capacity", c_uint32),
        ("tool_capacity", c_uint32),
        ("crossing_capacity", c_uint32),
        ("direction_limit", c_uint32),
        ("closure_count", c_uint32),
        ("closure_tolerance", c_uint32),
        ("step_budget", c_uint32),
        ("interval", c_uint32),
        ("event_capacity", c_uint32),
        ("reserved", c_uint32),
        ("tail_reach", c_double),
        ("tail_least", c_double),
        ("wrap_turns", c_double),
        ("slip_limit", c_double),
        ("plane_offset", c_double),
        ("seed", c_uint64),
    ]


class vbss_knot_tool(ctypes.Structure):
    """A tool: a chain of capsules between successive points of its axis.

    point_count: Number of points of the axis, 2 to 4.

    held: Object in the jaws.

    axis: Points from the handle (or trocar) to the tip, m; successive points differ.

    radius: Radius of each capsule, m, 0 to 1.

    held_place: THREAD: place of the jaws on the polyline; otherwise ignored."""
    point_count: int
    held: int
    axis: Any
    radius: Any
    held_place: float
    _kinds_: ClassVar[dict[str, Any]] = {"held": KnotHeld}
    _fields_ = [
        ("point_count", c_uint32),
        ("held", c_int32),
        ("axis", (c_double * 3) * 4),
        ("radius", c_double * 3),
        ("held_place", c_double),
    ]


class vbss_knot_input(ctypes.Structure):
    """Input of a detector. Fill it with vbss_knot_input_init, then set its fields. The library
    copies all of it.

    point_count: Number of points, 2 to point_capacity; the default 0 is refused.

    points: x, y, z of each point from the tail's end on, m, each coordinate at most 1e3 in
    magnitude.

    stride_bytes: Distance from one point to the next, bytes, at least 24; default 24.

    tool_count: Number of tools, 0 (default) to tool_capacity.

    tools: Array of tool_count tools; may be NULL without tools.

    hole_count: Number of points where the thread goes through tissue. 0 (default): not known;
    1: one point; 2: in at the first, out at the second. Without tissue no throw is stray, and
    throws are listed in the order in which they nest.

    reversed: 1: the points start at the long limb's end, and places count from there; default
    0.

    holes: Positions of the holes, m.

    hole_places: Places of the holes on the polyline; negative (default): the place nearest to
    `holes`.

    away: Direction away from the knot into the tissue, of any length; zero (default): from the
    middle of the thread to the middle of the holes.

    may_have_passed: 1: the thread may have passed through itself or a tool since the last step,
    for example without a collision guard, so the topology is read again; default 0."""
    struct_size: int
    point_count: int
    points: Any
    stride_bytes: int
    tool_count: int
    tools: Any
    hole_count: int
    reversed: int
    holes: Any
    hole_places: Any
    away: Any
    may_have_passed: int
    reserved: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("point_count", c_uint32),
        ("points", POINTER(c_double)),
        ("stride_bytes", c_uint32),
        ("tool_count", c_uint32),
        ("tools", POINTER(vbss_knot_tool)),
        ("hole_count", c_uint32),
        ("reversed", c_uint32),
        ("holes", (c_double * 3) * 2),
        ("hole_places", c_double * 2),
        ("away", c_double * 3),
        ("may_have_passed", c_uint32),
        ("reserved", c_uint32),
    ]


class vbss_knot_throw(ctypes.Structure):
    """A throw of a knot. Throws are counted from the tissue outward.

    verdict: Certainty, FORMED or CERTIFIED.

    wraps: Number of wraps, from 1 on.

    handedness: +1 right-handed, -1 left-handed.

    flags: VBSS_KNOT_THROW_ bits.

    tail_places: LOCATED: first and last place on the tail limb, ascending.

    long_places: LOCATED: first and last place on the long limb, ascending.

    slip: LOCATED: (cT - cL) / (cT + cL), with the mean curvature cT of the tail limb and cL of
    the long limb where the two cross, seen from all directions. 0: a flat half knot; +1: the
    tail is hitched round a straight long limb; -1: the reverse.

    tail_length: LOCATED: length of thread between the throw and the tail's end, m.

    formed_step: Step of the detector in which the throw was first found.

    reading_step: Step of the input that last confirmed the throw."""
    struct_size: int
    verdict: int
    wraps: int
    handedness: int
    flags: int
    reserved: int
    tail_places: Any
    long_places: Any
    slip: float
    tail_length: float
    formed_step: int
    reading_step: int
    _kinds_: ClassVar[dict[str, Any]] = {"verdict": KnotVerdict, "flags": KnotThrowBits}
    _fields_ = [
        ("struct_size", c_uint32),
        ("verdict", c_int32),
        ("wraps", c_int32),
        ("handedness", c_int32),
        ("flags", c_uint32),
        ("reserved", c_uint32),
        ("tail_places", c_double * 2),
        ("long_places", c_double * 2),
        ("slip", c_double),
        ("tail_length", c_double),
        ("formed_step", c_uint64),
        ("reading_step", c_uint64),
    ]


class KnotThrow(NamedTuple):
    """A throw of a knot. Throws are counted from the tissue outward. Fields as vbss_knot_throw
    says."""
    verdict: KnotVerdict
    wraps: int
    handedness: int
    flags: KnotThrowBits
    tail_places: tuple[float, ...]
    long_places: tuple[float, ...]
    slip: float
    tail_length: float
    formed_step: int
    reading_step: int


class vbss_knot_winding(ctypes.Structure):
    """Winding of the thread about one tool. Both methods update it in every step.

    wrapped: 1: |turns| of the longest run has reached wrap_turns, and has not since fallen a
    quarter of a turn below.

    turns: Signed turns about the axis, seen from the tip to the handle, walking from the tail's
    end to the long limb's. All thread beside the tool counts; thread beyond the tip or the
    handle does not.

    run_turns: Turns of the run that winds most. A run is thread beside the tool without a gap.

    run_places: First and last place of that run.

    run_heights: Distance of these places from the tip along the axis, m.

    sense: Direction along the tool in which the run winds, from its end nearer to the tissue to
    the other. +1: towards the tip, as a throw needs; -1: towards the handle, which ties
    nothing; 0: less than the thread's width either way, or not wrapped.

    runs: Number of runs."""
    struct_size: int
    wrapped: int
    turns: float
    run_turns: float
    run_places: Any
    run_heights: Any
    sense: int
    runs: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("wrapped", c_int32),
        ("turns", c_double),
        ("run_turns", c_double),
        ("run_places", c_double * 2),
        ("run_heights", c_double * 2),
        ("sense", c_int32),
        ("runs", c_uint32),
    ]


class KnotWinding(NamedTuple):
    """Winding of the thread about one tool. Both methods update it in every step. Fields as
    vbss_knot_winding says."""
    wrapped: int
    turns: float
    run_turns: float
    run_places: tuple[float, ...]
    run_heights: tuple[float, ...]
    sense: int
    runs: int


class vbss_knot_state(ctypes.Structure):
    """State of a detector.

    name: Name of the knot.

    verdict: Verdict of the least certain throw; UNCERTAIN when the reading is; NONE without a
    knot.

    reason: Reason why the reading is uncertain.

    throw_count: Number of tied throws, at most 8.

    faults: Differences from the FLS knot: VBSS_KNOT_FAULT_ bits.

    next_verdict: Verdict of the throw that is being tied: NONE, WRAPPING or PASSED.

    next_wraps: Its wraps if the tools withdrew now; 0: no throw would be tied.

    next_handedness: Its handedness, +1 or -1; 0 without such a throw.

    next_tool: The tool that the thread winds round, from 0.

    loops: PROJECTION: loops round a tool that one segment crosses.

    undone: PROJECTION: number of crossings of loops that tie nothing.

    crossings: Number of crossings of the simplest diagram found.

    certified: 1: the diagram was decomposed into twist regions.

    signature: Signature sigma; -2 for the right-handed 3_1.

    signature_tristram: Levine-Tristram signature at 0.27 pi.

    determinant: Determinant |Delta(-1)|.

    v2: Vassiliev invariant of degree 2 (coefficient of z^2 of the Conway polynomial).

    v3: Vassiliev invariant of degree 3; 1 for the right-handed 3_1.

    closures: Number of other closures that were compared.

    closures_agreeing: Number of other closures that gave the same result.

    ends_free: 1: both ends are outermost, so that all closures agree.

    steps: Number of calls of vbss_knot_detector_step and vbss_knot_detector_judge.

    reading_step: Step whose input the last reading used; 0: there was no reading."""
    struct_size: int
    name: int
    verdict: int
    reason: int
    throw_count: int
    faults: int
    next_verdict: int
    next_wraps: int
    next_handedness: int
    next_tool: int
    loops: int
    undone: int
    crossings: int
    certified: int
    signature: int
    signature_tristram: int
    determinant: int
    v2: int
    v3: int
    closures: int
    closures_agreeing: int
    ends_free: int
    reserved: int
    steps: int
    reading_step: int
    _kinds_: ClassVar[dict[str, Any]] = {"name": KnotName, "verdict": KnotVerdict, "reason": KnotReason, "faults": KnotFaultBits, "next_verdict": KnotVerdict}
    _fields_ = [
        ("struct_size", c_uint32),
        ("name", c_int32),
        ("verdict", c_int32),
        ("reason", c_int32),
        ("throw_count", c_uint32),
        ("faults", c_uint32),
        ("next_verdict", c_int32),
        ("next_wraps", c_int32),
        ("next_handedness", c_int32),
        ("next_tool", c_uint32),
        ("loops", c_uint32),
        ("undone", c_uint32),
        ("crossings", c_uint32),
        ("certified", c_int32),
        ("signature", c_int32),
        ("signature_tristram", c_int32),
        ("determinant", c_int64),
        ("v2", c_int64),
        ("v3", c_int64),
        ("closures", c_uint32),
        ("closures_agreeing", c_uint32),
        ("ends_free", c_int32),
        ("reserved", c_uint32),
        ("steps", c_uint64),
        ("reading_step", c_uint64),
    ]


class KnotState(NamedTuple):
    """State of a detector. Fields as vbss_knot_state says."""
    name: KnotName
    verdict: KnotVerdict
    reason: KnotReason
    throw_count: int
    faults: KnotFaultBits
    next_verdict: KnotVerdict
    next_wraps: int
    next_handedness: int
    next_tool: int
    loops: int
    undone: int
    crossings: int
    certified: int
    signature: int
    signature_tristram: int
    determinant: int
    v2: int
    v3: int
    closures: int
    closures_agreeing: int
    ends_free: int
    steps: int
    reading_step: int


class vbss_knot_detector_statistics(ctypes.Structure):
    """Counts since creation or reset.

    readings: Finished readings of the topology.

    closures: Closed curves that were read.

    certified: Closed curves that were decomposed into twist regions.

    uncertain: Readings that ended uncertain.

    projections: Diagrams that were made.

    degenerate: Diagrams rejected because a crossing was not certain.

    overflows: Diagrams rejected because of too many crossings.

    removed: Vertices removed by proved moves.

    work: Operations used by readings.

    most_step_work: Largest number of operations in a step.

    most_work: Largest number of operations of a reading.

    revoked: Verdicts that were revoked."""
    struct_size: int
    reserved: int
    readings: int
    closures: int
    certified: int
    uncertain: int
    projections: int
    degenerate: int
    overflows: int
    removed: int
    work: int
    most_step_work: int
    most_work: int
    revoked: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("readings", c_uint64),
        ("closures", c_uint64),
        ("certified", c_uint64),
        ("uncertain", c_uint64),
        ("projections", c_uint64),
        ("degenerate", c_uint64),
        ("overflows", c_uint64),
        ("removed", c_uint64),
        ("work", c_uint64),
        ("most_step_work", c_uint64),
        ("most_work", c_uint64),
        ("revoked", c_uint64),
    ]


class KnotDetectorStatistics(NamedTuple):
    """Counts since creation or reset. Fields as vbss_knot_detector_statistics says."""
    readings: int
    closures: int
    certified: int
    uncertain: int
    projections: int
    degenerate: int
    overflows: int
    removed: int
    work: int
    most_step_work: int
    most_work: int
    revoked: int


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_knot_detector_config_init": (c_int32, (POINTER(vbss_knot_detector_config), c_uint32)),
    "vbss_knot_input_init": (c_int32, (POINTER(vbss_knot_input), c_uint32)),
    "vbss_knot_detector_create": (c_int32, (POINTER(vbss_context),
        POINTER(vbss_knot_detector_config), POINTER(POINTER(vbss_knot_detector)))),
    "vbss_knot_detector_destroy": (c_int32, (POINTER(vbss_knot_detector),)),
    "vbss_knot_detector_step": (c_int32, (POINTER(vbss_knot_detector), POINTER(vbss_knot_input))),
    "vbss_knot_detector_judge": (c_int32, (POINTER(vbss_knot_detector), POINTER(vbss_knot_input))),
    "vbss_knot_detector_reset": (c_int32, (POINTER(vbss_knot_detector),)),
    "vbss_knot_detector_get_state": (c_int32, (POINTER(vbss_knot_detector),
        POINTER(vbss_knot_state), c_uint32)),
    "vbss_knot_detector_get_throw": (c_int32, (POINTER(vbss_knot_detector), c_uint32,
        POINTER(vbss_knot_throw), c_uint32)),
    "vbss_knot_detector_get_winding": (c_int32, (POINTER(vbss_knot_detector), c_uint32,
        POINTER(vbss_knot_winding), c_uint32)),
    "vbss_knot_detector_get_notation": (c_int32, (POINTER(vbss_knot_detector), POINTER(c_char),
        c_uint64)),
    "vbss_knot_detector_get_view": (c_int32, (POINTER(vbss_knot_detector), c_int32,
        POINTER(vbss_view), c_uint32)),
    "vbss_knot_detector_get_statistics": (c_int32, (POINTER(vbss_knot_detector),
        POINTER(vbss_knot_detector_statistics), c_uint32)),
    "vbss_knot_detector_save": (c_int32, (POINTER(vbss_knot_detector), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_knot_detector_restore": (c_int32, (POINTER(vbss_knot_detector), POINTER(c_uint8),
        c_uint64)),
    "vbss_knot_detector_get_hash": (c_int32, (POINTER(vbss_knot_detector), POINTER(c_uint64))),
}
