/* Method VBLAST, explicit steps that diverge: the call fails before a segment is longer than a hundred times the thread. */
#include <math.h>
#include <string.h>

#include "fixtures/baseline_of.h"
#include "thread/paper_rig.h"

enum { SEGMENTS = 30, STEPS = 3000 };

static double longest_segment(rig *r)
{
    double longest = 0.0;
    for (uint32_t i = 0; i + 1 < r->nodes; i++) {
        double length = vec3_distance(rig_position(r, i + 1), rig_position(r, i));
        assert_true(isfinite(length));
        longest = vbss_max(longest, length);
    }
    return longest;
}

static void expect_text(rig *r, const char *wanted)
{
    vbss_result result;
    const char *text;
    expect_ok(vbss_context_get_last_error(r->context, &result, &text));
    assert_int_equal(result, VBSS_ERROR_NOT_FINITE);
    assert_non_null(strstr(text, wanted));
}

/* Both ends are drawn 10 mm farther apart than the thread is long, within so many steps. Returns the step that fails, or
 * STEPS if none does. */
static uint32_t draw_apart(rig *r, uint32_t over)
{
    rig_pin_here(r, 0);
    uint32_t pin = rig_pin_here(r, SEGMENTS);
    for (uint32_t i = 0; i < STEPS; i++) {
        uint64_t before, after;
        double share = i < over ? (i + 1.0) / over : 1.0;
        rig_move(r, pin, vec3_make(0.15 + 0.01 * share, 0.0, 0.0));
        expect_ok(vbss_thread_get_hash(r->thread, &before));
        vbss_result result = vbss_thread_step(r->thread, 1e-3);
        if (result != VBSS_OK) {
            expect_ok(vbss_thread_get_hash(r->thread, &after));
            assert_int_equal(before, after);
            return i;
        }
        assert_true(longest_segment(r) <= 100.0 * (0.15 + 0.16));
    }
    return STEPS;
}

static void divergence_is_reported_and_undone(void **state)
{
    (void)state;
    const double stiffness[] = {1.0, 1e2, 1e4, 1e6};
    const uint32_t substeps[] = {1, 4, 16};
    for (int k = 0; k < 12; k++) {
        rig r;
        vbss_thread_config config = paper(SEGMENTS);
        double k_spring = stiffness[k % 4];
        uint32_t n = substeps[k / 4];
        baseline_of(&config.baseline)->thread_stiffness = k_spring;
        baseline_of(&config.baseline)->thread_substeps = n;
        rig_begin(&r, &config);
        /* Springs are stable below mass / dt^2: 0.32 N/m in 1 ms, 82 N/m in a sixteenth of it. */
        double limit = 0.32 * n * n;
        uint32_t failed = draw_apart(&r, 100);
        if (k_spring > limit) {
            assert_in_range(failed, 0, STEPS - 1);
            expect_text(&r, "the explicit method has diverged: ");
        } else {
            assert_int_equal(failed, STEPS);
        }
        rig_end(&r);
    }
}

/* The chosen springs and substeps stand both ends drawn beyond the thread's length, also within one step. */
static void chosen_steps_stay_within_bound(void **state)
{
    (void)state;
    for (uint32_t over = 1; over <= 100; over *= 10) {
        rig r;
        vbss_thread_config config = paper(SEGMENTS);
        rig_begin(&r, &config);
        assert_int_equal(draw_apart(&r, over), STEPS);
        rig_end(&r);
    }
}

/* The bound is relative: a thread may be anywhere, fly at any speed, and follow a hand that jumps. */
static void motion_of_whole_thread_is_no_divergence(void **state)
{
    (void)state;
    rig r;
    vec3 x[SEGMENTS + 1], v[SEGMENTS + 1];
    vbss_thread_config config = paper(SEGMENTS);
    rig_begin(&r, &config);
    for (uint32_t i = 0; i <= SEGMENTS; i++) {
        x[i] = vec3_make(900.0 + 0.005 * i, 0.0, 0.0);
        v[i] = vec3_make(0.0, 1e4, 0.0);
    }
    rig_place(&r, x, v);
    rig_run(&r, 1e-3, 1000);
    assert_true(rig_position(&r, 0).y > 9e3);
    rig_end(&r);
    rig_begin(&r, &config);
    uint32_t pin = rig_pin_here(&r, 0);
    rig_move(&r, pin, vec3_make(0.0, 30.0, 0.0));
    expect_ok(vbss_thread_step(r.thread, 1e-3));
    rig_end(&r);
}

int test_paper_divergence(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(divergence_is_reported_and_undone),
        harness_test(chosen_steps_stay_within_bound),
        harness_test(motion_of_whole_thread_is_no_divergence),
    };
    return cmocka_run_group_tests_name("thread.paper_divergence", tests, NULL, NULL);
}
