"""metrics.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_uint32, c_uint64, c_uint8
from enum import IntEnum, IntFlag
from typing import Any, ClassVar, NamedTuple

from .base import Method, vbss_context, vbss_view


class MetricsTool(IntEnum):
    """The constants of vbss_metrics_tool."""
    LEFT = 0
    """The left one,"""
    RIGHT = 1
    """the right one,"""
    NO_TOOL = 2
    """none, or not known: in events only."""


class MetricsHasBits(IntFlag):
    """Parts of a sample: bits."""
    LEFT = 1
    """Where the left tool is,"""
    RIGHT = 2
    """the right one,"""
    LEFT_FORCE = 4
    """what the left one bears,"""
    RIGHT_FORCE = 8
    """the right one."""


class MetricsEventKind(IntEnum):
    """The constants of vbss_metrics_event_kind; what can be undone says so. What stands and is
    told again is replaced."""
    NEEDLE_APPEARS = 1
    """The clock starts. Can be undone."""
    PHASE = 2
    """A phase of the task begins: `number` names it."""
    PUNCTURE = 3
    """The needle has gone through at mark `number` (0, 1), off by `angle` and `axial`. Undone: it
    was withdrawn, which is an attempt."""
    TAIL = 4
    """Tail `number` (0, 1) is `amount` m long. Can be undone."""
    TAIL_CUT = 5
    """It was cut; `amount` m are left. Can be undone."""
    GAP = 6
    """The slit gapes: from `position` to `other`, and by `amount` m where it gapes most. Can be
    undone."""
    THROW = 7
    """Throw `number` (0 next to the tissue) is tied: `wraps`, `handedness`, `relation`. Told
    again: known better. Undone: it is untied."""
    TRANSFER = 8
    """`tool` took over the needle. Can be undone."""
    TRANSFER_MISSED = 9
    """It should have, and did not. Can be undone."""
    DROP = 10
    """What the host calls `number` was dropped. Can be undone."""
    HOST = 11
    """A penalty of the host's own: it calls it `number`, and it costs `amount` points. Can be
    undone."""
    AVULSED = 12
    """The drain was torn off. Score zero. Can be undone."""
    BROKEN = 13
    """The thread broke, or was cut early. Score zero. Can be undone."""


class MetricsRelation(IntEnum):
    """The constants of vbss_metrics_relation."""
    UNKNOWN = 0
    """Not known,"""
    FIRST = 1
    """there is none before,"""
    SQUARE = 2
    """the other way round,"""
    GRANNY = 3
    """the same way round."""


class MetricsTightness(IntEnum):
    """The constants of vbss_metrics_tightness."""
    UNKNOWN = -1
    """It was not pulled, or not to an end."""
    TIGHT = 0
    """It holds."""
    SLIPS = 10
    """It slips."""
    UNTIED = 20
    """It comes apart."""


class MetricsBits(IntFlag):
    """What a report knows: bits."""
    STARTED = 1
    """The needle has appeared."""
    STOPPED = 2
    """Both tails are cut: the time stands."""
    PUNCTURE_0 = 4
    """The deviation from the first mark is known,"""
    PUNCTURE_1 = 8
    """from the second,"""
    GAP = 16
    """the gap,"""
    TAIL_0 = 32
    """the length of the first tail,"""
    TAIL_1 = 64
    """of the second."""
    FINISHED = 128
    """vbss_metrics_finish was called."""
    AVULSED = 256
    """The drain was torn off."""
    BROKEN = 512
    """The thread broke."""
    TIMEOUT = 1024
    """The time is up."""
    FINAL = 2048
    """The score is that of a whole trial: stopped, with deviations, gap and tightness known, or
    zero for good. Without it the score is what it would be if nothing more were found."""
    TIME_LOST = 4096
    """More than `lost_share` of the time is lost. Time and score include it and do not compare
    with those of other trials."""


class MetricsPenaltyKind(IntEnum):
    """The constants of vbss_metrics_penalty_kind."""
    DEVIATION = 1
    """A puncture off its mark, by `measure` mm."""
    GAP = 2
    """The slit gapes, by `measure` mm."""
    TIGHTNESS = 3
    """The knot slips or is untied: `measure` 10 or 20."""
    THROWS = 4
    """Throws are missing: `measure` of them."""
    GRANNY = 5
    """A throw the same way round as the one before."""
    ATTEMPT = 6
    """A puncture was withdrawn."""
    DROP = 7
    """Something was dropped."""
    TRANSFER = 8
    """The needle did not change hands."""
    HOST = 9
    """A penalty of the host, of `measure` points."""
    TIMEOUT = 10
    """The time is up: all that was left."""
    AVULSED = 11
    """The drain was torn off: all that was left."""
    BROKEN = 12
    """The thread broke: all that was left."""
    INCOMPLETE = 13
    """Finished before both tails were cut: all that was left."""
    TIME_LOST = 14
    """More than `lost_share` of the time was lost: `measure` s. It costs no points."""


class MetricsTask(IntEnum):
    """The phase of a question that is about the whole task."""
    WHOLE = -1
    """From the needle until both tails were cut; without a needle: all there is."""


class MetricsMotionBits(IntFlag):
    """What could be computed of a motion: bits."""
    LDJ = 1
    """`ldj_length`, `ldj_speed`"""
    SPARC = 2
    """`sparc`: not above 40.96 s."""
    MOVEMENTS = 4
    """`movement_sparc`"""
    CORRELATION = 8
    """`correlation`"""


class MetricsField(IntEnum):
    """The constants of vbss_metrics_field. Row i is of the time of the first sample + i / 100 s."""
    LEFT_SPEED = 0
    """x 1 double: of the left tool, m/s; 0 where it was not seen,"""
    RIGHT_SPEED = 1
    """of the right one."""
    LEFT_JERK = 2
    """x 1 double: |jerk|^2 of the left tool, m^2/s^6; 0 where it was not seen for 0.25 s without a
    gap,"""
    RIGHT_JERK = 3
    """of the right one."""
    LEFT_FORCE = 4
    """x 1 double: largest |force| in that hundredth, N, of the left tool,"""
    RIGHT_FORCE = 5
    """of the right one."""


class vbss_metrics(ctypes.Structure):
    """What was measured of one trial."""


class vbss_metrics_config(ctypes.Structure):
    """How to measure. Fill it with vbss_metrics_config_init, then change what you need.

    tightness_method: Whose tightness counts in the score; default VBSS_METHOD_OURS. Both are
    always reported.

    throw_capacity: Records of throws, undone ones too, 1 to 4096; default 64.

    phase_capacity: Visits of phases, 1 to 65536; default 256.

    incident_capacity: Transfers, attempts, drops, faults, 1 to 65536; default 256.

    throws_wanted: Throws that the knot should have, 0 to 64; default 3.

    duration: Of motion there is room for, s, 1 to 7200; default 600.

    drain_radius: Of the cylinder with the marks, m, 1e-4 to 1; default 6.5e-3.

    stiffness: EA of the thread, N, 1e-3 to 1e9; default 427 (silk, 0.25 mm).

    pull_force: Of the pull test, N, 1e-3 to 1e3; default 2.

    pull_time: That it must be borne, s, 0 to 1e3; default 1.

    slip_limit: Tail drawn in from which a knot slips, m, 1e-6 to 1; default 1e-3.

    strain_threshold: PAPER: strain from which a knot is tight, 0 to 1; default 0: pull_force /
    stiffness.

    idle_speed: Below it a tool is idle, m/s, 0 to 1; default 5e-3,

    idle_release: until it is faster than this, idle_speed to 1; default 6e-3.

    max_time: From which the score is zero, s, 1e-3 to 1e6; default 600.

    weight_deviation: Points a mm from a mark; this and all weights 0 to 1e6; default 10.

    weight_gap: Points a mm of gap; default 10.

    weight_tightness: Points a point of tightness (0, 10, 20); default 1.

    weight_throw: Points a throw that is missing; default 0.

    weight_granny: Points a throw that makes a granny; default 0.

    weight_attempt: Points a puncture that was withdrawn; default 0.

    weight_drop: Points a drop; default 0.

    weight_transfer: Points a needle transfer that was missed; default 0.

    weight_host: Times the points of a penalty of the host; default 1.

    max_speed: Largest speed of a hand, m/s, 0 to 1e6; default 2, for the upper limbs by ISO
    13855. A sample that is farther from the last one than this speed allows, plus 1 mm for
    noise, is an outlier: see vbss_metrics_add_sample. 0: no sample is an outlier.

    lost_share: Share of the time, 0 to 1, above which lost time sets VBSS_METRICS_TIME_LOST;
    default 0.02. A trial shorter than 1 s counts as 1 s."""
    struct_size: int
    tightness_method: int
    throw_capacity: int
    phase_capacity: int
    incident_capacity: int
    throws_wanted: int
    duration: float
    drain_radius: float
    stiffness: float
    pull_force: float
    pull_time: float
    slip_limit: float
    strain_threshold: float
    idle_speed: float
    idle_release: float
    max_time: float
    weight_deviation: float
    weight_gap: float
    weight_tightness: float
    weight_throw: float
    weight_granny: float
    weight_attempt: float
    weight_drop: float
    weight_transfer: float
    weight_host: float
    max_speed: float
    lost_share: float
    _kinds_: ClassVar[dict[str, Any]] = {"tightness_method": Method}
    _fields_ = [
        ("struct_size", c_uint32),
        ("tightness_method", c_int32),
        ("throw_capacity", c_uint32),
        ("phase_capacity", c_uint32),
        ("incident_capacity", c_uint32),
        ("throws_wanted", c_uint32),
        ("duration", c_double),
        ("drain_radius", c_double),
        ("stiffness", c_double),
        ("pull_force", c_double),
        ("pull_time", c_double),
        ("slip_limit", c_double),
        ("strain_threshold", c_double),
        ("idle_speed", c_double),
        ("idle_release", c_double),
        ("max_time", c_double),
        ("weight_deviation", c_double),
        ("weight_gap", c_double),
        ("weight_tightness", c_double),
        ("weight_throw", c_double),
        ("weight_granny", c_double),
        ("weight_attempt", c_double),
        ("weight_drop", c_double),
        ("weight_transfer", c_double),
        ("weight_host", c_double),
        ("max_speed", c_double),
        ("lost_share", c_double),
    ]


class vbss_metrics_sample(ctypes.Structure):
    """Where the tools are. Fill it with vbss_metrics_sample_init, then set what there is.

    valid: VBSS_METRICS_HAS_ bits; default 0.

    step: Of the simulator; only told again.

    time: s, at most 1e9 in magnitude, after the last sample.

    position: Of the tips, left and right, m, each at most 1e3.

    force: On the tools, N, each at most 1e6.

    time_lost: Time that the simulation has left out since its clock began, s, at most 1e9 and
    not less than in the last sample; default 0. It is part of `time`."""
    struct_size: int
    valid: int
    step: int
    time: float
    position: Any
    force: Any
    time_lost: float
    _kinds_: ClassVar[dict[str, Any]] = {"valid": MetricsHasBits}
    _fields_ = [
        ("struct_size", c_uint32),
        ("valid", c_uint32),
        ("step", c_uint64),
        ("time", c_double),
        ("position", (c_double * 3) * 2),
        ("force", (c_double * 3) * 2),
        ("time_lost", c_double),
    ]


class vbss_metrics_event(ctypes.Structure):
    """Something that happened. Fill it with vbss_metrics_event_init, then set what the kind wants.

    kind: What; the default 0 is refused.

    tool: With which tool; default VBSS_METRICS_NO_TOOL.

    number: As the kind says; throws: 0 to 63; default 0.

    undone: 1: it is no longer so; default 0.

    wraps: THROW: 1 single, 2 double, ..., 0 not known (default), to 64.

    handedness: THROW: +1 right-handed, -1 left-handed, 0 not known (default).

    relation: THROW: to the throw before; default UNKNOWN.

    step: Of the simulator; only told again.

    time: s, at most 1e9 in magnitude, not before what was told last.

    position: Where, m, each at most 1e3.

    force: With which force, N, each at most 1e6.

    other: GAP: the other side, m, each at most 1e3.

    angle: PUNCTURE: about the axis, rad, -pi to pi.

    axial: PUNCTURE: along the axis, m, at most 1e3.

    amount: As the kind says, 0 to 1e6."""
    struct_size: int
    kind: int
    tool: int
    number: int
    undone: int
    wraps: int
    handedness: int
    relation: int
    step: int
    time: float
    position: Any
    force: Any
    other: Any
    angle: float
    axial: float
    amount: float
    _kinds_: ClassVar[dict[str, Any]] = {"kind": MetricsEventKind, "tool": MetricsTool, "relation": MetricsRelation}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("tool", c_int32),
        ("number", c_uint32),
        ("undone", c_uint32),
        ("wraps", c_int32),
        ("handedness", c_int32),
        ("relation", c_int32),
        ("step", c_uint64),
        ("time", c_double),
        ("position", c_double * 3),
        ("force", c_double * 3),
        ("other", c_double * 3),
        ("angle", c_double),
        ("axial", c_double),
        ("amount", c_double),
    ]


class vbss_metrics_pull(ctypes.Structure):
    """A reading of the pull test. Fill it with vbss_metrics_pull_init, then set what there is.

    begins: 1: a new test begins, what an earlier one found is forgotten; default 0.

    tied: 1 (default): the knot is still there; 0: its topology is lost.

    step: Of the simulator; only told again.

    time: s, as of events.

    strain: Of the thread between knot and each tool, -1 to 1.

    force: With which each tool pulls, N, 0 to 1e6.

    drawn_in: Tail drawn into the knot since the test began, m, at most 1e3."""
    struct_size: int
    begins: int
    tied: int
    reserved: int
    step: int
    time: float
    strain: Any
    force: Any
    drawn_in: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("begins", c_uint32),
        ("tied", c_uint32),
        ("reserved", c_uint32),
        ("step", c_uint64),
        ("time", c_double),
        ("strain", c_double * 2),
        ("force", c_double * 2),
        ("drawn_in", c_double),
    ]


class vbss_metrics_report(ctypes.Structure):
    """What is known of a trial. What is not known is 0, and its bit is not set.

    flags: VBSS_METRICS_ bits of what is known.

    tightness_ours: By the pull test,

    tightness_paper: by the strain when both tools pull.

    throw_count: Throws that stand,

    square_count: of them square to the one before,

    granny_count: granny to it,

    unknown_count: not known which.

    throw_records: For vbss_metrics_get_throw: undone throws too.

    phase_count: For vbss_metrics_get_phase.

    penalty_count: For vbss_metrics_get_penalty.

    transfers: The needle changed hands,

    transfers_missed: should have,

    attempts: punctures that were withdrawn, at each mark,

    drops: things that were dropped,

    host_penalties: penalties of the host.

    samples: Samples taken.

    ticks: Of motion that are known, of the tool of which more are.

    ticks_lost: Beyond the room for motion: not measured.

    time: From the needle until both tails were cut, or until now, s, on the clock of the hands.
    It includes `time_lost`.

    deviation_mm: Of the punctures from their marks, along the drain.

    gap_mm: Between the two points,

    gap_largest_mm: where the slit gapes most.

    tail_mm: Of the tails, after the cut if they were.

    pull_held: Longest time the pull was borne, s.

    pull_strain: Largest strain that both sides had,

    drawn_in_mm: Most tail that was drawn in.

    score: max_time - time - penalties, not below zero.

    penalties: Sum of the penalties.

    outliers: Samples of the left and the right tool left out as outliers.

    jumps: Times that outliers lasted for more than 0.1 s: a new run began.

    time_lost: Part of `time` that the simulation left out, s.

    time_simulated: `time` without `time_lost`, s."""
    struct_size: int
    flags: int
    tightness_ours: int
    tightness_paper: int
    throw_count: int
    square_count: int
    granny_count: int
    unknown_count: int
    throw_records: int
    phase_count: int
    penalty_count: int
    transfers: int
    transfers_missed: int
    attempts: Any
    drops: int
    host_penalties: int
    reserved: int
    samples: int
    ticks: int
    ticks_lost: int
    time: float
    deviation_mm: Any
    gap_mm: float
    gap_largest_mm: float
    tail_mm: Any
    pull_held: float
    pull_strain: float
    drawn_in_mm: float
    score: float
    penalties: float
    outliers: Any
    jumps: Any
    time_lost: float
    time_simulated: float
    _kinds_: ClassVar[dict[str, Any]] = {"flags": MetricsBits, "tightness_ours": MetricsTightness, "tightness_paper": MetricsTightness}
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("tightness_ours", c_int32),
        ("tightness_paper", c_int32),
        ("throw_count", c_uint32),
        ("square_count", c_uint32),
        ("granny_count", c_uint32),
        ("unknown_count", c_uint32),
        ("throw_records", c_uint32),
        ("phase_count", c_uint32),
        ("penalty_count", c_uint32),
        ("transfers", c_uint32),
        ("transfers_missed", c_uint32),
        ("attempts", c_uint32 * 2),
        ("drops", c_uint32),
        ("host_penalties", c_uint32),
        ("reserved", c_uint32),
        ("samples", c_uint64),
        ("ticks", c_uint64),
        ("ticks_lost", c_uint64),
        ("time", c_double),
        ("deviation_mm", c_double * 2),
        ("gap_mm", c_double),
        ("gap_largest_mm", c_double),
        ("tail_mm", c_double * 2),
        ("pull_held", c_double),
        ("pull_strain", c_double),
        ("drawn_in_mm", c_double),
        ("score", c_double),
        ("penalties", c_double),
        ("outliers", c_uint64 * 2),
        ("jumps", c_uint32 * 2),
        ("time_lost", c_double),
        ("time_simulated", c_double),
    ]


class MetricsReport(NamedTuple):
    """What is known of a trial. What is not known is 0, and its bit is not set. Fields as
    vbss_metrics_report says."""
    flags: MetricsBits
    tightness_ours: MetricsTightness
    tightness_paper: MetricsTightness
    throw_count: int
    square_count: int
    granny_count: int
    unknown_count: int
    throw_records: int
    phase_count: int
    penalty_count: int
    transfers: int
    transfers_missed: int
    attempts: tuple[int, ...]
    drops: int
    host_penalties: int
    samples: int
    ticks: int
    ticks_lost: int
    time: float
    deviation_mm: tuple[float, ...]
    gap_mm: float
    gap_largest_mm: float
    tail_mm: tuple[float, ...]
    pull_held: float
    pull_strain: float
    drawn_in_mm: float
    score: float
    penalties: float
    outliers: tuple[int, ...]
    jumps: tuple[int, ...]
    time_lost: float
    time_simulated: float


class vbss_metrics_throw(ctypes.Structure):
    """A throw that was tied, in the order in which they were told.

    number: Its place in the knot, 0 next to the tissue.

    standing: 1: it is there; 0: it was untied.

    tool: With which tool.

    wraps: 1 single, 2 double, 0 not known.

    handedness: +1 right-handed, -1 left-handed, 0 not known.

    relation: To the throw before.

    step: When it was told first.

    time: The same, s.

    undone_time: When it was untied, s; 0 while it stands.

    position: Where, m.

    force: With which force, N."""
    struct_size: int
    number: int
    standing: int
    tool: int
    wraps: int
    handedness: int
    relation: int
    reserved: int
    step: int
    time: float
    undone_time: float
    position: Any
    force: Any
    _kinds_: ClassVar[dict[str, Any]] = {"tool": MetricsTool, "relation": MetricsRelation}
    _fields_ = [
        ("struct_size", c_uint32),
        ("number", c_uint32),
        ("standing", c_uint32),
        ("tool", c_int32),
        ("wraps", c_int32),
        ("handedness", c_int32),
        ("relation", c_int32),
        ("reserved", c_uint32),
        ("step", c_uint64),
        ("time", c_double),
        ("undone_time", c_double),
        ("position", c_double * 3),
        ("force", c_double * 3),
    ]


class MetricsThrow(NamedTuple):
    """A throw that was tied, in the order in which they were told. Fields as vbss_metrics_throw
    says."""
    number: int
    standing: int
    tool: MetricsTool
    wraps: int
    handedness: int
    relation: MetricsRelation
    step: int
    time: float
    undone_time: float
    position: tuple[float, ...]
    force: tuple[float, ...]


class vbss_metrics_phase(ctypes.Structure):
    """A visit of a phase, which may be entered again.

    number: The host's name of the phase.

    ended: 1: another has begun; 0: `end` is now, or the end of the trial.

    step: When it was entered.

    begin: The same, s.

    end: When it was left, s."""
    struct_size: int
    number: int
    ended: int
    reserved: int
    step: int
    begin: float
    end: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("number", c_uint32),
        ("ended", c_uint32),
        ("reserved", c_uint32),
        ("step", c_uint64),
        ("begin", c_double),
        ("end", c_double),
    ]


class MetricsPhase(NamedTuple):
    """A visit of a phase, which may be entered again. Fields as vbss_metrics_phase says."""
    number: int
    ended: int
    step: int
    begin: float
    end: float


class vbss_metrics_penalty(ctypes.Structure):
    """One reason why the score is not max_time - time. Faults that cost nothing are told too.

    kind: What.

    number: Of the mark, throw, ... as in the event.

    tool: With which tool.

    step: When.

    time: The same, s.

    measure: How much, as the kind says.

    amount: Points it took.

    position: Where, m.

    force: With which force, N.

    text: In words, a constant text, never NULL."""
    struct_size: int
    kind: int
    number: int
    tool: int
    step: int
    time: float
    measure: float
    amount: float
    position: Any
    force: Any
    text: Any
    _kinds_: ClassVar[dict[str, Any]] = {"kind": MetricsPenaltyKind, "tool": MetricsTool}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("number", c_uint32),
        ("tool", c_int32),
        ("step", c_uint64),
        ("time", c_double),
        ("measure", c_double),
        ("amount", c_double),
        ("position", c_double * 3),
        ("force", c_double * 3),
        ("text", c_char_p),
    ]


class MetricsPenalty(NamedTuple):
    """One reason why the score is not max_time - time. Faults that cost nothing are told too.
    Fields as vbss_metrics_penalty says."""
    kind: MetricsPenaltyKind
    number: int
    tool: MetricsTool
    step: int
    time: float
    measure: float
    amount: float
    position: tuple[float, ...]
    force: tuple[float, ...]
    text: str


class vbss_metrics_motion(ctypes.Structure):
    """How one tool moved, and what it bore.

    valid: VBSS_METRICS_HAS_ bits.

    movement_count: Movements of 0.2 s to 40.96 s between rests.

    time: In which it was seen, s,

    unseen_time: and not.

    path_length: m

    mean_speed: m/s,

    peak_speed: m/s.

    idle_time: In which it rested, s,

    idle_share: as a part of the time.

    ldj_length: -ln(T^5/L^2 integral of |jerk|^2): higher is smoother,

    ldj_speed: -ln(T^3/v_peak^2 integral of |jerk|^2).

    sparc: Of all of it as one movement,

    movement_sparc: mean over the movements.

    force_peak: Largest force, N.

    force_integral: Of its magnitude over time, N s."""
    struct_size: int
    valid: int
    movement_count: int
    reserved: int
    time: float
    unseen_time: float
    path_length: float
    mean_speed: float
    peak_speed: float
    idle_time: float
    idle_share: float
    ldj_length: float
    ldj_speed: float
    sparc: float
    movement_sparc: float
    force_peak: float
    force_integral: float
    _kinds_: ClassVar[dict[str, Any]] = {"valid": MetricsMotionBits}
    _fields_ = [
        ("struct_size", c_uint32),
        ("valid", c_uint32),
        ("movement_count", c_uint32),
        ("reserved", c_uint32),
        ("time", c_double),
        ("unseen_time", c_double),
        ("path_length", c_double),
        ("mean_speed", c_double),
        ("peak_speed", c_double),
        ("idle_time", c_double),
        ("idle_share", c_double),
        ("ldj_length", c_double),
        ("ldj_speed", c_double),
        ("sparc", c_double),
        ("movement_sparc", c_double),
        ("force_peak", c_double),
        ("force_integral", c_double),
    ]


class MetricsMotion(NamedTuple):
    """How one tool moved, and what it bore. Fields as vbss_metrics_motion says."""
    valid: MetricsMotionBits
    movement_count: int
    time: float
    unseen_time: float
    path_length: float
    mean_speed: float
    peak_speed: float
    idle_time: float
    idle_share: float
    ldj_length: float
    ldj_speed: float
    sparc: float
    movement_sparc: float
    force_peak: float
    force_integral: float


class vbss_metrics_bimanual(ctypes.Structure):
    """How both tools moved together.

    valid: VBSS_METRICS_HAS_CORRELATION, or 0.

    time: In which both were seen, s.

    correlation: Pearson's, of their speeds.

    both_moving_time: In which neither rested, s,

    one_moving_time: in which one did,

    still_time: in which both did.

    both_moving_share: The first of these as a part of the time."""
    struct_size: int
    valid: int
    time: float
    correlation: float
    both_moving_time: float
    one_moving_time: float
    still_time: float
    both_moving_share: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("valid", c_uint32),
        ("time", c_double),
        ("correlation", c_double),
        ("both_moving_time", c_double),
        ("one_moving_time", c_double),
        ("still_time", c_double),
        ("both_moving_share", c_double),
    ]


class MetricsBimanual(NamedTuple):
    """How both tools moved together. Fields as vbss_metrics_bimanual says."""
    valid: int
    time: float
    correlation: float
    both_moving_time: float
    one_moving_time: float
    still_time: float
    both_moving_share: float


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_metrics_config_init": (c_int32, (POINTER(vbss_metrics_config), c_uint32)),
    "vbss_metrics_sample_init": (c_int32, (POINTER(vbss_metrics_sample), c_uint32)),
    "vbss_metrics_event_init": (c_int32, (POINTER(vbss_metrics_event), c_uint32)),
    "vbss_metrics_pull_init": (c_int32, (POINTER(vbss_metrics_pull), c_uint32)),
    "vbss_metrics_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_metrics_config),
        POINTER(POINTER(vbss_metrics)))),
    "vbss_metrics_destroy": (c_int32, (POINTER(vbss_metrics),)),
    "vbss_metrics_add_sample": (c_int32, (POINTER(vbss_metrics), POINTER(vbss_metrics_sample))),
    "vbss_metrics_add_event": (c_int32, (POINTER(vbss_metrics), POINTER(vbss_metrics_event))),
    "vbss_metrics_add_pull": (c_int32, (POINTER(vbss_metrics), POINTER(vbss_metrics_pull))),
    "vbss_metrics_finish": (c_int32, (POINTER(vbss_metrics),)),
    "vbss_metrics_get_report": (c_int32, (POINTER(vbss_metrics), POINTER(vbss_metrics_report),
        c_uint32)),
    "vbss_metrics_get_throw": (c_int32, (POINTER(vbss_metrics), c_uint32,
        POINTER(vbss_metrics_throw), c_uint32)),
    "vbss_metrics_get_phase": (c_int32, (POINTER(vbss_metrics), c_uint32,
        POINTER(vbss_metrics_phase), c_uint32)),
    "vbss_metrics_get_penalty": (c_int32, (POINTER(vbss_metrics), c_uint32,
        POINTER(vbss_metrics_penalty), c_uint32)),
    "vbss_metrics_get_motion": (c_int32, (POINTER(vbss_metrics), c_int32, c_int32,
        POINTER(vbss_metrics_motion), c_uint32)),
    "vbss_metrics_get_bimanual": (c_int32, (POINTER(vbss_metrics), c_int32,
        POINTER(vbss_metrics_bimanual), c_uint32)),
    "vbss_metrics_get_view": (c_int32, (POINTER(vbss_metrics), c_int32, POINTER(vbss_view),
        c_uint32)),
    "vbss_metrics_offset": (c_int32, (POINTER(c_double), POINTER(c_double), POINTER(c_double),
        POINTER(c_double), POINTER(c_double), POINTER(c_double))),
    "vbss_metrics_save": (c_int32, (POINTER(vbss_metrics), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_metrics_restore": (c_int32, (POINTER(vbss_metrics), POINTER(c_uint8), c_uint64)),
    "vbss_metrics_get_hash": (c_int32, (POINTER(vbss_metrics), POINTER(c_uint64))),
}
