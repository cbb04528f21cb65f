"""scene.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64, c_uint8
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import Method, vbss_context, vbss_view
from .drain import vbss_drain
from .grasper import vbss_grasper
from .needle import vbss_needle
from .thread import vbss_thread


class SceneMode(IntEnum):
    """The constants of vbss_scene_mode."""
    REAL_TIME = 0
    """A step has a limit of work and of attempts, so that it ends in time, and a call has one: see
    `work_limit` and `slot_limit`. What is not done by then waits, and what would wait too long
    is counted in `paused`. Tight knots of many throws slip a little early for it."""
    OFFLINE = 1
    """All the work it takes; halves as often as halving_limit allows, and is cut short only after
    that, which is counted in `clamped`. For experiments."""


class OverlapPolicy(IntEnum):
    """The constants of vbss_overlap_policy."""
    WARN = 0
    """The body is added; a warning in the log names the other body and the depth."""
    REFUSE = 1
    """VBSS_ERROR_OUT_OF_RANGE; nothing has changed."""
    ALLOW = 2
    """The body is added without a check."""


class RigidKind(IntEnum):
    """The constants of vbss_rigid_kind."""
    DRIVEN = 0
    """Exactly as told; stopped only by the guard."""
    COUPLED = 1
    """A proxy, tied to the pose it is told by a virtual coupling."""
    FREE = 2
    """As forces say."""


class SceneField(IntEnum):
    """The constants of vbss_scene_field. Contacts are those that carried a force at the end of the
    last step, in the order of their features; of method PAPER, those that were responded to."""
    CONTACTS = 0
    """x 5 uint32_t: vbss_contact_kind, body a, feature a, body b, feature b. A feature is a
    segment or a node of a thread, a capsule of a rigid body (times two plus its end, where an
    end is meant), a node, a triangle or a side of a drain, 0 of the floor. Sides of a drain's
    triangles are numbered each once, in the order of their two nodes, the lower node first."""
    CONTACT_POINTS = 1
    """x 3: between the two surfaces, m."""
    CONTACT_NORMALS = 2
    """x 3: unit, from b to a."""
    CONTACT_FORCES = 3
    """x 3: of b on a, N. Where a search for contact states ran out of work, those with which all
    bodies balance: they miss the law by the residual, and may pull."""
    CONTACT_GAPS = 4
    """Distance of the surfaces, negative when they overlap, m."""
    EVENTS = 5
    """x 4 uint32_t: vbss_event_kind, two bodies, a number."""


class ContactKind(IntEnum):
    """The constants of vbss_contact_kind."""
    SEGMENTS = 0
    """Two segments of threads."""
    NODE_CAPSULE = 1
    """A smoothed point of a fine thread, and a capsule."""
    SEGMENT_CAPSULE = 2
    """A segment of a coarse thread, and a capsule."""
    NODE_FLOOR = 3
    """A node of a thread, and the floor."""
    CAPSULES = 4
    """Two capsules of different bodies."""
    CAPSULE_FLOOR = 5
    """An end of a capsule, and the floor."""
    GRASP = 6
    """One of the three points of a thread that a grasper holds, three times the place of the grasp
    among all plus which of them; or of a needle or a drain, which of them; and 0 of the
    grasper."""
    POINT_FACE = 7
    """A node of a thread, an end of a capsule or a node of a drain, and a triangle of a drain."""
    SIDES = 8
    """A segment of a thread, a capsule or a side of a drain's triangle, and a side of a drain's
    triangle."""
    DRAIN_FLOOR = 9
    """A node of a drain, and the floor."""
    HOLE = 10
    """A needle or a thread, the place of the hole among all; and 0 of the drain. The normal is
    along the suture. PAPER: where particles were moved."""


class EventKind(IntEnum):
    """The constants of vbss_event_kind."""
    TOUCH = 1
    """Two bodies that did not touch do; a body with itself too."""
    PART = 2
    """Two bodies that touched do no longer."""
    CLAMPED = 3
    """A step was cut short, or paused; the number is the share of it in 1/65536 that was lost."""
    LOST = 4
    """Events beyond the capacity; the number says how many."""
    GRASP = 5
    """Jaws hold a thread, a needle or a wall: that, grasper, arc length in um; of a wall a
    triangle that they hold."""
    RELEASE = 6
    """They have opened and let it go: the same."""
    TORN = 7
    """It was pulled out of them: the same."""
    SLIP = 8
    """It begins to slide through them, or to turn in them: the same."""
    GRASP_LOST = 9
    """Beyond grasp_capacity: thread, grasper; it is not held."""
    CUT = 10
    """A thread, its new piece, and the arc length of the cut in um; 0 in place of the piece: it
    would have been cut, but all its cuts are made."""
    EXCHANGED = 11
    """A grasper, 0, and what it is now."""
    NOT_EXCHANGED = 12
    """A grasper, 0, and what it was to be."""
    PUNCTURE = 13
    """A needle's tip enters a wall, PAPER: has gone through: needle, drain, id of the hole
    (vbss_scene_get_hole)."""
    WITHDRAWN = 14
    """The tip has left the hole the way it came: the same."""
    PASSED = 15
    """The needle has gone through it, swage and all; the thread follows: the same."""
    HOLE_LOST = 16
    """Beyond hole_capacity the wall holds: needle, drain, 0."""
    RETURNED = 17
    """The swage has come back through it: the needle is in it again: the same."""
    UNTHREADED = 18
    """An end of a thread has left the hole: thread, drain, id of the hole."""
    BLOCKED = 19
    """Bodies are held back, for the first time since a while: the two bodies of vbss_blocker, its
    cause."""
    UNBLOCKED = 20
    """They have moved freely for 0.1 s: the same numbers."""


class BlockerCause(IntEnum):
    """The constants of vbss_blocker_cause."""
    WORK = 0
    """The limit of work of the step was exhausted."""
    COLLISION = 1
    """The bodies would pass through each other, or come too near."""
    PENETRATION = 2
    """The bodies penetrate each other by more than the tolerance."""
    CONTACT = 3
    """No contact forces were found that obey the contact law."""
    CONVERGENCE = 4
    """The motion of the body did not converge."""


class vbss_scene(ctypes.Structure):
    """A scene."""


class vbss_scene_config(ctypes.Structure):
    """How to make a scene. Fill it with vbss_scene_config_init, then change what you need.

    method: Default VBSS_METHOD_OURS; threads must have the same.

    mode: Default VBSS_MODE_REAL_TIME.

    thread_capacity: Most threads at a time, 0 to 64; default 4.

    node_capacity: Most nodes of all threads, 0 to 8192; default 1024.

    rigid_capacity: Most rigid bodies, graspers too, 0 to 256; default 4.

    capsule_capacity: Most capsules of all of them, 0 to 4096; default 16.

    pin_capacity: Most pins at a time, 0 to 256; default 8.

    contact_capacity: Most contacts that may close at a time, 0 to 65536; default 1024.

    candidate_capacity: Most pairs looked at, 0 to 1e7; default 16384.

    event_capacity: Most events of a step that are kept, 0 to 65536; default 256.

    floor: 1: there is a floor, all that is above a plane; default 0.

    floor_normal: Up, of any length from 1e-100 to 1e100; default (0, 1, 0).

    floor_height: Of the plane along its normal, m, each at most 1e3; default 0.

    floor_friction: Coefficient, 0 to 10; default 0.3.

    thread_friction: Coefficient of friction of threads with each other, 0 to 10; default 0.3
    (silk on silk; the literature has 0.1 to 0.4).

    contact_stiffness: Normal and tangential stiffness of a contact, N/m, 1e3 to 1e9; default
    2e5: 5 um at 1 N.

    contact_margin: Contacts are looked for within this distance beyond touching and what things
    may approach each other in the step, m, 0 to 0.1; default 3e-5. More costs time, less costs
    retries.

    stretch_tolerance: Largest stretch error that a step may leave, 1e-9 to 1e-1; default 1e-3.

    penetration_tolerance: Largest penetration that a step may leave, as a share of the diameter
    of the thinner one, 1e-3 to 0.5; default 0.1. A state that has more may only have less
    afterwards.

    linearisation_limit: Of an attempt, 1 to 100; default 12.

    state_limit: Solves for the states of the contacts in a linearisation, 1 to 1000; default
    36.

    halving_limit: How often a step may be halved, 0 to 10; default 5.

    attempt_limit: REAL_TIME: attempts in a step after which what is left of it waits, 1 to
    1000; default 3. Without a work_limit nothing waits: what is left is tried once a part, and
    cut short where it would harm.

    paper_pass_limit: PAPER: passes of detection and response in a step, 1 to 1000; default 4.

    grasp_capacity: Most places of threads in jaws at a time, 0 to 256; default 8. With them
    count those that jaws have let go but are not clear of yet, and those that blades have cut,
    two ends each: without room they stay open.

    paper_thickness: PAPER: distance kept beyond touching (the paper's eps_D), m, 0 to 1e-2;
    default 0.

    work_limit: REAL_TIME, method OURS: operations in a step after which nothing is searched for
    any longer. Forces of contacts are taken as they have been found by then: they balance, but
    miss the law of contact by up to vbss_scene_statistics::last_residual; lengths are found all
    the same, with a few solves beyond the limit. Where that fails, where such forces put in
    more than 20 uJ that nothing has done the work for (1 mJ in a scene without drains), or
    after attempt_limit attempts, the rest of the step is left out: everything waits for the
    next one, which begins with smaller parts (vbss_scene_statistics::paused), and what is
    driven goes on from where it was stopped. The first step of a scene has 32 times both limits
    between its attempts, because bodies may overlap as they were placed; it never waits.
    Without limit is the smallest part that halving_limit allows, until its states are not
    found: then it is tried once more with as much for itself. Where a drain is, the smallest
    part has the limit as well, and what takes more is halved three times more before it has
    none. An operation is what costs about as much as a product of two 3x3 blocks; 250000 are
    some 0.5 ms of a core of 2.6 GHz (docs/contact.md). 0: no limit; default 250000.

    drain_capacity: Most drains at a time, 0 to 16; default 1.

    hole_capacity: Most holes of needles and threads in drains at a time, 0 to 256; default 16.

    slot_limit: REAL_TIME with a work_limit, method OURS: operations in a call of
    vbss_scene_step. A step that takes more waits where it is, and the next call goes on with
    it, to the bits that it would have come to; with what that has left it begins the next step.
    So bodies are up to two steps behind after a call (vbss_scene_statistics::behind), some of
    them by a part of a step; what is farther behind is left out and counted in `paused`. Where
    graspers, driven bodies and attachments are told to go meanwhile is for the next step. A
    host that changes anything else while a step waits ends it, which is counted there, too, and
    the next 1000 do not wait. Beyond the limit a call does what follows at the end of a step,
    and what the guard has refused. 0: a call makes its step, all of it; default 210000.

    speed_limit: Largest speed of any point of a driven or coupled body, or of a grasper, on the
    way to its target, m/s, 0 to 1e6; 0: no limit; default 20. A body approaches a target that
    is farther away at this speed, over several steps. So a pose in the wrong unit, or a device
    that jumps, causes no long step and no extreme force. Method OURS only. Logs and snapshots
    store the limit, and a scene with another one rejects them. One exception: scenes without a
    limit and with the default limit accept each other's snapshots.

    overlap: Default VBSS_OVERLAP_WARN."""
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
    contact_margin: float
    stretch_tolerance: float
    penetration_tolerance: float
    linearisation_limit: int
    state_limit: int
    halving_limit: int
    attempt_limit: int
    paper_pass_limit: int
    grasp_capacity: int
    paper_thickness: float
    work_limit: int
    drain_capacity: int
    hole_capacity: int
    slot_limit: int
    speed_limit: float
    overlap: int
    reserved: int
    _kinds_: ClassVar[dict[str, Any]] = {"method": Method, "mode": SceneMode, "overlap": OverlapPolicy}
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
        ("contact_margin", c_double),
        ("stretch_tolerance", c_double),
        ("penetration_tolerance", c_double),
        ("linearisation_limit", c_uint32),
        ("state_limit", c_uint32),
        ("halving_limit", c_uint32),
        ("attempt_limit", c_uint32),
        ("paper_pass_limit", c_uint32),
        ("grasp_capacity", c_uint32),
        ("paper_thickness", c_double),
        ("work_limit", c_uint32),
        ("drain_capacity", c_uint32),
        ("hole_capacity", c_uint32),
        ("slot_limit", c_uint32),
        ("speed_limit", c_double),
        ("overlap", c_int32),
        ("reserved", c_uint32),
    ]


class vbss_overlap(ctypes.Structure):
    """The deepest overlap of a body.

    body: Number of the other body; 0: the floor, or none if depth is 0.

    depth: How far the two surfaces are inside each other, m; 0: no overlap."""
    struct_size: int
    body: int
    depth: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("body", c_uint32),
        ("depth", c_double),
    ]


class Overlap(NamedTuple):
    """The deepest overlap of a body. Fields as vbss_overlap says."""
    body: int
    depth: float


class vbss_capsule(ctypes.Structure):
    """One capsule of a rigid body, in the frame of the body.

    begin: An end of the axis, m.

    end: The other; may be the same: a ball.

    radius: m, 1e-6 to 1."""
    begin: Any
    end: Any
    radius: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("begin", c_double * 3),
        ("end", c_double * 3),
        ("radius", c_double),
    ]


class vbss_rigid_config(ctypes.Structure):
    """How to make a rigid body. Fill it with vbss_rigid_config_init, then change what you need.

    kind: Default VBSS_RIGID_DRIVEN.

    capsule_count: 1 to 256.

    capsules: capsule_count of them; copied.

    position: Of the origin of the frame, m, each at most 1e3; default 0.

    orientation: w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0.

    velocity: Of the origin, m/s, each at most 1e5; COUPLED, FREE; default 0.

    angular_velocity: rad/s, each at most 1e6; COUPLED, FREE; default 0. A body turns by a
    quarter of a turn in a part of a step at most: a faster one slows down.

    mass: Of the body, kg, 1e-9 to 1e3; default 0.02. It is spread over the capsules as if they
    were solid and of one material; overlaps count twice.

    gravity: m/s^2, each at most 1e6; default 0: hands carry their tools.

    friction: Coefficient with all others, 0 to 10; default 0.15. Of two bodies the geometric
    mean counts.

    stiffness: COUPLED: N/m, 0 to 1e9; default 2000.

    damping: COUPLED: N s/m, 0 to 1e6; default 5.

    turning_stiffness: COUPLED: N m/rad, 0 to 1e9; default 2.

    turning_damping: COUPLED: N m s/rad, 0 to 1e6; default 0.005."""
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
    _kinds_: ClassVar[dict[str, Any]] = {"kind": RigidKind}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("capsule_count", c_uint32),
        ("reserved", c_uint32),
        ("capsules", POINTER(vbss_capsule)),
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


class vbss_rigid_state(ctypes.Structure):
    """Where a rigid body is and what acts on it.

    kind: As it was made.

    position: Of the origin of its frame, m.

    orientation: w, x, y, z; body to world.

    velocity: Of the origin, m/s.

    angular_velocity: World frame, rad/s.

    target_position: Where it was told to be.

    target_orientation: The same.

    hand_force: What the hand feels, N: the opposite of the coupling's force; of a driven body
    the sum of its contacts and pins. Zero for a free body.

    hand_torque: The same about the origin of its frame, N m.

    contact_force: Of all contacts and pins on it in the last step, N.

    contact_torque: The same about the origin of its frame, N m."""
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
    _kinds_: ClassVar[dict[str, Any]] = {"kind": RigidKind}
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


class RigidState(NamedTuple):
    """Where a rigid body is and what acts on it. Fields as vbss_rigid_state says."""
    kind: RigidKind
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
    """Counters since creation, and figures of the last step. Method PAPER counts its passes of
    detection and response in `attempts`, pairs tested in `guard_pairs`, those listed last in
    `rows`, and steps whose last pass still moved something in `loose_states`; its stretch error
    is max |length / rest length - 1|.

    contacts: That carry a force after the last step.

    rows: That might have closed in its last part.

    separators: Blocks of the system in its last part that contacts take part in.

    steps: Calls of vbss_scene_step that succeeded.

    parts: Accepted parts of steps; equal to steps if none was divided.

    attempts: Tries, rejected ones included.

    linearisations: Of all attempts.

    state_solves: Solves of the separators' system.

    patterns: How often its pattern was worked out; not part of the state.

    rejected_states: Attempts rejected: states of the contacts not found.

    rejected_stretch: Stretch error or shape not converged; a node of a drain went too far.

    rejected_depth: Penetration.

    rejected_guard: Something would have passed, or come too near.

    rejected_singular: A pivot was too small, or numbers not finite.

    rejected_full: More candidates or contacts than there is room for.

    loose_states: Attempts accepted with up to 5 % of residual in the contact law.

    loose_stretch: Parts accepted with more stretch error than the tolerance.

    clamped: Parts cut short by the guard.

    recovering: Parts accepted that began with too much penetration and have less now.

    guard_pairs: Pairs that the guard has looked at: known to be apart, or tested.

    last_penetration: Largest after the last step, m.

    penetration: Largest so far, m.

    last_stretch_error: max |length / rest length - 1 - T / EA| after the last step.

    stretch_error: Largest so far.

    last_residual: Of the contact law after the last part, N.

    time: Sum of the lengths of the steps, s, with `time_paused`.

    operations: Of all steps, as work_limit counts them; method OURS.

    most_operations: Of a step.

    paused: REAL_TIME: steps of which a part, or all, was left out.

    time_paused: Of those parts together, s: simulated time that was lost.

    deferred: Calls after which a step waited, or had not begun; see slot_limit.

    behind: Such steps after the last call, 0 to 2."""
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
    reserved: int
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
        ("reserved", c_uint32),
    ]


class SceneStatistics(NamedTuple):
    """Counters since creation, and figures of the last step. Method PAPER counts its passes of
    detection and response in `attempts`, pairs tested in `guard_pairs`, those listed last in
    `rows`, and steps whose last pass still moved something in `loose_states`; its stretch error
    is max |length / rest length - 1|. Fields as vbss_scene_statistics says."""
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


class vbss_blocker(ctypes.Structure):
    """Two bodies that hold back each other, and all bodies that touch them. A step that fails is
    held back for the bodies that are connected with them by contacts, grasps, holes or pins.
    All other bodies move on.

    cause: Why, in the last step that held them back.

    body_a: Number of a body; 0: unknown.

    body_b: Number of the other; 0: the floor, or no second body.

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
    _kinds_: ClassVar[dict[str, Any]] = {"cause": BlockerCause}
    _fields_ = [
        ("struct_size", c_uint32),
        ("cause", c_int32),
        ("body_a", c_uint32),
        ("body_b", c_uint32),
        ("since", c_double),
        ("lost_time", c_double),
        ("depth", c_double),
    ]


class Blocker(NamedTuple):
    """Two bodies that hold back each other, and all bodies that touch them. A step that fails is
    held back for the bodies that are connected with them by contacts, grasps, holes or pins.
    All other bodies move on. Fields as vbss_blocker says."""
    cause: BlockerCause
    body_a: int
    body_b: int
    since: float
    lost_time: float
    depth: float


class vbss_hole(ctypes.Structure):
    """A hole of a needle or a thread in a drain.

    id: From 1 on, in the order in which they were made; none twice.

    needle: Its number in the scene; 0: a thread is in it.

    drain: The same.

    triangle: Of the drain.

    outward: 1: the tip went through from inside; 0: from outside.

    weights: Of the triangle's nodes in the hole.

    rest_position: Of that point of the drain at rest, m: VBSS_DRAIN_REST_POSITIONS.

    position: Where it is, in the middle of the wall, m.

    direction: Unit: of the suture there, toward the needle's tip, or the thread's begin.

    arc_length: Of what is in it, m: of the needle from the tip (below 0 that is still before
    the middle), of the thread from its begin. Round the swage it may be up to 0.2 mm beyond an
    end.

    friction: On the suture, along `direction`, N.

    force: On the suture, N.

    thread: Number of the thread that is in it; 0: a needle is."""
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
    ]


