"""visual.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import vbss_context, vbss_view
from .drain import vbss_drain
from .grasper import vbss_grasper
from .needle import vbss_needle
from .scene import vbss_scene
from .thread import vbss_thread


class VisualKind(IntEnum):
    """The constants of vbss_visual_kind."""
    THREAD = 1
    """A thread, or a piece of one."""
    DRAIN = 2
    """A drain."""
    NEEDLE = 3
    """A needle."""
    DRIVER = 4
    """A grasper that is a needle driver."""
    SHEARS = 5
    """A grasper that is shears."""
    RIGID = 6
    """Another rigid body of a scene: its capsules."""
    FLOOR = 7
    """The floor of a scene."""


class SpotKind(IntEnum):
    """The constants of vbss_spot_kind."""
    MARK = 1
    """One of the two marks, on the outer face."""
    HOLE = 2
    """A hole with a needle or a thread in it, through the wall."""


class VisualField(IntEnum):
    """The constants of vbss_visual_field."""
    VERTICES = 0
    """x 12 float: position, m from `origin`; unit normal, outward; texture; material; value.
    *Texture*: of tubes and tools 0 to 1 once round, and m along; of drains m along the tube,
    and m from the middle of the slit round it, before the slit was opened; of floors m in its
    plane. *Material*, x 3, m: where this matter is in the body as it was made: of drains at
    rest in the drain's frame (VBSS_DRAIN_REST_POSITIONS); of tubes and tools along their axis
    and across it; of floors as texture, and 0. *Value*: of threads the tension, N; of drains 1
    on the outer face, -1 on the inner one, 0 on rims; of graspers 0 shaft, 1 neck, 2 jaws; else
    0."""
    TRIANGLES = 1
    """x 3 uint32_t: vertices, counter-clockwise seen from outside."""
    PARTS = 2
    """x 8 uint32_t: vbss_visual_kind, source, number of the body in its scene or 0, first vertex,
    number of vertices, first triangle, number of triangles, 0. In the order of sources, in a
    scene in that of places of bodies."""
    SPOTS = 3
    """x 6 float: place in VBSS_VISUAL_VIEW_PARTS of the drain, vbss_spot_kind, material x 3,
    radius in m."""


class vbss_visual(ctypes.Structure):
    """Meshes of what is shown."""


class vbss_visual_config(ctypes.Structure):
    """How to make a visual. Fill it with vbss_visual_config_init, then change what you need.

    source_capacity: Scenes and bodies that are shown, 1 to 256; default 8.

    part_capacity: Bodies that are drawn, 1 to 4096; default 32.

    vertex_capacity: Vertices, 16 to 2^24; default 65536. Room for two such meshes is taken.

    triangle_capacity: Triangles, 16 to 2^24; default 131072.

    spot_capacity: Marks and holes, 0 to 4096; default 32.

    node_capacity: Nodes of the longest thread or the largest drain, 2 to 65537; default 4096.

    side_limit: Sides of a tube's section are 6 to this many; 6 to 64; default 32.

    division_limit: A segment, or a side of a triangle, is divided into so many at most, 1 to
    32; default 12.

    tube_tolerance: Of tubes, tools and needles: between middle line and chords, and between
    sections and their polygons, m, 1e-8 to 1; default 5e-6.

    surface_tolerance: Of drains: between curved sides of patches and chords, m, 1e-8 to 1;
    default 2e-5.

    mark_radius: Of the marks of drains, m, 0 to 0.1; default 1e-3.

    tip_length: Over which a needle becomes thin, m, 0 to 1; default 4e-3. Half its length at
    most.

    floor_size: Side of the square that shows a floor, m, 1e-3 to 1e3; default 0.3.

    origin: Place in the world, m, each at most 1e3, from which vertices count: choose it where
    things happen, as they are single numbers of 24 bits. The floor's square is round it too.
    Default 0."""
    struct_size: int
    source_capacity: int
    part_capacity: int
    vertex_capacity: int
    triangle_capacity: int
    spot_capacity: int
    node_capacity: int
    side_limit: int
    division_limit: int
    reserved: int
    tube_tolerance: float
    surface_tolerance: float
    mark_radius: float
    tip_length: float
    floor_size: float
    origin: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("source_capacity", c_uint32),
        ("part_capacity", c_uint32),
        ("vertex_capacity", c_uint32),
        ("triangle_capacity", c_uint32),
        ("spot_capacity", c_uint32),
        ("node_capacity", c_uint32),
        ("side_limit", c_uint32),
        ("division_limit", c_uint32),
        ("reserved", c_uint32),
        ("tube_tolerance", c_double),
        ("surface_tolerance", c_double),
        ("mark_radius", c_double),
        ("tip_length", c_double),
        ("floor_size", c_double),
        ("origin", c_double * 3),
    ]


class vbss_visual_statistics(ctypes.Structure):
    """What the last update made.

    sources: Scenes and bodies that it was told to show.

    parts: Bodies drawn.

    vertices: Of all parts.

    triangles: Of all parts.

    spots: Marks and holes.

    updates: Calls of vbss_visual_update that succeeded."""
    struct_size: int
    sources: int
    parts: int
    vertices: int
    triangles: int
    spots: int
    updates: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("sources", c_uint32),
        ("parts", c_uint32),
        ("vertices", c_uint32),
        ("triangles", c_uint32),
        ("spots", c_uint32),
        ("updates", c_uint64),
    ]


class VisualStatistics(NamedTuple):
    """What the last update made. Fields as vbss_visual_statistics says."""
    sources: int
    parts: int
    vertices: int
    triangles: int
    spots: int
    updates: int


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_visual_config_init": (c_int32, (POINTER(vbss_visual_config), c_uint32)),
    "vbss_visual_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_visual_config),
        POINTER(POINTER(vbss_visual)))),
    "vbss_visual_destroy": (c_int32, (POINTER(vbss_visual),)),
    "vbss_visual_add_scene": (c_int32, (POINTER(vbss_visual), POINTER(vbss_scene),
        POINTER(c_uint32))),
    "vbss_visual_add_thread": (c_int32, (POINTER(vbss_visual), POINTER(vbss_thread),
        POINTER(c_uint32))),
    "vbss_visual_add_drain": (c_int32, (POINTER(vbss_visual), POINTER(vbss_drain),
        POINTER(c_uint32))),
    "vbss_visual_add_needle": (c_int32, (POINTER(vbss_visual), POINTER(vbss_needle),
        POINTER(c_uint32))),
    "vbss_visual_add_grasper": (c_int32, (POINTER(vbss_visual), POINTER(vbss_grasper),
        POINTER(c_uint32))),
    "vbss_visual_remove": (c_int32, (POINTER(vbss_visual), c_uint32)),
    "vbss_visual_update": (c_int32, (POINTER(vbss_visual),)),
    "vbss_visual_get_view": (c_int32, (POINTER(vbss_visual), c_int32, POINTER(vbss_view),
        c_uint32)),
    "vbss_visual_get_statistics": (c_int32, (POINTER(vbss_visual), POINTER(vbss_visual_statistics),
        c_uint32)),
}
