// Written by bindings/csharp/generate.py from the public headers: do not edit.
namespace VblastSs
{
    internal static class HeaderVersion
    {
        internal const uint VersionMajor = 1;
        internal const uint VersionMinor = 0;
        internal const uint VersionPatch = 0;
    }
}
