/* Writes the files that check_pictures.py looks at: painter_pictures <folder>. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "painter/painter.h"

enum { WIDTH = 800, HEIGHT = 600, POINTS = 301 };

static const char *folder;
static int failures;

static const char *path_of(const char *name)
{
    static char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static void must(painter_result result, const painter *p)
{
    if (result != PAINTER_OK) {
        fprintf(stderr, "%s: %s\n", painter_result_string(result), painter_error(p));
        failures++;
    }
}

static painter *start(int width, int height)
{
    painter *p;
    if (painter_create(width, height, &p) != PAINTER_OK) {
        exit(2);
    }
    return p;
}

/* What a decoder must give back. */
static void write_raw(painter *p, const char *name)
{
    size_t size = (size_t)3 * WIDTH * HEIGHT;
    uint8_t *pixels = malloc(size);
    FILE *file = fopen(path_of(name), "wb");
    if (pixels == NULL || file == NULL) {
        exit(2);
    }
    must(painter_paint(p, pixels, size), p);
    fwrite(pixels, 1, size, file);
    fclose(file);
    free(pixels);
}

/* ---- scenes */

/* A trefoil as loose as on the table, 20 mm in the picture, coloured by a made-up tension. */
static void write_trefoil(void)
{
    painter *p = start(WIDTH, HEIGHT);
    static double points[POINTS][3];
    static painter_colour colours[POINTS];
    for (int i = 0; i < POINTS; i++) {
        double t = 6.283185307179586 * i / (POINTS - 1);
        points[i][0] = 2.4e-3 * (sin(t) + 2.0 * sin(2.0 * t));
        points[i][1] = 2.4e-3 * (cos(t) - 2.0 * cos(2.0 * t));
        points[i][2] = -1e-3 * sin(3.0 * t);
        colours[i] = painter_ramp(cos(t), -1.0, 1.0);
    }
    const painter_camera camera = {{0.0, 0.0, 0.1}, {0.0}, {0.0, 1.0, 0.0}, 20e-3, 0.0};
    must(painter_set_camera(p, &camera), p);
    must(painter_add_chain(p, &points[0][0], POINTS, 0, 0.125e-3, PAINTER_VIOLET, colours), p);
    must(painter_add_dots(p, points[50], 1, 0, 3.0, PAINTER_VERMILION), p);
    must(painter_add_label(p, points[50], "contact", PAINTER_BLACK), p);
    must(painter_add_scale_bar(p, 2e-3, "2 mm"), p);
    must(painter_add_ramp(p, "0 N", "2 N"), p);
    must(painter_write_png(p, path_of("trefoil.png")), p);
    must(painter_write_svg(p, path_of("trefoil.svg")), p);
    must(painter_write_two_views(p, path_of("trefoil-two.png")), p);
    painter_destroy(p);
}

/* Two bars that cross, the vermilion one nearer; the upper end of the other one, green, is what is
 * seen of it from above. 40 pixels a millimetre. */
static void write_crossing(void)
{
    painter *p = start(WIDTH, HEIGHT);
    const painter_camera camera = {{0.0, 0.0, 0.1}, {0.0}, {0.0, 1.0, 0.0}, 20e-3, 0.0};
    must(painter_set_camera(p, &camera), p);
    must(painter_add_capsule(p, (double[3]){0.0, -5e-3, 0.0}, (double[3]){0.0, 5e-3, 0.0}, 1e-3,
                             PAINTER_BLUE),
         p);
    must(painter_add_capsule(p, (double[3]){-6e-3, 0.0, 3e-3}, (double[3]){6e-3, 0.0, 3e-3}, 1e-3,
                             PAINTER_VERMILION),
         p);
    const double top[3] = {0.0, 5e-3, 0.0};
    must(painter_add_capsule(p, top, top, 1.2e-3, PAINTER_GREEN), p);
    must(painter_add_text(p, 20.0, 30.0, "a<b & \"c\" > \xc2\xb5 \xff\x01 \xe2\x82\xac",
                          PAINTER_BLACK),
         p);
    must(painter_write_png(p, path_of("crossing.png")), p);
    must(painter_write_svg(p, path_of("crossing.svg")), p);
    must(painter_write_two_views(p, path_of("crossing-two.png")), p);
    write_raw(p, "crossing.raw");
    painter_destroy(p);
}

