// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_grasper_kind.</summary>
    public enum GrasperKind : int
    {
        /// <summary>Jaws that hold.</summary>
        NeedleDriver = 1,
        /// <summary>Blades that cut.</summary>
        Shears = 2,
    }

    /// <summary>The constants of vbss_grasper_preset.</summary>
    public enum GrasperPreset : int
    {
        /// <summary>A needle driver with straight jaws: the defaults.</summary>
        Straight = 0,
        /// <summary>
        /// Jaws on a neck of 5 mm, bent by 0.8 rad. Rolled about its shaft, the tool points its
        /// jaws at the other tool, which can then go round them without meeting the shaft.
        /// </summary>
        Angled = 1,
    }

    /// <summary>The constants of vbss_grasper_field.</summary>
    public enum GrasperField : int
    {
        /// <summary>x 7: start and end of the axis, radius, m. Order: shaft, jaw at +x, jaw at -x, neck.</summary>
        Capsules = 0,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct GrasperConfigData
    {
        internal uint StructSize;
        internal Method Method;
        internal GrasperKind Kind;
        internal int HasTrocar;
        internal Vector3d Trocar;
        internal double DriverLength;
        internal double DriverRadius;
        internal double DriverBend;
        internal double DriverOpening;
        internal double ShearsLength;
        internal double ShearsRadius;
        internal double ShearsBend;
        internal double ShearsOpening;
        internal double DriverNeck;
        internal double ShearsNeck;
        internal double NeckRadius;
        internal double ShaftLength;
        internal double ShaftRadius;
        internal double Friction;
        internal double ClosingForce;
        internal double ClosingAngle;
        internal double JawSpeed;
        internal double GripFriction;
        internal double GripLength;
        internal double GripStiffness;
        internal double Mass;
        internal double Stiffness;
        internal double Damping;
        internal double TurningStiffness;
        internal double TurningDamping;
        internal Vector3d ExchangeCentre;
        internal double ExchangeDistance;
        internal IntPtr Baseline;
        internal double NeedleStiffness;
        internal double NeedleTurningStiffness;
        internal double NeedleTorque;
        internal double SolenoidOpening;
    }

    /// <summary>Configuration of a grasper. Fill it with vbss_grasper_config_init, then change fields.</summary>
    public sealed unsafe partial class GrasperConfig
    {
        private readonly GrasperConfigData[] box = new GrasperConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public GrasperConfig()
        {
            fixed (GrasperConfigData* data = box)
            {
                Vblast.Check(Native.vbss_grasper_config_init(data, (uint)sizeof(GrasperConfigData)));
            }
        }

        /// <summary>Must be that of the scene; default VBSS_METHOD_IMPLICIT.</summary>
        public Method Method
        {
            get { return box[0].Method; }
            set { box[0].Method = value; }
        }

        /// <summary>Initial kind; default VBSS_GRASPER_KIND_NEEDLE_DRIVER.</summary>
        public GrasperKind Kind
        {
            get { return box[0].Kind; }
            set { box[0].Kind = value; }
        }

        /// <summary>1: the shaft goes through `trocar`; default 0: free.</summary>
        public int HasTrocar
        {
            get { return box[0].HasTrocar; }
            set { box[0].HasTrocar = value; }
        }

        /// <summary>Point of entry of the shaft, m, each at most 1e3; default 0.</summary>
        public Vector3d Trocar
        {
            get { return box[0].Trocar; }
            set { box[0].Trocar = value; }
        }

        /// <summary>Length of a driver's jaws, pivot to tip, m, 1e-4 to 1; default 13e-3.</summary>
        public double DriverLength
        {
            get { return box[0].DriverLength; }
            set { box[0].DriverLength = value; }
        }

        /// <summary>Radius of each jaw, m, 1e-6 to 0.1, below the length; default 0.5e-3.</summary>
        public double DriverRadius
        {
            get { return box[0].DriverRadius; }
            set { box[0].DriverRadius = value; }
        }

        /// <summary>Angle between jaws and shaft, rad, -1.5 to 1.5; default 0.</summary>
        public double DriverBend
        {
            get { return box[0].DriverBend; }
            set { box[0].DriverBend = value; }
        }

        /// <summary>
        /// Angle of each jaw from the middle when the handle is open, rad, 1e-3 to 1.2; default
        /// 0.35.
        /// </summary>
        public double DriverOpening
        {
            get { return box[0].DriverOpening; }
            set { box[0].DriverOpening = value; }
        }

        /// <summary>Length of the blades of shears, pivot to tip, m, 1e-4 to 1; default 15e-3.</summary>
        public double ShearsLength
        {
            get { return box[0].ShearsLength; }
            set { box[0].ShearsLength = value; }
        }

        /// <summary>Radius of each blade, m, 1e-6 to 0.1, below the length; default 0.5e-3.</summary>
        public double ShearsRadius
        {
            get { return box[0].ShearsRadius; }
            set { box[0].ShearsRadius = value; }
        }

        /// <summary>Angle between blades and shaft, rad, -1.5 to 1.5; default 0.</summary>
        public double ShearsBend
        {
            get { return box[0].ShearsBend; }
            set { box[0].ShearsBend = value; }
        }

        /// <summary>
        /// Angle of each blade from the middle when the handle is open, rad, 1e-3 to 1.2; default
        /// 0.35.
        /// </summary>
        public double ShearsOpening
        {
            get { return box[0].ShearsOpening; }
            set { box[0].ShearsOpening = value; }
        }

        /// <summary>Length from the pivot back to the bend, m, 0 to 1; default 0.</summary>
        public double DriverNeck
        {
            get { return box[0].DriverNeck; }
            set { box[0].DriverNeck = value; }
        }

        /// <summary>Length from the pivot of the blades back to the bend, m, 0 to 1; default 0.</summary>
        public double ShearsNeck
        {
            get { return box[0].ShearsNeck; }
            set { box[0].ShearsNeck = value; }
        }

        /// <summary>Radius of either neck, m, 1e-6 to 0.1; default 1.2e-3.</summary>
        public double NeckRadius
        {
            get { return box[0].NeckRadius; }
            set { box[0].NeckRadius = value; }
        }

        /// <summary>Length from the bend on, m, 1e-3 to 10; default 0.15.</summary>
        public double ShaftLength
        {
            get { return box[0].ShaftLength; }
            set { box[0].ShaftLength = value; }
        }

        /// <summary>Radius of the shaft, m, 1e-6 to 0.1; default 2.5e-3.</summary>
        public double ShaftRadius
        {
            get { return box[0].ShaftRadius; }
            set { box[0].ShaftRadius = value; }
        }

        /// <summary>Coefficient for contacts outside the grasp, 0 to 10; default 0.15.</summary>
        public double Friction
        {
            get { return box[0].Friction; }
            set { box[0].Friction = value; }
        }

        /// <summary>
        /// Pressure of the jaws on a grasped body when the handle is closed, N, 0 to 1e4; default
        /// 8.
        /// </summary>
        public double ClosingForce
        {
            get { return box[0].ClosingForce; }
            set { box[0].ClosingForce = value; }
        }

        /// <summary>
        /// Angle by which the jaws of a closed handle would close further without a grasped body,
        /// rad, 1e-3 to 1. The pressure grows over this angle from zero to closing_force. Default
        /// 0.1.
        /// </summary>
        public double ClosingAngle
        {
            get { return box[0].ClosingAngle; }
            set { box[0].ClosingAngle = value; }
        }

        /// <summary>Largest speed of each jaw, rad/s, 1e-2 to 1e3; default 8.</summary>
        public double JawSpeed
        {
            get { return box[0].JawSpeed; }
            set { box[0].JawSpeed = value; }
        }

        /// <summary>Coefficient of each face in the grasp, 0 to 10; default 0.5.</summary>
        public double GripFriction
        {
            get { return box[0].GripFriction; }
            set { box[0].GripFriction = value; }
        }

        /// <summary>Length of thread that a grasp holds, m, 1e-5 to 1e-1; default 1e-3.</summary>
        public double GripLength
        {
            get { return box[0].GripLength; }
            set { box[0].GripLength = value; }
        }

        /// <summary>
        /// Stiffness of the whole clamp of a thread along the faces, N/m, 1 to 1e6; default 3000.
        /// From face to face it is 64 times as stiff.
        /// </summary>
        public double GripStiffness
        {
            get { return box[0].GripStiffness; }
            set { box[0].GripStiffness = value; }
        }

        /// <summary>
        /// Mass of the proxy, kg, 1e-4 to 1e2; default 0.02. It is at the tip, with a radius of
        /// gyration of 30 mm.
        /// </summary>
        public double Mass
        {
            get { return box[0].Mass; }
            set { box[0].Mass = value; }
        }

        /// <summary>
        /// Stiffness of the virtual coupling, N/m, 0 to 1e9. The default of 400 suits haptic arms;
        /// scripted hands may use 2000 with a damping of 10 N s/m.
        /// </summary>
        public double Stiffness
        {
            get { return box[0].Stiffness; }
            set { box[0].Stiffness = value; }
        }

        /// <summary>
        /// Damping of the virtual coupling, N s/m, 0 to 1e6; default 5. If a hand receives its
        /// force a time d after its pose was read, and holds it for h, the damping must be at least
        /// stiffness (d + h / 2). Otherwise the coupling adds energy to a hand that presses on a
        /// rigid obstacle. At an elastic one the hand itself needs a little damping, which
        /// docs/reference/device-layer.md derives.
        /// </summary>
        public double Damping
        {
            get { return box[0].Damping; }
            set { box[0].Damping = value; }
        }

        /// <summary>Rotational stiffness of the coupling, N m/rad, 0 to 1e9; default 5.</summary>
        public double TurningStiffness
        {
            get { return box[0].TurningStiffness; }
            set { box[0].TurningStiffness = value; }
        }

        /// <summary>Rotational damping of the coupling, N m s/rad, 0 to 1e6; default 0.05.</summary>
        public double TurningDamping
        {
            get { return box[0].TurningDamping; }
            set { box[0].TurningDamping = value; }
        }

        /// <summary>
        /// Tools are exchanged only with empty jaws and with the tip farther than exchange_distance
        /// from this point, m, each at most 1e3; default 0.
        /// </summary>
        public Vector3d ExchangeCentre
        {
            get { return box[0].ExchangeCentre; }
            set { box[0].ExchangeCentre = value; }
        }

        /// <summary>Distance, m, 0 to 1e3; default 0: no limit.</summary>
        public double ExchangeDistance
        {
            get { return box[0].ExchangeDistance; }
            set { box[0].ExchangeDistance = value; }
        }

        /// <summary>VBLAST: its parameters; NULL (default): their defaults. The library copies them.</summary>
        public BaselineConfig Baseline { get; set; }

        /// <summary>Stiffness of the clamp on either, equal in all directions, N/m, 1 to 1e7; default 3e4.</summary>
        public double NeedleStiffness
        {
            get { return box[0].NeedleStiffness; }
            set { box[0].NeedleStiffness = value; }
        }

        /// <summary>
        /// Rotational stiffness of the clamp on a needle about the normal of the jaws' faces, N
        /// m/rad, 1e-6 to 1e4; default 0.5. About axes in the faces it is half of this.
        /// </summary>
        public double NeedleTurningStiffness
        {
            get { return box[0].NeedleTurningStiffness; }
            set { box[0].NeedleTurningStiffness = value; }
        }

        /// <summary>
        /// Torque at which a needle turns in the jaws of a closed handle, N m, 0 to 1e2; default
        /// 0.03 (not verified). The torque is proportional to the pressure of the jaws.
        /// </summary>
        public double NeedleTorque
        {
            get { return box[0].NeedleTorque; }
            set { box[0].NeedleTorque = value; }
        }

        /// <summary>See vbss_grasper_state::solenoid; 0 to 1; default 0.2.</summary>
        public double SolenoidOpening
        {
            get { return box[0].SolenoidOpening; }
            set { box[0].SolenoidOpening = value; }
        }

        internal GrasperConfigData* Pin(Pins pins)
        {
            ref GrasperConfigData data = ref box[0];
            data.Baseline = Baseline == null ? IntPtr.Zero : (IntPtr)Baseline.Pin(pins);
            return (GrasperConfigData*)pins.Array(box);
        }
    }

    /// <summary>Pose of a grasper, and the forces that act on it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct GrasperState
    {
        internal uint StructSize;
        /// <summary>Present kind.</summary>
        public GrasperKind Kind;
        /// <summary>Number of the grasper in its scene; 0: not in a scene.</summary>
        public uint Body;
        /// <summary>Number of grasps: places of threads, a needle, a wall.</summary>
        public uint GraspCount;
        /// <summary>Position of the tip, m.</summary>
        public Vector3d Position;
        /// <summary>Unit quaternion, w, x, y, z.</summary>
        public Quaterniond Orientation;
        /// <summary>Velocity of the tip, m/s.</summary>
        public Vector3d Velocity;
        /// <summary>Angular velocity, rad/s.</summary>
        public Vector3d AngularVelocity;
        /// <summary>Target of the tip, m.</summary>
        public Vector3d TargetPosition;
        /// <summary>Target, after the trocar has turned it.</summary>
        public Quaterniond TargetOrientation;
        /// <summary>Opening of the handle that the host set.</summary>
        public double Opening;
        /// <summary>Angle of each jaw from the middle, rad.</summary>
        public double JawAngle;
        /// <summary>Pressure of the jaws on all grasped bodies, N.</summary>
        public double Pressure;
        /// <summary>
        /// Force on the hand at the tip, which a device shall exert, N: a command for
        /// vbss_device_write. A device that gets the pose of the tool by vbss_device_write_coupled
        /// has this force already. VBLAST: the force of stretched threads that it carries.
        /// </summary>
        public Vector3d HandForce;
        /// <summary>Torque on the hand about the tip, N m; VBLAST: 0.</summary>
        public Vector3d HandTorque;
        /// <summary>Number of the held needle in its scene; 0: none.</summary>
        public uint Needle;
        /// <summary>Number of the drain whose wall it holds; 0: none.</summary>
        public uint Drain;
        /// <summary>
        /// 1: a solenoid shall lock the handle (vbss_output_command::solenoid). It is set once the
        /// tool holds a needle and the opening of the handle is below solenoid_opening, and cleared
        /// when the tool holds no needle.
        /// </summary>
        public uint Solenoid;
        internal uint Reserved;
    }
}
