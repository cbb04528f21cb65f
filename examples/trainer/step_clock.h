/* Slots of 1 ms on the real clock, and what the system lets a program do to keep them. */
#ifndef VBSS_EXAMPLES_TRAINER_STEP_CLOCK_H
#define VBSS_EXAMPLES_TRAINER_STEP_CLOCK_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>
#include <time.h>

#define STEP_CLOCK_PERIOD 1e-3 /* s */

typedef struct step_clock {
    bool simulated;       /* nothing waits */
    struct timespec slot; /* when the present one began */
    double began, woke;   /* s */
    double cpu;           /* of the thread at the begin of its work, s */
} step_clock;

void step_clock_begin(step_clock *p, bool simulated);
/* Waits for the next slot; by how much the thread woke up late, s. */
double step_clock_wait(step_clock *p);
/* When the slot began, since the first, s; the devices' clock. */
double step_clock_slot_time(const step_clock *p);
/* Since the begin, s. */
double step_clock_elapsed(const step_clock *p);
void step_clock_work_begins(step_clock *p);
/* The thread's CPU time since then; wall time from the slot's begin to now, s. */
double step_clock_work_ends(const step_clock *p, double *wall);

/* Starts a thread as real-time as may be, and tells how that is. */
bool step_clock_start(pthread_t *thread, void *(*run)(void *), void *user, bool simulated,
                      char *text, size_t bytes);

#endif
