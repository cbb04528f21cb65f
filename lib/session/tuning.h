/* Tuned numbers of lib/session.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md). */
#ifndef VBSS_SESSION_TUNING_H
#define VBSS_SESSION_TUNING_H

#include "base/tune.h"

/* ---- Events (device_io.c, outcome.c) */

/* A refused tool exchange is requested again after this many steps. At 2 kHz that is half the time.
 * Unit: steps. Origin: chosen. Test: none known. */
#define SESSION_EXCHANGE_RETRY_STEPS VBSS_TUNE(SESSION_EXCHANGE_RETRY_STEPS, 250)
/* A cut that takes off less is no cut of a limb.
 * Unit: 1, relative to the length of the thread. Origin: chosen: above rounding, below the thread's diameter.
 * Test: none known. */
#define SESSION_MIN_CUT_RATIO VBSS_TUNE(SESSION_MIN_CUT_RATIO, 1e-5)

#endif
