// Light, gathered in linear numbers with several samples a pixel, and what optics and chip make of it: as lens.c of the desktop
// viewer does.
import { Program, checkFrame, texture } from './graphics.js';

const SAMPLES = 4;

export class Lens {
  constructor(gl, programs) {
    this.gl = gl;
    this.program = new Program(gl, 'lens', programs);
    this.empty = gl.createVertexArray();
    this.width = this.height = 0;
  }

  resize(width, height) {
    const { gl } = this;
    if (width === this.width && height === this.height) return;
    for (const handle of [this.colour, this.depth]) gl.deleteRenderbuffer(handle);
    for (const handle of [this.many, this.one]) gl.deleteFramebuffer(handle);
    gl.deleteTexture(this.light);
    const samples = Math.min(SAMPLES, ...gl.getInternalformatParameter(gl.RENDERBUFFER, gl.RGBA16F, gl.SAMPLES).slice(0, 1));
    Object.assign(this, { width, height, colour: gl.createRenderbuffer(), depth: gl.createRenderbuffer(),
      many: gl.createFramebuffer(), one: gl.createFramebuffer() });
    gl.bindRenderbuffer(gl.RENDERBUFFER, this.colour);
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, gl.RGBA16F, width, height);
    gl.bindRenderbuffer(gl.RENDERBUFFER, this.depth);
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, gl.DEPTH_COMPONENT24, width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.many);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, this.colour);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, this.depth);
    checkFrame(gl, 'samples');
    this.light = texture(gl, gl.RGBA16F, width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.one);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.light, 0);
    checkFrame(gl, 'light');
  }

  // What is drawn from here on is seen.
  open(background) {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.many);
    gl.viewport(0, 0, this.width, this.height);
    gl.clearColor(...background, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  // Into a frame (null: the canvas), in a viewport; through a laparoscope of that barrel and spread, or as eyes see it.
  close(frame, viewport, { barrel, spread } = { barrel: 0, spread: 0 }) {
    const { gl, program, width, height } = this;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.many);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, this.one);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.viewport(...viewport);
    gl.disable(gl.DEPTH_TEST);
    program.use();
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.light);
    gl.uniform1i(program.at('light'), 0);
    gl.uniform1f(program.at('aspect'), width / height);
    gl.uniform1f(program.at('barrel'), barrel);
    gl.uniform1f(program.at('spread'), spread || 1);
    gl.uniform1f(program.at('field'), spread ? 1 : 0);
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
