/* The speed of the core, measured at the start of a program, for the budgets of its scene. */
#ifndef VBSS_EXAMPLES_THROW_CORE_SPEED_H
#define VBSS_EXAMPLES_THROW_CORE_SPEED_H

#include <vblast_ss/core_speed.h>
#include <vblast_ss/solver_options.h>

enum { CORE_SPEED_WORDS = 256 };

/* CPU time of the calling thread, s. */
double cpu_clock(void *unused);
/* Sets the speed of the core for which the budgets count, and says in a text what it is. A speed of 0 or less is measured
 * first. A core of less than a fifth of the default speed counts as one of that fifth, since with fewer operations a step
 * makes hardly any progress. On failure the options stay, and the text is the reason. */
vbss_result core_speed_fit(double operations_per_us, vbss_solver_options *solver,
                           char words[CORE_SPEED_WORDS]);

#endif
