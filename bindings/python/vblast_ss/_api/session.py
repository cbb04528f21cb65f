"""session.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_double, c_int32, c_uint32, c_uint64, c_uint8, c_void_p
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .device import vbss_device
from .knot import KnotFaultBits, vbss_knot_detector
from .metrics import MetricsRelation, MetricsTool, vbss_metrics
from .record import vbss_record, vbss_replay
from .scene import vbss_scene


class SessionPhase(IntEnum):
    """The constants of vbss_session_phase, in the order of the task."""
    IDLE = 0
    """No step was made: the needle has not appeared."""
    LOADING = 1
    """The needle is to be taken."""
    APPROACH = 2
    """A tool has it; on to the first mark."""
    IN_DRAIN = 3
    """Its tip is in; on to the second mark."""
    PULL_THROUGH = 4
    """It is out again: thread is drawn to the tail's length."""
    THROW_1 = 5
    """The first throw is tied and seated."""
    TRANSFER_1 = 6
    """The needle is to change hands."""
    THROW_2 = 7
    """The second throw."""
    TRANSFER_2 = 8
    """The needle is to change hands."""
    THROW_3 = 9
    """The third throw."""
    CUT = 10
    """Both tails are to be cut."""
    DONE = 11
    """They are. For good."""
    FAILED = 12
    """See vbss_session_failure. For good."""


class SessionStage(IntEnum):
    """The constants of vbss_session_stage."""
    NONE = 0
    """Nothing of it is there."""
    WRAP = 1
    """The thread winds round a tool,"""
    GRASPED = 2
    """and a tool holds its tail near the end;"""
    PASSED = 3
    """it is tied if the tools withdraw."""
    SEATING = 4
    """It is tied, and to be pulled down."""
    SEATED = 5
    """It lies on the tissue."""


class SessionFailure(IntEnum):
    """The constants of vbss_session_failure."""
    NONE = 0
    """It has not."""
    TIMEOUT = 1
    """The time is up."""
    AVULSED = 2
    """The drain was torn off its anchors."""
    CUT_EARLY = 3
    """The thread was cut before the third throw was seated,"""
    CUT_KNOT = 4
    """or where it goes through the tissue or the knot."""
    BROKEN = 5
    """It bore more than it bears."""
    LOST = 6
    """Thread, needle, drain or a tool was removed from the scene."""


class SessionEventKind(IntEnum):
    """The constants of vbss_session_event_kind. Those that say "undone" come again with `undone` 1
    when it is no longer so."""
    APPEARED = 1
    """The needle has appeared: the clock starts."""
    PHASE = 2
    """The phase `number` begins; undone 1: it is an earlier one than before."""
    TAKEN = 3
    """`tool` holds the needle. Undone: it does no longer."""
    DROPPED = 4
    """Before the stitch: nobody holds the needle, and it is in no wall."""
    PUNCTURE = 5
    """Mark `number` (0: in, 1: out) was pierced, `amount` mm off; `position` is of the hole.
    Undone: the needle, or in the end the thread, has left the hole."""
    STRAY = 6
    """A wall was pierced elsewhere: hole `number`. Undone."""
    THREADED = 7
    """The swage has gone through hole `number` (0, 1), the thread follows. Undone: it has come
    back."""
    TAIL = 8
    """The tail is `amount` m long, as it should. Undone."""
    STAGE = 9
    """Throw `number` (0, 1, ...) is at `stage`, whichever way."""
    THROW = 10
    """Throw `number` is tied: `wraps`, `handedness`, `relation`; told again when these are known
    better. Undone: it came undone."""
    SEATED = 11
    """Throw `number` is seated; the slit gapes `amount` m. Undone."""
    TRANSFER = 12
    """After throw `number` `tool` has taken over the needle."""
    TRANSFER_MISSED = 13
    """Throw `number` is tied, but the needle has not changed hands since the one before. Undone:
    with the throw."""
    FAULT = 14
    """The knot has the fault `number`, a VBSS_KNOT_FAULT_ bit, for `throw_dwell`; HITCH (a throw
    has capsized): for 20 times `throw_dwell`, because its measure swings while a throw is drawn
    tight. Undone: after the same time."""
    CUT = 15
    """Tail `number` (0: the short one, 1: the needle's) was cut; `amount` m are left of it."""
    DONE = 16
    """The task is complete."""
    FAILED = 17
    """It has failed: `number` is a vbss_session_failure."""
    TIME_LOST = 18
    """More than `lost_share` of the time is lost: `amount` s of it, since the needle appeared.
    Times and score do not compare with those of other trials. Undone: it is less than half of
    that share again."""


