/* The list of events of a step. */
#include "scene/world/world.h"

void vbss_scene_clear_events(scene_object *s)
{
    s->report.event_count = s->report.lost_events = 0;
}

void vbss_scene_add_event(scene_object *s, vbss_scene_event_kind kind, uint32_t a, uint32_t b,
                          uint32_t number)
{
    if (s->report.event_count == s->config.event_capacity) {
        s->report.lost_events++;
        return;
    }
    uint32_t *event = s->report.events[s->report.event_count++];
    event[0] = (uint32_t)kind;
    event[1] = a;
    event[2] = b;
    event[3] = number;
}

void vbss_scene_write_lost_event(scene_object *s)
{
    if (s->report.lost_events > 0 && s->config.event_capacity > 0) { /* replaces the last event */
        uint32_t *last = s->report.events[s->config.event_capacity - 1];
        last[0] = VBSS_SCENE_EVENT_LOST;
        last[1] = last[2] = 0;
        last[3] = s->report.lost_events + 1;
    }
}

void vbss_scene_emit_cut_event(scene_object *s, const scene_body *thread, const scene_body *piece,
                               double arc_length)
{
    uint32_t um = (uint32_t)(vbss_min(1e6 * arc_length, 4e9) + 0.5);
    vbss_scene_add_event(s, VBSS_SCENE_EVENT_CUT, thread->number, piece != NULL ? piece->number : 0,
                         um);
    vbss_scene_write_lost_event(s);
}
