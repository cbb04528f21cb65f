"""replica.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import vbss_view
from .scene import vbss_scene


class ReplicaKind(IntEnum):
    """The constants of vbss_replica_kind."""
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
    """Another rigid body."""


class ReplicaField(IntEnum):
    """The constants of vbss_replica_field. Bodies have the order of the scene's table of bodies."""
    BODIES = 0
    """x 8 uint32_t: vbss_replica_kind, number of the body in its scene, first node, number of
    nodes, first triangle, number of triangles, first capsule, number of capsules."""
    POSES = 1
    """x 7, one row per body: position of the frame that vbss_scene_get_rigid reports, m, and
    orientation w, x, y, z. Threads and drains have 0, 0, 0 and 1, 0, 0, 0."""
    SIZES = 2
    """x 2, one row per body: radius of a thread or of a needle's wire, or half the thickness of a
    drain's wall, m, otherwise 0; angle of each jaw of a grasper from the middle, rad, otherwise
    0."""
    NODES = 3
    """x 3: positions of the nodes of threads and drains, m."""
    TENSIONS = 4
    """x 1, one row per node: tension of the segment of a thread that begins at this node, N,
    without the part of bending, as visuals show it. It is 0 at the last node of a thread and at
    nodes of drains."""
    TRIANGLES = 5
    """x 3 uint32_t: nodes of the triangles of drains, counted from the drain's first node,
    counter-clockwise seen from outside."""
    CAPSULES = 6
    """x 7: both ends of the axis and the radius of the capsules of rigid bodies, needles and
    graspers, m."""
    HOLES = 7
    """x 4 uint32_t, one row per hole: its id, number of the needle in it or 0, number of the
    thread in it or 0, number of the drain."""
    HOLE_PLACES = 8
    """x 8, one row per hole: position, position on the drain at rest, radius of the suture in it,
    arc length of the suture there, m."""
    CONTACTS = 9
    """x 5 uint32_t: as VBSS_SCENE_VIEW_CONTACTS."""
    CONTACT_POINTS = 10
    """x 3: point between the two surfaces, m."""
    CONTACT_NORMALS = 11
    """x 3: unit normal from b to a."""
    CONTACT_FORCES = 12
    """x 3: force of b on a, N."""
    CONTACT_GAPS = 13
    """x 1: distance of the surfaces, m."""


class vbss_replica(ctypes.Structure):
    """A copy of a scene for another thread."""


class vbss_replica_config(ctypes.Structure):
    """Configuration of a replica. Fill it with vbss_replica_config_init, then change fields.

    drain_node_capacity: Largest number of nodes of all drains, 0 to 2^20. Default 0: the nodes
    of the drains that the scene has when the replica is created. All other capacities are those
    of the scene."""
    struct_size: int
    drain_node_capacity: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("drain_node_capacity", c_uint32),
    ]


class vbss_replica_state(ctypes.Structure):
    """The state that was taken last.

    is_new: 1: this call took a state; 0: none was published since the last take, so it is the
    same as before.

    number: Number of the state: 1 for the first that was published; 0: none was published yet,
    and all arrays are empty.

    missed: Published states that the reader has never taken, up to this one.

    steps: Steps of the scene: vbss_scene_statistics::steps.

    time: Simulated time of the scene, s: vbss_scene_statistics::time.

    bytes: Bytes that the call copied that published this state.

    floor: 1: the scene has a floor; otherwise 0.

    floor_normal: Direction up of the floor, unit.

    floor_height: Height of the floor along its normal, m."""
    struct_size: int
    is_new: int
    number: int
    missed: int
    steps: int
    time: float
    bytes: int
    floor: int
    reserved: int
    floor_normal: Any
    floor_height: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("is_new", c_int32),
        ("number", c_uint64),
        ("missed", c_uint64),
        ("steps", c_uint64),
        ("time", c_double),
        ("bytes", c_uint64),
        ("floor", c_int32),
        ("reserved", c_uint32),
        ("floor_normal", c_double * 3),
        ("floor_height", c_double),
    ]


class ReplicaState(NamedTuple):
    """The state that was taken last. Fields as vbss_replica_state says."""
    is_new: int
    number: int
    missed: int
    steps: int
    time: float
    bytes: int
    floor: int
    floor_normal: tuple[float, ...]
    floor_height: float


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_replica_config_init": (c_int32, (POINTER(vbss_replica_config), c_uint32)),
    "vbss_replica_create": (c_int32, (POINTER(vbss_scene), POINTER(vbss_replica_config),
        POINTER(POINTER(vbss_replica)))),
    "vbss_replica_destroy": (c_int32, (POINTER(vbss_replica),)),
    "vbss_replica_publish": (c_int32, (POINTER(vbss_replica), POINTER(vbss_scene))),
    "vbss_replica_take": (c_int32, (POINTER(vbss_replica), POINTER(vbss_replica_state), c_uint32)),
    "vbss_replica_get_view": (c_int32, (POINTER(vbss_replica), c_int32, POINTER(vbss_view),
        c_uint32)),
}
