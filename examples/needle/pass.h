/* One trial: a scene is made, two hands pass the needle, and what came of it is measured. */
#ifndef VBSS_EXAMPLES_NEEDLE_PASS_H
#define VBSS_EXAMPLES_NEEDLE_PASS_H

#include <stdbool.h>

#include "needle/stitch.h"

enum { PASS_STEPS = 40000 }; /* at most, of 1 ms */

typedef struct pass_options {
    uint64_t seed;
    double time_limit;  /* s, simulated */
    const char *log;    /* may be NULL */
    const char *folder; /* for pictures; may be NULL */
    bool verbose;
} pass_options;

/* Index 0: left, 1: right. */
typedef struct pass_outcome {
    bool good;
    const char *state, *why;
    uint32_t punctures, others;
    int tries;      /* to take the needle */
    int again;      /* times that it was drawn back from the left wall */
    double off[2];  /* of the holes from the marks, m; below 0: there is none */
    double wall[2]; /* largest force of a wall on the needle before it enters, N */
    double hole[2]; /* largest of a hole on it, N */
    double hand[2]; /* largest on a hand, N */
    double slid;    /* of the needle in the right jaws, m */
    double out;     /* of the tip beyond the left wall, m */
    double time;    /* simulated, s */
    double *steps;  /* PASS_STEPS: thread CPU time of each, s, ascending in the end */
    uint32_t count;
    vbss_scene_statistics scene;
    bool painted;
} pass_outcome;

vbss_result pass_run(const pass_options *o, pass_outcome *out);

/* again.c. Plays the log back on the same scene: true, to equal hashes. */
bool pass_replay(const pass_options *o);

/* show.c */
bool show_picture(const stitch *t, const char *path, const char *text);

#endif
