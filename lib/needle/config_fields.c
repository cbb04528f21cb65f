/* The configuration of a needle as fields, for descriptions of scenes. */
#include "base/fields.h"
#include "needle/needle.h"

_Static_assert(sizeof(vbss_needle_config) == 192, "new fields must be listed, with a new version");

#define NUMBER(name) VBSS_NUMBER(vbss_needle_config, name)

/* Without the initial motion, which is part of the state. */
static const vbss_field fields[] = {
    VBSS_WORD(vbss_needle_config, method),
    VBSS_WORD(vbss_needle_config, segment_count),
    NUMBER(radius),
    NUMBER(wire_radius),
    NUMBER(arc),
    NUMBER(density),
    NUMBER(friction),
    NUMBER(drag),
    VBSS_NUMBERS(vbss_needle_config, gravity, 3),
};

void vbss_needle_visit_config(vbss_stream *stream, vbss_needle_config *config)
{
    vbss_section outer = vbss_stream_open(stream, VBSS_CODE('N', 'C', 'F', 'G'), 1);
    vbss_stream_fields(stream, fields, sizeof fields / sizeof fields[0], config);
    vbss_stream_close(stream, outer);
}
