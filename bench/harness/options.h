/* Command line of a suite. */
#ifndef VBSS_BENCH_HARNESS_OPTIONS_H
#define VBSS_BENCH_HARNESS_OPTIONS_H

#include <stdbool.h>
#include <stdio.h>

enum { BENCH_REPETITIONS = 7, BENCH_QUICK_REPETITIONS = 2, BENCH_SEEDS = 5, BENCH_QUICK_SEEDS = 1 };

typedef struct bench_options {
    const char *out;    /* JSON file, NULL: none */
    const char *filter; /* only cases whose name contains it, NULL: all */
    const char *git;    /* commit, NULL: unknown */
    unsigned repetitions;
    unsigned seeds; /* of suites that have some */
    bool quick;
    bool list;
    bool help;
    double batch_ns; /* a batch takes at least this long, however cheap the timer */
} bench_options;

bench_options bench_default_options(void);
/* False, with one line about it on `complaints`, when the arguments are wrong. */
bool bench_parse_options(int argc, char **argv, bench_options *options, FILE *complaints);
void bench_print_usage(FILE *to, const char *suite);

#endif
