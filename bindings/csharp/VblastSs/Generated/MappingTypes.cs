// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>Bits for the buttons of a mouse.</summary>
    [Flags]
    public enum MappingMouseBits : uint
    {
        /// <summary>Movements of the mouse turn the tool instead of shifting it.</summary>
        Turn = 1,
        /// <summary>The jaws close; otherwise they open.</summary>
        Close = 2,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct MappingConfigData
    {
        internal uint StructSize;
        internal uint PadCurve;
        internal Vector3d Right;
        internal Vector3d Up;
        internal Vector3d Low;
        internal Vector3d High;
        internal double MouseMetres;
        internal double MouseDepth;
        internal double MouseRadians;
        internal double MouseRoll;
        internal double JawRate;
        internal double KeyMetres;
        internal double KeyRadians;
        internal double KeyJaw;
        internal double PadSpeed;
        internal double PadTurning;
        internal double PadDead;
    }

    /// <summary>
    /// Mapping from mouse, keyboard or gamepad to a pose. Fill it with vbss_mapping_config_init,
    /// then change fields. Rotations are about axes of the pose's frame.
    /// </summary>
    public sealed unsafe partial class MappingConfig
    {
        private readonly MappingConfigData[] box = new MappingConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public MappingConfig()
        {
            fixed (MappingConfigData* data = box)
            {
                Vblast.Check(Native.vbss_mapping_config_init(data, (uint)sizeof(MappingConfigData)));
            }
        }

        /// <summary>Gamepad: power of the deflection, 1 to 4; default 2.</summary>
        public uint PadCurve
        {
            get { return box[0].PadCurve; }
            set { box[0].PadCurve = value; }
        }

        /// <summary>Direction to the right of the screen, unit to 1e-6; default x.</summary>
        public Vector3d Right
        {
            get { return box[0].Right; }
            set { box[0].Right = value; }
        }

        /// <summary>
        /// Direction to the top of the screen, normal to `right`; default y. Right x up points
        /// towards the user.
        /// </summary>
        public Vector3d Up
        {
            get { return box[0].Up; }
            set { box[0].Up = value; }
        }

        /// <summary>Lower corner of the box to which positions are confined, m; default -0.1.</summary>
        public Vector3d Low
        {
            get { return box[0].Low; }
            set { box[0].Low = value; }
        }

        /// <summary>Upper corner of the box, m, each coordinate at most 1e3 in magnitude; default 0.1.</summary>
        public Vector3d High
        {
            get { return box[0].High; }
            set { box[0].High = value; }
        }

        /// <summary>Mouse: metres per count; default 1e-4.</summary>
        public double MouseMetres
        {
            get { return box[0].MouseMetres; }
            set { box[0].MouseMetres = value; }
        }

        /// <summary>Mouse: metres away from the user per notch of the wheel; default 2e-3.</summary>
        public double MouseDepth
        {
            get { return box[0].MouseDepth; }
            set { box[0].MouseDepth = value; }
        }

        /// <summary>Mouse, turning: rad per count; default 5e-3.</summary>
        public double MouseRadians
        {
            get { return box[0].MouseRadians; }
            set { box[0].MouseRadians = value; }
        }

        /// <summary>Mouse, turning: rad about the direction of depth per notch; default 0.1.</summary>
        public double MouseRoll
        {
            get { return box[0].MouseRoll; }
            set { box[0].MouseRoll = value; }
        }

        /// <summary>Mouse: speed at which the jaws close and open, 1/s, 0 to 1e3; default 4.</summary>
        public double JawRate
        {
            get { return box[0].JawRate; }
            set { box[0].JawRate = value; }
        }

        /// <summary>Keyboard: metres per press; default 1e-3.</summary>
        public double KeyMetres
        {
            get { return box[0].KeyMetres; }
            set { box[0].KeyMetres = value; }
        }

        /// <summary>Keyboard: rad per press; default 0.05.</summary>
        public double KeyRadians
        {
            get { return box[0].KeyRadians; }
            set { box[0].KeyRadians = value; }
        }

        /// <summary>Keyboard: change of the opening per press; default 0.1.</summary>
        public double KeyJaw
        {
            get { return box[0].KeyJaw; }
            set { box[0].KeyJaw = value; }
        }

        /// <summary>Gamepad: m/s at full deflection; default 0.1.</summary>
        public double PadSpeed
        {
            get { return box[0].PadSpeed; }
            set { box[0].PadSpeed = value; }
        }

        /// <summary>Gamepad: rad/s at full deflection; default 1.</summary>
        public double PadTurning
        {
            get { return box[0].PadTurning; }
            set { box[0].PadTurning = value; }
        }

        /// <summary>Gamepad: deflection that counts as zero, 0 to 0.9; default 0.15.</summary>
        public double PadDead
        {
            get { return box[0].PadDead; }
            set { box[0].PadDead = value; }
        }

        internal MappingConfigData* Pin(Pins pins)
        {
            return (MappingConfigData*)pins.Array(box);
        }
    }
}
