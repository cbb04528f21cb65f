/* Serialisation of the warm-start entries. */
#include "base/stream.h"
#include "contact/contact.h"

void vbss_contact_serialise(vbss_stream *stream, uint16_t first_tag, contact_set *set)
{
    vbss_stream_count(stream, first_tag, &set->warm_start_count, set->capacity);
    for (uint32_t i = 0; i < set->warm_start_count; i++) {
        contact_warm_start_entry *entry = &set->warm_start[i];
        vbss_stream_u32(stream, (uint16_t)(first_tag + 1), &entry->key.kind, 5);
        vbss_stream_u32(stream, (uint16_t)(first_tag + 2), &entry->status, 1);
        vbss_stream_f64(stream, (uint16_t)(first_tag + 3), &entry->normal_force, 1);
        vbss_stream_f64(stream, (uint16_t)(first_tag + 4), &entry->tangential_force.x, 3);
        vbss_stream_f64(stream, (uint16_t)(first_tag + 5), &entry->friction_ratio, 1);
        bool check = stream->mode == VBSS_STREAM_READ && !stream->trusted;
        if (check &&
            (entry->status > (uint32_t)CONTACT_SLIP || entry->status == (uint32_t)CONTACT_OPEN ||
             !(entry->friction_ratio >= 0.0 && entry->friction_ratio <= 1.0) ||
             (i > 0 && vbss_contact_compare_keys(&entry[-1].key, &entry->key) >= 0))) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such contact");
        }
    }
    vbss_stream_f64(stream, (uint16_t)(first_tag + 6), &set->residual, 1);
    vbss_stream_u64(stream, (uint16_t)(first_tag + 7), &set->counters.solves, 1);
    vbss_stream_u64(stream, (uint16_t)(first_tag + 8), &set->counters.inexact, 1);
}
