/* Slots of 1 ms on the real clock, and what the system lets a program do to keep them. */
#ifndef VBSS_EXAMPLES_TRAINER_PACE_H
#define VBSS_EXAMPLES_TRAINER_PACE_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>
#include <time.h>

#define PACE_PERIOD 1e-3 /* s */

typedef struct pace {
    bool simulated;       /* nothing waits */
    struct timespec slot; /* when the present one began */
    double began, woke;   /* s */
    double cpu;           /* of the thread at the begin of its work, s */
} pace;

void pace_begin(pace *p, bool simulated);
/* Waits for the next slot; by how much the thread woke up late, s. */
double pace_wait(pace *p);
/* When the slot began, since the first, s; the devices' clock. */
double pace_slot_time(const pace *p);
/* Since the begin, s. */
double pace_elapsed(const pace *p);
void pace_work_begins(pace *p);
/* The thread's CPU time since then; wall time from the slot's begin to now, s. */
double pace_work_ends(const pace *p, double *wall);

/* Starts a thread as real-time as may be, and tells how that is. */
bool pace_start(pthread_t *thread, void *(*run)(void *), void *user, bool simulated, char *text,
                size_t bytes);

#endif
