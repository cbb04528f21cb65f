// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// Behaviour when a step finds no acceptable state at once: a VBSS_SCENE_MODE_ constant.
pub type vbss_scene_mode = i32;

/// Treatment of a new body that overlaps another one or the floor: a VBSS_SCENE_OVERLAP_ constant.
pub type vbss_scene_overlap_policy = i32;

/// Kind of motion of a rigid body: a VBSS_SCENE_RIGID_ constant.
pub type vbss_scene_rigid_kind = i32;

/// An array of a scene: a VBSS_SCENE_VIEW_ constant.
pub type vbss_scene_field = i32;

/// Features of a contact: a VBSS_SCENE_CONTACT_ constant.
pub type vbss_scene_contact_kind = i32;

/// Reason why bodies are held back: a VBSS_SCENE_BLOCKER_ constant.
pub type vbss_scene_blocker_cause = i32;

// The constants of vbss_scene_mode.
/// The work and the attempts of a step are limited, and the work of a call, so that it ends in
/// time: see `step_budget_us` and `call_budget_us` of vbss_solver_options. Work left over is
/// deferred to the next call. Time that would be deferred too long is left out and counted in
/// `paused`. As a result tight knots of many throws slip a little early.
pub const VBSS_SCENE_MODE_REAL_TIME: vbss_scene_mode = 0;
/// A step takes all the work that it needs. It is halved as often as `halving_limit` allows, and
/// only then truncated, which is counted in `clamped`. After eight truncated parts the rest of
/// the step is left out, for the bodies of these parts alone, and counted in `paused`. For
/// experiments.
pub const VBSS_SCENE_MODE_OFFLINE: vbss_scene_mode = 1;

// The constants of vbss_scene_overlap_policy.
/// The body is added; a warning in the log names the other body and the depth.
pub const VBSS_SCENE_OVERLAP_WARN: vbss_scene_overlap_policy = 0;
/// The call returns VBSS_ERROR_OUT_OF_RANGE, and nothing has changed.
pub const VBSS_SCENE_OVERLAP_REFUSE: vbss_scene_overlap_policy = 1;
/// The body is added without a check.
pub const VBSS_SCENE_OVERLAP_ALLOW: vbss_scene_overlap_policy = 2;

// The constants of vbss_scene_rigid_kind.
/// The body follows its target exactly; only the guard can stop it.
pub const VBSS_SCENE_RIGID_DRIVEN: vbss_scene_rigid_kind = 0;
/// The body is a proxy that a virtual coupling ties to its target.
pub const VBSS_SCENE_RIGID_COUPLED: vbss_scene_rigid_kind = 1;
/// The body moves under forces.
pub const VBSS_SCENE_RIGID_FREE: vbss_scene_rigid_kind = 2;

// The constants of vbss_scene_field. Contacts are those that carried a force at the end of the
// last step, in the order of their features. With method VBLAST they are those with a response.
/// x 5 uint32_t: vbss_scene_contact_kind, body a, feature a, body b, feature b. Features are
/// segments or nodes of a thread, capsules of a rigid body (2 times the capsule, plus the end
/// if an end touches), and nodes, triangles or sides of a drain; floor and planes have feature 0. Each
/// side of a drain's triangles is numbered once, in the order of its two nodes, the lower node
/// first.
pub const VBSS_SCENE_VIEW_CONTACTS: vbss_scene_field = 0;
/// x 3: point between the two surfaces, m.
pub const VBSS_SCENE_VIEW_CONTACT_POINTS: vbss_scene_field = 1;
/// x 3: unit normal from b to a.
pub const VBSS_SCENE_VIEW_CONTACT_NORMALS: vbss_scene_field = 2;
/// x 3: force of b on a, N. When a search for contact states has exhausted its work limit,
/// these are forces with which all bodies balance. They miss the contact law by the residual,
/// and may pull.
pub const VBSS_SCENE_VIEW_CONTACT_FORCES: vbss_scene_field = 3;
/// x 1: distance of the surfaces, m; negative when they overlap.
pub const VBSS_SCENE_VIEW_CONTACT_GAPS: vbss_scene_field = 4;

