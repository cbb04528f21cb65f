// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>A device: one or two adapters, calibration, and the output stage.</summary>
    public sealed unsafe partial class Device : VbssObject
    {
        internal Device(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>The state, to go back to it or to go on elsewhere to the same bits.</summary>
        public byte[] Save()
        {
            return SaveState(Native.vbss_device_save);
        }

        /// <summary>Goes to a state that was saved from this object, or from one made alike. A failed call changes nothing.</summary>
        public void Restore(ReadOnlySpan<byte> state)
        {
            fixed (byte* bytes = state)
            {
                Context.Check(Native.vbss_device_restore(Handle, bytes, (ulong)state.Length));
            }
        }

        /// <summary>
        /// Creates a device: copies the tables of its adapters, opens them and asks for their
        /// capabilities.
        /// </summary>
        /// <param name="context">owner</param>
        /// <param name="first">the adapter of the pose; must have `read`</param>
        /// <param name="second">
        /// an adapter for the signals in `second_signals` and for outputs, or NULL. The second
        /// adapter drives the solenoid if it has one. The first one drives forces if it can.
        /// </param>
        /// <param name="config">configuration; NULL for the defaults</param>
        public Device(Context context, DeviceAdapter first, DeviceAdapter second, DeviceConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr device;
                Context.Check(Native.vbss_device_create(ObjectHandle.Of(context), first == null ? null : first.Pin(pins), second == null ? null : second.Pin(pins), config == null ? null : config.Pin(pins), out device));
                Adopt(device, Native.vbss_device_destroy, pins);
            }
        }

        /// <summary>
        /// Reads each adapter once. The call succeeds even if the hardware fails: status, stale,
        /// events and statistics report faults. The library also logs a warning when the hardware
        /// is lost, is back, has stopped, refuses forces or restarts its clock. The call allocates
        /// nothing.
        /// </summary>
        /// <param name="now">
        /// the host's clock, s; not before the `now` of an earlier call. If it is earlier or out of
        /// range, the call returns an error and switches all outputs off
        /// </param>
        public DeviceInput Read(double now)
        {
            DeviceInput input;
            Context.Check(Native.vbss_device_read(Handle, now, &input, (uint)sizeof(DeviceInput)));
            return input;
        }

        /// <summary>
        /// Passes a command through the output stage and writes the result to the adapters. While
        /// the clutch is held, forces and solenoid are off. Two writes more than 0.1 s apart mean
        /// that the clock has jumped or the host was suspended: all outputs are then off for
        /// vbss_output_result::expires. The call allocates nothing.
        /// </summary>
        /// <param name="now">
        /// the host's clock, s; not before the `now` of an earlier call. If it is earlier or out of
        /// range, the call returns an error and switches all outputs off
        /// </param>
        /// <param name="command">
        /// the wanted outputs, forces in the world's frame; NULL: no new command, so that the last
        /// one ages
        /// </param>
        public OutputResult Write(double now, OutputCommand command)
        {
            using (Pins pins = Pins.Rent())
            {
                OutputResult result;
                Context.Check(Native.vbss_device_write(Handle, now, command == null ? null : command.Pin(pins), &result, (uint)sizeof(OutputResult)));
                return result;
            }
        }

        /// <summary>
        /// Writes like vbss_device_write, with the force of a virtual coupling. The coupling acts
        /// relative to the pose that was read last; where the workspace limits that pose, it also
        /// limits the coupling. An adapter with its own servo receives the coupling in its frame,
        /// unless forces are off. It then applies the coupling without the host until
        /// `command_timeout` of its output stage has passed. A device gets the force of a tool's
        /// spring in one way only. Use this function with the pose of the tool, or
        /// vbss_device_write with vbss_grasper_state::hand_force. Both at once would be twice the
        /// spring, so this call refuses a command with a force. docs/reference/device-layer.md says
        /// which one suits which device.
        /// </summary>
        /// <param name="now">
        /// the host's clock, s; not before the `now` of an earlier call. If it is earlier or out of
        /// range, the call returns an error and switches all outputs off
        /// </param>
        /// <param name="command">
        /// the other wanted outputs, torque in the world's frame; its force must be 0.
        /// vbss_device_coupling::force has other forces than that of the spring
        /// </param>
        /// <param name="coupling">pose of the tool and the coupling to the hand, in the world's frame</param>
        public OutputResult WriteCoupled(double now, OutputCommand command, DeviceCoupling coupling)
        {
            using (Pins pins = Pins.Rent())
            {
                OutputResult result;
                Context.Check(Native.vbss_device_write_coupled(Handle, now, command == null ? null : command.Pin(pins), coupling == null ? null : coupling.Pin(pins), &result, (uint)sizeof(OutputResult)));
                return result;
            }
        }

        /// <summary>
        /// Emergency stop: writes zeros at once and latches. All outputs stay off until
        /// vbss_device_clear_emergency_stop.
        /// </summary>
        public void LatchEmergencyStop()
        {
            Context.Check(Native.vbss_device_latch_emergency_stop(Handle));
        }

        /// <summary>
        /// Clears the emergency stop. Forces rise from zero. If its cause persists, the next read
        /// latches it again.
        /// </summary>
        public void ClearEmergencyStop()
        {
            Context.Check(Native.vbss_device_clear_emergency_stop(Handle));
        }

        /// <summary>
        /// Holds or releases the clutch. While it is held, the pose stays and the hand moves
        /// freely. After the release the pose follows the hand from where it stayed.
        /// </summary>
        /// <param name="held">1: hold, 0: release; no effect if it is already so</param>
        public void SetClutch(int held)
        {
            Context.Check(Native.vbss_device_set_clutch(Handle, held));
        }

        /// <summary>
        /// Shifts and turns the calibrated pose so that the last sample corresponds to a given
        /// pose, and releases the clutch.
        /// </summary>
        /// <param name="position">position of the tool, world, m, each coordinate at most 1e3 in magnitude; NULL keeps it</param>
        /// <param name="orientation">quaternion w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps it</param>
        public void Recentre(Vector3d? position, Quaterniond? orientation)
        {
            Vector3d positionValue = position.GetValueOrDefault();
            Quaterniond orientationValue = orientation.GetValueOrDefault();
            Context.Check(Native.vbss_device_recentre(Handle, position.HasValue ? (double*)&positionValue : null, orientation.HasValue ? (double*)&orientationValue : null));
        }

        /// <summary>
        /// Holds the opening that reads report until the handle has passed it, or has come within
        /// 0.04 of it. A host calls this when the jaws and the handle differ, for example after it
        /// has restored a scene.
        /// </summary>
        /// <param name="opening">opening of the jaws, 0 (closed) to 1 (open)</param>
        public void HoldJaw(double opening)
        {
            Context.Check(Native.vbss_device_hold_jaw(Handle, opening));
        }

        /// <summary>
        /// Replaces the calibration from the next read on. The call resets the shifts of the clutch
        /// and of vbss_device_recentre and the filter of the opening.
        /// </summary>
        /// <param name="calibration">the calibration; NULL for the defaults</param>
        public void SetCalibration(DeviceCalibration calibration = null)
        {
            using (Pins pins = Pins.Rent())
            {
                Context.Check(Native.vbss_device_set_calibration(Handle, calibration == null ? null : calibration.Pin(pins)));
            }
        }

        /// <summary>Returns the capabilities of the hardware.</summary>
        /// <param name="which">
        /// 0 or 1: capabilities that the first or second adapter reports; 2: both together, within
        /// the limits of the configuration
        /// </param>
        public DeviceCapabilities GetCapabilities(uint which)
        {
            using (Pins pins = Pins.Rent())
            {
                var capabilities = new DeviceCapabilities();
                Context.Check(Native.vbss_device_get_capabilities(Handle, which, capabilities == null ? null : capabilities.Pin(pins), (uint)sizeof(DeviceCapabilitiesData)));
                return capabilities;
            }
        }

        /// <summary>Returns the last failure of an adapter.</summary>
        /// <param name="which">0 or 1: the first or second adapter</param>
        /// <param name="resultResult">the result of its function, VBSS_OK when nothing has failed yet; may be NULL</param>
        /// <param name="textResult">
        /// its explanation, never NULL, valid until the next call that reads, writes or restores
        /// the device; the argument may be NULL
        /// </param>
        public void GetError(uint which, out Result resultResult, out string textResult)
        {
            Result result;
            byte* text;
            Context.Check(Native.vbss_device_get_error(Handle, which, (Result*)&result, &text));
            resultResult = result;
            textResult = Vblast.Text((IntPtr)text);
        }

        /// <summary>Returns the input statistics of a device.</summary>
        public DeviceStatistics GetStatistics()
        {
            DeviceStatistics statistics;
            Context.Check(Native.vbss_device_get_statistics(Handle, &statistics, (uint)sizeof(DeviceStatistics)));
            return statistics;
        }

        /// <summary>Returns the statistics of the device's output stage.</summary>
        public OutputStatistics GetOutputStatistics()
        {
            OutputStatistics statistics;
            Context.Check(Native.vbss_device_get_output_statistics(Handle, &statistics, (uint)sizeof(OutputStatistics)));
            return statistics;
        }

        /// <summary>Returns a hash of the device layer; equal histories give equal hashes on every machine.</summary>
        public ulong GetHash()
        {
            ulong hash;
            Context.Check(Native.vbss_device_get_hash(Handle, (ulong*)&hash));
            return hash;
        }
    }
}
