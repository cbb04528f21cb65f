// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_openhaptics_config_init(OpenhapticsConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_openhaptics_create(ObjectHandle context, OpenhapticsConfigData* config, out IntPtr openhaptics);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_openhaptics_destroy(IntPtr openhaptics);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_openhaptics_get_adapter(ObjectHandle openhaptics, uint which, DeviceAdapterData* adapter);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_openhaptics_get_status(ObjectHandle openhaptics, uint which, OpenhapticsStatus* status, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_openhaptics_get_identity(ObjectHandle openhaptics, uint which, byte** model, byte** serial);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_nidaqmx_config_init(NidaqmxConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_nidaqmx_create(ObjectHandle context, NidaqmxConfigData* config, out IntPtr nidaqmx);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_nidaqmx_destroy(IntPtr nidaqmx);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_nidaqmx_get_adapter(ObjectHandle nidaqmx, uint which, DeviceAdapterData* adapter);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_nidaqmx_poll(ObjectHandle nidaqmx, double now);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_nidaqmx_get_status(ObjectHandle nidaqmx, NidaqmxStatus* status, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_nidaqmx_list_devices(ObjectHandle context, byte* library, byte* text, uint bytes);
    }
}
