/* The device layer: what a read and a write cost, and what energy an output stage hands out. */
#ifndef VBSS_BENCH_DEVICE_BENCH_DEVICE_H
#define VBSS_BENCH_DEVICE_BENCH_DEVICE_H

#include "harness/bench.h"

void add_cost_cases(bench *b);      /* cost.c */
void add_passivity_cases(bench *b); /* passivity.c */

#endif
