// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>One or two haptic arms under one servo.</summary>
    public sealed unsafe partial class Openhaptics : VbssObject
    {
        internal Openhaptics(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>
        /// Loads the vendor's library, opens the arms and starts the servo. There is no force until
        /// the host writes to a device.
        /// </summary>
        /// <param name="context">owner</param>
        /// <param name="config">configuration; NULL for the defaults</param>
        public Openhaptics(Context context, OpenhapticsConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr openhaptics;
                Context.Check(Native.vbss_openhaptics_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out openhaptics));
                Adopt(openhaptics, Native.vbss_openhaptics_destroy, pins);
            }
        }

        /// <summary>Returns the status of an arm after its newest tick.</summary>
        /// <param name="which">0 or 1</param>
        public OpenhapticsStatus GetStatus(uint which)
        {
            OpenhapticsStatus status;
            Context.Check(Native.vbss_openhaptics_get_status(Handle, which, &status, (uint)sizeof(OpenhapticsStatus)));
            return status;
        }

        /// <summary>Returns model and serial number of an arm from the vendor's library.</summary>
        /// <param name="which">0 or 1</param>
        /// <param name="modelResult">its model, never NULL, valid as long as the arms exist; the argument may be NULL</param>
        /// <param name="serialResult">its serial number, never NULL, valid as long as the arms exist; the argument may be NULL</param>
        public void GetIdentity(uint which, out string modelResult, out string serialResult)
        {
            byte* model;
            byte* serial;
            Context.Check(Native.vbss_openhaptics_get_identity(Handle, which, &model, &serial));
            modelResult = Vblast.Text((IntPtr)model);
            serialResult = Vblast.Text((IntPtr)serial);
        }
    }

    /// <summary>One or two handles: a potentiometer and a solenoid each.</summary>
    public sealed unsafe partial class Nidaqmx : VbssObject
    {
        internal Nidaqmx(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>Loads the vendor's library, opens the lines with solenoids off, and starts their thread.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">configuration; NULL for the defaults</param>
        public Nidaqmx(Context context, NidaqmxConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr nidaqmx;
                Context.Check(Native.vbss_nidaqmx_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out nidaqmx));
                Adopt(nidaqmx, Native.vbss_nidaqmx_destroy, pins);
            }
        }

        /// <summary>
        /// Makes one round in place of the library's thread: writes the newest outputs and reads
        /// one sample. The call waits for the hardware, up to twice `timeout`.
        /// </summary>
        /// <param name="now">
        /// a clock that never runs backwards, s, at most 1e9 in magnitude; when it does, solenoids
        /// are switched off
        /// </param>
        public void Poll(double now)
        {
            Vblast.Check(Native.vbss_nidaqmx_poll(Handle, now));
        }

        /// <summary>Returns the status of the lines after their newest round.</summary>
        public NidaqmxStatus GetStatus()
        {
            NidaqmxStatus status;
            Context.Check(Native.vbss_nidaqmx_get_status(Handle, &status, (uint)sizeof(NidaqmxStatus)));
            return status;
        }
    }
}