class SessionGap(IntEnum):
    """The constants of vbss_session_gap."""
    LIPS = 0
    """The lips, which are as high as the wall: vbss_drain_gap.opening. A wall that rises is shut
    when it meets the other one's face. Drains of method PAPER: EDGES."""
    EDGES = 1
    """The edges in the middle of the wall: vbss_drain_gap.gap, the paper's measure."""


class vbss_session(ctypes.Structure):
    """A session."""


class vbss_session_event(ctypes.Structure):
    """Something that happened.

    kind: What.

    tool: With which tool; VBSS_METRICS_NO_TOOL: none, or not known.

    number: As the kind says.

    undone: 1: it is no longer so.

    stage: STAGE: which.

    wraps: THROW: 1 single, 2 double, ...

    handedness: THROW: +1 right-handed, -1 left-handed.

    relation: THROW: to the throw before.

    phase: The phase after the step in which it happened.

    ordinal: Of the event, from 0 on.

    step: Of the session, from 1 on.

    time: Since the needle appeared, s, on the clock of the hands.

    position: Of the tool's tip, or where the kind says, m.

    force: On the tool's hand, N; zero without a tool.

    amount: As the kind says."""
    struct_size: int
    kind: int
    tool: int
    number: int
    undone: int
    stage: int
    wraps: int
    handedness: int
    relation: int
    phase: int
    ordinal: int
    step: int
    time: float
    position: Any
    force: Any
    amount: float
    _kinds_: ClassVar[dict[str, Any]] = {"kind": SessionEventKind, "tool": MetricsTool, "stage": SessionStage, "relation": MetricsRelation, "phase": SessionPhase}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("tool", c_int32),
        ("number", c_uint32),
        ("undone", c_uint32),
        ("stage", c_int32),
        ("wraps", c_int32),
        ("handedness", c_int32),
        ("relation", c_int32),
        ("phase", c_int32),
        ("ordinal", c_uint64),
        ("step", c_uint64),
        ("time", c_double),
        ("position", c_double * 3),
        ("force", c_double * 3),
        ("amount", c_double),
    ]


class SessionEvent(NamedTuple):
    """Something that happened. Fields as vbss_session_event says."""
    kind: SessionEventKind
    tool: MetricsTool
    number: int
    undone: int
    stage: SessionStage
    wraps: int
    handedness: int
    relation: MetricsRelation
    phase: SessionPhase
    ordinal: int
    step: int
    time: float
    position: tuple[float, ...]
    force: tuple[float, ...]
    amount: float


# A function of the host that hears of each event, at the end of the step in which it happened. It
# may look at everything and must not change anything of the context.
vbss_session_event_fn = CFUNCTYPE(None, c_void_p, POINTER(vbss_session_event))


