// A script of calls (see calls.c) with the module in Node.js: the hashes and states that it asks for, then the log.
//
//     node run_module.mjs SIMULATION.js MODULE.wasm LOG < SCRIPT
import fs from 'node:fs'
import { pathToFileURL } from 'node:url'

const [simulationFile, module, log] = process.argv.slice(2)
const { Simulation } = await import(pathToFileURL(simulationFile))
const simulation = await Simulation.load(fs.readFileSync(module), (text) => process.stderr.write(text))
for (const line of fs.readFileSync(0, 'utf8').split('\n').filter((line) => line !== '')) {
  const [word, ...numbers] = line.split(' ')
  if (word === 'hash') console.log(simulation.hashes().join(' '))
  else if (word === 'state') console.log(JSON.stringify(simulation.state()))
  else simulation.check(simulation.calls[word === 'camera' ? 'page_set_camera' : `page_${word}`](...numbers.map(Number)) ?? 0, line)
}
simulation.end()
fs.writeFileSync(log, Buffer.from(await simulation.log().arrayBuffer()))
