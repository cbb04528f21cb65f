/* The program that lights what is seen, as text: one lamp at the tip of the laparoscope, with shadows that are soft at their
 * edges; what things are made of, by the kind of their part. Only renderer.c has it, and the page of examples/web. */
#ifndef VBSS_EXAMPLES_VIEWER_MATERIALS_H
#define VBSS_EXAMPLES_VIEWER_MATERIALS_H

/* Of the lamp at a metre, so that what is 70 mm away is bright. */
#define MATERIAL_BRIGHTNESS 0.0165F

static const char material_vertex[] =
    "#version 330 core\n"
    "layout(location = 0) in vec3 position;\n"
    "layout(location = 1) in vec3 normal;\n"
    "layout(location = 2) in vec2 texture_place;\n"
    "layout(location = 3) in vec3 material;\n"
    "layout(location = 4) in float value;\n"
    "out vec3 at, out_of, rest;\n"
    "out vec2 place;\n"
    "out float which;\n"
    "uniform mat4 seen;\n"
    "void main() {\n"
    "    at = position; out_of = normal; place = texture_place; rest = material; which = value;\n"
    "    gl_Position = seen * vec4(position, 1.0);\n"
    "}\n";

enum { MATERIAL_PIECES = 3 };
static const char *const material_fragment[MATERIAL_PIECES] = {
    /* light */
    "#version 330 core\n"
    "in vec3 at, out_of, rest;\n"
    "in vec2 place;\n"
    "in float which;\n"
    "out vec4 colour;\n"
    "uniform int kind, spot_count;\n"
    "uniform vec4 spots[32];\n" /* place at rest, radius; marks first */
    "uniform int mark_count;\n"
    "uniform bool ghost;\n"
    "uniform vec3 eye, lamp;\n"
    "uniform float brightness, most_tension, clear, gone;\n"
    "uniform mat4 light;\n"
    "uniform sampler2DShadow shadow;\n"
    "const float PI = 3.14159265;\n"
    /* noise from place alone */
    "float hash(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }\n"
    "float noise(vec2 p) {\n"
    "    vec2 i = floor(p), f = fract(p);\n"
    "    f = f * f * (3.0 - 2.0 * f);\n"
    "    return mix(mix(hash(i), hash(i + vec2(1, 0)), f.x),\n"
    "               mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), f.x), f.y);\n"
    "}\n"
    "float rough_noise(vec2 p) {\n"
    "    return 0.5 * noise(p) + 0.25 * noise(2.1 * p) + 0.125 * noise(4.3 * p) + 0.0625 * "
    "noise(8.9 * p);\n"
    "}\n"
    "float lit(vec3 p, vec3 n) {\n"
    "    vec4 c = light * vec4(p + 2e-4 * n, 1.0);\n"
    "    if (max(abs(c.x), abs(c.y)) > c.w) return 1.0;\n" /* outside the depths that the lamp has */
    "    vec3 s = 0.5 * c.xyz / c.w + 0.5;\n"
    "    float turn = 2.0 * PI * hash(gl_FragCoord.xy), sum = 0.0;\n"
    "    for (int i = 0; i < 12; i++) {\n" /* a disc, turned in each pixel */
    "        float r = sqrt((float(i) + 0.5) / 12.0), a = turn + 2.39996 * float(i);\n"
    "        sum += texture(shadow, vec3(s.xy + 2.2e-3 * r * vec2(cos(a), sin(a)), s.z));\n"
    "    }\n"
    "    return sum / 12.0;\n"
    "}\n"
    /* what steel mirrors: a pink cavity, darker upward, with the lamp's glow */
    "vec3 cavity(vec3 direction, float rough) {\n"
    "    float up = 0.5 + 0.5 * direction.z;\n"
    "    vec3 c = mix(vec3(0.46, 0.24, 0.20), vec3(0.22, 0.14, 0.13), up);\n"
    "    return c + (1.0 - rough) * 0.10 * smoothstep(0.2, 0.9, sin(5.0 * direction.x + 3.0 * "
    "direction.z));\n"
    "}\n"
    /* GGX (Walter et al. 2007) with the visibility of Schlick, Fresnel by Schlick (1994) */
    "vec3 glint(vec3 n, vec3 l, vec3 v, float rough, vec3 f0) {\n"
    "    vec3 h = normalize(l + v);\n"
    "    float a = rough * rough, nh = max(dot(n, h), 0.0), nl = max(dot(n, l), 0.0), nv = "
    "max(dot(n, v), 1e-3);\n"
    "    float d = nh * nh * (a * a - 1.0) + 1.0, k = 0.5 * a;\n"
    "    float distribution = a * a / (PI * d * d), seen = 0.25 / ((nl * (1.0 - k) + k) * (nv * "
    "(1.0 - k) + k));\n"
    "    return (f0 + (1.0 - f0) * pow(1.0 - max(dot(h, v), 0.0), 5.0)) * distribution * seen * "
    "nl;\n"
    "}\n",
    /* what things are made of */
    "struct surface { vec3 albedo, f0, normal; float rough, metal, glow; };\n"
    "surface silk(vec3 n) {\n" /* braid: strands that cross, two ways round */
    "    float along = place.y / 0.00045, round = place.x * 6.0;\n"
    "    float braid = sin(2.0 * PI * (along + round)) * sin(2.0 * PI * (along - round));\n"
    "    float fine = smoothstep(0.02, 0.1, 1.0 / (60.0 * length(fwidth(vec2(along, round))) + "
    "1e-3));\n"
    "    vec3 c = vec3(0.055, 0.045, 0.10) * (1.0 + 0.5 * fine * braid);\n"
    "    if (most_tension > 0.0) {\n" /* ever brighter, also for who confuses red and green */
    "        const vec3 slack = vec3(0.00, 0.02, 0.30), half_taut = vec3(0.20, 0.19, 0.19),\n"
    "            taut = vec3(1.00, 0.80, 0.04);\n"
    "        float s = 2.0 * clamp(which / most_tension, 0.0, 1.0);\n"
    "        c = s < 1.0 ? mix(slack, half_taut, s) : mix(half_taut, taut, s - 1.0);\n"
    "    }\n"
    "    return surface(c, vec3(0.05), normalize(n + 0.15 * fine * braid * vec3(0.3, 0.5, 0.4)), "
    "0.42, 0.0, 0.1);\n"
    "}\n"
    "surface steel(vec3 n, float rough) {\n"
    "    return surface(vec3(0.0), vec3(0.62, 0.60, 0.58), n, rough, 1.0, 0.0);\n"
    "}\n"
    "surface jaw(vec3 n) {\n" /* the flat side is cut crosswise, so that it holds */
    "    surface s = steel(n, 0.38);\n"
    "    if (place.x > 0.7) {\n"
    "        vec2 cut = abs(fract(vec2(place.x * 12.0 + place.y * 2500.0, place.x * 12.0 - place.y "
    "* 2500.0)) - 0.5);\n"
    "        s.f0 *= 0.35 + 0.65 * smoothstep(0.05, 0.2, min(cut.x, cut.y)); s.rough = 0.5;\n"
    "    }\n"
    "    return s;\n"
    "}\n"
    "surface latex(vec3 n) {\n"
    "    float grain = rough_noise(1500.0 * place);\n"
    "    vec3 c = vec3(0.76, 0.47, 0.20) * (0.90 + 0.2 * grain);\n"
    "    if (which < -0.5) c *= vec3(0.80, 0.66, 0.55);\n" /* within, it is seen through itself */
    "    if (abs(which) < 0.5) c = vec3(0.90, 0.70, 0.45);\n" /* cut */
    "    for (int i = 0; i < spot_count; i++) {\n"
    "        float r = spots[i].w, d = distance(rest, spots[i].xyz);\n"
    "        if (i < mark_count) {\n"
    "            float ink = which > 0.5 ? 1.0 - smoothstep(0.88 * r, 1.04 * r, d + 1.2e-4 * "
    "(grain - 0.5)) : 0.0;\n"
    "            c = mix(c, vec3(0.03, 0.03, 0.05), 0.93 * ink);\n"
    "        } else {\n" /* a dark hole with a stretched, pale rim */
    "            c = mix(c, vec3(0.95, 0.80, 0.60), 0.4 * (1.0 - smoothstep(1.2 * r, 2.6 * r, "
    "d)));\n"
    "            c = mix(c, vec3(0.05, 0.02, 0.02), 1.0 - smoothstep(1.05 * r, 1.5 * r, d));\n"
    "        }\n"
    "    }\n"
    "    return surface(c, vec3(0.04), normalize(n + 0.05 * (grain - 0.5)), 0.34, 0.0, 0.35);\n"
    "}\n"
    "surface tissue(vec3 n) {\n"
    "    float soft = rough_noise(140.0 * place), fine = rough_noise(700.0 * place);\n"
    "    float vessel = smoothstep(0.030, 0.0, abs(rough_noise(55.0 * place + 7.0) - 0.47));\n"
    "    vec3 c = mix(vec3(0.52, 0.17, 0.14), vec3(0.74, 0.36, 0.28), soft + 0.25 * fine);\n"
    "    c = mix(c, vec3(0.40, 0.05, 0.06), 0.35 * vessel);\n"
    "    vec2 bump = vec2(rough_noise(260.0 * place + 3.1), rough_noise(260.0 * place + 9.7)) - "
    "0.47;\n"
    "    return surface(c, vec3(0.035), normalize(n + 0.55 * vec3(bump, 0.0)), 0.30, 0.0, 0.25);\n"
    "}\n",
    /* together */
    "surface made_of(vec3 n) {\n"
    "    if (kind == 1) return silk(n);\n"
    "    if (kind == 2) return latex(n);\n"
    "    if (kind == 3) return steel(n, 0.26);\n"
    "    if (kind == 4 || kind == 5) {\n"
    "        if (which > 1.5) return jaw(n);\n"
    "        surface s = steel(n, which > 0.5 ? 0.30 : 0.46);\n"
    "        if (which < 0.5) s.f0 *= 0.10;\n" /* the shaft's black coat */
    "        return s;\n"
    "    }\n"
    "    if (kind == 7) return tissue(n);\n"
    "    return surface(vec3(0.55, 0.58, 0.62), vec3(0.04), n, 0.5, 0.0, 0.0);\n"
    "}\n"
    "void main() {\n"
    "    vec3 n = normalize(out_of), v = normalize(eye - at), l = lamp - at;\n"
    "    float far2 = dot(l, l);\n"
    "    l *= inversesqrt(far2);\n"
    "    surface s = made_of(n);\n"
    "    float reached = lit(at, n), nl = dot(s.normal, l);\n"
    "    float soft = max(0.0, (nl + s.glow) / (1.0 + s.glow));\n" /* light that goes round under the skin */
    "    vec3 c = s.albedo / PI * soft * mix(vec3(reached), vec3(1.0), 0.25 * s.glow * vec3(1.0, "
    "0.5, 0.3));\n"
    "    c += reached * glint(s.normal, l, v, s.rough, s.f0);\n"
    "    c *= brightness / far2;\n"
    "    vec3 around = cavity(reflect(-v, s.normal), s.rough);\n"
    "    c += s.metal * s.f0 * around * (0.35 + 0.65 * reached);\n"
    "    c += s.albedo * vec3(0.050, 0.034, 0.030);\n" /* what the cavity gives back */
    /* of a pixel's samples; the places between their shares from noise */
    "    float there = clear > 0.0 ? smoothstep(gone * clear, clear, distance(eye, at)) : 1.0;\n"
    "    if (ghost) {\n" /* a bright rim, and little else */
    "        float rim = pow(1.0 - abs(dot(n, v)), 2.0);\n"
    "        c = mix(vec3(0.05, 0.25, 0.30), vec3(0.35, 0.95, 1.00), rim);\n"
    "        there *= 0.25 + 0.5 * rim;\n"
    "    }\n"
    "    if (there <= 0.0) discard;\n"
    "    colour = vec4(c, there < 1.0 ? there + 0.25 * (hash(gl_FragCoord.xy) - 0.5) : 1.0);\n"
    "}\n"};

#endif
