// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mock_config_init(MockConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mock_create(ObjectHandle context, MockConfigData* config, out IntPtr mock);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mock_destroy(IntPtr mock);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mock_get_adapter(ObjectHandle mock, DeviceAdapterData* adapter);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mock_set_sample(ObjectHandle mock, DeviceSampleData* sample);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mock_add_fault(ObjectHandle mock, MockFault fault, double from, double until, double value);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mock_clear_faults(ObjectHandle mock);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mock_clear_rows(ObjectHandle mock);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mock_get_view(ObjectHandle mock, MockField field, ViewData* view, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mock_get_statistics(ObjectHandle mock, MockStatistics* statistics, uint structSize);
    }
}
