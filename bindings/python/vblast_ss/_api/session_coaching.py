"""session_coaching.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_uint32, c_uint64
from enum import IntEnum, IntFlag
from typing import Any, ClassVar, NamedTuple

from .metrics import MetricsTool
from .session import vbss_session


class SessionGoal(IntEnum):
    """The constants of vbss_session_goal. "The hand" is vbss_session_coaching.tool. Each comment
    says which geometry is given, and which numbers become zero when the goal is met."""
    NONE = 0
    """There is no goal: before the first step, or after the end."""
    TAKE_NEEDLE = 1
    """The hand takes the needle. POINT: on the needle; DIRECTION: of the jaws. `distance` of the
    tool's tip from the point; `angle` between jaws and direction."""
    REACH_MARK = 2
    """The hand brings the needle's tip to mark `number` (0 left, 1 right). POINT: the mark;
    DIRECTION: into the wall. `distance` of the tip from the mark; `angle` between tip and
    direction."""
    PIERCE = 3
    """The hand pushes the tip through the wall at mark `number`. Geometry and numbers as for
    REACH_MARK, and ARC: the needle's own arc."""
    DRIVE = 4
    """The hand turns the needle along its own arc to mark `number`. POINT: the mark; ARC: from the
    tip to beside the mark. `angle` of the arc; `distance` of the tip from the mark; `offset`:
    how far the arc misses the mark."""
    EXPOSE_TIP = 5
    """The tip is out: the hand turns the needle on until it can be taken there. ARC; `length` that
    must still come out."""
    TAKE_TIP = 6
    """The hand takes the needle beyond the second hole. POINT, DIRECTION, `distance` and `angle`
    as for TAKE_NEEDLE."""
    RELEASE_NEEDLE = 7
    """The hand opens its jaws and releases the needle, which the other one holds. POINT: the
    tool's tip."""
    DRAW_NEEDLE = 8
    """The hand turns the needle out of the drain along its arc. ARC; `length` of needle that is
    still in front of the second hole."""
    DRAW_THREAD = 9
    """The hand draws the thread through. POINT: the second hole; DIRECTION: to pull; `length` of
    tail beyond `tail_high`."""
    LENGTHEN_TAIL = 10
    """The tail is too short: the hand draws it back. POINT: on the tail, beside the first hole;
    DIRECTION: to pull; `length` that is missing; `distance` of the tool's tip from the point."""
    WIND = 11
    """The hand winds the needle's limb round the other tool for throw `number` (0, 1, 2). POINT:
    where the other tool's tip shall be, over the drain at rest; DIRECTION: in which its jaws
    shall point; ARC: about its jaws, `arc_angle` with the turns that are missing; `turns` that
    are missing; `distance` of the other tool's tip from the point, which need not become zero."""
    TAKE_TAIL = 12
    """The hand, with the turns on its jaws, takes the tail near its end. POINT: on the tail;
    DIRECTION: along the tail, from its end. `distance` of the tool's tip from the point."""
    RELEASE_TAIL = 13
    """The hand opens its jaws and releases the thread. POINT: the tool's tip."""
    DRAW_TAIL = 14
    """The hand draws the tail through the turns. POINT: the slit; DIRECTION: to pull; ARC: from
    the tool's tip over the slit down to its own side, where the arc is no longer given; `turns`
    that are still on its jaws."""
    SEAT = 15
    """Both hands pull throw `number` down, the hand in DIRECTION and the other one opposite, each
    with `pull_force`. If the slit is open under a second or third throw that hangs loose,
    DIRECTION is to the other hand's side: from there the throw draws the one below tight.
    POINT: the slit; `force` that the weaker end misses to that; `length`: gap of the slit
    beyond `seat_gap`."""
    HAND_OVER = 16
    """The hand takes the needle from the other one after throw `number`. POINT, DIRECTION,
    `distance` and `angle` as for TAKE_NEEDLE."""
    TAKE_SHEARS = 17
    """The hand exchanges its tool for shears."""
    CUT = 18
    """The hand cuts tail `number` (0: the short one, 1: the needle's). POINT: where to cut;
    DIRECTION: along the tail, from the knot. `distance` of the shears' tip from the point."""