// The constants of vbss_scene_contact_kind.
/// Two segments of threads.
pub const VBSS_SCENE_CONTACT_SEGMENTS: vbss_scene_contact_kind = 0;
/// A smoothed point of a fine thread and a capsule.
pub const VBSS_SCENE_CONTACT_NODE_CAPSULE: vbss_scene_contact_kind = 1;
/// A segment of a coarse thread and a capsule.
pub const VBSS_SCENE_CONTACT_SEGMENT_CAPSULE: vbss_scene_contact_kind = 2;
/// A node of a thread and the floor, or a plane.
pub const VBSS_SCENE_CONTACT_NODE_FLOOR: vbss_scene_contact_kind = 3;
/// Two capsules of different bodies.
pub const VBSS_SCENE_CONTACT_CAPSULES: vbss_scene_contact_kind = 4;
/// An end of a capsule and the floor, or a plane.
pub const VBSS_SCENE_CONTACT_CAPSULE_FLOOR: vbss_scene_contact_kind = 5;
/// A held point and a grasper. The feature of a thread is 3 times the index of the grasp plus
/// the index of one of its three held points. The feature of a needle or a drain is the index
/// of the held point. The feature of the grasper is 0.
pub const VBSS_SCENE_CONTACT_GRASP: vbss_scene_contact_kind = 6;
/// A node of a thread, an end of a capsule or a node of a drain, with a triangle of a drain.
pub const VBSS_SCENE_CONTACT_POINT_FACE: vbss_scene_contact_kind = 7;
/// A segment of a thread, a capsule or a side of a drain's triangle, with a side of a drain's
/// triangle.
pub const VBSS_SCENE_CONTACT_SIDES: vbss_scene_contact_kind = 8;
/// A node of a drain and the floor, or a plane.
pub const VBSS_SCENE_CONTACT_DRAIN_FLOOR: vbss_scene_contact_kind = 9;
/// A needle or a thread in a hole of a drain. The feature of the suture is the index of the
/// hole; the feature of the drain is 0. The normal is along the suture. VBLAST: a place where
/// particles were moved.
pub const VBSS_SCENE_CONTACT_HOLE: vbss_scene_contact_kind = 10;

// The constants of vbss_scene_blocker_cause.
/// The work limit of the step was exhausted.
pub const VBSS_SCENE_BLOCKER_WORK: vbss_scene_blocker_cause = 0;
/// The bodies would pass through each other, or come too near.
pub const VBSS_SCENE_BLOCKER_COLLISION: vbss_scene_blocker_cause = 1;
/// The bodies penetrate each other by more than the tolerance.
pub const VBSS_SCENE_BLOCKER_PENETRATION: vbss_scene_blocker_cause = 2;
/// No contact forces were found that obey the contact law.
pub const VBSS_SCENE_BLOCKER_CONTACT: vbss_scene_blocker_cause = 3;
/// The motion of the body did not converge.
pub const VBSS_SCENE_BLOCKER_CONVERGENCE: vbss_scene_blocker_cause = 4;

/// Bodies that touch each other and are stepped together.
#[repr(C)]
pub struct vbss_scene {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of a scene. Fill it with vbss_scene_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Method; default VBSS_METHOD_IMPLICIT. Bodies of the scene must have the same method.
    pub method: vbss_method,
    /// Mode; default VBSS_SCENE_MODE_REAL_TIME.
    pub mode: vbss_scene_mode,
    /// Largest number of threads at a time, 0 to 64; default 4.
    pub thread_capacity: u32,
    /// Largest number of nodes of all threads, 0 to 8192; default 1024.
    pub node_capacity: u32,
    /// Largest number of rigid bodies and graspers, 0 to 256; default 4.
    pub rigid_capacity: u32,
    /// Largest number of capsules of these bodies, 0 to 4096; default 16.
    pub capsule_capacity: u32,
    /// Largest number of pins at a time, 0 to 256; default 8.
    pub pin_capacity: u32,
    /// Largest number of contacts that may close at a time, 0 to 65536; default 1024.
    pub contact_capacity: u32,
    /// Largest number of candidate pairs, 0 to 1e7; default 16384.
    pub candidate_capacity: u32,
    /// Largest number of events that are kept until the host takes them (scene_event.h), and of those of
    /// a step, 0 to 65536; default 256.
    pub event_capacity: u32,
    /// 1: a floor fills the half-space below a plane; default 0.
    pub floor: i32,
    /// Direction up, of any length from 1e-100 to 1e100; default (0, 1, 0).
    pub floor_normal: [f64; 3],
    /// Height of the plane along its normal, m, at most 1e3 in magnitude; default 0.
    pub floor_height: f64,
    /// Coefficient of friction of the floor, 0 to 10; default 0.3.
    pub floor_friction: f64,
    /// Coefficient of friction between threads, 0 to 10; default 0.3 (silk on silk; the literature
    /// has 0.1 to 0.4).
    pub thread_friction: f64,
    /// Normal and tangential stiffness of a contact, N/m, 1e3 to 1e9; default 2e5: 5 um at 1 N.
    pub contact_stiffness: f64,
    /// Largest number of grasped places of threads at a time, 0 to 256; default 8. Places that jaws
    /// have released but not cleared count too, and so do the two ends at each cut of blades.
    /// Without capacity the jaws stay open.
    pub grasp_capacity: u32,
    /// Largest number of drains at a time, 0 to 16; default 1.
    pub drain_capacity: u32,
    /// Largest number of holes of needles and threads in walls at a time, 0 to 256; default 16.
    pub hole_capacity: u32,
    /// Treatment of overlapping new bodies; default VBSS_SCENE_OVERLAP_WARN.
    pub overlap: vbss_scene_overlap_policy,
    /// Largest speed of any point of a driven or coupled body, or of a grasper, on the way to
    /// its target, m/s, 0 to 1e6; 0: no limit; default 20. A body approaches a target that is
    /// farther away at this speed, over several steps. A pose in the wrong unit, or a jump of a
    /// device, then causes no long step and no extreme force. Method IMPLICIT only. Logs and
    /// snapshots store the limit, and a scene with another one rejects them. One exception:
    /// scenes without a limit and with the default limit accept each other's snapshots.
    pub speed_limit: f64,
    /// Method IMPLICIT: capacity of the linear system's matrix and its factor for threads and rigid
    /// bodies, in blocks of 3 x 3 numbers of 96 bytes, 0 to 1e7; 0 (default): 4096, and 20 for each
    /// node of node_capacity and 40 for each body of rigid_capacity. A node without contact takes up
    /// to 12 blocks, one of a tight knot 42; each drain adds its own. A step that needs more returns
    /// VBSS_ERROR_CAPACITY. See docs/reference/memory.md.
    pub matrix_capacity: u32,
    /// Zero.
    pub reserved: u32,
    /// VBLAST: its parameters; NULL (default): their defaults. The library copies them.
    pub baseline: *const vbss_baseline_config,
    /// Options of the solver, with the budgets of steps and calls; NULL (default): their defaults. The
    /// scene copies them.
    pub solver: *const vbss_solver_options,
}

