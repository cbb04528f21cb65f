/* A trainee with a mouse, as a program. Both hands are those of the viewer's window (examples/viewer/live.h), moved by counts of
 * the mouse, notches of the wheel and keys alone. It sees, 200 ms late and with errors, the tips of the tools and of the needle, the
 * colours of the thread, the caption of the jaws, and the coach. It moves as people do: one movement at a time, each planned from
 * the view after the one before, with an error that grows with its length. */
#ifndef VBSS_TESTS_TRAINEE_TRAINEE_H
#define VBSS_TESTS_TRAINEE_TRAINEE_H

#include "viewer/live.h"

enum { TRAINEE_DELAY = 13 }; /* frames of 16 ms between an event and the reaction to it: 208 ms */

/* The view of a frame. */
typedef struct sight {
    vec tip[SIDES], needle; /* m */
    vec jaws[SIDES];        /* unit: where they point */
    vec opens[SIDES];       /* unit: along which they open */
    bool holds[SIDES];      /* the needle, or the thread, as the caption says */
    bool has_needle[SIDES];
    bool shears[SIDES];
    double tension[2]; /* N, of tail and limb, as their colours show it */
    vbss_session_coaching coach;
} sight;

typedef struct trainee {
    live live;
    uint64_t random, shades; /* of movements and places; of colours */
    sight past[TRAINEE_DELAY + 1];
    uint64_t frames;
    double noise; /* share of the length of a movement; 0.05 is usual */
    double home;  /* m: x of the slit before it was pulled at */
    bool verbose;
} trainee;

vbss_result trainee_begin(trainee *t, vbss_session_exercise exercise, const start_states *states,
                          uint64_t seed, const char *log);
void trainee_end(trainee *t);
/* Frames pass; false: the exercise has ended, or a step failed. */
bool trainee_wait(trainee *t, int frames);
/* The view of 200 ms ago. */
const sight *trainee_see(const trainee *t);
/* Waits until the effect of the last movement is in the view. */
bool trainee_finish_motion(trainee *t);
/* One movement of a hand, as it is meant. */
bool trainee_move(trainee *t, int side, vec by);
/* Movements until the tip is seen within `near` of the place, 12 at most. */
bool trainee_go(trainee *t, int side, vec to, double near);
bool trainee_roll(trainee *t, int side, double angle);
/* Turns the jaws until they point in the direction. */
bool trainee_turn(trainee *t, int side, vec to);
/* Rolls the jaws until they open square to the direction. */
bool trainee_roll_across(trainee *t, int side, vec direction);
bool trainee_jaws(trainee *t, int side, bool closes);
bool trainee_aid(trainee *t, uint32_t aid);
bool trainee_exchange(trainee *t, int side);
/* Prints what it does and sees, if it shall. */
void trainee_say(const trainee *t, const char *what);
bool trainee_has_ended(const trainee *t, vbss_session_exercise_state *state);

/* ---- lessons.c: each exercise, by the words of the coach */

void lesson_take_needle(trainee *t);
void lesson_pass_mark(trainee *t);
void lesson_cut(trainee *t);
/* throws.c */
void lesson_throw(trainee *t);

#endif
