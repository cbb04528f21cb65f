/* Ties one throw: what the hands do, one state after the other, from what they see. */
#ifndef VBSS_EXAMPLES_THROW_THROW_H
#define VBSS_EXAMPLES_THROW_THROW_H

#include "throw/catch.h"

#define REACH 0.98 /* of a tail's or a limb's length, nearly taut */

typedef enum throw_state {
    THROW_PICK,   /* C takes the limb */
    THROW_NEAR,   /* the limb to the near side, under where W will be */
    THROW_PLACE,  /* W to where it is wound about */
    THROW_ORBIT,  /* C round W's jaws, the limb taut */
    THROW_CHECK,  /* are the turns right? */
    THROW_UNWIND, /* no: back */
    THROW_TAIL,   /* W to before the tail */
    THROW_CLOSE,  /* on the tail; would it tie what it shall? */
    THROW_DRAW,   /* the tail through the turns */
    THROW_LOWER,  /* both hands low, nothing tight yet */
    THROW_SEAT,   /* pull tight */
    THROW_SQUARE, /* both come round again from where they went back to */
    THROW_PART,   /* both ease */
    THROW_RETAKE, /* W takes the tail that it has let go, to pull again */
    THROW_DONE,
    THROW_FAILED,
    THROW_STATES
} throw_state;

/* What the hands do wrong in a throw, knowingly: without it they would see it and begin anew. */
typedef enum throw_mistake {
    THROW_NO_MISTAKE,
    THROW_REVERSED, /* C winds the other way: as before, if the one below was tied by the other hand */
    THROW_TO_HANDLE, /* each turn is nearer to W's handle than the last */
    THROW_COUNTER,   /* the last turns are wound back again */
    THROW_BIGHT,     /* W takes the tail in its middle, and draws that through */
    THROW_DROPPED,   /* W lets the tail go before its end is through */
    THROW_ONE_SIDED, /* W alone pulls, until the tail is straight */
    THROW_SLACK,     /* nobody pulls: a session tells, the detector does not */
} throw_mistake;

/* How a throw is tied; lengths in m. */
typedef struct throw_plan {
    int wraps;
    vec wrap_tip;       /* of W while it is wound about */
    vec wrap_point;     /* where the handle's end of its jaws shall point then */
    double hold;        /* of limb from its mark to C's jaws */
    double s0, ds;      /* where along W C goes round, from its tip; less in each turn */
    double slack;       /* radius of the orbit over the free length */
    double speed;       /* of C, m/s */
    double tension;     /* that C gives way to when it winds, N */
    double clearance;   /* of C's tip above the drain's top */
    double beyond;      /* rad of orbit, so that what hangs from C hangs behind the tail */
    double opening;     /* of W's handle, when it takes the tail */
    uint32_t tail_node; /* where it takes it */
    double behind;      /* how far behind its tip */
    double off_floor; /* m: what of the tail is nearer to the floor is left, the next place taken */
    bool soft;        /* what is below is only held by its own friction: nothing may be taut */
    bool alike;       /* both ends are pulled alike in the end */
    bool still; /* W waits before that, until C has taken up the slack: the tail stays short */
    bool down;  /* the turn is closed from below, on either side of the drain, before that */
    /* The tail is raised on the near side until the turn is closed: laid over the throw below, it opens that one. */
    bool raised;
    bool flat; /* so closed, it is pulled flat as well, with both ends bent, and tight then */
    /* The hands see which end bends, and W draws a tail that bends alone; only then the throw is pulled. */
    bool even;
    bool gives; /* W gives with a tail that is straight until it bends as the limb does */
    /* Both hands go back to where the throw below was pulled from, pull from there, and then, with nothing slack meanwhile, the flat way. */
    bool back;
    /* Further ones of the tail, farther from its end, if it is missed or would tie something else. */
    uint32_t catches;
    double
        minds; /* N, felt by W on its way to the tail: it draws back, and comes again; 0: nothing */
    double
        backs_off; /* N, felt by C on its orbit: it has hooked something, and the limb is wound anew; 0: nothing */
    /* What does not go is tried again: drawn harder; both ease in the end, and may pull again. */
    bool again;
    bool firm;     /* C winds as wide as the limb is long, however slack it has become */
    double widest; /* radius of C's orbit */
    double light;  /* N, of C while the tail is drawn through */
    double drawn;  /* N, of W meanwhile: so little that tied throws do not move */
    double sweep;  /* m/s, of W meanwhile, at most */
    double reach; /* share of the tail that W goes to while turns are on its jaws: it hangs slack */
    double min_height; /* m above the drain's top, of W meanwhile */
    double tilt;       /* rad, of W's way meanwhile, from upright to the near side */
    double low;        /* m, below the drain's top, to where both pull then */
    double far;        /* m, farther outward than usual */
    double
        askew; /* rad about the upright, that both hands are off the stitch's line while it is closed */
    double pull; /* N, in the end */
    int retries;
    bool wrong;     /* C goes round the other way */
    bool unchecked; /* what it would tie does not matter */
    bool other_end; /* C alone pulls and W follows, to flatten a capsized throw */
    throw_mistake mistake;
    bool waits; /* once it is made, until somebody says so (throw_mend) */
} throw_plan;

