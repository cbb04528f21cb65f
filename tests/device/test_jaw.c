/* The handle's opening: range, filter, play, closed or not, and the sensor that is broken. */
#include "device/device.h"
#include "harness/harness.h"

static vbss_device_calibration range(double closed, double open)
{
    vbss_device_calibration c;
    expect_ok(vbss_device_calibration_init(&c, sizeof c));
    c.jaw_closed = closed;
    c.jaw_open = open;
    c.jaw_play = c.jaw_time = 0.0;
    return c;
}

static void range_may_be_reversed(void **state)
{
    (void)state;
    vbss_device_calibration up = range(1.5, 2.0), down = range(2.0, 1.5);
    for (int i = 0; i <= 8; i++) {
        double raw = 1.5 + 0.0625 * i;
        expect_near(i / 8.0, vbss_device_opening_from_raw(&up, raw), 1e-15);
        expect_near(1.0 - i / 8.0, vbss_device_opening_from_raw(&down, raw), 1e-15);
    }
    expect_near(0.0, vbss_device_opening_from_raw(&up, 1.4), 0.0);
    expect_near(1.0, vbss_device_opening_from_raw(&up, 2.1), 0.0);
}

static void broken_wire_is_rejected(void **state)
{
    (void)state;
    vbss_device_calibration c = range(2.0, 1.0);
    c.jaw_margin = 0.25;
    assert_true(vbss_device_is_plausible_raw(&c, 2.25));
    assert_true(vbss_device_is_plausible_raw(&c, 0.75));
    assert_false(vbss_device_is_plausible_raw(&c, 2.26));
    assert_false(vbss_device_is_plausible_raw(&c, 0.0));
    assert_false(vbss_device_is_plausible_raw(&c, (double)NAN));
}

/* A step from 0 to 1 after n samples: 1 - exp(-n h / T), whatever the steps are. */
static void filter_is_exponential(void **state)
{
    (void)state;
    vbss_device_calibration c = range(0.0, 1.0);
    c.jaw_time = 0.02;
    device_jaw jaw = {.is_known = false};
    vbss_device_update_jaw(&jaw, &c, 0.0, 0.0);
    double time = 0.0;
    for (int i = 0; i < 40; i++) {
        double h = i % 3 == 0 ? 0.004 : 0.001;
        time += h;
        vbss_device_update_jaw(&jaw, &c, 1.0, h);
        expect_near(1.0 - vbss_exp(-time / 0.02), jaw.opening, 1e-14);
    }
}

static void first_sample_is_unfiltered(void **state)
{
    (void)state;
    vbss_device_calibration c = range(0.0, 1.0);
    c.jaw_time = 1.0;
    c.jaw_play = 0.1;
    for (int i = 0; i <= 10; i++) {
        device_jaw jaw = {.is_known = false, .filtered = 7.0};
        vbss_device_update_jaw(&jaw, &c, i / 10.0, 1e-3);
        expect_near(i / 10.0, jaw.opening, 1e-15);
    }
}

/* Noise of one step of the converter each way stays within the play; a movement larger than it comes through. */
static void noise_within_backlash_is_ignored(void **state)
{
    (void)state;
    vbss_device_calibration c = range(0.0, 1.0);
    c.jaw_play = 0.05;
    device_jaw jaw = {.is_known = false};
    vbss_device_update_jaw(&jaw, &c, 0.5, 0.0);
    vbss_device_update_jaw(&jaw, &c, 0.52, 1e-3);
    double rest = jaw.opening;
    for (int i = 0; i < 100; i++) {
        vbss_device_update_jaw(&jaw, &c, 0.52 - (i % 2) * 0.02, 1e-3);
        expect_same_bits(rest, jaw.opening);
    }
    vbss_device_update_jaw(&jaw, &c, 0.6, 1e-3);
    assert_true(jaw.opening > rest + 0.05);
    double open = jaw.opening;
    vbss_device_update_jaw(&jaw, &c, 0.551, 1e-3);
    expect_same_bits(open, jaw.opening);
    vbss_device_update_jaw(&jaw, &c, 0.549, 1e-3);
    assert_true(jaw.opening < open);
}

static void backlash_keeps_range_ends(void **state)
{
    (void)state;
    vbss_device_calibration c = range(0.0, 1.0);
    c.jaw_play = 0.1;
    device_jaw jaw = {.is_known = false};
    vbss_device_update_jaw(&jaw, &c, 0.3, 0.0);
    for (int i = 0; i < 5; i++) {
        vbss_device_update_jaw(&jaw, &c, 1.0, 1e-3);
        expect_near(1.0, jaw.opening, 1e-15);
        vbss_device_update_jaw(&jaw, &c, 0.0, 1e-3);
        expect_near(0.0, jaw.opening, 1e-15);
        assert_true(jaw.is_closed);
    }
}

static void opening_and_closing_thresholds_differ(void **state)
{
    (void)state;
    vbss_device_calibration c = range(0.0, 1.0);
    c.jaw_close_at = 0.2;
    c.jaw_open_at = 0.3;
    const double openings[] = {0.5, 0.25, 0.2, 0.25, 0.29, 0.3, 0.25, 0.21, 0.19};
    const bool closed[] = {false, false, true, true, true, false, false, false, true};
    device_jaw jaw = {.is_known = false};
    for (size_t i = 0; i < sizeof openings / sizeof openings[0]; i++) {
        vbss_device_update_jaw(&jaw, &c, openings[i], 1e-3);
        assert_int_equal(jaw.is_closed, closed[i]);
    }
}

int test_jaw(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(range_may_be_reversed),
        cmocka_unit_test(broken_wire_is_rejected),
        cmocka_unit_test(filter_is_exponential),
        cmocka_unit_test(first_sample_is_unfiltered),
        cmocka_unit_test(noise_within_backlash_is_ignored),
        cmocka_unit_test(backlash_keeps_range_ends),
        cmocka_unit_test(opening_and_closing_thresholds_differ),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
