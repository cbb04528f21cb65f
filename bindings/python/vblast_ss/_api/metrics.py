"""metrics.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_uint32, c_uint64, c_uint8
from enum import IntEnum, IntFlag
from typing import Any, ClassVar, NamedTuple

from .base import vbss_context, vbss_view


class MetricsTool(IntEnum):
    """The constants of vbss_metrics_tool."""
    LEFT = 0
    """The left tool."""
    RIGHT = 1
    """The right tool."""
    NONE = 2
    """No tool, or an unknown one; for events only."""


class MetricsTightnessTest(IntEnum):
    """The constants of vbss_metrics_tightness_test."""
    PULL = 0
    """The knot bears a force for a time without slipping."""
    STRAIN = 1
    """The strain of both sides (Qi et al. 2017)."""


class MetricsHasBits(IntFlag):
    """Bits for the parts of a sample."""
    LEFT = 1
    """The position of the left tool is valid."""
    RIGHT = 2
    """The position of the right tool is valid."""
    LEFT_FORCE = 4
    """The force on the left tool is valid."""
    RIGHT_FORCE = 8
    """The force on the right tool is valid."""


class MetricsEventKind(IntEnum):
    """The constants of vbss_metrics_event_kind. Each says whether it can be undone. An event that
    is reported again replaces its predecessor."""
    NEEDLE_APPEARS = 1
    """The clock starts. Can be undone."""
    PHASE = 2
    """The phase `number` of the task begins."""
    PUNCTURE = 3
    """The needle has passed through at mark `number` (0, 1), off by `angle` and `axial`. Undone:
    the puncture was withdrawn and counts as an attempt."""
    TAIL = 4
    """Tail `number` (0, 1) is `amount` m long. Can be undone."""
    TAIL_CUT = 5
    """Tail `number` (0, 1) was cut; `amount` m are left. Can be undone."""
    GAP = 6
    """The slit gapes from `position` to `other`; its widest gap is `amount` m. Can be undone."""
    THROW = 7
    """Throw `number` (0 next to the tissue) is tied, with `wraps`, `handedness` and `relation`. A
    repeated event corrects them. Undone: the throw was untied."""
    TRANSFER = 8
    """`tool` took over the needle. Can be undone."""
    TRANSFER_MISSED = 9
    """`tool` should have taken over the needle, and did not. Can be undone."""
    DROP = 10
    """The host's object `number` was dropped. Can be undone."""
    HOST = 11
    """A penalty that the host defines: `number` identifies it, and it costs `amount` points. Can
    be undone."""
    AVULSED = 12
    """The drain was torn off. The score becomes zero. Can be undone."""
    BROKEN = 13
    """The thread broke, or was cut early. The score becomes zero. Can be undone."""
    ASSISTED = 14
    """The trainee was assisted, by aid `number`. The score becomes zero. Can be undone."""


class MetricsRelation(IntEnum):
    """The constants of vbss_metrics_relation."""
    UNKNOWN = 0
    """The relation is not known."""
    FIRST = 1
    """There is no throw before."""
    SQUARE = 2
    """The throw has the opposite handedness."""
    GRANNY = 3
    """The throw has the same handedness."""


class MetricsTightness(IntEnum):
    """The constants of vbss_metrics_tightness."""
    UNKNOWN = -1
    """The knot was not pulled, or the pull test is incomplete."""
    TIGHT = 0
    """The knot holds."""
    SLIPS = 10
    """The knot slips."""
    UNTIED = 20
    """The knot comes apart."""


