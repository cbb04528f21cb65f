#include <string.h>

#include "harness/harness.h"

/* The numbers are part of the ABI: written out here, never computed. */
static void result_numbers_are_pinned(void **state)
{
    (void)state;
    assert_int_equal(VBSS_OK, 0);
    assert_int_equal(VBSS_ERROR_NULL_ARGUMENT, -1);
    assert_int_equal(VBSS_ERROR_OUT_OF_RANGE, -2);
    assert_int_equal(VBSS_ERROR_NOT_FINITE, -3);
    assert_int_equal(VBSS_ERROR_STRUCT_SIZE, -4);
    assert_int_equal(VBSS_ERROR_UNKNOWN_FIELD, -5);
    assert_int_equal(VBSS_ERROR_INVALID_HANDLE, -6);
    assert_int_equal(VBSS_ERROR_OUT_OF_MEMORY, -7);
    assert_int_equal(VBSS_ERROR_CAPACITY, -8);
    assert_int_equal(VBSS_ERROR_BUSY, -9);
    assert_int_equal(VBSS_ERROR_ARITHMETIC_MODE, -10);
    assert_int_equal(VBSS_ERROR_TRUNCATED, -11);
    assert_int_equal(VBSS_ERROR_CORRUPT, -12);
    assert_int_equal(VBSS_ERROR_DATA_VERSION, -13);
    assert_int_equal(VBSS_ERROR_IN_SCENE, -14);
    assert_int_equal(VBSS_ERROR_DEVICE, -15);
    assert_int_equal(VBSS_ERROR_CLOCK_STOPPED, -16);
    assert_int_equal(VBSS_ERROR_CLOCK_JUMPED, -17);
    assert_int_equal(VBSS_ERROR_CLOCK_COARSE, -18);
    assert_int_equal(VBSS_ERROR_NOT_FOUND, -19);
    assert_int_equal(VBSS_ERROR_WRONG_STATE, -20);
    assert_int_equal(VBSS_ERROR_INCOMPATIBLE, -21);
    assert_int_equal(VBSS_ERROR_IN_USE, -22);
    assert_int_equal(VBSS_LOG_NONE, 0);
    assert_int_equal(VBSS_LOG_ERROR, 1);
    assert_int_equal(VBSS_LOG_WARNING, 2);
    assert_int_equal(VBSS_LOG_INFO, 3);
}

static void result_names_and_texts_are_unique(void **state)
{
    (void)state;
#define RESULT_NUMBER(name, number, text) number,
    const vbss_result all[] = {VBSS_RESULTS(RESULT_NUMBER)};
    enum { COUNT = sizeof all / sizeof all[0] };
    for (int i = 0; i < COUNT; i++) {
        assert_int_equal(all[i], -i); /* no gaps: a forgotten row is seen */
        assert_memory_equal(vbss_result_name(all[i]), "VBSS_", 5);
        assert_true(strlen(vbss_result_string(all[i])) > 3);
        for (int k = 0; k < i; k++) {
            assert_string_not_equal(vbss_result_string(all[i]), vbss_result_string(all[k]));
        }
    }
    const vbss_result none[] = {1, -COUNT, INT32_MIN, INT32_MAX};
    for (int i = 0; i < 4; i++) {
        assert_string_equal(vbss_result_name(none[i]), "unknown result");
        assert_string_equal(vbss_result_string(none[i]), "unknown result");
    }
}

static void version_and_build_are_reported(void **state)
{
    (void)state;
    assert_int_equal(vbss_version(), VBSS_VERSION_NUM);
    const char *info = vbss_build_info();
    char version[64];
    snprintf(version, sizeof version, "libvblast_ss %d.%d.%d%s (", VBSS_VERSION_MAJOR,
             VBSS_VERSION_MINOR, VBSS_VERSION_PATCH, VBSS_VERSION_SUFFIX);
    assert_non_null(strstr(info, version));
    assert_non_null(strstr(info, "-ffp-contract=off"));
    assert_null(strchr(info, '\n'));
}

int test_result(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(result_numbers_are_pinned),
        harness_test(result_names_and_texts_are_unique),
        harness_test(version_and_build_are_reported),
    };
    return cmocka_run_group_tests_name("base.result", tests, NULL, NULL);
}
