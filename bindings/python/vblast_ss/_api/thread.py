"""thread.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64, c_uint8
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import Method, vbss_context, vbss_view
from .baseline import vbss_baseline_config, vbss_baseline_statistics


class ThreadBending(IntEnum):
    """The constants of vbss_thread_bending."""
    SPLINE = 0
    """Fourth order: the energy of the cubic spline through the nodes, truncated to neighbours
    three apart. The length of a segment is that of its arc."""
    LOCAL = 1
    """Second order: each node couples with its two neighbours only. The length of a segment is its
    chord."""


class ThreadMesh(IntEnum):
    """The constants of vbss_thread_mesh."""
    FIXED = 0
    """Nodes and rest lengths stay as they were created."""
    ADAPTIVE = 1
    """Method IMPLICIT, docs/explanation/adaptive.md: between two steps the thread divides segments
    where it is bent or near another body, and removes nodes where it is straight and has
    clearance. This renumbers nodes, segments, attachments, pins, grasps and contacts."""


class ThreadPreset(IntEnum):
    """The constants of vbss_thread_preset."""
    SILK_2_0 = 0
    """2-0 silk: 0.32 mm, 1.05e-4 kg/m, EA = 700 N (8.7 GPa), EI = 2.7e-8 N m^2. Diameter by USP
    <861> (0.30 to 0.339 mm), density of a solid braid; EI is that of the paper's thread, scaled
    with the fourth power of the radius, and uncertain by a factor of five."""
    VBLAST = 1
    """The thread of VBLaST-SS: 0.25 mm, 6.4e-5 kg/m, EA = 427 N, EI = 1e-8 N m^2."""


class ThreadMaterial(IntEnum):
    """The constants of vbss_thread_material. docs/reference/sutures.md has sources and
    uncertainties."""
    SILK = 0
    """Braided silk."""
    POLYGLACTIN = 1
    """Braided polyglactin 910, absorbable."""
    POLYPROPYLENE = 2
    """Polypropylene monofilament."""
    NYLON = 3
    """Nylon monofilament."""


class ThreadUspSize(IntEnum):
    """The constants of vbss_thread_usp_size, with the middle of the range of the diameter, mm."""
    USP_10_0 = -10
    """0.025 (0.020 to 0.029)."""
    USP_9_0 = -9
    """0.035 (0.030 to 0.039)."""
    USP_8_0 = -8
    """0.045 (0.040 to 0.049)."""
    USP_7_0 = -7
    """0.06 (0.050 to 0.069)."""
    USP_6_0 = -6
    """0.085 (0.070 to 0.099)."""
    USP_5_0 = -5
    """0.125 (0.100 to 0.149)."""
    USP_4_0 = -4
    """0.175 (0.150 to 0.199)."""
    USP_3_0 = -3
    """0.225 (0.200 to 0.249)."""
    USP_2_0 = -2
    """0.32 (0.300 to 0.339)."""
    USP_0 = 0
    """0.375 (0.350 to 0.399)."""
    USP_1 = 1
    """0.45 (0.400 to 0.499)."""
    USP_2 = 2
    """0.55 (0.500 to 0.599)."""


class ThreadAttachmentKind(IntEnum):
    """The constants of vbss_thread_attachment_kind."""
    PIN = 0
    """The node is held at `position`."""
    CLAMP = 1
    """The node is held at `position`, and the thread's direction there is `direction`."""
    FORCE = 2
    """`force` pulls at the node."""
    SPRING = 3
    """A spring-damper from `position` to the node."""
    MASS = 4
    """`mass` is fixed to the node; it has inertia and weight."""
    ROLL = 5
    """Threads with torsional_stiffness: holds the section at the node, which moves freely;
    vbss_thread_set_roll turns it. A CLAMP does this, too."""


