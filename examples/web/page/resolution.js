// How finely the thread of the whole stitch is divided: as finely as this machine can, by the time of its steps. The finest is tried
// for a second, since the browser's compiler is still at work in the first part of that; coarser ones only if it is too slow.
export const FINEST = 2; // the scene of page_begin with a thread of 300 segments
const COARSER = [[FINEST, 300], [3, 120], [4, 60]]; // scene, segments
const SHARE = 0.6; // of a millisecond: steps take longer while a knot is tied than at the start
const WARM = [600, 100], TRIED = 400; // ms before the time is taken, for the first scene and for others; of which it is taken

// `begin(scene)` begins it, `step()` makes a step, `clock()` gives ms. The scene, its segments, and ms a step of each that was tried.
export function choose(begin, step, clock) {
  const tried = [];
  for (const [scene, segments] of COARSER) {
    begin(scene);
    const start = clock();
    let now = start, from = start, steps = 0;
    const warm = WARM[tried.length > 0 ? 1 : 0];
    while (now - start < warm + TRIED) {
      step();
      now = clock();
      if (now - start < warm) from = now;
      else steps++;
    }
    tried.push({ segments, milliseconds: (now - from) / Math.max(1, steps) });
    if (tried[tried.length - 1].milliseconds <= SHARE) return { scene, segments, tried };
  }
  const [scene, segments] = COARSER[COARSER.length - 1];
  return { scene, segments, tried };
}
