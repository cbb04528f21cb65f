// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>Bodies that touch each other and are stepped together.</summary>
    public sealed unsafe partial class Scene : VbssObject
    {
        /// <summary>Returns the properties of a body.</summary>
        /// <param name="body">its number; 0: the floor</param>
        public SceneBodyInfo GetBody(uint body)
        {
            SceneBodyInfo info;
            Context.Check(Native.vbss_scene_get_body(Handle, body, &info, (uint)sizeof(SceneBodyInfo)));
            return info;
        }

        /// <summary>Returns the handle of a drain in the scene.</summary>
        /// <param name="body">number of the drain in the scene</param>
        public Drain GetDrain(uint body)
        {
            IntPtr drain;
            Context.Check(Native.vbss_scene_get_drain(Handle, body, out drain));
            return Context.Find(drain, (owner, handle) => new Drain(owner, handle, null));
        }

        /// <summary>Returns the handle of a needle in the scene.</summary>
        /// <param name="body">number of the needle in the scene</param>
        public Needle GetNeedle(uint body)
        {
            IntPtr needle;
            Context.Check(Native.vbss_scene_get_needle(Handle, body, out needle));
            return Context.Find(needle, (owner, handle) => new Needle(owner, handle, null));
        }

        /// <summary>Returns the handle of a grasper in the scene.</summary>
        /// <param name="body">number of the grasper in the scene</param>
        public Grasper GetGrasper(uint body)
        {
            IntPtr grasper;
            Context.Check(Native.vbss_scene_get_grasper(Handle, body, out grasper));
            return Context.Find(grasper, (owner, handle) => new Grasper(owner, handle, null));
        }

        /// <summary>
        /// Finds the first surface that a ray hits. A ray that begins inside a body hits it at
        /// fraction 0.
        /// </summary>
        /// <param name="origin">where the ray begins, m, each coordinate at most 1e3 in magnitude</param>
        /// <param name="translation">vector from there to its end, m, each component at most 1e4 in magnitude, not zero</param>
        /// <param name="mask">categories of bodies that count (vbss_scene_set_filter); 0xffffffff: all</param>
        public SceneRayHit CastRay(Vector3d origin, Vector3d translation, uint mask)
        {
            SceneRayHit hit;
            Context.Check(Native.vbss_scene_cast_ray(Handle, (double*)&origin, (double*)&translation, mask, &hit, (uint)sizeof(SceneRayHit)));
            return hit;
        }

        /// <summary>
        /// Finds the body whose surface is nearest to a point, within a radius. Inside several
        /// bodies it is the one with the deepest surface.
        /// </summary>
        /// <param name="point">the point, m, each coordinate at most 1e3 in magnitude</param>
        /// <param name="radius">largest distance, m, 0 to 1e4</param>
        /// <param name="mask">categories of bodies that count (vbss_scene_set_filter); 0xffffffff: all</param>
        public SceneNearest FindNearest(Vector3d point, double radius, uint mask)
        {
            SceneNearest nearest;
            Context.Check(Native.vbss_scene_find_nearest(Handle, (double*)&point, radius, mask, &nearest, (uint)sizeof(SceneNearest)));
            return nearest;
        }
    }
}
