// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>Bits for the actions of an output stage in a step.</summary>
    [Flags]
    public enum OutputFlagBits : uint
    {
        /// <summary>A number was NaN or infinite: all off.</summary>
        NotFinite = 1,
        /// <summary>The device refuses forces: all off.</summary>
        Fault = 2,
        /// <summary>The force was above the largest magnitude.</summary>
        Clamped = 4,
        /// <summary>The force was above the limit of the past load.</summary>
        Continuous = 8,
        /// <summary>The force was above the limit of the temperature.</summary>
        Warm = 16,
        /// <summary>The force rose faster than the limit.</summary>
        Slewed = 32,
        /// <summary>The pose is too old: ramp to zero.</summary>
        InputStale = 64,
        /// <summary>The command is too old: ramp to zero.</summary>
        CommandStale = 128,
        /// <summary>The emergency stop is latched: all off.</summary>
        Stopped = 256,
        /// <summary>The step came later than the watchdog allows.</summary>
        Late = 512,
        /// <summary>
        /// The command asks for the solenoid, but it is off for one of these reasons. Devices
        /// switch it off also while the clutch is engaged, the opening is stale, or an adapter is
        /// lost or has just failed.
        /// </summary>
        SolenoidOff = 1024,
        /// <summary>The solenoid was on for too long.</summary>
        SolenoidSpent = 2048,
        /// <summary>Devices: an adapter did not accept the result.</summary>
        NotWritten = 4096,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct OutputConfigData
    {
        internal uint StructSize;
        internal uint Reserved;
        internal double MaxForce;
        internal double MaxTorque;
        internal double ContinuousForce;
        internal double ContinuousTorque;
        internal double LoadTime;
        internal double Warm;
        internal double Hot;
        internal double ForceRise;
        internal double TorqueRise;
        internal double InputTimeout;
        internal double CommandTimeout;
        internal double RampTime;
        internal double SolenoidTime;
        internal double SolenoidDuty;
    }

    /// <summary>
    /// Limits of an output stage. Fill it with vbss_output_config_init, then change fields. A
    /// device lowers them to the capabilities of its adapters, and its timeouts are at least 2.5 of
    /// their periods.
    /// </summary>
    public sealed unsafe partial class OutputConfig
    {
        private readonly OutputConfigData[] box = new OutputConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public OutputConfig()
        {
            fixed (OutputConfigData* data = box)
            {
                Vblast.Check(Native.vbss_output_config_init(data, (uint)sizeof(OutputConfigData)));
            }
        }

        /// <summary>Largest force, N, 0 to 1e3; default 3.</summary>
        public double MaxForce
        {
            get { return box[0].MaxForce; }
            set { box[0].MaxForce = value; }
        }

        /// <summary>Largest torque, N m, 0 to 1e3; default 0.1.</summary>
        public double MaxTorque
        {
            get { return box[0].MaxTorque; }
            set { box[0].MaxTorque = value; }
        }

        /// <summary>
        /// Permitted root mean square of the force over an unlimited time, N, 0 to 1e3; default
        /// 0.88, a value often given for the Touch, without a known public source.
        /// </summary>
        public double ContinuousForce
        {
            get { return box[0].ContinuousForce; }
            set { box[0].ContinuousForce = value; }
        }

        /// <summary>Permitted root mean square of the torque, N m; default 0.03, chosen.</summary>
        public double ContinuousTorque
        {
            get { return box[0].ContinuousTorque; }
            set { box[0].ContinuousTorque = value; }
        }

        /// <summary>Time constant of these means, s, 1e-3 to 1e4; default 10, chosen.</summary>
        public double LoadTime
        {
            get { return box[0].LoadTime; }
            set { box[0].LoadTime = value; }
        }

        /// <summary>Temperature above which forces are reduced, 0 to 1; default 0.7.</summary>
        public double Warm
        {
            get { return box[0].Warm; }
            set { box[0].Warm = value; }
        }

        /// <summary>Temperature at which forces are zero, above `warm`, to 2; default 1.</summary>
        public double Hot
        {
            get { return box[0].Hot; }
            set { box[0].Hot = value; }
        }

        /// <summary>Fastest rise or turn, N/s, 1e-3 to 1e9; default 500. No limit for a fall.</summary>
        public double ForceRise
        {
            get { return box[0].ForceRise; }
            set { box[0].ForceRise = value; }
        }

        /// <summary>Fastest rise or turn of the torque, N m/s; default 20.</summary>
        public double TorqueRise
        {
            get { return box[0].TorqueRise; }
            set { box[0].TorqueRise = value; }
        }

        /// <summary>Age at which a pose is stale, s, 1e-4 to 10; default 0.005.</summary>
        public double InputTimeout
        {
            get { return box[0].InputTimeout; }
            set { box[0].InputTimeout = value; }
        }

        /// <summary>Age at which a command is stale, s, 1e-4 to 10; default 0.005.</summary>
        public double CommandTimeout
        {
            get { return box[0].CommandTimeout; }
            set { box[0].CommandTimeout = value; }
        }

        /// <summary>Length of the ramp to zero, s, 0 to 10; default 0.005.</summary>
        public double RampTime
        {
            get { return box[0].RampTime; }
            set { box[0].RampTime = value; }
        }

        /// <summary>Longest time of the solenoid on, s, 0 to 1e4; default 1, chosen.</summary>
        public double SolenoidTime
        {
            get { return box[0].SolenoidTime; }
            set { box[0].SolenoidTime = value; }
        }

        /// <summary>Largest long-term share of time of the solenoid on, 0 to 0.99; default 0.25, chosen.</summary>
        public double SolenoidDuty
        {
            get { return box[0].SolenoidDuty; }
            set { box[0].SolenoidDuty = value; }
        }

        internal OutputConfigData* Pin(Pins pins)
        {
            return (OutputConfigData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct OutputCommandData
    {
        internal uint StructSize;
        internal uint Solenoid;
        internal uint Fault;
        internal uint Reserved;
        internal Vector3d Force;
        internal Vector3d Torque;
        internal double Age;
        internal double InputAge;
        internal double Temperature;
    }

    /// <summary>Command to an output stage. Fill it with vbss_output_command_init, then set its fields.</summary>
    public sealed unsafe partial class OutputCommand
    {
        private readonly OutputCommandData[] box = new OutputCommandData[1];

        /// <summary>The defaults of the library.</summary>
        public OutputCommand()
        {
            fixed (OutputCommandData* data = box)
            {
                Vblast.Check(Native.vbss_output_command_init(data, (uint)sizeof(OutputCommandData)));
            }
        }

        /// <summary>1: on; default 0.</summary>
        public uint Solenoid
        {
            get { return box[0].Solenoid; }
            set { box[0].Solenoid = value; }
        }

        /// <summary>1: the device refuses forces; default 0.</summary>
        public uint Fault
        {
            get { return box[0].Fault; }
            set { box[0].Fault = value; }
        }

        /// <summary>
        /// Force, N; for a device, in the world's frame. A flag reports numbers that are not
        /// finite.
        /// </summary>
        public Vector3d Force
        {
            get { return box[0].Force; }
            set { box[0].Force = value; }
        }

        /// <summary>Torque, N m; for a device, in the world's frame.</summary>
        public Vector3d Torque
        {
            get { return box[0].Torque; }
            set { box[0].Torque = value; }
        }

        /// <summary>Age of the command, s, such as that of the anchor it was computed from; default 0.</summary>
        public double Age
        {
            get { return box[0].Age; }
            set { box[0].Age = value; }
        }

        /// <summary>Age of the pose, s; default 0. A device uses the age of its own pose if that is older.</summary>
        public double InputAge
        {
            get { return box[0].InputAge; }
            set { box[0].InputAge = value; }
        }

        /// <summary>Temperature of the motors; default 0. A device uses its own value if that is higher.</summary>
        public double Temperature
        {
            get { return box[0].Temperature; }
            set { box[0].Temperature = value; }
        }

        internal OutputCommandData* Pin(Pins pins)
        {
            return (OutputCommandData*)pins.Array(box);
        }
    }

    /// <summary>Counters of an output stage. Each counter of a flag is the number of steps with that flag.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct OutputStatistics
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>Steps so far.</summary>
        public ulong Steps;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_NOT_FINITE.</summary>
        public ulong NotFinite;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_FAULT.</summary>
        public ulong Faults;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_CLAMPED.</summary>
        public ulong Clamped;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_CONTINUOUS.</summary>
        public ulong Continuous;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_WARM.</summary>
        public ulong Warm;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_SLEWED.</summary>
        public ulong Slewed;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_INPUT_STALE.</summary>
        public ulong InputStale;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_COMMAND_STALE.</summary>
        public ulong CommandStale;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_STOPPED.</summary>
        public ulong Stopped;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_LATE.</summary>
        public ulong Late;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_SOLENOID_OFF.</summary>
        public ulong SolenoidOff;
        /// <summary>Steps with VBSS_OUTPUT_FLAG_SOLENOID_SPENT.</summary>
        public ulong SolenoidSpent;
        /// <summary>Ramps that the watchdog started.</summary>
        public ulong Watchdogs;
        /// <summary>Times that the emergency stop was latched.</summary>
        public ulong Stops;
        /// <summary>Times that the solenoid was switched on.</summary>
        public ulong Pulses;
        /// <summary>Largest force in a result, N.</summary>
        public double LargestForce;
        /// <summary>Largest torque in a result, N m.</summary>
        public double LargestTorque;
        /// <summary>Total time of the solenoid on, s.</summary>
        public double SolenoidOn;
    }

    /// <summary>
    /// Result of an output stage, for the hardware. In a call of an adapter it is followed by zeros
    /// up to 4096 bytes.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct OutputResult
    {
        internal uint StructSize;
        /// <summary>VBSS_OUTPUT_FLAG_ bits: actions of the stage.</summary>
        public OutputFlagBits Flags;
        /// <summary>1: on, 0: off.</summary>
        public uint Solenoid;
        internal uint Reserved;
        /// <summary>Force, N; for an adapter, in the device's frame.</summary>
        public Vector3d Force;
        /// <summary>Torque, N m; for an adapter, in the device's frame.</summary>
        public Vector3d Torque;
        /// <summary>Mean square force over the square of its limit; 1: at the limit.</summary>
        public double ForceLoad;
        /// <summary>Mean square torque over the square of its limit.</summary>
        public double TorqueLoad;
        /// <summary>Time that the solenoid may stay on from now on, s.</summary>
        public double SolenoidLeft;
        /// <summary>Time after which an adapter without a new call switches all outputs off itself, s.</summary>
        public double Expires;
    }
}
