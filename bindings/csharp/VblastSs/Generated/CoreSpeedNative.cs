// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_core_speed_measure(ObjectHandle context, IntPtr clock, IntPtr user, CoreSpeed* speed, uint structSize);
    }
}
