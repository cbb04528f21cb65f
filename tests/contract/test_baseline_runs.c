/* Scripted runs of scenes of the published method. */
#include <string.h>

#include "base/error.h"
#include "baseline/scene.h"
#include "contract/contract.h"
#include "contract/events.h"
#include "fixtures/paper_needle_scenes.h"
#include "scene/paper_drains.h"
#include "fixtures/scene_build.h"

static vbss_result destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

/* ---- a needle that two tools pass through a drain */

static vbss_result needle_create(vbss_context *context, void *user, void **handle)
{
    (void)user;
    return paper_needle_scene_create(context, (vbss_scene **)handle);
}

static vbss_result needle_step(void *handle)
{
    return paper_needle_scene_step(handle);
}

static const scene_object *object_of(vbss_scene *scene)
{
    scene_object *s = NULL;
    expect_ok(vbss_scene_open(scene, &s));
    return s;
}

static void check_needle_step(const scene_object *scene, int i, const event_counts *counts)
{
    const scene_body *needle_body = vbss_scene_body(scene, PAPER_NEEDLE_SCENE_NEEDLE);
    const scene_rigid *needle = &needle_body->rigid;
    const baseline_body *own = baseline_body_of(scene, needle_body);
    const uint32_t leader =
        i < PAPER_NEEDLE_SCENE_HANDED ? PAPER_NEEDLE_SCENE_FIRST : PAPER_NEEDLE_SCENE_SECOND;
    if (i == PAPER_NEEDLE_SCENE_TAKEN || i == PAPER_NEEDLE_SCENE_THROUGH ||
        i == PAPER_NEEDLE_SCENE_BOTH || i == PAPER_NEEDLE_SCENE_HANDED) {
        assert_int_equal(own->leader, leader);
    }
    assert_true(i != PAPER_NEEDLE_SCENE_THROUGH || counts->of[VBSS_SCENE_EVENT_PUNCTURE] == 2);
    assert_true(i != PAPER_NEEDLE_SCENE_PASSED || counts->of[VBSS_SCENE_EVENT_PASSED] == 2);
    const thread_object *t = vbss_scene_body(scene, PAPER_NEEDLE_SCENE_THREAD)->thread.thread;
    const vec3 swage =
        pose_apply(vbss_needle_pose(needle->needle),
                   vbss_needle_point(needle->needle, vbss_needle_length(needle->needle)));
    expect_near(0.0, vec3_distance(swage, t->now.x[0]), 1e-15);
    assert_true(t->statistics.last_stretch_error < 0.5);
}

static void check_needle_events(const event_counts *counts)
{
    static const uint32_t wanted[] = {[VBSS_SCENE_EVENT_GRASP] = 2,
                                      [VBSS_SCENE_EVENT_RELEASE] = 2,
                                      [VBSS_SCENE_EVENT_PUNCTURE] = 2,
                                      [VBSS_SCENE_EVENT_PASSED] = 2,
                                      [VBSS_SCENE_EVENT_HOLE_LOST] = 0};
    for (uint32_t k = VBSS_SCENE_EVENT_GRASP; k <= VBSS_SCENE_EVENT_HOLE_LOST; k++) {
        if (k != VBSS_SCENE_EVENT_CUT) {
            assert_int_equal(counts->of[k], wanted[k]);
        }
    }
}

static void needle_is_passed_and_dropped(const contract_run *run)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *scene = NULL;
    vbss_needle_state n;
    event_counts counts = {{0}};
    expect_ok(run->body.create(context, run->body.user, &scene));
    for (int i = 1; i <= PAPER_NEEDLE_SCENE_STEPS; i++) {
        expect_ok(run->body.step(scene));
        count_events(scene, &counts);
        check_needle_step(object_of(scene), i, &counts);
    }
    check_needle_events(&counts);
    const scene_object *s = object_of(scene);
    const scene_body *needle = vbss_scene_body(s, PAPER_NEEDLE_SCENE_NEEDLE);
    expect_ok(vbss_needle_get_state((vbss_needle *)needle->rigid.slot, &n, sizeof n));
    assert_int_equal(baseline_body_of(s, needle)->leader, 0);
    assert_true(fabs(n.velocity[1]) < 1e-3);
    expect_near(PAPER_NEEDLE_SCENE_FLOOR + 0.35e-3, n.tip[1], 1e-4);
    harness_context_end(context, &memory);
}

