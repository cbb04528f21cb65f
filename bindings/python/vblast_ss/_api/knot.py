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
    """Winding, then the topology of the closed thread."""
    PROJECTION = 1
    """Loops in a projection, as the paper does."""


class KnotHeld(IntEnum):
    """The constants of vbss_knot_held."""
    NOTHING = 0
    """Empty jaws."""
    THREAD = 1
    """The thread, at a place."""
    NEEDLE = 2
    """The needle, at the last point of the polyline."""


class KnotVerdict(IntEnum):
    """The constants of vbss_knot_verdict."""
    NONE = 0
    """There is none."""
    WRAPPING = 1
    """The thread winds round a tool."""
    PASSED = 2
    """Tied if the tools withdraw with what they hold."""
    FORMED = 3
    """The ends are through; invariants agree."""
    CERTIFIED = 4
    """Its type is proved, its ends clear, its order known."""
    UNCERTAIN = 5
    """Cannot be told; `reason` says why."""


class KnotReason(IntEnum):
    """The constants of vbss_knot_reason."""
    NONE = 0
    """It is not."""
    ENDS = 1
    """Closures differ: an end lies inside the knot."""
    DEGENERATE = 2
    """The thread touches itself in every projection."""
    CAPACITY = 3
    """The diagram has more crossings than the detector has room for, or is too wide for the Jones
    polynomial that must confirm the result."""
    CONFLICT = 4
    """Twist regions and invariants differ."""


class KnotName(IntEnum):
    """The constants of vbss_knot_name. "=": the next throw has the other handedness; "x": the
    same."""
    NONE = 0
    """No knot."""
    SINGLE = 1
    """One throw of one wrap: 3_1."""
    DOUBLE = 2
    """One of two, the surgeon's first: 5_1."""
    TRIPLE = 3
    """One of three: 7_1."""
    SQUARE = 4
    """1=1"""
    GRANNY = 5
    """1x1"""
    SURGEONS = 6
    """2=1"""
    SURGEONS_GRANNY = 7
    """2x1"""
    FLS = 8
    """2=1=1"""
    STACK = 9
    """Other throws; see vbss_knot_detector_get_notation."""
    OTHER = 10
    """A knot that is no stack of throws."""


class KnotFaultBits(IntFlag):
    """What keeps a knot from being the FLS knot 2=1=1: bits."""
    FIRST = 1
    """The first throw has not two wraps."""
    LATER = 2
    """A later throw has not one wrap."""
    FEW = 4
    """Fewer than three throws."""
    MANY = 8
    """More than three."""
    GRANNY = 16
    """A throw of the same handedness as the one before."""
    STRAY = 32
    """A knot in one limb alone."""
    HITCH = 64
    """A throw turned into a half hitch, which slides."""
    ORDER = 128
    """The order of the throws is not known."""
    TYPE = 256
    """Not a stack of throws."""
    UNCERTAIN = 512
    """The reading is uncertain."""


class KnotThrowBits(IntFlag):
    """Flags of a throw: bits."""
    LOCATED = 1
    """Its places on the limbs are known."""
    ORDERED = 2
    """Its position in the stack is known: sub-chains show it, or (in vbss_knot_detector_step) the
    throws were in this order when they were read before, and at most one came."""
    GRANNY = 4
    """Same handedness as the throw before."""
    STRAY = 8
    """In one limb alone: not round the other."""
    HITCH = 16
    """|slip| is at least slip_limit."""
    REVOCABLE = 32
    """Its tail is shorter than tail_least, or undone if tools withdraw."""


class KnotEvent(IntEnum):
    """The constants of vbss_knot_event. In the view an event is followed by three numbers, told
    here."""
    WRAPPED = 1
    """Thread winds round a tool: tool, 1 + (turns > 0), 0."""
    UNWRAPPED = 2
    """It does no longer: tool, 0, 0."""
    WRONG_WAY = 3
    """It winds towards the handle: tool, 0, 0."""
    PASSED = 4
    """A throw is tied if the tools withdraw: tool, wraps, 1 + (right-handed)."""
    FORMED = 5
    """A throw: its number from 0, wraps, 1 + (right-handed)."""
    CERTIFIED = 6
    """The same."""
    REVOKED = 7
    """A throw is gone or no longer sure: number, wraps, 1 + (right-handed)."""
    STRAY = 8
    """A knot in one limb: number, wraps, 1 + (right-handed)."""
    UNCERTAIN = 9
    """The reading is uncertain: vbss_knot_reason, 0, 0."""
    READ = 10
    """A reading of the topology ended: throws, name, verdict."""
    LOST = 11
    """Events beyond the capacity: how many, 0, 0."""


