/* Serialisation of the warm-start entries. */
#include "base/stream.h"
#include "contact/contact.h"

/* The format has one number for the friction ratio of a contact, which is below 1, and the direction
 * of a sleeve: 1 forward, 0 backward. */
static void serialise_slip(vbss_stream *stream, uint16_t tag, contact_warm_start_entry *entry)
{
    double number = entry->is_forward ? 1.0 : entry->friction_ratio;
    vbss_stream_f64(stream, tag, &number, 1);
    if (stream->mode == VBSS_STREAM_READ) {
        entry->is_forward = number == 1.0;
        entry->friction_ratio = entry->is_forward ? 0.0 : number;
    }
}

void vbss_contact_serialise(vbss_stream *stream, uint16_t first_tag, contact_set *set)
{
    vbss_stream_count(stream, first_tag, &set->warm_start_count, set->capacity);
    for (uint32_t i = 0; i < set->warm_start_count; i++) {
        contact_warm_start_entry *entry = &set->warm_start[i];
        vbss_stream_u32(stream, (uint16_t)(first_tag + 1), &entry->key.kind, 5);
        uint32_t status = entry->status;
        vbss_stream_u32(stream, (uint16_t)(first_tag + 2), &status, 1);
        entry->status = (uint8_t)status;
        vbss_stream_f64(stream, (uint16_t)(first_tag + 3), &entry->normal_force, 1);
        vbss_stream_f64(stream, (uint16_t)(first_tag + 4), &entry->tangential_force.x, 3);
        serialise_slip(stream, (uint16_t)(first_tag + 5), entry);
        bool check = stream->mode == VBSS_STREAM_READ && !stream->trusted;
        if (check && (status > (uint32_t)CONTACT_SLIP || status == (uint32_t)CONTACT_OPEN ||
                      !(entry->friction_ratio >= 0.0 && entry->friction_ratio <= 1.0) ||
                      (i > 0 && vbss_contact_compare_keys(&entry[-1].key, &entry->key) >= 0))) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such contact");
        }
    }
    vbss_stream_f64(stream, (uint16_t)(first_tag + 6), &set->residual, 1);
    vbss_stream_u64(stream, (uint16_t)(first_tag + 7), &set->counters.solves, 1);
    vbss_stream_u64(stream, (uint16_t)(first_tag + 8), &set->counters.inexact, 1);
}
