// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>Finds knots in a thread, step by step.</summary>
    public sealed unsafe partial class KnotDetector : VbssObject
    {
        internal KnotDetector(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>The state, to go back to it or to go on elsewhere to the same bits.</summary>
        public byte[] Save()
        {
            return SaveState(Native.vbss_knot_detector_save);
        }

        /// <summary>Goes to a state that was saved from this object, or from one made alike. A failed call changes nothing.</summary>
        public void Restore(ReadOnlySpan<byte> state)
        {
            fixed (byte* bytes = state)
            {
                Context.Check(Native.vbss_knot_detector_restore(Handle, bytes, (ulong)state.Length));
            }
        }

        /// <summary>A read-only array inside the library; see <see cref="View"/>.</summary>
        public View GetView(KnotField field)
        {
            return new View(this, (int)field, false, (handle, number, view, size) =>
                Native.vbss_knot_detector_get_view(handle, (KnotField)number, view, size));
        }

        /// <summary>Creates a detector without a history and allocates all memory that it needs.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">configuration; NULL for the defaults</param>
        public KnotDetector(Context context, KnotDetectorConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr detector;
                Context.Check(Native.vbss_knot_detector_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out detector));
                Adopt(detector, Native.vbss_knot_detector_destroy, pins);
            }
        }

        /// <summary>
        /// Processes the thread and the tools of a step: updates the winding, works on the topology
        /// within the work limit, begins a new reading when it is due, and reports changes as
        /// events. The call allocates nothing.
        /// </summary>
        /// <param name="input">the input; the same tools in the same order in every step</param>
        public void Step(KnotInput input)
        {
            using (Pins pins = Pins.Rent())
            {
                Context.Check(Native.vbss_knot_detector_step(Handle, input == null ? null : input.Pin(pins)));
            }
        }

        /// <summary>
        /// Processes an input like vbss_knot_detector_step, but without a work limit: it abandons
        /// an unfinished reading and reads this input to the end.
        /// </summary>
        /// <param name="input">the input</param>
        public void Judge(KnotInput input)
        {
            using (Pins pins = Pins.Rent())
            {
                Context.Check(Native.vbss_knot_detector_judge(Handle, input == null ? null : input.Pin(pins)));
            }
        }

        /// <summary>
        /// Resets a detector to its state after creation, with its statistics and its count of
        /// steps.
        /// </summary>
        public void Reset()
        {
            Context.Check(Native.vbss_knot_detector_reset(Handle));
        }

        /// <summary>Returns the state of a detector.</summary>
        public KnotState GetState()
        {
            KnotState state;
            Context.Check(Native.vbss_knot_detector_get_state(Handle, &state, (uint)sizeof(KnotState)));
            return state;
        }

        /// <summary>Returns one throw of the knot.</summary>
        /// <param name="number">0 (nearest to the tissue) to throw_count - 1</param>
        public KnotThrow GetThrow(uint number)
        {
            KnotThrow knotThrow;
            Context.Check(Native.vbss_knot_detector_get_throw(Handle, number, &knotThrow, (uint)sizeof(KnotThrow)));
            return knotThrow;
        }

        /// <summary>Returns the winding of the thread about one tool.</summary>
        /// <param name="tool">index of the tool, 0 to tool_count - 1 of the last input</param>
        public KnotWinding GetWinding(uint tool)
        {
            KnotWinding winding;
            Context.Check(Native.vbss_knot_detector_get_winding(Handle, tool, &winding, (uint)sizeof(KnotWinding)));
            return winding;
        }

        /// <summary>Returns counts since creation or reset.</summary>
        public KnotDetectorStatistics GetStatistics()
        {
            KnotDetectorStatistics statistics;
            Context.Check(Native.vbss_knot_detector_get_statistics(Handle, &statistics, (uint)sizeof(KnotDetectorStatistics)));
            return statistics;
        }

        /// <summary>
        /// Returns a hash of the detector's state; equal histories give equal hashes on every
        /// machine.
        /// </summary>
        public ulong GetHash()
        {
            ulong hash;
            Context.Check(Native.vbss_knot_detector_get_hash(Handle, (ulong*)&hash));
            return hash;
        }
    }
}
