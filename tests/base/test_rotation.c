#include <math.h>

#include "base/rotation.h"
#include "harness/harness.h"

static const double pi = 0x1.921fb54442d18p1;

static void there_and_back(harness_source *source, void *user)
{
    (void)user;
    vec3 axis = vec3_unit_or(harness_draw_vec3(source, -1, 1), vec3_make(1, 0, 0));
    /* Angles from 1e-12 to pi, evenly in the logarithm: across both small-angle limits. */
    double angle = pi * pow(10.0, harness_draw_real(source, -12.5, -1e-9));
    vec3 rotation = vec3_scale(axis, angle);
    quat q = vbss_quat_from_rotation_vector(rotation);
    expect_near(1.0, quat_dot(q, q), 9e-16);
    vec3 back = vbss_quat_to_rotation_vector(q);
    expect_near(0.0, vec3_distance(rotation, back), 6e-16 * angle + 1e-16 * (angle > 3.0));
    /* The other sign is the same orientation. */
    vec3 same = vbss_quat_to_rotation_vector(quat_make(-q.w, -q.x, -q.y, -q.z));
    expect_near(0.0, vec3_distance(back, same), 0.0);
}

static void rotation_vector_round_trip(void **state)
{
    (void)state;
    harness_property("there and back", 5000, there_and_back, NULL);
}

static void zero_rotation_is_exact_identity(void **state)
{
    (void)state;
    quat q = vbss_quat_from_rotation_vector(vec3_zero());
    expect_same_bits(1.0, q.w);
    expect_same_bits(0.0, q.x);
    vec3 back = vbss_quat_to_rotation_vector(q);
    expect_same_bits(0.0, vec3_norm(back));
}

static void small_angle_series_joins_closed_form(void **state)
{
    (void)state;
    /* Just below and above each limit the two formulas must agree to rounding. */
    const double limits[] = {1e-4, 2e-5};
    for (int i = 0; i < 2; i++) {
        quat below = vbss_quat_from_rotation_vector(vec3_make(limits[i] * (1 - 1e-15), 0, 0));
        quat above = vbss_quat_from_rotation_vector(vec3_make(limits[i] * (1 + 1e-15), 0, 0));
        expect_near(below.x / above.x, 1.0, 3e-15);
        expect_near(below.w, above.w, 1e-16);
        vec3 b = vbss_quat_to_rotation_vector(below), a = vbss_quat_to_rotation_vector(above);
        expect_near(b.x / a.x, 1.0, 3e-15);
    }
}

static void constant_angular_velocity_turns_by_its_angle(void **state)
{
    (void)state;
    vec3 omega = vec3_make(0.3, -2.0, 1.1);
    quat q = quat_identity();
    enum { STEPS = 1000 };
    for (int i = 0; i < STEPS; i++) {
        q = vbss_quat_integrate(q, omega, 1e-3);
    }
    vec3 turned = vbss_quat_to_rotation_vector(q);
    expect_near(0.0, vec3_distance(turned, omega), 1e-13);
}

static void long_integration_stays_unit(void **state)
{
    (void)state;
    quat q = quat_identity();
    double worst = 0.0;
    for (int i = 0; i < 1000000; i++) {
        q = vbss_quat_integrate(q, vec3_make(30.0, -20.0, 11.0), 1e-3);
        worst = fmax(worst, fabs(quat_dot(q, q) - 1.0));
    }
    expect_near(0.0, worst, 9e-16);
}

static void unnormalised_quaternion_is_read_as_rotation(void **state)
{
    (void)state;
    vec3 half = vbss_quat_to_rotation_vector(quat_make(0, 1e-6, 0, 0));
    expect_near(pi, half.x, 1e-15);
    vec3 largest = vbss_quat_to_rotation_vector(quat_make(1e-7, 1e-6, 0, 0));
    expect_near(2 * atan2(1e-6, 1e-7), largest.x, 1e-15);
}

static void non_finite_angular_velocity_propagates(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++) {
        vec3 spin = vec3_make(0, harness_bad_numbers[i], 0);
        assert_false(quat_is_finite(vbss_quat_integrate(quat_identity(), spin, 1e-3)));
    }
}

static void angular_velocity_is_in_world_frame(void **state)
{
    (void)state;
    /* Lying on its side (x turned to y), then turned about the world's x: y goes to z. */
    quat side = vbss_quat_from_rotation_vector(vec3_make(0, 0, pi / 2));
    quat q = vbss_quat_integrate(side, vec3_make(1, 0, 0), pi / 2);
    vec3 x = quat_rotate(q, vec3_make(1, 0, 0));
    expect_near(1.0, x.z, 1e-15);
    expect_near(0.0, x.x, 1e-15);
    expect_near(0.0, x.y, 1e-15);
}

int test_rotation(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(rotation_vector_round_trip),
        harness_test(zero_rotation_is_exact_identity),
        harness_test(small_angle_series_joins_closed_form),
        harness_test(constant_angular_velocity_turns_by_its_angle),
        harness_test(long_integration_stays_unit),
        harness_test(unnormalised_quaternion_is_read_as_rotation),
        harness_test(non_finite_angular_velocity_propagates),
        harness_test(angular_velocity_is_in_world_frame),
    };
    return cmocka_run_group_tests_name("base.rotation", tests, NULL, NULL);
}
