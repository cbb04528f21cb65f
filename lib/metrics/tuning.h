/* Tuned numbers of lib/metrics.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md).
 * That page says why a number stays absolute. */
#ifndef VBSS_METRICS_TUNING_H
#define VBSS_METRICS_TUNING_H

#include "base/tune.h"

/* ---- Motion (outliers.c, tracks.c, motion.c, smoothing.c, spectrum.c) */

/* A sample this far beyond the reach of the hand is not an outlier yet: noise of sensors and of clocks.
 * Unit: m, absolute. Origin: chosen. Test: none known. */
#define METRICS_OUTLIER_TOLERANCE VBSS_TUNE(METRICS_OUTLIER_TOLERANCE, 1e-3)

/* A tool without a sample for longer is gone.
 * Unit: s, absolute. Origin: derived: three samples at 30 Hz. Test: none known. */
#define METRICS_MAX_SAMPLE_GAP VBSS_TUNE(METRICS_MAX_SAMPLE_GAP, 0.1)
/* A shorter movement has no spectrum.
 * Unit: ticks of 10 ms. Origin: chosen. Test: none known. */
#define METRICS_SHORTEST_MOVEMENT VBSS_TUNE(METRICS_SHORTEST_MOVEMENT, 20)
/* The smoothing passes half of the amplitude at this frequency.
 * Unit: Hz. Origin: chosen. Test: none known. */
#define METRICS_CUTOFF_FREQUENCY VBSS_TUNE(METRICS_CUTOFF_FREQUENCY, 10.0)
/* Largest frequency of a spectrum.
 * Unit: Hz. Origin: published with the spectral arc length. Test: none known. */
#define METRICS_MAX_FREQUENCY VBSS_TUNE(METRICS_MAX_FREQUENCY, 20.0)
/* A spectrum ends where its amplitude stays below this.
 * Unit: 1, relative to the amplitude at 0 Hz. Origin: published with the spectral arc length. Test: none
 * known. */
#define METRICS_AMPLITUDE_THRESHOLD VBSS_TUNE(METRICS_AMPLITUDE_THRESHOLD, 0.05)

/* ---- Lost time (report.c) */

/* A shorter time counts as this long, so that a single lost step is a small share of it.
 * Unit: s, absolute. Origin: chosen. Test: none known. */
#define METRICS_LOST_TIME_WINDOW VBSS_TUNE(METRICS_LOST_TIME_WINDOW, 1.0)

/* ---- Pull test (pull_test.c) */

/* A pull that has begun may fall to this fraction.
 * Unit: 1, relative to the configured pull. Origin: chosen. Test: none known. */
#define METRICS_HOLD_HYSTERESIS VBSS_TUNE(METRICS_HOLD_HYSTERESIS, 0.9)

#endif
