// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_config_init(ThreadConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_config_preset(ThreadConfigData* config, ThreadPreset preset);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_config_suture(ThreadConfigData* config, ThreadMaterial material, ThreadUspSize size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_grade_lengths(double length, double centre, double finest, double coarsest, double ratio, double* restLengths, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_create(ObjectHandle context, ThreadConfigData* config, out IntPtr thread);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_destroy(IntPtr thread);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_discard(ObjectHandle thread);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_step(ObjectHandle thread, double h);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_set_state(ObjectHandle thread, double* positions, double* velocities, uint nodeCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_attachment_init(ThreadAttachmentData* attachment, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_attach(ObjectHandle thread, ThreadAttachmentData* attachment, uint* id);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_set_attachment_target(ObjectHandle thread, uint id, double* target, double* direction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_set_roll(ObjectHandle thread, uint id, double roll);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_detach(ObjectHandle thread, uint id);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_get_reaction(ObjectHandle thread, uint id, ThreadReaction* reaction, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_cut(ObjectHandle thread, double arcLength, out IntPtr piece);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_get_view(ObjectHandle thread, ThreadField field, ViewData* view, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_get_energies(ObjectHandle thread, ThreadEnergies* energies, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_get_momentum(ObjectHandle thread, ThreadMomentum* momentum, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_get_statistics(ObjectHandle thread, ThreadStatistics* statistics, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_get_baseline_statistics(ObjectHandle thread, BaselineStatistics* statistics, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_save(ObjectHandle thread, byte* bytes, ulong capacity, ulong* written);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_restore(ObjectHandle thread, byte* bytes, ulong count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_thread_get_hash(ObjectHandle thread, ulong* hash);
    }
}
