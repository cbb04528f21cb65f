"""drain.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64, c_uint8
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import Method, vbss_context, vbss_view
from .baseline import vbss_baseline_config


class DrainMesh(IntEnum):
    """The constants of vbss_drain_mesh."""
    MESH_137 = 0
    """137 nodes, 240 triangles."""
    MESH_159 = 1
    """159 nodes, 280 triangles."""
    MESH_181 = 2
    """181 nodes, 320 triangles."""
    MESH_225 = 3
    """225 nodes, 400 triangles: for walls thinner than 0.6 mm."""


class DrainAttachmentKind(IntEnum):
    """The constants of vbss_drain_attachment_kind."""
    PIN = 0
    """The node is at `position`."""
    FORCE = 1
    """`force` pulls at the node."""
    SPRING = 2
    """A spring from `position` to the node."""


class DrainField(IntEnum):
    """The constants of vbss_drain_field. n nodes, m triangles."""
    POSITIONS = 0
    """n x 3 doubles, m, on the middle surface."""
    VELOCITIES = 1
    """n x 3 doubles, m/s."""
    REST_POSITIONS = 2
    """n x 3 doubles, m, in the drain's frame."""
    TRIANGLES = 3
    """m x 3 uint32_t, nodes counter-clockwise seen from outside."""
    SLIT_LEFT = 4
    """uint32_t: nodes of the slit's edge on the left (-z), with both tips, along x."""
    SLIT_RIGHT = 5
    """uint32_t: nodes of the slit's edge on the right (+z), with both tips, along x."""
    ANCHORS = 6
    """uint32_t: nodes of the bottom strip; method VBLAST: none."""
    ANCHOR_FORCES = 7
    """3 doubles for each of VBSS_DRAIN_VIEW_ANCHORS, N: the force of the anchor on the drain; zero
    once it is torn off."""
    STRAINS = 8
    """m x 3 doubles: strains of the middle surface along and across the triangle's first side, and
    shear (2 e12). Method VBLAST reports strains and curvatures too, although it does not resist
    them."""
    CURVATURES = 9
    """m x 3 doubles, 1/m: changes of curvature along and across the triangle's first side, and
    twist (2 k12)."""


class vbss_drain(ctypes.Structure):
    """A drain."""


class vbss_drain_surface(ctypes.Structure):
    """A triangulated sheet or tube, which a drain may be in place of the tube with a slit: a pad
    of skin, a vessel, a bowel. Fill it with vbss_drain_surface_init, then set the arrays. The
    library copies them when the drain is created.

    The triangles are those of the middle surface at rest, without stress. Each edge belongs to
    one triangle (a free edge) or to two, which list it in opposite directions; where triangles
    meet in their interior, more than three meet at a node.

    node_count: Number of nodes, 3 to 2048.

    triangle_count: Number of triangles, 1 to 4096.

    anchor_count: Number of anchored nodes, 0 to node_count; default 0.

    positions: node_count x 3: positions of the nodes at rest, in the drain's frame, m, each at
    most 1 in magnitude.

    triangles: triangle_count x 3: nodes of each triangle, counter-clockwise seen from outside.
    Needles enter from either side.

    anchors: anchor_count: nodes that are glued to their place at rest, each once; NULL if there
    are none. They tear off above vbss_drain_config::tear_stress.

    thickness: triangle_count: thickness of the wall that stiffness and mass of each triangle
    have, m, 1e-6 to 0.1; NULL (default): vbss_drain_config::thickness. Contacts use that one
    thickness everywhere.

    young_modulus: triangle_count: Young's modulus of each triangle, Pa, 1e3 to 1e12; NULL
    (default): vbss_drain_config::young_modulus."""
    struct_size: int
    node_count: int
    triangle_count: int
    anchor_count: int
    positions: Any
    triangles: Any
    anchors: Any
    thickness: Any
    young_modulus: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("node_count", c_uint32),
        ("triangle_count", c_uint32),
        ("anchor_count", c_uint32),
        ("positions", POINTER(c_double)),
        ("triangles", POINTER(c_uint32)),
        ("anchors", POINTER(c_uint32)),
        ("thickness", POINTER(c_double)),
        ("young_modulus", POINTER(c_double)),
    ]


