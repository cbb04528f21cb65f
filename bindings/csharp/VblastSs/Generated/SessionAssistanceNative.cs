// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_session_assistance_init(SessionAssistanceData* assistance, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_session_hand_init(SessionHandData* hand, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_session_set_assistance(ObjectHandle session, SessionAssistanceData* assistance);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_session_get_assistance(ObjectHandle session, SessionAssistanceData* assistance, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_session_move_hand(ObjectHandle session, MetricsTool tool, SessionHandData* hand);
    }
}
