"""The slit rubber tube, and sheets and tubes of the host's triangles."""
from __future__ import annotations

import ctypes
from typing import Any, Mapping, Optional, Sequence

from ._api.drain import (DrainAttachmentKind, DrainEnergies, DrainField, DrainGap, DrainMesh, DrainPlaces,
                         DrainStatistics, vbss_drain, vbss_drain_attachment, vbss_drain_config, vbss_drain_energies,
                         vbss_drain_gap, vbss_drain_places, vbss_drain_statistics, vbss_drain_surface)
from ._library import lib
from ._objects import Body, Configured, context_or_new, created, Saved, Viewed
from ._values import doubles, index, initialised, numbers
from .context import Context
from .errors import check
from .views import Array

__all__ = ["Drain", "DrainAttachmentKind", "DrainEnergies", "DrainField", "DrainGap", "DrainMesh", "DrainPlaces",
           "DrainStatistics"]


def _surface(settings: Mapping[str, Any]) -> Any:
    """A vbss_drain_surface that keeps its arrays alive."""
    surface = vbss_drain_surface()
    check(lib.vbss_drain_surface_init(ctypes.byref(surface), ctypes.sizeof(surface)))
    arrays: dict[str, Any] = {}
    for name, value in settings.items():
        if name not in _SURFACE:
            raise TypeError(f"a surface has no '{name}', but {', '.join(_SURFACE)}")
        if value is not None:
            kind, row = _SURFACE[name]
            arrays[name] = numbers(value, kind, name, row=row)
            setattr(surface, name, ctypes.cast(arrays[name], ctypes.POINTER(kind)))  # type: ignore[type-var]
    surface.node_count = len(arrays.get("positions", ())) // 3
    surface.triangle_count = len(arrays.get("triangles", ())) // 3
    surface.anchor_count = len(arrays.get("anchors", ()))
    for name in ("thickness", "young_modulus"):
        if name in arrays and len(arrays[name]) != surface.triangle_count:
            raise ValueError(f"{name} has {len(arrays[name])} numbers for {surface.triangle_count} triangles")
    surface._arrays = arrays
    return surface


_SURFACE = {"positions": (ctypes.c_double, 3), "triangles": (ctypes.c_uint32, 3), "anchors": (ctypes.c_uint32, 1),
            "thickness": (ctypes.c_double, 1), "young_modulus": (ctypes.c_double, 1)}


