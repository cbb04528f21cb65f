/* Pictures side by side. */
#ifndef VBSS_EXAMPLES_PANELS_H
#define VBSS_EXAMPLES_PANELS_H

#include "painter/painter.h"

#include <stdbool.h>

/* Copies panel `index` of `count` into a strip of them, a white seam before it. */
void panels_put(const uint8_t *panel, int width, int height, size_t index, size_t count,
                uint8_t *strip);
/* A drawing from the painter's, in the files <path>.0, <path>.1 ... of that width and height, which are removed. */
bool panels_join(const char *path, int width, int height, size_t count);

#endif
