#include "surgeon/surgeon.h"

#include <stdio.h>

#define TAIL_SHORT 15e-3
#define TAIL_LONG 20e-3
#define TAIL_JAMMED 25e-3 /* of a tail that has jammed */
#define GAP_OPEN 1.5e-3
#define GAP_SHUT 0.5e-3
#define GAP_HELD 1e-3 /* under the double: with less the second throw is pulled from behind */
#define BESIDE v3(0.0, 3e-3, 0.0) /* the marks, of one who misses them: along the drain */
#define LIFT 0.08                 /* m, of a needle in both walls */
#define A_MOMENT 0.1              /* s */
#define OPEN 0.4e-3               /* m: pulled flat, a slit that is wider stays open */
/* So often a throw that springs open as its tail is let go is pulled again, and so often lost throws are tied again. */
enum { RETAKEN = 2, RETURNED = 4 };

vbss_result surgeon_create(surgeon *s, const surgeon_options *o)
{
    stitch_plan plan;
    char note[64];
    memset(s, 0, sizeof *s);
    surgeon_plan(o, &plan);
    TRY(stitch_create(&s->stitch, o->seed, &plan));
    hesitation_begin(&s->thinks, skill_or_expert(o->skill), o->seed);
    s->mistake = o->mistake;
    s->mends = s->stitch.mends = o->mends;
    s->limit = surgeon_task_plan(o).time_limit;
    s->stitch.withdraws = o->mistake == SURGEON_WITHDRAWN;
    if (o->mistake == SURGEON_MISSED) {
        s->stitch.beside = BESIDE;
    }
    snprintf(note, sizeof note, "vbss surgeon %sseed %lu", o->left_handed ? "left " : "",
             (unsigned long)o->seed);
    return throw_rig_begin(&s->stitch.site.rig, o->log, note);
}

bool surgeon_slit_is_shut(const surgeon *s)
{
    return s->gap <= GAP_SHUT;
}

const char *surgeon_stage_name(surgeon_stage stage)
{
    static const char *const names[] = {"pass", "pull",  "tie", "over", "second",
                                        "back", "third", "cut", "done", "failed"};
    return names[stage];
}

const char *surgeon_doing(const surgeon *s)
{
    switch (s->stage) {
    case SURGEON_PASS:
        return stitch_name(s->stitch.state);
    case SURGEON_PULL:
        return s->lengthen.state == LENGTHEN_NOT ? pull_name(s->pull.state)
                                                 : lengthen_name(s->lengthen.state);
    case SURGEON_TIE:
    case SURGEON_SECOND:
    case SURGEON_THIRD:
        return throw_state_name(s->tie.state);
    case SURGEON_OVER:
    case SURGEON_BACK:
        return hand_over_name(s->over.state);
    case SURGEON_CUT:
        return cut_state_name(s->cut.state);
    default:
        return s->stage == SURGEON_DONE ? "done" : "failed";
    }
}

static void fail(surgeon *s, const char *why)
{
    s->why = why;
    s->stage = SURGEON_FAILED;
}

static vbss_result move(surgeon *s, double dt)
{
    stitch *t = &s->stitch;
    TRY(hand_step(&t->right, dt));
    TRY(hand_step(&t->left, dt));
    TRY(throw_rig_step(&t->site.rig, dt));
    TRY(hand_feel(&t->right));
    return hand_feel(&t->left);
}

/* The hands stay where they were told to be; their tremor does not. */
static vbss_result think(surgeon *s, double dt)
{
    if (s->stage == SURGEON_PASS) {
        TRY(hand_step(&s->stitch.right, dt));
        TRY(hand_step(&s->stitch.left, dt));
        TRY(throw_rig_step(&s->stitch.site.rig, dt));
        return stitch_observe(&s->stitch);
    }
    if (s->stage > SURGEON_PULL) {
        TRY(surgeon_observe(s));
    }
    return move(s, dt);
}

