/* An allocator that remembers what it handed out and fails on demand. */
#include <stdlib.h>
#include <string.h>

#include "harness/blocks.h"
#include "harness/harness.h"

/* The block handed out stands behind a front of one alignment; the list of what is alive is apart,
 * so that a second release is told without a look at memory that is gone. */
#define FRONT 64u
struct harness_block {
    struct harness_block *next;
    unsigned char *start;
    uint64_t size, alignment;
};

static size_t rounded_up(uint64_t size)
{
    return (size_t)(size + FRONT - 1) / FRONT * FRONT;
}

static void *watched_allocate(void *user, uint64_t size, uint64_t alignment)
{
    harness_memory *memory = user;
    memory->calls++;
    bool failing =
        memory->fail_call != 0 && (memory->calls == memory->fail_call ||
                                   (memory->fail_ever_after && memory->calls > memory->fail_call));
    if (failing || alignment > FRONT) {
        memory->failures++;
        return NULL;
    }
    size_t rounded = rounded_up(size);
    struct harness_block *noted = malloc(sizeof *noted);
    unsigned char *start = harness_block_take(FRONT + rounded);
    if (noted == NULL) {
        abort(); /* the machine is out of memory, not the test */
    }
    *noted = (struct harness_block){memory->alive, start, size, alignment};
    memory->alive = noted;
    memory->blocks++;
    memset(start + FRONT, 0xa5, (size_t)size); /* nobody may count on zeros */
    return start + FRONT;
}

static void watched_release(void *user, void *block, uint64_t size, uint64_t alignment)
{
    harness_memory *memory = user;
    struct harness_block **link = &memory->alive;
    while (*link != NULL && (*link)->start + FRONT != block) {
        link = &(*link)->next;
    }
    struct harness_block *found = *link;
    if (found == NULL || found->size != size || found->alignment != alignment) {
        memory->wrong_releases++;
        return;
    }
    *link = found->next;
    memory->blocks--;
    memset(found->start, 0x5a, FRONT + (size_t)size); /* a later read is seen by its value */
    harness_block_give_back(found->start, FRONT + rounded_up(size));
    free(found);
}

vbss_context_config harness_watched_config(harness_memory *memory)
{
    vbss_context_config config;
    memset(memory, 0, sizeof *memory);
    expect_ok(vbss_context_config_init(&config, sizeof config));
    config.allocate = watched_allocate;
    config.deallocate = watched_release;
    config.allocator_user = memory;
    return config;
}

vbss_context *harness_context(harness_memory *memory)
{
    vbss_context_config config = harness_watched_config(memory);
    vbss_context *context;
    expect_ok(vbss_context_create(&config, &context));
    return context;
}

static void assert_all_returned(const harness_memory *memory)
{
    assert_int_equal(memory->blocks, 0);
    assert_int_equal(memory->wrong_releases, 0);
}

void harness_context_end(vbss_context *context, const harness_memory *memory)
{
    expect_ok(vbss_context_destroy(context));
    assert_all_returned(memory);
}

/* One context, one attempt, call number `fail_call` failing; true when nothing failed. */
static bool attempt_with(harness_attempt attempt, void *user, uint64_t fail_call, bool ever_after)
{
    harness_memory memory;
    vbss_context_config config = harness_watched_config(&memory);
    memory.fail_call = fail_call;
    memory.fail_ever_after = ever_after;
    vbss_context *context;
    vbss_result result = vbss_context_create(&config, &context);
    if (result == VBSS_OK) {
        result = attempt(context, user);
        vbss_context_statistics statistics;
        expect_ok(vbss_context_get_statistics(context, &statistics, sizeof statistics));
        assert_int_equal(statistics.objects_alive, 0);
        expect_ok(vbss_context_destroy(context));
    } else {
        assert_null(context);
    }
    assert_all_returned(&memory);
    expect_result(memory.failures > 0 ? VBSS_ERROR_OUT_OF_MEMORY : VBSS_OK, result);
    return memory.failures == 0;
}

void harness_fail_every_allocation(harness_attempt attempt, void *user)
{
    for (int ever_after = 0; ever_after < 2; ever_after++) {
        uint64_t fail_call = 1;
        while (!attempt_with(attempt, user, fail_call, ever_after == 1)) {
            fail_call++;
        }
        /* The context's own block is the first; an attempt that adds none tests nothing. */
        assert_true(fail_call > 2);
    }
}
