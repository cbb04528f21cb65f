/* Scripted runs of scenes with threads, drains and tools that the host drives. */
#include <string.h>

#include "base/error.h"
#include "contract/contract.h"
#include "fixtures/adaptive_scene.h"
#include "fixtures/scene_body.h"
#include "fixtures/solver_of.h"
#include "scene/cut_rig.h"
#include "scene/drains_rig.h"
#include "fixtures/scene_build.h"

static vbss_result destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

/* ---- a thread on two tools that is cut as time goes on */

enum { CUTS_AT = 12, LATER_CUT = 25 };

static vbss_result cut_add_tool(vbss_scene *scene, double x)
{
    const vbss_scene_capsule capsule = {{x, 0.0, -5e-3}, {x, 0.0, 5e-3}, 1e-3};
    vbss_scene_rigid_config config;
    VBSS_TRY(vbss_scene_rigid_config_init(&config, sizeof config));
    config.kind = x > 0.02 ? VBSS_SCENE_RIGID_FREE : VBSS_SCENE_RIGID_DRIVEN;
    return scene_build_capsule(scene, &config, capsule, NULL);
}

static vbss_result cut_create(vbss_context *context, void *user, void **handle)
{
    vbss_scene_config config;
    vbss_thread_config thread;
    vbss_scene *scene;
    uint32_t body, pin;
    VBSS_TRY(vbss_scene_config_init(&config, sizeof config));
    VBSS_TRY(vbss_thread_config_init(&thread, sizeof thread));
    config.method = thread.method = *(const vbss_method *)user;
    config.node_capacity = 60;
    thread.cut_capacity = 3;
    thread.segment_count = 30;
    thread.length = 0.03;
    thread.start[1] = 1.13e-3;
    VBSS_TRY(vbss_scene_create(context, &config, &scene));
    *handle = scene;
    VBSS_TRY(scene_build_thread(context, scene, &thread, NULL, &body));
    VBSS_TRY(cut_add_tool(scene, 0.008));
    VBSS_TRY(cut_add_tool(scene, 0.022));
    VBSS_TRY(vbss_scene_pin_thread(scene, body, 0, 0, NULL, &pin));
    return vbss_scene_pin_thread(scene, body, 29, 3, NULL, &pin);
}

static vbss_result cut_step(void *handle)
{
    vbss_scene_statistics statistics;
    uint32_t piece;
    VBSS_TRY(vbss_scene_get_statistics(handle, &statistics, sizeof statistics));
    if (statistics.steps == CUTS_AT) {
        VBSS_TRY(vbss_scene_cut_thread(handle, 1, 0.0152, &piece));
        VBSS_TRY(vbss_scene_cut_thread(handle, 1, 0.004, &piece));
    } else if (statistics.steps == LATER_CUT) {
        VBSS_TRY(vbss_scene_cut_thread(handle, 4, 0.0072, &piece));
    }
    return vbss_scene_step(handle, 1e-3);
}

/* Restored into scenes that were not cut, were cut elsewhere, and were cut more often. */
#define CUT_RUN(title, method)                                                                 \
    {                                                                                          \
        .name = (title),                                                                       \
        .body = {"scene that is cut",   &vbss_scene_kind, cut_create, NULL, cut_step, destroy, \
                 &(vbss_method){method}},                                                      \
        .saves = {5, 12, 13, 14, 20, 25, 26, 27, 40}, .save_count = 9, .continued = 30,        \
        .damages = {14}, .damage_count = 1, .quiet = 40                                        \
    }

/* ---- two adaptive strands come together and part again; one of them is cut */

static vbss_result adaptive_create(vbss_context *context, void *user, void **handle)
{
    return adaptive_scene_create(context, *(const vbss_thread_bending *)user,
                                 (vbss_scene **)handle);
}

static vbss_result adaptive_step(void *handle)
{
    return adaptive_scene_step(handle);
}

static void adaptive_refines_and_coarsens(const contract_run *run)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *scene = NULL;
    uint32_t largest = 0, smallest = 1000;
    expect_ok(run->body.create(context, run->body.user, &scene));
    for (int i = 0; i < 160; i++) {
        scene_object *s = NULL;
        expect_ok(run->body.step(scene));
        expect_ok(vbss_scene_open(scene, &s));
        cut_expect_sound(s);
        largest = s->node_count > largest ? s->node_count : largest;
        smallest = s->node_count < smallest ? s->node_count : smallest;
    }
    assert_true(largest > 90 && smallest <= 44);
    harness_context_end(context, &memory);
}

