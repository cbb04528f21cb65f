"""scene_settings.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32
from typing import Any

from .scene import vbss_scene


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_scene_set_gravity": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(c_double))),
    "vbss_scene_set_friction": (c_int32, (POINTER(vbss_scene), c_uint32, c_double)),
    "vbss_scene_set_thread_friction": (c_int32, (POINTER(vbss_scene), c_double)),
    "vbss_scene_set_coupling": (c_int32, (POINTER(vbss_scene), c_uint32, c_double, c_double,
        c_double, c_double)),
    "vbss_scene_set_speed_limit": (c_int32, (POINTER(vbss_scene), c_double)),
    "vbss_scene_set_budgets": (c_int32, (POINTER(vbss_scene), c_double, c_double, c_double)),
    "vbss_scene_set_filter": (c_int32, (POINTER(vbss_scene), c_uint32, c_uint32, c_uint32)),
    "vbss_scene_apply_force": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(c_double),
        POINTER(c_double), POINTER(c_double))),
    "vbss_scene_set_rigid_velocity": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(c_double),
        POINTER(c_double))),
    "vbss_scene_set_rigid_pose": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(c_double),
        POINTER(c_double))),
}