/* Everything that can be added, in perspective. */
static void write_table(void)
{
    painter *p = start(WIDTH, HEIGHT);
    const painter_camera camera = {
        {12e-3, 14e-3, 26e-3}, {0.0, -1e-3, 0.0}, {0.0, 1.0, 0.0}, 0.0, 0.8};
    const double corners[9] = {-9e-3, -2.9e-3, -9e-3, -3e-3, -2.9e-3, -9e-3, -6e-3, 2e-3, -8e-3};
    const double axes[9] = {8e-3, -3e-3, 0.0, 0.0, -3e-3, 0.0, 0.0, 3e-3, 0.0};
    const double ball[3] = {3e-3, -1.5e-3, 6e-3};
    must(painter_set_camera(p, &camera), p);
    must(painter_add_floor(p, (double[3]){0.0, -3e-3, 0.0}, (double[3]){12e-3, 0.0, 0.0},
                           (double[3]){0.0, 0.0, 30e-3}, 12, PAINTER_FLOOR),
         p);
    must(painter_add_capsule(p, ball, ball, 1.5e-3, PAINTER_GREEN), p);
    must(painter_add_capsule(p, (double[3]){-6e-3, -2e-3, 0.0}, (double[3]){5e-3, 2e-3, -3e-3},
                             0.7e-3, PAINTER_STEEL),
         p);
    must(painter_add_capsule(p, (double[3]){0.0, -5e-3, 0.0}, (double[3]){4e-3, -5e-3, 9e-3},
                             0.5e-3, PAINTER_PINK),
         p); /* under the floor */
    must(painter_add_triangles(p, corners, 3, 0, (const uint32_t[3]){0, 1, 2}, 1, PAINTER_TISSUE),
         p);
    must(painter_add_lines(p, axes, 3, 0, PAINTER_BLUE), p);
    must(painter_add_label(p, ball, "ball", PAINTER_BLACK), p);
    must(painter_write_png(p, path_of("table.png")), p);
    must(painter_write_svg(p, path_of("table.svg")), p);
    painter_destroy(p);
}

/* ---- pixels that are hard on an encoder; check_pictures.py knows them too */

static void write_pattern(const char *name, int width, int height, int pattern)
{
    size_t size = (size_t)3 * (size_t)width * (size_t)height;
    uint8_t *pixels = malloc(size);
    uint32_t random = 1;
    if (pixels == NULL) {
        exit(2);
    }
    for (size_t i = 0; i < size; i++) {
        random = random * 1664525u + 1013904223u;
        uint8_t noise = (uint8_t)(random >> 24);
        pixels[i] = pattern == 0   ? noise
                    : pattern == 1 ? 7
                    : pattern == 2 ? (uint8_t)(i % 40000 < 20000 ? noise : i % 251)
                    : i < 36000    ? noise
                                   : pixels[i - 36000];
    }
    must(painter_save_png(path_of(name), pixels, width, height), NULL);
    free(pixels);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: %s <folder>\n", argv[0]);
        return 2;
    }
    folder = argv[1];
    write_trefoil();
    write_crossing();
    write_table();
    write_pattern("noise.png", 97, 61, 0);
    write_pattern("flat.png", 350, 250, 1);
    write_pattern("mixed.png", 301, 200, 2);
    write_pattern("repeat.png", 100, 360, 3); /* farther back than a window reaches */
    write_pattern("one.png", 1, 1, 0);
    return failures == 0 ? 0 : 1;
}
