/* Pictures of a scene: capsules, chains of capsules, triangles, floors, dots and text, painted to a
 * PNG (depth buffer) or an SVG (sorted strokes). Made for examples, tests and benches; it needs the
 * C library only.
 *
 *     painter *p;
 *     if (painter_create(800, 600, &p) == PAINTER_OK) {
 *         painter_add_chain(p, positions, count, 0, 0.125e-3, PAINTER_VIOLET, NULL);
 *         painter_write_two_views(p, "knot.png");
 *         painter_destroy(p);
 *     }
 *
 * Lengths are in metres, points are three doubles, at most 1e6 each. Every function that can fail
 * returns a painter_result; a call that fails leaves the scene as it was and a text for
 * painter_error. Pointers must not be NULL unless that is said. The same calls give the same bytes.
 * A painter belongs to one thread at a time; different painters are independent. */
#ifndef VBSS_EXAMPLES_PAINTER_H
#define VBSS_EXAMPLES_PAINTER_H

#include <stddef.h>
#include <stdint.h>

typedef enum painter_result {
    PAINTER_OK = 0,
    PAINTER_ERROR_NULL = -1,   /* an argument that must not be NULL is */
    PAINTER_ERROR_NUMBER = -2, /* not finite, or out of range */
    PAINTER_ERROR_MEMORY = -3,
    PAINTER_ERROR_FILE = -4 /* the file cannot be opened or written */
} painter_result;

/* 0xrrggbb; the eight of Okabe and Ito are told apart by the colour-blind too. */
typedef uint32_t painter_colour;
#define PAINTER_ORANGE 0xe69f00u
#define PAINTER_SKY 0x56b4e9u
#define PAINTER_GREEN 0x009e73u
#define PAINTER_YELLOW 0xf0e442u
#define PAINTER_BLUE 0x0072b2u
#define PAINTER_VERMILION 0xd55e00u
#define PAINTER_PINK 0xcc79a7u
#define PAINTER_BLACK 0x202428u
/* and some for things: a suture, steel, tissue, a floor */
#define PAINTER_VIOLET 0x7353b5u
#define PAINTER_STEEL 0xa9b4bfu
#define PAINTER_TISSUE 0xe3b3a4u
#define PAINTER_FLOOR 0xdfe3e6u

enum { PAINTER_MAX_SIZE = 8192 }; /* pixels, each way */

typedef struct painter painter;

typedef struct painter_camera {
    double eye[3], target[3];
    double up[3]; /* points up in the picture; need not be perpendicular to the view */
    double width; /* orthographic: metres across the picture; 0: perspective */
    double angle; /* perspective: radians across the picture, 0.01 ... 2.8; else ignored */
} painter_camera;

/* ---- a painter (painter.c) */

painter_result painter_create(int width, int height,
                              painter **out); /* pixels; *out NULL on error */
void painter_destroy(painter *p);             /* NULL: nothing happens */
void painter_clear(painter *p); /* removes all that was added, keeps the camera; NULL: nothing */
/* What the last failed call of this painter complained about; "" when none has failed. */
const char *painter_error(const painter *p);
const char *painter_result_string(painter_result result);

/* ---- where to look from (camera.c) */

painter_result painter_set_camera(painter *p, const painter_camera *camera);
/* An orthographic camera that shows all that was added so far, a border around it, seen along
 * `direction` (from the eye to the scene). A painter whose camera was never set does this by itself
 * when it writes, along -z with y up. */
painter_result painter_fit_camera(painter *p, const double direction[3], const double up[3]);
/* The camera that is or would be used. */
painter_result painter_get_camera(painter *p, painter_camera *camera);

/* ---- what to paint (add.c); colours above 0xffffff are out of range */

/* a == b: a ball. What is thinner than 1.6 pixels is painted that thick. */
painter_result painter_add_capsule(painter *p, const double a[3], const double b[3], double radius,
                                   painter_colour colour);
/* Capsules between `count` points, each stride_bytes after the one before (0: 24, packed). With
 * segment_colours (may be NULL) segment i, between points i and i + 1, has colour i of count - 1. */
painter_result painter_add_chain(painter *p, const double *positions, size_t count,
                                 size_t stride_bytes, double radius, painter_colour colour,
                                 const painter_colour *segment_colours);
/* Triangles seen from both sides; indices: three for each, below vertex_count. */
painter_result painter_add_triangles(painter *p, const double *vertices, size_t vertex_count,
                                     size_t stride_bytes, const uint32_t *indices,
                                     size_t triangle_count, painter_colour colour);
/* A plane patch of corners centre +- u +- v, with `cells` grid cells each way (at least 1, at most
 * 1000); shadows fall on it. In an SVG what lies beyond its plane is painted first, then it. */
painter_result painter_add_floor(painter *p, const double centre[3], const double u[3],
                                 const double v[3], int cells, painter_colour colour);
/* Lines without thickness, one pixel wide: axes, boxes, paths. Points as in painter_add_chain. */
painter_result painter_add_lines(painter *p, const double *positions, size_t count,
                                 size_t stride_bytes, painter_colour colour);
/* Highlights, such as contact points: discs of `pixels` radius (0.5 ... 100) in a white and a
 * dark ring, in front of everything. */
painter_result painter_add_dots(painter *p, const double *positions, size_t count,
                                size_t stride_bytes, double pixels, painter_colour colour);

/* ---- text, in front of everything; ASCII in a PNG, UTF-8 in an SVG; at most 255 bytes are kept */

/* At a pixel, counted from the upper left corner: left end of the base line. */
painter_result painter_add_text(painter *p, double x, double y, const char *text,
                                painter_colour colour);
/* Beside a point of the scene. */
painter_result painter_add_label(painter *p, const double point[3], const char *text,
                                 painter_colour colour);
/* In the lower left corner, of that length in metres; only painted by orthographic cameras. */
painter_result painter_add_scale_bar(painter *p, double length, const char *text);
/* In the lower right corner: the ramp with its ends, such as "0 N" and "2 N". */
painter_result painter_add_ramp(painter *p, const char *low, const char *high);

/* ---- colours (colour.c) */

/* A ramp of even steps to the eye, darker = lower, from blue over red to yellow; low .. high are its
 * ends, beyond them the end stays. Grey when a number is not finite or low == high. */
painter_colour painter_ramp(double value, double low, double high);

/* ---- pictures; painter_write_* replace the file. A PNG has exact depth, outlines and shadows; an
 * SVG sorts short strokes by the depth of their middles, without shadows: things that touch or cut
 * each other are better looked at in a PNG */

painter_result painter_write_png(painter *p, const char *path);
painter_result painter_write_svg(painter *p, const char *path);
/* One PNG, twice as wide: left what the camera sees, right the same from above (the camera goes
 * round its target by 90 degrees, towards its up). */
painter_result painter_write_two_views(painter *p, const char *path);
/* The pixels of the PNG: rows from above, 3 bytes (red, green, blue) a pixel, no gaps. size: of the
 * array, at least 3 * width * height. */
painter_result painter_paint(painter *p, uint8_t *pixels, size_t size);

/* ---- the encoder alone (png.c): 3 * width * height bytes, rows as in painter_paint */
painter_result painter_save_png(const char *path, const uint8_t *pixels, int width, int height);

#endif
