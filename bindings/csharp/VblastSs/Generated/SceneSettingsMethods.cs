// Written by bindings/csharp/generate.py from the public headers: do not edit.
namespace VblastSs
{
    /// <summary>Bodies that touch each other and are stepped together.</summary>
    public sealed unsafe partial class Scene : VbssObject
    {
        /// <summary>Sets the gravitational acceleration of one body, or of all bodies that nothing carries.</summary>
        /// <param name="body">
        /// a thread, drain, needle, rigid body or grasper; 0: all threads, drains and needles and
        /// all free bodies. Driven and coupled bodies and graspers then keep theirs, because hands
        /// carry them. A driven body accepts a value, but moves as its target does.
        /// </param>
        /// <param name="gravity">acceleration, m/s^2, each component at most 1e6 in magnitude</param>
        public void SetGravity(uint body, Vector3d gravity)
        {
            Context.Check(Native.vbss_scene_set_gravity(Handle, body, (double*)&gravity));
        }

        /// <summary>
        /// Sets the coefficient of friction of a body or of the floor. A contact of a thread uses
        /// the coefficient of the other body; any other contact uses the geometric mean of both.
        /// The friction in closed jaws and in holes is another one, and does not change.
        /// </summary>
        /// <param name="body">a drain, needle, rigid body or grasper, no thread; 0: the floor</param>
        /// <param name="friction">coefficient, 0 to 10</param>
        public void SetFriction(uint body, double friction)
        {
            Context.Check(Native.vbss_scene_set_friction(Handle, body, friction));
        }

        /// <summary>Sets the coefficient of friction between threads, and of a thread with itself.</summary>
        /// <param name="friction">coefficient, 0 to 10</param>
        public void SetThreadFriction(double friction)
        {
            Context.Check(Native.vbss_scene_set_thread_friction(Handle, friction));
        }

        /// <summary>Sets the virtual coupling between a coupled body or a grasper and its target.</summary>
        /// <param name="body">a coupled rigid body, or a grasper</param>
        /// <param name="stiffness">stiffness, N/m, 0 to 1e9</param>
        /// <param name="damping">damping, N s/m, 0 to 1e6</param>
        /// <param name="turningStiffness">rotational stiffness, N m/rad, 0 to 1e9</param>
        /// <param name="turningDamping">rotational damping, N m s/rad, 0 to 1e6</param>
        public void SetCoupling(uint body, double stiffness, double damping, double turningStiffness, double turningDamping)
        {
            Context.Check(Native.vbss_scene_set_coupling(Handle, body, stiffness, damping, turningStiffness, turningDamping));
        }

        /// <summary>
        /// Sets the largest speed at which a driven or coupled body, or a grasper, approaches its
        /// target: `speed_limit` of vbss_scene_config.
        /// </summary>
        /// <param name="limit">speed, m/s, 0 to 1e6; 0: no limit</param>
        public void SetSpeedLimit(double limit)
        {
            Context.Check(Native.vbss_scene_set_speed_limit(Handle, limit));
        }

        /// <summary>
        /// Sets the budgets of a step and of a call, from the next step on. A host that measures
        /// the speed of its core late, or that shares the core with other work, changes them
        /// without a new scene. They apply in mode REAL_TIME. The fields of the same names of
        /// vbss_solver_options describe them; their values there stay those with which the scene
        /// was created.
        /// </summary>
        /// <param name="stepBudgetUs">budget of a step, us, 0 to 1e7; 0: no limit</param>
        /// <param name="callBudgetUs">budget of a call, us, 0 to 1e7; 0: each call completes its step</param>
        /// <param name="operationsPerUs">
        /// speed of the core, operations per us, 1e-3 to 1e6. Its product with a budget that is not
        /// 0 is 1 to 4294967295 when it is rounded.
        /// </param>
        public void SetBudgets(double stepBudgetUs, double callBudgetUs, double operationsPerUs)
        {
            Context.Check(Native.vbss_scene_set_budgets(Handle, stepBudgetUs, callBudgetUs, operationsPerUs));
        }

        /// <summary>
        /// Sets the contact filter of a body or of the floor. Two bodies collide if each has a
        /// category that the mask of the other contains. A new body has category 1 and the mask
        /// 0xffffffff. Bodies that do not collide have no contacts and pass through each other.
        /// Jaws do not grasp, and needles do not pierce, a body with which they do not collide.
        /// Pins, grasps and holes that exist stay, and a body always collides with itself. A piece
        /// that is cut from a thread has the filter of the thread. Bodies that overlap when a call
        /// lets them collide again are pushed apart as new bodies are.
        /// </summary>
        /// <param name="body">any body; 0: the floor</param>
        /// <param name="category">categories of the body, one bit each</param>
        /// <param name="mask">categories that the body collides with</param>
        public void SetFilter(uint body, uint category, uint mask)
        {
            Context.Check(Native.vbss_scene_set_filter(Handle, body, category, mask));
        }

        /// <summary>
        /// Applies a force and a torque to a body for one step, the next one that begins. Calls
        /// before that step add up. Afterwards the body is free of them. In a part of a step that
        /// is left out they do not act.
        /// </summary>
        /// <param name="body">a free or coupled rigid body, a needle or a coupled grasper</param>
        /// <param name="force">force, N, each component at most 1e6 in magnitude</param>
        /// <param name="point">
        /// point of the world at which the force acts now, m, each coordinate at most 1e3 in
        /// magnitude; NULL: the centre of mass
        /// </param>
        /// <param name="torque">
        /// additional torque in the world frame, N m, each component at most 1e6 in magnitude;
        /// NULL: none
        /// </param>
        public void ApplyForce(uint body, Vector3d force, Vector3d? point, Vector3d? torque)
        {
            Vector3d pointValue = point.GetValueOrDefault();
            Vector3d torqueValue = torque.GetValueOrDefault();
            Context.Check(Native.vbss_scene_apply_force(Handle, body, (double*)&force, point.HasValue ? (double*)&pointValue : null, torque.HasValue ? (double*)&torqueValue : null));
        }

        /// <summary>Sets the velocities of a free body. vbss_scene_get_rigid returns them.</summary>
        /// <param name="body">a free rigid body or a needle</param>
        /// <param name="velocity">velocity of the origin of its frame, m/s, each component at most 1e5 in magnitude</param>
        /// <param name="angularVelocity">
        /// angular velocity in the world frame, rad/s, each component at most 1e6 in magnitude;
        /// NULL keeps it
        /// </param>
        public void SetRigidVelocity(uint body, Vector3d velocity, Vector3d? angularVelocity)
        {
            Vector3d angularVelocityValue = angularVelocity.GetValueOrDefault();
            Context.Check(Native.vbss_scene_set_rigid_velocity(Handle, body, (double*)&velocity, angularVelocity.HasValue ? (double*)&angularVelocityValue : null));
        }

        /// <summary>
        /// Moves a free body to a pose at once. Its velocities stay. Nothing checks what is on the
        /// way. If the body overlaps another one there, `overlap` of vbss_scene_config decides.
        /// </summary>
        /// <param name="body">a free rigid body or a needle, without pins, grasps and holes</param>
        /// <param name="position">position of the origin of its frame, m, each coordinate at most 1e3 in magnitude</param>
        /// <param name="orientation">quaternion w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps the orientation</param>
        public void SetRigidPose(uint body, Vector3d position, Quaterniond? orientation)
        {
            Quaterniond orientationValue = orientation.GetValueOrDefault();
            Context.Check(Native.vbss_scene_set_rigid_pose(Handle, body, (double*)&position, orientation.HasValue ? (double*)&orientationValue : null));
        }
    }
}
