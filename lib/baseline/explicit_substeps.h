/* Number of explicit substeps in a step. */
#ifndef VBSS_BASELINE_EXPLICIT_SUBSTEPS_H
#define VBSS_BASELINE_EXPLICIT_SUBSTEPS_H

#include <stdint.h>

/* Returns the number of equal substeps for a step of h seconds. A substep is stable up to
 * 1 / sqrt(rate); rate in 1/s^2. The number is at least 1, and bounded even if the rate is not
 * finite. */
uint32_t vbss_baseline_substep_count(double h, double rate);

#endif
