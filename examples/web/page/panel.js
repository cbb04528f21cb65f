// Words in the room, for a headset: a panel above the scene, which has its place there and is covered by what is before it.
import { Program } from './graphics.js';
import { rotate } from './pose.js';

const WIDE = 0.6, TALL = 0.225; // m
const ABOVE = 0.24, BEHIND = 0.12; // m, its middle from the scene's
const PIXELS = [1024, 384], MARGIN = 28, SIZE = 46; // of the letters: 27 mm, 2.5 degrees at 0.6 m
const INK = { offset: '#4fd18b', goal: '#f2f2ee', mistake: '#f5c84c', phase: '#c9ccd2', caption: '#f2f2ee', slow: '#f5c84c' };
const SHADE = '#0b0d12';

const VERTEX = `#version 300 es
uniform mat4 seen;
uniform vec3 middle, right, up;
out vec2 at;
void main() {
  at = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = seen * vec4(middle + (at.x - 0.5) * right + (at.y - 0.5) * up, 1.0);
}`;
const FRAGMENT = `#version 300 es
precision highp float;
uniform sampler2D words;
in vec2 at;
out vec4 colour;
void main() { colour = vec4(pow(texture(words, vec2(at.x, 1.0 - at.y)).rgb, vec3(2.2)), 1.0); }`;

// Lines that fit.
export function wrap(words, width, measure) {
  const lines = [];
  for (const word of words.split(' ')) {
    const line = lines.length > 0 ? `${lines[lines.length - 1]} ${word}` : word;
    if (lines.length > 0 && measure(line) <= width) lines[lines.length - 1] = line;
    else lines.push(word);
  }
  return lines;
}

export class Panel {
  constructor(gl) {
    this.gl = gl;
    this.program = new Program(gl, 'panel', [VERTEX, FRAGMENT]);
    this.empty = gl.createVertexArray();
    this.texture = gl.createTexture();
    this.canvas = document.createElement('canvas');
    [this.canvas.width, this.canvas.height] = PIXELS;
    this.words = null;
  }

  // Lines of { kind, words }; drawn anew when they have changed.
  write(lines) {
    const words = JSON.stringify(lines);
    if (words === this.words) return;
    this.words = words;
    const c = this.canvas.getContext('2d');
    c.fillStyle = SHADE;
    c.fillRect(0, 0, ...PIXELS);
    c.textBaseline = 'top';
    let y = MARGIN;
    for (const { kind, words: text } of lines) {
      const size = kind === 'goal' || kind === 'mistake' ? SIZE : 0.8 * SIZE;
      c.font = `${size}px system-ui, sans-serif`;
      c.fillStyle = INK[kind];
      for (const line of wrap(text, PIXELS[0] - 2 * MARGIN, part => c.measureText(part).width)) {
        c.fillText(line, MARGIN, y);
        y += 1.25 * size;
      }
    }
    this.load();
  }

  load() {
    const { gl } = this;
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, this.canvas);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  }

  // `seen` from the room to an eye's picture; the scene stands at `place`, turned about the vertical.
  draw(seen, place, turn) {
    if (this.words === null || this.words === '[]') return;
    const { gl, program } = this;
    const q = [Math.cos(0.5 * turn), 0, Math.sin(0.5 * turn), 0];
    program.use();
    gl.uniformMatrix4fv(program.at('seen'), false, seen);
    gl.uniform3fv(program.at('middle'), rotate(q, [0, ABOVE, -BEHIND]).map((n, i) => n + place[i]));
    gl.uniform3fv(program.at('right'), rotate(q, [WIDE, 0, 0]));
    gl.uniform3fv(program.at('up'), [0, TALL, 0]);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.uniform1i(program.at('words'), 0);
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }
}
