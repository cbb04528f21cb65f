// What is seen: the bodies of the film, at a time of it.
import { AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, GridHelper, HemisphereLight, Mesh,
  PCFSoftShadowMap, PerspectiveCamera, Quaternion, Scene, Vector3, Vector4, WebGLRenderer } from 'three';
import { OrbitControls } from 'three-orbit';
import { columnsOf, trianglesOf } from './film.js';
import { MAX_DECALS, isFloor, isMark, materialOf, paintFloor, themes } from './styles.js';
import { Surface } from './surface.js';
import { Tube } from './tube.js';

const MM = 1000;

// From where the viewer's laparoscope looks: 50 degrees down, from the right; a little farther off.
const EYE = new Vector3(22, -50, 62);
const TARGET = new Vector3(0, 0, -2);

class RigidBody {
  constructor(model, film) {
    this.units = [film.place * MM, film.turn];
    this.geometry = new BufferGeometry();
    this.geometry.setIndex(new BufferAttribute(trianglesOf(model), 1));
    this.geometry.setAttribute('position', new BufferAttribute(columnsOf(model, 'positions').map(x => x * MM), 3));
    this.geometry.setAttribute('normal', new BufferAttribute(columnsOf(model, 'normals'), 3));
    this.mesh = new Mesh(this.geometry, materialOf(model));
  }

  update(numbers) {
    const [place, turn] = this.units;
    this.mesh.position.set(numbers[0] * place, numbers[1] * place, numbers[2] * place);
    this.mesh.quaternion.copy(new Quaternion(numbers[4] * turn, numbers[5] * turn, numbers[6] * turn, numbers[3] * turn).normalize());
  }
}

class ThreadBody {
  constructor(model, film) {
    this.unit = film.place * MM;
    this.tube = new Tube(model.radius * MM);
    this.mesh = new Mesh(this.tube.geometry, materialOf(model));
  }

  update(numbers) {
    if (numbers.length < 6) return;
    this.tube.update(numbers.map(n => n * this.unit), numbers.length / 3);
    this.mesh.geometry = this.tube.geometry;
  }
}

class DrainBody {
  constructor(model, film, frames, spots) {
    this.unit = film.place * MM;
    this.body = model.body;
    this.spots = spots;
    this.uniforms = {
      spots: { value: Array.from({ length: MAX_DECALS }, () => new Vector4()) },
      spotCount: { value: 0 },
    };
    const face = columnsOf(model, 'face');
    this.surface = new Surface(trianglesOf(model), face, columnsOf(model, 'material'), frames);
    this.mesh = new Mesh(this.surface.geometry, materialOf(model, this.uniforms));
  }

  update(numbers) {
    this.surface.update(numbers.map(n => n * this.unit));
  }

  mark(frame) {
    const known = this.spots.filter(s => s.frame <= frame).pop();
    const rows = known ? known.rows.filter(row => row[0] === this.body).slice(0, MAX_DECALS) : [];
    rows.forEach((row, i) => this.uniforms.spots.value[i].set(row[2], row[3], row[4], isMark(row) ? row[5] : -row[5]));
    this.uniforms.spotCount.value = rows.length;
  }
}

export class Stage {
  constructor(canvas, film, frames, changed) {
    this.frames = frames;
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFSoftShadowMap;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(38, 1, 1, 1000);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false; // arrows are the timeline's
    this.controls.minDistance = 8;
    this.controls.maxDistance = 400;
    this.controls.addEventListener('change', changed);
    this.addLights();
    this.bodies = film.models.map((model, i) => this.addBody(film, model, i));
    this.goHome();
  }

  addLights() {
    const sun = new DirectionalLight(0xfff6ee, 0.62);
    sun.position.set(55, -35, 120);
    sun.castShadow = true;
    sun.shadow.mapSize.set(2048, 2048);
    Object.assign(sun.shadow.camera, { left: -70, right: 70, top: 70, bottom: -70, near: 10, far: 300 });
    sun.shadow.bias = -0.002;
    sun.shadow.radius = 2;
    const fill = new DirectionalLight(0xdfe8ff, 0.2);
    fill.position.set(-60, -60, 40);
    this.scene.add(sun, fill, new HemisphereLight(0xffffff, 0x8a5a50, 0.32), new AmbientLight(0xffffff, 0.1));
  }

  addBody(film, model, number) {
    let body;
    if (model.form === 'rigid') body = new RigidBody(model, film);
    else if (model.form === 'tube') body = new ThreadBody(model, film);
    else body = new DrainBody(model, film, this.numbersOf(number), film.spots);
    body.mesh.castShadow = !isFloor(model);
    body.mesh.receiveShadow = true;
    body.mesh.frustumCulled = false;
    this.scene.add(body.mesh);
    if (isFloor(model)) {
      this.floor = body;
      this.grid = new GridHelper(300, 30);
      this.grid.rotation.x = Math.PI / 2;
      this.grid.material.vertexColors = 0;
      this.scene.add(this.grid);
    }
    return body;
  }

  // Of a model, in all frames that it is in.
  numbersOf(model) {
    return this.frames.flatMap(frame => {
      const item = frame.layout.items.find(i => i.model === model);
      return item ? [frame.numbers.subarray(item.at, item.at + item.size)] : [];
    });
  }

  goHome() {
    this.camera.position.copy(EYE);
    this.controls.target.copy(TARGET);
    this.controls.update();
  }

  setTheme(theme) {
    this.scene.background = new Color(themes[theme].background);
    if (this.floor) {
      paintFloor(this.floor.mesh.material, theme);
      this.grid.material.color = new Color(themes[theme].grid);
      this.grid.material.needsUpdate = true;
    }
  }

  // Between a frame and the next one, as far as these have the same bodies.
  show(frame, share) {
    const here = this.frames[frame];
    const next = this.frames[Math.min(frame + 1, this.frames.length - 1)];
    const mixed = Float32Array.from(here.numbers);
    if (share > 0 && next.layout === here.layout) {
      for (let i = 0; i < mixed.length; i++) mixed[i] += share * (next.numbers[i] - here.numbers[i]);
    }
    this.bodies.forEach(body => { body.mesh.visible = false; });
    for (const item of here.layout.items) {
      const body = this.bodies[item.model];
      body.mesh.visible = true;
      body.update(mixed.subarray(item.at, item.at + item.size));
      if (body.mark) body.mark(frame);
    }
    if (this.floor) this.grid.position.z = this.floor.mesh.position.z + 0.03;
  }

  draw() {
    const canvas = this.renderer.domElement;
    const { clientWidth: width, clientHeight: height } = canvas;
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    if (canvas.width !== Math.floor(width * ratio) || canvas.height !== Math.floor(height * ratio)) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
      this.camera.aspect = width / Math.max(height, 1);
      this.camera.updateProjectionMatrix();
    }
    this.renderer.render(this.scene, this.camera);
  }
}
