// Written by bindings/csharp/generate.py from the public headers: do not edit.
namespace VblastSs
{
    /// <summary>Bodies that touch each other and are stepped together.</summary>
    public sealed unsafe partial class Scene : VbssObject
    {
        /// <summary>
        /// Adds a mesh of triangles that never moves: anatomy, a table, a phantom. Threads,
        /// needles, tools and drains touch it from both sides, or from the front alone (one_sided).
        /// It counts as one of the scene's rigid bodies (rigid_capacity). Two static meshes do not
        /// touch each other. A driven body that overlaps it when it is added is held back by it.
        /// The call allocates all memory that steps need for the mesh, and builds its bounding
        /// volume hierarchy; no step allocates or builds either. Holes cannot be made in it, and no
        /// node be pinned to it. Rays and overlaps find it from both sides. vbss_scene_get_rigid
        /// reports the contact force on it.
        /// </summary>
        /// <param name="config">the configuration; not NULL, because a mesh needs triangles</param>
        public uint AddStaticMesh(SceneStaticMeshConfig config)
        {
            using (Pins pins = Pins.Rent())
            {
                uint body;
                Context.Check(Native.vbss_scene_add_static_mesh(Handle, config == null ? null : config.Pin(pins), (uint*)&body));
                return body;
            }
        }

        /// <summary>
        /// Adds a rigid body whose shape is a mesh of triangles: another instrument, a trocar, a
        /// bone. It moves as a rigid body of capsules does (vbss_scene_set_rigid_target, and for
        /// its kind of motion forces, velocities and poses), and vbss_scene_get_rigid reports the
        /// forces on it. Threads, needles, tools and drains touch its surface from both sides, with
        /// friction, and the guard (CCD) tests its moving triangles. During a part of a step its
        /// vertices move along straight lines. A set of convex hulls is a mesh with the faces of
        /// all of them. Meshes, static ones and host surfaces included, do not touch each other,
        /// nor a mesh the floor or a plane. A driven body of capsules that overlaps a driven mesh
        /// when one of them is added is held back by it. No node can be pinned to it, and no hole
        /// be made in it. Its kind is VBSS_SCENE_BODY_RIGID, and it counts as one of the scene's
        /// rigid bodies (rigid_capacity) without capsules. The call allocates all memory that steps
        /// need for it, and builds its bounding volume hierarchy, which steps never rebuild or
        /// refit.
        /// </summary>
        /// <param name="motion">
        /// pose, kind of motion, mass and coupling; NULL for the defaults. It has no capsules, and
        /// its friction is not used. The mass is spread evenly over the area of the triangles.
        /// </param>
        /// <param name="geometry">
        /// triangles, in the frame of the body, thickness and friction; not NULL, because a mesh
        /// needs triangles. one_sided must be 0.
        /// </param>
        public uint AddRigidMesh(SceneRigidConfig motion, SceneStaticMeshConfig geometry)
        {
            using (Pins pins = Pins.Rent())
            {
                uint body;
                Context.Check(Native.vbss_scene_add_rigid_mesh(Handle, motion == null ? null : motion.Pin(pins), geometry == null ? null : geometry.Pin(pins), (uint*)&body));
                return body;
            }
        }

        /// <summary>
        /// Adds a height field that never moves: a static mesh with two triangles for each cell of
        /// the grid. All that vbss_scene_add_static_mesh says holds for it, and its kind is
        /// VBSS_SCENE_BODY_STATIC_MESH. The triangles of a cell meet on its diagonal from the first
        /// corner. Feature 2 n is the triangle of cell n on the side of the rows, 2 n + 1 that on
        /// the side of the columns.
        /// </summary>
        /// <param name="config">the configuration; not NULL, because a field needs heights</param>
        public uint AddHeightField(SceneHeightFieldConfig config)
        {
            using (Pins pins = Pins.Rent())
            {
                uint body;
                Context.Check(Native.vbss_scene_add_height_field(Handle, config == null ? null : config.Pin(pins), (uint*)&body));
                return body;
            }
        }

        /// <summary>
        /// Adds the surface of a solid that is given by signed distances at the points of a grid,
        /// and never moves. The call finds the surface on which the trilinear interpolation of the
        /// distances is minus half the thickness, with one vertex for each cell of the grid that
        /// the surface passes, and adds it as a static mesh. All that vbss_scene_add_static_mesh
        /// says holds for it, and its kind is VBSS_SCENE_BODY_STATIC_MESH. The surface is open
        /// where it leaves the grid. A surface that passes a cell more than once is refused,
        /// because the grid is too coarse for it. Parts that lie between the points of the grid are
        /// not in the distances, and so not in the surface.
        /// </summary>
        /// <param name="config">the configuration; not NULL, because a field needs distances</param>
        public uint AddDistanceField(SceneDistanceFieldConfig config)
        {
            using (Pins pins = Pins.Rent())
            {
                uint body;
                Context.Check(Native.vbss_scene_add_distance_field(Handle, config == null ? null : config.Pin(pins), (uint*)&body));
                return body;
            }
        }

        /// <summary>
        /// Adds a plane that never moves. It bounds a half-space, as the floor does, and has the
        /// rules of the floor: nodes of threads, ends of capsules and nodes of drains touch it. Its
        /// contacts have the kinds of those with the floor, and its number as body b. It counts as
        /// one of the scene's rigid bodies (rigid_capacity) without capsules. No node can be pinned
        /// to it. A driven body that is in the half-space when the plane is added is held back by
        /// it. vbss_scene_get_rigid reports the contact force on it.
        /// </summary>
        /// <param name="config">the configuration</param>
        public uint AddPlane(ScenePlaneConfig config)
        {
            using (Pins pins = Pins.Rent())
            {
                uint body;
                Context.Check(Native.vbss_scene_add_plane(Handle, config == null ? null : config.Pin(pins), (uint*)&body));
                return body;
            }
        }
    }
}
