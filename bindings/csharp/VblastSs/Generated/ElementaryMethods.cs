// Written by bindings/csharp/generate.py from the public headers: do not edit.
namespace VblastSs
{
    /// <summary>Functions of elementary.h that need no object.</summary>
    public static unsafe partial class Elementary
    {
        /// <summary>
        /// Sine; the error is below 0.51 ulp for every argument, however large. Odd to the bit:
        /// sin(-x) = -sin(x), and a zero keeps its sign.
        /// </summary>
        /// <param name="angle">rad; any double</param>
        public static double Sin(double angle)
        {
            return Native.vbss_sin(angle);
        }

        /// <summary>
        /// Cosine; the error is below 0.51 ulp for every argument, however large. Even to the bit:
        /// cos(-x) = cos(x).
        /// </summary>
        /// <param name="angle">rad; any double</param>
        public static double Cos(double angle)
        {
            return Native.vbss_cos(angle);
        }

        /// <summary>
        /// The angle of a point in the plane, from the x axis towards the y axis; the error is
        /// below 0.52 ulp. Zeros and infinities are as in C11 Annex F: atan2(+-0, x) is +-0 for x
        /// &gt; 0 or +0, and +-pi for x &lt; 0 or -0; two infinities denote a point on a diagonal.
        /// </summary>
        /// <param name="y">coordinate on the y axis, any unit; any double</param>
        /// <param name="x">coordinate on the x axis, the same unit; any double</param>
        public static double Atan2(double y, double x)
        {
            return Native.vbss_atan2(y, x);
        }

        /// <summary>Arc cosine; the error is below 0.51 ulp. acos(1) is +0.</summary>
        /// <param name="cosine">-1 to 1; any other double gives NaN</param>
        public static double Acos(double cosine)
        {
            return Native.vbss_acos(cosine);
        }
    }
}
