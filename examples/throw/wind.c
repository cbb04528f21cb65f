#include "throw/states.h"

#define BACK_OFF 0.8     /* rad, of C on its orbit when it has hooked something */
#define FASTEST 10.0     /* rad/s, of C on its orbit; */
#define FASTEST_BACK 3.0 /* back, so that its circle can become wider as turns come off */
#define NEARLY 0.35      /* rad before the end of the orbit, where it may end as well */

vbss_result throw_pick(throw_run *t, double dt)
{
    const senses *s = t->see;
    hand_turn(s->c, catch_point(s, s->c, t->grip.node));
    catch_step(&t->grip, dt);
    if (t->grip.state == CATCH_HELD) {
        t->hold = senses_length(s, t->limb_root, s->c->node);
        throw_enter(t, THROW_NEAR);
        return throw_rig_release_limb(s->rig);
    }
    if (t->grip.state == CATCH_MISSED) {
        throw_fail(t, "limb not taken");
    }
    return VBSS_OK;
}

void throw_near(throw_run *t)
{
    const senses *s = t->see;
    hand_turn(s->c, v3(1.0, 0.0, 0.0));
    vec jaws = v3(0.004, -0.024, t->plan.wrap_tip.z - 0.01);
    hand_go(s->c, steer_tip_of(t, jaws), 0.12);
    if (v_distance(s->held_c, jaws) < 3e-3) {
        throw_enter(t, THROW_PLACE);
        hand_target(s->w, s->w->nature.target_at);
    }
}

void throw_place(throw_run *t)
{
    const senses *s = t->see;
    hand_go(s->w, t->plan.wrap_tip, 0.15);
    hand_turn(s->w, t->plan.wrap_point);
    if (v_distance(s->tool_w.tip, t->plan.wrap_tip) < 2e-3 && t->since > 0.2) {
        steer_frame f = steer_about_w(t, t->plan.s0);
        vec to = v_sub(steer_limb_root(t), f.origin), c = v_sub(s->held_c, f.origin);
        t->begin = vbss_atan2(v_dot(to, f.away), v_dot(to, f.over));
        if (t->begin > 0.0) {
            t->begin -= 2.0 * PI;
        }
        t->phi = vbss_atan2(v_dot(c, f.away), v_dot(c, f.over));
        t->rho = v_hypotenuse(v_dot(c, f.away), v_dot(c, f.over));
        hand_target(s->c, s->c->nature.target_at);
        t->clear = 0.0;
        t->back = false;
        throw_enter(t, THROW_ORBIT);
    }
}

/* C's needle may catch what it goes past. What holds C is not pulled at: back as it came, and wound anew. */
static bool is_hooked(throw_run *t, double sign, double rate, double dt)
{
    bool feels = t->plan.backs_off > 0.0 && t->see->tension_c > t->plan.backs_off;
    if (t->hooked == 0.0 && feels && t->retries < t->plan.retries) {
        t->hooked = BACK_OFF;
    }
    if (t->hooked == 0.0) {
        return false;
    }
    t->hooked -= rate * dt;
    t->phi -= sign * rate * dt;
    steer_keep_taut(t, 0.3, dt);
    if (t->hooked <= 0.0) {
        t->hooked = 0.0;
        throw_fail(t, "limb hooked");
    }
    return true;
}

void throw_orbit(throw_run *t, double dt)
{
    const senses *s = t->see;
    double sign = t->plan.wrong ? -1.0 : 1.0;
    double end = t->begin + sign * (2.0 * PI * (t->plan.wraps + 0.5) + t->plan.beyond);
    if (t->unwinds) {
        end = t->begin;
        sign = end < t->phi ? -1.0 : 1.0;
    } else if (t->back) {
        end -= sign * (2.0 * PI * t->plan.wraps + t->plan.beyond);
        sign = -sign;
    }
    double fastest = t->unwinds || (t->back && t->plan.waits) ? FASTEST_BACK : FASTEST;
    double rate = smaller(t->plan.speed * s->c->nature.speed / t->rho, fastest);
    if (is_hooked(t, sign, rate, dt)) {
        return;
    }
    bool stuck = s->tension_c > 3.0 * t->plan.tension;
    t->clear = stuck ? t->clear + dt : 0.0;
    if (stuck) {
        rate = 0.0;
    } else if (s->tension_c > t->plan.tension) {
        rate *= 0.3;
    }
    t->phi += sign * smaller(rate * dt, sign * (end - t->phi));
    steer_keep_taut(t, 0.3, dt);
    if (t->unwinds && sign * (end - t->phi) < 1e-9) {
        t->unwinds = false;
        t->plan = t->next;
        throw_enter(t, THROW_NEAR);
    } else if (sign * (end - t->phi) < 1e-9 ||
               (t->clear > 0.7 &&
                sign * (end - t->phi) < NEARLY)) { /* or as far as the limb lets it */
        bool turns_back = t->plan.mistake == THROW_COUNTER && !t->back;
        throw_enter(t, turns_back ? THROW_ORBIT : THROW_CHECK);
        t->back = t->back || turns_back;
        t->clear = 0.0;
    } else if (t->since > 15.0) {
        throw_fail(t, "orbit takes too long");
    }
}

/* W lets go and is drawn out of the turns along its jaws. */
void throw_unwind(throw_run *t)
{
    const senses *s = t->see;
    hand_open(s->w, s->w->holds ? 0.5 : 0.0);
    vec back = v_along(s->tool_w.tip, 0.02, s->tool_w.handle);
    bool out = t->since > 0.5 && s->last == 0 && s->tool_w.tip.x < -0.02;
    hand_go(s->w, s->tool_w.tip.x < -0.02 ? v3(-0.06, -0.06, 0.06) : back, 0.08);
    steer_yield(t);
    if ((out && s->tool_w.tip.x < -0.045) || t->since > 4.0) {
        t->give = 1.0;
        throw_enter(t, t->dropped || t->left ? THROW_DONE : THROW_NEAR);
    }
}

void throw_leave(throw_run *t)
{
    t->left = true;
    throw_enter(t, THROW_UNWIND);
}

void throw_check(throw_run *t, double dt)
{
    senses *s = t->see;
    steer_keep_taut(t, 0.2, dt);
    if (t->since < 0.15) {
        return;
    }
    double more = t->plan.soft ? 1.4 : 0.9; /* a slack limb winds further on */
    double turns = t->plan.wrong ? -s->turns : s->turns;
    bool meant = t->plan.mistake == THROW_TO_HANDLE || t->plan.mistake == THROW_COUNTER;
    bool right = turns > t->plan.wraps - 0.15 && turns < t->plan.wraps + more;
    if (right || meant) {
        throw_enter(t, THROW_TAIL);
        catch_begin(&t->grip, s, s->w, t->plan.tail_node, t->plan.opening, 0.06);
        t->grip.behind = t->plan.behind;
        t->grip.minds = t->plan.minds;
        hand_target(s->w, s->w->nature.target_end);
    } else {
        throw_fail(t, "wrap lost");
    }
}
