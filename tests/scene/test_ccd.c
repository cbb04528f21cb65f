/* Something is made to pass, and does not. */
#include "base/elementary.h"
#include "fixtures/solver_of.h"
#include "scene/small_watch.h"

static const vec3 half = {0.0, 0.0, 5e-3};
static const vec3 along = {5e-3, 0.0, 0.0};

/* In real time with and without a limit of work, and offline. */
enum { LIMITED, UNLIMITED, OFFLINE, VARIANTS };

static void set_variant(small *s, int variant)
{
    s->config.mode = variant == OFFLINE ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
    if (variant == UNLIMITED) {
        set_step_operations(&s->config, 0);
        solver_of(&s->config)->attempt_limit = 16;
    }
}

/* Steps, with the bound of a real-time step looked after. */
static void guarded_steps(small *s, uint32_t count, double h)
{
    for (uint32_t i = 0; i < count; i++) {
        vbss_scene_statistics before = small_statistics(s);
        small_steps(s, 1, h);
        uint64_t attempts = small_statistics(s).attempts - before.attempts;
        uint32_t smallest = solver_values(&s->config).attempt_limit;
        if (s->config.mode == VBSS_SCENE_MODE_OFFLINE) {
            continue;
        }
        if (step_operations(&s->config) == 0) { /* and one each for the parts that are left */
            assert_true(attempts <= smallest + (1u << solver_values(&s->config).halving_limit));
        } else if (before.steps > 0) { /* and what finishes the smallest part */
            assert_true(attempts <= smallest + 2);
        }
    }
}

/* A taut line along x at the origin, held by the world. */
static uint32_t add_taut_line(small *s, vbss_thread **thread)
{
    uint32_t line =
        small_thread(s, vec3_make(-12e-3, 0.0, 0.0), vec3_make(12e-3, 0.0, 0.0), 24, thread);
    small_pin_ends(s, line, 25);
    return line;
}

/* ---- tools */

/* Through the line in one step. */
static void thread_stops_driven_tool_and_recovers(void **state)
{
    (void)state;
    for (int m = 0; m < VARIANTS; m++) {
        small s;
        small_watch w;
        vbss_thread *thread;
        small_begin(&s);
        set_variant(&s, m);
        small_create(&s);
        s.thread.axial_stiffness = 4000.0; /* a soft one would give way */
        add_taut_line(&s, &thread);
        uint32_t tool =
            small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(1e-4, 5e-3, 0.0), half, 1e-3);
        small_watch_begin(&s, &w);
        small_steps(&s, 1, 1e-3);
        small_move(&s, tool, vec3_make(1e-4, -5e-3, 0.0)); /* 10 mm in one step */
        guarded_steps(&s, 1, 1e-3);
        assert_true(small_position(&s, tool).y > -4.5e-3); /* it lags */
        assert_true(m == LIMITED ? small_statistics(&s).paused > 0
                                 : small_statistics(&s).clamped > 0);
        guarded_steps(&s, 30, 1e-3);
        assert_true(small_node(thread, 12).y < small_position(&s, tool).y); /* still before it */
        small_watch_expect_nothing(&w);

        uint64_t clamped = small_statistics(&s).clamped;
        vec3 up = vec3_make(1e-4, 5e-3, 0.0);
        small_move(&s, tool, up);
        guarded_steps(&s, m == LIMITED ? 3 : 1, 1e-3); /* it begins in small parts */
        expect_near(0.0, vec3_distance(up, small_position(&s, tool)), 1e-16);
        guarded_steps(&s, 300, 1e-3);
        assert_int_equal(small_statistics(&s).clamped, clamped);
        expect_near(0.0, small_node(thread, 12).y, 1e-3); /* the thread springs back */
        small_watch_expect_nothing(&w);
        small_end(&s);
    }
}

