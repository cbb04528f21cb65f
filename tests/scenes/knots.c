#include "scenes/knots.h"

#include <vblast_ss/thread.h>

#include "base/error.h"
#include "scenes/knot_path.h"

const char *const knot_names[KNOT_KINDS] = {"loop",   "overhand",     "double overhand",
                                            "square", "granny",       "surgeon's",
                                            "fls",    "half hitches", "reversed half hitches"};

void knot_shape_init(knot_shape *shape, knot_kind kind)
{
    *shape = (knot_shape){.kind = kind,
                          .cylinder_radius = 2.5e-3,
                          .thread_radius = 0.125e-3,
                          .size = 1e-3,
                          .length = 0.15,
                          .finest = 0.3e-3,
                          .coarsest = 2e-3,
                          .ratio = 1.25,
                          .rest = KNOT_REST_ARCS};
}

static bool makes_sense(const knot_shape *shape)
{
    bool kind = shape->kind >= 0 && shape->kind < KNOT_KINDS;
    bool cylinder =
        !shape->cylinder || (shape->cylinder_radius > 0.0 && shape->cylinder_radius < 1.0);
    bool size = shape->thread_radius > 0.0 && shape->size < 1.0 &&
                shape->size >= KNOT_LEAST_SIZE * shape->thread_radius;
    bool mesh = shape->finest > 0.0 && shape->coarsest >= shape->finest && shape->ratio >= 1.0 &&
                shape->ratio <= 2.0;
    return kind && cylinder && size && mesh && shape->length < 10.0 && shape->tail >= 0.0 &&
           shape->tail < 10.0;
}

/* ---- the mesh: rest lengths along the curve */

/* One length everywhere; the knot's nodes are those next to its ends, outside. */
static vbss_result mesh_evenly(const knot_shape *shape, double tail, uint32_t capacity,
                               double *rest_lengths, knot_line *line)
{
    double segments = floor(shape->length / shape->finest + 0.5);
    uint32_t count = segments < 1e6 ? (uint32_t)segments : 1000000;
    double l = shape->length / count;
    line->node_count = count + 1;
    line->knot_first = (uint32_t)floor(tail / l);
    line->knot_last = (uint32_t)ceil((tail + line->knot_length) / l);
    if (line->node_count > capacity) {
        return VBSS_ERROR_CAPACITY;
    }
    for (uint32_t i = 0; i < count; i++) {
        rest_lengths[i] = l;
    }
    return VBSS_OK;
}

/* Growing away from the knot; capacity 0: counts only. */
static vbss_result mesh_tail(const knot_shape *shape, double tail, double *rest_lengths,
                             uint32_t capacity, uint32_t *count)
{
    double coarsest = vbss_min(shape->coarsest, tail), finest = vbss_min(shape->finest, coarsest);
    return vbss_thread_grade(tail, 0.0, finest, coarsest, shape->ratio, rest_lengths, capacity,
                             count);
}

static void reverse(double *values, uint32_t count)
{
    for (uint32_t i = 0; i < count / 2; i++) {
        double value = values[i];
        values[i] = values[count - 1 - i];
        values[count - 1 - i] = value;
    }
}

static vbss_result mesh_graded(const knot_shape *shape, double tail, uint32_t capacity,
                               double *rest_lengths, knot_line *line)
{
    double tails[2] = {tail, shape->length - line->knot_length - tail};
    double in_knot = ceil(line->knot_length / shape->finest - 1e-6);
    uint32_t knot = in_knot < 1e6 ? (uint32_t)in_knot : 1000000;
    uint32_t counts[2];
    for (int i = 0; i < 2; i++) {
        vbss_result result = mesh_tail(shape, tails[i], NULL, 0, &counts[i]);
        if (result != VBSS_OK && result != VBSS_ERROR_CAPACITY) {
            return result;
        }
    }
    line->knot_first = counts[0];
    line->knot_last = counts[0] + knot;
    line->node_count = counts[0] + knot + counts[1] + 1;
    if (line->node_count > capacity) {
        return VBSS_ERROR_CAPACITY;
    }
    VBSS_TRY(mesh_tail(shape, tails[0], rest_lengths, counts[0], &counts[0]));
    reverse(rest_lengths, counts[0]);
    for (uint32_t i = line->knot_first; i < line->knot_last; i++) {
        rest_lengths[i] = line->knot_length / knot;
    }
    return mesh_tail(shape, tails[1], rest_lengths + line->knot_last, counts[1], &counts[1]);
}

/* ---- the whole */

static void place(const knot_curve *curve, double tail, vec3 *positions, const double *rest_lengths,
                  uint32_t node_count)
{
    double s = -tail;
    for (uint32_t i = 0; i < node_count; i++) {
        positions[i] = knot_curve_at(curve, s);
        s += i + 1 < node_count ? rest_lengths[i] : 0.0;
    }
}

vbss_result knot_make(const knot_shape *shape, uint32_t capacity, vec3 *positions,
                      double *rest_lengths, knot_line *line)
{
    *line = (knot_line){.cylinder_radius = shape->cylinder ? shape->cylinder_radius : 0.0};
    if (!makes_sense(shape)) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    knot_curve curve;
    knot_path(shape, &curve, line);
    if (curve.full) {
        return VBSS_ERROR_CAPACITY;
    }
    line->knot_length = knot_curve_length(&curve);
    double straight = shape->length - line->knot_length;
    double tail = shape->tail > 0.0 ? shape->tail : 0.5 * straight;
    if (!(vbss_min(tail, straight - tail) >= shape->finest)) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    VBSS_TRY(shape->finest == shape->coarsest
                 ? mesh_evenly(shape, tail, capacity, rest_lengths, line)
                 : mesh_graded(shape, tail, capacity, rest_lengths, line));
    place(&curve, tail, positions, rest_lengths, line->node_count);
    for (uint32_t i = 0; i + 1 < line->node_count && shape->rest == KNOT_REST_CHORDS; i++) {
        rest_lengths[i] = vec3_distance(positions[i], positions[i + 1]);
    }
    return VBSS_OK;
}
