// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_scene_mode.</summary>
    public enum SceneMode : int
    {
        /// <summary>
        /// The work and the attempts of a step are limited, and the work of a call, so that it ends
        /// in time: see `step_budget_us` and `call_budget_us` of vbss_solver_options. Work left
        /// over is deferred to the next call. Time that would be deferred too long is left out and
        /// counted in `paused`. As a result tight knots of many throws slip a little early.
        /// </summary>
        RealTime = 0,
        /// <summary>
        /// A step takes all the work that it needs. It is halved as often as `halving_limit`
        /// allows, and only then truncated, which is counted in `clamped`. After eight truncated
        /// parts the rest of the step is left out, for the bodies of these parts alone, and counted
        /// in `paused`. For experiments.
        /// </summary>
        Offline = 1,
    }

    /// <summary>The constants of vbss_scene_overlap_policy.</summary>
    public enum SceneOverlapPolicy : int
    {
        /// <summary>The body is added; a warning in the log names the other body and the depth.</summary>
        Warn = 0,
        /// <summary>The call returns VBSS_ERROR_OUT_OF_RANGE, and nothing has changed.</summary>
        Refuse = 1,
        /// <summary>The body is added without a check.</summary>
        Allow = 2,
    }

    /// <summary>The constants of vbss_scene_rigid_kind.</summary>
    public enum SceneRigidKind : int
    {
        /// <summary>The body follows its target exactly; only the guard can stop it.</summary>
        Driven = 0,
        /// <summary>The body is a proxy that a virtual coupling ties to its target.</summary>
        Coupled = 1,
        /// <summary>The body moves under forces.</summary>
        Free = 2,
    }

    /// <summary>
    /// The constants of vbss_scene_field. Contacts are those that carried a force at the end of the
    /// last step, in the order of their features. With method VBLAST they are those with a
    /// response.
    /// </summary>
    public enum SceneField : int
    {
        /// <summary>
        /// x 5 uint32_t: vbss_scene_contact_kind, body a, feature a, body b, feature b. Features
        /// are segments or nodes of a thread, capsules of a rigid body (2 times the capsule, plus
        /// the end if an end touches), and nodes, triangles or sides of a drain; floor and planes
        /// have feature 0. Each side of a drain's triangles is numbered once, in the order of its
        /// two nodes, the lower node first.
        /// </summary>
        Contacts = 0,
        /// <summary>x 3: point between the two surfaces, m.</summary>
        ContactPoints = 1,
        /// <summary>x 3: unit normal from b to a.</summary>
        ContactNormals = 2,
        /// <summary>
        /// x 3: force of b on a, N. When a search for contact states has exhausted its work limit,
        /// these are forces with which all bodies balance. They miss the contact law by the
        /// residual, and may pull.
        /// </summary>
        ContactForces = 3,
        /// <summary>x 1: distance of the surfaces, m; negative when they overlap.</summary>
        ContactGaps = 4,
    }

    /// <summary>The constants of vbss_scene_contact_kind.</summary>
    public enum SceneContactKind : int
    {
        /// <summary>Two segments of threads.</summary>
        Segments = 0,
        /// <summary>A smoothed point of a fine thread and a capsule.</summary>
        NodeCapsule = 1,
        /// <summary>A segment of a coarse thread and a capsule.</summary>
        SegmentCapsule = 2,
        /// <summary>A node of a thread and the floor, or a plane.</summary>
        NodeFloor = 3,
        /// <summary>Two capsules of different bodies.</summary>
        Capsules = 4,
        /// <summary>An end of a capsule and the floor, or a plane.</summary>
        CapsuleFloor = 5,
        /// <summary>
        /// A held point and a grasper. The feature of a thread is 3 times the index of the grasp
        /// plus the index of one of its three held points. The feature of a needle or a drain is
        /// the index of the held point. The feature of the grasper is 0.
        /// </summary>
        Grasp = 6,
        /// <summary>
        /// A node of a thread, an end of a capsule or a node of a drain, with a triangle of a
        /// drain.
        /// </summary>
        PointFace = 7,
        /// <summary>
        /// A segment of a thread, a capsule or a side of a drain's triangle, with a side of a
        /// drain's triangle.
        /// </summary>
        Sides = 8,
        /// <summary>A node of a drain and the floor, or a plane.</summary>
        DrainFloor = 9,
        /// <summary>
        /// A needle or a thread in a hole of a drain. The feature of the suture is the index of the
        /// hole; the feature of the drain is 0. The normal is along the suture. VBLAST: a place
        /// where particles were moved.
        /// </summary>
        Hole = 10,
    }

    /// <summary>The constants of vbss_scene_blocker_cause.</summary>
    public enum SceneBlockerCause : int
    {
        /// <summary>The work limit of the step was exhausted.</summary>
        Work = 0,
        /// <summary>The bodies would pass through each other, or come too near.</summary>
        Collision = 1,
        /// <summary>The bodies penetrate each other by more than the tolerance.</summary>
        Penetration = 2,
        /// <summary>No contact forces were found that obey the contact law.</summary>
        Contact = 3,
        /// <summary>The motion of the body did not converge.</summary>
        Convergence = 4,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct SceneConfigData
    {
        internal uint StructSize;
        internal Method Method;
        internal SceneMode Mode;
        internal uint ThreadCapacity;
        internal uint NodeCapacity;
        internal uint RigidCapacity;
        internal uint CapsuleCapacity;
        internal uint PinCapacity;
        internal uint ContactCapacity;
        internal uint CandidateCapacity;
        internal uint EventCapacity;
        internal int Floor;
        internal Vector3d FloorNormal;
        internal double FloorHeight;
        internal double FloorFriction;
        internal double ThreadFriction;
        internal double ContactStiffness;
        internal uint GraspCapacity;
        internal uint DrainCapacity;
        internal uint HoleCapacity;
        internal SceneOverlapPolicy Overlap;
        internal double SpeedLimit;
        internal uint MatrixCapacity;
        internal uint Reserved;
        internal IntPtr Baseline;
        internal IntPtr Solver;
    }

    /// <summary>Configuration of a scene. Fill it with vbss_scene_config_init, then change fields.</summary>
    public sealed unsafe partial class SceneConfig
    {
        private readonly SceneConfigData[] box = new SceneConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public SceneConfig()
        {
            fixed (SceneConfigData* data = box)
            {
                Vblast.Check(Native.vbss_scene_config_init(data, (uint)sizeof(SceneConfigData)));
            }
        }

        /// <summary>Method; default VBSS_METHOD_IMPLICIT. Bodies of the scene must have the same method.</summary>
        public Method Method
        {
            get { return box[0].Method; }
            set { box[0].Method = value; }
        }

        /// <summary>Mode; default VBSS_SCENE_MODE_REAL_TIME.</summary>
        public SceneMode Mode
        {
            get { return box[0].Mode; }
            set { box[0].Mode = value; }
        }

        /// <summary>Largest number of threads at a time, 0 to 64; default 4.</summary>
        public uint ThreadCapacity
        {
            get { return box[0].ThreadCapacity; }
            set { box[0].ThreadCapacity = value; }
        }

        /// <summary>Largest number of nodes of all threads, 0 to 8192; default 1024.</summary>
        public uint NodeCapacity
        {
            get { return box[0].NodeCapacity; }
            set { box[0].NodeCapacity = value; }
        }

        /// <summary>Largest number of rigid bodies and graspers, 0 to 256; default 4.</summary>
        public uint RigidCapacity
        {
            get { return box[0].RigidCapacity; }
            set { box[0].RigidCapacity = value; }
        }

        /// <summary>Largest number of capsules of these bodies, 0 to 4096; default 16.</summary>
        public uint CapsuleCapacity
        {
            get { return box[0].CapsuleCapacity; }
            set { box[0].CapsuleCapacity = value; }
        }

        /// <summary>Largest number of pins at a time, 0 to 256; default 8.</summary>
        public uint PinCapacity
        {
            get { return box[0].PinCapacity; }
            set { box[0].PinCapacity = value; }
        }

        /// <summary>Largest number of contacts that may close at a time, 0 to 65536; default 1024.</summary>
        public uint ContactCapacity
        {
            get { return box[0].ContactCapacity; }
            set { box[0].ContactCapacity = value; }
        }

        /// <summary>Largest number of candidate pairs, 0 to 1e7; default 16384.</summary>
        public uint CandidateCapacity
        {
            get { return box[0].CandidateCapacity; }
            set { box[0].CandidateCapacity = value; }
        }

        /// <summary>
        /// Largest number of events that are kept until the host takes them (scene_event.h), and of
        /// those of a step, 0 to 65536; default 256.
        /// </summary>
        public uint EventCapacity
        {
            get { return box[0].EventCapacity; }
            set { box[0].EventCapacity = value; }
        }

        /// <summary>1: a floor fills the half-space below a plane; default 0.</summary>
        public int Floor
        {
            get { return box[0].Floor; }
            set { box[0].Floor = value; }
        }

        /// <summary>Direction up, of any length from 1e-100 to 1e100; default (0, 1, 0).</summary>
        public Vector3d FloorNormal
        {
            get { return box[0].FloorNormal; }
            set { box[0].FloorNormal = value; }
        }

        /// <summary>Height of the plane along its normal, m, at most 1e3 in magnitude; default 0.</summary>
        public double FloorHeight
        {
            get { return box[0].FloorHeight; }
            set { box[0].FloorHeight = value; }
        }

        /// <summary>Coefficient of friction of the floor, 0 to 10; default 0.3.</summary>
        public double FloorFriction
        {
            get { return box[0].FloorFriction; }
            set { box[0].FloorFriction = value; }
        }

        /// <summary>
        /// Coefficient of friction between threads, 0 to 10; default 0.3 (silk on silk; the
        /// literature has 0.1 to 0.4).
        /// </summary>
        public double ThreadFriction
        {
            get { return box[0].ThreadFriction; }
            set { box[0].ThreadFriction = value; }
        }

        /// <summary>Normal and tangential stiffness of a contact, N/m, 1e3 to 1e9; default 2e5: 5 um at 1 N.</summary>
        public double ContactStiffness
        {
            get { return box[0].ContactStiffness; }
            set { box[0].ContactStiffness = value; }
        }

        /// <summary>
        /// Largest number of grasped places of threads at a time, 0 to 256; default 8. Places that
        /// jaws have released but not cleared count too, and so do the two ends at each cut of
        /// blades. Without capacity the jaws stay open.
        /// </summary>
        public uint GraspCapacity
        {
            get { return box[0].GraspCapacity; }
            set { box[0].GraspCapacity = value; }
        }

        /// <summary>Largest number of drains at a time, 0 to 16; default 1.</summary>
        public uint DrainCapacity
        {
            get { return box[0].DrainCapacity; }
            set { box[0].DrainCapacity = value; }
        }

        /// <summary>Largest number of holes of needles and threads in walls at a time, 0 to 256; default 16.</summary>
        public uint HoleCapacity
        {
            get { return box[0].HoleCapacity; }
            set { box[0].HoleCapacity = value; }
        }

        /// <summary>Treatment of overlapping new bodies; default VBSS_SCENE_OVERLAP_WARN.</summary>
        public SceneOverlapPolicy Overlap
        {
            get { return box[0].Overlap; }
            set { box[0].Overlap = value; }
        }

        /// <summary>
        /// Largest speed of any point of a driven or coupled body, or of a grasper, on the way to
        /// its target, m/s, 0 to 1e6; 0: no limit; default 20. A body approaches a target that is
        /// farther away at this speed, over several steps. A pose in the wrong unit, or a jump of a
        /// device, then causes no long step and no extreme force. Method IMPLICIT only. Logs and
        /// snapshots store the limit, and a scene with another one rejects them. One exception:
        /// scenes without a limit and with the default limit accept each other's snapshots.
        /// </summary>
        public double SpeedLimit
        {
            get { return box[0].SpeedLimit; }
            set { box[0].SpeedLimit = value; }
        }

        /// <summary>
        /// Method IMPLICIT: capacity of the linear system's matrix and its factor for threads and
        /// rigid bodies, in blocks of 3 x 3 numbers of 96 bytes, 0 to 1e7; 0 (default): 4096, and
        /// 20 for each node of node_capacity and 40 for each body of rigid_capacity. A node without
        /// contact takes up to 12 blocks, one of a tight knot 42; each drain adds its own. A step
        /// that needs more returns VBSS_ERROR_CAPACITY. See docs/reference/memory.md.
        /// </summary>
        public uint MatrixCapacity
        {
            get { return box[0].MatrixCapacity; }
            set { box[0].MatrixCapacity = value; }
        }

        /// <summary>VBLAST: its parameters; NULL (default): their defaults. The library copies them.</summary>
        public BaselineConfig Baseline { get; set; }

        /// <summary>
        /// Options of the solver, with the budgets of steps and calls; NULL (default): their
        /// defaults. The scene copies them.
        /// </summary>
        public SolverOptions Solver { get; set; }

        internal SceneConfigData* Pin(Pins pins)
        {
            ref SceneConfigData data = ref box[0];
            data.Baseline = Baseline == null ? IntPtr.Zero : (IntPtr)Baseline.Pin(pins);
            data.Solver = Solver == null ? IntPtr.Zero : (IntPtr)Solver.Pin(pins);
            return (SceneConfigData*)pins.Array(box);
        }
    }

    /// <summary>The deepest overlap of a body.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneOverlap
    {
        internal uint StructSize;
        /// <summary>Number of the other body; 0: the floor, or none if depth is 0.</summary>
        public uint Body;
        /// <summary>Depth of the overlap of the two surfaces, m; 0: no overlap.</summary>
        public double Depth;
    }

    /// <summary>One capsule of a rigid body, in the frame of the body.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneCapsule
    {
        /// <summary>One end of the axis, m.</summary>
        public Vector3d Begin;
        /// <summary>The other end of the axis, m; equal ends make a ball.</summary>
        public Vector3d End;
        /// <summary>Radius, m, 1e-6 to 1.</summary>
        public double Radius;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct SceneRigidConfigData
    {
        internal uint StructSize;
        internal SceneRigidKind Kind;
        internal uint CapsuleCount;
        internal uint Reserved;
        internal IntPtr Capsules;
        internal Vector3d Position;
        internal Quaterniond Orientation;
        internal Vector3d Velocity;
        internal Vector3d AngularVelocity;
        internal double Mass;
        internal Vector3d Gravity;
        internal double Friction;
        internal double Stiffness;
        internal double Damping;
        internal double TurningStiffness;
        internal double TurningDamping;
    }

    /// <summary>
    /// Configuration of a rigid body. Fill it with vbss_scene_rigid_config_init, then change
    /// fields.
    /// </summary>
    public sealed unsafe partial class SceneRigidConfig
    {
        private readonly SceneRigidConfigData[] box = new SceneRigidConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public SceneRigidConfig()
        {
            fixed (SceneRigidConfigData* data = box)
            {
                Vblast.Check(Native.vbss_scene_rigid_config_init(data, (uint)sizeof(SceneRigidConfigData)));
            }
        }

        /// <summary>Kind of motion; default VBSS_SCENE_RIGID_DRIVEN.</summary>
        public SceneRigidKind Kind
        {
            get { return box[0].Kind; }
            set { box[0].Kind = value; }
        }

        /// <summary>Number of capsules, 1 to 256.</summary>
        public uint CapsuleCount
        {
            get { return box[0].CapsuleCount; }
            set { box[0].CapsuleCount = value; }
        }

        /// <summary>Array of capsule_count capsules; the library copies it.</summary>
        public SceneCapsule[] Capsules { get; set; }

        /// <summary>
        /// Position of the origin of the frame, m, each coordinate at most 1e3 in magnitude;
        /// default 0.
        /// </summary>
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

        /// <summary>
        /// COUPLED, FREE: velocity of the origin, m/s, each component at most 1e5 in magnitude;
        /// default 0.
        /// </summary>
        public Vector3d Velocity
        {
            get { return box[0].Velocity; }
            set { box[0].Velocity = value; }
        }

        /// <summary>
        /// COUPLED, FREE: angular velocity, rad/s, each component at most 1e6 in magnitude; default
        /// 0. A body turns by at most a quarter of a turn in a part of a step; a faster one slows
        /// down.
        /// </summary>
        public Vector3d AngularVelocity
        {
            get { return box[0].AngularVelocity; }
            set { box[0].AngularVelocity = value; }
        }

        /// <summary>
        /// Mass of the body, kg, 1e-9 to 1e3; default 0.02. It is distributed over the capsules as
        /// over solids of one material; overlaps count twice.
        /// </summary>
        public double Mass
        {
            get { return box[0].Mass; }
            set { box[0].Mass = value; }
        }

        /// <summary>
        /// Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default 0,
        /// because hands carry their tools.
        /// </summary>
        public Vector3d Gravity
        {
            get { return box[0].Gravity; }
            set { box[0].Gravity = value; }
        }

        /// <summary>
        /// Coefficient of friction, 0 to 10; default 0.15. A contact with a thread uses this
        /// coefficient, any other the geometric mean of both bodies.
        /// </summary>
        public double Friction
        {
            get { return box[0].Friction; }
            set { box[0].Friction = value; }
        }

        /// <summary>COUPLED: stiffness, N/m, 0 to 1e9; default 2000.</summary>
        public double Stiffness
        {
            get { return box[0].Stiffness; }
            set { box[0].Stiffness = value; }
        }

        /// <summary>COUPLED: damping, N s/m, 0 to 1e6; default 5.</summary>
        public double Damping
        {
            get { return box[0].Damping; }
            set { box[0].Damping = value; }
        }

        /// <summary>COUPLED: rotational stiffness, N m/rad, 0 to 1e9; default 2.</summary>
        public double TurningStiffness
        {
            get { return box[0].TurningStiffness; }
            set { box[0].TurningStiffness = value; }
        }

        /// <summary>COUPLED: rotational damping, N m s/rad, 0 to 1e6; default 0.005.</summary>
        public double TurningDamping
        {
            get { return box[0].TurningDamping; }
            set { box[0].TurningDamping = value; }
        }

        internal SceneRigidConfigData* Pin(Pins pins)
        {
            ref SceneRigidConfigData data = ref box[0];
            uint? countedCapsuleCount = null;
            data.Capsules = pins.Array(Capsules);
            if (Capsules != null)
            {
                data.CapsuleCount = pins.Count(nameof(Capsules), Capsules.Length, 1, 0, ref countedCapsuleCount);
            }
            return (SceneRigidConfigData*)pins.Array(box);
        }
    }

    /// <summary>State of a rigid body.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneRigidState
    {
        internal uint StructSize;
        /// <summary>Kind of motion.</summary>
        public SceneRigidKind Kind;
        /// <summary>Position of the origin of its frame, m.</summary>
        public Vector3d Position;
        /// <summary>Orientation from body to world, w, x, y, z.</summary>
        public Quaterniond Orientation;
        /// <summary>Velocity of the origin, m/s.</summary>
        public Vector3d Velocity;
        /// <summary>Angular velocity in the world frame, rad/s.</summary>
        public Vector3d AngularVelocity;
        /// <summary>Target position of the origin, m.</summary>
        public Vector3d TargetPosition;
        /// <summary>Target orientation, w, x, y, z.</summary>
        public Quaterniond TargetOrientation;
        /// <summary>
        /// Force on the hand, N: the opposite of the coupling's force; for a driven body the sum of
        /// its contacts and pins. Zero for a free body.
        /// </summary>
        public Vector3d HandForce;
        /// <summary>Torque on the hand about the origin of the body's frame, N m.</summary>
        public Vector3d HandTorque;
        /// <summary>Sum of the forces of all contacts and pins on the body in the last step, N.</summary>
        public Vector3d ContactForce;
        /// <summary>Their torque about the origin of the body's frame, N m.</summary>
        public Vector3d ContactTorque;
    }

    /// <summary>
    /// Counters since creation, and results of the last step. Method VBLAST leaves `rows`,
    /// `separators` and the counters of attempts, solves, the guard and operations at 0;
    /// vbss_scene_get_baseline_statistics returns what it counts.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneStatistics
    {
        internal uint StructSize;
        /// <summary>Contacts that carry a force after the last step.</summary>
        public uint Contacts;
        /// <summary>Contacts that could have closed in the last part.</summary>
        public uint Rows;
        /// <summary>Blocks of the last part's system that contacts couple.</summary>
        public uint Separators;
        /// <summary>Calls of vbss_scene_step that succeeded.</summary>
        public ulong Steps;
        /// <summary>Accepted parts of steps; equal to `steps` if no step was divided.</summary>
        public ulong Parts;
        /// <summary>Attempts, rejected ones included.</summary>
        public ulong Attempts;
        /// <summary>Linearisations of all attempts.</summary>
        public ulong Linearisations;
        /// <summary>Solves of the separators' system.</summary>
        public ulong StateSolves;
        /// <summary>Times the sparsity pattern of that system was computed; not part of the state.</summary>
        public ulong Patterns;
        /// <summary>Attempts rejected because contact states were not found.</summary>
        public ulong RejectedStates;
        /// <summary>
        /// Attempts rejected because lengths or shapes did not converge, or a node of a drain moved
        /// too far.
        /// </summary>
        public ulong RejectedStretch;
        /// <summary>Attempts rejected because of penetration.</summary>
        public ulong RejectedDepth;
        /// <summary>Attempts rejected by the guard: bodies would pass through each other, or come too near.</summary>
        public ulong RejectedGuard;
        /// <summary>Attempts rejected because a pivot was too small or a number was not finite.</summary>
        public ulong RejectedSingular;
        /// <summary>Attempts rejected because candidates or contacts exceeded their capacity.</summary>
        public ulong RejectedFull;
        /// <summary>Attempts accepted with a residual of up to 5 % in the contact law.</summary>
        public ulong LooseStates;
        /// <summary>Parts accepted with a stretch error above the tolerance.</summary>
        public ulong LooseStretch;
        /// <summary>Parts truncated by the guard.</summary>
        public ulong Clamped;
        /// <summary>Parts accepted that reduced a penetration above the tolerance.</summary>
        public ulong Recovering;
        /// <summary>Pairs that the guard has tested or knows to be apart.</summary>
        public ulong GuardPairs;
        /// <summary>Largest penetration after the last step, m.</summary>
        public double LastPenetration;
        /// <summary>Largest penetration of all steps, m.</summary>
        public double Penetration;
        /// <summary>
        /// IMPLICIT: max |length / rest length - 1 - T / EA| after the last step; VBLAST: max
        /// |length / rest length - 1|.
        /// </summary>
        public double LastStretchError;
        /// <summary>Largest stretch error of all steps.</summary>
        public double StretchError;
        /// <summary>Residual of the contact law after the last part, N.</summary>
        public double LastResidual;
        /// <summary>Sum of the lengths of the steps, `time_paused` included, s.</summary>
        public double Time;
        /// <summary>Operations of all steps, as the step budget counts them; method IMPLICIT.</summary>
        public ulong Operations;
        /// <summary>Largest number of operations of a step.</summary>
        public ulong MostOperations;
        /// <summary>REAL_TIME: steps of which a part, or all, was left out.</summary>
        public ulong Paused;
        /// <summary>Simulated time that these steps have lost, s.</summary>
        public double TimePaused;
        /// <summary>
        /// Calls after which a step was suspended or had not begun; see
        /// vbss_solver_options::call_budget_us.
        /// </summary>
        public ulong Deferred;
        /// <summary>Number of suspended and unbegun steps after the last call, 0 to 2.</summary>
        public uint Behind;
        /// <summary>
        /// Steps that two calls had suspended while other bodies waited, so that the third
        /// completed them without the budget of a call.
        /// </summary>
        public uint Overdue;
        /// <summary>Length that threads have torn at holes, m (vbss_drain_config::tear_energy).</summary>
        public double TornLength;
        /// <summary>Energy that this has dissipated, J.</summary>
        public double TearWork;
    }

    /// <summary>
    /// Two bodies that hold each other back, and all bodies that touch them. A failed step holds
    /// back only the bodies that contacts, grasps, holes or pins connect with these two. All other
    /// bodies move on.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneBlocker
    {
        internal uint StructSize;
        /// <summary>Cause in the last step that held them back.</summary>
        public SceneBlockerCause Cause;
        /// <summary>Number of one body; 0: unknown.</summary>
        public uint BodyA;
        /// <summary>Number of the other body; 0: the floor, or no second body.</summary>
        public uint BodyB;
        /// <summary>Simulated time at which they were first held back, s.</summary>
        public double Since;
        /// <summary>Simulated time that they have lost since then, s.</summary>
        public double LostTime;
        /// <summary>Their deepest overlap in the last step that held them back, m; 0: none.</summary>
        public double Depth;
    }

    /// <summary>A hole of a needle or a thread in a drain or host surface.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneHole
    {
        internal uint StructSize;
        /// <summary>Identifier from 1 on, in the order of creation; never reused.</summary>
        public uint Id;
        /// <summary>Number of the needle in the hole; 0: a thread is in it.</summary>
        public uint Needle;
        /// <summary>Number of the drain or host surface.</summary>
        public uint Drain;
        /// <summary>Triangle of it.</summary>
        public uint Triangle;
        /// <summary>1: the tip went through from inside; 0: from outside.</summary>
        public uint Outward;
        /// <summary>Weights of the triangle's nodes at the hole.</summary>
        public Doubles3 Weights;
        /// <summary>
        /// Position of the hole on the drain at rest, m: VBSS_DRAIN_VIEW_REST_POSITIONS. In a host
        /// surface the same as `position`.
        /// </summary>
        public Vector3d RestPosition;
        /// <summary>Current position of the hole, in the middle of the wall, m.</summary>
        public Vector3d Position;
        /// <summary>
        /// Unit direction of the suture at the hole, towards the needle's tip, or the thread's
        /// beginning.
        /// </summary>
        public Vector3d Direction;
        /// <summary>
        /// Arc length of the suture at the hole, m. For a needle it is measured from the tip, and
        /// is negative before the tip has reached the middle of the wall. For a thread it is
        /// measured from the beginning. Near the swage it may be up to 0.2 mm beyond an end.
        /// </summary>
        public double ArcLength;
        /// <summary>Friction on the suture along `direction`, N.</summary>
        public double Friction;
        /// <summary>Force on the suture, N.</summary>
        public Vector3d Force;
        /// <summary>Number of the thread in the hole; 0: a needle is in it.</summary>
        public uint Thread;
        internal uint Reserved;
        /// <summary>
        /// Length of the cut by which the thread has torn this hole, m: along the wall as it was
        /// then, in the plane of its triangles (vbss_drain_config::tear_energy).
        /// </summary>
        public double TornLength;
        /// <summary>Energy that this has dissipated, J.</summary>
        public double TearWork;
    }

    /// <summary>A grasped place of a thread, a needle or a drain.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct SceneGrasp
    {
        internal uint StructSize;
        /// <summary>Number of the grasped body in the scene.</summary>
        public uint Body;
        /// <summary>
        /// Arc length of the middle of the held part, m: unstretched along a thread, or from a
        /// needle's tip.
        /// </summary>
        public double ArcLength;
        /// <summary>Position of that middle, m.</summary>
        public Vector3d Position;
        /// <summary>
        /// Force of the jaws on the held body in the last step, N. While the body slides, it
        /// exceeds the limit by the clamp's gain in a step.
        /// </summary>
        public Vector3d Force;
        /// <summary>Largest force along the jaws' faces that they bear, N; VBLAST: 0.</summary>
        public double Limit;
        /// <summary>Distance that the body has slid through the jaws since it was grasped, m.</summary>
        public double Slid;
    }
}
