/* The files of suite visual. */
#ifndef VBSS_BENCH_VISUAL_BENCH_VISUAL_H
#define VBSS_BENCH_VISUAL_BENCH_VISUAL_H

#include "harness/bench.h"

/* Publishing a scene for a reader in another thread, beside a copy of as many bytes. */
void add_replica_cases(bench *b);

#endif
