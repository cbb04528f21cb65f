// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mapping_config_init(MappingConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mapping_mouse(MappingConfigData* config, double* motion, uint buttons, double h, DeviceSampleData* sample);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mapping_keyboard(MappingConfigData* config, double* presses, double h, DeviceSampleData* sample);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_mapping_gamepad(MappingConfigData* config, double* axes, double opening, double h, DeviceSampleData* sample);
    }
}
