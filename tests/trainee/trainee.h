/* A trainee with a mouse, as a program: what a person sees and does. Both hands are those of the viewer's window (examples/viewer/live.h),
 * moved by counts of the mouse, notches of the wheel and the keys alone. It sees, 200 ms late and with errors, the tips of the tools and of the
 * needle, what the caption says of the jaws, and what the coach says. It moves as people do: one movement at a time, each planned from what is
 * seen once the one before has been seen to end, with an error that grows with its length. */
#ifndef VBSS_TESTS_TRAINEE_TRAINEE_H
#define VBSS_TESTS_TRAINEE_TRAINEE_H

#include "viewer/live.h"

enum {
    TRAINEE_DELAY = 13
}; /* frames of 16 ms between what happens and what is acted upon: 208 ms */

/* What is seen in a frame. */
typedef struct sight {
    vec tip[SIDES], needle; /* m */
    vec jaws[SIDES];        /* unit: where they point */
    vec opens[SIDES];       /* unit: along which they open */
    bool holds[SIDES];      /* the needle, or the thread, as the caption says */
    bool has_needle[SIDES];
    bool shears[SIDES];
    vbss_session_coaching coach;
} sight;

typedef struct trainee {
    live live;
    uint64_t random;
    sight past[TRAINEE_DELAY + 1];
    uint64_t frames;
    double noise; /* share of the length of a movement; 0.05 is usual */
    bool verbose;
} trainee;

vbss_result trainee_begin(trainee *t, vbss_session_exercise exercise, const start_states *states,
                          uint64_t seed, const char *log);
void trainee_end(trainee *t);
/* Frames pass; false: the exercise has ended, or a step failed. */
bool trainee_wait(trainee *t, int frames);
/* What is seen now: what was 200 ms ago. */
const sight *trainee_see(const trainee *t);
/* Waits until all that was done is seen. */
bool trainee_settle(trainee *t);
/* One movement of a hand, as it is meant. */
bool trainee_move(trainee *t, int side, vec by);
/* Movements until the tip is seen within `near` of the place, 12 at most. */
bool trainee_go(trainee *t, int side, vec to, double near);
bool trainee_roll(trainee *t, int side, double angle);
/* Until the jaws open square to what lies in that direction. */
bool trainee_roll_across(trainee *t, int side, vec direction);
bool trainee_jaws(trainee *t, int side, bool closes);
bool trainee_aid(trainee *t, uint32_t aid);
bool trainee_exchange(trainee *t, int side);
bool trainee_has_ended(const trainee *t, vbss_session_exercise_state *state);

/* ---- lessons.c: how each exercise is done, from what the coach says */

void lesson_take_needle(trainee *t);
void lesson_pass_mark(trainee *t);
void lesson_cut(trainee *t);

#endif