class vbss_session_config(ctypes.Structure):
    """How to make a session. Fill it with vbss_session_config_init, then set the numbers of the
    bodies.

    thread: Numbers in the scene. The thread's node 0 is at the swage, its last node the end of
    the tail.

    needle: The same of the needle,

    drain: the drain,

    tools: the left and the right grasper;

    shears: a third one that cuts. 0 (default): a tool is exchanged.

    event_capacity: Most events that are kept, the newest; 8 to 65536; default 1024.

    knot_interval: The knot detector looks every so many steps, 1 to 1000; default 4. Its
    work_limit bounds the work of a look.

    hash_interval: With a record: the task is hashed in the log every so many steps, and after
    those with events, for replays to compare; 1 to 1e9; default 100.

    devices: Of the left and the right hand; NULL (default): the host moves that tool.

    knots: NULL (default): throws are not seen. It has room for the thread and all tools.

    metrics: NULL (default): nothing is measured.

    record: Of the scene; NULL (default): nothing is written down.

    replay: In the place of devices and record; has begun with the scene. NULL (default).

    listen: NULL (default): nobody.

    user: Handed to it; may be NULL.

    time_limit: From the needle's appearing on, s, 1e-3 to 1e6; default 600.

    dwell: A fact changes after it has differed for this time, s, 0 to 10; default 0.05.

    throw_dwell: The same time for throws and faults of the knot, s, 0 to 10; default 0.1. A
    half hitch has 20 times that.

    tail_low: Shortest tail, m, 0 to 1; default 15e-3;

    tail_high: longest tail, tail_low to 1; default 20e-3.

    tail_margin: So far beyond these it is not as it should any more, m, 0 to 1; default 1e-3.

    tail_reach: The tail is grasped within this of its end, m, 0 to 1; default 0.01.

    seat_gap: A throw is seated when the slit gapes no more than this (edges that have crossed
    do not), m, 0 to 1; default 0.5e-3,

    seat_release: no longer from this on, seat_gap to 1; default 1e-3.

    seat_force: Tension of both limbs that seats it, N, 0 to 1e3; default 0.5.

    avulsed_share: Share of the anchors torn from which the drain is off, 0 to 1; default 0.5.

    break_force: Tension at which the thread breaks, N, 0 to 1e6; default 0: it does not.

    gap_measure: What seats throws and is told as gap, to status, events and metrics; default
    LIPS.

    lost_share: Share of the time, 0 to 1, above which lost time is an event and sets
    `is_lossy`; default 0.02. A trial shorter than 1 s counts as 1 s."""
    struct_size: int
    thread: int
    needle: int
    drain: int
    tools: Any
    shears: int
    event_capacity: int
    knot_interval: int
    hash_interval: int
    devices: Any
    knots: Any
    metrics: Any
    record: Any
    replay: Any
    listen: Any
    user: Any
    time_limit: float
    dwell: float
    throw_dwell: float
    tail_low: float
    tail_high: float
    tail_margin: float
    tail_reach: float
    seat_gap: float
    seat_release: float
    seat_force: float
    avulsed_share: float
    break_force: float
    gap_measure: int
    reserved: int
    lost_share: float
    _kinds_: ClassVar[dict[str, Any]] = {"gap_measure": SessionGap}
    _fields_ = [
        ("struct_size", c_uint32),
        ("thread", c_uint32),
        ("needle", c_uint32),
        ("drain", c_uint32),
        ("tools", c_uint32 * 2),
        ("shears", c_uint32),
        ("event_capacity", c_uint32),
        ("knot_interval", c_uint32),
        ("hash_interval", c_uint32),
        ("devices", POINTER(vbss_device) * 2),
        ("knots", POINTER(vbss_knot_detector)),
        ("metrics", POINTER(vbss_metrics)),
        ("record", POINTER(vbss_record)),
        ("replay", POINTER(vbss_replay)),
        ("listen", vbss_session_event_fn),
        ("user", c_void_p),
        ("time_limit", c_double),
        ("dwell", c_double),
        ("throw_dwell", c_double),
        ("tail_low", c_double),
        ("tail_high", c_double),
        ("tail_margin", c_double),
        ("tail_reach", c_double),
        ("seat_gap", c_double),
        ("seat_release", c_double),
        ("seat_force", c_double),
        ("avulsed_share", c_double),
        ("break_force", c_double),
        ("gap_measure", c_int32),
        ("reserved", c_uint32),
        ("lost_share", c_double),
    ]


