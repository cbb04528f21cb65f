// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>Bodies that touch each other and are stepped together.</summary>
    public sealed unsafe partial class Scene : VbssObject
    {
        internal Scene(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>The state, to go back to it or to go on elsewhere to the same bits.</summary>
        public byte[] Save()
        {
            return SaveState(Native.vbss_scene_save);
        }

        /// <summary>Goes to a state that was saved from this object, or from one made alike. A failed call changes nothing.</summary>
        public void Restore(ReadOnlySpan<byte> state)
        {
            fixed (byte* bytes = state)
            {
                Context.Check(Native.vbss_scene_restore(Handle, bytes, (ulong)state.Length));
            }
        }

        /// <summary>A read-only array inside the library; see <see cref="View"/>.</summary>
        public View GetView(SceneField field)
        {
            return new View(this, (int)field, false, (handle, number, view, size) =>
                Native.vbss_scene_get_view(handle, (SceneField)number, view, size));
        }

        /// <summary>Creates a scene without bodies, and allocates the memory that steps need.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">configuration; NULL for the defaults</param>
        public Scene(Context context, SceneConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr scene;
                Context.Check(Native.vbss_scene_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out scene));
                Adopt(scene, Native.vbss_scene_destroy, pins);
            }
        }

        /// <summary>Adds a rigid body. A scene accepts at most 4096 bodies in its life, threads included.</summary>
        /// <param name="config">the configuration; not NULL, because a body needs capsules</param>
        public uint AddRigid(SceneRigidConfig config)
        {
            using (Pins pins = Pins.Rent())
            {
                uint body;
                Context.Check(Native.vbss_scene_add_rigid(Handle, config == null ? null : config.Pin(pins), (uint*)&body));
                return body;
            }
        }

        /// <summary>Returns one of the places that a grasper holds.</summary>
        /// <param name="tool">number of the grasper in the scene</param>
        /// <param name="index">index of the place, from 0 on</param>
        public SceneGrasp GetGrasp(uint tool, uint index)
        {
            SceneGrasp grasp;
            Context.Check(Native.vbss_scene_get_grasp(Handle, tool, index, &grasp, (uint)sizeof(SceneGrasp)));
            return grasp;
        }

        /// <summary>Returns a hole of a needle or a thread in a drain or host surface, after the last step.</summary>
        /// <param name="index">index of the hole, from 0 on; the order may change with the next step</param>
        public SceneHole GetHole(uint index)
        {
            SceneHole hole;
            Context.Check(Native.vbss_scene_get_hole(Handle, index, &hole, (uint)sizeof(SceneHole)));
            return hole;
        }

        /// <summary>
        /// Returns a pair of bodies that hold each other back. Pairs are in the order in which they
        /// began. A pair is listed until it has moved freely for 0.1 s of simulated time. At most
        /// 16 are listed. Method IMPLICIT.
        /// </summary>
        /// <param name="index">index of the pair, from 0 on</param>
        public SceneBlocker GetBlocker(uint index)
        {
            SceneBlocker blocker;
            Context.Check(Native.vbss_scene_get_blocker(Handle, index, &blocker, (uint)sizeof(SceneBlocker)));
            return blocker;
        }

        /// <summary>
        /// Makes a hole where a thread or a needle already goes through the wall of a drain or host
        /// surface, for hosts that lay out a stitch. Afterwards the hole behaves as if a needle had
        /// made it.
        /// </summary>
        /// <param name="body">the thread or the needle; a thread of three nodes at least</param>
        /// <param name="arcLength">
        /// approximate arc length of the hole, m, 0 to its length; the hole is at the nearest place
        /// of the suture that a descent from there finds
        /// </param>
        /// <param name="drain">the drain or host surface</param>
        /// <param name="triangle">its triangle: of a drain in VBSS_DRAIN_VIEW_TRIANGLES, of a host surface as it was added</param>
        /// <param name="weights">three weights of its nodes at the hole, 0 to 1, with the sum 1</param>
        public uint MakeHole(uint body, double arcLength, uint drain, uint triangle, Doubles3? weights)
        {
            Doubles3 weightsValue = weights.GetValueOrDefault();
            uint id;
            Context.Check(Native.vbss_scene_make_hole(Handle, body, arcLength, drain, triangle, weights.HasValue ? (double*)&weightsValue : null, (uint*)&id));
            return id;
        }

        /// <summary>
        /// Sets the target of a driven or coupled body for the end of the next step. The body, or
        /// the pose that it is tied to, moves there at constant speed during the step, turning the
        /// shortest way, and then stays. The last call before a step counts. Between two steps the
        /// target must turn by less than half a turn.
        /// </summary>
        /// <param name="body">a rigid body, neither a free one nor a grasper (vbss_grasper_set_target)</param>
        /// <param name="position">position of the origin of its frame, m, each coordinate at most 1e3 in magnitude</param>
        /// <param name="orientation">quaternion w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps the orientation</param>
        public void SetRigidTarget(uint body, Vector3d position, Quaterniond? orientation)
        {
            Quaterniond orientationValue = orientation.GetValueOrDefault();
            Context.Check(Native.vbss_scene_set_rigid_target(Handle, body, (double*)&position, orientation.HasValue ? (double*)&orientationValue : null));
        }

        /// <summary>
        /// Pins a node of a thread to a point of a body. The node moves there within the next step
        /// and then moves with the body. With method IMPLICIT the node's motion is eliminated in
        /// favour of the body's, so the body bears its force, at any ratio of masses. With method
        /// VBLAST, and on driven bodies and the world, the node moves as the body does. With method
        /// VBLAST pins keep a knot: pin the nearest node of both strands of a crossing. No other
        /// attachment may hold the node. On driven bodies and the world the node becomes the end of
        /// a section, and the pin is an attachment of the thread. A pin whose attachment was
        /// detached holds nothing. Along the thread the thread does not touch the body within 1.6
        /// contact distances of the pin.
        /// </summary>
        /// <param name="thread">number of the thread in the scene</param>
        /// <param name="node">0 to its number of nodes - 1</param>
        /// <param name="body">number of a rigid body; 0: the world</param>
        /// <param name="point">
        /// point in the frame of the body, m, each coordinate at most 1e3 in magnitude; NULL: the
        /// current position of the node
        /// </param>
        public uint PinThread(uint thread, uint node, uint body, Vector3d? point)
        {
            Vector3d pointValue = point.GetValueOrDefault();
            uint pin;
            Context.Check(Native.vbss_scene_pin_thread(Handle, thread, node, body, point.HasValue ? (double*)&pointValue : null, (uint*)&pin));
            return pin;
        }

        /// <summary>Removes a pin.</summary>
        /// <param name="pin">identifier of the pin</param>
        public void UnpinThread(uint pin)
        {
            Context.Check(Native.vbss_scene_unpin_thread(Handle, pin));
        }

        /// <summary>
        /// Cuts a thread of the scene in two, in place, with its pins, attachments and contacts.
        /// The part beyond the cut becomes a new body with node 0 at the cut. Pieces can be cut
        /// again. The scene has reserved capacity for the pieces when the thread was added, so the
        /// call allocates nothing, except a temporary copy of the state while a step is suspended.
        /// A cut within 1 % of a segment, or 1e-7 m, of a node goes through the node, which the
        /// thread keeps with its attachments. A cut within 0.2 mm of a hole of the thread is made
        /// 0.2 mm beside it, where an end is out of the hole. The ends at a cut do not touch each
        /// other until they have come apart. Contacts in the views keep their earlier numbers until
        /// the next step.
        /// </summary>
        /// <param name="thread">number of the thread in the scene</param>
        /// <param name="arcLength">
        /// unstretched arc length from the thread's node 0 to the cut, m, within its length and not
        /// at an end
        /// </param>
        public uint CutThread(uint thread, double arcLength)
        {
            uint piece;
            Context.Check(Native.vbss_scene_cut_thread(Handle, thread, arcLength, (uint*)&piece));
            return piece;
        }

        /// <summary>
        /// Returns the handle of a thread in the scene, for views and attachments. When a state
        /// from before its cut is restored, the handle of a piece becomes invalid. It becomes valid
        /// again when a state from after the cut is restored.
        /// </summary>
        /// <param name="body">number of the thread in the scene</param>
        public SutureThread GetThread(uint body)
        {
            IntPtr thread;
            Context.Check(Native.vbss_scene_get_thread(Handle, body, out thread));
            return Context.Find(thread, (owner, handle) => new SutureThread(owner, handle, null));
        }

        /// <summary>
        /// Does the work of the next step that does not depend on contacts, so that this step takes
        /// no longer than those after it: the search for close bodies begins, and the pattern of
        /// the linear system is analysed. Call it when all bodies are in the scene, before the
        /// first step or after bodies were added. The state does not change, and a scene steps with
        /// the same bits without the call. A suspended step stays as it is. The call allocates
        /// nothing. Method IMPLICIT; with method VBLAST the call does nothing.
        /// </summary>
        public void Prepare()
        {
            Context.Check(Native.vbss_scene_prepare(Handle));
        }

        /// <summary>
        /// Advances the scene by one step. The call allocates nothing. On failure the scene is
        /// unchanged. With method VBLAST the step of a thread or drain that has diverged fails; see
        /// vbss_thread_step and vbss_drain_step for the bounds. If a call has ended a suspended
        /// step, or some islands of a step, and the rest fails, that result stays: the call returns
        /// VBSS_OK, `behind` counts the rest, and the next call returns the failure.
        /// </summary>
        /// <param name="h">length of the step, s, 1e-7 to 0.1</param>
        public void Step(double h)
        {
            Context.Check(Native.vbss_scene_step(Handle, h));
        }

        /// <summary>Returns the state of a rigid body.</summary>
        /// <param name="body">its number</param>
        public SceneRigidState GetRigid(uint body)
        {
            SceneRigidState state;
            Context.Check(Native.vbss_scene_get_rigid(Handle, body, &state, (uint)sizeof(SceneRigidState)));
            return state;
        }

        /// <summary>Returns the counters of a scene.</summary>
        public SceneStatistics GetStatistics()
        {
            SceneStatistics statistics;
            Context.Check(Native.vbss_scene_get_statistics(Handle, &statistics, (uint)sizeof(SceneStatistics)));
            return statistics;
        }

        /// <summary>Returns what method VBLAST counts in a scene, without what its threads count.</summary>
        public BaselineStatistics GetBaselineStatistics()
        {
            BaselineStatistics statistics;
            Context.Check(Native.vbss_scene_get_baseline_statistics(Handle, &statistics, (uint)sizeof(BaselineStatistics)));
            return statistics;
        }

        /// <summary>
        /// Returns the deepest overlap of a body with another body or the floor in their current
        /// poses. An overlap counts if it is deeper than `penetration_tolerance` of the solver's
        /// options allows after a step. Overlaps of the body with itself do not count, nor do those
        /// near a pin of a thread on the other body or at the swage of a needle. Pairs of driven
        /// bodies do not count either, because a step does not test them until they have come
        /// apart. Contacts in jaws and holes count. The call compares all segments of the body with
        /// all others; use it while a scene is set up.
        /// </summary>
        /// <param name="body">number of the body</param>
        public SceneOverlap GetOverlap(uint body)
        {
            SceneOverlap overlap;
            Context.Check(Native.vbss_scene_get_overlap(Handle, body, &overlap, (uint)sizeof(SceneOverlap)));
            return overlap;
        }

        /// <summary>
        /// Returns the XXH64 of the state of the scene and its bodies, counters included. Equal
        /// states have equal hashes on every machine.
        /// </summary>
        public ulong GetHash()
        {
            ulong hash;
            Context.Check(Native.vbss_scene_get_hash(Handle, (ulong*)&hash));
            return hash;
        }
    }

    public sealed unsafe partial class SceneConfig
    {
        /// <summary>
        /// Returns the memory that vbss_scene_create allocates for a configuration. Bodies and
        /// drains add their own: see docs/reference/memory.md. The call creates such a scene and
        /// destroys it again, so that the number is exact; a host then knows what to reserve on
        /// another machine with the same sizes of pointers.
        /// </summary>
        /// <param name="context">the context, whose allocator must have this memory</param>
        /// <param name="config">configuration; NULL for the defaults</param>
        public static ulong GetMemory(Context context, SceneConfig config = null)
        {
            using (Pins pins = Pins.Rent())
            {
                ulong bytes;
                context.Check(Native.vbss_scene_config_get_memory(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), (ulong*)&bytes));
                return bytes;
            }
        }
    }
}
