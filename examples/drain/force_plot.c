#include "force_plot.h"

#include <stdio.h>
#include <string.h>

#include "painter/painter.h"

/* The picture's plane: a millimetre of travel is a millimetre, a newton is NEWTON. */
#define NEWTON 6e-3
#define LEFT (-6e-3)
#define RIGHT 19e-3
#define LOWEST (-1.5)
#define HIGHEST 3.2
#define WIDTH 28e-3 /* across the picture */
enum { PIXELS_WIDE = 900, PIXELS_HIGH = 960 };

static void put(double to[3], double travel, double force, double before)
{
    to[0] = travel;
    to[1] = NEWTON * force;
    to[2] = before;
}

static bool line(painter *p, double x0, double y0, double x1, double y1, painter_colour colour)
{
    double ends[6];
    put(ends, x0, y0, 1e-4);
    put(ends + 3, x1, y1, 1e-4);
    return painter_add_lines(p, ends, 2, 0, colour) == PAINTER_OK;
}

static bool label(painter *p, double x, double y, const char *text)
{
    double at[3];
    put(at, x, y, 1e-4);
    return painter_add_label(p, at, text, PAINTER_BLACK) == PAINTER_OK;
}

static bool add_range(painter *p, const force_plot *plot)
{
    static const uint32_t halves[6] = {0, 1, 2, 0, 2, 3};
    double corners[12];
    put(corners, LEFT, plot->low, -0.06e-3);
    put(corners + 3, RIGHT, plot->low, -0.06e-3);
    put(corners + 6, RIGHT, plot->high, -0.06e-3);
    put(corners + 9, LEFT, plot->high, -0.06e-3);
    return painter_add_triangles(p, corners, 4, 0, halves, 2, 0xe6ecd8) == PAINTER_OK &&
           label(p, LEFT + 0.4e-3, plot->high - 0.2, plot->range);
}

static bool add_axes(painter *p)
{
    char text[32];
    bool fine = line(p, LEFT, 0.0, RIGHT, 0.0, PAINTER_BLACK) &&
                line(p, LEFT, LOWEST, LEFT, HIGHEST, PAINTER_BLACK);
    for (int i = -1; fine && i <= 3; i++) {
        snprintf(text, sizeof text, "%d N", i);
        fine = line(p, LEFT, i, LEFT + 0.4e-3, i, PAINTER_BLACK) &&
               label(p, LEFT - 1.9e-3, i - 0.05, text);
    }
    for (int i = -5; fine && i <= 15; i += 5) {
        snprintf(text, sizeof text, "%d mm", i);
        fine = line(p, 1e-3 * i, 0.0, 1e-3 * i, 0.06, PAINTER_BLACK) &&
               label(p, 1e-3 * i - 0.4e-3, -0.17, text);
    }
    return fine;
}

/* Closer to the last that was painted, in the picture: nothing is lost. */
#define CLOSE 0.25e-3

static bool is_close(const force_curve *curve, size_t a, size_t b)
{
    double travel = curve->travel[b] - curve->travel[a];
    double force = NEWTON * (curve->force[b] - curve->force[a]);
    return travel * travel + force * force < CLOSE * CLOSE;
}

static bool add_curve(painter *p, const force_curve *curve, size_t from, size_t to,
                      painter_colour colour)
{
    bool fine = true;
    size_t last = from;
    for (size_t i = from + 1; fine && i < to; i++) {
        double ends[6];
        if (i + 1 < to && is_close(curve, last, i)) {
            continue;
        }
        put(ends, curve->travel[last], curve->force[last], 0.0);
        put(ends + 3, curve->travel[i], curve->force[i], 0.0);
        fine = painter_add_chain(p, ends, 2, 0, 0.05e-3, colour, NULL) == PAINTER_OK;
        last = i;
    }
    return fine;
}

static bool write(painter *p, const char *path)
{
    size_t length = strlen(path);
    bool png = length > 4 && strcmp(path + length - 4, ".png") == 0;
    return (png ? painter_write_png(p, path) : painter_write_svg(p, path)) == PAINTER_OK;
}

bool force_plot_write(const force_plot *plot, const force_curve *curve, const char *path)
{
    painter *p;
    painter_camera camera = {.up = {0.0, 1.0, 0.0}, .width = WIDTH};
    put(camera.target, 0.5 * (LEFT + RIGHT) - 0.5e-3, 0.5 * (LOWEST + HIGHEST), 0.0);
    put(camera.eye, camera.target[0], 0.5 * (LOWEST + HIGHEST), 0.1);
    if (painter_create(PIXELS_WIDE, PIXELS_HIGH, &p) != PAINTER_OK) {
        return false;
    }
    bool fine = painter_set_camera(p, &camera) == PAINTER_OK && add_range(p, plot) && add_axes(p) &&
                add_curve(p, curve, curve->turn, curve->count, PAINTER_SKY) &&
                add_curve(p, curve, 0, curve->turn, PAINTER_VERMILION) &&
                painter_add_text(p, 16.0, 24.0, plot->title, PAINTER_BLACK) == PAINTER_OK &&
                write(p, path);
    if (!fine) {
        fprintf(stderr, "%s: %s\n", path, painter_error(p));
    }
    painter_destroy(p);
    return fine;
}
