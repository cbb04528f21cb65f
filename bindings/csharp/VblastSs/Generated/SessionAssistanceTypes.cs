// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>
    /// Bits of the aids. "Along the direction" means: by the component of the hand's movement along
    /// vbss_session_assistance.direction.
    /// </summary>
    [Flags]
    public enum SessionAidBits : uint
    {
        /// <summary>
        /// A hand that holds the needle turns it about the centre of its arc and moves it in no
        /// other way. Movement along the direction drives the tip forward by the same length of
        /// arc. Turns of the hand are ignored. Acts before the first throw.
        /// </summary>
        Arc = 1,
        /// <summary>
        /// A hand that holds the needle goes round the jaws of the other tool. Movement along the
        /// direction winds in the sense that the next throw needs. The radius stays, between 8 mm
        /// and 45 mm. Turns of the hand turn the tool as without the aid. Acts in the phases of
        /// throws.
        /// </summary>
        Wind = 2,
        /// <summary>
        /// The roll of each tool about its shaft is the nearest multiple of `roll_step` from the
        /// roll in which the jaws open along the slit.
        /// </summary>
        SnapRoll = 4,
        /// <summary>Each step of the session is `pace` times as long as the host asks for.</summary>
        SlowMotion = 8,
        /// <summary>
        /// A hand that sinks slower than `sink_speed` leaves its tool at the same height, for arms
        /// without support.
        /// </summary>
        Hover = 16,
        /// <summary>
        /// The tool and the jaws of a hand that has moved less than `hold_distance` for `hold_time`
        /// stay where they are, until the hand leaves this distance.
        /// </summary>
        AutoHold = 32,
        /// <summary>All aids.</summary>
        All = 63,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct SessionAssistanceData
    {
        internal uint StructSize;
        internal SessionAidBits Aids;
        internal double Pace;
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
        public double Pace
        {
            get { return box[0].Pace; }
            set { box[0].Pace = value; }
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