class vbss_drain_config(ctypes.Structure):
    """Configuration of a drain. Fill it with vbss_drain_config_init, then change fields.

    method: Method; default VBSS_METHOD_IMPLICIT.

    mesh: Method IMPLICIT: mesh; default VBSS_DRAIN_MESH_137.

    mesh_divisions: Method IMPLICIT: divisions of each cell in each direction, 1 to 4; default
    1.

    attachment_capacity: Largest number of attachments, 0 to 256; default 8.

    iteration_limit: Method IMPLICIT: largest number of linearisations in a step, 1 to 50;
    default 1. A step with a larger limit stops at position_tolerance; this serves reference
    solutions.

    halving_limit: Method IMPLICIT: how often a step may be halved, 0 to 10; default 4.

    radius: Radius of the middle surface, m, 1e-4 to 1; default 6.5e-3.

    length: Length of the tube, m, 2 to 7 radii; default 32e-3.

    thickness: Thickness of the wall, m, 0.01 to 0.3 radii, or with a surface 1e-6 to 0.1;
    default 1e-3.

    slit_length: Length of the slit, m, one radius to 0.7 lengths; default 10e-3.

    slit_opening: Width of the slit at its middle, along the surface, m, 0 to 0.4 slit lengths
    and one radius; default 3e-3.

    mark_arc: Arc from the middle of the slit to each mark, along the surface before the slit
    was opened, m. It is longer than half the opening and lies between 20 and 90 degrees.
    Default 4.5e-3.

    young_modulus: Method IMPLICIT: Young's modulus, Pa, 1e3 to 1e12; default 1.2e6 (not
    verified for real drains).

    poisson_ratio: Method IMPLICIT: Poisson's ratio, 0 to 0.49; default 0.47.

    density: Density, kg/m^3, 1 to 1e5; default 950.

    drag: Drag coefficient, 1/s, 0 to 1e6; default 20. The force is -drag * mass * velocity.

    gravity: Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default
    0, because the rest shape is that of a drain that lies on its block.

    position: Origin of the drain's frame in the world, m, each at most 1e3; default 0.

    orientation: Quaternion (w, x, y, z) of any length from 1e-100 to 1e100; default (1, 0, 0,
    0).

    tear_stress: Method IMPLICIT: strength of the glue of the strip, Pa, 1 to 1e12; default 5e4
    (not verified). The anchor of a node tears off permanently above this stress times the
    node's area of the strip. Each step tears off at most one anchor: the one with the largest
    overload.

    position_tolerance: Method IMPLICIT: largest increment of the last linearisation, m, 1e-15
    to 1; default 1e-6.

    move_limit: Method IMPLICIT: a step in which a node would move farther than this gets one
    more linearisation. A step in which it would move four times as far is halved. m, 1e-9 to 1;
    default 1e-3.

    baseline: Method VBLAST: its parameters; NULL (default): their defaults. The library copies
    them.

    friction: In a scene: coefficient of friction with threads, 0 to 10. Friction with other
    bodies, the floor and the drain itself uses the geometric mean of both coefficients. Default
    0.3 (not verified).

    puncture_force: Force along the direction of a tip at which it enters a wall, N, 1e-3 to
    1e3; default 1 (the published range for both walls of a Penrose drain is 0.85 to 2.92).

    hole_force: Friction of a hole with a needle that slides in it, N, 1e-6 to 1e3; default 0.25
    (not verified).

    hole_friction: Coefficient of the additional friction from the force across the suture, 0 to
    10; default 0.3 (not verified).

    hole_stiffness: Stiffness of a hole across and along the suture in it, N/m, 1 to 1e7;
    default 2e4.

    hole_damping: Damping of sliding in a hole, N s/m, 0 to 1e3; default 0.05.

    tip_length: Length of a tip's path through the wall over which the force against its advance
    falls from puncture_force to hole_force, and that against drawing it back grows from 0 to
    hole_force; m, 0 to 0.1; default 0.5e-3.

    thread_force: Friction of a hole with a slack thread in it, N, 1e-6 to 1e3; default 0.02
    (not verified). A tight thread has capstan friction: docs/explanation/stitch.md.

    surface: Method IMPLICIT: sheet or tube in place of the tube with a slit; NULL (default):
    that tube. With a surface the fields mesh, mesh_divisions, radius, length, slit_length,
    slit_opening and mark_arc have no meaning, and the drain has neither marks nor a slit. The
    library copies the surface.

    tear_energy: In a scene, method IMPLICIT: energy for each square metre of cut, J/m^2, 1 to
    1e7; 0 (default): threads do not tear the wall at their holes. With it, a thread cuts
    through the wall when the force across it in the plane of the wall exceeds this energy times
    the thickness (of the triangle, where the surface states it): docs/explanation/tearing.md
    has published values. The mesh stays whole: the cut behind the thread is not opened."""
    struct_size: int
    method: int
    mesh: int
    mesh_divisions: int
    attachment_capacity: int
    iteration_limit: int
    halving_limit: int
    reserved: int
    radius: float
    length: float
    thickness: float
    slit_length: float
    slit_opening: float
    mark_arc: float
    young_modulus: float
    poisson_ratio: float
    density: float
    drag: float
    gravity: Any
    position: Any
    orientation: Any
    tear_stress: float
    position_tolerance: float
    move_limit: float
    baseline: Any
    friction: float
    puncture_force: float
    hole_force: float
    hole_friction: float
    hole_stiffness: float
    hole_damping: float
    tip_length: float
    thread_force: float
    surface: Any
    tear_energy: float
    _kinds_: ClassVar[dict[str, Any]] = {"method": Method, "mesh": DrainMesh}
    _fields_ = [
        ("struct_size", c_uint32),
        ("method", c_int32),
        ("mesh", c_int32),
        ("mesh_divisions", c_uint32),
        ("attachment_capacity", c_uint32),
        ("iteration_limit", c_uint32),
        ("halving_limit", c_uint32),
        ("reserved", c_uint32),
        ("radius", c_double),
        ("length", c_double),
        ("thickness", c_double),
        ("slit_length", c_double),
        ("slit_opening", c_double),
        ("mark_arc", c_double),
        ("young_modulus", c_double),
        ("poisson_ratio", c_double),
        ("density", c_double),
        ("drag", c_double),
        ("gravity", c_double * 3),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("tear_stress", c_double),
        ("position_tolerance", c_double),
        ("move_limit", c_double),
        ("baseline", POINTER(vbss_baseline_config)),
        ("friction", c_double),
        ("puncture_force", c_double),
        ("hole_force", c_double),
        ("hole_friction", c_double),
        ("hole_stiffness", c_double),
        ("hole_damping", c_double),
        ("tip_length", c_double),
        ("thread_force", c_double),
        ("surface", POINTER(vbss_drain_surface)),
        ("tear_energy", c_double),
    ]


