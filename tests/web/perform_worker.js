// The page's worker with the scripted surgeon in it (perform.h).
import { begin, heard, simulation } from '../../examples/web/page/worker.js';

const WANTED = 10;

heard.perform = ({ seed }) => {
  simulation.check(simulation.calls.page_perform(seed), 'the surgeon cannot begin');
  begin();
};

heard.wanted = () => {
  const { calls } = simulation;
  const hands = [0, 1].map(side => [...new Float64Array(calls.memory.buffer, calls.page_wanted(side), WANTED)]);
  postMessage({ wanted: { hands, doing: simulation.textAt(calls.page_doing()), hashes: simulation.hashes() } });
};
