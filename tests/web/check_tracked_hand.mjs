// A tracked hand (tracked_hand.js) of made-up joints: pose, jaws, gestures.
//
//     node check_tracked_hand.mjs TRACKED_HAND.js
import assert from 'node:assert'
import fs from 'node:fs'
import path from 'node:path'
import vm from 'node:vm'
import { pathToFileURL } from 'node:url'

const { JOINTS, TrackedHand } = await import(pathToFileURL(process.argv[2]))
const window = {}
vm.runInNewContext(fs.readFileSync(path.join(import.meta.dirname ?? path.dirname(process.argv[1]), 'stand_in_hand.js'), 'utf8'), { window, Math })
const { jointsOf, turn } = window.standInHand
const near = (a, b, most, words) => assert([...a].every((n, i) => Math.abs(n - b[i]) < most), `${words}: ${[...a]}, not ${b}`)

function read(reader, state, handedness) {
  const joints = jointsOf({ position: [0, 0, 0], orientation: [1, 0, 0, 0], pinch: 0.06, fist: 0, little: false, ...state }, handedness)
  return reader.read(Object.fromEntries(JOINTS.map(name => [name, joints[name]])))
}

// The palm down, fingers along -z: the tool points ahead and down, and its y is up; a turned hand turns it.
for (const handedness of ['left', 'right']) {
  const reader = new TrackedHand(handedness === 'right')
  const level = read(reader, {}, handedness)
  const ahead = turn(level.orientation, [0, 0, -1])
  assert(ahead[2] < -0.7 && ahead[1] < -0.4 && Math.abs(ahead[0]) < 0.2, `${handedness}: ${[...ahead]}`)
  for (const q of [[0.8, 0, 0.6, 0], [0.6, 0.8, 0, 0], [0.5, 0.5, -0.5, 0.5], [0, 0, 1, 0], [0, 0, 0, 1], [0.1, 0.7, 0.1, 0.7].map(n => n)]) {
    const unit = q.map(n => n / Math.hypot(...q))
    const turned = read(reader, { orientation: unit, position: [1, 2, 3] }, handedness)
    for (const v of [[0, 0, -1], [0, 1, 0]]) near(turn(turned.orientation, v), turn(unit, turn(level.orientation, v)), 1e-6, `${handedness} turned by ${q}`)
    near(turned.position.map((n, i) => n - [1, 2, 3][i]), turn(unit, level.position), 1e-6, 'place')
  }
}

// Jaws: what the fingers do between the two thresholds depends on where they come from.
const reader = new TrackedHand(true)
const jaws = [0.06, 0.04, 0.02, 0.012, 0.02, 0.028, 0.032, 0.02].map(pinch => read(reader, { pinch }, 'right').jaw)
assert(Math.abs(jaws[0] - 1) < 1e-9)
assert(jaws[1] < 1 && jaws[2] < jaws[1] && jaws[2] > 0, `${jaws}`)
assert.deepEqual(jaws.slice(3, 6), [0, 0, 0], 'closed until the fingers have parted')
assert(jaws[6] > 0.3 && jaws[7] > 0, `${jaws}`)
const [open, closed] = [0.06, 0].map(pinch => read(reader, { pinch }, 'right'))
near(open.position, closed.position, 1e-9, 'a pinch moves the tool')
near(open.orientation, closed.orientation, 1e-9, 'a pinch turns the tool')

// A fist of the other fingers is the clutch, with hysteresis too; the little finger at the thumb exchanges the tool.
assert.deepEqual([0, 0.45, 1, 0.45, 0].map(fist => read(reader, { fist }, 'right').clutched), [false, false, true, true, false])
assert.equal(read(reader, { fist: 1, pinch: 0 }, 'right').jaw, 0)
assert.deepEqual([false, true, false].map(little => read(reader, { little }, 'right').exchanges), [false, true, false])
assert.equal(reader.read(Object.fromEntries(JOINTS.map(name => [name, name === 'wrist' ? null : [0, 0, 0]]))), null)
console.log('a tracked hand: pose of both hands, pinch, fist and little finger with hysteresis')