class KnotField(IntEnum):
    """The constants of vbss_knot_field."""
    EVENTS = 0
    """x 4 uint32_t: vbss_knot_event and its numbers, of the last step."""
    LOOPS = 1
    """PROJECTION, x 4 uint32_t: tool, the two segments of the intersecting pair, 1 if the tool is
    inside; all loops of the last step."""


class vbss_knot_detector(ctypes.Structure):
    """A knot detector."""


class vbss_knot_config(ctypes.Structure):
    """How to make a detector. Fill it with vbss_knot_config_init, then change what you need.

    method: Default VBSS_KNOT_TOPOLOGY.

    point_capacity: Most points of the polyline, 2 to 8192; default 1024.

    tool_capacity: Most tools, 0 to 16; default 4.

    crossing_capacity: Most crossings that a diagram may have before it is simplified, 8 to
    2048; default 512. A quarter of them may be left.

    direction_limit: Directions of projection that are tried, 1 to 64; default 6.

    closure_count: Directions in which the ends are closed besides straight outward, 0 to 16;
    default 8.

    closure_tolerance: Of these the most that may contradict the outward closure, 0 to 16;
    default 2. With more an end lies inside the knot, and the verdict is uncertain.

    work_limit: TOPOLOGY: operations (about a nanosecond each) that a step spends on it at most,
    but for the last indivisible piece, 100 to 1e9; default 8000.

    interval: TOPOLOGY: a new reading of the topology begins this many steps after the last one
    began, if that has ended; 0: at events only; default 20.

    event_capacity: Most events of a step that are kept, 8 to 4096; default 64.

    tail_reach: The thread is held near its end if what hangs beyond the jaws is shorter, m, 0
    to 1; default 0.03. Longer, it is a bight.

    tail_least: A throw can be undone by its tail slipping back if that is shorter, m, 0 to 1;
    default 0.003.

    wrap_turns: Signed turns about a tool from which the thread is wrapped round it, 0.1 to 2;
    default 0.75. It ends a quarter of a turn below.

    slip_limit: |slip measure| of a throw from which it is a half hitch, 0 to 1; default 0.6.

    plane_offset: PROJECTION: where the plane crosses the tool's axis, m from the tip towards
    the handle, -1 to 1; default -0.002, ahead of the tip.

    seed: PROJECTION: of the directions of its rays; default 1."""
    struct_size: int
    method: int
    point_capacity: int
    tool_capacity: int
    crossing_capacity: int
    direction_limit: int
    closure_count: int
    closure_tolerance: int
    work_limit: int
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
        ("work_limit", c_uint32),
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
    """One tool: capsules between successive points of its axis.

    point_count: Of the axis, 2 to 4.

    held: What its jaws hold.

    axis: From the handle (or trocar) to the tip, m; successive points differ.

    radius: Of each capsule, m, 0 to 1.

    held_place: THREAD: place on the polyline where the jaws are; otherwise ignored."""
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
    """What a detector is shown. Fill it with vbss_knot_input_init, then change what you need. All
    of it is copied.

    point_count: 2 to point_capacity; the default 0 is refused.

    points: x, y, z of each, m, each at most 1e3; from the tail's end on.

    stride_bytes: From one point to the next, at least 24; default 24.

    tool_count: 0 (default) to tool_capacity.

    tools: tool_count of them; may be NULL when there are none.

    hole_count: 0 (default): it is not known where the thread goes through tissue; 1: at one
    point; 2: in at the first, out at the second. Without tissue nothing is stray, and throws
    are told in the order in which they nest.

    reversed: 1: the points are given from the long limb's end on; places too count from there.
    Default 0.

    holes: Where the holes are, m.

    hole_places: Their places on the polyline; negative (default): the nearest to `holes`.

    away: Away from the knot into the tissue, of any length; zero (default): from the middle of
    the thread to that of the holes.

    may_have_passed: 1: the thread may have passed through itself or a tool since the last step
    (a guard has failed, or there is none): read the topology anew. Default 0."""
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
    """One throw of a knot, counted from the tissue outward.

    verdict: FORMED or CERTIFIED.

    wraps: k, from 1 on.

    handedness: +1 right-handed, -1 left-handed.

    flags: VBSS_KNOT_THROW_ bits.

    tail_places: LOCATED: from where to where it lies on the tail limb, ascending.

    long_places: The same on the long limb.

    slip: LOCATED: (kT - kL) / (kT + kL) of the total turning of both limbs inside the throw: 0
    a flat half knot, +1 the tail hitched round a straight long limb, -1 the reverse.

    tail_length: LOCATED: of thread between the throw and the tail's end, m.

    formed_step: Steps of the detector when it was first seen.

    reading_step: Step of the input in which it was last confirmed."""
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
    """One throw of a knot, counted from the tissue outward. Fields as vbss_knot_throw says."""
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
    """How the thread winds about one tool. Updated in every step, by both methods.

    wrapped: 1: |turns| of the longest run reached wrap_turns, and is not a quarter below.

    turns: Signed turns about the axis looking from the tip to the handle, of all thread beside
    the tool, walking from the tail's to the long limb's end; what is beyond tip or handle does
    not count.

    run_turns: Of the run that winds most: thread beside the tool without a gap.

    run_places: Where it begins and ends.

    run_heights: How far from the tip that is along the axis, m.

    sense: Along the tool while it winds, from the tissue's end of the run to the other: +1
    towards the tip, as a throw needs; -1 towards the handle, which ties nothing; 0 neither by a
    thread's width, or not wrapped.

    runs: How many runs there are."""
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
    """How the thread winds about one tool. Updated in every step, by both methods. Fields as
    vbss_knot_winding says."""
    wrapped: int
    turns: float
    run_turns: float
    run_places: tuple[float, ...]
    run_heights: tuple[float, ...]
    sense: int
    runs: int


