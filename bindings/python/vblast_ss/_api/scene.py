"""scene.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64, c_uint8
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import Method, vbss_context, vbss_view
from .baseline import vbss_baseline_config, vbss_baseline_statistics
from .drain import vbss_drain
from .grasper import vbss_grasper
from .needle import vbss_needle
from .solver_options import vbss_solver_options
from .thread import vbss_thread


class SceneMode(IntEnum):
    """The constants of vbss_scene_mode."""
    REAL_TIME = 0
    """The work and the attempts of a step are limited, and the work of a call, so that it ends in
    time: see `step_budget_us` and `call_budget_us` of vbss_solver_options. Work left over is
    deferred to the next call. Time that would be deferred too long is left out and counted in
    `paused`. As a result tight knots of many throws slip a little early."""
    OFFLINE = 1
    """A step takes all the work that it needs. It is halved as often as `halving_limit` allows,
    and only then truncated, which is counted in `clamped`. After eight truncated parts the rest
    of the step is left out, for the bodies of these parts alone, and counted in `paused`. For
    experiments."""


class SceneOverlapPolicy(IntEnum):
    """The constants of vbss_scene_overlap_policy."""
    WARN = 0
    """The body is added; a warning in the log names the other body and the depth."""
    REFUSE = 1
    """The call returns VBSS_ERROR_OUT_OF_RANGE, and nothing has changed."""
    ALLOW = 2
    """The body is added without a check."""


class SceneRigidKind(IntEnum):
    """The constants of vbss_scene_rigid_kind."""
    DRIVEN = 0
    """The body follows its target exactly; only the guard can stop it."""
    COUPLED = 1
    """The body is a proxy that a virtual coupling ties to its target."""
    FREE = 2
    """The body moves under forces."""


class SceneField(IntEnum):
    """The constants of vbss_scene_field. Contacts are those that carried a force at the end of the
    last step, in the order of their features. With method VBLAST they are those with a
    response."""
    CONTACTS = 0
    """x 5 uint32_t: vbss_scene_contact_kind, body a, feature a, body b, feature b. Features are
    segments or nodes of a thread, capsules of a rigid body (2 times the capsule, plus the end
    if an end touches), and nodes, triangles or sides of a drain; floor and planes have feature
    0. Each side of a drain's triangles is numbered once, in the order of its two nodes, the
    lower node first."""
    CONTACT_POINTS = 1
    """x 3: point between the two surfaces, m."""
    CONTACT_NORMALS = 2
    """x 3: unit normal from b to a."""
    CONTACT_FORCES = 3
    """x 3: force of b on a, N. When a search for contact states has exhausted its work limit,
    these are forces with which all bodies balance. They miss the contact law by the residual,
    and may pull."""
    CONTACT_GAPS = 4
    """x 1: distance of the surfaces, m; negative when they overlap."""


class SceneContactKind(IntEnum):
    """The constants of vbss_scene_contact_kind."""
    SEGMENTS = 0
    """Two segments of threads."""
    NODE_CAPSULE = 1
    """A smoothed point of a fine thread and a capsule."""
    SEGMENT_CAPSULE = 2
    """A segment of a coarse thread and a capsule."""
    NODE_FLOOR = 3
    """A node of a thread and the floor, or a plane."""
    CAPSULES = 4
    """Two capsules of different bodies."""
    CAPSULE_FLOOR = 5
    """An end of a capsule and the floor, or a plane."""
    GRASP = 6
    """A held point and a grasper. The feature of a thread is 3 times the index of the grasp plus
    the index of one of its three held points. The feature of a needle or a drain is the index
    of the held point. The feature of the grasper is 0."""
    POINT_FACE = 7
    """A node of a thread, an end of a capsule or a node of a drain, with a triangle of a drain."""
    SIDES = 8
    """A segment of a thread, a capsule or a side of a drain's triangle, with a side of a drain's
    triangle."""
    DRAIN_FLOOR = 9
    """A node of a drain and the floor, or a plane."""
    HOLE = 10
    """A needle or a thread in a hole of a drain. The feature of the suture is the index of the
    hole; the feature of the drain is 0. The normal is along the suture. VBLAST: a place where
    particles were moved."""


class SceneBlockerCause(IntEnum):
    """The constants of vbss_scene_blocker_cause."""
    WORK = 0
    """The work limit of the step was exhausted."""
    COLLISION = 1
    """The bodies would pass through each other, or come too near."""
    PENETRATION = 2
    """The bodies penetrate each other by more than the tolerance."""
    CONTACT = 3
    """No contact forces were found that obey the contact law."""
    CONVERGENCE = 4
    """The motion of the body did not converge."""


class vbss_scene(ctypes.Structure):
    """Bodies that touch each other and are stepped together."""


class vbss_scene_config(ctypes.Structure):
    """Configuration of a scene. Fill it with vbss_scene_config_init, then change fields.

    method: Method; default VBSS_METHOD_IMPLICIT. Bodies of the scene must have the same method.

    mode: Mode; default VBSS_SCENE_MODE_REAL_TIME.

    thread_capacity: Largest number of threads at a time, 0 to 64; default 4.

    node_capacity: Largest number of nodes of all threads, 0 to 8192; default 1024.

    rigid_capacity: Largest number of rigid bodies and graspers, 0 to 256; default 4.

    capsule_capacity: Largest number of capsules of these bodies, 0 to 4096; default 16.

    pin_capacity: Largest number of pins at a time, 0 to 256; default 8.

    contact_capacity: Largest number of contacts that may close at a time, 0 to 65536; default
    1024.

    candidate_capacity: Largest number of candidate pairs, 0 to 1e7; default 16384.

    event_capacity: Largest number of events that are kept until the host takes them
    (scene_event.h), and of those of a step, 0 to 65536; default 256.

    floor: 1: a floor fills the half-space below a plane; default 0.

    floor_normal: Direction up, of any length from 1e-100 to 1e100; default (0, 1, 0).

    floor_height: Height of the plane along its normal, m, at most 1e3 in magnitude; default 0.

    floor_friction: Coefficient of friction of the floor, 0 to 10; default 0.3.

    thread_friction: Coefficient of friction between threads, 0 to 10; default 0.3 (silk on
    silk; the literature has 0.1 to 0.4).

    contact_stiffness: Normal and tangential stiffness of a contact, N/m, 1e3 to 1e9; default
    2e5: 5 um at 1 N.

    grasp_capacity: Largest number of grasped places of threads at a time, 0 to 256; default 8.
    Places that jaws have released but not cleared count too, and so do the two ends at each cut
    of blades. Without capacity the jaws stay open.

    drain_capacity: Largest number of drains at a time, 0 to 16; default 1.

    hole_capacity: Largest number of holes of needles and threads in walls at a time, 0 to 256;
    default 16.

    overlap: Treatment of overlapping new bodies; default VBSS_SCENE_OVERLAP_WARN.

    speed_limit: Largest speed of any point of a driven or coupled body, or of a grasper, on the
    way to its target, m/s, 0 to 1e6; 0: no limit; default 20. A body approaches a target that
    is farther away at this speed, over several steps. A pose in the wrong unit, or a jump of a
    device, then causes no long step and no extreme force. Method IMPLICIT only. Logs and
    snapshots store the limit, and a scene with another one rejects them. One exception: scenes
    without a limit and with the default limit accept each other's snapshots.

    matrix_capacity: Method IMPLICIT: capacity of the linear system's matrix and its factor for
    threads and rigid bodies, in blocks of 3 x 3 numbers of 96 bytes, 0 to 1e7; 0 (default):
    4096, and 20 for each node of node_capacity and 40 for each body of rigid_capacity. A node
    without contact takes up to 12 blocks, one of a tight knot 42; each drain adds its own. A
    step that needs more returns VBSS_ERROR_CAPACITY. See docs/reference/memory.md.

    baseline: VBLAST: its parameters; NULL (default): their defaults. The library copies them.

    solver: Options of the solver, with the budgets of steps and calls; NULL (default): their
    defaults. The scene copies them."""
    struct_size: int
    method: int
    mode: int
    thread_capacity: int
    node_capacity: int
    rigid_capacity: int
    capsule_capacity: int
    pin_capacity: int
    contact_capacity: int
    candidate_capacity: int
    event_capacity: int
    floor: int
    floor_normal: Any
    floor_height: float
    floor_friction: float
    thread_friction: float
    contact_stiffness: float
    grasp_capacity: int
    drain_capacity: int
    hole_capacity: int
    overlap: int
    speed_limit: float
    matrix_capacity: int
    reserved: int
    baseline: Any
    solver: Any
    _kinds_: ClassVar[dict[str, Any]] = {"method": Method, "mode": SceneMode, "overlap": SceneOverlapPolicy}
    _fields_ = [
        ("struct_size", c_uint32),
        ("method", c_int32),
        ("mode", c_int32),
        ("thread_capacity", c_uint32),
        ("node_capacity", c_uint32),
        ("rigid_capacity", c_uint32),
        ("capsule_capacity", c_uint32),
        ("pin_capacity", c_uint32),
        ("contact_capacity", c_uint32),
        ("candidate_capacity", c_uint32),
        ("event_capacity", c_uint32),
        ("floor", c_int32),
        ("floor_normal", c_double * 3),
        ("floor_height", c_double),
        ("floor_friction", c_double),
        ("thread_friction", c_double),
        ("contact_stiffness", c_double),
        ("grasp_capacity", c_uint32),
        ("drain_capacity", c_uint32),
        ("hole_capacity", c_uint32),
        ("overlap", c_int32),
        ("speed_limit", c_double),
        ("matrix_capacity", c_uint32),
        ("reserved", c_uint32),
        ("baseline", POINTER(vbss_baseline_config)),
        ("solver", POINTER(vbss_solver_options)),
    ]


class vbss_scene_overlap(ctypes.Structure):
    """The deepest overlap of a body.

    body: Number of the other body; 0: the floor, or none if depth is 0.

    depth: Depth of the overlap of the two surfaces, m; 0: no overlap."""
    struct_size: int
    body: int
    depth: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("body", c_uint32),
        ("depth", c_double),
    ]


class SceneOverlap(NamedTuple):
    """The deepest overlap of a body. Fields as vbss_scene_overlap says."""
    body: int
    depth: float


class vbss_scene_capsule(ctypes.Structure):
    """One capsule of a rigid body, in the frame of the body.

    begin: One end of the axis, m.

    end: The other end of the axis, m; equal ends make a ball.

    radius: Radius, m, 1e-6 to 1."""
    begin: Any
    end: Any
    radius: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("begin", c_double * 3),
        ("end", c_double * 3),
        ("radius", c_double),
    ]


class vbss_scene_rigid_config(ctypes.Structure):
    """Configuration of a rigid body. Fill it with vbss_scene_rigid_config_init, then change
    fields.

    kind: Kind of motion; default VBSS_SCENE_RIGID_DRIVEN.

    capsule_count: Number of capsules, 1 to 256.

    capsules: Array of capsule_count capsules; the library copies it.

    position: Position of the origin of the frame, m, each coordinate at most 1e3 in magnitude;
    default 0.

    orientation: Orientation w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0.

    velocity: COUPLED, FREE: velocity of the origin, m/s, each component at most 1e5 in
    magnitude; default 0.

    angular_velocity: COUPLED, FREE: angular velocity, rad/s, each component at most 1e6 in
    magnitude; default 0. A body turns by at most a quarter of a turn in a part of a step; a
    faster one slows down.

    mass: Mass of the body, kg, 1e-9 to 1e3; default 0.02. It is distributed over the capsules
    as over solids of one material; overlaps count twice.

    gravity: Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default
    0, because hands carry their tools.

    friction: Coefficient of friction, 0 to 10; default 0.15. A contact with a thread uses this
    coefficient, any other the geometric mean of both bodies.

    stiffness: COUPLED: stiffness, N/m, 0 to 1e9; default 2000.

    damping: COUPLED: damping, N s/m, 0 to 1e6; default 5.

    turning_stiffness: COUPLED: rotational stiffness, N m/rad, 0 to 1e9; default 2.

    turning_damping: COUPLED: rotational damping, N m s/rad, 0 to 1e6; default 0.005."""
    struct_size: int
    kind: int
    capsule_count: int
    reserved: int
    capsules: Any
    position: Any
    orientation: Any
    velocity: Any
    angular_velocity: Any
    mass: float
    gravity: Any
    friction: float
    stiffness: float
    damping: float
    turning_stiffness: float
    turning_damping: float
    _kinds_: ClassVar[dict[str, Any]] = {"kind": SceneRigidKind}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("capsule_count", c_uint32),
        ("reserved", c_uint32),
        ("capsules", POINTER(vbss_scene_capsule)),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("velocity", c_double * 3),
        ("angular_velocity", c_double * 3),
        ("mass", c_double),
        ("gravity", c_double * 3),
        ("friction", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("turning_stiffness", c_double),
        ("turning_damping", c_double),
    ]


class vbss_scene_rigid_state(ctypes.Structure):
    """State of a rigid body.

    kind: Kind of motion.

    position: Position of the origin of its frame, m.

    orientation: Orientation from body to world, w, x, y, z.

    velocity: Velocity of the origin, m/s.

    angular_velocity: Angular velocity in the world frame, rad/s.

    target_position: Target position of the origin, m.

    target_orientation: Target orientation, w, x, y, z.

    hand_force: Force on the hand, N: the opposite of the coupling's force; for a driven body
    the sum of its contacts and pins. Zero for a free body.

    hand_torque: Torque on the hand about the origin of the body's frame, N m.

    contact_force: Sum of the forces of all contacts and pins on the body in the last step, N.

    contact_torque: Their torque about the origin of the body's frame, N m."""
    struct_size: int
    kind: int
    position: Any
    orientation: Any
    velocity: Any
    angular_velocity: Any
    target_position: Any
    target_orientation: Any
    hand_force: Any
    hand_torque: Any
    contact_force: Any
    contact_torque: Any
    _kinds_: ClassVar[dict[str, Any]] = {"kind": SceneRigidKind}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("velocity", c_double * 3),
        ("angular_velocity", c_double * 3),
        ("target_position", c_double * 3),
        ("target_orientation", c_double * 4),
        ("hand_force", c_double * 3),
        ("hand_torque", c_double * 3),
        ("contact_force", c_double * 3),
        ("contact_torque", c_double * 3),
    ]


