/* Pictures in memory, and what is on them. */
#ifndef VBSS_TESTS_PAINTER_CANVAS_H
#define VBSS_TESTS_PAINTER_CANVAS_H

#include <stdbool.h>
#include <stdint.h>

#include "painter/painter.h"

enum { CANVAS = 200 }; /* pixels, each way */

typedef struct canvas {
    uint8_t pixels[CANVAS * CANVAS * 3];
} canvas;

/* A painter of that size that looks along -z at the origin, 20 mm wide: 10 pixels a millimetre. */
painter *canvas_painter(void);
/* Pixels of x and y in metres, as that painter sees them. */
int canvas_column(double x);
int canvas_row(double y);
/* Paints, and destroys the painter. */
void canvas_paint(painter *p, canvas *to);

/* 0xrrggbb */
uint32_t canvas_pixel(const canvas *c, int column, int row);
bool canvas_is_background(const canvas *c, int column, int row);
/* The same hue, lit somehow. */
bool canvas_matches(uint32_t pixel, painter_colour colour);
/* Sum of red, green and blue. */
int canvas_brightness(const canvas *c, int column, int row);
/* Pixels of the row that are not background. */
int canvas_covered(const canvas *c, int row);

#endif
