// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_device_clock.</summary>
    public enum DeviceClock : int
    {
        /// <summary>
        /// The adapter's clock has its own origin. The age of a sample is the time since the first
        /// read that returned it.
        /// </summary>
        Own = 0,
        /// <summary>
        /// The adapter uses the host's clock. The age of a sample follows from its own time, so
        /// that delays are known.
        /// </summary>
        Shared = 1,
    }

    /// <summary>The constants of vbss_device_status.</summary>
    public enum DeviceStatus : int
    {
        /// <summary>There is no pose yet.</summary>
        Waiting = 0,
        /// <summary>The pose is current.</summary>
        Ready = 1,
        /// <summary>The pose is stale; the last one is held.</summary>
        Stale = 2,
        /// <summary>An adapter reports that its hardware is missing.</summary>
        Lost = 3,
    }

    /// <summary>Bits of the events of a read.</summary>
    [Flags]
    public enum DeviceEventBits : uint
    {
        /// <summary>An adapter's hardware is missing.</summary>
        Lost = 1,
        /// <summary>An adapter's hardware is back.</summary>
        Found = 2,
        /// <summary>The pose became stale.</summary>
        Stale = 4,
        /// <summary>The pose is current again, or came for the first time.</summary>
        Fresh = 8,
        /// <summary>The opening became stale.</summary>
        JawStale = 16,
        /// <summary>The opening is current again, or came for the first time.</summary>
        JawFresh = 32,
        /// <summary>A sample or raw opening was refused.</summary>
        Refused = 64,
        /// <summary>An adapter returned no sample.</summary>
        Failed = 128,
        /// <summary>The device latched the emergency stop.</summary>
        Stopped = 256,
        /// <summary>A device began to refuse forces.</summary>
        Fault = 512,
        /// <summary>The clock of an adapter restarted.</summary>
        Restarted = 1024,
        /// <summary>The kind of tool has changed.</summary>
        Tool = 2048,
        /// <summary>An adapter became too slow to switch outputs off in time.</summary>
        Slow = 4096,
        /// <summary>The opening is held until the handle has passed it.</summary>
        JawHeld = 8192,
        /// <summary>The handle took over the opening.</summary>
        JawTaken = 16384,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct DeviceCalibrationData
    {
        internal uint StructSize;
        internal Ints3 Axes;
        internal Doubles9 Rotation;
        internal double Scale;
        internal Vector3d Offset;
        internal Quaterniond Mount;
        internal Vector3d WorkspaceLow;
        internal Vector3d WorkspaceHigh;
        internal double ForceScale;
        internal double JawClosed;
        internal double JawOpen;
        internal double JawMargin;
        internal double JawPlay;
        internal double JawTime;
        internal double JawCloseAt;
        internal double JawOpenAt;
    }

    /// <summary>
    /// Transform from the device to the world. Fill it with vbss_device_calibration_init, then
    /// change fields. Let p be a position and R an orientation of the device, f a force of the
    /// world, and C the rotation times the matrix of `axes`: position offset + C scale p, then the
    /// clutch's shift, then into the workspace orientation C R C^T mount: at the device's identity
    /// the tool is oriented as `mount` force to the device: force_scale C^T f A stiffness k in the
    /// world is felt as k scale force_scale.
    /// </summary>
    public sealed unsafe partial class DeviceCalibration
    {
        private readonly DeviceCalibrationData[] box = new DeviceCalibrationData[1];

        /// <summary>The defaults of the library.</summary>
        public DeviceCalibration()
        {
            fixed (DeviceCalibrationData* data = box)
            {
                Vblast.Check(Native.vbss_device_calibration_init(data, (uint)sizeof(DeviceCalibrationData)));
            }
        }

        /// <summary>
        /// World axis i is device axis |axes[i]| (1 to 3), reversed if negative; default 1, 2, 3. A
        /// left-handed choice mirrors.
        /// </summary>
        public Ints3 Axes
        {
            get { return box[0].Axes; }
            set { box[0].Axes = value; }
        }

        /// <summary>Rotation applied after `axes`, row by row, orthonormal to 1e-6; default identity.</summary>
        public Doubles9 Rotation
        {
            get { return box[0].Rotation; }
            set { box[0].Rotation = value; }
        }

        /// <summary>World metres per device metre, 1e-3 to 1e3; default 1.</summary>
        public double Scale
        {
            get { return box[0].Scale; }
            set { box[0].Scale = value; }
        }

        /// <summary>Offset, m, each coordinate at most 1e3 in magnitude; default 0.</summary>
        public Vector3d Offset
        {
            get { return box[0].Offset; }
            set { box[0].Offset = value; }
        }

        /// <summary>
        /// Orientation of the tool frame in the handle's frame, w, x, y, z, any length; default 1,
        /// 0, 0, 0.
        /// </summary>
        public Quaterniond Mount
        {
            get { return box[0].Mount; }
            set { box[0].Mount = value; }
        }

        /// <summary>Lower corner of the box to which poses are confined, world, m; default -1.</summary>
        public Vector3d WorkspaceLow
        {
            get { return box[0].WorkspaceLow; }
            set { box[0].WorkspaceLow = value; }
        }

        /// <summary>Upper corner of the box, above the lower one, at most 1e3 in magnitude; default 1.</summary>
        public Vector3d WorkspaceHigh
        {
            get { return box[0].WorkspaceHigh; }
            set { box[0].WorkspaceHigh = value; }
        }

        /// <summary>Device force per world force, 1e-3 to 1e3; default 1.</summary>
        public double ForceScale
        {
            get { return box[0].ForceScale; }
            set { box[0].ForceScale = value; }
        }

        /// <summary>`jaw_raw` of the closed handle; default 0.</summary>
        public double JawClosed
        {
            get { return box[0].JawClosed; }
            set { box[0].JawClosed = value; }
        }

        /// <summary>
        /// `jaw_raw` of the open handle, at least 1e-9 away from jaw_closed, above or below;
        /// default 1.
        /// </summary>
        public double JawOpen
        {
            get { return box[0].JawOpen; }
            set { box[0].JawOpen = value; }
        }

        /// <summary>
        /// Largest distance of a raw value outside the range from closed to open, as a share of the
        /// range, 0 to 10; default 0.25. A value farther outside is refused, because the sensor
        /// must be broken.
        /// </summary>
        public double JawMargin
        {
            get { return box[0].JawMargin; }
            set { box[0].JawMargin = value; }
        }

        /// <summary>Backlash: largest movement of the opening that is ignored, 0 to 0.5; default 0.02.</summary>
        public double JawPlay
        {
            get { return box[0].JawPlay; }
            set { box[0].JawPlay = value; }
        }

        /// <summary>Time constant of the opening's filter, s, 0 to 10; default 0.01.</summary>
        public double JawTime
        {
            get { return box[0].JawTime; }
            set { box[0].JawTime = value; }
        }

        /// <summary>Opening at and below which the jaws become closed, 0 to 1; default 0.05.</summary>
        public double JawCloseAt
        {
            get { return box[0].JawCloseAt; }
            set { box[0].JawCloseAt = value; }
        }

        /// <summary>Opening at and above which closed jaws become open, jaw_close_at to 1; default 0.1.</summary>
        public double JawOpenAt
        {
            get { return box[0].JawOpenAt; }
            set { box[0].JawOpenAt = value; }
        }

        internal DeviceCalibrationData* Pin(Pins pins)
        {
            return (DeviceCalibrationData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct DeviceConfigData
    {
        internal uint StructSize;
        internal DeviceTool Tool;
        internal DeviceHasBits SecondSignals;
        internal DeviceClock Clock;
        internal uint StopWhenLost;
        internal uint ClutchOrientation;
        internal uint JawTakeover;
        internal uint Reserved;
        internal double JawTimeout;
        internal double VelocityTime;
        internal double NormTolerance;
        internal double MaxStiffness;
        internal double MaxDamping;
        internal IntPtr Calibration;
        internal IntPtr Output;
    }

    /// <summary>Configuration of a device. Fill it with vbss_device_config_init, then change fields.</summary>
    public sealed unsafe partial class DeviceConfig
    {
        private readonly DeviceConfigData[] box = new DeviceConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public DeviceConfig()
        {
            fixed (DeviceConfigData* data = box)
            {
                Vblast.Check(Native.vbss_device_config_init(data, (uint)sizeof(DeviceConfigData)));
            }
        }

        /// <summary>Kind of tool, where no adapter reports one; default VBSS_DEVICE_TOOL_NEEDLE_DRIVER.</summary>
        public DeviceTool Tool
        {
            get { return box[0].Tool; }
            set { box[0].Tool = value; }
        }

        /// <summary>
        /// VBSS_DEVICE_HAS_ bits of the signals that come from the second adapter, if there is one;
        /// default the jaw. A bit of the pose (position, orientation, velocities) selects the whole
        /// pose; either bit of the opening selects both.
        /// </summary>
        public DeviceHasBits SecondSignals
        {
            get { return box[0].SecondSignals; }
            set { box[0].SecondSignals = value; }
        }

        /// <summary>Interpretation of sample times; default VBSS_DEVICE_CLOCK_OWN.</summary>
        public DeviceClock Clock
        {
            get { return box[0].Clock; }
            set { box[0].Clock = value; }
        }

        /// <summary>
        /// 1 (default): a lost adapter latches the emergency stop; 0: its samples only become
        /// stale.
        /// </summary>
        public uint StopWhenLost
        {
            get { return box[0].StopWhenLost; }
            set { box[0].StopWhenLost = value; }
        }

        /// <summary>
        /// 1: the clutch holds the orientation too; 0 (default): the orientation always follows the
        /// hand.
        /// </summary>
        public uint ClutchOrientation
        {
            get { return box[0].ClutchOrientation; }
            set { box[0].ClutchOrientation = value; }
        }

        /// <summary>
        /// 1: the reported opening never jumps. It is held while the clutch is held, and after
        /// vbss_device_restore, a change of tool or vbss_device_hold_jaw, until the handle has
        /// passed it. A session also holds it in its first step and after vbss_session_restore. 0
        /// (default): the opening always follows the handle.
        /// </summary>
        public uint JawTakeover
        {
            get { return box[0].JawTakeover; }
            set { box[0].JawTakeover = value; }
        }

        /// <summary>
        /// Age at which the jaw's opening is stale, s, 1e-4 to 1e3; default 0.1. The pose uses
        /// input_timeout of the output stage.
        /// </summary>
        public double JawTimeout
        {
            get { return box[0].JawTimeout; }
            set { box[0].JawTimeout = value; }
        }

        /// <summary>Time constant of estimated velocities, s, 0 to 10; default 0.005.</summary>
        public double VelocityTime
        {
            get { return box[0].VelocityTime; }
            set { box[0].VelocityTime = value; }
        }

        /// <summary>
        /// Largest |1 - length| of an orientation that is accepted and normalised, 0 to 0.5;
        /// default 1e-3.
        /// </summary>
        public double NormTolerance
        {
            get { return box[0].NormTolerance; }
            set { box[0].NormTolerance = value; }
        }

        /// <summary>Upper limit of couplings, N/m, 0 to 1e6; default 400. The device only reports it.</summary>
        public double MaxStiffness
        {
            get { return box[0].MaxStiffness; }
            set { box[0].MaxStiffness = value; }
        }

        /// <summary>Upper limit of couplings, N s/m, 0 to 1e6; default 4. The device only reports it.</summary>
        public double MaxDamping
        {
            get { return box[0].MaxDamping; }
            set { box[0].MaxDamping = value; }
        }

        /// <summary>Calibration; NULL (default): the initialised one. The library copies it.</summary>
        public DeviceCalibration Calibration { get; set; }

        /// <summary>Output stage; NULL (default): the initialised one. The library copies it.</summary>
        public OutputConfig Output { get; set; }

        internal DeviceConfigData* Pin(Pins pins)
        {
            ref DeviceConfigData data = ref box[0];
            data.Calibration = Calibration == null ? IntPtr.Zero : (IntPtr)Calibration.Pin(pins);
            data.Output = Output == null ? IntPtr.Zero : (IntPtr)Output.Pin(pins);
            return (DeviceConfigData*)pins.Array(box);
        }
    }

    /// <summary>Result of a read, in the world's frame.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct DeviceInput
    {
        internal uint StructSize;
        /// <summary>Status of the device.</summary>
        public DeviceStatus Status;
        /// <summary>VBSS_DEVICE_HAS_ bits of the known values; estimated velocities count.</summary>
        public DeviceHasBits Valid;
        /// <summary>VBSS_DEVICE_HAS_ bits of the values that are stale and held; stale velocities are zero.</summary>
        public DeviceHasBits Stale;
        /// <summary>VBSS_DEVICE_EVENT_ bits.</summary>
        public DeviceEventBits Events;
        /// <summary>Bits 1, 2, 4: the workspace limits x, y, z.</summary>
        public uint Clamped;
        /// <summary>Buttons as last reported, one bit each.</summary>
        public uint Buttons;
        /// <summary>Buttons that were up in the last read and are down now.</summary>
        public uint Pressed;
        /// <summary>Buttons that were down in the last read and are up now.</summary>
        public uint Released;
        /// <summary>Kind of tool.</summary>
        public DeviceTool Tool;
        /// <summary>1: the jaws count as closed.</summary>
        public int JawClosed;
        /// <summary>1: the clutch is held, so the pose stays and there is no force.</summary>
        public int Clutched;
        /// <summary>1: the emergency stop is latched.</summary>
        public int Stopped;
        /// <summary>1: `jaw` is held until the handle has passed it.</summary>
        public uint JawHeld;
        /// <summary>Time of the pose, by the adapter's clock, s.</summary>
        public double Time;
        /// <summary>Age of the pose, s; -1: there is none.</summary>
        public double Age;
        /// <summary>Age of the opening, s; -1: there is none.</summary>
        public double JawAge;
        /// <summary>Position, m.</summary>
        public Vector3d Position;
        /// <summary>Orientation from tool to world, unit quaternion w, x, y, z.</summary>
        public Quaterniond Orientation;
        /// <summary>Velocity, m/s.</summary>
        public Vector3d Velocity;
        /// <summary>Angular velocity in the world's frame, rad/s.</summary>
        public Vector3d AngularVelocity;
        /// <summary>Opening, 0 (closed) to 1 (open).</summary>
        public double Jaw;
        /// <summary>Raw opening as last reported.</summary>
        public double JawRaw;
        /// <summary>Temperature as last reported, 0 to 1.</summary>
        public double Temperature;
    }

    /// <summary>Counts of a device since creation. Entry [0] is of the first adapter and [1] of the second.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct DeviceStatistics
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>Calls of vbss_device_read.</summary>
        public ulong Reads;
        /// <summary>Calls of vbss_device_write.</summary>
        public ulong Writes;
        /// <summary>Samples accepted.</summary>
        public ULongs2 Accepted;
        /// <summary>Samples whose time had not advanced.</summary>
        public ULongs2 Repeated;
        /// <summary>Samples refused because they are older than the one before.</summary>
        public ULongs2 OutOfOrder;
        /// <summary>Samples refused because of a NaN or an infinity.</summary>
        public ULongs2 NotFinite;
        /// <summary>Samples refused because a field is out of range.</summary>
        public ULongs2 OutOfRange;
        /// <summary>Samples refused because of an orientation outside norm_tolerance.</summary>
        public ULongs2 NotUnit;
        /// <summary>Reads without a sample.</summary>
        public ULongs2 FailedReads;
        /// <summary>Outputs that an adapter did not accept.</summary>
        public ULongs2 FailedWrites;
        /// <summary>Times the hardware was lost.</summary>
        public ULongs2 Lost;
        /// <summary>Times the hardware began to refuse forces.</summary>
        public ULongs2 Faults;
        /// <summary>Times the adapter's clock restarted.</summary>
        public ULongs2 Restarts;
        /// <summary>Raw openings refused because they are outside jaw_margin.</summary>
        public ulong JawRefused;
        /// <summary>Times the pose became stale.</summary>
        public ulong PoseStale;
        /// <summary>Reads with a stale pose.</summary>
        public ulong PoseStaleReads;
        /// <summary>Times the opening became stale.</summary>
        public ulong JawStale;
        /// <summary>Reads in which the workspace limited the pose.</summary>
        public ulong ClampedReads;
        /// <summary>Times the clutch was held.</summary>
        public ulong Clutches;
        /// <summary>Largest age of a pose, s.</summary>
        public double OldestPose;
    }
}
