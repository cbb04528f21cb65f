// Words beside and on the picture: how far the task is, the tool that the mouse has, what has happened, the time.
const $ = id => document.getElementById(id);
const KEPT = 4000; // ms that a caption stays
const DONE = 11; // the first of the phases that are final
const COACH = [19, 20]; // events of the coach, whose words are beside the picture anyway
const SLOW = 0.9; // of real time

const millimetres = value => (value === null ? '\u2013' : value.toFixed(2));

// Where to look for a tool that is not in the picture.
function whereIs({ place }) {
  if (!place || Math.max(Math.abs(place[0]), Math.abs(place[1])) < 1) return '';
  const [x, y] = place;
  if (Math.abs(x) > Math.abs(y)) return `, outside the picture on the ${x < 0 ? 'left' : 'right'}`;
  return `, outside the picture ${y < 0 ? 'below' : 'above'}`;
}

function set(id, words) {
  if ($(id).textContent !== words) $(id).textContent = words;
}

export class Captions {
  begin() {
    this.said = [];
    this.reported = false;
    this.knot = undefined;
    $('report').hidden = true;
    for (const id of ['goal', 'mistake', 'phase', 'measures', 'counts', 'score', 'caption', 'tool', 'clock']) set(id, '');
  }

  say(words, now) {
    this.said.push({ words, until: now + KEPT });
    this.said = this.said.slice(-3);
  }

  putTask(task) {
    set('phase', `${task.phase}${task.failure ? `: ${task.failure}` : task.stage ? `: ${task.stage}` : ''}, ${task.time.toFixed(1)} s`);
    set('measures', `off the marks, mm: in ${millimetres(task.marks[0])}, out ${millimetres(task.marks[1])}; slit ${task.gap.toFixed(2)} mm, ` +
      `tail ${task.tail.toFixed(1)} mm${task.tailSet ? ', set' : ''}`);
    set('counts', `throws ${task.throws}, seated ${task.seated}, hands changed ${task.transfers}, tails cut ${task.cut}`);
    set('score', `score ${task.score.toFixed(0)}, penalties ${task.penalties.toFixed(0)}, drops ${task.drops}`);
    if (task.number >= DONE && !this.reported && !this.isExercise) this.report(task);
    if (task.number < DONE && this.reported && !this.isExercise) this.reported = !($('report').hidden = true); // a time line that went back
  }

  // What to do next, how far that is, and what went wrong.
  putCoach(coach) {
    const far = coach && coach.distance > 0.5e-3 ? ` ${millimetres(1000 * coach.distance)} mm` : '';
    const turns = coach && coach.turns > 0.1 ? ` ${coach.turns.toFixed(1)} turns` : '';
    set('goal', coach ? `${coach.goal}${far}${turns}` : '');
    set('mistake', coach && coach.mistake ? `${coach.mistake} ${coach.remedy}` : '');
  }

  // The goal of an exercise, then what came of it; `note` counts an outcome and says how often it was passed.
  putExercise(exercise, note) {
    this.isExercise = Boolean(exercise);
    if (!exercise) return;
    set('score', exercise.goal);
    if (exercise.outcome === 0 || this.reported) return;
    this.reported = true;
    const passed = exercise.outcome === 1;
    set('result', passed ? 'Passed' : 'Not passed');
    const rows = exercise.measures.map(({ words, met }) => [met ? 'good' : 'missed', words]);
    if (note) rows.push(['so far', note(exercise, passed)]);
    this.putRows(rows);
  }

  // Of a scene without a task.
  putKnot(knot, now) {
    if (this.knot !== undefined && knot !== undefined && knot !== this.knot) this.say(`knot: ${knot}`, now);
    this.knot = knot;
    set('phase', knot === undefined ? '' : `knot: ${knot}`);
    for (const id of ['measures', 'counts', 'score']) set(id, '');
  }

  // Null: the scene has one resolution only.
  putResolution(resolution) {
    this.resolution = resolution;
    if (!resolution || resolution.tried.length === 1) return;
    const [first] = resolution.tried;
    this.say(`thread of ${resolution.segments} segments instead of ${first.segments}, with which this machine takes ` +
      `${first.milliseconds.toFixed(2)} ms a step`, performance.now());
  }

