"""session.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_double, c_int32, c_uint32, c_uint64, c_uint8, c_void_p
from enum import IntEnum, IntFlag
from typing import Any, ClassVar, NamedTuple

from .device import vbss_device
from .knot import KnotFaultBits, vbss_knot_detector
from .metrics import MetricsRelation, MetricsTool, vbss_metrics
from .record import vbss_record, vbss_replay
from .scene import vbss_scene


class SessionPhase(IntEnum):
    """The constants of vbss_session_phase, in the order of the task."""
    IDLE = 0
    """No step was made; the needle has not appeared."""
    LOADING = 1
    """A tool must take the needle."""
    APPROACH = 2
    """A tool holds the needle and approaches the first mark."""
    IN_DRAIN = 3
    """The needle's tip is in the drain, on its way to the second mark."""
    PULL_THROUGH = 4
    """The tip is out again; the thread is drawn until the tail has its length."""
    THROW_1 = 5
    """The first throw must be tied and seated."""
    TRANSFER_1 = 6
    """The needle must change hands after the first throw."""
    THROW_2 = 7
    """The second throw must be tied and seated."""
    TRANSFER_2 = 8
    """The needle must change hands after the second throw."""
    THROW_3 = 9
    """The third throw must be tied and seated."""
    CUT = 10
    """Both tails must be cut."""
    DONE = 11
    """Both tails are cut; final."""
    FAILED = 12
    """The task has failed; final. See vbss_session_failure."""


class SessionStage(IntEnum):
    """The constants of vbss_session_stage."""
    NONE = 0
    """The throw has not begun."""
    WRAP = 1
    """The thread winds round a tool."""
    GRASPED = 2
    """The thread winds round a tool that holds the tail near its end."""
    PASSED = 3
    """The throw is tied if the tools withdraw."""
    SEATING = 4
    """The throw is tied and must be pulled down."""
    SEATED = 5
    """The throw lies on the tissue."""


class SessionFailure(IntEnum):
    """The constants of vbss_session_failure."""
    NONE = 0
    """The task has not failed."""
    TIMEOUT = 1
    """The time limit has passed."""
    AVULSED = 2
    """The drain was torn off its anchors."""
    CUT_EARLY = 3
    """The thread was cut before the third throw was seated."""
    CUT_KNOT = 4
    """The thread was cut inside the knot, or between the two holes."""
    BROKEN = 5
    """The thread broke: its tension exceeded `break_force`."""
    LOST = 6
    """Thread, needle, drain or a tool was removed from the scene."""


class SessionEventKind(IntEnum):
    """The constants of vbss_session_event_kind. A comment that says "Undone" describes the event
    with `undone` 1, which reports that the fact has ceased."""
    APPEARED = 1
    """The needle has appeared, and the clock starts."""
    PHASE = 2
    """The phase `number` begins. Undone: the task has fallen back to this phase."""
    TAKEN = 3
    """`tool` holds the needle. Undone: it has released the needle."""
    DROPPED = 4
    """Before the stitch: no tool holds the needle, and it is in no wall."""
    PUNCTURE = 5
    """Mark `number` (0: in, 1: out) was pierced, `amount` mm off; `position` is that of the hole.
    Undone: the needle has left the hole, or the thread's end has slipped through it."""
    STRAY = 6
    """A wall was pierced elsewhere, as hole `number`. Undone: the hole is empty again."""
    THREADED = 7
    """The swage has passed through hole `number` (0, 1), and the thread follows. Undone: it has
    come back."""
    TAIL = 8
    """The tail has a permitted length, `amount` m. Undone: it no longer has."""
    STAGE = 9
    """Throw `number` (0, 1, ...) has reached `stage`, forwards or backwards."""
    THROW = 10
    """Throw `number` is tied, with `wraps`, `handedness` and `relation`; a repeated event corrects
    them. Undone: the throw came undone."""
    SEATED = 11
    """Throw `number` is seated; the slit gapes `amount` m. Undone: it is no longer seated."""
    TRANSFER = 12
    """`tool` has taken over the needle after throw `number`."""
    TRANSFER_MISSED = 13
    """Throw `number` is tied, but the needle has not changed hands since the throw before. Undone:
    the throw came undone."""
    FAULT = 14
    """The knot has had the fault `number`, a VBSS_KNOT_FAULT_ bit, for `throw_dwell`. HITCH (a
    throw has capsized) takes 20 times `throw_dwell`, because its measure oscillates while a
    throw is drawn tight. Undone: the fault has been absent for the same time."""
    CUT = 15
    """Tail `number` (0: the short one, 1: the needle's) was cut; its remaining length is `amount`
    m."""
    DONE = 16
    """The task is complete."""
    FAILED = 17
    """The task has failed; `number` is a vbss_session_failure."""
    TIME_LOST = 18
    """More than `lost_share` of the time since the needle's appearance is lost: `amount` s. Times
    and score do not compare with those of other trials. Undone: the share has fallen below half
    of `lost_share`."""
    GOAL = 19
    """Only with `coaching`: the goal of the hand `tool` is now `number`, a VBSS_SESSION_GOAL_
    constant (session_coaching.h)."""
    MISTAKE = 20
    """Only with `coaching`: the mistake `number`, a VBSS_SESSION_MISTAKE_ constant, is made.
    Undone: it is mended or past."""
    AID = 21
    """The aid `number`, a VBSS_SESSION_AID_ bit, was switched on: the task is assisted and gets no
    score. `amount` is 1 for the first time, then 0. Undone: the aid was switched off."""
    EXERCISE = 22
    """Only with `exercise`: the exercise `number` has ended; `amount` is 1 if it is passed, and 0
    if it is not (session_exercise.h)."""


