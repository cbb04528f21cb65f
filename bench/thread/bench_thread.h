/* Suite thread: the groups of cases, one file each. */
#ifndef VBSS_BENCH_THREAD_BENCH_THREAD_H
#define VBSS_BENCH_THREAD_BENCH_THREAD_H

#include "harness/bench.h"

void add_cantilever_cases(bench *b); /* a falling thread beside peers: time and error */
void add_growth_cases(bench *b);     /* a step over N from 30 to 10000 */
void add_stage_cases(bench *b);      /* what a step spends its time on */
void add_option_cases(bench *b);     /* with and without memory of bends and twist, paired */

/* After a run: what each method of the cantilever is that was measured. */
void print_cantilever_notes(void);

#endif
