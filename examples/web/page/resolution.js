// How finely the thread of the whole stitch is divided: as finely as this machine can, by the time of its steps. The first scene
// is tried for most of a second, since the compiler of the browser needs some of that; coarser ones only if it is too slow.
export const FINEST = 2; // the scene of page_begin with a thread of 300 segments
const COARSER = [[FINEST, 300], [3, 120], [4, 60]]; // scene, segments
const SHARE = 0.6; // of a millisecond: steps take longer while a knot is tied than at the start
const TRIED = 400, WARM = 100; // ms

// `begin(scene)` begins it, `step()` makes a step, `clock()` gives ms. The scene, its segments, and ms a step of each that was tried.
export function choose(begin, step, clock) {
  const tried = [];
  for (const [scene, segments] of COARSER) {
    begin(scene);
    const start = clock();
    let now = start, from = start, steps = 0;
    while (now - start < TRIED) {
      step();
      now = clock();
      if (now - start < WARM) from = now;
      else steps++;
    }
    tried.push({ segments, milliseconds: (now - from) / Math.max(1, steps) });
    if (tried[tried.length - 1].milliseconds <= SHARE) return { scene, segments, tried };
  }
  const [scene, segments] = COARSER[COARSER.length - 1];
  return { scene, segments, tried };
}
