/* Contexts: who owns the memory, who hears the messages, what failed last. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#if defined(_WIN32)
#include <malloc.h>
#endif

#include "base/context.h"

_Static_assert(offsetof(vbss_context_config, struct_size) == 0, "struct_size comes first");
_Static_assert(sizeof(vbss_context_config) == 8 + 5 * sizeof(void *), "no hidden padding");
_Static_assert(sizeof(vbss_context_statistics) == 48, "published size");

/* ---- the C library as allocator */

static void *libc_allocate(void *user, uint64_t size, uint64_t alignment)
{
    (void)user;
#if defined(_WIN32)
    return _aligned_malloc((size_t)size, (size_t)alignment);
#else
    /* C11 wants a multiple of the alignment. */
    uint64_t rounded = (size + alignment - 1u) / alignment * alignment;
    return rounded > SIZE_MAX ? NULL : aligned_alloc((size_t)alignment, (size_t)rounded);
#endif
}

static void libc_release(void *user, void *block, uint64_t size, uint64_t alignment)
{
    (void)user;
    (void)size;
    (void)alignment;
#if defined(_WIN32)
    _aligned_free(block);
#else
    free(block);
#endif
}

/* ---- structs that cross the border, with the sizes of their published versions (numbers, as sizeof
 * grows with the struct) */

static const vbss_context_config config_defaults = {
    .struct_size = (uint32_t)sizeof(vbss_context_config),
    .log_level = VBSS_LOG_WARNING,
};
static const uint32_t config_sizes[] = {8u + 5u * (uint32_t)sizeof(void *), 0};
static const vbss_layout config_layout = {"vbss_context_config", &config_defaults, config_sizes};

static const uint32_t statistics_sizes[] = {48, 0};
static const vbss_layout statistics_layout = {"vbss_context_statistics", NULL, statistics_sizes};

/* ---- life of a context */

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
    bool one_of_two = (own.allocate == NULL) != (own.release == NULL);
    if (one_of_two || own.log_level < VBSS_LOG_NONE || own.log_level > VBSS_LOG_INFO) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    if (own.allocate == NULL) {
        own.allocate = libc_allocate;
        own.release = libc_release;
    }
    vbss_context *made = own.allocate(own.allocator_user, sizeof *made, VBSS_ALIGNMENT);
    if (made == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    if ((uintptr_t)made % VBSS_ALIGNMENT != 0) {
        own.release(own.allocator_user, made, sizeof *made, VBSS_ALIGNMENT);
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->tag = VBSS_TAG_CONTEXT;
    made->log_level = own.log_level;
    made->allocate = own.allocate;
    made->release = own.release;
    made->allocator_user = own.allocator_user;
    made->log = own.log;
    made->log_user = own.log_user;
    made->bytes_allocated = made->bytes_peak = sizeof *made;
    made->allocation_count = 1;
    *context = made;
    vbss_message(made, VBSS_LOG_INFO, "context created by %s", vbss_build_info());
    return VBSS_OK;
}

vbss_result vbss_context_destroy(vbss_context *context)
{
    if (context == NULL) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_context_edit(context));
    if (context->objects_alive > 0) {
        vbss_message(context, VBSS_LOG_WARNING,
                     "context destroyed with %llu objects alive; they are destroyed with it",
                     (unsigned long long)context->objects_alive);
    }
    vbss_slots_release(context);
    context->tag = 0;
    context->release(context->allocator_user, context, sizeof *context, VBSS_ALIGNMENT);
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

/* ---- callbacks and messages */

bool vbss_callback_begin(vbss_context *context)
{
    bool outer = context->in_callback;
    context->in_callback = true;
    return outer;
}

void vbss_callback_end(vbss_context *context, bool outer)
{
    context->in_callback = outer;
}

static void send(vbss_context *context, vbss_log_level level, const char *message)
{
    if (context->log == NULL || level > context->log_level || context->in_callback) {
        return; /* a message about a call made inside a callback could recurse for ever */
    }
    bool outer = vbss_callback_begin(context);
    context->log(context->log_user, level, message);
    vbss_callback_end(context, outer);
}

void vbss_message(vbss_context *context, vbss_log_level level, const char *format, ...)
{
    char message[VBSS_TEXT_BYTES];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    send(context, level, message);
}

static void keep_error(vbss_context *context, vbss_result result, const char *text)
{
    context->last_result = result;
    memcpy(context->last_error, text, VBSS_TEXT_BYTES);
}

vbss_result vbss_fail(vbss_context *context, vbss_result result, const char *format, ...)
{
    if (context != NULL) {
        char text[VBSS_TEXT_BYTES] = {0};
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(text, sizeof text, format, arguments);
        va_end(arguments);
        keep_error(context, result, text);
        send(context, VBSS_LOG_ERROR, text);
        keep_error(context, result, text); /* calls inside the callback may have failed as well */
    }
    return result;
}

/* ---- memory */

/* What the allocator is asked for; an empty array is a block of its own, never NULL. */
static uint64_t block_bytes(size_t count, size_t size)
{
    return count == 0 || size == 0 ? 1u : (uint64_t)count * size;
}

static void release(vbss_context *context, void *block, uint64_t bytes)
{
    bool outer = vbss_callback_begin(context);
    context->release(context->allocator_user, block, bytes, VBSS_ALIGNMENT);
    vbss_callback_end(context, outer);
}

/* A block as the rest of the library expects it, or NULL. */
static void *ask_allocator(vbss_context *context, uint64_t bytes)
{
    bool outer = vbss_callback_begin(context);
    void *block = context->allocate(context->allocator_user, bytes, VBSS_ALIGNMENT);
    vbss_callback_end(context, outer);
    if ((uintptr_t)block % VBSS_ALIGNMENT != 0) {
        release(context, block, bytes);
        return NULL;
    }
    return block;
}

void *vbss_allocate(vbss_context *context, size_t count, size_t size, const char *what)
{
    /* Kept below PTRDIFF_MAX, and by a margin that rounding up to the alignment cannot overflow. */
    if (count > 0 && size > (SIZE_MAX / 4) / count) {
        vbss_fail(context, VBSS_ERROR_OUT_OF_MEMORY, "%s: %llu x %llu bytes are too many", what,
                  (unsigned long long)count, (unsigned long long)size);
        return NULL;
    }
    uint64_t bytes = block_bytes(count, size);
    void *block = ask_allocator(context, bytes);
    if (block == NULL) {
        vbss_fail(context, VBSS_ERROR_OUT_OF_MEMORY, "%s: no memory for %llu bytes", what,
                  (unsigned long long)bytes);
        return NULL;
    }
    memset(block, 0, (size_t)bytes);
    context->allocation_count++;
    context->bytes_allocated += bytes;
    if (context->bytes_allocated > context->bytes_peak) {
        context->bytes_peak = context->bytes_allocated;
    }
    return block;
}

void vbss_release(vbss_context *context, void *block, size_t count, size_t size)
{
    if (block != NULL) {
        uint64_t bytes = block_bytes(count, size);
        context->bytes_allocated -= bytes;
        release(context, block, bytes);
    }
}
