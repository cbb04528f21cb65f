/* What begins nearer than it may come: it may leave, and not go on. */
#include "fixtures/solver_of.h"
#include "scene/small_watch.h"

static const vec3 half = {0.0, 0.0, 5e-3};
static const vec3 along = {5e-3, 0.0, 0.0};

/* An axis within a third of the distance of touching: pressed on by 0.1 N it comes out, or stays; it does not
 * go through. Let go it leaves. */
static void overlapping_start_may_leave_but_not_pass(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++) {
        small s;
        small_watch w;
        vbss_thread *thread;
        bool pressed = k % 2 == 1, floor = k >= 2;
        small_begin(&s);
        s.config.floor = floor;
        small_create(&s);
        double y = floor ? 0.3 * 0.125e-3 : 0.3 * 1.125e-3;
        s.thread.gravity[1] = pressed ? -1e4 : 0.0;
        small_thread(&s, vec3_make(-6e-3, y, 0.0), vec3_make(6e-3, y, 0.0), 24, &thread);
        if (!floor) {
            small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
        }
        small_watch_begin(&s, &w);
        small_steps(&s, 200, 1e-3);
        small_watch_expect_nothing(&w);
        assert_true(small_statistics(&s).recovering > 0);
        if (!pressed) { /* out, to where they touch */
            double wanted = floor ? 0.125e-3 : 1.125e-3;
            assert_true(small_node(thread, 12).y > 0.85 * wanted);
        }
        small_end(&s);
    }
}

/* The host has placed two driven sticks so that they overlap. They go where it says, and a thread far
 * away falls freely. Sticks that start apart still stop each other. */
static void overlapping_prescribed_bodies_follow_their_targets(void **state)
{
    (void)state;
    double distance = 1.2e-3; /* of axes; surfaces are apart from 2 mm on */
    for (int i = 0; i < 9; i++) {
        distance = i < 6 ? 0.5 * distance : i == 6 ? 0.0 : distance + 0.2e-3;
        small s;
        vbss_thread *thread;
        small_begin(&s);
        solver_of(&s.config)->halving_limit = 0;
        solver_of(&s.config)->attempt_limit = 1;
        small_create(&s);
        s.thread.gravity[1] = -9.81;
        small_thread(&s, vec3_make(0.1, 0.0, 0.0), vec3_make(0.11, 0.0, 0.0), 8, &thread);
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
        uint32_t tool =
            small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, distance, 0.0), along, 1e-3);
        for (int n = 1; n <= 40; n++) {
            double y = distance - 0.08e-3 * (n % 20);
            small_move(&s, tool, vec3_make(0.0, y, 0.0));
            small_steps(&s, 1, 1e-3);
            expect_near(y, small_position(&s, tool).y, 1e-16);
        }
        expect_near(-0.5 * 9.81 * 0.04 * 0.04, small_node(thread, 4).y, 1e-3 * 0.04 * 9.81);
        assert_int_equal(small_statistics(&s).clamped, 0);
        assert_int_equal(small_statistics(&s).paused, 0);
        small_end(&s);
    }
}

/* The floor stops what is driven at half its radius. */
static void driven_tool_stays_out_of_floor(void **state)
{
    (void)state;
    for (int limited = 0; limited < 2; limited++) {
        small s;
        small_watch w;
        small_begin(&s);
        if (!limited) {
            set_step_operations(&s.config, 0);
            solver_of(&s.config)->attempt_limit = 16;
        }
        s.config.floor = 1;
        small_create(&s);
        uint32_t tool =
            small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 4e-3, 0.0), half, 1e-3);
        small_watch_begin(&s, &w);
        for (int i = 0; i < 3; i++) {
            small_move(&s, tool, vec3_make(0.0, -5e-3, 0.0));
            small_steps(&s, 1, 1e-3);
            double y = small_position(&s, tool).y;
            assert_true(i == 0 ? y > 0.49e-3 : y > 0.0);
        }
        small_watch_expect_nothing(&w);
        small_move(&s, tool, vec3_make(0.0, 4e-3, 0.0));
        small_steps(&s, limited ? 3 : 1, 1e-3); /* it begins in small parts */
        expect_near(4e-3, small_position(&s, tool).y, 1e-16);
        small_end(&s);
    }
}

