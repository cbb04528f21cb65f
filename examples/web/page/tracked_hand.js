// A hand that a headset tracks, as a controller: from its joints (WebXR Hand Input) the place and the axes of the tool's handle, how
// far the jaws are open, and two gestures. Pure: whoever asks the headset hands the joints in.
import { cross, multiply } from './pose.js';

const TOUCH = 0.015, APART = 0.03; // m, thumb to fingertip: from which on they touch, and have parted
const OPEN = 0.06; // m, thumb to index finger, of jaws that are open
const CURLED = 1.15, STRAIGHT = 1.4; // a fingertip's distance from the wrist, as a share of its knuckle's
const TILT = 0.6; // rad, of the tool below the back of the hand
const KNUCKLE = 'finger-phalanx-proximal';
const CURL = ['middle', 'ring', 'pinky'];
export const JOINTS = ['wrist', 'thumb-tip', 'index-finger-tip', `index-${KNUCKLE}`,
  ...CURL.flatMap(finger => [`${finger}-finger-tip`, `${finger}-${KNUCKLE}`])];

const minus = (a, b) => a.map((n, i) => n - b[i]);
const size = v => Math.hypot(...v);
const unit = v => v.map(n => n / size(v));
const apart = (a, b) => size(minus(a, b));

// On below one number, off above another.
class Hysteresis {
  constructor(on, off) {
    Object.assign(this, { on, off, is: false });
  }

  read(value) {
    this.is = value < (this.is ? this.off : this.on);
    return this.is;
  }
}

// A rotation's quaternion from its axes: x, y, z as columns.
function quaternionOf(x, y, z) {
  const q = [1 + x[0] + y[1] + z[2], 1 + x[0] - y[1] - z[2], 1 - x[0] + y[1] - z[2], 1 - x[0] - y[1] + z[2]].map(n => 0.5 * Math.sqrt(Math.max(0, n)));
  const most = q.indexOf(Math.max(...q)), d = 4 * q[most];
  const [wx, wy, wz] = [y[2] - z[1], z[0] - x[2], x[1] - y[0]], [xy, xz, yz] = [x[1] + y[0], x[2] + z[0], y[2] + z[1]];
  const rows = [[d * q[0], wx, wy, wz], [wx, d * q[1], xy, xz], [wy, xy, d * q[2], yz], [wz, xz, yz, d * q[3]]];
  return rows[most].map(n => n / d);
}

export class TrackedHand {
  constructor(isRight) {
    this.isRight = isRight;
    this.pinch = new Hysteresis(TOUCH, APART);
    this.fist = new Hysteresis(CURLED, STRAIGHT);
    this.little = new Hysteresis(TOUCH, APART);
  }

  // From the wrist to the knuckles; the palm down, as a hand lies on a table.
  axes(at) {
    const knuckles = [at[`index-${KNUCKLE}`], at[`middle-${KNUCKLE}`]];
    const forward = unit(minus(knuckles[0].map((n, i) => 0.5 * (n + knuckles[1][i])), at.wrist));
    const across = minus(at[`index-${KNUCKLE}`], at[`pinky-${KNUCKLE}`]);
    const up = this.isRight ? cross(forward, across) : cross(across, forward);
    const z = forward.map(n => -n);
    const x = unit(cross(up, z));
    return multiply(quaternionOf(x, cross(z, x), z), [Math.cos(0.5 * TILT), -Math.sin(0.5 * TILT), 0, 0]);
  }

  // `at`: joints by name, m; without one of them (null) the hand is not seen. The knuckle of the index finger has the tool: it rests
  // while fingers pinch.
  read(at) {
    if (JOINTS.some(name => !at[name])) return null;
    const thumb = at['thumb-tip'];
    const pinch = apart(thumb, at['index-finger-tip']);
    const closed = this.pinch.read(pinch);
    const reach = CURL.map(finger => apart(at[`${finger}-finger-tip`], at.wrist) / apart(at[`${finger}-${KNUCKLE}`], at.wrist));
    const clutched = this.fist.read(Math.max(...reach));
    const little = this.little.read(apart(thumb, at['pinky-finger-tip']));
    return { position: at[`index-${KNUCKLE}`], orientation: this.axes(at), jaw: closed ? 0 : Math.min(1, Math.max(0, (pinch - TOUCH) / (OPEN - TOUCH))),
      clutched, exchanges: little && !clutched };
  }
}
