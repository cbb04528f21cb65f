/* Mouse, keyboard and gamepad: what their movements make of a pose. */
#include <string.h>

#include "base/error.h"
#include "base/rotation.h"
#include "device/device.h"
#include "harness/harness.h"

static vbss_mapping_config config;
static vbss_device_sample sample;

static int begin(void **state)
{
    (void)state;
    expect_ok(vbss_mapping_config_init(&config, sizeof config));
    expect_ok(vbss_device_sample_init(&sample, sizeof sample));
    return 0;
}

static void expect_position(double x, double y, double z)
{
    expect_near(x, sample.position[0], 1e-15);
    expect_near(y, sample.position[1], 1e-15);
    expect_near(z, sample.position[2], 1e-15);
}

static vec3 turned(void)
{
    const double *q = sample.orientation;
    return vbss_quat_to_rotation_vector(quat_make(q[0], q[1], q[2], q[3]));
}

static void expect_turned(double x, double y, double z)
{
    expect_near(0.0, vec3_distance(vec3_make(x, y, z), turned()), 1e-14);
}

/* ---- mouse */

static void mouse_moves_in_plane_and_wheel_in_depth(void **state)
{
    (void)state;
    const double motion[3] = {30.0, -20.0, 2.0};
    sample.time = 5.0;
    sample.jaw = 0.5;
    expect_ok(vbss_mapping_mouse(&config, motion, 0, 0.01, &sample));
    expect_position(3e-3, -2e-3, -4e-3);
    expect_turned(0.0, 0.0, 0.0);
    expect_near(0.54, sample.jaw, 1e-15);
    expect_near(5.01, sample.time, 1e-15);
    assert_int_equal(sample.valid,
                     VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION | VBSS_DEVICE_HAS_JAW);
    expect_ok(vbss_mapping_mouse(&config, motion, VBSS_MAPPING_MOUSE_CLOSE, 0.1, &sample));
    expect_near(0.14, sample.jaw, 1e-15);
    expect_ok(vbss_mapping_mouse(NULL, motion, VBSS_MAPPING_MOUSE_CLOSE, 10.0, &sample));
    expect_near(0.0, sample.jaw, 0.0);
    expect_position(9e-3, -6e-3, -12e-3);
}

static void mouse_turns_with_button_down(void **state)
{
    (void)state;
    const double right[3] = {100.0, 0.0, 0.0}, up[3] = {0.0, 40.0, 0.0}, roll[3] = {0.0, 0.0, 3.0};
    expect_ok(vbss_mapping_mouse(&config, right, VBSS_MAPPING_MOUSE_TURN, 0.0, &sample));
    expect_turned(0.0, 0.5, 0.0);
    begin(state);
    expect_ok(vbss_mapping_mouse(&config, up, VBSS_MAPPING_MOUSE_TURN, 0.0, &sample));
    expect_turned(-0.2, 0.0, 0.0);
    begin(state);
    expect_ok(vbss_mapping_mouse(&config, roll, VBSS_MAPPING_MOUSE_TURN, 0.0, &sample));
    expect_turned(0.0, 0.0, 0.3);
    expect_position(0.0, 0.0, 0.0);
    begin(state);
    for (int i = 0; i < 1000; i++) { /* stays unit, and adds up */
        const double little[3] = {0.5, 0.0, 0.0};
        expect_ok(vbss_mapping_mouse(&config, little, VBSS_MAPPING_MOUSE_TURN, 0.0, &sample));
    }
    expect_turned(0.0, 2.5, 0.0);
}

/* A camera that looks along x: right is -y, up is z. */
static void mouse_plane_is_screen_plane(void **state)
{
    (void)state;
    const double motion[3] = {10.0, 20.0, 1.0};
    memcpy(config.right, (const double[3]){0.0, -1.0, 0.0}, sizeof config.right);
    memcpy(config.up, (const double[3]){0.0, 0.0, 1.0}, sizeof config.up);
    expect_ok(vbss_mapping_mouse(&config, motion, 0, 0.0, &sample));
    expect_position(2e-3, -1e-3, 2e-3); /* away from the user is along x */
}

static void position_stays_in_box(void **state)
{
    (void)state;
    const double far[3] = {1e6, -1e6, 1e6};
    config.low[1] = -0.03;
    for (int i = 0; i < 3; i++) {
        expect_ok(vbss_mapping_mouse(&config, far, 0, 0.0, &sample));
        expect_position(0.1, -0.03, -0.1);
    }
}

/* ---- keyboard */

