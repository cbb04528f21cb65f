/* Samples handed in one by one: what becomes of each part, what is refused, and what is told. */
#include <string.h>

#include "device/rig.h"

static vbss_device_sample sample;

static void begin(device_rig *r)
{
    device_rig_begin(r);
    r->mock_configs[0].measure = NULL;
    r->calibration.jaw_time = r->calibration.jaw_play = 0.0;
    device_rig_open(r, 1);
    expect_ok(vbss_device_sample_init(&sample, sizeof sample));
    sample.valid = VBSS_DEVICE_HAS_POSITION;
}

/* As the next measurement, a millisecond later. */
static void show(device_rig *r)
{
    sample.time += 1e-3;
    expect_ok(vbss_mock_set_sample(r->mocks[0], &sample));
    device_rig_read(r);
}

/* ---- parts */

static void only_valid_signals_are_used(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    sample.position[0] = 0.01;
    sample.orientation[0] = 5.0;
    sample.velocity[0] = sample.jaw = sample.jaw_raw = sample.temperature = (double)NAN;
    sample.buttons = 7;
    sample.tool = 99;
    show(&r);
    assert_int_equal(r.input.valid, VBSS_DEVICE_HAS_POSITION);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    expect_near(0.01, r.input.position[0], 0.0);
    expect_near(1.0, r.input.orientation[0], 0.0);
    assert_int_equal(r.input.buttons, 0);
    assert_int_equal(r.input.tool, VBSS_DEVICE_TOOL_NEEDLE_DRIVER);
    show(&r);
    assert_int_equal(r.input.valid, VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_VELOCITY);
    sample.valid |= VBSS_DEVICE_HAS_ORIENTATION;
    sample.orientation[0] = 1.0;
    show(&r);
    assert_int_equal(r.input.valid & VBSS_DEVICE_HAS_ANGULAR_VELOCITY, 0);
    show(&r);
    assert_int_equal(r.input.valid, DEVICE_POSE_SIGNALS | DEVICE_MOTION_SIGNALS);
    device_rig_end(&r);
}

/* Those of the device come before any estimate, and go to the world as positions do. */
static void device_velocities_are_used(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    r.calibration.axes[0] = 2;
    r.calibration.axes[1] = -1;
    r.calibration.scale = 3.0;
    r.mock_configs[0].measure = NULL;
    device_rig_open(&r, 1);
    expect_ok(vbss_device_sample_init(&sample, sizeof sample));
    sample.valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION |
                   VBSS_DEVICE_HAS_VELOCITY | VBSS_DEVICE_HAS_ANGULAR_VELOCITY;
    for (int i = 0; i < 4; i++) {
        sample.position[0] = 0.01 * i;
        sample.velocity[0] = 0.1;
        sample.velocity[1] = 0.2;
        sample.angular_velocity[1] = 4.0;
        show(&r);
        expect_near(0.6, r.input.velocity[0], 1e-15);
        expect_near(-0.3, r.input.velocity[1], 1e-15);
        expect_near(4.0, r.input.angular_velocity[0], 1e-15);
    }
    device_rig_steps(&r, 10); /* no new sample: stale, and at rest */
    assert_true(r.input.velocity[0] == 0.0 && r.input.angular_velocity[0] == 0.0);
    assert_int_equal(r.input.stale, r.input.valid);
    device_rig_end(&r);
}

static void calibrated_opening_precedes_raw(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    sample.valid |= VBSS_DEVICE_HAS_JAW_RAW;
    sample.jaw_raw = 0.25;
    sample.jaw = 0.75;
    show(&r);
    expect_near(0.25, r.input.jaw, 1e-15);
    assert_true((r.input.valid & VBSS_DEVICE_HAS_JAW) != 0);
    sample.valid |= VBSS_DEVICE_HAS_JAW;
    show(&r);
    expect_near(0.75, r.input.jaw, 1e-15);
    sample.jaw_raw = 1e5; /* then nobody asks whether it is believable */
    sample.jaw = 0.02;
    show(&r);
    expect_near(0.02, r.input.jaw, 1e-15);
    expect_near(1e5, r.input.jaw_raw, 0.0);
    assert_int_equal(r.input.jaw_closed, 1);
    device_rig_end(&r);
}

static void button_changes_are_reported(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    sample.valid |= VBSS_DEVICE_HAS_BUTTONS;
    const uint32_t masks[] = {0, 5, 4, 6, 6};
    uint32_t before = 0;
    for (int i = 0; i < 5; i++) {
        sample.buttons = masks[i];
        show(&r);
        assert_int_equal(r.input.buttons, masks[i]);
        assert_int_equal(r.input.pressed, masks[i] & ~before);
        assert_int_equal(r.input.released, before & ~masks[i]);
        before = masks[i];
    }
    device_rig_end(&r);
}

static void tool_change_is_reported(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    sample.valid |= VBSS_DEVICE_HAS_TOOL;
    sample.tool = VBSS_DEVICE_TOOL_SHEARS;
    show(&r);
    assert_int_equal(r.input.tool, VBSS_DEVICE_TOOL_SHEARS);
    assert_true((r.input.events & VBSS_DEVICE_EVENT_TOOL) != 0);
    show(&r);
    assert_int_equal(r.input.events & VBSS_DEVICE_EVENT_TOOL, 0);
    device_rig_end(&r);
}

/* ---- what is refused, and leaves everything as it was */

