/* Tuned numbers of lib/thread.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md). */
#ifndef VBSS_THREAD_TUNING_H
#define VBSS_THREAD_TUNING_H

#include "base/tune.h"

/* ---- Implicit step (implicit_step.c) */

/* Length of the first substep of a motion that starts with unknown accelerations.
 * Unit: 1, relative to the step. Origin: chosen. Test: none known. */
#define THREAD_START_FRACTION VBSS_TUNE(THREAD_START_FRACTION, 1.0 / 64.0)
/* A step that needs more is not smooth, and the steps after it are damped.
 * Unit: linearisations. Origin: chosen. Test: none known. */
#define THREAD_MAX_SMOOTH_ITERATIONS VBSS_TUNE(THREAD_MAX_SMOOTH_ITERATIONS, 4)
/* Steps by backward Euler after a step that was not smooth.
 * Unit: steps. Origin: chosen. Test: none known. */
#define THREAD_DAMPED_STEPS VBSS_TUNE(THREAD_DAMPED_STEPS, 2)
/* The direction of the rest curvature is updated this often in a step, and is fixed after that.
 * Unit: linearisations. Origin: chosen. Test: none known. */
#define THREAD_REST_CURVATURE_UPDATES VBSS_TUNE(THREAD_REST_CURVATURE_UPDATES, 30)
/* Accelerations are not carried over between substeps of which one is longer by this ratio.
 * Unit: 1, relative to the substep before. Origin: chosen. Test: none known. */
#define THREAD_MAX_LENGTH_RATIO VBSS_TUNE(THREAD_MAX_LENGTH_RATIO, 2.1)
/* Largest compression that the stiffness keeps inside the thread.
 * Unit: 1, relative to the buckling load of a free end. Origin: derived: twice the load of an end, less a
 * tenth. Test: none known. */
#define THREAD_INNER_COMPRESSION VBSS_TUNE(THREAD_INNER_COMPRESSION, 1.8)
/* Largest compression that the stiffness keeps at a free end.
 * Unit: 1, relative to the buckling load of a free end. Origin: derived: the load itself, less a tenth. Test:
 * halved scene-tools, scene-mesh, graspers, needle-hands, session; doubled scene-tools, scene-mesh, graspers,
 * session. */
#define THREAD_END_COMPRESSION VBSS_TUNE(THREAD_END_COMPRESSION, 0.9)

/* ---- Prediction (substep.c) */

/* The prediction of a smooth motion strains a segment by at most this.
 * Unit: 1, strain. Origin: chosen. Test: halved none known; doubled scene-mesh. */
#define THREAD_SMOOTH_STRAIN VBSS_TUNE(THREAD_SMOOTH_STRAIN, 0.03)
/* The prediction strains a segment by at most this where a motion starts.
 * Unit: 1, strain. Origin: chosen. Test: none known. */
#define THREAD_STARTING_STRAIN VBSS_TUNE(THREAD_STARTING_STRAIN, 1e-3)
/* Newton starts from the old positions when the prediction strains a segment by more.
 * Unit: 1, strain. Origin: chosen. Test: none known. */
#define THREAD_MAX_PREDICTION_STRAIN VBSS_TUNE(THREAD_MAX_PREDICTION_STRAIN, 0.5)

/* ---- Rest curvature (rest_curvature.c) */

/* Smooths the norm of a turn near zero, where it has no direction.
 * Unit: 1, relative to the squared rest angle. Origin: chosen. Test: none known. */
#define THREAD_SMOOTH_TURN_SQUARED VBSS_TUNE(THREAD_SMOOTH_TURN_SQUARED, 1e-6)

/* ---- Bending with memory (bending_memory.c) */

/* A cell that turns by less is straight, and its bend has no plane of its own.
 * Unit: rad. Origin: chosen: small against the turn at any yield. Test: none known. */
#define THREAD_MEMORY_STRAIGHT_TURN VBSS_TUNE(THREAD_MEMORY_STRAIGHT_TURN, 1e-3)
/* Substeps shorter than this have the coefficients of relaxation by series.
 * Unit: 1, relative to the relaxation time. Origin: derived: rounding of the formula and remainder of the series
 * are below 1e-9 there. Test: none known. */
#define THREAD_MEMORY_SERIES_LIMIT VBSS_TUNE(THREAD_MEMORY_SERIES_LIMIT, 1e-3)

