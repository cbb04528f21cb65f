// Vectors, quaternions (w, x, y, z) and matrices (column by column), as few as a headset needs.
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export function multiply([a, b, c, d], [e, f, g, h]) {
  return [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e];
}

export const conjugate = ([w, x, y, z]) => [w, -x, -y, -z];

export function rotate(q, v) {
  const u = [q[1], q[2], q[3]];
  const t = cross(u, v).map(n => 2 * n);
  const s = cross(u, t);
  return v.map((n, i) => n + q[0] * t[i] + s[i]);
}

export function product(a, b) {
  const m = new Float32Array(16);
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      for (let k = 0; k < 4; k++) m[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    }
  }
  return m;
}

// A perspective view whose picture reaches so far to each side: the tangent of half the angle.
export function widen(seen, slope) {
  const m = Float32Array.from(seen);
  for (const row of [0, 1]) {
    const size = slope * Math.hypot(m[row], m[4 + row], m[8 + row]);
    for (let column = 0; column < 4; column++) m[4 * column + row] /= size;
  }
  return m;
}

// Where the scene is in the room: its point `target` at `place`, turned about the vertical, `scale` times as large. The scene's z
// is up, the room's y; the scene's y leads away from the one who looks along the room's -z.
export class Placement {
  constructor(target, place, turn, scale) {
    Object.assign(this, { target: Array.from(target), place, scale });
    const half = Math.SQRT1_2;
    this.turned = multiply([Math.cos(0.5 * turn), 0, Math.sin(0.5 * turn), 0], [half, -half, 0, 0]);
  }

  toScene(point) {
    const offset = point.map((n, i) => (n - this.place[i]) / this.scale);
    return rotate(conjugate(this.turned), offset).map((n, i) => n + this.target[i]);
  }

  orientationToScene(q) {
    return multiply(conjugate(this.turned), q);
  }

  // From the scene to the room.
  matrix() {
    const m = new Float32Array(16);
    for (let i = 0; i < 3; i++) {
      const axis = rotate(this.turned, [0, 1, 2].map(k => (k === i ? this.scale : 0)));
      m.set(axis, 4 * i);
    }
    const centre = rotate(this.turned, this.target);
    m.set([0, 1, 2].map(i => this.place[i] - this.scale * centre[i]), 12);
    m[15] = 1;
    return m;
  }
}
