// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_replica_kind.</summary>
    public enum ReplicaKind : int
    {
        /// <summary>A thread, or a piece of one.</summary>
        Thread = 1,
        /// <summary>A drain.</summary>
        Drain = 2,
        /// <summary>A needle.</summary>
        Needle = 3,
        /// <summary>A grasper that is a needle driver.</summary>
        Driver = 4,
        /// <summary>A grasper that is shears.</summary>
        Shears = 5,
        /// <summary>Another rigid body.</summary>
        Rigid = 6,
    }

    /// <summary>The constants of vbss_replica_field. Bodies have the order of the scene's table of bodies.</summary>
    public enum ReplicaField : int
    {
        /// <summary>
        /// x 8 uint32_t: vbss_replica_kind, number of the body in its scene, first node, number of
        /// nodes, first triangle, number of triangles, first capsule, number of capsules.
        /// </summary>
        Bodies = 0,
        /// <summary>
        /// x 7, one row per body: position of the frame that vbss_scene_get_rigid reports, m, and
        /// orientation w, x, y, z. Threads and drains have 0, 0, 0 and 1, 0, 0, 0.
        /// </summary>
        Poses = 1,
        /// <summary>
        /// x 2, one row per body: radius of a thread or of a needle's wire, or half the thickness
        /// of a drain's wall, m, otherwise 0; angle of each jaw of a grasper from the middle, rad,
        /// otherwise 0.
        /// </summary>
        Sizes = 2,
        /// <summary>x 3: positions of the nodes of threads and drains, m.</summary>
        Nodes = 3,
        /// <summary>
        /// x 1, one row per node: tension of the segment of a thread that begins at this node, N,
        /// without the part of bending, as visuals show it. It is 0 at the last node of a thread
        /// and at nodes of drains.
        /// </summary>
        Tensions = 4,
        /// <summary>
        /// x 3 uint32_t: nodes of the triangles of drains, counted from the drain's first node,
        /// counter-clockwise seen from outside.
        /// </summary>
        Triangles = 5,
        /// <summary>
        /// x 7: both ends of the axis and the radius of the capsules of rigid bodies, needles and
        /// graspers, m.
        /// </summary>
        Capsules = 6,
        /// <summary>
        /// x 4 uint32_t, one row per hole: its id, number of the needle in it or 0, number of the
        /// thread in it or 0, number of the drain.
        /// </summary>
        Holes = 7,
        /// <summary>
        /// x 8, one row per hole: position, position on the drain at rest, radius of the suture in
        /// it, arc length of the suture there, m.
        /// </summary>
        HolePlaces = 8,
        /// <summary>x 5 uint32_t: as VBSS_SCENE_VIEW_CONTACTS.</summary>
        Contacts = 9,
        /// <summary>x 3: point between the two surfaces, m.</summary>
        ContactPoints = 10,
        /// <summary>x 3: unit normal from b to a.</summary>
        ContactNormals = 11,
        /// <summary>x 3: force of b on a, N.</summary>
        ContactForces = 12,
        /// <summary>x 1: distance of the surfaces, m.</summary>
        ContactGaps = 13,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ReplicaConfigData
    {
        internal uint StructSize;
        internal uint DrainNodeCapacity;
    }

    /// <summary>Configuration of a replica. Fill it with vbss_replica_config_init, then change fields.</summary>
    public sealed unsafe partial class ReplicaConfig
    {
        private readonly ReplicaConfigData[] box = new ReplicaConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public ReplicaConfig()
        {
            fixed (ReplicaConfigData* data = box)
            {
                Vblast.Check(Native.vbss_replica_config_init(data, (uint)sizeof(ReplicaConfigData)));
            }
        }

        /// <summary>
        /// Largest number of nodes of all drains, 0 to 2^20. Default 0: the nodes of the drains
        /// that the scene has when the replica is created. All other capacities are those of the
        /// scene.
        /// </summary>
        public uint DrainNodeCapacity
        {
            get { return box[0].DrainNodeCapacity; }
            set { box[0].DrainNodeCapacity = value; }
        }

        internal ReplicaConfigData* Pin(Pins pins)
        {
            return (ReplicaConfigData*)pins.Array(box);
        }
    }

    /// <summary>The state that was taken last.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ReplicaState
    {
        internal uint StructSize;
        /// <summary>
        /// 1: this call took a state; 0: none was published since the last take, so it is the same
        /// as before.
        /// </summary>
        public int IsNew;
        /// <summary>
        /// Number of the state: 1 for the first that was published; 0: none was published yet, and
        /// all arrays are empty.
        /// </summary>
        public ulong Number;
        /// <summary>Published states that the reader has never taken, up to this one.</summary>
        public ulong Missed;
        /// <summary>Steps of the scene: vbss_scene_statistics::steps.</summary>
        public ulong Steps;
        /// <summary>Simulated time of the scene, s: vbss_scene_statistics::time.</summary>
        public double Time;
        /// <summary>Bytes that the call copied that published this state.</summary>
        public ulong Bytes;
        /// <summary>1: the scene has a floor; otherwise 0.</summary>
        public int Floor;
        internal uint Reserved;
        /// <summary>Direction up of the floor, unit.</summary>
        public Vector3d FloorNormal;
        /// <summary>Height of the floor along its normal, m.</summary>
        public double FloorHeight;
    }
}
