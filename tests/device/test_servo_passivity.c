/* What energy a hand gets from a stiff wall in a round of pressing and letting go, in each arrangement of host and servo.
 * docs/notebook/devices.md has the table. */
#include "harness/harness.h"
#include "fixtures/servo_wall.h"

/* mJ a round. */
static double gained(const servo_wall *given)
{
    servo_wall wall = *given;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    expect_ok(servo_wall_run(context, VBSS_STAND_IN_OPENHAPTICS, &wall));
    assert_int_equal(wall.illegal, 0);
    if (wall.away < 0.01) {
        assert_true(wall.deepest > 1e-4);
    }
    print_message("arrangement %d, period %d, lag %d, %g N/m, %g N s/m, %g kg: %+.4f mJ a round\n",
                  wall.arrangement, wall.period, wall.lag, wall.stiffness, wall.damping, wall.mass,
                  1e3 * wall.gained);
    harness_context_end(context, &memory);
    return 1e3 * wall.gained;
}

static servo_wall wall_of(servo_arrangement arrangement, int period, int lag)
{
    return (servo_wall){.arrangement = arrangement,
                        .period = period,
                        .lag = lag,
                        .stiffness = 400.0,
                        .damping = 1.0,
                        .mass = 0.1};
}

/* period and lag of a host: 1 kHz, 500, 333, 200 and 100 Hz */
static const int hosts[][2] = {{1, 1}, {2, 1}, {3, 2}, {5, 4}, {10, 9}};
enum { HOSTS = sizeof hosts / sizeof hosts[0] };

/* A light hand that damps nothing itself, without damping in the coupling and with: the worst there is. */
static void servo_coupling_is_passive(void **state)
{
    (void)state;
    for (int k = 0; k < 6; k++) {
        servo_wall inside = wall_of(SERVO_INSIDE, 1, 0);
        inside.damping = k % 2;
        inside.mass = 0.05 * (1 << k / 2);
        assert_true(gained(&inside) < 0.0);
        for (int i = 0; i < HOSTS; i++) {
            servo_wall beside = wall_of(SERVO_BESIDE, hosts[i][0], hosts[i][1]);
            beside.damping = inside.damping;
            beside.mass = inside.mass;
            assert_true(gained(&beside) < 0.0);
        }
    }
}

/* The same force from the same host, put out as it comes: a hand that does not damp is thrown back. */
static void delayed_force_generates_energy(void **state)
{
    (void)state;
    for (int i = 0; i < HOSTS; i++) {
        servo_wall wall = wall_of(SERVO_FORWARDED, hosts[i][0], hosts[i][1]);
        wall.damping = 0.0;
        assert_true(gained(&wall) > 1.0);
    }
}

/* What the price is: away from the wall the tool comes after the hand. */
static void free_hand_feels_little_drag(void **state)
{
    (void)state;
    for (int i = 0; i < HOSTS; i++) {
        servo_wall wall = wall_of(SERVO_BESIDE, hosts[i][0], hosts[i][1]);
        wall.away = 0.02;
        double taken = -gained(&wall);
        assert_true(taken > 0.0 && taken < 10.0);
    }
}

int test_servo_passivity(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(servo_coupling_is_passive),
        cmocka_unit_test(delayed_force_generates_energy),
        cmocka_unit_test(free_hand_feels_little_drag),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
