// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>A drain.</summary>
    public sealed unsafe partial class Drain : VbssObject
    {
        internal Drain(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>The state, to go back to it or to go on elsewhere to the same bits.</summary>
        public byte[] Save()
        {
            return SaveState(Native.vbss_drain_save);
        }

        /// <summary>Goes to a state that was saved from this object, or from one made alike. A failed call changes nothing.</summary>
        public void Restore(ReadOnlySpan<byte> state)
        {
            fixed (byte* bytes = state)
            {
                Context.Check(Native.vbss_drain_restore(Handle, bytes, (ulong)state.Length));
            }
        }

        /// <summary>A read-only array inside the library; see <see cref="View"/>.</summary>
        public View GetView(DrainField field)
        {
            return new View(this, (int)field, false, (handle, number, view, size) =>
                Native.vbss_drain_get_view(handle, (DrainField)number, view, size));
        }

        /// <summary>Creates a drain at rest.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">the configuration; NULL for the defaults</param>
        public Drain(Context context, DrainConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr drain;
                Context.Check(Native.vbss_drain_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out drain));
                Adopt(drain, Native.vbss_drain_destroy, pins);
            }
        }

        /// <summary>
        /// Destroys a drain now, or when it leaves the scene that it belongs to: on
        /// vbss_scene_remove and on vbss_scene_destroy. Until then the handle is valid. A host that
        /// has discarded all bodies of a scene needs to destroy only the scene.
        /// </summary>
        public void Discard()
        {
            Context.Check(Native.vbss_drain_discard(Handle));
        }

        /// <summary>
        /// Advances a drain by one step. The call allocates nothing. If the new state is not
        /// finite, the call fails and the drain keeps its state from before the step. With method
        /// VBLAST the call also fails if a node is farther from its rest position than 100 times
        /// the length of the drain plus the largest such distance of an attachment: the explicit
        /// steps have diverged, and the error text states it.
        /// </summary>
        /// <param name="h">length of the step, s, 1e-7 to 0.1</param>
        public void Step(double h)
        {
            Context.Check(Native.vbss_drain_step(Handle, h));
        }

        /// <summary>
        /// Attaches something to a node. A node takes one PIN, and any number of the others. All
        /// fields must be in their ranges, also those that the kind does not read.
        /// </summary>
        /// <param name="attachment">the attachment</param>
        public uint Attach(DrainAttachment attachment)
        {
            using (Pins pins = Pins.Rent())
            {
                uint id;
                Context.Check(Native.vbss_drain_attach(Handle, attachment == null ? null : attachment.Pin(pins), (uint*)&id));
                return id;
            }
        }

        /// <summary>
        /// Sets the target of an attachment for the end of the next step. A PIN, or the end of a
        /// SPRING, moves there at constant velocity during the step, and then stays.
        /// </summary>
        /// <param name="id">the attachment</param>
        /// <param name="target">PIN, SPRING: position, m; FORCE: the force, N, which changes at once</param>
        public void SetAttachmentTarget(uint id, Vector3d target)
        {
            Context.Check(Native.vbss_drain_set_attachment_target(Handle, id, (double*)&target));
        }

        /// <summary>Removes an attachment.</summary>
        /// <param name="id">the attachment</param>
        public void Detach(uint id)
        {
            Context.Check(Native.vbss_drain_detach(Handle, id));
        }

        /// <summary>
        /// Returns the force of an attachment on the drain at the end of the last step; zero before
        /// its first step.
        /// </summary>
        /// <param name="id">the attachment</param>
        public Vector3d GetReaction(uint id)
        {
            Vector3d force;
            Context.Check(Native.vbss_drain_get_reaction(Handle, id, (double*)&force));
            return force;
        }

        /// <summary>Returns the nodes of the marks and of the points between which the gap is measured.</summary>
        public DrainPlaces GetPlaces()
        {
            DrainPlaces places;
            Context.Check(Native.vbss_drain_get_places(Handle, &places, (uint)sizeof(DrainPlaces)));
            return places;
        }

        /// <summary>Returns the opening of the slit.</summary>
        public DrainGap GetGap()
        {
            DrainGap gap;
            Context.Check(Native.vbss_drain_get_gap(Handle, &gap, (uint)sizeof(DrainGap)));
            return gap;
        }

        /// <summary>Returns the drain's energies.</summary>
        public DrainEnergies GetEnergies()
        {
            DrainEnergies energies;
            Context.Check(Native.vbss_drain_get_energies(Handle, &energies, (uint)sizeof(DrainEnergies)));
            return energies;
        }

        /// <summary>Returns the drain's counters.</summary>
        public DrainStatistics GetStatistics()
        {
            DrainStatistics statistics;
            Context.Check(Native.vbss_drain_get_statistics(Handle, &statistics, (uint)sizeof(DrainStatistics)));
            return statistics;
        }

        /// <summary>
        /// Returns the XXH64 of the drain's state, its counters included; equal states have equal
        /// hashes on every machine.
        /// </summary>
        public ulong GetHash()
        {
            ulong hash;
            Context.Check(Native.vbss_drain_get_hash(Handle, (ulong*)&hash));
            return hash;
        }
    }
}
