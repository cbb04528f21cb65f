/* Creation, destruction and queries of a context. */
#include <string.h>

#include "base/api_call.h"
#include "base/config.h"
#include "base/context.h"
#include "base/error.h"
#include "base/memory.h"

_Static_assert(offsetof(vbss_context_config, struct_size) == 0, "struct_size comes first");
_Static_assert(sizeof(vbss_context_config) == 8 + 5 * sizeof(void *), "no hidden padding");
_Static_assert(sizeof(vbss_context_statistics) == 48, "published size");

/* ---- public structs. The published sizes are literal numbers because sizeof grows with the
 * struct. */

static const vbss_context_config config_defaults = {
    .struct_size = (uint32_t)sizeof(vbss_context_config),
    .log_level = VBSS_LOG_WARNING,
};
static const uint32_t config_sizes[] = {8u + 5u * (uint32_t)sizeof(void *), 0};
static const vbss_layout config_layout = {"vbss_context_config", &config_defaults, config_sizes};

static const uint32_t statistics_sizes[] = {48, 0};
static const vbss_layout statistics_layout = {"vbss_context_statistics", NULL, statistics_sizes};

/* ---- creation and destruction */

vbss_result vbss_context_config_init(vbss_context_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

vbss_result vbss_context_create(const vbss_context_config *config, vbss_context **context)
{
    if (context == NULL) {
        return VBSS_ERROR_NULL_ARGUMENT;
    }
    *context = NULL;
    vbss_context_config own = config_defaults;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(NULL, &config_layout, config, &own));
    }
    bool one_of_two = (own.allocate == NULL) != (own.deallocate == NULL);
    if (one_of_two || own.log_level < VBSS_LOG_NONE || own.log_level > VBSS_LOG_INFO) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    if (own.allocate == NULL) {
        vbss_memory_from_libc(&own);
    }
    vbss_context *made = own.allocate(own.allocator_user, sizeof *made, VBSS_ALIGNMENT);
    if (made == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    if ((uintptr_t)made % VBSS_ALIGNMENT != 0) {
        own.deallocate(own.allocator_user, made, sizeof *made, VBSS_ALIGNMENT);
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->tag = VBSS_TAG_CONTEXT;
    made->log_level = own.log_level;
    made->allocate = own.allocate;
    made->deallocate = own.deallocate;
    made->allocator_user = own.allocator_user;
    made->log = own.log;
    made->log_user = own.log_user;
    made->bytes_allocated = made->bytes_peak = sizeof *made;
    made->allocation_count = 1;
    *context = made;
    vbss_message(made, VBSS_LOG_INFO, "context created by libvblast_ss %d.%d.%d%s",
                 VBSS_VERSION_MAJOR, VBSS_VERSION_MINOR, VBSS_VERSION_PATCH, VBSS_VERSION_SUFFIX);
    return VBSS_OK;
}

static vbss_result destroy_members(vbss_context *context)
{
    VBSS_ENTER(context);
    VBSS_TRY(vbss_context_edit(context));
    if (context->objects_alive > 0) {
        vbss_message(context, VBSS_LOG_INFO, "context destroyed together with %llu objects",
                     (unsigned long long)context->objects_alive);
    }
    vbss_slots_release(context);
    context->tag = 0;
    return VBSS_OK;
}

vbss_result vbss_context_destroy(vbss_context *context)
{
    if (context == NULL) {
        return VBSS_OK;
    }
    VBSS_TRY(destroy_members(context));
    context->deallocate(context->allocator_user, context, sizeof *context, VBSS_ALIGNMENT);
    return VBSS_OK;
}

vbss_result vbss_context_open(const vbss_context *context)
{
    return context != NULL && context->tag == VBSS_TAG_CONTEXT ? VBSS_OK
                                                               : VBSS_ERROR_INVALID_HANDLE;
}

vbss_result vbss_context_edit(vbss_context *context)
{
    VBSS_TRY(vbss_context_open(context));
    return context->in_callback
               ? vbss_fail(context, VBSS_ERROR_BUSY, "nothing can be changed inside a callback")
               : VBSS_OK;
}

vbss_result vbss_context_get_last_error(const vbss_context *context, vbss_result *result,
                                        const char **text)
{
    VBSS_ENTER(context);
    VBSS_TRY(vbss_context_open(context));
    if (result != NULL) {
        *result = context->last_result;
    }
    if (text != NULL) {
        *text = context->last_error;
    }
    return VBSS_OK;
}

vbss_result vbss_context_get_statistics(vbss_context *context, vbss_context_statistics *statistics,
                                        uint32_t struct_size)
{
    VBSS_ENTER(context);
    VBSS_TRY(vbss_context_open(context));
    const vbss_context_statistics own = {
        .struct_size = (uint32_t)sizeof own,
        .bytes_allocated = context->bytes_allocated,
        .bytes_peak = context->bytes_peak,
        .allocation_count = context->allocation_count,
        .objects_alive = context->objects_alive,
        .objects_created = context->last_ordinal,
    };
    return vbss_struct_write(context, &statistics_layout, &own, statistics, struct_size);
}
