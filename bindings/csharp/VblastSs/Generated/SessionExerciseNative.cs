// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_session_begin_at(ObjectHandle session, byte* bytes, ulong count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_session_get_exercise(ObjectHandle session, SessionExerciseState* state, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_session_get_measure(ObjectHandle session, uint index, SessionMeasure* measure, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr vbss_session_exercise_name(SessionExercise exercise);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr vbss_session_exercise_string(SessionExercise exercise);
    }
}
