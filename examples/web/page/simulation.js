// The module with its calls (examples/web/page.h), for the worker and for tests in Node.js.
import { Wasi } from './wasi.js';

const FIELDS = [['vertices', Float32Array, 12], ['triangles', Uint32Array, 3], ['parts', Uint32Array, 8], ['spots', Float32Array, 6]];
const VIEW_FLOATS = 46;
export const PROGRAMS = ['material', 'lens', 'shadow'];

export class Simulation {
  // Bytes of the module; `say` receives what it prints.
  static async load(bytes, say) {
    const wasi = new Wasi(say);
    const { instance } = await WebAssembly.instantiate(bytes, wasi.imports());
    wasi.memory = instance.exports.memory;
    instance.exports._initialize();
    return new Simulation(instance.exports, wasi);
  }

  constructor(calls, wasi) {
    this.calls = calls; // all that need no more than numbers are called directly
    this.wasi = wasi;
  }

  textAt(address) {
    const bytes = new Uint8Array(this.calls.memory.buffer, address);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }

  // Fails with the library's words.
  check(result, what) {
    if (result !== 0) throw new Error(`${what}: result ${result} ${this.textAt(this.calls.page_problem())}`);
  }

  begin(scene, seed) {
    this.check(this.calls.page_begin(scene, seed), 'the scene cannot be made');
  }

  put(bytes) {
    const at = this.calls.page_room(bytes.length);
    if (at === 0) throw new Error('the file is too large');
    new Uint8Array(this.calls.memory.buffer, at, bytes.length).set(bytes);
  }

  // One skill; `starts`: the states at which exercises start.
  exercise(number, starts) {
    this.put(starts);
    this.check(this.calls.page_exercise(number), 'the exercise cannot begin');
  }

  // The track of ghost hands, for all sessions.
  takeGhost(bytes) {
    this.put(bytes);
    this.check(this.calls.page_take_ghost(), 'the ghost hands are damaged');
  }

  // A log as it was saved, in place of hands.
  replay(bytes) {
    this.put(bytes);
    this.check(this.calls.page_replay(), 'this is no log that can be played here');
  }

  seek(step) {
    this.check(this.calls.page_seek(step), 'the log has no such step');
  }

  step(count) {
    this.check(this.calls.page_step(count), 'a step failed');
  }

  end() {
    this.check(this.calls.page_end(), 'the log cannot be ended');
  }

  // What has been written so far.
  log() {
    return this.wasi.files.get('log.vbss').toBlob();
  }

  hashes() {
    return [this.calls.page_scene_hash(), this.calls.page_session_hash()].map(
      hash => BigInt.asUintN(64, hash).toString(16).padStart(16, '0'));
  }

  firstLook() {
    const [aside, down, away] = new Float64Array(this.calls.memory.buffer, this.calls.page_first_camera(), 3);
    return { aside, down, away };
  }

  view() {
    return new Float32Array(this.calls.memory.buffer, this.calls.page_view(), VIEW_FLOATS).slice();
  }

  // Copies into the buffers of an earlier answer, where these are large enough.
  draw(buffers = {}) {
    const address = this.calls.page_draw();
    if (address === 0) throw new Error(`no picture: ${this.textAt(this.calls.page_problem())}`);
    const table = new Uint32Array(this.calls.memory.buffer, address, 2 * FIELDS.length).slice();
    const arrays = {};
    FIELDS.forEach(([name, Type, width], i) => {
      const count = width * table[2 * i + 1];
      const old = buffers[name];
      const buffer = old && old.byteLength >= 4 * count ? old : new ArrayBuffer(Math.ceil(1.2 * 4 * count));
      arrays[name] = new Type(buffer, 0, count);
      if (count > 0) arrays[name].set(new Type(this.calls.memory.buffer, table[2 * i], count));
    });
    return arrays;
  }

  state() {
    return JSON.parse(this.textAt(this.calls.page_state()));
  }

  // The desktop viewer's programs, in the language of WebGL 2.
  programs() {
    const header = '#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2DShadow;\n';
    const program = i => this.textAt(this.calls.page_program(i)).replace('#version 330 core\n', header);
    return Object.fromEntries(PROGRAMS.map((name, i) => [name, [program(2 * i), program(2 * i + 1)]]));
  }
}
