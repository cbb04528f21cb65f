/* Suite base: the groups of cases, one file each. */
#ifndef VBSS_BENCH_BASE_BENCH_BASE_H
#define VBSS_BENCH_BASE_BENCH_BASE_H

#include "harness/bench.h"

void add_api_call_cases(bench *b);        /* entry and exit of public calls */
void add_elementary_cases(bench *b);      /* sin, cos, ..., log beside libm */
void add_kernel_cases(bench *b);          /* hash, stream, quaternions */
void add_spinning_bodies_cases(bench *b); /* a stepped scene of the ground floor alone */

#endif
