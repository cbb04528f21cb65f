// Left-handed: the page shows the scene in a mirror (x of the scene is -x), and each hand leads the tool that is on its own side
// there. The session itself is not mirrored: its log is one of any session.
const OTHER = { left: 'right', right: 'left' };

// Sides, not what is left.
export const mirrorWords = text => text.replace(/\b(left|right)(?= tool| wrist| hand|-handed| shears)/g, side => OTHER[side]);

const mirrorPoint = ([x, ...rest]) => [-x, ...rest];

// Messages to the worker that have a side or a direction in them.
export function mirrorMessage(message) {
  const m = { ...message };
  if (m.side !== undefined) m.side = 1 - m.side;
  if (m.name === 'move') {
    m.right = -m.right;
    if (m.turns) m.away = -m.away; // the wheel rolls
  }
  if (m.name === 'pull') m.axes = m.axes.map((n, i) => ([0, 4, 5].includes(i) ? -n : n)); // right; turn, roll
  if (m.name === 'pose') {
    const [w, x, y, z] = m.orientation;
    Object.assign(m, { position: mirrorPoint(m.position), orientation: [w, x, -y, -z] });
  }
  if (m.look) m.look = { ...m.look, aside: -m.look.aside };
  return m;
}

function mirrorTool(tool) {
  const t = { ...tool };
  for (const name of ['position', 'target', 'place', 'foot']) if (t[name]) t[name] = mirrorPoint(t[name]);
  const [w, x, y, z] = t.orientation;
  t.orientation = [w, x, -y, -z];
  return t;
}

// What the worker says of the session.
export function mirrorState(state) {
  const s = { ...state, tools: [...state.tools].reverse().map(mirrorTool), events: state.events.map(e => ({ ...e, words: mirrorWords(e.words) })) };
  if (s.coach) {
    s.coach = { ...s.coach };
    for (const name of ['goal', 'mistake', 'remedy']) s.coach[name] = mirrorWords(s.coach[name]);
    if (s.coach.point) s.coach.point = mirrorPoint(s.coach.point);
  }
  return s;
}

// A matrix that places points of the scene, column by column, before a mirrored one.
export function mirrorScene(matrix) {
  return matrix.map((n, i) => (i < 4 ? -n : n));
}

// A picture whose right is left.
export function mirrorPicture(matrix) {
  return matrix.map((n, i) => (i % 4 === 0 ? -n : n));
}