class SceneRigidState(NamedTuple):
    """State of a rigid body. Fields as vbss_scene_rigid_state says."""
    kind: SceneRigidKind
    position: tuple[float, ...]
    orientation: tuple[float, ...]
    velocity: tuple[float, ...]
    angular_velocity: tuple[float, ...]
    target_position: tuple[float, ...]
    target_orientation: tuple[float, ...]
    hand_force: tuple[float, ...]
    hand_torque: tuple[float, ...]
    contact_force: tuple[float, ...]
    contact_torque: tuple[float, ...]


class vbss_scene_statistics(ctypes.Structure):
    """Counters since creation, and results of the last step. Method VBLAST leaves `rows`,
    `separators` and the counters of attempts, solves, the guard and operations at 0;
    vbss_scene_get_baseline_statistics returns what it counts.

    contacts: Contacts that carry a force after the last step.

    rows: Contacts that could have closed in the last part.

    separators: Blocks of the last part's system that contacts couple.

    steps: Calls of vbss_scene_step that succeeded.

    parts: Accepted parts of steps; equal to `steps` if no step was divided.

    attempts: Attempts, rejected ones included.

    linearisations: Linearisations of all attempts.

    state_solves: Solves of the separators' system.

    patterns: Times the sparsity pattern of that system was computed; not part of the state.

    rejected_states: Attempts rejected because contact states were not found.

    rejected_stretch: Attempts rejected because lengths or shapes did not converge, or a node of
    a drain moved too far.

    rejected_depth: Attempts rejected because of penetration.

    rejected_guard: Attempts rejected by the guard: bodies would pass through each other, or
    come too near.

    rejected_singular: Attempts rejected because a pivot was too small or a number was not
    finite.

    rejected_full: Attempts rejected because candidates or contacts exceeded their capacity.

    loose_states: Attempts accepted with a residual of up to 5 % in the contact law.

    loose_stretch: Parts accepted with a stretch error above the tolerance.

    clamped: Parts truncated by the guard.

    recovering: Parts accepted that reduced a penetration above the tolerance.

    guard_pairs: Pairs that the guard has tested or knows to be apart.

    last_penetration: Largest penetration after the last step, m.

    penetration: Largest penetration of all steps, m.

    last_stretch_error: IMPLICIT: max |length / rest length - 1 - T / EA| after the last step;
    VBLAST: max |length / rest length - 1|.

    stretch_error: Largest stretch error of all steps.

    last_residual: Residual of the contact law after the last part, N.

    time: Sum of the lengths of the steps, `time_paused` included, s.

    operations: Operations of all steps, as the step budget counts them; method IMPLICIT.

    most_operations: Largest number of operations of a step.

    paused: REAL_TIME: steps of which a part, or all, was left out.

    time_paused: Simulated time that these steps have lost, s.

    deferred: Calls after which a step was suspended or had not begun; see
    vbss_solver_options::call_budget_us.

    behind: Number of suspended and unbegun steps after the last call, 0 to 2.

    overdue: Steps that two calls had suspended while other bodies waited, so that the third
    completed them without the budget of a call.

    torn_length: Length that threads have torn at holes, m (vbss_drain_config::tear_energy).

    tear_work: Energy that this has dissipated, J."""
    struct_size: int
    contacts: int
    rows: int
    separators: int
    steps: int
    parts: int
    attempts: int
    linearisations: int
    state_solves: int
    patterns: int
    rejected_states: int
    rejected_stretch: int
    rejected_depth: int
    rejected_guard: int
    rejected_singular: int
    rejected_full: int
    loose_states: int
    loose_stretch: int
    clamped: int
    recovering: int
    guard_pairs: int
    last_penetration: float
    penetration: float
    last_stretch_error: float
    stretch_error: float
    last_residual: float
    time: float
    operations: int
    most_operations: int
    paused: int
    time_paused: float
    deferred: int
    behind: int
    overdue: int
    torn_length: float
    tear_work: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("contacts", c_uint32),
        ("rows", c_uint32),
        ("separators", c_uint32),
        ("steps", c_uint64),
        ("parts", c_uint64),
        ("attempts", c_uint64),
        ("linearisations", c_uint64),
        ("state_solves", c_uint64),
        ("patterns", c_uint64),
        ("rejected_states", c_uint64),
        ("rejected_stretch", c_uint64),
        ("rejected_depth", c_uint64),
        ("rejected_guard", c_uint64),
        ("rejected_singular", c_uint64),
        ("rejected_full", c_uint64),
        ("loose_states", c_uint64),
        ("loose_stretch", c_uint64),
        ("clamped", c_uint64),
        ("recovering", c_uint64),
        ("guard_pairs", c_uint64),
        ("last_penetration", c_double),
        ("penetration", c_double),
        ("last_stretch_error", c_double),
        ("stretch_error", c_double),
        ("last_residual", c_double),
        ("time", c_double),
        ("operations", c_uint64),
        ("most_operations", c_uint64),
        ("paused", c_uint64),
        ("time_paused", c_double),
        ("deferred", c_uint64),
        ("behind", c_uint32),
        ("overdue", c_uint32),
        ("torn_length", c_double),
        ("tear_work", c_double),
    ]


