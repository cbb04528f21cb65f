// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>The measurement of one trial.</summary>
    public sealed unsafe partial class Metrics : VbssObject
    {
        internal Metrics(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>The state, to go back to it or to go on elsewhere to the same bits.</summary>
        public byte[] Save()
        {
            return SaveState(Native.vbss_metrics_save);
        }

        /// <summary>Goes to a state that was saved from this object, or from one made alike. A failed call changes nothing.</summary>
        public void Restore(ReadOnlySpan<byte> state)
        {
            fixed (byte* bytes = state)
            {
                Context.Check(Native.vbss_metrics_restore(Handle, bytes, (ulong)state.Length));
            }
        }

        /// <summary>A read-only array inside the library; see <see cref="View"/>.</summary>
        public View GetView(MetricsField field)
        {
            return new View(this, (int)field, false, (handle, number, view, size) =>
                Native.vbss_metrics_get_view(handle, (MetricsField)number, view, size));
        }

        /// <summary>Creates an empty measurement and allocates all memory that it needs.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">configuration; NULL for the defaults</param>
        public Metrics(Context context, MetricsConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr metrics;
                Context.Check(Native.vbss_metrics_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out metrics));
                Adopt(metrics, Native.vbss_metrics_destroy, pins);
            }
        }

        /// <summary>
        /// Adds a sample. A tool that was not seen for more than 0.1 s starts a new run where it
        /// reappears; the gap adds no path. A position that the hand cannot have reached with
        /// `max_speed` is an outlier. It is counted and left out, and the curve bridges it like a
        /// lost sample. Later positions that are nearer to the outlier are outliers, too. After 0.1
        /// s of outliers the tool has jumped: it counts as not seen for that time, and a new run
        /// starts at its position. The call allocates nothing; motion beyond `duration` is counted
        /// as lost.
        /// </summary>
        /// <param name="sample">the sample</param>
        public void AddSample(MetricsSample sample)
        {
            using (Pins pins = Pins.Rent())
            {
                Context.Check(Native.vbss_metrics_add_sample(Handle, sample == null ? null : sample.Pin(pins)));
            }
        }

        /// <summary>Adds an event, also after vbss_metrics_finish.</summary>
        /// <param name="event">the event</param>
        public void AddEvent(MetricsEvent @event)
        {
            using (Pins pins = Pins.Rent())
            {
                Context.Check(Native.vbss_metrics_add_event(Handle, @event == null ? null : @event.Pin(pins)));
            }
        }

        /// <summary>Adds a reading of the pull test, also after vbss_metrics_finish.</summary>
        /// <param name="pull">the reading</param>
        public void AddPull(MetricsPull pull)
        {
            using (Pins pins = Pins.Rent())
            {
                Context.Check(Native.vbss_metrics_add_pull(Handle, pull == null ? null : pull.Pin(pins)));
            }
        }

        /// <summary>
        /// Ends the samples: computes the motion up to the last one and refuses further samples. A
        /// second call does nothing.
        /// </summary>
        public void Finish()
        {
            Context.Check(Native.vbss_metrics_finish(Handle));
        }

        /// <summary>Returns the results of the trial so far.</summary>
        public MetricsReport GetReport()
        {
            MetricsReport report;
            Context.Check(Native.vbss_metrics_get_report(Handle, &report, (uint)sizeof(MetricsReport)));
            return report;
        }

        /// <summary>Returns one record of a throw.</summary>
        /// <param name="index">0 to throw_records - 1</param>
        public MetricsThrow GetThrow(uint index)
        {
            MetricsThrow record;
            Context.Check(Native.vbss_metrics_get_throw(Handle, index, &record, (uint)sizeof(MetricsThrow)));
            return record;
        }

        /// <summary>Returns one visit of a phase.</summary>
        /// <param name="index">0 to phase_count - 1</param>
        public MetricsPhase GetPhase(uint index)
        {
            MetricsPhase phase;
            Context.Check(Native.vbss_metrics_get_phase(Handle, index, &phase, (uint)sizeof(MetricsPhase)));
            return phase;
        }

        /// <summary>
        /// Returns the motion of a tool. The call takes some ms for a minute of motion; do not call
        /// it in every step.
        /// </summary>
        /// <param name="tool">VBSS_METRICS_TOOL_LEFT or VBSS_METRICS_TOOL_RIGHT</param>
        /// <param name="phase">index of a visit of a phase, or VBSS_METRICS_PHASE_ALL</param>
        public MetricsMotion GetMotion(MetricsTool tool, int phase)
        {
            MetricsMotion motion;
            Context.Check(Native.vbss_metrics_get_motion(Handle, tool, phase, &motion, (uint)sizeof(MetricsMotion)));
            return motion;
        }

        /// <summary>Returns the joint motion of both tools.</summary>
        /// <param name="phase">index of a visit of a phase, or VBSS_METRICS_PHASE_ALL</param>
        public MetricsBimanual GetBimanual(int phase)
        {
            MetricsBimanual bimanual;
            Context.Check(Native.vbss_metrics_get_bimanual(Handle, phase, &bimanual, (uint)sizeof(MetricsBimanual)));
            return bimanual;
        }

        /// <summary>
        /// Computes the offset of a place on a cylinder from a mark on it, as the event of a
        /// puncture needs it.
        /// </summary>
        /// <param name="axis">direction of the axis through `centre`, of any length</param>
        /// <param name="centre">a point on the axis, m</param>
        /// <param name="mark">the mark, m; only its direction from the axis and its position along it matter</param>
        /// <param name="place">the place, m; only its direction from the axis and its position along it matter</param>
        /// <param name="angleResult">from mark to place about the axis, right-handed, -pi to pi, rad</param>
        /// <param name="axialResult">from mark to place along the axis, m</param>
        public static void GetOffset(Vector3d axis, Vector3d centre, Vector3d mark, Vector3d place, out double angleResult, out double axialResult)
        {
            double angle;
            double axial;
            Vblast.Check(Native.vbss_metrics_get_offset((double*)&axis, (double*)&centre, (double*)&mark, (double*)&place, (double*)&angle, (double*)&axial));
            angleResult = angle;
            axialResult = axial;
        }

        /// <summary>
        /// Returns a hash of the whole measurement; equal logs give equal hashes on every machine.
        /// The cost grows with the length of the trial; do not call it in every step.
        /// </summary>
        public ulong GetHash()
        {
            ulong hash;
            Context.Check(Native.vbss_metrics_get_hash(Handle, (ulong*)&hash));
            return hash;
        }
    }
}