class SessionExercise(IntEnum):
    """The constants of vbss_session_exercise. session_exercise.h has their starts, goals and
    measures."""
    NONE = 0
    """No exercise: the whole task."""
    TAKE_NEEDLE = 1
    """The needle is taken up."""
    PASS_MARK = 2
    """The needle is pushed through the wall at a mark."""
    SINGLE_THROW = 3
    """A throw of one wrap is tied and seated."""
    DOUBLE_THROW = 4
    """A throw of two wraps is tied and seated."""
    SQUARE_THROW = 5
    """A throw that is square to the first one is tied and seated."""
    CUT = 6
    """Both tails are cut."""
    COUNT = 7
    """One more than the largest exercise."""


class SessionAidBits(IntFlag):
    """Bits of the aids (session_assistance.h). "Along the direction" means: by the component of
    the hand's movement along vbss_session_assistance.direction."""
    ARC = 1
    """A hand that holds the needle turns it about the centre of its arc and moves it in no other
    way. Movement along the direction drives the tip forward by the same length of arc. Turns of
    the hand are ignored. Acts before the first throw."""
    WIND = 2
    """A hand that holds the needle takes the needle's end with the thread round the jaws of the
    other tool. Movement along the direction winds in the sense that the next throw needs. The
    radius, between 8 mm and 45 mm, is 0.92 of the one at which the thread is taut, or stays if
    there is no stitch. With a coach it allows for the turns on the jaws. Turns of the hand turn
    the tool as without the aid. Acts in the phases of throws."""
    SNAP_ROLL = 4
    """The roll of each tool about its shaft is the nearest multiple of `roll_step` from the roll
    in which the jaws open along the slit."""
    SLOW_MOTION = 8
    """Each step of the session is `time_scale` times as long as the host asks for."""
    HOVER = 16
    """A hand that sinks slower than `sink_speed` leaves its tool at the same height, for arms
    without support."""
    AUTO_HOLD = 32
    """The tool and the jaws of a hand that has moved less than `hold_distance` for `hold_time`
    stay where they are, until the hand leaves this distance."""
    FOLLOW = 64
    """The tool of a hand that has rested for 0.1 s follows the tool of the other hand while that
    one moves, for inputs that move one hand at a time. It needs a coach and acts by the coach's
    goal, while the thread is held at both ends. TAKE_TAIL, and DRAW_TAIL after the first throw,
    with turns on the jaws: the needle goes along with them and above them, so that the thread
    stays as long from the slit over the jaws to the needle; it comes nearer while its end of
    the thread bears more than 0.05 N. SEAT, RELEASE_TAIL: the tool moves opposite to the other
    one at its own height. It moves up to twice as far, or gives way, so that both ends bear as
    much. The tool stays within 0.15 m of the slit. It is not turned, and its jaws do not move."""
    ALL = 127
    """All aids."""


