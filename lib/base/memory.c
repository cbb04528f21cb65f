/* Memory from the host's allocator or from the C library. */
#include <stdlib.h>
#include <string.h>
#if defined(_WIN32)
#include <malloc.h>
#endif

#include "base/context.h"
#include "base/error.h"
#include "base/memory.h"

/* ---- the C library as the allocator */

static void *libc_allocate(void *user, uint64_t size, uint64_t alignment)
{
    (void)user;
#if defined(_WIN32)
    return _aligned_malloc((size_t)size, (size_t)alignment);
#else
    /* C11 requires a multiple of the alignment. */
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

void vbss_memory_from_libc(vbss_context_config *config)
{
    config->allocate = libc_allocate;
    config->deallocate = libc_release;
}

/* ---- arrays for the rest of the library */

/* Bytes to request. An empty array has a block of one byte and so is never NULL. */
static uint64_t block_bytes(size_t count, size_t size)
{
    return count == 0 || size == 0 ? 1u : (uint64_t)count * size;
}

static void release(vbss_context *context, void *block, uint64_t bytes)
{
    bool outer = vbss_callback_begin(context);
    context->deallocate(context->allocator_user, block, bytes, VBSS_ALIGNMENT);
    vbss_callback_end(context, outer);
}

/* A block with the required alignment, or NULL. */
static void *call_allocator(vbss_context *context, uint64_t bytes)
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
    /* The limit keeps sizes below PTRDIFF_MAX and leaves room to round up to the alignment. */
    if (count > 0 && size > (SIZE_MAX / 4) / count) {
        vbss_fail(context, VBSS_ERROR_OUT_OF_MEMORY, "%s: %llu x %llu bytes are too many", what,
                  (unsigned long long)count, (unsigned long long)size);
        return NULL;
    }
    uint64_t bytes = block_bytes(count, size);
    void *block = call_allocator(context, bytes);
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

uint64_t vbss_bytes_allocated(const vbss_context *context)
{
    return context->bytes_allocated;
}

vbss_result vbss_allocate_arrays(vbss_context *context, const vbss_array *arrays, size_t count,
                                 const char *what)
{
    for (size_t i = 0; i < count; i++) {
        void *block = vbss_allocate(context, arrays[i].count, arrays[i].size, what);
        if (block == NULL) {
            return VBSS_ERROR_OUT_OF_MEMORY;
        }
        memcpy(arrays[i].pointer, &block, sizeof block);
    }
    return VBSS_OK;
}

void vbss_release_arrays(vbss_context *context, const vbss_array *arrays, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        void *block;
        memcpy(&block, arrays[i].pointer, sizeof block);
        vbss_release(context, block, arrays[i].count, arrays[i].size);
    }
}
