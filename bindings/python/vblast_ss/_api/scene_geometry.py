"""scene_geometry.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32
from typing import Any, ClassVar

from .scene import vbss_scene, vbss_scene_rigid_config


class vbss_scene_static_mesh_config(ctypes.Structure):
    """Configuration of a static mesh. Fill it with vbss_scene_static_mesh_config_init, then change
    fields.

    vertex_count: Number of vertices, 3 to 65536.

    triangle_count: Number of triangles, 1 to 131072.

    one_sided: 0: bodies touch it from both sides (default). 1: only from the front, which is
    the side from which the corners of a triangle are counter-clockwise. What is behind is left
    alone, also within the thickness, and passes to the front. There it is pushed out to the
    contact distance. What is in front at the start of a step does not get behind, unless it
    goes round a free edge. Each edge of such a mesh belongs to one triangle, or to two that
    list it in opposite directions.

    vertices: Vertices in the world, m: vertex_count times x, y, z, each at most 1e3 in
    magnitude; the library copies them.

    triangles: Corners of triangles: triangle_count times three different indices of vertices,
    in any order. Triangles may share vertices and edges, and need not form a closed surface;
    the library copies them.

    friction: Friction coefficient of its surface, 0 to 10; default 0.15. A contact with a
    thread has this coefficient, any other contact the geometric mean of both.

    thickness: Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. The triangles are its
    middle: other bodies touch it at half the thickness from them."""
    struct_size: int
    vertex_count: int
    triangle_count: int
    one_sided: int
    vertices: Any
    triangles: Any
    friction: float
    thickness: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("vertex_count", c_uint32),
        ("triangle_count", c_uint32),
        ("one_sided", c_uint32),
        ("vertices", POINTER(c_double)),
        ("triangles", POINTER(c_uint32)),
        ("friction", c_double),
        ("thickness", c_double),
    ]


class vbss_scene_height_field_config(ctypes.Structure):
    """Configuration of a height field. Fill it with vbss_scene_height_field_config_init, then
    change fields. In its frame the heights are along y, the columns along x, and the rows along
    z.

    column_count: Number of heights of a row, 2 or more.

    row_count: Number of rows, 2 or more.

    height_count: Number of heights: column_count times row_count, at most 65536.

    one_sided: 0: bodies touch it from both sides (default). 1: only from above, as a one-sided
    mesh.

    heights: Heights, m, at most 1e3 in magnitude, row by row; the library copies them.

    position: Position of the first height of the first row at height 0, m; default 0.

    orientation: Orientation of its frame, w, x, y, z, of any length from 1e-100 to 1e100;
    default 1, 0, 0, 0.

    spacing: Spacing of columns and of rows, m, 1e-6 to 1e3; default 1e-3.

    friction: Friction coefficient, 0 to 10; default 0.15. A contact with a thread has this
    coefficient, any other contact the geometric mean of both.

    thickness: Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. The heights are its
    middle: other bodies touch it at half the thickness from them."""
    struct_size: int
    column_count: int
    row_count: int
    height_count: int
    one_sided: int
    reserved: int
    heights: Any
    position: Any
    orientation: Any
    spacing: Any
    friction: float
    thickness: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("column_count", c_uint32),
        ("row_count", c_uint32),
        ("height_count", c_uint32),
        ("one_sided", c_uint32),
        ("reserved", c_uint32),
        ("heights", POINTER(c_double)),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("spacing", c_double * 2),
        ("friction", c_double),
        ("thickness", c_double),
    ]


class vbss_scene_distance_field_config(ctypes.Structure):
    """Configuration of a distance field. Fill it with vbss_scene_distance_field_config_init, then
    change fields.

    distance_count: Number of distances: the product of the three counts.

    counts: Numbers of distances along x, y and z, each 2 to 2048.

    one_sided: 1: bodies touch it only from outside, as a one-sided mesh (default). 0: from both
    sides.

    distances: Signed distances from the surface at the points of a grid, m: negative inside,
    positive outside, x fastest, z slowest. The library copies them not, but the surface.

    position: Position of the first point of the grid, m, each coordinate at most 1e3 in
    magnitude; default 0.

    orientation: Orientation of the grid, w, x, y, z, of any length from 1e-100 to 1e100;
    default 1, 0, 0, 0.

    spacing: Spacing of the grid along x, y and z, m, 1e-6 to 1e3; default 1e-3.

    friction: Friction coefficient, 0 to 10; default 0.15. A contact with a thread has this
    coefficient, any other contact the geometric mean of both.

    thickness: Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. Its outer face is where
    the distance is 0, and its middle where it is minus half the thickness. Parts of the solid
    that are thinner do not exist."""
    struct_size: int
    distance_count: int
    counts: Any
    one_sided: int
    distances: Any
    position: Any
    orientation: Any
    spacing: Any
    friction: float
    thickness: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("distance_count", c_uint32),
        ("counts", c_uint32 * 3),
        ("one_sided", c_uint32),
        ("distances", POINTER(c_double)),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("spacing", c_double * 3),
        ("friction", c_double),
        ("thickness", c_double),
    ]


class vbss_scene_plane_config(ctypes.Structure):
    """Configuration of a plane. Fill it with vbss_scene_plane_config_init, then change fields.

    normal: Direction out of the half-space that the plane bounds, of any length from 1e-100 to
    1e100; default 0, 1, 0.

    height: Height of the plane along its normal, m, at most 1e3 in magnitude; default 0.

    friction: Coefficient of friction, 0 to 10; default 0.3. A contact with a thread has this
    coefficient, any other contact the geometric mean of both."""
    struct_size: int
    reserved: int
    normal: Any
    height: float
    friction: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("normal", c_double * 3),
        ("height", c_double),
        ("friction", c_double),
    ]


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_scene_static_mesh_config_init": (c_int32, (POINTER(vbss_scene_static_mesh_config),
        c_uint32)),
    "vbss_scene_add_static_mesh": (c_int32, (POINTER(vbss_scene),
        POINTER(vbss_scene_static_mesh_config), POINTER(c_uint32))),
    "vbss_scene_add_rigid_mesh": (c_int32, (POINTER(vbss_scene), POINTER(vbss_scene_rigid_config),
        POINTER(vbss_scene_static_mesh_config), POINTER(c_uint32))),
    "vbss_scene_height_field_config_init": (c_int32, (POINTER(vbss_scene_height_field_config),
        c_uint32)),
    "vbss_scene_add_height_field": (c_int32, (POINTER(vbss_scene),
        POINTER(vbss_scene_height_field_config), POINTER(c_uint32))),
    "vbss_scene_distance_field_config_init": (c_int32, (POINTER(vbss_scene_distance_field_config),
        c_uint32)),
    "vbss_scene_add_distance_field": (c_int32, (POINTER(vbss_scene),
        POINTER(vbss_scene_distance_field_config), POINTER(c_uint32))),
    "vbss_scene_plane_config_init": (c_int32, (POINTER(vbss_scene_plane_config), c_uint32)),
    "vbss_scene_add_plane": (c_int32, (POINTER(vbss_scene), POINTER(vbss_scene_plane_config),
        POINTER(c_uint32))),
}