class SessionGap(IntEnum):
    """The constants of vbss_session_gap."""
    LIPS = 0
    """Gap between the lips, which are as high as the wall: vbss_drain_gap.opening. A wall that
    rises counts as closed when it meets the face of the other wall. A drain of
    VBSS_METHOD_VBLAST uses EDGES instead."""
    EDGES = 1
    """Gap between the edges in the middle of the wall: vbss_drain_gap.gap, the paper's measure."""


class vbss_session(ctypes.Structure):
    """A run of the suturing task on a scene."""


class vbss_session_event(ctypes.Structure):
    """An event of a session.

    kind: Kind of the event.

    tool: Tool of the event; VBSS_METRICS_TOOL_NONE: none, or not known.

    number: Meaning depends on the kind.

    undone: 1: the fact has ceased.

    stage: STAGE: the stage that the throw has reached.

    wraps: THROW: number of wraps, 1 single, 2 double, ...

    handedness: THROW: +1 right-handed, -1 left-handed.

    relation: THROW: relation to the throw before.

    phase: The phase after the step of the event.

    ordinal: Ordinal number of the event, from 0 on.

    step: Step of the session, from 1 on.

    time: Time since the needle's appearance, s, on the clock of the hands.

    position: Position of the tool's tip, or as the kind says, m.

    force: Force on the tool's hand, N; zero without a tool.

    amount: Meaning depends on the kind."""
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
    """An event of a session. Fields as vbss_session_event says."""
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


# A function of the host that receives each event, at the end of its step. It may read all objects
# of the context and must not change any.
vbss_session_event_fn = CFUNCTYPE(None, c_void_p, POINTER(vbss_session_event))


class vbss_session_config(ctypes.Structure):
    """Configuration of a session. Fill it with vbss_session_config_init, then set the numbers of
    the bodies.

    thread: Number of the thread in the scene. Its node 0 is at the swage; its last node is the
    end of the tail.

    needle: Number of the needle in the scene.

    drain: Number of the drain in the scene.

    tools: Numbers of the left and the right grasper in the scene.

    shears: Number of a third grasper, which cuts; default 0: a tool is exchanged for shears.

    event_capacity: Largest number of events that are kept, the newest ones; 8 to 65536; default
    1024.

    knot_interval: Number of steps between inputs of the knot detector, 1 to 1000; default 4.
    The detector's own step_budget bounds the work of an input.

    hash_interval: Number of steps between hashes of the task in the log, for replays to
    compare; 1 to 1e9; default 100. Steps with events are hashed too. Used only with a record.

    devices: Devices of the left and the right hand; NULL (default): the host moves that tool.

    knots: Knot detector, with capacity for the thread and all tools; NULL (default): throws are
    not detected.

    metrics: Metrics; NULL (default): nothing is measured.

    record: Record of the scene; NULL (default): nothing is logged. Each step of the session
    attaches it (vbss_scene_set_recorder). To log edits before the first step, the host attaches
    it.

    replay: Replay that has begun with the scene, in place of devices and record; NULL
    (default): none.

    listen: Function that receives the events; NULL (default): none.

    user: Pointer that `listen` receives; may be NULL.

    time_limit: Time limit from the needle's appearance on, s, 1e-3 to 1e6; default 600.

    dwell: Time for which a fact must differ before it changes, s, 0 to 10; default 0.05.

    throw_dwell: Dwell time of throws and of faults of the knot, s, 0 to 10; default 0.1. A half
    hitch takes 20 times as long.

    tail_low: Shortest permitted tail, m, 0 to 1; default 15e-3.

    tail_high: Longest permitted tail, m, tail_low to 1; default 20e-3.

    tail_margin: Hysteresis of both limits: a tail that is set stays set up to this far beyond
    them, m, 0 to 1; default 1e-3.

    tail_reach: Largest distance from the end at which a tail counts as grasped, m, 0 to 1;
    default 0.01.

    seat_gap: Largest gap of the slit at which a throw becomes seated, m, 0 to 1; default
    0.5e-3. Edges that have crossed do not gape.

    seat_release: Gap at which a throw is no longer seated, m, seat_gap to 1; default 1e-3.

    seat_force: Tension of both limbs that seats a throw, N, 0 to 1e3; default 0.5.

    avulsed_share: Share of torn anchors at which the drain counts as torn off, 0 to 1; default
    0.5.

    break_force: Tension at which the thread breaks, N, 0 to 1e6; default 0: it never breaks.

    gap_measure: Measure of the gap that seats throws and that status, events and metrics
    report; default LIPS.

    coaching: 1: the session coaches (session_coaching.h); default 0. The hashes in logs do not
    depend on it, but the state of a session that coaches can be restored only to one that
    coaches, too.

    lost_share: Share of lost time above which TIME_LOST is an event and `is_lossy` is set, 0 to
    1; default 0.02. A trial shorter than 1 s counts as 1 s.

    exercise: Exercise that the session trains in place of the whole task (session_exercise.h);
    default NONE. The state of an exercise can be restored only to a session with the same one."""
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
    coaching: int
    lost_share: float
    exercise: int
    reserved: int
    _kinds_: ClassVar[dict[str, Any]] = {"gap_measure": SessionGap, "exercise": SessionExercise}
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
        ("coaching", c_uint32),
        ("lost_share", c_double),
        ("exercise", c_int32),
        ("reserved", c_uint32),
    ]


