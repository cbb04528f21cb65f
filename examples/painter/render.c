/* The picture in pixels: what the eye sees at each sample, outlined, lit, and averaged.
 * It is made in bands, so that a large picture needs little memory. */
#include "raster.h"

#include <stdlib.h>

enum {
    SAMPLES = 3, /* a pixel, each way */
    BAND = 64,   /* pixels high */
    MARGIN = 6   /* pixels above and below it that outlines and dusk may come from */
};

/* In radii of what is in front, and in pixels at most. */
static const double outline_part = 0.34, widest_outline = 1.5;
static const double dusk_part = 1.0, widest_dusk = MARGIN - 1.0;
static const double outline_strength = 0.9, dusk_strength = 0.65;

typedef struct scene {
    view v; /* in samples */
    const shape *placed;
    shadows shade;
    samples seen;
    float *covered; /* how much of each sample's light is taken by an outline or dusk, 0 ... 1 */
} scene;

/* ---- outlines and dusk: next to the edge of something nearer, what is behind it gets dark */

static bool is_empty(const scene *s, size_t at)
{
    return s->seen.distance[at] >= HUGE_VAL;
}

/* Neighbours on one strand pass into each other; its far parts that cross do not. */
static bool is_one_surface(const shape *a, const shape *b)
{
    if (a->strand != b->strand || a->kind != SHAPE_CAPSULE) {
        return a->strand == b->strand;
    }
    double end_a = a->start + vec_length(vec_sub(a->b, a->a));
    double end_b = b->start + vec_length(vec_sub(b->b, b->a));
    return fmax(a->start, b->start) - fmin(end_a, end_b) < 4.0 * a->radius;
}

/* Something stands before what is seen at `behind`, by more than a crossing's rounding. */
static bool is_before(const scene *s, const shape *front, double distance, size_t behind)
{
    if (is_empty(s, behind)) {
        return true;
    }
    return s->seen.distance[behind] - distance > 0.25 * front->radius &&
           !is_one_surface(front, &s->placed[s->seen.seen[behind]]);
}

/* Round a sample at the edge of `front`: a line, and on surfaces a dusk that fades away from it. */
static void darken_round(scene *s, int x, int y, const shape *front, double distance, bool dusk)
{
    double z = 0.5 * (front->a.z + front->b.z), width = s->seen.width;
    double radius = front->radius * view_scale_at(&s->v, z) / SAMPLES; /* pixels */
    bool flat = front->kind != SHAPE_CAPSULE;
    double line = SAMPLES * (flat ? 0.8 : fmin(outline_part * radius, widest_outline));
    double reach = SAMPLES * (flat ? 1.5 : fmin(dusk_part * radius, widest_dusk));
    reach = dusk ? fmax(reach, line) : line;
    int left = (int)fmax(ceil(x - reach), 0.0), right = (int)fmin(x + reach, width - 1.0);
    int top = (int)fmax(ceil(y - reach), 0.0);
    int bottom = (int)fmin(y + reach, s->seen.height - 1.0);
    for (int row = top; row <= bottom; row++) {
        for (int column = left; column <= right; column++) {
            size_t at = (size_t)row * (size_t)s->seen.width + (size_t)column;
            double dx = column - x, dy = row - y, off = sqrt(dx * dx + dy * dy), dark = 0.0;
            if (off <= line) {
                dark = outline_strength;
            } else if (dusk && off < reach && !is_empty(s, at)) {
                dark = dusk_strength * (1.0 - off / reach);
            }
            if (dark > (double)s->covered[at] && is_before(s, front, distance, at)) {
                s->covered[at] = (float)dark;
            }
        }
    }
}

/* Of a sample: is it an edge, and is there a surface behind? */
static void darken_behind(scene *s, int x, int y)
{
    size_t width = (size_t)s->seen.width, at = (size_t)y * width + (size_t)x;
    if (is_empty(s, at)) {
        return;
    }
    const shape *front = &s->placed[s->seen.seen[at]];
    if (front->kind != SHAPE_CAPSULE && front->kind != SHAPE_TRIANGLE) {
        return;
    }
    const size_t next[4] = {x > 0 ? at - 1 : at, x + 1 < s->seen.width ? at + 1 : at,
                            y > 0 ? at - width : at, y + 1 < s->seen.height ? at + width : at};
    double distance = s->seen.distance[at];
    bool edge = false, surface = false;
    for (int i = 0; i < 4; i++) {
        if (is_before(s, front, distance, next[i])) {
            edge = true;
            surface = surface || !is_empty(s, next[i]);
        }
    }
    if (edge) {
        darken_round(s, x, y, front, distance, surface);
    }
}

static void darken_all(scene *s)
{
    size_t total = (size_t)s->seen.width * (size_t)s->seen.height;
    for (size_t i = 0; i < total; i++) {
        s->covered[i] = 0.0F;
    }
    for (int y = 0; y < s->seen.height; y++) {
        for (int x = 0; x < s->seen.width; x++) {
            darken_behind(s, x, y);
        }
    }
}

/* ---- light */

/* Lines between the cells, about a pixel wide: how much of one there is at a place on the floor. */
static double grid_line(const scene *s, const shape *floor_shape, vec place)
{
    vec from = vec_sub(place, floor_shape->a), normal = vec_cross(floor_shape->b, floor_shape->c);
    double area2 = vec_dot(normal, normal), line = 0.0;
    double scale = view_scale_at(&s->v, place.z) / SAMPLES;
    for (int axis = 0; axis < 2; axis++) {
        vec along = axis == 0 ? floor_shape->b : floor_shape->c;
        vec other = axis == 0 ? floor_shape->c : floor_shape->b;
        vec across = vec_cross(other, normal);
        double t = fabs(vec_dot(from, across)) / area2 * floor_shape->cells;
        double off = fabs(t - floor(t + 0.5)) / floor_shape->cells * vec_length(along);
        line = fmax(line, clamp(1.1 - off * scale, 0.0, 1.0));
    }
    return line;
}

