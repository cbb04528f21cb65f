// What left-handed people see and do (mirror.js).
//
//     node check_mirror.mjs MIRROR.js
import assert from 'node:assert'
import { pathToFileURL } from 'node:url'

const { mirrorMessage, mirrorPicture, mirrorScene, mirrorState, mirrorWords } = await import(pathToFileURL(process.argv[2]))

const messages = [
  { name: 'move', side: 1, turns: false, right: 3, up: 4, away: 5 }, { name: 'move', side: 0, turns: true, right: 3, up: 4, away: 5 },
  { name: 'pull', side: 1, axes: [1, 2, 3, 4, 5, 6], grain: 0.5 }, { name: 'close', side: 0, closes: true },
  { name: 'pose', side: 1, position: [1, 2, 3], orientation: [0.1, 0.2, 0.3, 0.4], jaw: 0.5, clutched: false, seconds: 0.01 },
  { name: 'frame', look: { aside: 0.3, down: 0.4, away: 0.1, aspect: 1.5 }, buffers: {} }, { name: 'pause', wanted: true }]
for (const m of messages) {
  assert.deepEqual(mirrorMessage(mirrorMessage(m)), m)
  if (m.name !== 'pause') assert.notDeepEqual(mirrorMessage(m), m)
}
assert.deepEqual(mirrorMessage(messages[0]), { name: 'move', side: 0, turns: false, right: -3, up: 4, away: 5 })
assert.deepEqual(mirrorMessage(messages[2]).axes, [-1, 2, 3, 4, -5, -6])

// A mirrored turn of a mirrored point is the mirrored image of the turned point.
function turn([w, x, y, z], v) {
  const across = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
  const t = across([x, y, z], v).map(n => 2 * n)
  return v.map((n, i) => n + w * t[i] + across([x, y, z], t)[i])
}
const q = [0.5, 0.1, -0.7, 0.5].map(n => n / Math.hypot(0.5, 0.1, 0.7, 0.5))
const mirrored = mirrorMessage({ name: 'pose', side: 0, position: [0, 0, 0], orientation: q })
const [x, ...rest] = turn(q, [1, 2, 3]), [u, ...others] = turn(mirrored.orientation, [-1, 2, 3])
assert([x + u, ...rest.map((n, i) => n - others[i])].every(n => Math.abs(n) < 1e-12))

// Of a matrix and a point: mirrored before, mirrored after.
const matrix = Array.from({ length: 16 }, (_, i) => Math.sin(i + 1))
const times = (m, p) => [0, 1, 2, 3].map(row => p.reduce((sum, n, column) => sum + m[4 * column + row] * n, 0))
assert.deepEqual(times(mirrorScene(matrix), [-1, 2, 3, 1]), times(matrix, [1, 2, 3, 1]))
const [a, ...b] = times(mirrorPicture(matrix), [1, 2, 3, 1]), [c, ...d] = times(matrix, [1, 2, 3, 1])
assert.deepEqual([-a, ...b], [c, ...d])

assert.equal(mirrorWords('With the right tool, turn the left wrist; 3.0 mm are left, hole in left, right-handed'),
  'With the left tool, turn the right wrist; 3.0 mm are left, hole in left, left-handed')
const tool = (n, x) => ({ holds: n, position: [x, 1, 2], target: [x, 1, 2], orientation: q, place: [x, 0] })
const state = mirrorState({ tools: [tool('needle', 1), tool('', 2)], events: [{ words: 'left tool holds the needle' }],
  coach: { goal: 'Open the left tool', mistake: '', remedy: '', point: [1, 2, 3] } })
assert.deepEqual(state.tools.map(t => [t.holds, t.position[0], t.place[0]]), [['', -2, -2], ['needle', -1, -1]])
assert.deepEqual([state.events[0].words, state.coach.goal, state.coach.point], ['right tool holds the needle', 'Open the right tool', [-1, 2, 3]])
console.log('in the mirror: messages, state, words and pictures')
