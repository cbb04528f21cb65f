/* A trial as a simulator would tell it: two hands at uneven times, with all kinds of events, some of them undone, and a
 * pull test at the end. What its tests and the determinism table step. */
#ifndef VBSS_TESTS_SCENES_METRICS_RUN_H
#define VBSS_TESTS_SCENES_METRICS_RUN_H

#include "metrics/metrics.h"

enum { METRICS_RUN_STEPS = 300 };

vbss_result metrics_run_create(vbss_context *context, vbss_metrics **metrics);
/* The next step, by the number of samples taken: so a restored measurement goes on where it was. */
vbss_result metrics_run_step(vbss_metrics *metrics);

#endif
