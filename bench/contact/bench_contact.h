/* Suite contact: its groups of cases. */
#ifndef VBSS_BENCH_CONTACT_H
#define VBSS_BENCH_CONTACT_H

#include "harness/bench.h"

/* knot_cases.c: knots that are pulled tight, and held; of both methods. */
void add_knot_cases(bench *b);
/* throws.c: loops that slide along a tool and off its tip. */
void add_throw_cases(bench *b);
/* resolution.c: what is gained by finer meshes and shorter steps. */
void add_resolution_cases(bench *b);
/* adaptive.c: knots on meshes that adapt themselves beside fixed ones. */
void add_adaptive_cases(bench *b);
/* peers.c: the overhand by others beside ours. */
void add_peer_cases(bench *b);

#endif