class ThreadField(IntEnum):
    """The constants of vbss_thread_field. n is the number of nodes."""
    POSITIONS = 0
    """n x 3 doubles, m."""
    VELOCITIES = 1
    """n x 3 doubles, m/s."""
    REST_LENGTHS = 2
    """n - 1 doubles, m."""
    LENGTHS = 3
    """n - 1 doubles, m: chords, or arcs with BENDING_SPLINE."""
    TENSIONS = 4
    """n - 1 doubles, N: force along each segment at the end of the last step, due to stretching
    and bending."""
    CURVATURES = 5
    """n x 3 doubles, 1/m: from the node to the centre of curvature."""
    SECTIONS = 6
    """First node of each section, uint32_t; the last ends at node n - 1."""
    SAGITTAS = 7
    """n - 1 doubles, m: sagitta of each segment, the shape error due to the mesh. It is rest
    length^2 / 8 times the larger curvature at the two nodes. Fixed meshes have it too."""
    PLASTIC_CURVATURES = 8
    """n x 3 doubles, 1/m: plastic curvature at each node, towards the centre of curvature; at a
    clamp as VBSS_THREAD_VIEW_CURVATURES. No entries in a thread without memory of bends."""
    VISCOUS_CURVATURES = 9
    """The same for the viscous curvature: that at which the viscous branch has no moment."""
    TWISTS = 10
    """n - 1 doubles, rad/m: twist per length of each segment; between a holder and a free end 0,
    with friction_torque rest_twist where no contact resists. No entries in a thread without
    torsional_stiffness."""
    MATERIAL_DIRECTORS = 11
    """n - 1 x 3 doubles: a unit vector across each segment, at its middle, that is fixed to the
    material; for display. No entries in a thread without torsional_stiffness."""


class vbss_thread(ctypes.Structure):
    """A suture thread."""


