/* The device layer: what a read and a write cost, what energy an output stage hands out; and what a hand has of
 * the graspers of a scene. */
#ifndef VBSS_BENCH_DEVICE_BENCH_DEVICE_H
#define VBSS_BENCH_DEVICE_BENCH_DEVICE_H

#include "harness/bench.h"

void add_cost_cases(bench *b);           /* cost.c */
void add_passivity_cases(bench *b);      /* passivity.c */
void add_tool_passivity_cases(bench *b); /* tool_passivity.c */
void add_tool_rest_cases(bench *b);      /* tool_rest.c */
void add_tool_wall_cases(bench *b);      /* tool_wall.c */
void add_tool_cost_cases(bench *b);      /* tool_cost.c */
void add_step_sizes(bench *b);           /* step_sizes.c */

#endif
