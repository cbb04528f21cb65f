"""session_assistance.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32
from typing import Any, ClassVar

from .session import SessionAidBits, vbss_session


class vbss_session_assistance(ctypes.Structure):
    """Assistance of a session. Fill it with vbss_session_assistance_init, then change fields.

    aids: VBSS_SESSION_AID_ bits of the aids that are on; default 0.

    time_scale: Simulated time per time of the host, 0.25 to 1; default 0.5.

    direction: Direction of ARC and WIND, of any length from 1e-9 to 1e3. Default 0, 0, 0: from
    the first mark of the stitch to the second one.

    roll_step: Step of the roll, rad, 0.01 to 3.2; default pi / 4.

    sink_speed: Speed below which a hand sinks unintentionally, m/s, 0 to 1; default 4e-3.

    hold_distance: Distance within which a hand rests, m, 0 to 1; default 2e-3.

    hold_time: Time after which a hand that rests is idle, s, 0 to 10; default 0.7."""
    struct_size: int
    aids: int
    time_scale: float
    direction: Any
    roll_step: float
    sink_speed: float
    hold_distance: float
    hold_time: float
    _kinds_: ClassVar[dict[str, Any]] = {"aids": SessionAidBits}
    _fields_ = [
        ("struct_size", c_uint32),
        ("aids", c_uint32),
        ("time_scale", c_double),
        ("direction", c_double * 3),
        ("roll_step", c_double),
        ("sink_speed", c_double),
        ("hold_distance", c_double),
        ("hold_time", c_double),
    ]


class vbss_session_hand(ctypes.Structure):
    """Input of a hand. Fill it with vbss_session_hand_init, then set its fields.

    is_origin: 1: the hand is now at this pose and its tool does not move: later movements start
    here. `opening` is ignored. Default 0.

    position: Position of the tool's tip, m, each coordinate at most 1e3 in magnitude.

    orientation: Orientation of the tool, w, x, y, z, of any length from 1e-100 to 1e100;
    default 1, 0, 0, 0.

    opening: Opening of the handle, 0 (closed) to 1 (open); default 0."""
    struct_size: int
    is_origin: int
    position: Any
    orientation: Any
    opening: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("is_origin", c_uint32),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("opening", c_double),
    ]


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_session_assistance_init": (c_int32, (POINTER(vbss_session_assistance), c_uint32)),
    "vbss_session_hand_init": (c_int32, (POINTER(vbss_session_hand), c_uint32)),
    "vbss_session_set_assistance": (c_int32, (POINTER(vbss_session),
        POINTER(vbss_session_assistance))),
    "vbss_session_get_assistance": (c_int32, (POINTER(vbss_session),
        POINTER(vbss_session_assistance), c_uint32)),
    "vbss_session_move_hand": (c_int32, (POINTER(vbss_session), c_int32,
        POINTER(vbss_session_hand))),
}
