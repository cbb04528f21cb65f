// Matrices of the page (pose.js).
//
//     node check_pose.mjs POSE.js
import assert from 'node:assert'
import { pathToFileURL } from 'node:url'

const { product, widen } = await import(pathToFileURL(process.argv[2]))

// A perspective of slope 0.7 and aspect 2 after a view that is turned and moved.
const lens = [1 / 1.4, 0, 0, 0, 0, 1 / 0.7, 0, 0, 0, 0, -1.02, -1, 0, 0, -0.01, 0]
const [c, s] = [Math.cos(0.4), Math.sin(0.4)]
const view = [c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0.01, -0.02, -0.1, 1]
const seen = product(lens, view), wide = widen(seen, 1.6)
const clip = (m, p) => [0, 1, 2, 3].map(row => [...p, 1].reduce((sum, n, column) => sum + m[4 * column + row] * n, 0))
for (const point of [[0.05, 0.03, 0.02], [-0.1, 0.08, -0.3], [0.3, -0.2, 0]]) {
  const [x, y, z, w] = clip(seen, point), [u, v, depth, far] = clip(wide, point)
  assert(Math.abs(u - x * 1.4 / 1.6) < 1e-6 && Math.abs(v - y * 0.7 / 1.6) < 1e-6, 'the slope')
  assert(Math.abs(z - depth) < 1e-6 && Math.abs(w - far) < 1e-6, 'depths have changed')
}
console.log('a view made wider has its slope, and its depths')
