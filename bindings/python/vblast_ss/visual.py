"""Meshes to draw."""
from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Optional, Union

from ._api.visual import (VisualSpotKind, VisualField, VisualKind, VisualStatistics, vbss_visual, vbss_visual_config,
                          vbss_visual_statistics)
from ._library import lib
from ._objects import Configured, Viewed, context_or_new, created
from ._values import index, initialised
from .context import Context
from .drain import Drain
from .grasper import Grasper
from .needle import Needle
from .replica import Replica
from .scene import Scene
from .thread import Thread
from .views import Array

__all__ = ["Part", "Spot", "VisualSpotKind", "Visual", "VisualField", "VisualKind", "VisualStatistics"]

Shown = Union[Scene, Replica, Thread, Drain, Needle, Grasper]


class Part(NamedTuple):
    """A body that is drawn: its rows of vertices and triangles."""
    kind: VisualKind
    source: int
    body: int
    vertices: slice
    triangles: slice


class Spot(NamedTuple):
    """A mark or a hole: `part` is the number of the drain in parts, `material` a place of it at rest, m."""
    part: int
    kind: VisualSpotKind
    material: tuple[float, float, float]
    radius: float


class Visual(Configured, Viewed):
    """Vertices and triangles of scenes and bodies, made anew by update(). Keywords are the settings of
    vbss_visual_config (Visual.settings_help(), Visual.defaults())."""
    _prefix, _noun = "vbss_visual", "visual"
    _config, _init, _fields = vbss_visual_config, "vbss_visual_config_init", VisualField

    def __init__(self, context: Optional[Context] = None, **settings: Any) -> None:
        context = context_or_new(context)
        config = initialised(vbss_visual_config, lib.vbss_visual_config_init, settings, "a visual")
        super().__init__(context, created(context, vbss_visual, lib.vbss_visual_create, context._handle,
                                          ctypes.byref(config)))
        self._replicas: dict[int, Replica] = {}  # by their sources

    def add(self, shown: Shown) -> int:
        """Shows a scene with all that is in it, a replica of a scene, also of another context, or a body that is alone,
        from the next update on; gives its number."""
        adds = {Scene: lib.vbss_visual_add_scene, Replica: lib.vbss_visual_add_replica, Thread: lib.vbss_visual_add_thread,
                Drain: lib.vbss_visual_add_drain, Needle: lib.vbss_visual_add_needle,
                Grasper: lib.vbss_visual_add_grasper}
        for kind, function in adds.items():
            if isinstance(shown, kind):
                source = ctypes.c_uint32()
                self._call(function, shown._handle, ctypes.byref(source))
                if isinstance(shown, Replica):
                    self._replicas[source.value] = shown
                return source.value
        raise TypeError(f"a visual shows scenes, replicas and bodies, not {type(shown).__name__}")

    def remove(self, source: int) -> None:
        """Shows that no more."""
        self._call(lib.vbss_visual_remove, index(source, "source"))
        self._replicas.pop(source, None)

    def update(self) -> None:
        """Makes the meshes of all that is shown as it is now."""
        for source in [number for number, replica in self._replicas.items() if replica.closed]:
            self.remove(source)  # the memory of its context may be gone
        self._call(lib.vbss_visual_update)

    @property
    def vertices(self) -> Array:
        """x 12: position, normal, texture 2, material 3, value."""
        return self._array(VisualField.VERTICES)

    @property
    def triangles(self) -> Array:
        """x 3: vertices, counter-clockwise seen from outside."""
        return self._array(VisualField.TRIANGLES)

    @property
    def parts(self) -> list[Part]:
        """Bodies that are drawn."""
        return [Part(VisualKind(kind), source, body, slice(vertex, vertex + vertices),
                     slice(triangle, triangle + triangles))
                for kind, source, body, vertex, vertices, triangle, triangles, _
                in self._array(VisualField.PARTS).tolist()]

    @property
    def spots(self) -> list[Spot]:
        """Marks and holes of drains."""
        return [Spot(int(part), VisualSpotKind(int(kind)), (x, y, z), radius)
                for part, kind, x, y, z, radius in self._array(VisualField.SPOTS).tolist()]

    @property
    def statistics(self) -> VisualStatistics:
        """What the last update made."""
        return self._read("get_statistics", VisualStatistics, vbss_visual_statistics)

    def _describe(self) -> str:
        figures = self.statistics
        return f"of {figures.sources}: {figures.parts} parts, {figures.triangles} triangles"
