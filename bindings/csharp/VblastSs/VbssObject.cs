using System;
using System.Collections.Generic;

namespace VblastSs
{
    /// <summary>
    /// An object of a context. Dispose destroys it; without Dispose it is destroyed by a later call on its
    /// context, after the garbage collector has found it unused. Disposing the context destroys all its objects.
    /// </summary>
    public abstract unsafe class VbssObject : IDisposable
    {
        internal delegate Result SaveFunction(ObjectHandle handle, byte* bytes, ulong capacity, ulong* written);

        private readonly HashSet<object> kept = new HashSet<object>();
        private ObjectHandle handle;
        private bool disposed;

        private protected VbssObject(Context context)
        {
            Context = context ?? throw new ArgumentNullException(nameof(context));
        }

        /// <summary>The context that the object belongs to.</summary>
        public Context Context { get; }

        /// <summary>Whether the object or its context has been disposed.</summary>
        public bool IsDisposed
        {
            get { return disposed || handle == null || handle.IsClosed || Context.IsDisposed; }
        }

        /// <summary>The scene that the object is a body of; it is destroyed after that.</summary>
        internal Scene MemberOf { get; private set; }

        internal ObjectHandle Handle
        {
            get
            {
                if (IsDisposed)
                {
                    throw new ObjectDisposedException(GetType().Name);
                }
                return handle;
            }
        }

        /// <summary>Destroys the object. A body of a scene is destroyed when it leaves the scene, or with the scene.</summary>
        public void Dispose()
        {
            if (IsDisposed)
            {
                return;
            }
            disposed = true;
            WeakReference<VbssObject> reference;
            Context.State.Wrappers.TryRemove(handle.DangerousGetHandle(), out reference);
            if (MemberOf == null)
            {
                handle.DestroyNow();
                OnDestroyed();
            }
            kept.Clear();
        }

        internal void Join(Scene scene)
        {
            MemberOf = scene;
        }

        /// <summary>The object is no body of a scene any more.</summary>
        internal void Leave()
        {
            MemberOf = null;
            if (disposed && !Context.IsDisposed)
            {
                handle.DestroyNow();
            }
        }

        internal virtual void OnDestroyed()
        {
        }

        private protected void Adopt(IntPtr native, DestroyFunction destroy, Pins pins = null)
        {
            NativeRoot[] roots = pins == null ? new NativeRoot[0] : pins.TakeRoots();
            handle = new ObjectHandle(native, Context.State, Context.Handle, destroy, roots);
            Context.State.Wrappers[native] = new WeakReference<VbssObject>(this);
            if (pins != null)
            {
                kept.UnionWith(pins.References);
            }
        }

        /// <summary>The garbage collector must not drop an object that this one uses.</summary>
        private protected void Keep(object other)
        {
            if (other != null && !(other is Context))
            {
                kept.Add(other);
            }
        }

        private protected static T Require<T>(T value)
            where T : class
        {
            return value ?? throw new ArgumentNullException(typeof(T).Name);
        }

        private protected byte[] SaveState(SaveFunction save)
        {
            ulong count;
            save(Handle, null, 0, &count);
            var state = new byte[count];
            fixed (byte* bytes = state)
            {
                Context.Check(save(Handle, bytes, count, &count));
            }
            return state;
        }
    }
}
