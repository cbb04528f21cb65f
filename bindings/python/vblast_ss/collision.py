"""Closest points, continuous collision tests, and the search for pairs worth testing."""
from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Optional, Sequence

from ._api.baseline import BaselineStatistics, vbss_baseline_statistics
from ._api.collision import (CollisionClosest, CollisionField, CollisionMethod, CollisionStatistics, CollisionDecision, CollisionImpact, CollisionPairKind,
                             CollisionResponse, CollisionResponseVariant, vbss_collision_closest, vbss_collision, vbss_collision_batch,
                             vbss_collision_config, vbss_collision_statistics, vbss_collision_impact, vbss_collision_response)
from ._library import lib
from ._objects import Configured, Saved, Viewed, context_or_new, created
from ._values import constant, doubles, index, initialised, numbers, numpy, optional, value_of
from .context import Context
from .errors import check
from .views import Array

__all__ = ["Answers", "CollisionClosest", "Collision", "CollisionField", "CollisionMethod", "CollisionStatistics", "CollisionDecision",
           "CollisionImpact", "CollisionPairKind", "CollisionResponse", "CollisionResponseVariant", "closest_capsules", "closest_point_triangle",
           "closest_segment_triangle", "closest_segments", "vblast_response", "test_edges", "test_point_triangle"]


def _closest(function: Any, *arguments: Any) -> CollisionClosest:
    found = vbss_collision_closest()
    check(function(*arguments, ctypes.byref(found), ctypes.sizeof(found)))
    return value_of(CollisionClosest, found)


def closest_segments(a: Any, b: Any) -> CollisionClosest:
    """Closest points of two segments, each two points, m."""
    return _closest(lib.vbss_collision_closest_segments, doubles(a, "a", 6), doubles(b, "b", 6))


def closest_point_triangle(point: Any, triangle: Any) -> CollisionClosest:
    """Closest points of a point (a) and a triangle (b)."""
    return _closest(lib.vbss_collision_closest_point_triangle, doubles(point, "point", 3), doubles(triangle, "triangle", 9))


def closest_segment_triangle(segment: Any, triangle: Any) -> CollisionClosest:
    """Closest points of a segment (a) and a triangle (b); distance 0 where it goes through."""
    return _closest(lib.vbss_collision_closest_segment_triangle, doubles(segment, "segment", 6),
                    doubles(triangle, "triangle", 9))


def closest_capsules(a: Any, radius_a: float, b: Any, radius_b: float) -> CollisionClosest:
    """Closest points of the surfaces of two capsules; the distance is negative when they overlap."""
    return _closest(lib.vbss_collision_closest_capsules, doubles(a, "a", 6), float(radius_a), doubles(b, "b", 6),
                    float(radius_b))


def _config(settings: dict[str, Any]) -> vbss_collision_config:
    config: vbss_collision_config = initialised(vbss_collision_config, lib.vbss_collision_config_init, settings,
                                                "a collision test")
    return config


def _test(function: Any, start: Any, end: Any, settings: dict[str, Any]) -> CollisionImpact:
    found, config = vbss_collision_impact(), _config(settings)
    check(function(ctypes.byref(config), doubles(start, "start", 12), doubles(end, "end", 12), ctypes.byref(found),
                   ctypes.sizeof(found)))
    return value_of(CollisionImpact, found)


def test_edges(start: Any, end: Any, **settings: Any) -> CollisionImpact:
    """Whether two moving edges come within `thickness` of each other: a0, a1, b0, b1 at time 0 and at time 1, m.
    Keywords as in vbss_collision_config."""
    return _test(lib.vbss_collision_test_edges, start, end, settings)


def test_point_triangle(start: Any, end: Any, **settings: Any) -> CollisionImpact:
    """The same of a moving point and a moving triangle: the point, then its corners."""
    return _test(lib.vbss_collision_test_point_triangle, start, end, settings)


# Not tests of their own, whatever a test runner thinks of their names.
test_edges.__test__ = test_point_triangle.__test__ = False  # type: ignore[attr-defined]


