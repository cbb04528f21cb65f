// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_config_init(DrainConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_surface_init(DrainSurfaceData* surface, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_create(ObjectHandle context, DrainConfigData* config, out IntPtr drain);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_destroy(IntPtr drain);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_discard(ObjectHandle drain);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_step(ObjectHandle drain, double h);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_set_state(ObjectHandle drain, double* positions, double* velocities, uint nodeCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_attachment_init(DrainAttachmentData* attachment, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_attach(ObjectHandle drain, DrainAttachmentData* attachment, uint* id);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_set_attachment_target(ObjectHandle drain, uint id, double* target);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_detach(ObjectHandle drain, uint id);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_get_reaction(ObjectHandle drain, uint id, double* force);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_get_places(ObjectHandle drain, DrainPlaces* places, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_get_gap(ObjectHandle drain, DrainGap* gap, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_get_view(ObjectHandle drain, DrainField field, ViewData* view, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_get_energies(ObjectHandle drain, DrainEnergies* energies, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_get_statistics(ObjectHandle drain, DrainStatistics* statistics, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_save(ObjectHandle drain, byte* bytes, ulong capacity, ulong* written);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_restore(ObjectHandle drain, byte* bytes, ulong count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_drain_get_hash(ObjectHandle drain, ulong* hash);
    }
}