static void coupled_tool_presses_without_passage(void **state)
{
    (void)state;
    small s;
    small_watch w;
    vbss_thread *thread;
    small_begin_scene(&s);
    add_taut_line(&s, &thread);
    uint32_t tool =
        small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(1e-4, 5e-3, 0.0), half, 1e-3);
    small_watch_begin(&s, &w);
    for (int i = 1; i <= 100; i++) { /* 0.2 m/s, to 15 mm below */
        small_move(&s, tool, vec3_make(1e-4, 5e-3 - 2e-4 * i, 0.0));
        guarded_steps(&s, 1, 1e-3);
    }
    guarded_steps(&s, 200, 1e-3);
    vbss_scene_rigid_state r = small_rigid(&s, tool);
    assert_true(small_node(thread, 12).y < r.position[1]);
    assert_true(r.hand_force[1] > 5.0); /* the hand feels it */
    expect_near(2000.0 * (r.position[1] - r.target_position[1]), r.hand_force[1], 0.5);
    small_watch_expect_nothing(&w);
    small_end(&s);
}

/* For a second; each part may go on by a share of what is left, and that is never all. */
static void driven_tools_never_pass_each_other(void **state)
{
    (void)state;
    for (int m = 0; m < VARIANTS; m++) {
        small s;
        small_watch w;
        small_begin(&s);
        set_variant(&s, m);
        small_create(&s);
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
        uint32_t tool =
            small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 5e-3, 0.0), along, 1e-3);
        small_watch_begin(&s, &w);
        for (int i = 0; i < 1000; i++) {
            small_move(&s, tool, vec3_make(0.0, -5e-3, 0.0));
            guarded_steps(&s, 1, 1e-3);
        }
        small_watch_expect_nothing(&w);
        assert_true(small_position(&s, tool).y > 0.0);
        small_move(&s, tool, vec3_make(0.0, 5e-3, 0.0));
        guarded_steps(&s, m == LIMITED ? 3 : 1, 1e-3); /* it begins in small parts */
        expect_near(5e-3, small_position(&s, tool).y, 1e-16);
        small_end(&s);
    }
}

static void crossing_coupled_tools_keep_their_sides(void **state)
{
    (void)state;
    small s;
    small_watch w;
    small_begin_scene(&s);
    uint32_t a = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 3e-3, 0.0), along, 1e-3);
    uint32_t b = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, -3e-3, 0.0), half, 1e-3);
    small_watch_begin(&s, &w);
    for (int i = 1; i <= 300; i++) { /* past each other by 6 mm */
        double y = 3e-3 - 6e-5 * vbss_min(i, 100.0);
        small_move(&s, a, vec3_make(0.0, y, 0.0));
        small_move(&s, b, vec3_make(0.0, -y, 0.0));
        guarded_steps(&s, 1, 1e-3);
    }
    expect_near(2e-3, small_position(&s, a).y - small_position(&s, b).y, 2e-4);
    small_watch_expect_nothing(&w);
    small_end(&s);
}

/* By more than a quarter of a turn in one step: the ends go straight, and so does what is guarded. */
static void swung_stick_takes_thread_along(void **state)
{
    (void)state;
    for (int degrees = 10; degrees <= 170; degrees += 20) {
        small s;
        small_watch w;
        double turn = degrees * 0.017453292519943295;
        const double zero[3] = {0.0, 0.0, 0.0};
        const double q[4] = {vbss_cos(0.5 * turn), 0.0, 0.0, vbss_sin(0.5 * turn)};
        small_begin_scene(&s);
        uint32_t stick = small_capsule(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(),
                                       vec3_make(0.02, 0.0, 0.0), 5e-4);
        vbss_thread *thread; /* across the path of the stick, near its middle */
        uint32_t line = small_thread(&s, vec3_make(9.2e-3, 2e-3, -6e-3),
                                     vec3_make(9.2e-3, 2e-3, 6e-3), 12, &thread);
        small_pin_ends(&s, line, 13);
        small_watch_begin(&s, &w);
        expect_ok(vbss_scene_set_rigid_target(s.scene, stick, zero, q));
        guarded_steps(&s, 20, 1e-3);
        small_watch_expect_nothing(&w);
        assert_true(small_statistics(&s).guard_pairs > 0);
        small_end(&s);
    }
}

/* ---- threads */

static void throw(vbss_thread * thread, uint32_t nodes, vec3 v)
{
    double velocities[3 * 50];
    for (uint32_t i = 0; i < nodes; i++) {
        vec3_store(velocities + 3 * (size_t)i, v);
    }
    expect_ok(vbss_thread_set_state(thread, NULL, velocities, nodes));
}

