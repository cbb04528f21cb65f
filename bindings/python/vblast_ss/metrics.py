"""How well a suture was done."""
from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Optional, Sequence

from ._api.metrics import (MetricsBimanual, MetricsFlagBits, MetricsEventKind, MetricsField, MetricsHasBits, MetricsMotion,
                           MetricsMotionBits, MetricsPenalty, MetricsPenaltyKind, MetricsPhase, MetricsRelation,
                           MetricsReport, MetricsTask, MetricsThrow, MetricsTightness, MetricsTool, vbss_metrics,
                           vbss_metrics_bimanual, vbss_metrics_config, vbss_metrics_event, vbss_metrics_motion,
                           vbss_metrics_penalty, vbss_metrics_phase, vbss_metrics_pull, vbss_metrics_report,
                           vbss_metrics_sample, vbss_metrics_throw)
from ._library import lib
from ._objects import Remade, Viewed, context_or_new, created
from ._values import constant, doubles, initialised, integer
from .context import Context
from .errors import OutOfRangeError, check
from .views import Array

__all__ = ["Metrics", "MetricsBimanual", "MetricsFlagBits", "MetricsEventKind", "MetricsField", "MetricsHasBits",
           "MetricsMotion", "MetricsMotionBits", "MetricsOffset", "MetricsPenalty", "MetricsPenaltyKind",
           "MetricsPhase", "MetricsRelation", "MetricsReport", "MetricsTask", "MetricsThrow", "MetricsTightness",
           "MetricsTool", "metrics_offset"]


class MetricsOffset(NamedTuple):
    """Where a place on a cylinder is, seen from a mark: rad about the axis, and m along it."""
    angle: float
    axial: float


def metrics_offset(axis: Sequence[float], centre: Sequence[float], mark: Sequence[float],
                   place: Sequence[float]) -> MetricsOffset:
    """The angle and axial of a puncture at a place, for the event: the axis goes through centre."""
    angle, axial = ctypes.c_double(), ctypes.c_double()
    check(lib.vbss_metrics_get_offset(doubles(axis, "axis", 3), doubles(centre, "centre", 3), doubles(mark, "mark", 3),
                                  doubles(place, "place", 3), ctypes.byref(angle), ctypes.byref(axial)))
    return MetricsOffset(angle.value, axial.value)


