/* What contacts remember: saved, hashed and restored. */
#include "base/stream.h"
#include "contact/contact.h"

void vbss_contact_serialise(vbss_stream *stream, uint16_t first_tag, contact_set *set)
{
    vbss_stream_count(stream, first_tag, &set->memory_count, set->capacity);
    for (uint32_t i = 0; i < set->memory_count; i++) {
        contact_memory *m = &set->memory[i];
        vbss_stream_u32(stream, (uint16_t)(first_tag + 1), &m->key.kind, 5);
        vbss_stream_u32(stream, (uint16_t)(first_tag + 2), &m->state, 1);
        vbss_stream_f64(stream, (uint16_t)(first_tag + 3), &m->pressure, 1);
        vbss_stream_f64(stream, (uint16_t)(first_tag + 4), &m->rubbing.x, 3);
        vbss_stream_f64(stream, (uint16_t)(first_tag + 5), &m->share, 1);
        bool check = stream->mode == VBSS_STREAM_READ && !stream->trusted;
        if (check && (m->state > (uint32_t)CONTACT_SLIP || m->state == (uint32_t)CONTACT_OPEN ||
                      !(m->share >= 0.0 && m->share <= 1.0) ||
                      (i > 0 && vbss_contact_compare(&m[-1].key, &m->key) >= 0))) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such contact");
        }
    }
    vbss_stream_f64(stream, (uint16_t)(first_tag + 6), &set->residual, 1);
    vbss_stream_u64(stream, (uint16_t)(first_tag + 7), &set->counters.solves, 1);
    vbss_stream_u64(stream, (uint16_t)(first_tag + 8), &set->counters.loose, 1);
}
