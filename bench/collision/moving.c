#include "collision/moving.h"

#include "base/elementary.h"
#include "base/linear.h"

#include <stdlib.h>

#define TURN 6.28318530717958648

/* A segment of the knot at rest: 1.2 diameters, which a tight knot needs. */
#define KNOT_SEGMENT (1.2 * 2.0 * MOVING_RADIUS)
/* Length of the trefoil below for size 1. */
#define TREFOIL_LENGTH 25.5

/* A flat trefoil that is open at its outermost point. In a step of 1 ms its strands come nearer by 1 um
 * at the crossings, from 1.5 diameters on, and hands tremble by 0.1 mm at 10 Hz. */
static void place_knot(uint32_t segments, uint32_t step, double *positions)
{
    double size = segments * KNOT_SEGMENT / TREFOIL_LENGTH;
    double gap = 3.0 * MOVING_RADIUS - 1e-6 * step;
    for (uint32_t i = 0; i <= segments; i++) {
        double t = TURN * (i + 0.25) / (segments + 0.5), s1, c1, s2, c2;
        vbss_sincos(t, &s1, &c1);
        vbss_sincos(2.0 * t, &s2, &c2);
        double tremor = 1e-4 * vbss_sin(TURN * 10e-3 * step + 3.0 * t);
        vec3_store(positions + 3 * (size_t)i,
                   vec3_make(size * (s1 + 2.0 * s2) + tremor, size * (c1 - 2.0 * c2),
                             -0.5 * gap * vbss_sin(3.0 * t) + 0.5 * tremor));
    }
}

bool moving_make(moving *m, moving_kind kind, uint32_t segments, uint32_t steps)
{
    const moving_shapes_options coil = {.segment_count = segments};
    size_t numbers = 3 * ((size_t)segments + 1);
    m->segments = segments;
    m->steps = steps;
    m->positions = calloc((steps + 1) * numbers, sizeof *m->positions);
    if (m->positions == NULL) {
        return false;
    }
    for (uint32_t step = 0; step <= steps; step++) {
        double *positions = m->positions + step * numbers;
        if (kind == MOVING_COIL) {
            moving_shapes_place(&coil, MOVING_THREAD, step, positions);
        } else {
            place_knot(segments, step, positions);
        }
    }
    double length = 0.0;
    for (uint32_t i = 0; i < segments; i++) {
        length += vec3_distance(vec3_load(m->positions + 3 * (size_t)i),
                                vec3_load(m->positions + 3 * (size_t)i + 3));
    }
    m->length = length / segments;
    return true;
}

void moving_release(moving *m)
{
    free(m->positions);
    m->positions = NULL;
}

const double *moving_at(const moving *m, uint32_t step)
{
    return m->positions + 3 * ((size_t)m->segments + 1) * step;
}

void moving_box(const moving *m, uint32_t step, uint32_t segment, double low[3], double high[3])
{
    const double *start = moving_at(m, step) + 3 * (size_t)segment;
    const double *end = moving_at(m, step + 1) + 3 * (size_t)segment;
    for (int k = 0; k < 3; k++) {
        double smallest = start[k], largest = start[k];
        const double others[3] = {start[k + 3], end[k], end[k + 3]};
        for (int other = 0; other < 3; other++) {
            smallest = others[other] < smallest ? others[other] : smallest;
            largest = others[other] > largest ? others[other] : largest;
        }
        low[k] = smallest - MOVING_RADIUS;
        high[k] = largest + MOVING_RADIUS;
    }
}
