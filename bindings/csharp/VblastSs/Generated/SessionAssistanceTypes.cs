// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    [StructLayout(LayoutKind.Sequential)]
    internal struct SessionAssistanceData
    {
        internal uint StructSize;
        internal SessionAidBits Aids;
        internal double TimeScale;
        internal Vector3d Direction;
        internal double RollStep;
        internal double SinkSpeed;
        internal double HoldDistance;
        internal double HoldTime;
    }

    /// <summary>Assistance of a session. Fill it with vbss_session_assistance_init, then change fields.</summary>
    public sealed unsafe partial class SessionAssistance
    {
        private readonly SessionAssistanceData[] box = new SessionAssistanceData[1];

        /// <summary>The defaults of the library.</summary>
        public SessionAssistance()
        {
            fixed (SessionAssistanceData* data = box)
            {
                Vblast.Check(Native.vbss_session_assistance_init(data, (uint)sizeof(SessionAssistanceData)));
            }
        }

        /// <summary>VBSS_SESSION_AID_ bits of the aids that are on; default 0.</summary>
        public SessionAidBits Aids
        {
            get { return box[0].Aids; }
            set { box[0].Aids = value; }
        }

        /// <summary>Simulated time per time of the host, 0.25 to 1; default 0.5.</summary>
        public double TimeScale
        {
            get { return box[0].TimeScale; }
            set { box[0].TimeScale = value; }
        }

        /// <summary>
        /// Direction of ARC and WIND, of any length from 1e-9 to 1e3. Default 0, 0, 0: from the
        /// first mark of the stitch to the second one.
        /// </summary>
        public Vector3d Direction
        {
            get { return box[0].Direction; }
            set { box[0].Direction = value; }
        }

        /// <summary>Step of the roll, rad, 0.01 to 3.2; default pi / 4.</summary>
        public double RollStep
        {
            get { return box[0].RollStep; }
            set { box[0].RollStep = value; }
        }

        /// <summary>Speed below which a hand sinks unintentionally, m/s, 0 to 1; default 4e-3.</summary>
        public double SinkSpeed
        {
            get { return box[0].SinkSpeed; }
            set { box[0].SinkSpeed = value; }
        }

        /// <summary>Distance within which a hand rests, m, 0 to 1; default 2e-3.</summary>
        public double HoldDistance
        {
            get { return box[0].HoldDistance; }
            set { box[0].HoldDistance = value; }
        }

        /// <summary>Time after which a hand that rests is idle, s, 0 to 10; default 0.7.</summary>
        public double HoldTime
        {
            get { return box[0].HoldTime; }
            set { box[0].HoldTime = value; }
        }

        internal SessionAssistanceData* Pin(Pins pins)
        {
            return (SessionAssistanceData*)pins.Array(box);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct SessionHandData
    {
        internal uint StructSize;
        internal uint IsOrigin;
        internal Vector3d Position;
        internal Quaterniond Orientation;
        internal double Opening;
    }

    /// <summary>Input of a hand. Fill it with vbss_session_hand_init, then set its fields.</summary>
    public sealed unsafe partial class SessionHand
    {
        private readonly SessionHandData[] box = new SessionHandData[1];

        /// <summary>The defaults of the library.</summary>
        public SessionHand()
        {
            fixed (SessionHandData* data = box)
            {
                Vblast.Check(Native.vbss_session_hand_init(data, (uint)sizeof(SessionHandData)));
            }
        }

        /// <summary>
        /// 1: the hand is now at this pose and its tool does not move: later movements start here.
        /// `opening` is ignored. Default 0.
        /// </summary>
        public uint IsOrigin
        {
            get { return box[0].IsOrigin; }
            set { box[0].IsOrigin = value; }
        }

        /// <summary>Position of the tool's tip, m, each coordinate at most 1e3 in magnitude.</summary>
        public Vector3d Position
        {
            get { return box[0].Position; }
            set { box[0].Position = value; }
        }

        /// <summary>
        /// Orientation of the tool, w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0,
        /// 0, 0.
        /// </summary>
        public Quaterniond Orientation
        {
            get { return box[0].Orientation; }
            set { box[0].Orientation = value; }
        }

        /// <summary>Opening of the handle, 0 (closed) to 1 (open); default 0.</summary>
        public double Opening
        {
            get { return box[0].Opening; }
            set { box[0].Opening = value; }
        }

        internal SessionHandData* Pin(Pins pins)
        {
            return (SessionHandData*)pins.Array(box);
        }
    }
}
