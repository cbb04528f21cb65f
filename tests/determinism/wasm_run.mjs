// Runs a WebAssembly program in Node.js, with as much of WASI (preview 1) as the golden program and the
// replay of logs need: arguments, output, a clock, and files that are only read.
//
//     node wasm_run.mjs PROGRAM.wasm ARGUMENT ...
//
// node:wasi is not used: its calls crash in Node.js 20 (nodejs/node#53087).
import fs from 'node:fs'

const [program, ...rest] = process.argv.slice(2)
const args = [program, ...rest].map((word) => Buffer.from(word + '\0'))
const SUCCESS = 0, BAD_FILE = 8, NO_ENTRY = 44
const DIRECTORY = 3, REGULAR_FILE = 4, CHARACTER_DEVICE = 2
const ROOT = 3 // the one directory that is open from the start: /
let memory, next = ROOT + 1
const files = new Map() // WASI's number -> the number of Node.js
const view = () => new DataView(memory.buffer)
const bytes = (at, size) => new Uint8Array(memory.buffer, at, size)

// Calls `use` with each part of a list of buffers until one is not filled; returns the bytes in all.
function each(list, count, use) {
  let total = 0
  for (let i = 0; i < count; i++) {
    const at = view().getUint32(list + 8 * i, true), size = view().getUint32(list + 8 * i + 4, true)
    const done = use(bytes(at, size))
    total += done
    if (done < size) break
  }
  return total
}

const calls = {
  args_sizes_get(count, size) {
    view().setUint32(count, args.length, true)
    view().setUint32(size, args.reduce((sum, word) => sum + word.length, 0), true)
    return SUCCESS
  },
  args_get(pointers, at) {
    for (const [i, word] of args.entries()) {
      view().setUint32(pointers + 4 * i, at, true)
      bytes(at, word.length).set(word)
      at += word.length
    }
    return SUCCESS
  },
  clock_time_get(clock, precision, time) {
    view().setBigUint64(time, process.hrtime.bigint(), true)
    return SUCCESS
  },
  fd_write(file, list, count, written) {
    if (file !== 1 && file !== 2) return BAD_FILE
    const total = each(list, count, (part) => {
      for (let done = 0; done < part.length;) done += fs.writeSync(file, part, done)
      return part.length
    })
    view().setUint32(written, total, true)
    return SUCCESS
  },
  fd_read(file, list, count, read) {
    if (!files.has(file)) return BAD_FILE
    view().setUint32(read, each(list, count, (part) => fs.readSync(files.get(file), part)), true)
    return SUCCESS
  },
  fd_close(file) {
    if (!files.has(file)) return BAD_FILE
    fs.closeSync(files.get(file))
    files.delete(file)
    return SUCCESS
  },
  fd_fdstat_get(file, stat) {
    bytes(stat, 24).fill(0)
    view().setUint8(stat, file === ROOT ? DIRECTORY : file < ROOT ? CHARACTER_DEVICE : REGULAR_FILE)
    view().setBigUint64(stat + 8, ~0n, true) // all rights
    view().setBigUint64(stat + 16, ~0n, true)
    return SUCCESS
  },
  fd_prestat_get(file, prestat) {
    if (file !== ROOT) return BAD_FILE
    view().setUint32(prestat, 0, true)
    view().setUint32(prestat + 4, 1, true)
    return SUCCESS
  },
  fd_prestat_dir_name(file, at) {
    view().setUint8(at, '/'.charCodeAt(0))
    return SUCCESS
  },
  path_open(root, lookup, path, size, flags, rights, inherited, mode, file) {
    try {
      files.set(next, fs.openSync('/' + Buffer.from(bytes(path, size)).toString(), 'r'))
    } catch {
      return NO_ENTRY
    }
    view().setUint32(file, next++, true)
    return SUCCESS
  },
  proc_exit(code) {
    process.exit(code)
  },
}

const module = new WebAssembly.Module(fs.readFileSync(program))
const imports = { wasi_snapshot_preview1: { ...calls } }
for (const { module: from, name } of WebAssembly.Module.imports(module)) {
  imports[from][name] ??= () => { throw new Error(`the program calls ${name}, which this script does not have`) }
}
const instance = new WebAssembly.Instance(module, imports)
memory = instance.exports.memory
instance.exports._start()
