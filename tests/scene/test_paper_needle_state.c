/* Saving, restoring and hashing of scenes with needles of method PAPER; what is refused; steps that allocate nothing. */
#include <stdlib.h>

#include "base/error.h"
#include "baseline/scene.h"
#include "scene/needles_rig.h"
#include "fixtures/paper_needle_scenes.h"

/* ---- as a body of the harness */

static vbss_result create(vbss_context *context, void *user, void **handle)
{
    vbss_scene *scene = NULL;
    (void)user;
    VBSS_TRY(paper_needle_scene_create(context, &scene));
    *handle = scene;
    return VBSS_OK;
}

static vbss_result step(void *handle)
{
    return paper_needle_scene_step(handle);
}

static vbss_result destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

static const harness_body body = {"paper needle", &vbss_scene_kind, create, NULL,
                                  step,           destroy,          NULL};

static void restored_scene_continues_bit_equal(void **state)
{
    (void)state;
    const size_t moments[] = {PAPER_NEEDLE_SCENE_TAKEN,   165, /* on its way through the wall */
                              PAPER_NEEDLE_SCENE_THROUGH, PAPER_NEEDLE_SCENE_BOTH,
                              PAPER_NEEDLE_SCENE_HANDED,  PAPER_NEEDLE_SCENE_PASSED};
    harness_save_restore_continue_at(&body, moments, sizeof moments / sizeof moments[0], 60);
}

static void steps_do_not_allocate(void **state)
{
    (void)state;
    assert_int_equal(harness_step_allocations(&body, PAPER_NEEDLE_SCENE_STEPS), 0);
}

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    harness_refuses_bad_snapshots(&body, PAPER_NEEDLE_SCENE_BOTH);
}

/* ---- the moments */

static void state_cases_cover_events(void **state)
{
    (void)state;
    static const uint32_t wanted[] = {[VBSS_EVENT_GRASP] = 2,
                                      [VBSS_EVENT_RELEASE] = 2,
                                      [VBSS_EVENT_PUNCTURE] = 2,
                                      [VBSS_EVENT_PASSED] = 2,
                                      [VBSS_EVENT_HOLE_LOST] = 0};
    small s;
    uint32_t event[4], count[VBSS_EVENT_HOLE_LOST + 1] = {0};
    small_begin(&s);
    expect_ok(paper_needle_scene_create(s.context, &s.scene));
    const scene_object *scene = small_object(&s);
    const scene_body *needle_body = vbss_scene_body(scene, PAPER_NEEDLE_SCENE_NEEDLE);
    const scene_rigid *needle = &needle_body->rigid;
    const baseline_body *own = baseline_body_of(scene, needle_body);
    for (int i = 1; i <= PAPER_NEEDLE_SCENE_STEPS; i++) {
        expect_ok(paper_needle_scene_step(s.scene));
        for (uint32_t k = VBSS_EVENT_GRASP; k <= VBSS_EVENT_HOLE_LOST; k++) {
            count[k] += small_events(&s, (vbss_event_kind)k, event);
        }
        uint32_t leader =
            i < PAPER_NEEDLE_SCENE_HANDED ? PAPER_NEEDLE_SCENE_FIRST : PAPER_NEEDLE_SCENE_SECOND;
        if (i == PAPER_NEEDLE_SCENE_TAKEN || i == PAPER_NEEDLE_SCENE_THROUGH ||
            i == PAPER_NEEDLE_SCENE_BOTH || i == PAPER_NEEDLE_SCENE_HANDED) {
            assert_int_equal(own->leader, leader);
        }
        assert_true(i != PAPER_NEEDLE_SCENE_THROUGH || count[VBSS_EVENT_PUNCTURE] == 2);
        assert_true(i != PAPER_NEEDLE_SCENE_PASSED || count[VBSS_EVENT_PASSED] == 2);
        const thread_object *t = vbss_scene_body(scene, PAPER_NEEDLE_SCENE_THREAD)->thread.thread;
        pose at = vbss_needle_pose(needle->needle);
        vec3 swage =
            pose_apply(at, vbss_needle_point(needle->needle, vbss_needle_length(needle->needle)));
        expect_near(0.0, vec3_distance(swage, t->now.x[0]), 1e-15);
        assert_true(t->statistics.last_stretch_error < 0.5);
    }
    for (uint32_t k = VBSS_EVENT_GRASP; k <= VBSS_EVENT_HOLE_LOST; k++) {
        if (k != VBSS_EVENT_CUT) {
            assert_int_equal(count[k], wanted[k]);
        }
    }
    vbss_needle_state n;
    expect_ok(vbss_needle_get_state((vbss_needle *)needle->slot, &n, sizeof n));
    assert_int_equal(own->leader, 0);
    assert_true(fabs(n.velocity[1]) < 1e-3);
    expect_near(PAPER_NEEDLE_SCENE_FLOOR + 0.35e-3, n.tip[1], 1e-4);
    small_end(&s);
}

