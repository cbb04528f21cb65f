/* The surface of a drain worked out from its views alone: nodes, triangles, and sides, which are numbered in the order of their
 * two nodes, the lower node first. Features of it and of others as points, axes and triangles, and how far they are apart. */
#ifndef VBSS_TESTS_SCENE_DRAINS_SURFACE_H
#define VBSS_TESTS_SCENE_DRAINS_SURFACE_H

#include "collision/closest.h"
#include "scene/small.h"

enum { MAX_SIDES = 1024 };
typedef struct surface {
    uint32_t body;
    double radius; /* half the wall */
    uint32_t node_count, triangle_count, side_count;
    const vec3 *x;
    const uint32_t *triangles; /* three nodes each */
    uint32_t sides[MAX_SIDES][2];
    uint32_t faces[MAX_SIDES]; /* triangles that a side has; of a lip one */
} surface;

static inline bool before(const uint32_t *a, const uint32_t *b)
{
    return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
}

static inline void add_side(surface *f, uint32_t p, uint32_t q)
{
    const uint32_t side[2] = {p < q ? p : q, p < q ? q : p};
    uint32_t at = f->side_count;
    while (at > 0 && before(side, f->sides[at - 1])) {
        at--;
    }
    if (at > 0 && !before(f->sides[at - 1], side)) {
        f->faces[at - 1]++;
        return;
    }
    assert_true(f->side_count < MAX_SIDES);
    memmove(f->sides[at + 1], f->sides[at], (f->side_count - at) * sizeof *f->sides);
    memmove(&f->faces[at + 1], &f->faces[at], (f->side_count - at) * sizeof *f->faces);
    memcpy(f->sides[at], side, sizeof side);
    f->faces[at] = 1;
    f->side_count++;
}

static inline surface surface_view(uint32_t body, vbss_drain *drain, double wall)
{
    vbss_view x, triangles;
    surface f = {.body = body, .radius = 0.5 * wall};
    expect_ok(vbss_drain_get_view(drain, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x));
    expect_ok(vbss_drain_get_view(drain, VBSS_DRAIN_VIEW_TRIANGLES, &triangles, sizeof triangles));
    f.x = x.data;
    f.triangles = triangles.data;
    f.node_count = (uint32_t)x.count;
    f.triangle_count = (uint32_t)triangles.count;
    for (uint32_t t = 0; t < f.triangle_count; t++) {
        for (uint32_t k = 0; k < 3; k++) {
            add_side(&f, f.triangles[3 * t + k], f.triangles[3 * t + (k + 1) % 3]);
        }
    }
    return f;
}

/* A point, an axis or a triangle, and how thick it is about that. */
typedef struct feature {
    uint32_t corners;
    vec3 x[3];
    double radius;
} feature;

static inline double distance_to(const feature *f, vec3 point)
{
    vec3 corners[3];
    double weights[3];
    for (uint32_t k = 0; k < 3; k++) {
        corners[k] = vec3_sub(f->x[k < f->corners ? k : f->corners - 1], point);
    }
    return f->corners == 1 ? vec3_norm(corners[0])
                           : vec3_norm(closest_on_triangle(corners, weights));
}

static inline double distance_of(const feature *a, const feature *b)
{
    double at[2];
    return a->corners == 1
               ? distance_to(b, a->x[0])
               : vec3_norm(closest_between_edges(vec3_sub(a->x[1], a->x[0]),
                                                 vec3_sub(b->x[1], b->x[0]),
                                                 vec3_sub(b->x[0], a->x[0]), &at[0], &at[1]));
}

static inline feature feature_of_drain(const surface *f, uint32_t kind, bool is_b, uint32_t number)
{
    feature g = {.radius = f->radius, .corners = 1};
    const uint32_t *nodes = &number;
    if (kind == VBSS_SCENE_CONTACT_SIDES) {
        assert_true(number < f->side_count);
        nodes = f->sides[number];
        g.corners = 2;
    } else if (is_b) {
        assert_true(number < f->triangle_count);
        nodes = f->triangles + 3 * (size_t)number;
        g.corners = 3;
    }
    for (uint32_t k = 0; k < g.corners; k++) {
        assert_true(nodes[k] < f->node_count);
        g.x[k] = f->x[nodes[k]];
    }
    return g;
}

#endif
