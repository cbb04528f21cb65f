"""scene_query.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_void_p
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .drain import vbss_drain
from .grasper import vbss_grasper
from .needle import vbss_needle
from .scene import SceneRigidKind, vbss_scene


class SceneBodyKind(IntEnum):
    """The constants of vbss_scene_body_kind."""
    THREAD = 1
    """A thread."""
    DRAIN = 2
    """A drain."""
    RIGID = 3
    """A rigid body that is neither a needle nor a grasper."""
    NEEDLE = 4
    """A needle."""
    GRASPER = 5
    """A grasper."""
    FLOOR = 6
    """The floor, body 0."""
    STATIC_MESH = 7
    """A static mesh."""
    SURFACE = 8
    """A host surface (scene_surface.h)."""
    PLANE = 9
    """A plane that the host added."""


class vbss_scene_body_info(ctypes.Structure):
    """Properties of a body in a scene.

    body: Number of the body.

    kind: Kind of the body.

    motion: Kind of motion of rigid bodies, needles and graspers; 0 for other bodies.

    category: Categories of its contact filter (vbss_scene_set_filter).

    mask: Mask of its contact filter.

    friction: Coefficient of friction. For a thread, the one between threads.

    gravity: Gravitational acceleration, m/s^2; 0 for the floor."""
    struct_size: int
    body: int
    kind: int
    motion: int
    category: int
    mask: int
    friction: float
    gravity: Any
    _kinds_: ClassVar[dict[str, Any]] = {"kind": SceneBodyKind, "motion": SceneRigidKind}
    _fields_ = [
        ("struct_size", c_uint32),
        ("body", c_uint32),
        ("kind", c_int32),
        ("motion", c_int32),
        ("category", c_uint32),
        ("mask", c_uint32),
        ("friction", c_double),
        ("gravity", c_double * 3),
    ]


class SceneBodyInfo(NamedTuple):
    """Properties of a body in a scene. Fields as vbss_scene_body_info says."""
    body: int
    kind: SceneBodyKind
    motion: SceneRigidKind
    category: int
    mask: int
    friction: float
    gravity: tuple[float, ...]


class vbss_scene_ray_hit(ctypes.Structure):
    """First surface that a ray hits.

    is_hit: 1: the ray hits something; 0: all other fields are 0.

    body: Number of the body; 0: the floor.

    feature: Segment, capsule or triangle of the body; 0 for the floor.

    fraction: Place on the ray, 0 at its origin to 1 at its end.

    point: Point on the surface, m.

    normal: Outward unit normal of the surface there."""
    struct_size: int
    is_hit: int
    body: int
    feature: int
    fraction: float
    point: Any
    normal: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("is_hit", c_uint32),
        ("body", c_uint32),
        ("feature", c_uint32),
        ("fraction", c_double),
        ("point", c_double * 3),
        ("normal", c_double * 3),
    ]


class SceneRayHit(NamedTuple):
    """First surface that a ray hits. Fields as vbss_scene_ray_hit says."""
    is_hit: int
    body: int
    feature: int
    fraction: float
    point: tuple[float, ...]
    normal: tuple[float, ...]


class vbss_scene_nearest(ctypes.Structure):
    """Body nearest to a point.

    is_found: 1: a surface is within the radius; 0: all other fields are 0.

    body: Number of the body; 0: the floor.

    feature: Segment, capsule or triangle of the body; 0 for the floor.

    distance: Distance of its surface, m; negative inside the body.

    point: Nearest point of that surface, m.

    normal: Outward unit normal of the surface there."""
    struct_size: int
    is_found: int
    body: int
    feature: int
    distance: float
    point: Any
    normal: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("is_found", c_uint32),
        ("body", c_uint32),
        ("feature", c_uint32),
        ("distance", c_double),
        ("point", c_double * 3),
        ("normal", c_double * 3),
    ]


class SceneNearest(NamedTuple):
    """Body nearest to a point. Fields as vbss_scene_nearest says."""
    is_found: int
    body: int
    feature: int
    distance: float
    point: tuple[float, ...]
    normal: tuple[float, ...]


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_scene_get_bodies": (c_int32, (POINTER(vbss_scene), POINTER(c_uint32), c_uint32,
        POINTER(c_uint32))),
    "vbss_scene_get_body": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(vbss_scene_body_info),
        c_uint32)),
    "vbss_scene_get_drain": (c_int32, (POINTER(vbss_scene), c_uint32,
        POINTER(POINTER(vbss_drain)))),
    "vbss_scene_get_needle": (c_int32, (POINTER(vbss_scene), c_uint32,
        POINTER(POINTER(vbss_needle)))),
    "vbss_scene_get_grasper": (c_int32, (POINTER(vbss_scene), c_uint32,
        POINTER(POINTER(vbss_grasper)))),
    "vbss_scene_set_user_data": (c_int32, (POINTER(vbss_scene), c_uint32, c_void_p)),
    "vbss_scene_get_user_data": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(c_void_p))),
    "vbss_scene_cast_ray": (c_int32, (POINTER(vbss_scene), POINTER(c_double), POINTER(c_double),
        c_uint32, POINTER(vbss_scene_ray_hit), c_uint32)),
    "vbss_scene_find_nearest": (c_int32, (POINTER(vbss_scene), POINTER(c_double), c_double,
        c_uint32, POINTER(vbss_scene_nearest), c_uint32)),
}
