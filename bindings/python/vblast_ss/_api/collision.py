"""collision.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64, c_uint8
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import vbss_context, vbss_view


class CollisionMethod(IntEnum):
    """The constants of vbss_collision_method."""
    CONSERVATIVE = 0
    """Directional conservative advancement, the default: never misses. For D = 0 exact both ways."""
    CUBIC = 1
    """The usual one: roots of the coplanarity cubic, an inside test at each, the distance at the
    end. May miss."""
    PAPER = 2
    """As in VBLaST-SS (Qi et al. 2017, algorithm 1): distance at the end, then a sign test and a
    linear time of impact. Often misses."""


class PairKind(IntEnum):
    """The constants of vbss_pair_kind, with their four vertices."""
    EDGE_EDGE = 0
    """a0, a1 of edge a, then b0, b1 of edge b."""
    POINT_TRIANGLE = 1
    """The point (a), then b0, b1, b2 of the triangle."""


class Decision(IntEnum):
    """The constants of vbss_decision."""
    PROVED = 0
    """Miss: planes that separate the features by more than D at all times. Hit: at `time` the
    distance is at most D plus the tolerance."""
    EXACT = 1
    """D = 0: true of the given numbers, without any tolerance."""
    UNDECIDED = 2
    """Neither could be shown; told as a hit. D > 0: pass_limit was reached, or no direction was
    exact enough, which takes a D below some 1e-8 of the size. D = 0: the bits of the
    coordinates spread over more binary places than there is memory for: some 250 in a call
    without an object; with one, any doubles have fitted so far."""
    CLAIMED = 3
    """Of CUBIC and PAPER, which prove nothing."""


class CollisionField(IntEnum):
    """The constants of vbss_collision_field."""
    CANDIDATES = 0
    """x 5 uint32_t: vbss_pair_kind, shape and feature a, shape and feature b. A feature is an
    edge, a point (node) or a triangle. Sorted by these five numbers."""
    IMPACTS = 1
    """uint32_t: index of the candidate, ascending."""
    TIMES = 2
    """Of each impact: vbss_impact.time."""
    NORMALS = 3
    """x 3: vbss_impact.normal."""
    WEIGHTS = 4
    """x 4: vbss_impact.weights."""
    DECISIONS = 5
    """uint32_t: vbss_impact.decision."""
    DISTANCES = 6
    """vbss_impact.distance, m."""


class ResponseVariant(IntEnum):
    """The constants of vbss_response_variant."""
    END_OF_STEP = 0
    """Algorithm 2 as printed: along the shortest vector at the end of the step."""
    TIME_OF_IMPACT = 1
    """Along the normal at the time of impact, by D: D apart in the positions of that time."""


class vbss_collision(ctypes.Structure):
    """Shapes, their candidates and impacts, batches, counters."""


class vbss_closest(ctypes.Structure):
    """Two closest points.

    distance: m; of capsules: negative by the penetration depth when they overlap.

    normal: Unit vector from a to b; zero where there is none (axes that meet).

    point_a: On a, m.

    point_b: On b, m.

    weights_a: point_a as a sum of a's vertices; of the axis for a capsule.

    weights_b: point_b likewise."""
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


class Closest(NamedTuple):
    """Two closest points. Fields as vbss_closest says."""
    distance: float
    normal: tuple[float, ...]
    point_a: tuple[float, ...]
    point_b: tuple[float, ...]
    weights_a: tuple[float, ...]
    weights_b: tuple[float, ...]


class vbss_impact(ctypes.Structure):
    """What a continuous test found.

    hit: 1: they come within D; 0: they do not.

    decision: What `hit` stands on.

    passes: CONSERVATIVE: looks at the closest points; else roots looked at.

    time: Hit: 0 to 1; with CONSERVATIVE there is no contact before. PROVED: at `time` they are
    within D plus the tolerance. EXACT: `time` is as near to the first contact as the
    advancement came; `distance` tells how near, some 1e-14 of the size, but where features
    graze it stays behind. Miss: 1.

    distance: Hit: of the features at `time`, m; of CUBIC and PAPER: between what they take for
    the points of contact. Miss: 0.

    normal: Hit: unit vector from a to b, or zero where none is known. Miss: 0.

    weights: Hit: of the four vertices, summing to 1 on either feature. Miss: 0.

    point_a: Hit: on a at `time`, m. Miss: 0.

    point_b: Hit: on b at `time`, m. Miss: 0."""
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
    _kinds_: ClassVar[dict[str, Any]] = {"decision": Decision}
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


class Impact(NamedTuple):
    """What a continuous test found. Fields as vbss_impact says."""
    hit: int
    decision: Decision
    passes: int
    time: float
    distance: float
    normal: tuple[float, ...]
    weights: tuple[float, ...]
    point_a: tuple[float, ...]
    point_b: tuple[float, ...]


class vbss_collision_config(ctypes.Structure):
    """How to test and how much room there is. Fill it with vbss_collision_config_init.

    method: Default VBSS_COLLISION_CONSERVATIVE.

    thickness: Contact distance D, m: 0, or 1e-30 to 1e30; default 0. Between shapes their radii
    are added.

    tolerance: Share of D, 1e-12 to 1: a hit may be told of features that come no nearer than D
    (1 + tolerance); default 1e-3. Rounding sets a lower limit: docs/collision.md. Without
    effect on the answer when D = 0.

    pass_limit: CONSERVATIVE: passes before a test gives up and tells a hit, 1 to 1000000;
    default 10000. Most take one or two; edges that turn about each other just above D take
    hundreds. With D = 0 at most 256 are made. Exact decisions are not limited by it: they take
    some 10 us, milliseconds where bits spread over hundreds of binary places, and up to a
    second with subnormal numbers beside 1.

    shape_capacity: Most shapes ever added, 0 to 65536; default 16.

    pair_capacity: Most candidates at a time, 0 to 1e8; default 16384.

    impact_capacity: Most impacts at a time, 0 to 1e8; default 4096.

    exclusion: Segments of one chain are no candidates when the arc between their nearest ends
    is shorter than `exclusion` times D, D being that of the pair; 0 to 1e3; default 1.6: a tube
    bent until it touches itself needs pi/2. Neighbours never are.

    margin: Candidates are also told when features come within D plus this, m, 0 to 1e3; default
    0.

    paper_parallel: PAPER: edges are parallel when |a|^2 |b|^2 - (a.b)^2 is below this, in
    paper_unit^4; 0 to 1; default 1e-6.

    paper_unit: PAPER: its unit of length, m, 1e-9 to 1e3; default 1e-3."""
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
    paper_parallel: float
    paper_unit: float
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
        ("paper_parallel", c_double),
        ("paper_unit", c_double),
    ]


class vbss_collision_batch(ctypes.Structure):
    """Questions in rows, answers in rows. Fill it with vbss_collision_batch_init.

    kind: Of all questions.

    count: Questions, at most 1e8.

    stride: From one row to the next, at least count; in every array of rows.

    start: No two arrays overlap. 12 rows: x of vertex 0 of every question, y of vertex 0, z, x
    of vertex 1, ...; m.

    end: The same at time 1.

    thickness: D of each question, m; NULL: that of the configuration.

    hit: Receives vbss_impact.hit of each question.

    decision: Receives vbss_impact.decision; may be NULL.

    time: Receives vbss_impact.time; may be NULL.

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
    _kinds_: ClassVar[dict[str, Any]] = {"kind": PairKind}
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

    candidates: Of the last search.

    impacts: Of the last search.

    queries: Continuous tests.

    hits: Of these, hits.

    undecided: Of these, undecided.

    exact: Tests that needed exact arithmetic.

    passes: CONSERVATIVE: looks at the closest points.

    sign_tests_ended: PAPER: tests ended by the sign of w.w'.

    boxes_tested: Pairs of boxes looked at by the searches; not part of the state.

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
    sign_tests_ended: int
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
        ("sign_tests_ended", c_uint64),
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
    sign_tests_ended: int
    boxes_tested: int
    searches: int


