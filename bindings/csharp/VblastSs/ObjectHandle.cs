using System;
using System.Collections.Concurrent;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using System.Threading;

namespace VblastSs
{
    internal delegate Result DestroyFunction(IntPtr handle);

    /// <summary>What the objects of a context share. It has no finalizer, so that finalizers may use it.</summary>
    internal sealed class ContextState
    {
        /// <summary>An object to destroy, and its callbacks.</summary>
        internal struct Dropped
        {
            internal IntPtr Handle;
            internal DestroyFunction Destroy;
            internal NativeRoot[] Roots;
        }

        internal readonly ConcurrentDictionary<IntPtr, WeakReference<VbssObject>> Wrappers =
            new ConcurrentDictionary<IntPtr, WeakReference<VbssObject>>();
        internal readonly ConcurrentQueue<Dropped> Queue = new ConcurrentQueue<Dropped>();
        internal volatile bool Destroyed;
        private readonly ConcurrentQueue<Dropped> used = new ConcurrentQueue<Dropped>();
        private ExceptionDispatchInfo pending;

        /// <summary>Keeps the first exception of a callback until the call of the library returns.</summary>
        internal void Raise(Exception exception)
        {
            Interlocked.CompareExchange(ref pending, ExceptionDispatchInfo.Capture(exception), null);
        }

        internal ExceptionDispatchInfo TakePending()
        {
            return pending == null ? null : Interlocked.Exchange(ref pending, null);
        }

        /// <summary>
        /// Destroys an object. While another call is inside the context, that is left to a later sweep; while another
        /// object uses this one, to the destruction of a later object.
        /// </summary>
        internal void Destroy(Dropped dropped)
        {
            Result status = Destroyed ? Result.Ok : dropped.Destroy(dropped.Handle);
            if (status == Result.ErrorBusy)
            {
                Queue.Enqueue(dropped);
                return;
            }
            if (status != Result.Ok && status != Result.ErrorInvalidHandle)
            {
                used.Enqueue(dropped);
                return;
            }
            foreach (NativeRoot root in dropped.Roots)
            {
                root.Free();
            }
            DestroyAll(used);
        }

        /// <summary>Destroys the objects that finalizers have dropped. On the thread that uses the context.</summary>
        internal void Sweep()
        {
            DestroyAll(Queue);
        }

        private void DestroyAll(ConcurrentQueue<Dropped> queue)
        {
            for (int left = queue.Count; left > 0; left--)
            {
                Dropped dropped;
                if (queue.TryDequeue(out dropped))
                {
                    Destroy(dropped);
                }
            }
        }
    }

    /// <summary>Owns a handle of the library, or names one that its context owns.</summary>
    public sealed class ObjectHandle : SafeHandle
    {
        private static readonly ObjectHandle Null = new ObjectHandle();
        private readonly ContextState state;
        private readonly DestroyFunction destroy;
        private readonly NativeRoot[] roots;
        private readonly ObjectHandle context;
        private bool now;

        private ObjectHandle()
            : base(IntPtr.Zero, false)
        {
        }

        /// <summary>destroy null: the context owns the object. context null: this is the context's own handle.</summary>
        internal ObjectHandle(IntPtr handle, ContextState state, ObjectHandle context, DestroyFunction destroy, NativeRoot[] roots)
            : base(IntPtr.Zero, destroy != null)
        {
            this.state = state;
            this.context = context;
            this.destroy = destroy;
            this.roots = roots;
            SetHandle(handle);
        }

        /// <inheritdoc/>
        public override bool IsInvalid
        {
            get { return handle == IntPtr.Zero; }
        }

        internal static ObjectHandle Of(VbssObject value)
        {
            return value == null ? Null : value.Handle;
        }

        internal static ObjectHandle Of(Context value)
        {
            return value == null ? Null : value.Handle;
        }

        /// <summary>Destroys the object in this call, not in a later one of its context.</summary>
        internal void DestroyNow()
        {
            now = true;
            Dispose();
        }

        /// <inheritdoc/>
        protected override bool ReleaseHandle()
        {
            var dropped = new ContextState.Dropped { Handle = handle, Destroy = destroy, Roots = roots };
            if (context == null)
            {
                state.Destroy(dropped);
                state.Destroyed = true;
                state.Sweep(); // the objects are gone; this frees their callbacks
            }
            else if (now || state.Destroyed)
            {
                state.Destroy(dropped);
            }
            else
            {
                state.Queue.Enqueue(dropped);
            }
            GC.KeepAlive(context);
            return true;
        }
    }
}