/* What is below already may not go far; nor does it take others along. */
static void start_below_floor_rises_or_stays(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    small_begin(&s);
    s.config.floor = 1;
    small_create(&s);
    s.thread.gravity[1] = -9.81;
    small_thread(&s, vec3_make(-6e-3, -5e-4, 0.0), vec3_make(6e-3, -5e-4, 0.0), 24, &thread);
    small_steps(&s, 100, 1e-3);
    for (uint32_t i = 0; i <= 24; i++) {
        assert_true(small_node(thread, i).y > 0.9 * 0.125e-3);
    }
    small_end(&s);
}

/* ---- rigid bodies that overlap from the start part slowly, and hold back nothing else */

/* Falls freely, 100 mm away. */
static vbss_thread *add_falling_thread(small *s)
{
    vbss_thread *thread;
    s->thread.gravity[1] = -9.81;
    small_thread(s, vec3_make(0.1, 0.0, 0.0), vec3_make(0.11, 0.0, 0.0), 8, &thread);
    s->thread.gravity[1] = 0.0;
    return thread;
}

static void expect_free_fall(small *s, vbss_thread *falls, uint32_t steps)
{
    double t = 1e-3 * steps;
    expect_near(-0.5 * 9.81 * t * t, small_node(falls, 4).y, 4e-3 * 9.81 * t);
    assert_int_equal(small_statistics(s).paused, 0);
}

static double rigid_speed(small *s, uint32_t body)
{
    return vec3_norm(vec3_load(small_rigid(s, body).velocity));
}

/* Crossed sticks of 1 mm, 2 mm apart where they touch: a driven or a coupled one, and one that floats. */
static void overlapping_sticks_part_slowly(void **state)
{
    (void)state;
    for (int k = 0; k < 40; k++) {
        small s;
        bool driven = k % 2 == 0;
        const int quarter = k / 4;
        double distance = 0.1 * (double)quarter * 2e-3, speed = 0.0;
        small_begin(&s);
        s.config.mode = k / 2 % 2 == 0 ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
        small_create(&s);
        uint32_t one = small_stick(&s, driven ? VBSS_SCENE_RIGID_DRIVEN : VBSS_SCENE_RIGID_COUPLED,
                                   vec3_zero(), half, 1e-3);
        s.rigid.stiffness = s.rigid.damping = 0.0;
        uint32_t other =
            small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, distance, 0.0), along, 1e-3);
        vbss_thread *falls = add_falling_thread(&s);
        for (int i = 0; i < 150; i++) {
            small_steps(&s, 1, 1e-3);
            speed = vbss_max(rigid_speed(&s, other), speed);
            speed = vbss_max(rigid_speed(&s, one), speed);
        }
        assert_true(speed < 0.25);
        assert_true(fabs(small_position(&s, other).y - small_position(&s, one).y) > 0.9 * 2e-3);
        expect_free_fall(&s, falls, 150);
        small_end(&s);
    }
}

/* Two hands drive their tools into each other, and through. */
static void tools_driven_into_each_other_stop_slowly(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++) {
        small s;
        small_begin(&s);
        s.config.mode = k % 2 == 0 ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
        small_create(&s);
        uint32_t one = small_stick(&s, k < 2 ? VBSS_SCENE_RIGID_DRIVEN : VBSS_SCENE_RIGID_COUPLED,
                                   vec3_make(0.0, -2e-3, 0.0), half, 1e-3);
        uint32_t other =
            small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 2e-3, 0.0), along, 1e-3);
        vbss_thread *falls = add_falling_thread(&s);
        double speed = 0.0;
        for (int i = 1; i <= 150; i++) {
            double y = vbss_max(2e-3 - 1e-4 * i, -2e-3); /* 0.1 m/s */
            small_move(&s, one, vec3_make(0.0, k < 2 ? -2e-3 : -y, 0.0));
            small_move(&s, other, vec3_make(0.0, y, 0.0));
            small_steps(&s, 1, 1e-3);
            speed = vbss_max(rigid_speed(&s, other), speed);
        }
        assert_true(speed < 0.15);
        assert_true(small_position(&s, other).y - small_position(&s, one).y > 0.9 * 2e-3);
        expect_free_fall(&s, falls, 150);
        small_end(&s);
    }
}

int test_overlapping_start(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(overlapping_start_may_leave_but_not_pass),
        cmocka_unit_test(overlapping_prescribed_bodies_follow_their_targets),
        cmocka_unit_test(driven_tool_stays_out_of_floor),
        cmocka_unit_test(start_below_floor_rises_or_stays),
        cmocka_unit_test(overlapping_sticks_part_slowly),
        cmocka_unit_test(tools_driven_into_each_other_stop_slowly),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
