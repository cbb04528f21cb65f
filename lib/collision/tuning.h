/* Tuned numbers of lib/collision.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md). */
#ifndef VBSS_COLLISION_TUNING_H
#define VBSS_COLLISION_TUNING_H

#include "base/tune.h"

/* ---- Closest points (closest.h) */

/* Two edges are parallel below this squared sine of the angle between them.
 * Unit: 1, squared sine. Origin: chosen. Test: none known. */
#define CLOSEST_PARALLEL VBSS_TUNE(CLOSEST_PARALLEL, 1e-4)

/* ---- Continuous collision detection (conservative_advancement.c, ccd.c, ccd_simd.c, ccd_crossing.c) */

/* A hit uses at most this fraction of the tolerance, so that rounding does not exceed it.
 * Unit: 1, relative to the tolerance. Origin: chosen. Test: none known. */
#define COLLISION_HIT_FRACTION VBSS_TUNE(COLLISION_HIT_FRACTION, 0.999)
/* At zero thickness the exact test takes over after this many passes.
 * Unit: passes. Origin: chosen. Test: none known. */
#define COLLISION_ZERO_PASS_LIMIT VBSS_TUNE(COLLISION_ZERO_PASS_LIMIT, 32u)
/* At zero thickness a certain hit may take this many passes to come near its time.
 * Unit: passes. Origin: chosen. Test: none known. */
#define COLLISION_ZERO_HIT_PASS_LIMIT VBSS_TUNE(COLLISION_ZERO_HIT_PASS_LIMIT, 256u)
/* Half of the interval of time in which the test looks for a certain crossing.
 * Unit: 1, relative to the step. Origin: chosen. Test: none known. */
#define COLLISION_CROSSING_SPAN VBSS_TUNE(COLLISION_CROSSING_SPAN, 0x1p-20)
/* Rounds of four lanes between two checks of the pass limit. It changes time only.
 * Unit: rounds. Origin: chosen. Test: none known. */
#define COLLISION_LANE_ROUNDS VBSS_TUNE(COLLISION_LANE_ROUNDS, 8)

/* ---- Broad phase (broad_phase.c) */

/* Insertion sort is used up to this count. It changes time only.
 * Unit: pairs. Origin: chosen. Test: none known. */
#define COLLISION_INSERTION_SORT_LIMIT VBSS_TUNE(COLLISION_INSERTION_SORT_LIMIT, 24u)

/* ---- Near pairs and separation cache (near_pairs.c, separation_cache.c) */

/* Loose boxes exceed swept boxes by this on all sides. It changes time only.
 * Unit: 1, relative to the inflation of a swept box. Origin: chosen. Test: none known. */
#define COLLISION_LOOSENESS VBSS_TUNE(COLLISION_LOOSENESS, 0.25)
/* Loose boxes also cover this many steps of the present motion. It changes time only.
 * Unit: steps. Origin: chosen. Test: none known. */
#define COLLISION_LOOSE_STEPS VBSS_TUNE(COLLISION_LOOSE_STEPS, 4.0)
/* Searches without loose boxes after near pairs did not fit. It changes time only.
 * Unit: searches. Origin: chosen. Test: none known. */
#define COLLISION_TIGHT_SEARCHES VBSS_TUNE(COLLISION_TIGHT_SEARCHES, 64u)
/* Makes proved bounds of distances safe against rounding.
 * Unit: 1, relative to the distance. Origin: chosen. Test: collision.separation_bounds. */
#define COLLISION_ROUNDED_UP VBSS_TUNE(COLLISION_ROUNDED_UP, 1.0 + 1e-9)

/* ---- Posed meshes (posed_mesh.c) */

/* Boxes that were turned are enlarged by this much of their coordinates, which exceeds the rounding errors.
 * Unit: 1, relative to the coordinates. Origin: derived, a hundred times the errors of some ten products.
 * Test: none known. */
#define COLLISION_POSED_PADDING VBSS_TUNE(COLLISION_POSED_PADDING, 1e-12)
/* A cube around a mesh is larger by this much, so that it contains the padded boxes.
 * Unit: 1, relative to the coordinates. Origin: chosen, a thousand times COLLISION_POSED_PADDING. Test: none known. */
#define COLLISION_CUBE_PADDING VBSS_TUNE(COLLISION_CUBE_PADDING, 1e-9)

/* ---- Baseline (baseline/response.c) */

/* A shorter vector has no direction.
 * Unit: 1, relative to the features. Origin: chosen. Test: none known. */
#define BASELINE_MIN_DIRECTION_RATIO VBSS_TUNE(BASELINE_MIN_DIRECTION_RATIO, 1e-12)
/* Slower closing does not show which side closed the gap.
 * Unit: 1, relative to the displacement of both sides. Origin: chosen. Test: none known. */
#define BASELINE_MIN_CLOSING_RATIO VBSS_TUNE(BASELINE_MIN_CLOSING_RATIO, 1e-9)
/* A contact point of lower mobility does not move.
 * Unit: 1, relative to the freest vertex. Origin: chosen. Test: none known. */
#define BASELINE_MIN_MOBILITY_RATIO VBSS_TUNE(BASELINE_MIN_MOBILITY_RATIO, 1e-12)

#endif
