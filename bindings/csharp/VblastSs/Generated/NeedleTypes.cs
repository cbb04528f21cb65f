// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_needle_preset.</summary>
    public enum NeedlePreset : int
    {
        /// <summary>Half circle of radius 10.5 mm (Qi et al. 2017): the defaults.</summary>
        Vblast = 0,
        /// <summary>Half circle of 26 mm, radius 8.28 mm (not verified).</summary>
        Sh = 1,
    }

    /// <summary>The constants of vbss_needle_field.</summary>
    public enum NeedleField : int
    {
        /// <summary>x 3: ends of the capsules' axes, m, from the tip to the swage; segment_count + 1 rows.</summary>
        Points = 0,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct NeedleConfigData
    {
        internal uint StructSize;
        internal Method Method;
        internal uint SegmentCount;
        internal uint Reserved;
        internal double Radius;
        internal double WireRadius;
        internal double Arc;
        internal double Density;
        internal double Friction;
        internal double Drag;
        internal Vector3d Gravity;
        internal Vector3d Position;
        internal Quaterniond Orientation;
        internal Vector3d Velocity;
        internal Vector3d AngularVelocity;
    }

    /// <summary>Configuration of a needle. Fill it with vbss_needle_config_init, then change fields.</summary>
    public sealed unsafe partial class NeedleConfig
    {
        private readonly NeedleConfigData[] box = new NeedleConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public NeedleConfig()
        {
            fixed (NeedleConfigData* data = box)
            {
                Vblast.Check(Native.vbss_needle_config_init(data, (uint)sizeof(NeedleConfigData)));
            }
        }

        /// <summary>Must be that of the scene; default VBSS_METHOD_IMPLICIT.</summary>
        public Method Method
        {
            get { return box[0].Method; }
            set { box[0].Method = value; }
        }

        /// <summary>Capsules along the arc, 2 to 64; default 8.</summary>
        public uint SegmentCount
        {
            get { return box[0].SegmentCount; }
            set { box[0].SegmentCount = value; }
        }

        /// <summary>Radius of the arc's centre line, m, 1e-4 to 1; default 10.5e-3, the paper's radius.</summary>
        public double Radius
        {
            get { return box[0].Radius; }
            set { box[0].Radius = value; }
        }

        /// <summary>Radius of the wire, m, 1e-6 to radius / 5; default 0.35e-3 (not verified).</summary>
        public double WireRadius
        {
            get { return box[0].WireRadius; }
            set { box[0].WireRadius = value; }
        }

        /// <summary>Angle from tip to swage, rad, 0.1 to 6; default pi.</summary>
        public double Arc
        {
            get { return box[0].Arc; }
            set { box[0].Arc = value; }
        }

        /// <summary>Density, kg/m^3, 1 to 1e5; default 7900, steel.</summary>
        public double Density
        {
            get { return box[0].Density; }
            set { box[0].Density = value; }
        }

        /// <summary>Coefficient of friction with other bodies of a scene, 0 to 10; default 0.2.</summary>
        public double Friction
        {
            get { return box[0].Friction; }
            set { box[0].Friction = value; }
        }

        /// <summary>Decay rate of linear and angular momentum, 1/s, 0 to 1e6; default 0.</summary>
        public double Drag
        {
            get { return box[0].Drag; }
            set { box[0].Drag = value; }
        }

        /// <summary>Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default 0.</summary>
        public Vector3d Gravity
        {
            get { return box[0].Gravity; }
            set { box[0].Gravity = value; }
        }

        /// <summary>Position of the frame's origin, m, each coordinate at most 1e3 in magnitude; default 0.</summary>
        public Vector3d Position
        {
            get { return box[0].Position; }
            set { box[0].Position = value; }
        }

        /// <summary>Orientation w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0.</summary>
        public Quaterniond Orientation
        {
            get { return box[0].Orientation; }
            set { box[0].Orientation = value; }
        }

        /// <summary>Velocity of the origin, m/s, each component at most 1e5 in magnitude; default 0.</summary>
        public Vector3d Velocity
        {
            get { return box[0].Velocity; }
            set { box[0].Velocity = value; }
        }

        /// <summary>Angular velocity, rad/s, each component at most 1e6 in magnitude; default 0.</summary>
        public Vector3d AngularVelocity
        {
            get { return box[0].AngularVelocity; }
            set { box[0].AngularVelocity = value; }
        }

        internal NeedleConfigData* Pin(Pins pins)
        {
            return (NeedleConfigData*)pins.Array(box);
        }
    }

    /// <summary>Pose and velocity of a needle.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct NeedleState
    {
        internal uint StructSize;
        /// <summary>Number of the needle in its scene; 0: not in a scene.</summary>
        public uint Body;
        /// <summary>Position of the frame's origin, m.</summary>
        public Vector3d Position;
        /// <summary>Orientation, unit quaternion w, x, y, z.</summary>
        public Quaterniond Orientation;
        /// <summary>Velocity of the origin, m/s.</summary>
        public Vector3d Velocity;
        /// <summary>Angular velocity, rad/s.</summary>
        public Vector3d AngularVelocity;
        /// <summary>Position of the tip, m.</summary>
        public Vector3d Tip;
        /// <summary>Unit vector out of the tip.</summary>
        public Vector3d TipDirection;
        /// <summary>Position of the swage, m.</summary>
        public Vector3d Swage;
        /// <summary>Unit vector of the thread, away from the needle.</summary>
        public Vector3d SwageDirection;
    }

    /// <summary>Mass and inertia of a needle.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct NeedleMass
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>Mass, kg.</summary>
        public double Mass;
        /// <summary>Length of the centre line, m.</summary>
        public double Length;
        /// <summary>Centre of mass in the needle's frame, m.</summary>
        public Vector3d Centre;
        /// <summary>Principal moments about it, kg m^2.</summary>
        public Vector3d Inertia;
        /// <summary>Their unit axes in the needle's frame, in the same order.</summary>
        public Vectors3 Axes;
    }

    /// <summary>Energies, J.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct NeedleEnergies
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>Kinetic energy of translation and rotation.</summary>
        public double Kinetic;
        /// <summary>Potential energy, zero at the world's origin.</summary>
        public double Gravity;
        /// <summary>Their sum.</summary>
        public double Total;
    }
}
