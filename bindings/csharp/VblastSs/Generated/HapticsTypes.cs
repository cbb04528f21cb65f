// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_haptics_state.</summary>
    public enum HapticsState : int
    {
        /// <summary>There is no measurement yet.</summary>
        Waiting = 0,
        /// <summary>The hardware works.</summary>
        Running = 1,
        /// <summary>It measures, but accepts no forces for now: motors warm, force or speed too high.</summary>
        Refusing = 2,
        /// <summary>
        /// It accepts no forces until it is calibrated: put the stylus into the inkwell. An arm
        /// whose pose has been constant to the bit for 1 s is in this state, too: it is
        /// uncalibrated, its encoders give no data, or no hand holds it. It accepts forces again
        /// when its pose changes.
        /// </summary>
        Uncalibrated = 3,
        /// <summary>The hardware is missing: unplugged, or its driver has failed.</summary>
        Lost = 4,
    }

    /// <summary>The constants of vbss_nidaqmx_terminal.</summary>
    public enum NidaqmxTerminal : int
    {
        /// <summary>Against ground: 11 bits of a USB-6008.</summary>
        SingleEnded = 0,
        /// <summary>Between two inputs: 12 bits.</summary>
        Differential = 1,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct OpenhapticsConfigData
    {
        internal uint StructSize;
        internal uint DeviceCount;
        internal uint Rate;
        internal uint Reserved;
        internal IntPtr Library;
        internal IntPtr FirstName;
        internal IntPtr SecondName;
        internal IntPtr Output;
        internal IntPtr Tick;
        internal IntPtr User;
    }

    /// <summary>
    /// Configuration of the arms. Fill it with vbss_openhaptics_config_init, then change fields.
    /// The library copies the texts.
    /// </summary>
    public sealed unsafe partial class OpenhapticsConfig
    {
        private readonly OpenhapticsConfigData[] box = new OpenhapticsConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public OpenhapticsConfig()
        {
            fixed (OpenhapticsConfigData* data = box)
            {
                Vblast.Check(Native.vbss_openhaptics_config_init(data, (uint)sizeof(OpenhapticsConfigData)));
            }
        }

        /// <summary>Number of arms, 1 (default) or 2.</summary>
        public uint DeviceCount
        {
            get { return box[0].DeviceCount; }
            set { box[0].DeviceCount = value; }
        }

        /// <summary>
        /// Rate of the servo, Hz, 100 to 8000; default 1000. The vendor accepts 500, 1000 and 2000,
        /// and other rates for some arms.
        /// </summary>
        public uint Rate
        {
            get { return box[0].Rate; }
            set { box[0].Rate = value; }
        }

        /// <summary>
        /// Path or name of the vendor's library; NULL (default): `libHD.so`, `libHD.so.3.4` or
        /// `libHD.so.3.0`; `hd.dll`; or `libHD.dylib`.
        /// </summary>
        public string Library { get; set; }

        /// <summary>
        /// Name of the first arm in the vendor's set-up; NULL (default): its default device, or the
        /// one called `Default Device` or `Default PHANToM`.
        /// </summary>
        public string FirstName { get; set; }

        /// <summary>Name of the second arm in the vendor's set-up; default `Device2`.</summary>
        public string SecondName { get; set; }

        /// <summary>
        /// Limits of the output stage in the servo, lowered to the limits that the arms report;
        /// NULL (default): the initialised ones. The library copies them.
        /// </summary>
        public OutputConfig Output { get; set; }

        internal OpenhapticsConfigData* Pin(Pins pins)
        {
            ref OpenhapticsConfigData data = ref box[0];
            if (Library != null)
            {
                data.Library = pins.Text(Library);
            }
            if (FirstName != null)
            {
                data.FirstName = pins.Text(FirstName);
            }
            if (SecondName != null)
            {
                data.SecondName = pins.Text(SecondName);
            }
            data.Output = Output == null ? IntPtr.Zero : (IntPtr)Output.Pin(pins);
            PinCallbacks(pins);
            return (OpenhapticsConfigData*)pins.Array(box);
        }

        partial void PinCallbacks(Pins pins);
    }

    /// <summary>Status and counts of an arm.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct OpenhapticsStatus
    {
        internal uint StructSize;
        /// <summary>State of the arm.</summary>
        public HapticsState State;
        /// <summary>Last error code of the vendor's library for this arm; 0: none.</summary>
        public uint Error;
        /// <summary>The vendor's internal number of that error.</summary>
        public int InternalError;
        /// <summary>Number of ticks of the servo.</summary>
        public ulong Ticks;
        /// <summary>Ticks that began later than one tick length after the tick before.</summary>
        public ulong LateTicks;
        /// <summary>Ticks without a pose.</summary>
        public ulong FailedTicks;
        /// <summary>Errors that the vendor's library reported for this arm.</summary>
        public ulong Errors;
        /// <summary>Outputs of the host that the servo has received.</summary>
        public ulong Orders;
        /// <summary>Ticks with forces ramped down because the host was silent.</summary>
        public ulong SilentTicks;
        /// <summary>Temperature of the hottest motor, 0 to 1.</summary>
        public double Temperature;
        /// <summary>Longest time from the beginning of a tick to the end of the library's work in it, s.</summary>
        public double LongestTick;
        /// <summary>Force last applied, in the device's frame, N.</summary>
        public Vector3d Force;
        /// <summary>1: the pose has been constant to the bit for 1 s.</summary>
        public uint IsConstant;
        internal uint Reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct NidaqmxConfigData
    {
        internal uint StructSize;
        internal uint HandleCount;
        internal IntPtr Library;
        internal IntPtr FirstInput;
        internal IntPtr SecondInput;
        internal IntPtr FirstLine;
        internal IntPtr SecondLine;
        internal NidaqmxTerminal Terminal;
        internal uint ActiveLow;
        internal uint OwnThread;
        internal uint Reserved;
        internal double Low;
        internal double High;
        internal double Period;
        internal double Timeout;
    }

    /// <summary>
    /// Configuration of the lines. Fill it with vbss_nidaqmx_config_init, then change fields. The
    /// library copies the texts; a name has at most 127 bytes.
    /// </summary>
    public sealed unsafe partial class NidaqmxConfig
    {
        private readonly NidaqmxConfigData[] box = new NidaqmxConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public NidaqmxConfig()
        {
            fixed (NidaqmxConfigData* data = box)
            {
                Vblast.Check(Native.vbss_nidaqmx_config_init(data, (uint)sizeof(NidaqmxConfigData)));
            }
        }

        /// <summary>Number of handles, 1 or 2 (default).</summary>
        public uint HandleCount
        {
            get { return box[0].HandleCount; }
            set { box[0].HandleCount = value; }
        }

        /// <summary>
        /// Path or name of the vendor's library; NULL (default): `libnidaqmx.so.1` or, without it,
        /// `libnidaqmxbase.so`; `nicaiu.dll` on Windows. NI-DAQmx Base is recognised by its
        /// functions. It needs all lines on one port, such as `Dev1/port0/line0` and
        /// `Dev1/port0/line1`, and the other lines of that port stay high.
        /// </summary>
        public string Library { get; set; }

        /// <summary>Analog input of the first handle; default `Dev1/ai0`.</summary>
        public string FirstInput { get; set; }

        /// <summary>Analog input of the second handle; default `Dev1/ai1`.</summary>
        public string SecondInput { get; set; }

        /// <summary>
        /// Digital line of the first solenoid; NULL: there are no solenoids; default
        /// `Dev1/port0/line0`.
        /// </summary>
        public string FirstLine { get; set; }

        /// <summary>Digital line of the second solenoid; default `Dev1/port0/line1`.</summary>
        public string SecondLine { get; set; }

        /// <summary>Wiring of the potentiometers; default VBSS_NIDAQMX_TERMINAL_SINGLE_ENDED.</summary>
        public NidaqmxTerminal Terminal
        {
            get { return box[0].Terminal; }
            set { box[0].Terminal = value; }
        }

        /// <summary>
        /// 1 (default): a low line switches the solenoid's current on, so undriven lines, which are
        /// pulled high, keep it off. 0: a high line switches it on.
        /// </summary>
        public uint ActiveLow
        {
            get { return box[0].ActiveLow; }
            set { box[0].ActiveLow = value; }
        }

        /// <summary>
        /// 1 (default): a thread of the library moves the data; 0: the host calls
        /// vbss_nidaqmx_poll.
        /// </summary>
        public uint OwnThread
        {
            get { return box[0].OwnThread; }
            set { box[0].OwnThread = value; }
        }

        /// <summary>Lowest input voltage, V, -10 to 10; default -10.</summary>
        public double Low
        {
            get { return box[0].Low; }
            set { box[0].Low = value; }
        }

        /// <summary>Highest input voltage, V, above `low`, to 10; default 10.</summary>
        public double High
        {
            get { return box[0].High; }
            set { box[0].High = value; }
        }

        /// <summary>Time between two samples, s, 5e-4 to 1; default 0.002.</summary>
        public double Period
        {
            get { return box[0].Period; }
            set { box[0].Period = value; }
        }

        /// <summary>
        /// Longest wait of a call for the hardware, s, 1e-3 to 10, or 0 (default): the library
        /// chooses it. It starts with 0.004 s and doubles the wait up to 0.064 s while calls time
        /// out. A wait that the host sets does not change; the error text of the handle reports
        /// when it is too short.
        /// </summary>
        public double Timeout
        {
            get { return box[0].Timeout; }
            set { box[0].Timeout = value; }
        }

        internal NidaqmxConfigData* Pin(Pins pins)
        {
            ref NidaqmxConfigData data = ref box[0];
            if (Library != null)
            {
                data.Library = pins.Text(Library);
            }
            if (FirstInput != null)
            {
                data.FirstInput = pins.Text(FirstInput);
            }
            if (SecondInput != null)
            {
                data.SecondInput = pins.Text(SecondInput);
            }
            if (FirstLine != null)
            {
                data.FirstLine = pins.Text(FirstLine);
            }
            if (SecondLine != null)
            {
                data.SecondLine = pins.Text(SecondLine);
            }
            return (NidaqmxConfigData*)pins.Array(box);
        }
    }

    /// <summary>Status and counts of the lines.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct NidaqmxStatus
    {
        internal uint StructSize;
        /// <summary>
        /// State of the lines. REFUSING: the last read failed, or the lines are being reopened
        /// after a transient error; solenoids are off. LOST: a permanent error; the library reopens
        /// the lines when it can.
        /// </summary>
        public HapticsState State;
        /// <summary>Last error code of the vendor's library; 0: none.</summary>
        public int Error;
        /// <summary>Bits 1, 2: the first, the second solenoid is on.</summary>
        public uint Solenoids;
        /// <summary>Rounds of one write and one read.</summary>
        public ulong Cycles;
        /// <summary>Reads without a sample.</summary>
        public ulong FailedReads;
        /// <summary>Writes that failed.</summary>
        public ulong FailedWrites;
        /// <summary>Calls that succeeded with a warning.</summary>
        public ulong Warnings;
        /// <summary>Rounds in which a solenoid was switched off because the host was silent.</summary>
        public ulong SilentCycles;
        /// <summary>Reads and writes that timed out.</summary>
        public ulong Timeouts;
        /// <summary>Times the lines were reopened after an error.</summary>
        public ulong Reopened;
        /// <summary>Rounds so slow that a solenoid would switch off later than its command expires.</summary>
        public ulong LateRounds;
        /// <summary>Current longest wait of a call for the hardware, s.</summary>
        public double Timeout;
        /// <summary>Time from round to round, mean over about the last 16 rounds, s.</summary>
        public double RoundTime;
        /// <summary>
        /// Longest time from the host's last command until a solenoid is off, at the current round
        /// time, s; 0: unknown. A command expires after vbss_output_result::expires, 10 ms by
        /// default; rounds longer than half of that are too slow.
        /// </summary>
        public double OffTime;
    }
}
