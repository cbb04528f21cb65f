/* Between frames: where positions, orientations, velocities and forces go, and that they come back. */
#include <string.h>

#include "base/check.h"
#include "base/rotation.h"
#include "device/device.h"
#include "harness/harness.h"

static vbss_device_calibration fresh(void)
{
    vbss_device_calibration c;
    expect_ok(vbss_device_calibration_init(&c, sizeof c));
    return c;
}

static void expect_vec3(vec3 wanted, vec3 got, double tolerance)
{
    expect_near(0.0, vec3_distance(wanted, got), tolerance);
}

/* Of equal orientations, whatever the sign. */
static void expect_quat(quat wanted, quat got, double tolerance)
{
    expect_near(1.0, fabs(quat_dot(wanted, got)), tolerance);
}

static void set_rotation(vbss_device_calibration *c, quat q)
{
    mat3 r = quat_to_mat3(q);
    for (int i = 0; i < 9; i++) {
        c->rotation[i] = r.m[i / 3][i % 3];
    }
}

/* ---- one by one */

static void default_is_identity(void **state)
{
    (void)state;
    vbss_device_calibration c = fresh();
    device_frame f = vbss_device_make_frame(&c);
    vec3 p = vec3_make(0.011, -0.02, 0.033);
    quat q = vbss_quat_from_rotation_vector(vec3_make(0.3, -0.4, 0.5));
    expect_vec3(p, vbss_device_position_to_world(&c, &f, p), 0.0);
    expect_vec3(p, vbss_device_velocity_to_world(&c, &f, p), 0.0);
    expect_vec3(p, vbss_device_spin_to_world(&f, p), 0.0);
    expect_vec3(p, vbss_device_force_to_device(&c, &f, p), 0.0);
    expect_vec3(p, vbss_device_torque_to_device(&c, &f, p), 0.0);
    expect_quat(q, vbss_device_orientation_to_world(&f, q), 1e-15);
}

/* A device with y up and z towards the user, in a world with z up and x towards the user. */
static void axes_are_permuted(void **state)
{
    (void)state;
    vbss_device_calibration c = fresh();
    c.axes[0] = 3;
    c.axes[1] = 1;
    c.axes[2] = 2;
    device_frame f = vbss_device_make_frame(&c);
    expect_vec3(vec3_make(3.0, 1.0, 2.0),
                vbss_device_position_to_world(&c, &f, vec3_make(1.0, 2.0, 3.0)), 0.0);
    /* Turned about its y, it turns about the world's z. */
    quat q = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.7, 0.0));
    expect_quat(vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, 0.7)),
                vbss_device_orientation_to_world(&f, q), 1e-15);
    c.axes[1] = -1;
    f = vbss_device_make_frame(&c);
    expect_vec3(vec3_make(3.0, -1.0, 2.0),
                vbss_device_position_to_world(&c, &f, vec3_make(1.0, 2.0, 3.0)), 0.0);
}

/* What is seen in a mirror turns the other way. */
static void mirror_flips_rotation(void **state)
{
    (void)state;
    vbss_device_calibration c = fresh();
    c.axes[0] = -1;
    device_frame f = vbss_device_make_frame(&c);
    assert_true(f.parity == -1.0);
    quat about_x = vbss_quat_from_rotation_vector(vec3_make(0.4, 0.0, 0.0));
    quat about_y = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.4, 0.0));
    expect_quat(about_x, vbss_device_orientation_to_world(&f, about_x), 1e-15);
    expect_quat(quat_conjugate(about_y), vbss_device_orientation_to_world(&f, about_y), 1e-15);
    /* A point fixed to the handle moves as the mirrored orientation says. */
    quat q = vbss_quat_from_rotation_vector(vec3_make(0.3, -0.8, 0.5));
    vec3 x = vec3_make(0.1, 0.2, 0.3);
    vec3 mirrored = vbss_device_position_to_world(&c, &f, quat_rotate(q, x));
    vec3 image = vbss_device_position_to_world(&c, &f, x);
    expect_vec3(mirrored, quat_rotate(vbss_device_orientation_to_world(&f, q), image), 1e-15);
}