def vblast_response(kind: Any, variant: Any, impact: Optional[CollisionImpact], start: Any, end: Any, thickness: float,
                   inverse_masses: Sequence[float] = (1.0, 1.0, 1.0, 1.0)) -> CollisionResponse:
    """The paper's response to a hit: how far to move the four vertices. `kind` is "edge_edge" or
    "point_triangle", `variant` "end_of_step" or "time_of_impact"."""
    given = None
    if impact is not None:
        struct = vbss_collision_impact(struct_size=ctypes.sizeof(vbss_collision_impact))
        for name, value in impact._asdict().items():
            if isinstance(value, tuple):
                getattr(struct, name)[:] = value
            else:
                setattr(struct, name, value)
        given = ctypes.byref(struct)
    found = vbss_collision_response()
    check(lib.vbss_collision_get_vblast_response(constant(kind, CollisionPairKind, "kind"), constant(variant, CollisionResponseVariant, "variant"),
                                  given, doubles(start, "start", 12), doubles(end, "end", 12), float(thickness),
                                  doubles(inverse_masses, "inverse_masses", 4), ctypes.byref(found),
                                  ctypes.sizeof(found)))
    return value_of(CollisionResponse, found)


class Answers(NamedTuple):
    """Answers of a batch, one a question: arrays with numpy, lists without."""
    hit: Any
    decision: Any
    time: Any
    normal: Any
    weights: Any


