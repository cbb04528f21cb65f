// Meshes of the scene by the programs of the desktop viewer, as renderer.c does it: shadows of the lamp, then what is seen.
import { Program, checkFrame, texture } from './graphics.js';
import { Lens } from './lens.js';

const FLOATS = 12, PART_WORDS = 8, SPOT_FLOATS = 6, MAX_SPOTS = 32;
const FIELDS = [[3, 0], [3, 3], [2, 6], [3, 8], [1, 11]]; // floats, the first
const DRIVER = 4, SHEARS = 5, FLOOR = 7; // kinds of parts
const MARK = 1, HOLE = 2;
const SHADOW_SIZE = 1536;
const MAX_TENSION = 1; // N, of the last colour

// Parts of the floats of Simulation.view().
export function readView(view) {
  return { seen: view.subarray(0, 16), light: view.subarray(16, 32), eye: view.subarray(32, 35), lamp: view.subarray(35, 38),
    target: view.subarray(38, 41), clear: view[41], brightness: view[42], gone: view[43], barrel: view[44], spread: view[45] };
}

export class Renderer {
  constructor(canvas, programs) {
    const gl = canvas.getContext('webgl2', { antialias: false, alpha: false, xrCompatible: true });
    if (!gl || !gl.getExtension('EXT_color_buffer_float')) throw new Error('WebGL 2 with colours in floats is not there');
    gl.getExtension('OES_texture_half_float_linear');
    this.gl = gl;
    this.showsTension = false;
    this.meshes = null;
    this.ghost = 0; // source of the parts that are drawn as ghosts; 0: none
    this.material = new Program(gl, 'materials', programs.material);
    this.shadow = new Program(gl, 'shadow', programs.shadow);
    this.lens = new Lens(gl, programs.lens);
    this.makeBuffers();
    this.makeShadow();
  }

  makeBuffers() {
    const { gl } = this;
    this.array = gl.createVertexArray();
    gl.bindVertexArray(this.array);
    this.vertices = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.vertices);
    this.triangles = gl.createBuffer();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.triangles);
    FIELDS.forEach(([count, first], i) => {
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, count, gl.FLOAT, false, 4 * FLOATS, 4 * first);
    });
  }

  makeShadow() {
    const { gl } = this;
    this.depth = texture(gl, gl.DEPTH_COMPONENT24, SHADOW_SIZE, SHADOW_SIZE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
    this.lampFrame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.lampFrame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.depth, 0);
    checkFrame(gl, 'shadow');
  }

  // Arrays of Simulation.draw(), until the next ones.
  upload(arrays) {
    const { gl } = this;
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.vertices);
    gl.bufferData(gl.ARRAY_BUFFER, arrays.vertices, gl.STREAM_DRAW);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, arrays.triangles, gl.STREAM_DRAW);
    this.meshes = { parts: arrays.parts.slice(), spots: arrays.spots.slice() };
  }

  eachPart(draw) {
    const { parts } = this.meshes;
    for (let i = 0; i < parts.length / PART_WORDS; i++) {
      const [kind, source, , , , first, count] = parts.subarray(PART_WORDS * i, PART_WORDS * (i + 1));
      draw(kind, i, this.ghost !== 0 && source === this.ghost, () => this.gl.drawElements(this.gl.TRIANGLES, 3 * count, this.gl.UNSIGNED_INT, 12 * first));
    }
  }

  // From a view; `clear` as readView has it. Once for all eyes.
  drawShadows(view) {
    const { gl, shadow } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.lampFrame);
    gl.viewport(0, 0, SHADOW_SIZE, SHADOW_SIZE);
    gl.enable(gl.DEPTH_TEST);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    shadow.use();
    gl.uniformMatrix4fv(shadow.at('light'), false, view.light);
    gl.uniform3fv(shadow.at('lamp'), view.lamp);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(2, 4);
    gl.bindVertexArray(this.array);
    this.eachPart((kind, i, isGhost, draw) => {
      gl.uniform1f(shadow.at('clear'), kind === DRIVER || kind === SHEARS ? view.clear : 0);
      if (kind !== FLOOR && !isGhost) draw(); // which is below everything
    });
    gl.disable(gl.POLYGON_OFFSET_FILL);
  }

  // Marks first.
  setSpots(part) {
    const { gl, material } = this;
    const rows = [];
    let marks = 0;
    for (const kind of [MARK, HOLE]) {
      for (let at = 0; at < this.meshes.spots.length && rows.length < MAX_SPOTS; at += SPOT_FLOATS) {
        const row = this.meshes.spots.subarray(at, at + SPOT_FLOATS);
        if (row[0] === part && row[1] === kind) rows.push(row.subarray(2));
      }
      if (kind === MARK) marks = rows.length;
    }
    gl.uniform1i(material.at('spot_count'), rows.length);
    gl.uniform1i(material.at('mark_count'), marks);
    if (rows.length > 0) gl.uniform4fv(material.at('spots'), rows.flatMap(row => Array.from(row)));
  }

  drawSeen(view) {
    const { gl, material } = this;
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.SAMPLE_ALPHA_TO_COVERAGE);
    material.use();
    gl.uniformMatrix4fv(material.at('seen'), false, view.seen);
    gl.uniformMatrix4fv(material.at('light'), false, view.light);
    gl.uniform3fv(material.at('eye'), view.eye);
    gl.uniform3fv(material.at('lamp'), view.lamp);
    gl.uniform1f(material.at('brightness'), view.brightness);
    gl.uniform1f(material.at('most_tension'), this.showsTension ? MAX_TENSION : 0);
    gl.uniform1f(material.at('gone'), view.gone);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.depth);
    gl.uniform1i(material.at('shadow'), 0);
    gl.bindVertexArray(this.array);
    this.eachPart((kind, i, isGhost, draw) => {
      gl.uniform1i(material.at('kind'), kind);
      gl.uniform1i(material.at('ghost'), isGhost ? 1 : 0);
      gl.uniform1f(material.at('clear'), kind === DRIVER || kind === SHEARS ? view.clear : 0);
      this.setSpots(i);
      draw();
    });
    gl.disable(gl.SAMPLE_ALPHA_TO_COVERAGE);
  }

  // Through the laparoscope, on the canvas.
  draw(view) {
    const { width, height } = this.gl.canvas;
    this.drawShadows(view);
    this.drawEye(view, null, [0, 0, width, height], [0, 0, 0], view);
  }

  // Into a part of a frame; shadows are drawn already. Without a lens as eyes see it. `drawMore` draws among the rest.
  drawEye(view, frame, viewport, background, lens, drawMore = () => {}) {
    this.lens.resize(viewport[2], viewport[3]);
    this.lens.open(background);
    this.drawSeen(view);
    drawMore();
    this.lens.close(frame, viewport, lens);
  }
}