static void keys_move_by_steps(void **state)
{
    (void)state;
    const double presses[7] = {1.0, -2.0, 3.0, 0.0, 0.0, 0.0, -4.0};
    sample.jaw = 1.0;
    expect_ok(vbss_mapping_keyboard(&config, presses, 0.001, &sample));
    expect_position(1e-3, -2e-3, 3e-3);
    expect_near(0.6, sample.jaw, 1e-15);
    for (int axis = 0; axis < 3; axis++) {
        double turn[7] = {0.0};
        begin(state);
        turn[3 + axis] = -2.0;
        expect_ok(vbss_mapping_keyboard(&config, turn, 0.001, &sample));
        expect_turned(axis == 0 ? -0.1 : 0.0, axis == 1 ? -0.1 : 0.0, axis == 2 ? -0.1 : 0.0);
    }
}

/* ---- gamepad */

static void gamepad_moves_at_rates(void **state)
{
    (void)state;
    const double axes[6] = {1.0, -1.0, 0.1, 0.0, 7.0, 0.0};
    expect_ok(vbss_mapping_gamepad(&config, axes, 0.3, 0.05, &sample));
    expect_position(5e-3, -5e-3, 0.0); /* 0.1 is in the dead zone */
    expect_turned(0.0, 0.05, 0.0);     /* no faster than full */
    expect_near(0.3, sample.jaw, 0.0);
}

/* From nothing at the edge of the dead zone to all at full deflection, without a jump, by the power. */
static void response_curve_starts_at_dead_zone(void **state)
{
    (void)state;
    for (uint32_t curve = 1; curve <= 4; curve++) {
        double before = 0.0;
        config.pad_curve = curve;
        for (int i = 0; i <= 100; i++) {
            double axes[6] = {-i / 100.0, 0.0, 0.0, 0.0, 0.0, 0.0}, wanted = 1.0;
            double part = vbss_max((i / 100.0 - 0.15) / 0.85, 0.0);
            for (uint32_t k = 0; k < curve; k++) {
                wanted *= part;
            }
            sample.position[0] = 0.0;
            expect_ok(vbss_mapping_gamepad(&config, axes, 1.0, 0.1, &sample));
            expect_near(-0.01 * wanted, sample.position[0], 1e-16);
            assert_true(sample.position[0] <= before);
            before = sample.position[0];
        }
        expect_near(-0.01, before, 1e-16);
    }
}

/* ---- samples of any kind */

static void any_start_orientation_is_continued(void **state)
{
    (void)state;
    const double still[7] = {0.0};
    for (int i = 0; i < 4; i++) {
        memset(sample.orientation, 0, sizeof sample.orientation);
        sample.orientation[i] = 1.0;
        expect_ok(vbss_mapping_keyboard(&config, still, 0.0, &sample));
        expect_near(1.0, sample.orientation[i], 1e-15);
    }
}

static void longer_host_sample_keeps_its_size(void **state)
{
    (void)state;
    const double still[7] = {0.0};
    union {
        vbss_device_sample known;
        unsigned char bytes[224];
    } longer;
    expect_ok(vbss_device_sample_init(&longer.known, sizeof longer));
    expect_ok(vbss_mapping_keyboard(&config, still, 0.0, &longer.known));
    assert_int_equal(longer.known.struct_size, sizeof longer);
}

/* ---- what is refused leaves the sample as it was */

static vbss_result any(int which, const double *motion, double h, vbss_device_sample *s)
{
    return which == 0   ? vbss_mapping_mouse(&config, motion, 1, h, s)
           : which == 1 ? vbss_mapping_keyboard(&config, motion, h, s)
                        : vbss_mapping_gamepad(&config, motion, 0.5, h, s);
}

static void expect_refused(vbss_result wanted, int which, const double *motion, double h)
{
    vbss_device_sample before = sample;
    expect_result(wanted, any(which, motion, h, &sample));
    assert_memory_equal(&before, &sample, sizeof sample);
}

