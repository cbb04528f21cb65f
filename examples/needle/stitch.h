/* Two hands that drive a needle through both marks: what they do next, from what they see. */
#ifndef VBSS_EXAMPLES_NEEDLE_STITCH_H
#define VBSS_EXAMPLES_NEEDLE_STITCH_H

#include "needle/hold.h"
#include "throw/skill.h"

#define STITCH_LEFT_TROCAR v3(-0.12, -0.015, 0.08) /* on the line of the left shaft */
#define STITCH_JAW_WIDE 0.6                        /* of the right handle, when it takes a needle */

/* The right hand drives. */
typedef enum stitch_state {
    STITCH_LIE,   /* all comes to rest */
    STITCH_REACH, /* over the needle */
    STITCH_LOWER,
    STITCH_CLOSE,
    STITCH_LIFT,
    STITCH_BRING,  /* over the right mark */
    STITCH_TARGET, /* the tip before it */
    STITCH_ENTER,  /* through the right wall */
    STITCH_CROSS,  /* the lumen */
    STITCH_LEAVE,  /* through the left wall */
    STITCH_EASE,   /* back from it, to try again */
    STITCH_DRAW,   /* until enough of it stands out */
    STITCH_DONE,
    STITCH_FAILED
} stitch_state;

/* The left hand bears the wall against it. */
typedef enum stitch_support {
    SUPPORT_AWAY,
    SUPPORT_OVER,   /* the slit */
    SUPPORT_UNDER,  /* the right edge, from within */
    SUPPORT_OUT,    /* of the slit again */
    SUPPORT_BESIDE, /* the left wall */
    SUPPORT_ON,     /* it, from outside */
    SUPPORT_BACK
} stitch_support;

typedef struct stitch {
    site site;
    hand right, left;  /* the one that drives, and the other; of a left-handed, in the mirror */
    bool left_is_free; /* of a trocar */
    stitch_state state;
    stitch_support support;
    double since, support_since; /* s in the state */
    int tries;                   /* to take it */
    const char *why;
    pose held;        /* the needle in the frame of the pose that the right tool is commanded to */
    pose from;        /* of the right tool, when it lifts */
    vec beside;       /* so far from both marks it is stitched, knowingly */
    bool withdraws;   /* and drawn back out of the first wall */
    bool restarts;    /* and then entered again, because the left wall gives way */
    bool mends;       /* one that is withdrawn knowingly stays out until stitch_mend is called */
    vec errors[2];    /* of aim, at the left and the right mark */
    double target_at; /* their size, m */
    uint64_t random;
    bool misses;       /* the tip goes back from a right wall that it has missed */
    int forked;        /* times that the fork was set again under the right wall */
    int missed;        /* so many times */
    vec marks[2];      /* as seen, a little late */
    vec trim;          /* of the aim at the left mark */
    double square;     /* cosine between needle and left wall, the largest of this try */
    vec pressed;       /* where the needle pressed on it then, from the mark */
    vec fork;          /* so far from its usual place the fork is set on the left wall */
    int again;         /* times that the needle has been drawn back from it */
    int restart_count; /* times that the needle has been withdrawn for that */
    int relieved;      /* times that it has gone back in its hole there, because it dragged */
    double back;       /* so far it still has to, m; below 0: it has gone on since */
    double dragged;    /* N, that the hand felt then */
    double ahead;      /* gone - out, m, when it came out of the left wall */
    int fork_returns;  /* times that the fork has come again because the needle was locked */
    bool awaits_fork;
    vec hole[2];  /* left, right, likewise */
    vec entry;    /* where the right mark is taken to be while it is entered */
    double gone;  /* the tip beyond the right mark along the way it shall go, m */
    double along; /* share of the change from the circle of entry to that through both marks */
    uint32_t punctures, others; /* holes made; tears, slips out, withdrawals */
    uint32_t holes[2];          /* their ids: left, right */
    vbss_scene_hole made[2];    /* when made */
    double out;                 /* of the tip beyond the left wall, m */
} stitch;

typedef struct stitch_plan {
    site_plan site;
    bool free_left; /* the left tool has no trocar, and a neck: it can be wound about later on */
    const hand_skill *skill; /* NULL: an expert's */
} stitch_plan;

void stitch_plan_usual(stitch_plan *plan);
vbss_result stitch_create(stitch *t, uint64_t seed, const stitch_plan *plan);
/* Another error of aim at a mark. */
void stitch_set_error(stitch *t, int side);
/* Tells both hands what to do in the coming step, and moves their tools. */
vbss_result stitch_lead(stitch *t, double dt);
/* Looks at what it did. */
vbss_result stitch_observe(stitch *t);
/* Mends a mistake at the first wall: withdraws the needle or, if it is out, brings it to the mark again. */
void stitch_mend(stitch *t);
const char *stitch_name(stitch_state state);
/* Whose tool is at that side of the scene. */
const hand *stitch_hand(const stitch *t, int side);
/* stitch_judge.c. How far either hole is from its mark, m (below 0: there is none); true: the needle went through both walls, once
 * each and near their marks. */
bool stitch_is_through(const stitch *t, double off[2]);

#endif
