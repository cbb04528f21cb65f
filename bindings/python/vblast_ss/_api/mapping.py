"""mapping.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32
from enum import IntFlag
from typing import Any, ClassVar

from .adapter import vbss_device_sample


class MappingMouseBits(IntFlag):
    """Bits for the buttons of a mouse."""
    TURN = 1
    """Movements of the mouse turn the tool instead of shifting it."""
    CLOSE = 2
    """The jaws close; otherwise they open."""


class vbss_mapping_config(ctypes.Structure):
    """Mapping from mouse, keyboard or gamepad to a pose. Fill it with vbss_mapping_config_init,
    then change fields. Rotations are about axes of the pose's frame.

    pad_curve: Gamepad: power of the deflection, 1 to 4; default 2.

    right: Direction to the right of the screen, unit to 1e-6; default x.

    up: Direction to the top of the screen, normal to `right`; default y. Right x up points
    towards the user.

    low: Lower corner of the box to which positions are confined, m; default -0.1.

    high: Upper corner of the box, m, each coordinate at most 1e3 in magnitude; default 0.1.

    mouse_metres: Mouse: metres per count; default 1e-4.

    mouse_depth: Mouse: metres away from the user per notch of the wheel; default 2e-3.

    mouse_radians: Mouse, turning: rad per count; default 5e-3.

    mouse_roll: Mouse, turning: rad about the direction of depth per notch; default 0.1.

    jaw_rate: Mouse: speed at which the jaws close and open, 1/s, 0 to 1e3; default 4.

    key_metres: Keyboard: metres per press; default 1e-3.

    key_radians: Keyboard: rad per press; default 0.05.

    key_jaw: Keyboard: change of the opening per press; default 0.1.

    pad_speed: Gamepad: m/s at full deflection; default 0.1.

    pad_turning: Gamepad: rad/s at full deflection; default 1.

    pad_dead: Gamepad: deflection that counts as zero, 0 to 0.9; default 0.15."""
    struct_size: int
    pad_curve: int
    right: Any
    up: Any
    low: Any
    high: Any
    mouse_metres: float
    mouse_depth: float
    mouse_radians: float
    mouse_roll: float
    jaw_rate: float
    key_metres: float
    key_radians: float
    key_jaw: float
    pad_speed: float
    pad_turning: float
    pad_dead: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("pad_curve", c_uint32),
        ("right", c_double * 3),
        ("up", c_double * 3),
        ("low", c_double * 3),
        ("high", c_double * 3),
        ("mouse_metres", c_double),
        ("mouse_depth", c_double),
        ("mouse_radians", c_double),
        ("mouse_roll", c_double),
        ("jaw_rate", c_double),
        ("key_metres", c_double),
        ("key_radians", c_double),
        ("key_jaw", c_double),
        ("pad_speed", c_double),
        ("pad_turning", c_double),
        ("pad_dead", c_double),
    ]


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_mapping_config_init": (c_int32, (POINTER(vbss_mapping_config), c_uint32)),
    "vbss_mapping_mouse": (c_int32, (POINTER(vbss_mapping_config), POINTER(c_double), c_uint32,
        c_double, POINTER(vbss_device_sample))),
    "vbss_mapping_keyboard": (c_int32, (POINTER(vbss_mapping_config), POINTER(c_double), c_double,
        POINTER(vbss_device_sample))),
    "vbss_mapping_gamepad": (c_int32, (POINTER(vbss_mapping_config), POINTER(c_double), c_double,
        c_double, POINTER(vbss_device_sample))),
}
