// Written by bindings/csharp/generate.py from the public headers: do not edit.
namespace VblastSs
{
    /// <summary>Functions of base.h that need no object.</summary>
    public static unsafe partial class Vblast
    {
        /// <summary>Returns the version of the running library, in the form of VBSS_VERSION_NUM.</summary>
        public static uint Version()
        {
            return Native.vbss_version();
        }

        /// <summary>
        /// Returns build information: version with its suffix, source revision, compiler, and the
        /// flags that matter for reproducible results.
        /// </summary>
        public static string BuildInfo()
        {
            return Vblast.Text(Native.vbss_build_info());
        }

        /// <summary>Returns the name of a status, such as "VBSS_ERROR_CAPACITY".</summary>
        /// <param name="result">any number</param>
        public static string ResultName(Result result)
        {
            return Vblast.Text(Native.vbss_result_name(result));
        }

        /// <summary>Returns a description of a status.</summary>
        /// <param name="result">any number</param>
        public static string ResultString(Result result)
        {
            return Vblast.Text(Native.vbss_result_string(result));
        }

        /// <summary>
        /// Checks whether the calling thread rounds to nearest and keeps subnormal numbers. Hosts
        /// linked with fast-math flags often flush them to zero. The library computes in its own
        /// mode, so the answer concerns the arithmetic of the host only, such as the computation of
        /// poses.
        /// </summary>
        public static void ArithmeticCheck()
        {
            Vblast.Check(Native.vbss_arithmetic_check());
        }
    }

    /// <summary>
    /// Owner of all objects, their memory and their error texts. One thread at a time may use it;
    /// the library detects a second one (VBSS_ERROR_BUSY).
    /// </summary>
    public sealed unsafe partial class Context
    {
        /// <summary>Returns the memory and objects of a context.</summary>
        public ContextStatistics GetStatistics()
        {
            ContextStatistics statistics;
            Check(Native.vbss_context_get_statistics(Handle, &statistics, (uint)sizeof(ContextStatistics)));
            return statistics;
        }
    }
}
