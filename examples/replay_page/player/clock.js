// The time that is shown, and how it goes on.

export class Clock {
  constructor(times, changed) {
    this.times = times;
    this.changed = changed;
    this.time = times[0];
    this.speed = 1;
    this.playing = false;
    this.last = null;
  }

  get end() {
    return this.times[this.times.length - 1];
  }

  // The last frame at or before the time, and how far it is to the next.
  place() {
    let low = 0;
    let high = this.times.length - 1;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (this.times[middle] <= this.time + 1e-9) low = middle;
      else high = middle - 1;
    }
    const next = this.times[low + 1];
    const share = next === undefined ? 0 : (this.time - this.times[low]) / (next - this.times[low]);
    return { frame: low, share: Math.max(0, share) };
  }

  go(time) {
    this.time = Math.min(Math.max(time, this.times[0]), this.end);
    this.changed();
  }

  // To another frame, and stays there.
  step(frames) {
    this.pause();
    const { frame, share } = this.place();
    const begin = frames < 0 && share > 1e-6 ? frame + 1 : frame;
    this.go(this.times[Math.min(Math.max(begin + frames, 0), this.times.length - 1)]);
  }

  play() {
    if (this.time >= this.end) this.time = this.times[0];
    this.playing = true;
    this.last = null;
    this.changed();
  }

  pause() {
    this.playing = false;
    this.changed();
  }

  // Called once a picture; `now` in milliseconds.
  tick(now) {
    if (!this.playing) return;
    const passed = this.last === null ? 0 : (now - this.last) / 1000;
    this.last = now;
    this.time = Math.min(this.time + this.speed * passed, this.end);
    if (this.time >= this.end) this.playing = false;
  }
}
