// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>A suture thread.</summary>
    public sealed unsafe partial class SutureThread : VbssObject
    {
        internal SutureThread(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>The state, to go back to it or to go on elsewhere to the same bits.</summary>
        public byte[] Save()
        {
            return SaveState(Native.vbss_thread_save);
        }

        /// <summary>Goes to a state that was saved from this object, or from one made alike. A failed call changes nothing.</summary>
        public void Restore(ReadOnlySpan<byte> state)
        {
            fixed (byte* bytes = state)
            {
                Context.Check(Native.vbss_thread_restore(Handle, bytes, (ulong)state.Length));
            }
        }

        /// <summary>A read-only array inside the library; see <see cref="View"/>.</summary>
        public View GetView(ThreadField field)
        {
            return new View(this, (int)field, false, (handle, number, view, size) =>
                Native.vbss_thread_get_view(handle, (ThreadField)number, view, size));
        }

        /// <summary>Creates a thread at rest.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">the configuration; NULL for the defaults</param>
        public SutureThread(Context context, ThreadConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr thread;
                Context.Check(Native.vbss_thread_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out thread));
                Adopt(thread, Native.vbss_thread_destroy, pins);
            }
        }

        /// <summary>
        /// Destroys a thread now, or when it leaves the scene that it belongs to: on
        /// vbss_scene_remove and on vbss_scene_destroy; pieces cut from it remain. Until then the
        /// handle is valid. A host that has discarded all bodies of a scene needs to destroy only
        /// the scene.
        /// </summary>
        public void Discard()
        {
            Context.Check(Native.vbss_thread_discard(Handle));
        }

        /// <summary>
        /// Advances a thread by one step. The call allocates nothing. If the new state is not
        /// finite, the call fails and the thread keeps its state from before the step. With method
        /// VBLAST the call also fails if a segment has become longer than 100 times the length of
        /// the thread plus the distance that its attachments span: the explicit steps have
        /// diverged, and the error text states it. A thread with an adaptive mesh then adapts it by
        /// its curvature alone, because only a scene knows the distance to other bodies.
        /// </summary>
        /// <param name="h">length of the step, s, 1e-7 to 0.1</param>
        public void Step(double h)
        {
            Context.Check(Native.vbss_thread_step(Handle, h));
        }

        /// <summary>
        /// Attaches something to a node. A node takes one PIN or CLAMP, one CLAMP or ROLL, and any
        /// number of the others. All fields must be in their ranges, also those that the kind does
        /// not read.
        /// </summary>
        /// <param name="attachment">the attachment</param>
        public uint Attach(ThreadAttachment attachment)
        {
            using (Pins pins = Pins.Rent())
            {
                uint id;
                Context.Check(Native.vbss_thread_attach(Handle, attachment == null ? null : attachment.Pin(pins), (uint*)&id));
                return id;
            }
        }

        /// <summary>
        /// Sets the target of an attachment for the end of the next step. The attachment moves
        /// there at constant velocity during the step, and then stays.
        /// </summary>
        /// <param name="id">the attachment, not a MASS</param>
        /// <param name="target">PIN, CLAMP, SPRING: position, m; FORCE: the force, N, which changes at once</param>
        /// <param name="direction">CLAMP: as in vbss_thread_attachment; NULL keeps it</param>
        public void SetAttachmentTarget(uint id, Vector3d target, Vector3d? direction)
        {
            Vector3d directionValue = direction.GetValueOrDefault();
            Context.Check(Native.vbss_thread_set_attachment_target(Handle, id, (double*)&target, direction.HasValue ? (double*)&directionValue : null));
        }

        /// <summary>
        /// Sets the roll of a CLAMP or ROLL for the end of the next step: the angle by which it has
        /// turned the section about the thread since it was attached. The section rolls at constant
        /// speed during the step, and then stays. A change of the thread's direction takes the
        /// section along without spin. A new holder has the roll 0 and leaves the twist of the
        /// thread as it is. The twist between a holder and a free end is zero.
        /// </summary>
        /// <param name="id">the attachment, a CLAMP or ROLL</param>
        /// <param name="roll">
        /// angle, rad, -1e6 to 1e6, any number of turns; positive by the right-hand rule about the
        /// direction towards higher nodes
        /// </param>
        public void SetRoll(uint id, double roll)
        {
            Context.Check(Native.vbss_thread_set_roll(Handle, id, roll));
        }

        /// <summary>
        /// Removes an attachment. The twist between its neighbours is the sum of those on either
        /// side, or zero at a free end.
        /// </summary>
        /// <param name="id">the attachment</param>
        public void Detach(uint id)
        {
            Context.Check(Native.vbss_thread_detach(Handle, id));
        }

        /// <summary>
        /// Returns the reaction of an attachment in the last step, regardless of later changes;
        /// zero before its first step. While a scene has a suspended step
        /// (vbss_solver_options::call_budget_us), the last step may be some calls ago. A host that
        /// feeds a spring's force back to a hand should then compute it as stiffness times the
        /// current distance of both ends; a delayed force lets the hand wind the thread up.
        /// </summary>
        /// <param name="id">the attachment</param>
        public ThreadReaction GetReaction(uint id)
        {
            ThreadReaction reaction;
            Context.Check(Native.vbss_thread_get_reaction(Handle, id, &reaction, (uint)sizeof(ThreadReaction)));
            return reaction;
        }

        /// <summary>
        /// Cuts a thread in two. The segment at the place is divided, unless a node is within 1 %
        /// of a segment or 1e-7 m of it, which is then doubled. The thread keeps the part with node
        /// 0; the piece is a thread of its own with the same material and settings, its node 0 at
        /// the cut. Attachments go with their nodes and keep their ids; one on a doubled node stays
        /// with the thread. Plastic and viscous curvatures stay with their nodes; a node inside a
        /// divided segment begins without. Memory was reserved by cut_capacity, which both parts
        /// share.
        /// </summary>
        /// <param name="arcLength">place of the cut, m from node 0, measured in rest lengths, inside the thread</param>
        public SutureThread Cut(double arcLength)
        {
            IntPtr piece;
            Context.Check(Native.vbss_thread_cut(Handle, arcLength, out piece));
            return new SutureThread(Context, piece, Native.vbss_thread_destroy);
        }

        /// <summary>Returns the thread's energies.</summary>
        public ThreadEnergies GetEnergies()
        {
            ThreadEnergies energies;
            Context.Check(Native.vbss_thread_get_energies(Handle, &energies, (uint)sizeof(ThreadEnergies)));
            return energies;
        }

        /// <summary>Returns the thread's momentum.</summary>
        public ThreadMomentum GetMomentum()
        {
            ThreadMomentum momentum;
            Context.Check(Native.vbss_thread_get_momentum(Handle, &momentum, (uint)sizeof(ThreadMomentum)));
            return momentum;
        }

        /// <summary>Returns the thread's counters.</summary>
        public ThreadStatistics GetStatistics()
        {
            ThreadStatistics statistics;
            Context.Check(Native.vbss_thread_get_statistics(Handle, &statistics, (uint)sizeof(ThreadStatistics)));
            return statistics;
        }

        /// <summary>Returns what method VBLAST counts in a thread.</summary>
        public BaselineStatistics GetBaselineStatistics()
        {
            BaselineStatistics statistics;
            Context.Check(Native.vbss_thread_get_baseline_statistics(Handle, &statistics, (uint)sizeof(BaselineStatistics)));
            return statistics;
        }

        /// <summary>
        /// Returns the XXH64 of the thread's state, its counters included; equal states have equal
        /// hashes on every machine.
        /// </summary>
        public ulong GetHash()
        {
            ulong hash;
            Context.Check(Native.vbss_thread_get_hash(Handle, (ulong*)&hash));
            return hash;
        }
    }

    public sealed unsafe partial class ThreadConfig
    {
        /// <summary>Sets radius, linear density, EA and EI of a configuration to those of a known thread.</summary>
        /// <param name="preset">the known thread</param>
        public void UsePreset(ThreadPreset preset)
        {
            using (Pins pins = Pins.Rent())
            {
                Vblast.Check(Native.vbss_thread_config_preset(Pin(pins), preset));
            }
        }

        /// <summary>
        /// Sets radius, linear density, EA and EI of a configuration to those of a suture. They
        /// follow from the diameter of the size and from density, modulus of elasticity and modulus
        /// of bending of the material (docs/reference/sutures.md): a braid bends far more easily
        /// than a solid rod, a monofilament like one.
        /// </summary>
        /// <param name="material">the material</param>
        /// <param name="size">the size</param>
        public void UseSuture(ThreadMaterial material, ThreadUspSize size)
        {
            using (Pins pins = Pins.Rent())
            {
                Vblast.Check(Native.vbss_thread_config_suture(Pin(pins), material, size));
            }
        }
    }
}
