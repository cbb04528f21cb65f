#include "throw/cut.h"

#include <string.h>

#define ROOM 1.5e-3   /* of other thread from the place, along it */
#define REACH 8e-3    /* of the blades, beside it */
#define BEYOND 2.5e-3 /* of their tips, with what they may miss it by */
#define LEFT 4e-3     /* m of either end that is left on the knot */
#define FARTHER 2e-3  /* at each further try */
#define BEHIND 1.2e-3 /* of the blades' tips, where they cut */
#define OPENING 0.35  /* of the blades: no more is between them than need be */
#define SPEED 0.1     /* m/s */
#define DECIDED 2.0   /* s, where to cut */
#define AWAY v3(-0.06, -0.06, 0.06)
#define AWAY_C v3(0.08, -0.05, 0.05)
#define LIMB_UP v3(0.5, 0.2, 0.8) /* as C holds it */
#define TAUT 0.05                 /* N: the limb then */
#define YIELD 5e-3                /* m, that C gives way by */

const char *cut_state_name(cut_state state)
{
    static const char *const names[CUT_STATES] = {"ease",     "release", "leave",    "exchange",
                                                  "cut limb", "away",    "cut tail", "back",
                                                  "cut both", "not cut"};
    return names[state];
}

vbss_result cut_begin(cut_run *t, senses *see)
{
    memset(t, 0, sizeof *t);
    t->see = see;
    ease_begin(&t->easing, see);
    return senses_find_roots(see);
}

static void enter(cut_run *t, cut_state state)
{
    t->state = state;
    t->since = 0.0;
}

static void do_ease(cut_run *t, double dt)
{
    if (ease_step(&t->easing, t->see, dt)) {
        t->from = t->see->tool_w.tip;
        t->back = t->see->tool_w.handle;
        enter(t, CUT_RELEASE);
    }
}

static void do_release(cut_run *t)
{
    senses *s = t->see;
    hand_open(s->w, 0.4);
    if (t->since > 0.2) {
        hand_go(s->w, v_along(t->from, 20e-3, t->back), 0.06);
    }
    if (t->since > 0.2 && v_distance(s->tool_w.tip, t->from) > 15e-3) {
        hand_open(s->w, 0.0);
        enter(t, CUT_LEAVE);
    }
}

/* C holds the limb up, so that nothing is beside it where it comes out of the knot: not as far as it seems to, if it is taut. */
static void hold_up(const senses *s)
{
    vec back = v_sub(s->x[s->limb_root], s->tool_c.tip);
    bool taut = s->draws_c > TAUT;
    hand_go(s->c,
            taut ? v_along(s->tool_c.tip, YIELD, v_unit(back))
                 : senses_tip_holding_up(s, LIMB_UP, 0.98),
            0.06);
}

static void do_leave(cut_run *t)
{
    senses *s = t->see;
    hand_go(s->w, AWAY, 0.15);
    hold_up(s);
    if (v_distance(s->tool_w.tip, AWAY) < 3e-3) {
        hand_take_tool(s->w, VBSS_DEVICE_TOOL_SHEARS);
        enter(t, CUT_EXCHANGE);
    }
}

/* Of the thread, toward the limb. */
static vec tangent_at(const senses *s, uint32_t node)
{
    return v_unit(v_sub(s->x[node + 2], s->x[node - 2]));
}

/* What else lies between the blades would be cut with it, and open they are wide; hardly anything of them is beyond
 * the place. */
static bool is_alone(const senses *s, uint32_t node, double clear)
{
    if (clear > 0.0 && height_above_drain(s->x[node]) < clear) {
        return false;
    }
    vec tangent = tangent_at(s, node);
    vec back = v_unit(v_across(v_sub(seen(s->w, s->w->trocar), s->x[node]), tangent));
    for (uint32_t i = 0; i < s->nodes; i++) {
        vec to = v_sub(s->x[i], s->x[node]);
        uint32_t between = i > node ? i - node : node - i;
        if (between * SEGMENT > 2.0 * ROOM && fabs(v_dot(to, tangent)) < ROOM &&
            v_length(to) < REACH && v_dot(to, back) > -BEYOND) {
            return false;
        }
    }
    return true;
}

/* As near to the knot as the blades can be without touching more than that end. */
static uint32_t place_of(const cut_run *t, bool limb, int tries)
{
    const senses *s = t->see;
    uint32_t left = (uint32_t)((LEFT + FARTHER * tries) / SEGMENT);
    /* Before C's jaws; and two nodes on either side are looked at. */
    uint32_t end = limb && senses_holds(s, s->c) ? s->c->node : s->nodes;
    uint32_t last = end - 3, node = s->limb_root + left;
    if (!limb) {
        node = s->tail_root > left + 2 ? s->tail_root - left : 2; /* it may be that short */
    }
    node = node < last ? node : last;
    while (node > 8 && node + 8 < end && !is_alone(s, node, t->clear)) {
        node += limb ? 1 : UINT32_MAX;
    }
    return node;
}

