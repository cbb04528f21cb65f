/* Tuned numbers of lib/drain.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md). */
#ifndef VBSS_DRAIN_TUNING_H
#define VBSS_DRAIN_TUNING_H

#include "base/tune.h"

/* ---- Newton (step.c; also lib/scene) */

/* A larger correction is dropped.
 * Unit: 1, relative to the increment before. Origin: chosen. Test: session. */
#define DRAIN_MAX_CORRECTION_RATIO VBSS_TUNE(DRAIN_MAX_CORRECTION_RATIO, 0.5)
/* The matrix is of an earlier shape until a node is farther from it.
 * Unit: 1, relative to the configured move limit. Origin: chosen from 0.02 to 0.2: up to 0.1 the scenes of a drain differ from those
 * with a new matrix in each linearisation by less than these do from the converged ones (docs/notebook/step-time.md). Test: session. */
#define DRAIN_TANGENT_RATIO VBSS_TUNE(DRAIN_TANGENT_RATIO, 0.05)
/* A substep that moves a node farther is halved.
 * Unit: 1, relative to the configured move limit. Origin: chosen. Test: none known. */
#define DRAIN_MAX_MOVE_RATIO VBSS_TUNE(DRAIN_MAX_MOVE_RATIO, 4.0)
/* A smaller triangle counts as inverted.
 * Unit: 1, relative to the rest area. Origin: chosen. Test: none known. */
#define DRAIN_INVERTED_AREA_RATIO VBSS_TUNE(DRAIN_INVERTED_AREA_RATIO, 0.02)

/* ---- Mesh (uniform_grid.c) */

/* A landmark lies on a grid line when it is this close.
 * Unit: 1, relative to a cell. Origin: chosen. Test: none known. */
#define DRAIN_LINE_TOLERANCE VBSS_TUNE(DRAIN_LINE_TOLERANCE, 1e-6)
/* Longest side of a cell over its shortest. A more slender cell is refused.
 * Unit: 1. Origin: chosen. Test: none known. */
#define DRAIN_MAX_CELL_ASPECT VBSS_TUNE(DRAIN_MAX_CELL_ASPECT, 20.0)

#endif
