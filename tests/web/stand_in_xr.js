// A stand-in for navigator.xr: a headset whose two eyes are the halves of the canvas, and two controllers that a test moves:
// standIn.hands.right = { position, orientation (w, x, y, z), trigger, grip, stick, button, axes }. Metres, y up, the head looks along -z.
// standIn.tracked: both are hands instead, whose joints standIn.fingers.right makes (stand_in_hand.js).
// With standIn.before, which makes a promise, a frame waits for that; standIn.asked: what both eyes see in the next frame becomes
// standIn.picture.
(() => {
  const EYES = 0.064;
  const matrixOf = (position, [w, x, y, z]) => new Float32Array([
    1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0,
    2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0,
    2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0, ...position, 1]);
  const point = ([x, y, z], w = 1) => ({ x, y, z, w });
  const transform = (position, orientation) => {
    const [w, x, y, z] = orientation;
    const back = matrixOf([0, 0, 0], [w, -x, -y, -z]);
    const moved = [0, 1, 2].map(i => -(back[i] * position[0] + back[4 + i] * position[1] + back[8 + i] * position[2]));
    return { position: point(position), orientation: { w, x, y, z }, matrix: matrixOf(position, orientation),
      inverse: { matrix: matrixOf(moved, [w, -x, -y, -z]) } };
  };
  const perspective = (slope, aspect, near, far) => new Float32Array([1 / (slope * aspect), 0, 0, 0, 0, 1 / slope, 0, 0,
    0, 0, -(far + near) / (far - near), -1, 0, 0, -2 * far * near / (far - near), 0]);
  const hand = x => ({ position: [x, 1.2, -0.3], orientation: [1, 0, 0, 0], trigger: 0, grip: false, stick: false, button: false, axes: [0, 0, 0, 0], seen: true });

  const finger = x => ({ position: [x, 1.2, -0.3], orientation: [1, 0, 0, 0], pinch: 0.06, fist: 0, little: false, seen: true });

  const standIn = window.standIn = {
    head: { position: [0, 1.5, 0], orientation: [Math.cos(-0.27), Math.sin(-0.27), 0, 0] }, // looks 31 degrees down
    hands: { left: hand(-0.2), right: hand(0.2) }, pulses: 0, strongest: 0, frames: 0, session: null, before: null, asked: false, picture: null, tracked: false,
    fingers: { left: finger(-0.2), right: finger(0.2) } };

  class Layer {
    constructor(session, gl) {
      this.gl = gl;
      this.framebuffer = null;
    }

    getViewport(view) {
      const { width, height } = this.gl.canvas;
      return { x: view.eye === 'left' ? 0 : Math.floor(width / 2), y: 0, width: Math.floor(width / 2), height };
    }
  }

  function sourceOf(handedness) {
    const actuator = { pulse: strength => {
      standIn.pulses++;
      standIn.strongest = Math.max(standIn.strongest, strength);
      return Promise.resolve(true);
    } };
    const state = standIn.hands[handedness];
    const button = value => ({ value, pressed: value > 0.5 });
    const hand = { get: name => ({ handedness, name }) };
    return { handedness, targetRaySpace: { handedness }, get hand() { return standIn.tracked ? hand : undefined; }, gamepad: { hapticActuators: [actuator], get axes() { return state.axes; },
      get buttons() { return [button(state.trigger), button(state.grip ? 1 : 0), button(0), button(state.stick ? 1 : 0), button(state.button ? 1 : 0), button(standIn.again ? 1 : 0)]; } } };
  }

  class Session extends EventTarget {
    constructor() {
      super();
      this.inputSources = [sourceOf('left'), sourceOf('right')];
      this.ended = false;
    }

    updateRenderState({ baseLayer, depthNear, depthFar }) {
      Object.assign(this, { baseLayer, depthNear, depthFar });
    }

    requestReferenceSpace() {
      return Promise.resolve({});
    }

    requestAnimationFrame(work) {
      const frame = now => {
        if (this.ended) return;
        standIn.frames++;
        work(now, this.frame());
        if (standIn.asked) standIn.picture = this.baseLayer.gl.canvas.toDataURL('image/png');
        standIn.asked = false;
      };
      if (standIn.before) standIn.before().then(frame);
      else requestAnimationFrame(frame);
    }

    frame() {
      const { position, orientation } = standIn.head;
      const { width, height } = this.baseLayer.gl.canvas;
      const views = ['left', 'right'].map((eye, i) => ({ eye, transform: transform([position[0] + (i - 0.5) * EYES, ...position.slice(1)], orientation),
        projectionMatrix: perspective(0.9, width / 2 / height, this.depthNear, this.depthFar) }));
      return { getViewerPose: () => ({ transform: transform(position, orientation), views }),
        getPose: ({ handedness }) => {
          const { seen, position: at, orientation: q } = standIn.hands[handedness];
          return seen ? { transform: transform(at, q) } : null;
        },
        getJointPose: ({ handedness, name }) => {
          const state = standIn.fingers[handedness];
          const joint = state.seen && window.standInHand.jointsOf(state, handedness)[name];
          return joint ? { transform: transform(joint, [1, 0, 0, 0]), radius: 0.008 } : null;
        } };
    }

    end() {
      this.ended = true;
      this.dispatchEvent(new Event('end'));
      return Promise.resolve();
    }
  }

  WebGL2RenderingContext.prototype.makeXRCompatible = () => Promise.resolve(); // the browser's own waits for a device
  window.XRWebGLLayer = Layer;
  Object.defineProperty(navigator, 'xr', { value: {
    isSessionSupported: mode => Promise.resolve(mode === 'immersive-vr'),
    requestSession: () => Promise.resolve(standIn.session = new Session()),
  } });
})();
