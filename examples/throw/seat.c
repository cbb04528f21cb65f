#include "throw/states.h"

#define RISE 1.0      /* N/s, of a pull at both ends */
#define FAR_SIDE 0.02 /* m, of C from the knot while it comes down */
#define LOW 0.003     /* m above the drain's top, where it has come down */

/* C follows to the right, and gives way toward W. */
void throw_follow(throw_run *t, double dt)
{
    const senses *s = t->see;
    double speed = 0.03, least = t->plan.light;
    vec way = v3(1.0, 0.0, -0.3);
    if (t->plan.soft) { /* down by the far side, then along the drain's top */
        double far = s->tool_c.tip.y < FAR_SIDE ? 0.6 : 0.0;
        way = s->tool_c.tip.z > LOW ? v3(0.6, far, -0.7) : v3(1.0, 0.0, 0.0);
    }
    if (s->tension_c > least) {
        way = v_unit(v_sub(s->tool_w.tip, s->tool_c.tip));
        speed = fmin(0.1, 0.03 * (s->tension_c / least - 1.0) + 0.005);
    }
    t->carrot_c = v_along(t->carrot_c, speed * dt, way);
    t->carrot_c = v_add(s->tool_c.tip, v_limit(v_sub(t->carrot_c, s->tool_c.tip), 8e-3));
    hand_go(s->c, t->carrot_c, 0.15);
}

/* W is on a leash: the tail, or what is left of it. */
void throw_on_leash(throw_run *t, double most, double dt)
{
    const senses *s = t->see;
    double full = 0.98 * senses_length(s, s->w->node, t->tail_root);
    t->leash += s->tension_w > most ? -0.03 * dt : 0.01 * dt;
    t->leash = clamp(t->leash, 0.3 * full, full);
    double up = sin(t->angle), tilt = t->plan.tilt;
    vec way = v3(cos(t->angle), -up * sin(tilt), up * cos(tilt));
    vec jaws = v_along(steer_tail_root(t), t->leash, way);
    hand_go(s->w, v_along(jaws, -GRASP_BEHIND, s->tool_w.handle), 0.08);
}

/* Low on both sides before anything is tight. */
void throw_lower(throw_run *t, double dt)
{
    senses *s = t->see;
    hand_turn(s->w, OUTWARD);
    t->angle = fmin(t->angle + 0.04 / t->leash * dt, PI * 173.0 / 180.0);
    throw_on_leash(t, 0.05, dt);
    throw_follow(t, dt);
    if ((t->angle > PI * 172.0 / 180.0 && s->tool_w.tip.z < 6e-3) || t->since > 3.0) {
        t->carrot_w = s->tool_w.tip;
        t->carrot_c = s->tool_c.tip;
        t->clear = 0.0;
        throw_enter(t, THROW_SEAT);
    }
}

/* Where a hand goes to pull: fast while there is slack, then as the force that is missing asks. */
static void pull(hand *h, const hand_pose *p, vec *carrot, vec to, double felt, double wanted,
                 double dt)
{
    double missing = wanted - felt;
    double speed = felt < 0.3 && missing > 0.1 ? 0.04 : clamp(0.006 * missing, -0.02, 0.012);
    vec way = v_sub(to, p->tip);
    if (v_length(way) > 2e-3) {
        *carrot = v_along(*carrot, speed * dt, v_unit(way));
    }
    *carrot = v_add(p->tip, v_limit(v_sub(*carrot, p->tip), 5e-3));
    hand_go(h, *carrot, 0.05);
}

/* W lightly until C feels half the force, so that the turns run down to the drain. */
static void pull_one_first(throw_run *t, double dt)
{
    senses *s = t->see;
    const double full = t->plan.pull;
    double light = s->tension_c < 0.5 * full && t->clear == 0.0 ? 0.15 : full;
    pull(s->w, &s->tool_w, &t->carrot_w, v3(-0.07, 0.0, 0.002), s->tension_w, light, dt);
    pull(s->c, &s->tool_c, &t->carrot_c, v3(0.095, 0.0, 0.004), s->tension_c, full, dt);
    bool pulled = s->tension_w > 0.9 * full && s->tension_c > 0.9 * full;
    t->clear = light == full && t->clear == 0.0 ? dt : pulled ? t->clear + dt : t->clear;
}

/* Both ends alike and downward: pulled unlike, a throw on another one locks before it is down. */
static void pull_alike(throw_run *t, double dt)
{
    senses *s = t->see;
    const double full = t->plan.pull, low = -t->plan.low;
    double wanted = fmin(full, 0.1 + RISE * t->since);
    vec to_w = v3(-0.07 - t->plan.far, 0.0, low), to_c = v3(0.095 + t->plan.far, 0.0, low);
    pull(s->w, &s->tool_w, &t->carrot_w, to_w, s->tension_w, wanted, dt);
    pull(s->c, &s->tool_c, &t->carrot_c, to_c, s->tension_c, wanted, dt);
    t->clear += s->tension_w > 0.9 * full && s->tension_c > 0.9 * full ? dt : 0.0;
}

void throw_seat(throw_run *t, double dt)
{
    hand_turn(t->see->w, OUTWARD);
    if (t->plan.alike) {
        pull_alike(t, dt);
    } else {
        pull_one_first(t, dt);
    }
    if (t->clear > 0.5) {
        throw_enter(t, THROW_DONE);
    } else if (t->since > 12.0) {
        throw_fail(t, "not pulled tight");
    }
}