/* ---- Twist (twist_spans.c) */

/* Bounds the gradient of twist where the thread folds back on itself, and parallel transport has no plane.
 * Unit: 1, 1 + cosine of the turn. Origin: chosen: a turn of 177 degrees. Test: none known. */
#define THREAD_TWIST_MIN_FOLD VBSS_TUNE(THREAD_TWIST_MIN_FOLD, 1e-3)

/* ---- Cuts (cut.c) */

/* A cut this close to a node goes through the node, since slivers need tiny substeps.
 * Unit: 1, relative to the segment. Origin: chosen. Test: none known. */
#define THREAD_CUT_SNAP_FRACTION VBSS_TUNE(THREAD_CUT_SNAP_FRACTION, 0.01)
/* A cut leaves no shorter segment.
 * Unit: 1, relative to the radius of the thread. Origin: chosen: 1e-7 m at the default radius. Test: none
 * known. */
#define THREAD_CUT_MIN_LENGTH_RATIO VBSS_TUNE(THREAD_CUT_MIN_LENGTH_RATIO, 1e-7 / 0.125e-3)

/* ---- Remeshing (remesh_criteria.c, remesh.c, remesh_window.c) */

/* Segments whose length is checked after a step.
 * Unit: segments. Origin: chosen. Test: scene-mesh. */
#define REMESH_CHECKS_PER_STEP VBSS_TUNE(REMESH_CHECKS_PER_STEP, 32)
/* Neighbouring segments differ in length by at most this ratio.
 * Unit: 1. Origin: derived: halving a segment gives 2; the rest is rounding. Test: scene-mesh. */
#define REMESH_MAX_LENGTH_RATIO VBSS_TUNE(REMESH_MAX_LENGTH_RATIO, 2.0 * (1.0 + 1e-9))
/* A segment is split only when it is longer than this.
 * Unit: 1, relative to the preferred length. Origin: chosen. Test: scene-mesh. */
#define REMESH_LENGTH_TOLERANCE VBSS_TUNE(REMESH_LENGTH_TOLERANCE, 1.25)
/* Nodes on either side of a change that move with it.
 * Unit: nodes. Origin: chosen. Test: scene-mesh. */
#define REMESH_MOVABLE_SIDE VBSS_TUNE(REMESH_MOVABLE_SIDE, 2)
/* A change moves a node of a free thread by at most this.
 * Unit: 1, relative to the segment. Origin: chosen. Test: none known. */
#define REMESH_MAX_DISPLACEMENT_RATIO VBSS_TUNE(REMESH_MAX_DISPLACEMENT_RATIO, 0.05)
/* Passes of the projection that restores strain and momentum.
 * Unit: passes. Origin: chosen. Test: scene-mesh. */
#define REMESH_PROJECTION_PASSES VBSS_TUNE(REMESH_PROJECTION_PASSES, 3)
/* Regularises the projection where its constraints are nearly dependent.
 * Unit: 1, relative to the largest diagonal entry. Origin: chosen. Test: scene-mesh. */
#define REMESH_REGULARISATION VBSS_TUNE(REMESH_REGULARISATION, 1e-3)

/* ---- Snapshots (snapshot.c) */

/* Rest lengths below this are refused. Those of any configuration are longer, and their squares are not zero.
 * Unit: m. Origin: chosen. Test: fuzz.log with UndefinedBehaviorSanitizer. */
#define THREAD_MIN_REST_LENGTH VBSS_TUNE(THREAD_MIN_REST_LENGTH, 1e-12)

/* ---- Materials of sutures (sutures.c); docs/reference/sutures.md has the sources and uncertainties. */

/* Density of a solid silk braid.
 * Unit: kg/m^3. Origin: derived, from the preset of 2-0 silk. Test: none known. */
#define SUTURE_SILK_DENSITY VBSS_TUNE(SUTURE_SILK_DENSITY, 1305.0)
/* Modulus of braided silk, size 3-0.
 * Unit: Pa. Origin: published. Test: none known. */
#define SUTURE_SILK_MODULUS VBSS_TUNE(SUTURE_SILK_MODULUS, 8.70e9)
/* Density of polyglactin.
 * Unit: kg/m^3. Origin: chosen. Test: none known. */
#define SUTURE_POLYGLACTIN_DENSITY VBSS_TUNE(SUTURE_POLYGLACTIN_DENSITY, 1500.0)
/* Modulus of rapid polyglactin 910, size 3-0.
 * Unit: Pa. Origin: published. Test: none known. */
