// Joints of a hand that a test moves: { position (of the wrist), orientation (w, x, y, z), pinch (m, thumb to index finger), fist (0 to
// 1, of the other three fingers), little (its tip is at the thumb's) }. Unturned, its palm is down and its fingers point along -z.
(() => {
  const ROOTS = { index: [-0.025, 0, -0.09], middle: [0, 0.003, -0.092], ring: [0.02, 0, -0.088], pinky: [0.038, -0.004, -0.08] };
  const LONG = 0.075, CURLED = [0, -0.03, 0.05]; // m: a finger; where the tip of a curled one is, from its knuckle
  const KNUCKLE = 'finger-phalanx-proximal';

  function turn([w, x, y, z], v) {
    const across = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const t = across([x, y, z], v).map(n => 2 * n);
    return v.map((n, i) => n + w * t[i] + across([x, y, z], t)[i]);
  }

  function jointsOf({ position, orientation, pinch, fist, little }, handedness) {
    const local = { wrist: [0, 0, 0] };
    for (const [finger, root] of Object.entries(ROOTS)) {
      const bend = finger === 'index' ? 0 : fist;
      local[`${finger}-${KNUCKLE}`] = root;
      local[`${finger}-finger-tip`] = root.map((n, i) => n + (1 - bend) * [0, -0.02, -LONG][i] + bend * CURLED[i]);
    }
    const tip = local['index-finger-tip'];
    local['thumb-tip'] = [tip[0] - pinch, tip[1], tip[2]];
    if (little) local['pinky-finger-tip'] = local['thumb-tip'];
    const mirror = handedness === 'left' ? -1 : 1;
    return Object.fromEntries(Object.entries(local).map(([name, [x, y, z]]) => [name, turn(orientation, [mirror * x, y, z]).map((n, i) => n + position[i])]));
  }

  window.standInHand = { jointsOf, turn };
})();