class Collision(Configured, Viewed, Saved):
    """Moving shapes, their candidates and impacts, and single tests that are counted. Keywords are the settings
    of vbss_collision_config (Collision.settings_help(), Collision.defaults())."""
    _prefix, _noun = "vbss_collision", "collision object"
    _config, _init, _fields = vbss_collision_config, "vbss_collision_config_init", CollisionField

    def __init__(self, context: Optional[Context] = None, **settings: Any) -> None:
        context = context_or_new(context)
        config = _config(settings)
        super().__init__(context, created(context, vbss_collision, lib.vbss_collision_create, context._handle,
                                          ctypes.byref(config)))

    def test(self, kind: Any, start: Any, end: Any) -> CollisionImpact:
        """One continuous test: "edge_edge" or "point_triangle"."""
        return self._read("test", CollisionImpact, vbss_collision_impact, constant(kind, CollisionPairKind, "kind"),
                          doubles(start, "start", 12), doubles(end, "end", 12))

    def test_batch(self, kind: Any, start: Any, end: Any, thickness: Optional[Any] = None) -> Answers:
        """Many tests: `start` and `end` are n x 4 x 3, m; `thickness` is n, or the object's."""
        first, last = doubles(start, "start", row=12), doubles(end, "end", row=12)
        if len(first) != len(last):
            raise ValueError(f"start has {len(first)} numbers, and end {len(last)}")
        count = len(first) // 12
        rows = [self._rows(array, count) for array in (first, last)]
        batch = initialised(vbss_collision_batch, lib.vbss_collision_batch_init, {}, "a batch")
        batch.kind, batch.count, batch.stride = constant(kind, CollisionPairKind, "kind"), count, count
        room = max(1, count)
        hit, decision = (ctypes.c_int32 * room)(), (ctypes.c_int32 * room)()
        time, normal, weights = ((ctypes.c_double * (n * room))() for n in (1, 3, 4))
        batch.start, batch.end = rows
        if thickness is not None:
            batch.thickness = doubles(thickness, "thickness", count)
        batch.hit, batch.decision, batch.time, batch.normal, batch.weights = hit, decision, time, normal, weights
        self._call(lib.vbss_collision_test_batch, ctypes.byref(batch))
        flags = [bool(value) for value in hit[:count]]
        lists = (decision[:count], time[:count], list(zip(*(normal[i * count:(i + 1) * count] for i in range(3)))),
                 list(zip(*(weights[i * count:(i + 1) * count] for i in range(4)))))
        np = numpy()
        if np is None:
            return Answers(flags, *lists)
        return Answers(np.array(flags, dtype=bool), np.array(lists[0], dtype=np.int32), np.array(lists[1]),
                       np.array(lists[2]).reshape(count, 3), np.array(lists[3]).reshape(count, 4))

    @staticmethod
    def _rows(array: Any, count: int) -> Any:
        """One question behind the other -> one coordinate behind the other, as the library wants them."""
        rows = (ctypes.c_double * max(1, 12 * count))()
        for row in range(12):
            rows[row * count:(row + 1) * count] = array[row::12]
        return rows

    # ---- shapes

    def add_chain(self, node_count: int, radius: float = 0.0, rest_lengths: Any = None) -> int:
        """Adds a chain of capsules; returns its name."""
        shape = ctypes.c_uint32()
        count = index(node_count, "node_count")
        self._call(lib.vbss_collision_add_chain, count, optional(rest_lengths, "rest_lengths", max(0, count - 1)),
                   radius, ctypes.byref(shape))
        return shape.value

    def add_capsules(self, capsule_count: int, radius: float = 0.0) -> int:
        """Adds capsules that move independently; returns their name."""
        shape = ctypes.c_uint32()
        self._call(lib.vbss_collision_add_capsules, index(capsule_count), radius, ctypes.byref(shape))
        return shape.value

    def add_mesh(self, node_count: int, triangles: Any, radius: float = 0.0) -> int:
        """Adds a triangle mesh, m x 3 nodes; returns its name."""
        nodes = numbers(triangles, ctypes.c_uint32, "triangles", row=3)
        shape = ctypes.c_uint32()
        self._call(lib.vbss_collision_add_mesh, index(node_count), nodes, len(nodes) // 3, radius,
                   ctypes.byref(shape))
        return shape.value

    def remove(self, shape: int) -> None:
        self._call(lib.vbss_collision_remove, index(shape))

    def set_filter(self, shape: int, category: int = 1, mask: int = 0xffffffff) -> None:
        """Says which shapes a shape is searched with."""
        self._call(lib.vbss_collision_set_filter, index(shape), index(category), index(mask))

    def set_motion(self, shape: int, end: Any, start: Any = None) -> None:
        """Says how a shape moves, n x 3, m; without a start, from where the last move ended."""
        last = doubles(end, "end", row=3)
        self._call(lib.vbss_collision_set_motion, index(shape), optional(start, "start", len(last)), last, len(last) // 3)

    def find_candidates(self) -> Array:
        """Pairs of features that may come near each other: `candidates`."""
        self._call(lib.vbss_collision_find_candidates)
        return self.candidates

    def find_impacts(self) -> Array:
        """Tests all candidates; the hits are `impacts`."""
        self._call(lib.vbss_collision_find_impacts)
        return self.impacts

    def edge(self, shape: int, edge: int) -> tuple[int, int]:
        """The nodes of an edge."""
        nodes = (ctypes.c_uint32 * 2)()
        self._call(lib.vbss_collision_get_edge, index(shape), index(edge), nodes)
        return nodes[0], nodes[1]

    @property
    def candidates(self) -> Array:
        """n x 5: PairKind, shape and feature a, shape and feature b."""
        return self._array(CollisionField.CANDIDATES)

    @property
    def impacts(self) -> Array:
        """Index of the candidate of each impact, ascending."""
        return self._array(CollisionField.IMPACTS)

    @property
    def times(self) -> Array:
        return self._array(CollisionField.TIMES)

    @property
    def normals(self) -> Array:
        """x 3."""
        return self._array(CollisionField.NORMALS)

    @property
    def weights(self) -> Array:
        """x 4."""
        return self._array(CollisionField.WEIGHTS)

    @property
    def decisions(self) -> Array:
        return self._array(CollisionField.DECISIONS)

    @property
    def distances(self) -> Array:
        return self._array(CollisionField.DISTANCES)

    @property
    def statistics(self) -> CollisionStatistics:
        return self._read("get_statistics", CollisionStatistics, vbss_collision_statistics)

    @property
    def baseline_statistics(self) -> BaselineStatistics:
        """What only the method "vblast" counts."""
        return self._read("get_baseline_statistics", BaselineStatistics, vbss_baseline_statistics)

    def _describe(self) -> str:
        found = self.statistics
        return f"{found.candidates} candidates, {found.impacts} impacts, {found.queries} tests"