class vbss_drain_attachment(ctypes.Structure):
    """An attachment acts on one node. Fill it with vbss_drain_attachment_init.

    kind: Kind; default VBSS_DRAIN_ATTACHMENT_PIN.

    node: Node, which is not anchored.

    position: PIN: target of the node in the next step; SPRING: its fixed end; m, each
    coordinate at most 1e3 in magnitude.

    force: FORCE: force, N, each component at most 1e6 in magnitude.

    stiffness: SPRING: stiffness, N/m, 0 to 1e9."""
    struct_size: int
    kind: int
    node: int
    reserved: int
    position: Any
    force: Any
    stiffness: float
    _kinds_: ClassVar[dict[str, Any]] = {"kind": DrainAttachmentKind}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("node", c_uint32),
        ("reserved", c_uint32),
        ("position", c_double * 3),
        ("force", c_double * 3),
        ("stiffness", c_double),
    ]


class vbss_drain_places(ctypes.Structure):
    """Places on a drain, as nodes.

    node_count: Number of nodes of the mesh.

    triangle_count: Number of triangles of the mesh.

    marks: The marks, left and right.

    gap_points: The middles of the slit's edges, left and right, which are the paper's points."""
    struct_size: int
    node_count: int
    triangle_count: int
    marks: Any
    gap_points: Any
    reserved: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("node_count", c_uint32),
        ("triangle_count", c_uint32),
        ("marks", c_uint32 * 2),
        ("gap_points", c_uint32 * 2),
        ("reserved", c_uint32),
    ]


