#include "throw/transfer.h"

#include <string.h>

enum { BEYOND = 24 }; /* nodes, of the jaws that take the limb beyond those that offer it */

const char *transfer_state_name(transfer_state state)
{
    static const char *const names[] = {"ease", "release", "offer", "take",
                                        "give", "done",    "failed"};
    return names[state];
}

void transfer_begin(transfer_run *t, senses *see)
{
    memset(t, 0, sizeof *t);
    t->see = see;
}

static void enter(transfer_run *t, transfer_state state)
{
    t->state = state;
    t->since = 0.0;
}

/* Slowly, so that the knot stays as it was pulled. */
static void do_ease(transfer_run *t)
{
    senses *s = t->see;
    const double smallest = 0.05;
    vec knot = s->x[s->tail_root];
    vec w = v_unit(v_sub(knot, s->tool_w.tip)), c = v_unit(v_sub(knot, s->tool_c.tip));
    hand_go(s->w, v_along(s->tool_w.tip, s->tension_w > smallest ? 1e-3 : 0.0, w), 0.01);
    hand_go(s->c, v_along(s->tool_c.tip, s->tension_c > smallest ? 1e-3 : 0.0, c), 0.01);
    if ((s->tension_w < smallest && s->tension_c < smallest) || t->since > 2.0) {
        t->from = s->tool_w.tip;
        t->back = s->tool_w.handle;
        enter(t, TRANSFER_RELEASE);
    }
}

/* W's jaws open and are drawn back along themselves. */
static void do_release(transfer_run *t)
{
    senses *s = t->see;
    hand_open(s->w, 0.4);
    if (t->since > 0.2) {
        hand_go(s->w, v_along(t->from, 20e-3, t->back), 0.04);
    }
    if (t->since > 0.9) {
        hand_open(s->w, 0.0);
        enter(t, TRANSFER_OFFER);
    }
}

/* C holds the limb up, a little slack. */
static void do_offer(transfer_run *t)
{
    senses *s = t->see;
    vec at = senses_tip_holding_up(s, v3(0.2, -0.3, 1.0), 0.97);
    hand_go(s->c, at, 0.1);
    if (t->misses > 0 && t->since < 0.8) { /* out as it came in */
        hand_go(s->w, v_along(t->from, 30e-3, t->back), 0.06);
        return;
    }
    hand_go(s->w, v3(-0.04, -0.04, 0.05), 0.1);
    if (v_distance(s->tool_c.tip, at) < 2e-3 && t->since > 0.5) {
        uint32_t node = s->c->node + BEYOND;
        catch_begin(&t->grip, s, s->w, node, 1.0, 0.1);
        enter(t, node + 3 < s->nodes ? TRANSFER_TAKE : TRANSFER_FAILED);
    }
}

static void do_take(transfer_run *t, double dt)
{
    senses *s = t->see;
    hand_turn(s->w, catch_point(s, s->w, t->grip.node));
    catch_step(&t->grip, dt);
    if (t->grip.state == CATCH_HELD) {
        t->from = s->tool_c.tip;
        t->back = s->tool_c.handle;
        t->aside = v_cross(s->tool_c.handle, s->tool_c.opening);
        enter(t, TRANSFER_GIVE);
    } else if (t->grip.state == CATCH_MISSED) {
        t->from = s->tool_w.tip;
        t->back = s->tool_w.handle;
        enter(t, t->misses++ < 2 ? TRANSFER_OFFER : TRANSFER_FAILED);
    }
}

/* The parts are exchanged: the world in a mirror. */
static vbss_result exchange(senses *s)
{
    hand *w = s->w;
    s->w = s->c;
    s->c = w;
    s->w->side = -s->w->side;
    s->c->side = -s->c->side;
    return vbss_knot_detector_reset(s->detector);
}

static vbss_result do_give(transfer_run *t)
{
    senses *s = t->see;
    hand_open(s->c, 0.6);
    if (t->since > 0.15) {
        hand_go(s->c, v_along(t->from, 30e-3, t->back), 0.06);
    }
    if (t->since > 0.9) { /* beside the limb, lest they close on it again */
        hand_go(s->c, v_along(v_along(t->from, 30e-3, t->back), 15e-3, t->aside), 0.06);
    }
    if (t->tries > 0) { /* its end still between them: so far off that it is drawn out */
        hand_open(s->c, 1.0);
        hand_go(s->c, v_along(t->from, 30e-3 + 30e-3 * t->tries, t->back), 0.06);
    }
    if (t->since > 1.3) {
        hand_open(s->c, 0.0);
    }
    if (t->since > 1.6 && s->c->holds) {
        if (t->tries++ == 4) {
            enter(t, TRANSFER_FAILED);
            return VBSS_OK;
        }
        t->since = 0.0;
    } else if (t->since > 1.6) {
        enter(t, TRANSFER_DONE);
        return exchange(s);
    }
    return VBSS_OK;
}

vbss_result transfer_step(transfer_run *t, double dt)
{
    t->since += dt;
    switch (t->state) {
    case TRANSFER_EASE:
        do_ease(t);
        return VBSS_OK;
    case TRANSFER_RELEASE:
        do_release(t);
        return VBSS_OK;
    case TRANSFER_OFFER:
        do_offer(t);
        return VBSS_OK;
    case TRANSFER_TAKE:
        do_take(t, dt);
        return VBSS_OK;
    case TRANSFER_GIVE:
        return do_give(t);
    default:
        return VBSS_OK;
    }
}
