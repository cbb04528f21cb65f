/* All corners of hand, arm and delay in the passivity rig. `ctest -R haptic_corners -V` prints the table of
 * docs/notebook/devices.md. */
#include "scene/haptic_rig.h"

static const char *const obstacles[HAPTIC_OBSTACLES] = {"rigid wall", "elastic wall, 90 N/m",
                                                        "drain", "needle in the other tool"};
static const double stiffnesses[] = {100.0, 200.0, 400.0}, masses[] = {0.05, 0.1, 0.2};
static const double speeds[] = {0.05, 0.5}; /* of the hand when it meets the obstacle, m/s */
static const int delays[] = {1, 2, 4};
enum { CORNERS = 3, SPEEDS = 2 };

static haptic_loop corner(int stiffness, int mass, int delay)
{
    vbss_grasper_config config;
    expect_ok(vbss_grasper_config_init(&config, sizeof config));
    return (haptic_loop){.mass = masses[mass],
                         .stiffness = stiffnesses[stiffness],
                         .delay = delays[delay],
                         .coupling_stiffness = config.stiffness,
                         .coupling_damping = config.damping};
}

/* ---- a human hand */

static void press_once(haptic_obstacle obstacle, const haptic_loop *loop, haptic_measures *worst,
                       double *left)
{
    for (int i = 0; i < SPEEDS; i++) {
        haptic_measures m = haptic_measure(obstacle, loop, speeds[i]);
        haptic_expect_rest(&m);
        worst->largest_force = vbss_max(worst->largest_force, m.largest_force);
        worst->ripple = vbss_max(worst->ripple, m.ripple);
        *left = vbss_max(*left, m.energy[HAPTIC_WINDOWS - 1] / m.energy[0]);
    }
}

static void press_all(haptic_obstacle obstacle, int delay, bool in_device)
{
    haptic_measures worst = {.largest_force = 0.0};
    double left = 0.0;
    for (int k = 0; k < CORNERS; k++) {
        for (int m = 0; m < CORNERS; m++) {
            haptic_loop loop = corner(k, m, delay);
            loop.in_device = in_device;
            loop.damping = haptic_hand_damping(&loop);
            press_once(obstacle, &loop, &worst, &left);
        }
    }
    print_message("| %s | %s | %d | %.2f | %.1e | %.1e |\n", obstacles[obstacle],
                  in_device ? "coupling" : "force", delays[delay], worst.largest_force,
                  worst.ripple, left);
}

static void hand_comes_to_rest_in_all_corners(void **state)
{
    (void)state;
    print_message(
        "| obstacle | device gets | delay, ms | largest force, N | ripple at rest, N | energy "
        "after 2 s, of the first window |\n|---|---|---|---|---|---|\n");
    for (int what = 0; what < HAPTIC_OBSTACLES; what++) {
        for (int in_device = 0; in_device < 2; in_device++) {
            for (int d = 0; d < CORNERS; d++) {
                press_all((haptic_obstacle)what, d, in_device != 0);
            }
        }
    }
}

/* ---- a hand with as little damping as the bound asks for */

static void min_damping_stops_growth_in_all_corners(void **state)
{
    (void)state;
    for (int i = 0; i < HAPTIC_OBSTACLES * CORNERS * CORNERS * CORNERS; i++) {
        haptic_loop loop = corner(i % 3, i / 3 % 3, i / 9 % 3);
        double highest = sqrt((loop.stiffness + loop.coupling_stiffness) / loop.mass);
        loop.damping = haptic_min_damping(&loop, highest, (loop.delay + 1.0) * 1e-3);
        haptic_measures m = haptic_measure((haptic_obstacle)(i / 27), &loop, speeds[0]);
        assert_false(haptic_grows(&m));
    }
}

int test_haptic_corners(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(hand_comes_to_rest_in_all_corners),
        harness_test(min_damping_stops_growth_in_all_corners),
    };
    return cmocka_run_group_tests_name("scene.haptic_corners", tests, NULL, NULL);
}
