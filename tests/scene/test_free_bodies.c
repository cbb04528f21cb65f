/* A body that touches nothing does not wait for an expensive island: in real time it misses at max_missed three calls,
 * however few operations a call has. */
#include "fixtures/solver_of.h"
#include "scene/pulled_surgeons.h"
#include "scene/small.h"

#define STEP 1e-3
enum { CALLS = 300, MAX_MISSED = 3 };

static uint32_t add_falling_ball(vbss_scene *scene)
{
    const vbss_scene_capsule ball = {{0.0, 0.0, 0.0}, {1e-3, 0.0, 0.0}, 1e-3};
    vbss_scene_rigid_config config;
    uint32_t number = 0;
    expect_ok(vbss_scene_rigid_config_init(&config, sizeof config));
    config.kind = VBSS_SCENE_RIGID_FREE;
    config.capsules = &ball;
    config.capsule_count = 1;
    config.position[1] = 5.0;
    config.velocity[1] = -0.1;
    expect_ok(vbss_scene_add_rigid(scene, &config, &number));
    return number;
}

static double height_of(vbss_scene *scene, uint32_t ball)
{
    vbss_scene_rigid_state state;
    expect_ok(vbss_scene_get_rigid(scene, ball, &state, sizeof state));
    return state.position[1];
}

/* The largest number of calls in a row in which the ball stands still while a knot is pulled tight beside it. */
static uint32_t missed_calls(uint32_t call_budget, uint32_t *overdue)
{
    vbss_context *context;
    contact_scene_options options;
    contact_scene s;
    vbss_scene_statistics statistics;
    pulled_surgeons_init(&options);
    set_call_operations(&options.scene, call_budget);
    expect_ok(vbss_context_create(NULL, &context));
    expect_ok(contact_scene_create(context, &options, &s));
    const uint32_t ball = add_falling_ball(s.scene);
    uint32_t missed = 0, max_missed = 0;
    double height = height_of(s.scene, ball);
    for (int i = 0; i < CALLS; i++) {
        expect_ok(contact_scene_step(&s, STEP));
        const double now = height_of(s.scene, ball);
        missed = now < height ? 0 : missed + 1;
        max_missed = missed > max_missed ? missed : max_missed;
        height = now;
    }
    expect_ok(vbss_scene_get_statistics(s.scene, &statistics, sizeof statistics));
    *overdue = statistics.overdue;
    expect_ok(contact_scene_destroy(&s));
    expect_ok(vbss_context_destroy(context));
    return max_missed;
}

static void free_body_misses_three_calls_or_fewer(void **state)
{
    (void)state;
    const uint32_t limits[] = {1000, 5000, 20000, 60000};
    for (int k = 0; k < 4; k++) {
        uint32_t overdue;
        const uint32_t missed = missed_calls(limits[k], &overdue);
        assert_in_range(missed, 1, MAX_MISSED);
        assert_true(overdue > CALLS / 10);
    }
}

int test_free_bodies(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_body_misses_three_calls_or_fewer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
