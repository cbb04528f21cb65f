// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>
    /// The constants of vbss_record_input_kind, with their words and their numbers. The log format
    /// uses the same constants.
    /// </summary>
    public enum RecordInputKind : int
    {
        /// <summary>Words: body, 1 if turned. Numbers: position (3), orientation (4).</summary>
        RigidTarget = 1,
        /// <summary>Words: thread, node, body, 1 if at a point. Numbers: point (3).</summary>
        Pin = 2,
        /// <summary>Words: pin.</summary>
        Unpin = 3,
        /// <summary>
        /// Words: thread, kind, node. Numbers: position (3), direction (3), force (3), stiffness,
        /// damping, mass.
        /// </summary>
        Attach = 4,
        /// <summary>Words: thread, attachment, 1 if directed. Numbers: target (3), direction (3).</summary>
        AttachmentTarget = 5,
        /// <summary>Words: thread, attachment.</summary>
        Detach = 6,
        /// <summary>Words: thread. Numbers: arc length.</summary>
        Cut = 7,
        /// <summary>Words: grasper, 1 if turned. Numbers: position (3), orientation (4).</summary>
        GrasperTarget = 8,
        /// <summary>Words: grasper. Numbers: opening.</summary>
        SetOpening = 9,
        /// <summary>Words: grasper, kind.</summary>
        Exchange = 10,
        /// <summary>
        /// A change of scene_settings.h. Words: vbss_scene_setting, body (0 where the setting has
        /// none), and two words of the setting. Numbers: those of the setting.
        /// </summary>
        Setting = 11,
        /// <summary>vbss_scene_make_hole. Words: body, drain, triangle. Numbers: arc length, weights (3).</summary>
        Hole = 12,
        /// <summary>vbss_scene_remove. Words: body.</summary>
        Remove = 13,
        /// <summary>
        /// vbss_drain_attach. Words: drain, kind, node. Numbers: position (3), force (3),
        /// stiffness.
        /// </summary>
        DrainAttach = 14,
        /// <summary>vbss_drain_set_attachment_target. Words: drain, attachment. Numbers: target (3).</summary>
        DrainTarget = 15,
        /// <summary>vbss_drain_detach. Words: drain, attachment.</summary>
        DrainDetach = 16,
        /// <summary>vbss_thread_set_roll. Words: thread, attachment. Numbers: roll.</summary>
        Roll = 17,
    }

    /// <summary>
    /// The constants of vbss_scene_setting: functions of scene_settings.h, with the third and
    /// fourth word of an input, if it has any, and its numbers.
    /// </summary>
    public enum SceneSetting : int
    {
        /// <summary>vbss_scene_set_gravity. Numbers: gravity (3).</summary>
        Gravity = 1,
        /// <summary>vbss_scene_set_friction. Numbers: friction.</summary>
        Friction = 2,
        /// <summary>vbss_scene_set_thread_friction. Numbers: friction.</summary>
        ThreadFriction = 3,
        /// <summary>
        /// vbss_scene_set_coupling. Numbers: stiffness, damping, turning stiffness, turning
        /// damping.
        /// </summary>
        Coupling = 4,
        /// <summary>vbss_scene_set_speed_limit. Numbers: limit.</summary>
        SpeedLimit = 5,
        /// <summary>vbss_scene_set_filter. Words: category, mask.</summary>
        Filter = 6,
        /// <summary>
        /// vbss_scene_apply_force. Words: 1 if at a point, 1 with a torque. Numbers: force (3),
        /// point (3), torque (3).
        /// </summary>
        Force = 7,
        /// <summary>
        /// vbss_scene_set_rigid_velocity. Words: 1 if turned. Numbers: velocity (3), angular
        /// velocity (3).
        /// </summary>
        Velocity = 8,
        /// <summary>vbss_scene_set_rigid_pose. Words: 1 if turned. Numbers: position (3), orientation (4).</summary>
        Pose = 9,
        /// <summary>vbss_scene_set_budgets. Numbers: step budget, call budget, operations per us.</summary>
        Budgets = 10,
    }

    /// <summary>The constants of vbss_record_event_kind that are no vbss_scene_event_kind.</summary>
    public enum RecordEventKind : int
    {
        /// <summary>TRUNCATED or PAUSED: 0, 0, and the share of the step that was left out, in 65536ths.</summary>
        TimeLost = 3,
        /// <summary>Events of a step exceeded event_capacity: 0, 0, and the number of lost events.</summary>
        Lost = 4,
    }

    /// <summary>The constants of vbss_replay_outcome.</summary>
    public enum ReplayOutcome : int
    {
        /// <summary>The replay has not ended; all hashes so far agree.</summary>
        Stepped = 0,
        /// <summary>The log has ended with its end record; all hashes agree.</summary>
        Ended = 1,
        /// <summary>The state after `step` is not the recorded one.</summary>
        Differs = 2,
        /// <summary>The call has failed: the log is truncated or damaged, or the scene refused a step.</summary>
        Stopped = 3,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct RecordConfigData
    {
        internal uint StructSize;
        internal uint HashInterval;
        internal uint InputCapacity;
        internal uint NoteBytes;
        internal ulong BufferBytes;
        internal IntPtr Note;
        internal uint SnapshotInterval;
        internal uint Reserved;
    }

    /// <summary>Configuration of a record. Fill it with vbss_record_config_init, then change fields.</summary>
    public sealed unsafe partial class RecordConfig
    {
        private readonly RecordConfigData[] box = new RecordConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public RecordConfig()
        {
            fixed (RecordConfigData* data = box)
            {
                Vblast.Check(Native.vbss_record_config_init(data, (uint)sizeof(RecordConfigData)));
            }
        }

        /// <summary>Number of steps between hashes of the state, 1 to 1e9; default 1.</summary>
        public uint HashInterval
        {
            get { return box[0].HashInterval; }
            set { box[0].HashInterval = value; }
        }

        /// <summary>Largest number of inputs before a step, 0 to 65536; default 64.</summary>
        public uint InputCapacity
        {
            get { return box[0].InputCapacity; }
            set { box[0].InputCapacity = value; }
        }

        /// <summary>Size of the note, at most 2^24; default 0.</summary>
        public uint NoteBytes
        {
            get { return box[0].NoteBytes; }
            set { box[0].NoteBytes = value; }
        }

        /// <summary>
        /// Size of the buffer for bytes that the host has not taken yet, without the beginning of
        /// the log, bytes, 4096 to 2^30; default 2^20. A step is coded in at most 274 bytes when
        /// two rigid bodies move, and 332 when two graspers move and open. Smooth movements take
        /// about a tenth of that in the log.
        /// </summary>
        public ulong BufferBytes
        {
            get { return box[0].BufferBytes; }
            set { box[0].BufferBytes = value; }
        }

        /// <summary>
        /// Data of the host that the log stores, such as a description of its scene; default NULL,
        /// allowed when note_bytes is 0. The library copies it.
        /// </summary>
        public byte[] Note { get; set; }

        /// <summary>
        /// Number of steps between snapshots of the scene in the log, 0 to 1e9; default 2000. With
        /// 0 there is only the first snapshot. vbss_replay_seek starts from snapshots. A snapshot
        /// that does not fit in the buffer is written after a later step.
        /// </summary>
        public uint SnapshotInterval
        {
            get { return box[0].SnapshotInterval; }
            set { box[0].SnapshotInterval = value; }
        }

        internal RecordConfigData* Pin(Pins pins)
        {
            ref RecordConfigData data = ref box[0];
            uint? countedNoteBytes = null;
            data.Note = pins.Array(Note);
            if (Note != null)
            {
                data.NoteBytes = pins.Count(nameof(Note), Note.Length, 1, 0, ref countedNoteBytes);
            }
            return (RecordConfigData*)pins.Array(box);
        }
    }

    /// <summary>One input of the host.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct RecordInput
    {
        /// <summary>Kind of the input.</summary>
        public RecordInputKind Kind;
        /// <summary>Number of valid entries in `words`.</summary>
        public uint WordCount;
        /// <summary>Number of valid entries in `numbers`.</summary>
        public uint NumberCount;
        internal uint Reserved;
        /// <summary>Words; vbss_record_input_kind lists their meanings.</summary>
        public UInts4 Words;
        /// <summary>Numbers; vbss_record_input_kind lists their meanings.</summary>
        public Doubles12 Numbers;
    }

    /// <summary>A step as the log describes it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ReplayLoggedStep
    {
        internal uint StructSize;
        /// <summary>1: `hash` is valid.</summary>
        public uint Hashed;
        /// <summary>Number of the step, from 1 on.</summary>
        public ulong Number;
        /// <summary>Hash of the scene after the step; 0 if it was not hashed.</summary>
        public ulong Hash;
        /// <summary>Byte of the log just after this step.</summary>
        public ulong Position;
        /// <summary>Length of the step, s.</summary>
        public double H;
        /// <summary>Sum of the lengths of the steps up to this one, s: the clock of the hands.</summary>
        public double Time;
        internal IntPtr Inputs;
        internal IntPtr Events;
        /// <summary>Number of inputs.</summary>
        public uint InputCount;
        /// <summary>Number of events; each has four words.</summary>
        public uint EventCount;
        /// <summary>
        /// Part of `h` that the scene has left out, s, by its VBSS_RECORD_EVENT_TIME_LOST events.
        /// Each is up to h / 65536 too small. A step may report the time of an earlier paused step.
        /// </summary>
        public double TimeLost;
    }

    /// <summary>Contents and faults of a log. The counts cover its good part, before the first fault.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct RecordLogReport
    {
        internal uint StructSize;
        /// <summary>
        /// VBSS_OK, or the result of the first fault; VBSS_ERROR_TRUNCATED when the log is
        /// truncated.
        /// </summary>
        public Result Result;
        /// <summary>1: the log has its end record.</summary>
        public uint Ended;
        /// <summary>Number of faults. The arrays below hold the first eight.</summary>
        public uint FaultCount;
        /// <summary>Size of the log.</summary>
        public ulong LogBytes;
        /// <summary>Size of its good part, which can be replayed.</summary>
        public ulong GoodBytes;
        /// <summary>Number of complete steps.</summary>
        public ulong Steps;
        /// <summary>Number of inputs before these steps.</summary>
        public ulong Inputs;
        /// <summary>Number of events in these steps.</summary>
        public ulong Events;
        /// <summary>Number of snapshots, the first one included.</summary>
        public ulong Snapshots;
        /// <summary>Sum of the lengths of these steps, s: the clock of the hands.</summary>
        public double Time;
        /// <summary>Positions of the faults, as bytes of the log.</summary>
        public ULongs8 FaultPositions;
        internal Pointers8 FaultProblems;
        /// <summary>VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT or VBSS_ERROR_DATA_VERSION.</summary>
        public Results8 FaultResults;
        /// <summary>Part of `time` that the scene has left out, s; see vbss_replay_logged_step.time_lost.</summary>
        public double TimeLost;
    }

    /// <summary>General information on a log.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ReplayInfo
    {
        internal uint StructSize;
        /// <summary>Version of the library that wrote the log, as VBSS_VERSION_NUM.</summary>
        public uint LibraryVersion;
        /// <summary>Number of steps between hashes.</summary>
        public uint HashInterval;
        /// <summary>Size of the note.</summary>
        public uint NoteBytes;
        /// <summary>Size of the first snapshot, unpacked.</summary>
        public ulong SnapshotBytes;
        /// <summary>Size of the log, truncated and damaged parts included.</summary>
        public ulong LogBytes;
        internal IntPtr BuildInfo;
        internal IntPtr Note;
    }

    /// <summary>Position and outcome of a replay.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ReplayReport
    {
        internal uint StructSize;
        /// <summary>Outcome so far.</summary>
        public ReplayOutcome Outcome;
        /// <summary>Number of the last step that was made, from 1 on; 0: no step.</summary>
        public ulong Step;
        /// <summary>
        /// Number of the last step whose recorded hash agrees; 0: only the initial state agrees.
        /// The first step that differs comes after this one, and not after `step`.
        /// </summary>
        public ulong AgreedStep;
        /// <summary>Recorded hash after `step`; 0 if none was recorded.</summary>
        public ulong RecordedHash;
        /// <summary>Hash of the replayed scene after `step`; 0 if none was recorded.</summary>
        public ulong FoundHash;
        /// <summary>Byte of the log at which the next record begins.</summary>
        public ulong Position;
    }
}
