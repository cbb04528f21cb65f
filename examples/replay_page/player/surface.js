// The wall of a drain: each triangle of a frame becomes four, their new corners on curved sides (Vlachos et al. 2001), as
// lib/visual does it with more.
import { BufferAttribute, BufferGeometry } from 'three';

// Sides of triangles, once each; and the triangles that they make.
function split(triangles, count) {
  const sides = [];
  const middles = new Map();
  const middle = (a, b) => {
    const key = a < b ? a * 65536 + b : b * 65536 + a;
    if (!middles.has(key)) {
      middles.set(key, count + sides.length / 2);
      sides.push(a, b);
    }
    return middles.get(key);
  };
  const parts = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = triangles.subarray(i, i + 3);
    const ab = middle(a, b);
    const bc = middle(b, c);
    const ca = middle(c, a);
    parts.push(a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca);
  }
  return { sides, parts };
}

// Sums of normals of triangles, as long as these are large.
function addNormals(triangles, at, normals) {
  normals.fill(0);
  for (let i = 0; i < triangles.length; i += 3) {
    const a = 3 * triangles[i];
    const b = 3 * triangles[i + 1];
    const c = 3 * triangles[i + 2];
    const ux = at[b] - at[a], uy = at[b + 1] - at[a + 1], uz = at[b + 2] - at[a + 2];
    const vx = at[c] - at[a], vy = at[c + 1] - at[a + 1], vz = at[c + 2] - at[a + 2];
    const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    for (const corner of [a, b, c]) {
      normals[corner] += nx;
      normals[corner + 1] += ny;
      normals[corner + 2] += nz;
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let k = 0; k < 3; k++) normals[i + k] /= length;
  }
}

// Rims have vertices of their own where faces end. So that both stay together when they are curved, a rim's takes the normal
// of the face's that is always at its place.
function findTwins(face, material, frames) {
  const twins = Uint32Array.from(face, (_, i) => i);
  const samples = frames.filter((_, i) => i % Math.ceil(frames.length / 8) === 0);
  const apart = (i, k) => Math.max(...samples.map(p => Math.hypot(p[3 * i] - p[3 * k], p[3 * i + 1] - p[3 * k + 1],
    p[3 * i + 2] - p[3 * k + 2])));
  for (let i = 0; i < face.length; i++) {
    if (Math.abs(face[i]) > 0.5) continue;
    let best = 4; // in hundredths of a millimetre
    for (let k = 0; k < face.length; k++) {
      const near = Math.abs(material[3 * k] - material[3 * i]) + Math.abs(material[3 * k + 1] - material[3 * i + 1]) +
        Math.abs(material[3 * k + 2] - material[3 * i + 2]) < 1e-5;
      if (!near || Math.abs(face[k]) < 0.5) continue;
      const off = apart(i, k);
      if (off < best) {
        best = off;
        twins[i] = k;
      }
    }
  }
  return twins;
}

function withMiddles(values, size, sides) {
  const count = values.length / size;
  const all = new Float32Array(values.length + size * sides.length / 2);
  all.set(values);
  for (let i = 0; i < sides.length / 2; i++) {
    for (let k = 0; k < size; k++) {
      all[size * (count + i) + k] = 0.5 * (values[size * sides[2 * i] + k] + values[size * sides[2 * i + 1] + k]);
    }
  }
  return all;
}

export class Surface {
  // `frames`: places of it in all frames that it is in.
  constructor(triangles, face, material, frames) {
    const count = face.length;
    const { sides, parts } = split(triangles, count);
    this.count = count;
    this.triangles = triangles;
    this.sides = sides;
    this.parts = parts;
    this.twins = findTwins(face, material, frames);
    this.coarse = new Float32Array(3 * count);
    const all = count + sides.length / 2;
    this.geometry = new BufferGeometry();
    this.geometry.setIndex(parts);
    this.geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * all), 3));
    this.geometry.setAttribute('normal', new BufferAttribute(new Float32Array(3 * all), 3));
    this.geometry.setAttribute('matter', new BufferAttribute(withMiddles(material, 3, sides), 3));
    this.geometry.setAttribute('face', new BufferAttribute(withMiddles(face, 1, sides), 1));
  }

  update(places) {
    const at = this.geometry.attributes.position.array;
    const { coarse, twins, sides } = this;
    at.set(places);
    addNormals(this.triangles, places, coarse);
    for (let i = 0; i < sides.length / 2; i++) {
      const a = 3 * sides[2 * i];
      const b = 3 * sides[2 * i + 1];
      const na = 3 * twins[sides[2 * i]];
      const nb = 3 * twins[sides[2 * i + 1]];
      let off = 0;
      let back = 0;
      for (let k = 0; k < 3; k++) {
        off += (places[b + k] - places[a + k]) * coarse[na + k];
        back += (places[a + k] - places[b + k]) * coarse[nb + k];
      }
      for (let k = 0; k < 3; k++) {
        at[3 * (this.count + i) + k] = 0.5 * (places[a + k] + places[b + k]) -
          0.125 * (off * coarse[na + k] + back * coarse[nb + k]);
      }
    }
    addNormals(this.parts, at, this.geometry.attributes.normal.array);
    this.geometry.attributes.position.needsUpdate = true;
    this.geometry.attributes.normal.needsUpdate = true;
  }
}
