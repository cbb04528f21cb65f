/* A depth buffer filled by rays: for the eye, and for the light. */
#include "raster.h"

#include <stdlib.h>

/* ---- what is nearest at each sample */

static void raster_box(const view *v, const shape *placed, uint32_t number, box b, samples *to)
{
    int x0 = (int)clamp(floor(b.x0), 0.0, to->width);
    int x1 = (int)clamp(ceil(b.x1), 0.0, to->width);
    int y0 = (int)clamp(floor(b.y0), to->top, to->top + to->height);
    int y1 = (int)clamp(ceil(b.y1), to->top, to->top + to->height);
    for (int y = y0; y < y1; y++) {
        size_t row = (size_t)(y - to->top) * (size_t)to->width;
        for (int x = x0; x < x1; x++) {
            double t, *nearest = &to->distance[row + (size_t)x];
            ray r = view_ray(v, x + 0.5, y + 0.5);
            if (shape_hit(placed, &r, &t) && t < *nearest && !(v->perspective && t <= v->near)) {
                *nearest = t;
                if (to->seen != NULL) {
                    to->seen[row + (size_t)x] = number;
                }
            }
        }
    }
}

/* A long one in pieces: the box of a slanting whole is mostly empty. */
static int pieces_of(const shape *placed)
{
    if (placed->kind != SHAPE_CAPSULE && placed->kind != SHAPE_LINE) {
        return 1;
    }
    double length = vec_length(vec_sub(placed->b, placed->a));
    return (int)clamp(ceil(length / (8.0 * placed->radius)), 1.0, 64.0);
}

void raster_shapes(const view *v, const shape *placed, size_t count, bool lines, samples *to)
{
    size_t total = (size_t)to->width * (size_t)to->height;
    for (size_t i = 0; i < total; i++) {
        to->distance[i] = HUGE_VAL;
    }
    for (size_t i = 0; i < count; i++) {
        box all = shape_box(v, &placed[i], 0.0, 1.0);
        bool outside =
            all.y1 < to->top || all.y0 > to->top + to->height || all.x1 < 0.0 || all.x0 > to->width;
        if (outside || (placed[i].kind == SHAPE_LINE && !lines)) {
            continue;
        }
        int pieces = pieces_of(&placed[i]);
        for (int k = 0; k < pieces; k++) {
            box b = shape_box(v, &placed[i], (double)k / pieces, (k + 1.0) / pieces);
            raster_box(v, &placed[i], (uint32_t)i, b, to);
        }
    }
}

/* ---- what the light sees */

enum { LARGEST_MAP = 1536 }; /* samples, each way */

vec light_direction(void)
{
    vec l = {-0.36, 0.50, -0.79};
    return vec_scale(l, 1.0 / vec_length(l));
}

bool shadows_create(const view *v, double reach, const shape *placed, size_t count, shadows *s)
{
    /* The light looks at what the eye looks at, and about as far round it. */
    int larger = v->width > v->height ? v->width : v->height;
    int side = larger < LARGEST_MAP ? larger : LARGEST_MAP;
    double around = 1.7 * reach * larger / v->width;
    vec forward = vec_scale(light_direction(), -1.0);
    vec right = vec_cross(forward, (vec){0.0, 1.0, 0.0});
    right = vec_scale(right, 1.0 / vec_length(right));
    s->light = (view){.right = right,
                      .up = vec_cross(right, forward),
                      .forward = forward,
                      .scale = side / around,
                      .middle_x = 0.5 * side,
                      .middle_y = 0.5 * side,
                      .width = side,
                      .height = side};
    s->light.eye = (vec){0.0, 0.0, v->near * 1e3}; /* the camera's target */
    const size_t total = (size_t)side * (size_t)side;
    s->map = (samples){.width = side, .height = side};
    s->map.distance = malloc(total * sizeof *s->map.distance);
    shape *lit = calloc(count + 1, sizeof *lit);
    if (s->map.distance == NULL || lit == NULL) {
        free(lit);
        shadows_destroy(s);
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        lit[i] = shape_placed(&s->light, &placed[i]);
    }
    raster_shapes(&s->light, lit, count, false, &s->map);
    free(lit);
    return true;
}

void shadows_destroy(shadows *s)
{
    free(s->map.distance);
    s->map.distance = NULL;
}

double shadows_light(const shadows *s, vec place, double size)
{
    double x, y, light = 0.0;
    vec at = view_place(&s->light, place);
    double bias = 0.4 * size + 2.0 / s->light.scale;
    view_project(&s->light, at, &x, &y);
    x = floor(x - 0.5);
    y = floor(y - 0.5);
    const int side = s->map.width;
    if (!(x >= 0.0 && x < side - 1 && y >= 0.0 && y < side - 1)) {
        return 1.0;
    }
    size_t first = (size_t)y * (size_t)side + (size_t)x;
    for (int k = 0; k < 4; k++) {
        size_t tap = first + (size_t)(k & 1) + (size_t)(k >> 1) * (size_t)side;
        light += s->map.distance[tap] < at.z - bias ? 0.0 : 0.25;
    }
    return light;
}
