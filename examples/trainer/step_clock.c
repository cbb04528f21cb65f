#include "trainer/step_clock.h"

#include <errno.h>
#include <sched.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>

enum { PERIOD_NS = 1000000, SECOND_NS = 1000000000 };
enum { PRIORITY = 80 }; /* below that of the vendor's servo */

static double seconds(const struct timespec *t)
{
    return (double)t->tv_sec + 1e-9 * (double)t->tv_nsec;
}

static double read_clock(clockid_t clock)
{
    struct timespec t;
    (void)clock_gettime(clock, &t);
    return seconds(&t);
}

/* ---- slots */

void step_clock_begin(step_clock *p, bool simulated)
{
    memset(p, 0, sizeof *p);
    p->simulated = simulated;
    (void)clock_gettime(CLOCK_MONOTONIC, &p->slot);
    p->began = seconds(&p->slot);
}

static void advance(struct timespec *t)
{
    t->tv_nsec += PERIOD_NS;
    if (t->tv_nsec >= SECOND_NS) {
        t->tv_nsec -= SECOND_NS;
        t->tv_sec++;
    }
}

double step_clock_wait(step_clock *p)
{
    if (p->simulated) {
        (void)clock_gettime(CLOCK_MONOTONIC, &p->slot);
        return 0.0;
    }
    double now = read_clock(CLOCK_MONOTONIC);
    do { /* slots that went by are not made up for */
        advance(&p->slot);
    } while (seconds(&p->slot) + STEP_CLOCK_PERIOD < now);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &p->slot, NULL) == EINTR) {
    }
    return read_clock(CLOCK_MONOTONIC) - seconds(&p->slot);
}

double step_clock_slot_time(const step_clock *p)
{
    return seconds(&p->slot) - p->began;
}

double step_clock_elapsed(const step_clock *p)
{
    return read_clock(CLOCK_MONOTONIC) - p->began;
}

void step_clock_work_begins(step_clock *p)
{
    p->cpu = read_clock(CLOCK_THREAD_CPUTIME_ID);
    p->woke = p->simulated ? read_clock(CLOCK_MONOTONIC) : seconds(&p->slot);
}

double step_clock_work_ends(const step_clock *p, double *wall)
{
    *wall = read_clock(CLOCK_MONOTONIC) - p->woke;
    return read_clock(CLOCK_THREAD_CPUTIME_ID) - p->cpu;
}

/* ---- the thread */

static const char *read_governor(char *text, size_t bytes)
{
    FILE *file = fopen("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "r");
    if (file == NULL) {
        return "not told";
    }
    char *got = fgets(text, (int)bytes, file);
    (void)fclose(file);
    text[strcspn(text, "\n")] = '\0';
    return got != NULL ? text : "not told";
}

static bool start_in_turn(pthread_t *thread, void *(*run)(void *), void *user)
{
    pthread_attr_t how;
    struct sched_param priority = {.sched_priority = PRIORITY};
    if (pthread_attr_init(&how) != 0) {
        return false;
    }
    bool good = pthread_attr_setinheritsched(&how, PTHREAD_EXPLICIT_SCHED) == 0 &&
                pthread_attr_setschedpolicy(&how, SCHED_FIFO) == 0 &&
                pthread_attr_setschedparam(&how, &priority) == 0 &&
                pthread_create(thread, &how, run, user) == 0;
    (void)pthread_attr_destroy(&how);
    return good;
}

bool step_clock_start(pthread_t *thread, void *(*run)(void *), void *user, bool simulated,
                      char *text, size_t bytes)
{
    char governor[32];
    if (simulated) {
        snprintf(text, bytes, "simulated time");
        return pthread_create(thread, NULL, run, user) == 0;
    }
    bool locked = mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
    bool first = start_in_turn(thread, run, user);
    snprintf(text, bytes, "%s, memory %s, governor %s",
             first ? "SCHED_FIFO 80" : "SCHED_OTHER (SCHED_FIFO is not permitted)",
             locked ? "locked" : "not locked (not permitted)",
             read_governor(governor, sizeof governor));
    return first || pthread_create(thread, NULL, run, user) == 0;
}
