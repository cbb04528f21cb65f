// A session is played: its film on the stage, words beside it, the line of time below.
import { Clock } from './clock.js';
import { readFilm } from './film.js';
import { Stage } from './stage.js';
import { isListed, putTimeline } from './timeline.js';

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 8];
const $ = id => document.getElementById(id);

const session = JSON.parse($('session').textContent);

function setUpSource() {
  document.title = `Session replay: ${session.log}`;
  $('source').textContent = `${session.log}: ${session.scene}${session.fault ? `. Not whole: ${session.fault}` : ''}`;
  if (session.gaps.length === 0) $('gap-name').hidden = $('gap').hidden = true;
}

const lastOf = (rows, time) => rows.filter(row => row.time <= time + 1e-9).pop();

function putWords(clock, frame) {
  const phase = session.phases.find(p => clock.time < p.to) || session.phases[session.phases.length - 1];
  const knot = lastOf(session.knots, clock.time);
  const set = (id, words) => {
    if ($(id).textContent !== words) $(id).textContent = words;
  };
  set('phase', phase ? phase.name : 'not known');
  set('knot', knot ? [knot.notation, knot.name, knot.verdict].filter(Boolean).join(', ') : 'none yet');
  set('force-left', `${session.forces.left[frame].toFixed(2)} N`);
  set('force-right', `${session.forces.right[frame].toFixed(2)} N`);
  if (session.gaps.length > 0) {
    const gap = session.gaps[frame] >= 0 ? session.gaps[frame] : session.gaps[frame + 1];
    set('gap', `${gap.toFixed(2)} mm open`);
  }
  set('step', `${session.steps[frame]}`);
  set('time', `${clock.time.toFixed(2)} s of ${clock.end.toFixed(2)} s`);
  set('play', clock.playing ? 'pause' : 'play');
  if (document.activeElement !== $('scrub') || clock.playing || Number($('scrub').value) !== clock.time) {
    $('scrub').value = clock.time;
  }
  $('scrub').setAttribute('aria-valuetext', `${clock.time.toFixed(2)} seconds, ${phase ? phase.name : ''}`);
}

function setUpControls(clock, stage, draw) {
  for (const speed of SPEEDS) $('speed').add(new Option(`${speed} \u00d7`, speed, speed === 1, speed === 1));
  $('speed').addEventListener('change', () => { clock.speed = Number($('speed').value); });
  $('play').addEventListener('click', () => (clock.playing ? clock.pause() : clock.play()));
  $('back').addEventListener('click', () => clock.step(-1));
  $('forth').addEventListener('click', () => clock.step(1));
  $('home').addEventListener('click', () => { stage.goHome(); draw(); });
  $('scrub').max = clock.end;
  $('scrub').addEventListener('input', () => clock.go(Number($('scrub').value)));
}

// To the next event in that direction.
function goToEvent(clock, way) {
  const times = session.events.filter(isListed).map(e => e.time);
  const time = way > 0 ? times.find(t => t > clock.time + 1e-6) : times.reverse().find(t => t < clock.time - 1e-6);
  if (time !== undefined) {
    clock.pause();
    clock.go(time);
  }
}

// Space presses the button that the keyboard has gone to, but plays after one that was clicked.
function setUpKeys(clock) {
  document.addEventListener('click', event => {
    if (event.detail > 0 && event.target.closest('button')) document.activeElement.blur();
  });
  document.addEventListener('keydown', event => {
    const way = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    const chosen = event.target.tagName;
    if (event.altKey || event.ctrlKey || event.metaKey || chosen === 'SELECT') return;
    if (event.key === ' ' && chosen !== 'BUTTON') clock.playing ? clock.pause() : clock.play();
    else if (way !== 0 && event.shiftKey) goToEvent(clock, way);
    else if (way !== 0) clock.step(way);
    else if (event.key === 'Home') clock.go(0);
    else if (event.key === 'End') clock.go(clock.end);
    else return;
    event.preventDefault();
  });
}

function setUpTheme(changed) {
  const dark = window.matchMedia('(prefers-color-scheme: dark)');
  const set = theme => {
    document.documentElement.dataset.theme = theme;
    $('theme').textContent = theme === 'dark' ? 'light' : 'dark';
    changed(theme);
  };
  $('theme').addEventListener('click', () => set($('theme').textContent));
  dark.addEventListener('change', () => set(dark.matches ? 'dark' : 'light'));
  set(dark.matches ? 'dark' : 'light');
}

function begin() {
  let asked = false;
  let tell = () => {};
  let stage = null;
  // At most one picture a refresh, and none while nothing changes.
  const draw = () => {
    if (!asked && stage) {
      asked = true;
      requestAnimationFrame(picture);
    }
  };
  const clock = new Clock(session.times, draw);
  const picture = now => {
    asked = false;
    clock.tick(now);
    const { frame, share } = clock.place();
    stage.show(frame, share);
    stage.draw();
    putWords(clock, frame);
    tell(clock.time);
    if (clock.playing) draw();
  };
  stage = new Stage($('canvas'), session.film, readFilm(session.film), draw);
  tell = putTimeline(session, clock.end, time => {
    clock.pause();
    clock.go(time);
  });
  setUpControls(clock, stage, draw);
  setUpKeys(clock);
  setUpTheme(theme => {
    stage.setTheme(theme);
    draw();
  });
  window.addEventListener('resize', draw);
  const wanted = /^#t=([0-9.]+)$/.exec(window.location.hash);
  clock.go(wanted ? Number(wanted[1]) : 0);
}

setUpSource();
try {
  begin();
} catch (error) {
  $('problem').textContent = `This browser cannot show it: ${error.message}`;
  $('problem').hidden = false;
  throw error;
}
