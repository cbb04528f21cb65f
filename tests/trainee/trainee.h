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
    vec swage;              /* the needle's other end, m */
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
    double noise;    /* share of the length of a movement; 0.05 is usual */
    double home;     /* m: x of the slit before it was pulled at */
    vec slit;        /* m: where it was seen last */
    vec entry;       /* m: the first mark before it was pierced */
    double warned;   /* s: when the coach last said that turns had come off */
    bool is_wound;   /* turns are on the jaws */
    bool is_later;   /* the present throw is not the first */
    bool is_crossed; /* the hands, about the slit */
    bool has_pulled; /* the present throw tight */
    bool helps;      /* a closed tool supports the wall at the first mark */
    bool verbose;
    uint64_t printed;      /* events */
    int until;             /* the phase of the session at which the whole task ends */
    const char *folder;    /* for states of the whole task; NULL: none */
    double tension, force; /* N: largest of the thread, and on a hand, which it does not see */
} trainee;

vbss_result trainee_begin(trainee *t, vbss_session_exercise exercise, const start_states *states,
                          uint64_t seed, const char *log);
/* Parts of it: a mind without a scene; the camera and the first view. */
void trainee_wake(trainee *t, uint64_t seed);
void trainee_open_eyes(trainee *t);
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
/* To 2 degrees, not 6. */
bool trainee_turn_well(trainee *t, int side, vec to);
/* Rolls the jaws until they open square to the direction. */
bool trainee_roll_across(trainee *t, int side, vec direction);
bool trainee_jaws(trainee *t, int side, bool closes);
bool trainee_aid(trainee *t, uint32_t aid);
/* Whether the tool that is not moved follows, in throws. */
bool trainee_follow(trainee *t, bool follows);
bool trainee_exchange(trainee *t, int side);
/* Prints what it does and sees, if it shall. */
void trainee_say(trainee *t, const char *what);
bool trainee_has_ended(const trainee *t, vbss_session_exercise_state *state);
vbss_session_phase trainee_phase(const trainee *t);

/* ---- lessons.c: each exercise, by the words of the coach */

void lesson_take_needle(trainee *t);
void lesson_pass_mark(trainee *t);
/* The jaws lie square to the needle: their roll turns it until its tip points into the wall. */
bool lesson_turn_square(trainee *t);
/* False: the exercise has ended. */
bool lesson_pierce(trainee *t, int pushes);
/* cut.c */
void lesson_cut(trainee *t);
/* throws.c */
void lesson_throw(trainee *t);
/* What the present goal asks for; false: the exercise has ended, or the goal belongs to no throw. */
bool lesson_throw_part(trainee *t);
bool lesson_release_tail(trainee *t, int loop);

/* crossing.c */
bool lesson_cross_hands(trainee *t, int loop);

/* ---- stitching.c: the needle in the whole task; false: the task has ended */

bool lesson_take(trainee *t, int side, double lean);
bool lesson_leave(trainee *t, int side);
bool lesson_park(trainee *t, int side);
bool lesson_reach_mark(trainee *t, int side);
bool lesson_drive(trainee *t, int side);
bool lesson_turn_on(trainee *t, int side);
bool lesson_draw_needle(trainee *t, int side);
bool lesson_lift(trainee *t, int side);
bool lesson_draw_thread(trainee *t, int side);
bool lesson_lengthen_tail(trainee *t, int side);

/* ---- whole_task.c, states.c */

void lesson_whole_task(trainee *t);
/* Prints what came of it; true: its last phase was reached. */
bool trainee_report_task(const trainee *t, uint64_t seed);
vbss_result trainee_begin_task(trainee *t, uint64_t seed, const char *log);
/* A state of the present moment, if there is a folder for it. */
void trainee_save(trainee *t);
vbss_result trainee_resume(trainee *t, uint64_t seed, const char *path);

#endif
