// The page: a worker with the session, a picture, hands, words.
import workerText from 'suturing-worker';
import { Captions } from './captions.js';
import { Desk } from './desk.js';
import { Headset } from './headset.js';
import { Renderer, readView } from './renderer.js';

const $ = id => document.getElementById(id);
const MAX_PIXELS = 2; // a unit of the screen

class Page {
  constructor() {
    this.worker = new Worker(URL.createObjectURL(new Blob([workerText], { type: 'text/javascript' })));
    this.worker.onmessage = ({ data }) => this.hear(data);
    this.worker.onerror = event => this.fail(event.message);
    this.captions = new Captions();
    this.captions.begin();
    this.scene = { scene: 2, seed: 0 };
    this.paused = true;
    this.renderer = this.arrived = this.shown = this.last = null;
    this.buffers = {};
    this.frames = 0;
    this.asked = false;
    const act = { pause: () => this.pause(!this.paused), again: () => this.begin(), help: () => this.help(), tension: () => this.tension() };
    this.desk = new Desk($('canvas'), message => this.send(message), act);
    this.headset = new Headset(this);
    this.listen();
    Headset.isThere().then(there => { $('headset').hidden = !there; });
    requestAnimationFrame(now => this.picture(now));
  }

  send(message, buffers = []) {
    this.worker.postMessage(message, buffers);
  }

  fail(words) {
    $('problem').textContent = words;
    $('problem').hidden = false;
    this.failed = true;
  }

  // ---- what the worker says

  hear(data) {
    try {
      for (const [name, value] of Object.entries(data)) this[`hear${name[0].toUpperCase()}${name.slice(1)}`](value);
    } catch (error) {
      this.fail(error.message);
      throw error;
    }
  }

  hearProblem(words) {
    this.fail(words);
  }

  hearReady(ready) {
    this.loaded = ready.milliseconds;
    $('loading').hidden = true;
    $('scenes').hidden = false;
    this.begin();
  }

  hearBegun({ look, programs, resolution }) {
    this.captions.putResolution(resolution);
    this.renderer = this.renderer || new Renderer($('canvas'), programs);
    this.firstLook = look;
    this.desk.look = this.desk.look || { ...look };
    this.fresh = true;
  }

  hearFrame(frame) {
    if (this.fresh) this.desk.begin(this.firstLook, frame.state.tools);
    this.fresh = false;
    this.arrived = frame;
    this.asked = false;
  }

  hearLog({ blob, hashes }) {
    this.hashes = hashes;
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = 'suturing.vbss';
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  hearStepped(hashes) {
    this.hashes = hashes;
  }

  // ---- what the person does

  begin() {
    this.captions.begin();
    this.headset.renew();
    this.send({ name: 'begin', fits: true, ...this.scene });
  }

  pause(wanted) {
    this.paused = wanted;
    $('pause').textContent = wanted ? 'go on' : 'pause';
    this.send({ name: 'pause', wanted });
  }

  help() {
    $('help').hidden = !$('help').hidden;
    $('help-button').setAttribute('aria-expanded', String(!$('help').hidden));
  }

  tension() {
    this.renderer.showsTension = !this.renderer.showsTension;
  }

  choose(scene) {
    this.scene.scene = scene;
    $('start').hidden = true;
    this.begin();
    this.pause(false);
  }

  listen() {
    for (const button of $('scenes').querySelectorAll('button')) {
      button.addEventListener('click', () => this.choose(Number(button.dataset.scene)));
    }
    const clicks = { pause: () => this.pause(!this.paused), again: () => this.begin(), 'help-button': () => this.help(),
      'close-report': () => { $('report').hidden = true; }, save: () => this.send({ name: 'log', end: true }),
      headset: () => this.headset.enter().catch(error => this.fail(error.message)),
      choose: () => {
        this.pause(true);
        $('start').hidden = false;
      } };
    for (const [id, work] of Object.entries(clicks)) {
      $(id).addEventListener('click', event => {
        work();
        if (event.detail > 0) $(id).blur(); // so that space is the clutch again
      });
    }
    document.addEventListener('visibilitychange', () => {
      if (document.hidden && !this.paused && !this.headset.session) this.pause(true);
    });
  }

  // ---- pictures

  resize() {
    const canvas = $('canvas');
    const ratio = Math.min(window.devicePixelRatio || 1, MAX_PIXELS);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map(n => Math.max(1, Math.floor(ratio * n)));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  }

  show(frame, now) {
    this.renderer.upload(frame.arrays);
    for (const [name, array] of Object.entries(frame.arrays)) this.buffers[name] = array.buffer;
    this.captions.show(frame, this.desk.side, this.desk.taken, now);
    this.shown = { ...frame, view: readView(frame.view) };
    this.frames++;
  }

  // One request at a time: a worker that is late gets no more of them.
  ask() {
    const canvas = $('canvas');
    const look = { ...this.desk.look, aspect: canvas.width / canvas.height };
    this.asked = true;
    this.send({ name: 'frame', look, buffers: this.buffers }, Object.values(this.buffers));
    this.buffers = {};
  }

  // Takes what has come, asks for more; the view, if there is something to draw.
  exchange(now) {
    const arrived = this.arrived;
    this.arrived = null;
    if (arrived) this.show(arrived, now);
    if (!this.asked) this.ask();
    return this.shown && this.shown.view;
  }

  picture(now) {
    requestAnimationFrame(later => this.picture(later));
    const seconds = this.last === null ? 0 : Math.min(0.1, (now - this.last) / 1000);
    this.last = now;
    if (!this.renderer || this.failed || this.headset.session) return;
    this.resize();
    if (this.desk.takePad()) this.pause(!this.paused);
    if (!this.paused) this.desk.pass(seconds);
    const before = this.shown;
    const view = this.exchange(now);
    if (view && this.shown !== before) this.renderer.draw(view);
  }
}

window.suturing = new Page();
