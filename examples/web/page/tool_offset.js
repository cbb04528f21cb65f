// Where a tool is in the hand that leads it: its tip so far ahead of the controller, and its shaft turned down from where that
// points. The settings have both numbers of each hand; in a headset a press of the thumbstick begins and ends their adjustment.
import { multiply, rotate } from './pose.js';

// mm; degrees down.
export const LENGTH = { usual: 120, least: 0, most: 300 }, PITCH = { usual: 0, least: -60, most: 60 };
const DEAD = 0.3; // of the thumbstick
const LONGER = 50, STEEPER = 20; // mm/s, degrees/s, at the end of the thumbstick

// The pose of a tool, tip and orientation, from its controller's: m, quaternion w, x, y, z.
export function toolPose({ position, orientation }, { length, pitch }) {
  const half = 0.5 * pitch * Math.PI / 180;
  const turned = multiply(orientation, [Math.cos(half), -Math.sin(half), 0, 0]);
  const ahead = rotate(turned, [0, 0, -1e-3 * length]);
  return { position: position.map((n, i) => n + ahead[i]), orientation: turned };
}

export class ToolOffset {
  // Of `hand`: left or right. `settings` has the numbers and put(name, value), keep().
  constructor(settings, hand) {
    Object.assign(this, { settings, hand, isAdjusted: false, pressed: false });
  }

  get length() {
    return this.settings[`${this.hand}Length`];
  }

  get pitch() {
    return this.settings[`${this.hand}Pitch`];
  }

  // What the thumbstick says, in each frame: pressed or not, its axes to the right and back.
  read(isDown, axes, seconds) {
    if (isDown && !this.pressed) {
      if (this.isAdjusted) this.settings.keep();
      this.isAdjusted = !this.isAdjusted;
    }
    this.pressed = isDown;
    if (!this.isAdjusted || !axes) return;
    const [right, away] = [axes[2], -axes[3]].map(n => (Math.abs(n) > DEAD ? n : 0));
    if (away !== 0) this.settings.put(`${this.hand}Length`, this.length + LONGER * seconds * away);
    if (right !== 0) this.settings.put(`${this.hand}Pitch`, this.pitch + STEEPER * seconds * right);
  }

  end() {
    if (this.isAdjusted) this.settings.keep();
    this.isAdjusted = this.pressed = false;
  }

  // For the panel.
  words() {
    const turned = `${Math.abs(this.pitch).toFixed(0)}\u00b0 ${this.pitch < 0 ? 'up' : 'down'}`;
    return `${this.hand} hand: the tip is ${this.length.toFixed(0)} mm ahead, turned ${turned}. ` +
      'Stick away and back: length; right and left: down and up; press it: done.';
  }
}
