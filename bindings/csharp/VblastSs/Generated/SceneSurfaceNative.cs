// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_surface_config_init(SceneSurfaceConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_add_surface(ObjectHandle scene, SceneSurfaceConfigData* config, uint* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_move_surface(ObjectHandle scene, uint body, double* vertices, uint vertexCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_surface_compliance(ObjectHandle scene, uint body, double* compliance, uint count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_remesh_surface(ObjectHandle scene, uint body, double* vertices, uint vertexCount, uint* triangles, uint triangleCount, IntPtr place, IntPtr user);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_surface_view(ObjectHandle scene, uint body, SceneSurfaceField field, ViewData* view, uint structSize);
    }
}