class Drain(Configured, Body, Viewed, Saved):
    """A thin shell, alone or as a body of a scene: the tube with a slit on top, glued at its bottom, or a surface.

        surface       a mapping of arrays in place of the tube: positions (n x 3, m, at rest), triangles (m x 3 nodes,
                      counter-clockwise seen from outside), and if wanted anchors (nodes), and thickness, m, and
                      young_modulus, Pa, of each triangle

    All other keywords are settings of vbss_drain_config (Drain.settings_help(), Drain.defaults()).
    """
    _prefix, _noun = "vbss_drain", "drain"
    _config, _init, _fields = vbss_drain_config, "vbss_drain_config_init", DrainField

    def __init__(self, context: Optional[Context] = None, *, surface: Optional[Mapping[str, Any]] = None,
                 **settings: Any) -> None:
        context = context_or_new(context)
        config = initialised(vbss_drain_config, lib.vbss_drain_config_init, settings, "a drain")
        if surface is not None:
            own = _surface(surface)
            config.surface = ctypes.pointer(own)
        super().__init__(context, created(context, vbss_drain, lib.vbss_drain_create, context._handle,
                                          ctypes.byref(config)))

    def step(self, h: float = 1e-3) -> None:
        """Moves the drain forward by h seconds."""
        self._call(lib.vbss_drain_step, h)

    def set_state(self, positions: Any = None, velocities: Any = None) -> None:
        """Places the nodes, m, and gives them velocities, m/s; None leaves them."""
        given = [doubles(values, name, row=3) for values, name in
                 ((positions, "positions"), (velocities, "velocities")) if values is not None]
        if not given:
            return
        if len({len(values) for values in given}) > 1:
            raise ValueError("positions and velocities are of different size")
        self._call(lib.vbss_drain_set_state, given[0] if positions is not None else None,
                   given[-1] if velocities is not None else None, len(given[0]) // 3)

    def attach(self, kind: Any = "pin", node: int = 0, **settings: Any) -> int:
        """Attaches a "pin", "force" or "spring" to a node, with position, force, stiffness; returns its name."""
        attachment = initialised(vbss_drain_attachment, lib.vbss_drain_attachment_init,
                                 {"kind": kind, "node": node, **settings}, "an attachment")
        name = ctypes.c_uint32()
        self._call(lib.vbss_drain_attach, ctypes.byref(attachment), ctypes.byref(name))
        return name.value

    def set_attachment_target(self, attachment: int, target: Sequence[float]) -> None:
        """Says where an attachment shall be at the end of the next step; of a force, the force, N."""
        self._call(lib.vbss_drain_set_attachment_target, index(attachment), doubles(target, "target", 3))

    def detach(self, attachment: int) -> None:
        self._call(lib.vbss_drain_detach, index(attachment))

    def reaction(self, attachment: int) -> tuple[float, float, float]:
        """Force of an attachment on the drain at the end of the last step, N."""
        force = (ctypes.c_double * 3)()
        self._call(lib.vbss_drain_get_reaction, index(attachment), force)
        return force[0], force[1], force[2]

    @property
    def positions(self) -> Array:
        """n x 3, m: of the middle surface."""
        return self._array(DrainField.POSITIONS)

    @property
    def velocities(self) -> Array:
        """n x 3, m/s."""
        return self._array(DrainField.VELOCITIES)

    @property
    def rest_positions(self) -> Array:
        """n x 3, m, in the drain's frame."""
        return self._array(DrainField.REST_POSITIONS)

    @property
    def triangles(self) -> Array:
        """m x 3 nodes, counter-clockwise seen from outside."""
        return self._array(DrainField.TRIANGLES)

    @property
    def slit_left(self) -> Array:
        """Nodes of the slit's edge on the left, with both tips, along x."""
        return self._array(DrainField.SLIT_LEFT)

    @property
    def slit_right(self) -> Array:
        """The same on the right."""
        return self._array(DrainField.SLIT_RIGHT)

    @property
    def anchors(self) -> Array:
        """Nodes of the bottom strip."""
        return self._array(DrainField.ANCHORS)

    @property
    def anchor_forces(self) -> Array:
        """x 3, N: of each anchor on the drain."""
        return self._array(DrainField.ANCHOR_FORCES)

    @property
    def strains(self) -> Array:
        """m x 3."""
        return self._array(DrainField.STRAINS)

    @property
    def curvatures(self) -> Array:
        """m x 3, 1/m: changes of curvature."""
        return self._array(DrainField.CURVATURES)

    @property
    def places(self) -> DrainPlaces:
        """Nodes of the marks and of the points between which the gap is measured."""
        return self._read("get_places", DrainPlaces, vbss_drain_places)

    @property
    def gap(self) -> DrainGap:
        """How far the slit stands open."""
        return self._read("get_gap", DrainGap, vbss_drain_gap)

    @property
    def energies(self) -> DrainEnergies:
        return self._read("get_energies", DrainEnergies, vbss_drain_energies)

    @property
    def statistics(self) -> DrainStatistics:
        return self._read("get_statistics", DrainStatistics, vbss_drain_statistics)

    def _describe(self) -> str:
        places = self.places
        gap = f"gap {1e3 * self.gap.gap:.3g} mm, " if len(self.slit_left) else ""
        return f"{places.node_count} nodes, {places.triangle_count} triangles, {gap}t = {self.statistics.time:.6g} s"
