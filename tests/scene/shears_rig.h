/* What the tests of shears share: tools_rig with counts of cuts. Blades cut in the plane of their tip's y. */
#ifndef VBSS_TESTS_SCENE_SHEARS_RIG_H
#define VBSS_TESTS_SCENE_SHEARS_RIG_H

#include "base/elementary.h"
#include "scene/cut_rig.h"
#include "scene/tools_rig.h"
#include "fixtures/scene_build.h"

/* How far below a thread the tips of tools are that have it between their jaws, m. */
#define SHEARS_BELOW 5e-3
#define SHEARS_SEGMENT 0.5e-3

typedef struct shears_rig {
    tools_rig tools;
    /* Of all steps. */
    uint32_t cuts, failed_cuts, steps;
    vbss_scene_event first, last; /* cuts */
} shears_rig;

/* No scene yet: change tools.s.config and tools.s.thread, then small_create. */
static inline void shears_begin(shears_rig *r, vbss_method method)
{
    memset(r, 0, sizeof *r);
    tools_begin(&r->tools);
    r->tools.s.config.method = r->tools.s.thread.method = r->tools.config.method = method;
    r->tools.s.thread.cut_capacity = 3;
}

/* Method VBLAST with a soft thread: it takes a third of the explicit steps that the default takes. */
static inline void shears_begin_scene(shears_rig *r, vbss_method method)
{
    shears_begin(r, method);
    if (method == VBSS_METHOD_VBLAST) {
        r->tools.s.thread.bending_stiffness *= 0.1;
    }
    small_create(&r->tools.s);
}

static inline void shears_end(shears_rig *r)
{
    tools_end(&r->tools);
}

/* ---- what is in it */

/* Along y, from -15 mm to 15 mm; its ends are held, or nothing of it. */
static inline void shears_line(shears_rig *r, bool held)
{
    r->tools.body = small_thread(&r->tools.s, vec3_make(0.0, -0.015, 0.0),
                                 vec3_make(0.0, 0.015, 0.0), 60, &r->tools.thread);
    if (held) {
        small_pin_ends(&r->tools.s, r->tools.body, 61);
    }
}

/* As it lies: nodes at these places. */
static inline void shears_laid(shears_rig *r, const vec3 *nodes, uint32_t count)
{
    double rest[128];
    assert_true(count <= 128);
    for (uint32_t i = 0; i + 1 < count; i++) {
        rest[i] = vec3_distance(nodes[i], nodes[i + 1]);
    }
    r->tools.s.thread.segment_count = count - 1;
    r->tools.s.thread.bending = VBSS_THREAD_BENDING_LOCAL; /* whose segments are chords */
    r->tools.s.thread.bending_stiffness = 0.0;
    r->tools.s.thread.rest_lengths = rest;
    r->tools.s.thread.positions = &nodes->x;
    expect_ok(scene_build_thread(r->tools.s.context, r->tools.s.scene, &r->tools.s.thread,
                                 &r->tools.thread, &r->tools.body));
    r->tools.s.thread.positions = r->tools.s.thread.rest_lengths = NULL;
}

/* With open jaws that have a thread at y between them, turned about the shaft. */
static inline uint32_t shears_tool(shears_rig *r, vbss_grasper_kind kind, double y, double roll)
{
    const quat turn = quat_make(vbss_cos(0.5 * roll), 0.0, 0.0, vbss_sin(0.5 * roll));
    r->tools.config.kind = kind;
    return tools_add_turned(&r->tools, vec3_make(0.0, y, -SHEARS_BELOW), turn);
}

/* ---- what hands do */

static inline void shears_note(shears_rig *r)
{
    const step_events events = step_events_of(r->tools.s.scene);
    r->steps++;
    for (uint32_t i = 0; i < events.count; i++) {
        const vbss_scene_event *e = &events.of[i];
        if (e->kind == VBSS_SCENE_EVENT_CUT) {
            if (r->cuts + r->failed_cuts == 0) {
                r->first = *e;
            }
            r->last = *e;
            r->cuts += e->body_b != 0;
            r->failed_cuts += e->body_b == 0;
        }
    }
}

static inline void shears_steps(shears_rig *r, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        expect_ok(vbss_scene_step(r->tools.s.scene, 1e-3));
        shears_note(r);
    }
}

/* Closes the handle, until something is cut or the blades are shut; whether something was. */
static inline bool shears_cut(shears_rig *r, uint32_t tool)
{
    uint32_t before = r->cuts;
    tools_open(&r->tools, tool, 0.0);
    for (uint32_t i = 0; r->cuts == before && i < 100; i++) {
        shears_steps(r, 1);
    }
    return r->cuts > before;
}

/* ---- looks */

/* Of all threads, J. */
static inline double shears_kinetic(const small *s)
{
    const scene_object *o = small_object(s);
    double sum = 0.0;
    for (uint32_t i = 0; i < o->body_count; i++) {
        const thread_object *t = o->bodies[i].thread.thread;
        for (uint32_t k = 0; o->bodies[i].kind == SCENE_BODY_THREAD && k < t->node_count; k++) {
            sum += 0.5 * t->mass[k] * vec3_norm_squared(t->now.v[k]);
        }
    }
    return sum;
}

/* The blades have closed, and nothing went wrong on the way. */
static inline void shears_expect_shut(const shears_rig *r, uint32_t tool)
{
    vbss_scene_statistics statistics = small_statistics(&r->tools.s);
    expect_near(0.0, tools_state(&r->tools, tool).jaw_angle, 0.0);
    assert_int_equal(statistics.clamped, 0);
    if (r->tools.config.method == VBSS_METHOD_IMPLICIT) {
        assert_int_equal(statistics.loose_stretch, 0);
    }
    cut_expect_sound(small_object(&r->tools.s));
}

#endif
