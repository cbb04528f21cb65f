// The clock of steps of the page (step_clock.js) against clocks that are made up.
//
//     node check_step_clock.mjs STEP_CLOCK.js
import assert from 'node:assert'
import { pathToFileURL } from 'node:url'

const { BACKLOG, LATE, StepClock } = await import(pathToFileURL(process.argv[2]))

// Steps that take so long, ms, for so long; the loop of the worker, which comes again after `pause` ms.
function run(clock, begin, end, took, pause) {
  let now = begin
  while (now < end) {
    while (now < end && clock.take(now)) now += took
    now += pause
  }
  return now
}

function keepsUp() {
  const clock = new StepClock()
  clock.start(100)
  run(clock, 100, 5100, 0.5, 4)
  assert(Math.abs(clock.steps - 5000) <= 5, `${clock.steps} steps in 5 s`)
  assert.equal(clock.late, 0)
  assert.equal(clock.givenUp, 0)
}

// Steps of 2 ms: half the speed, whatever happened before, and no time that is still owed.
function goesSlowly() {
  const clock = new StepClock()
  clock.start(0)
  for (let now = 0; now < 10000; now = run(clock, now, now + 100, 2, 0.1)) clock.measure(now)
  assert(Math.abs(clock.steps - 5000) < 100, `${clock.steps} steps in 10 s`)
  assert(Math.abs(clock.factor - 0.5) < 0.05, `factor ${clock.factor}`)
  assert(Math.abs(clock.givenUp - 5000) < 150, `${clock.givenUp} ms given up`)
  assert(clock.late > 0.3 * clock.steps && clock.late < clock.steps)
  const before = clock.steps
  const now = run(clock, 10000, 11000, 0.1, 1) // fast again
  assert(clock.steps - before <= now - 10000 + BACKLOG + 1, 'it catches up with what was given up')
}

function standsStill() {
  const clock = new StepClock()
  assert(!clock.take(10))
  clock.start(10)
  assert(clock.take(10))
  clock.stop()
  assert(!clock.take(1000))
  clock.start(60000)
  run(clock, 60000, 60010, 0.1, 1)
  assert(clock.steps <= 12 && clock.givenUp === 0, 'a pause is no time that is owed')
}

function oneHiccup() {
  const clock = new StepClock()
  clock.start(0)
  run(clock, 0, 1000, 0.1, 1)
  run(clock, 1000 + LATE + 10, 2000, 0.1, 1) // a pause of 30 ms is caught up with, and ten steps were late
  assert.equal(clock.givenUp, 0)
  assert(clock.late >= 8 && clock.late <= 12, `${clock.late} late`)
  assert(Math.abs(clock.steps - 2000) <= 3)
}

for (const check of [keepsUp, goesSlowly, standsStill, oneHiccup]) check()
console.log('the clock is kept')
