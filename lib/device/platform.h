/* Services of the operating system for adapters of real hardware: libraries loaded at run time
 * (dynamic_library.c) and a thread with a clock (io_thread.c). The simulation uses none of them.
 * WebAssembly (WASI) has neither libraries nor threads: loading and starting fail there. */
#ifndef VBSS_DEVICE_PLATFORM_H
#define VBSS_DEVICE_PLATFORM_H

#if !defined(_WIN32) && !defined(__wasi__)
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
#if defined(_WIN32)
    void *handle;
#elif !defined(__wasi__)
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

#endif
