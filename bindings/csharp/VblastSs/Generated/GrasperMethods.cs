// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>A tool with two jaws.</summary>
    public sealed unsafe partial class Grasper : VbssObject
    {
        internal Grasper(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>A read-only array inside the library; see <see cref="View"/>.</summary>
        public View GetView(GrasperField field)
        {
            return new View(this, (int)field, false, (handle, number, view, size) =>
                Native.vbss_grasper_get_view(handle, (GrasperField)number, view, size));
        }

        /// <summary>Creates a grasper with open jaws. Its tip is at the origin until the host moves it.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">the configuration; NULL for the defaults</param>
        public Grasper(Context context, GrasperConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr grasper;
                Context.Check(Native.vbss_grasper_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out grasper));
                Adopt(grasper, Native.vbss_grasper_destroy, pins);
            }
        }

        /// <summary>
        /// Destroys a grasper now, or when it leaves the scene that it belongs to: on
        /// vbss_scene_remove and on vbss_scene_destroy. Until then the handle is valid. A host that
        /// has discarded all bodies of a scene needs to destroy only the scene.
        /// </summary>
        public void Discard()
        {
            Context.Check(Native.vbss_grasper_discard(Handle));
        }

        /// <summary>
        /// Sets the pose that the tool reaches at the end of the next step. Before the tool is
        /// added to a scene, the call sets its initial pose. With a trocar, the tip moves to the
        /// given position. The given orientation is turned along the shortest path until the shaft
        /// passes through the trocar, so only its roll about the shaft is free.
        /// </summary>
        /// <param name="position">target of the tip, m, each at most 1e3</param>
        /// <param name="orientation">target, w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps the last one</param>
        public void SetTarget(Vector3d position, Quaterniond? orientation)
        {
            Quaterniond orientationValue = orientation.GetValueOrDefault();
            Context.Check(Native.vbss_grasper_set_target(Handle, (double*)&position, orientation.HasValue ? (double*)&orientationValue : null));
        }

        /// <summary>
        /// Sets how far the handle is open from the next step on. The jaws follow with at most
        /// jaw_speed.
        /// </summary>
        /// <param name="opening">opening, 0 (closed) to 1 (open)</param>
        public void SetOpening(double opening)
        {
            Context.Check(Native.vbss_grasper_set_opening(Handle, opening));
        }

        /// <summary>
        /// Requests another kind of tool. The next step of the scene exchanges the tool or refuses
        /// the request, with an event either way. It refuses while the tool holds a body, where
        /// exchange_distance forbids the exchange, and where the tip is too near to the trocar for
        /// the other jaws. A refused request is not repeated.
        /// </summary>
        /// <param name="kind">the new kind; the present kind changes nothing</param>
        public void Exchange(GrasperKind kind)
        {
            Context.Check(Native.vbss_grasper_exchange(Handle, kind));
        }

        /// <summary>Returns the pose of a grasper and the forces that act on it.</summary>
        public GrasperState GetState()
        {
            GrasperState state;
            Context.Check(Native.vbss_grasper_get_state(Handle, &state, (uint)sizeof(GrasperState)));
            return state;
        }
    }

    public sealed unsafe partial class GrasperConfig
    {
        /// <summary>
        /// Sets length, radius, bend, opening and neck of the driver's jaws to those of a known
        /// tool.
        /// </summary>
        /// <param name="preset">the known tool</param>
        public void UsePreset(GrasperPreset preset)
        {
            using (Pins pins = Pins.Rent())
            {
                Vblast.Check(Native.vbss_grasper_config_preset(Pin(pins), preset));
            }
        }
    }
}
