"""scene_event.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64
from enum import IntEnum, IntFlag
from typing import Any, ClassVar, NamedTuple

from .scene import vbss_scene


class SceneEventKind(IntEnum):
    """The constants of vbss_scene_event_kind."""
    TOUCH = 1
    """Two bodies have come into contact, or a body with itself."""
    PART = 2
    """Two bodies in contact have separated."""
    TRUNCATED = 3
    """A part of a step was truncated: the bodies moved as far as the guard allows, and the rest of
    the part was left out (vbss_scene_statistics::clamped). The two bodies are those that the
    guard found; 0: unknown, or the floor."""
    GRASP = 5
    """Jaws have grasped a thread, a needle or a drain."""
    RELEASE = 6
    """Jaws have opened and released a body."""
    TORN = 7
    """A body was pulled out of the jaws. The value is the force of the jaws on it."""
    SLIP = 8
    """A body begins to slide through the jaws, or to turn in them. The value is the force of the
    jaws on it."""
    GRASP_LOST = 9
    """A grasp exceeded grasp_capacity, so the thread is not held."""
    CUT = 10
    """A thread was cut. The piece is 0 if the thread had no cuts left and stayed whole."""
    EXCHANGED = 11
    """An instrument was exchanged. The id is its new vbss_grasper_kind; the position is that of
    the grasper's frame."""
    NOT_EXCHANGED = 12
    """An instrument was not exchanged. The id is the wanted vbss_grasper_kind."""
    PUNCTURE = 13
    """A needle's tip has entered a wall (VBLAST: has gone through it). The value is the force of
    the wall along the tip; 0 with method VBLAST, and where a fold of the wall came onto the
    needle."""
    WITHDRAWN = 14
    """The tip has left the hole backwards."""
    PASSED = 15
    """The needle and its swage have passed through the hole, and the thread follows."""
    HOLE_LOST = 16
    """A hole exceeded hole_capacity, so the wall is not pierced."""
    RETURNED = 17
    """The swage has come back through the hole, and the needle is in it again."""
    UNTHREADED = 18
    """An end of a thread has left the hole."""
    BLOCKED = 19
    """Two bodies hold each other back: both bodies of vbss_scene_blocker, its cause. Reported once
    until they have moved freely again."""
    UNBLOCKED = 20
    """Two bodies have moved freely for 0.1 s after BLOCKED."""
    PAUSED = 21
    """The rest of a step was left out for the bodies that did not come to its end, or a whole step
    because too many waited (vbss_scene_statistics::paused). The two bodies are those that hold
    each other back; 0: unknown, or the floor. Several groups of bodies of a step may each have
    such an event; vbss_scene_statistics::time_paused counts the longest."""
    DEFERRED = 22
    """More steps than after the call before are suspended or have not begun: work waits for a
    later call, and no time is left out (vbss_scene_statistics::behind, and `call_budget_us`)."""
    CAUGHT_UP = 23
    """No step waits any more after DEFERRED."""
    OVERDUE = 24
    """A step that two calls had suspended was completed without the budget of a call, because
    other bodies waited (vbss_scene_statistics::overdue). This call took longer than it should."""
    TEARING = 25
    """A thread begins to tear the wall at its hole (vbss_drain_config::tear_energy). Reported
    again after the force has fallen below half of the one that tears."""
    TORN_OUT = 26
    """A thread has torn out: it has cut through the wall up to a free edge and left it there, and
    the hole is gone."""


class SceneEventFlagBits(IntFlag):
    """Bits of `flags` of an event."""
    POSITION = 1
    """The event has a position."""


class vbss_scene_event(ctypes.Structure):
    """An event of a scene. vbss_scene_event_kind says which fields a kind uses. All numbers are
    finite.

    kind: Kind of the event.

    body_a: Number of the first body; 0: the floor, or none.

    body_b: Number of the second body; 0: the floor, or none.

    id: Identifier, as the kind says; 0: none.

    flags: VBSS_SCENE_EVENT_FLAG_ bits.

    step: vbss_scene_statistics::steps after the call of vbss_scene_step that reported the
    event. An event between two steps has the number of the step before.

    time: vbss_scene_statistics::time after that call, s.

    value: Value, in the unit of the kind; 0: the kind has none.

    arc_length: Arc length along a thread or needle, m; 0: the kind has none.

    position: Position in the world, m; zero without VBSS_SCENE_EVENT_FLAG_POSITION."""
    struct_size: int
    kind: int
    body_a: int
    body_b: int
    id: int
    flags: int
    step: int
    time: float
    value: float
    arc_length: float
    position: Any
    _kinds_: ClassVar[dict[str, Any]] = {"kind": SceneEventKind, "flags": SceneEventFlagBits}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("body_a", c_uint32),
        ("body_b", c_uint32),
        ("id", c_uint32),
        ("flags", c_uint32),
        ("step", c_uint64),
        ("time", c_double),
        ("value", c_double),
        ("arc_length", c_double),
        ("position", c_double * 3),
    ]


class SceneEvent(NamedTuple):
    """An event of a scene. vbss_scene_event_kind says which fields a kind uses. All numbers are
    finite. Fields as vbss_scene_event says."""
    kind: SceneEventKind
    body_a: int
    body_b: int
    id: int
    flags: SceneEventFlagBits
    step: int
    time: float
    value: float
    arc_length: float
    position: tuple[float, ...]


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_scene_take_events": (c_int32, (POINTER(vbss_scene), POINTER(vbss_scene_event), c_uint32,
        c_uint32, POINTER(c_uint32), POINTER(c_uint64))),
}
