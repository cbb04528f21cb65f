// A headset by WebXR: both eyes see the scene before them, larger than it is, and each controller holds a tool. The trigger closes
// its jaws; while the grip button is held the tool stays (and the thumbstick makes the scene larger or smaller); A or X exchanges
// it; B or Y brings the scene before the head again; a press of the thumbstick adjusts where the tool is in the hand (tool_offset.js).
// A hand that is tracked does the same by gestures (tracked_hand.js).
import { mirrorScene } from './mirror.js';
import { Panel } from './panel.js';
import { Placement, product, rotate, widen } from './pose.js';
import { ToolOffset, toolPose } from './tool_offset.js';
import { JOINTS, TrackedHand } from './tracked_hand.js';
import { PORTS, throughPort } from './trocar.js';

const SCALE = 5, SMALLEST = 1, LARGEST = 10;
const GROWTH = 0.8; // 1/s, at the end of the thumbstick
const DEAD = 0.3; // of the thumbstick
const BEFORE = 0.5, BELOW = { seated: 0.3, standing: 0.42 }; // m from the head
const TRIGGER = 0, GRIP = 1, STICK = 3, EXCHANGE = 4, AGAIN = 5; // buttons of xr-standard
const FULL_FORCE = 2; // N, of the strongest pulse
const PULSE = 30; // ms
const NEAR = 0.03, FAR = 20; // m
const LIT = 1.6; // slope of the lamp's shadows: eyes see more than a laparoscope does
const CLEAR = 0.25; // m: what a tool has nearer to an eye is seen through
const DARK = [0.012, 0.013, 0.016];
const SIDES = { left: 0, right: 1 };

const values = p => [p.x, p.y, p.z];

export class Headset {
  // `page` has send, renderer, settings, captions, and takes pictures by exchange(now).
  constructor(page) {
    this.page = page;
    this.session = this.placement = this.last = this.panel = null;
    this.hands = [new TrackedHand(false), new TrackedHand(true)];
    this.offsets = ['left', 'right'].map(hand => new ToolOffset(page.settings, hand));
    this.scale = SCALE;
    this.pressed = [false, false];
    this.tracked = [false, false];
  }

  static async isThere() {
    return Boolean(navigator.xr) && navigator.xr.isSessionSupported('immersive-vr').catch(() => false);
  }

  async enter() {
    const { gl } = this.page.renderer;
    const session = await navigator.xr.requestSession('immersive-vr', { optionalFeatures: ['hand-tracking'] });
    await gl.makeXRCompatible();
    this.panel = this.panel || new Panel(gl);
    this.layer = new XRWebGLLayer(session, gl, { antialias: false });
    session.updateRenderState({ baseLayer: this.layer, depthNear: NEAR, depthFar: FAR });
    this.space = await session.requestReferenceSpace('local');
    session.addEventListener('end', () => this.leave());
    Object.assign(this, { session, placement: null, last: null });
    session.requestAnimationFrame((now, frame) => this.picture(now, frame));
  }

  leave() {
    this.session = null;
    for (const offset of this.offsets) offset.end();
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
    const below = this.page.settings.standing ? BELOW.standing : BELOW.seated;
    const at = [px - BEFORE * Math.sin(turn), py - below, pz - BEFORE * Math.cos(turn)];
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

  // What a controller says: null while it is not seen.
  readController(frame, { targetRaySpace, gamepad }) {
    const pose = gamepad ? frame.getPose(targetRaySpace, this.space) : null;
    if (!pose) return null;
    const isDown = button => Boolean(gamepad.buttons[button] && gamepad.buttons[button].pressed);
    const { x, y, z, w } = pose.transform.orientation;
    return { position: values(pose.transform.position), orientation: [w, x, y, z], jaw: 1 - gamepad.buttons[TRIGGER].value, clutched: isDown(GRIP),
      exchanges: isDown(EXCHANGE), again: isDown(AGAIN), adjusts: isDown(STICK), axes: gamepad.axes };
  }

  readHand(frame, { hand }, side) {
    const at = {};
    for (const name of JOINTS) {
      const space = hand.get(name);
      const pose = space ? frame.getJointPose(space, this.space) : null;
      at[name] = pose ? values(pose.transform.position) : null;
    }
    return this.hands[side].read(at);
  }

  // Of the scene; through its port, if it has one, by a turn of the tool, whose tip is where the last picture has it: a clutch has
  // taken it away from the hand.
  poseInScene(side, said) {
    const { position, orientation } = toolPose(said, this.offsets[side]);
    const tip = this.placement.toScene(position);
    const turned = this.placement.orientationToScene(orientation);
    const { shown, settings } = this.page;
    const through = settings.ports && shown ? throughPort(PORTS[side], shown.state.tools[side].target, turned) : turned;
    return through && { position: tip, orientation: through };
  }

  lead(frame, source, seconds) {
    const side = SIDES[source.handedness];
    if (side === undefined) return;
    const said = source.hand ? this.readHand(frame, source, side) : this.readController(frame, source);
    if (!said) return; // it stays where it was
    const offset = this.offsets[side];
    offset.read(Boolean(said.adjusts), said.axes, seconds);
    if (said.clutched && !offset.isAdjusted) this.grow(said.axes, seconds);
    if (said.again) this.placement = null; // anew with the next picture
    this.exchange(side, said.exchanges);
    const pose = this.placement && this.poseInScene(side, said);
    if (!pose) return;
    if (!this.tracked[side]) this.page.send({ name: 'track', side, tracked: true });
    this.tracked[side] = true;
    this.page.send({ name: 'pose', side, ...pose, jaw: said.jaw, clutched: said.clutched, seconds });
    if (source.gamepad) this.pulse(side, source.gamepad);
  }

  // What the tool feels.
  pulse(side, pad) {
    const shown = this.page.shown;
    const force = shown ? shown.state.tools[side].felt : 0;
    const actuator = pad.hapticActuators && pad.hapticActuators[0];
    if (actuator && force > 0.05 * FULL_FORCE) actuator.pulse(Math.min(1, force / FULL_FORCE), PULSE);
  }

  drawEyes(frame, head, view) {
    const { renderer, mirrored } = this.page;
    const stage = mirrored ? mirrorScene(this.placement.matrix()) : this.placement.matrix();
    const lit = { ...view, light: widen(view.light, LIT) };
    renderer.drawShadows(lit);
    lit.clear = CLEAR / this.placement.scale;
    for (const eye of head.views) {
      const at = this.layer.getViewport(eye);
      const room = product(eye.projectionMatrix, eye.transform.inverse.matrix);
      const from = this.placement.toScene(values(eye.transform.position));
      if (mirrored) from[0] = -from[0];
      renderer.drawEye({ ...lit, seen: product(room, stage), eye: from }, this.layer.framebuffer, [at.x, at.y, at.width, at.height], DARK,
        undefined, () => this.panel.draw(room, this.placement.place, this.turn));
    }
  }

  // On the panel.
  lines() {
    const adjusted = this.offsets.filter(offset => offset.isAdjusted).map(offset => ({ kind: 'offset', words: offset.words() }));
    return [...adjusted, ...this.page.captions.lines()];
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
    if (!this.placement) this.place(head, view.target);
    this.panel.write(this.lines());
    this.drawEyes(frame, head, view);
  }
}
