/* Saving, restoring and hashing of scenes with needles in jaws; steps that fail, and allocate nothing. */
#include <stdlib.h>

#include "base/error.h"
#include "scene/needles_rig.h"
#include "scene/api/api.h"
#include "scene/tools/tools.h"
#include "scene/world/world.h"
#include "fixtures/needle_scenes.h"

/* ---- as a body of the harness */

static vbss_result create(vbss_context *context, void *user, void **handle)
{
    vbss_scene *scene = NULL;
    (void)user;
    VBSS_TRY(needle_scene_create(context, &scene));
    *handle = scene;
    return VBSS_OK;
}

static vbss_result step(void *handle)
{
    return needle_scene_step(handle);
}

static vbss_result destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

static const harness_body body = {"needle", &vbss_scene_kind, create, NULL, step, destroy, NULL};

static const size_t moments[] = {NEEDLE_SCENE_LYING, NEEDLE_SCENE_TAKEN,  NEEDLE_SCENE_LIFTED,
                                 NEEDLE_SCENE_BOTH,  NEEDLE_SCENE_HANDED, NEEDLE_SCENE_DROPPED};
enum { MOMENTS = sizeof moments / sizeof moments[0] };

static void restored_scene_continues_bit_equal(void **state)
{
    (void)state;
    harness_save_restore_continue_at(&body, moments, MOMENTS, 60);
    harness_save_restore_continue(&body, 300, 10);  /* it is taken, */
    harness_save_restore_continue(&body, 320, 60);  /* settles in the jaws, */
    harness_save_restore_continue(&body, 1099, 20); /* is let go */
}

static void steps_do_not_allocate(void **state)
{
    (void)state;
    assert_int_equal(harness_step_allocations(&body, NEEDLE_SCENE_STEPS), 0);
}

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    harness_refuses_bad_snapshots(&body, NEEDLE_SCENE_BOTH);
}

static void spoil(scene_needle_grasp *hold, int which)
{
    double *numbers[] = {&hold->age,   &hold->slid,    &hold->turned,
                         &hold->limit, &hold->force.x, &hold->torque.z};
    const uint32_t nobodies[] = {NEEDLE_SCENE_THREAD, NEEDLE_SCENE_SECOND, 77};
    if (which < 3) {
        hold->needle = nobodies[which];
    } else if (which < 9) {
        *numbers[which - 3] = DBL_MAX * 10.0;
    } else if (which == 9) {
        hold->arc = -1e-3;
    } else if (which == 10) {
        hold->arc = 0.04;
    } else if (which == 11) {
        hold->angle = 0.0;
    } else if (which == 12) {
        hold->pose_in_jaws.position.y = 3.0;
    } else {
        hold->pose_in_jaws.orientation.w += 0.1;
    }
}

/* What the harness would not guess: sealed snapshots of holds that cannot be. */
static void impossible_grasp_is_rejected(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    expect_ok(needle_scene_create(s.context, &s.scene));
    for (int i = 0; i < NEEDLE_SCENE_BOTH; i++) {
        expect_ok(needle_scene_step(s.scene));
    }
    scene_needle_grasp *hold =
        &vbss_scene_body(small_object(&s), NEEDLE_SCENE_FIRST)->rigid.needle_grasp;
    uint64_t hash = small_hash(&s);
    for (int which = 0; which < 14; which++) {
        const scene_needle_grasp own = *hold;
        spoil(hold, which);
        small_state bad = small_save(&s);
        *hold = own;
        expect_result(VBSS_ERROR_CORRUPT, vbss_scene_restore(s.scene, bad.bytes, bad.count));
        assert_true(small_hash(&s) == hash);
        free(bad.bytes);
    }
    small_end(&s);
}

/* Jaws of the greatest length hold it by their ends, more than a metre from the pivot. */
static void long_jaws_are_restored(void **state)
{
    (void)state;
    needles_rig r;
    needles_begin_scene(&r);
    r.tools.config.driver_length = 1.0;
    r.tools.config.driver_radius = 2e-3;
    r.tools.config.driver_opening = 0.02;
    needles_add_across(&r, 0.5 * r.config.arc * r.config.radius, vec3_make(1e-3, 0.0, 0.0));
    tools_add(&r.tools, vec3_make(0.0, 0.0, -1e-7));
    tools_open(&r.tools, 0, 0.0);
    for (int i = 0; i < 50 && tools_state(&r.tools, 0).grasp_count == 0; i++) {
        tools_steps(&r.tools, 1);
    }
    assert_int_equal(tools_state(&r.tools, 0).grasp_count, 1);
    uint64_t hash = small_hash(&r.tools.s);
    small_state saved = small_save(&r.tools.s);
    tools_steps(&r.tools, 5);
    expect_ok(vbss_scene_restore(r.tools.s.scene, saved.bytes, saved.count));
    assert_true(small_hash(&r.tools.s) == hash);
    free(saved.bytes);
    needles_end(&r);
}

