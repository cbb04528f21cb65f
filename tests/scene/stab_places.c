#include "scene/stab_places.h"

#include "collision/closest.h"

/* Beyond touching, m. */
#define NEAREST 1e-6
/* Tries on one side of one kind of place; a needle that is too long for the lumen is put outside. */
enum { TRIES = 30 };

static double draw(vbss_random *random, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(random);
}

/* ---- on the wall */

typedef struct on_wall {
    uint32_t triangle;
    double weights[3];
} on_wall;

static on_wall at_node(const drain_mesh *m, vbss_random *random, uint32_t node)
{
    uint32_t first = vbss_random_below(random, m->triangle_count);
    for (uint32_t i = 0; i < m->triangle_count; i++) {
        uint32_t t = (first + i) % m->triangle_count;
        for (int k = 0; k < 3; k++) {
            if (m->triangles[t][k] == node) {
                on_wall p = {.triangle = t};
                p.weights[k] = 1.0;
                return p;
            }
        }
    }
    fail_msg("node %u is of no triangle", node);
    return (on_wall){0};
}

static uint32_t draw_end_node(const drain_mesh *m, vbss_random *random)
{
    uint32_t node;
    do {
        node = vbss_random_below(random, m->node_count);
    } while (fabs(m->rest[node].x) < 0.5 * m->options.length - 1e-6);
    return node;
}

static on_wall draw_on_wall(const drain_mesh *m, vbss_random *random, stab_kind kind)
{
    on_wall p = {.triangle = vbss_random_below(random, m->triangle_count)};
    double a = vbss_random_uniform(random), b = vbss_random_uniform(random);
    uint32_t one = vbss_random_below(random, 3);
    if (kind == STAB_FACE) {
        p.weights[0] = 1.0 - sqrt(a);
        p.weights[1] = sqrt(a) * b;
        p.weights[2] = 1.0 - p.weights[0] - p.weights[1];
    } else if (kind == STAB_SIDE) {
        p.weights[one] = a;
        p.weights[(one + 1) % 3] = 1.0 - a;
    } else if (kind == STAB_NODE) {
        p.weights[one] = 1.0;
    } else if (kind == STAB_MARK) {
        p = at_node(m, random, m->marks[vbss_random_below(random, 2)]);
    } else if (kind == STAB_LIP) {
        p = at_node(
            m, random,
            m->slit_nodes[vbss_random_below(random, 2)][vbss_random_below(random, m->slit_count)]);
    } else {
        p = at_node(m, random, draw_end_node(m, random));
    }
    return p;
}

/* ---- clear of it */

static double distance(const vec3 axis[2], const vec3 corner[3])
{
    double smallest = HUGE_VAL, weights[3], s, u;
    vec3 along = vec3_sub(axis[1], axis[0]);
    for (int k = 0; k < 2; k++) {
        const vec3 from[3] = {vec3_sub(corner[0], axis[k]), vec3_sub(corner[1], axis[k]),
                              vec3_sub(corner[2], axis[k])};
        smallest = fmin(smallest, vec3_norm(closest_on_triangle(from, weights)));
    }
    for (int k = 0; k < 3; k++) {
        vec3 side = vec3_sub(corner[(k + 1) % 3], corner[k]);
        vec3 between = vec3_sub(corner[k], axis[0]);
        smallest = fmin(smallest, vec3_norm(closest_between_edges(along, side, between, &s, &u)));
    }
    return needle_case_crosses(axis, corner, &along) ? 0.0 : smallest;
}

static bool is_clear(const drain_object *d, const needle_object *n, pose at, double clear)
{
    for (uint32_t i = 0; i < n->config.segment_count; i++) {
        const vec3 axis[2] = {
            pose_apply(at, vbss_needle_point(n, vbss_needle_vertex_arc(n, i))),
            pose_apply(at, vbss_needle_point(n, vbss_needle_vertex_arc(n, i + 1)))};
        vec3 middle = vec3_lerp(axis[0], axis[1], 0.5);
        double half = 0.5 * vec3_distance(axis[0], axis[1]) + clear;
        for (uint32_t t = 0; t < d->mesh.triangle_count; t++) {
            const uint32_t *node = d->mesh.triangles[t];
            const vec3 corner[3] = {d->x[node[0]], d->x[node[1]], d->x[node[2]]};
            double size =
                fmax(vec3_distance(corner[0], corner[1]), vec3_distance(corner[0], corner[2]));
            if (vec3_distance(middle, corner[0]) < half + size && distance(axis, corner) < clear) {
                return false;
            }
        }
    }
    return true;
}

/* ---- both */

static void draw_before(const needle_case *c, const drain_object *d, double farthest,
                        vbss_random *random, stab_place *p)
{
    const on_wall on = draw_on_wall(&d->mesh, random, p->kind);
    const uint32_t *node = d->mesh.triangles[on.triangle];
    const vec3 corner[3] = {d->x[node[0]], d->x[node[1]], d->x[node[2]]};
    vec3 at = vec3_zero();
    for (int k = 0; k < 3; k++) {
        at = vec3_add_scaled(at, on.weights[k], corner[k]);
    }
    vec3 normal = vec3_cross(vec3_sub(corner[1], corner[0]), vec3_sub(corner[2], corner[0]));
    vec3 out = vec3_scale(vec3_unit_or(normal, vec3_make(0.0, 1.0, 0.0)), p->inside ? -1.0 : 1.0);
    double gap = NEAREST * pow(farthest / NEAREST, vbss_random_uniform(random));
    double touching = c->config.wire_radius + 0.5 * c->d.config.thickness;
    /* beside an edge too */
    vec3 aside = vec3_scale(vbss_random_direction(random), draw(random, 0.0, 0.5) * touching);
    at = vec3_add_scaled(at, touching + gap, out);
    p->tip = p->kind == STAB_LIP || p->kind == STAB_END ? vec3_add(at, aside) : at;
    double lean = vbss_random_uniform(random);
    p->direction = vec3_add_scaled(vec3_neg(out), 1.5 * lean * lean, vbss_random_direction(random));
    p->direction = vec3_unit_or(p->direction, vec3_neg(out));
    p->aside = vbss_random_direction(random);
}

stab_place stab_places_draw(const needle_case *c, double farthest, vbss_random *random)
{
    drain_object *d;
    needle_object *n;
    expect_ok(vbss_drain_open(c->d.drain, &d));
    expect_ok(vbss_needle_open(c->needle, &n));
    double touching = c->config.wire_radius + 0.5 * c->d.config.thickness;
    stab_place p = {.kind = vbss_random_below(random, STAB_KINDS),
                    .inside = vbss_random_below(random, 3) == 0};
    for (;;) {
        if (p.tries++ % TRIES == TRIES - 1) {
            p.kind = vbss_random_below(random, STAB_KINDS);
            p.inside = false;
        }
        assert_true(p.tries < 10000);
        draw_before(c, d, farthest, random, &p);
        pose at = needle_case_pose(c->config.radius, p.tip, p.direction, p.aside);
        if (is_clear(d, n, at, touching)) {
            return p;
        }
    }
}
