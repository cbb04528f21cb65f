// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>Meshes of scenes and bodies.</summary>
    public sealed unsafe partial class Visual : VbssObject
    {
        internal Visual(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>A read-only array inside the library; see <see cref="View"/>.</summary>
        public View GetView(VisualField field)
        {
            return new View(this, (int)field, false, (handle, number, view, size) =>
                Native.vbss_visual_get_view(handle, (VisualField)number, view, size));
        }

        /// <summary>Creates a visual without sources. Only this call allocates memory.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">the configuration; NULL for the defaults</param>
        public Visual(Context context, VisualConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr visual;
                Context.Check(Native.vbss_visual_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out visual));
                Adopt(visual, Native.vbss_visual_destroy, pins);
            }
        }

        /// <summary>
        /// Shows a scene from the next update on: all its bodies, also bodies and pieces of threads
        /// added later, its floor and its holes. A destroyed scene is no longer shown.
        /// </summary>
        /// <param name="scene">a scene of the same context</param>
        public uint AddScene(Scene scene)
        {
            uint source;
            Keep(scene);
            Context.Check(Native.vbss_visual_add_scene(Handle, ObjectHandle.Of(scene), (uint*)&source));
            return source;
        }

        /// <summary>
        /// Shows a replica (replica.h): the scene as it was when the state that the reader took
        /// last was published. The replica belongs to the context of its scene, which may be
        /// another one than the visual's. The thread that updates the visual must be the reader of
        /// the replica. A destroyed replica is no longer shown; remove it before its context is
        /// destroyed.
        /// </summary>
        /// <param name="replica">a replica of any context</param>
        public uint AddReplica(Replica replica)
        {
            uint source;
            Keep(replica);
            Context.Check(Native.vbss_visual_add_replica(Handle, ObjectHandle.Of(replica), (uint*)&source));
            return source;
        }

        /// <summary>
        /// Shows a thread from the next update on, until it is removed from the visual or
        /// destroyed.
        /// </summary>
        /// <param name="thread">a thread of the same context</param>
        public uint AddThread(SutureThread thread)
        {
            uint source;
            Keep(thread);
            Context.Check(Native.vbss_visual_add_thread(Handle, ObjectHandle.Of(thread), (uint*)&source));
            return source;
        }

        /// <summary>
        /// Shows a drain from the next update on, without holes, until it is removed from the
        /// visual or destroyed.
        /// </summary>
        /// <param name="drain">a drain of the same context</param>
        public uint AddDrain(Drain drain)
        {
            uint source;
            Keep(drain);
            Context.Check(Native.vbss_visual_add_drain(Handle, ObjectHandle.Of(drain), (uint*)&source));
            return source;
        }

        /// <summary>
        /// Shows a needle from the next update on, until it is removed from the visual or
        /// destroyed.
        /// </summary>
        /// <param name="needle">a needle of the same context</param>
        public uint AddNeedle(Needle needle)
        {
            uint source;
            Keep(needle);
            Context.Check(Native.vbss_visual_add_needle(Handle, ObjectHandle.Of(needle), (uint*)&source));
            return source;
        }

        /// <summary>
        /// Shows a grasper from the next update on, until it is removed from the visual or
        /// destroyed.
        /// </summary>
        /// <param name="grasper">a grasper of the same context</param>
        public uint AddGrasper(Grasper grasper)
        {
            uint source;
            Keep(grasper);
            Context.Check(Native.vbss_visual_add_grasper(Handle, ObjectHandle.Of(grasper), (uint*)&source));
            return source;
        }

        /// <summary>Removes a scene or a body. It is not shown from the next update on.</summary>
        /// <param name="source">number of the scene or the body in the visual</param>
        public void Remove(uint source)
        {
            Context.Check(Native.vbss_visual_remove(Handle, source));
        }

        /// <summary>
        /// Computes the meshes of all sources in their current state. The call allocates nothing.
        /// Earlier views keep their content until the update after this one. On failure the meshes
        /// do not change.
        /// </summary>
        public void Update()
        {
            Context.Check(Native.vbss_visual_update(Handle));
        }

        /// <summary>Returns the counts of the last update.</summary>
        public VisualStatistics GetStatistics()
        {
            VisualStatistics statistics;
            Context.Check(Native.vbss_visual_get_statistics(Handle, &statistics, (uint)sizeof(VisualStatistics)));
            return statistics;
        }
    }
}