class Metrics(Viewed, Remade):
    """Measures one trial, of any simulator, from samples of the tools, events, and a pull test of the knot; all on
    one clock. Keywords are the settings of vbss_metrics_config (Metrics.settings_help(), Metrics.defaults())."""
    _prefix, _noun = "vbss_metrics", "measurement"
    _config, _init, _fields = vbss_metrics_config, "vbss_metrics_config_init", MetricsField

    def __init__(self, context: Optional[Context] = None, **settings: Any) -> None:
        context = context_or_new(context)
        config = initialised(vbss_metrics_config, lib.vbss_metrics_config_init, settings, "a measurement")
        self._settings = settings
        super().__init__(context, created(context, vbss_metrics, lib.vbss_metrics_create, context._handle,
                                          ctypes.byref(config)))

    # ---- what is told

    def add_sample(self, time: float, left: Optional[Sequence[float]] = None,
                   right: Optional[Sequence[float]] = None, *, left_force: Optional[Sequence[float]] = None,
                   right_force: Optional[Sequence[float]] = None, step: int = 0, time_lost: float = 0.0) -> None:
        """Where the tips are, m, and what the tools bear, N; None is not known. time_lost: simulated time that was lost
        since the clock began, s, a part of time."""
        sample = initialised(vbss_metrics_sample, lib.vbss_metrics_sample_init,
                             {"time": time, "step": step, "time_lost": time_lost}, "a sample")
        for bit, row, values, name in ((MetricsHasBits.LEFT, sample.position[0], left, "left"),
                                       (MetricsHasBits.RIGHT, sample.position[1], right, "right"),
                                       (MetricsHasBits.LEFT_FORCE, sample.force[0], left_force, "left_force"),
                                       (MetricsHasBits.RIGHT_FORCE, sample.force[1], right_force, "right_force")):
            if values is not None:
                sample.valid |= bit
                row[:] = doubles(values, name, 3)
        self._call(lib.vbss_metrics_add_sample, ctypes.byref(sample))

    def add_event(self, kind: Any, time: float, **settings: Any) -> None:
        """What happened: "needle_appears", "puncture", "throw" and the like (MetricsEventKind), with tool, number,
        undone, position, force and what else the kind wants, as in vbss_metrics_event."""
        event = initialised(vbss_metrics_event, lib.vbss_metrics_event_init, {"kind": kind, "time": time, **settings},
                            "an event")
        self._call(lib.vbss_metrics_add_event, ctypes.byref(event))

    def add_pull(self, time: float, **settings: Any) -> None:
        """A reading of the pull test: begins, tied, strain, force, drawn_in, as in vbss_metrics_pull."""
        pull = initialised(vbss_metrics_pull, lib.vbss_metrics_pull_init, {"time": time, **settings}, "a pull test")
        self._call(lib.vbss_metrics_add_pull, ctypes.byref(pull))

    def finish(self) -> None:
        """Ends the samples: motion becomes known up to the last one."""
        self._call(lib.vbss_metrics_finish)

    # ---- what is known

    @property
    def report(self) -> MetricsReport:
        """What is known of the trial so far, with the score."""
        return self._read("get_report", MetricsReport, vbss_metrics_report)

    @property
    def throws(self) -> list[MetricsThrow]:
        """In the order in which they were told, undone ones too."""
        return [self._read("get_throw", MetricsThrow, vbss_metrics_throw, number)
                for number in range(self.report.throw_records)]

    @property
    def phases(self) -> list[MetricsPhase]:
        """Visits of phases."""
        return [self._read("get_phase", MetricsPhase, vbss_metrics_phase, number)
                for number in range(self.report.phase_count)]

    @property
    def penalties(self) -> list[MetricsPenalty]:
        """Why the score is not max_time - time."""
        return [self._read("get_penalty", MetricsPenalty, vbss_metrics_penalty, number)
                for number in range(self.report.penalty_count)]

    def motion(self, tool: Any, phase: int = MetricsTask.ALL) -> MetricsMotion:
        """How the "left" or "right" tool moved, in all of the task or a visit of a phase. Takes time."""
        return self._read("get_motion", MetricsMotion, vbss_metrics_motion, constant(tool, MetricsTool, "tool"),
                          integer(phase, ctypes.c_int32, "phase"))

    def bimanual(self, phase: int = MetricsTask.ALL) -> MetricsBimanual:
        """How both tools moved together."""
        return self._read("get_bimanual", MetricsBimanual, vbss_metrics_bimanual,
                          integer(phase, ctypes.c_int32, "phase"))

    def _of_tool(self, tool: Any, left: MetricsField) -> Array:
        number = constant(tool, MetricsTool, "tool")
        if number not in (MetricsTool.LEFT, MetricsTool.RIGHT):
            raise OutOfRangeError(f"tool {number} is neither left nor right")
        return self._array(left + number)

    def speed(self, tool: Any) -> Array:
        """n, m/s, every 10 ms; 0 where it was not seen."""
        return self._of_tool(tool, MetricsField.LEFT_SPEED)

    def jerk(self, tool: Any) -> Array:
        """n, m^2/s^6, every 10 ms: |jerk|^2."""
        return self._of_tool(tool, MetricsField.LEFT_JERK)

    def force(self, tool: Any) -> Array:
        """n, N: the largest in each 10 ms."""
        return self._of_tool(tool, MetricsField.LEFT_FORCE)

    def _describe(self) -> str:
        report = self.report
        final = "final" if report.flags & MetricsFlagBits.FINAL else "so far"
        lost = f", {report.time_lost:.3g} s of it lost" if report.flags & MetricsFlagBits.TIME_LOST else ""
        return f"score {report.score:.6g} {final}, {report.throw_count} throws, t = {report.time:.6g} s{lost}"
