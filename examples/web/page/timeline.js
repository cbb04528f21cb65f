// The time line under a log that is played: where it is, and the way to any other step.
const STEP = 1e-3; // s
const JUMP = 1000, SMALL_JUMP = 100; // steps, by a key

export class Timeline {
  // `seek(step)` goes there; `isBusy()`: the one before has not ended.
  constructor(elementOf, seek) {
    this.bar = elementOf('line');
    this.box = elementOf('timeline');
    this.words = elementOf('line-time');
    this.seek = seek;
    this.wanted = null; // asked for, not yet there
    this.next = null; // asked for meanwhile
    this.bar.addEventListener('input', () => this.ask(Number(this.bar.value)));
  }

  begin() {
    this.wanted = this.next = null;
    this.box.hidden = true;
  }

  // One at a time: a bar that is dragged asks for many.
  ask(step) {
    const to = Math.min(Math.max(Math.round(step), 0), this.steps);
    if (this.wanted !== null) {
      this.next = to;
      return;
    }
    this.wanted = to;
    this.seek(to);
  }

  arrive() {
    const { next } = this;
    this.wanted = this.next = null;
    if (next !== null) this.ask(next);
  }

  jump(direction, isSmall) {
    if (!this.box.hidden) this.ask((this.wanted ?? this.step) + direction * (isSmall ? SMALL_JUMP : JUMP));
  }

  // `replay` as the state has it; nothing: hands are at work.
  show({ replay, steps }) {
    this.box.hidden = !replay;
    if (!replay) return;
    Object.assign(this, { step: steps, steps: replay.steps });
    this.bar.max = replay.steps;
    if (this.wanted === null) this.bar.value = steps;
    const words = `${(STEP * steps).toFixed(2)} of ${replay.length.toFixed(2)} s` +
      `${replay.differs ? ', not as recorded from here on' : steps >= replay.steps ? `, the end${replay.whole ? '' : ' is missing'}` : ''}`;
    if (this.words.textContent !== words) this.words.textContent = words;
    this.bar.setAttribute('aria-valuetext', words);
  }
}
