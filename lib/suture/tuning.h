/* Tuned numbers of lib/suture.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md). */
#ifndef VBSS_SUTURE_TUNING_H
#define VBSS_SUTURE_TUNING_H

#include "base/tune.h"

/* ---- Punctures (puncture.c) */

/* A tip enters a wall only if its direction is at least this close to the inner normal.
 * Unit: 1, cosine. Origin: chosen. Test: none known. */
#define SUTURE_MIN_ENTRY_COSINE VBSS_TUNE(SUTURE_MIN_ENTRY_COSINE, 0.3)
/* A puncture is at least this far from a free edge.
 * Unit: 1, relative to the radius of the wire. Origin: chosen. Test: none known. */
#define SUTURE_MIN_EDGE_DISTANCE VBSS_TUNE(SUTURE_MIN_EDGE_DISTANCE, 1.0)
/* A point on the border of two triangles lies in one of them, however its weights are rounded.
 * Unit: 1, barycentric. Origin: chosen. Test: none known. */
#define SUTURE_WEIGHT_ROUNDING VBSS_TUNE(SUTURE_WEIGHT_ROUNDING, 1e-9)

/* ---- Thread in a hole (curve.c, hole.c) */

/* Iterations of the search for the point of a span at a hole.
 * Unit: iterations. Origin: chosen. Test: halved session; doubled none known. */
#define SUTURE_MAX_ITERATIONS VBSS_TUNE(SUTURE_MAX_ITERATIONS, 24)
/* A bend below this has no grip of its own: a straight suture rubs as one that is pressed across.
 * Unit: 1, force across over force along. Origin: chosen. Test: session. */
#define SUTURE_BEND_REGULARISATION VBSS_TUNE(SUTURE_BEND_REGULARISATION, 0.01)
/* Segments that the end of the needle bends. They rub as the needle does.
 * Unit: segments. Origin: chosen. Test: none known. */
#define SUTURE_NEEDLE_BENT_SEGMENTS VBSS_TUNE(SUTURE_NEEDLE_BENT_SEGMENTS, 2)

/* ---- Tears (tear.c, scene/contacts/hole_constraints.c) */

/* A substep moves a hole by at most this. The thread must stay where neither contact nor the guard act
 * (SCENE_THREAD_EXCLUSION_ARC).
 * Unit: 1, relative to the contact distance. Origin: chosen. Test: none known. */
#define SUTURE_MAX_TEAR_RATIO VBSS_TUNE(SUTURE_MAX_TEAR_RATIO, 0.5)
/* Triangles through which a hole moves in a substep.
 * Unit: triangles. Origin: chosen. Test: none known. */
#define SUTURE_MAX_TORN_TRIANGLES VBSS_TUNE(SUTURE_MAX_TORN_TRIANGLES, 64)
/* A tear is reported as a new one after its force was below this.
 * Unit: 1, relative to the force at which it tears. Origin: chosen. Test: none known. */
#define SUTURE_TEAR_END_RATIO VBSS_TUNE(SUTURE_TEAR_END_RATIO, 0.5)

/* ---- Baseline (baseline/puncture.c) */

/* A tip is at a hole until this length of the needle has passed.
 * Unit: 1, relative to the thickness of the wall. Origin: chosen. Test: none known. */
#define BASELINE_AT_HOLE_RATIO VBSS_TUNE(BASELINE_AT_HOLE_RATIO, 3.0)

#endif
