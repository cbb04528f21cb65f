// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_mock_fault; t0: start of the fault, v: its value.</summary>
    public enum MockFault : int
    {
        /// <summary>
        /// A NaN in the position (v = 0), orientation (1), velocity (2), jaw and jaw_raw (3), or
        /// time (4).
        /// </summary>
        Nan = 1,
        /// <summary>Each read repeats the sample of t0.</summary>
        Stall = 2,
        /// <summary>Reads and writes fail, with VBSS_DEVICE_FLAG_LOST.</summary>
        Disconnect = 3,
        /// <summary>Only one new sample every v s.</summary>
        Rate = 4,
        /// <summary>Samples of v s ago.</summary>
        Late = 5,
        /// <summary>In every second interval of v s, samples of v s ago, so that their order is broken.</summary>
        Shuffle = 6,
        /// <summary>Orientations of length v.</summary>
        Norm = 7,
        /// <summary>The x coordinate is larger by v m.</summary>
        Jump = 8,
        /// <summary>A temperature of v.</summary>
        Temperature = 9,
        /// <summary>A raw opening of v, like that of a broken wire.</summary>
        Jaw = 10,
        /// <summary>VBSS_DEVICE_FLAG_STOP.</summary>
        Stop = 11,
        /// <summary>VBSS_DEVICE_FLAG_FAULT.</summary>
        Refusal = 12,
        /// <summary>Reads fail.</summary>
        ReadFails = 13,
        /// <summary>Writes fail.</summary>
        WriteFails = 14,
    }

    /// <summary>The constants of vbss_mock_field.</summary>
    public enum MockField : int
    {
        /// <summary>
        /// (n x 9) F64: now, force, torque, solenoid, flags of each write since
        /// vbss_mock_clear_rows.
        /// </summary>
        Rows = 1,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct MockConfigData
    {
        internal uint StructSize;
        internal uint FaultCapacity;
        internal uint RowCapacity;
        internal uint Reserved;
        internal IntPtr Measure;
        internal IntPtr User;
        internal IntPtr Capabilities;
    }

    /// <summary>Configuration of a mock. Fill it with vbss_mock_config_init, then change fields.</summary>
    public sealed unsafe partial class MockConfig
    {
        private readonly MockConfigData[] box = new MockConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public MockConfig()
        {
            fixed (MockConfigData* data = box)
            {
                Vblast.Check(Native.vbss_mock_config_init(data, (uint)sizeof(MockConfigData)));
            }
        }

        /// <summary>Largest number of faults, 0 to 4096; default 16.</summary>
        public uint FaultCapacity
        {
            get { return box[0].FaultCapacity; }
            set { box[0].FaultCapacity = value; }
        }

        /// <summary>Largest number of stored rows, one for each write, 0 to 2^20; default 1024.</summary>
        public uint RowCapacity
        {
            get { return box[0].RowCapacity; }
            set { box[0].RowCapacity = value; }
        }

        /// <summary>
        /// Capabilities; NULL (default): 6 and 3 degrees of freedom, 3.3 N, 400 N/m, 4 N s/m, 1
        /// kHz, a box of 0.15 m, all signals and outputs. The library copies them.
        /// </summary>
        public DeviceCapabilities Capabilities { get; set; }

        internal MockConfigData* Pin(Pins pins)
        {
            ref MockConfigData data = ref box[0];
            data.Capabilities = Capabilities == null ? IntPtr.Zero : (IntPtr)Capabilities.Pin(pins);
            PinCallbacks(pins);
            return (MockConfigData*)pins.Array(box);
        }

        partial void PinCallbacks(Pins pins);
    }

    /// <summary>Counters of a mock.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct MockStatistics
    {
        internal uint StructSize;
        /// <summary>1: the mock is open.</summary>
        public int Open;
        /// <summary>Number of calls that opened it.</summary>
        public ulong Opens;
        /// <summary>Number of reads.</summary>
        public ulong Reads;
        /// <summary>Number of writes, also those that failed.</summary>
        public ulong Writes;
        /// <summary>Rows beyond row_capacity.</summary>
        public ulong RowsLost;
    }
}
