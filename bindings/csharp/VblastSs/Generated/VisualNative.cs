// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_config_init(VisualConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_create(ObjectHandle context, VisualConfigData* config, out IntPtr visual);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_destroy(IntPtr visual);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_add_scene(ObjectHandle visual, ObjectHandle scene, uint* source);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_add_replica(ObjectHandle visual, ObjectHandle replica, uint* source);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_add_thread(ObjectHandle visual, ObjectHandle thread, uint* source);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_add_drain(ObjectHandle visual, ObjectHandle drain, uint* source);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_add_needle(ObjectHandle visual, ObjectHandle needle, uint* source);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_add_grasper(ObjectHandle visual, ObjectHandle grasper, uint* source);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_remove(ObjectHandle visual, uint source);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_update(ObjectHandle visual);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_get_view(ObjectHandle visual, VisualField field, ViewData* view, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_visual_get_statistics(ObjectHandle visual, VisualStatistics* statistics, uint structSize);
    }
}
