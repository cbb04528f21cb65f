// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>
    /// The constants of vbss_session_goal. "The hand" is vbss_session_coaching.tool. Each comment
    /// says which geometry is given, and which numbers become zero when the goal is met.
    /// </summary>
    public enum SessionGoal : int
    {
        /// <summary>There is no goal: before the first step, or after the end.</summary>
        None = 0,
        /// <summary>
        /// The hand takes the needle. POINT: on the needle; DIRECTION: of the jaws. `distance` of
        /// the tool's tip from the point; `angle` between jaws and direction.
        /// </summary>
        TakeNeedle = 1,
        /// <summary>
        /// The hand brings the needle's tip to mark `number` (0 left, 1 right). POINT: the mark;
        /// DIRECTION: into the wall. `distance` of the tip from the mark; `angle` between tip and
        /// direction.
        /// </summary>
        ReachMark = 2,
        /// <summary>
        /// The hand pushes the tip through the wall at mark `number`. Geometry and numbers as for
        /// REACH_MARK, and ARC: the needle's own arc.
        /// </summary>
        Pierce = 3,
        /// <summary>
        /// The hand turns the needle along its own arc to mark `number`. POINT: the mark; ARC: from
        /// the tip to beside the mark. `angle` of the arc; `distance` of the tip from the mark;
        /// `offset`: how far the arc misses the mark.
        /// </summary>
        Drive = 4,
        /// <summary>
        /// The tip is out: the hand turns the needle on until it can be taken there. ARC; `length`
        /// that must still come out.
        /// </summary>
        ExposeTip = 5,
        /// <summary>
        /// The hand takes the needle beyond the second hole. POINT, DIRECTION, `distance` and
        /// `angle` as for TAKE_NEEDLE.
        /// </summary>
        TakeTip = 6,
        /// <summary>
        /// The hand opens its jaws and releases the needle, which the other one holds. POINT: the
        /// tool's tip.
        /// </summary>
        ReleaseNeedle = 7,
        /// <summary>
        /// The hand turns the needle out of the drain along its arc. ARC; `length` of needle that
        /// is still in front of the second hole.
        /// </summary>
        DrawNeedle = 8,
        /// <summary>
        /// The hand draws the thread through. POINT: the second hole; DIRECTION: to pull; `length`
        /// of tail beyond `tail_high`.
        /// </summary>
        DrawThread = 9,
        /// <summary>
        /// The tail is too short: the hand draws it back. POINT: on the tail, beside the first
        /// hole; DIRECTION: to pull; `length` that is missing; `distance` of the tool's tip from
        /// the point.
        /// </summary>
        LengthenTail = 10,
        /// <summary>
        /// The hand winds the needle's limb round the other tool for throw `number` (0, 1, 2).
        /// POINT: where the other tool's tip shall be, over the drain at rest; DIRECTION: in which
        /// its jaws shall point; ARC: about its jaws, `arc_angle` with the turns that are missing;
        /// `turns` that are missing; `distance` of the other tool's tip from the point, which need
        /// not become zero.
        /// </summary>
        Wind = 11,
        /// <summary>
        /// The hand, with the turns on its jaws, takes the tail near its end. POINT: on the tail;
        /// DIRECTION: along the tail, from its end. `distance` of the tool's tip from the point.
        /// </summary>
        TakeTail = 12,
        /// <summary>The hand opens its jaws and releases the thread. POINT: the tool's tip.</summary>
        ReleaseTail = 13,
        /// <summary>
        /// The hand draws the tail through the turns. POINT: the slit; DIRECTION: to pull; ARC:
        /// from the tool's tip over the slit down to its own side, where the arc is no longer
        /// given; `turns` that are still on its jaws.
        /// </summary>
        DrawTail = 14,
        /// <summary>
        /// Both hands pull throw `number` down, the hand in DIRECTION and the other one opposite,
        /// each with `pull_force`. If the slit is open under a second or third throw that hangs
        /// loose, DIRECTION is to the other hand's side: from there the throw draws the one below
        /// tight. POINT: the slit; `force` that the weaker end misses to that; `length`: gap of the
        /// slit beyond `seat_gap`.
        /// </summary>
        Seat = 15,
        /// <summary>
        /// The hand takes the needle from the other one after throw `number`. POINT, DIRECTION,
        /// `distance` and `angle` as for TAKE_NEEDLE.
        /// </summary>
        HandOver = 16,
        /// <summary>The hand exchanges its tool for shears.</summary>
        TakeShears = 17,
        /// <summary>
        /// The hand cuts tail `number` (0: the short one, 1: the needle's). POINT: where to cut;
        /// DIRECTION: along the tail, from the knot. `distance` of the shears' tip from the point.
        /// </summary>
        Cut = 18,
    }

    /// <summary>
    /// The constants of vbss_session_mistake. "Ends" gives the condition under which a mistake
    /// ends.
    /// </summary>
    public enum SessionMistake : int
    {
        /// <summary>There is no mistake.</summary>
        None = 0,
        /// <summary>No hand holds the needle, and it is in no wall. Ends: a hand holds it.</summary>
        NeedleDropped = 1,
        /// <summary>The first hole is more than 1 mm from its mark. Ends: the needle leaves the hole.</summary>
        EntryMissed = 2,
        /// <summary>The second hole is more than 1 mm from its mark. Ends: the needle leaves the hole.</summary>
        ExitMissed = 3,
        /// <summary>A wall is pierced beside the stitch. Ends: that hole is empty.</summary>
        StrayHole = 4,
        /// <summary>The needle was drawn back out of the first hole. Ends: it is pierced again.</summary>
        NeedleWithdrawn = 5,
        /// <summary>The thread was pulled out of the stitch. Ends: the needle is in a wall again.</summary>
        ThreadPulledOut = 6,
        /// <summary>The tail is shorter than `tail_low`. Ends: it is longer, or a throw is begun.</summary>
        TailShort = 7,
        /// <summary>The first throw was begun with a tail longer than `tail_high`. Ends: the turns are off.</summary>
        TailLong = 8,
        /// <summary>The turns progress towards the handle and tie nothing. Ends: they no longer do.</summary>
        TowardHandle = 9,
        /// <summary>The limb is wound in the sense of the throw before: a granny. Ends: it is unwound.</summary>
        WrongSense = 10,
        /// <summary>
        /// Turns came off the jaws before the tail was taken, but for those that had to be unwound.
        /// Ends: they are wound again.
        /// </summary>
        TurnsLost = 11,
        /// <summary>
        /// The tail was taken with too few turns on the jaws. Ends: it is released, or tied all the
        /// same.
        /// </summary>
        TooFewTurns = 12,
        /// <summary>
        /// The tail is held too far from its end, and a bight of it would be drawn through. Ends:
        /// it is released, or held near its end.
        /// </summary>
        Bight = 13,
        /// <summary>
        /// The tail was dropped before the throw was tied. Ends: it is held again, or the turns are
        /// off.
        /// </summary>
        TailDropped = 14,
        /// <summary>A tied throw came undone. Ends: as many throws are tied again.</summary>
        ThrowUndone = 15,
        /// <summary>A throw is tied in the sense of the one before. Ends: it comes undone.</summary>
        Granny = 16,
        /// <summary>The first throw is tied with one wrap. Ends: it comes undone.</summary>
        TooFewWraps = 17,
        /// <summary>A throw is tied with more wraps than it needs. Ends: it comes undone.</summary>
        TooManyWraps = 18,
        /// <summary>There is a knot in one limb alone. Ends: it is open.</summary>
        StrayKnot = 19,
        /// <summary>
        /// The first throw, while it is alone, has capsized into a half hitch, which slides. Ends:
        /// it is flat again.
        /// </summary>
        Capsized = 20,
        /// <summary>
        /// One end of an unseated throw is pulled and the other is not, or gives way, so that the
        /// tail of the first throw becomes 15 mm longer than `tail_high`. Ends: both or neither
        /// are, or the throw is seated.
        /// </summary>
        OneSided = 21,
        /// <summary>
        /// A throw has been tied for 5 s, and both of its ends are slack. Ends: both ends are
        /// tense, or the throw is seated.
        /// </summary>
        Slack = 22,
        /// <summary>
        /// The slit has opened under a seated throw. Ends: the throw is seated, or the next one is
        /// tied on it.
        /// </summary>
        SlitOpened = 23,
        /// <summary>The walls of the slit have slipped past each other. Ends: they meet again.</summary>
        WallsCrossed = 24,
        /// <summary>An anchor of the drain bears more than 0.8 of its strength. Ends: it bears less.</summary>
        DrainTearing = 25,
        /// <summary>The tension of the thread exceeds 6 N. Ends: it falls below.</summary>
        PulledHard = 26,
        /// <summary>A throw is tied, and the needle has not changed hands before. Ends: it comes undone.</summary>
        TransferMissed = 27,
        /// <summary>The time limit has passed. Does not end.</summary>
        TimeUp = 28,
        /// <summary>The drain is torn off. Does not end.</summary>
        DrainTorn = 29,
        /// <summary>Cut before the third throw. Does not end.</summary>
        CutEarly = 30,
        /// <summary>Cut in the knot or stitch. Does not end.</summary>
        CutKnot = 31,
        /// <summary>The thread has broken. Does not end.</summary>
        ThreadBroken = 32,
        /// <summary>One more than the largest mistake.</summary>
        Count = 33,
    }

    /// <summary>Bits for the geometry that a goal has.</summary>
    [Flags]
    public enum SessionGeometryBits : uint
    {
        /// <summary>`point` is given.</summary>
        Point = 1,
        /// <summary>`direction` is given.</summary>
        Direction = 2,
        /// <summary>The fields `arc_` are given.</summary>
        Arc = 4,
        /// <summary>`pull_force` is given; the pull is along `direction`.</summary>
        Pull = 8,
    }

    /// <summary>Goal and mistakes of a session that coaches. A number that the goal does not use is zero.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SessionCoaching
    {
        internal uint StructSize;
        /// <summary>The next goal.</summary>
        public SessionGoal Goal;
        /// <summary>The hand that acts; NONE: no goal, or the session's third tool.</summary>
        public MetricsTool Tool;
        /// <summary>Mark, throw or tail of the goal, as its comment says; otherwise 0.</summary>
        public uint Number;
        internal IntPtr Sentence;
        /// <summary>
        /// The newest mistake that has not ended. One that cannot be mended is given for 5 s, those
        /// of a failure for good.
        /// </summary>
        public SessionMistake Mistake;
        /// <summary>1: the mistake can still be mended.</summary>
        public uint IsMendable;
        internal IntPtr MistakeSentence;
        internal IntPtr Remedy;
        /// <summary>Bit m: mistake m has not ended.</summary>
        public ulong Mistakes;
        /// <summary>VBSS_SESSION_GEOMETRY_ bits of the fields below.</summary>
        public SessionGeometryBits Geometry;
        internal uint Reserved;
        /// <summary>Where to go or to pull from, m.</summary>
        public Vector3d Point;
        /// <summary>Unit vector.</summary>
        public Vector3d Direction;
        /// <summary>Centre of the arc or circle to follow, m.</summary>
        public Vector3d ArcCentre;
        /// <summary>Unit axis; the arc goes about it by the right-hand rule.</summary>
        public Vector3d ArcAxis;
        /// <summary>Where the arc starts, m.</summary>
        public Vector3d ArcStart;
        /// <summary>Radius of the arc, m.</summary>
        public double ArcRadius;
        /// <summary>Angle that is left, rad, 0 or more; several turns for a winding.</summary>
        public double ArcAngle;
        /// <summary>Force to pull with at each end, N.</summary>
        public double PullForce;
        /// <summary>Distance to go, m.</summary>
        public double Distance;
        /// <summary>Angle to turn by, rad.</summary>
        public double Angle;
        /// <summary>DRIVE: distance by which the arc misses the mark, m.</summary>
        public double Offset;
        /// <summary>Turns that are missing, or that must come off.</summary>
        public double Turns;
        /// <summary>Force that is missing, N.</summary>
        public double Force;
        /// <summary>Length or gap that is missing, m.</summary>
        public double Length;
        /// <summary>Time since the goal began, s.</summary>
        public double GoalTime;
        /// <summary>Session time at which `mistake` was seen, s.</summary>
        public double MistakeTime;
    }
}
