/* Needles of method VBLAST: a step that fails changes nothing, and a leader that is removed releases its needle. */
#include <stdlib.h>

#include "baseline/scene.h"
#include "scene/needles_rig.h"
#include "fixtures/paper_needle_scenes.h"

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
    vbss_scene_hole hole;
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_get_hole(s.scene, 0, &hole, sizeof hole));
    small_end(&s);
}

int test_paper_needle_rollback(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(failed_step_changes_nothing),
        cmocka_unit_test(removed_leader_releases_needle),
    };
    return cmocka_run_group_tests_name("scene.paper_needle_rollback", tests, NULL, NULL);
}
