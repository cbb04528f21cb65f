// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_config_init(SceneConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_create(ObjectHandle context, SceneConfigData* config, out IntPtr scene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_destroy(IntPtr scene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_add_thread(ObjectHandle scene, ObjectHandle thread, uint* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_add_drain(ObjectHandle scene, ObjectHandle drain, uint* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_rigid_config_init(SceneRigidConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_add_rigid(ObjectHandle scene, SceneRigidConfigData* config, uint* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_add_needle(ObjectHandle scene, ObjectHandle needle, uint* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_add_grasper(ObjectHandle scene, ObjectHandle grasper, uint* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_grasp(ObjectHandle scene, uint tool, uint index, SceneGrasp* grasp, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_hole(ObjectHandle scene, uint index, SceneHole* hole, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_blocker(ObjectHandle scene, uint index, SceneBlocker* blocker, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_make_hole(ObjectHandle scene, uint body, double arcLength, uint drain, uint triangle, double* weights, uint* id);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_remove(ObjectHandle scene, uint body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_rigid_target(ObjectHandle scene, uint body, double* position, double* orientation);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_pin_thread(ObjectHandle scene, uint thread, uint node, uint body, double* point, uint* pin);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_unpin_thread(ObjectHandle scene, uint pin);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_cut_thread(ObjectHandle scene, uint thread, double arcLength, uint* piece);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_thread(ObjectHandle scene, uint body, out IntPtr thread);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_config_get_memory(ObjectHandle context, SceneConfigData* config, ulong* bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_prepare(ObjectHandle scene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_step(ObjectHandle scene, double h);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_rigid(ObjectHandle scene, uint body, SceneRigidState* state, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_view(ObjectHandle scene, SceneField field, ViewData* view, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_statistics(ObjectHandle scene, SceneStatistics* statistics, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_baseline_statistics(ObjectHandle scene, BaselineStatistics* statistics, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_overlap(ObjectHandle scene, uint body, SceneOverlap* overlap, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_save(ObjectHandle scene, byte* bytes, ulong capacity, ulong* written);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_restore(ObjectHandle scene, byte* bytes, ulong count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_load(ObjectHandle context, byte* bytes, ulong count, out IntPtr scene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_get_hash(ObjectHandle scene, ulong* hash);
    }
}
