using System;

namespace VblastSs
{
    public sealed unsafe partial class Record
    {
        /// <summary>Takes the bytes that have been logged since the last call.</summary>
        public byte[] Take()
        {
            byte* first;
            ulong count;
            Context.Check(Native.vbss_record_take(Handle, &first, &count));
            return new ReadOnlySpan<byte>(first, checked((int)count)).ToArray();
        }

        /// <summary>Checks a whole log, damaged ones too; returns a description of each of the first eight faults.</summary>
        public static string[] CheckLog(Context context, ReadOnlySpan<byte> log, out RecordLogReport report)
        {
            RecordLogReport filled;
            fixed (byte* bytes = log)
            {
                context.Check(Native.vbss_record_check_log(context.Handle, bytes, (ulong)log.Length, &filled, (uint)sizeof(RecordLogReport)));
            }
            report = filled;
            var problems = new string[Math.Min(filled.FaultCount, (uint)filled.FaultProblems.Length)];
            for (int i = 0; i < problems.Length; i++)
            {
                problems[i] = Vblast.Text(filled.FaultProblems[i]);
            }
            return problems;
        }
    }

    public sealed unsafe partial class Replay
    {
        /// <summary>A replay of a log, of which it keeps a copy.</summary>
        public Replay(Context context, ReadOnlySpan<byte> log)
            : base(context)
        {
            using (Pins pins = Pins.Rent())
            {
                var root = new NativeRoot(log.ToArray());
                pins.Roots.Add(root);
                IntPtr replay;
                context.Check(Native.vbss_replay_create(context.Handle, (byte*)root.Pointer, (ulong)log.Length, out replay));
                Adopt(replay, Native.vbss_replay_destroy, pins);
            }
        }

        /// <summary>Facts about the log; note receives the host's data, buildInfo the library that wrote it.</summary>
        public ReplayInfo GetInfo(out byte[] note, out string buildInfo)
        {
            ReplayInfo info;
            Context.Check(Native.vbss_replay_get_info(Handle, &info, (uint)sizeof(ReplayInfo)));
            note = new ReadOnlySpan<byte>((void*)info.Note, checked((int)info.NoteBytes)).ToArray();
            buildInfo = Vblast.Text(info.BuildInfo);
            return info;
        }

        /// <summary>A step of the log by its number, with copies of its inputs and of its events, four words each.</summary>
        public ReplayLoggedStep Read(ulong number, out RecordInput[] inputs, out uint[] events)
        {
            ReplayLoggedStep step;
            Context.Check(Native.vbss_replay_read(Handle, number, &step, (uint)sizeof(ReplayLoggedStep)));
            inputs = new ReadOnlySpan<RecordInput>((void*)step.Inputs, checked((int)step.InputCount)).ToArray();
            events = new ReadOnlySpan<uint>((void*)step.Events, checked((int)(4 * step.EventCount))).ToArray();
            return step;
        }
    }
}