class SceneStatistics(NamedTuple):
    """Counters since creation, and results of the last step. Method VBLAST leaves `rows`,
    `separators` and the counters of attempts, solves, the guard and operations at 0;
    vbss_scene_get_baseline_statistics returns what it counts. Fields as vbss_scene_statistics
    says."""
    contacts: int
    rows: int
    separators: int
    steps: int
    parts: int
    attempts: int
    linearisations: int
    state_solves: int
    patterns: int
    rejected_states: int
    rejected_stretch: int
    rejected_depth: int
    rejected_guard: int
    rejected_singular: int
    rejected_full: int
    loose_states: int
    loose_stretch: int
    clamped: int
    recovering: int
    guard_pairs: int
    last_penetration: float
    penetration: float
    last_stretch_error: float
    stretch_error: float
    last_residual: float
    time: float
    operations: int
    most_operations: int
    paused: int
    time_paused: float
    deferred: int
    behind: int
    overdue: int
    torn_length: float
    tear_work: float


class vbss_scene_blocker(ctypes.Structure):
    """Two bodies that hold each other back, and all bodies that touch them. A failed step holds
    back only the bodies that contacts, grasps, holes or pins connect with these two. All other
    bodies move on.

    cause: Cause in the last step that held them back.

    body_a: Number of one body; 0: unknown.

    body_b: Number of the other body; 0: the floor, or no second body.

    since: Simulated time at which they were first held back, s.

    lost_time: Simulated time that they have lost since then, s.

    depth: Their deepest overlap in the last step that held them back, m; 0: none."""
    struct_size: int
    cause: int
    body_a: int
    body_b: int
    since: float
    lost_time: float
    depth: float
    _kinds_: ClassVar[dict[str, Any]] = {"cause": SceneBlockerCause}
    _fields_ = [
        ("struct_size", c_uint32),
        ("cause", c_int32),
        ("body_a", c_uint32),
        ("body_b", c_uint32),
        ("since", c_double),
        ("lost_time", c_double),
        ("depth", c_double),
    ]