class vbss_thread_config(ctypes.Structure):
    """Configuration of a thread. Fill it with vbss_thread_config_init, then change fields.

    method: Method; default VBSS_METHOD_IMPLICIT.

    bending: Method IMPLICIT: discretisation of bending; default VBSS_THREAD_BENDING_SPLINE.

    segment_count: Number of segments, 1 to 65536; default 120.

    attachment_capacity: Largest number of attachments, 0 to 256; default 8.

    cut_capacity: Largest number of cuts of this thread and its pieces, 0 to 64; default 0.

    length: Length, m, 1e-6 to 1e3, at least 1e-7 per segment; default 0.15; ignored with
    rest_lengths.

    radius: Radius, m, 1e-7 to 0.1; default of VBSS_THREAD_PRESET_VBLAST. Contact in a scene and
    display use it; a thread alone does not.

    linear_density: Mass per length, kg/m, 1e-9 to 1e3; default of that preset.

    axial_stiffness: Axial stiffness EA, N, 1e-6 to 1e9; default of that preset.

    bending_stiffness: Bending stiffness EI, N m^2, 0 to 1e3; default of that preset.

    rest_curvature: Curvature at rest, 1/m, 0 to 1e4; default 0. Its plane is free, because such
    a thread has no twist: it does not work with torsional_stiffness.

    gravity: Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default
    (0, -9.81, 0).

    drag: Drag coefficient, 1/s, 0 to 1e6; default 0. The force is -drag * mass * velocity.

    damping: Method IMPLICIT: decay rate of the motion relative to the rigid motion of each
    section, 1/s, 0 to 1e6; default 0. It conserves linear and angular momentum.

    start: Position of node 0, m, each coordinate at most 1e3 in magnitude; default (0, 0, 0);
    ignored with positions.

    direction: Direction from node 0 on, of any length from 1e-100 to 1e100; default (1, 0, 0);
    ignored with positions.

    rest_lengths: Rest length of each segment, m, 1e-7 to 1e2; segment_count values, or NULL
    (default) for length / segment_count each. vbss_thread_grade_lengths fills such an array.
    The library copies it.

    positions: Positions of the nodes, m, each at most 1e3; 3 (segment_count + 1) values, or
    NULL (default) for a straight thread from start along direction. The library copies them.

    spectral_radius: Method IMPLICIT: spectral radius at infinite frequency of the time
    integration, 0 (strongest damping) to 1 (none); default 0.3. Above 0.5 stiff motion may gain
    energy.

    stretch_tolerance: Method IMPLICIT: largest stretch error that a step may leave, 1e-12 to
    1e-2; default 1e-6.

    position_tolerance: Method IMPLICIT: largest distance by which a further linearisation would
    move a node, m, 1e-12 to 1; an estimate; default 1e-6.

    iteration_limit: Method IMPLICIT: largest number of linearisations of an attempt, 1 to 100;
    default 40. Smooth motion takes one or two. The worst known case (ends shaken by 3 mm every
    ms) takes 300 in a step with its halves.

    halving_limit: Method IMPLICIT: how often a step is halved before its state is accepted
    unconverged, 0 to 10; default 5. `forced` counts such states and should stay zero.

    baseline: Method VBLAST: its parameters; NULL (default): their defaults. The library copies
    them.

    mesh: Default VBSS_THREAD_MESH_FIXED, which ignores the following fields.

    node_capacity: ADAPTIVE: largest number of nodes, segment_count + 1 to 65537; default 0:
    four times the initial number of segments, at most 65536. A scene must have capacity for all
    of them when the thread is added.

    finest_length: ADAPTIVE: length of the finest segments, m, 1e-7 to coarsest_length; default
    3e-4, 1.2 diameters of the paper's thread, at which a tight knot is converged. Because
    segments are halved, the finest ones have 0.63 to 1.25 times this length. Choose initial
    lengths of this length times a power of two.

    coarsest_length: ADAPTIVE: a node is not removed if that leaves a segment longer than 1.25
    times this length, m, at most 1e2; default 2e-3.

    refine_angle: ADAPTIVE: curvature times length, rad, above which a segment is divided, 0.01
    to 1; default 0.25.

    coarsen_angle: ADAPTIVE: curvature times length, rad, below which a node may be removed, 0
    to half of refine_angle; default 0.05.

    near_distance: ADAPTIVE, in a scene: gap, m, to another strand below which a segment is
    divided down to finest_length, and to a tool down to a quarter of its radius; 0 to 0.1;
    default 1e-3. The floor does not count.

    clear_distance: ADAPTIVE, in a scene: a node is removed only if no other body is within this
    gap, m, near_distance to 0.1; default 3e-3.

    mesh_operations: ADAPTIVE: largest number of divisions and removals after a step, 0 to 64;
    default 4.

    friction_torque: 1: contacts of a scene resist rolling of the thread about itself by their
    friction, so that a tight knot holds twist on either side of itself; 0 (default): they let
    it roll. Needs torsional_stiffness. docs/explanation/twist.md has the model.

    yield_curvature: Method IMPLICIT: elastic curvature beyond which bending is plastic, 1/m, 0
    to 1e6; default 0: bending is elastic. The bending moment at yield is EI times this
    curvature. docs/explanation/bending-memory.md has the model. Memory of bends, plastic or
    viscous, needs VBSS_THREAD_MESH_FIXED and a rest_curvature of 0.

    yield_hardening: Stiffness of bending beyond yield as a fraction of EI, 0 (ideally plastic)
    to 0.999; default 0. The hardening is linear and kinematic.

    relaxation_ratio: Method IMPLICIT: stiffness of the viscous branch of bending as a fraction
    of EI, 0 to 1e3; default 0: there is none. A fast bend has the stiffness EI (1 +
    relaxation_ratio), a slow one EI.

    relaxation_time: Time in which the moment of the viscous branch decays to 1/e at constant
    curvature, s, 1e-6 to 1e9; default 1.

    torsional_stiffness: Method IMPLICIT: torsional stiffness GJ, N m^2, 0 to 1e3; default 0:
    the thread has no twist. docs/explanation/twist.md has the model. Twist needs
    VBSS_THREAD_MESH_FIXED, a rest_curvature of 0 and bends without memory.

    rest_twist: Twist per length at which there is no torque, rad/m, -1e5 to 1e5; default 0;
    needs torsional_stiffness."""
    struct_size: int
    method: int
    bending: int
    segment_count: int
    attachment_capacity: int
    cut_capacity: int
    length: float
    radius: float
    linear_density: float
    axial_stiffness: float
    bending_stiffness: float
    rest_curvature: float
    gravity: Any
    drag: float
    damping: float
    start: Any
    direction: Any
    rest_lengths: Any
    positions: Any
    spectral_radius: float
    stretch_tolerance: float
    position_tolerance: float
    iteration_limit: int
    halving_limit: int
    baseline: Any
    mesh: int
    node_capacity: int
    finest_length: float
    coarsest_length: float
    refine_angle: float
    coarsen_angle: float
    near_distance: float
    clear_distance: float
    mesh_operations: int
    friction_torque: int
    yield_curvature: float
    yield_hardening: float
    relaxation_ratio: float
    relaxation_time: float
    torsional_stiffness: float
    rest_twist: float
    _kinds_: ClassVar[dict[str, Any]] = {"method": Method, "bending": ThreadBending, "mesh": ThreadMesh}
    _fields_ = [
        ("struct_size", c_uint32),
        ("method", c_int32),
        ("bending", c_int32),
        ("segment_count", c_uint32),
        ("attachment_capacity", c_uint32),
        ("cut_capacity", c_uint32),
        ("length", c_double),
        ("radius", c_double),
        ("linear_density", c_double),
        ("axial_stiffness", c_double),
        ("bending_stiffness", c_double),
        ("rest_curvature", c_double),
        ("gravity", c_double * 3),
        ("drag", c_double),
        ("damping", c_double),
        ("start", c_double * 3),
        ("direction", c_double * 3),
        ("rest_lengths", POINTER(c_double)),
        ("positions", POINTER(c_double)),
        ("spectral_radius", c_double),
        ("stretch_tolerance", c_double),
        ("position_tolerance", c_double),
        ("iteration_limit", c_uint32),
        ("halving_limit", c_uint32),
        ("baseline", POINTER(vbss_baseline_config)),
        ("mesh", c_int32),
        ("node_capacity", c_uint32),
        ("finest_length", c_double),
        ("coarsest_length", c_double),
        ("refine_angle", c_double),
        ("coarsen_angle", c_double),
        ("near_distance", c_double),
        ("clear_distance", c_double),
        ("mesh_operations", c_uint32),
        ("friction_torque", c_uint32),
        ("yield_curvature", c_double),
        ("yield_hardening", c_double),
        ("relaxation_ratio", c_double),
        ("relaxation_time", c_double),
        ("torsional_stiffness", c_double),
        ("rest_twist", c_double),
    ]


