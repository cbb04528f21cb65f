/* Tools in the lumen, fast tools, tools that do not stop, tools that squeeze: nothing passes through the wall. */
#include "base/elementary.h"
#include "scene/drain_case.h"

static drain_case c;

/* Middle surface 6.5 mm from the axis, wall 1 mm; 32 mm long. */
#define TOP 7.0e-3
#define HALF_LENGTH 16e-3

static void begin(double thickness)
{
    drain_case_begin(&c);
    c.config.thickness = thickness;
    c.config.tear_stress = 1e9;
    drain_case_make(&c);
}

/* In along the axis from one end, three turns that press on the wall from inside, and out again. */
static void stir(const char *name, double thickness)
{
    begin(thickness);
    uint32_t rod = drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED, vec3_make(35e-3, 0.0, 0.0),
                                   vec3_make(15e-3, 0.0, 0.0), 1.25e-3);
    drain_case_move_to(&c, rod, vec3_make(0.0, 0.0, 0.0), 350);
    for (int i = 0; i < 1500; i++) {
        double turn = 2.0 * VBSS_PI * i / 500.0, far = 6e-3 * vbss_min(i / 200.0, 1.0);
        drain_case_target(&c, rod, vec3_make(0.0, far * vbss_cos(turn), far * vbss_sin(turn)));
        drain_case_step(&c);
    }
    drain_case_report(&c, name);
    drain_case_move_to(&c, rod, vec3_make(0.0, 0.0, 0.0), 200);
    drain_case_move_to(&c, rod, vec3_make(45e-3, 0.0, 0.0), 300);
    drain_case_wait(&c, 500);
    drain_case_expect_rest(&c, 0.1e-3);
    drain_case_finish(&c, name, 0.05);
}

static void rod_stirs_in_lumen(void **state)
{
    (void)state;
    stir("stirred", 1e-3);
}

static void rod_stirs_in_thin_lumen(void **state)
{
    (void)state;
    stir("stirred, thin", 0.4e-3);
}

static void strike(const char *name, double speed, vec3 from, vec3 displacement, vec3 half)
{
    begin(1e-3);
    uint32_t rod = drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED, from, half, 1.5e-3);
    vec3 to = vec3_add(from, displacement);
    uint32_t steps = (uint32_t)(vec3_norm(displacement) / (speed * c.h));
    drain_case_move_to(&c, rod, to, steps);
    drain_case_move_to(&c, rod, from, steps);
    drain_case_wait(&c, 500);
    drain_case_expect_rest(&c, 0.1e-3);
    drain_case_finish(&c, name, 0.05);
}

static void fast_rod_strikes_side(void **state)
{
    (void)state;
    const vec3 from = {3e-3, 1e-3, 20e-3}, displacement = {0.0, 0.0, -18e-3},
               half = {0.0, 8e-3, 0.0};
    strike("struck at 0.5 m/s", 0.5, from, displacement, half);
    strike("struck at 1 m/s", 1.0, from, displacement, half);
}

static void fast_tip_strikes_top(void **state)
{
    (void)state;
    const vec3 from = {0.5e-3, 25e-3, 4e-3}, displacement = {0.0, -14e-3, 0.0},
               half = {0.0, 8e-3, 0.0};
    strike("a tip at 0.5 m/s", 0.5, from, displacement, half);
    strike("a tip at 1 m/s", 1.0, from, displacement, half);
}

/* What cannot be stopped by forces is stopped by the guard, and that is counted. */
static void driven_rod_stops_at_bottom(void **state)
{
    (void)state;
    begin(1e-3);
    uint32_t rod = drain_case_tool(&c, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, TOP + 5e-3, 0.0),
                                   vec3_make(0.0, 0.0, 20e-3), 1.5e-3);
    drain_case_move_to(&c, rod, vec3_make(0.0, -25e-3, 0.0),
                       740); /* 50 mm/s, through top and bottom */
    assert_true(drain_case_at(&c, rod).y > -6.5e-3);
    assert_true(small_statistics(&c.s).clamped > 0);
    drain_case_report(&c, "driven");
    small_watch_expect_nothing(&c.watch);
    drain_case_move_to(&c, rod, vec3_make(0.0, TOP + 20e-3, 0.0), 900);
    drain_case_wait(&c, 1000);
    drain_case_report(&c, "driven, and away");
    small_watch_expect_nothing(&c.watch);
    drain_case_expect_rest(&c, 0.1e-3);
    drain_case_end(&c);
}

/* One inside, one outside: the wall is between them. */
static void two_rods_squeeze_wall(void **state)
{
    (void)state;
    begin(1e-3);
    const vec3 half = {10e-3, 0.0, 0.0};
    uint32_t in =
        drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 0.0, 3e-3), half, 1.25e-3);
    uint32_t out =
        drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 0.0, 10e-3), half, 1.25e-3);
    for (int i = 0; i < 500; i++) {
        double travel = 5e-3 * vbss_min(i / 300.0, 1.0); /* 3.25 mm would be touching: 1 N each */
        drain_case_target(&c, in, vec3_make(0.0, 0.0, 3e-3 + 0.5 * travel));
        drain_case_target(&c, out, vec3_make(0.0, 0.0, 10e-3 - travel));
        drain_case_step(&c);
    }
    drain_case_report(&c, "squeezed");
    vec3 force = drain_case_contact_force(&c, in), other = drain_case_contact_force(&c, out);
    assert_true(force.z < -1.0 && other.z > 1.0);
    drain_case_move_to(&c, in, vec3_make(0.0, 0.0, 0.0), 200);
    drain_case_move_to(&c, out, vec3_make(0.0, 0.0, 15e-3), 200);
    drain_case_wait(&c, 300);
    drain_case_expect_rest(&c, 0.1e-3);
    drain_case_finish(&c, "squeezed", 0.05);
}

int test_drain_stirred(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rod_stirs_in_lumen),         cmocka_unit_test(rod_stirs_in_thin_lumen),
        cmocka_unit_test(fast_rod_strikes_side),      cmocka_unit_test(fast_tip_strikes_top),
        cmocka_unit_test(driven_rod_stops_at_bottom), cmocka_unit_test(two_rods_squeeze_wall),
    };
    return cmocka_run_group_tests_name("drain stirred", tests, NULL, NULL);
}