static void bad_numbers_are_rejected_and_change_nothing(void **state)
{
    const int counts[] = {3, 7, 6};
    const double still[7] = {0.0};
    for (int which = 0; which < 3; which++) {
        for (int i = 0; i < counts[which]; i++) {
            for (int k = 0; k < 3; k++) {
                double motion[7] = {0.0};
                motion[i] = harness_bad_numbers[k];
                expect_refused(VBSS_ERROR_NOT_FINITE, which, motion, 0.01);
            }
            double motion[7] = {0.0};
            motion[i] = 2e6;
            expect_refused(VBSS_ERROR_OUT_OF_RANGE, which, motion, 0.01);
        }
        expect_refused(VBSS_ERROR_NULL_ARGUMENT, which, NULL, 0.01);
        expect_refused(VBSS_ERROR_OUT_OF_RANGE, which, still, -0.001);
        expect_refused(VBSS_ERROR_OUT_OF_RANGE, which, still, 11.0);
        expect_refused(VBSS_ERROR_NOT_FINITE, which, still, (double)NAN);
        expect_result(VBSS_ERROR_NULL_ARGUMENT, any(which, still, 0.01, NULL));
        sample.orientation[0] = 0.0; /* no orientation */
        expect_refused(VBSS_ERROR_OUT_OF_RANGE, which, still, 0.01);
        sample.orientation[0] = 1.0;
        sample.position[1] = (double)NAN;
        expect_refused(VBSS_ERROR_NOT_FINITE, which, still, 0.01);
        begin(state);
        expect_result(VBSS_OK, any(which, still, 0.01, &sample));
    }
    const double motion[3] = {0.0};
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_mapping_mouse(&config, motion, 4, 0.0, &sample));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_mapping_gamepad(&config, still, 1.1, 0.0, &sample));
}

static void bad_mappings_are_rejected(void **state)
{
    (void)state;
    const double still[7] = {0.0};
    const vbss_mapping_config good = config;
    for (size_t at = offsetof(vbss_mapping_config, right); at < sizeof good; at += 8) {
        memcpy((unsigned char *)&config + at, &harness_bad_numbers[0], 8);
        expect_refused(VBSS_ERROR_NOT_FINITE, 0, still, 0.0);
        const double huge = 1e200;
        memcpy((unsigned char *)&config + at, &huge, 8);
        expect_refused(VBSS_ERROR_OUT_OF_RANGE, 1, still, 0.0);
        config = good;
    }
    config.up[0] = 0.1; /* not normal */
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, 2, still, 0.0);
    config = good;
    config.pad_curve = 0;
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, 2, still, 0.0);
    config = good;
    config.high[2] = config.low[2] - 1e-3;
    expect_refused(VBSS_ERROR_OUT_OF_RANGE, 2, still, 0.0);
}

/* ---- sizes */

static vbss_result mapping_init(void *c, uint32_t struct_size)
{
    return vbss_mapping_config_init(c, struct_size);
}

static vbss_result use_mapping(vbss_context *context, const void *c)
{
    const double still[3] = {0.0};
    vbss_device_sample s;
    (void)context;
    VBSS_TRY(vbss_device_sample_init(&s, sizeof s));
    return vbss_mapping_mouse(c, still, 0, 0.0, &s);
}

static vbss_result sample_init(void *s, uint32_t struct_size)
{
    return vbss_device_sample_init(s, struct_size);
}

/* As a copy: the call writes into it. */
static vbss_result use_sample(vbss_context *context, const void *s)
{
    const double still[3] = {0.0};
    uint32_t size;
    unsigned char copy[256] = {0};
    (void)context;
    memcpy(&size, s, sizeof size);
    memcpy(copy, s, size < sizeof copy ? size : sizeof size);
    return vbss_mapping_mouse(NULL, still, 0, 0.0, (vbss_device_sample *)(void *)copy);
}

static void size_protocol(void **state)
{
    (void)state;
    static const uint32_t mapping_sizes[] = {192, 0}, sample_sizes[] = {160, 0};
    const harness_config mapping = {mapping_sizes, mapping_init, use_mapping};
    const harness_config handed = {sample_sizes, sample_init, use_sample};
    harness_config_protocol(&mapping);
    harness_config_protocol(&handed);
}

int test_mapping(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(mouse_moves_in_plane_and_wheel_in_depth, begin),
        cmocka_unit_test_setup(mouse_turns_with_button_down, begin),
        cmocka_unit_test_setup(mouse_plane_is_screen_plane, begin),
        cmocka_unit_test_setup(position_stays_in_box, begin),
        cmocka_unit_test_setup(keys_move_by_steps, begin),
        cmocka_unit_test_setup(gamepad_moves_at_rates, begin),
        cmocka_unit_test_setup(response_curve_starts_at_dead_zone, begin),
        cmocka_unit_test_setup(any_start_orientation_is_continued, begin),
        cmocka_unit_test_setup(longer_host_sample_keeps_its_size, begin),
        cmocka_unit_test_setup(bad_numbers_are_rejected_and_change_nothing, begin),
        cmocka_unit_test_setup(bad_mappings_are_rejected, begin),
        cmocka_unit_test_setup(size_protocol, begin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