/* Slack, the knot has opened: it ends elsewhere than when it was pulled. */
static vbss_result target_at(cut_run *t, bool limb)
{
    senses *s = t->see;
    TRY(senses_find_roots(s));
    uint32_t node = place_of(t, limb, 0);
    catch_begin(&t->grip, s, s->w, node, OPENING, SPEED);
    t->grip.behind = BEHIND;
    t->grip.resolute = true;
    t->cuts = s->rig->cuts;
    hand_target(s->w, s->w->nature.target_end);
    return VBSS_OK;
}

static vbss_result do_exchange(cut_run *t)
{
    senses *s = t->see;
    vbss_grasper_state state;
    hold_up(s);
    TRY(vbss_grasper_get_state(s->w->grasper, &state, sizeof state));
    if (state.kind == VBSS_GRASPER_KIND_SHEARS) {
        TRY(target_at(t, true));
        enter(t, CUT_LIMB);
    } else if (t->since > 1.0) {
        enter(t, CUT_FAILED);
    }
    return VBSS_OK;
}

/* The bend leads the blades away from the line of the thread, so that they lie as square to it as they can. */
static vec across(const senses *s, uint32_t node)
{
    vec tangent = tangent_at(s, node);
    vec to = v_sub(seen(s->w, s->w->trocar), s->x[node]);
    return v_scale(v_dot(tangent, to) > 0.0 ? -1.0 : 1.0, tangent);
}

/* Blades come to the thread as jaws do. */
static bool is_cut(cut_run *t, double dt)
{
    const senses *s = t->see;
    if (s->rig->cuts > t->cuts) {
        t->ends++;
        return true;
    }
    /* The ends still move; but near to them the blades do not go from one place to another and back. */
    if (t->grip.state == CATCH_COME && t->grip.since < DECIDED) {
        t->grip.node = place_of(t, t->state == CUT_LIMB, t->grip.tries);
    }
    hand_turn(s->w, across(s, t->grip.node));
    catch_step(&t->grip, dt);
    if (t->grip.state == CATCH_MISSED) {
        enter(t, CUT_FAILED);
    }
    return false;
}

static void do_limb(cut_run *t, double dt)
{
    senses *s = t->see;
    if (!is_cut(t, dt)) {
        hold_up(s);
    } else {
        t->left_limb = senses_length(s, s->limb_root, s->nodes - 1);
        t->from = s->tool_w.tip;
        t->back = s->tool_w.handle;
        enter(t, CUT_AWAY);
    }
}

static vbss_result do_away(cut_run *t)
{
    senses *s = t->see;
    hand_go(s->w, v_along(t->from, 25e-3, t->back), SPEED);
    hand_open(s->w, 0.0);
    hand_go(s->c, AWAY_C, SPEED);
    if (v_distance(s->tool_c.tip, AWAY_C) < 5e-3) {
        TRY(target_at(t, false));
        enter(t, CUT_TAIL);
    }
    return VBSS_OK;
}

static void do_tail(cut_run *t, double dt)
{
    senses *s = t->see;
    if (is_cut(t, dt)) {
        t->left_tail = senses_length(s, 0, s->tail_root);
        t->from = s->tool_w.tip;
        t->back = s->tool_w.handle;
        enter(t, CUT_WITHDRAW);
    }
}

static void do_withdraw(cut_run *t)
{
    senses *s = t->see;
    hand_go(s->w, v_along(t->from, 40e-3, t->back), SPEED);
    if (v_distance(s->tool_w.tip, t->from) > 30e-3) {
        enter(t, CUT_DONE);
    }
}

vbss_result cut_step(cut_run *t, double dt)
{
    t->since += dt;
    switch (t->state) {
    case CUT_EASE:
        do_ease(t, dt);
        break;
    case CUT_RELEASE:
        do_release(t);
        break;
    case CUT_LEAVE:
        do_leave(t);
        break;
    case CUT_EXCHANGE:
        return do_exchange(t);
    case CUT_LIMB:
        do_limb(t, dt);
        break;
    case CUT_AWAY:
        return do_away(t);
    case CUT_TAIL:
        do_tail(t, dt);
        break;
    case CUT_WITHDRAW:
        do_withdraw(t);
        break;
    default:
        break;
    }
    return VBSS_OK;
}