static void spoil_needle(void *handle, uint32_t which)
{
    scene_object *s = NULL;
    expect_ok(vbss_scene_open(handle, &s));
    baseline_body *needle = baseline_body_of(s, vbss_scene_body(s, PAPER_NEEDLE_SCENE_NEEDLE));
    scene_needle_grasp *hold = &vbss_scene_body(s, PAPER_NEEDLE_SCENE_FIRST)->rigid.needle_grasp;
    const uint32_t no_tools[] = {PAPER_NEEDLE_SCENE_DRAIN, PAPER_NEEDLE_SCENE_SECOND, 77};
    const baseline_toggle toggles[] = {{PAPER_NEEDLE_SCENE_THREAD, 0, false},
                                       {77, 0, false},
                                       {PAPER_NEEDLE_SCENE_DRAIN, 9999, false},
                                       {0, 3, false},
                                       {0, 0, true}};
    if (which < 3) {
        needle->leader = no_tools[which];
    } else if (which < 8) {
        needle->toggles[2] = toggles[which - 3];
    } else if (which == 8) {
        hold->angle = 0.1;
    } else if (which == 9) {
        hold->needle = PAPER_NEEDLE_SCENE_THREAD;
    } else if (which == 10) {
        hold->needle = 0; /* and yet it leads */
    } else if (which == 11) {
        hold->pose_in_jaws.position.x = 3.0;
    } else {
        s->holes[0].triangle = 9999;
    }
}

/* ---- contacts over 100 steps */

static void expect_contacts(const contract_run *run, uint64_t smallest)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *scene = NULL;
    uint64_t contacts = 0;
    expect_ok(run->body.create(context, run->body.user, &scene));
    for (int i = 0; i < 100; i++) {
        vbss_scene_statistics t;
        expect_ok(run->body.step(scene));
        expect_ok(vbss_scene_get_statistics(scene, &t, sizeof t));
        contacts += t.contacts;
    }
    assert_true(contacts > smallest);
    harness_context_end(context, &memory);
}

/* ---- two threads and a coupled tool on a floor */

static vbss_result heap_create(vbss_context *context, void *user, void **handle)
{
    (void)user;
    vbss_scene_config c;
    vbss_scene *scene = NULL;
    uint32_t body = 0, pin;
    VBSS_TRY(vbss_scene_config_init(&c, sizeof c));
    c.method = VBSS_METHOD_VBLAST;
    c.floor = 1;
    c.floor_height = -0.01;
    VBSS_TRY(vbss_scene_create(context, &c, &scene));
    *handle = scene;
    uint32_t tool = add_capsule(scene, VBSS_SCENE_RIGID_COUPLED, vec3_make(0, 0, -0.02),
                                vec3_make(0, 0, 0.02), 2e-3);
    for (int k = 0; k < 2; k++) {
        vbss_thread_config t = paper_thread(12);
        vec3_store(t.start, vec3_make(-0.02, 0.003 + 0.002 * k, 0.001 * k));
        vec3_store(t.direction, vec3_make(1.0, 0.0, 0.2 * k));
        t.length = 0.05;
        VBSS_TRY(scene_build_thread(context, scene, &t, NULL, &body));
    }
    return vbss_scene_pin_thread(scene, body, 12, tool, NULL, &pin);
}

static vbss_result heap_step(void *handle)
{
    vbss_scene_statistics t;
    VBSS_TRY(vbss_scene_get_statistics(handle, &t, sizeof t));
    double along = 1e-4 * (double)t.steps;
    const double to[3] = {along, 0.3 * along, 0.0}, turn[4] = {1.0, 0.0, 10.0 * along, 0.0};
    VBSS_TRY(vbss_scene_set_rigid_target(handle, 1, to, turn));
    return vbss_scene_step(handle, FRAME);
}

