// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_scene_body_kind.</summary>
    public enum SceneBodyKind : int
    {
        /// <summary>A thread.</summary>
        Thread = 1,
        /// <summary>A drain.</summary>
        Drain = 2,
        /// <summary>A rigid body that is neither a needle nor a grasper.</summary>
        Rigid = 3,
        /// <summary>A needle.</summary>
        Needle = 4,
        /// <summary>A grasper.</summary>
        Grasper = 5,
        /// <summary>The floor, body 0.</summary>
        Floor = 6,
        /// <summary>A static mesh.</summary>
        StaticMesh = 7,
        /// <summary>A host surface (scene_surface.h).</summary>
        Surface = 8,
        /// <summary>A plane that the host added.</summary>
        Plane = 9,
    }

    /// <summary>Properties of a body in a scene.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneBodyInfo
    {
        internal uint StructSize;
        /// <summary>Number of the body.</summary>
        public uint Body;
        /// <summary>Kind of the body.</summary>
        public SceneBodyKind Kind;
        /// <summary>Kind of motion of rigid bodies, needles and graspers; 0 for other bodies.</summary>
        public SceneRigidKind Motion;
        /// <summary>Categories of its contact filter (vbss_scene_set_filter).</summary>
        public uint Category;
        /// <summary>Mask of its contact filter.</summary>
        public uint Mask;
        /// <summary>Coefficient of friction. For a thread, the one between threads.</summary>
        public double Friction;
        /// <summary>Gravitational acceleration, m/s^2; 0 for the floor.</summary>
        public Vector3d Gravity;
    }

    /// <summary>First surface that a ray hits.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneRayHit
    {
        internal uint StructSize;
        /// <summary>1: the ray hits something; 0: all other fields are 0.</summary>
        public uint IsHit;
        /// <summary>Number of the body; 0: the floor.</summary>
        public uint Body;
        /// <summary>Segment, capsule or triangle of the body; 0 for the floor.</summary>
        public uint Feature;
        /// <summary>Place on the ray, 0 at its origin to 1 at its end.</summary>
        public double Fraction;
        /// <summary>Point on the surface, m.</summary>
        public Vector3d Point;
        /// <summary>Outward unit normal of the surface there.</summary>
        public Vector3d Normal;
    }

    /// <summary>Body nearest to a point.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneNearest
    {
        internal uint StructSize;
        /// <summary>1: a surface is within the radius; 0: all other fields are 0.</summary>
        public uint IsFound;
        /// <summary>Number of the body; 0: the floor.</summary>
        public uint Body;
        /// <summary>Segment, capsule or triangle of the body; 0 for the floor.</summary>
        public uint Feature;
        /// <summary>Distance of its surface, m; negative inside the body.</summary>
        public double Distance;
        /// <summary>Nearest point of that surface, m.</summary>
        public Vector3d Point;
        /// <summary>Outward unit normal of the surface there.</summary>
        public Vector3d Normal;
    }
}
