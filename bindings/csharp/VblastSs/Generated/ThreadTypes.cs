// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_thread_bending.</summary>
    public enum ThreadBending : int
    {
        /// <summary>
        /// Fourth order: the energy of the cubic spline through the nodes, truncated to neighbours
        /// three apart. The length of a segment is that of its arc.
        /// </summary>
        Spline = 0,
        /// <summary>
        /// Second order: each node couples with its two neighbours only. The length of a segment is
        /// its chord.
        /// </summary>
        Local = 1,
    }

    /// <summary>The constants of vbss_thread_mesh.</summary>
    public enum ThreadMesh : int
    {
        /// <summary>Nodes and rest lengths stay as they were created.</summary>
        Fixed = 0,
        /// <summary>
        /// Method IMPLICIT, docs/explanation/adaptive.md: between two steps the thread divides
        /// segments where it is bent or near another body, and removes nodes where it is straight
        /// and has clearance. This renumbers nodes, segments, attachments, pins, grasps and
        /// contacts.
        /// </summary>
        Adaptive = 1,
    }

    /// <summary>The constants of vbss_thread_preset.</summary>
    public enum ThreadPreset : int
    {
        /// <summary>
        /// 2-0 silk: 0.32 mm, 1.05e-4 kg/m, EA = 700 N (8.7 GPa), EI = 2.7e-8 N m^2. Diameter by
        /// USP &lt;861&gt; (0.30 to 0.339 mm), density of a solid braid; EI is that of the paper's
        /// thread, scaled with the fourth power of the radius, and uncertain by a factor of five.
        /// </summary>
        Silk2_0 = 0,
        /// <summary>The thread of VBLaST-SS: 0.25 mm, 6.4e-5 kg/m, EA = 427 N, EI = 1e-8 N m^2.</summary>
        Vblast = 1,
    }

    /// <summary>
    /// The constants of vbss_thread_material. docs/reference/sutures.md has sources and
    /// uncertainties.
    /// </summary>
    public enum ThreadMaterial : int
    {
        /// <summary>Braided silk.</summary>
        Silk = 0,
        /// <summary>Braided polyglactin 910, absorbable.</summary>
        Polyglactin = 1,
        /// <summary>Polypropylene monofilament.</summary>
        Polypropylene = 2,
        /// <summary>Nylon monofilament.</summary>
        Nylon = 3,
    }

    /// <summary>The constants of vbss_thread_usp_size, with the middle of the range of the diameter, mm.</summary>
    public enum ThreadUspSize : int
    {
        /// <summary>0.025 (0.020 to 0.029).</summary>
        Usp10_0 = -10,
        /// <summary>0.035 (0.030 to 0.039).</summary>
        Usp9_0 = -9,
        /// <summary>0.045 (0.040 to 0.049).</summary>
        Usp8_0 = -8,
        /// <summary>0.06 (0.050 to 0.069).</summary>
        Usp7_0 = -7,
        /// <summary>0.085 (0.070 to 0.099).</summary>
        Usp6_0 = -6,
        /// <summary>0.125 (0.100 to 0.149).</summary>
        Usp5_0 = -5,
        /// <summary>0.175 (0.150 to 0.199).</summary>
        Usp4_0 = -4,
        /// <summary>0.225 (0.200 to 0.249).</summary>
        Usp3_0 = -3,
        /// <summary>0.32 (0.300 to 0.339).</summary>
        Usp2_0 = -2,
        /// <summary>0.375 (0.350 to 0.399).</summary>
        Usp0 = 0,
        /// <summary>0.45 (0.400 to 0.499).</summary>
        Usp1 = 1,
        /// <summary>0.55 (0.500 to 0.599).</summary>
        Usp2 = 2,
    }

    /// <summary>The constants of vbss_thread_attachment_kind.</summary>
    public enum ThreadAttachmentKind : int
    {
        /// <summary>The node is held at `position`.</summary>
        Pin = 0,
        /// <summary>The node is held at `position`, and the thread's direction there is `direction`.</summary>
        Clamp = 1,
        /// <summary>`force` pulls at the node.</summary>
        Force = 2,
        /// <summary>A spring-damper from `position` to the node.</summary>
        Spring = 3,
        /// <summary>`mass` is fixed to the node; it has inertia and weight.</summary>
        Mass = 4,
        /// <summary>
        /// Threads with torsional_stiffness: holds the section at the node, which moves freely;
        /// vbss_thread_set_roll turns it. A CLAMP does this, too.
        /// </summary>
        Roll = 5,
    }

    /// <summary>The constants of vbss_thread_field. n is the number of nodes.</summary>
    public enum ThreadField : int
    {
        /// <summary>n x 3 doubles, m.</summary>
        Positions = 0,
        /// <summary>n x 3 doubles, m/s.</summary>
        Velocities = 1,
        /// <summary>n - 1 doubles, m.</summary>
        RestLengths = 2,
        /// <summary>n - 1 doubles, m: chords, or arcs with BENDING_SPLINE.</summary>
        Lengths = 3,
        /// <summary>
        /// n - 1 doubles, N: force along each segment at the end of the last step, due to
        /// stretching and bending.
        /// </summary>
        Tensions = 4,
        /// <summary>n x 3 doubles, 1/m: from the node to the centre of curvature.</summary>
        Curvatures = 5,
        /// <summary>First node of each section, uint32_t; the last ends at node n - 1.</summary>
        Sections = 6,
        /// <summary>
        /// n - 1 doubles, m: sagitta of each segment, the shape error due to the mesh. It is rest
        /// length^2 / 8 times the larger curvature at the two nodes. Fixed meshes have it too.
        /// </summary>
        Sagittas = 7,
        /// <summary>
        /// n x 3 doubles, 1/m: plastic curvature at each node, towards the centre of curvature; at
        /// a clamp as VBSS_THREAD_VIEW_CURVATURES. No entries in a thread without memory of bends.
        /// </summary>
        PlasticCurvatures = 8,
        /// <summary>The same for the viscous curvature: that at which the viscous branch has no moment.</summary>
        ViscousCurvatures = 9,
        /// <summary>
        /// n - 1 doubles, rad/m: twist per length of each segment; between a holder and a free end
        /// 0, with friction_torque rest_twist where no contact resists. No entries in a thread
        /// without torsional_stiffness.
        /// </summary>
        Twists = 10,
        /// <summary>
        /// n - 1 x 3 doubles: a unit vector across each segment, at its middle, that is fixed to
        /// the material; for display. No entries in a thread without torsional_stiffness.
        /// </summary>
        MaterialDirectors = 11,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ThreadConfigData
    {
        internal uint StructSize;
        internal Method Method;
        internal ThreadBending Bending;
        internal uint SegmentCount;
        internal uint AttachmentCapacity;
        internal uint CutCapacity;
        internal double Length;
        internal double Radius;
        internal double LinearDensity;
        internal double AxialStiffness;
        internal double BendingStiffness;
        internal double RestCurvature;
        internal Vector3d Gravity;
        internal double Drag;
        internal double Damping;
        internal Vector3d Start;
        internal Vector3d Direction;
        internal IntPtr RestLengths;
        internal IntPtr Positions;
        internal double SpectralRadius;
        internal double StretchTolerance;
        internal double PositionTolerance;
        internal uint IterationLimit;
        internal uint HalvingLimit;
        internal IntPtr Baseline;
        internal ThreadMesh Mesh;
        internal uint NodeCapacity;
        internal double FinestLength;
        internal double CoarsestLength;
        internal double RefineAngle;
        internal double CoarsenAngle;
        internal double NearDistance;
        internal double ClearDistance;
        internal uint MeshOperations;
        internal uint FrictionTorque;
        internal double YieldCurvature;
        internal double YieldHardening;
        internal double RelaxationRatio;
        internal double RelaxationTime;
        internal double TorsionalStiffness;
        internal double RestTwist;
    }

    /// <summary>Configuration of a thread. Fill it with vbss_thread_config_init, then change fields.</summary>
    public sealed unsafe partial class ThreadConfig
    {
        private readonly ThreadConfigData[] box = new ThreadConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public ThreadConfig()
        {
            fixed (ThreadConfigData* data = box)
            {
                Vblast.Check(Native.vbss_thread_config_init(data, (uint)sizeof(ThreadConfigData)));
            }
        }

        /// <summary>Method; default VBSS_METHOD_IMPLICIT.</summary>
        public Method Method
        {
            get { return box[0].Method; }
            set { box[0].Method = value; }
        }

        /// <summary>Method IMPLICIT: discretisation of bending; default VBSS_THREAD_BENDING_SPLINE.</summary>
        public ThreadBending Bending
        {
            get { return box[0].Bending; }
            set { box[0].Bending = value; }
        }

        /// <summary>Number of segments, 1 to 65536; default 120.</summary>
        public uint SegmentCount
        {
            get { return box[0].SegmentCount; }
            set { box[0].SegmentCount = value; }
        }

        /// <summary>Largest number of attachments, 0 to 256; default 8.</summary>
        public uint AttachmentCapacity
        {
            get { return box[0].AttachmentCapacity; }
            set { box[0].AttachmentCapacity = value; }
        }

        /// <summary>Largest number of cuts of this thread and its pieces, 0 to 64; default 0.</summary>
        public uint CutCapacity
        {
            get { return box[0].CutCapacity; }
            set { box[0].CutCapacity = value; }
        }

        /// <summary>
        /// Length, m, 1e-6 to 1e3, at least 1e-7 per segment; default 0.15; ignored with
        /// rest_lengths.
        /// </summary>
        public double Length
        {
            get { return box[0].Length; }
            set { box[0].Length = value; }
        }

        /// <summary>
        /// Radius, m, 1e-7 to 0.1; default of VBSS_THREAD_PRESET_VBLAST. Contact in a scene and
        /// display use it; a thread alone does not.
        /// </summary>
        public double Radius
        {
            get { return box[0].Radius; }
            set { box[0].Radius = value; }
        }

        /// <summary>Mass per length, kg/m, 1e-9 to 1e3; default of that preset.</summary>
        public double LinearDensity
        {
            get { return box[0].LinearDensity; }
            set { box[0].LinearDensity = value; }
        }

        /// <summary>Axial stiffness EA, N, 1e-6 to 1e9; default of that preset.</summary>
        public double AxialStiffness
        {
            get { return box[0].AxialStiffness; }
            set { box[0].AxialStiffness = value; }
        }

        /// <summary>Bending stiffness EI, N m^2, 0 to 1e3; default of that preset.</summary>
        public double BendingStiffness
        {
            get { return box[0].BendingStiffness; }
            set { box[0].BendingStiffness = value; }
        }

        /// <summary>
        /// Curvature at rest, 1/m, 0 to 1e4; default 0. Its plane is free, because such a thread
        /// has no twist: it does not work with torsional_stiffness.
        /// </summary>
        public double RestCurvature
        {
            get { return box[0].RestCurvature; }
            set { box[0].RestCurvature = value; }
        }

        /// <summary>
        /// Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default (0,
        /// -9.81, 0).
        /// </summary>
        public Vector3d Gravity
        {
            get { return box[0].Gravity; }
            set { box[0].Gravity = value; }
        }

        /// <summary>Drag coefficient, 1/s, 0 to 1e6; default 0. The force is -drag * mass * velocity.</summary>
        public double Drag
        {
            get { return box[0].Drag; }
            set { box[0].Drag = value; }
        }

        /// <summary>
        /// Method IMPLICIT: decay rate of the motion relative to the rigid motion of each section,
        /// 1/s, 0 to 1e6; default 0. It conserves linear and angular momentum.
        /// </summary>
        public double Damping
        {
            get { return box[0].Damping; }
            set { box[0].Damping = value; }
        }

        /// <summary>
        /// Position of node 0, m, each coordinate at most 1e3 in magnitude; default (0, 0, 0);
        /// ignored with positions.
        /// </summary>
        public Vector3d Start
        {
            get { return box[0].Start; }
            set { box[0].Start = value; }
        }

        /// <summary>
        /// Direction from node 0 on, of any length from 1e-100 to 1e100; default (1, 0, 0); ignored
        /// with positions.
        /// </summary>
        public Vector3d Direction
        {
            get { return box[0].Direction; }
            set { box[0].Direction = value; }
        }

        /// <summary>
        /// Rest length of each segment, m, 1e-7 to 1e2; segment_count values, or NULL (default) for
        /// length / segment_count each. vbss_thread_grade_lengths fills such an array. The library
        /// copies it.
        /// </summary>
        public double[] RestLengths { get; set; }

        /// <summary>
        /// Positions of the nodes, m, each at most 1e3; 3 (segment_count + 1) values, or NULL
        /// (default) for a straight thread from start along direction. The library copies them.
        /// </summary>
        public double[] Positions { get; set; }

        /// <summary>
        /// Method IMPLICIT: spectral radius at infinite frequency of the time integration, 0
        /// (strongest damping) to 1 (none); default 0.3. Above 0.5 stiff motion may gain energy.
        /// </summary>
        public double SpectralRadius
        {
            get { return box[0].SpectralRadius; }
            set { box[0].SpectralRadius = value; }
        }

        /// <summary>
        /// Method IMPLICIT: largest stretch error that a step may leave, 1e-12 to 1e-2; default
        /// 1e-6.
        /// </summary>
        public double StretchTolerance
        {
            get { return box[0].StretchTolerance; }
            set { box[0].StretchTolerance = value; }
        }

        /// <summary>
        /// Method IMPLICIT: largest distance by which a further linearisation would move a node, m,
        /// 1e-12 to 1; an estimate; default 1e-6.
        /// </summary>
        public double PositionTolerance
        {
            get { return box[0].PositionTolerance; }
            set { box[0].PositionTolerance = value; }
        }

        /// <summary>
        /// Method IMPLICIT: largest number of linearisations of an attempt, 1 to 100; default 40.
        /// Smooth motion takes one or two. The worst known case (ends shaken by 3 mm every ms)
        /// takes 300 in a step with its halves.
        /// </summary>
        public uint IterationLimit
        {
            get { return box[0].IterationLimit; }
            set { box[0].IterationLimit = value; }
        }

        /// <summary>
        /// Method IMPLICIT: how often a step is halved before its state is accepted unconverged, 0
        /// to 10; default 5. `forced` counts such states and should stay zero.
        /// </summary>
        public uint HalvingLimit
        {
            get { return box[0].HalvingLimit; }
            set { box[0].HalvingLimit = value; }
        }

        /// <summary>Method VBLAST: its parameters; NULL (default): their defaults. The library copies them.</summary>
        public BaselineConfig Baseline { get; set; }

        /// <summary>Default VBSS_THREAD_MESH_FIXED, which ignores the following fields.</summary>
        public ThreadMesh Mesh
        {
            get { return box[0].Mesh; }
            set { box[0].Mesh = value; }
        }

        /// <summary>
        /// ADAPTIVE: largest number of nodes, segment_count + 1 to 65537; default 0: four times the
        /// initial number of segments, at most 65536. A scene must have capacity for all of them
        /// when the thread is added.
        /// </summary>
        public uint NodeCapacity
        {
            get { return box[0].NodeCapacity; }
            set { box[0].NodeCapacity = value; }
        }

        /// <summary>
        /// ADAPTIVE: length of the finest segments, m, 1e-7 to coarsest_length; default 3e-4, 1.2
        /// diameters of the paper's thread, at which a tight knot is converged. Because segments
        /// are halved, the finest ones have 0.63 to 1.25 times this length. Choose initial lengths
        /// of this length times a power of two.
        /// </summary>
        public double FinestLength
        {
            get { return box[0].FinestLength; }
            set { box[0].FinestLength = value; }
        }

        /// <summary>
        /// ADAPTIVE: a node is not removed if that leaves a segment longer than 1.25 times this
        /// length, m, at most 1e2; default 2e-3.
        /// </summary>
        public double CoarsestLength
        {
            get { return box[0].CoarsestLength; }
            set { box[0].CoarsestLength = value; }
        }

        /// <summary>
        /// ADAPTIVE: curvature times length, rad, above which a segment is divided, 0.01 to 1;
        /// default 0.25.
        /// </summary>
        public double RefineAngle
        {
            get { return box[0].RefineAngle; }
            set { box[0].RefineAngle = value; }
        }

        /// <summary>
        /// ADAPTIVE: curvature times length, rad, below which a node may be removed, 0 to half of
        /// refine_angle; default 0.05.
        /// </summary>
        public double CoarsenAngle
        {
            get { return box[0].CoarsenAngle; }
            set { box[0].CoarsenAngle = value; }
        }

        /// <summary>
        /// ADAPTIVE, in a scene: gap, m, to another strand below which a segment is divided down to
        /// finest_length, and to a tool down to a quarter of its radius; 0 to 0.1; default 1e-3.
        /// The floor does not count.
        /// </summary>
        public double NearDistance
        {
            get { return box[0].NearDistance; }
            set { box[0].NearDistance = value; }
        }

        /// <summary>
        /// ADAPTIVE, in a scene: a node is removed only if no other body is within this gap, m,
        /// near_distance to 0.1; default 3e-3.
        /// </summary>
        public double ClearDistance
        {
            get { return box[0].ClearDistance; }
            set { box[0].ClearDistance = value; }
        }

        /// <summary>ADAPTIVE: largest number of divisions and removals after a step, 0 to 64; default 4.</summary>
        public uint MeshOperations
        {
            get { return box[0].MeshOperations; }
            set { box[0].MeshOperations = value; }
        }

        /// <summary>
        /// 1: contacts of a scene resist rolling of the thread about itself by their friction, so
        /// that a tight knot holds twist on either side of itself; 0 (default): they let it roll.
        /// Needs torsional_stiffness. docs/explanation/twist.md has the model.
        /// </summary>
        public uint FrictionTorque
        {
            get { return box[0].FrictionTorque; }
            set { box[0].FrictionTorque = value; }
        }

        /// <summary>
        /// Method IMPLICIT: elastic curvature beyond which bending is plastic, 1/m, 0 to 1e6;
        /// default 0: bending is elastic. The bending moment at yield is EI times this curvature.
        /// docs/explanation/bending-memory.md has the model. Memory of bends, plastic or viscous,
        /// needs VBSS_THREAD_MESH_FIXED and a rest_curvature of 0.
        /// </summary>
        public double YieldCurvature
        {
            get { return box[0].YieldCurvature; }
            set { box[0].YieldCurvature = value; }
        }

        /// <summary>
        /// Stiffness of bending beyond yield as a fraction of EI, 0 (ideally plastic) to 0.999;
        /// default 0. The hardening is linear and kinematic.
        /// </summary>
        public double YieldHardening
        {
            get { return box[0].YieldHardening; }
            set { box[0].YieldHardening = value; }
        }

        /// <summary>
        /// Method IMPLICIT: stiffness of the viscous branch of bending as a fraction of EI, 0 to
        /// 1e3; default 0: there is none. A fast bend has the stiffness EI (1 + relaxation_ratio),
        /// a slow one EI.
        /// </summary>
        public double RelaxationRatio
        {
            get { return box[0].RelaxationRatio; }
            set { box[0].RelaxationRatio = value; }
        }

        /// <summary>
        /// Time in which the moment of the viscous branch decays to 1/e at constant curvature, s,
        /// 1e-6 to 1e9; default 1.
        /// </summary>
        public double RelaxationTime
        {
            get { return box[0].RelaxationTime; }
            set { box[0].RelaxationTime = value; }
        }

        /// <summary>
        /// Method IMPLICIT: torsional stiffness GJ, N m^2, 0 to 1e3; default 0: the thread has no
        /// twist. docs/explanation/twist.md has the model. Twist needs VBSS_THREAD_MESH_FIXED, a
        /// rest_curvature of 0 and bends without memory.
        /// </summary>
        public double TorsionalStiffness
        {
            get { return box[0].TorsionalStiffness; }
            set { box[0].TorsionalStiffness = value; }
        }

        /// <summary>
        /// Twist per length at which there is no torque, rad/m, -1e5 to 1e5; default 0; needs
        /// torsional_stiffness.
        /// </summary>
        public double RestTwist
        {
            get { return box[0].RestTwist; }
            set { box[0].RestTwist = value; }
        }

        internal ThreadConfigData* Pin(Pins pins)
        {
            ref ThreadConfigData data = ref box[0];
            uint? countedSegmentCount = null;
            data.RestLengths = pins.Array(RestLengths);
            if (RestLengths != null)
            {
                data.SegmentCount = pins.Count(nameof(RestLengths), RestLengths.Length, 1, 0, ref countedSegmentCount);
            }
            data.Positions = pins.Array(Positions);
            if (Positions != null)
            {
                data.SegmentCount = pins.Count(nameof(Positions), Positions.Length, 3, 1, ref countedSegmentCount);
            }
            data.Baseline = Baseline == null ? IntPtr.Zero : (IntPtr)Baseline.Pin(pins);
            return (ThreadConfigData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ThreadAttachmentData
    {
        internal uint StructSize;
        internal ThreadAttachmentKind Kind;
        internal uint Node;
        internal uint Reserved;
        internal Vector3d Position;
        internal Vector3d Direction;
        internal Vector3d Force;
        internal double Stiffness;
        internal double Damping;
        internal double Mass;
    }

    /// <summary>An attachment acts on one node. Fill it with vbss_thread_attachment_init.</summary>
    public sealed unsafe partial class ThreadAttachment
    {
        private readonly ThreadAttachmentData[] box = new ThreadAttachmentData[1];

        /// <summary>The defaults of the library.</summary>
        public ThreadAttachment()
        {
            fixed (ThreadAttachmentData* data = box)
            {
                Vblast.Check(Native.vbss_thread_attachment_init(data, (uint)sizeof(ThreadAttachmentData)));
            }
        }

        /// <summary>Kind; default VBSS_THREAD_ATTACHMENT_PIN.</summary>
        public ThreadAttachmentKind Kind
        {
            get { return box[0].Kind; }
            set { box[0].Kind = value; }
        }

        /// <summary>Node, 0 to segment_count; default 0.</summary>
        public uint Node
        {
            get { return box[0].Node; }
            set { box[0].Node = value; }
        }

        /// <summary>
        /// PIN, CLAMP: target of the node in the next step; SPRING: its fixed end; m, each
        /// coordinate at most 1e3 in magnitude.
        /// </summary>
        public Vector3d Position
        {
            get { return box[0].Position; }
            set { box[0].Position = value; }
        }

        /// <summary>
        /// CLAMP: direction of the thread towards higher nodes, of any length from 1e-100 to 1e100;
        /// default (1, 0, 0). A thread with another direction turns there in the next step.
        /// </summary>
        public Vector3d Direction
        {
            get { return box[0].Direction; }
            set { box[0].Direction = value; }
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

        /// <summary>SPRING: damping of the velocity relative to the moving end, N s/m, 0 to 1e6.</summary>
        public double Damping
        {
            get { return box[0].Damping; }
            set { box[0].Damping = value; }
        }

        /// <summary>MASS: mass, kg, 0 to 1e3.</summary>
        public double Mass
        {
            get { return box[0].Mass; }
            set { box[0].Mass = value; }
        }

        internal ThreadAttachmentData* Pin(Pins pins)
        {
            return (ThreadAttachmentData*)pins.Array(box);
        }
    }

    /// <summary>Reaction of an attachment in the last step.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ThreadReaction
    {
        internal uint StructSize;
        /// <summary>The node, as cuts have renumbered it.</summary>
        public uint Node;
        /// <summary>Force of the attachment on the thread at the end of the step, N.</summary>
        public Vector3d Force;
        /// <summary>CLAMP, ROLL: torque of the attachment on the thread, N m; else 0.</summary>
        public Vector3d Torque;
    }

    /// <summary>Energies of a thread, J.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ThreadEnergies
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>Kinetic energy, attached masses included.</summary>
        public double Kinetic;
        /// <summary>Elastic energy of EA.</summary>
        public double Stretching;
        /// <summary>Elastic energy of bending; with memory what hardening stores, too.</summary>
        public double Bending;
        /// <summary>Potential, zero at the origin; attached masses included.</summary>
        public double Gravity;
        /// <summary>Sum of the four and of `twisting`.</summary>
        public double Total;
        /// <summary>
        /// Energy that plastic and viscous bending have dissipated since creation, or since the cut
        /// that made this piece; not part of the total; never decreases.
        /// </summary>
        public double Dissipated;
        /// <summary>Elastic energy of twist.</summary>
        public double Twisting;
    }

    /// <summary>Momentum of a thread, attached masses included.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ThreadMomentum
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>Mass, kg.</summary>
        public double Mass;
        /// <summary>Centre of mass, m.</summary>
        public Vector3d Centre;
        /// <summary>Linear momentum, kg m/s.</summary>
        public Vector3d Linear;
        /// <summary>Angular momentum about the origin, kg m^2/s.</summary>
        public Vector3d Angular;
    }

    /// <summary>
    /// Counters since creation, and results of the last step. vbss_thread_get_baseline_statistics
    /// returns what method VBLAST counts beside these.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ThreadStatistics
    {
        internal uint StructSize;
        /// <summary>IMPLICIT: linearisations of the last step.</summary>
        public uint LastIterations;
        /// <summary>Calls of vbss_thread_step that succeeded.</summary>
        public ulong Steps;
        /// <summary>IMPLICIT: linearisations.</summary>
        public ulong Iterations;
        /// <summary>Accepted parts of steps; equal to steps if none was divided.</summary>
        public ulong Substeps;
        /// <summary>IMPLICIT: substeps made by backward Euler.</summary>
        public ulong FirstOrder;
        /// <summary>IMPLICIT: attempts that were rejected and halved.</summary>
        public ulong Rejections;
        /// <summary>IMPLICIT: substeps accepted unconverged, at the last halving.</summary>
        public ulong Forced;
        /// <summary>
        /// IMPLICIT: linearisations repeated with less compression, parts that started from the old
        /// positions because the prediction was unusable, and parts in which the force of rest
        /// curvature was kept constant.
        /// </summary>
        public ulong Softened;
        /// <summary>
        /// IMPLICIT: max |length / rest length - 1 - T / EA| after the last step; VBLAST: max
        /// |length / rest length - 1|.
        /// </summary>
        public double LastStretchError;
        /// <summary>Largest stretch error after any part of a step.</summary>
        public double StretchError;
        /// <summary>max (length / rest length - 1) after the last step.</summary>
        public double LastStretch;
        /// <summary>Simulated time, s.</summary>
        public double Time;
        /// <summary>Segments divided.</summary>
        public ulong Refined;
        /// <summary>Nodes removed.</summary>
        public ulong Coarsened;
        /// <summary>Divisions whose new node is on the chord instead of the arc, for lack of clearance.</summary>
        public ulong LaidOnChord;
        /// <summary>Divisions refused because thread or scene had no free node.</summary>
        public ulong RefusedCapacity;
        /// <summary>Changes refused at or beside attachments, pins, grasps or the ends at a cut.</summary>
        public ulong RefusedHeld;
        /// <summary>Removals refused because another body was too near.</summary>
        public ulong RefusedNear;
        /// <summary>Present number of nodes; also for a fixed mesh.</summary>
        public uint Nodes;
        /// <summary>Largest number of nodes so far; 0 for a fixed mesh.</summary>
        public uint MostNodes;
        /// <summary>Largest of VBSS_THREAD_VIEW_SAGITTAS, m; also for a fixed mesh.</summary>
        public double Sagitta;
    }
}
