// A gamepad of the standard mapping as a hand, as the desktop viewer has it (examples/viewer/pad.c). Pure: whoever polls the pad
// hands its state in.
const DRAWN = 0.5, LET_GO = 0.25; // of a trigger
const DEAD = 0.15; // of a stick
const [A, LEFT_BUMPER, RIGHT_BUMPER, LEFT_TRIGGER, RIGHT_TRIGGER, BACK, START] = [0, 4, 5, 6, 7, 8, 9];

const stick = value => (Math.abs(value) < DEAD ? 0 : (value - Math.sign(value) * DEAD) / (1 - DEAD));

export class Pad {
  constructor() {
    this.down = {};
    this.known = false;
  }

  // Sticks point down with positive numbers, and back to the user. What is down in the first state does not count until it was up.
  read(now) {
    if (!now) {
      this.known = false;
      return { axes: [0, 0, 0, 0, 0, 0], isFine: false, pressed: {} };
    }
    const isDown = button => Boolean(now.buttons[button] && now.buttons[button].pressed);
    const value = button => (now.buttons[button] ? now.buttons[button].value : 0);
    const [right, down, roll, depth] = now.axes.map(stick);
    const axes = isDown(LEFT_BUMPER) ? [0, 0, depth, down, right, roll] : [right, -down, depth, 0, 0, roll];
    const held = { jaws: isDown(A) || value(RIGHT_TRIGGER) > (this.down.jaws ? LET_GO : DRAWN), other: isDown(RIGHT_BUMPER),
      pause: isDown(START), help: isDown(BACK) };
    const pressed = Object.fromEntries(Object.entries(held).map(([name, is]) => [name, this.known && is && !this.down[name]]));
    this.down = held;
    this.known = true;
    return { axes, isFine: value(LEFT_TRIGGER) > DRAWN, pressed };
  }
}