class SessionMistake(IntEnum):
    """The constants of vbss_session_mistake. "Ends" gives the condition under which a mistake
    ends."""
    NONE = 0
    """There is no mistake."""
    NEEDLE_DROPPED = 1
    """No hand holds the needle, and it is in no wall. Ends: a hand holds it."""
    ENTRY_MISSED = 2
    """The first hole is more than 1 mm from its mark. Ends: the needle leaves the hole."""
    EXIT_MISSED = 3
    """The second hole is more than 1 mm from its mark. Ends: the needle leaves the hole."""
    STRAY_HOLE = 4
    """A wall is pierced beside the stitch. Ends: that hole is empty."""
    NEEDLE_WITHDRAWN = 5
    """The needle was drawn back out of the first hole. Ends: it is pierced again."""
    THREAD_PULLED_OUT = 6
    """The thread was pulled out of the stitch. Ends: the needle is in a wall again."""
    TAIL_SHORT = 7
    """The tail is shorter than `tail_low`. Ends: it is longer, or a throw is begun."""
    TAIL_LONG = 8
    """The first throw was begun with a tail longer than `tail_high`. Ends: the turns are off."""
    TOWARD_HANDLE = 9
    """The turns progress towards the handle and tie nothing. Ends: they no longer do."""
    WRONG_SENSE = 10
    """The limb is wound in the sense of the throw before: a granny. Ends: it is unwound."""
    TURNS_LOST = 11
    """Turns came off the jaws before the tail was taken, but for those that had to be unwound.
    Ends: they are wound again."""
    TOO_FEW_TURNS = 12
    """The tail was taken with too few turns on the jaws. Ends: it is released, or tied all the
    same."""
    BIGHT = 13
    """The tail is held too far from its end, and a bight of it would be drawn through. Ends: it is
    released, or held near its end."""
    TAIL_DROPPED = 14
    """The tail was dropped before the throw was tied. Ends: it is held again, or the turns are
    off."""
    THROW_UNDONE = 15
    """A tied throw came undone. Ends: as many throws are tied again."""
    GRANNY = 16
    """A throw is tied in the sense of the one before. Ends: it comes undone."""
    TOO_FEW_WRAPS = 17
    """The first throw is tied with one wrap. Ends: it comes undone."""
    TOO_MANY_WRAPS = 18
    """A throw is tied with more wraps than it needs. Ends: it comes undone."""
    STRAY_KNOT = 19
    """There is a knot in one limb alone. Ends: it is open."""
    CAPSIZED = 20
    """The first throw, while it is alone, has capsized into a half hitch, which slides. Ends: it
    is flat again."""
    ONE_SIDED = 21
    """One end of an unseated throw is pulled and the other is not, or gives way, so that the tail
    of the first throw becomes 15 mm longer than `tail_high`. Ends: both or neither are, or the
    throw is seated."""
    SLACK = 22
    """A throw has been tied for 5 s, and both of its ends are slack. Ends: both ends are tense, or
    the throw is seated."""
    SLIT_OPENED = 23
    """The slit has opened under a seated throw. Ends: the throw is seated, or the next one is tied
    on it."""
    WALLS_CROSSED = 24
    """The walls of the slit have slipped past each other. Ends: they meet again."""
    DRAIN_TEARING = 25
    """An anchor of the drain bears more than 0.8 of its strength. Ends: it bears less."""
    PULLED_HARD = 26
    """The tension of the thread exceeds 6 N. Ends: it falls below."""
    TRANSFER_MISSED = 27
    """A throw is tied, and the needle has not changed hands before. Ends: it comes undone."""
    TIME_UP = 28
    """The time limit has passed. Does not end."""
    DRAIN_TORN = 29
    """The drain is torn off. Does not end."""
    CUT_EARLY = 30
    """Cut before the third throw. Does not end."""
    CUT_KNOT = 31
    """Cut in the knot or stitch. Does not end."""
    THREAD_BROKEN = 32
    """The thread has broken. Does not end."""
    COUNT = 33
    """One more than the largest mistake."""


class SessionGeometryBits(IntFlag):
    """Bits for the geometry that a goal has."""
    POINT = 1
    """`point` is given."""
    DIRECTION = 2
    """`direction` is given."""
    ARC = 4
    """The fields `arc_` are given."""
    PULL = 8
    """`pull_force` is given; the pull is along `direction`."""


