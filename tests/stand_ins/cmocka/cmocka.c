#include <cmocka.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static jmp_buf end_of_test;
static bool testing;

void print_message(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
}

void print_error(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
}

void _fail(const char *file, int line)
{
    print_error("%s:%d: failed\n", file, line);
    if (!testing) {
        exit(1);
    }
    longjmp(end_of_test, 1);
}

void stand_in_assert(int good, const char *said, const char *file, int line)
{
    if (good == 0) {
        print_error("%s\n", said);
        _fail(file, line);
    }
}

void stand_in_assert_equal(unsigned long long a, unsigned long long b, const char *said,
                           const char *file, int line)
{
    if (a != b) {
        print_error("%s: %lld, %lld\n", said, (long long)a, (long long)b);
        _fail(file, line);
    }
}

void stand_in_assert_same_text(const char *a, const char *b, const char *file, int line)
{
    if (strcmp(a, b) != 0) {
        print_error("'%s' is not '%s'\n", a, b);
        _fail(file, line);
    }
}

static bool passes(const struct CMUnitTest *test)
{
    void *state = test->initial_state;
    volatile bool good = test->setup_func == NULL || test->setup_func(&state) == 0;
    testing = true;
    if (good && setjmp(end_of_test) == 0) {
        test->test_func(&state);
    } else {
        good = false;
    }
    testing = false;
    return (test->teardown_func == NULL || test->teardown_func(&state) == 0) && good;
}

int stand_in_run_group(const char *name, const struct CMUnitTest *tests, size_t count)
{
    int failed = 0;
    for (size_t i = 0; i < count; i++) {
        bool good = passes(&tests[i]);
        failed += !good;
        print_message("[ %s ] %s\n", good ? "passed" : "FAILED", tests[i].name);
        fflush(stdout);
    }
    print_message("%s: %d of %d failed\n", name, failed, (int)count);
    return failed;
}
