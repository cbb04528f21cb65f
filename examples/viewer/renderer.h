/* Draws what a visual shows, through a laparoscope. */
#ifndef VBSS_EXAMPLES_VIEWER_RENDERER_H
#define VBSS_EXAMPLES_VIEWER_RENDERER_H

#include <stdbool.h>
#include <stdint.h>

#include <vblast_ss/visual.h>

#include "camera.h"
#include "lens.h"
#include "shadow.h"

typedef struct renderer {
    GLuint program, vertex_array, vertices, triangles;
    shadow shadow;
    lens lens;
    uint32_t ghost;    /* source of the visual that is drawn as a ghost; 0: none */
    float max_tension; /* N, of the last of the colours that threads have then; 0: they are silk */
} renderer;

/* An OpenGL 3.3 context must be current. False, told on standard error: it cannot do what is needed. */
bool renderer_begin(renderer *r, int width, int height);
void renderer_end(renderer *r);
bool renderer_resize(renderer *r, int width, int height);
/* The picture is then in the lens. False, told, when a view or OpenGL failed. */
bool renderer_draw(renderer *r, vbss_visual *visual, const camera *c);
/* False, told: OpenGL has met an error since it was asked last. */
bool renderer_good(void);

#endif
