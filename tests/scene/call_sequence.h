/* Random calls on two scenes that are created alike: one receives every call, the other only those that the first did
 * not refuse. */
#ifndef VBSS_TESTS_SCENE_CALL_SEQUENCE_H
#define VBSS_TESTS_SCENE_CALL_SEQUENCE_H

#include "scene/small.h"

/* What the calls of all cases came to. */
typedef struct call_counts {
    uint64_t calls, refused, refused_suspended, failed_steps, failed_allocations, restores,
        restores_suspended, grouped, frozen;
} call_counts;

/* A property of the harness; `counts` is a call_counts, to which the case is added. It asserts that
 *   - a refused call, a failed allocation included, leaves the snapshot, the generation, the views and the events as
 *     they were, and the next steps have the same bits as those of the other scene;
 *   - bodies that wait for others within a step stay where they are;
 *   - a scene that is saved and restored goes on to the same bits. */
void call_sequence(harness_source *source, void *counts);

/* Asserts that many cases together have met each kind of trouble. A single case that is replayed need not. */
void call_sequence_expect_variety(const call_counts *counts);

#endif
