// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>
    /// An adapter without hardware: driven by a function of time or by samples, with faults on
    /// demand.
    /// </summary>
    public sealed unsafe partial class Mock : VbssObject
    {
        internal Mock(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>A read-only array inside the library; see <see cref="View"/>.</summary>
        public View GetView(MockField field)
        {
            return new View(this, (int)field, false, (handle, number, view, size) =>
                Native.vbss_mock_get_view(handle, (MockField)number, view, size));
        }

        /// <summary>Creates a mock.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">the configuration; NULL for the defaults</param>
        public Mock(Context context, MockConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr mock;
                Context.Check(Native.vbss_mock_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out mock));
                Adopt(mock, Native.vbss_mock_destroy, pins);
            }
        }

        /// <summary>
        /// Sets the sample that later reads return, unless the mock has a function of time. Reads
        /// return it unchecked, even with invalid numbers; faults act on it afterwards.
        /// </summary>
        /// <param name="sample">an initialised sample</param>
        public void SetSample(DeviceSample sample)
        {
            using (Pins pins = Pins.Rent())
            {
                Context.Check(Native.vbss_mock_set_sample(Handle, sample == null ? null : sample.Pin(pins)));
            }
        }

        /// <summary>
        /// Adds a fault. STALL, RATE, LATE and SHUFFLE need a function of time; faults act in the
        /// order they were added.
        /// </summary>
        /// <param name="fault">the fault</param>
        /// <param name="from">first `now` with the fault, s</param>
        /// <param name="until">first `now` without the fault, s, not before `from`; up to 1e9</param>
        /// <param name="value">
        /// value of the fault; RATE, SHUFFLE: 1e-6 to 1e3, LATE: 0 to 1e3, NAN: 0 to 4, others: up
        /// to 1e9
        /// </param>
        public void AddFault(MockFault fault, double from, double until, double value)
        {
            Context.Check(Native.vbss_mock_add_fault(Handle, fault, from, until, value));
        }

        /// <summary>Removes all faults.</summary>
        public void ClearFaults()
        {
            Context.Check(Native.vbss_mock_clear_faults(Handle));
        }

        /// <summary>Clears the rows of the writes.</summary>
        public void ClearRows()
        {
            Context.Check(Native.vbss_mock_clear_rows(Handle));
        }

        /// <summary>Returns the counters since creation.</summary>
        public MockStatistics GetStatistics()
        {
            MockStatistics statistics;
            Context.Check(Native.vbss_mock_get_statistics(Handle, &statistics, (uint)sizeof(MockStatistics)));
            return statistics;
        }
    }
}
