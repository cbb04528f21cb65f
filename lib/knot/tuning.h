/* Tuned numbers of lib/knot.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md).
 * That page says why a number stays absolute. */
#ifndef VBSS_KNOT_TUNING_H
#define VBSS_KNOT_TUNING_H

#include "base/tune.h"

/* ---- Detector (detector.c, job.c, winding.c) */

/* Steps between two readings while a tool holds the thread or is wrapped.
 * Unit: steps. Origin: chosen. Test: none known. */
#define KNOT_TYING_INTERVAL VBSS_TUNE(KNOT_TYING_INTERVAL, 20)
/* A wrap ends this far below the turns that start it.
 * Unit: turns. Origin: chosen. Test: none known. */
#define KNOT_UNWRAP_HYSTERESIS VBSS_TUNE(KNOT_UNWRAP_HYSTERESIS, 0.25)
/* A shorter thread has no knot.
 * Unit: m, absolute. Origin: chosen. Test: none known. */
#define KNOT_MIN_EXTENT VBSS_TUNE(KNOT_MIN_EXTENT, 1e-9)
/* A tool that is folded more sharply has no bisecting plane.
 * Unit: 1, 1 + cosine of the bend. Origin: chosen. Test: none known. */
#define KNOT_MIN_FOLD_COSINE VBSS_TUNE(KNOT_MIN_FOLD_COSINE, 1e-6)
/* A whole number of turns within this is shifted by twice as much, off the half-line.
 * Unit: turns. Origin: chosen. Test: none known. */
#define KNOT_TURN_ROUNDING VBSS_TUNE(KNOT_TURN_ROUNDING, 1e-6)
/* Fewer turns have no sense of winding along the tool.
 * Unit: turns. Origin: chosen. Test: none known. */
#define KNOT_SENSE_MIN_TURNS VBSS_TUNE(KNOT_SENSE_MIN_TURNS, 0.5)
/* The sense of winding compares heights this far from both ends of the run.
 * Unit: 1, relative to the turns of the run. Origin: chosen. Test: none known. */
#define KNOT_SENSE_QUARTILE VBSS_TUNE(KNOT_SENSE_QUARTILE, 0.25)
/* A smaller difference in height has no sense.
 * Unit: 1, relative to the radius of the tool. Origin: chosen. Test: none known. */
#define KNOT_SENSE_WIDTH_RATIO VBSS_TUNE(KNOT_SENSE_WIDTH_RATIO, 0.1)

/* ---- Closure (closure.c) */

/* Weight of the random direction in a closure: directions lie within some 60 degrees.
 * Unit: 1, relative to the outward direction. Origin: chosen. Test: none known. */
#define KNOT_DIRECTION_SPREAD VBSS_TUNE(KNOT_DIRECTION_SPREAD, 0.87)
/* Distance of the point that joins two opposite closures.
 * Unit: 1, relative to the far distance. Origin: chosen. Test: session. */
#define KNOT_FAR_DETOUR_RATIO VBSS_TUNE(KNOT_FAR_DETOUR_RATIO, 1.5)
/* Closures of a smaller sum are opposite, and any normal joins them.
 * Unit: 1, squared sum of two unit vectors. Origin: chosen. Test: none known. */
#define KNOT_OPPOSITE_SQUARED VBSS_TUNE(KNOT_OPPOSITE_SQUARED, 1e-6)

/* ---- Reduction (reduction.c) */

/* Cost of a vertex that is skipped.
 * Unit: operations, about 1 ns each. Origin: fitted: `./bench/run.sh knots`. Test: session. */
#define KNOT_SKIP_OPS VBSS_TUNE(KNOT_SKIP_OPS, 2)
/* Cost of a vertex that is visited.
 * Unit: operations, about 1 ns each. Origin: fitted: `./bench/run.sh knots`. Test: session. */
#define KNOT_VISIT_OPS VBSS_TUNE(KNOT_VISIT_OPS, 55)
/* Cost of an edge that is tested.
 * Unit: operations, about 1 ns each. Origin: fitted: `./bench/run.sh knots`. Test: session. */
#define KNOT_EDGE_OPS VBSS_TUNE(KNOT_EDGE_OPS, 12)
/* Cost of a vertex that is removed.
 * Unit: operations, about 1 ns each. Origin: fitted: `./bench/run.sh knots`. Test: session. */
#define KNOT_REMOVE_OPS VBSS_TUNE(KNOT_REMOVE_OPS, 15)
/* Cost of a vertex or obstacle that is compacted.
 * Unit: operations, about 1 ns each. Origin: fitted: `./bench/run.sh knots`. Test: session. */
#define KNOT_COMPACT_OPS VBSS_TUNE(KNOT_COMPACT_OPS, 5)

/* ---- Slip (slip.c) */

/* Rounds of the search for the middles of throws. In tight knots the measure moves by less than 0.01
 * after them. Unit: rounds. Origin: chosen. Test: none known. */
#define KNOT_SLIP_ROUNDS VBSS_TUNE(KNOT_SLIP_ROUNDS, 8)
/* Reach of a window that has no neighbour; 3.5 changes the measure by at most 0.02.
 * Unit: 1, relative to the standard deviations of the crossings on both limbs, summed. Origin: chosen. Test: none
 * known. */
#define KNOT_SLIP_REACH VBSS_TUNE(KNOT_SLIP_REACH, 2.5)
/* Segments this far apart cross as if they were points, within 6 %.
 * Unit: 1, relative to the sum of their lengths. Origin: chosen. Test: none known. */
#define KNOT_SLIP_FAR_RATIO VBSS_TUNE(KNOT_SLIP_FAR_RATIO, 2.0)

/* ---- Diagram (projection.c, projected_edges.c, triangle.h, curve.c) */

/* A crossing this near to a vertex or to another crossing rejects the direction.
 * Unit: 1, relative to the edge. Origin: chosen. Test: none known. */
#define KNOT_NEAR_PLACE VBSS_TUNE(KNOT_NEAR_PLACE, 1e-6)
/* Strands this near in height reject the direction.
 * Unit: 1, relative to the size of the polygon. Origin: chosen. Test: none known. */
#define KNOT_NEAR_HEIGHT VBSS_TUNE(KNOT_NEAR_HEIGHT, 1e-12)
/* Longer edges are kept apart in the search for crossings.
 * Unit: 1, relative to the mean of the edges that are not longer than the mean. Origin: chosen. Test: session. */
#define KNOT_LONG_EDGE_RATIO VBSS_TUNE(KNOT_LONG_EDGE_RATIO, 8.0)
/* A determinant has a certain sign beyond this.
 * Unit: 1, relative to the product of the lengths. Origin: derived: a million times the rounding bound. Test:
 * none known. */
#define KNOT_CLEARANCE VBSS_TUNE(KNOT_CLEARANCE, 1e-9)
/* Strands of a diagram that may be relaid.
 * Unit: strands. Origin: chosen. Test: none known. */
#define KNOT_TRIES VBSS_TUNE(KNOT_TRIES, 400)

#endif
