/* Hands that nobody has: what a session's log told its tools, or a scene's script. A mock measures them, or those of stand-ins
 * are led by them. */
#ifndef VBSS_EXAMPLES_TRAINER_HANDS_H
#define VBSS_EXAMPLES_TRAINER_HANDS_H

#include "trainer/stage.h"

/* Where a tool was told to be, in a step of a log; or shall be. */
typedef struct reported {
    double time; /* s, from the log's begin */
    double position[3], orientation[4], opening;
    vbss_grasper_kind kind; /* what it shall be */
    bool known;
} reported;

/* A log, read before anything runs: both tools in each step. */
typedef struct score {
    reported *reported[HANDS]; /* NULL: that tool is in no input */
    size_t count;
    double duration;
    unsigned long seed; /* of the surgeon whose log it is */
    bool of_surgeon;
} score;

/* A hand that follows one of the two. */
typedef struct follower {
    const stage *stage; /* whose script; */
    const score *score; /* NULL: it is the script */
    int side;
    size_t next; /* step of the log */
} follower;

/* Reads a log. The grasper with the smaller number in its scene is the right one, as in all scenes here.
 * False: `why` says what is wrong. */
bool score_read(score *s, const char *path, char *why, size_t bytes);
void score_free(score *s);
/* What the hand wants at a time, which does not go back; not `known`: nothing yet. */
reported follower_want(follower *f, double time);
/* As vbss_mock_measure_fn, of a follower. */
void follower_measure(void *user, double time, vbss_device_sample *sample);

#endif