  report(task) {
    this.reported = true;
    set('result', task.failure ? `Failed: ${task.failure}` : 'Done');
    const rows = [['time', `${task.time.toFixed(1)} s`], ['score', task.score.toFixed(0)], ['penalties', task.penalties.toFixed(0)],
      ['off the marks', task.marks.map(m => `${millimetres(m)} mm`).join(', ')], ['slit', `${task.gap.toFixed(2)} mm`],
      ['tail', `${task.tail.toFixed(1)} mm`], ['throws seated', `${task.seated} of 3`], ['needle dropped', `${task.drops} times`]];
    if (this.resolution) rows.push(['segments of the thread', String(this.resolution.segments)]);
    if (task.lost > 0) rows.push(['time that was left out', `${task.lost.toFixed(2)} s`]);
    this.putRows(rows);
  }

  putRows(rows) {
    $('facts').replaceChildren(...rows.flatMap(([name, value]) => {
      const [dt, dd] = [document.createElement('dt'), document.createElement('dd')];
      dt.textContent = name;
      dd.textContent = value;
      return [dt, dd];
    }));
    $('report').hidden = false;
  }

  putTool(tool, side, isTaken, isPaused, isPlayed) {
    const name = side === 0 ? 'left' : 'right';
    const hold = tool.holds ? `, holds ${tool.holds}` : '';
    set('tool', `${name} ${tool.shears ? 'shears' : 'tool'}, jaws ${tool.opening < 0.5 ? 'closed' : 'open'}${hold}${tool.clutched ? ', stays' : ''}${whereIs(tool)}` +
      `${isPaused ? ' \u2013 paused' : isTaken || tool.tracked || isPlayed ? '' : ' \u2013 click into the picture to take it'}`);
    const shown = tool.place && tool.foot && !tool.tracked;
    $('mark').style.display = shown ? '' : 'none';
    if (!shown) return;
    const { clientWidth: width, clientHeight: height } = $('canvas');
    const [[x, y], [u, v]] = [tool.place, tool.foot].map(([a, b]) => [0.5 * (1 + a) * width, 0.5 * (1 - b) * height]);
    const put = (id, values) => Object.entries(values).forEach(([key, value]) => $(id).setAttribute(key, value.toFixed(1)));
    put('drop', { x1: x, y1: y, x2: u, y2: v });
    put('tip', { x1: x - 7, y1: y, x2: x + 7, y2: y });
    put('foot', { x: u - 3, y: v - 1.5 });
  }

  // `late` and slow motion are said as they are: a session that is late is not one that is in time.
  putClock(clock) {
    const slow = !clock.paused && clock.factor < SLOW;
    const words = clock.steps === 0 ? '' : `${slow ? `slow motion, ${clock.factor.toFixed(2)} of real time; ` : ''}` +
      `${(clock.steps / 1000).toFixed(1)} s, ${clock.stepTime === null ? '\u2013' : clock.stepTime.toFixed(2)} ms a step, ` +
      `late ${(100 * clock.late / clock.steps).toFixed(1)} %`;
    set('clock', words);
    $('clock').classList.toggle('slow', slow);
  }

  // For a panel in a headset: what the page says, where there is something.
  lines() {
    const slow = $('clock').classList.contains('slow') ? $('clock').textContent.split(';')[0] : '';
    const words = { goal: $('goal').textContent, mistake: $('mistake').textContent, phase: $('phase').textContent, caption: $('caption').textContent, slow };
    if (!$('report').hidden) words.caption = $('result').textContent;
    return Object.entries(words).filter(([, text]) => text !== '').map(([kind, text]) => ({ kind, words: text }));
  }

  show({ state, clock }, side, isTaken, now, note) {
    for (const event of state.events) if (!COACH.includes(event.kind)) this.say(event.words, now);
    this.putCoach(state.coach);
    this.isExercise = Boolean(state.exercise);
    if (state.task) this.putTask(state.task);
    else this.putKnot(state.knot, now);
    this.putExercise(state.exercise, state.replay ? null : note);
    this.putTool(state.tools[side], side, isTaken, clock.paused, Boolean(state.replay));
    this.putClock(clock);
    this.said = this.said.filter(caption => caption.until > now);
    set('caption', this.said.map(caption => caption.words).join('; '));
  }
}
