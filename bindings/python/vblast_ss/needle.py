"""The curved needle."""
from __future__ import annotations

import ctypes
from typing import Any, Optional, Sequence

from ._api.needle import (NeedleEnergies, NeedleField, NeedleMass, NeedlePreset, NeedleState, vbss_needle,
                          vbss_needle_config, vbss_needle_energies, vbss_needle_mass, vbss_needle_state)
from ._library import lib
from ._objects import Body, Configured, context_or_new, created, Saved, Viewed
from ._values import constant, doubles, initialised, optional
from .context import Context
from .errors import check
from .views import Array

__all__ = ["Needle", "NeedleEnergies", "NeedleField", "NeedleMass", "NeedlePreset", "NeedleState"]


class Needle(Configured, Body, Viewed, Saved):
    """A rigid arc of round wire, in free flight or as a body of a scene. `preset` is "vblast" or "sh"; `shape` is the
    share of a circle, the length along the arc and the diameter of the wire, m, as catalogues have them: (0.5, 26e-3, 0.7e-3). Other
    keywords are the settings of vbss_needle_config (Needle.settings_help(), Needle.defaults())."""
    _prefix, _noun = "vbss_needle", "needle"
    _config, _init, _fields = vbss_needle_config, "vbss_needle_config_init", NeedleField

    def __init__(self, context: Optional[Context] = None, *, preset: Any = None, shape: Any = None, **settings: Any) -> None:
        def prepare(config: Any) -> None:
            if preset is not None:
                check(lib.vbss_needle_config_preset(ctypes.byref(config), constant(preset, NeedlePreset, "preset")))
            if shape is not None:
                circle, length, wire_diameter = shape
                check(lib.vbss_needle_config_shape(ctypes.byref(config), circle, length, wire_diameter))

        context = context_or_new(context)
        config = initialised(vbss_needle_config, lib.vbss_needle_config_init, settings, "a needle", prepare)
        super().__init__(context, created(context, vbss_needle, lib.vbss_needle_create, context._handle,
                                          ctypes.byref(config)))

    def step(self, h: float = 1e-3) -> None:
        """Moves the needle forward by h seconds of free flight."""
        self._call(lib.vbss_needle_step, h)

    def set_state(self, position: Sequence[float], orientation: Optional[Sequence[float]] = None,
                  velocity: Optional[Sequence[float]] = None,
                  angular_velocity: Optional[Sequence[float]] = None) -> None:
        """Puts the needle somewhere; without velocities it rests."""
        self._call(lib.vbss_needle_set_state, doubles(position, "position", 3),
                   optional(orientation, "orientation", 4), optional(velocity, "velocity", 3),
                   optional(angular_velocity, "angular_velocity", 3))

    def place(self, arc_length: float) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """Position and direction toward the tip, at a length from the tip toward the swage, m."""
        position, direction = (ctypes.c_double * 3)(), (ctypes.c_double * 3)()
        self._call(lib.vbss_needle_get_place, arc_length, position, direction)
        return (position[0], position[1], position[2]), (direction[0], direction[1], direction[2])

    @property
    def state(self) -> NeedleState:
        """Where it is, with tip and swage."""
        return self._read("get_state", NeedleState, vbss_needle_state)

    @property
    def mass(self) -> NeedleMass:
        """What it weighs."""
        return self._read("get_mass", NeedleMass, vbss_needle_mass)

    @property
    def energies(self) -> NeedleEnergies:
        return self._read("get_energies", NeedleEnergies, vbss_needle_energies)

    @property
    def points(self) -> Array:
        """x 3, m: ends of the capsules' axes, from the tip to the swage."""
        return self._array(NeedleField.POINTS)

    def _describe(self) -> str:
        state = self.state
        return "tip at ({:.4g}, {:.4g}, {:.4g}) m".format(*state.tip) + (f", body {state.body}" if state.body else "")