typedef struct throw_run {
    senses *see;
    throw_plan plan;
    throw_state state;
    double since;      /* s in this state */
    double phi, begin; /* of C round W, rad, from above over the far side; where the mark is */
    double rho, give;
    vec carrot_w, carrot_c;
    vec beside; /* of C from the turns on W; zero: not yet taken */
    double angle, leash, clear, hold;
    double begun; /* the angle when W began to draw */
    catch_run grip;
    uint32_t throws_before;
    uint32_t tail_root, limb_root; /* nodes where tail and limb come out of drain or knot */
    int retries, refused;
    uint32_t elsewhere; /* so often the tail was caught nearer to the drain, since it was wound */
    const char *why;
    senses_knot predicted, formed; /* at the catch, and when the end had come through */
    double hooked;                 /* rad that C still has to back off */
    bool back;                     /* winding back what was wound */
    bool unwinds;                  /* all of it, and then anew, with the plan `next` */
    throw_plan next;
    bool dropped;            /* the tail, knowingly */
    bool evenly;             /* it is pulled flat once the tail is taken again */
    bool left;               /* the hand takes the turns off again and ends the throw */
    double closed;           /* s in this state when both ends can be pulled; 0: not yet */
    double round_w, round_c; /* rad about the knot, of both hands as they go back */
    double far_w, far_c;     /* m from it, as they come round again */
    double asked;            /* N, of both ends then */
    double lost;             /* s, that W has had no turns on its jaws */
    double slip,
        slip_read;    /* of this throw as the hands see it, 0: not known; when, s in this state */
    double far_round; /* s, that W has drawn as far round as it goes and C has felt the limb */
    int pulls;        /* so often it was pulled again */
} throw_run;

void throw_plan_usual(throw_plan *p, int wraps);
/* Has the throw pulled from behind, as the one below was: that shuts an open slit, and makes a half hitch of the throw below. */
void throw_plan_back(throw_plan *p);
/* The hands shall make that mistake in it. */
void throw_plan_spoil(throw_plan *p, throw_mistake mistake);
/* Mends the mistake of the plan, and continues with `plan`, which has none. (mend.c) */
void throw_mend(throw_run *t, const throw_plan *plan);
/* A single on top of what is tied. */
void throw_plan_on_top(throw_plan *p);
void throw_begin(throw_run *t, senses *see, const throw_plan *plan);
/* What the hands do in the coming step, from what is seen now. */
vbss_result throw_step(throw_run *t, double dt);
/* What it became, as far as could be told when its end was through. */
bool throw_is_formed_as(const throw_run *t, const char *notation);
/* How long both ends have been pulled, s; where they can be at once, since it began. */
double throw_pulled_for(const throw_run *t);
/* It is tight. */
void throw_seated(throw_run *t);
/* It was, and both ends are slack now: it may be pulled again. */
bool throw_is_slack(const throw_run *t);
void throw_pull_again(throw_run *t);
/* It has sprung open since W let the tail go: W takes that again, and both pull again, flat with both ends bent or from behind. */
void throw_retake(throw_run *t, bool evenly);
/* Once more, from the beginning, if it is not too late; else the throw has failed. */
void throw_fail(throw_run *t, const char *why);
/* Nothing is drawn through yet: W comes out of the turns, and the throw ends with `left`. */
void throw_leave(throw_run *t);
/* That the throw shall have: each has the other hand's. */
int throw_handedness(const throw_run *t);
const char *throw_state_name(throw_state state);

#endif
