/* Two hands (played_hand.h) lead the tools of a scene through mock devices and a session, under the eyes of task_watch. */
#ifndef VBSS_TESTS_SCENE_HAND_RUN_H
#define VBSS_TESTS_SCENE_HAND_RUN_H

#include <vblast_ss/session.h>

#include "fixtures/played_hand.h"
#include "scene/task_watch.h"

enum { HAND_RUN_HANDS = 2 };

typedef struct hand_run {
    harness_memory memory;
    vbss_context *context;
    bool owns_scene;                   /* and the context */
    double (*rows[HAND_RUN_HANDS])[8]; /* of a log */
    vbss_scene *scene;
    vbss_session_config config; /* with the numbers of the bodies */
    vbss_session *session;
    played_hand hands[HAND_RUN_HANDS]; /* to be set before the start */
    task_watch watch;
    uint64_t steps;
    uint64_t grasps;      /* events of jaws that grasp something */
    double largest_force; /* that a device wrote, N */
} hand_run;

/* A floor with a drain on it; beside it a needle with a thread at its swage; two tools with open jaws above. The random hands
 * hold them. */
void hand_run_begin(hand_run *r, uint64_t seed);
/* The hands of a log, in a scene like the one that it was recorded from. The scene and its context stay the caller's. */
void hand_run_begin_log(hand_run *r, vbss_context *context, vbss_scene *scene, const uint8_t *log,
                        uint64_t bytes);
/* Steps of 1 ms that the log's hands take at that speed. */
uint32_t hand_run_length(const hand_run *r, double speed);
void hand_run_end(hand_run *r); /* asserts that all memory came back */

/* Creates devices, session and watch. */
void hand_run_start(hand_run *r, double speed);
/* Steps of 1 ms. */
void hand_run_steps(hand_run *r, uint32_t count);
/* Prints what the watch has found. */
void hand_run_print(const hand_run *r, const char *name, double speed);
/* Asserts that nothing passed through anything, that no node was faster than 50 m/s, and that forces kept their limit. */
void hand_run_expect_kept(const hand_run *r);

#endif
