// Written by bindings/csharp/generate.py from the public headers: do not edit.
namespace VblastSs
{
    /// <summary>Bodies that touch each other and are stepped together.</summary>
    public sealed unsafe partial class Scene : VbssObject
    {
        /// <summary>
        /// Adds a host surface: a static mesh that moves (vbss_scene_add_static_mesh). It counts as
        /// one of the scene's rigid bodies (rigid_capacity). It touches neither itself nor static
        /// meshes nor other host surfaces. No node can be pinned to it. Needles and threads pass
        /// through it by holes, as through a drain (vbss_scene_make_hole, puncture_force). A driven
        /// body and the surface do not press on each other, because both follow the host exactly:
        /// the guard holds both back. Vertices with a compliance
        /// (vbss_scene_set_surface_compliance) give way to it, and a coupled tool gives way itself.
        /// The call allocates all memory that steps need for the surface. vbss_scene_get_rigid
        /// reports the sum of the contact forces on it.
        /// </summary>
        /// <param name="config">the configuration; not NULL, because a surface needs triangles</param>
        public uint AddSurface(SceneSurfaceConfig config)
        {
            using (Pins pins = Pins.Rent())
            {
                uint body;
                Context.Check(Native.vbss_scene_add_surface(Handle, config == null ? null : config.Pin(pins), (uint*)&body));
                return body;
            }
        }
    }
}
