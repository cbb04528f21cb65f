/* The states at which exercises start: made by the scripted surgeon, kept in a file. A state is of one version of the library,
 * so a file that does not fit any more is made once more. */
#ifndef VBSS_EXAMPLES_EXERCISE_STARTS_H
#define VBSS_EXAMPLES_EXERCISE_STARTS_H

#include <stdbool.h>
#include <stddef.h>

#include "exercise/places.h"
#include "ghost/track.h"

/* Takes over the bytes, which were allocated by malloc. False: they are no states; they are freed. */
bool starts_parse(start_states *s, uint8_t *bytes, size_t count);
/* False: the file is wrong, and `why` names the fault. */
bool starts_read(start_states *s, const char *path, char *why, size_t why_bytes);
/* The file is replaced at once, or stays as it is. */
bool starts_write(const start_states *s, const char *path, char *why, size_t why_bytes);
void starts_free(start_states *s);

/* ---- starts_make.c */

/* The surgeon works until three throws are seated, or, with `hands`, until both tails are cut: they become a track of his tools: 90 s of
 * simulated time, which take about as long. `shown`, which may be NULL, receives the time of the task now and then. False: no seed
 * of ten has succeeded. */
bool starts_make(start_states *s, ghost_track *hands, void (*shown)(void *user, double seconds),
                 void *user);

#endif
