/* The last resort: what a step that is cut short leaves behind. */
#include <stdlib.h>

#include "base/elementary.h"
#include "base/rotation.h"
#include "fixtures/solver_of.h"
#include "scene/small_watch.h"

static const vec3 half = {0.0, 0.0, 5e-3};

/* One attempt and no halves: what is not accepted at once is cut short at once. */
static void begin_hasty(small *s)
{
    small_begin(s);
    solver_of(&s->config)->halving_limit = 0;
    solver_of(&s->config)->attempt_limit = 1;
    small_create(s);
}

static double share_lost(const small *s)
{
    return step_events_lost_time(s->scene) / 1e-3;
}

/* Two sticks that are driven into each other stop before they meet. Bodies of other islands go on. */
static void only_the_island_that_collides_is_truncated(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    begin_hasty(&s);
    small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
    uint32_t meets = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 6e-3, 0.0),
                                 vec3_make(5e-3, 0.0, 0.0), 1e-3);
    uint32_t other = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.1, 0.0, 0.0), half, 1e-3);
    s.rigid.velocity[2] = 1.0;
    uint32_t free = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.2, 0.0, 0.0), half, 1e-3);
    small_thread(&s, vec3_make(0.3, 0.0, 0.0), vec3_make(0.31, 0.0, 0.0), 10, &thread);
    double v[33] = {0.0};
    for (int i = 0; i < 11; i++) {
        v[3 * i + 1] = 2.0;
    }
    expect_ok(vbss_thread_set_state(thread, NULL, v, 11));
    small_move(&s, meets, vec3_make(0.0, -6e-3, 0.0));
    small_move(&s, other, vec3_make(0.1, 8e-3, 0.0));
    small_steps(&s, 1, 1e-3);
    assert_int_equal(small_statistics(&s).clamped, 1);
    double share = 1.0 - share_lost(&s);
    assert_true(share > 0.3 && share < 0.42); /* 5 of 12 mm, of that nine tenths */
    expect_near(6e-3 - 12e-3 * share, small_position(&s, meets).y, 1e-6);
    expect_near(8e-3, small_position(&s, other).y, 1e-16);
    expect_near(1e-3, small_position(&s, free).z, 1e-7);
    expect_near(1.0, small_rigid(&s, free).velocity[2], 1e-6);
    expect_near(2e-3, small_node(thread, 5).y, 1e-7);
    vbss_view velocities;
    expect_ok(
        vbss_thread_get_view(thread, VBSS_THREAD_VIEW_VELOCITIES, &velocities, sizeof velocities));
    expect_near(2.0, ((const double *)velocities.data)[16], 1e-4);
    /* The next step is a whole one. */
    expect_near(1e-3, small_statistics(&s).time, 0.0);
    small_move(&s, meets, vec3_make(0.0, 6e-3, 0.0));
    small_steps(&s, 1, 1e-3);
    expect_near(6e-3, small_position(&s, meets).y, 1e-16);
    assert_int_equal(small_statistics(&s).clamped, 1);
    small_end(&s);
}

/* A thread that a stick drags along belongs to its island: both stop at the same fraction. */
static void an_island_is_truncated_as_a_whole(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    begin_hasty(&s);
    small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
    uint32_t meets = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 6e-3, 0.0),
                                 vec3_make(5e-3, 0.0, 0.0), 1e-3);
    vec3 end = vec3_make(5e-3, 6e-3, 0.0);
    uint32_t line = small_thread(&s, end, vec3_add(end, vec3_make(0.01, 0.0, 0.0)), 10, &thread);
    small_pin(&s, line, 0, meets);
    double v[33] = {0.0};
    for (int i = 0; i < 11; i++) {
        v[3 * i + 1] = -12.0;
    }
    expect_ok(vbss_thread_set_state(thread, NULL, v, 11));
    small_move(&s, meets, vec3_make(0.0, -6e-3, 0.0));
    small_steps(&s, 1, 1e-3);
    assert_int_equal(small_statistics(&s).clamped, 1);
    double share = 1.0 - share_lost(&s);
    expect_near(6e-3 - 12e-3 * share, small_position(&s, meets).y, 1e-6);
    expect_near(6e-3 - 12e-3 * share, small_node(thread, 10).y, 1e-5);
    small_end(&s);
}

