/* The parameters of the baseline, which a host gives in the configurations of five kinds of objects. */
#ifndef VBSS_BASE_BASELINE_CONFIG_H
#define VBSS_BASE_BASELINE_CONFIG_H

#include <vblast_ss/baseline.h>

/* Checks the parameters at *config, or takes the defaults where it is NULL, copies them to *own,
 * and lets *config point there. */
vbss_result vbss_baseline_read_config(vbss_context *context, const vbss_baseline_config **config,
                                      vbss_baseline_config *own);

#endif
