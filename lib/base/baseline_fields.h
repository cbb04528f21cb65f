/* Fields of a configuration that points to parameters of the baseline. */
#ifndef VBSS_BASE_BASELINE_FIELDS_H
#define VBSS_BASE_BASELINE_FIELDS_H

#include <vblast_ss/baseline.h>

#include "base/fields.h"

/* The fields of both, in the order of their section. An offset below `baseline_offset` counts in the
 * configuration, another one from there in the parameters. */
typedef struct vbss_baseline_fields {
    const vbss_field *fields;
    size_t count, baseline_offset;
    uint32_t section; /* its code; the version is 1 */
} vbss_baseline_fields;

/* Visits both in a section of their own. */
void vbss_baseline_visit_config(vbss_stream *stream, const vbss_baseline_fields *table,
                                void *config, vbss_baseline_config *baseline);

#endif
