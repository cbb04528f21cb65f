#include "canvas.h"

#include <math.h>

#include "harness/harness.h"

painter *canvas_painter(void)
{
    painter *p;
    const painter_camera camera = {{0.0, 0.0, 0.1}, {0.0}, {0.0, 1.0, 0.0}, 20e-3, 0.0};
    assert_int_equal(painter_create(CANVAS, CANVAS, &p), PAINTER_OK);
    assert_int_equal(painter_set_camera(p, &camera), PAINTER_OK);
    return p;
}

int canvas_column(double x)
{
    return (int)(0.5 * CANVAS + x * 1e4);
}

int canvas_row(double y)
{
    return (int)(0.5 * CANVAS - y * 1e4);
}

void canvas_paint(painter *p, canvas *to)
{
    assert_int_equal(painter_paint(p, to->pixels, sizeof to->pixels), PAINTER_OK);
    painter_destroy(p);
}

uint32_t canvas_pixel(const canvas *c, int column, int row)
{
    const uint8_t *pixel = c->pixels + 3 * ((size_t)row * CANVAS + (size_t)column);
    return (uint32_t)pixel[0] << 16 | (uint32_t)pixel[1] << 8 | pixel[2];
}

bool canvas_is_background(const canvas *c, int column, int row)
{
    return canvas_pixel(c, column, row) == 0xf6f7f9u;
}

/* Light on a thing takes away from all of its colours alike; a shine, or dark, adds grey. */
static void hue(uint32_t colour, double *of)
{
    double smallest = 1.0;
    for (int i = 0; i < 3; i++) {
        double code = (double)(colour >> 8 * i & 255) / 255.0;
        of[i] = code * code;
        smallest = fmin(smallest, of[i]);
    }
    for (int i = 0; i < 3; i++) {
        of[i] -= smallest;
    }
}

bool canvas_matches(uint32_t pixel, painter_colour colour)
{
    double a[3], b[3], product = 0.0, seen = 0.0, wanted = 0.0;
    hue(pixel, a);
    hue(colour, b);
    for (int i = 0; i < 3; i++) {
        product += a[i] * b[i];
        seen += a[i] * a[i];
        wanted += b[i] * b[i];
    }
    return seen > 1e-4 && product > 0.98 * sqrt(seen * wanted);
}

int canvas_brightness(const canvas *c, int column, int row)
{
    uint32_t pixel = canvas_pixel(c, column, row);
    return (int)((pixel >> 16) + (pixel >> 8 & 255) + (pixel & 255));
}

int canvas_covered(const canvas *c, int row)
{
    int count = 0;
    for (int column = 0; column < CANVAS; column++) {
        count += canvas_is_background(c, column, row) ? 0 : 1;
    }
    return count;
}
