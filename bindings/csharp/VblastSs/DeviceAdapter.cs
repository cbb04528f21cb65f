using System;
using System.Runtime.InteropServices;
using System.Text;

namespace VblastSs
{
    /// <remarks>
    /// Delegates receive the same sample and capabilities in every call: copy what you need. What a delegate throws
    /// counts as a failure of the device, and the call of the library throws it when it returns.
    /// </remarks>
    public sealed unsafe partial class DeviceAdapter
    {
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate Result OpenFunction(IntPtr user);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void CloseFunction(IntPtr user);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate Result DescribeFunction(IntPtr user, IntPtr capabilities);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate Result ReadFunction(IntPtr user, double now, IntPtr sample);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate Result WriteFunction(IntPtr user, double now, IntPtr output);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void ExplainFunction(IntPtr user, IntPtr text, uint bytes);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate Result CoupleFunction(IntPtr user, double now, IntPtr output, IntPtr coupling);

        private static readonly OpenFunction OpenEntry = OnOpen;
        private static readonly CloseFunction CloseEntry = OnClose;
        private static readonly DescribeFunction DescribeEntry = OnDescribe;
        private static readonly ReadFunction ReadEntry = OnRead;
        private static readonly WriteFunction WriteEntry = OnWrite;
        private static readonly ExplainFunction ExplainEntry = OnExplain;
        private static readonly CoupleFunction CoupleEntry = OnCouple;

        private readonly DeviceSample sample = new DeviceSample();
        private readonly DeviceCapabilities capabilities = new DeviceCapabilities();
        private readonly DeviceCoupling coupling = new DeviceCoupling();
        private VbssObject source; // whose functions these are, if not those of this class

        /// <summary>Opens the hardware; default null: nothing to open.</summary>
        public Func<Result> Open { get; set; }

        /// <summary>Closes the hardware; default null: nothing to close.</summary>
        public Action Close { get; set; }

        /// <summary>Reports the capabilities; default null: all signals, and the outputs that there are delegates for.</summary>
        public Func<DeviceCapabilities, Result> Describe { get; set; }

        /// <summary>Fills the newest sample for a time of the host's clock, s.</summary>
        public Func<double, DeviceSample, Result> Read { get; set; }

        /// <summary>Writes the outputs; default null: no outputs.</summary>
        public Func<double, OutputResult, Result> Write { get; set; }

        /// <summary>Describes the last failure; default null: no texts.</summary>
        public Func<string> Explain { get; set; }

        /// <summary>Writes outputs with a coupling; default null: the adapter has no servo.</summary>
        public Func<double, OutputResult, DeviceCoupling, Result> Couple { get; set; }

        /// <summary>An adapter of an object of the library, which lives as long as a device that uses the adapter.</summary>
        internal DeviceAdapter(VbssObject source)
            : this()
        {
            this.source = source;
        }

        internal delegate Result FillFunction(DeviceAdapterData* data);

        internal Result Fill(FillFunction fill)
        {
            fixed (DeviceAdapterData* data = box)
            {
                return fill(data);
            }
        }

        partial void PinCallbacks(Pins pins)
        {
            if (source != null)
            {
                pins.References.Add(source);
                return;
            }
            pins.Callback(this, OpenEntry, ref box[0].Open, ref box[0].User);
            box[0].Open = Entry(Open, OpenEntry);
            box[0].Close = Entry(Close, CloseEntry);
            box[0].Describe = Entry(Describe, DescribeEntry);
            box[0].Read = Entry(Read, ReadEntry);
            box[0].Write = Entry(Write, WriteEntry);
            box[0].Explain = Entry(Explain, ExplainEntry);
            box[0].Couple = Entry(Couple, CoupleEntry);
        }

        private static IntPtr Entry(Delegate target, Delegate entry)
        {
            return target == null ? IntPtr.Zero : Marshal.GetFunctionPointerForDelegate(entry);
        }

        private static Result Guard(IntPtr user, Func<DeviceAdapter, IntPtr, double, IntPtr, Result> call, IntPtr first, double now,
                                    IntPtr second)
        {
            NativeRoot root = NativeRoot.Of(user);
            try
            {
                return call((DeviceAdapter)root.Target, first, now, second);
            }
            catch (Exception exception)
            {
                root.Raise(exception);
                return Result.ErrorDevice;
            }
        }

        [MonoPInvokeCallback(typeof(OpenFunction))]
        private static Result OnOpen(IntPtr user)
        {
            return Guard(user, (adapter, first, now, second) => adapter.Open(), IntPtr.Zero, 0, IntPtr.Zero);
        }

        [MonoPInvokeCallback(typeof(CloseFunction))]
        private static void OnClose(IntPtr user)
        {
            Guard(user, (adapter, first, now, second) => { adapter.Close(); return Result.Ok; }, IntPtr.Zero, 0, IntPtr.Zero);
        }

