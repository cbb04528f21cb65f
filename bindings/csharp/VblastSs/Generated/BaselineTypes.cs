// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    [StructLayout(LayoutKind.Sequential)]
    internal struct BaselineConfigData
    {
        internal uint StructSize;
        internal uint ThreadSubsteps;
        internal uint ThreadIterationLimit;
        internal uint DrainSubsteps;
        internal uint ScenePassLimit;
        internal uint Reserved;
        internal double CollisionParallel;
        internal double CollisionUnit;
        internal double ThreadStiffness;
        internal double ThreadDamping;
        internal double ThreadTolerance;
        internal double DrainStiffness;
        internal double DrainDamping;
        internal double GrasperStiffness;
        internal double GrasperDistance;
        internal double SceneThickness;
    }

    /// <summary>Parameters of the baseline. Fill it with vbss_baseline_config_init, then change fields.</summary>
    public sealed unsafe partial class BaselineConfig
    {
        private readonly BaselineConfigData[] box = new BaselineConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public BaselineConfig()
        {
            fixed (BaselineConfigData* data = box)
            {
                Vblast.Check(Native.vbss_baseline_config_init(data, (uint)sizeof(BaselineConfigData)));
            }
        }

        /// <summary>
        /// Explicit steps of a thread in one step, 1 to 100000; 0 (default): as many as the
        /// stiffest bending mode and the tension need.
        /// </summary>
        public uint ThreadSubsteps
        {
            get { return box[0].ThreadSubsteps; }
            set { box[0].ThreadSubsteps = value; }
        }

        /// <summary>Largest number of iterations of a thread's projection, 1 to 1000; default 50.</summary>
        public uint ThreadIterationLimit
        {
            get { return box[0].ThreadIterationLimit; }
            set { box[0].ThreadIterationLimit = value; }
        }

        /// <summary>
        /// Explicit steps of a drain in one step, 1 to 100000; 0 (default): as many as stability
        /// needs.
        /// </summary>
        public uint DrainSubsteps
        {
            get { return box[0].DrainSubsteps; }
            set { box[0].DrainSubsteps = value; }
        }

        /// <summary>Number of passes of detection and response in a step of a scene, 1 to 1000; default 4.</summary>
        public uint ScenePassLimit
        {
            get { return box[0].ScenePassLimit; }
            set { box[0].ScenePassLimit = value; }
        }

        /// <summary>
        /// Of collision.h alone; scenes use the default. Edges are parallel when |a|^2 |b|^2 -
        /// (a.b)^2 is below this, in collision_unit^4; 0 to 1; default 1e-6.
        /// </summary>
        public double CollisionParallel
        {
            get { return box[0].CollisionParallel; }
            set { box[0].CollisionParallel = value; }
        }

        /// <summary>
        /// Of collision.h alone; scenes use the default. Unit of length, m, 1e-9 to 1e3; default
        /// 1e-3.
        /// </summary>
        public double CollisionUnit
        {
            get { return box[0].CollisionUnit; }
            set { box[0].CollisionUnit = value; }
        }

        /// <summary>
        /// Spring constant of a segment of a thread, N/m, 0 to 1e9; default 0: derived from mass
        /// and step by docs/explanation/paper-thread.md.
        /// </summary>
        public double ThreadStiffness
        {
            get { return box[0].ThreadStiffness; }
            set { box[0].ThreadStiffness = value; }
        }

        /// <summary>
        /// Share of the velocity relative to the rigid motion of a thread's section that each
        /// explicit step removes, 0 to 1; default 0.
        /// </summary>
        public double ThreadDamping
        {
            get { return box[0].ThreadDamping; }
            set { box[0].ThreadDamping = value; }
        }

        /// <summary>Largest |C| / l of a section of a thread, 1e-14 to 1; default 1e-6.</summary>
        public double ThreadTolerance
        {
            get { return box[0].ThreadTolerance; }
            set { box[0].ThreadTolerance = value; }
        }

        /// <summary>
        /// Stiffness of the spring that ties a particle of a drain to its rest position, N/m, 0 to
        /// 1e9; default 125.
        /// </summary>
        public double DrainStiffness
        {
            get { return box[0].DrainStiffness; }
            set { box[0].DrainStiffness = value; }
        }

        /// <summary>
        /// Share of the velocity relative to the rigid motion of the drain that each explicit step
        /// removes, 0 to 1; default 0.7.
        /// </summary>
        public double DrainDamping
        {
            get { return box[0].DrainDamping; }
            set { box[0].DrainDamping = value; }
        }

        /// <summary>
        /// Factor k_s of the force on the hand of a grasper, k_s (stretched length - length), N/m,
        /// 0 to 1e6; default 50.
        /// </summary>
        public double GrasperStiffness
        {
            get { return box[0].GrasperStiffness; }
            set { box[0].GrasperStiffness = value; }
        }

        /// <summary>
        /// Largest distance from the tip of a grasper at which closing jaws take a node, and from
        /// the centre line of the jaws at which they take a needle, m, 0 to 0.1; default 2e-3 (the
        /// paper gives no number).
        /// </summary>
        public double GrasperDistance
        {
            get { return box[0].GrasperDistance; }
            set { box[0].GrasperDistance = value; }
        }

        /// <summary>Distance that a scene keeps beyond contact (the paper's eps_D), m, 0 to 1e-2; default 0.</summary>
        public double SceneThickness
        {
            get { return box[0].SceneThickness; }
            set { box[0].SceneThickness = value; }
        }

        internal BaselineConfigData* Pin(Pins pins)
        {
            return (BaselineConfigData*)pins.Array(box);
        }
    }

    /// <summary>
    /// Counters of the baseline since the creation of an object, and results of its last step. One
    /// struct serves scenes, threads and collision objects; each fills the fields of its kind, and
    /// the others are 0. They are part of the state: a snapshot restores them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct BaselineStatistics
    {
        internal uint StructSize;
        /// <summary>Scene: pairs that the last search of the last step found.</summary>
        public uint LastCandidates;
        /// <summary>Scene: passes of detection and response in all steps; at least one a step.</summary>
        public ulong Passes;
        /// <summary>Scene: pairs that these passes tested, the floor excluded.</summary>
        public ulong TestedPairs;
        /// <summary>
        /// Scene: steps whose last pass still moved a body, because of
        /// vbss_baseline_config::scene_pass_limit.
        /// </summary>
        public ulong UnconvergedSteps;
        /// <summary>Thread: iterations of the projection, summed over sections and explicit steps.</summary>
        public ulong ProjectionIterations;
        /// <summary>
        /// Thread: projections that did not converge, so that their section kept the positions from
        /// before.
        /// </summary>
        public ulong FailedProjections;
        /// <summary>
        /// Collision object, and scene: continuous tests that the sign of w.w' ended
        /// (docs/explanation/paper-collision.md).
        /// </summary>
        public ulong SignTestsEnded;
        /// <summary>Thread: the part of the last step.</summary>
        public uint LastProjectionIterations;
        internal uint Reserved;
    }
}
