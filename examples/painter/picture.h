/* Private to the painter: what a picture holds, how it is looked at, what rays hit. */
#ifndef VBSS_EXAMPLES_PAINTER_PICTURE_H
#define VBSS_EXAMPLES_PAINTER_PICTURE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "font.h"
#include "painter.h"

typedef struct vec {
    double x, y, z;
} vec;

static inline vec vec_of(const double v[3])
{
    return (vec){v[0], v[1], v[2]};
}
static inline vec vec_add(vec a, vec b)
{
    return (vec){a.x + b.x, a.y + b.y, a.z + b.z};
}
static inline vec vec_sub(vec a, vec b)
{
    return (vec){a.x - b.x, a.y - b.y, a.z - b.z};
}
static inline vec vec_scale(vec a, double s)
{
    return (vec){a.x * s, a.y * s, a.z * s};
}
static inline double vec_dot(vec a, vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline vec vec_cross(vec a, vec b)
{
    return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline double vec_length(vec a)
{
    return sqrt(vec_dot(a, a));
}
static inline vec vec_lerp(vec a, vec b, double t)
{
    return vec_add(a, vec_scale(vec_sub(b, a), t));
}
static inline double clamp(double value, double low, double high)
{
    return value < low ? low : value > high ? high : value;
}

/* ---- what a picture holds (painter.c) */

typedef enum shape_kind { SHAPE_CAPSULE, SHAPE_TRIANGLE, SHAPE_FLOOR, SHAPE_LINE } shape_kind;

/* Capsule, line: from a to b. Triangle: a, a + b, a + c. Floor: a + s b + t c, 0 <= s, t <= 1. */
typedef struct shape {
    shape_kind kind;
    painter_colour colour;
    vec a, b, c;
    double radius; /* of a capsule */
    double start;  /* arc length of a on its strand */
    size_t strand; /* shapes added by one call are one strand */
    int cells;     /* of a floor */
} shape;

typedef struct dot {
    vec centre;
    double pixels;
    painter_colour colour;
} dot;

enum { TEXT_SIZE = 256 };
typedef struct caption {
    bool in_scene; /* beside a point; else at pixel (point.x, point.y) */
    vec point;
    painter_colour colour;
    char text[TEXT_SIZE];
} caption;

struct painter {
    int width, height;
    bool has_camera;
    painter_camera camera;
    shape *shapes;
    dot *dots;
    caption *captions;
    size_t shape_count, shape_room, dot_count, dot_room, caption_count, caption_room, strands;
    double bar_length; /* of the scale bar; 0: none */
    char bar_text[TEXT_SIZE];
    bool has_ramp;
    char ramp_low[TEXT_SIZE], ramp_high[TEXT_SIZE];
    char error[320];
};

#define PICTURE_LARGEST 1e6 /* so that squares and sums of them stay finite */

/* Keeps the text, returns the result. */
painter_result picture_fail(painter *p, painter_result result, const char *format, ...);
/* Input is looked at before anything changes. */
painter_result picture_need(painter *p, const void *pointer, const char *name);
painter_result picture_check_point(painter *p, const double v[3], const char *name);
painter_result picture_check_colour(painter *p, painter_colour colour);
painter_result picture_check_range(painter *p, double value, double low, double high,
                                   const char *name);
/* Sets a stride of 0 to what it stands for. */
painter_result picture_check_points(painter *p, const double *points, size_t count, size_t *stride);
/* Point i of an array, which need not be aligned. */
vec picture_point(const double *points, size_t stride, size_t i);
/* Makes an array of `used` items of that size hold `more` of them. */
painter_result picture_make_room(painter *p, void **array, size_t *room, size_t used, size_t more,
                                 size_t size);

/* ---- where it is looked at from (camera.c): camera space has x right, y up, z away from the eye */

typedef struct view {
    vec eye, right, up, forward;
    bool perspective;
    double scale; /* pixels a metre; perspective: pixels of a slope of one */
    double middle_x, middle_y;
    double near;       /* perspective: what is not farther is not seen */
    int width, height; /* pixels */
} view;

typedef struct ray {
    vec from, along; /* along: of length one */
} ray;

view view_of(const painter_camera *camera, int width, int height);
/* The same picture with `times` as many pixels each way. */
view view_enlarged(const view *v, int times);
vec view_place(const view *v, vec point);
vec view_turn(const view *v, vec direction);
/* Pixels of a place in camera space; false where the eye sees nothing. */
bool view_project(const view *v, vec place, double *x, double *y);
/* Pixels a metre there. */
double view_scale_at(const view *v, double z);
ray view_ray(const view *v, double x, double y);
/* The camera from above: round the target by 90 degrees. */
painter_camera camera_from_above(const painter_camera *camera);
painter_camera camera_in_use(const painter *p);

/* ---- shapes in camera space, and rays that hit them (hit.c) */

typedef struct box {
    double x0, x1, y0, y1; /* pixels */
} box;

shape shape_placed(const view *v, const shape *s);
/* Pixels outside of which nothing of the shape is seen; capsules: between the fractions t0 and t1. */
box shape_box(const view *v, const shape *placed, double t0, double t1);
/* Distance along the ray; false when it misses. */
bool shape_hit(const shape *placed, const ray *r, double *t);
/* Unit vector out of the surface, towards the ray's origin. */
vec shape_normal(const shape *placed, const ray *r, vec point);

/* ---- light on them (render.c) */

typedef struct rgb {
    double r, g, b; /* linear light, 0 ... 1 */
} rgb;

#define PICTURE_BACKGROUND 0xf6f7f9u
#define PICTURE_INK 0x1c2127u

/* Unit vector to the light, in camera space: over the left shoulder. */
vec light_direction(void);
rgb rgb_of(painter_colour colour);
painter_colour rgb_packed(rgb light);
rgb rgb_mix(rgb a, rgb b, double t);
/* Paints the shapes seen by `camera` into rows `stride` bytes apart; false without memory. */
bool picture_render(const painter *p, const painter_camera *camera, uint8_t *pixels, size_t stride);

/* ---- what lies in front (overlay.c), on pixels (pixels.c) or in an SVG (svg.c) */

typedef struct sheet {
    void *user;
    int width, height;
    void (*disc)(void *user, double x, double y, double radius, painter_colour colour);
    void (*line)(void *user, double x0, double y0, double x1, double y1, double thickness,
                 painter_colour colour);
    void (*fill)(void *user, double x, double y, double width, double height,
                 painter_colour colour);
    /* anchor: 0 x is the left end, 1 the right end, 0.5 the middle */
    void (*text)(void *user, double x, double y, double anchor, const char *text,
                 painter_colour colour);
} sheet;

typedef struct pixel_area {
    uint8_t *first; /* of the upper left pixel */
    size_t stride;  /* bytes from row to row */
    int width, height;
} pixel_area;

sheet sheet_on_pixels(pixel_area *area);
void picture_overlay(const painter *p, const painter_camera *camera, const sheet *to);

/* ---- bytes (deflate.c, png.c) */

typedef struct bytes {
    uint8_t *data;
    size_t count, room;
    bool failed; /* no memory: what was added since is lost */
} bytes;

void bytes_add(bytes *to, const void *data, size_t count);
void bytes_free(bytes *b);
/* Appends a zlib stream of the data. */
void bytes_add_zlib(bytes *to, const uint8_t *data, size_t count);
/* Writes them to a file; 0 or errno. */
int bytes_write(const bytes *b, const char *path);
/* The same with an error of the painter, and for lost bytes too. */
painter_result picture_save(painter *p, const bytes *file, const char *path);
void png_encode(bytes *to, const uint8_t *pixels, int width, int height);

#endif
