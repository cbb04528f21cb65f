// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_metrics_tool.</summary>
    public enum MetricsTool : int
    {
        /// <summary>The left tool.</summary>
        Left = 0,
        /// <summary>The right tool.</summary>
        Right = 1,
        /// <summary>No tool, or an unknown one; for events only.</summary>
        None = 2,
    }

    /// <summary>The constants of vbss_metrics_tightness_test.</summary>
    public enum MetricsTightnessTest : int
    {
        /// <summary>The knot bears a force for a time without slipping.</summary>
        Pull = 0,
        /// <summary>The strain of both sides (Qi et al. 2017).</summary>
        Strain = 1,
    }

    /// <summary>Bits for the parts of a sample.</summary>
    [Flags]
    public enum MetricsHasBits : uint
    {
        /// <summary>The position of the left tool is valid.</summary>
        Left = 1,
        /// <summary>The position of the right tool is valid.</summary>
        Right = 2,
        /// <summary>The force on the left tool is valid.</summary>
        LeftForce = 4,
        /// <summary>The force on the right tool is valid.</summary>
        RightForce = 8,
    }

    /// <summary>
    /// The constants of vbss_metrics_event_kind. Each says whether it can be undone. An event that
    /// is reported again replaces its predecessor.
    /// </summary>
    public enum MetricsEventKind : int
    {
        /// <summary>The clock starts. Can be undone.</summary>
        NeedleAppears = 1,
        /// <summary>The phase `number` of the task begins.</summary>
        Phase = 2,
        /// <summary>
        /// The needle has passed through at mark `number` (0, 1), off by `angle` and `axial`.
        /// Undone: the puncture was withdrawn and counts as an attempt.
        /// </summary>
        Puncture = 3,
        /// <summary>Tail `number` (0, 1) is `amount` m long. Can be undone.</summary>
        Tail = 4,
        /// <summary>Tail `number` (0, 1) was cut; `amount` m are left. Can be undone.</summary>
        TailCut = 5,
        /// <summary>The slit gapes from `position` to `other`; its widest gap is `amount` m. Can be undone.</summary>
        Gap = 6,
        /// <summary>
        /// Throw `number` (0 next to the tissue) is tied, with `wraps`, `handedness` and
        /// `relation`. A repeated event corrects them. Undone: the throw was untied.
        /// </summary>
        Throw = 7,
        /// <summary>`tool` took over the needle. Can be undone.</summary>
        Transfer = 8,
        /// <summary>`tool` should have taken over the needle, and did not. Can be undone.</summary>
        TransferMissed = 9,
        /// <summary>The host's object `number` was dropped. Can be undone.</summary>
        Drop = 10,
        /// <summary>
        /// A penalty that the host defines: `number` identifies it, and it costs `amount` points.
        /// Can be undone.
        /// </summary>
        Host = 11,
        /// <summary>The drain was torn off. The score becomes zero. Can be undone.</summary>
        Avulsed = 12,
        /// <summary>The thread broke, or was cut early. The score becomes zero. Can be undone.</summary>
        Broken = 13,
        /// <summary>The trainee was assisted, by aid `number`. The score becomes zero. Can be undone.</summary>
        Assisted = 14,
    }

    /// <summary>The constants of vbss_metrics_relation.</summary>
    public enum MetricsRelation : int
    {
        /// <summary>The relation is not known.</summary>
        Unknown = 0,
        /// <summary>There is no throw before.</summary>
        First = 1,
        /// <summary>The throw has the opposite handedness.</summary>
        Square = 2,
        /// <summary>The throw has the same handedness.</summary>
        Granny = 3,
    }

    /// <summary>The constants of vbss_metrics_tightness.</summary>
    public enum MetricsTightness : int
    {
        /// <summary>The knot was not pulled, or the pull test is incomplete.</summary>
        Unknown = -1,
        /// <summary>The knot holds.</summary>
        Tight = 0,
        /// <summary>The knot slips.</summary>
        Slips = 10,
        /// <summary>The knot comes apart.</summary>
        Untied = 20,
    }

    /// <summary>Bits of the flags of a report.</summary>
    [Flags]
    public enum MetricsFlagBits : uint
    {
        /// <summary>The needle has appeared.</summary>
        Started = 1,
        /// <summary>Both tails are cut, and the time has stopped.</summary>
        Stopped = 2,
        /// <summary>The deviation from the first mark is known.</summary>
        Puncture0 = 4,
        /// <summary>The deviation from the second mark is known.</summary>
        Puncture1 = 8,
        /// <summary>The gap is known.</summary>
        Gap = 16,
        /// <summary>The length of the first tail is known.</summary>
        Tail0 = 32,
        /// <summary>The length of the second tail is known.</summary>
        Tail1 = 64,
        /// <summary>vbss_metrics_finish was called.</summary>
        Finished = 128,
        /// <summary>The drain was torn off.</summary>
        Avulsed = 256,
        /// <summary>The thread broke.</summary>
        Broken = 512,
        /// <summary>The time has run out.</summary>
        Timeout = 1024,
        /// <summary>
        /// The score is that of a whole trial: stopped, with deviations, gap and tightness known,
        /// or zero for good. Without this bit the score assumes that nothing more is found.
        /// </summary>
        Final = 2048,
        /// <summary>
        /// More than `lost_share` of the time is lost. Time and score include it and do not compare
        /// with those of other trials.
        /// </summary>
        TimeLost = 4096,
        /// <summary>The trainee was assisted: there is no score.</summary>
        Assisted = 8192,
    }

    /// <summary>The constants of vbss_metrics_penalty_kind.</summary>
    public enum MetricsPenaltyKind : int
    {
        /// <summary>A puncture is off its mark by `measure` mm.</summary>
        Deviation = 1,
        /// <summary>The slit gapes by `measure` mm.</summary>
        Gap = 2,
        /// <summary>The knot slips (`measure` is 10) or is untied (20).</summary>
        Tightness = 3,
        /// <summary>`measure` throws are missing.</summary>
        Throws = 4,
        /// <summary>A throw has the same handedness as the one before.</summary>
        Granny = 5,
        /// <summary>A puncture was withdrawn.</summary>
        Attempt = 6,
        /// <summary>Something was dropped.</summary>
        Drop = 7,
        /// <summary>A needle transfer was missed.</summary>
        Transfer = 8,
        /// <summary>A penalty of the host of `measure` points.</summary>
        Host = 9,
        /// <summary>The time has run out; it costs all remaining points.</summary>
        Timeout = 10,
        /// <summary>The drain was torn off; it costs all remaining points.</summary>
        Avulsed = 11,
        /// <summary>The thread broke; it costs all remaining points.</summary>
        Broken = 12,
        /// <summary>The trial ended before both tails were cut; it costs all remaining points.</summary>
        Incomplete = 13,
        /// <summary>
        /// More than `lost_share` of the time was lost; `measure` is the lost time, s. It costs no
        /// points.
        /// </summary>
        TimeLost = 14,
        /// <summary>The trainee was assisted; it costs all remaining points.</summary>
        Assisted = 15,
    }

    /// <summary>The `phase` argument for the whole task.</summary>
    public enum MetricsTask : int
    {
        /// <summary>
        /// From the needle's appearance until both tails were cut; without a needle, the whole
        /// recording.
        /// </summary>
        All = -1,
    }

    /// <summary>Bits for the measures of motion that could be computed.</summary>
    [Flags]
    public enum MetricsMotionBits : uint
    {
        /// <summary>`ldj_length` and `ldj_speed` are valid.</summary>
        Ldj = 1,
        /// <summary>`sparc` is valid: the motion lasts at most 40.96 s.</summary>
        Sparc = 2,
        /// <summary>`movement_sparc` is valid.</summary>
        Movements = 4,
        /// <summary>`correlation` is valid.</summary>
        Correlation = 8,
    }

    /// <summary>
    /// The constants of vbss_metrics_field. Row i belongs to the time of the first sample plus i /
    /// 100 s.
    /// </summary>
    public enum MetricsField : int
    {
        /// <summary>x 1 double: speed of the left tool, m/s; 0 where it was not seen.</summary>
        LeftSpeed = 0,
        /// <summary>x 1 double: speed of the right tool, m/s; 0 where it was not seen.</summary>
        RightSpeed = 1,
        /// <summary>
        /// x 1 double: |jerk|^2 of the left tool, m^2/s^6; 0 where it was not seen for 0.25 s
        /// without a gap.
        /// </summary>
        LeftJerk = 2,
        /// <summary>
        /// x 1 double: |jerk|^2 of the right tool, m^2/s^6; 0 where it was not seen for 0.25 s
        /// without a gap.
        /// </summary>
        RightJerk = 3,
        /// <summary>x 1 double: largest |force| on the left tool in that hundredth of a second, N.</summary>
        LeftForce = 4,
        /// <summary>x 1 double: largest |force| on the right tool in that hundredth of a second, N.</summary>
        RightForce = 5,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct MetricsConfigData
    {
        internal uint StructSize;
        internal MetricsTightnessTest TightnessTest;
        internal uint ThrowCapacity;
        internal uint PhaseCapacity;
        internal uint IncidentCapacity;
        internal uint ThrowsWanted;
        internal double Duration;
        internal double DrainRadius;
        internal double Stiffness;
        internal double PullForce;
        internal double PullTime;
        internal double SlipLimit;
        internal double StrainThreshold;
        internal double IdleSpeed;
        internal double IdleRelease;
        internal double MaxTime;
        internal double WeightDeviation;
        internal double WeightGap;
        internal double WeightTightness;
        internal double WeightThrow;
        internal double WeightGranny;
        internal double WeightAttempt;
        internal double WeightDrop;
        internal double WeightTransfer;
        internal double WeightHost;
        internal double MaxSpeed;
        internal double LostShare;
    }

    /// <summary>Configuration of a measurement. Fill it with vbss_metrics_config_init, then change fields.</summary>
    public sealed unsafe partial class MetricsConfig
    {
        private readonly MetricsConfigData[] box = new MetricsConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public MetricsConfig()
        {
            fixed (MetricsConfigData* data = box)
            {
                Vblast.Check(Native.vbss_metrics_config_init(data, (uint)sizeof(MetricsConfigData)));
            }
        }

        /// <summary>
        /// The test whose tightness counts in the score; default VBSS_METRICS_TEST_PULL. Both are
        /// always reported.
        /// </summary>
        public MetricsTightnessTest TightnessTest
        {
            get { return box[0].TightnessTest; }
            set { box[0].TightnessTest = value; }
        }

        /// <summary>Largest number of throw records, undone throws included, 1 to 4096; default 64.</summary>
        public uint ThrowCapacity
        {
            get { return box[0].ThrowCapacity; }
            set { box[0].ThrowCapacity = value; }
        }

        /// <summary>Largest number of phase visits, 1 to 65536; default 256.</summary>
        public uint PhaseCapacity
        {
            get { return box[0].PhaseCapacity; }
            set { box[0].PhaseCapacity = value; }
        }

        /// <summary>Largest number of transfers, attempts, drops and faults, 1 to 65536; default 256.</summary>
        public uint IncidentCapacity
        {
            get { return box[0].IncidentCapacity; }
            set { box[0].IncidentCapacity = value; }
        }

        /// <summary>Throws that the knot should have, 0 to 64; default 3.</summary>
        public uint ThrowsWanted
        {
            get { return box[0].ThrowsWanted; }
            set { box[0].ThrowsWanted = value; }
        }

        /// <summary>Longest motion that can be stored, s, 1 to 7200; default 600.</summary>
        public double Duration
        {
            get { return box[0].Duration; }
            set { box[0].Duration = value; }
        }

        /// <summary>Radius of the cylinder that carries the marks, m, 1e-4 to 1; default 6.5e-3.</summary>
        public double DrainRadius
        {
            get { return box[0].DrainRadius; }
            set { box[0].DrainRadius = value; }
        }

        /// <summary>Axial stiffness EA of the thread, N, 1e-3 to 1e9; default 427 (silk, 0.25 mm).</summary>
        public double Stiffness
        {
            get { return box[0].Stiffness; }
            set { box[0].Stiffness = value; }
        }

        /// <summary>Force of the pull test, N, 1e-3 to 1e3; default 2.</summary>
        public double PullForce
        {
            get { return box[0].PullForce; }
            set { box[0].PullForce = value; }
        }

        /// <summary>Time that the knot must bear the pull, s, 0 to 1e3; default 1.</summary>
        public double PullTime
        {
            get { return box[0].PullTime; }
            set { box[0].PullTime = value; }
        }

        /// <summary>Length of tail drawn in above which the knot slips, m, 1e-6 to 1; default 1e-3.</summary>
        public double SlipLimit
        {
            get { return box[0].SlipLimit; }
            set { box[0].SlipLimit = value; }
        }

        /// <summary>
        /// VBSS_METRICS_TEST_STRAIN: strain above which a knot is tight, 0 to 1; default 0, which
        /// means pull_force / stiffness.
        /// </summary>
        public double StrainThreshold
        {
            get { return box[0].StrainThreshold; }
            set { box[0].StrainThreshold = value; }
        }

        /// <summary>Speed below which a tool becomes idle, m/s, 0 to 1; default 5e-3.</summary>
        public double IdleSpeed
        {
            get { return box[0].IdleSpeed; }
            set { box[0].IdleSpeed = value; }
        }

        /// <summary>Speed above which an idle tool moves again, m/s, idle_speed to 1; default 6e-3.</summary>
        public double IdleRelease
        {
            get { return box[0].IdleRelease; }
            set { box[0].IdleRelease = value; }
        }

        /// <summary>Time from which the score is zero, s, 1e-3 to 1e6; default 600.</summary>
        public double MaxTime
        {
            get { return box[0].MaxTime; }
            set { box[0].MaxTime = value; }
        }

        /// <summary>Points per mm of deviation from a mark, 0 to 1e6; default 10.</summary>
        public double WeightDeviation
        {
            get { return box[0].WeightDeviation; }
            set { box[0].WeightDeviation = value; }
        }

        /// <summary>Points per mm of gap, 0 to 1e6; default 10.</summary>
        public double WeightGap
        {
            get { return box[0].WeightGap; }
            set { box[0].WeightGap = value; }
        }

        /// <summary>Points per point of tightness (0, 10, 20), 0 to 1e6; default 1.</summary>
        public double WeightTightness
        {
            get { return box[0].WeightTightness; }
            set { box[0].WeightTightness = value; }
        }

        /// <summary>Points per missing throw, 0 to 1e6; default 0.</summary>
        public double WeightThrow
        {
            get { return box[0].WeightThrow; }
            set { box[0].WeightThrow = value; }
        }

        /// <summary>Points per throw that makes a granny, 0 to 1e6; default 0.</summary>
        public double WeightGranny
        {
            get { return box[0].WeightGranny; }
            set { box[0].WeightGranny = value; }
        }

        /// <summary>Points per puncture that was withdrawn, 0 to 1e6; default 0.</summary>
        public double WeightAttempt
        {
            get { return box[0].WeightAttempt; }
            set { box[0].WeightAttempt = value; }
        }

        /// <summary>Points per drop, 0 to 1e6; default 0.</summary>
        public double WeightDrop
        {
            get { return box[0].WeightDrop; }
            set { box[0].WeightDrop = value; }
        }

        /// <summary>Points per missed needle transfer, 0 to 1e6; default 0.</summary>
        public double WeightTransfer
        {
            get { return box[0].WeightTransfer; }
            set { box[0].WeightTransfer = value; }
        }

        /// <summary>Factor of the points of the host's penalties, 0 to 1e6; default 1.</summary>
        public double WeightHost
        {
            get { return box[0].WeightHost; }
            set { box[0].WeightHost = value; }
        }

        /// <summary>
        /// Largest speed of a hand, m/s, 0 to 1e6; default 2, for the upper limbs by ISO 13855. A
        /// sample that is farther from the last one than this speed allows, plus 1 mm for noise, is
        /// an outlier: see vbss_metrics_add_sample. With 0 no sample is an outlier.
        /// </summary>
        public double MaxSpeed
        {
            get { return box[0].MaxSpeed; }
            set { box[0].MaxSpeed = value; }
        }

        /// <summary>
        /// Share of lost time above which VBSS_METRICS_FLAG_TIME_LOST is set, 0 to 1; default 0.02.
        /// A trial shorter than 1 s counts as 1 s.
        /// </summary>
        public double LostShare
        {
            get { return box[0].LostShare; }
            set { box[0].LostShare = value; }
        }

        internal MetricsConfigData* Pin(Pins pins)
        {
            return (MetricsConfigData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct MetricsSampleData
    {
        internal uint StructSize;
        internal MetricsHasBits Valid;
        internal ulong Step;
        internal double Time;
        internal Vectors2 Position;
        internal Vectors2 Force;
        internal double TimeLost;
    }

    /// <summary>
    /// Positions of the tools and forces on them. Fill it with vbss_metrics_sample_init, then set
    /// the known parts.
    /// </summary>
    public sealed unsafe partial class MetricsSample
    {
        private readonly MetricsSampleData[] box = new MetricsSampleData[1];

        /// <summary>The defaults of the library.</summary>
        public MetricsSample()
        {
            fixed (MetricsSampleData* data = box)
            {
                Vblast.Check(Native.vbss_metrics_sample_init(data, (uint)sizeof(MetricsSampleData)));
            }
        }

        /// <summary>VBSS_METRICS_HAS_ bits; default 0.</summary>
        public MetricsHasBits Valid
        {
            get { return box[0].Valid; }
            set { box[0].Valid = value; }
        }

        /// <summary>Step number of the simulator; it is only passed on.</summary>
        public ulong Step
        {
            get { return box[0].Step; }
            set { box[0].Step = value; }
        }

        /// <summary>Time of the sample, s, at most 1e9 in magnitude, after the last sample.</summary>
        public double Time
        {
            get { return box[0].Time; }
            set { box[0].Time = value; }
        }

        /// <summary>Positions of the left and the right tip, m, each coordinate at most 1e3 in magnitude.</summary>
        public Vectors2 Position
        {
            get { return box[0].Position; }
            set { box[0].Position = value; }
        }

        /// <summary>Forces on the left and the right tool, N, each component at most 1e6 in magnitude.</summary>
        public Vectors2 Force
        {
            get { return box[0].Force; }
            set { box[0].Force = value; }
        }

        /// <summary>
        /// Time that the simulation has left out since its clock began, s, at most 1e9 and not less
        /// than in the last sample; default 0. It is part of `time`.
        /// </summary>
        public double TimeLost
        {
            get { return box[0].TimeLost; }
            set { box[0].TimeLost = value; }
        }

        internal MetricsSampleData* Pin(Pins pins)
        {
            return (MetricsSampleData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct MetricsEventData
    {
        internal uint StructSize;
        internal MetricsEventKind Kind;
        internal MetricsTool Tool;
        internal uint Number;
        internal uint Undone;
        internal int Wraps;
        internal int Handedness;
        internal MetricsRelation Relation;
        internal ulong Step;
        internal double Time;
        internal Vector3d Position;
        internal Vector3d Force;
        internal Vector3d Other;
        internal double Angle;
        internal double Axial;
        internal double Amount;
    }

    /// <summary>An event. Fill it with vbss_metrics_event_init, then set the fields of its kind.</summary>
    public sealed unsafe partial class MetricsEvent
    {
        private readonly MetricsEventData[] box = new MetricsEventData[1];

        /// <summary>The defaults of the library.</summary>
        public MetricsEvent()
        {
            fixed (MetricsEventData* data = box)
            {
                Vblast.Check(Native.vbss_metrics_event_init(data, (uint)sizeof(MetricsEventData)));
            }
        }

        /// <summary>Kind of the event; the default 0 is refused.</summary>
        public MetricsEventKind Kind
        {
            get { return box[0].Kind; }
            set { box[0].Kind = value; }
        }

        /// <summary>The tool that was used; default VBSS_METRICS_TOOL_NONE.</summary>
        public MetricsTool Tool
        {
            get { return box[0].Tool; }
            set { box[0].Tool = value; }
        }

        /// <summary>Meaning depends on the kind; for throws 0 to 63; default 0.</summary>
        public uint Number
        {
            get { return box[0].Number; }
            set { box[0].Number = value; }
        }

        /// <summary>1: the event is undone; default 0.</summary>
        public uint Undone
        {
            get { return box[0].Undone; }
            set { box[0].Undone = value; }
        }

        /// <summary>THROW: wraps, 1 single, 2 double, at most 64; default 0: not known.</summary>
        public int Wraps
        {
            get { return box[0].Wraps; }
            set { box[0].Wraps = value; }
        }

        /// <summary>THROW: +1 right-handed, -1 left-handed, 0 not known (default).</summary>
        public int Handedness
        {
            get { return box[0].Handedness; }
            set { box[0].Handedness = value; }
        }

        /// <summary>THROW: relation to the throw before; default UNKNOWN.</summary>
        public MetricsRelation Relation
        {
            get { return box[0].Relation; }
            set { box[0].Relation = value; }
        }

        /// <summary>Step number of the simulator; it is only passed on.</summary>
        public ulong Step
        {
            get { return box[0].Step; }
            set { box[0].Step = value; }
        }

        /// <summary>Time, s, at most 1e9 in magnitude, not before that of the last input.</summary>
        public double Time
        {
            get { return box[0].Time; }
            set { box[0].Time = value; }
        }

        /// <summary>Position of the event, m, each coordinate at most 1e3 in magnitude.</summary>
        public Vector3d Position
        {
            get { return box[0].Position; }
            set { box[0].Position = value; }
        }

        /// <summary>Force at the event, N, each component at most 1e6 in magnitude.</summary>
        public Vector3d Force
        {
            get { return box[0].Force; }
            set { box[0].Force = value; }
        }

        /// <summary>GAP: point on the other side, m, each coordinate at most 1e3 in magnitude.</summary>
        public Vector3d Other
        {
            get { return box[0].Other; }
            set { box[0].Other = value; }
        }

        /// <summary>PUNCTURE: offset about the axis, rad, -pi to pi.</summary>
        public double Angle
        {
            get { return box[0].Angle; }
            set { box[0].Angle = value; }
        }

        /// <summary>PUNCTURE: offset along the axis, m, at most 1e3 in magnitude.</summary>
        public double Axial
        {
            get { return box[0].Axial; }
            set { box[0].Axial = value; }
        }

        /// <summary>Meaning depends on the kind; 0 to 1e6.</summary>
        public double Amount
        {
            get { return box[0].Amount; }
            set { box[0].Amount = value; }
        }

        internal MetricsEventData* Pin(Pins pins)
        {
            return (MetricsEventData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct MetricsPullData
    {
        internal uint StructSize;
        internal uint Begins;
        internal uint Tied;
        internal uint Reserved;
        internal ulong Step;
        internal double Time;
        internal Doubles2 Strain;
        internal Doubles2 Force;
        internal double DrawnIn;
    }

    /// <summary>A reading of the pull test. Fill it with vbss_metrics_pull_init, then set its fields.</summary>
    public sealed unsafe partial class MetricsPull
    {
        private readonly MetricsPullData[] box = new MetricsPullData[1];

        /// <summary>The defaults of the library.</summary>
        public MetricsPull()
        {
            fixed (MetricsPullData* data = box)
            {
                Vblast.Check(Native.vbss_metrics_pull_init(data, (uint)sizeof(MetricsPullData)));
            }
        }

        /// <summary>1: a new test begins, and the results of an earlier one are discarded; default 0.</summary>
        public uint Begins
        {
            get { return box[0].Begins; }
            set { box[0].Begins = value; }
        }

        /// <summary>1 (default): the knot is still there; 0: its topology is lost.</summary>
        public uint Tied
        {
            get { return box[0].Tied; }
            set { box[0].Tied = value; }
        }

        /// <summary>Step number of the simulator; it is only passed on.</summary>
        public ulong Step
        {
            get { return box[0].Step; }
            set { box[0].Step = value; }
        }

        /// <summary>Time, s, at most 1e9 in magnitude, not before that of the last input.</summary>
        public double Time
        {
            get { return box[0].Time; }
            set { box[0].Time = value; }
        }

        /// <summary>Strain of the thread between the knot and each tool, -1 to 1.</summary>
        public Doubles2 Strain
        {
            get { return box[0].Strain; }
            set { box[0].Strain = value; }
        }

        /// <summary>Force with which each tool pulls, N, 0 to 1e6.</summary>
        public Doubles2 Force
        {
            get { return box[0].Force; }
            set { box[0].Force = value; }
        }

        /// <summary>Tail drawn into the knot since the test began, m, at most 1e3.</summary>
        public double DrawnIn
        {
            get { return box[0].DrawnIn; }
            set { box[0].DrawnIn = value; }
        }

        internal MetricsPullData* Pin(Pins pins)
        {
            return (MetricsPullData*)pins.Array(box);
        }
    }

    /// <summary>The results of a trial so far. An unknown value is 0, and its bit is not set.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct MetricsReport
    {
        internal uint StructSize;
        /// <summary>VBSS_METRICS_FLAG_ bits: which values are known, and how the trial ended.</summary>
        public MetricsFlagBits Flags;
        /// <summary>Tightness by the pull test.</summary>
        public MetricsTightness TightnessPull;
        /// <summary>Tightness by the strain when both tools pull.</summary>
        public MetricsTightness TightnessStrain;
        /// <summary>Number of throws in the knot.</summary>
        public uint ThrowCount;
        /// <summary>Number of throws that are square to the one before.</summary>
        public uint SquareCount;
        /// <summary>Number of throws that make a granny with the one before.</summary>
        public uint GrannyCount;
        /// <summary>Number of throws whose relation is not known.</summary>
        public uint UnknownCount;
        /// <summary>Number of records for vbss_metrics_get_throw, undone throws included.</summary>
        public uint ThrowRecords;
        /// <summary>Number of visits for vbss_metrics_get_phase.</summary>
        public uint PhaseCount;
        /// <summary>Number of penalties for vbss_metrics_get_penalty.</summary>
        public uint PenaltyCount;
        /// <summary>Number of needle transfers.</summary>
        public uint Transfers;
        /// <summary>Number of missed needle transfers.</summary>
        public uint TransfersMissed;
        /// <summary>Number of withdrawn punctures at each mark.</summary>
        public UInts2 Attempts;
        /// <summary>Number of drops.</summary>
        public uint Drops;
        /// <summary>Number of penalties of the host.</summary>
        public uint HostPenalties;
        internal uint Reserved;
        /// <summary>Number of samples accepted.</summary>
        public ulong Samples;
        /// <summary>Number of ticks of motion evaluated so far, for the tool that has more of them.</summary>
        public ulong Ticks;
        /// <summary>Number of ticks not measured because `duration` was used up.</summary>
        public ulong TicksLost;
        /// <summary>
        /// Time from the needle's appearance until both tails were cut, or until now, s, on the
        /// clock of the hands. It includes `time_lost`.
        /// </summary>
        public double Time;
        /// <summary>Deviation of each puncture from its mark, along the drain, mm.</summary>
        public Doubles2 DeviationMm;
        /// <summary>Gap between the two points of the event GAP, mm.</summary>
        public double GapMm;
        /// <summary>Gap where the slit gapes most, mm.</summary>
        public double GapLargestMm;
        /// <summary>Length of each tail, after the cut if it was cut, mm.</summary>
        public Doubles2 TailMm;
        /// <summary>Longest time for which the knot bore the pull, s.</summary>
        public double PullHeld;
        /// <summary>Largest strain that both sides reached.</summary>
        public double PullStrain;
        /// <summary>Largest length of tail drawn in, mm.</summary>
        public double DrawnInMm;
        /// <summary>max_time - time - penalties, not below zero.</summary>
        public double Score;
        /// <summary>Sum of the penalties.</summary>
        public double Penalties;
        /// <summary>Samples of the left and the right tool left out as outliers.</summary>
        public ULongs2 Outliers;
        /// <summary>How often outliers lasted for more than 0.1 s, so that a new run began, for each tool.</summary>
        public UInts2 Jumps;
        /// <summary>Part of `time` that the simulation left out, s.</summary>
        public double TimeLost;
        /// <summary>Time that was simulated, s: `time` minus `time_lost`.</summary>
        public double TimeSimulated;
    }

    /// <summary>A throw that was tied. Records are in the order of their first events.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct MetricsThrow
    {
        internal uint StructSize;
        /// <summary>Position in the knot; 0 is next to the tissue.</summary>
        public uint Number;
        /// <summary>1: the throw is tied; 0: it was untied.</summary>
        public uint Standing;
        /// <summary>The tool that tied it.</summary>
        public MetricsTool Tool;
        /// <summary>Number of wraps: 1 single, 2 double, 0 not known.</summary>
        public int Wraps;
        /// <summary>+1 right-handed, -1 left-handed, 0 not known.</summary>
        public int Handedness;
        /// <summary>Relation to the throw before.</summary>
        public MetricsRelation Relation;
        internal uint Reserved;
        /// <summary>Step of its first event.</summary>
        public ulong Step;
        /// <summary>Time of its first event, s.</summary>
        public double Time;
        /// <summary>Time at which it was untied, s; 0 while it is tied.</summary>
        public double UndoneTime;
        /// <summary>Position of the throw, m.</summary>
        public Vector3d Position;
        /// <summary>Force at the throw, N.</summary>
        public Vector3d Force;
    }

    /// <summary>A visit of a phase. A phase may be visited more than once.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct MetricsPhase
    {
        internal uint StructSize;
        /// <summary>The host's number of the phase.</summary>
        public uint Number;
        /// <summary>1: another phase has begun; 0: `end` is the current time, or the end of the trial.</summary>
        public uint Ended;
        internal uint Reserved;
        /// <summary>Step at which the phase began.</summary>
        public ulong Step;
        /// <summary>Time at which the phase began, s.</summary>
        public double Begin;
        /// <summary>Time at which the phase ended, s.</summary>
        public double End;
    }

    /// <summary>One reason why the score is not max_time - time. Faults that cost no points are listed too.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct MetricsPenalty
    {
        internal uint StructSize;
        /// <summary>Kind of the penalty.</summary>
        public MetricsPenaltyKind Kind;
        /// <summary>Number of the mark, throw or other object, as in the event.</summary>
        public uint Number;
        /// <summary>The tool that was used.</summary>
        public MetricsTool Tool;
        /// <summary>Step of the penalty.</summary>
        public ulong Step;
        /// <summary>Time of the penalty, s.</summary>
        public double Time;
        /// <summary>Size of the fault; its meaning depends on the kind.</summary>
        public double Measure;
        /// <summary>Points that it costs.</summary>
        public double Amount;
        /// <summary>Position, m.</summary>
        public Vector3d Position;
        /// <summary>Force, N.</summary>
        public Vector3d Force;
        internal IntPtr Text;
    }

    /// <summary>Motion of one tool, and the force on it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct MetricsMotion
    {
        internal uint StructSize;
        /// <summary>VBSS_METRICS_HAS_ bits.</summary>
        public MetricsMotionBits Valid;
        /// <summary>Number of movements between rests that last 0.2 s to 40.96 s.</summary>
        public uint MovementCount;
        internal uint Reserved;
        /// <summary>Time in which the tool was seen, s.</summary>
        public double Time;
        /// <summary>Time in which the tool was not seen, s.</summary>
        public double UnseenTime;
        /// <summary>Length of the path, m.</summary>
        public double PathLength;
        /// <summary>Mean speed, m/s.</summary>
        public double MeanSpeed;
        /// <summary>Peak speed, m/s.</summary>
        public double PeakSpeed;
        /// <summary>Time in which the tool was idle, s.</summary>
        public double IdleTime;
        /// <summary>Idle share of `time`, 0 to 1.</summary>
        public double IdleShare;
        /// <summary>Log dimensionless jerk by length, -ln(T^5/L^2 integral of |jerk|^2); higher is smoother.</summary>
        public double LdjLength;
        /// <summary>
        /// Log dimensionless jerk by peak speed, -ln(T^3/v_peak^2 integral of |jerk|^2); higher is
        /// smoother.
        /// </summary>
        public double LdjSpeed;
        /// <summary>Spectral arc length of the whole motion as one movement.</summary>
        public double Sparc;
        /// <summary>Mean spectral arc length over the movements.</summary>
        public double MovementSparc;
        /// <summary>Largest force, N.</summary>
        public double ForcePeak;
        /// <summary>Integral of the magnitude of the force over time, N s.</summary>
        public double ForceIntegral;
    }

    /// <summary>Joint motion of both tools.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct MetricsBimanual
    {
        internal uint StructSize;
        /// <summary>VBSS_METRICS_HAS_CORRELATION, or 0.</summary>
        public uint Valid;
        /// <summary>Time in which both tools were seen, s.</summary>
        public double Time;
        /// <summary>Pearson's correlation of their speeds, -1 to 1.</summary>
        public double Correlation;
        /// <summary>Time in which both tools moved, s.</summary>
        public double BothMovingTime;
        /// <summary>Time in which exactly one tool moved, s.</summary>
        public double OneMovingTime;
        /// <summary>Time in which both tools were idle, s.</summary>
        public double StillTime;
        /// <summary>`both_moving_time` as a share of `time`, 0 to 1.</summary>
        public double BothMovingShare;
    }
}
