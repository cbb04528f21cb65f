/* A scripted surgeon: two hands that act through devices alone, one stage of the task after the other. */
#ifndef VBSS_EXAMPLES_SURGEON_SURGEON_H
#define VBSS_EXAMPLES_SURGEON_SURGEON_H

#include "needle/stitch.h"
#include "surgeon/hand_over.h"
#include "surgeon/lengthen.h"
#include "surgeon/mistake.h"
#include "surgeon/pull.h"
#include "surgeon/task.h"
#include "throw/cut.h"
#include "throw/throw.h"

/* On the line of the left shaft when its jaws take a tail that lies on the drain and beyond. */
#define SURGEON_STEEP v3(-0.15, -0.02, 0.2)
#define SURGEON_MINDS 0.4 /* N: a hand on its way to the tail that feels more draws back */

typedef enum surgeon_stage {
    SURGEON_PASS,   /* the needle through both marks (needle/stitch.c) */
    SURGEON_PULL,   /* it and its thread through, until the tail is short (pull.c) */
    SURGEON_TIE,    /* a double throw (tie.c, throw/throw.c) */
    SURGEON_OVER,   /* the needle to the left hand (hand_over.c) */
    SURGEON_SECOND, /* a single throw, the mirror image (later.c) */
    SURGEON_BACK,   /* the needle to the right hand */
    SURGEON_THIRD,  /* another one, as the first */
    SURGEON_CUT,    /* both tails (throw/cut.c) */
    SURGEON_DONE,
    SURGEON_FAILED
} surgeon_stage;

typedef struct surgeon {
    stitch stitch; /* with scene and hands */
    pull_run pull;
    lengthen_run lengthen; /* if the tail has become too short */
    senses see;
    throw_run tie;
    hand_over over;
    cut_run cut;
    hesitation thinks;
    surgeon_mistake mistake;
    bool mends;      /* when the coach names it */
    vec lifted_from; /* by one who tears the drain */
    bool lowers;     /* and goes back there */
    double limit;    /* s, of who is idle; 0: none */
    surgeon_stage stage;
    const char *why; /* failed */
    uint64_t steps;
    double off[2];          /* of the holes from their marks, m */
    double tail;            /* when it was set, m */
    double gap_before, gap; /* between the lips: before the throw, now, m */
    double edges;           /* between the middles of the slit's edges, m */
    double shut, at_rest;   /* so long, while both hands pull hard; or less, s */
    double met;             /* so long, while both pull at all, s */
    bool seated;            /* it was for a moment, and has not gaped since */
    double slack;           /* of the first throw as it is planned */
    int retaken;            /* times that the throw was pulled again after its tail was let go */
    int returned;           /* times that a throw was tied again that had come undone */
    double undone;          /* so long, while the limb is wound, s */
} surgeon;

typedef struct surgeon_options {
    uint64_t seed;
    uint32_t segments; /* of the thread; 0: 300, the only number that the scripted hands can tie */
    surgeon_stage until;               /* ends before this one */
    const vbss_solver_options *solver; /* NULL: the defaults */
    const hand_skill *skill;           /* NULL: an expert's */
    surgeon_mistake mistake;
    bool mends;       /* it is mended when the coach says so */
    bool coaching;    /* the session coaches; with a mistake it does in any case */
    bool left_handed; /* all in the mirror: the left hand drives, from the left mark */
    const char *log;  /* may be NULL */
    site_material material;
} surgeon_options;

/* What there is before the first step. (plan.c) */
void surgeon_plan(const surgeon_options *o, stitch_plan *plan);
/* Of the session. (plan.c) */
task_plan surgeon_task_plan(const surgeon_options *o);
vbss_result surgeon_create(surgeon *s, const surgeon_options *o);
/* Hands, devices, scene, and what is seen of it. */
vbss_result surgeon_step(surgeon *s, double dt);
/* Does what the coach says of a mistake. (mend.c) */
void surgeon_mend(surgeon *s, vbss_session_mistake coached);
/* Makes the plan of a throw one with the surgeon's mistake, if that is one in this throw. (mend.c) */
void surgeon_spoil(const surgeon *s, throw_plan *plan);
/* As the program knows it. */
bool surgeon_slit_is_shut(const surgeon *s); /* between its lips */
const char *surgeon_stage_name(surgeon_stage stage);
/* What the hands do at the moment. */
const char *surgeon_doing(const surgeon *s);

/* ---- tie.c */
/* Of the double. */
void surgeon_plan_tie(throw_plan *plan);
/* Sees the thread from now on. */
vbss_result surgeon_see(surgeon *s);
vbss_result surgeon_begin_tie(surgeon *s);
void surgeon_hold_level(surgeon *s);
vbss_result surgeon_tie(surgeon *s, double dt);
/* What the senses tell, from the tying on. */
vbss_result surgeon_observe(surgeon *s);

/* ---- later.c */
vbss_result surgeon_begin_hand_over(surgeon *s);
/* Of the single that comes next; `limb`: its length, m. */
void surgeon_plan_later(const surgeon *s, double limb, throw_plan *plan);
vbss_result surgeon_begin_later(surgeon *s);
/* Counts the throws. Begins the throw of this stage; if one below it has come undone, takes the needle to the hand that ties that one
 * again. */
vbss_result surgeon_begin_next(surgeon *s);
/* True if surely fewer throws are tied than the throw of this stage needs below it. */
vbss_result surgeon_read_throws(surgeon *s, bool *is_undone);
vbss_result surgeon_begin_cut(surgeon *s);

/* ---- show.c; a width of what is seen, m */
bool surgeon_show(const surgeon *s, const char *path, const char *text, vec middle, double width);

#endif