static void rest_orientation_maps_to_mounted_tool(void **state)
{
    (void)state;
    vbss_device_calibration c = fresh();
    set_rotation(&c, vbss_quat_from_rotation_vector(vec3_make(0.2, 0.9, -0.4)));
    quat mount = vbss_quat_from_rotation_vector(vec3_make(1.0, 0.1, 0.0));
    const double twice[4] = {2.0 * mount.w, 2.0 * mount.x, 2.0 * mount.y, 2.0 * mount.z};
    memcpy(c.mount, twice, sizeof twice);
    device_frame f = vbss_device_make_frame(&c);
    expect_quat(mount, vbss_device_orientation_to_world(&f, quat_identity()), 1e-15);
}

static void workspace_clamps_position(void **state)
{
    (void)state;
    vbss_device_calibration c = fresh();
    c.workspace_low[1] = -0.02;
    c.workspace_high[2] = 0.01;
    vec3 p = vec3_make(0.5, -0.03, 0.02);
    assert_int_equal(vbss_device_clamp_to_workspace(&c, &p), 6);
    expect_vec3(vec3_make(0.5, -0.02, 0.01), p, 0.0);
    assert_int_equal(vbss_device_clamp_to_workspace(&c, &p), 0); /* on the wall is inside */
}

/* ---- there and back, for any calibration */

static vbss_device_calibration any(harness_source *source)
{
    static const int32_t orders[6][3] = {{1, 2, 3}, {2, 3, 1}, {3, 1, 2},
                                         {1, 3, 2}, {3, 2, 1}, {2, 1, 3}};
    vbss_device_calibration c = fresh();
    uint32_t order = harness_draw_below(source, 6);
    for (int i = 0; i < 3; i++) {
        c.axes[i] = harness_draw_below(source, 2) == 0 ? orders[order][i] : -orders[order][i];
        c.offset[i] = harness_draw_real(source, -0.5, 0.5);
    }
    set_rotation(&c, harness_draw_unit_quat(source));
    c.scale = harness_draw_real(source, 0.1, 10.0);
    c.force_scale = harness_draw_real(source, 0.1, 10.0);
    quat q = harness_draw_unit_quat(source);
    c.mount[0] = q.w;
    vec3_store(c.mount + 1, vec3_make(q.x, q.y, q.z));
    return c;
}

/* Work and power of the world are those of the device times scale over force_scale. */
static void power_agrees(harness_source *source, void *user)
{
    (void)user;
    vbss_device_calibration c = any(source);
    expect_ok(vbss_device_check_calibration(NULL, &c));
    device_frame f = vbss_device_make_frame(&c);
    vec3 v = harness_draw_vec3(source, -1.0, 1.0), force = harness_draw_vec3(source, -3.0, 3.0);
    double world = vec3_dot(vbss_device_velocity_to_world(&c, &f, v), force);
    double device = vec3_dot(v, vbss_device_force_to_device(&c, &f, force));
    expect_near(world / c.scale, device / c.force_scale, 1e-14);
    double turning = vec3_dot(vbss_device_spin_to_world(&f, v), force);
    expect_near(turning, vec3_dot(v, vbss_device_torque_to_device(&c, &f, force)) / c.force_scale,
                1e-14);
}

/* The way of the spin: orientations a moment apart. */
static void spins_agree_with_orientations(harness_source *source, void *user)
{
    (void)user;
    vbss_device_calibration c = any(source);
    device_frame f = vbss_device_make_frame(&c);
    quat q = harness_draw_unit_quat(source);
    vec3 spin = harness_draw_vec3(source, -1.0, 1.0);
    const double h = 1e-3;
    quat before = vbss_device_orientation_to_world(&f, q);
    quat after = vbss_device_orientation_to_world(&f, vbss_quat_integrate(q, spin, h));
    vec3 seen = vbss_quat_to_rotation_vector(quat_mul(after, quat_conjugate(before)));
    expect_vec3(vbss_device_spin_to_world(&f, spin), vec3_scale(seen, 1.0 / h), 1e-11);
}