class Hole(NamedTuple):
    """A hole of a needle or a thread in a drain. Fields as vbss_hole says."""
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


class vbss_grasp(ctypes.Structure):
    """A place of a thread, of a needle, or of a drain, that a grasper holds.

    thread: Number of the thread, the needle or the drain in the scene.

    arc_length: Of the middle of what is held, along the thread, unstretched; from the needle's
    tip; m.

    position: Where that is, m.

    force: Of the jaws on what they hold in the last step, N: while it slides, above the limit
    by what the clamp gains in a step.

    limit: Largest force along their faces that they bear, N; PAPER: 0.

    slid: So far it has slid through them since it was taken, m."""
    struct_size: int
    thread: int
    arc_length: float
    position: Any
    force: Any
    limit: float
    slid: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("thread", c_uint32),
        ("arc_length", c_double),
        ("position", c_double * 3),
        ("force", c_double * 3),
        ("limit", c_double),
        ("slid", c_double),
    ]


class Grasp(NamedTuple):
    """A place of a thread, of a needle, or of a drain, that a grasper holds. Fields as vbss_grasp
    says."""
    thread: int
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
    "vbss_rigid_config_init": (c_int32, (POINTER(vbss_rigid_config), c_uint32)),
    "vbss_scene_add_rigid": (c_int32, (POINTER(vbss_scene), POINTER(vbss_rigid_config),
        POINTER(c_uint32))),
    "vbss_scene_add_needle": (c_int32, (POINTER(vbss_scene), POINTER(vbss_needle),
        POINTER(c_uint32))),
    "vbss_scene_add_grasper": (c_int32, (POINTER(vbss_scene), POINTER(vbss_grasper),
        POINTER(c_uint32))),
    "vbss_scene_get_grasp": (c_int32, (POINTER(vbss_scene), c_uint32, c_uint32, POINTER(vbss_grasp),
        c_uint32)),
    "vbss_scene_get_hole": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(vbss_hole), c_uint32)),
    "vbss_scene_get_blocker": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(vbss_blocker),
        c_uint32)),
    "vbss_scene_make_hole": (c_int32, (POINTER(vbss_scene), c_uint32, c_double, c_uint32, c_uint32,
        POINTER(c_double), POINTER(c_uint32))),
    "vbss_scene_remove": (c_int32, (POINTER(vbss_scene), c_uint32)),
    "vbss_scene_move_rigid": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(c_double),
        POINTER(c_double))),
    "vbss_scene_pin_thread": (c_int32, (POINTER(vbss_scene), c_uint32, c_uint32, c_uint32,
        POINTER(c_double), POINTER(c_uint32))),
    "vbss_scene_unpin_thread": (c_int32, (POINTER(vbss_scene), c_uint32)),
    "vbss_scene_cut_thread": (c_int32, (POINTER(vbss_scene), c_uint32, c_double,
        POINTER(c_uint32))),
    "vbss_scene_get_thread": (c_int32, (POINTER(vbss_scene), c_uint32,
        POINTER(POINTER(vbss_thread)))),
    "vbss_scene_step": (c_int32, (POINTER(vbss_scene), c_double)),
    "vbss_scene_get_rigid": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(vbss_rigid_state),
        c_uint32)),
    "vbss_scene_get_view": (c_int32, (POINTER(vbss_scene), c_int32, POINTER(vbss_view), c_uint32)),
    "vbss_scene_get_statistics": (c_int32, (POINTER(vbss_scene), POINTER(vbss_scene_statistics),
        c_uint32)),
    "vbss_scene_get_overlap": (c_int32, (POINTER(vbss_scene), c_uint32, POINTER(vbss_overlap),
        c_uint32)),
    "vbss_scene_save": (c_int32, (POINTER(vbss_scene), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_scene_restore": (c_int32, (POINTER(vbss_scene), POINTER(c_uint8), c_uint64)),
    "vbss_scene_get_hash": (c_int32, (POINTER(vbss_scene), POINTER(c_uint64))),
}
