/* What the optics and the camera's chip make of the light: barrel, round field, tone; and the picture as bytes. */
#ifndef VBSS_EXAMPLES_VIEWER_LENS_H
#define VBSS_EXAMPLES_VIEWER_LENS_H

#include <stdbool.h>
#include <stdint.h>

#include <epoxy/gl.h>

enum { LENS_SAMPLES = 4 };

typedef struct lens {
    int width, height;
    GLuint program, empty;      /* a vertex array without vertices */
    GLuint many, colour, depth; /* several samples a pixel, in linear light */
    GLuint one, light;          /* one */
    GLuint out, picture;        /* as it is shown */
} lens;

bool lens_begin(lens *l, int width, int height);
void lens_end(lens *l);
/* What is drawn from here on is seen. */
void lens_open(const lens *l);
/* It becomes the picture, which may be drawn on from here on. */
void lens_close(const lens *l);
/* Rows from the top, red, green and blue. */
void lens_read(const lens *l, uint8_t *pixels);
/* Into a window of that size, as large as it can be. */
void lens_show(const lens *l, int width, int height);

#endif
