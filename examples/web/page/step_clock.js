// Steps against wall time. A step is due a millisecond after the one before. When steps are more than BACKLOG behind, that time is
// given up: the session goes on in slow motion, and never tries to catch up with work that it has no time for.
export const BACKLOG = 50; // ms
export const LATE = 20; // ms after its time, from which on a step counts as late: more than a picture

export class StepClock {
  constructor() {
    this.steps = 0;
    this.late = 0;
    this.givenUp = 0; // ms
    this.next = null; // when the next step is due, ms; null: it stands still
    this.factor = 1; // of real time, over about a second
    this.measured = null;
  }

  start(now) {
    this.next = now;
    this.measured = { now, steps: this.steps };
  }

  stop() {
    this.next = null;
  }

  // Whether a step is due; it is made then.
  take(now) {
    if (this.next === null || now < this.next) return false;
    const behind = now - this.next;
    if (behind > BACKLOG) {
      this.givenUp += behind;
      this.next = now;
    }
    if (behind > LATE) this.late++;
    this.next += 1;
    this.steps++;
    return true;
  }

  measure(now) {
    if (this.next === null || now - this.measured.now < 100) return this.factor;
    const ratio = (this.steps - this.measured.steps) / (now - this.measured.now);
    this.factor += Math.min(1, (now - this.measured.now) / 1000) * (ratio - this.factor);
    this.measured = { now, steps: this.steps };
    return this.factor;
  }
}