class vbss_session_coaching(ctypes.Structure):
    """Goal and mistakes of a session that coaches. A number that the goal does not use is zero.

    goal: The next goal.

    tool: The hand that acts; NONE: no goal, or the session's third tool.

    number: Mark, throw or tail of the goal, as its comment says; otherwise 0.

    sentence: The goal as an English sentence: a constant string, never NULL.

    mistake: The newest mistake that has not ended. One that cannot be mended is given for 5 s,
    those of a failure for good.

    is_mendable: 1: the mistake can still be mended.

    mistake_sentence: The mistake as a sentence: constant, "" without one.

    remedy: How to mend the mistake, or how to go on: a constant string, "" without one.

    mistakes: Bit m: mistake m has not ended.

    geometry: VBSS_SESSION_GEOMETRY_ bits of the fields below.

    point: Where to go or to pull from, m.

    direction: Unit vector.

    arc_centre: Centre of the arc or circle to follow, m.

    arc_axis: Unit axis; the arc goes about it by the right-hand rule.

    arc_start: Where the arc starts, m.

    arc_radius: Radius of the arc, m.

    arc_angle: Angle that is left, rad, 0 or more; several turns for a winding.

    pull_force: Force to pull with at each end, N.

    distance: Distance to go, m.

    angle: Angle to turn by, rad.

    offset: DRIVE: distance by which the arc misses the mark, m.

    turns: Turns that are missing, or that must come off.

    force: Force that is missing, N.

    length: Length or gap that is missing, m.

    goal_time: Time since the goal began, s.

    mistake_time: Session time at which `mistake` was seen, s."""
    struct_size: int
    goal: int
    tool: int
    number: int
    sentence: Any
    mistake: int
    is_mendable: int
    mistake_sentence: Any
    remedy: Any
    mistakes: int
    geometry: int
    reserved: int
    point: Any
    direction: Any
    arc_centre: Any
    arc_axis: Any
    arc_start: Any
    arc_radius: float
    arc_angle: float
    pull_force: float
    distance: float
    angle: float
    offset: float
    turns: float
    force: float
    length: float
    goal_time: float
    mistake_time: float
    _kinds_: ClassVar[dict[str, Any]] = {"goal": SessionGoal, "tool": MetricsTool, "mistake": SessionMistake, "geometry": SessionGeometryBits}
    _fields_ = [
        ("struct_size", c_uint32),
        ("goal", c_int32),
        ("tool", c_int32),
        ("number", c_uint32),
        ("sentence", c_char_p),
        ("mistake", c_int32),
        ("is_mendable", c_uint32),
        ("mistake_sentence", c_char_p),
        ("remedy", c_char_p),
        ("mistakes", c_uint64),
        ("geometry", c_uint32),
        ("reserved", c_uint32),
        ("point", c_double * 3),
        ("direction", c_double * 3),
        ("arc_centre", c_double * 3),
        ("arc_axis", c_double * 3),
        ("arc_start", c_double * 3),
        ("arc_radius", c_double),
        ("arc_angle", c_double),
        ("pull_force", c_double),
        ("distance", c_double),
        ("angle", c_double),
        ("offset", c_double),
        ("turns", c_double),
        ("force", c_double),
        ("length", c_double),
        ("goal_time", c_double),
        ("mistake_time", c_double),
    ]


class SessionCoaching(NamedTuple):
    """Goal and mistakes of a session that coaches. A number that the goal does not use is zero.
    Fields as vbss_session_coaching says."""
    goal: SessionGoal
    tool: MetricsTool
    number: int
    sentence: str
    mistake: SessionMistake
    is_mendable: int
    mistake_sentence: str
    remedy: str
    mistakes: int
    geometry: SessionGeometryBits
    point: tuple[float, ...]
    direction: tuple[float, ...]
    arc_centre: tuple[float, ...]
    arc_axis: tuple[float, ...]
    arc_start: tuple[float, ...]
    arc_radius: float
    arc_angle: float
    pull_force: float
    distance: float
    angle: float
    offset: float
    turns: float
    force: float
    length: float
    goal_time: float
    mistake_time: float


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_session_get_coaching": (c_int32, (POINTER(vbss_session), POINTER(vbss_session_coaching),
        c_uint32)),
    "vbss_session_mistake_string": (c_char_p, (c_int32,)),
    "vbss_session_remedy_string": (c_char_p, (c_int32,)),
}
