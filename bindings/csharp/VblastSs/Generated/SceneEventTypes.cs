// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_scene_event_kind.</summary>
    public enum SceneEventKind : int
    {
        /// <summary>Two bodies have come into contact, or a body with itself.</summary>
        Touch = 1,
        /// <summary>Two bodies in contact have separated.</summary>
        Part = 2,
        /// <summary>
        /// A part of a step was truncated: the bodies moved as far as the guard allows, and the
        /// rest of the part was left out (vbss_scene_statistics::clamped). The two bodies are those
        /// that the guard found; 0: unknown, or the floor.
        /// </summary>
        Truncated = 3,
        /// <summary>Jaws have grasped a thread, a needle or a drain.</summary>
        Grasp = 5,
        /// <summary>Jaws have opened and released a body.</summary>
        Release = 6,
        /// <summary>A body was pulled out of the jaws. The value is the force of the jaws on it.</summary>
        Torn = 7,
        /// <summary>
        /// A body begins to slide through the jaws, or to turn in them. The value is the force of
        /// the jaws on it.
        /// </summary>
        Slip = 8,
        /// <summary>A grasp exceeded grasp_capacity, so the thread is not held.</summary>
        GraspLost = 9,
        /// <summary>A thread was cut. The piece is 0 if the thread had no cuts left and stayed whole.</summary>
        Cut = 10,
        /// <summary>
        /// An instrument was exchanged. The id is its new vbss_grasper_kind; the position is that
        /// of the grasper's frame.
        /// </summary>
        Exchanged = 11,
        /// <summary>An instrument was not exchanged. The id is the wanted vbss_grasper_kind.</summary>
        NotExchanged = 12,
        /// <summary>
        /// A needle's tip has entered a wall (VBLAST: has gone through it). The value is the force
        /// of the wall along the tip; 0 with method VBLAST, and where a fold of the wall came onto
        /// the needle.
        /// </summary>
        Puncture = 13,
        /// <summary>The tip has left the hole backwards.</summary>
        Withdrawn = 14,
        /// <summary>The needle and its swage have passed through the hole, and the thread follows.</summary>
        Passed = 15,
        /// <summary>A hole exceeded hole_capacity, so the wall is not pierced.</summary>
        HoleLost = 16,
        /// <summary>The swage has come back through the hole, and the needle is in it again.</summary>
        Returned = 17,
        /// <summary>An end of a thread has left the hole.</summary>
        Unthreaded = 18,
        /// <summary>
        /// Two bodies hold each other back: both bodies of vbss_scene_blocker, its cause. Reported
        /// once until they have moved freely again.
        /// </summary>
        Blocked = 19,
        /// <summary>Two bodies have moved freely for 0.1 s after BLOCKED.</summary>
        Unblocked = 20,
        /// <summary>
        /// The rest of a step was left out for the bodies that did not come to its end, or a whole
        /// step because too many waited (vbss_scene_statistics::paused). The two bodies are those
        /// that hold each other back; 0: unknown, or the floor. Several groups of bodies of a step
        /// may each have such an event; vbss_scene_statistics::time_paused counts the longest.
        /// </summary>
        Paused = 21,
        /// <summary>
        /// More steps than after the call before are suspended or have not begun: work waits for a
        /// later call, and no time is left out (vbss_scene_statistics::behind, and
        /// `call_budget_us`).
        /// </summary>
        Deferred = 22,
        /// <summary>No step waits any more after DEFERRED.</summary>
        CaughtUp = 23,
        /// <summary>
        /// A step that two calls had suspended was completed without the budget of a call, because
        /// other bodies waited (vbss_scene_statistics::overdue). This call took longer than it
        /// should.
        /// </summary>
        Overdue = 24,
        /// <summary>
        /// A thread begins to tear the wall at its hole (vbss_drain_config::tear_energy). Reported
        /// again after the force has fallen below half of the one that tears.
        /// </summary>
        Tearing = 25,
        /// <summary>
        /// A thread has torn out: it has cut through the wall up to a free edge and left it there,
        /// and the hole is gone.
        /// </summary>
        TornOut = 26,
    }

    /// <summary>Bits of `flags` of an event.</summary>
    [Flags]
    public enum SceneEventFlagBits : uint
    {
        /// <summary>The event has a position.</summary>
        Position = 1,
    }

    /// <summary>
    /// An event of a scene. vbss_scene_event_kind says which fields a kind uses. All numbers are
    /// finite.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneEvent
    {
        internal uint StructSize;
        /// <summary>Kind of the event.</summary>
        public SceneEventKind Kind;
        /// <summary>Number of the first body; 0: the floor, or none.</summary>
        public uint BodyA;
        /// <summary>Number of the second body; 0: the floor, or none.</summary>
        public uint BodyB;
        /// <summary>Identifier, as the kind says; 0: none.</summary>
        public uint Id;
        /// <summary>VBSS_SCENE_EVENT_FLAG_ bits.</summary>
        public SceneEventFlagBits Flags;
        /// <summary>
        /// vbss_scene_statistics::steps after the call of vbss_scene_step that reported the event.
        /// An event between two steps has the number of the step before.
        /// </summary>
        public ulong Step;
        /// <summary>vbss_scene_statistics::time after that call, s.</summary>
        public double Time;
        /// <summary>Value, in the unit of the kind; 0: the kind has none.</summary>
        public double Value;
        /// <summary>Arc length along a thread or needle, m; 0: the kind has none.</summary>
        public double ArcLength;
        /// <summary>Position in the world, m; zero without VBSS_SCENE_EVENT_FLAG_POSITION.</summary>
        public Vector3d Position;
    }
}
