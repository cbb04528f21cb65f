// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>Speed of the processor core on which a measurement ran.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct CoreSpeed
    {
        internal uint StructSize;
        /// <summary>Number of timed steps of the fixed scene.</summary>
        public uint Steps;
        /// <summary>
        /// Speed for vbss_solver_options::operations_per_us, operations per us; &gt; 0. A few
        /// hundred on a core of 2.6 GHz. A quarter of the steps were at least as fast. Steps that
        /// other programs have interrupted do not affect it, as long as they are fewer than three
        /// quarters.
        /// </summary>
        public double OperationsPerUs;
        /// <summary>
        /// Median time of the steps divided by their lower quartile, at least 1. A value far above
        /// 1 means that other programs have often interrupted the measurement.
        /// </summary>
        public double Spread;
        /// <summary>Time of all timed steps on the host's clock, s.</summary>
        public double Duration;
    }
}
