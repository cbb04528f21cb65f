#include "pen.h"

#include <math.h>
#include <stdlib.h>

#include "painter/font.h"
#include "shader.h"

#define BASE 2.0F /* of the font: the line it stands on, */
#define TALL 6.0F /* and a capital letter's height above it */

static const char vertex[] = "#version 330 core\n"
                             "layout(location = 0) in vec2 place;\n"
                             "layout(location = 1) in vec4 colour;\n"
                             "out vec4 of;\n"
                             "uniform vec2 size;\n"
                             "void main() {\n"
                             "    of = colour;\n"
                             "    vec2 p = 2.0 * place / size - 1.0;\n"
                             "    gl_Position = vec4(p.x, -p.y, 0.0, 1.0);\n"
                             "}\n";
static const char *const fragment = "#version 330 core\n"
                                    "in vec4 of;\n"
                                    "out vec4 colour;\n"
                                    "void main() { colour = of; }\n";

bool pen_begin(pen *p)
{
    *p = (pen){.program = shader_program("pen", vertex, &fragment, 1), .scale = 1.0F};
    glGenVertexArrays(1, &p->vertex_array);
    glBindVertexArray(p->vertex_array);
    glGenBuffers(1, &p->buffer);
    glBindBuffer(GL_ARRAY_BUFFER, p->buffer);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(pen_corner), NULL);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(
        1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(pen_corner),
        (const void *)offsetof(pen_corner, colour)); /* NOLINT(performance-no-int-to-ptr) */
    return p->program != 0;
}

void pen_end(pen *p)
{
    glDeleteBuffers(1, &p->buffer);
    glDeleteVertexArrays(1, &p->vertex_array);
    glDeleteProgram(p->program);
    free(p->corners);
}

/* ---- triangles */

static bool has_room(pen *p, size_t more)
{
    if (p->count + more <= p->room) {
        return true;
    }
    size_t room = 2 * p->room + 4096;
    pen_corner *corners = realloc(p->corners, room * sizeof *corners);
    if (corners == NULL) {
        p->short_of_memory = true;
        return false;
    }
    p->corners = corners;
    p->room = room;
    return true;
}

/* Two triangles between corners that go round. */
static void add_four(pen *p, float corners[4][2], pen_colour colour)
{
    static const int order[6] = {0, 1, 2, 0, 2, 3};
    if (!has_room(p, 6)) {
        return;
    }
    for (int i = 0; i < 6; i++) {
        const float *at = corners[order[i]];
        p->corners[p->count++] = (pen_corner){at[0],
                                              at[1],
                                              {(uint8_t)(colour >> 24), (uint8_t)(colour >> 16),
                                               (uint8_t)(colour >> 8), (uint8_t)colour}};
    }
}

void pen_line(pen *p, const float from[2], const float to[2], float width, pen_colour colour)
{
    float x = to[0] - from[0], y = to[1] - from[1], length = sqrtf(x * x + y * y);
    float half = 0.5F * width;
    if (length < 1e-3F) { /* a dot */
        pen_box(p, from[0] - half, from[1] - half, width, width, colour);
        return;
    }
    x *= half / length;
    y *= half / length;
    float corners[4][2] = {{from[0] - x - y, from[1] - y + x},
                           {to[0] + x - y, to[1] + y + x},
                           {to[0] + x + y, to[1] + y - x},
                           {from[0] - x + y, from[1] - y - x}};
    add_four(p, corners, colour);
}

void pen_box(pen *p, float x, float y, float width, float height, pen_colour colour)
{
    float corners[4][2] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    add_four(p, corners, colour);
}

/* ---- words */

static void add_stroke(pen *p, const char *from, const char *to, float x, float y, float unit,
                       float width, pen_colour colour)
{
    const float a[2] = {x + unit * (float)(from[0] - '0'),
                        y - unit * ((float)(from[1] - '0') - BASE)};
    const float b[2] = {x + unit * (float)(to[0] - '0'), y - unit * ((float)(to[1] - '0') - BASE)};
    pen_line(p, a, b, width, colour);
}

float pen_text(pen *p, float x, float y, float height, pen_colour colour, const char *text)
{
    const float unit = height / TALL, width = fmaxf(0.13F * height, 1.1F / p->scale);
    while (*text != '\0') {
        const char *glyph = font_glyph(&text);
        for (const char *c = glyph; *c != '\0'; c += *c == ' ' ? 1 : 2) {
            bool first = c == glyph || c[-1] == ' ';
            bool alone = first && (c[2] == ' ' || c[2] == '\0');
            if (*c != ' ' && (!first || alone)) {
                add_stroke(p, alone ? c : c - 2, c, x, y, unit, width, colour);
            }
        }
        x += unit * (float)font_advance(glyph);
    }
    return x;
}

void pen_draw(pen *p, int width, int height)
{
    glUseProgram(p->program);
    glUniform2f(glGetUniformLocation(p->program, "size"), (float)width / p->scale,
                (float)height / p->scale);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(p->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, p->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(p->count * sizeof *p->corners), p->corners,
                 GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, (GLsizei)p->count);
    glDisable(GL_BLEND);
    p->count = 0;
}
