/* A tool on an arm in a hand that feels its force late: where the loop is stable, in closed form, and that a human hand is. */
#include "scene/haptic_rig.h"

static haptic_loop loop_of(double mass, double stiffness, int delay)
{
    vbss_grasper_config config;
    expect_ok(vbss_grasper_config_init(&config, sizeof config));
    return (haptic_loop){.mass = mass,
                         .stiffness = stiffness,
                         .delay = delay,
                         .coupling_stiffness = config.stiffness,
                         .coupling_damping = config.damping};
}

/* Energy of the last window as a multiple of that of the second. */
static double growth(const haptic_measures *m)
{
    assert_true(m->energy[1] > 0.0);
    return m->energy[HAPTIC_WINDOWS - 1] / m->energy[1];
}

/* A hand without damping at a rigid wall, on the border of stability at an angular frequency w. A force is late by T, the delay
 * and half a step in which it is held; that of the damper by half a step more, for its difference of positions. With
 * F = -(K e^(-iwT) + iwB e^(-iw(T + h/2))) x both parts of -m w^2 + k - F/x = 0 give B and m. */
static haptic_loop border(double frequency, int delay, double share_of_damping)
{
    const double late = (delay + 0.5) * 1e-3, later = (delay + 1.0) * 1e-3;
    haptic_loop loop = loop_of(0.0, 100.0, delay);
    double k = loop.coupling_stiffness;
    double b = k * sin(frequency * late) / (frequency * cos(frequency * later));
    loop.mass =
        (loop.stiffness + k * cos(frequency * late) + frequency * b * sin(frequency * later)) /
        (frequency * frequency);
    loop.coupling_damping = share_of_damping * b;
    return loop;
}

static void rigid_wall_is_stable_from_closed_form_damping_on(void **state)
{
    (void)state;
    const int delays[3] = {1, 2, 4};
    for (int i = 0; i < 3; i++) {
        const haptic_loop less = border(70.0, delays[i], 0.85),
                          more = border(70.0, delays[i], 1.15);
        haptic_measures unstable = haptic_measure(HAPTIC_WALL, &less, 0.05);
        haptic_measures stable = haptic_measure(HAPTIC_WALL, &more, 0.05);
        assert_true(growth(&unstable) > 1.5);
        assert_true(growth(&stable) < 1.0 / 1.5);
    }
}

/* An elastic wall stretches the coupling's damper less, so that the hand has to pay for the delay. */
static void elastic_wall_is_stable_from_min_damping_on(void **state)
{
    (void)state;
    haptic_loop loop = loop_of(0.2, 100.0, 4);
    haptic_measures undamped = haptic_measure(HAPTIC_ELASTIC, &loop, 0.05);
    assert_true(growth(&undamped) > 1.5);
    double frequency = sqrt((loop.stiffness + HAPTIC_ELASTIC_STIFFNESS) / loop.mass);
    loop.damping = haptic_min_damping(&loop, frequency, 4.5e-3);
    haptic_measures damped = haptic_measure(HAPTIC_ELASTIC, &loop, 0.05);
    assert_true(growth(&damped) < 1.0);
}

/* A firm hand on a light arm, 4 ms late, strikes at 0.5 m/s. */
static void firm_hand_comes_to_rest_on_drain_and_needle(void **state)
{
    (void)state;
    for (int what = HAPTIC_DRAIN; what <= HAPTIC_NEEDLE; what++) {
        haptic_loop loop = loop_of(0.05, 400.0, 4);
        loop.damping = haptic_hand_damping(&loop);
        haptic_measures m = haptic_measure((haptic_obstacle)what, &loop, 0.5);
        haptic_expect_rest(&m);
        assert_true(m.pressed > 0.1);
    }
}

/* The stage shortens what the tool asks for, and the continuous limit takes over while the hand presses on. */
static void hard_press_keeps_limit_of_force(void **state)
{
    (void)state;
    haptic_loop loop = loop_of(0.2, 400.0, 4);
    loop.damping = haptic_hand_damping(&loop);
    haptic_rig r;
    haptic_begin(&r, HAPTIC_WALL, &loop);
    haptic_measures m = haptic_press(&r, 0.5, 5.0);
    assert_true(m.asked > 5.0);
    haptic_expect_limit(&m);
    haptic_end(&r);
}

int test_haptic_loop(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(rigid_wall_is_stable_from_closed_form_damping_on),
        harness_test(elastic_wall_is_stable_from_min_damping_on),
        harness_test(firm_hand_comes_to_rest_on_drain_and_needle),
        harness_test(hard_press_keeps_limit_of_force),
    };
    return cmocka_run_group_tests_name("scene.haptic_loop", tests, NULL, NULL);
}
