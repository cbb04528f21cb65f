// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_gravity(ObjectHandle scene, uint body, double* gravity);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_friction(ObjectHandle scene, uint body, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_thread_friction(ObjectHandle scene, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_coupling(ObjectHandle scene, uint body, double stiffness, double damping, double turningStiffness, double turningDamping);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_speed_limit(ObjectHandle scene, double limit);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_budgets(ObjectHandle scene, double stepBudgetUs, double callBudgetUs, double operationsPerUs);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_filter(ObjectHandle scene, uint body, uint category, uint mask);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_apply_force(ObjectHandle scene, uint body, double* force, double* point, double* torque);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_rigid_velocity(ObjectHandle scene, uint body, double* velocity, double* angularVelocity);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_rigid_pose(ObjectHandle scene, uint body, double* position, double* orientation);
    }
}
