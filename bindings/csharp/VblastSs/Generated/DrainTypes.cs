// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_drain_mesh.</summary>
    public enum DrainMesh : int
    {
        /// <summary>137 nodes, 240 triangles.</summary>
        Mesh137 = 0,
        /// <summary>159 nodes, 280 triangles.</summary>
        Mesh159 = 1,
        /// <summary>181 nodes, 320 triangles.</summary>
        Mesh181 = 2,
        /// <summary>225 nodes, 400 triangles: for walls thinner than 0.6 mm.</summary>
        Mesh225 = 3,
    }

    /// <summary>The constants of vbss_drain_attachment_kind.</summary>
    public enum DrainAttachmentKind : int
    {
        /// <summary>The node is at `position`.</summary>
        Pin = 0,
        /// <summary>`force` pulls at the node.</summary>
        Force = 1,
        /// <summary>A spring from `position` to the node.</summary>
        Spring = 2,
    }

    /// <summary>The constants of vbss_drain_field. n nodes, m triangles.</summary>
    public enum DrainField : int
    {
        /// <summary>n x 3 doubles, m, on the middle surface.</summary>
        Positions = 0,
        /// <summary>n x 3 doubles, m/s.</summary>
        Velocities = 1,
        /// <summary>n x 3 doubles, m, in the drain's frame.</summary>
        RestPositions = 2,
        /// <summary>m x 3 uint32_t, nodes counter-clockwise seen from outside.</summary>
        Triangles = 3,
        /// <summary>uint32_t: nodes of the slit's edge on the left (-z), with both tips, along x.</summary>
        SlitLeft = 4,
        /// <summary>uint32_t: nodes of the slit's edge on the right (+z), with both tips, along x.</summary>
        SlitRight = 5,
        /// <summary>uint32_t: nodes of the bottom strip; method VBLAST: none.</summary>
        Anchors = 6,
        /// <summary>
        /// 3 doubles for each of VBSS_DRAIN_VIEW_ANCHORS, N: the force of the anchor on the drain;
        /// zero once it is torn off.
        /// </summary>
        AnchorForces = 7,
        /// <summary>
        /// m x 3 doubles: strains of the middle surface along and across the triangle's first side,
        /// and shear (2 e12). Method VBLAST reports strains and curvatures too, although it does
        /// not resist them.
        /// </summary>
        Strains = 8,
        /// <summary>
        /// m x 3 doubles, 1/m: changes of curvature along and across the triangle's first side, and
        /// twist (2 k12).
        /// </summary>
        Curvatures = 9,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct DrainSurfaceData
    {
        internal uint StructSize;
        internal uint NodeCount;
        internal uint TriangleCount;
        internal uint AnchorCount;
        internal IntPtr Positions;
        internal IntPtr Triangles;
        internal IntPtr Anchors;
        internal IntPtr Thickness;
        internal IntPtr YoungModulus;
    }

    /// <summary>
    /// A triangulated sheet or tube, which a drain may be in place of the tube with a slit: a pad
    /// of skin, a vessel, a bowel. Fill it with vbss_drain_surface_init, then set the arrays. The
    /// library copies them when the drain is created. The triangles are those of the middle surface
    /// at rest, without stress. Each edge belongs to one triangle (a free edge) or to two, which
    /// list it in opposite directions; where triangles meet in their interior, more than three meet
    /// at a node.
    /// </summary>
    public sealed unsafe partial class DrainSurface
    {
        private readonly DrainSurfaceData[] box = new DrainSurfaceData[1];

        /// <summary>The defaults of the library.</summary>
        public DrainSurface()
        {
            fixed (DrainSurfaceData* data = box)
            {
                Vblast.Check(Native.vbss_drain_surface_init(data, (uint)sizeof(DrainSurfaceData)));
            }
        }

        /// <summary>Number of nodes, 3 to 2048.</summary>
        public uint NodeCount
        {
            get { return box[0].NodeCount; }
            set { box[0].NodeCount = value; }
        }

        /// <summary>Number of triangles, 1 to 4096.</summary>
        public uint TriangleCount
        {
            get { return box[0].TriangleCount; }
            set { box[0].TriangleCount = value; }
        }

        /// <summary>Number of anchored nodes, 0 to node_count; default 0.</summary>
        public uint AnchorCount
        {
            get { return box[0].AnchorCount; }
            set { box[0].AnchorCount = value; }
        }

        /// <summary>
        /// node_count x 3: positions of the nodes at rest, in the drain's frame, m, each at most 1
        /// in magnitude.
        /// </summary>
        public double[] Positions { get; set; }

        /// <summary>
        /// triangle_count x 3: nodes of each triangle, counter-clockwise seen from outside. Needles
        /// enter from either side.
        /// </summary>
        public uint[] Triangles { get; set; }

        /// <summary>
        /// anchor_count: nodes that are glued to their place at rest, each once; NULL if there are
        /// none. They tear off above vbss_drain_config::tear_stress.
        /// </summary>
        public uint[] Anchors { get; set; }

        /// <summary>
        /// triangle_count: thickness of the wall that stiffness and mass of each triangle have, m,
        /// 1e-6 to 0.1; NULL (default): vbss_drain_config::thickness. Contacts use that one
        /// thickness everywhere.
        /// </summary>
        public double[] Thickness { get; set; }

        /// <summary>
        /// triangle_count: Young's modulus of each triangle, Pa, 1e3 to 1e12; NULL (default):
        /// vbss_drain_config::young_modulus.
        /// </summary>
        public double[] YoungModulus { get; set; }

        internal DrainSurfaceData* Pin(Pins pins)
        {
            ref DrainSurfaceData data = ref box[0];
            uint? countedNodeCount = null;
            uint? countedTriangleCount = null;
            uint? countedAnchorCount = null;
            data.Positions = pins.Array(Positions);
            if (Positions != null)
            {
                data.NodeCount = pins.Count(nameof(Positions), Positions.Length, 3, 0, ref countedNodeCount);
            }
            data.Triangles = pins.Array(Triangles);
            if (Triangles != null)
            {
                data.TriangleCount = pins.Count(nameof(Triangles), Triangles.Length, 3, 0, ref countedTriangleCount);
            }
            data.Anchors = pins.Array(Anchors);
            if (Anchors != null)
            {
                data.AnchorCount = pins.Count(nameof(Anchors), Anchors.Length, 1, 0, ref countedAnchorCount);
            }
            data.Thickness = pins.Array(Thickness);
            if (Thickness != null)
            {
                data.TriangleCount = pins.Count(nameof(Thickness), Thickness.Length, 1, 0, ref countedTriangleCount);
            }
            data.YoungModulus = pins.Array(YoungModulus);
            if (YoungModulus != null)
            {
                data.TriangleCount = pins.Count(nameof(YoungModulus), YoungModulus.Length, 1, 0, ref countedTriangleCount);
            }
            return (DrainSurfaceData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct DrainConfigData
    {
        internal uint StructSize;
        internal Method Method;
        internal DrainMesh Mesh;
        internal uint MeshDivisions;
        internal uint AttachmentCapacity;
        internal uint IterationLimit;
        internal uint HalvingLimit;
        internal uint Reserved;
        internal double Radius;
        internal double Length;
        internal double Thickness;
        internal double SlitLength;
        internal double SlitOpening;
        internal double MarkArc;
        internal double YoungModulus;
        internal double PoissonRatio;
        internal double Density;
        internal double Drag;
        internal Vector3d Gravity;
        internal Vector3d Position;
        internal Quaterniond Orientation;
        internal double TearStress;
        internal double PositionTolerance;
        internal double MoveLimit;
        internal IntPtr Baseline;
        internal double Friction;
        internal double PunctureForce;
        internal double HoleForce;
        internal double HoleFriction;
        internal double HoleStiffness;
        internal double HoleDamping;
        internal double TipLength;
        internal double ThreadForce;
        internal IntPtr Surface;
        internal double TearEnergy;
    }

    /// <summary>Configuration of a drain. Fill it with vbss_drain_config_init, then change fields.</summary>
    public sealed unsafe partial class DrainConfig
    {
        private readonly DrainConfigData[] box = new DrainConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public DrainConfig()
        {
            fixed (DrainConfigData* data = box)
            {
                Vblast.Check(Native.vbss_drain_config_init(data, (uint)sizeof(DrainConfigData)));
            }
        }

        /// <summary>Method; default VBSS_METHOD_IMPLICIT.</summary>
        public Method Method
        {
            get { return box[0].Method; }
            set { box[0].Method = value; }
        }

        /// <summary>Method IMPLICIT: mesh; default VBSS_DRAIN_MESH_137.</summary>
        public DrainMesh Mesh
        {
            get { return box[0].Mesh; }
            set { box[0].Mesh = value; }
        }

        /// <summary>Method IMPLICIT: divisions of each cell in each direction, 1 to 4; default 1.</summary>
        public uint MeshDivisions
        {
            get { return box[0].MeshDivisions; }
            set { box[0].MeshDivisions = value; }
        }

        /// <summary>Largest number of attachments, 0 to 256; default 8.</summary>
        public uint AttachmentCapacity
        {
            get { return box[0].AttachmentCapacity; }
            set { box[0].AttachmentCapacity = value; }
        }

        /// <summary>
        /// Method IMPLICIT: largest number of linearisations in a step, 1 to 50; default 1. A step
        /// with a larger limit stops at position_tolerance; this serves reference solutions.
        /// </summary>
        public uint IterationLimit
        {
            get { return box[0].IterationLimit; }
            set { box[0].IterationLimit = value; }
        }

        /// <summary>Method IMPLICIT: how often a step may be halved, 0 to 10; default 4.</summary>
        public uint HalvingLimit
        {
            get { return box[0].HalvingLimit; }
            set { box[0].HalvingLimit = value; }
        }

        /// <summary>Radius of the middle surface, m, 1e-4 to 1; default 6.5e-3.</summary>
        public double Radius
        {
            get { return box[0].Radius; }
            set { box[0].Radius = value; }
        }

        /// <summary>Length of the tube, m, 2 to 7 radii; default 32e-3.</summary>
        public double Length
        {
            get { return box[0].Length; }
            set { box[0].Length = value; }
        }

        /// <summary>
        /// Thickness of the wall, m, 0.01 to 0.3 radii, or with a surface 1e-6 to 0.1; default
        /// 1e-3.
        /// </summary>
        public double Thickness
        {
            get { return box[0].Thickness; }
            set { box[0].Thickness = value; }
        }

        /// <summary>Length of the slit, m, one radius to 0.7 lengths; default 10e-3.</summary>
        public double SlitLength
        {
            get { return box[0].SlitLength; }
            set { box[0].SlitLength = value; }
        }

        /// <summary>
        /// Width of the slit at its middle, along the surface, m, 0 to 0.4 slit lengths and one
        /// radius; default 3e-3.
        /// </summary>
        public double SlitOpening
        {
            get { return box[0].SlitOpening; }
            set { box[0].SlitOpening = value; }
        }

        /// <summary>
        /// Arc from the middle of the slit to each mark, along the surface before the slit was
        /// opened, m. It is longer than half the opening and lies between 20 and 90 degrees.
        /// Default 4.5e-3.
        /// </summary>
        public double MarkArc
        {
            get { return box[0].MarkArc; }
            set { box[0].MarkArc = value; }
        }

        /// <summary>
        /// Method IMPLICIT: Young's modulus, Pa, 1e3 to 1e12; default 1.2e6 (not verified for real
        /// drains).
        /// </summary>
        public double YoungModulus
        {
            get { return box[0].YoungModulus; }
            set { box[0].YoungModulus = value; }
        }

        /// <summary>Method IMPLICIT: Poisson's ratio, 0 to 0.49; default 0.47.</summary>
        public double PoissonRatio
        {
            get { return box[0].PoissonRatio; }
            set { box[0].PoissonRatio = value; }
        }

        /// <summary>Density, kg/m^3, 1 to 1e5; default 950.</summary>
        public double Density
        {
            get { return box[0].Density; }
            set { box[0].Density = value; }
        }

        /// <summary>Drag coefficient, 1/s, 0 to 1e6; default 20. The force is -drag * mass * velocity.</summary>
        public double Drag
        {
            get { return box[0].Drag; }
            set { box[0].Drag = value; }
        }

        /// <summary>
        /// Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default 0,
        /// because the rest shape is that of a drain that lies on its block.
        /// </summary>
        public Vector3d Gravity
        {
            get { return box[0].Gravity; }
            set { box[0].Gravity = value; }
        }

        /// <summary>Origin of the drain's frame in the world, m, each at most 1e3; default 0.</summary>
        public Vector3d Position
        {
            get { return box[0].Position; }
            set { box[0].Position = value; }
        }

        /// <summary>Quaternion (w, x, y, z) of any length from 1e-100 to 1e100; default (1, 0, 0, 0).</summary>
        public Quaterniond Orientation
        {
            get { return box[0].Orientation; }
            set { box[0].Orientation = value; }
        }

        /// <summary>
        /// Method IMPLICIT: strength of the glue of the strip, Pa, 1 to 1e12; default 5e4 (not
        /// verified). The anchor of a node tears off permanently above this stress times the node's
        /// area of the strip. Each step tears off at most one anchor: the one with the largest
        /// overload.
        /// </summary>
        public double TearStress
        {
            get { return box[0].TearStress; }
            set { box[0].TearStress = value; }
        }

        /// <summary>
        /// Method IMPLICIT: largest increment of the last linearisation, m, 1e-15 to 1; default
        /// 1e-6.
        /// </summary>
        public double PositionTolerance
        {
            get { return box[0].PositionTolerance; }
            set { box[0].PositionTolerance = value; }
        }

        /// <summary>
        /// Method IMPLICIT: a step in which a node would move farther than this gets one more
        /// linearisation. A step in which it would move four times as far is halved. m, 1e-9 to 1;
        /// default 1e-3.
        /// </summary>
        public double MoveLimit
        {
            get { return box[0].MoveLimit; }
            set { box[0].MoveLimit = value; }
        }

        /// <summary>Method VBLAST: its parameters; NULL (default): their defaults. The library copies them.</summary>
        public BaselineConfig Baseline { get; set; }

        /// <summary>
        /// In a scene: coefficient of friction with threads, 0 to 10. Friction with other bodies,
        /// the floor and the drain itself uses the geometric mean of both coefficients. Default 0.3
        /// (not verified).
        /// </summary>
        public double Friction
        {
            get { return box[0].Friction; }
            set { box[0].Friction = value; }
        }

        /// <summary>
        /// Force along the direction of a tip at which it enters a wall, N, 1e-3 to 1e3; default 1
        /// (the published range for both walls of a Penrose drain is 0.85 to 2.92).
        /// </summary>
        public double PunctureForce
        {
            get { return box[0].PunctureForce; }
            set { box[0].PunctureForce = value; }
        }

        /// <summary>
        /// Friction of a hole with a needle that slides in it, N, 1e-6 to 1e3; default 0.25 (not
        /// verified).
        /// </summary>
        public double HoleForce
        {
            get { return box[0].HoleForce; }
            set { box[0].HoleForce = value; }
        }

        /// <summary>
        /// Coefficient of the additional friction from the force across the suture, 0 to 10;
        /// default 0.3 (not verified).
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

        /// <summary>
        /// Friction of a hole with a slack thread in it, N, 1e-6 to 1e3; default 0.02 (not
        /// verified). A tight thread has capstan friction: docs/explanation/stitch.md.
        /// </summary>
        public double ThreadForce
        {
            get { return box[0].ThreadForce; }
            set { box[0].ThreadForce = value; }
        }

        /// <summary>
        /// Method IMPLICIT: sheet or tube in place of the tube with a slit; NULL (default): that
        /// tube. With a surface the fields mesh, mesh_divisions, radius, length, slit_length,
        /// slit_opening and mark_arc have no meaning, and the drain has neither marks nor a slit.
        /// The library copies the surface.
        /// </summary>
        public DrainSurface Surface { get; set; }

        /// <summary>
        /// In a scene, method IMPLICIT: energy for each square metre of cut, J/m^2, 1 to 1e7; 0
        /// (default): threads do not tear the wall at their holes. With it, a thread cuts through
        /// the wall when the force across it in the plane of the wall exceeds this energy times the
        /// thickness (of the triangle, where the surface states it): docs/explanation/tearing.md
        /// has published values. The mesh stays whole: the cut behind the thread is not opened.
        /// </summary>
        public double TearEnergy
        {
            get { return box[0].TearEnergy; }
            set { box[0].TearEnergy = value; }
        }

        internal DrainConfigData* Pin(Pins pins)
        {
            ref DrainConfigData data = ref box[0];
            data.Baseline = Baseline == null ? IntPtr.Zero : (IntPtr)Baseline.Pin(pins);
            data.Surface = Surface == null ? IntPtr.Zero : (IntPtr)Surface.Pin(pins);
            return (DrainConfigData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct DrainAttachmentData
    {
        internal uint StructSize;
        internal DrainAttachmentKind Kind;
        internal uint Node;
        internal uint Reserved;
        internal Vector3d Position;
        internal Vector3d Force;
        internal double Stiffness;
    }

    /// <summary>An attachment acts on one node. Fill it with vbss_drain_attachment_init.</summary>
    public sealed unsafe partial class DrainAttachment
    {
        private readonly DrainAttachmentData[] box = new DrainAttachmentData[1];

        /// <summary>The defaults of the library.</summary>
        public DrainAttachment()
        {
            fixed (DrainAttachmentData* data = box)
            {
                Vblast.Check(Native.vbss_drain_attachment_init(data, (uint)sizeof(DrainAttachmentData)));
            }
        }

        /// <summary>Kind; default VBSS_DRAIN_ATTACHMENT_PIN.</summary>
        public DrainAttachmentKind Kind
        {
            get { return box[0].Kind; }
            set { box[0].Kind = value; }
        }

        /// <summary>Node, which is not anchored.</summary>
        public uint Node
        {
            get { return box[0].Node; }
            set { box[0].Node = value; }
        }

        /// <summary>
        /// PIN: target of the node in the next step; SPRING: its fixed end; m, each coordinate at
        /// most 1e3 in magnitude.
        /// </summary>
        public Vector3d Position
        {
            get { return box[0].Position; }
            set { box[0].Position = value; }
        }

        /// <summary>FORCE: force, N, each component at most 1e6 in magnitude.</summary>
        public Vector3d Force
        {
            get { return box[0].Force; }
            set { box[0].Force = value; }
        }

        /// <summary>SPRING: stiffness, N/m, 0 to 1e9.</summary>
        public double Stiffness
        {
            get { return box[0].Stiffness; }
            set { box[0].Stiffness = value; }
        }

        internal DrainAttachmentData* Pin(Pins pins)
        {
            return (DrainAttachmentData*)pins.Array(box);
        }
    }

    /// <summary>Places on a drain, as nodes.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct DrainPlaces
    {
        internal uint StructSize;
        /// <summary>Number of nodes of the mesh.</summary>
        public uint NodeCount;
        /// <summary>Number of triangles of the mesh.</summary>
        public uint TriangleCount;
        /// <summary>The marks, left and right.</summary>
        public UInts2 Marks;
        /// <summary>The middles of the slit's edges, left and right, which are the paper's points.</summary>
        public UInts2 GapPoints;
        internal uint Reserved;
    }

    /// <summary>Opening of the slit.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct DrainGap
    {
        internal uint StructSize;
        /// <summary>Index of the opposite nodes that `largest` is between, along x.</summary>
        public uint LargestPair;
        /// <summary>Distance between the middles of the edges, m: the paper's measure.</summary>
        public double Gap;
        /// <summary>Largest distance between opposite nodes of the edges, m.</summary>
        public double Largest;
        /// <summary>
        /// Component of the vector between the middles, left to right, along that vector at rest,
        /// which moves with the drain's frame, m. It is negative when the edges have crossed.
        /// </summary>
        public double SignedGap;
        /// <summary>
        /// Distance between the lips at the middles of the edges, m, measured between the lines
        /// through the wall there. At rest it is about the gap. Where lips meet it is 0 to a fifth
        /// of the wall's thickness, for any rotation of the lips. Raised lips meet with their inner
        /// corners or face to face, while `gap` is up to a whole wall. The opening is 0 (shut)
        /// where one lip lies on the other. Method VBLAST measures it in the same manner.
        /// </summary>
        public double Opening;
        /// <summary>Largest opening between opposite nodes of the edges, m.</summary>
        public double WidestOpening;
        /// <summary>End points of `opening`, left and right, m.</summary>
        public Vectors2 Lips;
    }

    /// <summary>Energies of a drain, J.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct DrainEnergies
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>Kinetic energy of the lumped masses.</summary>
        public double Kinetic;
        /// <summary>Elastic energy of stretching; method VBLAST: zero.</summary>
        public double Membrane;
        /// <summary>Elastic energy of bending; method VBLAST: zero.</summary>
        public double Bending;
        /// <summary>Energy of SPRING attachments; method VBLAST: also of the springs to the rest positions.</summary>
        public double Springs;
        /// <summary>Potential, zero at the origin.</summary>
        public double Gravity;
        /// <summary>Sum of the energies.</summary>
        public double Total;
    }

    /// <summary>Counters since creation, and results of the last step.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct DrainStatistics
    {
        internal uint StructSize;
        /// <summary>Anchors that have torn off.</summary>
        public uint Torn;
        /// <summary>Triangles that are inverted or collapsed at present.</summary>
        public uint Inverted;
        internal uint Reserved;
        /// <summary>Calls of vbss_drain_step that succeeded, and steps of its scene.</summary>
        public ulong Steps;
        /// <summary>
        /// Accepted parts of steps, equal to `steps` if none was halved; method VBLAST: explicit
        /// steps.
        /// </summary>
        public ulong Parts;
        /// <summary>Linearisations assembled and solved.</summary>
        public ulong Linearisations;
        /// <summary>Corrections that were not small against the increment, and were left out.</summary>
        public ulong CorrectionsDropped;
        /// <summary>Parts that moved a node beyond four move_limits at the last halving.</summary>
        public ulong Forced;
        /// <summary>Largest displacement of a node in a part of the last step, m.</summary>
        public double LastMove;
        /// <summary>
        /// Largest displacement by the last correction of the last part, m: the remaining error is
        /// smaller.
        /// </summary>
        public double LastCorrection;
        /// <summary>Simulated time, s.</summary>
        public double Time;
        /// <summary>
        /// New matrices: a linearisation keeps the matrix of an earlier one while no node is
        /// farther than 0.05 move_limit from where it was then. Method VBLAST: zero.
        /// </summary>
        public ulong Matrices;
    }
}
