// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_session_outcome.</summary>
    public enum SessionOutcome : int
    {
        /// <summary>There is no exercise, or it has not ended.</summary>
        None = 0,
        /// <summary>The goal is reached, and each measure is within its mark.</summary>
        Passed = 1,
        /// <summary>A measure misses its mark, or the goal was not reached.</summary>
        Failed = 2,
    }

    /// <summary>
    /// The constants of vbss_session_measure_kind. Each comment ends with the exercises and the
    /// pass mark.
    /// </summary>
    public enum SessionMeasureKind : int
    {
        /// <summary>
        /// Time of the exercise, s. All; TAKE_NEEDLE and CUT at most 60, PASS_MARK and throws at
        /// most 120. At this time the exercise ends.
        /// </summary>
        Time = 1,
        /// <summary>
        /// Where the needle is held, as a share of its length from the tip. TAKE_NEEDLE: 0.47 to
        /// 0.7; courses ask for half to two thirds.
        /// </summary>
        GraspShare = 2,
        /// <summary>
        /// Angle between the jaws that hold the needle and the normal of the needle's plane, rad.
        /// TAKE_NEEDLE: at most 30 degrees.
        /// </summary>
        GraspAngle = 3,
        /// <summary>Number of times that the needle was dropped. TAKE_NEEDLE: 0.</summary>
        Drops = 4,
        /// <summary>
        /// Distance of the first hole from its mark on the surface of the drain, m. PASS_MARK: at
        /// most 1 mm, the published accuracy of proficient trainees.
        /// </summary>
        Deviation = 5,
        /// <summary>
        /// Angle between the needle's tip and the normal of the wall as the first hole is made,
        /// rad. PASS_MARK: at most 30 degrees; courses ask for 0.
        /// </summary>
        EntryAngle = 6,
        /// <summary>Number of holes beside the stitch. PASS_MARK: 0.</summary>
        Strays = 7,
        /// <summary>Wraps of the throw. SINGLE_THROW and SQUARE_THROW: 1; DOUBLE_THROW: 2.</summary>
        Wraps = 8,
        /// <summary>
        /// 1: the throw is square to the one before; 0: it is not, or this is not known.
        /// SQUARE_THROW: 1.
        /// </summary>
        Square = 9,
        /// <summary>Largest gap along the slit at the outcome, m. Throws: at most 1 mm.</summary>
        Gap = 10,
        /// <summary>
        /// Largest tension of the thread during the exercise that lasts for the session's `dwell`
        /// of simulated time, N: the largest of the minima of successive intervals of that length.
        /// Throws: at most 6.1 N, the published maximum while experts tie on a drain.
        /// </summary>
        Tension = 11,
        /// <summary>Remaining length of the short tail, m. CUT: 2 to 8 mm; courses ask for 3 to 5 mm.</summary>
        ShortTail = 12,
        /// <summary>Remaining length of the needle's tail, m. CUT: 2 to 8 mm.</summary>
        LongTail = 13,
    }

    /// <summary>The exercise of a session and its outcome.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SessionExerciseState
    {
        internal uint StructSize;
        /// <summary>The exercise; NONE: the session runs the whole task.</summary>
        public SessionExercise Exercise;
        /// <summary>The outcome.</summary>
        public SessionOutcome Outcome;
        /// <summary>Number of measures; 0 without an exercise.</summary>
        public uint MeasureCount;
        /// <summary>Bit i: measure i is not known yet, or is outside its pass mark.</summary>
        public uint Missed;
        /// <summary>VBSS_SESSION_AID_ bits of the aids that were on; 0: the exercise was not assisted.</summary>
        public SessionAidBits AidsUsed;
        internal IntPtr Name;
        internal IntPtr Sentence;
        /// <summary>Time since the start, until the outcome or now, s.</summary>
        public double Time;
    }

    /// <summary>A measure of an exercise. It is met if it is known, and `low` &lt;= `value` &lt;= `high`.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SessionMeasure
    {
        internal uint StructSize;
        /// <summary>Kind of the measure, which says its unit.</summary>
        public SessionMeasureKind Kind;
        /// <summary>1: `value` is known; 0: not yet, and `value` is zero.</summary>
        public uint IsKnown;
        /// <summary>1: the value is known and within the pass mark.</summary>
        public uint IsMet;
        internal IntPtr Name;
        /// <summary>The value; its unit is that of the kind.</summary>
        public double Value;
        /// <summary>Smallest value that passes.</summary>
        public double Low;
        /// <summary>Largest value that passes.</summary>
        public double High;
    }
}
