/* What method VBLAST counts in objects of several modules. */
#ifndef VBSS_BASE_BASELINE_STATISTICS_H
#define VBSS_BASE_BASELINE_STATISTICS_H

#include <vblast_ss/baseline.h>

/* Writes the counters to the caller's struct. VBSS_ERROR_INCOMPATIBLE if `own` is NULL: the object uses
 * another method. */
vbss_result vbss_baseline_write_statistics(vbss_context *context,
                                           const vbss_baseline_statistics *own,
                                           vbss_baseline_statistics *statistics,
                                           uint32_t struct_size);

#endif
