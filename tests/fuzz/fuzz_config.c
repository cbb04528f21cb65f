/* Any bytes as a configuration: what is made from it lives, or a status says why it is not made. The first byte
 * chooses the kind; with its highest bit also the struct's size is any. Memory is short. */
#include <stdlib.h>
#include <string.h>

#include "fuzz/fuzz.h"

enum { ANY_SIZE = 0x80, MEMORY = 8 << 20 };

static void *allocate(void *user, uint64_t size, uint64_t alignment)
{
    uint64_t *left = user;
    if (size > *left) {
        return NULL;
    }
    void *block =
        aligned_alloc((size_t)alignment, (size_t)((size + alignment - 1) / alignment * alignment));
    *left -= block != NULL ? size : 0;
    return block;
}

static void release(void *user, void *block, uint64_t size, uint64_t alignment)
{
    uint64_t *left = user;
    (void)alignment;
    *left += block != NULL ? size : 0;
    free(block);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    vbss_context_config c;
    vbss_context *context;
    uint64_t left = MEMORY;
    if (size == 0) {
        return 0;
    }
    uint8_t kind = (data[0] & 0x7fu) % CONFIG_KINDS;
    uint8_t *config = calloc(1, CONFIG_ROOM);
    MUST(config != NULL);
    uint32_t own = init_config(kind, config);
    memcpy(config, data + 1, size - 1 < own ? size - 1 : own);
    if ((data[0] & ANY_SIZE) == 0) {
        memcpy(config, &own, sizeof own);
    }
    MUST(vbss_context_config_init(&c, sizeof c) == VBSS_OK);
    c.allocate = allocate;
    c.deallocate = release;
    c.allocator_user = &left;
    if (vbss_context_create(&c, &context) == VBSS_OK) {
        try_config(context, kind, config);
        MUST(vbss_context_destroy(context) == VBSS_OK);
    }
    MUST(left == MEMORY); /* nothing was lost */
    free(config);
    return 0;
}