class vbss_thread_attachment(ctypes.Structure):
    """An attachment acts on one node. Fill it with vbss_thread_attachment_init.

    kind: Kind; default VBSS_THREAD_ATTACHMENT_PIN.

    node: Node, 0 to segment_count; default 0.

    position: PIN, CLAMP: target of the node in the next step; SPRING: its fixed end; m, each
    coordinate at most 1e3 in magnitude.

    direction: CLAMP: direction of the thread towards higher nodes, of any length from 1e-100 to
    1e100; default (1, 0, 0). A thread with another direction turns there in the next step.

    force: FORCE: force, N, each component at most 1e6 in magnitude.

    stiffness: SPRING: stiffness, N/m, 0 to 1e9.

    damping: SPRING: damping of the velocity relative to the moving end, N s/m, 0 to 1e6.

    mass: MASS: mass, kg, 0 to 1e3."""
    struct_size: int
    kind: int
    node: int
    reserved: int
    position: Any
    direction: Any
    force: Any
    stiffness: float
    damping: float
    mass: float
    _kinds_: ClassVar[dict[str, Any]] = {"kind": ThreadAttachmentKind}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("node", c_uint32),
        ("reserved", c_uint32),
        ("position", c_double * 3),
        ("direction", c_double * 3),
        ("force", c_double * 3),
        ("stiffness", c_double),
        ("damping", c_double),
        ("mass", c_double),
    ]


class vbss_thread_reaction(ctypes.Structure):
    """Reaction of an attachment in the last step.

    node: The node, as cuts have renumbered it.

    force: Force of the attachment on the thread at the end of the step, N.

    torque: CLAMP, ROLL: torque of the attachment on the thread, N m; else 0."""
    struct_size: int
    node: int
    force: Any
    torque: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("node", c_uint32),
        ("force", c_double * 3),
        ("torque", c_double * 3),
    ]


class ThreadReaction(NamedTuple):
    """Reaction of an attachment in the last step. Fields as vbss_thread_reaction says."""
    node: int
    force: tuple[float, ...]
    torque: tuple[float, ...]