/// The deepest overlap of a body.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_overlap {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Number of the other body; 0: the floor, or none if depth is 0.
    pub body: u32,
    /// Depth of the overlap of the two surfaces, m; 0: no overlap.
    pub depth: f64,
}

/// One capsule of a rigid body, in the frame of the body.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_capsule {
    /// One end of the axis, m.
    pub begin: [f64; 3],
    /// The other end of the axis, m; equal ends make a ball.
    pub end: [f64; 3],
    /// Radius, m, 1e-6 to 1.
    pub radius: f64,
}

/// Configuration of a rigid body. Fill it with vbss_scene_rigid_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_rigid_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Kind of motion; default VBSS_SCENE_RIGID_DRIVEN.
    pub kind: vbss_scene_rigid_kind,
    /// Number of capsules, 1 to 256.
    pub capsule_count: u32,
    /// Zero.
    pub reserved: u32,
    /// Array of capsule_count capsules; the library copies it.
    pub capsules: *const vbss_scene_capsule,
    /// Position of the origin of the frame, m, each coordinate at most 1e3 in magnitude; default
    /// 0.
    pub position: [f64; 3],
    /// Orientation w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0.
    pub orientation: [f64; 4],
    /// COUPLED, FREE: velocity of the origin, m/s, each component at most 1e5 in magnitude; default
    /// 0.
    pub velocity: [f64; 3],
    /// COUPLED, FREE: angular velocity, rad/s, each component at most 1e6 in magnitude; default 0.
    /// A body turns by at most a quarter of a turn in a part of a step; a faster one slows down.
    pub angular_velocity: [f64; 3],
    /// Mass of the body, kg, 1e-9 to 1e3; default 0.02. It is distributed over the capsules as over
    /// solids of one material; overlaps count twice.
    pub mass: f64,
    /// Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default 0,
    /// because hands carry their tools.
    pub gravity: [f64; 3],
    /// Coefficient of friction, 0 to 10; default 0.15. A contact with a thread uses this
    /// coefficient, any other the geometric mean of both bodies.
    pub friction: f64,
    /// COUPLED: stiffness, N/m, 0 to 1e9; default 2000.
    pub stiffness: f64,
    /// COUPLED: damping, N s/m, 0 to 1e6; default 5.
    pub damping: f64,
    /// COUPLED: rotational stiffness, N m/rad, 0 to 1e9; default 2.
    pub turning_stiffness: f64,
    /// COUPLED: rotational damping, N m s/rad, 0 to 1e6; default 0.005.
    pub turning_damping: f64,
}

/// State of a rigid body.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_rigid_state {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Kind of motion.
    pub kind: vbss_scene_rigid_kind,
    /// Position of the origin of its frame, m.
    pub position: [f64; 3],
    /// Orientation from body to world, w, x, y, z.
    pub orientation: [f64; 4],
    /// Velocity of the origin, m/s.
    pub velocity: [f64; 3],
    /// Angular velocity in the world frame, rad/s.
    pub angular_velocity: [f64; 3],
    /// Target position of the origin, m.
    pub target_position: [f64; 3],
    /// Target orientation, w, x, y, z.
    pub target_orientation: [f64; 4],
    /// Force on the hand, N: the opposite of the coupling's force; for a driven body the sum of its
    /// contacts and pins. Zero for a free body.
    pub hand_force: [f64; 3],
    /// Torque on the hand about the origin of the body's frame, N m.
    pub hand_torque: [f64; 3],
    /// Sum of the forces of all contacts and pins on the body in the last step, N.
    pub contact_force: [f64; 3],
    /// Their torque about the origin of the body's frame, N m.
    pub contact_torque: [f64; 3],
}

