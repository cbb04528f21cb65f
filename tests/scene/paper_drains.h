/* What the tests of drains in scenes of method VBLAST share: one drain along x, its slit on top (+y), and tools that go
 * where they are told. */
#ifndef VBSS_TESTS_SCENE_PAPER_DRAINS_H
#define VBSS_TESTS_SCENE_PAPER_DRAINS_H

#include "baseline/drain.h"
#include "scene/paper_fixture.h"

#define HALF_WALL 0.5e-3
#define RING_RADIUS 6.5e-3

/* SIDE_NODE: at mid-length, on +z. */
enum { DRAIN_NODES = 85, SIDE_NODE = 39 };

typedef struct stage_drain {
    vbss_drain *drain;
    drain_object *object;
    uint32_t body;
} stage_drain;

static inline vbss_drain_config paper_drain(void)
{
    vbss_drain_config c;
    expect_ok(vbss_drain_config_init(&c, sizeof c));
    c.method = VBSS_METHOD_VBLAST;
    return c;
}

static inline stage_drain add_drain(stage *s, const vbss_drain_config *c)
{
    stage_drain d = {NULL, NULL, 0};
    expect_ok(scene_build_drain(s->context, s->scene, c, &d.drain, &d.body));
    expect_ok(vbss_drain_open(d.drain, &d.object));
    return d;
}

static inline stage_drain begin_with_drain(stage *s)
{
    vbss_drain_config c = paper_drain();
    begin(s);
    make(s);
    return add_drain(s, &c);
}

/* Its tip is there, and its other end further along an axis. */
static inline uint32_t add_tool(stage *s, vec3 tip, vec3 axis, double radius)
{
    uint32_t body = 0;
    vbss_scene_rigid_config c;
    expect_ok(vbss_scene_rigid_config_init(&c, sizeof c));
    vec3_store(c.position, tip);
    expect_ok(scene_build_capsule(s->scene, &c, scene_build_rod(vec3_zero(), axis, radius), &body));
    return body;
}

/* Over the side node, with its surface that far from the drain's. */
static inline vec3 over_side(double radius, double away)
{
    return vec3_make(0, 0, RING_RADIUS + HALF_WALL + radius + away);
}

static inline void go(stage *s, uint32_t tool, vec3 to)
{
    double place[3];
    vec3_store(place, to);
    expect_ok(vbss_scene_set_rigid_target(s->scene, tool, place, NULL));
    expect_ok(vbss_scene_step(s->scene, 1e-3));
}

/* Evenly, a step a millisecond. */
static inline void travel(stage *s, uint32_t tool, vec3 from, vec3 to, int steps)
{
    for (int i = 1; i <= steps; i++) {
        go(s, tool, vec3_lerp(from, to, (double)i / steps));
    }
}

static inline void wait_for(stage *s, int steps)
{
    for (int i = 0; i < steps; i++) {
        expect_ok(vbss_scene_step(s->scene, 1e-3));
    }
}

static inline uint32_t attach(const stage_drain *d, vbss_drain_attachment_kind kind, uint32_t node,
                              vec3 vector)
{
    uint32_t id;
    vbss_drain_attachment a;
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    a.stiffness = 200.0;
    vec3_store(kind == VBSS_DRAIN_ATTACHMENT_FORCE ? a.force : a.position, vector);
    expect_ok(vbss_drain_attach(d->drain, &a, &id));
    return id;
}

static inline vec3 moved(const stage_drain *d, uint32_t node)
{
    return vec3_sub(d->object->x[node], d->object->baseline->rest[node]);
}

/* How far the farthest particle is from its rest position, but for one; DRAIN_NODES: none is left out. */
static inline double farthest(const stage_drain *d, uint32_t but)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < DRAIN_NODES; i++) {
        largest = i == but ? largest : vbss_max(vec3_norm(moved(d, i)), largest);
    }
    return largest;
}

static inline vbss_drain_gap gap_of(const stage_drain *d)
{
    vbss_drain_gap gap;
    expect_ok(vbss_drain_get_gap(d->drain, &gap, sizeof gap));
    return gap;
}

/* Of the thread's axis from the drain's edges. */
static inline double clearance(stage *s, const stage_drain *d)
{
    uint32_t n;
    const vec3 *x = places(s->threads[0], &n);
    double smallest = 1.0;
    for (uint32_t e = 0; e < d->object->mesh.edge_count; e++) {
        const uint32_t *nodes = d->object->mesh.edges[e].nodes;
        const vec3 side[2] = {d->object->x[nodes[0]], d->object->x[nodes[1]]};
        smallest = vbss_min(vec3_norm(between(x, n, side, 2)), smallest);
    }
    return smallest;
}

#endif
