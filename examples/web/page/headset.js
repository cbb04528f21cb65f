// A headset by WebXR: both eyes see the scene before them, larger than it is, and each controller holds a tool. The trigger closes
// its jaws; while the grip button is held the tool stays (and the thumbstick makes the scene larger or smaller); A or X exchanges
// it.
import { Placement, product, rotate } from './pose.js';

const SCALE = 5, SMALLEST = 1, LARGEST = 10;
const GROWTH = 0.8; // 1/s, at the end of the thumbstick
const DEAD = 0.3; // of the thumbstick
const BEFORE = 0.5, BELOW = 0.3; // m from the head
const TIP = 0.12; // m, from the controller to its tool's tip
const TRIGGER = 0, GRIP = 1, EXCHANGE = 4; // buttons of xr-standard
const FULL_FORCE = 2; // N, of the strongest pulse
const PULSE = 30; // ms
const NEAR = 0.03, FAR = 20; // m
const DARK = [0.012, 0.013, 0.016];
const SIDES = { left: 0, right: 1 };

const values = p => [p.x, p.y, p.z];

export class Headset {
  // `page` has send, renderer, and takes pictures by exchange(now).
  constructor(page) {
    this.page = page;
    this.session = this.placement = this.last = null;
    this.scale = SCALE;
    this.pressed = [false, false];
    this.tracked = [false, false];
  }

  static async isThere() {
    return Boolean(navigator.xr) && navigator.xr.isSessionSupported('immersive-vr').catch(() => false);
  }

  async enter() {
    const { gl } = this.page.renderer;
    const session = await navigator.xr.requestSession('immersive-vr');
    await gl.makeXRCompatible();
    this.layer = new XRWebGLLayer(session, gl, { antialias: false });
    session.updateRenderState({ baseLayer: this.layer, depthNear: NEAR, depthFar: FAR });
    this.space = await session.requestReferenceSpace('local');
    session.addEventListener('end', () => this.leave());
    Object.assign(this, { session, placement: null, last: null });
    session.requestAnimationFrame((now, frame) => this.picture(now, frame));
  }

  leave() {
    this.session = null;
    this.forget();
  }

  // Both hands are the mouse's again.
  forget() {
    this.tracked.forEach((tracked, side) => {
      if (tracked) this.page.send({ name: 'track', side, tracked: false });
    });
    this.tracked = [false, false];
  }

  // A new scene has no controllers yet.
  renew() {
    this.tracked = [false, false];
    this.placement = null;
  }

  // Before the head, wherever that looks.
  place(head, target) {
    const { x, y, z, w } = head.transform.orientation;
    const forward = rotate([w, x, y, z], [0, 0, -1]);
    const turn = Math.atan2(-forward[0], -forward[2]);
    const [px, py, pz] = values(head.transform.position);
    const at = [px - BEFORE * Math.sin(turn), py - BELOW, pz - BEFORE * Math.cos(turn)];
    this.turn = turn;
    this.placement = new Placement(target, at, turn, this.scale);
  }

  grow(axes, seconds) {
    const pull = axes && Math.abs(axes[3]) > DEAD ? -axes[3] : 0;
    if (pull === 0) return;
    this.scale = Math.min(Math.max(this.scale * Math.exp(GROWTH * pull * seconds), SMALLEST), LARGEST);
    const { target, place } = this.placement;
    this.placement = new Placement(target, place, this.turn, this.scale);
  }

  exchange(side, isDown) {
    if (isDown && !this.pressed[side]) this.page.send({ name: 'exchange', side });
    this.pressed[side] = isDown;
  }

  lead(frame, source, seconds) {
    const side = SIDES[source.handedness], pad = source.gamepad;
    const pose = side === undefined || !pad ? null : frame.getPose(source.targetRaySpace, this.space);
    if (!pose) return; // it stays where it was
    const { x, y, z, w } = pose.transform.orientation;
    const ahead = rotate([w, x, y, z], [0, 0, -TIP]);
    const tip = values(pose.transform.position).map((n, i) => n + ahead[i]);
    const clutched = Boolean(pad.buttons[GRIP] && pad.buttons[GRIP].pressed);
    if (clutched) this.grow(pad.axes, seconds);
    this.exchange(side, Boolean(pad.buttons[EXCHANGE] && pad.buttons[EXCHANGE].pressed));
    if (!this.tracked[side]) this.page.send({ name: 'track', side, tracked: true });
    this.tracked[side] = true;
    this.page.send({ name: 'pose', side, position: this.placement.toScene(tip), orientation: this.placement.orientationToScene([w, x, y, z]),
      jaw: 1 - pad.buttons[TRIGGER].value, clutched, seconds });
    this.pulse(side, pad);
  }

  // What the tool feels.
  pulse(side, pad) {
    const shown = this.page.shown;
    const force = shown ? shown.state.tools[side].felt : 0;
    const actuator = pad.hapticActuators && pad.hapticActuators[0];
    if (actuator && force > 0.05 * FULL_FORCE) actuator.pulse(Math.min(1, force / FULL_FORCE), PULSE);
  }

  drawEyes(frame, head, view) {
    const { renderer } = this.page;
    const stage = this.placement.matrix();
    const lamp = { ...view, clear: 0 };
    renderer.drawShadows(lamp);
    for (const eye of head.views) {
      const at = this.layer.getViewport(eye);
      const seen = product(product(eye.projectionMatrix, eye.transform.inverse.matrix), stage);
      renderer.drawEye({ ...lamp, seen, eye: this.placement.toScene(values(eye.transform.position)) }, this.layer.framebuffer,
        [at.x, at.y, at.width, at.height], DARK);
    }
  }

  picture(now, frame) {
    if (!this.session) return;
    this.session.requestAnimationFrame((later, next) => this.picture(later, next));
    const head = frame.getViewerPose(this.space);
    const seconds = this.last === null ? 0.014 : Math.min(0.1, (now - this.last) / 1000);
    this.last = now;
    const view = this.page.exchange(now);
    if (!head || !view) return;
    if (!this.placement) this.place(head, view.target);
    for (const source of this.session.inputSources) this.lead(frame, source, seconds);
    this.drawEyes(frame, head, view);
  }
}
