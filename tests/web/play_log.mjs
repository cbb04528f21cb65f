// Plays a log with the module in Node.js: to each of the steps, the hashes there; then to its end, and the state. Forward it goes
// step by step, back by a jump.
//
//     node play_log.mjs SIMULATION.js MODULE.wasm LOG STEP...
import fs from 'node:fs'
import { pathToFileURL } from 'node:url'

const [simulationFile, module, log, ...steps] = process.argv.slice(2)
const { Simulation } = await import(pathToFileURL(simulationFile))
const simulation = await Simulation.load(fs.readFileSync(module), (text) => process.stderr.write(text))
simulation.replay(fs.readFileSync(log))
let at = 0
steps.forEach((word, i) => {
  const step = Number(word)
  if (step > at && i % 2 === 0) simulation.step(step - at)
  else simulation.seek(step)
  at = step
  console.log(simulation.hashes().join(' '))
})
simulation.step(1e9) // there are fewer
console.log(JSON.stringify(simulation.state()))
