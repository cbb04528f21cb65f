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
from .replica import vbss_replica
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


class VisualSpotKind(IntEnum):
    """The constants of vbss_visual_spot_kind."""
    MARK = 1
    """One of the two marks, on the outer face."""
    HOLE = 2
    """A hole with a needle or a thread in it, through the wall."""


class VisualField(IntEnum):
    """The constants of vbss_visual_field."""
    VERTICES = 0
    """x 12 float: position, m from `origin`; unit normal, outward; texture; material; value.
    *Texture*: on tubes and tools, 0 to 1 around the section, and m along; on drains, m along
    the tube, and m around it from the middle of the slit before it was opened; on floors, m in
    the plane. *Material*, x 3, m: position in the undeformed body. On drains it is the position
    at rest in the drain's frame (VBSS_DRAIN_VIEW_REST_POSITIONS); on tubes and tools, along and
    across the axis; on floors, the texture and 0. *Value*: on threads, the tension, N; on
    drains, 1 on the outer face, -1 on the inner face, 0 on rims; on graspers, 0 shaft, 1 neck,
    2 jaws; else 0."""
    TRIANGLES = 1
    """x 3 uint32_t: vertices, counter-clockwise seen from outside."""
    PARTS = 2
    """x 8 uint32_t: vbss_visual_kind, source, number of the body in its scene or 0, first vertex,
    number of vertices, first triangle, number of triangles, 0. Parts have the order of their
    sources, and within a scene that of its bodies."""
    SPOTS = 3
    """x 6 float: index of the drain in VBSS_VISUAL_VIEW_PARTS, vbss_visual_spot_kind, material x
    3, radius in m."""


class vbss_visual(ctypes.Structure):
    """Meshes of scenes and bodies."""


class vbss_visual_config(ctypes.Structure):
    """Configuration of a visual. Fill it with vbss_visual_config_init, then change fields.

    source_capacity: Largest number of scenes and bodies, 1 to 256; default 8.

    part_capacity: Largest number of drawn bodies, 1 to 4096; default 32.

    vertex_capacity: Largest number of vertices, 16 to 2^24; default 65536. The visual allocates
    two such meshes.

    triangle_capacity: Largest number of triangles, 16 to 2^24; default 131072.

    spot_capacity: Largest number of spots, 0 to 4096; default 32.

    node_capacity: Largest number of nodes of a thread or a drain, 2 to 65537; default 4096.

    side_limit: Largest number of sides of a tube's section, 6 to 64; default 32. The smallest
    number is 6.

    division_limit: Largest number of parts of a segment, or of a side of a triangle, 1 to 32;
    default 12.

    tube_tolerance: Tubes, tools and needles: largest deviation of chords from the centre line,
    and of polygons from sections, m, 1e-8 to 1; default 5e-6.

    surface_tolerance: Drains: largest deviation of chords from curved sides of patches, m, 1e-8
    to 1; default 2e-5.

    mark_radius: Radius of the marks of drains, m, 0 to 0.1; default 1e-3.

    tip_length: Length over which a needle tapers to its tip, m, 0 to 1; default 4e-3. At most
    half the needle's length is used.

    floor_size: Side of the square that shows a floor, m, 1e-3 to 1e3; default 0.3.

    origin: Point in the world that vertices are relative to, m, each at most 1e3; default 0.
    Choose it near the bodies, because vertices have single precision (24 bits). The square of
    the floor is centred on it too."""
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
    """Counts of the last update.

    sources: Scenes and bodies that the host has added.

    parts: Bodies drawn.

    vertices: Vertices of all parts.

    triangles: Triangles of all parts.

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
    """Counts of the last update. Fields as vbss_visual_statistics says."""
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
    "vbss_visual_add_replica": (c_int32, (POINTER(vbss_visual), POINTER(vbss_replica),
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
