/* The cantilever scene beside what the harness times: the fall by other steps, and the way to rest. */
#ifndef VBSS_BENCH_THREAD_CANTILEVER_H
#define VBSS_BENCH_THREAD_CANTILEVER_H

#include "thread/peer.h"

#define CANTILEVER_FALL_S 0.1

uint32_t cantilever_steps(double time, double dt);
double cantilever_distance_mm(const double a[3], const double b[3]);

/* Distance of the tip to the static one after 6 s with a drag of 8 1/s; NaN: a step failed. */
double cantilever_relax_mm(const cantilever_method *method, uint32_t segments, double dt);
/* CPU time of the fall per simulated ms; NaN: a step failed. */
double cantilever_us_per_ms(const cantilever_method *method, uint32_t segments, double dt,
                            uint32_t repetitions);

#endif
