// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


extern "C" {
    /// Sets the gravitational acceleration of one body, or of all bodies that nothing carries.
    ///
    /// @param scene    the scene
    /// @param body     a thread, drain, needle, rigid body or grasper; 0: all threads, drains and needles
    /// and all free bodies. Driven and coupled bodies and graspers then keep theirs, because
    /// hands carry them. A driven body accepts a value, but moves as its target does.
    /// @param gravity  acceleration, m/s^2, each component at most 1e6 in magnitude
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such body), VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_OUT_OF_RANGE,
    /// VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY (only while a step is suspended) or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_gravity(scene: *mut vbss_scene, body: u32, gravity: *const f64) -> vbss_result;
    /// Sets the coefficient of friction of a body or of the floor. A contact of a thread uses the
    /// coefficient of the other body; any other contact uses the geometric mean of both. The friction in
    /// closed jaws and in holes is another one, and does not change.
    ///
    /// @param scene     the scene
    /// @param body      a drain, needle, rigid body or grasper, no thread; 0: the floor
    /// @param friction  coefficient, 0 to 10
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such body),
    /// VBSS_ERROR_INCOMPATIBLE (a thread, or another method), VBSS_ERROR_OUT_OF_RANGE,
    /// VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY (only while a step is suspended) or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_friction(scene: *mut vbss_scene, body: u32, friction: f64) -> vbss_result;
    /// Sets the coefficient of friction between threads, and of a thread with itself.
    ///
    /// @param scene     the scene
    /// @param friction  coefficient, 0 to 10
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_INCOMPATIBLE (another method),
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY (only while a
    /// step is suspended) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_thread_friction(scene: *mut vbss_scene, friction: f64) -> vbss_result;
    /// Sets the virtual coupling between a coupled body or a grasper and its target.
    ///
    /// @param scene              the scene
    /// @param body               a coupled rigid body, or a grasper
    /// @param stiffness          stiffness, N/m, 0 to 1e9
    /// @param damping            damping, N s/m, 0 to 1e6
    /// @param turning_stiffness  rotational stiffness, N m/rad, 0 to 1e9
    /// @param turning_damping    rotational damping, N m s/rad, 0 to 1e6
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such body),
    /// VBSS_ERROR_INCOMPATIBLE (a body without a coupling, or another method),
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY (only while a
    /// step is suspended) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_coupling(scene: *mut vbss_scene, body: u32, stiffness: f64, damping: f64, turning_stiffness: f64, turning_damping: f64) -> vbss_result;
    /// Sets the largest speed at which a driven or coupled body, or a grasper, approaches its target:
    /// `speed_limit` of vbss_scene_config.
    ///
    /// @param scene  the scene
    /// @param limit  speed, m/s, 0 to 1e6; 0: no limit
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_INCOMPATIBLE (another method),
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY (only while a
    /// step is suspended) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_speed_limit(scene: *mut vbss_scene, limit: f64) -> vbss_result;
    /// Sets the budgets of a step and of a call, from the next step on. A host that measures the speed of
    /// its core late, or that shares the core with other work, changes them without a new scene. They apply
    /// in mode REAL_TIME. The fields of the same names of vbss_solver_options describe them; their values
    /// there stay those with which the scene was created.
    ///
    /// @param scene              the scene
    /// @param step_budget_us     budget of a step, us, 0 to 1e7; 0: no limit
    /// @param call_budget_us     budget of a call, us, 0 to 1e7; 0: each call completes its step
    /// @param operations_per_us  speed of the core, operations per us, 1e-3 to 1e6. Its product with a budget
    /// that is not 0 is 1 to 4294967295 when it is rounded.
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_INCOMPATIBLE (another method),
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY (only while a
    /// step is suspended) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_budgets(scene: *mut vbss_scene, step_budget_us: f64, call_budget_us: f64, operations_per_us: f64) -> vbss_result;
    /// Sets the contact filter of a body or of the floor. Two bodies collide if each has a category that
    /// the mask of the other contains. A new body has category 1 and the mask 0xffffffff. Bodies that do
    /// not collide have no contacts and pass through each other. Jaws do not grasp, and needles do not
    /// pierce, a body with which they do not collide. Pins, grasps and holes that exist stay, and a body
    /// always collides with itself. A piece that is cut from a thread has the filter of the thread.
    /// Bodies that overlap when a call lets them collide again are pushed apart as new bodies are.
    ///
    /// @param scene     the scene
    /// @param body      any body; 0: the floor
    /// @param category  categories of the body, one bit each
    /// @param mask      categories that the body collides with
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such body),
    /// VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_OUT_OF_MEMORY (only while a step is
    /// suspended) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_filter(scene: *mut vbss_scene, body: u32, category: u32, mask: u32) -> vbss_result;
    /// Applies a force and a torque to a body for one step, the next one that begins. Calls before that
    /// step add up. Afterwards the body is free of them. In a part of a step that is left out they do
    /// not act.
    ///
    /// @param scene   the scene
    /// @param body    a free or coupled rigid body, a needle or a coupled grasper
    /// @param force   force, N, each component at most 1e6 in magnitude
    /// @param point   point of the world at which the force acts now, m, each coordinate at most 1e3 in
    /// magnitude; NULL: the centre of mass
    /// @param torque  additional torque in the world frame, N m, each component at most 1e6 in
    /// magnitude; NULL: none
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such body), VBSS_ERROR_INCOMPATIBLE (no rigid body, a driven one, or another method),
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_apply_force(scene: *mut vbss_scene, body: u32, force: *const f64, point: *const f64, torque: *const f64) -> vbss_result;
    /// Sets the velocities of a free body. vbss_scene_get_rigid returns them.
    ///
    /// @param scene             the scene
    /// @param body              a free rigid body or a needle
    /// @param velocity          velocity of the origin of its frame, m/s, each component at most 1e5 in
    /// magnitude
    /// @param angular_velocity  angular velocity in the world frame, rad/s, each component at most 1e6 in
    /// magnitude; NULL keeps it
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such body), VBSS_ERROR_INCOMPATIBLE (a body that is not free, or another method),
    /// VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY (only while a
    /// step is suspended) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_rigid_velocity(scene: *mut vbss_scene, body: u32, velocity: *const f64, angular_velocity: *const f64) -> vbss_result;
    /// Moves a free body to a pose at once. Its velocities stay. Nothing checks what is on the way. If
    /// the body overlaps another one there, `overlap` of vbss_scene_config decides.
    ///
    /// @param scene        the scene
    /// @param body         a free rigid body or a needle, without pins, grasps and holes
    /// @param position     position of the origin of its frame, m, each coordinate at most 1e3 in
    /// magnitude
    /// @param orientation  quaternion w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps the
    /// orientation
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
    /// such body), VBSS_ERROR_INCOMPATIBLE (a body that is not free, or another method),
    /// VBSS_ERROR_IN_USE (a pin, a hole or a grasp holds the body), VBSS_ERROR_OUT_OF_RANGE (a
    /// value, or an overlap, if the scene refuses it), VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_OUT_OF_MEMORY (only while a step is suspended) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_rigid_pose(scene: *mut vbss_scene, body: u32, position: *const f64, orientation: *const f64) -> vbss_result;
}
