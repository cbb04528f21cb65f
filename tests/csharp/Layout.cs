using System;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;

namespace VblastSs.Tests
{
    /// <summary>Sizes and offsets of the structs, in the order of their declaration, to be compared with those of C.</summary>
    internal static class Layout
    {
        internal static void Print()
        {
            foreach (Type type in typeof(Context).Assembly.GetTypes().Where(type => type.IsValueType && !type.IsEnum &&
                     type.Namespace == "VblastSs" && type.IsLayoutSequential).OrderBy(type => type.Name, StringComparer.Ordinal))
            {
                var offsets = type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)
                    .OrderBy(field => field.MetadataToken).Select(field => Marshal.OffsetOf(type, field.Name).ToInt64());
                Console.WriteLine(type.Name + " " + Marshal.SizeOf(type) + " " + string.Join(" ", offsets));
            }
        }
    }
}
