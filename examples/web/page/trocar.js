// A tool through a port in the wall of the belly: the hand has its place and its roll, and the port turns the shaft.
import { cross, multiply, rotate } from './pose.js';

export const PORTS = [[-0.12, -0.015, 0.08], [0.12, -0.06, 0.1]]; // m, of the left and the right tool; the left one is the scripted surgeon's
const NEAREST = 0.02; // m, of the tip to the port

// The shortest turn of `orientation` (w, x, y, z) after which the tool's z, along its shaft, points from its tip to the port. The tip
// keeps off the port.
export function throughPort(port, tip, orientation) {
  const to = port.map((n, i) => n - tip[i]);
  const far = Math.hypot(...to);
  if (far < NEAREST) return null;
  const wanted = to.map(n => n / far), shaft = rotate(orientation, [0, 0, 1]);
  const dot = shaft.reduce((sum, n, i) => sum + n * wanted[i], 0);
  if (dot < -0.9999) return null; // turned back: no turn is the shortest
  const turn = [1 + dot, ...cross(shaft, wanted)];
  const size = Math.hypot(...turn);
  return multiply(turn.map(n => n / size), orientation);
}