class vbss_thread_energies(ctypes.Structure):
    """Energies of a thread, J.

    kinetic: Kinetic energy, attached masses included.

    stretching: Elastic energy of EA.

    bending: Elastic energy of bending; with memory what hardening stores, too.

    gravity: Potential, zero at the origin; attached masses included.

    total: Sum of the four and of `twisting`.

    dissipated: Energy that plastic and viscous bending have dissipated since creation, or since
    the cut that made this piece; not part of the total; never decreases.

    twisting: Elastic energy of twist."""
    struct_size: int
    reserved: int
    kinetic: float
    stretching: float
    bending: float
    gravity: float
    total: float
    dissipated: float
    twisting: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("kinetic", c_double),
        ("stretching", c_double),
        ("bending", c_double),
        ("gravity", c_double),
        ("total", c_double),
        ("dissipated", c_double),
        ("twisting", c_double),
    ]


class ThreadEnergies(NamedTuple):
    """Energies of a thread, J. Fields as vbss_thread_energies says."""
    kinetic: float
    stretching: float
    bending: float
    gravity: float
    total: float
    dissipated: float
    twisting: float


class vbss_thread_momentum(ctypes.Structure):
    """Momentum of a thread, attached masses included.

    mass: Mass, kg.

    centre: Centre of mass, m.

    linear: Linear momentum, kg m/s.

    angular: Angular momentum about the origin, kg m^2/s."""
    struct_size: int
    reserved: int
    mass: float
    centre: Any
    linear: Any
    angular: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("mass", c_double),
        ("centre", c_double * 3),
        ("linear", c_double * 3),
        ("angular", c_double * 3),
    ]


class ThreadMomentum(NamedTuple):
    """Momentum of a thread, attached masses included. Fields as vbss_thread_momentum says."""
    mass: float
    centre: tuple[float, ...]
    linear: tuple[float, ...]
    angular: tuple[float, ...]


class vbss_thread_statistics(ctypes.Structure):
    """Counters since creation, and results of the last step. vbss_thread_get_baseline_statistics
    returns what method VBLAST counts beside these.

    last_iterations: IMPLICIT: linearisations of the last step.

    steps: Calls of vbss_thread_step that succeeded.

    iterations: IMPLICIT: linearisations.

    substeps: Accepted parts of steps; equal to steps if none was divided.

    first_order: IMPLICIT: substeps made by backward Euler.

    rejections: IMPLICIT: attempts that were rejected and halved.

    forced: IMPLICIT: substeps accepted unconverged, at the last halving.

    softened: IMPLICIT: linearisations repeated with less compression, parts that started from
    the old positions because the prediction was unusable, and parts in which the force of rest
    curvature was kept constant.

    last_stretch_error: IMPLICIT: max |length / rest length - 1 - T / EA| after the last step;
    VBLAST: max |length / rest length - 1|.

    stretch_error: Largest stretch error after any part of a step.

    last_stretch: max (length / rest length - 1) after the last step.

    time: Simulated time, s.

    refined: Segments divided.

    coarsened: Nodes removed.

    laid_on_chord: Divisions whose new node is on the chord instead of the arc, for lack of
    clearance.

    refused_capacity: Divisions refused because thread or scene had no free node.

    refused_held: Changes refused at or beside attachments, pins, grasps or the ends at a cut.

    refused_near: Removals refused because another body was too near.

    nodes: Present number of nodes; also for a fixed mesh.

    most_nodes: Largest number of nodes so far; 0 for a fixed mesh.

    sagitta: Largest of VBSS_THREAD_VIEW_SAGITTAS, m; also for a fixed mesh."""
    struct_size: int
    last_iterations: int
    steps: int
    iterations: int
    substeps: int
    first_order: int
    rejections: int
    forced: int
    softened: int
    last_stretch_error: float
    stretch_error: float
    last_stretch: float
    time: float
    refined: int
    coarsened: int
    laid_on_chord: int
    refused_capacity: int
    refused_held: int
    refused_near: int
    nodes: int
    most_nodes: int
    sagitta: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("last_iterations", c_uint32),
        ("steps", c_uint64),
        ("iterations", c_uint64),
        ("substeps", c_uint64),
        ("first_order", c_uint64),
        ("rejections", c_uint64),
        ("forced", c_uint64),
        ("softened", c_uint64),
        ("last_stretch_error", c_double),
        ("stretch_error", c_double),
        ("last_stretch", c_double),
        ("time", c_double),
        ("refined", c_uint64),
        ("coarsened", c_uint64),
        ("laid_on_chord", c_uint64),
        ("refused_capacity", c_uint64),
        ("refused_held", c_uint64),
        ("refused_near", c_uint64),
        ("nodes", c_uint32),
        ("most_nodes", c_uint32),
        ("sagitta", c_double),
    ]


