#include "surgeon/surgeon.h"

vbss_result surgeon_create(surgeon *s, const surgeon_options *o)
{
    memset(s, 0, sizeof *s);
    stitch_plan plan = {.site = {.segments = 300, .work = o->work}, .free_left = true};
    TRY(stitch_create(&s->stitch, o->seed, &plan));
    return stand_begin(&s->stitch.site.stand, o->log);
}

const char *surgeon_doing(const surgeon *s)
{
    switch (s->stage) {
    case SURGEON_PASS:
        return stitch_name(s->stitch.state);
    case SURGEON_PULL:
        return pull_name(s->pull.state);
    case SURGEON_TIE:
        return throw_state_name(s->tie.state);
    default:
        return s->stage == SURGEON_DONE ? "done" : "failed";
    }
}

double surgeon_tail(const surgeon *s)
{
    return s->pull.tail;
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
    TRY(stand_step(&t->site.stand, dt));
    TRY(hand_feel(&t->right));
    return hand_feel(&t->left);
}

static vbss_result pass(surgeon *s, double dt)
{
    stitch *t = &s->stitch;
    TRY(stitch_lead(t, dt));
    TRY(stand_step(&t->site.stand, dt));
    TRY(stitch_look(t));
    if (t->state == STITCH_DONE) {
        pull_begin(&s->pull, t);
        s->stage = SURGEON_PULL;
    } else if (t->state == STITCH_FAILED) {
        fail(s, t->why);
    }
    return VBSS_OK;
}

static vbss_result pull(surgeon *s, double dt)
{
    pull_step(&s->pull, dt);
    TRY(move(s, dt));
    if (s->pull.state == PULL_DONE) {
        s->stage = SURGEON_TIE;
        return surgeon_begin_tie(s);
    }
    if (s->pull.state == PULL_FAILED) {
        fail(s, s->pull.why);
    }
    return VBSS_OK;
}

static vbss_result tie(surgeon *s, double dt)
{
    TRY(surgeon_tie(s, dt));
    TRY(move(s, dt));
    if (s->tie.state == THROW_DONE) {
        s->stage = SURGEON_DONE;
    } else if (s->tie.state == THROW_FAILED) {
        fail(s, s->tie.why);
    }
    return VBSS_OK;
}

vbss_result surgeon_step(surgeon *s, double dt)
{
    vbss_drain_gap gap;
    s->steps++;
    switch (s->stage) {
    case SURGEON_PASS:
        TRY(pass(s, dt));
        break;
    case SURGEON_PULL:
        TRY(pull(s, dt));
        break;
    case SURGEON_TIE:
        TRY(tie(s, dt));
        break;
    default:
        break;
    }
    TRY(vbss_drain_get_gap(s->stitch.site.drain, &gap, sizeof gap));
    s->gap = gap.gap;
    return VBSS_OK;
}
