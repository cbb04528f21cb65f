/* Private to the painter: what is seen at every sample of an area of a picture. */
#ifndef VBSS_EXAMPLES_PAINTER_RASTER_H
#define VBSS_EXAMPLES_PAINTER_RASTER_H

#include "picture.h"

/* Samples lie in the middle of the pixels of a view, rows top ... top + height - 1 of all columns. */
typedef struct samples {
    int top, width, height;
    double *distance; /* along the sample's ray, row by row; HUGE_VAL: nothing there */
    uint32_t *seen;   /* number of the shape; may be NULL */
} samples;

/* Puts what is nearest into the samples; lines only when they are wanted. */
void raster_shapes(const view *v, const shape *placed, size_t count, bool lines, samples *to);

/* What the light sees. */
typedef struct shadows {
    view light; /* seen from camera space */
    samples map;
} shadows;

bool shadows_create(const view *v, double reach, const shape *placed, size_t count, shadows *s);
void shadows_destroy(shadows *s);
/* 1: in full light, 0: in the shadow, of a place in camera space and a thing of that size. */
double shadows_light(const shadows *s, vec place, double size);

#endif
