/* Fields of a context, private to api_call.c, context.c, memory.c, message.c and
 * slot.c. */
#ifndef VBSS_BASE_CONTEXT_H
#define VBSS_BASE_CONTEXT_H

#include <stdatomic.h>
#include <stdbool.h>

#include "base/float_mode.h"
#include "base/slot.h"

/* First word of a context and of a slot; it reveals a handle of the wrong type. */
#define VBSS_TAG_CONTEXT 0x43534256u /* "VBSC" */
#define VBSS_TAG_SLOT 0x53534256u    /* "VBSS" */

/* Size of an error or log text with its final 0; longer texts are truncated. */
#define VBSS_TEXT_BYTES 256

#define VBSS_SLOTS_PER_BLOCK 64
/* Slots are allocated in blocks, which form a list from newest to oldest. */
typedef struct slot_block {
    struct slot_block *older;
    uint32_t used;
    vbss_slot slots[VBSS_SLOTS_PER_BLOCK];
} slot_block;

struct vbss_context {
    uint32_t tag;
    vbss_log_level log_level;
    vbss_allocate_fn allocate;
    vbss_deallocate_fn deallocate;
    void *allocator_user; /* passed to allocate and release */
    vbss_log_fn log;
    void *log_user; /* passed to log */
    /* The thread inside the context (api_call.c), 0 if there is none. Only that thread uses the
     * other fields. */
    atomic_uintptr_t owner;
    bool in_callback;     /* a function of the host is running */
    bool in_library;      /* the thread inside runs our code, not the host's */
    float_mode host_mode; /* in force while a function of the host runs */
    uint64_t bytes_allocated, bytes_peak, allocation_count;
    /* last_ordinal belongs to the youngest object; 0 before the first */
    uint64_t objects_alive, last_ordinal;
    slot_block *newest_block;
    vbss_result last_result; /* status of the last call that failed */
    char last_error[VBSS_TEXT_BYTES];
};

/* Sets the config's allocator to that of the C library. */
void vbss_memory_from_libc(vbss_context_config *config);

/* Destroys all objects that are alive, youngest first, and frees all slots. Only the destruction of
 * a context calls this. */
void vbss_slots_release(vbss_context *context);

#endif
