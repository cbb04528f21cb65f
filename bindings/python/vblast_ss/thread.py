"""A suture thread, alone or as a body of a scene."""
from __future__ import annotations

import ctypes
import operator
from typing import Any, Iterable, Optional, Sequence

from ._api.baseline import BaselineStatistics, vbss_baseline_statistics
from ._api.thread import (ThreadAttachmentKind, ThreadBending, ThreadMesh, ThreadEnergies, ThreadField, ThreadMaterial, ThreadMomentum, ThreadPreset, ThreadUspSize,
                          ThreadReaction, ThreadStatistics, vbss_thread, vbss_thread_attachment, vbss_thread_config,
                          vbss_thread_energies, vbss_thread_momentum, vbss_thread_reaction, vbss_thread_statistics)
from ._library import lib
from ._objects import Body, Configured, context_or_new, created, Saved, Viewed
from ._values import constant, doubles, index, initialised, optional
from .context import Context
from .errors import check
from .views import Array

__all__ = ["ThreadAttachmentKind", "ThreadBending", "ThreadMesh", "Thread", "ThreadEnergies", "ThreadField", "ThreadMomentum",
           "ThreadMaterial", "ThreadPreset", "ThreadReaction", "ThreadStatistics", "ThreadUspSize", "grade_lengths"]


def attachment_of(kind: Any, settings: dict[str, Any]) -> vbss_thread_attachment:
    struct: vbss_thread_attachment = initialised(
        vbss_thread_attachment, lib.vbss_thread_attachment_init, {"kind": kind, **settings}, "an attachment")
    return struct


def grade_lengths(length: float, centre: float, finest: float, coarsest: float, ratio: float = 1.2) -> list[float]:
    """Rest lengths of segments that are fine about one place and grow away from it by a constant ratio, m."""
    count = ctypes.c_uint32()
    arguments = (float(length), float(centre), float(finest), float(coarsest), float(ratio))
    buffer = (ctypes.c_double * 65536)()
    check(lib.vbss_thread_grade_lengths(*arguments, buffer, len(buffer), ctypes.byref(count)))
    return list(buffer[:count.value])


