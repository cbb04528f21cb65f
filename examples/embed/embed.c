/* How a host embeds the library: its own memory, its own log, every status looked at.
 *
 * The host here has a fixed budget of memory and wants to know what the library does with it. */
#include <inttypes.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>

#include <vblast_ss/vblast_ss.h>

/* ---- the host's memory: a budget in bytes */

typedef struct budget {
    uint64_t left;
} budget;

static void *budget_allocate(void *user, uint64_t size, uint64_t alignment)
{
    budget *b = user;
    /* aligned_alloc wants a multiple of the alignment. */
    uint64_t rounded = (size + alignment - 1) / alignment * alignment;
    if (size > b->left) {
        return NULL; /* the library answers with a status and stays as it is */
    }
    b->left -= size;
    return aligned_alloc((size_t)alignment, (size_t)rounded);
}

static void budget_release(void *user, void *block, uint64_t size, uint64_t alignment)
{
    budget *b = user;
    (void)alignment;
    b->left += size; /* the size comes back with the block: no bookkeeping of our own */
    free(block);
}

/* ---- the host's log */

static void print_message(void *user, vbss_log_level level, const char *message)
{
    static const char *const names[] = {"", "error", "warning", "info"};
    fprintf((FILE *)user, "  [%s] %s\n", names[level], message);
}

/* ---- */

static vbss_result run(uint64_t bytes)
{
    budget memory = {bytes};
    vbss_context_config config;
    vbss_context *context;
    vbss_context_statistics statistics;

    vbss_result result = vbss_context_config_init(&config, sizeof config);
    if (result != VBSS_OK) {
        return result;
    }
    config.allocate = budget_allocate;
    config.deallocate = budget_release;
    config.allocator_user = &memory;
    config.log = print_message;
    config.log_user = stdout;
    config.log_level = VBSS_LOG_INFO;
    result = vbss_context_create(&config, &context);
    if (result != VBSS_OK) {
        return result;
    }
    result = vbss_context_get_statistics(context, &statistics, sizeof statistics);
    if (result == VBSS_OK) {
        printf("  the context holds %" PRIu64 " bytes, %" PRIu64 " of the budget are left\n",
               statistics.bytes_allocated, memory.left);
    }
    vbss_context_destroy(context);
    return memory.left == bytes ? result : VBSS_ERROR_OUT_OF_RANGE; /* everything came back */
}

int main(void)
{
    (void)setlocale(LC_NUMERIC, "C"); /* numbers with a decimal point */
    printf("headers %d, library %u: %s\n", VBSS_VERSION_NUM, (unsigned)vbss_version(),
           vbss_build_info());
    printf("arithmetic of this thread: %s\n", vbss_result_string(vbss_arithmetic_check()));
    printf("a context in 64 KiB:\n");
    vbss_result enough = run(65536);
    printf("  %s\n", vbss_result_string(enough));
    printf("a context in 64 bytes:\n");
    vbss_result too_little = run(64);
    printf("  %s (%s)\n", vbss_result_string(too_little), vbss_result_name(too_little));
    return enough == VBSS_OK && too_little == VBSS_ERROR_OUT_OF_MEMORY ? 0 : 1;
}
