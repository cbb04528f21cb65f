/* A test that lets each allocation of a scene fail makes and ends it a thousand times. Its large blocks would come from the kernel
 * each time, with a fault for each page: with AddressSanitizer most of such a test's time. */
#include "harness/blocks.h"

#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/context.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define IS_WATCHED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#define IS_WATCHED
#endif
#ifdef IS_WATCHED
#include <sanitizer/asan_interface.h>
#define DELAY ((size_t)1 << 28)
#else
#define DELAY ((size_t)0)
#define ASAN_POISON_MEMORY_REGION(from, size) ((void)(from), (void)(size))
#define ASAN_UNPOISON_MEMORY_REGION(from, size) ((void)(from), (void)(size))
#endif

enum { LINE = 64, SHELVES = 1024, MAX_KEPT = 1 << 29 }; /* more than the delay */

/* One that is kept, noted apart: it is not to be touched itself. */
typedef struct kept {
    struct kept *next;
    unsigned char *block;
    size_t size;
    uint64_t given; /* bytes, when it was given back */
} kept;

/* The longest kept is taken first, and not at once: a look at what was released is to be seen late, too. */
static struct {
    atomic_flag busy;
    kept *first[SHELVES], **end[SHELVES];
    size_t size;
    uint64_t given; /* bytes, ever */
} blocks = {.busy = ATOMIC_FLAG_INIT};

static void lock(void)
{
    while (atomic_flag_test_and_set_explicit(&blocks.busy, memory_order_acquire)) {
    }
}

static void unlock(void)
{
    atomic_flag_clear_explicit(&blocks.busy, memory_order_release);
}

/* Aligned blocks, as the library itself takes them where it runs. */
static vbss_context_config libc(void)
{
    vbss_context_config config;
    vbss_memory_from_libc(&config);
    return config;
}

static size_t shelf_of(size_t size)
{
    return (size_t)((size / LINE * UINT64_C(0x9e3779b97f4a7c15)) >> 54);
}

static void *take_kept(size_t size)
{
    size_t shelf = shelf_of(size);
    kept **link = &blocks.first[shelf];
    while (*link != NULL && (*link)->size != size) {
        link = &(*link)->next;
    }
    kept *found = *link;
    if (found == NULL || blocks.given < found->given + DELAY) {
        return NULL;
    }
    *link = found->next;
    if (found->next == NULL) {
        blocks.end[shelf] = link;
    }
    blocks.size -= size;
    void *block = found->block;
    free(found);
    return block;
}

void *harness_block_take(size_t size)
{
    lock();
    void *block = take_kept(size);
    unlock();
    if (block == NULL) {
        block = libc().allocate(NULL, size, LINE);
    }
    if (block == NULL) {
        abort(); /* the machine is out of memory, not the test */
    }
    ASAN_UNPOISON_MEMORY_REGION(block, size);
    return block;
}

void harness_block_give_back(void *block, size_t size)
{
    kept *note = malloc(sizeof *note);
    size_t shelf = shelf_of(size);
    lock();
    blocks.given += size;
    bool keeps = note != NULL && blocks.size + size <= MAX_KEPT;
    if (keeps) {
        *note = (kept){.block = block, .size = size, .given = blocks.given};
        kept **end = blocks.end[shelf] != NULL ? blocks.end[shelf] : &blocks.first[shelf];
        *end = note;
        blocks.end[shelf] = &note->next;
        blocks.size += size;
        ASAN_POISON_MEMORY_REGION(block, size);
    }
    unlock();
    if (!keeps) {
        free(note);
        libc().deallocate(NULL, block, size, LINE);
    }
}

size_t harness_block_delay(void)
{
    return DELAY;
}

bool harness_block_is_forbidden(const void *block)
{
#ifdef IS_WATCHED
    return __asan_address_is_poisoned(block) != 0;
#else
    (void)block;
    return false;
#endif
}
