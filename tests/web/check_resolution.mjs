// The choice of the thread's resolution (resolution.js) on machines that are made up.
//
//     node check_resolution.mjs RESOLUTION.js
import assert from 'node:assert'
import { pathToFileURL } from 'node:url'

const { FINEST, choose } = await import(pathToFileURL(process.argv[2]))

// Steps of each scene take so long, ms; the first `cold` steps ten times as long, as before a compiler has come to them.
function machine(took, cold = 0) {
  let now = 1000, scene = null, steps = 0
  const begun = []
  const choice = choose(wanted => { scene = wanted; steps = 0; begun.push(wanted) },
    () => { now += took[scene] * (steps++ < cold ? 10 : 1) }, () => now)
  return { choice, begun, seconds: (now - 1000) / 1000 }
}

const fast = machine({ 2: 0.3, 3: 0.2, 4: 0.1 })
assert.deepEqual([fast.choice.scene, fast.choice.segments, fast.begun], [FINEST, 300, [FINEST]])
assert(Math.abs(fast.choice.tried[0].milliseconds - 0.3) < 1e-6, JSON.stringify(fast.choice))
const slow = machine({ 2: 1.1, 3: 0.55, 4: 0.3 })
assert.deepEqual([slow.choice.scene, slow.choice.segments, slow.begun], [3, 120, [2, 3]])
const slower = machine({ 2: 5, 3: 3, 4: 2 })
assert.deepEqual([slower.choice.scene, slower.choice.segments], [4, 60], 'the coarsest, though it is too slow')
assert.equal(slower.choice.tried.length, 3)
assert(slower.seconds < 2.5, `${slower.seconds} s`)
const cold = machine({ 2: 0.5, 3: 0.2, 4: 0.1 }, 100)
assert.equal(cold.choice.segments, 300, 'slow first steps are not counted')
console.log('300, 120 and 60 segments chosen as the steps of made-up machines want it')
