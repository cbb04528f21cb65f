/* Real threads: a servo at 1 kHz and a thread for the lines beside the host's. What is shared is the newest of each. */
#include "base/triple_buffer.h"
#include "device/hardware_rig.h"
#include "device/platform.h"

static void host_step(hardware_rig *r, int i)
{
    expect_ok(vbss_device_read(r->devices[i], r->now, &r->inputs[i], sizeof r->inputs[i]));
    expect_ok(vbss_device_write_coupled(r->devices[i], r->now, &r->commands[i], &r->couplings[i],
                                        NULL, 0));
}

/* Nothing is asked about times: the machine may have others to serve. */
static void servo_lines_and_host_share_only_newest_value(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_openhaptics_status arm;
    vbss_nidaqmx_status lines;
    hardware_rig_begin(&r, true);
    hardware_rig_open(&r, 2);
    r.daq->forbid_this_thread(1);
    double begin = vbss_device_time();
    for (int k = 0; k < 400; k++) {
        r.now = vbss_device_time() - begin;
        for (int i = 0; i < 2; i++) {
            r.couplings[i].stiffness = 100.0;
            r.couplings[i].position[0] = 0.002;
            r.commands[i].solenoid = k / 50 % 2 == 0;
            host_step(&r, i);
        }
        vbss_device_sleep(1e-3);
    }
    expect_ok(vbss_openhaptics_get_status(r.openhaptics, 1, &arm, sizeof arm));
    expect_ok(vbss_nidaqmx_get_status(r.nidaqmx, &lines, sizeof lines));
    assert_true(arm.ticks > 50 && arm.orders > 20 && arm.errors == 0);
    assert_true(lines.cycles > 20 && lines.failed_reads == 0 && lines.failed_writes == 0);
    assert_true(fabs(r.inputs[0].jaw_raw - 0.5) < 0.01);
    r.daq->forbid_this_thread(0); /* the end may wait */
    hardware_rig_end(&r);
}

/* ---- the exchange alone: what is read is one value as it was written, and never an older one */

enum { VALUES = 200000 };

typedef struct shared {
    vbss_triple_buffer exchange;
    uint64_t copies[3][8];
} shared;

static void write_values(void *user)
{
    shared *s = user;
    for (uint64_t k = 1; k <= VALUES; k++) {
        uint64_t *copy = s->copies[s->exchange.writer];
        for (int i = 0; i < 8; i++) {
            copy[i] = k * (uint64_t)(i + 1);
        }
        vbss_triple_buffer_publish(&s->exchange);
    }
}

static void newest_value_is_whole_and_monotonic(void **state)
{
    (void)state;
    static shared s;
    device_thread writer = {.run = write_values, .user = &s};
    uint64_t last = 0;
    vbss_triple_buffer_init(&s.exchange);
    assert_false(vbss_triple_buffer_fetch(&s.exchange));
    assert_true(vbss_device_start_thread(&writer));
    while (last < VALUES) {
        if (vbss_triple_buffer_fetch(&s.exchange)) {
            const uint64_t *copy = s.copies[s.exchange.reader];
            assert_true(copy[0] > last);
            last = copy[0];
            for (int i = 0; i < 8; i++) {
                assert_true(copy[i] == last * (uint64_t)(i + 1));
            }
        }
    }
    vbss_device_join_thread(&writer);
    assert_false(vbss_triple_buffer_fetch(&s.exchange));
}

int test_hardware_threads(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(servo_lines_and_host_share_only_newest_value),
        cmocka_unit_test(newest_value_is_whole_and_monotonic),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
