/* Suite task: its groups of cases. */
#ifndef VBSS_BENCH_TASK_H
#define VBSS_BENCH_TASK_H

#include "harness/bench.h"

/* parts.c: the scene of the task before anything is touched, one part after the other. */
void add_part_cases(bench *b);
/* tying.c: a double throw drawn tight over the slit, with what is added to the scene's step. */
void add_tying_cases(bench *b);
/* drawn.c: a double throw with 30 to 480 segments, drawn tight. */
void add_drawn_cases(bench *b);
/* performances.c: the whole task by scripted surgeons. */
void add_performances(bench *b);

#endif
