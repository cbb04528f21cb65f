#include "scenes/throw_stack.h"

#include <stdlib.h>

#include "base/random.h"
#include "scenes/knot_path.h"
#include "scenes/swept.h"

void throw_stack_init(throw_stack *stack)
{
    *stack = (throw_stack){.size = 1e-3,
                           .depth = 4e-3,
                           .drain = 3e-3,
                           .tail = 15e-3,
                           .limb = 60e-3,
                           .segments = 240,
                           .coarseness = 3.0,
                           .seed = 1};
}

void throw_stack_add(throw_stack *stack, int wraps, int sign)
{
    if (stack->throws < STACK_THROWS) {
        stack->wraps[stack->throws] = wraps;
        stack->signs[stack->throws++] = sign;
    }
}

static bool within(double value, double least, double most)
{
    return value >= least && value <= most;
}

static bool makes_sense(const throw_stack *stack)
{
    bool throws = stack->throws <= STACK_THROWS;
    for (uint32_t i = 0; i < stack->throws && throws; i++) {
        throws = stack->wraps[i] >= 0 && stack->wraps[i] <= 3 &&
                 (stack->signs[i] == 1 || stack->signs[i] == -1);
    }
    return throws && within(stack->size, 1e-4, 1e-2) &&
           within(stack->depth, 4.0 * stack->size, 1.0) &&
           within(stack->drain, 1e-6, stack->depth) && within(stack->tail, 1e-4, 1.0) &&
           within(stack->limb, 1e-4, 1.0) && stack->segments >= 30 &&
           stack->segments < STACK_POINTS && within(stack->coarseness, 1.0, 10.0) &&
           within(stack->unevenness, 0.0, 0.9);
}

/* ---- segments: equal shares of a measure that counts limbs less */

typedef struct measure {
    double limbs[2], knot, coarseness; /* m */
} measure;

static double measured(const measure *m)
{
    return (m->limbs[0] + m->limbs[1]) / m->coarseness + m->knot;
}

/* The length along the curve, from the knot's beginning on, where so much has been measured; and back. */
static double along(const measure *m, double amount)
{
    double first = m->limbs[0] / m->coarseness;
    if (amount < first) {
        return (amount - first) * m->coarseness;
    }
    double in_knot = amount - first;
    return in_knot < m->knot ? in_knot : m->knot + (in_knot - m->knot) * m->coarseness;
}

/* Lengths along the curve where the points are. */
static void place_points(const throw_stack *stack, const measure *m, double *lengths)
{
    vbss_random random;
    vbss_random_seed(&random, stack->seed, 31);
    double sum = 0.0, reached = 0.0;
    for (uint32_t i = 0; i < stack->segments; i++) {
        lengths[i] = 1.0 + stack->unevenness * (2.0 * vbss_random_uniform(&random) - 1.0);
        sum += lengths[i];
    }
    for (uint32_t i = 0; i <= stack->segments; i++) {
        double s = along(m, measured(m) * vbss_min(reached / sum, 1.0));
        reached += i < stack->segments ? lengths[i] : 0.0;
        lengths[i] = s; /* what stood there was taken */
    }
}

/* ---- proof that the points show the curve: of a much finer line all other points can be taken away */

static bool put_finely(const knot_curve *curve, const double *lengths, uint32_t segments,
                       uint32_t pieces, swept_line *fine)
{
    for (uint32_t i = 0; i < segments; i++) {
        double from = lengths[i], step = (lengths[i + 1] - from) / pieces;
        for (uint32_t k = 0; k < pieces; k++) {
            vec3 a = knot_curve_at(curve, from + k * step);
            vec3 b = knot_curve_at(curve, from + (k + 1) * step);
            vec3 middle = knot_curve_at(curve, from + (k + 0.5) * step);
            double deviation = vec3_distance(middle, vec3_lerp(a, b, 0.5));
            if (!swept_put(fine, a, deviation, k == 0)) {
                return false;
            }
        }
    }
    return swept_put(fine, knot_curve_at(curve, lengths[segments]), 0.0, true);
}

