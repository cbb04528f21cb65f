/* Tuned numbers of lib/grasper.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md).
 * That page says why a number stays absolute. */
#ifndef VBSS_GRASPER_TUNING_H
#define VBSS_GRASPER_TUNING_H

#include "base/tune.h"

/* ---- Jaws (jaws.c, trocar.c) */

/* Round jaws grasp or cut a strand at most this far beside their middle.
 * Unit: 1, relative to the radius of the jaws. Origin: chosen. Test: none known. */
#define GRASPER_MAX_OFFSET_RATIO VBSS_TUNE(GRASPER_MAX_OFFSET_RATIO, 0.5)
/* A tip nearer to its trocar defines no shaft direction.
 * Unit: 1, relative to the length of the jaws. Origin: chosen. Test: none known. */
#define GRASPER_MIN_TROCAR_RATIO VBSS_TUNE(GRASPER_MIN_TROCAR_RATIO, 1e-10)

/* ---- Clamps (thread_clamp.c, needle_clamp.c) */

/* Stiffness of a clamp across its faces. A power of two is exact.
 * Unit: 1, relative to the stiffness along the faces. Origin: chosen. Test: graspers. */
#define GRASPER_NORMAL_STIFFNESS_RATIO VBSS_TUNE(GRASPER_NORMAL_STIFFNESS_RATIO, 64.0)
/* A grasped thread or needle reaches the middle of the jaws after this time.
 * Unit: s, absolute. Origin: chosen. Test: graspers, needle-hands. */
#define GRASPER_CENTRING_TIME VBSS_TUNE(GRASPER_CENTRING_TIME, 0.08)
/* A thread that is steeper to the faces is pushed aside and does not run through.
 * Unit: 1, cosine. Origin: chosen. Test: halved none known; doubled graspers. */
#define GRASPER_MIN_ALONG_FRACTION VBSS_TUNE(GRASPER_MIN_ALONG_FRACTION, 0.5)

#endif
