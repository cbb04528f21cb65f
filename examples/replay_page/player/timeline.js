// The line of time below: phases, forces, a tick for each event, and the list of these.

const classNames = {
  hold: 'held, let go', wall: 'a wall', cut: 'cut', tool: 'tool exchanged', warn: 'slips, leaves', bad: 'lost, torn', step: 'a step cut short or paused',
};

const percent = (time, end) => `${end > 0 ? 100 * time / end : 0}%`;

function add(parent, name, words, settings = {}) {
  const element = document.createElement(name);
  element.textContent = words;
  Object.assign(element, settings);
  parent.append(element);
  return element;
}

function putPhases(session, end) {
  const band = document.getElementById('phases');
  session.phases.forEach((phase, i) => {
    const span = add(band, 'span', phase.name, { title: `${phase.name}: ${phase.from.toFixed(2)} s to ${phase.to.toFixed(2)} s` });
    span.style.left = percent(phase.from, end);
    span.style.width = percent(phase.to - phase.from, end);
    span.style.background = `var(--p${i % 6})`;
  });
}

function putCurves(session, end) {
  const svg = document.getElementById('curves');
  const most = Math.max(0.1, ...session.forces.left, ...session.forces.right);
  for (const side of ['left', 'right']) {
    const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    const points = session.forces[side].map((force, i) =>
      `${(1000 * session.times[i] / (end || 1)).toFixed(1)} ${(98 - 94 * force / most).toFixed(1)}`);
    path.setAttribute('d', 'M' + points.join('L'));
    path.style.stroke = `var(--${side})`;
    svg.append(path);
  }
  return most;
}

function putLegend(session, most) {
  const legend = document.getElementById('legend');
  for (const [name, words] of Object.entries(classNames)) {
    const count = session.events.filter(e => e.class === name).length;
    if (count > 0) add(legend, 'span', `${words}: ${count}`, { className: name });
  }
  for (const side of ['left', 'right']) {
    add(legend, 'span', `force on the ${side} hand, up to ${most.toFixed(1)} N`, { className: 'line' })
      .style.setProperty('--mark', `var(--${side})`);
  }
}

// Steps that were cut short have ticks only: they tell of the simulation, not of the task.
export const isListed = event => event.class !== 'step';

// `go` is called with the time of an event that is chosen. Returns what marks the events that were before a time.
export function putTimeline(session, end, go) {
  const ticks = document.getElementById('ticks');
  const list = document.getElementById('events');
  putPhases(session, end);
  putLegend(session, putCurves(session, end));
  for (const event of session.events) {
    add(ticks, 'span', '', { className: event.class }).style.left = percent(event.time, end);
  }
  const listed = session.events.filter(isListed);
  const buttons = listed.map(event => {
    const button = add(add(list, 'li', ''), 'button', '', { type: 'button', className: event.class });
    add(button, 'span', event.time.toFixed(2));
    add(button, 'span', event.words);
    button.addEventListener('click', () => go(event.time));
    return button;
  });
  let shown = null;
  return time => {
    const past = listed.filter(e => e.time <= time + 1e-9).length;
    if (past === shown) return;
    shown = past;
    buttons.forEach((button, i) => {
      button.classList.toggle('past', i < past);
      button.classList.toggle('last', i === past - 1);
    });
    const last = buttons[past - 1];
    if (last) list.scrollTop = last.offsetTop - list.offsetTop - list.clientHeight / 2;
    else list.scrollTop = 0;
  };
}
