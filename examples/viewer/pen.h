/* Lines, boxes and words on the picture, in points from its upper left corner: pixels, as many as its size wants. */
#ifndef VBSS_EXAMPLES_VIEWER_PEN_H
#define VBSS_EXAMPLES_VIEWER_PEN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <epoxy/gl.h>

typedef uint32_t pen_colour; /* 0xrrggbbaa */

#define PEN_WHITE 0xf2f2eeffu
#define PEN_PALE 0xc9ccd2ffu
#define PEN_SHADE 0x0b0d12b0u
#define PEN_GREEN 0x4fd18bffu
#define PEN_YELLOW 0xf5c84cffu
#define PEN_RED 0xff6a4dffu
#define PEN_BLUE 0x63b3ffffu

typedef struct pen_corner {
    float x, y;
    uint8_t colour[4];
} pen_corner;

typedef struct pen {
    GLuint program, vertex_array, buffer;
    pen_corner *corners; /* three a triangle */
    size_t count, room;
    bool short_of_memory; /* something was left out */
    float scale;          /* pixels a point */
} pen;

bool pen_begin(pen *p);
void pen_end(pen *p);
void pen_line(pen *p, const float from[2], const float to[2], float width, pen_colour colour);
void pen_box(pen *p, float x, float y, float width, float height, pen_colour colour);
/* Of a capital letter's height, standing on y; returns where it ends. */
float pen_text(pen *p, float x, float y, float height, pen_colour colour, const char *text);
/* All of it on the picture that is drawn on, of that size in pixels; then nothing is left. */
void pen_draw(pen *p, int width, int height);

#endif