class vbss_knot_state(ctypes.Structure):
    """What a detector knows.

    name: Of what is tied.

    verdict: Of the least certain throw; UNCERTAIN when the reading is; NONE: no knot.

    reason: Why it is uncertain.

    throw_count: Throws that are tied, at most 8.

    faults: Against the FLS knot: VBSS_KNOT_FAULT_ bits.

    next_verdict: Of a throw that is being tied: NONE, WRAPPING or PASSED.

    next_wraps: Its wraps if the tools withdrew now; 0: it would tie nothing.

    next_handedness: +1, -1; 0 when there is none.

    next_tool: The tool that the thread winds round, from 0.

    loops: PROJECTION: loops round a tool that one segment crosses.

    undone: PROJECTION: crossings of loops that tie nothing.

    crossings: Of the simplest diagram found.

    certified: 1: it was taken apart into twist regions.

    signature: sigma; right-handed 3_1: -2.

    signature_tristram: Levine-Tristram at 0.27 pi.

    determinant: |Delta(-1)|.

    v2: Vassiliev invariant of degree 2 (Conway's z^2).

    v3: Of degree 3; right-handed 3_1: 1.

    closures: Other closures that were compared.

    closures_agreeing: Of them those that gave the same.

    ends_free: 1: both ends are outermost, so that all closures agree.

    steps: Steps and judgements so far.

    reading_step: The one whose input the last reading is of; 0: there was none."""
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
    """What a detector knows. Fields as vbss_knot_state says."""
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


class vbss_knot_statistics(ctypes.Structure):
    """Figures since creation.

    readings: Readings of the topology that ended.

    closures: Closed curves that were read.

    certified: Of them taken apart into twist regions.

    uncertain: Readings that ended uncertain.

    projections: Diagrams made.

    degenerate: Of them thrown away: a crossing was not certain.

    overflows: Of them thrown away: too many crossings.

    removed: Vertices removed by proved moves.

    work: Operations spent on readings.

    most_step_work: In the step that spent most.

    most_work: In the reading that took most.

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


class KnotStatistics(NamedTuple):
    """Figures since creation. Fields as vbss_knot_statistics says."""
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
    "vbss_knot_config_init": (c_int32, (POINTER(vbss_knot_config), c_uint32)),
    "vbss_knot_input_init": (c_int32, (POINTER(vbss_knot_input), c_uint32)),
    "vbss_knot_detector_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_knot_config),
        POINTER(POINTER(vbss_knot_detector)))),
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
        POINTER(vbss_knot_statistics), c_uint32)),
    "vbss_knot_detector_save": (c_int32, (POINTER(vbss_knot_detector), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_knot_detector_restore": (c_int32, (POINTER(vbss_knot_detector), POINTER(c_uint8),
        c_uint64)),
    "vbss_knot_detector_get_hash": (c_int32, (POINTER(vbss_knot_detector), POINTER(c_uint64))),
}
