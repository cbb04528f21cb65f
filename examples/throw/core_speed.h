/* The speed of the core, measured at the start of a program, and the limits of work of a scene that fit it. */
#ifndef VBSS_EXAMPLES_THROW_CORE_SPEED_H
#define VBSS_EXAMPLES_THROW_CORE_SPEED_H

#include <stddef.h>
#include <stdint.h>

#include <vblast_ss/budget.h>

/* Limits of a step and of a call, operations; 0: the default, below 0: none. */
typedef struct core_limits {
    int32_t work, slot;
} core_limits;

enum { CORE_SPEED_WORDS = 256 };

/* CPU time of the calling thread, s. */
double cpu_clock(void *unused);
/* Finds the limits for a slot of 1 ms, and says in a text what they are. A speed of 0 or less is measured first.
 * On failure the limits stay, and the text is the reason. */
vbss_result core_speed_fit(double operations_per_microsecond, core_limits *limits,
                           char words[CORE_SPEED_WORDS]);

#endif
