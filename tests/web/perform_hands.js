// Moves the controllers of the stand-in (stand_in_xr.js) to where the surgeon of perform_worker.js wants its tools: once in each
// frame of the headset, by the place that the page gave the scene, and by what the controllers have, not by the page's calls.
// In lockstep: between two frames the session makes the steps of one frame at 90 Hz, however long the picture takes.
// performer.film = { begin, end, every } (s of the session): what both eyes see then is added to performer.pictures.
(() => {
  const TIP = 0.12; // m, from the controller to its tool's tip, as docs/guides/web.md has it
  const STEPS = 11; // a frame
  const PRESSED = 4, PATIENCE = 40; // frames: of a press; until the next one
  const times = ([a, b, c, d], [e, f, g, h]) =>
    [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e];
  const turn = (q, v) => times(times(q, [0, ...v]), [q[0], -q[1], -q[2], -q[3]]).slice(1);
  const waiting = [0, 0];
  let now = 0;

  function place(hand, [x, y, z, qw, qx, qy, qz, opening]) {
    const { target, place: at, scale, turned } = window.suturing.headset.placement;
    const orientation = times(turned, [qw, qx, qy, qz]);
    const tip = turn(turned, [x - target[0], y - target[1], z - target[2]]).map((n, i) => at[i] + scale * n);
    const ahead = turn(orientation, [0, 0, -TIP]);
    Object.assign(hand, { orientation, position: tip.map((n, i) => n - ahead[i]), trigger: 1 - opening });
  }

  // Only pictures that are looked at are drawn: the processor takes 0.1 s for both eyes.
  function drawSome(renderer) {
    for (const name of ['drawShadows', 'drawEye']) {
      const draw = renderer[name].bind(renderer);
      renderer[name] = (...what) => window.standIn.asked && draw(...what);
    }
  }

  // A press, and time for the tool to be exchanged, before the next one.
  function exchange(hand, side, wantsShears, isShears) {
    if (waiting[side] > 0) waiting[side]--;
    else if (wantsShears !== isShears) waiting[side] = PATIENCE;
    hand.button = waiting[side] > PATIENCE - PRESSED;
  }

  const performer = window.performer = {
    ended: false, frames: 0, seconds: 0, seed: null, film: { begin: 0, end: Infinity, every: Infinity }, pictures: [],
    begin(seed) {
      const page = window.suturing;
      page.captions.begin();
      page.pause(true);
      drawSome(page.renderer);
      this.next = this.film.begin;
      this.seed = seed;
      window.standIn.before = () => new Promise(done => {
        if (this.seconds === 0) this.beginSession();
        this.takePicture();
        page.hearWanted = wanted => {
          this.lead(wanted);
          this.askForPicture();
          now += STEPS;
          done(now);
        };
        const count = page.headset.placement && !this.ended ? STEPS : 0;
        this.seconds += 1e-3 * count;
        page.send({ name: 'steps', count });
        page.send({ name: 'wanted' });
      });
    },
    // At the start of a frame, so that each run has the same frames; until the first step the headset forgets when its last one was.
    beginSession() {
      const page = window.suturing;
      page.headset.last = null;
      if (this.seed === null) return;
      page.headset.renew();
      page.send({ name: 'perform', seed: this.seed });
      this.seed = null;
    },
    askForPicture() {
      if (this.seconds < Math.max(this.next, 2e-3 * STEPS) || this.seconds > this.film.end) return; // by then the page shows this session
      this.next += this.film.every;
      window.standIn.asked = true;
    },
    takePicture() {
      const { standIn } = window;
      if (standIn.picture) this.pictures.push({ seconds: this.seconds, picture: standIn.picture });
      standIn.picture = null;
    },
    lead({ hands, doing }) {
      const page = window.suturing;
      Object.assign(this, { doing, ended: hands[0][9] > 0 });
      if (!page.headset.placement || !page.shown) return;
      ['left', 'right'].forEach((name, side) => {
        const hand = window.standIn.hands[name];
        place(hand, hands[side]);
        exchange(hand, side, hands[side][8] > 0, page.shown.state.tools[side].shears);
      });
      this.frames++;
    },
  };
})();
