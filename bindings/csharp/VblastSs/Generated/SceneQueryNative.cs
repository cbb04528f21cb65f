// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_bodies(ObjectHandle scene, uint* numbers, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_body(ObjectHandle scene, uint body, SceneBodyInfo* info, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_drain(ObjectHandle scene, uint body, out IntPtr drain);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_needle(ObjectHandle scene, uint body, out IntPtr needle);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_grasper(ObjectHandle scene, uint body, out IntPtr grasper);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_user_data(ObjectHandle scene, uint body, IntPtr data);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_user_data(ObjectHandle scene, uint body, IntPtr* data);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_cast_ray(ObjectHandle scene, double* origin, double* translation, uint mask, SceneRayHit* hit, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_find_nearest(ObjectHandle scene, double* point, double radius, uint mask, SceneNearest* nearest, uint structSize);
    }
}