#define SUTURE_POLYGLACTIN_MODULUS VBSS_TUNE(SUTURE_POLYGLACTIN_MODULUS, 9.32e9)
/* Modulus of bending of a braid: that of the published thread, EI = 1e-8 N m^2 at a radius of 0.125 mm.
 * Unit: Pa. Origin: derived. Test: none known. */
#define SUTURE_BRAID_BENDING_MODULUS VBSS_TUNE(SUTURE_BRAID_BENDING_MODULUS, 5.215e7)
/* Density of polypropylene.
 * Unit: kg/m^3. Origin: chosen. Test: none known. */
#define SUTURE_POLYPROPYLENE_DENSITY VBSS_TUNE(SUTURE_POLYPROPYLENE_DENSITY, 905.0)
/* Modulus of a drawn polypropylene filament.
 * Unit: Pa. Origin: chosen. Test: none known. */
#define SUTURE_POLYPROPYLENE_MODULUS VBSS_TUNE(SUTURE_POLYPROPYLENE_MODULUS, 3.0e9)
/* Density of nylon.
 * Unit: kg/m^3. Origin: chosen. Test: none known. */
#define SUTURE_NYLON_DENSITY VBSS_TUNE(SUTURE_NYLON_DENSITY, 1140.0)
/* Modulus of a drawn nylon filament.
 * Unit: Pa. Origin: chosen. Test: none known. */
#define SUTURE_NYLON_MODULUS VBSS_TUNE(SUTURE_NYLON_MODULUS, 2.5e9)

/* ---- Twist with friction torque (contact_rolls.c) */

/* Twists per length that differ by more than this have different torques.
 * Unit: 1, relative to the sum of both. Origin: chosen: above rounding. Test: none known. */
#define THREAD_TORQUE_CHANGE VBSS_TUNE(THREAD_TORQUE_CHANGE, 1e-9)

/* ---- Baseline (baseline/divergence.c, thread_forces.c, thread_projection.c, thread_step.c) */

/* The bending energy is linear in the cosine beyond this turn.
 * Unit: 1, 1 + cosine of the turn. Origin: derived: 120 degrees cost 6.3 times the explicit substeps of a
 * straight thread. Test: none known. */
#define BASELINE_FOLD_COSINE VBSS_TUNE(BASELINE_FOLD_COSINE, 0.5)
/* The tension is that of the spring beyond this strain, where the projection failed.
 * Unit: 1, strain. Origin: chosen. Test: none known. */
#define BASELINE_MAX_STRETCH VBSS_TUNE(BASELINE_MAX_STRETCH, 1e-3)
/* Smooths the norm of the curvature near zero, where it has no direction.
 * Unit: 1, relative to the squared rest curvature. Origin: chosen. Test: none known. */
#define BASELINE_SMOOTH_CURVATURE_SQUARED VBSS_TUNE(BASELINE_SMOOTH_CURVATURE_SQUARED, 1e-6)
/* Constraints of a smaller pivot are dependent and already fulfilled.
 * Unit: 1, relative to the diagonal. Origin: chosen. Test: none known. */
#define BASELINE_SINGULAR_PIVOT_RATIO VBSS_TUNE(BASELINE_SINGULAR_PIVOT_RATIO, 1e-13)
/* A solve for the tensions alone needs larger pivots than this.
 * Unit: 1, relative to the diagonal. Origin: chosen. Test: none known. */
#define BASELINE_UNSOUND_PIVOT_RATIO VBSS_TUNE(BASELINE_UNSOUND_PIVOT_RATIO, 1e-6)
/* Stiffness of a spring that the step chooses itself.
 * Unit: 1, relative to the stable stiffness. Origin: chosen. Test: none known. */
#define BASELINE_SPRING_FRACTION VBSS_TUNE(BASELINE_SPRING_FRACTION, 0.75)
/* A longer segment, or a farther node of a drain, shows that the explicit method has diverged.
 * Unit: 1, relative to the body's length and the span of its attachments. Origin: chosen: three times
 * the stretch of a thread that is drawn 0.01 m beyond its length in 1 ms, which recovers.
 * Test: that of diverging threads. */
#define BASELINE_DIVERGENCE_RATIO VBSS_TUNE(BASELINE_DIVERGENCE_RATIO, 100.0)

#endif