static vbss_result pass(surgeon *s, double dt)
{
    stitch *t = &s->stitch;
    TRY(stitch_lead(t, dt));
    TRY(throw_rig_step(&t->site.rig, dt));
    TRY(stitch_observe(t));
    if (t->state == STITCH_DONE) {
        for (int side = 0; side < 2; side++) {
            s->off[side] = site_deviation(&t->site, &t->made[side], side);
        }
        pull_begin(&s->pull, t);
        s->lifted_from = t->right.at;
        s->stage = SURGEON_PULL;
        if (t->punctures != 2 || t->others > 0) {
            fail(s, "not through both marks");
        }
    } else if (t->state == STITCH_FAILED) {
        fail(s, t->why);
    }
    return VBSS_OK;
}

/* The needle, in both walls, goes straight up. */
static vbss_result lift(surgeon *s, double dt)
{
    hand *h = &s->stitch.right;
    vec up = h->at;
    up.z = LIFT;
    hand_go(h, up, 0.05);
    TRY(move(s, dt));
    if (!h->holds) {
        fail(s, "the needle is lost");
    } else if (h->at.z > LIFT - 1e-3) {
        fail(s, "lifted");
    }
    return VBSS_OK;
}

/* Back to where it was lifted from. */
static vbss_result lower(surgeon *s, double dt)
{
    hand *h = &s->stitch.right;
    hand_go(h, s->lifted_from, 0.05);
    s->lowers = v_distance(h->at, s->lifted_from) > 1e-3;
    return move(s, dt);
}

static vbss_result pull(surgeon *s, double dt)
{
    if (s->mistake == SURGEON_TORN) {
        return lift(s, dt);
    }
    if (s->lowers) {
        return lower(s, dt);
    }
    const bool lengthens = s->lengthen.state != LENGTHEN_NOT;
    if (lengthens) {
        TRY(surgeon_observe(s));
        lengthen_step(&s->lengthen, dt);
    } else {
        pull_step(&s->pull, dt);
    }
    TRY(move(s, dt));
    if (s->pull.state == PULL_DONE && !lengthens && s->pull.tail < TAIL_SHORT) {
        TRY(surgeon_see(s));
        lengthen_begin(&s->lengthen, &s->pull, &s->see);
    } else if (lengthens && s->lengthen.state < LENGTHEN_DONE) {
        return VBSS_OK;
    } else if (s->pull.state == PULL_DONE) {
        s->stage = SURGEON_TIE;
        s->tail = s->pull.tail;
        s->gap_before = s->gap;
        double limit = s->pull.jammed ? TAIL_JAMMED : TAIL_LONG;
        if (s->tail < TAIL_SHORT || s->tail > limit || s->gap < GAP_OPEN) {
            fail(s, s->lengthen.state == LENGTHEN_FAILED ? "the short tail is not drawn out"
                                                         : "tail or slit are not as they shall be");
        }
        return surgeon_begin_tie(s);
    }
    if (s->pull.state == PULL_FAILED) {
        fail(s, s->pull.why);
    }
    return VBSS_OK;
}

/* Of the throws as they were tied. */
static const char *notation_after(surgeon_stage stage)
{
    return stage == SURGEON_TIE ? "2" : stage == SURGEON_SECOND ? "2=1" : "2=1=1";
}

/* The tail has been drawn in by winding. Before the limb is wound again it is drawn out, as the coach asks. In later throws the knot holds it. */
static bool is_tail_drawn_in(surgeon *s)
{
    const throw_run *t = &s->tie;
    return s->stage == SURGEON_TIE && t->state == THROW_PLACE && t->since == 0.0 &&
           pull_tail(&s->stitch) < TAIL_SHORT;
}

