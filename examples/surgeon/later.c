#include "surgeon/surgeon.h"
#include "throw/steer.h"

/* The second and third throw: each mirrors the one before, so that the knot is square. */
#define WRAP_TIP_X \
    0.018 /* of W, so that what stands up to it is behind the turns, and C's needle clear of it */
/* Where C is the hand that it was in the first throw: its needle was led past the limb on the wrong side, and hooked it. */
#define WRAP_TIP_FARTHER 0.026
#define TURN_ROOM 0.045  /* m of the limb are left to go round W: that high is W */
#define TURN_PLACE 0.010 /* behind W's tip */
#define SLACK 0.97
#define WINDING 0.03 /* N, that C gives way to */
#define ALIKE \
    0.05 /* N, of both hands while the tail is drawn: else what is tied goes to one side */
/* Distance of W from the knot while the turns are on its jaws, as a share of the tail. A taut tail opens the throw below, and so does one that
 * is folded at the knot. The tail of the third throw is shorter. */
#define SLACK_TAIL 0.75
#define SLACK_THIRD 0.9
/* m/s, of W as it sweeps the tail of the third throw round the knot, which unrolls the second. Chosen: with 0.08 one slit of seven opened
 * farther (docs/notebook/surgeon.md). */
#define SLOW_SWEEP 0.02
#define MIN_HEIGHT 5e-3   /* m above the drain's top, of W then */
#define LOW 0.012         /* m below the drain's top, to where both pull: just above the floor */
#define FAR 0.05          /* m farther out than C may be already */
#define ASKEW (-PI / 4.0) /* so that the ends do not go straight back over what is tied */
#define PULL \
    1.0 /* N, of both hands, if not both ends bend: with 2 flat throws turn into half hitches */
#define PULL_KEPT 1.5
#define CATCHES 3
#define RETRIES 2           /* wound anew: that pulls at what is tied, but else it is left */
#define OFF_FLOOR 2e-3      /* m, where W takes the tail */
#define BLADES_CLEAR 2.5e-3 /* m off the drain, which open blades would push */
#define NEAR_SIDE v3(-0.08, -0.3, 0.15)

vbss_result surgeon_begin_hand_over(surgeon *s)
{
    TRY(hand_over_begin(&s->over, &s->stitch, &s->see));
    s->over.kept = s->mistake == SURGEON_KEPT;
    return VBSS_OK;
}

void surgeon_plan_later(const surgeon *s, double limb, throw_plan *plan)
{
    throw_plan_on_top(plan);
    bool kept = s->mistake == SURGEON_KEPT, third = s->stage == SURGEON_THIRD;
    plan->wrap_tip =
        v3(third || kept ? WRAP_TIP_FARTHER : WRAP_TIP_X, 0.0, clamp(limb - TURN_ROOM, 0.03, 0.07));
    plan->s0 = TURN_PLACE;
    plan->slack = SLACK;
    plan->firm = true;
    plan->tension = WINDING;
    plan->light = plan->drawn = ALIKE;
    plan->low = LOW;
    plan->far = FAR;
    /* The second leaves the first as it is while its tail is raised, and is then pulled flat: closed alone, it opens as the tail is
     * straightened and drawn through the third. If the slit is open all the same, before or after, it is pulled from where the first was
     * (tie.c). The third is pulled its own way, which is the first one's, too. */
    plan->catches = CATCHES;
    plan->minds = plan->backs_off = SURGEON_MINDS;
    plan->retries = RETRIES;
    plan->again = !kept;
    plan->raised = plan->flat = !kept && !third;
    plan->down = true;
    plan->even = !kept && third;
    plan->askew = kept ? ASKEW : 0.0;
    plan->off_floor = OFF_FLOOR;
    plan->reach = third ? SLACK_THIRD : SLACK_TAIL;
    plan->min_height = MIN_HEIGHT;
    plan->sweep = third ? SLOW_SWEEP : plan->sweep;
    plan->pull = kept ? PULL_KEPT : PULL;
}

vbss_result surgeon_read_throws(surgeon *s, bool *is_undone)
{
    senses_knot k;
    TRY(senses_judge(&s->see, false, &k));
    const bool sure =
        k.state.verdict == VBSS_KNOT_VERDICT_CERTIFIED || k.state.verdict == VBSS_KNOT_VERDICT_NONE;
    const uint32_t below = s->stage == SURGEON_THIRD ? 2 : 1;
    *is_undone = sure && k.state.throw_count < below && s->mistake == SURGEON_NO_MISTAKE;
    return VBSS_OK;
}

vbss_result surgeon_begin_later(surgeon *s)
{
    senses *e = &s->see;
    throw_plan plan;
    surgeon_plan_later(s, senses_length(e, e->limb_root, e->c->node), &plan);
    surgeon_spoil(s, &plan);
    surgeon_hold_level(s);
    s->shut = 0.0;
    s->seated = false;
    s->retaken = 0;
    s->undone = 0.0;
    throw_begin(&s->tie, e, &plan);
    return VBSS_OK;
}

/* The shears come from the near side, across both ends. */
vbss_result surgeon_begin_cut(surgeon *s)
{
    hand *w = s->see.w;
    hand_through(w, seen(w, NEAR_SIDE));
    TRY(cut_begin(&s->cut, &s->see));
    s->cut.clear = BLADES_CLEAR;
    return VBSS_OK;
}