/* What is pinned to a body that is held back is held back with it; from there it goes on. */
static void pins_lag_with_their_bodies(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    small_begin_scene(&s);
    small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
    uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 4e-3, 0.0),
                                vec3_make(5e-3, 0.0, 0.0), 1e-3);
    vec3 held = vec3_make(5e-3, 5e-3, 0.0);
    uint32_t line = small_thread(&s, held, vec3_add(held, vec3_make(0.01, 0.0, 0.0)), 10, &thread);
    small_pin(&s, line, 0, tool);
    for (int i = 0; i < 40; i++) {
        double y = i < 20 ? -4e-3 : 4e-3 + 1e-4 * (i - 20); /* through, and back */
        small_move(&s, tool, vec3_make(0.0, y, 0.0));
        small_steps(&s, 1, 1e-3);
        vec3 point = vec3_add(small_position(&s, tool), vec3_make(5e-3, 1e-3, 0.0));
        expect_near(0.0, vec3_distance(point, small_node(thread, 0)), 1e-12);
        assert_true(i >= 20 || small_position(&s, tool).y > 0.0);
        assert_true(small_tension(thread, 0) < 5.0); /* nothing is torn */
    }
    assert_true(small_statistics(&s).clamped > 0);
    small_end(&s);
}

/* An end of a thread jumps aside, and one linearisation does not find the lengths. Truncation takes no state whose
 * tensions are beyond the stretch tolerance. */
static void truncation_adds_no_tension(void **state)
{
    (void)state;
    uint32_t truncated = 0;
    for (int k = 1; k <= 24; k++) {
        small s;
        vbss_thread *thread;
        small_begin(&s);
        solver_of(&s.config)->halving_limit = 0;
        solver_of(&s.config)->iteration_limit = 1;
        small_create(&s);
        uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
        vec3 end = vec3_make(1e-3, 0.0, 0.0);
        uint32_t line =
            small_thread(&s, end, vec3_add(end, vec3_make(0.01, 0.0, 0.0)), 10, &thread);
        small_pin(&s, line, 0, tool);
        small_move(&s, tool, vec3_make(0.0, 5e-5 * k, 0.0));
        small_steps(&s, 1, 1e-3);
        double largest =
            s.thread.axial_stiffness * solver_values(&s.config).stretch_tolerance * (1.0 + 1e-9);
        assert_true(largest > 0.1 && largest < 1.0);
        truncated += small_statistics(&s).clamped > 0;
        for (uint32_t i = 0; i < 10; i++) {
            assert_true(small_tension(thread, i) <= largest);
        }
        small_end(&s);
    }
    assert_true(truncated > 0);
}

static void offline_mode_retries_before_truncation(void **state)
{
    (void)state;
    uint64_t attempts[2], clamped[2];
    for (int m = 0; m < 2; m++) {
        small s;
        small_begin(&s);
        s.config.mode = m == 0 ? VBSS_SCENE_MODE_REAL_TIME : VBSS_SCENE_MODE_OFFLINE;
        solver_of(&s.config)->attempt_limit = 3;
        set_step_operations(&s.config, 0);
        small_create(&s);
        uint32_t line =
            small_thread(&s, vec3_make(-6e-3, 0.0, 0.0), vec3_make(6e-3, 0.0, 0.0), 12, NULL);
        small_pin_ends(&s, line, 13);
        uint32_t tool =
            small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(1e-4, 2e-3, 0.0), half, 1e-3);
        small_move(&s, tool, vec3_make(1e-4, -1e-3, 0.0)); /* within what the thread can give */
        small_steps(&s, 1, 1e-3);
        attempts[m] = small_statistics(&s).attempts;
        clamped[m] = small_statistics(&s).clamped;
        small_end(&s);
    }
    assert_true(attempts[0] <= 3 + 32);
    assert_true(attempts[1] > attempts[0]);
    assert_true(clamped[0] > 0);
}

