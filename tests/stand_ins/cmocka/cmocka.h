/* A stand-in for cmocka where there is no package of it: as much as the tests that are built there use. */
#ifndef VBSS_TESTS_STAND_INS_CMOCKA_H
#define VBSS_TESTS_STAND_INS_CMOCKA_H

#include <stddef.h>

typedef void (*CMUnitTestFunction)(void **state);
typedef int (*CMFixtureFunction)(void **state);

struct CMUnitTest {
    const char *name;
    CMUnitTestFunction test_func;
    CMFixtureFunction setup_func, teardown_func; /* NULL: none */
    void *initial_state;
};

#define cmocka_unit_test(test)        \
    {                                 \
#test, test, NULL, NULL, NULL \
    }
#define cmocka_unit_test_setup(test, setup) \
    {                                       \
#test, test, setup, NULL, NULL      \
    }
#define cmocka_unit_test_teardown(test, teardown) \
    {                                             \
#test, test, NULL, teardown, NULL         \
    }
/* A group has no fixtures of its own. */
#define cmocka_run_group_tests(tests, none, none_either) \
    stand_in_run_group(#tests, (tests), sizeof(tests) / sizeof(tests)[0])
int stand_in_run_group(const char *name, const struct CMUnitTest *tests, size_t count);

void print_message(const char *format, ...);
void print_error(const char *format, ...);
/* Ends the test; outside of one, the process. */
_Noreturn void _fail(const char *file, int line);
#define fail_msg(...)              \
    do {                           \
        print_error(__VA_ARGS__);  \
        print_error("\n");         \
        _fail(__FILE__, __LINE__); \
    } while (0)

void stand_in_assert(int good, const char *said, const char *file, int line);
#define stand_in_assert_that(condition, said) \
    stand_in_assert((condition) ? 1 : 0, said, __FILE__, __LINE__)
#define assert_true(c) stand_in_assert_that(c, #c)
#define assert_false(c) stand_in_assert_that(!(c), "not " #c)
#define assert_null(p) stand_in_assert_that((p) == NULL, #p " == NULL")
#define assert_non_null(p) stand_in_assert_that((p) != NULL, #p " != NULL")
#define assert_ptr_equal(a, b) stand_in_assert_that((a) == (b), #a " == " #b)

void stand_in_assert_equal(unsigned long long a, unsigned long long b, const char *said,
                           const char *file, int line);
#define assert_int_equal(a, b)                                                            \
    stand_in_assert_equal((unsigned long long)(a), (unsigned long long)(b), #a " == " #b, \
                          __FILE__, __LINE__)
void stand_in_assert_same_text(const char *a, const char *b, const char *file, int line);
#define assert_string_equal(a, b) stand_in_assert_same_text((a), (b), __FILE__, __LINE__)
#define assert_memory_equal(a, b, size) \
    stand_in_assert_that(memcmp((a), (b), (size)) == 0, #a " as " #b)

#endif
