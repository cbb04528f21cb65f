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

static bool published(const harness_config *config, uint32_t size)
{
    for (const uint32_t *known = config->sizes; *known != 0; known++) {
        if (*known == size) {
            return true;
        }
    }
    return false;
}

void harness_config_protocol(const harness_config *config)
{
    enum { LARGER = 64 }; /* bytes by which a newer header's struct is longer */
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    uint32_t own = 0;
    for (const uint32_t *known = config->sizes; *known != 0; known++) {
        own = *known;
    }
    uint32_t large = own + LARGER;
    unsigned char *given = malloc(large), *defaults = malloc(large);
    assert_non_null(given);
    assert_non_null(defaults);

    /* init: as many defaults as there is room for, zeros beyond, the caller's size in front */
    expect_result(VBSS_ERROR_NULL_ARGUMENT, config->init(NULL, own));
    expect_ok(config->init(defaults, own));
    assert_int_equal(size_of(defaults), own);
    expect_ok(config->create_and_destroy(context, defaults));
    memset(given, 0xff, large);
    expect_ok(config->init(given, large));
    assert_int_equal(size_of(given), large);
    assert_memory_equal(given + 4, defaults + 4, own - 4);
    for (uint32_t i = own; i < large; i++) {
        assert_int_equal(given[i], 0);
    }

    /* a newer header: fine until it asks for something unknown, wherever that stands */
    expect_ok(config->create_and_destroy(context, given));
    for (uint32_t i = own; i < large; i++) {
        given[i] = 1;
        expect_result(VBSS_ERROR_UNKNOWN_FIELD, config->create_and_destroy(context, given));
        given[i] = 0;
    }

    /* older headers: the published sizes, and nothing between them */
    for (uint32_t size = 0; size < own; size++) {
        vbss_result wanted = published(config, size) ? VBSS_OK : VBSS_ERROR_STRUCT_SIZE;
        expect_result(wanted, config->init(given, size));
        memcpy(given, &size, sizeof size);
        expect_result(wanted, config->create_and_destroy(context, given));
    }
    const uint32_t never[] = {UINT32_MAX, 0xa5a5a5a5u, 4097};
    for (int i = 0; i < 3; i++) {
        memcpy(given, &never[i], sizeof never[i]);
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

static const vbss_kind decoy_kind = {
    "decoy", VBSS_CODE('D', 'C', 'O', 'Y'), 1, destroy_nothing, visit_nothing, NULL};

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