class DrainPlaces(NamedTuple):
    """Places on a drain, as nodes. Fields as vbss_drain_places says."""
    node_count: int
    triangle_count: int
    marks: tuple[int, ...]
    gap_points: tuple[int, ...]


class vbss_drain_gap(ctypes.Structure):
    """Opening of the slit.

    largest_pair: Index of the opposite nodes that `largest` is between, along x.

    gap: Distance between the middles of the edges, m: the paper's measure.

    largest: Largest distance between opposite nodes of the edges, m.

    signed_gap: Component of the vector between the middles, left to right, along that vector at
    rest, which moves with the drain's frame, m. It is negative when the edges have crossed.

    opening: Distance between the lips at the middles of the edges, m, measured between the
    lines through the wall there. At rest it is about the gap. Where lips meet it is 0 to a
    fifth of the wall's thickness, for any rotation of the lips. Raised lips meet with their
    inner corners or face to face, while `gap` is up to a whole wall. The opening is 0 (shut)
    where one lip lies on the other. Method VBLAST measures it in the same manner.

    widest_opening: Largest opening between opposite nodes of the edges, m.

    lips: End points of `opening`, left and right, m."""
    struct_size: int
    largest_pair: int
    gap: float
    largest: float
    signed_gap: float
    opening: float
    widest_opening: float
    lips: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("largest_pair", c_uint32),
        ("gap", c_double),
        ("largest", c_double),
        ("signed_gap", c_double),
        ("opening", c_double),
        ("widest_opening", c_double),
        ("lips", (c_double * 3) * 2),
    ]


class DrainGap(NamedTuple):
    """Opening of the slit. Fields as vbss_drain_gap says."""
    largest_pair: int
    gap: float
    largest: float
    signed_gap: float
    opening: float
    widest_opening: float
    lips: tuple[tuple[float, ...], ...]


class vbss_drain_energies(ctypes.Structure):
    """Energies of a drain, J.

    kinetic: Kinetic energy of the lumped masses.

    membrane: Elastic energy of stretching; method VBLAST: zero.

    bending: Elastic energy of bending; method VBLAST: zero.

    springs: Energy of SPRING attachments; method VBLAST: also of the springs to the rest
    positions.

    gravity: Potential, zero at the origin.

    total: Sum of the energies."""
    struct_size: int
    reserved: int
    kinetic: float
    membrane: float
    bending: float
    springs: float
    gravity: float
    total: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("kinetic", c_double),
        ("membrane", c_double),
        ("bending", c_double),
        ("springs", c_double),
        ("gravity", c_double),
        ("total", c_double),
    ]


class DrainEnergies(NamedTuple):
    """Energies of a drain, J. Fields as vbss_drain_energies says."""
    kinetic: float
    membrane: float
    bending: float
    springs: float
    gravity: float
    total: float


