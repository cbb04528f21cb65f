/* Suite knots: the groups of cases, one file each. */
#ifndef VBSS_BENCH_KNOTS_BENCH_KNOTS_H
#define VBSS_BENCH_KNOTS_BENCH_KNOTS_H

#include "harness/bench.h"

void add_family_cases(
    bench *b); /* threads with a truth: what is told of them, and the time it takes */
void add_stage_cases(bench *b);      /* where that time goes */
void add_moving_cases(bench *b);     /* the same spread over steps */
void add_projection_cases(bench *b); /* method PROJECTION: how often it is right */

#endif