static void heap_touches(const contract_run *run)
{
    expect_contacts(run, 50);
}

/* ---- a tool goes in and out at the side of a drain, a thread lies across */

static vbss_result poked_add_drain(vbss_context *context, vbss_scene *scene)
{
    vbss_drain *drain;
    vbss_drain_attachment a;
    uint32_t id;
    vbss_drain_config d = paper_drain();
    d.gravity[1] = -9.81;
    VBSS_TRY(scene_build_drain(context, scene, &d, &drain, NULL));
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.node = 3;
    a.position[1] = 7e-3;
    return vbss_drain_attach(drain, &a, &id);
}

static vbss_result poked_create(vbss_context *context, void *user, void **handle)
{
    (void)user;
    vbss_scene_config c;
    vbss_scene *scene = NULL;
    VBSS_TRY(vbss_scene_config_init(&c, sizeof c));
    c.method = VBSS_METHOD_VBLAST;
    c.floor = 1;
    c.floor_height = -6.8e-3;
    VBSS_TRY(vbss_scene_create(context, &c, &scene));
    *handle = scene;
    (void)add_capsule(scene, VBSS_SCENE_RIGID_COUPLED, vec3_zero(), vec3_make(0, 0, 0.05), 2e-3);
    VBSS_TRY(poked_add_drain(context, scene));
    vbss_thread_config t = paper_thread(12);
    vec3_store(t.start, vec3_make(3e-3, 7.3e-3, -0.02));
    vec3_store(t.direction, vec3_make(0.0, 0.0, 1.0));
    t.length = 0.04;
    return scene_build_thread(context, scene, &t, NULL, NULL);
}

static vbss_result poked_step(void *handle)
{
    vbss_scene_statistics t;
    VBSS_TRY(vbss_scene_get_statistics(handle, &t, sizeof t));
    double along = 1e-4 * (double)(t.steps % 40);
    const double to[3] = {along, 0.2 * along, 0.0095 - along};
    VBSS_TRY(vbss_scene_set_rigid_target(handle, 1, to, NULL));
    return vbss_scene_step(handle, 1e-3);
}

static void poked_touches(const contract_run *run)
{
    expect_contacts(run, 200);
}

int test_baseline_runs(void)
{
    const contract_run runs[] = {
        /* 165: on its way through the wall. */
        {.name = "needle through a drain",
         .body = {"paper needle", &vbss_scene_kind, needle_create, NULL, needle_step, destroy,
                  NULL},
         .saves = {PAPER_NEEDLE_SCENE_TAKEN, 165, PAPER_NEEDLE_SCENE_THROUGH,
                   PAPER_NEEDLE_SCENE_BOTH, PAPER_NEEDLE_SCENE_HANDED, PAPER_NEEDLE_SCENE_PASSED},
         .save_count = 6,
         .continued = 60,
         .damages = {PAPER_NEEDLE_SCENE_BOTH},
         .damage_count = 1,
         .quiet = PAPER_NEEDLE_SCENE_STEPS,
         .covers = needle_is_passed_and_dropped,
         .spoil = spoil_needle,
         .spoil_count = 13,
         .spoil_at = PAPER_NEEDLE_SCENE_THROUGH},
        {.name = "heap",
         .body = {"paper scene", &vbss_scene_kind, heap_create, NULL, heap_step, destroy, NULL},
         .saves = {40},
         .save_count = 1,
         .continued = 40,
         .damages = {40},
         .damage_count = 1,
         .quiet = 60,
         .repeated = 100,
         .covers = heap_touches},
        {.name = "poked drain",
         .body = {"poked paper drain", &vbss_scene_kind, poked_create, NULL, poked_step, destroy,
                  NULL},
         .saves = {30},
         .save_count = 1,
         .continued = 40,
         .damages = {30},
         .damage_count = 1,
         .quiet = 60,
         .repeated = 100,
         .covers = poked_touches},
    };
    return contract_check_runs("contract.baseline_runs", runs, sizeof runs / sizeof runs[0]);
}
