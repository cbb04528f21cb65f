// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern double vbss_sin(double angle);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern double vbss_cos(double angle);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern double vbss_atan2(double y, double x);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern double vbss_acos(double cosine);
    }
}
