/* As test_call_sequences.c, for many more sequences. */
#include "scene/call_sequence.h"

enum { CASES = 2000 };

static void refused_calls_and_restores_leave_no_trace(void **state)
{
    (void)state;
    call_counts counts = {.calls = 0};
    harness_property("call sequences, long", CASES, call_sequence, &counts);
    call_sequence_expect_variety(&counts);
}

int test_call_sequences_long(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(refused_calls_and_restores_leave_no_trace),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
