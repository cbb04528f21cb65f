// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>Bits for the parts of a sample.</summary>
    [Flags]
    public enum DeviceHasBits : uint
    {
        /// <summary>`position` is valid.</summary>
        Position = 1,
        /// <summary>`orientation` is valid.</summary>
        Orientation = 2,
        /// <summary>`velocity` is valid.</summary>
        Velocity = 4,
        /// <summary>`angular_velocity` is valid.</summary>
        AngularVelocity = 8,
        /// <summary>`jaw_raw` is valid.</summary>
        JawRaw = 16,
        /// <summary>`jaw` is valid and replaces `jaw_raw`.</summary>
        Jaw = 32,
        /// <summary>`buttons` is valid.</summary>
        Buttons = 64,
        /// <summary>`tool` is valid.</summary>
        Tool = 128,
        /// <summary>`temperature` is valid.</summary>
        Temperature = 256,
    }

    /// <summary>Bits for the outputs of a device.</summary>
    [Flags]
    public enum DeviceOutBits : uint
    {
        /// <summary>Force on the hand.</summary>
        Force = 1,
        /// <summary>Torque on the hand.</summary>
        Torque = 2,
        /// <summary>Solenoid in the handle.</summary>
        Solenoid = 4,
    }

    /// <summary>Bits for the state that a device reports with a sample.</summary>
    [Flags]
    public enum DeviceFlagBits : uint
    {
        /// <summary>The hardware is missing: unplugged, or its driver has failed.</summary>
        Lost = 1,
        /// <summary>Emergency stop; it latches as vbss_device_latch_emergency_stop does.</summary>
        Stop = 2,
        /// <summary>The hardware refuses forces for now; all outputs are off while this bit is set.</summary>
        Fault = 4,
        /// <summary>
        /// The hardware is too slow to switch outputs off within vbss_output_result::expires.
        /// `explain` gives its speed.
        /// </summary>
        Slow = 8,
    }

    /// <summary>The constants of vbss_device_tool.</summary>
    public enum DeviceTool : int
    {
        /// <summary>No tool.</summary>
        None = 0,
        /// <summary>A needle driver.</summary>
        NeedleDriver = 1,
        /// <summary>Shears.</summary>
        Shears = 2,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct DeviceSampleData
    {
        internal uint StructSize;
        internal DeviceHasBits Valid;
        internal DeviceFlagBits Flags;
        internal uint Buttons;
        internal DeviceTool Tool;
        internal uint Reserved;
        internal double Time;
        internal Vector3d Position;
        internal Quaterniond Orientation;
        internal Vector3d Velocity;
        internal Vector3d AngularVelocity;
        internal double JawRaw;
        internal double Jaw;
        internal double Temperature;
    }

    /// <summary>
    /// A sample of an adapter. The library passes a cleared one; the adapter fills the fields that
    /// it has and sets their bits in `valid`. The library's memory has 4096 bytes, so an adapter
    /// with a newer header may fill fields that an older library does not know. The library ignores
    /// them, and unknown bits.
    /// </summary>
    public sealed unsafe partial class DeviceSample
    {
        private readonly DeviceSampleData[] box = new DeviceSampleData[1];

        /// <summary>The defaults of the library.</summary>
        public DeviceSample()
        {
            fixed (DeviceSampleData* data = box)
            {
                Vblast.Check(Native.vbss_device_sample_init(data, (uint)sizeof(DeviceSampleData)));
            }
        }

        /// <summary>VBSS_DEVICE_HAS_ bits.</summary>
        public DeviceHasBits Valid
        {
            get { return box[0].Valid; }
            set { box[0].Valid = value; }
        }

        /// <summary>VBSS_DEVICE_FLAG_ bits; evaluated even if the read fails.</summary>
        public DeviceFlagBits Flags
        {
            get { return box[0].Flags; }
            set { box[0].Flags = value; }
        }

        /// <summary>Pressed buttons, one bit each.</summary>
        public uint Buttons
        {
            get { return box[0].Buttons; }
            set { box[0].Buttons = value; }
        }

        /// <summary>Kind of tool.</summary>
        public DeviceTool Tool
        {
            get { return box[0].Tool; }
            set { box[0].Tool = value; }
        }

        /// <summary>Time of the measurement, s, by any clock that never runs backwards.</summary>
        public double Time
        {
            get { return box[0].Time; }
            set { box[0].Time = value; }
        }

        /// <summary>Position, m, each coordinate at most 1e3 in magnitude.</summary>
        public Vector3d Position
        {
            get { return box[0].Position; }
            set { box[0].Position = value; }
        }

        /// <summary>Orientation from handle to device frame, unit quaternion w, x, y, z.</summary>
        public Quaterniond Orientation
        {
            get { return box[0].Orientation; }
            set { box[0].Orientation = value; }
        }

        /// <summary>Velocity, m/s, each component at most 1e3 in magnitude.</summary>
        public Vector3d Velocity
        {
            get { return box[0].Velocity; }
            set { box[0].Velocity = value; }
        }

        /// <summary>Angular velocity in the device's frame, rad/s, each component at most 1e4 in magnitude.</summary>
        public Vector3d AngularVelocity
        {
            get { return box[0].AngularVelocity; }
            set { box[0].AngularVelocity = value; }
        }

        /// <summary>Opening in the sensor's unit, such as V, at most 1e6 in magnitude.</summary>
        public double JawRaw
        {
            get { return box[0].JawRaw; }
            set { box[0].JawRaw = value; }
        }

        /// <summary>Opening, 0 (closed) to 1 (open).</summary>
        public double Jaw
        {
            get { return box[0].Jaw; }
            set { box[0].Jaw = value; }
        }

        /// <summary>Temperature of the hottest motor, 0 (cold) to 1 (about to fail).</summary>
        public double Temperature
        {
            get { return box[0].Temperature; }
            set { box[0].Temperature = value; }
        }

        internal DeviceSampleData* Pin(Pins pins)
        {
            return (DeviceSampleData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct DeviceCapabilitiesData
    {
        internal uint StructSize;
        internal DeviceHasBits Signals;
        internal DeviceOutBits Outputs;
        internal uint InputDof;
        internal uint OutputDof;
        internal uint Reserved;
        internal double MaxForce;
        internal double MaxContinuousForce;
        internal double MaxTorque;
        internal double MaxContinuousTorque;
        internal double MaxStiffness;
        internal double MaxDamping;
        internal double UpdateRate;
        internal Vector3d WorkspaceLow;
        internal Vector3d WorkspaceHigh;
    }

    /// <summary>
    /// Capabilities of a device; 0 means unknown. The library passes a cleared struct of 4096
    /// bytes, as with vbss_device_sample.
    /// </summary>
    public sealed unsafe partial class DeviceCapabilities
    {
        private readonly DeviceCapabilitiesData[] box = new DeviceCapabilitiesData[1];

        /// <summary>The defaults of the library.</summary>
        public DeviceCapabilities()
        {
            fixed (DeviceCapabilitiesData* data = box)
            {
                Vblast.Check(Native.vbss_device_capabilities_init(data, (uint)sizeof(DeviceCapabilitiesData)));
            }
        }

        /// <summary>VBSS_DEVICE_HAS_ bits that samples may have.</summary>
        public DeviceHasBits Signals
        {
            get { return box[0].Signals; }
            set { box[0].Signals = value; }
        }

        /// <summary>VBSS_DEVICE_OUT_ bits of the available outputs.</summary>
        public DeviceOutBits Outputs
        {
            get { return box[0].Outputs; }
            set { box[0].Outputs = value; }
        }

        /// <summary>Degrees of freedom that are measured.</summary>
        public uint InputDof
        {
            get { return box[0].InputDof; }
            set { box[0].InputDof = value; }
        }

        /// <summary>Degrees of freedom that are driven.</summary>
        public uint OutputDof
        {
            get { return box[0].OutputDof; }
            set { box[0].OutputDof = value; }
        }

        /// <summary>Peak force, N.</summary>
        public double MaxForce
        {
            get { return box[0].MaxForce; }
            set { box[0].MaxForce = value; }
        }

        /// <summary>Largest continuous force, N.</summary>
        public double MaxContinuousForce
        {
            get { return box[0].MaxContinuousForce; }
            set { box[0].MaxContinuousForce = value; }
        }

        /// <summary>Peak torque, N m.</summary>
        public double MaxTorque
        {
            get { return box[0].MaxTorque; }
            set { box[0].MaxTorque = value; }
        }

        /// <summary>Largest continuous torque, N m.</summary>
        public double MaxContinuousTorque
        {
            get { return box[0].MaxContinuousTorque; }
            set { box[0].MaxContinuousTorque = value; }
        }

        /// <summary>Largest stiffness that does not make the arm buzz, N/m.</summary>
        public double MaxStiffness
        {
            get { return box[0].MaxStiffness; }
            set { box[0].MaxStiffness = value; }
        }

        /// <summary>Largest damping that does not make the arm buzz, N s/m.</summary>
        public double MaxDamping
        {
            get { return box[0].MaxDamping; }
            set { box[0].MaxDamping = value; }
        }

        /// <summary>Sample rate, Hz.</summary>
        public double UpdateRate
        {
            get { return box[0].UpdateRate; }
            set { box[0].UpdateRate = value; }
        }

        /// <summary>Lower corner of the reachable box, device frame, m.</summary>
        public Vector3d WorkspaceLow
        {
            get { return box[0].WorkspaceLow; }
            set { box[0].WorkspaceLow = value; }
        }

        /// <summary>Upper corner of the reachable box; equal to `workspace_low` if unknown.</summary>
        public Vector3d WorkspaceHigh
        {
            get { return box[0].WorkspaceHigh; }
            set { box[0].WorkspaceHigh = value; }
        }

        internal DeviceCapabilitiesData* Pin(Pins pins)
        {
            return (DeviceCapabilitiesData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct DeviceCouplingData
    {
        internal uint StructSize;
        internal uint Reserved;
        internal Vector3d Position;
        internal Vector3d Velocity;
        internal Vector3d Force;
        internal double Stiffness;
        internal double Damping;
    }

    /// <summary>
    /// A virtual coupling between the hand and the tool. The force on the hand is force + stiffness
    /// (position - p) + damping (velocity - v) with p and v the hand's position and velocity. Fill
    /// it with vbss_device_coupling_init, then set its fields. A device computes this force in each
    /// write, from the pose that was read last. An adapter with its own servo (haptics.h)
    /// recomputes it in every tick from the pose just measured. The simulation then adds no delay
    /// between the hand and its spring.
    /// </summary>
    public sealed unsafe partial class DeviceCoupling
    {
        private readonly DeviceCouplingData[] box = new DeviceCouplingData[1];

        /// <summary>The defaults of the library.</summary>
        public DeviceCoupling()
        {
            fixed (DeviceCouplingData* data = box)
            {
                Vblast.Check(Native.vbss_device_coupling_init(data, (uint)sizeof(DeviceCouplingData)));
            }
        }

        /// <summary>
        /// Position of the tool that is coupled to the hand, m, each coordinate at most 1e3 in
        /// magnitude.
        /// </summary>
        public Vector3d Position
        {
            get { return box[0].Position; }
            set { box[0].Position = value; }
        }

        /// <summary>Velocity of the tool, m/s, each component at most 1e3 in magnitude; default 0.</summary>
        public Vector3d Velocity
        {
            get { return box[0].Velocity; }
            set { box[0].Velocity = value; }
        }

        /// <summary>Force that is added, N, each component at most 1e3 in magnitude; default 0.</summary>
        public Vector3d Force
        {
            get { return box[0].Force; }
            set { box[0].Force = value; }
        }

        /// <summary>Stiffness, N/m, 0 to 1e6; default 0.</summary>
        public double Stiffness
        {
            get { return box[0].Stiffness; }
            set { box[0].Stiffness = value; }
        }

        /// <summary>Damping, N s/m, 0 to 1e6; default 0.</summary>
        public double Damping
        {
            get { return box[0].Damping; }
            set { box[0].Damping = value; }
        }

        internal DeviceCouplingData* Pin(Pins pins)
        {
            return (DeviceCouplingData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct DeviceAdapterData
    {
        internal uint StructSize;
        internal uint Reserved;
        internal IntPtr Name;
        internal IntPtr User;
        internal IntPtr Open;
        internal IntPtr Close;
        internal IntPtr Describe;
        internal IntPtr Read;
        internal IntPtr Write;
        internal IntPtr Explain;
        internal IntPtr Couple;
    }

    /// <summary>
    /// An adapter. Fill it with vbss_device_adapter_init, then set the functions that exist. The
    /// library calls them on the thread that calls the device. They must return (no longjmp, no
    /// exception) and must not change the context.
    /// </summary>
    public sealed unsafe partial class DeviceAdapter
    {
        private readonly DeviceAdapterData[] box = new DeviceAdapterData[1];

        /// <summary>The defaults of the library.</summary>
        public DeviceAdapter()
        {
            fixed (DeviceAdapterData* data = box)
            {
                Vblast.Check(Native.vbss_device_adapter_init(data, (uint)sizeof(DeviceAdapterData)));
            }
        }

        /// <summary>Name in messages; NULL (default): "device". At most 31 bytes are kept.</summary>
        public string Name { get; set; }

        internal DeviceAdapterData* Pin(Pins pins)
        {
            ref DeviceAdapterData data = ref box[0];
            if (Name != null)
            {
                data.Name = pins.Text(Name);
            }
            PinCallbacks(pins);
            return (DeviceAdapterData*)pins.Array(box);
        }

        partial void PinCallbacks(Pins pins);
    }
}
