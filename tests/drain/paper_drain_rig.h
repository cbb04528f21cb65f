/* One drain of method VBLAST in a watched context. Every call that fails, fails the test. */
#ifndef VBSS_TESTS_PAPER_DRAIN_RIG_H
#define VBSS_TESTS_PAPER_DRAIN_RIG_H

#include <string.h>

#include "fixtures/baseline_of.h"
#include "harness/harness.h"

#include "drain/drain.h"

/* Rows of 12 particles; the middle one, whose first is doubled by the last of all. */
enum { PAPER_NODES = 85, PAPER_ROUND = 12, PAPER_MIDDLE = 3 * PAPER_ROUND, PAPER_DOUBLE = 84 };

typedef struct paper_rig {
    harness_memory memory;
    vbss_context *context;
    vbss_drain *drain;
    drain_object *object;
} paper_rig;

/* The defaults, undamped. */
static inline vbss_drain_config paper_config(void)
{
    vbss_drain_config config;
    expect_ok(vbss_drain_config_init(&config, sizeof config));
    config.method = VBSS_METHOD_VBLAST;
    baseline_of(&config.baseline)->drain_damping = 0.0;
    config.drag = 0.0;
    return config;
}

/* The rig must stay where it is until its end. */
static inline void paper_begin(paper_rig *r, const vbss_drain_config *config)
{
    r->context = harness_context(&r->memory);
    expect_ok(vbss_drain_create(r->context, config, &r->drain));
    expect_ok(vbss_drain_open(r->drain, &r->object));
}

static inline void paper_end(paper_rig *r)
{
    harness_context_end(r->context, &r->memory);
}

static inline void paper_run(paper_rig *r, double h, uint32_t steps)
{
    for (uint32_t i = 0; i < steps; i++) {
        expect_ok(vbss_drain_step(r->drain, h));
    }
}

static inline vec3 paper_vector(paper_rig *r, vbss_drain_field field, uint32_t i)
{
    vbss_view view;
    expect_ok(vbss_drain_get_view(r->drain, field, &view, sizeof view));
    assert_true(i < view.count);
    return vec3_load((const double *)view.data + 3 * (size_t)i);
}

static inline vec3 paper_place(paper_rig *r, uint32_t node)
{
    return paper_vector(r, VBSS_DRAIN_VIEW_POSITIONS, node);
}

/* From its rest position, in a drain whose frame is the world. */
static inline vec3 paper_moved(paper_rig *r, uint32_t node)
{
    return vec3_sub(paper_place(r, node), paper_vector(r, VBSS_DRAIN_VIEW_REST_POSITIONS, node));
}

/* Takes nodes away from where they are; all others stay. */
static inline void paper_displace(paper_rig *r, const uint32_t *nodes, const vec3 *displacements,
                                  uint32_t count)
{
    vec3 x[PAPER_NODES];
    memcpy(x, r->object->x, sizeof x);
    for (uint32_t k = 0; k < count; k++) {
        x[nodes[k]] = vec3_add(x[nodes[k]], displacements[k]);
    }
    expect_ok(vbss_drain_set_state(r->drain, &x[0].x, NULL, PAPER_NODES));
}

/* PIN and SPRING at a place, FORCE of that vector. */
static inline uint32_t paper_attach(paper_rig *r, vbss_drain_attachment_kind kind, uint32_t node,
                                    vec3 vector, double stiffness)
{
    uint32_t id;
    vbss_drain_attachment a;
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    a.stiffness = stiffness;
    vec3_store(kind == VBSS_DRAIN_ATTACHMENT_FORCE ? a.force : a.position, vector);
    expect_ok(vbss_drain_attach(r->drain, &a, &id));
    return id;
}

static inline void paper_take(paper_rig *r, uint32_t id, vec3 target)
{
    double t[3];
    vec3_store(t, target);
    expect_ok(vbss_drain_set_attachment_target(r->drain, id, t));
}

static inline vec3 paper_reaction(paper_rig *r, uint32_t id)
{
    double force[3];
    expect_ok(vbss_drain_get_reaction(r->drain, id, force));
    return vec3_load(force);
}

static inline vbss_drain_energies paper_energies(paper_rig *r)
{
    vbss_drain_energies energies;
    expect_ok(vbss_drain_get_energies(r->drain, &energies, sizeof energies));
    return energies;
}

static inline vbss_drain_statistics paper_statistics(paper_rig *r)
{
    vbss_drain_statistics statistics;
    expect_ok(vbss_drain_get_statistics(r->drain, &statistics, sizeof statistics));
    return statistics;
}

static inline vbss_drain_places paper_places(paper_rig *r)
{
    vbss_drain_places places;
    expect_ok(vbss_drain_get_places(r->drain, &places, sizeof places));
    return places;
}

static inline uint64_t paper_hash(paper_rig *r)
{
    uint64_t hash;
    expect_ok(vbss_drain_get_hash(r->drain, &hash));
    return hash;
}

#endif
