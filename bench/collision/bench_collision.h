/* Suite collision: the groups of cases, one file each. */
#ifndef VBSS_BENCH_COLLISION_BENCH_COLLISION_H
#define VBSS_BENCH_COLLISION_BENCH_COLLISION_H

#include "harness/bench.h"

void add_query_cases(bench *b); /* continuous tests beside peers: time and wrong answers */
void end_query_cases(void);
void add_broad_cases(bench *b); /* the search for pairs over N from 250 to 10000 */

/* After a run: what each method is that was measured. */
void print_query_notes(void);

#endif
