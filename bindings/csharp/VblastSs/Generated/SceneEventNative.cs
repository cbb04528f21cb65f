// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_take_events(ObjectHandle scene, SceneEvent* events, uint structSize, uint capacity, uint* count, ulong* lost);
    }
}
