using System;

namespace VblastSs
{
    /// <summary>
    /// Owner of all objects. One thread at a time may use a context with its objects; a call from a second thread
    /// throws a <see cref="VbssException"/> with the status ErrorBusy. Contexts are independent of each other.
    /// </summary>
    public sealed unsafe partial class Context : IDisposable
    {
        private readonly ObjectHandle handle;

        /// <summary>A context. Messages of the library go to the configuration's Log.</summary>
        public Context(ContextConfig config = null)
        {
            Vblast.RequireVersion();
            using (Pins pins = Pins.Rent(State))
            {
                IntPtr context;
                ContextConfigData* data = config == null ? null : config.Pin(pins);
                Vblast.Check(Native.vbss_context_create(data, out context));
                handle = new ObjectHandle(context, State, null, Native.vbss_context_destroy, pins.TakeRoots());
            }
        }

        /// <summary>Whether the context has been disposed, with all its objects.</summary>
        public bool IsDisposed
        {
            get { return State.Destroyed || handle.IsClosed; }
        }

        internal ContextState State { get; } = new ContextState();

        internal ObjectHandle Handle
        {
            get
            {
                if (IsDisposed)
                {
                    throw new ObjectDisposedException(nameof(Context));
                }
                return handle;
            }
        }

        /// <summary>
        /// Destroys the context and every object in it. Inside one of its callbacks, or while another thread is inside
        /// the context, it throws a <see cref="VbssException"/> and changes nothing.
        /// </summary>
        public void Dispose()
        {
            if (IsDisposed)
            {
                return;
            }
            Result status = Native.vbss_context_destroy(handle.DangerousGetHandle());
            if (status != Result.Ok)
            {
                throw new VbssException(status, Vblast.ResultString(status));
            }
            State.Destroyed = true;
            State.Sweep(); // frees the callbacks of dropped objects
            handle.Dispose();
            State.Wrappers.Clear();
        }

        /// <summary>Throws what a callback has thrown, or a failure of the call; destroys objects that were dropped.</summary>
        internal void Check(Result status)
        {
            var pending = State.TakePending();
            if (status == Result.Ok && pending == null && State.Queue.IsEmpty)
            {
                return;
            }
            string text = status == Result.Ok ? null : ErrorText(status);
            State.Sweep();
            if (pending != null)
            {
                pending.Throw();
            }
            if (status != Result.Ok)
            {
                throw new VbssException(status, text);
            }
        }

        /// <summary>The object of a handle: the one that has it already, or a new one that does not own it.</summary>
        internal T Find<T>(IntPtr native, Func<Context, IntPtr, T> make)
            where T : VbssObject
        {
            WeakReference<VbssObject> reference;
            VbssObject found;
            if (State.Wrappers.TryGetValue(native, out reference) && reference.TryGetTarget(out found) && !found.IsDisposed && found is T)
            {
                return (T)found;
            }
            return make(this, native);
        }

        private string ErrorText(Result status)
        {
            Result last;
            byte* text;
            // The text belongs to the thread inside the context, so a busy one has none for this call.
            if (!IsDisposed && Native.vbss_context_get_last_error(Handle, &last, &text) == Result.Ok && last == status)
            {
                return Vblast.Text((IntPtr)text);
            }
            return Vblast.ResultString(status);
        }
    }
}
