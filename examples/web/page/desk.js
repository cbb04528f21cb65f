// Mouse, keyboard and gamepad: one mouse moves both tools in turn, as in the desktop viewer (person.c).
import { Pad } from './pad.js';

const FINE = 0.25; // of a movement, with shift
const KEY_COUNTS = 300, KEY_NOTCHES = 15; // a second, of 0.1 mm and 2 mm: 30 mm/s
const NOTCH = 100; // of a wheel's pixels
const NOTCH_LINES = 3;
const TURNING = 0.8; // of the camera, rad/s
const GOING = 0.7; // of the distance, 1/s
const LOWEST = 0.1, HIGHEST = 1.5; // rad
const NEAREST = 0.03, FARTHEST = 0.3; // m

export class Desk {
  // `send` hands messages to the worker; `act` has the functions that keys call.
  constructor(canvas, send, act) {
    this.canvas = canvas;
    this.send = send;
    this.act = act;
    this.side = 1;
    this.closes = [false, false];
    this.held = new Set();
    this.pad = new Pad();
    this.pulled = '';
    this.turning = this.clutching = this.clutched = this.taken = false;
    this.look = this.firstLook = null;
    this.listen();
  }

  begin(look, tools, side) {
    this.firstLook = { ...look };
    this.look = { ...look };
    this.side = side;
    this.closes = tools.map(tool => tool.closes);
    this.pulled = '';
    this.clutched = false;
  }

  get fine() {
    return this.held.has('Shift') ? FINE : 1;
  }

  take() {
    this.taken = true;
    this.canvas.focus();
    // Where a browser refuses it, the pointer itself moves the tool.
    if (!document.pointerLockElement && this.canvas.requestPointerLock) {
      const asked = this.canvas.requestPointerLock();
      if (asked && asked.catch) asked.catch(() => {});
    }
  }

  release() {
    this.taken = this.turning = this.clutching = false;
    this.held.clear();
    if (document.pointerLockElement) document.exitPointerLock();
    this.clutch();
  }

  listen() {
    const { canvas } = this;
    canvas.addEventListener('mousedown', event => this.press(event));
    canvas.addEventListener('contextmenu', event => event.preventDefault());
    canvas.addEventListener('wheel', event => this.wheel(event), { passive: false });
    window.addEventListener('mouseup', event => {
      if (event.button === 2) this.turning = false;
      if (event.button === 1) this.clutching = false;
      this.clutch();
    });
    window.addEventListener('mousemove', event => this.move(event));
    window.addEventListener('keydown', event => this.key(event));
    window.addEventListener('keyup', event => {
      this.held.delete(event.key.length === 1 ? event.key.toLowerCase() : event.key);
      this.clutch();
    });
    window.addEventListener('blur', () => this.release());
    document.addEventListener('pointerlockchange', () => {
      if (document.pointerLockElement) this.locked = true;
      else if (this.locked) {
        this.locked = false;
        this.release();
      }
    });
  }

  press(event) {
    event.preventDefault();
    if (!this.taken) this.take();
    else if (event.button === 0) this.toggle();
    if (event.button === 2) this.turning = true;
    if (event.button === 1) this.clutching = true;
    this.clutch();
  }

  toggle() {
    this.closes[this.side] = !this.closes[this.side];
    this.send({ name: 'close', side: this.side, closes: this.closes[this.side] });
  }

  move(event) {
    if (!this.taken || (event.movementX === 0 && event.movementY === 0)) return;
    this.send({ name: 'move', side: this.side, turns: this.turning, right: this.fine * event.movementX, up: -this.fine * event.movementY, away: 0 });
  }

  wheel(event) {
    event.preventDefault();
    if (!this.taken) return;
    const notches = -event.deltaY / (event.deltaMode === 0 ? NOTCH : NOTCH_LINES);
    this.send({ name: 'move', side: this.side, turns: this.turning, right: 0, up: 0, away: this.fine * notches });
  }

  clutch() {
    const held = this.clutching || this.held.has(' ');
    if (held === this.clutched) return;
    this.clutched = held;
    this.send({ name: 'clutch', side: this.side, held });
  }

  other() {
    this.clutching = false;
    this.held.delete(' ');
    this.clutch();
    this.side = 1 - this.side;
  }

  key(event) {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const isIn = kind => event.target.closest && event.target.closest(kind);
    if (isIn('input[type=number]')) return; // digits and arrows are its own
    const inButton = isIn('button, input[type=checkbox]');
    if (event.altKey || event.ctrlKey || event.metaKey || (inButton && (key === ' ' || key === 'Enter' || key === 'Tab'))) return;
    if (key === 'Tab' && !this.taken) return; // from button to button, as on any page
    if (!event.repeat) {
      const once = { Tab: () => this.other(), p: this.act.pause, r: this.act.again, h: this.act.help, g: this.act.ghost, 3: this.act.tension,
        x: () => this.send({ name: 'exchange', side: this.side }), ',': () => this.act.jump(-1, event.shiftKey), '.': () => this.act.jump(1, event.shiftKey),
        '<': () => this.act.jump(-1, true), '>': () => this.act.jump(1, true), Home: () => { this.look = { ...this.firstLook }; },
        Escape: () => this.release() };
      if (Object.hasOwn(once, key)) once[key]();
    }
    this.held.add(key);
    if (['Tab', ' ', 'ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'PageUp', 'PageDown', 'Home'].includes(key)) event.preventDefault();
    this.clutch();
  }

  pull(more, less) {
    return (this.held.has(more) ? 1 : 0) - (this.held.has(less) ? 1 : 0);
  }

  // The first gamepad that is there.
  takePad() {
    const pads = navigator.getGamepads ? navigator.getGamepads() : [];
    const { axes, isFine, pressed } = this.pad.read([...pads].find(pad => pad && pad.mapping === 'standard'));
    if (pressed.jaws) this.toggle();
    if (pressed.other) this.other();
    if (pressed.help) this.act.help();
    const pulled = JSON.stringify([this.side, axes, isFine]);
    if (pulled !== this.pulled) {
      [0, 1].forEach(side => this.send({ name: 'pull', side, axes: side === this.side ? axes : [0, 0, 0, 0, 0, 0],
        grain: isFine ? FINE : 1 }));
    }
    this.pulled = pulled;
    return pressed.pause;
  }

  // What held keys do in so many seconds.
  pass(seconds) {
    const [right, up, away] = [this.pull('d', 'a'), this.pull('w', 's'), this.pull('e', 'q')];
    const share = this.fine * seconds;
    if (right || up || away) {
      this.send({ name: 'move', side: this.side, turns: false, right: share * KEY_COUNTS * right, up: share * KEY_COUNTS * up,
        away: share * KEY_NOTCHES * away });
    }
    const { look } = this;
    look.aside += TURNING * seconds * this.pull('ArrowRight', 'ArrowLeft');
    look.down = Math.min(Math.max(look.down + TURNING * seconds * this.pull('ArrowUp', 'ArrowDown'), LOWEST), HIGHEST);
    look.away = Math.min(Math.max(look.away * (1 + GOING * seconds * this.pull('PageDown', 'PageUp')), NEAREST), FARTHEST);
  }
}