/* ---- snapshots of what cannot be */

static void spoil(scene_object *s, int which)
{
    baseline_body *needle = baseline_body_of(s, vbss_scene_body(s, PAPER_NEEDLE_SCENE_NEEDLE));
    scene_needle_grasp *hold = &vbss_scene_body(s, PAPER_NEEDLE_SCENE_FIRST)->rigid.needle_grasp;
    const uint32_t nobodies[] = {PAPER_NEEDLE_SCENE_DRAIN, PAPER_NEEDLE_SCENE_SECOND, 77};
    const baseline_toggle toggles[] = {{PAPER_NEEDLE_SCENE_THREAD, 0, false},
                                       {77, 0, false},
                                       {PAPER_NEEDLE_SCENE_DRAIN, 9999, false},
                                       {0, 3, false},
                                       {0, 0, true}};
    if (which < 3) {
        needle->leader = nobodies[which];
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

static void impossible_state_is_rejected(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    expect_ok(paper_needle_scene_create(s.context, &s.scene));
    for (int i = 0; i < PAPER_NEEDLE_SCENE_THROUGH; i++) {
        expect_ok(paper_needle_scene_step(s.scene));
    }
    scene_object *scene = small_object(&s);
    small_state good = small_save(&s);
    uint64_t hash = small_hash(&s);
    for (int which = 0; which < 13; which++) {
        spoil(scene, which);
        small_state bad = small_save(&s);
        expect_ok(vbss_scene_restore(s.scene, good.bytes, good.count));
        expect_result(VBSS_ERROR_CORRUPT, vbss_scene_restore(s.scene, bad.bytes, bad.count));
        assert_true(small_hash(&s) == hash);
        free(bad.bytes);
    }
    free(good.bytes);
    small_end(&s);
}

/* ---- steps that fail */

/* Of a thread that is torn to pieces, while the needle is led: needle, tool and pins are as before. */
static void failed_step_changes_nothing(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    expect_ok(paper_needle_scene_create(s.context, &s.scene));
    for (int i = 0; i < 300; i++) {
        expect_ok(paper_needle_scene_step(s.scene));
    }
    thread_object *t = vbss_scene_body(small_object(&s), PAPER_NEEDLE_SCENE_THREAD)->thread.thread;
    small_state saved = small_save(&s);
    uint64_t before = small_hash(&s);
    vec3 own = t->now.v[5];
    t->now.v[5].x = 1e200;
    expect_result(VBSS_ERROR_NOT_FINITE, paper_needle_scene_step(s.scene));
    t->now.v[5] = own;
    const scene_rigid *needle =
        &vbss_scene_body(small_object(&s), PAPER_NEEDLE_SCENE_NEEDLE)->rigid;
    assert_memory_equal(&needle->body.target_end, &needle->body.target_start,
                        sizeof needle->body.target_end);
    expect_ok(paper_needle_scene_step(s.scene));
    uint64_t next = small_hash(&s);
    expect_ok(vbss_scene_restore(s.scene, saved.bytes, saved.count));
    assert_true(small_hash(&s) == before);
    expect_ok(paper_needle_scene_step(s.scene));
    assert_true(small_hash(&s) == next);
    free(saved.bytes);
    small_end(&s);
}

/* ---- what leaves */

static void removed_leader_releases_needle(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    expect_ok(paper_needle_scene_create(s.context, &s.scene));
    for (int i = 0; i < PAPER_NEEDLE_SCENE_BOTH; i++) {
        expect_ok(paper_needle_scene_step(s.scene));
    }
    const scene_object *scene = small_object(&s);
    const baseline_body *needle =
        baseline_body_of(scene, vbss_scene_body(scene, PAPER_NEEDLE_SCENE_NEEDLE));
    expect_ok(vbss_scene_remove(s.scene, PAPER_NEEDLE_SCENE_FIRST));
    assert_int_equal(needle->leader, 0);
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    assert_int_equal(needle->leader, PAPER_NEEDLE_SCENE_SECOND); /* who has waited */
    expect_ok(vbss_scene_remove(s.scene, PAPER_NEEDLE_SCENE_NEEDLE));
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    vbss_hole hole;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_get_hole(s.scene, 0, &hole, sizeof hole));
    small_end(&s);
}

int test_paper_needle_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(restored_scene_continues_bit_equal),
        cmocka_unit_test(steps_do_not_allocate),
        cmocka_unit_test(bad_snapshots_are_rejected),
        cmocka_unit_test(state_cases_cover_events),
        cmocka_unit_test(impossible_state_is_rejected),
        cmocka_unit_test(failed_step_changes_nothing),
        cmocka_unit_test(removed_leader_releases_needle),
    };
    return cmocka_run_group_tests_name("scene.paper_needle_state", tests, NULL, NULL);
}