/// Counters since creation, and results of the last step. Method VBLAST leaves `rows`, `separators` and
/// the counters of attempts, solves, the guard and operations at 0; vbss_scene_get_baseline_statistics
/// returns what it counts.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_statistics {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Contacts that carry a force after the last step.
    pub contacts: u32,
    /// Contacts that could have closed in the last part.
    pub rows: u32,
    /// Blocks of the last part's system that contacts couple.
    pub separators: u32,
    /// Calls of vbss_scene_step that succeeded.
    pub steps: u64,
    /// Accepted parts of steps; equal to `steps` if no step was divided.
    pub parts: u64,
    /// Attempts, rejected ones included.
    pub attempts: u64,
    /// Linearisations of all attempts.
    pub linearisations: u64,
    /// Solves of the separators' system.
    pub state_solves: u64,
    /// Times the sparsity pattern of that system was computed; not part of the state.
    pub patterns: u64,
    /// Attempts rejected because contact states were not found.
    pub rejected_states: u64,
    /// Attempts rejected because lengths or shapes did not converge, or a node of a drain moved too
    /// far.
    pub rejected_stretch: u64,
    /// Attempts rejected because of penetration.
    pub rejected_depth: u64,
    /// Attempts rejected by the guard: bodies would pass through each other, or come too near.
    pub rejected_guard: u64,
    /// Attempts rejected because a pivot was too small or a number was not finite.
    pub rejected_singular: u64,
    /// Attempts rejected because candidates or contacts exceeded their capacity.
    pub rejected_full: u64,
    /// Attempts accepted with a residual of up to 5 % in the contact law.
    pub loose_states: u64,
    /// Parts accepted with a stretch error above the tolerance.
    pub loose_stretch: u64,
    /// Parts truncated by the guard.
    pub clamped: u64,
    /// Parts accepted that reduced a penetration above the tolerance.
    pub recovering: u64,
    /// Pairs that the guard has tested or knows to be apart.
    pub guard_pairs: u64,
    /// Largest penetration after the last step, m.
    pub last_penetration: f64,
    /// Largest penetration of all steps, m.
    pub penetration: f64,
    /// IMPLICIT: max |length / rest length - 1 - T / EA| after the last step; VBLAST: max |length /
    /// rest length - 1|.
    pub last_stretch_error: f64,
    /// Largest stretch error of all steps.
    pub stretch_error: f64,
    /// Residual of the contact law after the last part, N.
    pub last_residual: f64,
    /// Sum of the lengths of the steps, `time_paused` included, s.
    pub time: f64,
    /// Operations of all steps, as the step budget counts them; method IMPLICIT.
    pub operations: u64,
    /// Largest number of operations of a step.
    pub most_operations: u64,
    /// REAL_TIME: steps of which a part, or all, was left out.
    pub paused: u64,
    /// Simulated time that these steps have lost, s.
    pub time_paused: f64,
    /// Calls after which a step was suspended or had not begun; see
    /// vbss_solver_options::call_budget_us.
    pub deferred: u64,
    /// Number of suspended and unbegun steps after the last call, 0 to 2.
    pub behind: u32,
    /// Steps that two calls had suspended while other bodies waited, so that the third completed
    /// them without the budget of a call.
    pub overdue: u32,
    /// Length that threads have torn at holes, m (vbss_drain_config::tear_energy).
    pub torn_length: f64,
    /// Energy that this has dissipated, J.
    pub tear_work: f64,
}

/// Two bodies that hold each other back, and all bodies that touch them. A failed step holds back
/// only the bodies that contacts, grasps, holes or pins connect with these two. All other bodies
/// move on.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_blocker {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Cause in the last step that held them back.
    pub cause: vbss_scene_blocker_cause,
    /// Number of one body; 0: unknown.
    pub body_a: u32,
    /// Number of the other body; 0: the floor, or no second body.
    pub body_b: u32,
    /// Simulated time at which they were first held back, s.
    pub since: f64,
    /// Simulated time that they have lost since then, s.
    pub lost_time: f64,
    /// Their deepest overlap in the last step that held them back, m; 0: none.
    pub depth: f64,
}

/// A hole of a needle or a thread in a drain or host surface.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_hole {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Identifier from 1 on, in the order of creation; never reused.
    pub id: u32,
    /// Number of the needle in the hole; 0: a thread is in it.
    pub needle: u32,
    /// Number of the drain or host surface.
    pub drain: u32,
    /// Triangle of it.
    pub triangle: u32,
    /// 1: the tip went through from inside; 0: from outside.
    pub outward: u32,
    /// Weights of the triangle's nodes at the hole.
    pub weights: [f64; 3],
    /// Position of the hole on the drain at rest, m: VBSS_DRAIN_VIEW_REST_POSITIONS. In a host surface the
    /// same as `position`.
    pub rest_position: [f64; 3],
    /// Current position of the hole, in the middle of the wall, m.
    pub position: [f64; 3],
    /// Unit direction of the suture at the hole, towards the needle's tip, or the thread's
    /// beginning.
    pub direction: [f64; 3],
    /// Arc length of the suture at the hole, m. For a needle it is measured from the tip, and is
    /// negative before the tip has reached the middle of the wall. For a thread it is measured from
    /// the beginning. Near the swage it may be up to 0.2 mm beyond an end.
    pub arc_length: f64,
    /// Friction on the suture along `direction`, N.
    pub friction: f64,
    /// Force on the suture, N.
    pub force: [f64; 3],
    /// Number of the thread in the hole; 0: a needle is in it.
    pub thread: u32,
    /// Zero.
    pub reserved: u32,
    /// Length of the cut by which the thread has torn this hole, m: along the wall as it was then, in the
    /// plane of its triangles (vbss_drain_config::tear_energy).
    pub torn_length: f64,
    /// Energy that this has dissipated, J.
    pub tear_work: f64,
}

