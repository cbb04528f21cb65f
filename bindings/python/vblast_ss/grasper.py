"""Tools with jaws: needle drivers and shears."""
from __future__ import annotations

import ctypes
from typing import Any, Optional, Sequence

from ._api.grasper import (GrasperField, GrasperKind, GrasperPreset, GrasperState, vbss_grasper, vbss_grasper_config,
                           vbss_grasper_state)
from ._library import lib
from ._objects import Body, Configured, context_or_new, created, Viewed
from ._values import constant, doubles, initialised, optional
from .context import Context
from .errors import check
from .views import Array

__all__ = ["Grasper", "GrasperField", "GrasperKind", "GrasperPreset", "GrasperState"]


class Grasper(Configured, Body, Viewed):
    """A tool that moves, touches, holds and cuts when the scene it was added to is stepped. `preset` is
    "straight" or "angled"; other keywords are the settings of vbss_grasper_config (Grasper.settings_help(),
    Grasper.defaults())."""
    _prefix, _noun = "vbss_grasper", "grasper"
    _config, _init, _fields = vbss_grasper_config, "vbss_grasper_config_init", GrasperField

    def __init__(self, context: Optional[Context] = None, *, preset: Any = None, **settings: Any) -> None:
        def prepare(config: Any) -> None:
            if preset is not None:
                check(lib.vbss_grasper_config_preset(ctypes.byref(config),
                                                     constant(preset, GrasperPreset, "preset")))

        context = context_or_new(context)
        config = initialised(vbss_grasper_config, lib.vbss_grasper_config_init, settings, "a grasper", prepare)
        super().__init__(context, created(context, vbss_grasper, lib.vbss_grasper_create, context._handle,
                                          ctypes.byref(config)))

    def set_target(self, position: Sequence[float], orientation: Optional[Sequence[float]] = None) -> None:
        """Says where the tip shall be at the end of the next step, m, and how the tool shall be turned."""
        self._call(lib.vbss_grasper_set_target, doubles(position, "position", 3), optional(orientation, "orientation", 4))

    def set_opening(self, opening: float) -> None:
        """Says how far the handle is open, 0 closed to 1 open."""
        self._call(lib.vbss_grasper_set_opening, opening)

    def exchange(self, kind: Any) -> None:
        """Says which tool it shall be: "needle_driver" or "shears"."""
        self._call(lib.vbss_grasper_exchange, constant(kind, GrasperKind, "kind"))

    @property
    def state(self) -> GrasperState:
        """Where it is, and what acts on it."""
        return self._read("get_state", GrasperState, vbss_grasper_state)

    @property
    def capsules(self) -> Array:
        """x 7: begin and end of the axis, radius, m: shaft, the jaw at +x, the one at -x, neck."""
        return self._array(GrasperField.CAPSULES)

    def _describe(self) -> str:
        state = self.state
        kind = getattr(state.kind, "name", str(state.kind)).lower().replace("_", " ")
        return f"{kind}, tip at " + "({:.4g}, {:.4g}, {:.4g}) m".format(*state.position) + \
            f", opening {state.opening:.3g}" + (f", body {state.body}" if state.body else "")
