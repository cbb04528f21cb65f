/* Touch events: pairs of bodies that started or ceased to touch in a step. */
#include "scene/step/step.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

#include <string.h>

static bool precedes(scene_touching_pair x, scene_touching_pair y)
{
    return x.body_a != y.body_a ? x.body_a < y.body_a : x.body_b < y.body_b;
}

/* Inserts a pair in order unless it is listed. Linear search is enough for few pairs. */
void vbss_scene_insert_touching_pair(scene_object *s, scene_touching_pair touching_pair)
{
    uint32_t position = s->report.touching_pair_count;
    while (position > 0 && precedes(touching_pair, s->report.touching_pairs[position - 1])) {
        position--;
    }
    if (position > 0 && !precedes(s->report.touching_pairs[position - 1], touching_pair)) {
        return;
    }
    memmove(&s->report.touching_pairs[position + 1], &s->report.touching_pairs[position],
            (s->report.touching_pair_count - position) * sizeof *s->report.touching_pairs);
    s->report.touching_pairs[position] = touching_pair;
    s->report.touching_pair_count++;
}

void vbss_scene_list_touching_pairs(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->warm_start_count; i++) {
        const contact_key *key = &s->contacts->warm_start[i].key;
        const scene_touching_pair touching_pair = {key->body_a, key->body_b};
        vbss_scene_insert_touching_pair(s, touching_pair);
    }
}

static void emit_pair_event(scene_object *s, vbss_scene_event_kind kind, scene_touching_pair pair)
{
    const vbss_scene_event event = {.kind = kind, .body_a = pair.body_a, .body_b = pair.body_b};
    vbss_scene_add_event(s, &event, 0);
}

static void locate_touch_event(const scene_report *r, vbss_scene_event *event)
{
    for (uint32_t i = 0; i < r->contact_count; i++) {
        const uint32_t *features = r->contact_features[i];
        const double force = vec3_norm(r->contact_forces[i]);
        if (features[1] == event->body_a && features[3] == event->body_b && force > event->value) {
            event->value = force;
            event->flags |= VBSS_SCENE_EVENT_FLAG_POSITION;
            vec3_store(event->position, r->contact_points[i]);
        }
    }
}

void vbss_scene_locate_touch_events(scene_object *s)
{
    for (uint32_t i = 0; i < s->events.pending_count; i++) {
        if (s->events.pending[i].kind == VBSS_SCENE_EVENT_TOUCH) {
            locate_touch_event(&s->report, &s->events.pending[i]);
        }
    }
}

void vbss_scene_update_touching_pairs(scene_object *s)
{
    uint32_t count = s->report.touching_pair_count;
    scene_touching_pair *previous = s->report.touching_pairs;
    s->report.touching_pairs = s->report.previous_touching_pairs;
    s->report.previous_touching_pairs = previous;
    s->report.touching_pair_count = 0;
    s->method->list_touching_pairs(s);
    uint32_t o = 0, n = 0;
    while (o < count || n < s->report.touching_pair_count) {
        bool has_ended = n == s->report.touching_pair_count ||
                         (o < count && precedes(previous[o], s->report.touching_pairs[n]));
        bool has_begun =
            !has_ended && (o == count || precedes(s->report.touching_pairs[n], previous[o]));
        if (has_ended) {
            emit_pair_event(s, VBSS_SCENE_EVENT_PART, previous[o]);
        } else if (has_begun) {
            emit_pair_event(s, VBSS_SCENE_EVENT_TOUCH, s->report.touching_pairs[n]);
        }
        o += !has_begun;
        n += !has_ended;
    }
    vbss_scene_log_lost_events(s);
}
