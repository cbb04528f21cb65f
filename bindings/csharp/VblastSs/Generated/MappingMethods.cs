// Written by bindings/csharp/generate.py from the public headers: do not edit.
namespace VblastSs
{
    /// <summary>Functions of mapping.h that need no object.</summary>
    public static unsafe partial class Mapping
    {
        /// <summary>
        /// Applies a motion of a mouse. It shifts the tool in the plane of the screen and, by the
        /// wheel, in depth. With VBSS_MAPPING_MOUSE_TURN the side of the tool that faces the user
        /// follows the mouse, and the wheel rolls the tool.
        /// </summary>
        /// <param name="config">the mapping; NULL for the defaults</param>
        /// <param name="motion">
        /// counts to the right, counts up, notches of the wheel away from the user; each at most
        /// 1e6
        /// </param>
        /// <param name="buttons">VBSS_MAPPING_MOUSE_ bits</param>
        /// <param name="h">time since the last call, s, 0 to 10</param>
        /// <param name="sample">sample</param>
        public static void Mouse(MappingConfig config, Vector3d motion, uint buttons, double h, DeviceSample sample)
        {
            using (Pins pins = Pins.Rent())
            {
                Vblast.Check(Native.vbss_mapping_mouse(config == null ? null : config.Pin(pins), (double*)&motion, buttons, h, sample == null ? null : sample.Pin(pins)));
            }
        }

        /// <summary>Applies presses of keys.</summary>
        /// <param name="config">the mapping; NULL for the defaults</param>
        /// <param name="presses">
        /// presses since the last call, negative for the opposite key: right, up, towards the user,
        /// turns about these three, opening; each at most 1e6
        /// </param>
        /// <param name="h">time since the last call, s, 0 to 10</param>
        /// <param name="sample">sample</param>
        public static void Keyboard(MappingConfig config, Doubles7 presses, double h, DeviceSample sample)
        {
            using (Pins pins = Pins.Rent())
            {
                Vblast.Check(Native.vbss_mapping_keyboard(config == null ? null : config.Pin(pins), (double*)&presses, h, sample == null ? null : sample.Pin(pins)));
            }
        }

        /// <summary>Applies the state of a gamepad: its axes set rates, with a dead zone and a curve.</summary>
        /// <param name="config">the mapping; NULL for the defaults</param>
        /// <param name="axes">
        /// -1 to 1: right, up, towards the user, turns about these three; larger values count as
        /// full deflection
        /// </param>
        /// <param name="opening">opening of the jaws, 0 to 1, such as the value of a trigger</param>
        /// <param name="h">time since the last call, s, 0 to 10</param>
        /// <param name="sample">sample</param>
        public static void Gamepad(MappingConfig config, Doubles6 axes, double opening, double h, DeviceSample sample)
        {
            using (Pins pins = Pins.Rent())
            {
                Vblast.Check(Native.vbss_mapping_gamepad(config == null ? null : config.Pin(pins), (double*)&axes, opening, h, sample == null ? null : sample.Pin(pins)));
            }
        }
    }
}