/* ---- the moments */

typedef struct look {
    bool first, second; /* hold it */
    vbss_needle_state needle;
    double fastest; /* part of the needle, m/s */
} look;

static look look_at(const small *s)
{
    look l;
    const scene_object *scene = small_object(s);
    const scene_rigid *r = &vbss_scene_body(scene, NEEDLE_SCENE_NEEDLE)->rigid;
    l.first = vbss_scene_has_needle_grasp(scene, NEEDLE_SCENE_FIRST);
    l.second = vbss_scene_has_needle_grasp(scene, NEEDLE_SCENE_SECOND);
    expect_ok(vbss_needle_get_state((vbss_needle *)r->slot, &l.needle, sizeof l.needle));
    l.fastest = vec3_norm(r->body.now.v) + 0.03 * vec3_norm(r->body.now.w);
    return l;
}

/* What happens there must be what the names say, or the tests above show little. */
static void state_cases_cover_events(void **state)
{
    (void)state;
    static const bool first[MOMENTS] = {false, true, true, true, false, false};
    static const bool second[MOMENTS] = {false, false, false, true, true, false};
    const double wire = 0.35e-3, up = wire + NEEDLE_SCENE_LIFT;
    const double heights[MOMENTS] = {wire, wire, up, up, up, wire}; /* of tip and swage */
    small s;
    size_t next = 0;
    look lying = {0}, here;
    uint32_t event[4], count[VBSS_EVENT_SLIP + 1] = {0};
    small_begin(&s);
    expect_ok(needle_scene_create(s.context, &s.scene));
    for (size_t i = 0; i < NEEDLE_SCENE_STEPS; i++) {
        if (next < MOMENTS && i == moments[next]) {
            here = look_at(&s);
            lying = next == 0 ? here : lying;
            assert_int_equal(here.first, first[next]);
            assert_int_equal(here.second, second[next]);
            assert_true(here.fastest < (moments[next] == NEEDLE_SCENE_HANDED ? 1e-2 : 1e-5));
            expect_near(heights[next], here.needle.tip[2], 1e-4);
            expect_near(heights[next], here.needle.swage[2], 1e-4);
            next++;
        }
        expect_ok(needle_scene_step(s.scene));
        for (uint32_t k = VBSS_EVENT_GRASP; k <= VBSS_EVENT_SLIP; k++) {
            count[k] += small_events(&s, (vbss_event_kind)k, event);
        }
    }
    assert_int_equal(next, MOMENTS);
    assert_int_equal(count[VBSS_EVENT_GRASP], 2);
    assert_int_equal(count[VBSS_EVENT_RELEASE], 2);
    assert_int_equal(count[VBSS_EVENT_TORN], 0);
    vec3 carried = vec3_sub(vec3_load(here.needle.position), vec3_load(lying.needle.position));
    assert_true(vec3_norm(carried) > 0.5 * NEEDLE_SCENE_CARRY);
    assert_int_equal(small_statistics(&s).clamped, 0);
    assert_int_equal(small_statistics(&s).paused, 0);
    small_end(&s);
}

static void runs_are_bit_equal(void **state)
{
    (void)state;
    uint64_t hashes[2][NEEDLE_SCENE_STEPS / 100];
    for (int run = 0; run < 2; run++) {
        small s;
        small_begin(&s);
        expect_ok(needle_scene_create(s.context, &s.scene));
        for (int i = 0; i < NEEDLE_SCENE_STEPS; i++) {
            expect_ok(needle_scene_step(s.scene));
            if (i % 100 == 99) {
                hashes[run][i / 100] = small_hash(&s);
            }
        }
        small_end(&s);
    }
    assert_memory_equal(hashes[0], hashes[1], sizeof hashes[0]);
}

/* ---- steps that fail */

typedef struct shown {
    uint64_t hash;
    vbss_needle_state needle;
    vbss_grasper_state tool;
    vbss_grasp grasp;
    vec3 points[9];
    scene_needle_grasp hold;
    bool has_grasp;
} shown;

