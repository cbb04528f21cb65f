"""budget.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_double, c_int32, c_uint32, c_void_p
from typing import Any, ClassVar, NamedTuple

from .base import vbss_context
from .scene import vbss_scene_config


# Reads a clock of the host. The function must return (no longjmp, no exception). Its calls that
# would change the context return VBSS_ERROR_BUSY.
vbss_budget_clock_fn = CFUNCTYPE(c_double, c_void_p)


class vbss_budget_speed(ctypes.Structure):
    """Speed of the processor core on which a measurement ran.

    steps: Number of timed steps of the fixed scene.

    operations_per_microsecond: Speed in operations, as vbss_scene_config::step_budget counts
    them, per microsecond; > 0. A few hundred on a core of 2.6 GHz. A quarter of the steps were
    at least as fast. Steps that other programs have interrupted do not affect it, as long as
    they are fewer than three quarters.

    spread: Median time of the steps divided by their lower quartile, at least 1. A value far
    above 1 means that other programs have often interrupted the measurement.

    duration: Time of all timed steps on the host's clock, s."""
    struct_size: int
    steps: int
    operations_per_microsecond: float
    spread: float
    duration: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("steps", c_uint32),
        ("operations_per_microsecond", c_double),
        ("spread", c_double),
        ("duration", c_double),
    ]


class BudgetSpeed(NamedTuple):
    """Speed of the processor core on which a measurement ran. Fields as vbss_budget_speed says."""
    steps: int
    operations_per_microsecond: float
    spread: float
    duration: float


class vbss_budget_config(ctypes.Structure):
    """Time that a call of vbss_scene_step may take. Fill it with vbss_budget_config_init, then set
    the speed.

    allows_more: 1: the limits may exceed the defaults of vbss_scene_config on a fast core;
    default 0.

    operations_per_microsecond: Speed of the core, operations per microsecond, 1e-3 to 1e6; no
    default.

    slot: Time between two calls of vbss_scene_step, s, 1e-5 to 1; default 1e-3.

    share: Share of the slot that the operations of a call may take, 0.01 to 1; default 0.5. The
    rest is for the work that operations do not count, for calls that exceed their limit, and
    for the host."""
    struct_size: int
    allows_more: int
    operations_per_microsecond: float
    slot: float
    share: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("allows_more", c_uint32),
        ("operations_per_microsecond", c_double),
        ("slot", c_double),
        ("share", c_double),
    ]


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_budget_measure_speed": (c_int32, (POINTER(vbss_context), vbss_budget_clock_fn, c_void_p,
        POINTER(vbss_budget_speed), c_uint32)),
    "vbss_budget_config_init": (c_int32, (POINTER(vbss_budget_config), c_uint32)),
    "vbss_budget_fit_scene": (c_int32, (POINTER(vbss_context), POINTER(vbss_budget_config),
        POINTER(vbss_scene_config))),
}
