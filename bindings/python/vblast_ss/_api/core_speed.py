"""core_speed.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_double, c_int32, c_uint32, c_void_p
from typing import Any, ClassVar, NamedTuple

from .base import vbss_context


# Reads a clock of the host. The function must return (no longjmp, no exception). Its calls that
# would change the context return VBSS_ERROR_BUSY.
vbss_core_speed_clock_fn = CFUNCTYPE(c_double, c_void_p)


class vbss_core_speed(ctypes.Structure):
    """Speed of the processor core on which a measurement ran.

    steps: Number of timed steps of the fixed scene.

    operations_per_us: Speed for vbss_solver_options::operations_per_us, operations per us; > 0.
    A few hundred on a core of 2.6 GHz. A quarter of the steps were at least as fast. Steps that
    other programs have interrupted do not affect it, as long as they are fewer than three
    quarters.

    spread: Median time of the steps divided by their lower quartile, at least 1. A value far
    above 1 means that other programs have often interrupted the measurement.

    duration: Time of all timed steps on the host's clock, s."""
    struct_size: int
    steps: int
    operations_per_us: float
    spread: float
    duration: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("steps", c_uint32),
        ("operations_per_us", c_double),
        ("spread", c_double),
        ("duration", c_double),
    ]


class CoreSpeed(NamedTuple):
    """Speed of the processor core on which a measurement ran. Fields as vbss_core_speed says."""
    steps: int
    operations_per_us: float
    spread: float
    duration: float


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_core_speed_measure": (c_int32, (POINTER(vbss_context), vbss_core_speed_clock_fn, c_void_p,
        POINTER(vbss_core_speed), c_uint32)),
}
