/* The programs of lens and shadow, as text: for shadow.c, lens.c, and the page of examples/web, which is drawn by the same ones.
 */
#ifndef VBSS_EXAMPLES_VIEWER_PROGRAMS_H
#define VBSS_EXAMPLES_VIEWER_PROGRAMS_H

/* ---- lens: what optics and chip make of the light */

static const char lens_vertex[] = "#version 330 core\n"
                                  "out vec2 at;\n"
                                  "void main() {\n" /* one triangle over all of the picture */
                                  "    at = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);\n"
                                  "    gl_Position = vec4(2.0 * at - 1.0, 0.0, 1.0);\n"
                                  "}\n";
static const char *const lens_fragment =
    "#version 330 core\n"
    "in vec2 at;\n"
    "out vec4 colour;\n"
    "uniform sampler2D light;\n"
    "uniform float aspect, barrel, spread, field;\n" /* of it: 1; 0 without a laparoscope */
    "void main() {\n"
    "    vec2 p = 2.0 * at - 1.0;\n"
    "    vec2 round = vec2(p.x * aspect, p.y);\n" /* 1 at the upper edge */
    "    float r2 = dot(round, round);\n"
    "    vec2 bent = p * (1.0 + barrel * r2) / spread;\n"
    "    vec3 c = texture(light, 0.5 * bent + 0.5).rgb;\n"
    "    c *= 1.0 - 0.42 * field * smoothstep(0.1, 1.3, r2);\n"         /* less light aside */
    "    c *= 1.0 - field * smoothstep(1.08, 1.13, sqrt(r2));\n"        /* the round field */
    "    c = c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14);\n" /* tone: Narkowicz 2015 */
    "    colour = vec4(pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2)), 1.0);\n"
    "}\n";

/* ---- shadow: the depth that the lamp sees */

static const char shadow_vertex[] =
    "#version 330 core\n"
    "layout(location = 0) in vec3 position;\n"
    "uniform mat4 light;\n"
    "out vec3 at;\n"
    "void main() { at = position; gl_Position = light * vec4(position, "
    "1.0); }\n";
static const char *const shadow_fragment =
    "#version 330 core\n"
    "in vec3 at;\n"
    "uniform vec3 lamp;\n"
    "uniform float clear;\n"
    "void main() { if (distance(at, lamp) < clear) discard; }\n";

#endif
