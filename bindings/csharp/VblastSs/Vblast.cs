using System;
using System.Runtime.InteropServices;
using System.Text;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
#if UNITY_IOS && !UNITY_EDITOR
        internal const string Library = "__Internal";
#else
        internal const string Library = "vblast_ss";
#endif
    }

    public static unsafe partial class Vblast
    {
        internal static void Check(Result status)
        {
            if (status != Result.Ok)
            {
                throw new VbssException(status, ResultString(status));
            }
        }

        /// <summary>A copy of a text of the library, which is UTF-8.</summary>
        internal static string Text(IntPtr text)
        {
            if (text == IntPtr.Zero)
            {
                return null;
            }
            int count = 0;
            while (((byte*)text)[count] != 0)
            {
                count++;
            }
            return Encoding.UTF8.GetString((byte*)text, count);
        }

        /// <summary>Refuses a library that is older than this assembly, or of another major version.</summary>
        internal static void RequireVersion()
        {
            uint version = Version();
            if (version / 10000 != HeaderVersion.VersionMajor || version / 100 % 100 < HeaderVersion.VersionMinor)
            {
                throw new DllNotFoundException("The library has version " + version + "; this assembly was made for " +
                                               HeaderVersion.VersionMajor + "." + HeaderVersion.VersionMinor + ".");
            }
        }
    }
}
