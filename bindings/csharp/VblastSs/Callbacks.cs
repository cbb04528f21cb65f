using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>Ahead-of-time compilers make a method with this attribute callable from C.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        internal MonoPInvokeCallbackAttribute(Type type)
        {
            Type = type;
        }

        internal Type Type { get; }
    }

    /// <summary>What the library has a pointer to as long as an object lives: the target of callbacks, passed as `user`, or bytes.</summary>
    internal sealed class NativeRoot
    {
        private GCHandle self;

        internal NativeRoot(object target, ContextState state)
        {
            Target = target;
            State = state;
            self = GCHandle.Alloc(this);
        }

        /// <summary>Bytes that stay where they are until Free.</summary>
        internal NativeRoot(byte[] bytes)
        {
            Target = bytes;
            self = GCHandle.Alloc(bytes, GCHandleType.Pinned);
        }

        internal object Target { get; }

        private ContextState State { get; }

        internal IntPtr Pointer
        {
            get { return Target is byte[] ? self.AddrOfPinnedObject() : GCHandle.ToIntPtr(self); }
        }

        internal static NativeRoot Of(IntPtr user)
        {
            return (NativeRoot)GCHandle.FromIntPtr(user).Target;
        }

        internal void Free()
        {
            if (self.IsAllocated)
            {
                self.Free();
            }
        }

        /// <summary>An exception must not cross C: the call of the library that is under way throws it when it returns.</summary>
        internal void Raise(Exception exception)
        {
            if (State != null)
            {
                State.Raise(exception);
            }
        }
    }

    public sealed unsafe partial class ContextConfig
    {
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void LogFunction(IntPtr user, LogLevel level, IntPtr message);

        private static readonly LogFunction LogEntry = OnLog;

        /// <summary>Receives messages, during calls of the library and on their thread; default null: none.</summary>
        public Action<LogLevel, string> Log { get; set; }

        partial void PinCallbacks(Pins pins)
        {
            pins.Callback(Log, LogEntry, ref box[0].Log, ref box[0].LogUser);
        }

        [MonoPInvokeCallback(typeof(LogFunction))]
        private static void OnLog(IntPtr user, LogLevel level, IntPtr message)
        {
            NativeRoot root = NativeRoot.Of(user);
            try
            {
                ((Action<LogLevel, string>)root.Target)(level, Vblast.Text(message));
            }
            catch (Exception exception)
            {
                root.Raise(exception);
            }
        }
    }

    public sealed unsafe partial class SessionConfig
    {
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void ListenFunction(IntPtr user, IntPtr sessionEvent);

        private static readonly ListenFunction ListenEntry = OnEvent;

        /// <summary>Receives the events, during steps and on their thread; default null: none.</summary>
        public Action<SessionEvent> Listen { get; set; }

        partial void PinCallbacks(Pins pins)
        {
            pins.Callback(Listen, ListenEntry, ref box[0].Listen, ref box[0].User);
        }

        [MonoPInvokeCallback(typeof(ListenFunction))]
        private static void OnEvent(IntPtr user, IntPtr sessionEvent)
        {
            NativeRoot root = NativeRoot.Of(user);
            try
            {
                ((Action<SessionEvent>)root.Target)(*(SessionEvent*)sessionEvent);
            }
            catch (Exception exception)
            {
                root.Raise(exception);
            }
        }
    }

    public sealed unsafe partial class MockConfig
    {
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void MeasureFunction(IntPtr user, double time, IntPtr sample);

        private static readonly MeasureFunction MeasureEntry = OnMeasure;

        /// <summary>Fills a sample for a time, s; default null: the sample of SetSample.</summary>
        public Action<double, DeviceSample> Measure { get; set; }

        partial void PinCallbacks(Pins pins)
        {
            pins.Callback(Measure, MeasureEntry, ref box[0].Measure, ref box[0].User);
        }

        [MonoPInvokeCallback(typeof(MeasureFunction))]
        private static void OnMeasure(IntPtr user, double time, IntPtr sample)
        {
            NativeRoot root = NativeRoot.Of(user);
            try
            {
                var managed = new DeviceSample();
                managed.CopyFrom((DeviceSampleData*)sample);
                ((Action<double, DeviceSample>)root.Target)(time, managed);
                managed.CopyTo((DeviceSampleData*)sample);
            }
            catch (Exception exception)
            {
                root.Raise(exception);
            }
        }
    }

    public sealed unsafe partial class OpenhapticsConfig
    {
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void TickFunction(IntPtr user, double now);

        private static readonly TickFunction TickEntry = OnTick;

        /// <summary>Called in each tick of the servo, on its thread, with the time, s; default null: none.</summary>
        public Action<double> Tick { get; set; }

        partial void PinCallbacks(Pins pins)
        {
            pins.Callback(Tick, TickEntry, ref box[0].Tick, ref box[0].User);
        }

        [MonoPInvokeCallback(typeof(TickFunction))]
        private static void OnTick(IntPtr user, double now)
        {
            NativeRoot root = NativeRoot.Of(user);
            try
            {
                ((Action<double>)root.Target)(now);
            }
            catch (Exception exception)
            {
                root.Raise(exception);
            }
        }
    }

    public partial struct CoreSpeed
    {
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate double ClockFunction(IntPtr user);

        private static readonly ClockFunction ClockEntry = OnClock;

        /// <summary>Measures the speed of the core that calls, with a clock of the host, s.</summary>
        public static unsafe CoreSpeed Measure(Context context, Func<double> clock)
        {
            var root = new NativeRoot(clock, context.State);
            try
            {
                CoreSpeed speed;
                context.Check(Native.vbss_core_speed_measure(context.Handle, Marshal.GetFunctionPointerForDelegate(ClockEntry),
                                                             root.Pointer, &speed, (uint)sizeof(CoreSpeed)));
                return speed;
            }
            finally
            {
                root.Free();
            }
        }

        [MonoPInvokeCallback(typeof(ClockFunction))]
        private static double OnClock(IntPtr user)
        {
            NativeRoot root = NativeRoot.Of(user);
            try
            {
                return ((Func<double>)root.Target)();
            }
            catch (Exception exception)
            {
                root.Raise(exception);
                return 0;
            }
        }
    }
}
