// Written by bindings/csharp/generate.py from the public headers: do not edit.
namespace VblastSs
{
    /// <summary>A run of the suturing task on a scene.</summary>
    public sealed unsafe partial class Session : VbssObject
    {
        /// <summary>
        /// Returns the coach's goal with its geometry, and the newest mistake, for the state after
        /// the last step. The call computes the geometry from the scene. It changes nothing and
        /// allocates nothing.
        /// </summary>
        public SessionCoaching GetCoaching()
        {
            SessionCoaching coaching;
            Context.Check(Native.vbss_session_get_coaching(Handle, &coaching, (uint)sizeof(SessionCoaching)));
            return coaching;
        }

        /// <summary>Returns a mistake as an English sentence, for example to list the events of a session.</summary>
        /// <param name="mistake">the mistake</param>
        public static string MistakeString(SessionMistake mistake)
        {
            return Vblast.Text(Native.vbss_session_mistake_string(mistake));
        }

        /// <summary>Returns how to mend a mistake, or how to go on after it, as an English sentence.</summary>
        /// <param name="mistake">the mistake</param>
        public static string RemedyString(SessionMistake mistake)
        {
            return Vblast.Text(Native.vbss_session_remedy_string(mistake));
        }
    }
}
