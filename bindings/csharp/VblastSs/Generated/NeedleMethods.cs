// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>A needle.</summary>
    public sealed unsafe partial class Needle : VbssObject
    {
        internal Needle(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>The state, to go back to it or to go on elsewhere to the same bits.</summary>
        public byte[] Save()
        {
            return SaveState(Native.vbss_needle_save);
        }

        /// <summary>Goes to a state that was saved from this object, or from one made alike. A failed call changes nothing.</summary>
        public void Restore(ReadOnlySpan<byte> state)
        {
            fixed (byte* bytes = state)
            {
                Context.Check(Native.vbss_needle_restore(Handle, bytes, (ulong)state.Length));
            }
        }

        /// <summary>A read-only array inside the library; see <see cref="View"/>.</summary>
        public View GetView(NeedleField field)
        {
            return new View(this, (int)field, false, (handle, number, view, size) =>
                Native.vbss_needle_get_view(handle, (NeedleField)number, view, size));
        }

        /// <summary>Creates a needle with the pose and velocity of its configuration.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">configuration; NULL for the defaults</param>
        public Needle(Context context, NeedleConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr needle;
                Context.Check(Native.vbss_needle_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out needle));
                Adopt(needle, Native.vbss_needle_destroy, pins);
            }
        }

        /// <summary>
        /// Destroys a needle now, or when it leaves the scene that it belongs to: on
        /// vbss_scene_remove and on vbss_scene_destroy. Until then the handle is valid. A host that
        /// has discarded all bodies of a scene needs to destroy only the scene.
        /// </summary>
        public void Discard()
        {
            Context.Check(Native.vbss_needle_discard(Handle));
        }

        /// <summary>
        /// Makes one step of free flight under gravity and drag, without contacts. Angular momentum
        /// is conserved up to rounding; the rotation is of second order (the splitting of
        /// docs/explanation/needle.md). A needle turns by at most a quarter of a turn in a step; a
        /// faster one slows down.
        /// </summary>
        /// <param name="h">length of the step, s, 1e-7 to 0.1</param>
        public void Step(double h)
        {
            Context.Check(Native.vbss_needle_step(Handle, h));
        }

        /// <summary>Sets the pose and velocity of a needle that is not in a scene.</summary>
        /// <param name="position">position of the frame's origin, m, each coordinate at most 1e3 in magnitude</param>
        /// <param name="orientation">w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps it</param>
        /// <param name="velocity">velocity of the frame's origin, m/s, each component at most 1e5 in magnitude; NULL: zero</param>
        /// <param name="angularVelocity">rad/s, each component at most 1e6 in magnitude; NULL: zero</param>
        public void SetState(Vector3d position, Quaterniond? orientation, Vector3d? velocity, Vector3d? angularVelocity)
        {
            Quaterniond orientationValue = orientation.GetValueOrDefault();
            Vector3d velocityValue = velocity.GetValueOrDefault();
            Vector3d angularVelocityValue = angularVelocity.GetValueOrDefault();
            Context.Check(Native.vbss_needle_set_state(Handle, (double*)&position, orientation.HasValue ? (double*)&orientationValue : null, velocity.HasValue ? (double*)&velocityValue : null, angularVelocity.HasValue ? (double*)&angularVelocityValue : null));
        }

        /// <summary>Returns pose and velocity of a needle.</summary>
        public NeedleState GetState()
        {
            NeedleState state;
            Context.Check(Native.vbss_needle_get_state(Handle, &state, (uint)sizeof(NeedleState)));
            return state;
        }

        /// <summary>Returns mass and inertia of a needle.</summary>
        public NeedleMass GetMass()
        {
            NeedleMass mass;
            Context.Check(Native.vbss_needle_get_mass(Handle, &mass, (uint)sizeof(NeedleMass)));
            return mass;
        }

        /// <summary>
        /// Returns a point on the exact centre line, and the direction toward the tip there. Beyond
        /// the ends the line continues straight.
        /// </summary>
        /// <param name="arcLength">from the tip towards the swage, m, at most 10 in magnitude</param>
        /// <param name="positionResult">position on the centre line, m</param>
        /// <param name="directionResult">unit vector; may be NULL</param>
        public void GetPlace(double arcLength, out Vector3d positionResult, out Vector3d directionResult)
        {
            Vector3d position;
            Vector3d direction;
            Context.Check(Native.vbss_needle_get_place(Handle, arcLength, (double*)&position, (double*)&direction));
            positionResult = position;
            directionResult = direction;
        }

        /// <summary>Returns the energies of a needle.</summary>
        public NeedleEnergies GetEnergies()
        {
            NeedleEnergies energies;
            Context.Check(Native.vbss_needle_get_energies(Handle, &energies, (uint)sizeof(NeedleEnergies)));
            return energies;
        }

        /// <summary>
        /// Returns the XXH64 of the needle's state; equal states have equal hashes on every
        /// machine.
        /// </summary>
        public ulong GetHash()
        {
            ulong hash;
            Context.Check(Native.vbss_needle_get_hash(Handle, (ulong*)&hash));
            return hash;
        }
    }

    public sealed unsafe partial class NeedleConfig
    {
        /// <summary>Sets radius, wire radius and arc to those of a known needle.</summary>
        /// <param name="preset">the known needle</param>
        public void UsePreset(NeedlePreset preset)
        {
            using (Pins pins = Pins.Rent())
            {
                Vblast.Check(Native.vbss_needle_config_preset(Pin(pins), preset));
            }
        }

        /// <summary>
        /// Sets radius, wire radius and arc to those of a needle as catalogues describe it.
        /// docs/reference/sutures.md lists common needles.
        /// </summary>
        /// <param name="circle">share of a circle, 0.05 to 0.9: 0.5 for a half circle</param>
        /// <param name="length">length along the arc, m, 1e-3 to 1</param>
        /// <param name="wireDiameter">diameter of the wire, m, 1e-5 to 0.4 of the arc's radius</param>
        public void UseShape(double circle, double length, double wireDiameter)
        {
            using (Pins pins = Pins.Rent())
            {
                Vblast.Check(Native.vbss_needle_config_shape(Pin(pins), circle, length, wireDiameter));
            }
        }
    }
}
