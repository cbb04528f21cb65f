#include "throw/states.h"

#include <string.h>

#define UPRIGHT (0.5 * PI)
enum { NEXT_PLACE = 2 };    /* nodes farther from the end, at each */
#define HANGS 0.5           /* share of what C may feel of the limb: it is taut */
#define STUCK 1.5           /* s: drawn so long as far round as W goes, the turn hangs at its tip */
#define HARDER (1.0 / 1.5)  /* more of both forces per s then */
#define LONG_DRAWN 6.0      /* s */
#define LOST 0.3            /* s, that turns are off W's jaws before it has the tail */
#define EASES 3e-3          /* m, of W as it closes */
#define CHECK_INTERVAL 0.02 /* s, between checks whether the end has come through */
#define SURELY 0.2 /* s, that it has, and turns are off W's jaws: they may catch at the tip again */

/* Open jaws do not get at what lies on the floor: told to, they press on it. */
static uint32_t place_of_tail(const throw_run *t)
{
    const senses *s = t->see;
    uint32_t node = t->plan.tail_node + NEXT_PLACE * t->elsewhere;
    while (2 * node < t->tail_root && s->x[node].z < FLOOR_HEIGHT + t->plan.off_floor) {
        node++;
    }
    return node;
}

static void begin_catch(throw_run *t, uint32_t node)
{
    hand_open(t->see->w, t->plan.opening);
    catch_begin(&t->grip, t->see, t->see->w, node, t->plan.opening, 0.06);
    t->grip.behind = t->plan.behind;
    t->grip.minds = t->plan.minds;
}

void throw_take_tail(throw_run *t, uint32_t node)
{
    begin_catch(t, node);
    throw_enter(t, THROW_TAIL);
}

/* Whether the tail is caught once more, nearer to the drain. */
static bool is_caught_elsewhere(throw_run *t)
{
    if (t->elsewhere >= t->plan.catches) {
        return false;
    }
    t->refused++;
    t->elsewhere++;
    throw_take_tail(t, place_of_tail(t));
    return true;
}

void throw_tail(throw_run *t, double dt)
{
    const senses *s = t->see;
    if (t->grip.state == CATCH_COME) {
        t->grip.node = place_of_tail(t);
        hand_turn(s->w, catch_point(s, s->w, t->grip.node));
    }
    catch_step(&t->grip, dt);
    steer_keep(t, dt);
    t->lost = t->plan.again && s->last == 0 ? t->lost + dt : 0.0;
    if (t->lost > LOST) {
        throw_fail(t, "turns lost");
    } else if (t->plan.again && v_length(senses_drain(s)) > THROW_DRAGGED) {
        throw_fail(t, "drain dragged");
    } else if (t->grip.state == CATCH_HELD) {
        /* toward the drain: where it stops, late, it would draw the tail */
        vec to_root = v_unit(v_sub(steer_tail_root(t), s->tool_w.tip));
        t->carrot_w = v_along(s->tool_w.tip, EASES, to_root);
        throw_enter(t, THROW_CLOSE);
    } else if (t->grip.state == CATCH_MISSED && !is_caught_elsewhere(t)) {
        throw_fail(t, "tail not caught");
    }
}

void throw_retake(throw_run *t, bool evenly)
{
    t->evenly = evenly && !t->plan.even; /* pulled so before, it has sprung open again */
    t->elsewhere = 0;
    begin_catch(t, place_of_tail(t));
    throw_enter(t, THROW_RETAKE);
}

/* A tail that cannot be taken again is left. */
void throw_take_again(throw_run *t, double dt)
{
    if (t->grip.state == CATCH_COME) {
        t->grip.node = place_of_tail(t);
        hand_turn(t->see->w, catch_point(t->see, t->see->w, t->grip.node));
    }
    catch_step(&t->grip, dt);
    if (t->grip.state == CATCH_HELD && t->evenly) {
        throw_pull_evenly(t);
    } else if (t->grip.state == CATCH_HELD) {
        throw_pull_again(t);
    } else if (t->grip.state == CATCH_MISSED) {
        throw_enter(t, THROW_DONE);
    }
}

vbss_result throw_close(throw_run *t, double dt)
{
    senses *s = t->see;
    steer_keep(t, dt);
    hand_go(s->w, t->carrot_w, 0.02);
    if (t->since < 0.15) {
        return VBSS_OK;
    }
    TRY(senses_judge(s, true, &t->predicted));
    const vbss_knot_state *k = &t->predicted.state;
    bool right = k->next_verdict == VBSS_KNOT_VERDICT_PASSED && k->next_wraps == t->plan.wraps &&
                 k->next_handedness == throw_handedness(t);
    if (right || t->plan.unchecked) {
        vec from = v_sub(steer_jaws_of(&s->tool_w), steer_tail_root(t));
        t->angle = t->begun = vbss_atan2(from.z, from.x);
        t->leash = v_hypotenuse(from.z, from.x);
        t->clear = t->far_round = 0.0;
        t->carrot_c = s->tool_c.tip;
        throw_enter(t, THROW_DRAW);
    } else if (!is_caught_elsewhere(t)) {
        t->refused++;
        throw_fail(t, "wrong knot at the catch");
    }
    return VBSS_OK;
}

