// Written by bindings/csharp/generate.py from the public headers: do not edit.
namespace VblastSs
{
    /// <summary>A run of the suturing task on a scene.</summary>
    public sealed unsafe partial class Session : VbssObject
    {
        /// <summary>Switches aids on and off, from the next step on.</summary>
        /// <param name="assistance">the aids and their settings; NULL switches all aids off and keeps the settings</param>
        public void SetAssistance(SessionAssistance assistance)
        {
            using (Pins pins = Pins.Rent())
            {
                Context.Check(Native.vbss_session_set_assistance(Handle, assistance == null ? null : assistance.Pin(pins)));
            }
        }

        /// <summary>
        /// Returns the assistance that was set. In a replay, the aids are those of the log, and the
        /// settings are the defaults.
        /// </summary>
        public SessionAssistance GetAssistance()
        {
            using (Pins pins = Pins.Rent())
            {
                var assistance = new SessionAssistance();
                Context.Check(Native.vbss_session_get_assistance(Handle, assistance == null ? null : assistance.Pin(pins), (uint)sizeof(SessionAssistanceData)));
                return assistance;
            }
        }

        /// <summary>
        /// Passes the input of a hand for the next step, which moves its tool there as the aids
        /// permit. Without a call before a step the tool keeps its target. A device of the hand
        /// takes precedence. The call allocates nothing.
        /// </summary>
        /// <param name="tool">VBSS_METRICS_TOOL_LEFT or VBSS_METRICS_TOOL_RIGHT</param>
        /// <param name="hand">the input of the hand</param>
        public void MoveHand(MetricsTool tool, SessionHand hand)
        {
            using (Pins pins = Pins.Rent())
            {
                Context.Check(Native.vbss_session_move_hand(Handle, tool, hand == null ? null : hand.Pin(pins)));
            }
        }
    }
}
