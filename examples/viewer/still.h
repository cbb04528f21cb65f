/* Pictures as files. */
#ifndef VBSS_EXAMPLES_VIEWER_STILL_H
#define VBSS_EXAMPLES_VIEWER_STILL_H

#include <stdbool.h>
#include <stdint.h>

/* Rows from the top, red, green and blue, as a PNG; false: no memory, or no file. */
bool still_write(const char *path, const uint8_t *pixels, int width, int height);

#endif
