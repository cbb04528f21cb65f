/* How many explicit steps make up a step. */
#ifndef VBSS_BASELINE_EXPLICIT_SUBSTEPS_H
#define VBSS_BASELINE_EXPLICIT_SUBSTEPS_H

#include <stdint.h>

/* Into how many equal parts a step of h seconds is divided, if they are stable up to 1 / sqrt(rate). */
uint32_t vbss_baseline_substep_count(double h, double rate);

#endif
