/* Pictures, one after the other, to ffmpeg. */
#ifndef VBSS_EXAMPLES_VIEWER_FILM_H
#define VBSS_EXAMPLES_VIEWER_FILM_H

#include <stdbool.h>
#include <stdint.h>
#include <sys/types.h>

typedef struct film {
    int pipe;
    pid_t child;
    int width, height;
} film;

/* False, told on standard error: it cannot be begun. Without a program of that name that is told in the end. */
bool film_begin(film *f, const char *path, int width, int height, int rate);
/* Rows from the top, red, green and blue; false: ffmpeg takes no more. */
bool film_add(const film *f, const uint8_t *pixels);
/* False, told: it did not become a film. */
bool film_end(film *f);

#endif