static rgb lit(const scene *s, const shape *seen, const ray *r, double distance)
{
    const rgb dark = rgb_of(PICTURE_INK), white = {1.0, 1.0, 1.0};
    rgb own = rgb_of(seen->colour);
    if (seen->kind == SHAPE_LINE) {
        return own;
    }
    vec place = vec_add(r->from, vec_scale(r->along, distance));
    vec normal = shape_normal(seen, r, place), light = light_direction();
    double faces_light = vec_dot(normal, light), faces_eye = -vec_dot(normal, r->along);
    double sun = shadows_light(&s->shade, place, seen->radius);
    if (seen->kind == SHAPE_FLOOR) {
        own = rgb_mix(own, dark, 0.16 * grid_line(s, seen, place));
        return rgb_mix(own, dark, 0.3 * (1.0 - sun));
    }
    /* Half of the light comes from everywhere above; edges turn away into the dark. */
    double wrapped = 0.5 + 0.5 * faces_light;
    double strength = 0.36 + 0.3 * wrapped + 0.5 * (0.4 + 0.6 * sun) * fmax(faces_light, 0.0);
    if (seen->kind == SHAPE_CAPSULE) {
        double rim = clamp(faces_eye / 0.6, 0.0, 1.0);
        strength *= 0.45 + 0.55 * rim * (2.0 - rim);
    }
    own = (rgb){own.r * strength, own.g * strength, own.b * strength};
    vec half = vec_sub(light, r->along);
    double shine = fmax(vec_dot(normal, half) / vec_length(half), 0.0);
    shine *= shine;
    shine *= shine;
    shine *= shine;
    shine *= shine; /* to the power of 16 */
    return rgb_mix(own, white, 0.24 * sun * shine * shine);
}

static rgb sample_light(const scene *s, int x, int y)
{
    const rgb dark = rgb_of(PICTURE_INK);
    size_t at = (size_t)y * (size_t)s->seen.width + (size_t)x;
    rgb own = rgb_of(PICTURE_BACKGROUND);
    if (!is_empty(s, at)) {
        ray r = view_ray(&s->v, x + 0.5, s->seen.top + y + 0.5);
        own = lit(s, &s->placed[s->seen.seen[at]], &r, s->seen.distance[at]);
    }
    return rgb_mix(own, dark, (double)s->covered[at]);
}

/* ---- pixels out of samples */

static void average_row(const scene *s, int first_sample, int width, uint8_t *row)
{
    const double share = 1.0 / (SAMPLES * SAMPLES);
    for (int x = 0; x < width; x++) {
        rgb sum = {0.0, 0.0, 0.0};
        for (int k = 0; k < SAMPLES * SAMPLES; k++) {
            rgb one = sample_light(s, x * SAMPLES + k % SAMPLES, first_sample + k / SAMPLES);
            sum = (rgb){sum.r + one.r, sum.g + one.g, sum.b + one.b};
        }
        painter_colour mean = rgb_packed((rgb){sum.r * share, sum.g * share, sum.b * share});
        uint8_t *pixel = row + 3 * (size_t)x;
        pixel[0] = (uint8_t)(mean >> 16);
        pixel[1] = (uint8_t)(mean >> 8 & 255);
        pixel[2] = (uint8_t)(mean & 255);
    }
}

static void render_band(scene *s, size_t count, int top, const painter *p, uint8_t *pixels,
                        size_t stride)
{
    int bottom = top + BAND < p->height ? top + BAND : p->height;
    s->seen.top = (top - MARGIN) * SAMPLES;
    s->seen.height = (bottom - top + 2 * MARGIN) * SAMPLES;
    raster_shapes(&s->v, s->placed, count, true, &s->seen);
    darken_all(s);
    for (int y = top; y < bottom; y++) {
        average_row(s, (y - top + MARGIN) * SAMPLES, p->width, pixels + (size_t)y * stride);
    }
}

bool picture_render(const painter *p, const painter_camera *camera, uint8_t *pixels, size_t stride)
{
    view v = view_of(camera, p->width, p->height);
    scene s = {.v = view_enlarged(&v, SAMPLES)};
    size_t total = (size_t)s.v.width * (BAND + 2 * MARGIN) * SAMPLES;
    shape *placed = calloc(p->shape_count + 1, sizeof *placed);
    s.seen.width = s.v.width;
    s.seen.distance = malloc(total * sizeof *s.seen.distance);
    s.seen.seen = malloc(total * sizeof *s.seen.seen);
    s.covered = malloc(total * sizeof *s.covered);
    bool enough =
        placed != NULL && s.seen.distance != NULL && s.seen.seen != NULL && s.covered != NULL;
    if (enough) {
        for (size_t i = 0; i < p->shape_count; i++) {
            placed[i] = shape_placed(&v, &p->shapes[i]);
        }
        s.placed = placed;
        double reach = p->width / view_scale_at(&v, v.near * 1e3);
        enough = shadows_create(&s.v, reach, placed, p->shape_count, &s.shade);
    }
    for (int top = 0; enough && top < p->height; top += BAND) {
        render_band(&s, p->shape_count, top, p, pixels, stride);
    }
    shadows_destroy(&s.shade);
    free(s.covered);
    free(s.seen.seen);
    free(s.seen.distance);
    free(placed);
    return enough;
}
