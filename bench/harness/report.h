/* What a run tells: a JSON file for machines, a table for people. */
#ifndef VBSS_BENCH_HARNESS_REPORT_H
#define VBSS_BENCH_HARNESS_REPORT_H

#include <stdbool.h>
#include <stdio.h>

#include "harness/environment.h"
#include "harness/run.h"

/* google-benchmark's schema; every counter is a flat number of its case. */
void bench_write_json(const bench *b, const bench_environment *environment, FILE *file);
/* One block for each scene, one row for each method and N; rows of one N stand together, compared
 * with the first of them. */
void bench_print_table(const bench *b, const bench_environment *environment, FILE *file);

#endif
