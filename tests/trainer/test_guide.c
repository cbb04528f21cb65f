/* The guide finds how an arm stands, however that is, and asks again where a motion tells nothing. What it finds makes a device
 * say where the hand is in the world. */
#include <math.h>
#include <string.h>

#include "harness/harness.h"
#include "trainer/guide.h"

#include <vblast_ss/mock.h>

/* World axes of motions: right, up, toward who trains. */
static const double directions[3][3] = {{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}};

/* The mounting of an arm: its axis i is world axis |axes[i]|. */
typedef struct bench {
    int axes[3];
    guide g;
} bench;

static void to_arm(const bench *b, const double world[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        int axis = b->axes[i];
        out[i] = axis < 0 ? -world[-axis - 1] : world[axis - 1];
    }
}

static void see(bench *b, const double world[3], double raw)
{
    vbss_device_input in;
    memset(&in, 0, sizeof in);
    in.status = VBSS_DEVICE_STATUS_READY;
    to_arm(b, world, in.position);
    in.orientation[0] = 0.8;
    in.orientation[3] = 0.6;
    in.jaw_raw = raw;
    guide_see(&b->g, &in);
}

static const char *move(bench *b, const double direction[3], double length)
{
    double at[3];
    for (int i = 0; i < 3; i++) {
        at[i] = 0.01 * (i + 1) + length * direction[i];
    }
    see(b, at, 0.0);
    return guide_next(&b->g);
}

static void begin(bench *b, int x, int y, int z)
{
    vbss_device_calibration usual;
    const double nowhere[3] = {0.0, 0.0, 0.0};
    *b = (bench){.axes = {x, y, z}};
    expect_ok(vbss_device_calibration_init(&usual, sizeof usual));
    expect_ok(guide_begin(&b->g, true, true, &usual));
    assert_null(move(b, nowhere, 0.0));
}

static void reach(bench *b)
{
    for (int corner = 0; corner < 8; corner++) {
        double at[3];
        for (int i = 0; i < 3; i++) {
            at[i] = (corner >> i & 1) != 0 ? 0.08 : -0.04;
        }
        see(b, at, 0.0);
    }
    assert_null(guide_next(&b->g));
}

static const char *squeeze(bench *b, double raw)
{
    for (int i = 0; i < 500; i++) {
        see(b, directions[0], raw);
    }
    return guide_next(&b->g);
}

static void finish(bench *b)
{
    for (int i = 0; i < 3; i++) {
        assert_null(move(b, directions[i], 0.05));
    }
    assert_int_equal(b->g.step, GUIDE_POINT);
    assert_null(move(b, directions[0], 0.0));
    reach(b);
    assert_null(squeeze(b, 3.1));
    assert_null(squeeze(b, 1.7));
    assert_int_equal(b->g.step, GUIDE_DONE);
}

/* A device with what was found says where the hand is, and that the tool is upright. */
static void expect_world(bench *b)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_mock *mock;
    vbss_device *device;
    vbss_device_adapter adapter;
    vbss_device_config config;
    vbss_device_sample sample;
    vbss_device_input in;
    const double world[3] = {0.02, -0.03, 0.05}, middle[3] = {0.02, 0.02, 0.02};
    guide_centre(&b->g, middle); /* where it is already */
    expect_ok(vbss_mock_create(context, NULL, &mock));
    expect_ok(vbss_device_adapter_init(&adapter, sizeof adapter));
    expect_ok(vbss_mock_get_adapter(mock, &adapter));
    expect_ok(vbss_device_config_init(&config, sizeof config));
    config.calibration = &b->g.found;
    expect_ok(vbss_device_create(context, &adapter, NULL, &config, &device));
    expect_ok(vbss_device_sample_init(&sample, sizeof sample));
    sample.valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION;
    to_arm(b, world, sample.position);
    sample.orientation[0] = 0.8;
    sample.orientation[3] = 0.6;
    sample.time = 1.0;
    expect_ok(vbss_mock_set_sample(mock, &sample));
    expect_ok(vbss_device_read(device, 1.0, &in, sizeof in));
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(in.position[i] - world[i]) < 1e-12);
        assert_true(fabs(in.orientation[i + 1]) < 1e-12);
    }
    harness_context_end(context, &memory);
}

static void every_arm_mounting_is_found(void **state)
{
    (void)state;
    static const int turns[6][3] = {{1, 2, 3}, {2, 3, 1}, {3, 1, 2},
                                    {1, 3, 2}, {3, 2, 1}, {2, 1, 3}};
    for (int k = 0; k < 48; k++) { /* 24 of them mirror */
        const int *t = turns[k / 8];
        bench b;
        begin(&b, (k & 1) != 0 ? -t[0] : t[0], (k & 2) != 0 ? -t[1] : t[1],
              (k & 4) != 0 ? -t[2] : t[2]);
        finish(&b);
        assert_true(fabs(b.g.found.jaw_closed - 3.1) < 1e-9);
        assert_true(fabs(b.g.found.jaw_open - 1.7) < 1e-9);
        expect_world(&b);
    }
}

static void uninformative_motion_is_repeated(void **state)
{
    (void)state;
    bench b;
    const double askew[3] = {1.0, 0.7, 0.0};
    begin(&b, 1, 2, 3);
    assert_non_null(guide_next(&b.g)); /* nothing was seen */
    assert_non_null(move(&b, directions[0], 0.015));
    assert_non_null(move(&b, askew, 0.05));
    assert_int_equal(b.g.step, GUIDE_RIGHT);
    assert_null(move(&b, directions[0], -0.05)); /* an arm that mirrors may say so */
    assert_non_null(move(&b, directions[0], 0.05));
    assert_int_equal(b.g.step, GUIDE_UP);
}

static void small_reach_or_handle_range_is_repeated(void **state)
{
    (void)state;
    bench b;
    begin(&b, 1, 2, 3);
    for (int i = 0; i < 3; i++) {
        assert_null(move(&b, directions[i], 0.05));
    }
    assert_null(move(&b, directions[0], 0.0));
    assert_non_null(move(&b, directions[0], 0.05));
    reach(&b);
    assert_null(squeeze(&b, 1.0));
    assert_non_null(squeeze(&b, 1.04));
    assert_int_equal(b.g.step, GUIDE_OPEN);
    assert_null(squeeze(&b, 1.06));
}

static void only_present_devices_are_calibrated(void **state)
{
    (void)state;
    guide g;
    vbss_device_calibration usual;
    expect_ok(vbss_device_calibration_init(&usual, sizeof usual));
    expect_ok(guide_begin(&g, false, true, &usual));
    assert_int_equal(g.step, GUIDE_CLOSE);
    expect_ok(guide_begin(&g, true, false, &usual));
    assert_int_equal(g.step, GUIDE_REST);
    expect_ok(guide_begin(&g, false, false, &usual));
    assert_int_equal(g.step, GUIDE_DONE);
}

int test_guide(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_arm_mounting_is_found),
        cmocka_unit_test(uninformative_motion_is_repeated),
        cmocka_unit_test(small_reach_or_handle_range_is_repeated),
        cmocka_unit_test(only_present_devices_are_calibrated),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
