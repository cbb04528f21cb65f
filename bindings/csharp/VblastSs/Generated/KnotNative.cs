// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_config_init(KnotDetectorConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_input_init(KnotInputData* input, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_create(ObjectHandle context, KnotDetectorConfigData* config, out IntPtr detector);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_destroy(IntPtr detector);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_step(ObjectHandle detector, KnotInputData* input);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_judge(ObjectHandle detector, KnotInputData* input);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_reset(ObjectHandle detector);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_get_state(ObjectHandle detector, KnotState* state, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_get_throw(ObjectHandle detector, uint number, KnotThrow* knotThrow, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_get_winding(ObjectHandle detector, uint tool, KnotWinding* winding, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_get_notation(ObjectHandle detector, byte* text, ulong capacity);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_get_view(ObjectHandle detector, KnotField field, ViewData* view, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_get_statistics(ObjectHandle detector, KnotDetectorStatistics* statistics, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_save(ObjectHandle detector, byte* bytes, ulong capacity, ulong* written);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_restore(ObjectHandle detector, byte* bytes, ulong count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_knot_detector_get_hash(ObjectHandle detector, ulong* hash);
    }
}
