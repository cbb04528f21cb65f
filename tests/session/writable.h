/* The memory behind a view of the library: tests put a state there that no short run reaches. */
#ifndef VBSS_TESTS_SESSION_WRITABLE_H
#define VBSS_TESTS_SESSION_WRITABLE_H

#include <string.h>

static inline void *writable(const void *view)
{
    void *memory;
    memcpy(&memory, &view, sizeof memory);
    return memory;
}

#endif