/// A grasped place of a thread, a needle or a drain.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_scene_grasp {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Number of the grasped body in the scene.
    pub body: u32,
    /// Arc length of the middle of the held part, m: unstretched along a thread, or from a needle's
    /// tip.
    pub arc_length: f64,
    /// Position of that middle, m.
    pub position: [f64; 3],
    /// Force of the jaws on the held body in the last step, N. While the body slides, it exceeds
    /// the limit by the clamp's gain in a step.
    pub force: [f64; 3],
    /// Largest force along the jaws' faces that they bear, N; VBLAST: 0.
    pub limit: f64,
    /// Distance that the body has slid through the jaws since it was grasped, m.
    pub slid: f64,
}

extern "C" {
    /// Fills a configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_scene_config_init(config: *mut vbss_scene_config, struct_size: u32) -> vbss_result;
    /// Creates a scene without bodies, and allocates the memory that steps need.
    ///
    /// @param context     owner
    /// @param config   configuration; NULL for the defaults
    /// @param scene  the new scene; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_create(context: *mut vbss_context, config: *const vbss_scene_config, scene: *mut *mut vbss_scene) -> vbss_result;
    /// Destroys a scene with its rigid bodies and pins; its threads, drains and graspers no longer
    /// belong to a scene.
    ///
    /// @param scene  the scene; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_destroy(scene: *mut vbss_scene) -> vbss_result;
    /// Adds a thread of the same context, which belongs to the scene until it is removed. The scene also
    /// reserves capacity for each piece that can still be cut from the thread: a thread and two nodes.
    /// The remaining cuts belong to the scene as long as a thread of the family does. An adaptive mesh
    /// needs capacity for its whole node_capacity; nodes of threads added later reduce that capacity.
    /// The mesh adapts at the very end of steps, which renumbers the nodes and segments beyond a change.
    /// Pins, grasps and contacts in the views follow (docs/explanation/adaptive.md).
    ///
    /// @param scene      the scene
    /// @param thread     the thread, of the scene's method, with a radius above 0
    /// @param body  its number in the scene, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: the thread is of another context),
    /// VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (an overlap, if the scene refuses it),
    /// VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_IN_SCENE, VBSS_ERROR_CAPACITY
    /// (pieces included), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_add_thread(scene: *mut vbss_scene, thread: *mut vbss_thread, body: *mut u32) -> vbss_result;
    /// Adds a drain of the same context, which belongs to the scene until it is removed. The call
    /// allocates the memory that the scene's steps need for it. Features within three wall thicknesses
    /// of each other along its surface do not touch. The scene's limits of linearisations and halvings
    /// apply; the drain's own limits are for its own steps.
    ///
    /// @param scene      the scene
    /// @param drain      the drain, of the scene's method
    /// @param body  its number in the scene, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: the drain is of another context),
    /// VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (an overlap, if the scene refuses it),
    /// VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_IN_SCENE, VBSS_ERROR_CAPACITY,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_add_drain(scene: *mut vbss_scene, drain: *mut vbss_drain, body: *mut u32) -> vbss_result;
    /// Fills a configuration of a rigid body with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_scene_rigid_config_init(config: *mut vbss_scene_rigid_config, struct_size: u32) -> vbss_result;
    /// Adds a rigid body. A scene accepts at most 4096 bodies in its life, threads included.
    ///
    /// @param scene      the scene
    /// @param config   the configuration; not NULL, because a body needs capsules
    /// @param body  its number in the scene, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_add_rigid(scene: *mut vbss_scene, config: *const vbss_scene_rigid_config, body: *mut u32) -> vbss_result;
    /// Adds a needle as a free body with its current pose and velocity. A thread whose first node is
    /// pinned to it at the swage (vbss_scene_pin_thread) is swaged to it. Until its removal stepping,
    /// placing, restoring or destroying it alone returns VBSS_ERROR_IN_SCENE. With method VBLAST it
    /// exactly follows the tool whose jaws have closed on it first. A needle that no tool holds flies,
    /// lies on the floor, and stays in the walls of drains that it passes through
    /// (docs/explanation/paper-needle.md).
    ///
    /// @param scene      the scene
    /// @param needle     a needle of the same context and method
    /// @param body  its number in the scene, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: the needle is of another context),
    /// VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_IN_SCENE, VBSS_ERROR_OUT_OF_RANGE (an overlap, if
    /// the scene refuses it), VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_CAPACITY
    /// (bodies or capsules), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_add_needle(scene: *mut vbss_scene, needle: *mut vbss_needle, body: *mut u32) -> vbss_result;
    /// Adds a grasper of the same context, which belongs to the scene until it is removed. It starts at
    /// its last target, at rest. It counts as a rigid body with four capsules.
    ///
    /// @param scene      the scene
    /// @param grasper    the grasper, of the scene's method
    /// @param body  its number in the scene, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: the grasper is of another context),
    /// VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (an overlap, if the scene refuses it,
    /// or the trocar is nearer to the tip than the lateral reach of the bent jaws),
    /// VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_IN_SCENE, VBSS_ERROR_CAPACITY,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_add_grasper(scene: *mut vbss_scene, grasper: *mut vbss_grasper, body: *mut u32) -> vbss_result;
    /// Returns one of the places that a grasper holds.
    ///
    /// @param scene        the scene
    /// @param tool         number of the grasper in the scene
    /// @param index        index of the place, from 0 on
    /// @param grasp   receives the grasp
    /// @param struct_size  `sizeof *grasp` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such place)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_grasp(scene: *mut vbss_scene, tool: u32, index: u32, grasp: *mut vbss_scene_grasp, struct_size: u32) -> vbss_result;
    /// Returns a hole of a needle or a thread in a drain or host surface, after the last step.
    ///
    /// @param scene        the scene
    /// @param index        index of the hole, from 0 on; the order may change with the next step
    /// @param hole    receives the hole
    /// @param struct_size  `sizeof *hole` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such hole)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_hole(scene: *mut vbss_scene, index: u32, hole: *mut vbss_scene_hole, struct_size: u32) -> vbss_result;
    /// Returns a pair of bodies that hold each other back. Pairs are in the order in which they began. A
    /// pair is listed until it has moved freely for 0.1 s of simulated time. At most 16 are listed.
    /// Method IMPLICIT.
    ///
    /// @param scene         the scene
    /// @param index         index of the pair, from 0 on
    /// @param blocker  receives the pair
    /// @param struct_size   `sizeof *blocker` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such pair)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_blocker(scene: *mut vbss_scene, index: u32, blocker: *mut vbss_scene_blocker, struct_size: u32) -> vbss_result;
    /// Makes a hole where a thread or a needle already goes through the wall of a drain or host surface, for hosts that
    /// lay out a stitch. Afterwards the hole behaves as if a needle had made it.
    ///
    /// @param scene       the scene, of method IMPLICIT
    /// @param body        the thread or the needle; a thread of three nodes at least
    /// @param arc_length  approximate arc length of the hole, m, 0 to its length; the hole is at the
    /// nearest place of the suture that a descent from there finds
    /// @param drain       the drain or host surface
    /// @param triangle    its triangle: of a drain in VBSS_DRAIN_VIEW_TRIANGLES, of a host surface as it was added
    /// @param weights     three weights of its nodes at the hole, 0 to 1, with the sum 1
    /// @param id     receives the identifier of the hole; may be NULL
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (a
    /// value, or the suture is too far from there to touch the wall), VBSS_ERROR_NOT_FOUND (no
    /// such body), VBSS_ERROR_INCOMPATIBLE (a body of another kind, a thread of two nodes, or
    /// another method), VBSS_ERROR_IN_USE (a hole of the same suture is nearer than its
    /// diameter), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY (hole_capacity),
    /// VBSS_ERROR_OUT_OF_MEMORY (only while a step is suspended) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_make_hole(scene: *mut vbss_scene, body: u32, arc_length: f64, drain: u32, triangle: u32, weights: *const f64, id: *mut u32) -> vbss_result;
    /// Removes a body, with its pins and grasps. A thread, drain or grasper then no longer belongs to a
    /// scene, and a grasper is at its target.
    ///
    /// @param scene  the scene
    /// @param body   its number, not 0
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such body) or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_remove(scene: *mut vbss_scene, body: u32) -> vbss_result;
    /// Sets the target of a driven or coupled body for the end of the next step. The body, or the pose
    /// that it is tied to, moves there at constant speed during the step, turning the shortest way, and
    /// then stays. The last call before a step counts. Between two steps the target must turn by less
    /// than half a turn.
    ///
    /// @param scene        the scene
    /// @param body         a rigid body, neither a free one nor a grasper (vbss_grasper_set_target)
    /// @param position     position of the origin of its frame, m, each coordinate at most 1e3 in
    /// magnitude
    /// @param orientation  quaternion w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps the
    /// orientation
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such body), VBSS_ERROR_INCOMPATIBLE (no rigid body, a free one or a grasper),
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_rigid_target(scene: *mut vbss_scene, body: u32, position: *const f64, orientation: *const f64) -> vbss_result;
    /// Pins a node of a thread to a point of a body. The node moves there within the next step and then
    /// moves with the body. With method IMPLICIT the node's motion is eliminated in favour of the body's, so
    /// the body bears its force, at any ratio of masses. With method VBLAST, and on driven bodies and the
    /// world, the node moves as the body does. With method VBLAST pins keep a knot: pin the nearest node
    /// of both strands of a crossing. No other attachment may hold the node. On driven bodies and the
    /// world the node becomes the end of a section, and the pin is an attachment of the thread. A pin
    /// whose attachment was detached holds nothing. Along the thread the thread does not touch the body
    /// within 1.6 contact distances of the pin.
    ///
    /// @param scene     the scene
    /// @param thread    number of the thread in the scene
    /// @param node      0 to its number of nodes - 1
    /// @param body      number of a rigid body; 0: the world
    /// @param point     point in the frame of the body, m, each coordinate at most 1e3 in magnitude;
    /// NULL: the current position of the node
    /// @param pin  identifier of the pin, from 1 on, never reused
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such thread or body), VBSS_ERROR_INCOMPATIBLE (a body of another kind), VBSS_ERROR_IN_USE
    /// (the node is held already), VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_CAPACITY (pins, or the thread's attachments), VBSS_ERROR_OUT_OF_MEMORY (only
    /// while a step is suspended) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_pin_thread(scene: *mut vbss_scene, thread: u32, node: u32, body: u32, point: *const f64, pin: *mut u32) -> vbss_result;
    /// Removes a pin.
    ///
    /// @param scene  the scene
    /// @param pin    identifier of the pin
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such pin) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_unpin_thread(scene: *mut vbss_scene, pin: u32) -> vbss_result;
    /// Cuts a thread of the scene in two, in place, with its pins, attachments and contacts. The part
    /// beyond the cut becomes a new body with node 0 at the cut. Pieces can be cut again. The scene has
    /// reserved capacity for the pieces when the thread was added, so the call allocates nothing, except
    /// a temporary copy of the state while a step is suspended. A cut within 1 % of a segment, or 1e-7
    /// m, of a node goes through the node, which the thread keeps with its attachments. A cut within 0.2
    /// mm of a hole of the thread is made 0.2 mm beside it, where an end is out of the hole. The ends at
    /// a cut do not touch each other until they have come apart. Contacts in the views keep their
    /// earlier numbers until the next step.
    ///
    /// @param scene       the scene
    /// @param thread      number of the thread in the scene
    /// @param arc_length  unstretched arc length from the thread's node 0 to the cut, m, within its
    /// length and not at an end
    /// @param piece  number of the new body, for vbss_scene_get_thread; also in an event (scene_event.h)
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such body), VBSS_ERROR_INCOMPATIBLE (no thread), VBSS_ERROR_OUT_OF_RANGE (the cut is not
    /// within the thread), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY (no cuts left, which is an
    /// event, too), VBSS_ERROR_OUT_OF_MEMORY (only while a step is suspended) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_cut_thread(scene: *mut vbss_scene, thread: u32, arc_length: f64, piece: *mut u32) -> vbss_result;
    /// Returns the handle of a thread in the scene, for views and attachments. When a state from before
    /// its cut is restored, the handle of a piece becomes invalid. It becomes valid again when a state
    /// from after the cut is restored.
    ///
    /// @param scene        the scene
    /// @param body         number of the thread in the scene
    /// @param thread  its handle; NULL when there is no such thread
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such body) or VBSS_ERROR_INCOMPATIBLE (no thread)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_thread(scene: *mut vbss_scene, body: u32, thread: *mut *mut vbss_thread) -> vbss_result;
    /// Returns the memory that vbss_scene_create allocates for a configuration. Bodies and drains add
    /// their own: see docs/reference/memory.md. The call creates such a scene and destroys it again, so that the
    /// number is exact; a host then knows what to reserve on another machine with the same sizes of
    /// pointers.
    ///
    /// @param context     the context, whose allocator must have this memory
    /// @param config      configuration; NULL for the defaults
    /// @param bytes  memory of the scene, bytes, without the slots of handles, which a context
    /// allocates 64 at a time
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, the failures of
    /// vbss_scene_create or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_config_get_memory(context: *mut vbss_context, config: *const vbss_scene_config, bytes: *mut u64) -> vbss_result;
    /// Does the work of the next step that does not depend on contacts, so that this step takes no
    /// longer than those after it: the search for close bodies begins, and the pattern of the linear system is
    /// analysed. Call it when all bodies are in the scene, before the first step or after bodies were
    /// added. The state does not change, and a scene steps with the same bits without the call. A suspended step stays
    /// as it is. The call allocates nothing. Method IMPLICIT; with method VBLAST the call does nothing.
    ///
    /// @param scene  the scene
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_CAPACITY (candidates or matrix) or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_prepare(scene: *mut vbss_scene) -> vbss_result;
    /// Advances the scene by one step. The call allocates nothing. On failure the scene is unchanged.
    /// With method VBLAST the step of a thread or drain that has diverged fails; see vbss_thread_step
    /// and vbss_drain_step for the bounds. If a call has ended a suspended step, or some islands of a
    /// step, and the rest fails, that result stays: the call returns VBSS_OK, `behind` counts the rest,
    /// and the next call returns the failure.
    ///
    /// @param scene  the scene
    /// @param h      length of the step, s, 1e-7 to 0.1
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FINITE (h, or the state would be),
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_CAPACITY (contacts, candidates or matrix),
    /// VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_step(scene: *mut vbss_scene, h: f64) -> vbss_result;
    /// Returns the state of a rigid body.
    ///
    /// @param scene        the scene
    /// @param body         its number
    /// @param state   receives the state
    /// @param struct_size  `sizeof *state` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_NOT_FOUND (no such body) or VBSS_ERROR_INCOMPATIBLE (no rigid body)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_rigid(scene: *mut vbss_scene, body: u32, state: *mut vbss_scene_rigid_state, struct_size: u32) -> vbss_result;
    /// Returns a view of one of the scene's arrays.
    ///
    /// @param scene        the scene
    /// @param field        the array
    /// @param view    receives the view
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_OUT_OF_RANGE (no such field)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_view(scene: *mut vbss_scene, field: vbss_scene_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
    /// Returns the counters of a scene.
    ///
    /// @param scene            the scene
    /// @param statistics  receives the counters
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_statistics(scene: *mut vbss_scene, statistics: *mut vbss_scene_statistics, struct_size: u32) -> vbss_result;
    /// Returns what method VBLAST counts in a scene, without what its threads count.
    ///
    /// @param scene           the scene
    /// @param statistics  receives the counters
    /// @param struct_size      `sizeof *statistics` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INCOMPATIBLE if the scene uses another method, VBSS_ERROR_INVALID_HANDLE,
    /// VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_baseline_statistics(scene: *mut vbss_scene, statistics: *mut vbss_baseline_statistics, struct_size: u32) -> vbss_result;
    /// Returns the deepest overlap of a body with another body or the floor in their current poses. An
    /// overlap counts if it is deeper than `penetration_tolerance` of the solver's options allows
    /// after a step. Overlaps of the body with itself do not count, nor do those near a pin of a thread
    /// on the other body or at the swage of a needle. Pairs of driven bodies do not count either,
    /// because a step does not test them until they have come apart. Contacts in jaws and holes count.
    /// The call compares all segments of the body with all others; use it while a scene is set up.
    ///
    /// @param scene         the scene
    /// @param body          number of the body
    /// @param overlap  receives the overlap
    /// @param struct_size   `sizeof *overlap` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such body),
    /// VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_overlap(scene: *mut vbss_scene, body: u32, overlap: *mut vbss_scene_overlap, struct_size: u32) -> vbss_result;
    /// Saves the state of the scene and all its bodies, with a description from which vbss_scene_load
    /// creates an equal scene. A restored scene continues with the same bits, also on another machine.
    ///
    /// @param scene         the scene
    /// @param bytes    receives the state; NULL with capacity 0 asks for its size, which logs no error
    /// @param capacity      size of the buffer
    /// @param written  bytes of the state, also when it does not fit
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_save(scene: *mut vbss_scene, bytes: *mut u8, capacity: u64, written: *mut u64) -> vbss_result;
    /// Restores a saved state into this scene or an equal one, with equal bodies added in the same
    /// order. Cuts are part of the state: the call undoes and repeats them as needed. It cannot restore
    /// a piece that was removed. A body that was added after a cut has another number in a scene without
    /// that cut. On failure the scene is unchanged.
    ///
    /// @param scene  the scene
    /// @param bytes  the state
    /// @param count  its size
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
    /// VBSS_ERROR_CORRUPT, VBSS_ERROR_CAPACITY, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY
    /// or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_restore(scene: *mut vbss_scene, bytes: *const u8, count: u64) -> vbss_result;
    /// Creates a scene and all its bodies from the bytes of vbss_scene_save alone. The scene has the hash
    /// of the saved one and continues with the same bits. Its bodies have their old numbers;
    /// vbss_scene_get_bodies lists them, and vbss_scene_get_thread and its like return their handles.
    ///
    /// The host destroys the scene. The scene owns the bodies that it was loaded with: vbss_scene_remove
    /// destroys such a body, and vbss_scene_destroy all of them, pieces of their threads included. Bodies
    /// that the host adds later stay the host's, as in any scene. Pointers of the host for bodies are NULL
    /// (vbss_scene_set_user_data).
    ///
    /// @param context     owner
    /// @param bytes       the saved scene; not used after the call
    /// @param count       its size
    /// @param scene  the new scene; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
    /// VBSS_ERROR_CORRUPT (also: no scene or body can have the described configuration),
    /// VBSS_ERROR_DATA_VERSION (also: an older library saved the scene, without a description),
    /// VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_load(context: *mut vbss_context, bytes: *const u8, count: u64, scene: *mut *mut vbss_scene) -> vbss_result;
    /// Returns the XXH64 of the state of the scene and its bodies, counters included. Equal states have
    /// equal hashes on every machine.
    ///
    /// @param scene      the scene
    /// @param hash  the hash
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_get_hash(scene: *mut vbss_scene, hash: *mut u64) -> vbss_result;
}
