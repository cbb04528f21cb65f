/* Velocities out of poses: right for constant ones, filtered as documented for others. */
#include "base/rotation.h"
#include "device/device.h"
#include "harness/harness.h"

static const double filter_time = 0.005;

static device_motion fresh(void)
{
    device_motion m;
    vbss_device_reset_motion(&m);
    return m;
}

/* Irregular times, far from zero. */
static double time_of(int i)
{
    return 1e4 + 1e-3 * i + 4e-4 * (i % 3);
}

static void constant_velocity_from_second_sample(void **state)
{
    (void)state;
    const vec3 v = vec3_make(0.2, -0.1, 0.05), spin = vec3_make(0.5, 2.0, -1.0);
    const vec3 from = vec3_make(0.01, 0.0, 0.02);
    device_motion m = fresh();
    for (int i = 0; i < 200; i++) {
        double t = time_of(i) - 1e4;
        quat q = vbss_quat_from_rotation_vector(vec3_scale(spin, t));
        vbss_device_update_motion(&m, filter_time, time_of(i), vec3_add_scaled(from, t, v), &q);
        if (i == 0) {
            assert_true(vec3_norm(m.velocity) == 0.0 && vec3_norm(m.spin) == 0.0);
            assert_false(m.has_velocity);
            continue;
        }
        /* What the times lose to rounding: 2e-12 of 6e-4 s. */
        expect_near(0.0, vec3_distance(v, m.velocity), 1e-8 * vec3_norm(v));
        expect_near(0.0, vec3_distance(spin, m.spin), 1e-8 * vec3_norm(spin));
    }
}

/* The same from a clock that began just now: to rounding. */
static void constant_velocity_is_exact_to_rounding(void **state)
{
    (void)state;
    device_motion m = fresh();
    for (int i = 0; i < 200; i++) {
        double t = i / 1024.0;
        vbss_device_update_motion(&m, filter_time, t, vec3_make(0.25 * t, 0.0, -t), NULL);
        if (i > 0) {
            expect_near(0.25, m.velocity.x, 1e-15);
            expect_near(-1.0, m.velocity.z, 1e-15);
        }
    }
    assert_false(m.has_spin);
}

/* A jump of the velocity is answered by 1 - exp(-t/T). */
static void velocity_filter_is_exponential(void **state)
{
    (void)state;
    device_motion m = fresh();
    double x = 0.0, t = 0.0;
    vbss_device_update_motion(&m, filter_time, t, vec3_zero(), NULL);
    t += 1e-3;
    vbss_device_update_motion(&m, filter_time, t, vec3_zero(), NULL);
    double begin = t;
    for (int i = 0; i < 50; i++) {
        double h = 1e-3 + 5e-4 * (i % 2);
        t += h;
        x += 0.3 * h;
        vbss_device_update_motion(&m, filter_time, t, vec3_make(x, 0.0, 0.0), NULL);
        expect_near(0.3 * (1.0 - vbss_exp(-(t - begin) / filter_time)), m.velocity.x, 1e-11);
    }
}

static void unfiltered_velocity_is_difference(void **state)
{
    (void)state;
    device_motion m = fresh();
    vbss_device_update_motion(&m, 0.0, 0.0, vec3_zero(), NULL);
    vbss_device_update_motion(&m, 0.0, 0.5, vec3_make(1.0, 0.0, 0.0), NULL);
    expect_near(2.0, m.velocity.x, 0.0);
    vbss_device_update_motion(&m, 0.0, 0.75, vec3_make(0.0, 0.0, 0.0), NULL);
    expect_near(-4.0, m.velocity.x, 1e-15);
}

/* Turns by the short way, whatever the sign of the quaternion. */
static void quaternion_sign_does_not_matter(void **state)
{
    (void)state;
    device_motion m = fresh();
    for (int i = 0; i < 20; i++) {
        quat q = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, 2.0 * i / 1024.0));
        if (i % 2 == 1) {
            q = quat_make(-q.w, -q.x, -q.y, -q.z);
        }
        vbss_device_update_motion(&m, filter_time, i / 1024.0, vec3_zero(), &q);
        if (i > 0) {
            expect_near(2.0, m.spin.z, 1e-12);
        }
    }
}

/* The first orientation after many positions is no turn from the identity. */
static void late_first_orientation_is_no_rotation(void **state)
{
    (void)state;
    device_motion m = fresh();
    quat q = vbss_quat_from_rotation_vector(vec3_make(1.0, 0.0, 0.0));
    vbss_device_update_motion(&m, filter_time, 0.0, vec3_zero(), NULL);
    vbss_device_update_motion(&m, filter_time, 0.001, vec3_zero(), &q);
    assert_true(vec3_norm(m.spin) == 0.0);
    vbss_device_update_motion(&m, filter_time, 0.002, vec3_zero(), &q);
    assert_true(vec3_norm(m.spin) == 0.0);
    assert_true(m.has_spin);
}

/* No state that a restore could bring makes a division by zero. */
static void equal_times_are_no_motion(void **state)
{
    (void)state;
    device_motion m = fresh();
    vbss_device_update_motion(&m, filter_time, 1.0, vec3_zero(), NULL);
    vbss_device_update_motion(&m, filter_time, 1.0, vec3_make(1.0, 0.0, 0.0), NULL);
    vbss_device_update_motion(&m, filter_time, 0.5, vec3_make(2.0, 0.0, 0.0), NULL);
    assert_true(m.velocity.x == 0.0);
}

int test_motion(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constant_velocity_from_second_sample),
        cmocka_unit_test(constant_velocity_is_exact_to_rounding),
        cmocka_unit_test(velocity_filter_is_exponential),
        cmocka_unit_test(unfiltered_velocity_is_difference),
        cmocka_unit_test(quaternion_sign_does_not_matter),
        cmocka_unit_test(late_first_orientation_is_no_rotation),
        cmocka_unit_test(equal_times_are_no_motion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
