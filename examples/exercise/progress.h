/* A trainee's progress: a text file with a line for each exercise that was tried.
 *
 *     vblast_ss progress 1
 *     # exercise attempts passed unaided best
 *     take_needle 3 2 1 14.250
 *
 * attempts: ended exercises; passed; passed without an aid; best time of those, s, 0 without one. Lines that begin with # and
 * empty ones are left out. The file is replaced as a whole. A file that is not like this is never written to. */
#ifndef VBSS_EXAMPLES_EXERCISE_PROGRESS_H
#define VBSS_EXAMPLES_EXERCISE_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

#include <vblast_ss/session_exercise.h>

typedef struct progress_row {
    unsigned attempts, passed, unaided;
    double best; /* s */
} progress_row;

typedef struct progress {
    progress_row rows[VBSS_SESSION_EXERCISE_COUNT];
} progress;

/* A file that does not exist is empty. False: the file is wrong, and `why` names the line. */
bool progress_read(progress *p, const char *path, char *why, size_t why_bytes);
bool progress_write(const progress *p, const char *path, char *why, size_t why_bytes);
/* Counts an exercise that has ended. */
void progress_add(progress *p, const vbss_session_exercise_state *state);
/* Reads, counts and writes. A file that is not one of progress stays as it is. */
bool progress_note(const char *path, const vbss_session_exercise_state *state, progress *p,
                   char *why, size_t why_bytes);

#endif
