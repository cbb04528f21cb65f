// A thread: a tube about a smooth line through the places of a frame.
import { BufferAttribute, BufferGeometry } from 'three';

const SIDES = 8;
const PARTS = 3; // of a segment

const away = (p, i, k) => Math.hypot(p[3 * k] - p[3 * i], p[3 * k + 1] - p[3 * i + 1], p[3 * k + 2] - p[3 * i + 2]);

// Slope at each place, for chords as parameter: of the parabola through it and its neighbours; straight at the ends.
function slopesOf(places, count) {
  const slopes = new Float64Array(3 * count);
  for (let i = 0; i < count; i++) {
    const before = Math.max(i - 1, 0);
    const after = Math.min(i + 1, count - 1);
    const a = Math.max(away(places, before, i), 1e-9);
    const b = Math.max(away(places, i, after), 1e-9);
    for (let k = 0; k < 3; k++) {
      const back = (places[3 * i + k] - places[3 * before + k]) / a;
      const forth = (places[3 * after + k] - places[3 * i + k]) / b;
      slopes[3 * i + k] = before === i ? forth : after === i ? back : (b * back + a * forth) / (a + b);
    }
  }
  return slopes;
}

function smoothed(places, count) {
  const slopes = slopesOf(places, count);
  const line = new Float64Array(3 * (PARTS * (count - 1) + 1));
  for (let i = 0; i + 1 < count; i++) {
    const length = away(places, i, i + 1);
    for (let part = 0; part < PARTS + (i + 2 === count); part++) {
      const t = part / PARTS;
      const at = 3 * (PARTS * i + part);
      for (let k = 0; k < 3; k++) {
        const p = places[3 * i + k];
        const q = places[3 * i + 3 + k];
        const begin = length * slopes[3 * i + k];
        const end = length * slopes[3 * i + 3 + k];
        line[at + k] = p + t * (begin + t * (3 * (q - p) - 2 * begin - end + t * (begin + end - 2 * (q - p))));
      }
    }
  }
  return line;
}

function unit(v) {
  const length = Math.hypot(v[0], v[1], v[2]) || 1;
  return [v[0] / length, v[1] / length, v[2] / length];
}

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export class Tube {
  constructor(radius) {
    this.radius = radius;
    this.rings = 0;
    this.geometry = new BufferGeometry();
  }

  makeRoom(rings) {
    this.rings = rings;
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * SIDES * rings), 3));
    this.geometry.setAttribute('normal', new BufferAttribute(new Float32Array(3 * SIDES * rings), 3));
    const triangles = [];
    for (let ring = 0; ring + 1 < rings; ring++) {
      for (let side = 0; side < SIDES; side++) {
        const a = ring * SIDES + side;
        const b = ring * SIDES + (side + 1) % SIDES;
        triangles.push(a, b, a + SIDES, b, b + SIDES, a + SIDES);
      }
    }
    for (let side = 1; side + 1 < SIDES; side++) { // flat ends
      const last = (rings - 1) * SIDES;
      triangles.push(0, side + 1, side, last, last + side, last + side + 1);
    }
    this.geometry.setIndex(triangles);
  }

  // Sections are carried along without turning about the line.
  update(places, count) {
    const line = smoothed(places, count);
    const rings = line.length / 3;
    if (rings !== this.rings) this.makeRoom(rings);
    const position = this.geometry.attributes.position;
    const normal = this.geometry.attributes.normal;
    let across = null;
    for (let i = 0; i < rings; i++) {
      const before = 3 * Math.max(i - 1, 0);
      const after = 3 * Math.min(i + 1, rings - 1);
      const tangent = unit([0, 1, 2].map(k => line[after + k] - line[before + k]));
      if (across === null) across = Math.abs(tangent[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
      const along = across[0] * tangent[0] + across[1] * tangent[1] + across[2] * tangent[2];
      across = unit(across.map((x, k) => x - along * tangent[k]));
      const second = cross(tangent, across);
      for (let side = 0; side < SIDES; side++) {
        const angle = 2 * Math.PI * side / SIDES;
        const c = Math.cos(angle);
        const s = Math.sin(angle);
        for (let k = 0; k < 3; k++) {
          const out = c * across[k] + s * second[k];
          const at = 3 * (i * SIDES + side) + k;
          normal.array[at] = out;
          position.array[at] = line[3 * i + k] + this.radius * out;
        }
      }
    }
    position.needsUpdate = true;
    normal.needsUpdate = true;
  }
}
