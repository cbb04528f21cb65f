/* Memory for one step: a pointer that moves through a block allocated beforehand. */
#include "base/base.h"

/* Under AddressSanitizer, memory that is not taken is poison: a pointer kept across a rewind is
 * caught. */
#if defined(__SANITIZE_ADDRESS__)
#define ARENA_POISON 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ARENA_POISON 1
#endif
#endif
#if defined(ARENA_POISON)
#include <sanitizer/asan_interface.h>
#define POISON(block, size) ASAN_POISON_MEMORY_REGION(block, size)
#define UNPOISON(block, size) ASAN_UNPOISON_MEMORY_REGION(block, size)
#else
#define POISON(block, size) ((void)(block), (void)(size))
#define UNPOISON(block, size) ((void)(block), (void)(size))
#endif

size_t vbss_arena_need(size_t count, size_t size)
{
    if (count > 0 && size > (SIZE_MAX / 4) / count) {
        return SIZE_MAX / 4; /* more than any arena has, and sums of it do not wrap */
    }
    return (count * size + VBSS_ALIGNMENT - 1u) / VBSS_ALIGNMENT * VBSS_ALIGNMENT;
}

vbss_result vbss_arena_create(vbss_context *context, vbss_arena *arena, size_t capacity)
{
    unsigned char *block = vbss_allocate(context, capacity, 1, "arena");
    if (block == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    arena->block = block;
    arena->capacity = capacity;
    arena->used = arena->peak = 0;
    POISON(block, capacity);
    return VBSS_OK;
}

void vbss_arena_destroy(vbss_context *context, vbss_arena *arena)
{
    UNPOISON(arena->block, arena->capacity);
    vbss_release(context, arena->block, arena->capacity, 1);
    arena->block = NULL;
    arena->capacity = arena->used = 0;
}

void *vbss_arena_take(vbss_arena *arena, size_t count, size_t size)
{
    size_t need = vbss_arena_need(count, size);
    bool full = need > arena->capacity - arena->used;
    size_t end = arena->used + need;
    if (end > arena->peak) {
        arena->peak = end;
    }
    if (full) {
        return NULL;
    }
    void *taken = arena->block + arena->used;
    arena->used = end;
    UNPOISON(taken, count * size);
    return taken;
}

void vbss_arena_rewind(vbss_arena *arena, size_t mark)
{
    if (mark < arena->used) {
        POISON(arena->block + mark, arena->used - mark);
        arena->used = mark;
    }
}
