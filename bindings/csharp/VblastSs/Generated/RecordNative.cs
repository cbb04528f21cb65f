// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_record_config_init(RecordConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_record_create(ObjectHandle scene, RecordConfigData* config, out IntPtr record);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_record_destroy(IntPtr record);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_record_resume(ObjectHandle replay, RecordConfigData* config, out IntPtr record, ulong* position);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_record_take(ObjectHandle record, byte** bytes, ulong* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_set_recorder(ObjectHandle scene, ObjectHandle record);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_record_apply_input(ObjectHandle record, RecordInput* input, uint* id);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_record_end(ObjectHandle record);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_replay_create(ObjectHandle context, byte* bytes, ulong count, out IntPtr replay);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_replay_destroy(IntPtr replay);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_replay_get_info(ObjectHandle replay, ReplayInfo* info, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_replay_get_scene_config(ObjectHandle replay, SceneConfigData* config);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_replay_check(ObjectHandle replay, ulong* steps);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_replay_begin(ObjectHandle replay, ObjectHandle scene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_replay_load_scene(ObjectHandle replay, out IntPtr scene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_replay_step(ObjectHandle replay, ReplayReport* report, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_replay_seek(ObjectHandle replay, ulong step, ReplayReport* report, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_replay_read(ObjectHandle replay, ulong number, ReplayLoggedStep* step, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_record_check_log(ObjectHandle context, byte* bytes, ulong count, RecordLogReport* report, uint structSize);
    }
}
