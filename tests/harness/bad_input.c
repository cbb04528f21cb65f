/* Input no host should give and every library gets. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harness/harness.h"

const double harness_bad_numbers[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};

static uint32_t size_of(const void *config)
{
    uint32_t size;
    memcpy(&size, config, sizeof size);
    return size;
}

void harness_config_protocol(const harness_config *config)
{
    enum { LARGER = 64 }; /* bytes by which a newer header's struct is longer */
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    uint32_t large = config->size + LARGER;
    unsigned char *given = malloc(large), *defaults = malloc(large);
    assert_non_null(given);
    assert_non_null(defaults);

    /* init: as many defaults as there is room for, zeros beyond, the caller's size in front */
    expect_result(VBSS_ERROR_NULL_ARGUMENT, config->init(NULL, config->size));
    expect_result(VBSS_ERROR_STRUCT_SIZE, config->init(given, 0));
    expect_result(VBSS_ERROR_STRUCT_SIZE, config->init(given, config->first_size - 1));
    expect_ok(config->init(defaults, config->size));
    assert_int_equal(size_of(defaults), config->size);
    memset(given, 0xff, large);
    expect_ok(config->init(given, large));
    assert_int_equal(size_of(given), large);
    assert_memory_equal(given + 4, defaults + 4, config->size - 4);
    for (uint32_t i = config->size; i < large; i++) {
        assert_int_equal(given[i], 0);
    }

    /* create: the same struct in every size */
    expect_ok(config->create_and_destroy(context, given)); /* newer header, nothing unknown set */
    given[config->size + 1] = 1;
    expect_result(VBSS_ERROR_UNKNOWN_FIELD, config->create_and_destroy(context, given));
    expect_ok(config->create_and_destroy(context, defaults));
    memset(given, 0xff, large);
    expect_ok(config->init(given, config->first_size));
    expect_ok(config->create_and_destroy(context, given)); /* oldest header */
    for (uint32_t size = 0; size < config->first_size; size += 4) {
        memcpy(given, &size, sizeof size);
        expect_result(VBSS_ERROR_STRUCT_SIZE, config->create_and_destroy(context, given));
    }

    free(defaults);
    free(given);
    harness_context_end(context, &memory);
}

/* An object of no use but to be of another type. */
static void destroy_nothing(vbss_context *context, void *object)
{
    (void)context;
    (void)object;
}

static void visit_nothing(vbss_stream *stream, void *object)
{
    (void)stream;
    (void)object;
}

static const vbss_kind decoy_kind = {"decoy", VBSS_CODE('D', 'C', 'O', 'Y'), 1, destroy_nothing,
                                     visit_nothing};

void harness_refuses_bad_handles(vbss_context *context, void *destroyed,
                                 const harness_handle_call *calls, size_t count)
{
    vbss_slot *decoy;
    expect_ok(vbss_slot_create(context, &decoy_kind, NULL, &decoy));
    for (size_t i = 0; i < count; i++) {
        const char *text;
        expect_result(VBSS_ERROR_INVALID_HANDLE, calls[i](NULL));
        expect_result(VBSS_ERROR_INVALID_HANDLE, calls[i](context));
        expect_result(VBSS_ERROR_INVALID_HANDLE, calls[i](decoy));
        expect_ok(vbss_context_get_last_error(context, NULL, &text));
        assert_non_null(strstr(text, "decoy"));
        expect_result(VBSS_ERROR_INVALID_HANDLE, calls[i](destroyed));
        expect_ok(vbss_context_get_last_error(context, NULL, &text));
        assert_non_null(strstr(text, "destroyed"));
    }
    expect_ok(vbss_slot_destroy(decoy, &decoy_kind));
}