        [MonoPInvokeCallback(typeof(DescribeFunction))]
        private static Result OnDescribe(IntPtr user, IntPtr capabilities)
        {
            return Guard(user, (adapter, first, now, second) => adapter.DescribeTo((DeviceCapabilitiesData*)first), capabilities, 0,
                         IntPtr.Zero);
        }

        [MonoPInvokeCallback(typeof(ReadFunction))]
        private static Result OnRead(IntPtr user, double now, IntPtr sample)
        {
            return Guard(user, (adapter, first, time, second) => adapter.ReadTo(time, (DeviceSampleData*)first), sample, now, IntPtr.Zero);
        }

        [MonoPInvokeCallback(typeof(WriteFunction))]
        private static Result OnWrite(IntPtr user, double now, IntPtr output)
        {
            return Guard(user, (adapter, first, time, second) => adapter.Write(time, *(OutputResult*)first), output, now, IntPtr.Zero);
        }

        [MonoPInvokeCallback(typeof(ExplainFunction))]
        private static void OnExplain(IntPtr user, IntPtr text, uint bytes)
        {
            Guard(user, (adapter, first, size, second) => adapter.ExplainTo((byte*)first, (int)size), text, bytes, IntPtr.Zero);
        }

        [MonoPInvokeCallback(typeof(CoupleFunction))]
        private static Result OnCouple(IntPtr user, double now, IntPtr output, IntPtr coupling)
        {
            return Guard(user, (adapter, first, time, second) => adapter.CoupleWith(time, *(OutputResult*)first, (DeviceCouplingData*)second),
                         output, now, coupling);
        }

        private Result DescribeTo(DeviceCapabilitiesData* target)
        {
            capabilities.CopyFrom(target);
            Result result = Describe(capabilities);
            capabilities.CopyTo(target);
            return result;
        }

        private Result ReadTo(double now, DeviceSampleData* target)
        {
            sample.CopyFrom(target);
            Result result = Read(now, sample);
            sample.CopyTo(target);
            return result;
        }

        private Result CoupleWith(double now, OutputResult output, DeviceCouplingData* given)
        {
            coupling.CopyFrom(given);
            return Couple(now, output, coupling);
        }

        private Result ExplainTo(byte* text, int bytes)
        {
            byte[] encoded = Encoding.UTF8.GetBytes(Explain() ?? "");
            int count = Math.Min(encoded.Length, bytes - 1);
            Marshal.Copy(encoded, 0, (IntPtr)text, count);
            text[count] = 0;
            return Result.Ok;
        }
    }

    public sealed unsafe partial class DeviceSample
    {
        internal void CopyFrom(DeviceSampleData* given)
        {
            box[0] = *given;
        }

        internal void CopyTo(DeviceSampleData* target)
        {
            *target = box[0];
        }
    }

    public sealed unsafe partial class DeviceCapabilities
    {
        internal void CopyFrom(DeviceCapabilitiesData* given)
        {
            box[0] = *given;
        }

        internal void CopyTo(DeviceCapabilitiesData* target)
        {
            *target = box[0];
        }
    }

    public sealed unsafe partial class DeviceCoupling
    {
        internal void CopyFrom(DeviceCouplingData* given)
        {
            box[0] = *given;
        }
    }

    public sealed unsafe partial class Mock
    {
        /// <summary>The adapter of this simulated device.</summary>
        public DeviceAdapter GetAdapter()
        {
            var adapter = new DeviceAdapter(this);
            Context.Check(adapter.Fill(data => Native.vbss_mock_get_adapter(Handle, data)));
            return adapter;
        }
    }

    public sealed unsafe partial class Openhaptics
    {
        /// <summary>The adapter of a device: 0 the first, 1 the second.</summary>
        public DeviceAdapter GetAdapter(uint which)
        {
            var adapter = new DeviceAdapter(this);
            Context.Check(adapter.Fill(data => Native.vbss_openhaptics_get_adapter(Handle, which, data)));
            return adapter;
        }
    }

    public sealed unsafe partial class Nidaqmx
    {
        /// <summary>The adapter of a jaw: 0 the first, 1 the second.</summary>
        public DeviceAdapter GetAdapter(uint which)
        {
            var adapter = new DeviceAdapter(this);
            Context.Check(adapter.Fill(data => Native.vbss_nidaqmx_get_adapter(Handle, which, data)));
            return adapter;
        }

        /// <summary>Names of the devices that the driver finds.</summary>
        public static string ListDevices(Context context, string library = null)
        {
            using (Pins pins = Pins.Rent())
            {
                byte* text = stackalloc byte[4096];
                byte* name = library == null ? null : (byte*)pins.Text(library);
                context.Check(Native.vbss_nidaqmx_list_devices(context.Handle, name, text, 4096));
                return Vblast.Text((IntPtr)text);
            }
        }
    }
}