class SceneBlocker(NamedTuple):
    """Two bodies that hold each other back, and all bodies that touch them. A failed step holds
    back only the bodies that contacts, grasps, holes or pins connect with these two. All other
    bodies move on. Fields as vbss_scene_blocker says."""
    cause: SceneBlockerCause
    body_a: int
    body_b: int
    since: float
    lost_time: float
    depth: float


class vbss_scene_hole(ctypes.Structure):
    """A hole of a needle or a thread in a drain or host surface.

    id: Identifier from 1 on, in the order of creation; never reused.

    needle: Number of the needle in the hole; 0: a thread is in it.

    drain: Number of the drain or host surface.

    triangle: Triangle of it.

    outward: 1: the tip went through from inside; 0: from outside.

    weights: Weights of the triangle's nodes at the hole.

    rest_position: Position of the hole on the drain at rest, m: VBSS_DRAIN_VIEW_REST_POSITIONS.
    In a host surface the same as `position`.

    position: Current position of the hole, in the middle of the wall, m.

    direction: Unit direction of the suture at the hole, towards the needle's tip, or the
    thread's beginning.

    arc_length: Arc length of the suture at the hole, m. For a needle it is measured from the
    tip, and is negative before the tip has reached the middle of the wall. For a thread it is
    measured from the beginning. Near the swage it may be up to 0.2 mm beyond an end.

    friction: Friction on the suture along `direction`, N.

    force: Force on the suture, N.

    thread: Number of the thread in the hole; 0: a needle is in it.

    torn_length: Length of the cut by which the thread has torn this hole, m: along the wall as
    it was then, in the plane of its triangles (vbss_drain_config::tear_energy).

    tear_work: Energy that this has dissipated, J."""
    struct_size: int
    id: int
    needle: int
    drain: int
    triangle: int
    outward: int
    weights: Any
    rest_position: Any
    position: Any
    direction: Any
    arc_length: float
    friction: float
    force: Any
    thread: int
    reserved: int
    torn_length: float
    tear_work: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("id", c_uint32),
        ("needle", c_uint32),
        ("drain", c_uint32),
        ("triangle", c_uint32),
        ("outward", c_uint32),
        ("weights", c_double * 3),
        ("rest_position", c_double * 3),
        ("position", c_double * 3),
        ("direction", c_double * 3),
        ("arc_length", c_double),
        ("friction", c_double),
        ("force", c_double * 3),
        ("thread", c_uint32),
        ("reserved", c_uint32),
        ("torn_length", c_double),
        ("tear_work", c_double),
    ]