static void positions_come_back(harness_source *source, void *user)
{
    (void)user;
    vbss_device_calibration c = any(source);
    device_frame f = vbss_device_make_frame(&c);
    vec3 p = harness_draw_vec3(source, -0.2, 0.2);
    vec3 world = vbss_device_position_to_world(&c, &f, p);
    vec3 back = mat3_transpose_mul_vec3(f.rotation, vec3_sub(world, vec3_load(c.offset)));
    expect_vec3(p, vec3_scale(back, 1.0 / c.scale), 1e-13);
}

static void calibration_round_trip(void **state)
{
    (void)state;
    harness_property("power_agrees", 2000, power_agrees, NULL);
    harness_property("spins_agree", 2000, spins_agree_with_orientations, NULL);
    harness_property("positions_come_back", 2000, positions_come_back, NULL);
}

/* A rotation typed in with six digits is made right before it is used. */
static void nearly_unit_rotation_is_normalised(void **state)
{
    (void)state;
    vbss_device_calibration c = fresh();
    set_rotation(&c, vbss_quat_from_rotation_vector(vec3_make(0.2, 0.9, -0.4)));
    for (int i = 0; i < 9; i++) {
        c.rotation[i] = floor(c.rotation[i] * 1e7) / 1e7;
    }
    expect_ok(vbss_device_check_calibration(NULL, &c));
    device_frame f = vbss_device_make_frame(&c);
    mat3 off = mat3_sub(mat3_mul(f.rotation, mat3_transpose(f.rotation)), mat3_identity());
    expect_near(0.0, vbss_max_abs(&off.m[0][0], 9), 1e-15);
}

/* ---- what is none */

static void expect_refused(vbss_result wanted, const vbss_device_calibration *c)
{
    expect_result(wanted, vbss_device_check_calibration(NULL, c));
}

static void invalid_calibration_is_rejected(void **state)
{
    (void)state;
    vbss_device_calibration c = fresh();
    const int32_t axes[][3] = {{1, 1, 3}, {0, 1, 2}, {1, 2, 4}, {INT32_MIN, 2, 3}, {1, -1, 2}};
    for (size_t i = 0; i < sizeof axes / sizeof axes[0]; i++) {
        c = fresh();
        memcpy(c.axes, axes[i], sizeof axes[i]);
        expect_refused(VBSS_ERROR_OUT_OF_RANGE, &c);
    }
    c = fresh();
    c.rotation[0] = -1.0; /* a mirror is no rotation */
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, &c);
    c = fresh();
    c.rotation[4] = 1.0 + 1e-5;
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, &c);
    c = fresh();
    c.rotation[1] = 1e-5;
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, &c);
    c = fresh();
    memset(c.mount, 0, sizeof c.mount);
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, &c);
    c = fresh();
    c.workspace_high[1] = -2.0;
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, &c);
    c = fresh();
    c.jaw_open = c.jaw_closed = 1.5;
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, &c);
    c = fresh();
    c.jaw_open_at = 0.04; /* below jaw_close_at */
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, &c);
}

static void every_bad_number_is_rejected(void **state)
{
    (void)state;
    const vbss_device_calibration good = fresh();
    size_t first = offsetof(vbss_device_calibration, rotation);
    for (size_t at = first; at < sizeof good; at += sizeof(double)) {
        for (int i = 0; i < 3; i++) {
            vbss_device_calibration c = good;
            memcpy((unsigned char *)&c + at, &harness_bad_numbers[i], sizeof(double));
            expect_refused(VBSS_ERROR_NOT_FINITE, &c);
        }
        vbss_device_calibration c = good;
        const double huge = 1e200;
        memcpy((unsigned char *)&c + at, &huge, sizeof huge);
        expect_refused(VBSS_ERROR_OUT_OF_RANGE, &c);
    }
}

int test_calibration(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(default_is_identity),
        cmocka_unit_test(axes_are_permuted),
        cmocka_unit_test(mirror_flips_rotation),
        cmocka_unit_test(rest_orientation_maps_to_mounted_tool),
        cmocka_unit_test(workspace_clamps_position),
        harness_test(calibration_round_trip),
        cmocka_unit_test(nearly_unit_rotation_is_normalised),
        cmocka_unit_test(invalid_calibration_is_rejected),
        cmocka_unit_test(every_bad_number_is_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
