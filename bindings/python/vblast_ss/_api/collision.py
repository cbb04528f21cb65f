"""collision.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64, c_uint8
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import vbss_context, vbss_view
from .baseline import vbss_baseline_config, vbss_baseline_statistics


class CollisionMethod(IntEnum):
    """The constants of vbss_collision_method."""
    CONSERVATIVE = 0
    """Directional conservative advancement, the default: never misses. For D = 0, hits and misses
    are exact."""
    CUBIC = 1
    """The usual method: roots of the coplanarity cubic, an inside test at each root, and the
    distance at the end. May miss."""
    VBLAST = 2
    """Algorithm 1 of VBLaST-SS (Qi et al. 2017): distance at the end, then a sign test and a
    linear time of impact. Often misses."""


class CollisionPairKind(IntEnum):
    """The constants of vbss_collision_pair_kind, with their four vertices."""
    EDGE_EDGE = 0
    """a0, a1 of edge a, then b0, b1 of edge b."""
    POINT_TRIANGLE = 1
    """The point (a), then b0, b1, b2 of the triangle."""


class CollisionDecision(IntEnum):
    """The constants of vbss_collision_decision."""
    PROVED = 0
    """Miss: planes that separate the features by more than D at all times. Hit: at `time` the
    distance is at most D plus the tolerance."""
    EXACT = 1
    """D = 0: true for the given numbers, without any tolerance."""
    UNDECIDED = 2
    """Neither could be shown, so the answer is a hit. D > 0: the test reached pass_limit, or no
    direction was exact enough, which takes a D below about 1e-8 of the size. D = 0: the bits of
    the coordinates spread over more binary places than there is memory for. A call without an
    object has memory for about 250 places; with an object, all doubles tried so far have
    fitted."""
    CLAIMED = 3
    """CUBIC and VBLAST: not proved."""


class CollisionField(IntEnum):
    """The constants of vbss_collision_field."""
    CANDIDATES = 0
    """x 5 uint32_t: vbss_collision_pair_kind, shape and feature a, shape and feature b. A feature
    is an edge, a point (node) or a triangle. Sorted by these five numbers."""
    IMPACTS = 1
    """uint32_t: index of the candidate, ascending."""
    TIMES = 2
    """vbss_collision_impact.time."""
    NORMALS = 3
    """x 3: vbss_collision_impact.normal."""
    WEIGHTS = 4
    """x 4: vbss_collision_impact.weights."""
    DECISIONS = 5
    """uint32_t: vbss_collision_impact.decision."""
    DISTANCES = 6
    """vbss_collision_impact.distance, m."""


class CollisionResponseVariant(IntEnum):
    """The constants of vbss_collision_response_variant."""
    END_OF_STEP = 0
    """Algorithm 2 as printed: along the shortest vector at the end of the step."""
    TIME_OF_IMPACT = 1
    """Along the normal at the time of impact, by D: the features are then D apart in the positions
    of that time."""


class vbss_collision(ctypes.Structure):
    """Shapes, their candidates and impacts, batches, counters."""


class vbss_collision_closest(ctypes.Structure):
    """Two closest points.

    distance: Distance, m; minus the penetration depth for capsules that overlap.

    normal: Unit vector from a to b; zero if undefined (axes that meet).

    point_a: On a, m.

    point_b: On b, m.

    weights_a: Weights of the vertices of a, or of its axis, that give point_a.

    weights_b: Weights of the vertices of b, or of its axis, that give point_b."""
    struct_size: int
    reserved: int
    distance: float
    normal: Any
    point_a: Any
    point_b: Any
    weights_a: Any
    weights_b: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("distance", c_double),
        ("normal", c_double * 3),
        ("point_a", c_double * 3),
        ("point_b", c_double * 3),
        ("weights_a", c_double * 3),
        ("weights_b", c_double * 3),
    ]


class CollisionClosest(NamedTuple):
    """Two closest points. Fields as vbss_collision_closest says."""
    distance: float
    normal: tuple[float, ...]
    point_a: tuple[float, ...]
    point_b: tuple[float, ...]
    weights_a: tuple[float, ...]
    weights_b: tuple[float, ...]


class vbss_collision_impact(ctypes.Structure):
    """Result of a continuous test.

    hit: 1: they come within D; 0: they do not.

    decision: Evidence for `hit`.

    passes: CONSERVATIVE: evaluations of the closest points; else of roots.

    time: Hit: 0 to 1; with CONSERVATIVE there is no contact before. PROVED: at `time` the
    features are within D plus the tolerance. EXACT: `time` is as near to the first contact as
    the advancement came. `distance` says how near: about 1e-14 of the size, but more where
    features graze. Miss: 1.

    distance: Hit: distance of the features at `time`, m; CUBIC and VBLAST: distance of the
    assumed points of contact. Miss: 0.

    normal: Hit: unit vector from a to b, or zero if none is known. Miss: 0.

    weights: Hit: weights of the four vertices, sum 1 on either feature. Miss: 0.

    point_a: Hit: point on a at `time`, m. Miss: 0.

    point_b: Hit: point on b at `time`, m. Miss: 0."""
    struct_size: int
    hit: int
    decision: int
    passes: int
    time: float
    distance: float
    normal: Any
    weights: Any
    point_a: Any
    point_b: Any
    _kinds_: ClassVar[dict[str, Any]] = {"decision": CollisionDecision}
    _fields_ = [
        ("struct_size", c_uint32),
        ("hit", c_int32),
        ("decision", c_int32),
        ("passes", c_uint32),
        ("time", c_double),
        ("distance", c_double),
        ("normal", c_double * 3),
        ("weights", c_double * 4),
        ("point_a", c_double * 3),
        ("point_b", c_double * 3),
    ]


class CollisionImpact(NamedTuple):
    """Result of a continuous test. Fields as vbss_collision_impact says."""
    hit: int
    decision: CollisionDecision
    passes: int
    time: float
    distance: float
    normal: tuple[float, ...]
    weights: tuple[float, ...]
    point_a: tuple[float, ...]
    point_b: tuple[float, ...]


class vbss_collision_config(ctypes.Structure):
    """Method of the tests, and capacities. Fill it with vbss_collision_config_init.

    method: Default VBSS_COLLISION_METHOD_CONSERVATIVE.

    thickness: Contact distance D, m: 0, or 1e-30 to 1e30; default 0. Between shapes their radii
    are added.

    tolerance: Share of D, 1e-12 to 1; default 1e-3. A test may report a hit for features that
    only come within D (1 + tolerance). Rounding sets a lower limit:
    docs/explanation/collision.md. No effect on the answer when D = 0.

    pass_limit: CONSERVATIVE: passes before a test gives up and reports a hit, 1 to 1000000;
    default 10000. Most tests take one or two; edges that turn about each other just above D
    take hundreds. With D = 0 a test makes at most 256. The limit does not apply to exact
    decisions. They take about 10 us, milliseconds where bits spread over hundreds of binary
    places, and up to a second with subnormal numbers beside 1.

    shape_capacity: Largest number of shapes ever added, 0 to 65536; default 16.

    pair_capacity: Largest number of candidates, 0 to 1e8; default 16384.

    impact_capacity: Largest number of impacts, 0 to 1e8; default 4096.

    exclusion: Excludes two segments of one chain from the candidates if the arc between their
    nearest ends is shorter than `exclusion` times the D of the pair; 0 to 1e3. Neighbours are
    always excluded. Default 1.6: a tube bent until it touches itself needs pi/2.

    margin: Added to D in the search for candidates, m, 0 to 1e3; default 0.

    baseline: VBLAST: its parameters; NULL (default): their defaults. The library copies them."""
    struct_size: int
    method: int
    thickness: float
    tolerance: float
    pass_limit: int
    shape_capacity: int
    pair_capacity: int
    impact_capacity: int
    exclusion: float
    margin: float
    baseline: Any
    _kinds_: ClassVar[dict[str, Any]] = {"method": CollisionMethod}
    _fields_ = [
        ("struct_size", c_uint32),
        ("method", c_int32),
        ("thickness", c_double),
        ("tolerance", c_double),
        ("pass_limit", c_uint32),
        ("shape_capacity", c_uint32),
        ("pair_capacity", c_uint32),
        ("impact_capacity", c_uint32),
        ("exclusion", c_double),
        ("margin", c_double),
        ("baseline", POINTER(vbss_baseline_config)),
    ]


class vbss_collision_batch(ctypes.Structure):
    """Questions in rows, answers in rows. Fill it with vbss_collision_batch_init.

    kind: Kinds of the features of all questions.

    count: Questions, at most 1e8.

    stride: Elements from one row to the next in every array, at least count.

    start: Positions at time 0, m. 12 rows: x of vertex 0 of every question, y of vertex 0, z, x
    of vertex 1, and so on. No two arrays of a batch overlap.

    end: Positions at time 1, m, in rows as for `start`.

    thickness: D of each question, m; NULL: D of the configuration.

    hit: Receives vbss_collision_impact.hit of each question.

    decision: Receives vbss_collision_impact.decision; may be NULL.

    time: Receives vbss_collision_impact.time; may be NULL.

    normal: Receives 3 rows; may be NULL.

    weights: Receives 4 rows; may be NULL."""
    struct_size: int
    kind: int
    count: int
    stride: int
    start: Any
    end: Any
    thickness: Any
    hit: Any
    decision: Any
    time: Any
    normal: Any
    weights: Any
    _kinds_: ClassVar[dict[str, Any]] = {"kind": CollisionPairKind}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("count", c_uint32),
        ("stride", c_uint32),
        ("start", POINTER(c_double)),
        ("end", POINTER(c_double)),
        ("thickness", POINTER(c_double)),
        ("hit", POINTER(c_int32)),
        ("decision", POINTER(c_int32)),
        ("time", POINTER(c_double)),
        ("normal", POINTER(c_double)),
        ("weights", POINTER(c_double)),
    ]


class vbss_collision_statistics(ctypes.Structure):
    """Counters of a collision object since its creation. Searches and tests that fail are not
    counted.

    candidates: Candidates of the last search.

    impacts: Impacts of the last search.

    queries: Continuous tests.

    hits: Continuous tests that were hits.

    undecided: Continuous tests that were undecided.

    exact: Tests that needed exact arithmetic.

    passes: CONSERVATIVE: evaluations of the closest points.

    boxes_tested: Pairs of boxes that the searches tested; not part of the state.

    searches: Searches for candidates."""
    struct_size: int
    candidates: int
    impacts: int
    reserved: int
    queries: int
    hits: int
    undecided: int
    exact: int
    passes: int
    boxes_tested: int
    searches: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("candidates", c_uint32),
        ("impacts", c_uint32),
        ("reserved", c_uint32),
        ("queries", c_uint64),
        ("hits", c_uint64),
        ("undecided", c_uint64),
        ("exact", c_uint64),
        ("passes", c_uint64),
        ("boxes_tested", c_uint64),
        ("searches", c_uint64),
    ]


class CollisionStatistics(NamedTuple):
    """Counters of a collision object since its creation. Searches and tests that fail are not
    counted. Fields as vbss_collision_statistics says."""
    candidates: int
    impacts: int
    queries: int
    hits: int
    undecided: int
    exact: int
    passes: int
    boxes_tested: int
    searches: int


class vbss_collision_response(ctypes.Structure):
    """Displacements by the paper's response.

    completed: 1: the paper leaves this case open, and a rule of docs/explanation/paper-
    collision.md was used. Examples are no relative motion along the direction, and features
    that meet at the end.

    direction: q: unit vector from edge b to edge a, on the side of the start.

    depth: u: distance to restore along q, m.

    share_a: Share of u that a moves along q; b moves -(1 - share_a) u q.

    displacement: Displacements of the four vertices at time 1, m."""
    struct_size: int
    completed: int
    direction: Any
    depth: float
    share_a: float
    displacement: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("completed", c_int32),
        ("direction", c_double * 3),
        ("depth", c_double),
        ("share_a", c_double),
        ("displacement", c_double * 12),
    ]


class CollisionResponse(NamedTuple):
    """Displacements by the paper's response. Fields as vbss_collision_response says."""
    completed: int
    direction: tuple[float, ...]
    depth: float
    share_a: float
    displacement: tuple[float, ...]


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_collision_closest_segments": (c_int32, (POINTER(c_double), POINTER(c_double),
        POINTER(vbss_collision_closest), c_uint32)),
    "vbss_collision_closest_point_triangle": (c_int32, (POINTER(c_double), POINTER(c_double),
        POINTER(vbss_collision_closest), c_uint32)),
    "vbss_collision_closest_segment_triangle": (c_int32, (POINTER(c_double), POINTER(c_double),
        POINTER(vbss_collision_closest), c_uint32)),
    "vbss_collision_closest_capsules": (c_int32, (POINTER(c_double), c_double, POINTER(c_double),
        c_double, POINTER(vbss_collision_closest), c_uint32)),
    "vbss_collision_config_init": (c_int32, (POINTER(vbss_collision_config), c_uint32)),
    "vbss_collision_test_edges": (c_int32, (POINTER(vbss_collision_config), POINTER(c_double),
        POINTER(c_double), POINTER(vbss_collision_impact), c_uint32)),
    "vbss_collision_test_point_triangle": (c_int32, (POINTER(vbss_collision_config),
        POINTER(c_double), POINTER(c_double), POINTER(vbss_collision_impact), c_uint32)),
    "vbss_collision_get_vblast_response": (c_int32, (c_int32, c_int32,
        POINTER(vbss_collision_impact), POINTER(c_double), POINTER(c_double), c_double,
        POINTER(c_double), POINTER(vbss_collision_response), c_uint32)),
    "vbss_collision_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_collision_config),
        POINTER(POINTER(vbss_collision)))),
    "vbss_collision_destroy": (c_int32, (POINTER(vbss_collision),)),
    "vbss_collision_test": (c_int32, (POINTER(vbss_collision), c_int32, POINTER(c_double),
        POINTER(c_double), POINTER(vbss_collision_impact), c_uint32)),
    "vbss_collision_batch_init": (c_int32, (POINTER(vbss_collision_batch), c_uint32)),
    "vbss_collision_test_batch": (c_int32, (POINTER(vbss_collision),
        POINTER(vbss_collision_batch))),
    "vbss_collision_add_chain": (c_int32, (POINTER(vbss_collision), c_uint32, POINTER(c_double),
        c_double, POINTER(c_uint32))),
    "vbss_collision_add_capsules": (c_int32, (POINTER(vbss_collision), c_uint32, c_double,
        POINTER(c_uint32))),
    "vbss_collision_add_mesh": (c_int32, (POINTER(vbss_collision), c_uint32, POINTER(c_uint32),
        c_uint32, c_double, POINTER(c_uint32))),
    "vbss_collision_remove": (c_int32, (POINTER(vbss_collision), c_uint32)),
    "vbss_collision_set_filter": (c_int32, (POINTER(vbss_collision), c_uint32, c_uint32, c_uint32)),
    "vbss_collision_set_motion": (c_int32, (POINTER(vbss_collision), c_uint32, POINTER(c_double),
        POINTER(c_double), c_uint32)),
    "vbss_collision_find_candidates": (c_int32, (POINTER(vbss_collision),)),
    "vbss_collision_find_impacts": (c_int32, (POINTER(vbss_collision),)),
    "vbss_collision_get_view": (c_int32, (POINTER(vbss_collision), c_int32, POINTER(vbss_view),
        c_uint32)),
    "vbss_collision_get_edge": (c_int32, (POINTER(vbss_collision), c_uint32, c_uint32,
        POINTER(c_uint32))),
    "vbss_collision_get_statistics": (c_int32, (POINTER(vbss_collision),
        POINTER(vbss_collision_statistics), c_uint32)),
    "vbss_collision_get_baseline_statistics": (c_int32, (POINTER(vbss_collision),
        POINTER(vbss_baseline_statistics), c_uint32)),
    "vbss_collision_save": (c_int32, (POINTER(vbss_collision), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_collision_restore": (c_int32, (POINTER(vbss_collision), POINTER(c_uint8), c_uint64)),
    "vbss_collision_get_hash": (c_int32, (POINTER(vbss_collision), POINTER(c_uint64))),
}
