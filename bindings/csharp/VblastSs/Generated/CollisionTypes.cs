// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_collision_method.</summary>
    public enum CollisionMethod : int
    {
        /// <summary>
        /// Directional conservative advancement, the default: never misses. For D = 0, hits and
        /// misses are exact.
        /// </summary>
        Conservative = 0,
        /// <summary>
        /// The usual method: roots of the coplanarity cubic, an inside test at each root, and the
        /// distance at the end. May miss.
        /// </summary>
        Cubic = 1,
        /// <summary>
        /// Algorithm 1 of VBLaST-SS (Qi et al. 2017): distance at the end, then a sign test and a
        /// linear time of impact. Often misses.
        /// </summary>
        Vblast = 2,
    }

    /// <summary>The constants of vbss_collision_pair_kind, with their four vertices.</summary>
    public enum CollisionPairKind : int
    {
        /// <summary>a0, a1 of edge a, then b0, b1 of edge b.</summary>
        EdgeEdge = 0,
        /// <summary>The point (a), then b0, b1, b2 of the triangle.</summary>
        PointTriangle = 1,
    }

    /// <summary>The constants of vbss_collision_decision.</summary>
    public enum CollisionDecision : int
    {
        /// <summary>
        /// Miss: planes that separate the features by more than D at all times. Hit: at `time` the
        /// distance is at most D plus the tolerance.
        /// </summary>
        Proved = 0,
        /// <summary>D = 0: true for the given numbers, without any tolerance.</summary>
        Exact = 1,
        /// <summary>
        /// Neither could be shown, so the answer is a hit. D &gt; 0: the test reached pass_limit,
        /// or no direction was exact enough, which takes a D below about 1e-8 of the size. D = 0:
        /// the bits of the coordinates spread over more binary places than there is memory for. A
        /// call without an object has memory for about 250 places; with an object, all doubles
        /// tried so far have fitted.
        /// </summary>
        Undecided = 2,
        /// <summary>CUBIC and VBLAST: not proved.</summary>
        Claimed = 3,
    }

    /// <summary>The constants of vbss_collision_field.</summary>
    public enum CollisionField : int
    {
        /// <summary>
        /// x 5 uint32_t: vbss_collision_pair_kind, shape and feature a, shape and feature b. A
        /// feature is an edge, a point (node) or a triangle. Sorted by these five numbers.
        /// </summary>
        Candidates = 0,
        /// <summary>uint32_t: index of the candidate, ascending.</summary>
        Impacts = 1,
        /// <summary>vbss_collision_impact.time.</summary>
        Times = 2,
        /// <summary>x 3: vbss_collision_impact.normal.</summary>
        Normals = 3,
        /// <summary>x 4: vbss_collision_impact.weights.</summary>
        Weights = 4,
        /// <summary>uint32_t: vbss_collision_impact.decision.</summary>
        Decisions = 5,
        /// <summary>vbss_collision_impact.distance, m.</summary>
        Distances = 6,
    }

    /// <summary>The constants of vbss_collision_response_variant.</summary>
    public enum CollisionResponseVariant : int
    {
        /// <summary>Algorithm 2 as printed: along the shortest vector at the end of the step.</summary>
        EndOfStep = 0,
        /// <summary>
        /// Along the normal at the time of impact, by D: the features are then D apart in the
        /// positions of that time.
        /// </summary>
        TimeOfImpact = 1,
    }

    /// <summary>Two closest points.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct CollisionClosest
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>Distance, m; minus the penetration depth for capsules that overlap.</summary>
        public double Distance;
        /// <summary>Unit vector from a to b; zero if undefined (axes that meet).</summary>
        public Vector3d Normal;
        /// <summary>On a, m.</summary>
        public Vector3d PointA;
        /// <summary>On b, m.</summary>
        public Vector3d PointB;
        /// <summary>Weights of the vertices of a, or of its axis, that give point_a.</summary>
        public Doubles3 WeightsA;
        /// <summary>Weights of the vertices of b, or of its axis, that give point_b.</summary>
        public Doubles3 WeightsB;
    }

    /// <summary>Result of a continuous test.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct CollisionImpact
    {
        internal uint StructSize;
        /// <summary>1: they come within D; 0: they do not.</summary>
        public int Hit;
        /// <summary>Evidence for `hit`.</summary>
        public CollisionDecision Decision;
        /// <summary>CONSERVATIVE: evaluations of the closest points; else of roots.</summary>
        public uint Passes;
        /// <summary>
        /// Hit: 0 to 1; with CONSERVATIVE there is no contact before. PROVED: at `time` the
        /// features are within D plus the tolerance. EXACT: `time` is as near to the first contact
        /// as the advancement came. `distance` says how near: about 1e-14 of the size, but more
        /// where features graze. Miss: 1.
        /// </summary>
        public double Time;
        /// <summary>
        /// Hit: distance of the features at `time`, m; CUBIC and VBLAST: distance of the assumed
        /// points of contact. Miss: 0.
        /// </summary>
        public double Distance;
        /// <summary>Hit: unit vector from a to b, or zero if none is known. Miss: 0.</summary>
        public Vector3d Normal;
        /// <summary>Hit: weights of the four vertices, sum 1 on either feature. Miss: 0.</summary>
        public Doubles4 Weights;
        /// <summary>Hit: point on a at `time`, m. Miss: 0.</summary>
        public Vector3d PointA;
        /// <summary>Hit: point on b at `time`, m. Miss: 0.</summary>
        public Vector3d PointB;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct CollisionConfigData
    {
        internal uint StructSize;
        internal CollisionMethod Method;
        internal double Thickness;
        internal double Tolerance;
        internal uint PassLimit;
        internal uint ShapeCapacity;
        internal uint PairCapacity;
        internal uint ImpactCapacity;
        internal double Exclusion;
        internal double Margin;
        internal IntPtr Baseline;
    }

    /// <summary>Method of the tests, and capacities. Fill it with vbss_collision_config_init.</summary>
    public sealed unsafe partial class CollisionConfig
    {
        private readonly CollisionConfigData[] box = new CollisionConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public CollisionConfig()
        {
            fixed (CollisionConfigData* data = box)
            {
                Vblast.Check(Native.vbss_collision_config_init(data, (uint)sizeof(CollisionConfigData)));
            }
        }

        /// <summary>Default VBSS_COLLISION_METHOD_CONSERVATIVE.</summary>
        public CollisionMethod Method
        {
            get { return box[0].Method; }
            set { box[0].Method = value; }
        }

        /// <summary>
        /// Contact distance D, m: 0, or 1e-30 to 1e30; default 0. Between shapes their radii are
        /// added.
        /// </summary>
        public double Thickness
        {
            get { return box[0].Thickness; }
            set { box[0].Thickness = value; }
        }

        /// <summary>
        /// Share of D, 1e-12 to 1; default 1e-3. A test may report a hit for features that only
        /// come within D (1 + tolerance). Rounding sets a lower limit:
        /// docs/explanation/collision.md. No effect on the answer when D = 0.
        /// </summary>
        public double Tolerance
        {
            get { return box[0].Tolerance; }
            set { box[0].Tolerance = value; }
        }

        /// <summary>
        /// CONSERVATIVE: passes before a test gives up and reports a hit, 1 to 1000000; default
        /// 10000. Most tests take one or two; edges that turn about each other just above D take
        /// hundreds. With D = 0 a test makes at most 256. The limit does not apply to exact
        /// decisions. They take about 10 us, milliseconds where bits spread over hundreds of binary
        /// places, and up to a second with subnormal numbers beside 1.
        /// </summary>
        public uint PassLimit
        {
            get { return box[0].PassLimit; }
            set { box[0].PassLimit = value; }
        }

        /// <summary>Largest number of shapes ever added, 0 to 65536; default 16.</summary>
        public uint ShapeCapacity
        {
            get { return box[0].ShapeCapacity; }
            set { box[0].ShapeCapacity = value; }
        }

        /// <summary>Largest number of candidates, 0 to 1e8; default 16384.</summary>
        public uint PairCapacity
        {
            get { return box[0].PairCapacity; }
            set { box[0].PairCapacity = value; }
        }

        /// <summary>Largest number of impacts, 0 to 1e8; default 4096.</summary>
        public uint ImpactCapacity
        {
            get { return box[0].ImpactCapacity; }
            set { box[0].ImpactCapacity = value; }
        }

        /// <summary>
        /// Excludes two segments of one chain from the candidates if the arc between their nearest
        /// ends is shorter than `exclusion` times the D of the pair; 0 to 1e3. Neighbours are
        /// always excluded. Default 1.6: a tube bent until it touches itself needs pi/2.
        /// </summary>
        public double Exclusion
        {
            get { return box[0].Exclusion; }
            set { box[0].Exclusion = value; }
        }

        /// <summary>Added to D in the search for candidates, m, 0 to 1e3; default 0.</summary>
        public double Margin
        {
            get { return box[0].Margin; }
            set { box[0].Margin = value; }
        }

        /// <summary>VBLAST: its parameters; NULL (default): their defaults. The library copies them.</summary>
        public BaselineConfig Baseline { get; set; }

        internal CollisionConfigData* Pin(Pins pins)
        {
            ref CollisionConfigData data = ref box[0];
            data.Baseline = Baseline == null ? IntPtr.Zero : (IntPtr)Baseline.Pin(pins);
            return (CollisionConfigData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct CollisionBatchData
    {
        internal uint StructSize;
        internal CollisionPairKind Kind;
        internal uint Count;
        internal uint Stride;
        internal IntPtr Start;
        internal IntPtr End;
        internal IntPtr Thickness;
        internal IntPtr Hit;
        internal IntPtr Decision;
        internal IntPtr Time;
        internal IntPtr Normal;
        internal IntPtr Weights;
    }

    /// <summary>Questions in rows, answers in rows. Fill it with vbss_collision_batch_init.</summary>
    public sealed unsafe partial class CollisionBatch
    {
        private readonly CollisionBatchData[] box = new CollisionBatchData[1];

        /// <summary>The defaults of the library.</summary>
        public CollisionBatch()
        {
            fixed (CollisionBatchData* data = box)
            {
                Vblast.Check(Native.vbss_collision_batch_init(data, (uint)sizeof(CollisionBatchData)));
            }
        }

        /// <summary>Kinds of the features of all questions.</summary>
        public CollisionPairKind Kind
        {
            get { return box[0].Kind; }
            set { box[0].Kind = value; }
        }

        /// <summary>Questions, at most 1e8.</summary>
        public uint Count
        {
            get { return box[0].Count; }
            set { box[0].Count = value; }
        }

        /// <summary>Elements from one row to the next in every array, at least count.</summary>
        public uint Stride
        {
            get { return box[0].Stride; }
            set { box[0].Stride = value; }
        }

        /// <summary>
        /// Positions at time 0, m. 12 rows: x of vertex 0 of every question, y of vertex 0, z, x of
        /// vertex 1, and so on. No two arrays of a batch overlap.
        /// </summary>
        public double[] Start { get; set; }

        /// <summary>Positions at time 1, m, in rows as for `start`.</summary>
        public double[] End { get; set; }

        /// <summary>D of each question, m; NULL: D of the configuration.</summary>
        public double[] Thickness { get; set; }

        /// <summary>Receives vbss_collision_impact.hit of each question.</summary>
        public int[] Hit { get; set; }

        /// <summary>Receives vbss_collision_impact.decision; may be NULL.</summary>
        public int[] Decision { get; set; }

        /// <summary>Receives vbss_collision_impact.time; may be NULL.</summary>
        public double[] Time { get; set; }

        /// <summary>Receives 3 rows; may be NULL.</summary>
        public double[] Normal { get; set; }

        /// <summary>Receives 4 rows; may be NULL.</summary>
        public double[] Weights { get; set; }

        internal CollisionBatchData* Pin(Pins pins)
        {
            ref CollisionBatchData data = ref box[0];
            uint? countedStride = null;
            data.Start = pins.Array(Start);
            if (Start != null)
            {
                data.Stride = pins.Count(nameof(Start), Start.Length, 12, 0, ref countedStride);
            }
            data.End = pins.Array(End);
            if (End != null)
            {
                data.Stride = pins.Count(nameof(End), End.Length, 12, 0, ref countedStride);
            }
            data.Thickness = pins.Array(Thickness);
            if (Thickness != null)
            {
                data.Stride = pins.Count(nameof(Thickness), Thickness.Length, 1, 0, ref countedStride);
            }
            data.Hit = pins.Array(Hit);
            if (Hit != null)
            {
                data.Stride = pins.Count(nameof(Hit), Hit.Length, 1, 0, ref countedStride);
            }
            data.Decision = pins.Array(Decision);
            if (Decision != null)
            {
                data.Stride = pins.Count(nameof(Decision), Decision.Length, 1, 0, ref countedStride);
            }
            data.Time = pins.Array(Time);
            if (Time != null)
            {
                data.Stride = pins.Count(nameof(Time), Time.Length, 1, 0, ref countedStride);
            }
            data.Normal = pins.Array(Normal);
            if (Normal != null)
            {
                data.Stride = pins.Count(nameof(Normal), Normal.Length, 3, 0, ref countedStride);
            }
            data.Weights = pins.Array(Weights);
            if (Weights != null)
            {
                data.Stride = pins.Count(nameof(Weights), Weights.Length, 4, 0, ref countedStride);
            }
            return (CollisionBatchData*)pins.Array(box);
        }
    }

    /// <summary>
    /// Counters of a collision object since its creation. Searches and tests that fail are not
    /// counted.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct CollisionStatistics
    {
        internal uint StructSize;
        /// <summary>Candidates of the last search.</summary>
        public uint Candidates;
        /// <summary>Impacts of the last search.</summary>
        public uint Impacts;
        internal uint Reserved;
        /// <summary>Continuous tests.</summary>
        public ulong Queries;
        /// <summary>Continuous tests that were hits.</summary>
        public ulong Hits;
        /// <summary>Continuous tests that were undecided.</summary>
        public ulong Undecided;
        /// <summary>Tests that needed exact arithmetic.</summary>
        public ulong Exact;
        /// <summary>CONSERVATIVE: evaluations of the closest points.</summary>
        public ulong Passes;
        /// <summary>Pairs of boxes that the searches tested; not part of the state.</summary>
        public ulong BoxesTested;
        /// <summary>Searches for candidates.</summary>
        public ulong Searches;
    }

    /// <summary>Displacements by the paper's response.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct CollisionResponse
    {
        internal uint StructSize;
        /// <summary>
        /// 1: the paper leaves this case open, and a rule of docs/explanation/paper-collision.md
        /// was used. Examples are no relative motion along the direction, and features that meet at
        /// the end.
        /// </summary>
        public int Completed;
        /// <summary>q: unit vector from edge b to edge a, on the side of the start.</summary>
        public Vector3d Direction;
        /// <summary>u: distance to restore along q, m.</summary>
        public double Depth;
        /// <summary>Share of u that a moves along q; b moves -(1 - share_a) u q.</summary>
        public double ShareA;
        /// <summary>Displacements of the four vertices at time 1, m.</summary>
        public Doubles12 Displacement;
    }
}
