/* What happened in a step: who touches whom, and what went wrong. */
#include "scene/events.h"
#include "scene/scene.h"

#include <string.h>

void vbss_scene_begin_events(scene_object *s)
{
    s->event_count = s->lost_events = 0;
}

void vbss_scene_add_event(scene_object *s, vbss_event_kind kind, uint32_t a, uint32_t b,
                          uint32_t number)
{
    if (s->event_count == s->config.event_capacity) {
        s->lost_events++;
        return;
    }
    uint32_t *event = s->events[s->event_count++];
    event[0] = (uint32_t)kind;
    event[1] = a;
    event[2] = b;
    event[3] = number;
}

static bool before(scene_touch x, scene_touch y)
{
    return x.body_a != y.body_a ? x.body_a < y.body_a : x.body_b < y.body_b;
}

/* Few pairs of bodies: inserted in order, each once. */
static void insert(scene_object *s, scene_touch touch)
{
    uint32_t to = s->touch_count;
    while (to > 0 && before(touch, s->touches[to - 1])) {
        to--;
    }
    if (to > 0 && !before(s->touches[to - 1], touch)) {
        return;
    }
    memmove(&s->touches[to + 1], &s->touches[to], (s->touch_count - to) * sizeof *s->touches);
    s->touches[to] = touch;
    s->touch_count++;
}

static void list_touches(scene_object *s)
{
    s->touch_count = 0;
    for (uint32_t i = 0; s->contacts != NULL && i < s->contacts->warm_start_count; i++) {
        const contact_key *key = &s->contacts->warm_start[i].key;
        const scene_touch touch = {key->body_a, key->body_b};
        insert(s, touch);
    }
    for (uint32_t i = 0; i < s->hit_count; i++) { /* PAPER */
        const scene_touch touch = {s->hits[i].key.body_a, s->hits[i].key.body_b};
        insert(s, touch);
    }
}

void vbss_scene_note_touches(scene_object *s)
{
    uint32_t count = s->touch_count;
    scene_touch *old = s->touches;
    s->touches = s->touches_before;
    s->touches_before = old;
    list_touches(s);
    uint32_t o = 0, n = 0;
    while (o < count || n < s->touch_count) {
        bool gone = n == s->touch_count || (o < count && before(old[o], s->touches[n]));
        bool come = !gone && (o == count || before(s->touches[n], old[o]));
        if (gone) {
            vbss_scene_add_event(s, VBSS_EVENT_PART, old[o].body_a, old[o].body_b, 0);
        } else if (come) {
            vbss_scene_add_event(s, VBSS_EVENT_TOUCH, s->touches[n].body_a, s->touches[n].body_b,
                                 0);
        }
        o += !come;
        n += !gone;
    }
    vbss_scene_show_lost(s);
}

void vbss_scene_show_lost(scene_object *s)
{
    if (s->lost_events > 0 && s->config.event_capacity > 0) { /* in the place of the last */
        uint32_t *last = s->events[s->config.event_capacity - 1];
        last[0] = VBSS_EVENT_LOST;
        last[1] = last[2] = 0;
        last[3] = s->lost_events + 1;
    }
}
