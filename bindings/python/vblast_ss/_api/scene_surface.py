"""scene_surface.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_double, c_int32, c_uint32, c_void_p
from enum import IntEnum
from typing import Any, ClassVar

from .base import vbss_view
from .scene import vbss_scene


class SceneSurfaceField(IntEnum):
    """The constants of vbss_scene_surface_field."""
    POSITIONS = 1
    """Positions of the vertices after the last step, m: vertex_count times x, y, z. They differ
    from the targets while a step is suspended, and after a step of which the scene left out a
    part."""
    TARGETS = 2
    """Positions that the host gave last, m: vertex_count times x, y, z."""
    FORCES = 3
    """Forces of contacts and holes on the vertices at the end of the last step, friction included,
    N: vertex_count times x, y, z. Each contact force acts at a point of the middle of the wall,
    and the corners of the triangle or edge there share it by its barycentric coordinates. So
    the forces on the vertices have the sum and the torque of the contact forces at these
    points. The corners of the triangle in which a hole is share its force in the same way.
    After a step of which the scene left out a part they are those of the step before."""


class vbss_scene_surface_config(ctypes.Structure):
    """Configuration of a host surface. Fill it with vbss_scene_surface_config_init, then change
    fields.

    vertex_count: Number of vertices, 3 to 65536.

    triangle_count: Number of triangles, 1 to 131072.

    one_sided: 0: both sides are solid. Other values are refused: the guard does not yet hold
    for one side of a surface that moves.

    vertices: First positions of the vertices in the world, m: vertex_count times x, y, z, each
    at most 1e3 in magnitude; the library copies them.

    triangles: Corners of triangles: triangle_count times three different indices of vertices,
    in any order. No triangle may be so thin that the cross product of two of its sides is zero.
    The library copies them.

    friction: Friction coefficient of its surface, 0 to 10; default 0.15. A contact with a
    thread has this coefficient, any other contact the geometric mean of both.

    thickness: Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. The triangles are its
    middle: other bodies touch it at half the thickness from them.

    jump_limit: Largest distance between two positions of a vertex that the host gives one after
    the other, m, 1e-6 to 1e3; default 20e-3: 20 m/s at steps of 1 ms. vbss_scene_move_surface
    refuses a longer one.

    compliance_size: Numbers with which the host states how far each vertex gives way to a
    force: 0 (default): none, all vertices are exactly where the host says; 1: one compliance
    for all directions; 9: a symmetric matrix of 3 x 3. Values are set by
    vbss_scene_set_surface_compliance, and are zero before.

    puncture_force: Force along the direction of a tip at which it enters the wall, N, 1e-3 to
    1e3; 0 (default): no tip enters by force, and holes are those of vbss_scene_make_hole only.

    hole_force: Friction of a hole with a needle that slides in it, N, 1e-6 to 1e3; default
    0.25.

    hole_friction: Coefficient of the additional friction from the force across the suture, 0 to
    10; default 0.3.

    hole_stiffness: Stiffness of a hole across and along the suture in it, N/m, 1 to 1e7;
    default 2e4.

    hole_damping: Damping of sliding in a hole, N s/m, 0 to 1e3; default 0.05.

    tip_length: Length of a tip's path through the wall over which the force against its advance
    falls from puncture_force to hole_force, and that against drawing it back grows from 0 to
    hole_force; m, 0 to 0.1; default 0.5e-3.

    thread_force: Friction of a hole with a slack thread in it, N, 1e-6 to 1e3; default 0.02.

    tear_energy: Energy for each square metre of cut, J/m^2, 1 to 1e7; 0 (default): threads do
    not tear the wall at their holes. Otherwise as vbss_drain_config::tear_energy."""
    struct_size: int
    vertex_count: int
    triangle_count: int
    one_sided: int
    vertices: Any
    triangles: Any
    friction: float
    thickness: float
    jump_limit: float
    compliance_size: int
    reserved: int
    puncture_force: float
    hole_force: float
    hole_friction: float
    hole_stiffness: float
    hole_damping: float
    tip_length: float
    thread_force: float
    tear_energy: float
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
        ("jump_limit", c_double),
        ("compliance_size", c_uint32),
        ("reserved", c_uint32),
        ("puncture_force", c_double),
        ("hole_force", c_double),
        ("hole_friction", c_double),
        ("hole_stiffness", c_double),
        ("hole_damping", c_double),
        ("tip_length", c_double),
        ("thread_force", c_double),
        ("tear_energy", c_double),
    ]


class vbss_scene_hole_place(ctypes.Structure):
    """A hole of a host surface that gets another mesh, as vbss_scene_place_hole_fn receives it.

    hole: Id of the hole, as vbss_scene_make_hole gave it.

    triangle: Triangle of the mesh before in which the hole is.

    weights: Barycentric coordinates of the hole in that triangle.

    position: Where the hole is now, in the world, m.

    normal: Unit normal of that triangle now: along (b - a) x (c - a) for its corners a, b, c."""
    struct_size: int
    hole: int
    triangle: int
    reserved: int
    weights: Any
    position: Any
    normal: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("hole", c_uint32),
        ("triangle", c_uint32),
        ("reserved", c_uint32),
        ("weights", c_double * 3),
        ("position", c_double * 3),
        ("normal", c_double * 3),
    ]


# Says where on the new mesh of a host surface a hole is (vbss_scene_remesh_surface). It runs on
# the thread that remeshes, once for each hole of the surface, in ascending order of the entries
# of vbss_scene_get_hole. The scene still has the mesh from before; calls that change the context
# return VBSS_ERROR_BUSY.
vbss_scene_place_hole_fn = CFUNCTYPE(c_int32, c_void_p, POINTER(vbss_scene_hole_place), POINTER(c_uint32), POINTER(c_double))


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_scene_surface_config_init": (c_int32, (POINTER(vbss_scene_surface_config), c_uint32)),
    "vbss_scene_add_surface": (c_int32, (POINTER(vbss_scene), POINTER(vbss_scene_surface_config),
        POINTER(c_uint32))),
    "vbss_scene_move_surface": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(c_double),
        c_uint32)),
    "vbss_scene_set_surface_compliance": (c_int32, (POINTER(vbss_scene), c_uint32,
        POINTER(c_double), c_uint32)),
    "vbss_scene_remesh_surface": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(c_double),
        c_uint32, POINTER(c_uint32), c_uint32, vbss_scene_place_hole_fn, c_void_p)),
    "vbss_scene_get_surface_view": (c_int32, (POINTER(vbss_scene), c_uint32, c_int32,
        POINTER(vbss_view), c_uint32)),
}