class SceneHole(NamedTuple):
    """A hole of a needle or a thread in a drain or host surface. Fields as vbss_scene_hole says."""
    id: int
    needle: int
    drain: int
    triangle: int
    outward: int
    weights: tuple[float, ...]
    rest_position: tuple[float, ...]
    position: tuple[float, ...]
    direction: tuple[float, ...]
    arc_length: float
    friction: float
    force: tuple[float, ...]
    thread: int
    torn_length: float
    tear_work: float


class vbss_scene_grasp(ctypes.Structure):
    """A grasped place of a thread, a needle or a drain.

    body: Number of the grasped body in the scene.

    arc_length: Arc length of the middle of the held part, m: unstretched along a thread, or
    from a needle's tip.

    position: Position of that middle, m.

    force: Force of the jaws on the held body in the last step, N. While the body slides, it
    exceeds the limit by the clamp's gain in a step.

    limit: Largest force along the jaws' faces that they bear, N; VBLAST: 0.

    slid: Distance that the body has slid through the jaws since it was grasped, m."""
    struct_size: int
    body: int
    arc_length: float
    position: Any
    force: Any
    limit: float
    slid: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("body", c_uint32),
        ("arc_length", c_double),
        ("position", c_double * 3),
        ("force", c_double * 3),
        ("limit", c_double),
        ("slid", c_double),
    ]


