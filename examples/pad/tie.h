/* Ties the interrupted stitch: a double throw and two single ones, about the jaws of one tool. The limb is the end of the thread that had
 * the needle, the tail is the other one. */
#ifndef VBSS_EXAMPLES_PAD_TIE_H
#define VBSS_EXAMPLES_PAD_TIE_H

#include <stdbool.h>

#include <vblast_ss/vblast_ss.h>

#include "base/linear.h"
#include "scripted/hand.h"

enum { TIE_THROWS = 3 };

typedef enum tie_state {
    TIE_TAKE,  /* the first hand takes the limb; the needle is cut off */
    TIE_PLACE, /* it holds the limb beside the other tool, over the stitch */
    TIE_WIND,  /* and leads it round that tool's jaws */
    TIE_REACH, /* the jaws come to the tail, with the turns on them, */
    TIE_CLOSE, /* take it, */
    TIE_DRAW,  /* and draw it through the turns, */
    TIE_BACK,  /* or give it up and back out of the turns: the limb is wound again */
    TIE_LOWER, /* both hands go low, the ends still slack */
    TIE_PULL,  /* both pull the throw tight */
    TIE_EASE,  /* both ease, and the tail is let go */
    TIE_LEAVE, /* after the last throw: both ends are cut, and both hands go away */
    TIE_DONE,
    TIE_FAILED
} tie_state;

/* A free tool: led to a pose with limited speed, as a hand would. */
typedef struct tie_hand {
    scripted_hand *of;
    vec3 at, velocity, goal; /* of the tip: led to, of that, wanted */
    quat turn, wanted_turn;
    double speed;   /* m/s, limit */
    double opening; /* of the jaws, 0 to 1 */
    /* as it is */
    vec3 tip, handle,
        across;     /* the jaws point from the handle to the tip, and open along `across` */
    bool holds;     /* the thread of the stitch */
    uint32_t node;  /* in the jaws then */
    vec3 jaws;      /* where they hold */
    double tension; /* of the thread in them, smoothed, N */
} tie_hand;

/* The thread as the hands see it: nodes from the limb's end to the tail's. */
typedef struct tie_thread {
    vbss_thread *thread;
    uint32_t body, count;
    const vec3 *x;
    double segment;                /* m */
    uint32_t limb_root, tail_root; /* nodes where both come out of the skin or of the knot */
} tie_thread;

typedef struct tie_knot {
    vbss_knot_state state;
    char notation[32];
    int32_t handedness[TIE_THROWS]; /* of the throws */
} tie_knot;

typedef struct pad_tie {
    vbss_scene *scene;
    tie_state state;
    const char *why; /* it failed; NULL: it has not */
    uint32_t throws; /* tied */
    double side;     /* of the incision where the limb comes out: 1 for +x */
    vec3 stitch;     /* middle of it, on the skin, m */
    vec3 off;        /* of the hands from where they should be, m */
    double since;    /* s in the state */
    tie_hand w,
        c; /* the tool that is wound about and draws the tail; the one that holds the limb */
    tie_thread thread;
    vbss_knot_detector *detector, *counter; /* of the bare thread; of its turns about the jaws */
    tie_knot knot;
    double turned, begun;    /* rad, of the limb round the jaws; at the beginning */
    double slack;            /* share of the limb's free length at which it is held */
    double angle, leash;     /* of the tail about its root while it is drawn, rad, m */
    vec3 lead_w, lead_c;     /* places that go ahead of hands which feel */
    vec3 beside;             /* from the turns to the hand that goes with them */
    double wanted;           /* N, of the limb while the ends are pulled */
    bool is_locking;         /* both ends are */
    double pulled;           /* s, since both ends bear the wanted force */
    vec3 lips;               /* from the left to the right one at the stitch, m */
    uint32_t pulls;          /* of the present throw */
    uint32_t tries, retries; /* to catch the tail; to wind, in the present throw */
    double turns;            /* of the thread about the jaws */
} pad_tie;

/* ---- tie_hand.c */
void tie_take_over(tie_hand *h, scripted_hand *of, double opening);
void tie_go(tie_hand *h, vec3 tip, double speed);
/* The tool points with its handle in one direction, and its jaws open along another one, roughly. */
void tie_turn(tie_hand *h, vec3 handle, vec3 across);
vbss_result tie_move(tie_hand *h, double dt);
vbss_result tie_feel(tie_hand *h, vbss_scene *scene, const tie_thread *thread);
vec3 tie_limited(vec3 v, double limit);

/* ---- tie_knot.c */
/* Reads the knot of the thread without its tools; finds the roots of limb and tail. */
vbss_result tie_judge(pad_tie *t);
/* Goes on reading the tied knot from step to step: the order of its throws is known from before. */
vbss_result tie_follow(pad_tie *t);
/* How often the thread is wound about the jaws, with its sign. */
vbss_result tie_count_turns(pad_tie *t, double *turns);

/* ---- tie_wind.c: until the tail is caught */
void tie_take(pad_tie *t);
void tie_place(pad_tie *t);
vbss_result tie_wind(pad_tie *t, double dt);
void tie_reach(pad_tie *t, double dt);
vbss_result tie_close(pad_tie *t, double dt);
/* The throw has gone wrong before it was formed: it is wound again, or given up if that was tried too often. */
void tie_retry(pad_tie *t, const char *why);
void tie_back(pad_tie *t);

/* ---- tie_pull.c: from then on */
vbss_result tie_draw(pad_tie *t, double dt);
void tie_lower(pad_tie *t, double dt);
vbss_result tie_pull(pad_tie *t, double dt);
vbss_result tie_ease(pad_tie *t, double dt);
void tie_leave(pad_tie *t);

/* ---- tie.c */
void tie_enter(pad_tie *t, tie_state state);
void tie_fail(pad_tie *t, const char *why);
double tie_length(const tie_thread *thread, uint32_t from, uint32_t to);
const char *tie_state_name(tie_state state);
/* The throw that is being tied or pulled tight, from 1. */
uint32_t tie_present_throw(const pad_tie *t);
/* Begins with the limb held taut by its needle, and hands where they are. */
vbss_result tie_begin(pad_tie *t, vbss_context *context, vbss_scene *scene, vec3 stitch,
                      scripted_hand hands[2]);
/* Leads both hands in the coming step. */
vbss_result tie_step(pad_tie *t, double dt);
/* The thread, or what a cut has left of it. */
vbss_result tie_see(pad_tie *t, uint32_t body, double segment);

#endif
