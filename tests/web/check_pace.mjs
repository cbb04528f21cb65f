// The pace of the page (pace.js) against clocks that are made up.
//
//     node check_pace.mjs PACE.js
import assert from 'node:assert'
import { pathToFileURL } from 'node:url'

const { BACKLOG, LATE, Pace } = await import(pathToFileURL(process.argv[2]))

// Steps that take so long, ms, for so long; the loop of the worker, which comes again after `pause` ms.
function run(pace, begin, end, took, pause) {
  let now = begin
  while (now < end) {
    while (now < end && pace.take(now)) now += took
    now += pause
  }
  return now
}

function keepsUp() {
  const pace = new Pace()
  pace.start(100)
  run(pace, 100, 5100, 0.5, 4)
  assert(Math.abs(pace.steps - 5000) <= 5, `${pace.steps} steps in 5 s`)
  assert.equal(pace.late, 0)
  assert.equal(pace.givenUp, 0)
}

// Steps of 2 ms: half the speed, whatever happened before, and no time that is still owed.
function goesSlowly() {
  const pace = new Pace()
  pace.start(0)
  for (let now = 0; now < 10000; now = run(pace, now, now + 100, 2, 0.1)) pace.measure(now)
  assert(Math.abs(pace.steps - 5000) < 100, `${pace.steps} steps in 10 s`)
  assert(Math.abs(pace.factor - 0.5) < 0.05, `factor ${pace.factor}`)
  assert(Math.abs(pace.givenUp - 5000) < 150, `${pace.givenUp} ms given up`)
  assert(pace.late > 0.3 * pace.steps && pace.late < pace.steps)
  const before = pace.steps
  const now = run(pace, 10000, 11000, 0.1, 1) // fast again
  assert(pace.steps - before <= now - 10000 + BACKLOG + 1, 'it catches up with what was given up')
}

function standsStill() {
  const pace = new Pace()
  assert(!pace.take(10))
  pace.start(10)
  assert(pace.take(10))
  pace.stop()
  assert(!pace.take(1000))
  pace.start(60000)
  run(pace, 60000, 60010, 0.1, 1)
  assert(pace.steps <= 12 && pace.givenUp === 0, 'a pause is no time that is owed')
}

function oneHiccup() {
  const pace = new Pace()
  pace.start(0)
  run(pace, 0, 1000, 0.1, 1)
  run(pace, 1000 + LATE + 10, 2000, 0.1, 1) // a pause of 30 ms is caught up with, and ten steps were late
  assert.equal(pace.givenUp, 0)
  assert(pace.late >= 8 && pace.late <= 12, `${pace.late} late`)
  assert(Math.abs(pace.steps - 2000) <= 3)
}

for (const check of [keepsUp, goesSlowly, standsStill, oneHiccup]) check()
console.log('the pace is kept')