/* ---- whatever a host does */

static bool all_finite(const small *s)
{
    small_state state = small_save(s);
    /* Reading refuses what is not finite. */
    bool finite = vbss_scene_restore(s->scene, state.bytes, state.count) == VBSS_OK;
    free(state.bytes);
    return finite;
}

static vec3 draw_near(harness_source *source)
{
    return harness_draw_vec3(source, -6e-3, 6e-3);
}

static void shake(small *s, harness_source *source, vbss_thread *thread, uint32_t tool)
{
    double x[3 * 17], v[3 * 17];
    double speed = vbss_exp(harness_draw_real(source, -3.0, 11.0));
    for (uint32_t i = 0; i < 17; i++) {
        vec3 at = vec3_add(small_node(thread, i), harness_draw_vec3(source, -1e-4, 1e-4));
        vec3_store(x + 3 * (size_t)i, at);
        vec3_store(v + 3 * (size_t)i, harness_draw_vec3(source, -speed, speed));
    }
    switch (harness_draw_below(source, 4)) {
    case 0:
        expect_ok(vbss_thread_set_state(thread, NULL, v, 17));
        break;
    case 1:
        expect_ok(vbss_thread_set_state(thread, x, NULL, 17));
        break;
    default: {
        double p[3];
        /* Not by so much at once that straight ways of its ends are no turn. */
        quat q = vbss_quat_from_rotation_vector(harness_draw_vec3(source, -0.3, 0.3));
        const double turned[4] = {q.w, q.x, q.y, q.z};
        vec3_store(p, draw_near(source));
        expect_ok(vbss_scene_set_rigid_target(s->scene, tool, p, turned));
    }
    }
}

/* Steps end, in numbers, and nothing passes. */
static void wild_scenes_end_in_numbers(harness_source *source, void *user)
{
    (void)user;
    small s;
    small_watch w;
    vbss_thread *thread;
    small_begin(&s);
    s.config.floor = (int32_t)harness_draw_below(source, 2);
    s.config.floor_height = -5e-3;
    s.config.mode = (vbss_scene_mode)harness_draw_below(source, 2);
    solver_of(&s.config)->halving_limit = harness_draw_below(source, 6);
    solver_of(&s.config)->attempt_limit = 1 + harness_draw_below(source, 16);
    small_create(&s);
    s.thread.gravity[1] = s.rigid.gravity[1] = -9.81;
    uint32_t line =
        small_thread(&s, vec3_make(-4e-3, 3e-3, 0.0), vec3_make(4e-3, 3e-3, 1e-3), 16, &thread);
    vbss_scene_rigid_kind kind = (vbss_scene_rigid_kind)harness_draw_below(source, 2);
    uint32_t tool = small_stick(&s, kind, vec3_zero(), half, 1e-3);
    s.rigid.mass = vbss_exp(harness_draw_real(source, -18.0, 2.0));
    uint32_t needle = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(6e-3, 3e-3, 1e-3),
                                  vec3_make(0.0, 1e-3, 0.0), 3e-4);
    if (harness_draw_below(source, 2) == 0) {
        small_pin(&s, line, 16, needle);
    }
    if (harness_draw_below(source, 2) == 0) {
        small_pin(&s, line, 0, harness_draw_below(source, 2) == 0 ? 0 : tool);
    }
    small_watch_begin(&s, &w);
    for (int i = 0; i < 12; i++) {
        if (harness_draw_below(source, 2) == 0) {
            shake(&s, source, thread, tool);
        }
        uint64_t hash = small_hash(&s);
        vbss_result result = vbss_scene_step(s.scene, 1e-3);
        if (result != VBSS_OK) {
            assert_true(result == VBSS_ERROR_CAPACITY || result == VBSS_ERROR_NOT_FINITE);
            assert_true(small_hash(&s) == hash);
        }
        assert_true(all_finite(&s));
    }
    assert_int_equal(w.passed, 0);
    small_end(&s);
}