class vbss_response(ctypes.Structure):
    """Displacements by the paper's response.

    completed: 1: the paper leaves this case open, such as no relative motion along the
    direction, or features that meet at the end, and a rule of docs/paper-collision.md was used.

    direction: q: unit vector from edge b to edge a, on the side of the start.

    depth: u: what is to be restored along q, m.

    share_a: Share of u that a moves along q; b moves -(1 - share_a) u q.

    displacement: Of the four vertices at time 1, m."""
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


class Response(NamedTuple):
    """Displacements by the paper's response. Fields as vbss_response says."""
    completed: int
    direction: tuple[float, ...]
    depth: float
    share_a: float
    displacement: tuple[float, ...]


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_closest_segments": (c_int32, (POINTER(c_double), POINTER(c_double), POINTER(vbss_closest),
        c_uint32)),
    "vbss_closest_point_triangle": (c_int32, (POINTER(c_double), POINTER(c_double),
        POINTER(vbss_closest), c_uint32)),
    "vbss_closest_segment_triangle": (c_int32, (POINTER(c_double), POINTER(c_double),
        POINTER(vbss_closest), c_uint32)),
    "vbss_closest_capsules": (c_int32, (POINTER(c_double), c_double, POINTER(c_double), c_double,
        POINTER(vbss_closest), c_uint32)),
    "vbss_collision_config_init": (c_int32, (POINTER(vbss_collision_config), c_uint32)),
    "vbss_edges_test": (c_int32, (POINTER(vbss_collision_config), POINTER(c_double),
        POINTER(c_double), POINTER(vbss_impact), c_uint32)),
    "vbss_point_triangle_test": (c_int32, (POINTER(vbss_collision_config), POINTER(c_double),
        POINTER(c_double), POINTER(vbss_impact), c_uint32)),
    "vbss_paper_response": (c_int32, (c_int32, c_int32, POINTER(vbss_impact), POINTER(c_double),
        POINTER(c_double), c_double, POINTER(c_double), POINTER(vbss_response), c_uint32)),
    "vbss_collision_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_collision_config),
        POINTER(POINTER(vbss_collision)))),
    "vbss_collision_destroy": (c_int32, (POINTER(vbss_collision),)),
    "vbss_collision_test": (c_int32, (POINTER(vbss_collision), c_int32, POINTER(c_double),
        POINTER(c_double), POINTER(vbss_impact), c_uint32)),
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
    "vbss_collision_move": (c_int32, (POINTER(vbss_collision), c_uint32, POINTER(c_double),
        POINTER(c_double), c_uint32)),
    "vbss_collision_find_candidates": (c_int32, (POINTER(vbss_collision),)),
    "vbss_collision_find_impacts": (c_int32, (POINTER(vbss_collision),)),
    "vbss_collision_get_view": (c_int32, (POINTER(vbss_collision), c_int32, POINTER(vbss_view),
        c_uint32)),
    "vbss_collision_get_edge": (c_int32, (POINTER(vbss_collision), c_uint32, c_uint32,
        POINTER(c_uint32))),
    "vbss_collision_get_statistics": (c_int32, (POINTER(vbss_collision),
        POINTER(vbss_collision_statistics), c_uint32)),
    "vbss_collision_save": (c_int32, (POINTER(vbss_collision), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_collision_restore": (c_int32, (POINTER(vbss_collision), POINTER(c_uint8), c_uint64)),
    "vbss_collision_get_hash": (c_int32, (POINTER(vbss_collision), POINTER(c_uint64))),
}
