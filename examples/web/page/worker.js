// Runs the session: steps of a millisecond against the clock, in slices, between which messages are heard. The page asks for
// each picture; its buffers go to and fro.
import packed from 'suturing-module';
import packedGhost from 'suturing-ghost';
import packedStarts from 'suturing-starts';
import { unpack } from './packing.js';
import { FINEST, choose } from './resolution.js';
import { StepClock } from './step_clock.js';
import { Simulation } from './simulation.js';

const SLICE = 6; // ms of steps between messages
const PROBE = 50; // steps whose time is taken together

const channel = new MessageChannel(); // to come again at once; a timer waits for 4 ms
let clock = new StepClock();
export let simulation = null; // for the worker of tests
let resolution = null;
let starts = null; // of exercises, as bytes
let paused = true, ended = false, asked = false, stepTime = null;
let left = Infinity; // steps of a log that is played

function again() {
  if (asked || paused || ended) return;
  asked = true;
  if (clock.next !== null && clock.next <= performance.now()) channel.port2.postMessage(0);
  else setTimeout(() => guard(run), 1);
}

function note(time, steps) {
  const each = time / steps;
  stepTime = stepTime === null ? each : stepTime + Math.min(1, steps / PROBE) * (each - stepTime);
}

function run() {
  asked = false;
  if (paused || ended) return;
  const begin = performance.now();
  let now = begin, steps = 0;
  while (now - begin < SLICE && left > 0 && clock.take(now)) {
    simulation.step(1);
    left--;
    steps++;
    now = performance.now();
  }
  if (steps > 0) note(now - begin, steps);
  if (left > 0) again();
  else clock.stop();
}
channel.port1.onmessage = () => guard(run);

function pause(wanted) {
  paused = wanted;
  if (wanted || left === 0) clock.stop();
  else clock.start(performance.now());
  again();
}

// Of a session that was made a moment ago.
export function begin(resolution = null, length = Infinity) {
  ended = false;
  left = length;
  clock = new StepClock();
  postMessage({ begun: { look: simulation.firstLook(), programs: simulation.programs(), resolution } });
  pause(paused);
}

export const heard = {
  // `fits`: the whole stitch is as fine as this machine can have it, which is found once.
  begin({ scene, seed, fits }) {
    if (fits && scene === FINEST && resolution === null) {
      resolution = choose(tried => simulation.begin(tried, seed), () => simulation.step(1), () => performance.now());
    }
    const own = fits && scene === FINEST ? resolution : null;
    simulation.begin(own ? own.scene : scene, seed);
    begin(own);
  },
  exercise({ exercise }) {
    simulation.exercise(exercise, starts);
    begin();
  },
  aids({ aids }) {
    simulation.check(simulation.calls.page_set_aids(aids), 'aids');
  },
  // Scenes without the task have no ghost hands.
  ghost({ shown }) {
    simulation.calls.page_show_ghost(shown ? 1 : 0);
  },
  // A saved log, as bytes: it is played from its beginning.
  replay({ bytes }) {
    simulation.replay(new Uint8Array(bytes));
    begin(null, simulation.state().replay.steps);
  },
  seek({ step }) {
    simulation.seek(step);
    left = simulation.state().replay.steps - step;
    pause(paused); // the clock begins here
    postMessage({ sought: { step, hashes: simulation.hashes() } });
  },
  pause({ wanted }) {
    pause(wanted);
  },
  // For tests: so many steps at once, whatever the clock says.
  steps({ count }) {
    simulation.step(count);
    postMessage({ stepped: simulation.hashes() });
  },
  frame({ look, buffers }) {
    simulation.calls.page_set_camera(look.aside, look.down, look.away, look.aspect);
    const arrays = simulation.draw(buffers);
    const { steps, late, givenUp } = clock;
    const frame = { arrays, ghost: simulation.calls.page_ghost(), view: simulation.view(), state: simulation.state(),
      clock: { steps, late, givenUp, factor: clock.measure(performance.now()), stepTime, paused, memory: simulation.calls.memory.buffer.byteLength } };
    postMessage({ frame }, Object.values(arrays).map(array => array.buffer));
  },
  move({ side, turns, right, up, away }) {
    simulation.calls.page_move(side, turns ? 1 : 0, right, up, away);
  },
  pull({ side, axes, grain }) {
    simulation.calls.page_pull(side, ...axes, grain);
  },
  close({ side, closes }) {
    simulation.calls.page_close(side, closes ? 1 : 0);
  },
  clutch({ side, held }) {
    simulation.check(simulation.calls.page_clutch(side, held ? 1 : 0), 'clutch');
  },
  exchange({ side }) {
    simulation.check(simulation.calls.page_exchange(side), 'exchange');
  },
  track({ side, tracked }) {
    simulation.check(simulation.calls.page_track(side, tracked ? 1 : 0), 'controller');
  },
  pose({ side, position, orientation, jaw, clutched, seconds }) {
    simulation.calls.page_pose(side, ...position, ...orientation, jaw, clutched ? 1 : 0, seconds);
  },
  // The log as it is; `end` makes it whole, and no step follows. `shares` is handed back.
  log({ end, shares }) {
    if (end && !ended) {
      simulation.end();
      ended = true;
    }
    postMessage({ log: { blob: simulation.log(), hashes: simulation.hashes(), shares } });
  },
};

function guard(work) {
  try {
    work();
  } catch (error) {
    paused = ended = true;
    postMessage({ problem: error.message });
  }
}

async function load() {
  const begin = performance.now();
  simulation = await Simulation.load(await unpack(packed), text => console.log(text));
  starts = await unpack(packedStarts);
  simulation.takeGhost(await unpack(packedGhost));
  postMessage({ ready: { milliseconds: performance.now() - begin } });
}

onmessage = ({ data }) => guard(() => heard[data.name](data));
load().catch(error => postMessage({ problem: error.message }));
