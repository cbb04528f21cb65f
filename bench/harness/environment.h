/* Where a measurement was made. What cannot be read is an empty text or zero, never an error. */
#ifndef VBSS_BENCH_HARNESS_ENVIRONMENT_H
#define VBSS_BENCH_HARNESS_ENVIRONMENT_H

#include <stddef.h>

enum { BENCH_MAX_CACHES = 8 };

typedef struct bench_cache {
    char type[24];
    unsigned level;
    unsigned long size; /* bytes */
    unsigned sharing;   /* processors behind one of it */
} bench_cache;

typedef struct bench_environment {
    char date[40]; /* ISO 8601, UTC */
    char cpu_model[128];
    unsigned cpu_count; /* online */
    double mhz;         /* at the time of reading */
    double load[3];
    bench_cache caches[BENCH_MAX_CACHES];
    unsigned cache_count;
    char compiler[128];
    char flags[512];
} bench_environment;

void bench_read_environment(bench_environment *environment);

/* Copies the words of `text` that hold no '/': results are published, and paths of the machine that
 * made them are nobody's business. */
void bench_copy_without_paths(char *to, size_t capacity, const char *text);

#endif
