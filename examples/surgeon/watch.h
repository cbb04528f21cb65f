/* One who watches the surgeon: what is told and painted, and how long the steps take. */
#ifndef VBSS_EXAMPLES_SURGEON_WATCH_H
#define VBSS_EXAMPLES_SURGEON_WATCH_H

#include "surgeon/surgeon.h"
#include "surgeon/task.h"

enum { WATCH_STEPS = 100000 }; /* of 1 ms, at most */

typedef struct watch {
    surgeon_options options;
    task task;          /* beside the scene */
    double most, every; /* s, simulated: at most; between pictures */
    const char *folder; /* for pictures; may be NULL */
    bool verbose;
    int pictures;
    double next;                                    /* picture, s */
    double *times[SURGEON_DONE];                    /* of steps, s, WATCH_STEPS each */
    uint32_t counts[SURGEON_DONE];                  /* of them */
    double left[SURGEON_DONE], right[SURGEON_DONE]; /* most that a hand feels, N */
} watch;

/* From the needle on the floor on. */
vbss_result watch_run(watch *w, surgeon *s);
/* Plays the log back on the same scene, its session too: true, to equal hashes. */
bool watch_replay(const watch *w);
/* What came of it. */
void watch_tell(watch *w, const surgeon *s, vbss_result result);
/* And what its session says of it: phase, measures, events. (tell.c) */
void watch_tell_task(const watch *w);

#endif