class MetricsFlagBits(IntFlag):
    """Bits of the flags of a report."""
    STARTED = 1
    """The needle has appeared."""
    STOPPED = 2
    """Both tails are cut, and the time has stopped."""
    PUNCTURE_0 = 4
    """The deviation from the first mark is known."""
    PUNCTURE_1 = 8
    """The deviation from the second mark is known."""
    GAP = 16
    """The gap is known."""
    TAIL_0 = 32
    """The length of the first tail is known."""
    TAIL_1 = 64
    """The length of the second tail is known."""
    FINISHED = 128
    """vbss_metrics_finish was called."""
    AVULSED = 256
    """The drain was torn off."""
    BROKEN = 512
    """The thread broke."""
    TIMEOUT = 1024
    """The time has run out."""
    FINAL = 2048
    """The score is that of a whole trial: stopped, with deviations, gap and tightness known, or
    zero for good. Without this bit the score assumes that nothing more is found."""
    TIME_LOST = 4096
    """More than `lost_share` of the time is lost. Time and score include it and do not compare
    with those of other trials."""
    ASSISTED = 8192
    """The trainee was assisted: there is no score."""


class MetricsPenaltyKind(IntEnum):
    """The constants of vbss_metrics_penalty_kind."""
    DEVIATION = 1
    """A puncture is off its mark by `measure` mm."""
    GAP = 2
    """The slit gapes by `measure` mm."""
    TIGHTNESS = 3
    """The knot slips (`measure` is 10) or is untied (20)."""
    THROWS = 4
    """`measure` throws are missing."""
    GRANNY = 5
    """A throw has the same handedness as the one before."""
    ATTEMPT = 6
    """A puncture was withdrawn."""
    DROP = 7
    """Something was dropped."""
    TRANSFER = 8
    """A needle transfer was missed."""
    HOST = 9
    """A penalty of the host of `measure` points."""
    TIMEOUT = 10
    """The time has run out; it costs all remaining points."""
    AVULSED = 11
    """The drain was torn off; it costs all remaining points."""
    BROKEN = 12
    """The thread broke; it costs all remaining points."""
    INCOMPLETE = 13
    """The trial ended before both tails were cut; it costs all remaining points."""
    TIME_LOST = 14
    """More than `lost_share` of the time was lost; `measure` is the lost time, s. It costs no
    points."""
    ASSISTED = 15
    """The trainee was assisted; it costs all remaining points."""


class MetricsTask(IntEnum):
    """The `phase` argument for the whole task."""
    ALL = -1
    """From the needle's appearance until both tails were cut; without a needle, the whole
    recording."""


class MetricsMotionBits(IntFlag):
    """Bits for the measures of motion that could be computed."""
    LDJ = 1
    """`ldj_length` and `ldj_speed` are valid."""
    SPARC = 2
    """`sparc` is valid: the motion lasts at most 40.96 s."""
    MOVEMENTS = 4
    """`movement_sparc` is valid."""
    CORRELATION = 8
    """`correlation` is valid."""


class MetricsField(IntEnum):
    """The constants of vbss_metrics_field. Row i belongs to the time of the first sample plus i /
    100 s."""
    LEFT_SPEED = 0
    """x 1 double: speed of the left tool, m/s; 0 where it was not seen."""
    RIGHT_SPEED = 1
    """x 1 double: speed of the right tool, m/s; 0 where it was not seen."""
    LEFT_JERK = 2
    """x 1 double: |jerk|^2 of the left tool, m^2/s^6; 0 where it was not seen for 0.25 s without a
    gap."""
    RIGHT_JERK = 3
    """x 1 double: |jerk|^2 of the right tool, m^2/s^6; 0 where it was not seen for 0.25 s without
    a gap."""
    LEFT_FORCE = 4
    """x 1 double: largest |force| on the left tool in that hundredth of a second, N."""
    RIGHT_FORCE = 5
    """x 1 double: largest |force| on the right tool in that hundredth of a second, N."""


class vbss_metrics(ctypes.Structure):
    """The measurement of one trial."""