class vbss_session_status(ctypes.Structure):
    """Status of a session.

    phase: Phase of the task.

    stage: Stage of the throw in progress; NONE if there is none.

    failure: Reason of the failure; NONE if the task has not failed.

    holder: The tool that holds the needle, the first of two; VBSS_METRICS_TOOL_NONE: none.

    punctured: Bits: 1 the hole in exists, 2 the hole out exists.

    threaded: Bits: 1 the thread goes through the hole in, 2 through the hole out.

    tail_set: 1: the tail has a permitted length.

    throws: Number of tied throws.

    seated: Number of seated throws, counted from the tissue.

    transfers: Number of needle transfers between throws, at most two.

    cut: Bits: 1 the short tail is cut, 2 the needle's tail is cut.

    faults: Faults of the knot, VBSS_KNOT_FAULT_ bits, as last reported by events.

    metrics_lost: Number of events that did not fit into the metrics.

    steps: Number of steps.

    first_event: Ordinal of the oldest event that is kept; this is also the number of lost
    events.

    event_count: Number of events.

    time: Time since the needle's appearance until the end or now, s, on the clock of the hands.
    It includes `time_lost`.

    tail: Length of the short tail from the hole on, m; 0 without a tail.

    gap: Gap of the slit's middle by `gap_measure`, m.

    tension: Largest tension of the short limb and of the needle's limb, N.

    deviation_mm: Deviation of each hole from its mark, mm.

    time_lost: Part of `time` that the scene has left out, s. It counts paused steps
    (vbss_scene_statistics::time_paused) and truncated substeps (VBSS_SCENE_EVENT_TRUNCATED),
    from the second step on.

    time_simulated: Time that was simulated, s: `time` minus `time_lost`. Up to two steps of it
    may still be deferred (vbss_scene_statistics::behind).

    is_lossy: 1: more than `lost_share` of the time is lost, with hysteresis.

    aids: VBSS_SESSION_AID_ bits of the aids in the last step.

    aids_used: Bits of all aids that were on during the task; 0: it is not assisted."""
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
    aids: int
    aids_used: int
    _kinds_: ClassVar[dict[str, Any]] = {"phase": SessionPhase, "stage": SessionStage, "failure": SessionFailure, "holder": MetricsTool, "faults": KnotFaultBits, "aids": SessionAidBits}
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
        ("aids", c_uint32),
        ("aids_used", c_uint32),
    ]


class SessionStatus(NamedTuple):
    """Status of a session. Fields as vbss_session_status says."""
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
    aids: SessionAidBits
    aids_used: int


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
