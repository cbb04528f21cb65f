/* Number of explicit substeps, from the rate that limits their stability. */
#include "baseline/explicit_substeps.h"

#include <math.h>
#include "solver/tuning.h"

#define MAX_SUBSTEPS 100000u

uint32_t vbss_baseline_substep_count(double h, double rate)
{
    double wanted = h * sqrt(rate) * (1.0 / SOLVER_STABILITY_FRACTION);
    if (!(wanted < MAX_SUBSTEPS)) {
        return MAX_SUBSTEPS;
    }
    uint32_t count = (uint32_t)wanted;
    return count < wanted || count == 0 ? count + 1 : count;
}