class ThreadStatistics(NamedTuple):
    """Counters since creation, and results of the last step. vbss_thread_get_baseline_statistics
    returns what method VBLAST counts beside these. Fields as vbss_thread_statistics says."""
    last_iterations: int
    steps: int
    iterations: int
    substeps: int
    first_order: int
    rejections: int
    forced: int
    softened: int
    last_stretch_error: float
    stretch_error: float
    last_stretch: float
    time: float
    refined: int
    coarsened: int
    laid_on_chord: int
    refused_capacity: int
    refused_held: int
    refused_near: int
    nodes: int
    most_nodes: int
    sagitta: float


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_thread_config_init": (c_int32, (POINTER(vbss_thread_config), c_uint32)),
    "vbss_thread_config_preset": (c_int32, (POINTER(vbss_thread_config), c_int32)),
    "vbss_thread_config_suture": (c_int32, (POINTER(vbss_thread_config), c_int32, c_int32)),
    "vbss_thread_grade_lengths": (c_int32, (c_double, c_double, c_double, c_double, c_double,
        POINTER(c_double), c_uint32, POINTER(c_uint32))),
    "vbss_thread_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_thread_config),
        POINTER(POINTER(vbss_thread)))),
    "vbss_thread_destroy": (c_int32, (POINTER(vbss_thread),)),
    "vbss_thread_discard": (c_int32, (POINTER(vbss_thread),)),
    "vbss_thread_step": (c_int32, (POINTER(vbss_thread), c_double)),
    "vbss_thread_set_state": (c_int32, (POINTER(vbss_thread), POINTER(c_double), POINTER(c_double),
        c_uint32)),
    "vbss_thread_attachment_init": (c_int32, (POINTER(vbss_thread_attachment), c_uint32)),
    "vbss_thread_attach": (c_int32, (POINTER(vbss_thread), POINTER(vbss_thread_attachment),
        POINTER(c_uint32))),
    "vbss_thread_set_attachment_target": (c_int32, (POINTER(vbss_thread), c_uint32,
        POINTER(c_double), POINTER(c_double))),
    "vbss_thread_set_roll": (c_int32, (POINTER(vbss_thread), c_uint32, c_double)),
    "vbss_thread_detach": (c_int32, (POINTER(vbss_thread), c_uint32)),
    "vbss_thread_get_reaction": (c_int32, (POINTER(vbss_thread), c_uint32,
        POINTER(vbss_thread_reaction), c_uint32)),
    "vbss_thread_cut": (c_int32, (POINTER(vbss_thread), c_double, POINTER(POINTER(vbss_thread)))),
    "vbss_thread_get_view": (c_int32, (POINTER(vbss_thread), c_int32, POINTER(vbss_view),
        c_uint32)),
    "vbss_thread_get_energies": (c_int32, (POINTER(vbss_thread), POINTER(vbss_thread_energies),
        c_uint32)),
    "vbss_thread_get_momentum": (c_int32, (POINTER(vbss_thread), POINTER(vbss_thread_momentum),
        c_uint32)),
    "vbss_thread_get_statistics": (c_int32, (POINTER(vbss_thread), POINTER(vbss_thread_statistics),
        c_uint32)),
    "vbss_thread_get_baseline_statistics": (c_int32, (POINTER(vbss_thread),
        POINTER(vbss_baseline_statistics), c_uint32)),
    "vbss_thread_save": (c_int32, (POINTER(vbss_thread), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_thread_restore": (c_int32, (POINTER(vbss_thread), POINTER(c_uint8), c_uint64)),
    "vbss_thread_get_hash": (c_int32, (POINTER(vbss_thread), POINTER(c_uint64))),
}
