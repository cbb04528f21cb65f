// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_scene_surface_field.</summary>
    public enum SceneSurfaceField : int
    {
        /// <summary>
        /// Positions of the vertices after the last step, m: vertex_count times x, y, z. They
        /// differ from the targets while a step is suspended, and after a step of which the scene
        /// left out a part.
        /// </summary>
        Positions = 1,
        /// <summary>Positions that the host gave last, m: vertex_count times x, y, z.</summary>
        Targets = 2,
        /// <summary>
        /// Forces of contacts and holes on the vertices at the end of the last step, friction
        /// included, N: vertex_count times x, y, z. Each contact force acts at a point of the
        /// middle of the wall, and the corners of the triangle or edge there share it by its
        /// barycentric coordinates. So the forces on the vertices have the sum and the torque of
        /// the contact forces at these points. The corners of the triangle in which a hole is share
        /// its force in the same way. After a step of which the scene left out a part they are
        /// those of the step before.
        /// </summary>
        Forces = 3,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct SceneSurfaceConfigData
    {
        internal uint StructSize;
        internal uint VertexCount;
        internal uint TriangleCount;
        internal uint OneSided;
        internal IntPtr Vertices;
        internal IntPtr Triangles;
        internal double Friction;
        internal double Thickness;
        internal double JumpLimit;
        internal uint ComplianceSize;
        internal uint Reserved;
        internal double PunctureForce;
        internal double HoleForce;
        internal double HoleFriction;
        internal double HoleStiffness;
        internal double HoleDamping;
        internal double TipLength;
        internal double ThreadForce;
        internal double TearEnergy;
    }

    /// <summary>
    /// Configuration of a host surface. Fill it with vbss_scene_surface_config_init, then change
    /// fields.
    /// </summary>
    public sealed unsafe partial class SceneSurfaceConfig
    {
        private readonly SceneSurfaceConfigData[] box = new SceneSurfaceConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public SceneSurfaceConfig()
        {
            fixed (SceneSurfaceConfigData* data = box)
            {
                Vblast.Check(Native.vbss_scene_surface_config_init(data, (uint)sizeof(SceneSurfaceConfigData)));
            }
        }

        /// <summary>Number of vertices, 3 to 65536.</summary>
        public uint VertexCount
        {
            get { return box[0].VertexCount; }
            set { box[0].VertexCount = value; }
        }

        /// <summary>Number of triangles, 1 to 131072.</summary>
        public uint TriangleCount
        {
            get { return box[0].TriangleCount; }
            set { box[0].TriangleCount = value; }
        }

        /// <summary>
        /// 0: both sides are solid. Other values are refused: the guard does not yet hold for one
        /// side of a surface that moves.
        /// </summary>
        public uint OneSided
        {
            get { return box[0].OneSided; }
            set { box[0].OneSided = value; }
        }

        /// <summary>
        /// First positions of the vertices in the world, m: vertex_count times x, y, z, each at
        /// most 1e3 in magnitude; the library copies them.
        /// </summary>
        public double[] Vertices { get; set; }

        /// <summary>
        /// Corners of triangles: triangle_count times three different indices of vertices, in any
        /// order. No triangle may be so thin that the cross product of two of its sides is zero.
        /// The library copies them.
        /// </summary>
        public uint[] Triangles { get; set; }

        /// <summary>
        /// Friction coefficient of its surface, 0 to 10; default 0.15. A contact with a thread has
        /// this coefficient, any other contact the geometric mean of both.
        /// </summary>
        public double Friction
        {
            get { return box[0].Friction; }
            set { box[0].Friction = value; }
        }

        /// <summary>
        /// Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. The triangles are its middle:
        /// other bodies touch it at half the thickness from them.
        /// </summary>
        public double Thickness
        {
            get { return box[0].Thickness; }
            set { box[0].Thickness = value; }
        }

        /// <summary>
        /// Largest distance between two positions of a vertex that the host gives one after the
        /// other, m, 1e-6 to 1e3; default 20e-3: 20 m/s at steps of 1 ms. vbss_scene_move_surface
        /// refuses a longer one.
        /// </summary>
        public double JumpLimit
        {
            get { return box[0].JumpLimit; }
            set { box[0].JumpLimit = value; }
        }

        /// <summary>
        /// Numbers with which the host states how far each vertex gives way to a force: 0
        /// (default): none, all vertices are exactly where the host says; 1: one compliance for all
        /// directions; 9: a symmetric matrix of 3 x 3. Values are set by
        /// vbss_scene_set_surface_compliance, and are zero before.
        /// </summary>
        public uint ComplianceSize
        {
            get { return box[0].ComplianceSize; }
            set { box[0].ComplianceSize = value; }
        }

        /// <summary>
        /// Force along the direction of a tip at which it enters the wall, N, 1e-3 to 1e3; 0
        /// (default): no tip enters by force, and holes are those of vbss_scene_make_hole only.
        /// </summary>
        public double PunctureForce
        {
            get { return box[0].PunctureForce; }
            set { box[0].PunctureForce = value; }
        }

        /// <summary>Friction of a hole with a needle that slides in it, N, 1e-6 to 1e3; default 0.25.</summary>
        public double HoleForce
        {
            get { return box[0].HoleForce; }
            set { box[0].HoleForce = value; }
        }

        /// <summary>
        /// Coefficient of the additional friction from the force across the suture, 0 to 10;
        /// default 0.3.
        /// </summary>
        public double HoleFriction
        {
            get { return box[0].HoleFriction; }
            set { box[0].HoleFriction = value; }
        }

        /// <summary>Stiffness of a hole across and along the suture in it, N/m, 1 to 1e7; default 2e4.</summary>
        public double HoleStiffness
        {
            get { return box[0].HoleStiffness; }
            set { box[0].HoleStiffness = value; }
        }

        /// <summary>Damping of sliding in a hole, N s/m, 0 to 1e3; default 0.05.</summary>
        public double HoleDamping
        {
            get { return box[0].HoleDamping; }
            set { box[0].HoleDamping = value; }
        }

        /// <summary>
        /// Length of a tip's path through the wall over which the force against its advance falls
        /// from puncture_force to hole_force, and that against drawing it back grows from 0 to
        /// hole_force; m, 0 to 0.1; default 0.5e-3.
        /// </summary>
        public double TipLength
        {
            get { return box[0].TipLength; }
            set { box[0].TipLength = value; }
        }

        /// <summary>Friction of a hole with a slack thread in it, N, 1e-6 to 1e3; default 0.02.</summary>
        public double ThreadForce
        {
            get { return box[0].ThreadForce; }
            set { box[0].ThreadForce = value; }
        }

        /// <summary>
        /// Energy for each square metre of cut, J/m^2, 1 to 1e7; 0 (default): threads do not tear
        /// the wall at their holes. Otherwise as vbss_drain_config::tear_energy.
        /// </summary>
        public double TearEnergy
        {
            get { return box[0].TearEnergy; }
            set { box[0].TearEnergy = value; }
        }

        internal SceneSurfaceConfigData* Pin(Pins pins)
        {
            ref SceneSurfaceConfigData data = ref box[0];
            uint? countedVertexCount = null;
            uint? countedTriangleCount = null;
            data.Vertices = pins.Array(Vertices);
            if (Vertices != null)
            {
                data.VertexCount = pins.Count(nameof(Vertices), Vertices.Length, 3, 0, ref countedVertexCount);
            }
            data.Triangles = pins.Array(Triangles);
            if (Triangles != null)
            {
                data.TriangleCount = pins.Count(nameof(Triangles), Triangles.Length, 3, 0, ref countedTriangleCount);
            }
            return (SceneSurfaceConfigData*)pins.Array(box);
        }
    }

    /// <summary>A hole of a host surface that gets another mesh, as vbss_scene_place_hole_fn receives it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneHolePlace
    {
        internal uint StructSize;
        /// <summary>Id of the hole, as vbss_scene_make_hole gave it.</summary>
        public uint Hole;
        /// <summary>Triangle of the mesh before in which the hole is.</summary>
        public uint Triangle;
        internal uint Reserved;
        /// <summary>Barycentric coordinates of the hole in that triangle.</summary>
        public Doubles3 Weights;
        /// <summary>Where the hole is now, in the world, m.</summary>
        public Vector3d Position;
        /// <summary>Unit normal of that triangle now: along (b - a) x (c - a) for its corners a, b, c.</summary>
        public Vector3d Normal;
    }
}
