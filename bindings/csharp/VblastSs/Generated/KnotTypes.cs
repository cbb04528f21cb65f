// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_knot_method.</summary>
    public enum KnotMethod : int
    {
        /// <summary>Winding numbers, and the topology of the closed thread.</summary>
        Topology = 0,
        /// <summary>Loops in a projection, as in the paper.</summary>
        Projection = 1,
    }

    /// <summary>The constants of vbss_knot_held.</summary>
    public enum KnotHeld : int
    {
        /// <summary>The jaws are empty.</summary>
        Nothing = 0,
        /// <summary>The jaws hold the thread at a place.</summary>
        Thread = 1,
        /// <summary>The jaws hold the needle, which is at the last point of the polyline.</summary>
        Needle = 2,
    }

    /// <summary>The constants of vbss_knot_verdict.</summary>
    public enum KnotVerdict : int
    {
        /// <summary>There is no throw.</summary>
        None = 0,
        /// <summary>The thread winds round a tool.</summary>
        Wrapping = 1,
        /// <summary>The throw is tied if the tools withdraw with their load.</summary>
        Passed = 2,
        /// <summary>The ends have passed through; invariants agree.</summary>
        Formed = 3,
        /// <summary>The type is proved, the ends are clear, the order is known.</summary>
        Certified = 4,
        /// <summary>The verdict is uncertain; `reason` says why.</summary>
        Uncertain = 5,
    }

    /// <summary>The constants of vbss_knot_reason.</summary>
    public enum KnotReason : int
    {
        /// <summary>The reading is certain.</summary>
        None = 0,
        /// <summary>Closures differ: an end lies inside the knot.</summary>
        Ends = 1,
        /// <summary>The thread touches itself in every projection.</summary>
        Degenerate = 2,
        /// <summary>
        /// The diagram has more crossings than the detector's capacity, or is too wide for the
        /// Jones polynomial that must confirm the result.
        /// </summary>
        Capacity = 3,
        /// <summary>Twist regions and invariants differ.</summary>
        Conflict = 4,
    }

    /// <summary>
    /// The constants of vbss_knot_name. Numbers are the wraps of the throws. After "=" the next
    /// throw has the opposite handedness, after "x" the same one.
    /// </summary>
    public enum KnotName : int
    {
        /// <summary>There is no knot.</summary>
        None = 0,
        /// <summary>One throw of one wrap: 3_1.</summary>
        Single = 1,
        /// <summary>One throw of two wraps, the surgeon's first: 5_1.</summary>
        Double = 2,
        /// <summary>One throw of three wraps: 7_1.</summary>
        Triple = 3,
        /// <summary>Square knot, 1=1.</summary>
        Square = 4,
        /// <summary>Granny knot, 1x1.</summary>
        Granny = 5,
        /// <summary>Surgeon's knot, 2=1.</summary>
        Surgeons = 6,
        /// <summary>Granny form of the surgeon's knot, 2x1.</summary>
        SurgeonsGranny = 7,
        /// <summary>The FLS knot, 2=1=1.</summary>
        Fls = 8,
        /// <summary>Another stack of throws; see vbss_knot_detector_get_notation.</summary>
        Stack = 9,
        /// <summary>A knot that is not a stack of throws.</summary>
        Other = 10,
    }

    /// <summary>Bits for the differences of a knot from the FLS knot 2=1=1.</summary>
    [Flags]
    public enum KnotFaultBits : uint
    {
        /// <summary>The first throw does not have two wraps.</summary>
        First = 1,
        /// <summary>A later throw does not have one wrap.</summary>
        Later = 2,
        /// <summary>There are fewer than three throws.</summary>
        Few = 4,
        /// <summary>There are more than three throws.</summary>
        Many = 8,
        /// <summary>A throw has the same handedness as the one before.</summary>
        Granny = 16,
        /// <summary>There is a knot in one limb alone.</summary>
        Stray = 32,
        /// <summary>A throw has turned into a half hitch, which slides.</summary>
        Hitch = 64,
        /// <summary>The order of the throws is not known.</summary>
        Order = 128,
        /// <summary>The knot is not a stack of throws.</summary>
        Type = 256,
        /// <summary>The reading is uncertain.</summary>
        Uncertain = 512,
    }

    /// <summary>Bits of the flags of a throw.</summary>
    [Flags]
    public enum KnotThrowBits : uint
    {
        /// <summary>Its places on the limbs are known.</summary>
        Located = 1,
        /// <summary>
        /// Its position in the stack is known: sub-chains show it. In vbss_knot_detector_step it is
        /// also known if an earlier reading had the throws in this order and at most one was added.
        /// </summary>
        Ordered = 2,
        /// <summary>The throw has the same handedness as the throw before.</summary>
        Granny = 4,
        /// <summary>The throw lies in one limb alone and not round the other limb.</summary>
        Stray = 8,
        /// <summary>|slip| is at least `slip_limit`.</summary>
        Hitch = 16,
        /// <summary>The tail is shorter than tail_least, or the throw is undone if the tools withdraw.</summary>
        Revocable = 32,
    }

    /// <summary>
    /// The constants of vbss_knot_event. In the view three numbers follow each event; each comment
    /// lists them after its colon.
    /// </summary>
    public enum KnotEvent : int
    {
        /// <summary>The thread winds round a tool: tool, 1 + (turns &gt; 0), 0.</summary>
        Wrapped = 1,
        /// <summary>The thread no longer winds round a tool: tool, 0, 0.</summary>
        Unwrapped = 2,
        /// <summary>The thread winds towards the handle: tool, 0, 0.</summary>
        WrongDirection = 3,
        /// <summary>A throw is tied as soon as the tools withdraw: tool, wraps, 1 + (right-handed).</summary>
        Passed = 4,
        /// <summary>A throw is formed: its number from 0, wraps, 1 + (right-handed).</summary>
        Formed = 5,
        /// <summary>A throw is certified: its number from 0, wraps, 1 + (right-handed).</summary>
        Certified = 6,
        /// <summary>A throw is gone or uncertain: number, wraps, 1 + (right-handed).</summary>
        Revoked = 7,
        /// <summary>A knot lies in one limb: number, wraps, 1 + (right-handed).</summary>
        Stray = 8,
        /// <summary>The reading is uncertain: vbss_knot_reason, 0, 0.</summary>
        Uncertain = 9,
        /// <summary>A reading of the topology has ended: throws, name, verdict.</summary>
        Read = 10,
        /// <summary>Events exceeded the capacity: number of lost events, 0, 0.</summary>
        Lost = 11,
    }

    /// <summary>The constants of vbss_knot_field.</summary>
    public enum KnotField : int
    {
        /// <summary>x 4 uint32_t: vbss_knot_event and its three numbers, of the last step.</summary>
        Events = 0,
        /// <summary>
        /// PROJECTION, x 4 uint32_t: tool, the two segments of the intersecting pair, 1 if the tool
        /// is inside; all loops of the last step.
        /// </summary>
        Loops = 1,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct KnotDetectorConfigData
    {
        internal uint StructSize;
        internal KnotMethod Method;
        internal uint PointCapacity;
        internal uint ToolCapacity;
        internal uint CrossingCapacity;
        internal uint DirectionLimit;
        internal uint ClosureCount;
        internal uint ClosureTolerance;
        internal uint StepBudget;
        internal uint Interval;
        internal uint EventCapacity;
        internal uint Reserved;
        internal double TailReach;
        internal double TailLeast;
        internal double WrapTurns;
        internal double SlipLimit;
        internal double PlaneOffset;
        internal ulong Seed;
    }

    /// <summary>
    /// Configuration of a detector. Fill it with vbss_knot_detector_config_init, then change
    /// fields.
    /// </summary>
    public sealed unsafe partial class KnotDetectorConfig
    {
        private readonly KnotDetectorConfigData[] box = new KnotDetectorConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public KnotDetectorConfig()
        {
            fixed (KnotDetectorConfigData* data = box)
            {
                Vblast.Check(Native.vbss_knot_detector_config_init(data, (uint)sizeof(KnotDetectorConfigData)));
            }
        }

        /// <summary>Method; default VBSS_KNOT_METHOD_TOPOLOGY.</summary>
        public KnotMethod Method
        {
            get { return box[0].Method; }
            set { box[0].Method = value; }
        }

        /// <summary>Largest number of points of the polyline, 2 to 8192; default 1024.</summary>
        public uint PointCapacity
        {
            get { return box[0].PointCapacity; }
            set { box[0].PointCapacity = value; }
        }

        /// <summary>Largest number of tools, 0 to 16; default 4.</summary>
        public uint ToolCapacity
        {
            get { return box[0].ToolCapacity; }
            set { box[0].ToolCapacity = value; }
        }

        /// <summary>
        /// Largest number of crossings of a diagram before it is simplified, 8 to 2048; default
        /// 512. A quarter as many may remain afterwards.
        /// </summary>
        public uint CrossingCapacity
        {
            get { return box[0].CrossingCapacity; }
            set { box[0].CrossingCapacity = value; }
        }

        /// <summary>Largest number of directions of projection to try, 1 to 64; default 6.</summary>
        public uint DirectionLimit
        {
            get { return box[0].DirectionLimit; }
            set { box[0].DirectionLimit = value; }
        }

        /// <summary>
        /// Number of directions in which the ends are closed besides straight outward, 0 to 16;
        /// default 8.
        /// </summary>
        public uint ClosureCount
        {
            get { return box[0].ClosureCount; }
            set { box[0].ClosureCount = value; }
        }

        /// <summary>
        /// Largest number of these closures that may contradict the outward closure, 0 to 16;
        /// default 2. With more an end lies inside the knot, and the verdict is uncertain.
        /// </summary>
        public uint ClosureTolerance
        {
            get { return box[0].ClosureTolerance; }
            set { box[0].ClosureTolerance = value; }
        }

        /// <summary>
        /// TOPOLOGY: largest number of operations (about a nanosecond each) in a step, exceeded at
        /// most by the last indivisible operation, 100 to 1e9; default 8000.
        /// </summary>
        public uint StepBudget
        {
            get { return box[0].StepBudget; }
            set { box[0].StepBudget = value; }
        }

        /// <summary>
        /// TOPOLOGY: number of steps from the start of a reading to the start of the next one, if
        /// the first has ended; 0: read at events only; default 20.
        /// </summary>
        public uint Interval
        {
            get { return box[0].Interval; }
            set { box[0].Interval = value; }
        }

        /// <summary>Largest number of events of a step that are kept, 8 to 4096; default 64.</summary>
        public uint EventCapacity
        {
            get { return box[0].EventCapacity; }
            set { box[0].EventCapacity = value; }
        }

        /// <summary>
        /// Largest length beyond the jaws with which the thread counts as held near its end, m, 0
        /// to 1; default 0.03. A longer one is a bight.
        /// </summary>
        public double TailReach
        {
            get { return box[0].TailReach; }
            set { box[0].TailReach = value; }
        }

        /// <summary>Length below which a tail can slip back and undo its throw, m, 0 to 1; default 0.003.</summary>
        public double TailLeast
        {
            get { return box[0].TailLeast; }
            set { box[0].TailLeast = value; }
        }

        /// <summary>
        /// Signed turns about a tool from which the thread is wrapped round it, 0.1 to 2; default
        /// 0.75. The wrap ends a quarter of a turn lower.
        /// </summary>
        public double WrapTurns
        {
            get { return box[0].WrapTurns; }
            set { box[0].WrapTurns = value; }
        }

        /// <summary>Magnitude of a throw's slip measure from which it is a half hitch, 0 to 1; default 0.45.</summary>
        public double SlipLimit
        {
            get { return box[0].SlipLimit; }
            set { box[0].SlipLimit = value; }
        }

        /// <summary>
        /// PROJECTION: position of the plane on the tool's axis, m from the tip towards the handle,
        /// -1 to 1; default -0.002, ahead of the tip.
        /// </summary>
        public double PlaneOffset
        {
            get { return box[0].PlaneOffset; }
            set { box[0].PlaneOffset = value; }
        }

        /// <summary>PROJECTION: seed of the directions of its rays; default 1.</summary>
        public ulong Seed
        {
            get { return box[0].Seed; }
            set { box[0].Seed = value; }
        }

        internal KnotDetectorConfigData* Pin(Pins pins)
        {
            return (KnotDetectorConfigData*)pins.Array(box);
        }
    }

    /// <summary>A tool: a chain of capsules between successive points of its axis.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct KnotTool
    {
        /// <summary>Number of points of the axis, 2 to 4.</summary>
        public uint PointCount;
        /// <summary>Object in the jaws.</summary>
        public KnotHeld Held;
        /// <summary>Points from the handle (or trocar) to the tip, m; successive points differ.</summary>
        public Vectors4 Axis;
        /// <summary>Radius of each capsule, m, 0 to 1.</summary>
        public Doubles3 Radius;
        /// <summary>THREAD: place of the jaws on the polyline; otherwise ignored.</summary>
        public double HeldPlace;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct KnotInputData
    {
        internal uint StructSize;
        internal uint PointCount;
        internal IntPtr Points;
        internal uint StrideBytes;
        internal uint ToolCount;
        internal IntPtr Tools;
        internal uint HoleCount;
        internal uint Reversed;
        internal Vectors2 Holes;
        internal Doubles2 HolePlaces;
        internal Vector3d Away;
        internal uint MayHavePassed;
        internal uint Reserved;
    }

    /// <summary>
    /// Input of a detector. Fill it with vbss_knot_input_init, then set its fields. The library
    /// copies all of it.
    /// </summary>
    public sealed unsafe partial class KnotInput
    {
        private readonly KnotInputData[] box = new KnotInputData[1];

        /// <summary>The defaults of the library.</summary>
        public KnotInput()
        {
            fixed (KnotInputData* data = box)
            {
                Vblast.Check(Native.vbss_knot_input_init(data, (uint)sizeof(KnotInputData)));
            }
        }

        /// <summary>Number of points, 2 to point_capacity; the default 0 is refused.</summary>
        public uint PointCount
        {
            get { return box[0].PointCount; }
            set { box[0].PointCount = value; }
        }

        /// <summary>
        /// x, y, z of each point from the tail's end on, m, each coordinate at most 1e3 in
        /// magnitude.
        /// </summary>
        public double[] Points { get; set; }

        /// <summary>Distance from one point to the next, bytes, at least 24; default 24.</summary>
        public uint StrideBytes
        {
            get { return box[0].StrideBytes; }
            set { box[0].StrideBytes = value; }
        }

        /// <summary>Number of tools, 0 (default) to tool_capacity.</summary>
        public uint ToolCount
        {
            get { return box[0].ToolCount; }
            set { box[0].ToolCount = value; }
        }

        /// <summary>Array of tool_count tools; may be NULL without tools.</summary>
        public KnotTool[] Tools { get; set; }

        /// <summary>
        /// Number of points where the thread goes through tissue. 0 (default): not known; 1: one
        /// point; 2: in at the first, out at the second. Without tissue no throw is stray, and
        /// throws are listed in the order in which they nest.
        /// </summary>
        public uint HoleCount
        {
            get { return box[0].HoleCount; }
            set { box[0].HoleCount = value; }
        }

        /// <summary>1: the points start at the long limb's end, and places count from there; default 0.</summary>
        public uint Reversed
        {
            get { return box[0].Reversed; }
            set { box[0].Reversed = value; }
        }

        /// <summary>Positions of the holes, m.</summary>
        public Vectors2 Holes
        {
            get { return box[0].Holes; }
            set { box[0].Holes = value; }
        }

        /// <summary>Places of the holes on the polyline; negative (default): the place nearest to `holes`.</summary>
        public Doubles2 HolePlaces
        {
            get { return box[0].HolePlaces; }
            set { box[0].HolePlaces = value; }
        }

        /// <summary>
        /// Direction away from the knot into the tissue, of any length; zero (default): from the
        /// middle of the thread to the middle of the holes.
        /// </summary>
        public Vector3d Away
        {
            get { return box[0].Away; }
            set { box[0].Away = value; }
        }

        /// <summary>
        /// 1: the thread may have passed through itself or a tool since the last step, for example
        /// without a collision guard, so the topology is read again; default 0.
        /// </summary>
        public uint MayHavePassed
        {
            get { return box[0].MayHavePassed; }
            set { box[0].MayHavePassed = value; }
        }

        internal KnotInputData* Pin(Pins pins)
        {
            ref KnotInputData data = ref box[0];
            uint? countedPointCount = null;
            uint? countedToolCount = null;
            data.Points = pins.Array(Points);
            if (Points != null)
            {
                data.PointCount = pins.Count(nameof(Points), Points.Length, 3, 0, ref countedPointCount);
            }
            data.Tools = pins.Array(Tools);
            if (Tools != null)
            {
                data.ToolCount = pins.Count(nameof(Tools), Tools.Length, 1, 0, ref countedToolCount);
            }
            return (KnotInputData*)pins.Array(box);
        }
    }

    /// <summary>A throw of a knot. Throws are counted from the tissue outward.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct KnotThrow
    {
        internal uint StructSize;
        /// <summary>Certainty, FORMED or CERTIFIED.</summary>
        public KnotVerdict Verdict;
        /// <summary>Number of wraps, from 1 on.</summary>
        public int Wraps;
        /// <summary>+1 right-handed, -1 left-handed.</summary>
        public int Handedness;
        /// <summary>VBSS_KNOT_THROW_ bits.</summary>
        public KnotThrowBits Flags;
        internal uint Reserved;
        /// <summary>LOCATED: first and last place on the tail limb, ascending.</summary>
        public Doubles2 TailPlaces;
        /// <summary>LOCATED: first and last place on the long limb, ascending.</summary>
        public Doubles2 LongPlaces;
        /// <summary>
        /// LOCATED: (cT - cL) / (cT + cL), with the mean curvature cT of the tail limb and cL of
        /// the long limb where the two cross, seen from all directions. 0: a flat half knot; +1:
        /// the tail is hitched round a straight long limb; -1: the reverse.
        /// </summary>
        public double Slip;
        /// <summary>LOCATED: length of thread between the throw and the tail's end, m.</summary>
        public double TailLength;
        /// <summary>Step of the detector in which the throw was first found.</summary>
        public ulong FormedStep;
        /// <summary>Step of the input that last confirmed the throw.</summary>
        public ulong ReadingStep;
    }

    /// <summary>Winding of the thread about one tool. Both methods update it in every step.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct KnotWinding
    {
        internal uint StructSize;
        /// <summary>
        /// 1: |turns| of the longest run has reached wrap_turns, and has not since fallen a quarter
        /// of a turn below.
        /// </summary>
        public int Wrapped;
        /// <summary>
        /// Signed turns about the axis, seen from the tip to the handle, walking from the tail's
        /// end to the long limb's. All thread beside the tool counts; thread beyond the tip or the
        /// handle does not.
        /// </summary>
        public double Turns;
        /// <summary>Turns of the run that winds most. A run is thread beside the tool without a gap.</summary>
        public double RunTurns;
        /// <summary>First and last place of that run.</summary>
        public Doubles2 RunPlaces;
        /// <summary>Distance of these places from the tip along the axis, m.</summary>
        public Doubles2 RunHeights;
        /// <summary>
        /// Direction along the tool in which the run winds, from its end nearer to the tissue to
        /// the other. +1: towards the tip, as a throw needs; -1: towards the handle, which ties
        /// nothing; 0: less than the thread's width either way, or not wrapped.
        /// </summary>
        public int Sense;
        /// <summary>Number of runs.</summary>
        public uint Runs;
    }

    /// <summary>State of a detector.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct KnotState
    {
        internal uint StructSize;
        /// <summary>Name of the knot.</summary>
        public KnotName Name;
        /// <summary>Verdict of the least certain throw; UNCERTAIN when the reading is; NONE without a knot.</summary>
        public KnotVerdict Verdict;
        /// <summary>Reason why the reading is uncertain.</summary>
        public KnotReason Reason;
        /// <summary>Number of tied throws, at most 8.</summary>
        public uint ThrowCount;
        /// <summary>Differences from the FLS knot: VBSS_KNOT_FAULT_ bits.</summary>
        public KnotFaultBits Faults;
        /// <summary>Verdict of the throw that is being tied: NONE, WRAPPING or PASSED.</summary>
        public KnotVerdict NextVerdict;
        /// <summary>Its wraps if the tools withdrew now; 0: no throw would be tied.</summary>
        public int NextWraps;
        /// <summary>Its handedness, +1 or -1; 0 without such a throw.</summary>
        public int NextHandedness;
        /// <summary>The tool that the thread winds round, from 0.</summary>
        public uint NextTool;
        /// <summary>PROJECTION: loops round a tool that one segment crosses.</summary>
        public uint Loops;
        /// <summary>PROJECTION: number of crossings of loops that tie nothing.</summary>
        public uint Undone;
        /// <summary>Number of crossings of the simplest diagram found.</summary>
        public uint Crossings;
        /// <summary>1: the diagram was decomposed into twist regions.</summary>
        public int Certified;
        /// <summary>Signature sigma; -2 for the right-handed 3_1.</summary>
        public int Signature;
        /// <summary>Levine-Tristram signature at 0.27 pi.</summary>
        public int SignatureTristram;
        /// <summary>Determinant |Delta(-1)|.</summary>
        public long Determinant;
        /// <summary>Vassiliev invariant of degree 2 (coefficient of z^2 of the Conway polynomial).</summary>
        public long V2;
        /// <summary>Vassiliev invariant of degree 3; 1 for the right-handed 3_1.</summary>
        public long V3;
        /// <summary>Number of other closures that were compared.</summary>
        public uint Closures;
        /// <summary>Number of other closures that gave the same result.</summary>
        public uint ClosuresAgreeing;
        /// <summary>1: both ends are outermost, so that all closures agree.</summary>
        public int EndsFree;
        internal uint Reserved;
        /// <summary>Number of calls of vbss_knot_detector_step and vbss_knot_detector_judge.</summary>
        public ulong Steps;
        /// <summary>Step whose input the last reading used; 0: there was no reading.</summary>
        public ulong ReadingStep;
    }

    /// <summary>Counts since creation or reset.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct KnotDetectorStatistics
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>Finished readings of the topology.</summary>
        public ulong Readings;
        /// <summary>Closed curves that were read.</summary>
        public ulong Closures;
        /// <summary>Closed curves that were decomposed into twist regions.</summary>
        public ulong Certified;
        /// <summary>Readings that ended uncertain.</summary>
        public ulong Uncertain;
        /// <summary>Diagrams that were made.</summary>
        public ulong Projections;
        /// <summary>Diagrams rejected because a crossing was not certain.</summary>
        public ulong Degenerate;
        /// <summary>Diagrams rejected because of too many crossings.</summary>
        public ulong Overflows;
        /// <summary>Vertices removed by proved moves.</summary>
        public ulong Removed;
        /// <summary>Operations used by readings.</summary>
        public ulong Work;
        /// <summary>Largest number of operations in a step.</summary>
        public ulong MostStepWork;
        /// <summary>Largest number of operations of a reading.</summary>
        public ulong MostWork;
        /// <summary>Verdicts that were revoked.</summary>
        public ulong Revoked;
    }
}