class Thread(Configured, Body, Viewed, Saved):
    """An elastic rod, without twist unless it has a torsional_stiffness: a chain of nodes, numbered from 0.

        preset        a thread to start from: "silk_2_0" or "vblast"
        suture        material and USP size to start from: ("silk", "2-0"); ThreadMaterial and ThreadUspSize list them
        positions     of the nodes, n x 3, m: sets segment_count to n - 1; default straight
        rest_lengths  of the segments, m: sets segment_count; default equal

    All other keywords are settings of vbss_thread_config: Thread.settings_help() explains them and
    Thread.defaults() lists them.
    """
    _prefix, _noun = "vbss_thread", "thread"
    _config, _init, _fields = vbss_thread_config, "vbss_thread_config_init", ThreadField

    def __init__(self, context: Optional[Context] = None, *, preset: Any = None, suture: Any = None, positions: Any = None,
                 rest_lengths: Any = None, **settings: Any) -> None:
        def prepare(config: Any) -> None:
            if preset is not None:
                check(lib.vbss_thread_config_preset(ctypes.byref(config), constant(preset, ThreadPreset, "preset")))
            if suture is not None:
                material, size = suture
                if isinstance(size, str):
                    size = "usp_" + size.replace("-", "_")
                check(lib.vbss_thread_config_suture(ctypes.byref(config), constant(material, ThreadMaterial, "material"),
                                                    constant(size, ThreadUspSize, "size")))

        context = context_or_new(context)
        places = None if positions is None else doubles(positions, "positions", row=3)
        lengths = None if rest_lengths is None else doubles(rest_lengths, "rest_lengths")
        counts = {"segment_count": operator.index(settings["segment_count"])} if "segment_count" in settings else {}
        if places is not None:
            counts["positions"] = max(0, len(places) // 3 - 1)
        if lengths is not None:
            counts["rest_lengths"] = len(lengths)
        if len(set(counts.values())) > 1:
            raise ValueError("numbers of segments differ: " + ", ".join(f"{n} by {name}" for name, n in counts.items()))
        if counts:
            settings["segment_count"] = next(iter(counts.values()))
        config = initialised(vbss_thread_config, lib.vbss_thread_config_init, settings, "a thread", prepare)
        if places is not None:
            config.positions = ctypes.cast(places, ctypes.POINTER(ctypes.c_double))
        if lengths is not None:
            config.rest_lengths = ctypes.cast(lengths, ctypes.POINTER(ctypes.c_double))
        super().__init__(context, created(context, vbss_thread, lib.vbss_thread_create, context._handle,
                                          ctypes.byref(config)))

    def step(self, h: float = 1e-3) -> None:
        """Moves the thread forward by h seconds."""
        self._call(lib.vbss_thread_step, h)

    def set_state(self, positions: Any = None, velocities: Any = None) -> None:
        """Places the nodes, m, and gives them velocities, m/s; None leaves them."""
        given = [doubles(values, name, row=3) for values, name in
                 ((positions, "positions"), (velocities, "velocities")) if values is not None]
        if not given:
            return
        if len({len(values) for values in given}) > 1:
            raise ValueError("positions and velocities are of different size")
        self._call(lib.vbss_thread_set_state, given[0] if positions is not None else None,
                   given[-1] if velocities is not None else None, len(given[0]) // 3)

    # ---- what holds it

    def attach(self, kind: Any = "pin", node: int = 0, **settings: Any) -> int:
        """Attaches something to a node: "pin", "clamp", "force", "spring" or "mass", with position, direction,
        force, stiffness, damping, mass. A pin, clamp or spring without a position holds the node where it is.
        Returns the name of the attachment."""
        number = constant(kind, ThreadAttachmentKind, "kind")
        if "position" not in settings and number in (ThreadAttachmentKind.PIN, ThreadAttachmentKind.CLAMP,
                                                     ThreadAttachmentKind.SPRING):
            places = self.positions
            if 0 <= index(node, "node") < len(places):
                settings["position"] = places[node]
        attachment = attachment_of(number, {"node": node, **settings})
        name = ctypes.c_uint32()
        self._call(lib.vbss_thread_attach, ctypes.byref(attachment), ctypes.byref(name))
        return name.value

    def set_attachment_target(self, attachment: int, target: Sequence[float], direction: Optional[Sequence[float]] = None) -> None:
        """Says where an attachment shall be at the end of the next step; of a force, the force, N."""
        self._call(lib.vbss_thread_set_attachment_target, index(attachment), doubles(target, "target", 3),
                   optional(direction, "direction", 3))

    def set_roll(self, attachment: int, roll: float) -> None:
        """Says by which angle, rad, a clamp shall have turned the thread about its direction at the end of the next
        step. Needs torsional_stiffness."""
        self._call(lib.vbss_thread_set_roll, index(attachment), roll)

    def detach(self, attachment: int) -> None:
        self._call(lib.vbss_thread_detach, index(attachment))

    def reaction(self, attachment: int) -> ThreadReaction:
        """Force, and torque of a clamp, on the thread in the last step."""
        return self._read("get_reaction", ThreadReaction, vbss_thread_reaction, index(attachment))

    def cut(self, arc_length: float) -> Thread:
        """Cuts the thread, which keeps the part with node 0; returns the other. Needs cut_capacity."""
        piece = ctypes.POINTER(vbss_thread)()
        self._call(lib.vbss_thread_cut, arc_length, ctypes.byref(piece))
        return Thread._of(self._context, piece)

    # ---- what there is to see

    @property
    def positions(self) -> Array:
        """n x 3, m."""
        return self._array(ThreadField.POSITIONS)

    @property
    def velocities(self) -> Array:
        """n x 3, m/s."""
        return self._array(ThreadField.VELOCITIES)

    @property
    def rest_lengths(self) -> Array:
        """n - 1, m."""
        return self._array(ThreadField.REST_LENGTHS)

    @property
    def lengths(self) -> Array:
        """n - 1, m: of chords, or of arcs with spline bending."""
        return self._array(ThreadField.LENGTHS)

    @property
    def tensions(self) -> Array:
        """n - 1, N, at the end of the last step."""
        return self._array(ThreadField.TENSIONS)

    @property
    def curvatures(self) -> Array:
        """n x 3, 1/m: from the node to the centre of curvature."""
        return self._array(ThreadField.CURVATURES)

    @property
    def sections(self) -> Array:
        """First node of each section."""
        return self._array(ThreadField.SECTIONS)

    @property
    def sagittas(self) -> Array:
        """n - 1, m: what the mesh leaves out of the shape."""
        return self._array(ThreadField.SAGITTAS)

    @property
    def plastic_curvatures(self) -> Array:
        """n x 3, 1/m: towards the centre of curvature; 0 x 3 without memory of bends."""
        return self._array(ThreadField.PLASTIC_CURVATURES)

    @property
    def viscous_curvatures(self) -> Array:
        """n x 3, 1/m: that at which the viscous branch has no moment; 0 x 3 without memory of bends."""
        return self._array(ThreadField.VISCOUS_CURVATURES)

    @property
    def twists(self) -> Array:
        """n - 1, rad/m: twist per length; no entries without torsional_stiffness."""
        return self._array(ThreadField.TWISTS)

    @property
    def material_directors(self) -> Array:
        """n - 1 x 3: across each segment, fixed to the material; 0 x 3 without torsional_stiffness."""
        return self._array(ThreadField.MATERIAL_DIRECTORS)

    @property
    def node_count(self) -> int:
        return self.statistics.nodes

    @property
    def energies(self) -> ThreadEnergies:
        return self._read("get_energies", ThreadEnergies, vbss_thread_energies)

    @property
    def momentum(self) -> ThreadMomentum:
        return self._read("get_momentum", ThreadMomentum, vbss_thread_momentum)

    @property
    def statistics(self) -> ThreadStatistics:
        return self._read("get_statistics", ThreadStatistics, vbss_thread_statistics)

    @property
    def baseline_statistics(self) -> BaselineStatistics:
        """What only a thread of method "vblast" counts."""
        return self._read("get_baseline_statistics", BaselineStatistics, vbss_baseline_statistics)

    def _describe(self) -> str:
        numbers = self.statistics
        lengths: Iterable[float] = self.rest_lengths.tolist()
        return f"{numbers.nodes} nodes, {sum(lengths):.4g} m, t = {numbers.time:.6g} s"