class SceneGrasp(NamedTuple):
    """A grasped place of a thread, a needle or a drain. Fields as vbss_scene_grasp says."""
    body: int
    arc_length: float
    position: tuple[float, ...]
    force: tuple[float, ...]
    limit: float
    slid: float


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_scene_config_init": (c_int32, (POINTER(vbss_scene_config), c_uint32)),
    "vbss_scene_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_scene_config),
        POINTER(POINTER(vbss_scene)))),
    "vbss_scene_destroy": (c_int32, (POINTER(vbss_scene),)),
    "vbss_scene_add_thread": (c_int32, (POINTER(vbss_scene), POINTER(vbss_thread),
        POINTER(c_uint32))),
    "vbss_scene_add_drain": (c_int32, (POINTER(vbss_scene), POINTER(vbss_drain),
        POINTER(c_uint32))),
    "vbss_scene_rigid_config_init": (c_int32, (POINTER(vbss_scene_rigid_config), c_uint32)),
    "vbss_scene_add_rigid": (c_int32, (POINTER(vbss_scene), POINTER(vbss_scene_rigid_config),
        POINTER(c_uint32))),
    "vbss_scene_add_needle": (c_int32, (POINTER(vbss_scene), POINTER(vbss_needle),
        POINTER(c_uint32))),
    "vbss_scene_add_grasper": (c_int32, (POINTER(vbss_scene), POINTER(vbss_grasper),
        POINTER(c_uint32))),
    "vbss_scene_get_grasp": (c_int32, (POINTER(vbss_scene), c_uint32, c_uint32,
        POINTER(vbss_scene_grasp), c_uint32)),
    "vbss_scene_get_hole": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(vbss_scene_hole),
        c_uint32)),
    "vbss_scene_get_blocker": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(vbss_scene_blocker),
        c_uint32)),
    "vbss_scene_make_hole": (c_int32, (POINTER(vbss_scene), c_uint32, c_double, c_uint32, c_uint32,
        POINTER(c_double), POINTER(c_uint32))),
    "vbss_scene_remove": (c_int32, (POINTER(vbss_scene), c_uint32)),
    "vbss_scene_set_rigid_target": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(c_double),
        POINTER(c_double))),
    "vbss_scene_pin_thread": (c_int32, (POINTER(vbss_scene), c_uint32, c_uint32, c_uint32,
        POINTER(c_double), POINTER(c_uint32))),
    "vbss_scene_unpin_thread": (c_int32, (POINTER(vbss_scene), c_uint32)),
    "vbss_scene_cut_thread": (c_int32, (POINTER(vbss_scene), c_uint32, c_double,
        POINTER(c_uint32))),
    "vbss_scene_get_thread": (c_int32, (POINTER(vbss_scene), c_uint32,
        POINTER(POINTER(vbss_thread)))),
    "vbss_scene_config_get_memory": (c_int32, (POINTER(vbss_context), POINTER(vbss_scene_config),
        POINTER(c_uint64))),
    "vbss_scene_prepare": (c_int32, (POINTER(vbss_scene),)),
    "vbss_scene_step": (c_int32, (POINTER(vbss_scene), c_double)),
    "vbss_scene_get_rigid": (c_int32, (POINTER(vbss_scene), c_uint32,
        POINTER(vbss_scene_rigid_state), c_uint32)),
    "vbss_scene_get_view": (c_int32, (POINTER(vbss_scene), c_int32, POINTER(vbss_view), c_uint32)),
    "vbss_scene_get_statistics": (c_int32, (POINTER(vbss_scene), POINTER(vbss_scene_statistics),
        c_uint32)),
    "vbss_scene_get_baseline_statistics": (c_int32, (POINTER(vbss_scene),
        POINTER(vbss_baseline_statistics), c_uint32)),
    "vbss_scene_get_overlap": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(vbss_scene_overlap),
        c_uint32)),
    "vbss_scene_save": (c_int32, (POINTER(vbss_scene), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_scene_restore": (c_int32, (POINTER(vbss_scene), POINTER(c_uint8), c_uint64)),
    "vbss_scene_load": (c_int32, (POINTER(vbss_context), POINTER(c_uint8), c_uint64,
        POINTER(POINTER(vbss_scene)))),
    "vbss_scene_get_hash": (c_int32, (POINTER(vbss_scene), POINTER(c_uint64))),
}