/* At 50 m/s it goes 50 mm in a step: far behind what it meets. */
static void thread_thrown_at_tool_does_not_pass(void **state)
{
    (void)state;
    const vbss_scene_rigid_kind kinds[] = {VBSS_SCENE_RIGID_DRIVEN, VBSS_SCENE_RIGID_COUPLED,
                                           VBSS_SCENE_RIGID_FREE};
    for (int k = 0; k < 3 * VARIANTS; k++) {
        small s;
        small_watch w;
        vbss_thread *thread;
        small_begin(&s);
        set_variant(&s, k % VARIANTS);
        small_create(&s);
        small_thread(&s, vec3_make(-10e-3, 4e-3, 1e-4), vec3_make(10e-3, 4e-3, 2e-4), 40, &thread);
        small_stick(&s, kinds[k / VARIANTS], vec3_zero(), half, 1e-3);
        small_watch_begin(&s, &w);
        throw(thread, 41, vec3_make(0.0, -50.0, 1.0));
        guarded_steps(&s, 50, 1e-3);
        small_watch_expect_nothing(&w);
        small_end(&s);
    }
}

static void thread_thrown_at_floor_does_not_pass(void **state)
{
    (void)state;
    for (int k = 0; k < 2 * VARIANTS; k++) {
        small s;
        small_watch w;
        vbss_thread *thread;
        small_begin(&s);
        set_variant(&s, k % VARIANTS);
        s.config.floor = 1;
        s.config.floor_normal[0] = k < VARIANTS ? 0.0 : 0.3;
        small_create(&s);
        small_thread(&s, vec3_make(-10e-3, 8e-3, 0.0), vec3_make(10e-3, 10e-3, 0.0), 40, &thread);
        small_watch_begin(&s, &w);
        throw(thread, 41, vec3_make(5.0, -50.0, 0.0));
        guarded_steps(&s, 50, 1e-3);
        small_watch_expect_nothing(&w);
        assert_true(w.nearest_floor > 0.4 * 0.125e-3);
        small_end(&s);
    }
}

static void threads_thrown_at_each_other_do_not_pass(void **state)
{
    (void)state;
    for (int k = 0; k < 2 * VARIANTS; k++) {
        small s;
        small_watch w;
        vbss_thread *a, *b;
        small_begin(&s);
        set_variant(&s, k % VARIANTS);
        small_create(&s);
        small_thread(&s, vec3_make(-10e-3, 2e-3, 0.0), vec3_make(10e-3, 2e-3, 0.0), 30, &a);
        small_thread(&s, vec3_make(1e-4, -2e-3, -10e-3), vec3_make(0.0, -2e-3, 10e-3), 30, &b);
        small_watch_begin(&s, &w);
        throw(a, 31, vec3_make(0.0, k < VARIANTS ? -50.0 : -5.0, 0.0));
        throw(b, 31, vec3_make(0.0, 50.0, 0.0));
        guarded_steps(&s, 50, 1e-3);
        small_watch_expect_nothing(&w);
        small_end(&s);
    }
}

static void capsule_thrown_at_floor_does_not_pass(void **state)
{
    (void)state;
    for (int k = 0; k < 2 * VARIANTS; k++) {
        small s;
        small_watch w;
        small_begin(&s);
        set_variant(&s, k % VARIANTS);
        s.config.floor = 1;
        small_create(&s);
        s.rigid.velocity[1] = -50.0;
        s.rigid.angular_velocity[2] = 100.0;
        s.rigid.mass = k < VARIANTS ? 1e-4 : 0.02;
        small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 8e-3, 0.0), along, 1e-3);
        small_watch_begin(&s, &w);
        guarded_steps(&s, 50, 1e-3);
        small_watch_expect_nothing(&w);
        small_end(&s);
    }
}

int test_ccd(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thread_stops_driven_tool_and_recovers),
        cmocka_unit_test(coupled_tool_presses_without_passage),
        cmocka_unit_test(driven_tools_never_pass_each_other),
        cmocka_unit_test(crossing_coupled_tools_keep_their_sides),
        cmocka_unit_test(swung_stick_takes_thread_along),
        cmocka_unit_test(thread_thrown_at_tool_does_not_pass),
        cmocka_unit_test(thread_thrown_at_floor_does_not_pass),
        cmocka_unit_test(threads_thrown_at_each_other_do_not_pass),
        cmocka_unit_test(capsule_thrown_at_floor_does_not_pass),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