static void show(const needles_rig *r, shown *l)
{
    vbss_view view;
    memset(l, 0, sizeof *l);
    l->hash = small_hash(&r->tools.s);
    l->needle = needles_state(r);
    l->tool = tools_state(&r->tools, 0);
    expect_ok(vbss_needle_get_view(r->needle, VBSS_NEEDLE_VIEW_POINTS, &view, sizeof view));
    assert_int_equal(view.count, 9);
    memcpy(l->points, view.data, sizeof l->points);
    memcpy(&l->hold,
           &vbss_scene_body(small_object(&r->tools.s), r->tools.bodies[0])->rigid.needle_grasp,
           sizeof l->hold);
    l->has_grasp = vbss_scene_get_grasp(r->tools.s.scene, r->tools.bodies[0], 0, &l->grasp,
                                        sizeof l->grasp) == VBSS_OK;
}

enum { BALLS = 24 };

/* Balls along the arc, below the needle. */
static uint32_t add_brush(needles_rig *r)
{
    vbss_capsule balls[BALLS];
    uint32_t body_of_balls = 0;
    double length = r->config.arc * r->config.radius;
    for (int i = 0; i < BALLS; i++) {
        vec3 at = needles_place(r, length * (i + 0.5) / BALLS, NULL);
        balls[i].radius = 0.3e-3;
        vec3_store(balls[i].begin, at);
        vec3_store(balls[i].end, at);
    }
    r->tools.s.rigid.kind = VBSS_RIGID_DRIVEN;
    r->tools.s.rigid.capsules = balls;
    r->tools.s.rigid.capsule_count = BALLS;
    vec3_store(r->tools.s.rigid.position, vec3_make(0.0, 0.0, -5e-3));
    expect_ok(vbss_scene_add_rigid(r->tools.s.scene, &r->tools.s.rigid, &body_of_balls));
    return body_of_balls;
}

/* In every step the balls are told first to go where all of them all but touch the needle: there is no room for that. What
 * is told of the tool is done when they stay. */
static void expect_nothing_changed(uint32_t contacts, uint32_t candidates)
{
    needles_rig r;
    uint32_t holding = 0, taken = 0, let_go = 0, event[4];
    needles_begin(&r);
    r.tools.s.config.contact_capacity = contacts;
    r.tools.s.config.candidate_capacity = candidates;
    r.tools.s.config.capsule_capacity = 64;
    r.tools.s.config.work_limit = 0;
    small_create(&r.tools.s);
    needles_add_across(&r, 0.5 * r.config.arc * r.config.radius, vec3_zero());
    tools_add(&r.tools, vec3_make(0.0, 0.0, -2e-3));
    uint32_t brush = add_brush(&r);
    for (uint32_t i = 0; i < 200; i++) {
        shown before, after;
        tools_open(&r.tools, 0, i < 120 ? 0.0 : 1.0);
        tools_move(&r.tools, 0, vec3_make(1e-6 * i, 0.0, -2e-3));
        small_move(&r.tools.s, brush, vec3_make(0.0, 0.0, -0.66e-3));
        show(&r, &before);
        expect_result(VBSS_ERROR_CAPACITY, vbss_scene_step(r.tools.s.scene, 1e-3));
        show(&r, &after);
        assert_memory_equal(&before, &after, sizeof before);
        small_move(&r.tools.s, brush, vec3_make(0.0, 0.0, -5e-3));
        tools_steps(&r.tools, 1);
        taken += tools_happened(&r.tools, VBSS_EVENT_GRASP, event);
        let_go += tools_happened(&r.tools, VBSS_EVENT_RELEASE, event);
        holding += before.has_grasp;
    }
    assert_int_equal(taken, 1);
    assert_int_equal(let_go, 1);
    assert_true(holding > 50);
    needles_end(&r);
}

static void failed_step_changes_nothing(void **state)
{
    (void)state;
    expect_nothing_changed(16, 4096);
    expect_nothing_changed(256, 16);
}

int test_needle_state(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(state_cases_cover_events),
        harness_test(runs_are_bit_equal),
        harness_test(restored_scene_continues_bit_equal),
        harness_test(steps_do_not_allocate),
        harness_test(bad_snapshots_are_rejected),
        harness_test(impossible_grasp_is_rejected),
        harness_test(long_jaws_are_restored),
        harness_test(failed_step_changes_nothing),
    };
    return cmocka_run_group_tests_name("scene.needle_state", tests, NULL, NULL);
}
