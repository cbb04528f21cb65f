/* Passes the newest value from one thread to another without locks.
 *
 * There are three copies: the writer owns one, the reader owns one, and each swaps its copy with the
 * third. The struct has only the indices of the copies. */
#ifndef VBSS_BASE_TRIPLE_BUFFER_H
#define VBSS_BASE_TRIPLE_BUFFER_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

/* A flag beside the index of a copy, 0 to 2; chosen. */
#define VBSS_TRIPLE_BUFFER_NEW 4u

typedef struct vbss_triple_buffer {
    _Alignas(64) atomic_uint shared; /* the third copy's index; flag until it is fetched */
    _Alignas(64) uint32_t writer;
    _Alignas(64) uint32_t reader;
} vbss_triple_buffer;

static inline void vbss_triple_buffer_init(vbss_triple_buffer *e)
{
    e->writer = 0;
    e->reader = 1;
    atomic_init(&e->shared, 2u);
}

/* Publishes the writer's copy. The writer then owns another one, with old contents. */
static inline void vbss_triple_buffer_publish(vbss_triple_buffer *e)
{
    unsigned was = atomic_exchange_explicit(&e->shared, e->writer | VBSS_TRIPLE_BUFFER_NEW,
                                            memory_order_acq_rel);
    e->writer = was & 3u;
}

/* Gets the newest value into the reader's copy. Returns false if there is none since the last
 * fetch; the reader then keeps its copy. */
static inline bool vbss_triple_buffer_fetch(vbss_triple_buffer *e)
{
    if ((atomic_load_explicit(&e->shared, memory_order_relaxed) & VBSS_TRIPLE_BUFFER_NEW) == 0) {
        return false;
    }
    unsigned was = atomic_exchange_explicit(&e->shared, e->reader, memory_order_acq_rel);
    e->reader = was & 3u;
    return true;
}

#endif
