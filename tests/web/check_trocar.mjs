// A tool through a port (trocar.js).
//
//     node check_trocar.mjs TROCAR.js
import assert from 'node:assert'
import { pathToFileURL } from 'node:url'

const { PORTS, throughPort } = await import(pathToFileURL(process.argv[2]))

function turn([w, x, y, z], v) {
  const across = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
  const t = across([x, y, z], v).map(n => 2 * n)
  return v.map((n, i) => n + w * t[i] + across([x, y, z], t)[i])
}

let seed = 1
const random = () => { seed = (1103515245 * seed + 12345) % 2147483648; return seed / 1073741824 - 1 }
for (let i = 0; i < 500; i++) {
  const port = PORTS[i % 2], tip = [0.04 * random(), 0.04 * random(), 0.02 * random()]
  const q = [random(), random(), random(), random()], size = Math.hypot(...q)
  const unit = q.map(n => n / size)
  const turned = throughPort(port, tip, unit)
  const shaft = turn(turned ?? unit, [0, 0, 1])
  const to = port.map((n, k) => n - tip[k]), far = Math.hypot(...to)
  if (turned === null) {
    assert(shaft.reduce((sum, n, k) => sum + n * to[k], 0) / far < -0.999, 'refused')
    continue
  }
  shaft.forEach((n, k) => assert(Math.abs(n - to[k] / far) < 1e-9, 'beside the port'))
  assert(Math.abs(Math.hypot(...turned) - 1) < 1e-12)
  // The shortest turn: a tool that points there already is not turned, and a roll about its shaft stays.
  throughPort(port, tip, turned).forEach((n, k) => assert(Math.abs(n - turned[k]) < 1e-12, 'turned again'))
  const half = 0.3, rolled = [Math.cos(half), 0, 0, Math.sin(half)]
  const [a, b, c, d] = turned, [e, , , h] = rolled
  const more = [a * e - d * h, b * e + c * h, c * e - b * h, a * h + d * e]
  throughPort(port, tip, more).forEach((n, k) => assert(Math.abs(n - more[k]) < 1e-9, 'the roll is lost'))
}
assert.equal(throughPort(PORTS[0], PORTS[0].map(n => n + 0.001), [1, 0, 0, 0]), null, 'the tip is in the port')
console.log('a tool through a port: the shaft goes through it, its roll stays')
