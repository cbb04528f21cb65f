"""The speed of the processor core, for the budgets of a scene's solver.

    speed = vb.measure_core_speed(context).operations_per_us
    scene = vb.Scene(context, solver={"operations_per_us": speed})

A program may store the number. It is part of the logs and saved states of a scene, so a replay needs that of the log
(Replay.scene_settings), not that of the machine that replays."""
from __future__ import annotations

import ctypes
import time
from typing import Callable, Optional

from ._api.core_speed import CoreSpeed, vbss_core_speed, vbss_core_speed_clock_fn
from ._library import lib
from ._objects import context_or_new
from ._values import value_of
from .context import Context

__all__ = ["CoreSpeed", "measure_core_speed"]


def measure_core_speed(context: Optional[Context] = None, clock: Callable[[], float] = time.perf_counter) -> CoreSpeed:
    """Measures the speed of the processor core, which takes some 40 ms. The clock returns seconds. One that stops,
    jumps or is too coarse raises ClockStoppedError, ClockJumpedError or ClockCoarseError."""
    owner = context_or_new(context)
    speed = vbss_core_speed()
    read = vbss_core_speed_clock_fn(lambda user: owner._guarded(float("nan"), lambda: float(clock())))
    owner._call(lib.vbss_core_speed_measure, owner._handle, read, None, ctypes.byref(speed), ctypes.sizeof(speed))
    return value_of(CoreSpeed, speed)
