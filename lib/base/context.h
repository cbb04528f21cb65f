/* The inside of a context, for context.c, memory.c, message.c and slot.c. */
#ifndef VBSS_BASE_CONTEXT_H
#define VBSS_BASE_CONTEXT_H

#include <stdbool.h>

#include "base/slot.h"

/* First words of a context and of a slot: a handle of the wrong sort is told by them. */
#define VBSS_TAG_CONTEXT 0x43534256u /* "VBSC" */
#define VBSS_TAG_SLOT 0x53534256u    /* "VBSS" */

/* Longest text of an error or message, with its end; longer ones are cut. */
#define VBSS_TEXT_BYTES 256

#define VBSS_SLOTS_PER_BLOCK 64
typedef struct slot_block {
    struct slot_block *older;
    uint32_t used;
    vbss_slot slots[VBSS_SLOTS_PER_BLOCK];
} slot_block;

struct vbss_context {
    uint32_t tag;
    vbss_log_level log_level;
    vbss_allocate_fn allocate;
    vbss_release_fn release;
    void *allocator_user;
    vbss_log_fn log;
    void *log_user;
    bool in_callback;
    uint64_t bytes_allocated, bytes_peak, allocation_count;
    uint64_t objects_alive, last_ordinal;
    slot_block *newest_block;
    vbss_result last_result;
    char last_error[VBSS_TEXT_BYTES];
};

/* memory.c: the allocator of a config that names none. */
void vbss_memory_from_libc(vbss_context_config *config);

/* slot.c, for the end of a context: destroys what is alive, youngest first, and gives back the
 * slots. */
void vbss_slots_release(vbss_context *context);

#endif
