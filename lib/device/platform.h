/* What the operating system gives to adapters of real hardware: libraries loaded at run time (dynamic_library.c), a
 * thread with a clock (io_thread.c), and what two threads share (here). Nothing of it is known to the simulation. */
#ifndef VBSS_DEVICE_PLATFORM_H
#define VBSS_DEVICE_PLATFORM_H

#include <stdatomic.h>
#ifndef _WIN32
#include <pthread.h>
#endif

#include "device/device.h"

/* ---- dynamic_library.c */

/* A function to look for, and where its address goes. */
typedef struct device_symbol {
    const char *name;
    void *address; /* of a pointer to a function */
} device_symbol;

/* NULL: there is none; `text` says why. */
void *vbss_device_load_library(const char *name, char *text, size_t room);
/* What does not end well when it is unloaded stays in memory; the handle is given back. */
void vbss_device_unload_library(void *library);
/* The first that is not there; NULL: all are. */
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

bool vbss_device_start_thread(device_thread *thread);
void vbss_device_join_thread(device_thread *thread);
void vbss_device_sleep(double seconds);
/* Of any origin, never backwards, s. */
double vbss_device_time(void);

/* ---- the newest value from one thread to another, without waits on either side: of three copies the writer has one,
 * the reader one, and the third is swapped with theirs. Which copy is whose is all that is kept here. */

#define DEVICE_TRIPLE_BUFFER_NEW 4u

typedef struct device_triple_buffer {
    _Alignas(64) atomic_uint shared; /* index, and DEVICE_TRIPLE_BUFFER_NEW until it was taken */
    _Alignas(64) uint32_t writer;
    _Alignas(64) uint32_t reader;
} device_triple_buffer;

static inline void device_triple_buffer_init(device_triple_buffer *e)
{
    e->writer = 0;
    e->reader = 1;
    atomic_init(&e->shared, 2u);
}

/* The writer's copy is the newest from now on; it goes on with another one. */
static inline void device_triple_buffer_publish(device_triple_buffer *e)
{
    unsigned was = atomic_exchange_explicit(&e->shared, e->writer | DEVICE_TRIPLE_BUFFER_NEW,
                                            memory_order_acq_rel);
    e->writer = was & 3u;
}

/* True when the reader's copy is another than before. */
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
