/* An exercise of the task: the scene of the scripted surgeon, a session that trains one skill, and the place of the task at
 * which it starts. Trainer, viewer and page share it. */
#ifndef VBSS_EXAMPLES_EXERCISE_PRACTICE_H
#define VBSS_EXAMPLES_EXERCISE_PRACTICE_H

#include "exercise/places.h"
#include "surgeon/task.h"

/* Session of a stitch that was just created, at the place at which the exercise starts. NONE: the whole task.
 * VBSS_ERROR_NOT_FOUND: the states have no such place; other errors: they are of another version of the library. */
vbss_result practice_begin(task *k, const stitch *t, vbss_session_exercise exercise,
                           const start_states *states);
/* Begins its log, before the first step. NULL: no file. */
vbss_result practice_record(const task *k, throw_rig *rig, vbss_session_exercise exercise,
                            const char *log);
/* The same session, which follows a replay that has begun. */
vbss_result practice_follow(task *k, const stitch *t, vbss_session_exercise exercise,
                            vbss_replay *replay);

#endif
