// What things are made of, and the light on them. Lengths are in millimetres.
import { Color, DoubleSide, MeshPhongMaterial } from 'three';

const THREAD = 1, DRAIN = 2, NEEDLE = 3, DRIVER = 4, SHEARS = 5, FLOOR = 7;
const MARK = 1;
export const MAX_DECALS = 24;

export const themes = {
  light: { background: 0xe4e9ef, floor: 0xcf9d8f, grid: 0xa8776b },
  dark: { background: 0x0f1317, floor: 0x6b3f38, grid: 0x4c2c27 },
};

// Marks and holes are where a point of the wall rests, so they are as sharp as the picture.
const spotsInside = `
  for (int i = 0; i < ${MAX_DECALS}; i++) {
    if (i >= spotCount) break;
    float off = distance(rest, spots[i].xyz), radius = abs(spots[i].w);
    float edge = fwidth(off) + 1e-6;
    if (spots[i].w > 0.0 && side > 0.5)
      diffuseColor.rgb = mix(diffuseColor.rgb, vec3(0.05, 0.05, 0.08), 1.0 - smoothstep(radius - edge, radius + edge, off));
    if (spots[i].w < 0.0)
      diffuseColor.rgb = mix(diffuseColor.rgb, vec3(0.1, 0.02, 0.02), 1.0 - smoothstep(1.4 * radius - edge, 1.4 * radius + edge, off));
  }
  if (side < -0.5) diffuseColor.rgb *= vec3(0.86, 0.72, 0.6);`;

function latex(uniforms) {
  const material = new MeshPhongMaterial({ color: 0xe6c98c, specular: 0x1f1c14, shininess: 30, side: DoubleSide });
  material.extensions = { derivatives: true };
  material.onBeforeCompile = shader => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = 'attribute vec3 matter; attribute float face; varying vec3 rest; varying float side;\n' +
      shader.vertexShader.replace('#include <begin_vertex>', '#include <begin_vertex>\nrest = matter; side = face;');
    shader.fragmentShader = `uniform vec4 spots[${MAX_DECALS}]; uniform int spotCount; varying vec3 rest; varying float side;\n` +
      shader.fragmentShader.replace('#include <color_fragment>', '#include <color_fragment>' + spotsInside);
  };
  return material;
}

const steel = (color, specular, shininess) => new MeshPhongMaterial({ color, specular, shininess });

// The material of a model; of a drain's, `uniforms` tell where it has spots.
export function materialOf(model, uniforms) {
  switch (model.kind) {
    case THREAD: return new MeshPhongMaterial({ color: 0x5546c0, specular: 0x444455, shininess: 25 });
    case DRAIN: return latex(uniforms);
    case NEEDLE: return steel(0xb9c2cb, 0x999999, 80);
    case DRIVER:
    case SHEARS: return model.piece === 0 ? steel(0x2b3036, 0x444444, 25) : steel(0xa4adb6, 0x888888, 60);
    case FLOOR: return new MeshPhongMaterial({ color: themes.light.floor, specular: 0x221111, shininess: 10 });
    default: return new MeshPhongMaterial({ color: 0xe6c98c, specular: 0x1a1811, shininess: 20 });
  }
}

export const isFloor = model => model.kind === FLOOR;
export const isMark = row => row[1] === MARK;

export function paintFloor(material, theme) {
  material.color = new Color(themes[theme].floor);
}
