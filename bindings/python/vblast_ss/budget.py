"""Limits of the work of a scene that fit the processor.

    speed = vb.budget_speed(context)
    scene = vb.Scene(context, **vb.fitted_limits(speed.operations_per_microsecond))

The limits of a scene are part of its logs and saved states, so a replay needs those of the log
(Replay.scene_settings), not those of the machine that replays."""
from __future__ import annotations

import ctypes
import time
from typing import Any, Callable, Optional

from ._api.budget import BudgetSpeed, vbss_budget_config, vbss_budget_clock_fn, vbss_budget_speed
from ._api.scene import vbss_scene_config
from ._library import lib
from ._objects import context_or_new
from ._values import initialised, value_of
from .context import Context

__all__ = ["BudgetSpeed", "budget_speed", "fitted_limits"]


def budget_speed(context: Optional[Context] = None, clock: Callable[[], float] = time.perf_counter) -> BudgetSpeed:
    """Measures the speed of the processor core, which takes some 40 ms. The clock returns seconds. One that stops,
    jumps or is too coarse raises ClockStoppedError, ClockJumpedError or ClockCoarseError."""
    owner = context_or_new(context)
    speed = vbss_budget_speed()
    read = vbss_budget_clock_fn(lambda user: owner._guarded(float("nan"), lambda: float(clock())))
    owner._call(lib.vbss_budget_measure_speed, owner._handle, read, None, ctypes.byref(speed), ctypes.sizeof(speed))
    return value_of(BudgetSpeed, speed)


def fitted_limits(operations_per_microsecond: float, context: Optional[Context] = None, **settings: Any) -> dict[str, int]:
    """step_budget and call_budget of a Scene for a core of that speed. Keywords are the settings of vbss_budget_config:
    `slot` (s), `share` of it, and `allows_more` than the defaults."""
    context = context_or_new(context)
    budget = initialised(vbss_budget_config, lib.vbss_budget_config_init,
                         {"operations_per_microsecond": operations_per_microsecond, **settings}, "a budget")
    config = initialised(vbss_scene_config, lib.vbss_scene_config_init, {}, "a scene")
    context._call(lib.vbss_budget_fit_scene, context._handle, ctypes.byref(budget), ctypes.byref(config))
    return {"step_budget": config.step_budget, "call_budget": config.call_budget}
