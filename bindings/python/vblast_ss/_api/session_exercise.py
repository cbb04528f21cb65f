"""session_exercise.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_uint32, c_uint64, c_uint8
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .session import SessionAidBits, SessionExercise, vbss_session


class SessionOutcome(IntEnum):
    """The constants of vbss_session_outcome."""
    NONE = 0
    """There is no exercise, or it has not ended."""
    PASSED = 1
    """The goal is reached, and each measure is within its mark."""
    FAILED = 2
    """A measure misses its mark, or the goal was not reached."""


class SessionMeasureKind(IntEnum):
    """The constants of vbss_session_measure_kind. Each comment ends with the exercises and the
    pass mark."""
    TIME = 1
    """Time of the exercise, s. All; TAKE_NEEDLE and CUT at most 60, PASS_MARK and throws at most
    120. At this time the exercise ends."""
    GRASP_SHARE = 2
    """Where the needle is held, as a share of its length from the tip. TAKE_NEEDLE: 0.47 to 0.7;
    courses ask for half to two thirds."""
    GRASP_ANGLE = 3
    """Angle between the jaws that hold the needle and the normal of the needle's plane, rad.
    TAKE_NEEDLE: at most 30 degrees."""
    DROPS = 4
    """Number of times that the needle was dropped. TAKE_NEEDLE: 0."""
    DEVIATION = 5
    """Distance of the first hole from its mark on the surface of the drain, m. PASS_MARK: at most
    1 mm, the published accuracy of proficient trainees."""
    ENTRY_ANGLE = 6
    """Angle between the needle's tip and the normal of the wall as the first hole is made, rad.
    PASS_MARK: at most 30 degrees; courses ask for 0."""
    STRAYS = 7
    """Number of holes beside the stitch. PASS_MARK: 0."""
    WRAPS = 8
    """Wraps of the throw. SINGLE_THROW and SQUARE_THROW: 1; DOUBLE_THROW: 2."""
    SQUARE = 9
    """1: the throw is square to the one before; 0: it is not, or this is not known. SQUARE_THROW:
    1."""
    GAP = 10
    """Largest gap along the slit at the outcome, m. Throws: at most 1 mm."""
    TENSION = 11
    """Largest tension of the thread during the exercise that lasts for the session's `dwell` of
    simulated time, N: the largest of the minima of successive intervals of that length. Throws:
    at most 6.1 N, the published maximum while experts tie on a drain."""
    SHORT_TAIL = 12
    """Remaining length of the short tail, m. CUT: 2 to 8 mm; courses ask for 3 to 5 mm."""
    LONG_TAIL = 13
    """Remaining length of the needle's tail, m. CUT: 2 to 8 mm."""


class vbss_session_exercise_state(ctypes.Structure):
    """The exercise of a session and its outcome.

    exercise: The exercise; NONE: the session runs the whole task.

    outcome: The outcome.

    measure_count: Number of measures; 0 without an exercise.

    missed: Bit i: measure i is not known yet, or is outside its pass mark.

    aids_used: VBSS_SESSION_AID_ bits of the aids that were on; 0: the exercise was not
    assisted.

    name: Name, such as "take_needle": a constant string, "" for NONE.

    sentence: The goal as an English sentence: a constant string, "" for NONE.

    time: Time since the start, until the outcome or now, s."""
    struct_size: int
    exercise: int
    outcome: int
    measure_count: int
    missed: int
    aids_used: int
    name: Any
    sentence: Any
    time: float
    _kinds_: ClassVar[dict[str, Any]] = {"exercise": SessionExercise, "outcome": SessionOutcome, "aids_used": SessionAidBits}
    _fields_ = [
        ("struct_size", c_uint32),
        ("exercise", c_int32),
        ("outcome", c_int32),
        ("measure_count", c_uint32),
        ("missed", c_uint32),
        ("aids_used", c_uint32),
        ("name", c_char_p),
        ("sentence", c_char_p),
        ("time", c_double),
    ]


class SessionExerciseState(NamedTuple):
    """The exercise of a session and its outcome. Fields as vbss_session_exercise_state says."""
    exercise: SessionExercise
    outcome: SessionOutcome
    measure_count: int
    missed: int
    aids_used: SessionAidBits
    name: str
    sentence: str
    time: float


class vbss_session_measure(ctypes.Structure):
    """A measure of an exercise. It is met if it is known, and `low` <= `value` <= `high`.

    kind: Kind of the measure, which says its unit.

    is_known: 1: `value` is known; 0: not yet, and `value` is zero.

    is_met: 1: the value is known and within the pass mark.

    name: Short English name: a constant string, never NULL.

    value: The value; its unit is that of the kind.

    low: Smallest value that passes.

    high: Largest value that passes."""
    struct_size: int
    kind: int
    is_known: int
    is_met: int
    name: Any
    value: float
    low: float
    high: float
    _kinds_: ClassVar[dict[str, Any]] = {"kind": SessionMeasureKind}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("is_known", c_uint32),
        ("is_met", c_uint32),
        ("name", c_char_p),
        ("value", c_double),
        ("low", c_double),
        ("high", c_double),
    ]


class SessionMeasure(NamedTuple):
    """A measure of an exercise. It is met if it is known, and `low` <= `value` <= `high`. Fields
    as vbss_session_measure says."""
    kind: SessionMeasureKind
    is_known: int
    is_met: int
    name: str
    value: float
    low: float
    high: float


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_session_begin_at": (c_int32, (POINTER(vbss_session), POINTER(c_uint8), c_uint64)),
    "vbss_session_get_exercise": (c_int32, (POINTER(vbss_session),
        POINTER(vbss_session_exercise_state), c_uint32)),
    "vbss_session_get_measure": (c_int32, (POINTER(vbss_session), c_uint32,
        POINTER(vbss_session_measure), c_uint32)),
    "vbss_session_exercise_name": (c_char_p, (c_int32,)),
    "vbss_session_exercise_string": (c_char_p, (c_int32,)),
}
