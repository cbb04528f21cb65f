// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_config_init(MetricsConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_sample_init(MetricsSampleData* sample, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_event_init(MetricsEventData* @event, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_pull_init(MetricsPullData* pull, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_create(ObjectHandle context, MetricsConfigData* config, out IntPtr metrics);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_destroy(IntPtr metrics);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_add_sample(ObjectHandle metrics, MetricsSampleData* sample);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_add_event(ObjectHandle metrics, MetricsEventData* @event);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_add_pull(ObjectHandle metrics, MetricsPullData* pull);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_finish(ObjectHandle metrics);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_get_report(ObjectHandle metrics, MetricsReport* report, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_get_throw(ObjectHandle metrics, uint index, MetricsThrow* record, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_get_phase(ObjectHandle metrics, uint index, MetricsPhase* phase, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_get_penalty(ObjectHandle metrics, uint index, MetricsPenalty* penalty, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_get_motion(ObjectHandle metrics, MetricsTool tool, int phase, MetricsMotion* motion, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_get_bimanual(ObjectHandle metrics, int phase, MetricsBimanual* bimanual, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_get_view(ObjectHandle metrics, MetricsField field, ViewData* view, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_get_offset(double* axis, double* centre, double* mark, double* place, double* angle, double* axial);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_save(ObjectHandle metrics, byte* bytes, ulong capacity, ulong* written);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_restore(ObjectHandle metrics, byte* bytes, ulong count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_metrics_get_hash(ObjectHandle metrics, ulong* hash);
    }
}