class vbss_metrics_config(ctypes.Structure):
    """Configuration of a measurement. Fill it with vbss_metrics_config_init, then change fields.

    tightness_test: The test whose tightness counts in the score; default
    VBSS_METRICS_TEST_PULL. Both are always reported.

    throw_capacity: Largest number of throw records, undone throws included, 1 to 4096; default
    64.

    phase_capacity: Largest number of phase visits, 1 to 65536; default 256.

    incident_capacity: Largest number of transfers, attempts, drops and faults, 1 to 65536;
    default 256.

    throws_wanted: Throws that the knot should have, 0 to 64; default 3.

    duration: Longest motion that can be stored, s, 1 to 7200; default 600.

    drain_radius: Radius of the cylinder that carries the marks, m, 1e-4 to 1; default 6.5e-3.

    stiffness: Axial stiffness EA of the thread, N, 1e-3 to 1e9; default 427 (silk, 0.25 mm).

    pull_force: Force of the pull test, N, 1e-3 to 1e3; default 2.

    pull_time: Time that the knot must bear the pull, s, 0 to 1e3; default 1.

    slip_limit: Length of tail drawn in above which the knot slips, m, 1e-6 to 1; default 1e-3.

    strain_threshold: VBSS_METRICS_TEST_STRAIN: strain above which a knot is tight, 0 to 1;
    default 0, which means pull_force / stiffness.

    idle_speed: Speed below which a tool becomes idle, m/s, 0 to 1; default 5e-3.

    idle_release: Speed above which an idle tool moves again, m/s, idle_speed to 1; default
    6e-3.

    max_time: Time from which the score is zero, s, 1e-3 to 1e6; default 600.

    weight_deviation: Points per mm of deviation from a mark, 0 to 1e6; default 10.

    weight_gap: Points per mm of gap, 0 to 1e6; default 10.

    weight_tightness: Points per point of tightness (0, 10, 20), 0 to 1e6; default 1.

    weight_throw: Points per missing throw, 0 to 1e6; default 0.

    weight_granny: Points per throw that makes a granny, 0 to 1e6; default 0.

    weight_attempt: Points per puncture that was withdrawn, 0 to 1e6; default 0.

    weight_drop: Points per drop, 0 to 1e6; default 0.

    weight_transfer: Points per missed needle transfer, 0 to 1e6; default 0.

    weight_host: Factor of the points of the host's penalties, 0 to 1e6; default 1.

    max_speed: Largest speed of a hand, m/s, 0 to 1e6; default 2, for the upper limbs by ISO
    13855. A sample that is farther from the last one than this speed allows, plus 1 mm for
    noise, is an outlier: see vbss_metrics_add_sample. With 0 no sample is an outlier.

    lost_share: Share of lost time above which VBSS_METRICS_FLAG_TIME_LOST is set, 0 to 1;
    default 0.02. A trial shorter than 1 s counts as 1 s."""
    struct_size: int
    tightness_test: int
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
    _kinds_: ClassVar[dict[str, Any]] = {"tightness_test": MetricsTightnessTest}
    _fields_ = [
        ("struct_size", c_uint32),
        ("tightness_test", c_int32),
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
    """Positions of the tools and forces on them. Fill it with vbss_metrics_sample_init, then set
    the known parts.

    valid: VBSS_METRICS_HAS_ bits; default 0.

    step: Step number of the simulator; it is only passed on.

    time: Time of the sample, s, at most 1e9 in magnitude, after the last sample.

    position: Positions of the left and the right tip, m, each coordinate at most 1e3 in
    magnitude.

    force: Forces on the left and the right tool, N, each component at most 1e6 in magnitude.

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
    """An event. Fill it with vbss_metrics_event_init, then set the fields of its kind.

    kind: Kind of the event; the default 0 is refused.

    tool: The tool that was used; default VBSS_METRICS_TOOL_NONE.

    number: Meaning depends on the kind; for throws 0 to 63; default 0.

    undone: 1: the event is undone; default 0.

    wraps: THROW: wraps, 1 single, 2 double, at most 64; default 0: not known.

    handedness: THROW: +1 right-handed, -1 left-handed, 0 not known (default).

    relation: THROW: relation to the throw before; default UNKNOWN.

    step: Step number of the simulator; it is only passed on.

    time: Time, s, at most 1e9 in magnitude, not before that of the last input.

    position: Position of the event, m, each coordinate at most 1e3 in magnitude.

    force: Force at the event, N, each component at most 1e6 in magnitude.

    other: GAP: point on the other side, m, each coordinate at most 1e3 in magnitude.

    angle: PUNCTURE: offset about the axis, rad, -pi to pi.

    axial: PUNCTURE: offset along the axis, m, at most 1e3 in magnitude.

    amount: Meaning depends on the kind; 0 to 1e6."""
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
    """A reading of the pull test. Fill it with vbss_metrics_pull_init, then set its fields.

    begins: 1: a new test begins, and the results of an earlier one are discarded; default 0.

    tied: 1 (default): the knot is still there; 0: its topology is lost.

    step: Step number of the simulator; it is only passed on.

    time: Time, s, at most 1e9 in magnitude, not before that of the last input.

    strain: Strain of the thread between the knot and each tool, -1 to 1.

    force: Force with which each tool pulls, N, 0 to 1e6.

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
    """The results of a trial so far. An unknown value is 0, and its bit is not set.

    flags: VBSS_METRICS_FLAG_ bits: which values are known, and how the trial ended.

    tightness_pull: Tightness by the pull test.

    tightness_strain: Tightness by the strain when both tools pull.

    throw_count: Number of throws in the knot.

    square_count: Number of throws that are square to the one before.

    granny_count: Number of throws that make a granny with the one before.

    unknown_count: Number of throws whose relation is not known.

    throw_records: Number of records for vbss_metrics_get_throw, undone throws included.

    phase_count: Number of visits for vbss_metrics_get_phase.

    penalty_count: Number of penalties for vbss_metrics_get_penalty.

    transfers: Number of needle transfers.

    transfers_missed: Number of missed needle transfers.

    attempts: Number of withdrawn punctures at each mark.

    drops: Number of drops.

    host_penalties: Number of penalties of the host.

    samples: Number of samples accepted.

    ticks: Number of ticks of motion evaluated so far, for the tool that has more of them.

    ticks_lost: Number of ticks not measured because `duration` was used up.

    time: Time from the needle's appearance until both tails were cut, or until now, s, on the
    clock of the hands. It includes `time_lost`.

    deviation_mm: Deviation of each puncture from its mark, along the drain, mm.

    gap_mm: Gap between the two points of the event GAP, mm.

    gap_largest_mm: Gap where the slit gapes most, mm.

    tail_mm: Length of each tail, after the cut if it was cut, mm.

    pull_held: Longest time for which the knot bore the pull, s.

    pull_strain: Largest strain that both sides reached.

    drawn_in_mm: Largest length of tail drawn in, mm.

    score: max_time - time - penalties, not below zero.

    penalties: Sum of the penalties.

    outliers: Samples of the left and the right tool left out as outliers.

    jumps: How often outliers lasted for more than 0.1 s, so that a new run began, for each
    tool.

    time_lost: Part of `time` that the simulation left out, s.

    time_simulated: Time that was simulated, s: `time` minus `time_lost`."""
    struct_size: int
    flags: int
    tightness_pull: int
    tightness_strain: int
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
    _kinds_: ClassVar[dict[str, Any]] = {"flags": MetricsFlagBits, "tightness_pull": MetricsTightness, "tightness_strain": MetricsTightness}
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("tightness_pull", c_int32),
        ("tightness_strain", c_int32),
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
    """The results of a trial so far. An unknown value is 0, and its bit is not set. Fields as
    vbss_metrics_report says."""
    flags: MetricsFlagBits
    tightness_pull: MetricsTightness
    tightness_strain: MetricsTightness
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
    """A throw that was tied. Records are in the order of their first events.

    number: Position in the knot; 0 is next to the tissue.

    standing: 1: the throw is tied; 0: it was untied.

    tool: The tool that tied it.

    wraps: Number of wraps: 1 single, 2 double, 0 not known.

    handedness: +1 right-handed, -1 left-handed, 0 not known.

    relation: Relation to the throw before.

    step: Step of its first event.

    time: Time of its first event, s.

    undone_time: Time at which it was untied, s; 0 while it is tied.

    position: Position of the throw, m.

    force: Force at the throw, N."""
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
    """A throw that was tied. Records are in the order of their first events. Fields as
    vbss_metrics_throw says."""
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
    """A visit of a phase. A phase may be visited more than once.

    number: The host's number of the phase.

    ended: 1: another phase has begun; 0: `end` is the current time, or the end of the trial.

    step: Step at which the phase began.

    begin: Time at which the phase began, s.

    end: Time at which the phase ended, s."""
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
    """A visit of a phase. A phase may be visited more than once. Fields as vbss_metrics_phase
    says."""
    number: int
    ended: int
    step: int
    begin: float
    end: float


class vbss_metrics_penalty(ctypes.Structure):
    """One reason why the score is not max_time - time. Faults that cost no points are listed too.

    kind: Kind of the penalty.

    number: Number of the mark, throw or other object, as in the event.

    tool: The tool that was used.

    step: Step of the penalty.

    time: Time of the penalty, s.

    measure: Size of the fault; its meaning depends on the kind.

    amount: Points that it costs.

    position: Position, m.

    force: Force, N.

    text: Description, a constant string; never NULL."""
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
    """One reason why the score is not max_time - time. Faults that cost no points are listed too.
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
    """Motion of one tool, and the force on it.

    valid: VBSS_METRICS_HAS_ bits.

    movement_count: Number of movements between rests that last 0.2 s to 40.96 s.

    time: Time in which the tool was seen, s.

    unseen_time: Time in which the tool was not seen, s.

    path_length: Length of the path, m.

    mean_speed: Mean speed, m/s.

    peak_speed: Peak speed, m/s.

    idle_time: Time in which the tool was idle, s.

    idle_share: Idle share of `time`, 0 to 1.

    ldj_length: Log dimensionless jerk by length, -ln(T^5/L^2 integral of |jerk|^2); higher is
    smoother.

    ldj_speed: Log dimensionless jerk by peak speed, -ln(T^3/v_peak^2 integral of |jerk|^2);
    higher is smoother.

    sparc: Spectral arc length of the whole motion as one movement.

    movement_sparc: Mean spectral arc length over the movements.

    force_peak: Largest force, N.

    force_integral: Integral of the magnitude of the force over time, N s."""
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
    """Motion of one tool, and the force on it. Fields as vbss_metrics_motion says."""
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
    """Joint motion of both tools.

    valid: VBSS_METRICS_HAS_CORRELATION, or 0.

    time: Time in which both tools were seen, s.

    correlation: Pearson's correlation of their speeds, -1 to 1.

    both_moving_time: Time in which both tools moved, s.

    one_moving_time: Time in which exactly one tool moved, s.

    still_time: Time in which both tools were idle, s.

    both_moving_share: `both_moving_time` as a share of `time`, 0 to 1."""
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
    """Joint motion of both tools. Fields as vbss_metrics_bimanual says."""
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
    "vbss_metrics_get_offset": (c_int32, (POINTER(c_double), POINTER(c_double), POINTER(c_double),
        POINTER(c_double), POINTER(c_double), POINTER(c_double))),
    "vbss_metrics_save": (c_int32, (POINTER(vbss_metrics), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_metrics_restore": (c_int32, (POINTER(vbss_metrics), POINTER(c_uint8), c_uint64)),
    "vbss_metrics_get_hash": (c_int32, (POINTER(vbss_metrics), POINTER(c_uint64))),
}
