/* A calibration is read as it was written, to the bit; what is no such file is refused, and changes nothing. */
#include <string.h>

#include "harness/harness.h"
#include "trainer/calibration.h"

#define PATH "trainer_calibration.txt"

static void make(calibration *c)
{
    expect_ok(calibration_init(c));
    c->known[LEFT] = c->known[RIGHT] = true;
    for (int side = 0; side < HANDS; side++) {
        vbss_device_calibration *h = &c->hands[side];
        h->axes[0] = 2;
        h->axes[1] = side == LEFT ? -1 : 1;
        h->axes[2] = -3;
        h->scale = 1.0 / 3.0;
        for (int i = 0; i < 3; i++) {
            h->offset[i] = 0.1 / (i + 7.0);
            h->mount[i + 1] = -1e-17 * i;
            h->workspace_low[i] = -0.07 - side / 9.0;
            h->workspace_high[i] = 0.1 + i / 7.0;
        }
        h->jaw_closed = 0.59570312500000001;
        h->jaw_open = 1.1 + side / 3.0;
    }
}

static void expect_same(const vbss_device_calibration *a, const vbss_device_calibration *b)
{
    assert_memory_equal(a, b, sizeof *a);
}

static void file_round_trip(void **state)
{
    (void)state;
    calibration written, found;
    char why[128];
    make(&written);
    assert_true(calibration_write(&written, PATH));
    expect_ok(calibration_init(&found));
    assert_true(calibration_read(&found, PATH, why, sizeof why));
    for (int side = 0; side < HANDS; side++) {
        assert_true(found.known[side]);
        expect_same(&found.hands[side], &written.hands[side]);
    }
}

static void unknown_hand_stays_unknown(void **state)
{
    (void)state;
    calibration written, found, usual;
    char why[128];
    make(&written);
    written.known[LEFT] = false;
    assert_true(calibration_write(&written, PATH));
    expect_ok(calibration_init(&found));
    expect_ok(calibration_init(&usual));
    assert_true(calibration_read(&found, PATH, why, sizeof why));
    assert_false(found.known[LEFT]);
    assert_true(found.known[RIGHT]);
    expect_same(&found.hands[LEFT], &usual.hands[LEFT]);
}

static void write_text(const char *text)
{
    FILE *file = fopen(PATH, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

#define HEAD "# vblast_ss trainer calibration 1\n"
#define LEFT_HAND                                                             \
    "left.axes 1 -3 2\nleft.scale 1\nleft.offset 0 0 0\nleft.mount 1 0 0 0\n" \
    "left.workspace_low -1 -1 -1\nleft.workspace_high 1 1 1\nleft.jaw_closed_open 0 1\n"

static void invalid_file_is_rejected(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "",
        "not a calibration\n" LEFT_HAND,
        HEAD,
        HEAD "left.scale 1\n",             /* the rest is missing */
        HEAD LEFT_HAND "left.scale 1\n",   /* again */
        HEAD LEFT_HAND "right.scale\n",    /* no number */
        HEAD LEFT_HAND "middle.scale 1\n", /* no such hand */
        HEAD LEFT_HAND "right.weight 1\n", /* no such fact */
        HEAD LEFT_HAND "right.scale 1 2\n",
        HEAD LEFT_HAND "right.scale nan\n",
        HEAD LEFT_HAND "right.scale 0\n",
        HEAD LEFT_HAND "right.axes 1 1 2\n",
        HEAD LEFT_HAND "right.axes 1 2 2.5\n",
        HEAD LEFT_HAND "right.axes 1 2 4\n",
        HEAD LEFT_HAND "right.jaw_closed_open 1 1\n",
        HEAD LEFT_HAND "right.offset 0 0 1e99\n",
        HEAD LEFT_HAND "right.scale 1", /* cut off */
    };
    calibration c, before;
    char why[128];
    expect_ok(calibration_init(&c));
    before = c;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        write_text(texts[i]);
        if (texts[i][0] != '\0' && calibration_read(&c, PATH, why, sizeof why)) {
            fail_msg("text %zu was taken", i);
        }
        assert_memory_equal(&c, &before, sizeof c);
    }
    write_text(HEAD LEFT_HAND);
    assert_true(calibration_read(&c, PATH, why, sizeof why));
    assert_false(calibration_read(&c, "no/such/file", why, sizeof why));
    assert_false(calibration_write(&c, "no/such/folder/file"));
}

int test_calibration_file(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(file_round_trip),
        cmocka_unit_test(unknown_hand_stays_unknown),
        cmocka_unit_test(invalid_file_is_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
