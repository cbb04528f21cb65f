// The page: a worker with the session, a picture, hands, words.
import workerText from 'suturing-worker';
import { Captions } from './captions.js';
import { Desk } from './desk.js';
import { Headset } from './headset.js';
import { mirrorMessage, mirrorPicture, mirrorState } from './mirror.js';
import { OwnPage } from './own_page.js';
import { Progress } from './progress.js';
import { Renderer, readView } from './renderer.js';
import { Settings } from './settings.js';
import { Timeline } from './timeline.js';

const $ = id => document.getElementById(id);
const MAX_PIXELS = 2; // a unit of the screen
const BY_HANDS = ['move', 'pull', 'close', 'clutch', 'exchange', 'track', 'pose', 'aids', 'ghost'];

function download(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

class Page {
  constructor() {
    this.own = new OwnPage(document);
    this.worker = new Worker(URL.createObjectURL(new Blob([workerText], { type: 'text/javascript' })));
    this.worker.onmessage = ({ data }) => this.hear(data);
    this.worker.onerror = event => this.fail(event.message);
    this.captions = new Captions();
    this.captions.begin();
    this.scene = { scene: 2, seed: 0 };
    this.paused = true;
    this.log = null;
    this.renderer = this.arrived = this.shown = this.last = null;
    this.buffers = {};
    this.frames = 0;
    this.asked = this.mirrored = this.showsGhost = false;
    this.progress = new Progress(window.localStorage);
    this.settings = new Settings($, () => this.restyle());
    this.restyle();
    this.timeline = new Timeline($, step => this.send({ name: 'seek', step }));
    const act = { pause: () => this.pause(!this.paused), again: () => this.begin(), help: () => this.help(), tension: () => this.tension(), ghost: () => this.ghost(),
      jump: (direction, isSmall) => this.timeline.jump(direction, isSmall) };
    this.desk = new Desk($('canvas'), message => this.send(message), act);
    this.headset = new Headset(this);
    this.listen();
    Headset.isThere().then(there => { $('headset').hidden = !there; });
    requestAnimationFrame(now => this.picture(now));
  }

  send(message, buffers = []) {
    if (this.log && BY_HANDS.includes(message.name)) return; // the log has its own
    this.worker.postMessage(this.mirrored ? mirrorMessage(message) : message, buffers);
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
    $('scenes').hidden = $('exercises').hidden = false;
    this.showProgress();
    if (this.own.hasSession) this.own.session().then(bytes => this.playBytes(bytes), error => this.fail(error.message));
    else this.begin();
  }

  hearBegun({ look, programs, resolution }) {
    this.captions.putResolution(resolution);
    this.renderer = this.renderer || new Renderer($('canvas'), programs);
    this.firstLook = this.mirrored ? { ...look, aside: -look.aside } : look;
    this.desk.look = this.desk.look || { ...this.firstLook };
    this.fresh = true;
    if (this.showsGhost) this.send({ name: 'ghost', shown: true });
  }

  hearFrame(frame) {
    const state = this.mirrored ? mirrorState(frame.state) : frame.state;
    if (this.fresh) this.desk.begin(this.firstLook, state.tools, this.mirrored ? 0 : 1);
    this.fresh = false;
    this.arrived = { ...frame, state };
    this.asked = false;
  }

  hearLog({ blob, hashes, shares }) {
    this.hashes = hashes;
    if (shares) this.saveShared(blob);
    else download(blob, 'suturing.vbss');
  }

  hearSought({ hashes }) {
    this.hashes = hashes;
    this.timeline.arrive();
  }

  hearStepped(hashes) {
    this.hashes = hashes;
  }

  // ---- what the person does

  begin() {
    this.renew();
    if (this.log) this.send({ name: 'replay', bytes: this.log });
    else if (this.exercise) this.send({ name: 'exercise', exercise: this.exercise });
    else this.send({ name: 'begin', fits: true, ...this.scene });
  }

  renew() {
    this.captions.begin();
    this.headset.renew();
    this.timeline.begin();
    $('save').hidden = Boolean(this.log);
    $('share').textContent = this.log ? 'share' : 'end and share';
    this.mirrored = this.settings.leftHanded;
    for (const box of this.aidBoxes()) box.checked = false;
  }

  // ---- exercises and aids

  aidBoxes() {
    return $('aids').querySelectorAll('input');
  }

  sendAids() {
    const aids = [...this.aidBoxes()].reduce((sum, box) => sum + (box.checked ? Number(box.dataset.aid) : 0), 0);
    this.send({ name: 'aids', aids });
  }

  showProgress() {
    const rows = this.progress.read();
    for (const button of $('exercises').querySelectorAll('button')) {
      const row = rows && rows[button.dataset.name];
      button.querySelector('span').textContent = rows === null ? 'progress is damaged' : row ? `${row.passed} of ${row.attempts} passed` : '';
    }
  }

  // Words for the outcome of an exercise, which is counted.
  note({ name, time }, passed) {
    const words = this.progress.note({ name, time, passed, aided: this.arrivedState.aidsUsed !== 0 });
    this.showProgress();
    return words;
  }

  practise(exercise) {
    this.exercise = exercise;
    this.log = null;
    this.go();
  }

  restyle() {
    document.documentElement.classList.toggle('contrast', this.settings.contrast);
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

  // An expert's tools beside the person's.
  ghost() {
    this.showsGhost = !this.showsGhost;
    $('ghost').setAttribute('aria-pressed', String(this.showsGhost));
    this.send({ name: 'ghost', shown: this.showsGhost });
  }

  tension() {
    this.renderer.showsTension = !this.renderer.showsTension;
  }

  choose(scene) {
    this.scene.scene = scene;
    this.exercise = 0;
    this.log = null;
    this.go();
  }

  // A log that was saved, by this page or by another program.
  async play(file) {
    this.playBytes(await file.arrayBuffer());
  }

  playBytes(log) {
    this.log = log;
    this.go();
  }

  // The session as a page that plays it: the log that is played, or the one that ends now.
  share() {
    if (this.log) this.saveShared(new Blob([this.log]));
    else this.send({ name: 'log', end: true, shares: true });
  }

  saveShared(log) {
    this.own.fileWith(log).then(page => download(page, 'suturing-session.html'), error => this.fail(error.message));
  }

  go() {
    $('start').hidden = true;
    this.begin();
    this.pause(false);
  }

  listen() {
    for (const button of $('scenes').querySelectorAll('button')) {
      button.addEventListener('click', () => this.choose(Number(button.dataset.scene)));
    }
    for (const button of $('exercises').querySelectorAll('button')) {
      button.addEventListener('click', () => this.practise(Number(button.dataset.exercise)));
    }
    for (const box of this.aidBoxes()) box.addEventListener('change', () => this.sendAids());
    const clicks = { 'aids-button': () => {
      $('aids').hidden = !$('aids').hidden;
      $('aids-button').setAttribute('aria-expanded', String(!$('aids').hidden));
    }, ghost: () => this.ghost(), pause: () => this.pause(!this.paused), again: () => this.begin(), 'help-button': () => this.help(),
      'close-report': () => { $('report').hidden = true; }, save: () => this.send({ name: 'log', end: true }), share: () => this.share(),
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
    $('log').addEventListener('change', () => {
      const [file] = $('log').files;
      if (file) this.play(file);
      $('log').value = '';
    });
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
    this.renderer.ghost = frame.ghost;
    for (const [name, array] of Object.entries(frame.arrays)) this.buffers[name] = array.buffer;
    this.timeline.show(frame.state);
    this.arrivedState = frame.state;
    this.captions.show(frame, this.desk.side, this.desk.taken, now, (exercise, passed) => this.note(exercise, passed));
    const view = readView(frame.view);
    if (this.mirrored) Object.assign(view, { seen: mirrorPicture(view.seen), target: view.target.map((n, i) => (i === 0 ? -n : n)) });
    this.shown = { ...frame, view };
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
