/* OpenGL 3.3 without a window: EGL on no surface, as Mesa has it. */
#ifndef VBSS_EXAMPLES_VIEWER_HEADLESS_H
#define VBSS_EXAMPLES_VIEWER_HEADLESS_H

#include <stdbool.h>

typedef struct headless {
    void *display, *context;
} headless;

/* False, told on standard error: there is no such thing here. */
bool headless_begin(headless *h);
void headless_end(headless *h);

#endif
