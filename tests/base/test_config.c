#include <string.h>

#include "base/check.h"
#include "base/config.h"
#include "harness/harness.h"

static vbss_result init_context_config(void *config, uint32_t struct_size)
{
    return vbss_context_config_init(config, struct_size);
}

static vbss_result create_context(vbss_context *unused, const void *config)
{
    (void)unused;
    vbss_context *context;
    vbss_result result = vbss_context_create(config, &context);
    if (result == VBSS_OK) {
        result = vbss_context_destroy(context);
    } else {
        assert_null(context);
    }
    return result;
}

static void context_config_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[] = {8 + 5 * sizeof(void *), 0};
    const harness_config config = {sizes, init_context_config, create_context};
    harness_config_protocol(&config);
}

/* A struct whose second version added a field. */
typedef struct sample {
    uint32_t struct_size, kept;
    double added;
} sample;
static const sample sample_defaults = {sizeof(sample), 1, 2.5};
static const uint32_t sample_sizes[] = {8, 16, 0};
static const vbss_layout sample_layout = {"sample", &sample_defaults, sample_sizes};

static void fields_missing_in_old_header_keep_defaults(void **state)
{
    (void)state;
    const struct {
        uint32_t struct_size, kept;
    } old = {8, 7};
    sample own;
    expect_ok(vbss_config_read(NULL, &sample_layout, &old, &own));
    assert_int_equal(own.kept, 7);
    expect_same_bits(2.5, own.added);
    assert_int_equal(own.struct_size, sizeof own);
}

static void rejected_config_keeps_defaults(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    struct {
        sample known;
        double newer;
    } given = {{sizeof given, 9, 9.0}, 1.0};
    sample own;
    const char *text;
    expect_result(VBSS_ERROR_UNKNOWN_FIELD,
                  vbss_config_read(context, &sample_layout, &given, &own));
    expect_ok(vbss_context_get_last_error(context, NULL, &text));
    assert_non_null(strstr(text, "sample"));
    union {
        sample known;
        unsigned char bytes[4096];
    } longest = {{4096, 9, 9.0}};
    sample from_longest;
    expect_ok(vbss_config_read(context, &sample_layout, &longest, &from_longest));
    const uint32_t wrong[] = {0, 4, 7, 9, 12, 15, 4097, UINT32_MAX};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        given.known.struct_size = wrong[i];
        expect_result(VBSS_ERROR_STRUCT_SIZE,
                      vbss_config_read(context, &sample_layout, &given, &own));
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_config_read(context, &sample_layout, NULL, &own));
    assert_int_equal(own.kept, 1);
    expect_same_bits(2.5, own.added);
    harness_context_end(context, &memory);
}

static void output_struct_fills_caller_size(void **state)
{
    (void)state;
    const sample own = {sizeof own, 3, 4.5};
    struct {
        sample known;
        uint64_t newer, beyond;
    } out = {{0, 0, 0}, 1, 2};
    expect_ok(vbss_struct_write(NULL, &sample_layout, &own, &out, sizeof own + 8));
    assert_int_equal(out.known.struct_size, sizeof own);
    expect_same_bits(4.5, out.known.added);
    assert_int_equal(out.newer, 0);
    assert_int_equal(out.beyond, 2);
    memset(&out, 0xff, sizeof out);
    expect_ok(vbss_struct_write(NULL, &sample_layout, &own, &out, 8));
    assert_int_equal(out.known.struct_size, 8);
    assert_int_equal(out.known.kept, 3);
    assert_int_equal(harness_bits(out.known.added), UINT64_MAX);
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_struct_write(NULL, &sample_layout, &own, &out, 7));
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_struct_write(NULL, &sample_layout, &own, &out, 12));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_struct_write(NULL, &sample_layout, &own, NULL, 8));
}

static void out_of_range_field_is_named_in_error(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    const char *text;
    for (int i = 0; i < 3; i++) {
        double values[3] = {1.0, 2.0, harness_bad_numbers[i]};
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_check_finite(context, values, 3, "force"));
        expect_ok(vbss_context_get_last_error(context, NULL, &text));
        assert_non_null(strstr(text, "force[2]"));
        expect_ok(vbss_check_finite(context, values, 2, "force"));
        double first[2] = {harness_bad_numbers[i], 1.0};
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_check_finite(context, first, 2, "force"));
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_check_range(context, values[2], 0, 1, "h"));
    }
    expect_ok(vbss_check_range(context, 0.0, 0.0, 1.0, "h"));
    expect_ok(vbss_check_range(context, 1.0, 0.0, 1.0, "h"));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_check_range(context, -1e-300, 0.0, 1.0, "h"));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_check_range(context, 0x1.0000000000001p0, 0.0, 1.0, "h"));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_check_pointer(context, NULL, "pose"));
    expect_ok(vbss_context_get_last_error(context, NULL, &text));
    assert_string_equal(text, "pose is NULL");
    harness_context_end(context, &memory);
}

int test_config(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(context_config_size_protocol),
        harness_test(fields_missing_in_old_header_keep_defaults),
        harness_test(rejected_config_keeps_defaults),
        harness_test(output_struct_fills_caller_size),
        harness_test(out_of_range_field_is_named_in_error),
    };
    return cmocka_run_group_tests_name("base.config", tests, NULL, NULL);
}
