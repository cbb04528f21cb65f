// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    [StructLayout(LayoutKind.Sequential)]
    internal struct SceneStaticMeshConfigData
    {
        internal uint StructSize;
        internal uint VertexCount;
        internal uint TriangleCount;
        internal uint OneSided;
        internal IntPtr Vertices;
        internal IntPtr Triangles;
        internal double Friction;
        internal double Thickness;
    }

    /// <summary>
    /// Configuration of a static mesh. Fill it with vbss_scene_static_mesh_config_init, then change
    /// fields.
    /// </summary>
    public sealed unsafe partial class SceneStaticMeshConfig
    {
        private readonly SceneStaticMeshConfigData[] box = new SceneStaticMeshConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public SceneStaticMeshConfig()
        {
            fixed (SceneStaticMeshConfigData* data = box)
            {
                Vblast.Check(Native.vbss_scene_static_mesh_config_init(data, (uint)sizeof(SceneStaticMeshConfigData)));
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
        /// 0: bodies touch it from both sides (default). 1: only from the front, which is the side
        /// from which the corners of a triangle are counter-clockwise. What is behind is left
        /// alone, also within the thickness, and passes to the front. There it is pushed out to the
        /// contact distance. What is in front at the start of a step does not get behind, unless it
        /// goes round a free edge. Each edge of such a mesh belongs to one triangle, or to two that
        /// list it in opposite directions.
        /// </summary>
        public uint OneSided
        {
            get { return box[0].OneSided; }
            set { box[0].OneSided = value; }
        }

        /// <summary>
        /// Vertices in the world, m: vertex_count times x, y, z, each at most 1e3 in magnitude; the
        /// library copies them.
        /// </summary>
        public double[] Vertices { get; set; }

        /// <summary>
        /// Corners of triangles: triangle_count times three different indices of vertices, in any
        /// order. Triangles may share vertices and edges, and need not form a closed surface; the
        /// library copies them.
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

        internal SceneStaticMeshConfigData* Pin(Pins pins)
        {
            ref SceneStaticMeshConfigData data = ref box[0];
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
            return (SceneStaticMeshConfigData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct SceneHeightFieldConfigData
    {
        internal uint StructSize;
        internal uint ColumnCount;
        internal uint RowCount;
        internal uint HeightCount;
        internal uint OneSided;
        internal uint Reserved;
        internal IntPtr Heights;
        internal Vector3d Position;
        internal Quaterniond Orientation;
        internal Doubles2 Spacing;
        internal double Friction;
        internal double Thickness;
    }

    /// <summary>
    /// Configuration of a height field. Fill it with vbss_scene_height_field_config_init, then
    /// change fields. In its frame the heights are along y, the columns along x, and the rows along
    /// z.
    /// </summary>
    public sealed unsafe partial class SceneHeightFieldConfig
    {
        private readonly SceneHeightFieldConfigData[] box = new SceneHeightFieldConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public SceneHeightFieldConfig()
        {
            fixed (SceneHeightFieldConfigData* data = box)
            {
                Vblast.Check(Native.vbss_scene_height_field_config_init(data, (uint)sizeof(SceneHeightFieldConfigData)));
            }
        }

        /// <summary>Number of heights of a row, 2 or more.</summary>
        public uint ColumnCount
        {
            get { return box[0].ColumnCount; }
            set { box[0].ColumnCount = value; }
        }

        /// <summary>Number of rows, 2 or more.</summary>
        public uint RowCount
        {
            get { return box[0].RowCount; }
            set { box[0].RowCount = value; }
        }

        /// <summary>Number of heights: column_count times row_count, at most 65536.</summary>
        public uint HeightCount
        {
            get { return box[0].HeightCount; }
            set { box[0].HeightCount = value; }
        }

        /// <summary>0: bodies touch it from both sides (default). 1: only from above, as a one-sided mesh.</summary>
        public uint OneSided
        {
            get { return box[0].OneSided; }
            set { box[0].OneSided = value; }
        }

        /// <summary>Heights, m, at most 1e3 in magnitude, row by row; the library copies them.</summary>
        public double[] Heights { get; set; }

        /// <summary>Position of the first height of the first row at height 0, m; default 0.</summary>
        public Vector3d Position
        {
            get { return box[0].Position; }
            set { box[0].Position = value; }
        }

        /// <summary>
        /// Orientation of its frame, w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0,
        /// 0, 0.
        /// </summary>
        public Quaterniond Orientation
        {
            get { return box[0].Orientation; }
            set { box[0].Orientation = value; }
        }

        /// <summary>Spacing of columns and of rows, m, 1e-6 to 1e3; default 1e-3.</summary>
        public Doubles2 Spacing
        {
            get { return box[0].Spacing; }
            set { box[0].Spacing = value; }
        }

        /// <summary>
        /// Friction coefficient, 0 to 10; default 0.15. A contact with a thread has this
        /// coefficient, any other contact the geometric mean of both.
        /// </summary>
        public double Friction
        {
            get { return box[0].Friction; }
            set { box[0].Friction = value; }
        }

        /// <summary>
        /// Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. The heights are its middle: other
        /// bodies touch it at half the thickness from them.
        /// </summary>
        public double Thickness
        {
            get { return box[0].Thickness; }
            set { box[0].Thickness = value; }
        }

        internal SceneHeightFieldConfigData* Pin(Pins pins)
        {
            ref SceneHeightFieldConfigData data = ref box[0];
            uint? countedHeightCount = null;
            data.Heights = pins.Array(Heights);
            if (Heights != null)
            {
                data.HeightCount = pins.Count(nameof(Heights), Heights.Length, 1, 0, ref countedHeightCount);
            }
            return (SceneHeightFieldConfigData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct SceneDistanceFieldConfigData
    {
        internal uint StructSize;
        internal uint DistanceCount;
        internal UInts3 Counts;
        internal uint OneSided;
        internal IntPtr Distances;
        internal Vector3d Position;
        internal Quaterniond Orientation;
        internal Vector3d Spacing;
        internal double Friction;
        internal double Thickness;
    }

    /// <summary>
    /// Configuration of a distance field. Fill it with vbss_scene_distance_field_config_init, then
    /// change fields.
    /// </summary>
    public sealed unsafe partial class SceneDistanceFieldConfig
    {
        private readonly SceneDistanceFieldConfigData[] box = new SceneDistanceFieldConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public SceneDistanceFieldConfig()
        {
            fixed (SceneDistanceFieldConfigData* data = box)
            {
                Vblast.Check(Native.vbss_scene_distance_field_config_init(data, (uint)sizeof(SceneDistanceFieldConfigData)));
            }
        }

        /// <summary>Number of distances: the product of the three counts.</summary>
        public uint DistanceCount
        {
            get { return box[0].DistanceCount; }
            set { box[0].DistanceCount = value; }
        }

        /// <summary>Numbers of distances along x, y and z, each 2 to 2048.</summary>
        public UInts3 Counts
        {
            get { return box[0].Counts; }
            set { box[0].Counts = value; }
        }

        /// <summary>1: bodies touch it only from outside, as a one-sided mesh (default). 0: from both sides.</summary>
        public uint OneSided
        {
            get { return box[0].OneSided; }
            set { box[0].OneSided = value; }
        }

        /// <summary>
        /// Signed distances from the surface at the points of a grid, m: negative inside, positive
        /// outside, x fastest, z slowest. The library copies them not, but the surface.
        /// </summary>
        public double[] Distances { get; set; }

        /// <summary>
        /// Position of the first point of the grid, m, each coordinate at most 1e3 in magnitude;
        /// default 0.
        /// </summary>
        public Vector3d Position
        {
            get { return box[0].Position; }
            set { box[0].Position = value; }
        }

        /// <summary>
        /// Orientation of the grid, w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0,
        /// 0, 0.
        /// </summary>
        public Quaterniond Orientation
        {
            get { return box[0].Orientation; }
            set { box[0].Orientation = value; }
        }

        /// <summary>Spacing of the grid along x, y and z, m, 1e-6 to 1e3; default 1e-3.</summary>
        public Vector3d Spacing
        {
            get { return box[0].Spacing; }
            set { box[0].Spacing = value; }
        }

        /// <summary>
        /// Friction coefficient, 0 to 10; default 0.15. A contact with a thread has this
        /// coefficient, any other contact the geometric mean of both.
        /// </summary>
        public double Friction
        {
            get { return box[0].Friction; }
            set { box[0].Friction = value; }
        }

        /// <summary>
        /// Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. Its outer face is where the
        /// distance is 0, and its middle where it is minus half the thickness. Parts of the solid
        /// that are thinner do not exist.
        /// </summary>
        public double Thickness
        {
            get { return box[0].Thickness; }
            set { box[0].Thickness = value; }
        }

        internal SceneDistanceFieldConfigData* Pin(Pins pins)
        {
            ref SceneDistanceFieldConfigData data = ref box[0];
            uint? countedDistanceCount = null;
            data.Distances = pins.Array(Distances);
            if (Distances != null)
            {
                data.DistanceCount = pins.Count(nameof(Distances), Distances.Length, 1, 0, ref countedDistanceCount);
            }
            return (SceneDistanceFieldConfigData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ScenePlaneConfigData
    {
        internal uint StructSize;
        internal uint Reserved;
        internal Vector3d Normal;
        internal double Height;
        internal double Friction;
    }

    /// <summary>Configuration of a plane. Fill it with vbss_scene_plane_config_init, then change fields.</summary>
    public sealed unsafe partial class ScenePlaneConfig
    {
        private readonly ScenePlaneConfigData[] box = new ScenePlaneConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public ScenePlaneConfig()
        {
            fixed (ScenePlaneConfigData* data = box)
            {
                Vblast.Check(Native.vbss_scene_plane_config_init(data, (uint)sizeof(ScenePlaneConfigData)));
            }
        }

        /// <summary>
        /// Direction out of the half-space that the plane bounds, of any length from 1e-100 to
        /// 1e100; default 0, 1, 0.
        /// </summary>
        public Vector3d Normal
        {
            get { return box[0].Normal; }
            set { box[0].Normal = value; }
        }

        /// <summary>Height of the plane along its normal, m, at most 1e3 in magnitude; default 0.</summary>
        public double Height
        {
            get { return box[0].Height; }
            set { box[0].Height = value; }
        }

        /// <summary>
        /// Coefficient of friction, 0 to 10; default 0.3. A contact with a thread has this
        /// coefficient, any other contact the geometric mean of both.
        /// </summary>
        public double Friction
        {
            get { return box[0].Friction; }
            set { box[0].Friction = value; }
        }

        internal ScenePlaneConfigData* Pin(Pins pins)
        {
            return (ScenePlaneConfigData*)pins.Array(box);
        }
    }
}
