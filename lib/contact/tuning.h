/* Tuned numbers of lib/contact.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md).
 * That page says why a number stays absolute. */
#ifndef VBSS_SCENE_CONTACT_TUNING_H
#define VBSS_SCENE_CONTACT_TUNING_H

#include "base/tune.h"

/* ---- Work (active_set.c) */

/* Cost of a separator in a solve.
 * Unit: operations of the step budget. Origin: fitted: thread CPU time of the 36000 steps of a surgeon's first
 * throw. Test: scene-tools, scene-mesh, graspers, needle-hands, session. */
#define CONTACT_SEPARATOR_COST VBSS_TUNE(CONTACT_SEPARATOR_COST, 70)

/* ---- Line search (active_set.c) */

/* The full step is taken when the slope at its end is below this.
 * Unit: 1, relative to the slope at the start. Origin: chosen. Test: scene-tools, scene-mesh, needle-hands,
 * session. */
#define CONTACT_FULL_STEP_SLOPE_RATIO VBSS_TUNE(CONTACT_FULL_STEP_SLOPE_RATIO, 0.5)
/* The line search ends at a slope below this.
 * Unit: 1, relative to the slope at the start. Origin: chosen. Test: scene-tools, scene-mesh, needle-hands,
 * session. */
#define CONTACT_SLOPE_TOLERANCE VBSS_TUNE(CONTACT_SLOPE_TOLERANCE, 0.1)
/* Steps of false position in a line search.
 * Unit: evaluations. Origin: chosen. Test: scene-tools, scene-mesh, graspers, needle-hands, session. */
#define CONTACT_FALSE_POSITION_STEPS VBSS_TUNE(CONTACT_FALSE_POSITION_STEPS, 8)
/* Steps of bisection after false position.
 * Unit: evaluations. Origin: chosen. Test: scene-mesh, graspers, needle-hands. */
#define CONTACT_BISECTION_STEPS VBSS_TUNE(CONTACT_BISECTION_STEPS, 8)
/* Shortest step of a line search.
 * Unit: 1, relative to the full step. Origin: chosen. Test: scene-tools, scene-mesh, needle-hands, session. */
#define CONTACT_MIN_STEP_FRACTION VBSS_TUNE(CONTACT_MIN_STEP_FRACTION, 0.005)
/* Bisection continues a search that ended below this fraction, unless contacts have been softened.
 * Unit: 1, relative to the full step. Origin: chosen. Test: scene-mesh, needle-hands, session. */
#define CONTACT_SHORT_STEP_FRACTION VBSS_TUNE(CONTACT_SHORT_STEP_FRACTION, 0.1)
/* Step length where the step does not descend at its start and the slope at its end is worse.
 * Unit: 1, relative to the full step. Origin: chosen. Test: scene-tools, scene-mesh, graspers, needle-hands,
 * session. */
#define CONTACT_DOUBTFUL_STEP_FRACTION VBSS_TUNE(CONTACT_DOUBTFUL_STEP_FRACTION, 0.5)

/* ---- Penalty continuation and convergence (active_set.c) */

/* All contacts are softened from this overlap on.
 * Unit: 1, relative to the contact distance. Origin: chosen. Test: halved scene-mesh, graspers, needle-hands,
 * session; doubled scene-tools, scene-mesh, graspers, needle-hands. */
#define CONTACT_DEEP_OVERLAP VBSS_TUNE(CONTACT_DEEP_OVERLAP, 0.2)
/* Solves within which a deep overlap softens contacts.
 * Unit: solves. Origin: chosen. Test: halved scene-tools, scene-mesh, needle-hands; doubled none known. */
#define CONTACT_DEEP_SOLVES VBSS_TUNE(CONTACT_DEEP_SOLVES, 2)
/* All contacts are softened after this many solves without convergence.
 * Unit: solves. Origin: chosen. Test: halved scene-tools, scene-mesh, graspers, needle-hands, session; doubled
 * scene-tools, scene-mesh, needle-hands, session. */
#define CONTACT_STUCK_SOLVES VBSS_TUNE(CONTACT_STUCK_SOLVES, 9)
/* Softened contacts are stiffened after this many solves at the latest.
 * Unit: solves. Origin: chosen. Test: halved scene-tools, scene-mesh, needle-hands, session; doubled scene-
 * tools, scene-mesh, session. */
