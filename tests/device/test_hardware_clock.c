/* The clock and sleep that a system gives to adapters, and what solenoids have of it, in real time. A machine may have others to
 * serve: of what happens often, the shortest are looked at; and only the soak of another system asks. */
#include <stdlib.h>

#include "device/hardware_rig.h"
#include "device/platform.h"

static int longer(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void sort_and_print(double *times, size_t count, const char *what)
{
    qsort(times, count, sizeof times[0], longer);
    print_message("%s: least %.3f, median %.3f, most %.3f ms\n", what, 1e3 * times[0],
                  1e3 * times[count / 2], 1e3 * times[count - 1]);
}

/* Not in the steps of 10 ms and more that a system's clock may have. */
static void sleep_duration_is_accurate(void **state)
{
    (void)state;
    enum { SLEEPS = 51 };
    double slept[SLEEPS];
    for (int i = 0; i < SLEEPS; i++) {
        double begin = vbss_device_time();
        vbss_device_sleep(2e-3);
        slept[i] = vbss_device_time() - begin;
    }
    sort_and_print(slept, SLEEPS, "sleep of 2 ms");
    assert_true(slept[0] >= 1.99e-3 && slept[SLEEPS / 4] < 5e-3);
}

static void servo_thread_turns_solenoids_off_within_10_ms(void **state)
{
    (void)state;
    enum { TIMES = 21 };
    double took[TIMES];
    hardware_rig r;
    hardware_rig_begin(&r, true);
    hardware_rig_open(&r, 1);
    r.commands[0].solenoid = 1;
    for (int i = 0; i < TIMES; i++) {
        double said = 0.0;
        while (!hardware_rig_solenoid(&r, 0)) {
            r.now = said = vbss_device_time();
            expect_ok(vbss_device_read(r.devices[0], r.now, &r.inputs[0], sizeof r.inputs[0]));
            expect_ok(vbss_device_write(r.devices[0], r.now, &r.commands[0], NULL, 0));
            vbss_device_sleep(1e-3);
        }
        while (hardware_rig_solenoid(&r, 0)) { /* to sleep is coarser than this is to be */
        }
        took[i] = vbss_device_time() - said;
    }
    sort_and_print(took, TIMES, "last word to solenoid off");
    assert_true(took[0] < 10e-3);
    hardware_rig_end(&r);
}

int test_hardware_clock(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sleep_duration_is_accurate),
        cmocka_unit_test(servo_thread_turns_solenoids_off_within_10_ms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
