// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_grasper_config_init(GrasperConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_grasper_config_preset(GrasperConfigData* config, GrasperPreset preset);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_grasper_create(ObjectHandle context, GrasperConfigData* config, out IntPtr grasper);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_grasper_destroy(IntPtr grasper);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_grasper_discard(ObjectHandle grasper);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_grasper_set_target(ObjectHandle grasper, double* position, double* orientation);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_grasper_set_opening(ObjectHandle grasper, double opening);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_grasper_exchange(ObjectHandle grasper, GrasperKind kind);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_grasper_get_state(ObjectHandle grasper, GrasperState* state, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_grasper_get_view(ObjectHandle grasper, GrasperField field, ViewData* view, uint structSize);
    }
}