static void any_host_motion_ends_finite_without_passage(void **state)
{
    (void)state;
    harness_property("wild", 150, wild_scenes_end_in_numbers, NULL);
}

/* What is shown of contacts after a cut is no figment of the attempt that was thrown away. */
static void forces_after_truncation_are_contact_forces(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    small_begin_scene(&s);
    uint32_t line =
        small_thread(&s, vec3_make(-6e-3, 0.0, 0.0), vec3_make(6e-3, 0.0, 0.0), 12, &thread);
    small_pin_ends(&s, line, 13);
    uint32_t tool =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(1e-4, 2e-3, 0.0), half, 1e-3);
    for (int i = 0; i < 10; i++) {
        small_move(&s, tool, vec3_make(1e-4, 2e-3 - 1e-3 * i, 0.0));
        small_steps(&s, 1, 1e-3);
        vbss_view v = small_view(&s, VBSS_SCENE_VIEW_CONTACT_FORCES);
        for (uint64_t k = 0; k < v.count; k++) {
            double force = vec3_norm(small_vector(&s, VBSS_SCENE_VIEW_CONTACT_FORCES, k));
            assert_true(force < 2e5 * 1.125e-3); /* not more than all of the distance gives */
        }
        double hand = vec3_norm(vec3_load(small_rigid(&s, tool).hand_force));
        assert_true(hand <
                    2.2 * vbss_max(small_tension(thread, 5), small_tension(thread, 6)) + 1.0);
    }
    assert_true(small_statistics(&s).clamped > 0);
    assert_true(small_statistics(&s).penetration < 1.125e-3);
    small_end(&s);
}

/* Two tools that cannot get past each other, one of them driven on: the other's hand feels it at once, also where
 * the rest of a step waits. */
static void expect_felt(uint32_t step_budget)
{
    small s;
    small_begin(&s);
    solver_of(&s.config)->penetration_tolerance = 1e-3; /* so that pressing is cut short early */
    set_step_operations(&s.config, step_budget);
    solver_of(&s.config)->attempt_limit =
        step_budget > 0 ? 3 : solver_values(&s.config).attempt_limit;
    small_create(&s);
    small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
    uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 2.1e-3, 0.0),
                                vec3_make(5e-3, 0.0, 0.0), 1e-3);
    for (int i = 1; i <= 60; i++) {
        small_move(&s, tool, vec3_make(0.0, 2.1e-3 - 5e-5 * i, 0.0));
        small_steps(&s, 1, 1e-3);
        vbss_scene_rigid_state r = small_rigid(&s, tool);
        double behind = r.position[1] - r.target_position[1], rate = 0.05 + r.velocity[1];
        expect_near(2000.0 * behind + 5.0 * rate, r.hand_force[1], 1e-6);
    }
    vbss_scene_statistics statistics = small_statistics(&s);
    assert_true(step_budget > 0 ? statistics.paused > 0 : statistics.clamped > 0);
    small_end(&s);
}

static void hand_feels_truncated_tool_motion(void **state)
{
    (void)state;
    expect_felt(0);
    expect_felt(1000000);
}

int test_truncation(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_the_island_that_collides_is_truncated),
        cmocka_unit_test(an_island_is_truncated_as_a_whole),
        cmocka_unit_test(pins_lag_with_their_bodies),
        cmocka_unit_test(truncation_adds_no_tension),
        cmocka_unit_test(offline_mode_retries_before_truncation),
        harness_test(any_host_motion_ends_finite_without_passage),
        cmocka_unit_test(forces_after_truncation_are_contact_forces),
        cmocka_unit_test(hand_feels_truncated_tool_motion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
