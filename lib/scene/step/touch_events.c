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
            vbss_scene_add_event(s, VBSS_SCENE_EVENT_PART, previous[o].body_a, previous[o].body_b,
                                 0);
        } else if (has_begun) {
            vbss_scene_add_event(s, VBSS_SCENE_EVENT_TOUCH, s->report.touching_pairs[n].body_a,
                                 s->report.touching_pairs[n].body_b, 0);
        }
        o += !has_begun;
        n += !has_ended;
    }
    vbss_scene_write_lost_event(s);
}