static vbss_result tie(surgeon *s, double dt)
{
    TRY(surgeon_tie(s, dt));
    TRY(move(s, dt));
    if (is_tail_drawn_in(s)) {
        lengthen_begin(&s->lengthen, &s->pull, &s->see);
        s->stage = SURGEON_PULL;
        return VBSS_OK;
    }
    if (s->tie.state == THROW_DONE && s->tie.left) {
        return surgeon_begin_next(s);
    }
    if (s->tie.state == THROW_DONE) {
        const char *wanted = notation_after(s->stage);
        s->stage = (surgeon_stage)(s->stage + 1);
        if (!throw_is_formed_as(&s->tie, wanted)) {
            fail(s, "not the throw that it shall be");
        } else if (s->stage == SURGEON_OVER && s->gap > GAP_HELD) {
            fail(s, "the slit is not shut");
        } else if (s->stage == SURGEON_CUT) {
            return surgeon_begin_cut(s);
        } else {
            return surgeon_begin_hand_over(s);
        }
    } else if (s->tie.state == THROW_FAILED) {
        fail(s, s->tie.why);
    }
    return VBSS_OK;
}

static vbss_result over(surgeon *s, double dt)
{
    TRY(surgeon_observe(s));
    s->over.again =
        s->stage == SURGEON_BACK && s->retaken < RETAKEN && s->mistake == SURGEON_NO_MISTAKE;
    s->over.slit = s->gap;
    TRY(hand_over_step(&s->over, dt));
    TRY(move(s, dt));
    if (s->over.state == HAND_OVER_SPRUNG) {
        s->retaken++;
        s->stage = (surgeon_stage)(s->stage - 1);
        throw_retake(&s->tie, s->gap < OPEN);
    } else if (s->over.state == HAND_OVER_DONE) {
        s->stage = (surgeon_stage)(s->stage + 1);
        TRY(surgeon_begin_next(s));
    }
    if (s->over.state == HAND_OVER_FAILED) {
        fail(s, s->over.why);
    }
    return VBSS_OK;
}

vbss_result surgeon_begin_next(surgeon *s)
{
    bool is_undone;
    TRY(senses_observe(&s->see));
    TRY(senses_find_roots(&s->see));
    TRY(surgeon_read_throws(s, &is_undone));
    if (!is_undone) {
        return surgeon_begin_later(s);
    }
    if (s->returned++ == RETURNED) {
        fail(s, "throws come undone");
        return VBSS_OK;
    }
    if (s->stage == SURGEON_THIRD && s->see.throws == 0) {
        s->stage = SURGEON_TIE;
        return surgeon_begin_tie(s);
    }
    s->stage = s->stage == SURGEON_THIRD ? SURGEON_OVER : SURGEON_BACK;
    return hand_over_begin_at_needle(&s->over, &s->stitch, &s->see);
}

static vbss_result cut(surgeon *s, double dt)
{
    TRY(surgeon_observe(s));
    TRY(cut_step(&s->cut, dt));
    TRY(move(s, dt));
    if (s->cut.state == CUT_DONE) {
        s->stage = SURGEON_DONE;
    } else if (s->cut.state == CUT_FAILED) {
        fail(s, "not cut");
    }
    return VBSS_OK;
}

vbss_result surgeon_step(surgeon *s, double dt)
{
    vbss_drain_gap gap;
    s->steps++;
    TRY(vbss_drain_get_gap(s->stitch.site.drain, &gap, sizeof gap));
    s->gap = gap.opening;
    s->edges = gap.gap;
    if (s->stage >= SURGEON_TIE && s->stage < SURGEON_CUT && pull_tail(&s->stitch) < 0.0) {
        fail(s, "the thread is out of the drain");
        return VBSS_OK;
    }
    if (s->limit > 0.0 && s->stitch.site.rig.time > s->limit + A_MOMENT) {
        fail(s, "idle");
    } else if (s->mistake == SURGEON_IDLE || hesitates(&s->thinks, surgeon_doing(s), dt)) {
        return think(s, dt);
    }
    switch (s->stage) {
    case SURGEON_PASS:
        return pass(s, dt);
    case SURGEON_PULL:
        return pull(s, dt);
    case SURGEON_TIE:
    case SURGEON_SECOND:
    case SURGEON_THIRD:
        return tie(s, dt);
    case SURGEON_OVER:
    case SURGEON_BACK:
        return over(s, dt);
    case SURGEON_CUT:
        return cut(s, dt);
    default:
        return VBSS_OK;
    }
}