class vbss_drain_statistics(ctypes.Structure):
    """Counters since creation, and results of the last step.

    torn: Anchors that have torn off.

    inverted: Triangles that are inverted or collapsed at present.

    steps: Calls of vbss_drain_step that succeeded, and steps of its scene.

    parts: Accepted parts of steps, equal to `steps` if none was halved; method VBLAST: explicit
    steps.

    linearisations: Linearisations assembled and solved.

    corrections_dropped: Corrections that were not small against the increment, and were left
    out.

    forced: Parts that moved a node beyond four move_limits at the last halving.

    last_move: Largest displacement of a node in a part of the last step, m.

    last_correction: Largest displacement by the last correction of the last part, m: the
    remaining error is smaller.

    time: Simulated time, s.

    matrices: New matrices: a linearisation keeps the matrix of an earlier one while no node is
    farther than 0.05 move_limit from where it was then. Method VBLAST: zero."""
    struct_size: int
    torn: int
    inverted: int
    reserved: int
    steps: int
    parts: int
    linearisations: int
    corrections_dropped: int
    forced: int
    last_move: float
    last_correction: float
    time: float
    matrices: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("torn", c_uint32),
        ("inverted", c_uint32),
        ("reserved", c_uint32),
        ("steps", c_uint64),
        ("parts", c_uint64),
        ("linearisations", c_uint64),
        ("corrections_dropped", c_uint64),
        ("forced", c_uint64),
        ("last_move", c_double),
        ("last_correction", c_double),
        ("time", c_double),
        ("matrices", c_uint64),
    ]


class DrainStatistics(NamedTuple):
    """Counters since creation, and results of the last step. Fields as vbss_drain_statistics says."""
    torn: int
    inverted: int
    steps: int
    parts: int
    linearisations: int
    corrections_dropped: int
    forced: int
    last_move: float
    last_correction: float
    time: float
    matrices: int


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_drain_config_init": (c_int32, (POINTER(vbss_drain_config), c_uint32)),
    "vbss_drain_surface_init": (c_int32, (POINTER(vbss_drain_surface), c_uint32)),
    "vbss_drain_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_drain_config),
        POINTER(POINTER(vbss_drain)))),
    "vbss_drain_destroy": (c_int32, (POINTER(vbss_drain),)),
    "vbss_drain_discard": (c_int32, (POINTER(vbss_drain),)),
    "vbss_drain_step": (c_int32, (POINTER(vbss_drain), c_double)),
    "vbss_drain_set_state": (c_int32, (POINTER(vbss_drain), POINTER(c_double), POINTER(c_double),
        c_uint32)),
    "vbss_drain_attachment_init": (c_int32, (POINTER(vbss_drain_attachment), c_uint32)),
    "vbss_drain_attach": (c_int32, (POINTER(vbss_drain), POINTER(vbss_drain_attachment),
        POINTER(c_uint32))),
    "vbss_drain_set_attachment_target": (c_int32, (POINTER(vbss_drain), c_uint32,
        POINTER(c_double))),
    "vbss_drain_detach": (c_int32, (POINTER(vbss_drain), c_uint32)),
    "vbss_drain_get_reaction": (c_int32, (POINTER(vbss_drain), c_uint32, POINTER(c_double))),
    "vbss_drain_get_places": (c_int32, (POINTER(vbss_drain), POINTER(vbss_drain_places), c_uint32)),
    "vbss_drain_get_gap": (c_int32, (POINTER(vbss_drain), POINTER(vbss_drain_gap), c_uint32)),
    "vbss_drain_get_view": (c_int32, (POINTER(vbss_drain), c_int32, POINTER(vbss_view), c_uint32)),
    "vbss_drain_get_energies": (c_int32, (POINTER(vbss_drain), POINTER(vbss_drain_energies),
        c_uint32)),
    "vbss_drain_get_statistics": (c_int32, (POINTER(vbss_drain), POINTER(vbss_drain_statistics),
        c_uint32)),
    "vbss_drain_save": (c_int32, (POINTER(vbss_drain), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_drain_restore": (c_int32, (POINTER(vbss_drain), POINTER(c_uint8), c_uint64)),
    "vbss_drain_get_hash": (c_int32, (POINTER(vbss_drain), POINTER(c_uint64))),
}
