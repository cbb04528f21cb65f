/* The cases of suite tissue in which something touches the drain. */
#ifndef VBSS_BENCH_TISSUE_SCENES_H
#define VBSS_BENCH_TISSUE_SCENES_H

#include "harness/bench.h"

void add_scenes(bench *b);
/* pierced.c */
void add_pierced(bench *b);
void add_stitched(bench *b);

#endif
