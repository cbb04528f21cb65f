/* Divergence of the explicit method: states that no thread and no drain can reach. */
#ifndef VBSS_BASELINE_DIVERGENCE_H
#define VBSS_BASELINE_DIVERGENCE_H

#include "drain/drain.h"
#include "thread/thread.h"

/* Fails with VBSS_ERROR_NOT_FINITE and a text if a number is not finite, or if a segment is longer
 * than BASELINE_DIVERGENCE_RATIO times the rest length of the thread plus the distance that its
 * attachments span. A thread that moves as a whole does not count. */
vbss_result vbss_baseline_check_thread(const thread_object *t);
/* Fails likewise if a node is farther from its rest position than that ratio times the length of
 * the drain plus the largest such distance of an attachment. */
vbss_result vbss_baseline_check_drain(const drain_object *d);

#endif
