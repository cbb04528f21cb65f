/* Services of the operating system for adapters of real hardware: libraries loaded at run time
 * (dynamic_library.c), a thread with a clock (io_thread.c), and a triple buffer. The simulation
 * uses none of them. */
#ifndef VBSS_DEVICE_PLATFORM_H
#define VBSS_DEVICE_PLATFORM_H

#include <stdatomic.h>
#ifndef _WIN32
#include <pthread.h>
#endif

#include "device/device.h"

/* ---- dynamic_library.c */

/* A function of a library, and where to store its address. */
typedef struct device_symbol {
    const char *name;
    void *address; /* points to a function pointer */
} device_symbol;

enum { DEVICE_LOAD_TEXT_BYTES = 192 };

/* Loads the first of `count` libraries that can be loaded, by path or file name, and stores its name
 * in `loaded`. Returns NULL on failure; `text`, which has room for `room` bytes, then names the
 * libraries that are missing, or the one that a library needs and that is missing. */
void *vbss_device_load_any(const char *const *names, size_t count, const char **loaded, char *text,
                           size_t room);
/* Releases the library, but keeps its code in memory: threads of the vendor may still run it. NULL
 * does nothing. */
void vbss_device_unload_library(void *library);
/* Stores the addresses of all symbols. Returns the name of the first missing one; NULL: none. */
const char *vbss_device_find_symbols(void *library, const device_symbol *symbols, size_t count);

/* ---- io_thread.c */

typedef void (*device_thread_run)(void *user);

typedef struct device_thread {
    device_thread_run run;
    void *user;
#ifdef _WIN32
    void *handle;
#else
    pthread_t handle;
#endif
} device_thread;

/* `thread` must have `run` and `user`, and must stay valid until it is joined. Returns false if no
 * thread could be started. */
bool vbss_device_start_thread(device_thread *thread);
/* Waits for the end of the thread. */
void vbss_device_join_thread(device_thread *thread);
void vbss_device_sleep(double seconds);
/* Monotonic clock with an arbitrary origin, s. */
double vbss_device_time(void);

/* ---- triple buffer
 *
 * Passes the newest value from one thread to another without locks. There are three copies: the
 * writer owns one, the reader owns one, and each swaps its copy with the third. The struct has only
 * the indices of the copies. */

/* A flag beside the index of a copy, 0 to 2; chosen. */
#define DEVICE_TRIPLE_BUFFER_NEW 4u

typedef struct device_triple_buffer {
    _Alignas(64) atomic_uint shared; /* the third copy's index; flag until it is fetched */
    _Alignas(64) uint32_t writer;
    _Alignas(64) uint32_t reader;
} device_triple_buffer;

static inline void device_triple_buffer_init(device_triple_buffer *e)
{
    e->writer = 0;
    e->reader = 1;
    atomic_init(&e->shared, 2u);
}

/* Publishes the writer's copy. The writer then owns another one, with old contents. */
static inline void device_triple_buffer_publish(device_triple_buffer *e)
{
    unsigned was = atomic_exchange_explicit(&e->shared, e->writer | DEVICE_TRIPLE_BUFFER_NEW,
                                            memory_order_acq_rel);
    e->writer = was & 3u;
}

/* Gets the newest value into the reader's copy. Returns false if there is none since the last
 * fetch; the reader then keeps its copy. */
static inline bool device_triple_buffer_fetch(device_triple_buffer *e)
{
    if ((atomic_load_explicit(&e->shared, memory_order_relaxed) & DEVICE_TRIPLE_BUFFER_NEW) == 0) {
        return false;
    }
    unsigned was = atomic_exchange_explicit(&e->shared, e->reader, memory_order_acq_rel);
    e->reader = was & 3u;
    return true;
}

#endif
