using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

namespace VblastSs
{
    /// <summary>Memory that must not move during a call, and what the created object has to keep alive.</summary>
    internal sealed class Pins : IDisposable
    {
        [ThreadStatic]
        private static Pins spare;

        private readonly List<GCHandle> pinned = new List<GCHandle>();

        /// <summary>Callbacks of the configurations of this call.</summary>
        internal readonly List<NativeRoot> Roots = new List<NativeRoot>();

        /// <summary>Objects that the configurations of this call name.</summary>
        internal readonly List<object> References = new List<object>();

        private bool adopted;
        private ContextState state;

        /// <summary>One for this call; Dispose makes it free for the next, so that calls in a loop allocate nothing.</summary>
        internal static Pins Rent(ContextState state = null)
        {
            Pins pins = spare ?? new Pins();
            spare = null;
            pins.state = state;
            return pins;
        }

        internal IntPtr Array<T>(T[] values)
        {
            if (values == null || values.Length == 0)
            {
                return IntPtr.Zero;
            }
            GCHandle handle = GCHandle.Alloc(values, GCHandleType.Pinned);
            pinned.Add(handle);
            return handle.AddrOfPinnedObject();
        }

        internal IntPtr Text(string text)
        {
            return Array(Encoding.UTF8.GetBytes(text + "\0"));
        }

        internal IntPtr Handle(VbssObject value)
        {
            if (value == null)
            {
                return IntPtr.Zero;
            }
            References.Add(value);
            return value.Handle.DangerousGetHandle();
        }

        /// <summary>Sets a function and its `user` so that C calls a delegate through a static entry.</summary>
        internal void Callback(object target, Delegate entry, ref IntPtr function, ref IntPtr user)
        {
            function = target == null ? IntPtr.Zero : Marshal.GetFunctionPointerForDelegate(entry);
            user = IntPtr.Zero;
            if (target != null)
            {
                var root = new NativeRoot(target, state);
                Roots.Add(root);
                user = root.Pointer;
            }
        }

        /// <summary>The count that the length of an array gives; arrays of one configuration have to agree.</summary>
        internal uint Count(string name, int length, int each, int more, ref uint? before)
        {
            if (length % each != 0 || length / each < more)
            {
                throw new ArgumentException(name + " has " + length + " values, which is no multiple of " + each + ".", name);
            }
            uint count = (uint)(length / each - more);
            if (before.HasValue && before.Value != count)
            {
                throw new ArgumentException(name + " has values for " + count + ", another array for " + before.Value + ".", name);
            }
            before = count;
            return count;
        }

        /// <summary>The callbacks now belong to an object, which frees them.</summary>
        internal NativeRoot[] TakeRoots()
        {
            adopted = true;
            return Roots.ToArray();
        }

        public void Dispose()
        {
            foreach (GCHandle handle in pinned)
            {
                handle.Free();
            }
            if (!adopted)
            {
                foreach (NativeRoot root in Roots)
                {
                    root.Free();
                }
            }
            adopted = false;
            pinned.Clear();
            Roots.Clear();
            References.Clear();
            state = null;
            spare = this;
        }
    }
}
