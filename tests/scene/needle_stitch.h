/* A needle with its thread that a hand turns through both walls at a mark: needle and thread are watched, and events have their
 * steps. Every call that fails, fails the test. */
#ifndef VBSS_TESTS_SCENE_NEEDLE_STITCH_H
#define VBSS_TESTS_SCENE_NEEDLE_STITCH_H

#include "scene/needle_case.h"
#include "scene/stitch_watch.h"

typedef struct needle_stitch {
    needle_case c;
    stitch_watch watch;
    uint32_t thread_body, steps;
    /* When an event came first and last: steps, from 1 on; 0: never. */
    uint32_t first[NEEDLE_CASE_EVENTS], last[NEEDLE_CASE_EVENTS];
} needle_stitch;

void needle_stitch_begin(needle_stitch *n);
void needle_stitch_wait(needle_stitch *n, uint32_t count);
/* Turns the tip on (below 0: back) by that distance at that speed, up to so many events of that kind in all; 0: none is waited
 * for. */
void needle_stitch_turn(needle_stitch *n, double distance, double speed,
                        vbss_scene_event_kind until, uint32_t count);
/* Into both walls, and on until the thread is in the first hole. */
void needle_stitch_into_second(needle_stitch *n, double speed);
/* Draws the thread's tail away from the first mark, with that force, N. */
void needle_stitch_draw(needle_stitch *n, double force);
/* Turned back while its thread is drawn with that force, N, the needle goes back through both holes, each event once: none is
 * left. */
void needle_stitch_expect_undone(needle_stitch *n, double force, double speed);
/* So many holes, so many of them with the thread in it. */
void needle_stitch_expect_in(const needle_stitch *n, uint32_t holes, uint32_t threads);
/* Tells; nothing has crossed the wall but in holes; ends. */
void needle_stitch_finish(needle_stitch *n, const char *name);
/* The same, where so many steps may be cut short. */
void needle_stitch_finish_clamped(needle_stitch *n, const char *name, uint32_t max_clamped);

#endif
