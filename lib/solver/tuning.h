/* Tuned numbers of lib/solver.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md). */
#ifndef VBSS_SOLVER_TUNING_H
#define VBSS_SOLVER_TUNING_H

#include "base/tune.h"

/* ---- Elimination (separator_lu.c, static_condensation.c, relative_damping.c) */

/* A smaller pivot has lost its digits, and the system is singular.
 * Unit: 1, relative to the largest entry or the diagonal of the block. Origin: chosen. Test: none known. */
#define SOLVER_MIN_PIVOT_RATIO VBSS_TUNE(SOLVER_MIN_PIVOT_RATIO, 1e-15)
/* A smaller pivot of the damping matrix is singular.
 * Unit: 1, relative to the largest entry. Origin: chosen. Test: none known. */
#define SOLVER_DAMPING_MIN_PIVOT_RATIO VBSS_TUNE(SOLVER_DAMPING_MIN_PIVOT_RATIO, 1e-13)

/* ---- Explicit substeps (explicit_substeps.c) */

/* Length of a substep. The rest is margin, as a spring may stiffen within a step.
 * Unit: 1, relative to the longest stable substep. Origin: chosen. Test: none known. */
#define SOLVER_STABILITY_FRACTION VBSS_TUNE(SOLVER_STABILITY_FRACTION, 0.9)

#endif
