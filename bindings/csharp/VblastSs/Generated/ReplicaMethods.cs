// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>A copy of a scene for another thread.</summary>
    public sealed unsafe partial class Replica : VbssObject
    {
        internal Replica(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>A read-only array inside the library; see <see cref="View"/>.</summary>
        public View GetView(ReplicaField field)
        {
            return new View(this, (int)field, true, (handle, number, view, size) =>
                Native.vbss_replica_get_view(handle, (ReplicaField)number, view, size));
        }

        /// <summary>
        /// Creates a replica in the context of a scene, with the scene's capacities. Only this call
        /// allocates memory. Add drains to the scene first, or state drain_node_capacity.
        /// </summary>
        /// <param name="scene">the scene whose capacities the replica gets</param>
        /// <param name="config">the configuration; NULL for the defaults</param>
        public Replica(Scene scene, ReplicaConfig config = null)
            : base(Require(scene).Context)
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr replica;
                Context.Check(Native.vbss_replica_create(ObjectHandle.Of(scene), config == null ? null : config.Pin(pins), out replica));
                Adopt(replica, Native.vbss_replica_destroy, pins);
                Keep(scene);
            }
        }

        /// <summary>
        /// Publishes the state of a scene as it is after the last step or edit. The call copies the
        /// state, allocates nothing and never waits for the reader. The constant mesh of a drain is
        /// copied only into buffers that do not have it yet. On failure the reader keeps the state
        /// that was published before.
        /// </summary>
        /// <param name="scene">a scene of the same context</param>
        public void Publish(Scene scene)
        {
            Keep(scene);
            Context.Check(Native.vbss_replica_publish(Handle, ObjectHandle.Of(scene)));
        }

        /// <summary>
        /// Takes the newest published state. Earlier views become invalid if there is a new one.
        /// The call stores no error text, and never waits for the stepping thread.
        /// </summary>
        public ReplicaState Take()
        {
            ReplicaState state;
            Vblast.Check(Native.vbss_replica_take(Handle, &state, (uint)sizeof(ReplicaState)));
            return state;
        }
    }
}