#define ADAPTIVE_RUN(title, bending, covered)                                       \
    {                                                                               \
        .name = (title),                                                            \
        .body = {"scene that adapts",                                               \
                 &vbss_scene_kind,                                                  \
                 adaptive_create,                                                   \
                 NULL,                                                              \
                 adaptive_step,                                                     \
                 destroy,                                                           \
                 &(vbss_thread_bending){bending}},                                  \
        .saves = {0, 3, 20, 45, 69, 70, 71, 110}, .save_count = 8, .continued = 30, \
        .damages = {30}, .damage_count = 1, .quiet = 120, .covers = (covered)       \
    }

/* ---- */

/* Other meshes, walls and glue; anchors tear while the tool is at work. */
static drain_hands hands_on(vbss_drain_mesh mesh, double tear_stress, double gravity,
                            vbss_scene_mode mode)
{
    drain_hands hands;
    expect_ok(drain_hands_init(&hands));
    hands.drain_config.mesh = mesh;
    hands.drain_config.tear_stress = tear_stress;
    hands.drain_config.gravity[1] = gravity;
    hands.config.mode = mode;
    return hands;
}

#define OTHER_DRAIN_RUN(title, hands)                    \
    {                                                    \
        .name = (title),                                 \
        .body = {"drain in a scene",                     \
                 &vbss_scene_kind,                       \
                 drains_body_create,                     \
                 NULL,                                   \
                 drains_body_step,                       \
                 drains_body_destroy,                    \
                 hands},                                 \
        .saves = {100}, .save_count = 1, .continued = 25 \
    }

int test_scene_runs(void)
{
    drain_hands usual, other[3];
    vbss_scene_config low_budget;
    scene_scene_kind knot = SCENE_SCENE_KNOT, tools = SCENE_SCENE_TOOLS;
    expect_ok(drain_hands_init(&usual));
    other[0] = hands_on(VBSS_DRAIN_MESH_159, 5e4, 0.0, VBSS_SCENE_MODE_REAL_TIME);
    other[1] = hands_on(VBSS_DRAIN_MESH_137, 2e3, -9.81, VBSS_SCENE_MODE_REAL_TIME);
    other[2] = hands_on(VBSS_DRAIN_MESH_137, 5e4, 0.0, VBSS_SCENE_MODE_OFFLINE);
    expect_ok(vbss_scene_config_init(&low_budget, sizeof low_budget));
    set_step_operations(&low_budget, 50000); /* one Newton iteration or two */
    const contract_run runs[] = {
        /* The knot is in contact from the first steps on, and tight at 290; the tools press from 20 on. */
        {.name = "knot",
         .body = scene_as_body(&knot),
         .saves = {1, 5, 12, 40, 270},
         .save_count = 5,
         .continued = 40,
         .damages = {12},
         .damage_count = 1,
         .quiet = 60,
         .repeated = 60},
        {.name = "tools",
         .body = scene_as_body(&tools),
         .saves = {1, 5, 12, 40},
         .save_count = 4,
         .continued = 30,
         .damages = {12},
         .damage_count = 1,
         .quiet = 60,
         .repeated = 60},
        /* The thread lies on the drain from 20 on; the tool touches at 8, is deep at 130, stirs, is up at 300. */
        {.name = "drain under a hand",
         .body = drains_as_body(&usual),
         .saves = {1, 12, 60, 150, 205, 320},
         .save_count = 6,
         .continued = 30,
         .damages = {70},
         .damage_count = 1,
         .quiet = 250},
        OTHER_DRAIN_RUN("drain of a finer mesh", &other[0]),
        OTHER_DRAIN_RUN("drain whose anchors tear", &other[1]),
        OTHER_DRAIN_RUN("drain in offline mode", &other[2]),
        /* Suspended, or not begun, while a hand holds the drain. */
        {.name = "drain at a low budget",
         .body = leap_as_body(&low_budget),
         .saves = {LEAP_AT - 1, LEAP_AT, LEAP_AT + 1, LEAP_AT + 2, LEAP_AT + 3, LEAP_AT + 4,
                   LEAP_AT + 5, LEAP_AT + 6, LEAP_AT + 7, LEAP_AT + 8, LEAP_AT + 9},
         .save_count = 11,
         .continued = 12},
        CUT_RUN("thread that is cut", VBSS_METHOD_IMPLICIT),
        CUT_RUN("thread that is cut, baseline", VBSS_METHOD_VBLAST),
        ADAPTIVE_RUN("adaptive threads", VBSS_THREAD_BENDING_SPLINE, adaptive_refines_and_coarsens),
        ADAPTIVE_RUN("adaptive threads, local bending", VBSS_THREAD_BENDING_LOCAL, NULL),
    };
    return contract_check_runs("contract.scene_runs", runs, sizeof runs / sizeof runs[0]);
}