class vbss_session_status(ctypes.Structure):
    """How far a session is.

    phase: How far the task is.

    stage: Of the throw that is under way; NONE if none is.

    failure: Why it has failed.

    holder: Who holds the needle, the first of two; VBSS_METRICS_NO_TOOL: nobody.

    punctured: Bits: 1, 2: the hole in, the hole out is there,

    threaded: and the thread goes through it.

    tail_set: 1: the tail is as it should.

    throws: Throws that are tied,

    seated: of them seated, counted from the tissue.

    transfers: Transfers between them that were made, at most two.

    cut: Bits: 1 the short tail, 2 the needle's.

    faults: Of the knot: VBSS_KNOT_FAULT_ bits, as last reported by events.

    metrics_lost: Events for which the metrics had no room.

    steps: Steps so far.

    first_event: The oldest event that is kept; so many are lost.

    event_count: Events so far.

    time: Since the needle appeared, until the end or now, s, on the clock of the hands. It
    includes `time_lost`.

    tail: Length of the short tail, from the hole, m; 0 without.

    gap: Of the slit's middle, as `gap_measure` says, m.

    tension: Largest of the short limb, of the needle's, N.

    deviation_mm: Of the holes from the marks.

    time_lost: Part of `time` that the scene has left out, s: paused steps
    (vbss_scene_statistics::time_paused) and truncated substeps (VBSS_EVENT_CLAMPED), from the
    second step on.

    time_simulated: `time` without `time_lost`, s. Up to two steps of it may still wait
    (vbss_scene_statistics::behind).

    is_lossy: 1: more than `lost_share` of the time is lost, with hysteresis."""
    struct_size: int
    phase: int
    stage: int
    failure: int
    holder: int
    punctured: int
    threaded: int
    tail_set: int
    throws: int
    seated: int
    transfers: int
    cut: int
    faults: int
    metrics_lost: int
    steps: int
    first_event: int
    event_count: int
    time: float
    tail: float
    gap: float
    tension: Any
    deviation_mm: Any
    time_lost: float
    time_simulated: float
    is_lossy: int
    reserved: int
    _kinds_: ClassVar[dict[str, Any]] = {"phase": SessionPhase, "stage": SessionStage, "failure": SessionFailure, "holder": MetricsTool, "faults": KnotFaultBits}
    _fields_ = [
        ("struct_size", c_uint32),
        ("phase", c_int32),
        ("stage", c_int32),
        ("failure", c_int32),
        ("holder", c_int32),
        ("punctured", c_uint32),
        ("threaded", c_uint32),
        ("tail_set", c_uint32),
        ("throws", c_uint32),
        ("seated", c_uint32),
        ("transfers", c_uint32),
        ("cut", c_uint32),
        ("faults", c_uint32),
        ("metrics_lost", c_uint32),
        ("steps", c_uint64),
        ("first_event", c_uint64),
        ("event_count", c_uint64),
        ("time", c_double),
        ("tail", c_double),
        ("gap", c_double),
        ("tension", c_double * 2),
        ("deviation_mm", c_double * 2),
        ("time_lost", c_double),
        ("time_simulated", c_double),
        ("is_lossy", c_uint32),
        ("reserved", c_uint32),
    ]


class SessionStatus(NamedTuple):
    """How far a session is. Fields as vbss_session_status says."""
    phase: SessionPhase
    stage: SessionStage
    failure: SessionFailure
    holder: MetricsTool
    punctured: int
    threaded: int
    tail_set: int
    throws: int
    seated: int
    transfers: int
    cut: int
    faults: KnotFaultBits
    metrics_lost: int
    steps: int
    first_event: int
    event_count: int
    time: float
    tail: float
    gap: float
    tension: tuple[float, ...]
    deviation_mm: tuple[float, ...]
    time_lost: float
    time_simulated: float
    is_lossy: int


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_session_config_init": (c_int32, (POINTER(vbss_session_config), c_uint32)),
    "vbss_session_create": (c_int32, (POINTER(vbss_scene), POINTER(vbss_session_config),
        POINTER(POINTER(vbss_session)))),
    "vbss_session_destroy": (c_int32, (POINTER(vbss_session),)),
    "vbss_session_step": (c_int32, (POINTER(vbss_session), c_double, c_double)),
    "vbss_session_seek": (c_int32, (POINTER(vbss_session), c_uint64)),
    "vbss_session_set_record": (c_int32, (POINTER(vbss_session), POINTER(vbss_record))),
    "vbss_session_get_status": (c_int32, (POINTER(vbss_session), POINTER(vbss_session_status),
        c_uint32)),
    "vbss_session_get_event": (c_int32, (POINTER(vbss_session), c_uint64,
        POINTER(vbss_session_event), c_uint32)),
    "vbss_session_save": (c_int32, (POINTER(vbss_session), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_session_restore": (c_int32, (POINTER(vbss_session), POINTER(c_uint8), c_uint64)),
    "vbss_session_get_hash": (c_int32, (POINTER(vbss_session), POINTER(c_uint64))),
}