#define CONTACT_SOFT_SOLVES VBSS_TUNE(CONTACT_SOFT_SOLVES, 5)
/* Stiffness of softened contacts. A power of two is exact.
 * Unit: 1, relative to the contact stiffness. Origin: chosen. Test: scene-tools, scene-mesh, graspers, needle-
 * hands, session. */
#define CONTACT_SOFT_STIFFNESS_SCALE VBSS_TUNE(CONTACT_SOFT_STIFFNESS_SCALE, 1.0 / 256.0)
/* Factor by which softened contacts are stiffened. The scale is a power of it.
 * Unit: 1. Origin: chosen. Test: scene-tools, scene-mesh, graspers, needle-hands, session. */
#define CONTACT_STIFFEN_FACTOR VBSS_TUNE(CONTACT_STIFFEN_FACTOR, 16.0)
/* Softened contacts count as converged below this overlap.
 * Unit: 1, relative to the contact distance. Origin: chosen. Test: halved session; doubled needle-hands. */
#define CONTACT_SOFT_OVERLAP VBSS_TUNE(CONTACT_SOFT_OVERLAP, 0.05)
/* A solve makes progress when it lowers the residual to this.
 * Unit: 1, relative to the residual at the last progress. Origin: chosen. Test: halved scene-tools, scene-
 * mesh, needle-hands, session; doubled scene-mesh, needle-hands, session. */
#define CONTACT_PROGRESS_RATIO VBSS_TUNE(CONTACT_PROGRESS_RATIO, 0.5)

/* ---- Contact law (contact_law.c) */

/* Largest ratio of friction force to augmented force of a slipping contact. At 1 it would stick.
 * Unit: 1, relative to the augmented force. Origin: chosen. Test: halved scene-tools, scene-mesh, graspers,
 * needle-hands, session; doubled scene-tools, needle-hands, session. */
#define CONTACT_MAX_FRICTION_RATIO VBSS_TUNE(CONTACT_MAX_FRICTION_RATIO, 0.999999)
/* Largest friction ratio of a contact that has just closed, whose slip direction is a guess.
 * Unit: 1, relative to the augmented force. Origin: chosen. Test: scene-tools, scene-mesh, graspers, needle-
 * hands, session. */
#define CONTACT_FIRST_FRICTION_RATIO VBSS_TUNE(CONTACT_FIRST_FRICTION_RATIO, 0.9)
/* A contact that closes slips if it moves farther than this, and sticks otherwise.
 * Unit: m, absolute. Origin: chosen. Test: scene-mesh, needle-hands, session. */
#define CONTACT_MIN_SLIP_ON_CLOSING VBSS_TUNE(CONTACT_MIN_SLIP_ON_CLOSING, 1e-7)
/* After this many solves without progress the yield force of a sleeve is lagged.
 * Unit: solves. Origin: chosen. Test: scene.hole_passage. */
#define CONTACT_LAG_STALLED_SOLVES VBSS_TUNE(CONTACT_LAG_STALLED_SOLVES, 4)
/* A sleeve's force may miss its direction by this, which changes it by the square.
 * Unit: 1, relative to the force. Origin: chosen. Test: none known. */
#define CONTACT_SLEEVE_TOLERANCE VBSS_TUNE(CONTACT_SLEEVE_TOLERANCE, 1e-4)
/* A force whose tangential part is smaller has no direction in the plane.
 * Unit: 1, relative to the squared force. Origin: chosen. Test: none known. */
#define CONTACT_MIN_TANGENT_SQUARED VBSS_TUNE(CONTACT_MIN_TANGENT_SQUARED, 1e-12)

/* ---- Tears at sleeves (contact_law.c) */

/* A transverse force tears a wall only if at least this part of it lies in the plane of the wall. Below, a
 * small yield would move the hole far.
 * Unit: 1. Origin: chosen. Test: none known. */
#define CONTACT_MIN_TEAR_SHARE VBSS_TUNE(CONTACT_MIN_TEAR_SHARE, 0.2)

#endif