static void bad_sample_is_rejected_whole(void **state)
{
    (void)state;
    const struct {
        uint32_t part;
        size_t at;
        double largest;
    } fields[] = {
        {VBSS_DEVICE_HAS_POSITION, offsetof(vbss_device_sample, position) + 8, 1e3},
        {VBSS_DEVICE_HAS_VELOCITY, offsetof(vbss_device_sample, velocity) + 16, 1e3},
        {VBSS_DEVICE_HAS_ANGULAR_VELOCITY, offsetof(vbss_device_sample, angular_velocity), 1e4},
        {VBSS_DEVICE_HAS_JAW_RAW, offsetof(vbss_device_sample, jaw_raw), 1e6},
        {VBSS_DEVICE_HAS_JAW, offsetof(vbss_device_sample, jaw), 1.0},
        {VBSS_DEVICE_HAS_TEMPERATURE, offsetof(vbss_device_sample, temperature), 1e3},
        {0, offsetof(vbss_device_sample, time), 1e9}};
    device_rig r;
    begin(&r);
    for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) {
        const double bad[] = {1.001 * fields[i].largest, harness_bad_numbers[0],
                              harness_bad_numbers[1], harness_bad_numbers[2]};
        for (int k = 0; k < 4; k++) {
            double x = r.input.position[0];
            vbss_device_sample good = sample;
            sample.valid |= VBSS_DEVICE_HAS_POSITION | fields[i].part;
            sample.position[0] = 0.3;
            memcpy((unsigned char *)&sample + fields[i].at, &bad[k], sizeof bad[k]);
            vbss_device_statistics before = device_rig_statistics(&r);
            show(&r);
            vbss_device_statistics after = device_rig_statistics(&r);
            assert_int_equal(after.out_of_range[0] - before.out_of_range[0], k == 0);
            assert_int_equal(after.not_finite[0] - before.not_finite[0], k > 0);
            assert_int_equal(after.accepted[0], before.accepted[0]);
            expect_same_bits(x, r.input.position[0]);
            good.time += 1e-3;
            sample = good;
            show(&r);
        }
    }
    for (size_t i = 0; i + 1 < sizeof fields / sizeof fields[0];
         i++) { /* up to there all is well */
        uint64_t accepted = device_rig_statistics(&r).accepted[0];
        sample.valid |= fields[i].part;
        memcpy((unsigned char *)&sample + fields[i].at, &fields[i].largest, sizeof(double));
        show(&r);
        assert_int_equal(device_rig_statistics(&r).accepted[0], accepted + 1);
    }
    sample.jaw = 0.0;
    sample.valid |= VBSS_DEVICE_HAS_TOOL;
    sample.tool = VBSS_DEVICE_TOOL_NONE;
    uint64_t accepted = device_rig_statistics(&r).accepted[0];
    show(&r);
    assert_int_equal(device_rig_statistics(&r).accepted[0], accepted + 1);
    sample.tool = 3;
    uint64_t before = device_rig_statistics(&r).out_of_range[0];
    show(&r);
    assert_int_equal(device_rig_statistics(&r).out_of_range[0], before + 1);
    device_rig_end(&r);
}

/* Later by less than a microsecond is the same measurement. */
static void equal_time_is_same_sample(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    show(&r);
    sample.position[0] = 0.7;
    sample.time += 5e-7;
    expect_ok(vbss_mock_set_sample(r.mocks[0], &sample));
    device_rig_read(&r);
    expect_near(0.0, r.input.position[0], 0.0);
    assert_int_equal(device_rig_statistics(&r).repeated[0], 1);
    sample.time += 1e-6;
    expect_ok(vbss_mock_set_sample(r.mocks[0], &sample));
    device_rig_read(&r);
    expect_near(0.7, r.input.position[0], 0.0);
    device_rig_end(&r);
}

/* ---- what asks for somebody is in the log, once */

static char reported[8][128];
static int reported_count;

static void keep(void *user, vbss_log_level level, const char *message)
{
    (void)user;
    if (reported_count < 8 && level == VBSS_LOG_WARNING) {
        memcpy(reported[reported_count], message, strlen(message) + 1);
        reported_count++;
    }
}

static void each_change_warns_once(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    expect_ok(vbss_context_destroy(r.context));
    vbss_context_config config = harness_watched_config(&r.memory);
    config.log = keep;
    expect_ok(vbss_context_create(&config, &r.context));
    reported_count = 0;
    device_rig_open(&r, 1);
    device_rig_steps(&r, 5);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_REFUSAL, 5.0, 0.0);
    device_rig_steps(&r, 10);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_STOP, 5.0, 0.0);
    device_rig_steps(&r, 10);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_DISCONNECT, 5.0, 0.0);
    device_rig_steps(&r, 10);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_LATE, 200.0, 0.15);
    device_rig_steps(&r, 105);
    assert_int_equal(reported_count, 5);
    assert_string_equal(reported[0], "mock refuses forces");
    assert_string_equal(reported[1], "mock asks for an emergency stop");
    assert_string_equal(reported[2], "mock is lost: unplugged by a fault of the mock");
    assert_string_equal(reported[3], "mock is back");
    assert_string_equal(reported[4], "mock counts time anew");
    device_rig_end(&r);
}

int test_samples(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_valid_signals_are_used),
        cmocka_unit_test(device_velocities_are_used),
        cmocka_unit_test(calibrated_opening_precedes_raw),
        cmocka_unit_test(button_changes_are_reported),
        cmocka_unit_test(tool_change_is_reported),
        cmocka_unit_test(bad_sample_is_rejected_whole),
        cmocka_unit_test(equal_time_is_same_sample),
        cmocka_unit_test(each_change_warns_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
