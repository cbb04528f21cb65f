using System;

namespace VblastSs
{
    public sealed unsafe partial class Session
    {
        /// <summary>
        /// Begins the task at the place that another session had reached: the facts of its saved state stay, and all else
        /// begins. Restore the scene first; the session has made no step and has no record yet. A failed call changes nothing.
        /// </summary>
        public void BeginAt(ReadOnlySpan<byte> state)
        {
            fixed (byte* bytes = state)
            {
                Context.Check(Native.vbss_session_begin_at(Handle, bytes, (ulong)state.Length));
            }
        }
    }
}
