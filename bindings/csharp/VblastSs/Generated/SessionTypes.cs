// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_session_phase, in the order of the task.</summary>
    public enum SessionPhase : int
    {
        /// <summary>No step was made; the needle has not appeared.</summary>
        Idle = 0,
        /// <summary>A tool must take the needle.</summary>
        Loading = 1,
        /// <summary>A tool holds the needle and approaches the first mark.</summary>
        Approach = 2,
        /// <summary>The needle's tip is in the drain, on its way to the second mark.</summary>
        InDrain = 3,
        /// <summary>The tip is out again; the thread is drawn until the tail has its length.</summary>
        PullThrough = 4,
        /// <summary>The first throw must be tied and seated.</summary>
        Throw1 = 5,
        /// <summary>The needle must change hands after the first throw.</summary>
        Transfer1 = 6,
        /// <summary>The second throw must be tied and seated.</summary>
        Throw2 = 7,
        /// <summary>The needle must change hands after the second throw.</summary>
        Transfer2 = 8,
        /// <summary>The third throw must be tied and seated.</summary>
        Throw3 = 9,
        /// <summary>Both tails must be cut.</summary>
        Cut = 10,
        /// <summary>Both tails are cut; final.</summary>
        Done = 11,
        /// <summary>The task has failed; final. See vbss_session_failure.</summary>
        Failed = 12,
    }

    /// <summary>The constants of vbss_session_stage.</summary>
    public enum SessionStage : int
    {
        /// <summary>The throw has not begun.</summary>
        None = 0,
        /// <summary>The thread winds round a tool.</summary>
        Wrap = 1,
        /// <summary>The thread winds round a tool that holds the tail near its end.</summary>
        Grasped = 2,
        /// <summary>The throw is tied if the tools withdraw.</summary>
        Passed = 3,
        /// <summary>The throw is tied and must be pulled down.</summary>
        Seating = 4,
        /// <summary>The throw lies on the tissue.</summary>
        Seated = 5,
    }

    /// <summary>The constants of vbss_session_failure.</summary>
    public enum SessionFailure : int
    {
        /// <summary>The task has not failed.</summary>
        None = 0,
        /// <summary>The time limit has passed.</summary>
        Timeout = 1,
        /// <summary>The drain was torn off its anchors.</summary>
        Avulsed = 2,
        /// <summary>The thread was cut before the third throw was seated.</summary>
        CutEarly = 3,
        /// <summary>The thread was cut inside the knot, or between the two holes.</summary>
        CutKnot = 4,
        /// <summary>The thread broke: its tension exceeded `break_force`.</summary>
        Broken = 5,
        /// <summary>Thread, needle, drain or a tool was removed from the scene.</summary>
        Lost = 6,
    }

    /// <summary>
    /// The constants of vbss_session_event_kind. A comment that says "Undone" describes the event
    /// with `undone` 1, which reports that the fact has ceased.
    /// </summary>
    public enum SessionEventKind : int
    {
        /// <summary>The needle has appeared, and the clock starts.</summary>
        Appeared = 1,
        /// <summary>The phase `number` begins. Undone: the task has fallen back to this phase.</summary>
        Phase = 2,
        /// <summary>`tool` holds the needle. Undone: it has released the needle.</summary>
        Taken = 3,
        /// <summary>Before the stitch: no tool holds the needle, and it is in no wall.</summary>
        Dropped = 4,
        /// <summary>
        /// Mark `number` (0: in, 1: out) was pierced, `amount` mm off; `position` is that of the
        /// hole. Undone: the needle has left the hole, or the thread's end has slipped through it.
        /// </summary>
        Puncture = 5,
        /// <summary>A wall was pierced elsewhere, as hole `number`. Undone: the hole is empty again.</summary>
        Stray = 6,
        /// <summary>
        /// The swage has passed through hole `number` (0, 1), and the thread follows. Undone: it
        /// has come back.
        /// </summary>
        Threaded = 7,
        /// <summary>The tail has a permitted length, `amount` m. Undone: it no longer has.</summary>
        Tail = 8,
        /// <summary>Throw `number` (0, 1, ...) has reached `stage`, forwards or backwards.</summary>
        Stage = 9,
        /// <summary>
        /// Throw `number` is tied, with `wraps`, `handedness` and `relation`; a repeated event
        /// corrects them. Undone: the throw came undone.
        /// </summary>
        Throw = 10,
        /// <summary>Throw `number` is seated; the slit gapes `amount` m. Undone: it is no longer seated.</summary>
        Seated = 11,
        /// <summary>`tool` has taken over the needle after throw `number`.</summary>
        Transfer = 12,
        /// <summary>
        /// Throw `number` is tied, but the needle has not changed hands since the throw before.
        /// Undone: the throw came undone.
        /// </summary>
        TransferMissed = 13,
        /// <summary>
        /// The knot has had the fault `number`, a VBSS_KNOT_FAULT_ bit, for `throw_dwell`. HITCH (a
        /// throw has capsized) takes 20 times `throw_dwell`, because its measure oscillates while a
        /// throw is drawn tight. Undone: the fault has been absent for the same time.
        /// </summary>
        Fault = 14,
        /// <summary>
        /// Tail `number` (0: the short one, 1: the needle's) was cut; its remaining length is
        /// `amount` m.
        /// </summary>
        Cut = 15,
        /// <summary>The task is complete.</summary>
        Done = 16,
        /// <summary>The task has failed; `number` is a vbss_session_failure.</summary>
        Failed = 17,
        /// <summary>
        /// More than `lost_share` of the time since the needle's appearance is lost: `amount` s.
        /// Times and score do not compare with those of other trials. Undone: the share has fallen
        /// below half of `lost_share`.
        /// </summary>
        TimeLost = 18,
        /// <summary>
        /// Only with `coaching`: the goal of the hand `tool` is now `number`, a VBSS_SESSION_GOAL_
        /// constant (session_coaching.h).
        /// </summary>
        Goal = 19,
        /// <summary>
        /// Only with `coaching`: the mistake `number`, a VBSS_SESSION_MISTAKE_ constant, is made.
        /// Undone: it is mended or past.
        /// </summary>
        Mistake = 20,
        /// <summary>
        /// The aid `number`, a VBSS_SESSION_AID_ bit, was switched on: the task is assisted and
        /// gets no score. `amount` is 1 for the first time, then 0. Undone: the aid was switched
        /// off.
        /// </summary>
        Aid = 21,
        /// <summary>
        /// Only with `exercise`: the exercise `number` has ended; `amount` is 1 if it is passed,
        /// and 0 if it is not (session_exercise.h).
        /// </summary>
        Exercise = 22,
    }

    /// <summary>
    /// The constants of vbss_session_exercise. session_exercise.h has their starts, goals and
    /// measures.
    /// </summary>
    public enum SessionExercise : int
    {
        /// <summary>No exercise: the whole task.</summary>
        None = 0,
        /// <summary>The needle is taken up.</summary>
        TakeNeedle = 1,
        /// <summary>The needle is pushed through the wall at a mark.</summary>
        PassMark = 2,
        /// <summary>A throw of one wrap is tied and seated.</summary>
        SingleThrow = 3,
        /// <summary>A throw of two wraps is tied and seated.</summary>
        DoubleThrow = 4,
        /// <summary>A throw that is square to the first one is tied and seated.</summary>
        SquareThrow = 5,
        /// <summary>Both tails are cut.</summary>
        Cut = 6,
        /// <summary>One more than the largest exercise.</summary>
        Count = 7,
    }

    /// <summary>
    /// Bits of the aids (session_assistance.h). "Along the direction" means: by the component of
    /// the hand's movement along vbss_session_assistance.direction.
    /// </summary>
    [Flags]
    public enum SessionAidBits : uint
    {
        /// <summary>
        /// A hand that holds the needle turns it about the centre of its arc and moves it in no
        /// other way. Movement along the direction drives the tip forward by the same length of
        /// arc. Turns of the hand are ignored. Acts before the first throw.
        /// </summary>
        Arc = 1,
        /// <summary>
        /// A hand that holds the needle takes the needle's end with the thread round the jaws of
        /// the other tool. Movement along the direction winds in the sense that the next throw
        /// needs. The radius, between 8 mm and 45 mm, is 0.92 of the one at which the thread is
        /// taut, or stays if there is no stitch. With a coach it allows for the turns on the jaws.
        /// Turns of the hand turn the tool as without the aid. Acts in the phases of throws.
        /// </summary>
        Wind = 2,
        /// <summary>
        /// The roll of each tool about its shaft is the nearest multiple of `roll_step` from the
        /// roll in which the jaws open along the slit.
        /// </summary>
        SnapRoll = 4,
        /// <summary>Each step of the session is `time_scale` times as long as the host asks for.</summary>
        SlowMotion = 8,
        /// <summary>
        /// A hand that sinks slower than `sink_speed` leaves its tool at the same height, for arms
        /// without support.
        /// </summary>
        Hover = 16,
        /// <summary>
        /// The tool and the jaws of a hand that has moved less than `hold_distance` for `hold_time`
        /// stay where they are, until the hand leaves this distance.
        /// </summary>
        AutoHold = 32,
        /// <summary>
        /// The tool of a hand that has rested for 0.1 s follows the tool of the other hand while
        /// that one moves, for inputs that move one hand at a time. It needs a coach and acts by
        /// the coach's goal, while the thread is held at both ends. TAKE_TAIL, and DRAW_TAIL after
        /// the first throw, with turns on the jaws: the needle goes along with them and above them,
        /// so that the thread stays as long from the slit over the jaws to the needle; it comes
        /// nearer while its end of the thread bears more than 0.05 N. SEAT, RELEASE_TAIL: the tool
        /// moves opposite to the other one at its own height. It moves up to twice as far, or gives
        /// way, so that both ends bear as much. The tool stays within 0.15 m of the slit. It is not
        /// turned, and its jaws do not move.
        /// </summary>
        Follow = 64,
        /// <summary>All aids.</summary>
        All = 127,
    }

    /// <summary>The constants of vbss_session_gap.</summary>
    public enum SessionGap : int
    {
        /// <summary>
        /// Gap between the lips, which are as high as the wall: vbss_drain_gap.opening. A wall that
        /// rises counts as closed when it meets the face of the other wall. A drain of
        /// VBSS_METHOD_VBLAST uses EDGES instead.
        /// </summary>
        Lips = 0,
        /// <summary>
        /// Gap between the edges in the middle of the wall: vbss_drain_gap.gap, the paper's
        /// measure.
        /// </summary>
        Edges = 1,
    }

    /// <summary>An event of a session.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SessionEvent
    {
        internal uint StructSize;
        /// <summary>Kind of the event.</summary>
        public SessionEventKind Kind;
        /// <summary>Tool of the event; VBSS_METRICS_TOOL_NONE: none, or not known.</summary>
        public MetricsTool Tool;
        /// <summary>Meaning depends on the kind.</summary>
        public uint Number;
        /// <summary>1: the fact has ceased.</summary>
        public uint Undone;
        /// <summary>STAGE: the stage that the throw has reached.</summary>
        public SessionStage Stage;
        /// <summary>THROW: number of wraps, 1 single, 2 double, ...</summary>
        public int Wraps;
        /// <summary>THROW: +1 right-handed, -1 left-handed.</summary>
        public int Handedness;
        /// <summary>THROW: relation to the throw before.</summary>
        public MetricsRelation Relation;
        /// <summary>The phase after the step of the event.</summary>
        public SessionPhase Phase;
        /// <summary>Ordinal number of the event, from 0 on.</summary>
        public ulong Ordinal;
        /// <summary>Step of the session, from 1 on.</summary>
        public ulong Step;
        /// <summary>Time since the needle's appearance, s, on the clock of the hands.</summary>
        public double Time;
        /// <summary>Position of the tool's tip, or as the kind says, m.</summary>
        public Vector3d Position;
        /// <summary>Force on the tool's hand, N; zero without a tool.</summary>
        public Vector3d Force;
        /// <summary>Meaning depends on the kind.</summary>
        public double Amount;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct SessionConfigData
    {
        internal uint StructSize;
        internal uint Thread;
        internal uint Needle;
        internal uint Drain;
        internal UInts2 Tools;
        internal uint Shears;
        internal uint EventCapacity;
        internal uint KnotInterval;
        internal uint HashInterval;
        internal Pointers2 Devices;
        internal IntPtr Knots;
        internal IntPtr Metrics;
        internal IntPtr Record;
        internal IntPtr Replay;
        internal IntPtr Listen;
        internal IntPtr User;
        internal double TimeLimit;
        internal double Dwell;
        internal double ThrowDwell;
        internal double TailLow;
        internal double TailHigh;
        internal double TailMargin;
        internal double TailReach;
        internal double SeatGap;
        internal double SeatRelease;
        internal double SeatForce;
        internal double AvulsedShare;
        internal double BreakForce;
        internal SessionGap GapMeasure;
        internal uint Coaching;
        internal double LostShare;
        internal SessionExercise Exercise;
        internal uint Reserved;
    }

    /// <summary>
    /// Configuration of a session. Fill it with vbss_session_config_init, then set the numbers of
    /// the bodies.
    /// </summary>
    public sealed unsafe partial class SessionConfig
    {
        private readonly SessionConfigData[] box = new SessionConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public SessionConfig()
        {
            fixed (SessionConfigData* data = box)
            {
                Vblast.Check(Native.vbss_session_config_init(data, (uint)sizeof(SessionConfigData)));
            }
        }

        /// <summary>
        /// Number of the thread in the scene. Its node 0 is at the swage; its last node is the end
        /// of the tail.
        /// </summary>
        public uint Thread
        {
            get { return box[0].Thread; }
            set { box[0].Thread = value; }
        }

        /// <summary>Number of the needle in the scene.</summary>
        public uint Needle
        {
            get { return box[0].Needle; }
            set { box[0].Needle = value; }
        }

        /// <summary>Number of the drain in the scene.</summary>
        public uint Drain
        {
            get { return box[0].Drain; }
            set { box[0].Drain = value; }
        }

        /// <summary>Numbers of the left and the right grasper in the scene.</summary>
        public UInts2 Tools
        {
            get { return box[0].Tools; }
            set { box[0].Tools = value; }
        }

        /// <summary>Number of a third grasper, which cuts; default 0: a tool is exchanged for shears.</summary>
        public uint Shears
        {
            get { return box[0].Shears; }
            set { box[0].Shears = value; }
        }

        /// <summary>Largest number of events that are kept, the newest ones; 8 to 65536; default 1024.</summary>
        public uint EventCapacity
        {
            get { return box[0].EventCapacity; }
            set { box[0].EventCapacity = value; }
        }

        /// <summary>
        /// Number of steps between inputs of the knot detector, 1 to 1000; default 4. The
        /// detector's own step_budget bounds the work of an input.
        /// </summary>
        public uint KnotInterval
        {
            get { return box[0].KnotInterval; }
            set { box[0].KnotInterval = value; }
        }

        /// <summary>
        /// Number of steps between hashes of the task in the log, for replays to compare; 1 to 1e9;
        /// default 100. Steps with events are hashed too. Used only with a record.
        /// </summary>
        public uint HashInterval
        {
            get { return box[0].HashInterval; }
            set { box[0].HashInterval = value; }
        }

        /// <summary>Devices of the left and the right hand; NULL (default): the host moves that tool.</summary>
        public Device[] Devices { get; } = new Device[2];

        /// <summary>
        /// Knot detector, with capacity for the thread and all tools; NULL (default): throws are
        /// not detected.
        /// </summary>
        public KnotDetector Knots { get; set; }

        /// <summary>Metrics; NULL (default): nothing is measured.</summary>
        public Metrics Metrics { get; set; }

        /// <summary>
        /// Record of the scene; NULL (default): nothing is logged. Each step of the session
        /// attaches it (vbss_scene_set_recorder). To log edits before the first step, the host
        /// attaches it.
        /// </summary>
        public Record Record { get; set; }

        /// <summary>
        /// Replay that has begun with the scene, in place of devices and record; NULL (default):
        /// none.
        /// </summary>
        public Replay Replay { get; set; }

        /// <summary>Time limit from the needle's appearance on, s, 1e-3 to 1e6; default 600.</summary>
        public double TimeLimit
        {
            get { return box[0].TimeLimit; }
            set { box[0].TimeLimit = value; }
        }

        /// <summary>Time for which a fact must differ before it changes, s, 0 to 10; default 0.05.</summary>
        public double Dwell
        {
            get { return box[0].Dwell; }
            set { box[0].Dwell = value; }
        }

        /// <summary>
        /// Dwell time of throws and of faults of the knot, s, 0 to 10; default 0.1. A half hitch
        /// takes 20 times as long.
        /// </summary>
        public double ThrowDwell
        {
            get { return box[0].ThrowDwell; }
            set { box[0].ThrowDwell = value; }
        }

        /// <summary>Shortest permitted tail, m, 0 to 1; default 15e-3.</summary>
        public double TailLow
        {
            get { return box[0].TailLow; }
            set { box[0].TailLow = value; }
        }

        /// <summary>Longest permitted tail, m, tail_low to 1; default 20e-3.</summary>
        public double TailHigh
        {
            get { return box[0].TailHigh; }
            set { box[0].TailHigh = value; }
        }

        /// <summary>
        /// Hysteresis of both limits: a tail that is set stays set up to this far beyond them, m, 0
        /// to 1; default 1e-3.
        /// </summary>
        public double TailMargin
        {
            get { return box[0].TailMargin; }
            set { box[0].TailMargin = value; }
        }

        /// <summary>
        /// Largest distance from the end at which a tail counts as grasped, m, 0 to 1; default
        /// 0.01.
        /// </summary>
        public double TailReach
        {
            get { return box[0].TailReach; }
            set { box[0].TailReach = value; }
        }

        /// <summary>
        /// Largest gap of the slit at which a throw becomes seated, m, 0 to 1; default 0.5e-3.
        /// Edges that have crossed do not gape.
        /// </summary>
        public double SeatGap
        {
            get { return box[0].SeatGap; }
            set { box[0].SeatGap = value; }
        }

        /// <summary>Gap at which a throw is no longer seated, m, seat_gap to 1; default 1e-3.</summary>
        public double SeatRelease
        {
            get { return box[0].SeatRelease; }
            set { box[0].SeatRelease = value; }
        }

        /// <summary>Tension of both limbs that seats a throw, N, 0 to 1e3; default 0.5.</summary>
        public double SeatForce
        {
            get { return box[0].SeatForce; }
            set { box[0].SeatForce = value; }
        }

        /// <summary>Share of torn anchors at which the drain counts as torn off, 0 to 1; default 0.5.</summary>
        public double AvulsedShare
        {
            get { return box[0].AvulsedShare; }
            set { box[0].AvulsedShare = value; }
        }

        /// <summary>Tension at which the thread breaks, N, 0 to 1e6; default 0: it never breaks.</summary>
        public double BreakForce
        {
            get { return box[0].BreakForce; }
            set { box[0].BreakForce = value; }
        }

        /// <summary>
        /// Measure of the gap that seats throws and that status, events and metrics report; default
        /// LIPS.
        /// </summary>
        public SessionGap GapMeasure
        {
            get { return box[0].GapMeasure; }
            set { box[0].GapMeasure = value; }
        }

        /// <summary>
        /// 1: the session coaches (session_coaching.h); default 0. The hashes in logs do not depend
        /// on it, but the state of a session that coaches can be restored only to one that coaches,
        /// too.
        /// </summary>
        public uint Coaching
        {
            get { return box[0].Coaching; }
            set { box[0].Coaching = value; }
        }

        /// <summary>
        /// Share of lost time above which TIME_LOST is an event and `is_lossy` is set, 0 to 1;
        /// default 0.02. A trial shorter than 1 s counts as 1 s.
        /// </summary>
        public double LostShare
        {
            get { return box[0].LostShare; }
            set { box[0].LostShare = value; }
        }

        /// <summary>
        /// Exercise that the session trains in place of the whole task (session_exercise.h);
        /// default NONE. The state of an exercise can be restored only to a session with the same
        /// one.
        /// </summary>
        public SessionExercise Exercise
        {
            get { return box[0].Exercise; }
            set { box[0].Exercise = value; }
        }

        internal SessionConfigData* Pin(Pins pins)
        {
            ref SessionConfigData data = ref box[0];
            for (int i = 0; i < 2; i++)
            {
                data.Devices[i] = pins.Handle(Devices[i]);
            }
            data.Knots = pins.Handle(Knots);
            data.Metrics = pins.Handle(Metrics);
            data.Record = pins.Handle(Record);
            data.Replay = pins.Handle(Replay);
            PinCallbacks(pins);
            return (SessionConfigData*)pins.Array(box);
        }

        partial void PinCallbacks(Pins pins);
    }

    /// <summary>Status of a session.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SessionStatus
    {
        internal uint StructSize;
        /// <summary>Phase of the task.</summary>
        public SessionPhase Phase;
        /// <summary>Stage of the throw in progress; NONE if there is none.</summary>
        public SessionStage Stage;
        /// <summary>Reason of the failure; NONE if the task has not failed.</summary>
        public SessionFailure Failure;
        /// <summary>The tool that holds the needle, the first of two; VBSS_METRICS_TOOL_NONE: none.</summary>
        public MetricsTool Holder;
        /// <summary>Bits: 1 the hole in exists, 2 the hole out exists.</summary>
        public uint Punctured;
        /// <summary>Bits: 1 the thread goes through the hole in, 2 through the hole out.</summary>
        public uint Threaded;
        /// <summary>1: the tail has a permitted length.</summary>
        public uint TailSet;
        /// <summary>Number of tied throws.</summary>
        public uint Throws;
        /// <summary>Number of seated throws, counted from the tissue.</summary>
        public uint Seated;
        /// <summary>Number of needle transfers between throws, at most two.</summary>
        public uint Transfers;
        /// <summary>Bits: 1 the short tail is cut, 2 the needle's tail is cut.</summary>
        public uint Cut;
        /// <summary>Faults of the knot, VBSS_KNOT_FAULT_ bits, as last reported by events.</summary>
        public KnotFaultBits Faults;
        /// <summary>Number of events that did not fit into the metrics.</summary>
        public uint MetricsLost;
        /// <summary>Number of steps.</summary>
        public ulong Steps;
        /// <summary>Ordinal of the oldest event that is kept; this is also the number of lost events.</summary>
        public ulong FirstEvent;
        /// <summary>Number of events.</summary>
        public ulong EventCount;
        /// <summary>
        /// Time since the needle's appearance until the end or now, s, on the clock of the hands.
        /// It includes `time_lost`.
        /// </summary>
        public double Time;
        /// <summary>Length of the short tail from the hole on, m; 0 without a tail.</summary>
        public double Tail;
        /// <summary>Gap of the slit's middle by `gap_measure`, m.</summary>
        public double Gap;
        /// <summary>Largest tension of the short limb and of the needle's limb, N.</summary>
        public Doubles2 Tension;
        /// <summary>Deviation of each hole from its mark, mm.</summary>
        public Doubles2 DeviationMm;
        /// <summary>
        /// Part of `time` that the scene has left out, s. It counts paused steps
        /// (vbss_scene_statistics::time_paused) and truncated substeps
        /// (VBSS_SCENE_EVENT_TRUNCATED), from the second step on.
        /// </summary>
        public double TimeLost;
        /// <summary>
        /// Time that was simulated, s: `time` minus `time_lost`. Up to two steps of it may still be
        /// deferred (vbss_scene_statistics::behind).
        /// </summary>
        public double TimeSimulated;
        /// <summary>1: more than `lost_share` of the time is lost, with hysteresis.</summary>
        public uint IsLossy;
        internal uint Reserved;
        /// <summary>VBSS_SESSION_AID_ bits of the aids in the last step.</summary>
        public SessionAidBits Aids;
        /// <summary>Bits of all aids that were on during the task; 0: it is not assisted.</summary>
        public uint AidsUsed;
    }
}
