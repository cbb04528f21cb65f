/* Counts of the events of a scene's steps. */
#ifndef VBSS_TESTS_CONTRACT_EVENTS_H
#define VBSS_TESTS_CONTRACT_EVENTS_H

#include <string.h>

#include "harness/harness.h"

typedef struct event_counts {
    uint32_t of[64]; /* by kind */
} event_counts;

/* Adds the events of the last step; how many of them are cuts that made a piece. */
static inline uint32_t count_events(vbss_scene *scene, event_counts *counts)
{
    vbss_view view;
    uint32_t cuts = 0;
    expect_ok(vbss_scene_get_view(scene, VBSS_SCENE_VIEW_EVENTS, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        uint32_t words[4];
        memcpy(words, (const char *)view.data + i * view.stride_bytes, sizeof words);
        assert_in_range(words[0], 0, 63);
        counts->of[words[0]]++;
        cuts += words[0] == VBSS_SCENE_EVENT_CUT && words[2] != 0;
    }
    return cuts;
}

static inline uint32_t count_cuts(vbss_scene *scene)
{
    event_counts counts = {{0}};
    return count_events(scene, &counts);
}

#endif
