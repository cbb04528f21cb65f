// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>An output stage on its own, for hosts with their own device layer.</summary>
    public sealed unsafe partial class Output : VbssObject
    {
        internal Output(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>Creates an output stage.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">its limits; NULL for the defaults</param>
        public Output(Context context, OutputConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr output;
                Context.Check(Native.vbss_output_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out output));
                Adopt(output, Native.vbss_output_destroy, pins);
            }
        }

        /// <summary>Applies the limits to a command. The call allocates nothing.</summary>
        /// <param name="h">time since the last step, s, 0 to 1e6</param>
        /// <param name="command">the command; NULL: no new command since the last one, which ages together with its pose</param>
        public OutputResult Step(double h, OutputCommand command)
        {
            using (Pins pins = Pins.Rent())
            {
                OutputResult result;
                Context.Check(Native.vbss_output_step(Handle, h, command == null ? null : command.Pin(pins), &result, (uint)sizeof(OutputResult)));
                return result;
            }
        }

        /// <summary>Latches the emergency stop: all results are zero until vbss_output_clear_emergency_stop.</summary>
        public void LatchEmergencyStop()
        {
            Context.Check(Native.vbss_output_latch_emergency_stop(Handle));
        }

        /// <summary>Clears the emergency stop.</summary>
        public void ClearEmergencyStop()
        {
            Context.Check(Native.vbss_output_clear_emergency_stop(Handle));
        }

        /// <summary>Returns the counters since creation.</summary>
        public OutputStatistics GetStatistics()
        {
            OutputStatistics statistics;
            Context.Check(Native.vbss_output_get_statistics(Handle, &statistics, (uint)sizeof(OutputStatistics)));
            return statistics;
        }
    }
}
