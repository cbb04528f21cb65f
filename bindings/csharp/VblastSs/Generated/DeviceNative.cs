// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_calibration_init(DeviceCalibrationData* calibration, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_config_init(DeviceConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_create(ObjectHandle context, DeviceAdapterData* first, DeviceAdapterData* second, DeviceConfigData* config, out IntPtr device);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_destroy(IntPtr device);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_read(ObjectHandle device, double now, DeviceInput* input, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_write(ObjectHandle device, double now, OutputCommandData* command, OutputResult* result, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_write_coupled(ObjectHandle device, double now, OutputCommandData* command, DeviceCouplingData* coupling, OutputResult* result, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_latch_emergency_stop(ObjectHandle device);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_clear_emergency_stop(ObjectHandle device);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_set_clutch(ObjectHandle device, int held);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_recentre(ObjectHandle device, double* position, double* orientation);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_hold_jaw(ObjectHandle device, double opening);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_set_calibration(ObjectHandle device, DeviceCalibrationData* calibration);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_get_capabilities(ObjectHandle device, uint which, DeviceCapabilitiesData* capabilities, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_get_error(ObjectHandle device, uint which, Result* result, byte** text);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_get_statistics(ObjectHandle device, DeviceStatistics* statistics, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_get_output_statistics(ObjectHandle device, OutputStatistics* statistics, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_save(ObjectHandle device, byte* bytes, ulong capacity, ulong* written);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_restore(ObjectHandle device, byte* bytes, ulong count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_device_get_hash(ObjectHandle device, ulong* hash);
    }
}
