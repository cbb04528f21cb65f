/* Suite needle: its groups of cases. */
#ifndef VBSS_BENCH_NEEDLE_H
#define VBSS_BENCH_NEEDLE_H

#include "harness/bench.h"

/* flight.c: thrown needles, beside other methods. */
void add_flights(bench *b);
/* passed.c: two hands take a needle and pass it through both marks of a drain. */
void add_passed(bench *b);

#endif
