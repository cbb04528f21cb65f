/* Tuned numbers of lib/session.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md). */
#ifndef VBSS_SESSION_TUNING_H
#define VBSS_SESSION_TUNING_H

#include "base/tune.h"

/* ---- Events (device_io.c, outcome.c, throws.c) */

/* A half hitch begins or ends after this many times throw_dwell: its measure swings from -1 to 1
 * within 0.1 s while a throw is drawn tight. With 20 the demonstration reports it once, with 1 it
 * reports it 38 times. Unit: 1, relative to throw_dwell. Origin: chosen. Test: session.reversals. */
#define SESSION_HITCH_DWELLS VBSS_TUNE(SESSION_HITCH_DWELLS, 20.0)

/* A refused tool exchange is requested again after this many steps. At 2 kHz that is half the time.
 * Unit: steps. Origin: chosen. Test: none known. */
#define SESSION_EXCHANGE_RETRY_STEPS VBSS_TUNE(SESSION_EXCHANGE_RETRY_STEPS, 250)
/* Smallest share of the thread whose removal counts as a cut of a limb.
 * Unit: 1, relative to the length of the thread. Origin: chosen: above rounding, below the thread's diameter.
 * Test: none known. */
#define SESSION_MIN_CUT_RATIO VBSS_TUNE(SESSION_MIN_CUT_RATIO, 1e-5)

/* ---- Clock (clock.c) */

/* Lost time that was reported is withdrawn below this part of config.lost_share.
 * Unit: 1, relative to config.lost_share. Origin: chosen. Test: none known. */
#define SESSION_LOST_SHARE_HYSTERESIS VBSS_TUNE(SESSION_LOST_SHARE_HYSTERESIS, 0.5)

#endif