/* Drawn for long, the limb may lie on W's jaws still, with no turn about them. */
static bool is_off_jaws(const throw_run *t)
{
    bool rests =
        t->plan.again && t->far_round > 0.0 && t->since > LONG_DRAWN && t->see->turns < 0.6;
    return t->see->last == 0 || rests;
}

static bool is_certain_but_for_order(const vbss_knot_state *k)
{
    return k->verdict == VBSS_KNOT_VERDICT_FORMED &&
           (k->faults & ~(uint32_t)VBSS_KNOT_FAULT_FEW) == VBSS_KNOT_FAULT_ORDER;
}

bool throw_is_formed_as(const throw_run *t, const char *notation)
{
    return strcmp(t->formed.notation, notation) == 0 || is_certain_but_for_order(&t->formed.state);
}

/* Loose throws are told, but which is below which may not be before they are pulled tight: drawn in vain for that, finished ones
 * were pulled open and wound about once more. */
static bool is_certain(const throw_run *t)
{
    bool long_drawn = t->plan.again && t->far_round > 0.0 && t->since > LONG_DRAWN;
    return t->formed.state.verdict == VBSS_KNOT_VERDICT_CERTIFIED ||
           (long_drawn && is_certain_but_for_order(&t->formed.state));
}

/* Has the end come through, whatever the tools hold? */
static vbss_result is_formed(throw_run *t, bool *formed)
{
    TRY(senses_judge(t->see, false, &t->formed));
    *formed = t->formed.state.throw_count > t->throws_before && is_certain(t) && is_off_jaws(t);
    return VBSS_OK;
}

#define OFF_JAWS 0.5 /* s, that turns are off them */
#define DROP_AT 0.4  /* rad of W's way, on which the end comes through later */

/* How the drawing of a throw ends that is none, or is left. */
static void draw_in_vain(throw_run *t, double dt)
{
    const senses *s = t->see;
    t->clear = s->last == 0 ? t->clear + dt : 0.0;
    if (t->plan.mistake == THROW_DROPPED && fabs(t->angle - t->begun) > DROP_AT) {
        if (t->plan.waits) {
            hand_open(t->see->w, t->plan.opening);
            hand_go(t->see->w, t->see->tool_w.tip, 0.02);
            return;
        }
        t->dropped = true;
        throw_enter(t, THROW_UNWIND);
    } else if (t->plan.mistake != THROW_DROPPED && t->clear > OFF_JAWS) {
        throw_enter(t, THROW_DONE);
    }
}

vbss_result throw_draw(throw_run *t, double dt)
{
    senses *s = t->see;
    bool formed = false;
    const double round = t->plan.raised ? RAISED : DRAWN_ROUND;
    double length = 0.97 * senses_length(s, s->w->node, t->tail_root);
    double speed = t->angle * 180.0 / PI < 50.0 ? 0.03 : 0.02;
    if (s->tension_w < t->plan.drawn + 0.05) {
        t->angle = smaller(t->angle + speed / length * dt, round);
    }
    if (t->plan.soft && t->angle > UPRIGHT) {
        hand_turn(s->w, OUTWARD); /* lest the last turn hang on its jaws */
    }
    bool is_round = t->angle > round - 2e-3;
    if (is_round && s->tension_c > HANGS * t->plan.light) {
        t->far_round += dt;
    }
    double harder = t->plan.again ? 1.0 + HARDER * larger(t->far_round - STUCK, 0.0) : 1.0;
    throw_on_leash(t, t->plan.drawn * harder, dt);
    if (t->plan.soft && s->last > 0 && !is_round) {
        steer_keep(t, dt); /* a taut limb would go with W, and open the throw below */
    } else {
        throw_follow(t, s->last > 0 ? t->plan.light * harder : t->plan.light, dt);
    }
    if (t->plan.mistake >= THROW_TO_HANDLE && t->plan.mistake <= THROW_DROPPED) {
        draw_in_vain(t, dt);
        return VBSS_OK;
    }
    if (fmod(t->since, CHECK_INTERVAL) < dt) {
        if (s->turns < t->plan.wraps) {
            TRY(is_formed(t, &formed));
        }
        t->clear = formed ? t->clear + CHECK_INTERVAL : 0.0;
    }
    if (formed && t->clear > (t->plan.again ? SURELY : 0.0)) {
        t->carrot_c = s->tool_c.tip;
        throw_enter(t, THROW_LOWER);
    } else if (t->since > (t->plan.reach < REACH ? 16.0 : 8.0)) {
        throw_fail(t, "not drawn through");
    }
    return VBSS_OK;
}