static bool shows(const knot_curve *curve, const double *lengths, uint32_t segments, double size)
{
    swept_line *fine = malloc(sizeof *fine);
    if (fine == NULL) {
        return false;
    }
    uint32_t pieces = segments < 400 ? 3200 / segments : 6;
    double shortest = DBL_MAX;
    for (uint32_t i = 0; i < segments; i++) {
        shortest = vbss_min(shortest, (lengths[i + 1] - lengths[i]) / pieces);
    }
    swept_begin(fine, 0.1 * vbss_min(shortest, 0.1 * size));
    bool shown = put_finely(curve, lengths, segments, pieces, fine);
    if (shown) {
        swept_finish(fine);
        swept_put_ray(fine, 0, vec3_make(-1.0, 0.0, 0.0));
        swept_put_ray(fine, fine->last, vec3_make(1.0, 0.0, 0.0));
        shown = swept_is_true(fine) && swept_thin_all(fine);
    }
    free(fine);
    return shown;
}

static double place_of(const double *lengths, uint32_t count, double s)
{
    uint32_t i = 0;
    while (i + 2 < count && lengths[i + 1] <= s) {
        i++;
    }
    return i + (s - lengths[i]) / (lengths[i + 1] - lengths[i]);
}

bool throw_stack_make(const throw_stack *stack, thread_line *line)
{
    if (!makes_sense(stack)) {
        return false;
    }
    knot_pile pile = {.throws = stack->throws > 0 ? stack->throws : 1, .signs = {1}};
    for (uint32_t i = 0; i < stack->throws; i++) {
        pile.wraps[i] = stack->wraps[i];
        pile.signs[i] = stack->signs[i];
    }
    knot_curve curve;
    knot_curve_begin(&curve, KNOT_PATH_SPACING * stack->size);
    knot_path_pile(&pile, stack->size, 0.5 * stack->depth, &curve);
    if (curve.full) {
        return false;
    }
    measure m = {{stack->tail, stack->limb}, knot_curve_length(&curve), stack->coarseness};
    double lengths[STACK_POINTS] = {0.0}, middle = 0.5 * m.knot;
    place_points(stack, &m, lengths);
    if (!shows(&curve, lengths, stack->segments, stack->size)) {
        return false;
    }
    line->count = stack->segments + 1;
    for (uint32_t i = 0; i < line->count; i++) {
        line->x[i] = knot_curve_at(&curve, lengths[i]);
    }
    line->tissue_place = place_of(lengths, line->count, middle);
    for (int i = 0; i < 2; i++) {
        double s = middle + (i == 0 ? -0.5 : 0.5) * stack->drain;
        line->hole_places[i] = place_of(lengths, line->count, s);
        line->holes[i] = thread_line_at(line, line->hole_places[i]);
    }
    line->away = vec3_make(0.0, 0.0, -1.0);
    return true;
}

/* ---- lines */

vec3 thread_line_at(const thread_line *line, double place)
{
    double last = (double)line->count - 1.0;
    double p = vbss_min(vbss_max(place, 0.0), last);
    uint32_t i = (uint32_t)p;
    i = i + 2 > line->count ? line->count - 2 : i;
    return vec3_lerp(line->x[i], line->x[i + 1], p - i);
}

void thread_line_leave_tissue(thread_line *line)
{
    line->tissue_place = line->hole_places[0] = line->hole_places[1] = -1.0;
    line->holes[0] = line->holes[1] = line->away = vec3_zero();
}

static void swap(vec3 *a, vec3 *b)
{
    vec3 kept = *a;
    *a = *b;
    *b = kept;
}

void thread_line_reverse(thread_line *line)
{
    double last = (double)line->count - 1.0, first_hole = line->hole_places[0];
    for (uint32_t i = 0; i < line->count / 2; i++) {
        swap(&line->x[i], &line->x[line->count - 1 - i]);
    }
    if (line->tissue_place < 0.0) {
        return;
    }
    swap(&line->holes[0], &line->holes[1]);
    line->hole_places[0] = last - line->hole_places[1];
    line->hole_places[1] = last - first_hole;
    line->tissue_place = last - line->tissue_place;
}

void thread_line_mirror(thread_line *line)
{
    for (uint32_t i = 0; i < line->count; i++) {
        line->x[i].x = -line->x[i].x;
    }
    line->holes[0].x = -line->holes[0].x;
    line->holes[1].x = -line->holes[1].x;
    line->away.x = -line->away.x;
}
