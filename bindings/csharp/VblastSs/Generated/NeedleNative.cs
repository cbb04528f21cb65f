// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_config_init(NeedleConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_config_preset(NeedleConfigData* config, NeedlePreset preset);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_config_shape(NeedleConfigData* config, double circle, double length, double wireDiameter);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_create(ObjectHandle context, NeedleConfigData* config, out IntPtr needle);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_destroy(IntPtr needle);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_discard(ObjectHandle needle);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_step(ObjectHandle needle, double h);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_set_state(ObjectHandle needle, double* position, double* orientation, double* velocity, double* angularVelocity);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_get_state(ObjectHandle needle, NeedleState* state, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_get_mass(ObjectHandle needle, NeedleMass* mass, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_get_place(ObjectHandle needle, double arcLength, double* position, double* direction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_get_energies(ObjectHandle needle, NeedleEnergies* energies, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_get_view(ObjectHandle needle, NeedleField field, ViewData* view, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_save(ObjectHandle needle, byte* bytes, ulong capacity, ulong* written);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_restore(ObjectHandle needle, byte* bytes, ulong count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_needle_get_hash(ObjectHandle needle, ulong* hash);
    }
}
