/* Pairs of capsules for comparisons with other libraries; lengths as in mm. */
#ifndef VBSS_TESTS_COLLISION_CAPSULE_PAIRS_H
#define VBSS_TESTS_COLLISION_CAPSULE_PAIRS_H

#include "harness/harness.h"

typedef enum capsule_pair_kind {
    CAPSULES_ANYWHERE,
    CAPSULES_NEARLY_TOUCHING, /* the gap is up to 1e-4, or as much of an overlap */
    CAPSULES_NEARLY_PARALLEL, /* the same gap, and directions that differ by 1e-6 */
    CAPSULES_LEANING,         /* towards each other, by 1e-9 to 1e-3: closest at an end */
    CAPSULE_PAIR_KINDS
} capsule_pair_kind;

typedef struct capsule_pair {
    double vertices[12]; /* ends of axis a, of axis b */
    double radius_a, radius_b;
} capsule_pair;

static inline vec3 draw_direction(harness_source *source)
{
    vec3 v = harness_draw_vec3(source, -1.0, 1.0);
    return vec3_unit_or(v, vec3_make(1.0, 0.0, 0.0));
}

/* Ends of an axis that goes through a point. */
static inline void draw_axis_through(harness_source *source, vec3 point, vec3 direction,
                                     double ends[6])
{
    double back = harness_draw_real(source, 0.1, 4.0), ahead = harness_draw_real(source, 0.1, 4.0);
    vec3_store(ends, vec3_add_scaled(point, -back, direction));
    vec3_store(ends + 3, vec3_add_scaled(point, ahead, direction));
}

static inline capsule_pair draw_capsule_pair(harness_source *source, capsule_pair_kind kind)
{
    capsule_pair pair;
    pair.radius_a = harness_draw_real(source, 0.05, 0.3);
    pair.radius_b = harness_draw_real(source, 0.05, 0.3);
    vec3 along_a = draw_direction(source), along_b = draw_direction(source);
    if (kind == CAPSULES_NEARLY_PARALLEL) {
        along_b = vec3_unit_or(vec3_add_scaled(along_a, 1e-6, along_b), along_a);
    }
    vec3 on_a = harness_draw_vec3(source, -2.0, 2.0), on_b;
    vec3 across = vec3_unit_or(vec3_cross(along_a, along_b), vec3_any_normal(along_a));
    if (kind == CAPSULES_LEANING) {
        double lean = 1e-3;
        for (uint64_t decades = harness_draw_u64(source) % 7; decades > 0; decades--) {
            lean *= 0.1;
        }
        along_b = vec3_unit_or(vec3_add_scaled(along_a, lean, across), along_a);
    }
    if (kind == CAPSULES_ANYWHERE) {
        on_b = harness_draw_vec3(source, -2.0, 2.0);
    } else {
        double gap = harness_draw_real(source, -1e-4, 1e-4);
        on_b = vec3_add_scaled(on_a, pair.radius_a + pair.radius_b + gap, across);
    }
    draw_axis_through(source, on_a, along_a, pair.vertices);
    draw_axis_through(source, on_b, along_b, pair.vertices + 6);
    return pair;
}

#endif
