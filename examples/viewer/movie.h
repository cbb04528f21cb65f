/* Pictures, one after the other, to ffmpeg. */
#ifndef VBSS_EXAMPLES_VIEWER_MOVIE_H
#define VBSS_EXAMPLES_VIEWER_MOVIE_H

#include <stdbool.h>
#include <stdint.h>
#include <sys/types.h>

typedef struct movie {
    int pipe;
    pid_t child;
    int width, height;
} movie;

/* Whether there is a program of the name ffmpeg. */
bool movie_possible(void);
/* False, told on standard error: it cannot be begun. Without a program of that name that is told in the end. */
bool movie_begin(movie *f, const char *path, int width, int height, int rate);
/* Rows from the top, red, green and blue; false: ffmpeg takes no more. */
bool movie_add(const movie *f, const uint8_t *pixels);
/* False, told: it did not become a film. */
bool movie_end(movie *f);

#endif
