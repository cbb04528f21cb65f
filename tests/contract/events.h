/* Counts of the events of a scene's steps. */
#ifndef VBSS_TESTS_CONTRACT_EVENTS_H
#define VBSS_TESTS_CONTRACT_EVENTS_H

#include <string.h>

#include "harness/harness.h"

typedef struct event_counts {
    uint32_t of[64]; /* by kind */
} event_counts;

/* Takes the events and counts them; how many of them are cuts that made a piece. */
static inline uint32_t count_events(vbss_scene *scene, event_counts *counts)
{
    vbss_scene_event events[64];
    uint32_t count, cuts = 0;
    uint64_t lost;
    do {
        expect_ok(vbss_scene_take_events(scene, events, sizeof *events, 64, &count, &lost));
        assert_int_equal(lost, 0);
        for (uint32_t i = 0; i < count; i++) {
            assert_in_range(events[i].kind, 1, 63);
            counts->of[events[i].kind]++;
            cuts += events[i].kind == VBSS_SCENE_EVENT_CUT && events[i].body_b != 0;
        }
    } while (count == 64);
    return cuts;
}

static inline uint32_t count_cuts(vbss_scene *scene)
{
    event_counts counts = {{0}};
    return count_events(scene, &counts);
}

#endif
