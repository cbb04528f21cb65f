/* Visits a configuration together with the parameters of the baseline. */
#include "base/baseline_fields.h"

void vbss_baseline_visit_config(vbss_stream *stream, const vbss_baseline_fields *table,
                                void *config, vbss_baseline_config *baseline)
{
    vbss_section outer = vbss_stream_open(stream, table->section, 1);
    for (size_t i = 0; i < table->count; i++) {
        const size_t offset = table->fields[i].offset;
        char *values = offset < table->baseline_offset
                           ? (char *)config + offset
                           : (char *)baseline + (offset - table->baseline_offset);
        vbss_stream_field(stream, (uint16_t)i, &table->fields[i], values);
    }
    vbss_stream_close(stream, outer);
}
