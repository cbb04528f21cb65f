/* The hands of a scripted surgeon's log, at one, two and five times their speed: what they do at another speed is not what they
 * meant, but nothing passes through anything and no node is thrown. */
#include <stdlib.h>

#include "hands/stage.h"
#include "scene/hand_run.h"

enum { AFTER = 300 }; /* steps of 1 ms */

static void play(const uint8_t *log, uint64_t bytes, double speed)
{
    static hand_run r;
    vbss_context *context;
    vbss_scene *scene;
    expect_ok(stage_create(&context, &scene));
    hand_run_begin_log(&r, context, scene, log, bytes);
    hand_run_start(&r, speed);
    hand_run_steps(&r, hand_run_length(&r, speed) + AFTER);
    hand_run_print(&r, "logged hands", speed);
    hand_run_expect_kept(&r);
    assert_true(r.grasps > 0);
    hand_run_end(&r);
    stage_destroy();
}

static void logged_hands_pass_nothing(void **state)
{
    (void)state;
    uint64_t bytes;
    uint8_t *log = stage_read_log(VBSS_NEEDLE_LOG, &bytes);
    assert_non_null(log);
    play(log, bytes, 1.0);
    play(log, bytes, 2.0);
    play(log, bytes, 5.0);
    free(log);
}

int test_logged_hands(void)
{
    const struct CMUnitTest tests[] = {harness_test(logged_hands_pass_nothing)};
    return cmocka_run_group_tests_name("hands.logged_hands", tests, NULL, NULL);
}
