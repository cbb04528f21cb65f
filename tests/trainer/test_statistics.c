/* Misses are told apart, histograms have every slot, and the reader gets the newest figures whole. */
#include <pthread.h>

#include "harness/harness.h"
#include "trainer/figures.h"

#define PERIOD 1e-3

static void own_and_machine_deadline_misses_are_separated(void **state)
{
    (void)state;
    figures f = {.slots = 0};
    figures_slot(&f, PERIOD, 0.5e-3, 0.0, 0.6e-3);
    figures_slot(&f, PERIOD, 0.5e-3, 3e-3, 3.5e-3); /* somebody else had the core */
    assert_int_equal(f.wall_misses, 1);
    assert_int_equal(f.our_misses, 0);
    figures_slot(&f, PERIOD, 1.1e-3, 0.0, 1.1e-3);
    assert_int_equal(f.wall_misses, 2);
    assert_int_equal(f.our_misses, 1);
    figures_slot(&f, PERIOD, 1.1e-3, 0.0, 0.0); /* simulated time: there is no wall */
    assert_int_equal(f.wall_misses, 2);
    assert_int_equal(f.our_misses, 2);
    assert_int_equal(f.slots, 4);
}

static void every_period_is_in_a_bin(void **state)
{
    (void)state;
    static const double times[] = {0.0, 9.9e-6, 10.1e-6, 60e-6, 999e-6, 1001e-6, 2.1e-3, 5.0};
    static const uint64_t wanted[BINS] = {2, 1, 0, 1, 0, 0, 1, 1, 2};
    figures f = {.slots = 0};
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        figures_slot(&f, PERIOD, times[i], times[i], 0.0);
    }
    for (int i = 0; i < BINS; i++) {
        assert_int_equal(f.work[i], wanted[i]);
        assert_int_equal(f.late[i], wanted[i]);
    }
    assert_true(f.worst_work == 5.0 && f.worst_late == 5.0);
}

static void events_above_capacity_are_counted(void **state)
{
    (void)state;
    figures f = {.slots = 0};
    for (int i = 0; i < MAX_EVENTS + 3; i++) {
        figures_note(&f, i % 2 == 0, "%d", i);
    }
    assert_int_equal(f.event_count, MAX_EVENTS);
    assert_int_equal(f.events_lost, 3);
    assert_int_equal(f.faults, (MAX_EVENTS + 4) / 2);
    assert_string_equal(f.events[5].text, "5");
}

static void newest_value_is_read(void **state)
{
    (void)state;
    static exchange e;
    static figures f;
    exchange_init(&e);
    assert_int_equal(exchange_take(&e)->slots, 0);
    for (uint64_t n = 1; n < 20; n++) {
        f.slots = n;
        exchange_put(&e, &f);
        if (n % 3 == 0) {
            assert_int_equal(exchange_take(&e)->slots, n);
            assert_int_equal(exchange_take(&e)->slots, n);
        }
    }
}

enum { PUTS = 20000 };

static void *put_many(void *user)
{
    static figures f;
    for (uint64_t n = 1; n <= PUTS; n++) {
        f.slots = n;
        f.our_misses = n;
        exchange_put(user, &f);
    }
    return NULL;
}

static void no_torn_reads(void **state)
{
    (void)state;
    static exchange e;
    pthread_t writer;
    uint64_t last = 0;
    exchange_init(&e);
    assert_int_equal(pthread_create(&writer, NULL, put_many, &e), 0);
    while (last < PUTS) {
        const figures *f = exchange_take(&e);
        assert_true(f->slots >= last); /* never back */
        assert_int_equal(f->slots, f->our_misses);
        last = f->slots;
    }
    assert_int_equal(pthread_join(writer, NULL), 0);
}

int test_statistics(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(own_and_machine_deadline_misses_are_separated),
        cmocka_unit_test(every_period_is_in_a_bin),
        cmocka_unit_test(events_above_capacity_are_counted),
        cmocka_unit_test(newest_value_is_read),
        cmocka_unit_test(no_torn_reads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
