/* The events of a step. */
#include "knot/knot.h"

void vbss_knot_emit_event(knot_detector *d, vbss_knot_event kind, uint32_t a, uint32_t b,
                          uint32_t c)
{
    if (d->event_count < d->config.event_capacity) {
        d->events[d->event_count++] = (knot_event){(uint32_t)kind, {a, b, c}};
        return;
    }
    d->events_lost++;
    d->events[d->event_count - 1] = (knot_event){VBSS_KNOT_EVENT_LOST, {d->events_lost + 1, 0, 0}};
}
