// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_visual_kind.</summary>
    public enum VisualKind : int
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
        /// <summary>Another rigid body of a scene: its capsules.</summary>
        Rigid = 6,
        /// <summary>The floor of a scene.</summary>
        Floor = 7,
    }

    /// <summary>The constants of vbss_visual_spot_kind.</summary>
    public enum VisualSpotKind : int
    {
        /// <summary>One of the two marks, on the outer face.</summary>
        Mark = 1,
        /// <summary>A hole with a needle or a thread in it, through the wall.</summary>
        Hole = 2,
    }

    /// <summary>The constants of vbss_visual_field.</summary>
    public enum VisualField : int
    {
        /// <summary>
        /// x 12 float: position, m from `origin`; unit normal, outward; texture; material; value.
        /// *Texture*: on tubes and tools, 0 to 1 around the section, and m along; on drains, m
        /// along the tube, and m around it from the middle of the slit before it was opened; on
        /// floors, m in the plane. *Material*, x 3, m: position in the undeformed body. On drains
        /// it is the position at rest in the drain's frame (VBSS_DRAIN_VIEW_REST_POSITIONS); on
        /// tubes and tools, along and across the axis; on floors, the texture and 0. *Value*: on
        /// threads, the tension, N; on drains, 1 on the outer face, -1 on the inner face, 0 on
        /// rims; on graspers, 0 shaft, 1 neck, 2 jaws; else 0.
        /// </summary>
        Vertices = 0,
        /// <summary>x 3 uint32_t: vertices, counter-clockwise seen from outside.</summary>
        Triangles = 1,
        /// <summary>
        /// x 8 uint32_t: vbss_visual_kind, source, number of the body in its scene or 0, first
        /// vertex, number of vertices, first triangle, number of triangles, 0. Parts have the order
        /// of their sources, and within a scene that of its bodies.
        /// </summary>
        Parts = 2,
        /// <summary>
        /// x 6 float: index of the drain in VBSS_VISUAL_VIEW_PARTS, vbss_visual_spot_kind, material
        /// x 3, radius in m.
        /// </summary>
        Spots = 3,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct VisualConfigData
    {
        internal uint StructSize;
        internal uint SourceCapacity;
        internal uint PartCapacity;
        internal uint VertexCapacity;
        internal uint TriangleCapacity;
        internal uint SpotCapacity;
        internal uint NodeCapacity;
        internal uint SideLimit;
        internal uint DivisionLimit;
        internal uint Reserved;
        internal double TubeTolerance;
        internal double SurfaceTolerance;
        internal double MarkRadius;
        internal double TipLength;
        internal double FloorSize;
        internal Vector3d Origin;
    }

    /// <summary>Configuration of a visual. Fill it with vbss_visual_config_init, then change fields.</summary>
    public sealed unsafe partial class VisualConfig
    {
        private readonly VisualConfigData[] box = new VisualConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public VisualConfig()
        {
            fixed (VisualConfigData* data = box)
            {
                Vblast.Check(Native.vbss_visual_config_init(data, (uint)sizeof(VisualConfigData)));
            }
        }

        /// <summary>Largest number of scenes and bodies, 1 to 256; default 8.</summary>
        public uint SourceCapacity
        {
            get { return box[0].SourceCapacity; }
            set { box[0].SourceCapacity = value; }
        }

        /// <summary>Largest number of drawn bodies, 1 to 4096; default 32.</summary>
        public uint PartCapacity
        {
            get { return box[0].PartCapacity; }
            set { box[0].PartCapacity = value; }
        }

        /// <summary>
        /// Largest number of vertices, 16 to 2^24; default 65536. The visual allocates two such
        /// meshes.
        /// </summary>
        public uint VertexCapacity
        {
            get { return box[0].VertexCapacity; }
            set { box[0].VertexCapacity = value; }
        }

        /// <summary>Largest number of triangles, 16 to 2^24; default 131072.</summary>
        public uint TriangleCapacity
        {
            get { return box[0].TriangleCapacity; }
            set { box[0].TriangleCapacity = value; }
        }

        /// <summary>Largest number of spots, 0 to 4096; default 32.</summary>
        public uint SpotCapacity
        {
            get { return box[0].SpotCapacity; }
            set { box[0].SpotCapacity = value; }
        }

        /// <summary>Largest number of nodes of a thread or a drain, 2 to 65537; default 4096.</summary>
        public uint NodeCapacity
        {
            get { return box[0].NodeCapacity; }
            set { box[0].NodeCapacity = value; }
        }

        /// <summary>
        /// Largest number of sides of a tube's section, 6 to 64; default 32. The smallest number is
        /// 6.
        /// </summary>
        public uint SideLimit
        {
            get { return box[0].SideLimit; }
            set { box[0].SideLimit = value; }
        }

        /// <summary>Largest number of parts of a segment, or of a side of a triangle, 1 to 32; default 12.</summary>
        public uint DivisionLimit
        {
            get { return box[0].DivisionLimit; }
            set { box[0].DivisionLimit = value; }
        }

        /// <summary>
        /// Tubes, tools and needles: largest deviation of chords from the centre line, and of
        /// polygons from sections, m, 1e-8 to 1; default 5e-6.
        /// </summary>
        public double TubeTolerance
        {
            get { return box[0].TubeTolerance; }
            set { box[0].TubeTolerance = value; }
        }

        /// <summary>
        /// Drains: largest deviation of chords from curved sides of patches, m, 1e-8 to 1; default
        /// 2e-5.
        /// </summary>
        public double SurfaceTolerance
        {
            get { return box[0].SurfaceTolerance; }
            set { box[0].SurfaceTolerance = value; }
        }

        /// <summary>Radius of the marks of drains, m, 0 to 0.1; default 1e-3.</summary>
        public double MarkRadius
        {
            get { return box[0].MarkRadius; }
            set { box[0].MarkRadius = value; }
        }

        /// <summary>
        /// Length over which a needle tapers to its tip, m, 0 to 1; default 4e-3. At most half the
        /// needle's length is used.
        /// </summary>
        public double TipLength
        {
            get { return box[0].TipLength; }
            set { box[0].TipLength = value; }
        }

        /// <summary>Side of the square that shows a floor, m, 1e-3 to 1e3; default 0.3.</summary>
        public double FloorSize
        {
            get { return box[0].FloorSize; }
            set { box[0].FloorSize = value; }
        }

        /// <summary>
        /// Point in the world that vertices are relative to, m, each at most 1e3; default 0. Choose
        /// it near the bodies, because vertices have single precision (24 bits). The square of the
        /// floor is centred on it too.
        /// </summary>
        public Vector3d Origin
        {
            get { return box[0].Origin; }
            set { box[0].Origin = value; }
        }

        internal VisualConfigData* Pin(Pins pins)
        {
            return (VisualConfigData*)pins.Array(box);
        }
    }

    /// <summary>Counts of the last update.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct VisualStatistics
    {
        internal uint StructSize;
        /// <summary>Scenes and bodies that the host has added.</summary>
        public uint Sources;
        /// <summary>Bodies drawn.</summary>
        public uint Parts;
        /// <summary>Vertices of all parts.</summary>
        public uint Vertices;
        /// <summary>Triangles of all parts.</summary>
        public uint Triangles;
        /// <summary>Marks and holes.</summary>
        public uint Spots;
        /// <summary>Calls of vbss_visual_update that succeeded.</summary>
        public ulong Updates;
    }
}
