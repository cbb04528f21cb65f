/* A drain at rest, and a needle, for tests of what happens between them. */
#ifndef VBSS_TESTS_SUTURE_FIXTURE_H
#define VBSS_TESTS_SUTURE_FIXTURE_H

#include <math.h>
#include <string.h>

#include "harness/harness.h"
#include "suture/suture.h"

#define WIRE 0.35e-3
#define TOUCHING 0.85e-3
#define REACH 3.4e-3

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    drain_object *d;
    needle_object *n;
} fixture;

static inline void begin(fixture *f)
{
    vbss_drain_config drain;
    vbss_needle_config needle;
    vbss_drain *made;
    vbss_needle *other;
    f->context = harness_context(&f->memory);
    expect_ok(vbss_drain_config_init(&drain, sizeof drain));
    expect_ok(vbss_needle_config_init(&needle, sizeof needle));
    expect_ok(vbss_drain_create(f->context, &drain, &made));
    expect_ok(vbss_needle_create(f->context, &needle, &other));
    expect_ok(vbss_drain_open(made, &f->d));
    expect_ok(vbss_needle_open(other, &f->n));
}

static inline void end(fixture *f)
{
    harness_context_end(f->context, &f->memory);
}

static inline vec3 corner(const fixture *f, uint32_t t, int k)
{
    return f->d->x[f->d->mesh.triangles[t][k]];
}

static inline vec3 place_in(const fixture *f, uint32_t t, double a, double b)
{
    vec3 p = vec3_scale(corner(f, t, 0), 1.0 - a - b);
    return vec3_add_scaled(vec3_add_scaled(p, a, corner(f, t, 1)), b, corner(f, t, 2));
}

/* Unit, outward. */
static inline vec3 normal_of(const fixture *f, uint32_t t)
{
    vec3 n = vec3_cross(vec3_sub(corner(f, t, 1), corner(f, t, 0)),
                        vec3_sub(corner(f, t, 2), corner(f, t, 0)));
    return vec3_unit_or(n, vec3_zero());
}

/* A tip that touches the wall from outside before that point, and is pressed straight in. */
static inline suture_tip tip_before(const fixture *f, uint32_t t, vec3 point, double force)
{
    vec3 n = normal_of(f, t);
    return (suture_tip){.position = vec3_add_scaled(point, TOUCHING, n),
                        .direction = vec3_neg(n),
                        .force = vec3_scale(n, force),
                        .normal = n};
}

static inline bool is_anchored(const fixture *f, uint32_t t)
{
    const uint32_t *node = f->d->mesh.triangles[t];
    return f->d->anchored[node[0]] && f->d->anchored[node[1]] && f->d->anchored[node[2]];
}

/* From a point at rest to the nearest free side. */
static inline double to_free_side(const fixture *f, vec3 point)
{
    double smallest = HUGE_VAL;
    for (uint32_t i = 0; i < f->d->mesh.edge_count; i++) {
        const drain_edge *side = &f->d->mesh.edges[i];
        vec3 a = f->d->x[side->nodes[0]], b = f->d->x[side->nodes[1]];
        vec3 along = vec3_sub(b, a);
        double share = vec3_dot(vec3_sub(point, a), along) / vec3_norm_squared(along);
        vec3 nearest = vec3_add_scaled(a, fmin(fmax(share, 0.0), 1.0), along);
        if (side->triangles[1] == DRAIN_NONE) {
            smallest = fmin(smallest, vec3_distance(point, nearest));
        }
    }
    return smallest;
}

#endif
