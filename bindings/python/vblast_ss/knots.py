"""Which knot is in a thread, or in any polyline, and which one is being tied."""
from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Optional, Sequence

from ._api.knot import (KnotEvent, KnotFaultBits, KnotField, KnotHeld, KnotMethod, KnotName, KnotReason, KnotState,
                        KnotDetectorStatistics, KnotThrow, KnotThrowBits, KnotVerdict, KnotWinding, vbss_knot_detector_config,
                        vbss_knot_detector, vbss_knot_input, vbss_knot_state, vbss_knot_detector_statistics, vbss_knot_throw,
                        vbss_knot_tool, vbss_knot_winding)
from ._library import lib
from ._objects import Remade, Viewed, context_or_new, created
from ._values import constant, doubles, index, initialised
from .context import Context
from .views import Array

__all__ = ["Knot", "KnotDetector", "KnotEvent", "KnotFaultBits", "KnotHeld", "KnotHappening", "KnotMethod",
           "KnotName", "KnotReason", "KnotState", "KnotDetectorStatistics", "KnotThrow", "KnotThrowBits", "KnotTool",
           "KnotVerdict", "KnotWinding", "classify"]


class KnotTool(NamedTuple):
    """One tool: capsules between successive points of its axis, from the handle to the tip, m."""
    axis: Sequence[Sequence[float]]
    radius: Any = 0.0
    held: Any = "nothing"
    held_place: float = 0.0

    def _fill(self, struct: vbss_knot_tool) -> None:
        points = doubles(self.axis, "axis of a tool", row=3)
        count = len(points) // 3
        if not 2 <= count <= 4:
            raise ValueError(f"the axis of a tool has {count} points, and 2 to 4 are allowed")
        radii = [float(self.radius)] * (count - 1) if isinstance(self.radius, (int, float)) else \
            list(doubles(self.radius, "radius of a tool", count - 1))
        struct.point_count = count
        struct.held = constant(self.held, KnotHeld, "held")
        for i in range(count):
            struct.axis[i][:] = points[3 * i:3 * i + 3]
        struct.radius[:count - 1] = radii
        struct.held_place = self.held_place


class KnotHappening(NamedTuple):
    """An event of the last step; KnotEvent says what the numbers are."""
    kind: KnotEvent
    numbers: tuple[int, int, int]


class Knot(NamedTuple):
    """The knot in a polyline."""
    notation: str
    name: KnotName
    verdict: KnotVerdict
    throws: tuple[KnotThrow, ...]
    state: KnotState


class KnotDetector(Viewed, Remade):
    """Shown the thread as a polyline in every step, from the end of the tail limb to that of the long one.
    Keywords are the settings of vbss_knot_detector_config (KnotDetector.settings_help(), KnotDetector.defaults())."""
    _prefix, _noun = "vbss_knot_detector", "knot detector"
    _config, _init, _fields = vbss_knot_detector_config, "vbss_knot_detector_config_init", KnotField

    def __init__(self, context: Optional[Context] = None, **settings: Any) -> None:
        context = context_or_new(context)
        config = initialised(vbss_knot_detector_config, lib.vbss_knot_detector_config_init, settings, "a knot detector")
        self._settings = settings
        super().__init__(context, created(context, vbss_knot_detector, lib.vbss_knot_detector_create,
                                          context._handle, ctypes.byref(config)))

    def _show(self, function: Any, points: Any, tools: Sequence[KnotTool], holes: Sequence[Sequence[float]],
              hole_places: Optional[Sequence[float]], settings: dict[str, Any]) -> None:
        given = doubles(points, "points", row=3)
        show = initialised(vbss_knot_input, lib.vbss_knot_input_init, settings, "what a detector is shown")
        show.points, show.point_count, show.stride_bytes = given, len(given) // 3, 24
        structs = (vbss_knot_tool * max(1, len(tools)))()
        for struct, tool in zip(structs, tools):
            tool._fill(struct)
        show.tools, show.tool_count = structs, len(tools)
        if len(holes) > 2:
            raise ValueError(f"{len(holes)} holes, and at most 2 are allowed")
        show.hole_count = len(holes)
        for i, hole in enumerate(holes):
            show.holes[i][:] = doubles(hole, "hole", 3)
        for i, place in enumerate(hole_places or ()):
            show.hole_places[i] = place
        self._call(function, ctypes.byref(show))

    def step(self, points: Any, *, tools: Sequence[KnotTool] = (), holes: Sequence[Sequence[float]] = (),
             hole_places: Optional[Sequence[float]] = None, **settings: Any) -> None:
        """Shows what there is in a step, with a limited amount of work on the topology. Points are n x 3, m.
        `holes` are where the thread goes into tissue; further keywords as in vbss_knot_input: reversed, away,
        may_have_passed."""
        self._show(lib.vbss_knot_detector_step, points, tools, holes, hole_places, settings)

    def judge(self, points: Any, *, tools: Sequence[KnotTool] = (), holes: Sequence[Sequence[float]] = (),
              hole_places: Optional[Sequence[float]] = None, **settings: Any) -> Knot:
        """The same without a limit of work; returns the knot."""
        self._show(lib.vbss_knot_detector_judge, points, tools, holes, hole_places, settings)
        return self.knot

    def reset(self) -> None:
        """Forgets all that was seen."""
        self._call(lib.vbss_knot_detector_reset)

    @property
    def state(self) -> KnotState:
        return self._read("get_state", KnotState, vbss_knot_state)

    @property
    def knot(self) -> Knot:
        """What is tied."""
        state = self.state
        return Knot(self.notation, state.name, state.verdict, tuple(self.throws), state)

    def throw(self, number: int) -> KnotThrow:
        """One throw, counted from the tissue outward."""
        return self._read("get_throw", KnotThrow, vbss_knot_throw, index(number))

    @property
    def throws(self) -> list[KnotThrow]:
        """All of them."""
        return [self.throw(number) for number in range(self.state.throw_count)]

    def winding(self, tool: int) -> KnotWinding:
        """How the thread winds about one tool."""
        return self._read("get_winding", KnotWinding, vbss_knot_winding, index(tool))

    @property
    def notation(self) -> str:
        """Such as "2=1=1"; "" for no knot, "?" for one that is no stack of throws."""
        text = ctypes.create_string_buffer(64)
        self._call(lib.vbss_knot_detector_get_notation, text, len(text))
        return text.value.decode()

    @property
    def events(self) -> list[KnotHappening]:
        """What happened in the last step."""
        return [KnotHappening(KnotEvent(kind), (a, b, c)) for kind, a, b, c in
                self._array(KnotField.EVENTS).tolist()]

    @property
    def loops(self) -> Array:
        """Method "projection", n x 4: tool, the two segments of the intersecting pair, 1 if the tool is inside."""
        return self._array(KnotField.LOOPS)

    @property
    def statistics(self) -> KnotDetectorStatistics:
        return self._read("get_statistics", KnotDetectorStatistics, vbss_knot_detector_statistics)

    def _describe(self) -> str:
        state = self.state
        verdict = getattr(state.verdict, "name", str(state.verdict)).lower()
        return f"'{self.notation}', {verdict}, {state.steps} steps"


def classify(points: Any, **settings: Any) -> Knot:
    """The knot in a polyline, n x 3, from the tail's end to the long one. Keywords as for KnotDetector."""
    given = doubles(points, "points", row=3)
    settings.setdefault("point_capacity", max(1024, len(given) // 3))
    with Context() as context, KnotDetector(context, **settings) as detector:
        return detector.judge(given)
