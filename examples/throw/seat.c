#include "throw/states.h"

#define RISE 1.0                    /* N/s, of a pull at both ends */
#define FAR_SIDE 0.02               /* m, of C from the knot while it comes down */
#define SLACK_TIME 5.0              /* s: turns that are still on W's jaws then are drawn off */
#define CLOSING 0.1                 /* N, of both, while a turn closes on the tail */
#define BESIDE (PI * 205.0 / 180.0) /* of W then */
#define BESIDE_ASKEW (PI * 190.0 / 180.0) /* the drain is in the way */
#define ABOVE_ASKEW 0.01                  /* m, of C: the same */
#define UNLIKE 0.15                       /* N, of one end more than of the other */
#define FAR_W (-0.07)                     /* m, to where both pull in the end */
#define FAR_C 0.095
#define LOW 0.003 /* m above the drain's top, where it has come down */

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

static vec turned(vec way, double about)
{
    double c = cos(about), s = sin(about);
    return v3(c * way.x - s * way.y, s * way.x + c * way.y, way.z);
}

/* W is on a leash: the tail, or what is left of it. */
void throw_on_leash(throw_run *t, double most, double dt)
{
    const senses *s = t->see;
    bool slack = s->last > 0 && t->state == THROW_DRAW && t->since < SLACK_TIME;
    double share = slack ? t->plan.reach : REACH;
    double full = share * senses_length(s, s->w->node, t->tail_root);
    t->leash += s->tension_w > most ? -0.03 * dt : 0.01 * dt;
    t->leash = clamp(t->leash, 0.3 * full, full);
    double up = sin(t->angle), tilt = up > 0.0 ? t->plan.tilt : 0.0;
    vec way = v3(cos(t->angle), -up * sin(tilt), up * cos(tilt));
    way = t->state == THROW_SEAT ? turned(way, t->plan.askew) : way;
    vec jaws = v_along(steer_tail_root(t), t->leash, way);
    if (t->state == THROW_DRAW) {
        jaws.z = fmax(jaws.z, t->plan.least_height);
    }
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
    bool low = (t->angle > PI * 172.0 / 180.0 && s->tool_w.tip.z < 6e-3) || t->since > 3.0;
    if (low && t->plan.mistake == THROW_SLACK) {
        throw_enter(t, THROW_DONE);
    } else if (low) {
        t->carrot_w = s->tool_w.tip;
        t->carrot_c = s->tool_c.tip;
        t->clear = 0.0;
        throw_enter(t, THROW_SEAT);
    }
}

static void draw(hand *h, const hand_pose *p, vec *carrot, vec to, double speed, double dt)
{
    vec way = v_sub(to, p->tip);
    if (v_length(way) > 2e-3) {
        *carrot = v_along(*carrot, speed * dt, v_unit(way));
    }
    *carrot = v_add(p->tip, v_limit(v_sub(*carrot, p->tip), 5e-3));
    hand_go(h, *carrot, 0.05);
}

/* Where a hand goes to pull: fast while there is slack, then as the force that is missing asks. */
static void pull(hand *h, const hand_pose *p, vec *carrot, vec to, double felt, double wanted,
                 double dt)
{
    double missing = wanted - felt;
    bool slack = felt < 0.3 && missing > 0.1;
    draw(h, p, carrot, to, slack ? 0.04 : clamp(0.006 * missing, -0.02, 0.012), dt);
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

/* Far out, and so low. */
static vec outward(const throw_run *t, double way)
{
    return v3(way + (way > 0.0 ? t->plan.far : -t->plan.far), 0.0, -t->plan.low);
}

/* Both hands low on either side and the tail straight, C draws the limb round it: the turn runs down to what is tied. Closed
 * from above, or by W, it locks where it happens to be, up to 14 mm from there. In line with the stitch the ends go straight
 * back over what is tied, which opens at 0.05 N; askew it holds. */
static bool is_closed(throw_run *t, double dt)
{
    senses *s = t->see;
    if (!t->plan.down || t->closed > 0.0) {
        return true;
    }
    bool askew = t->plan.askew != 0.0;
    t->angle = fmin(t->angle + 0.04 / t->leash * dt, askew ? BESIDE_ASKEW : BESIDE);
    throw_on_leash(t, CLOSING, dt);
    double speed = clamp(0.4 * (CLOSING - s->tension_c), -0.02, 0.02);
    vec to = turned(outward(t, FAR_C), t->plan.askew);
    to.z += askew ? ABOVE_ASKEW : 0.0;
    draw(s->c, &s->tool_c, &t->carrot_c, to, speed, dt);
    t->clear = s->tension_c > 0.5 * CLOSING ? t->clear + dt : 0.0;
    if (t->clear > 0.1 || t->since > 8.0) {
        t->closed = t->since;
        t->clear = 0.0;
        t->carrot_w = s->tool_w.tip;
    }
    return false;
}

/* C alone moves, until it feels the limb; the thread of the open loop then goes to the limb, not to the tail. */
static bool is_taken_up(throw_run *t, double dt)
{
    senses *s = t->see;
    if (!t->plan.still || t->closed > 0.0) {
        return true;
    }
    pull(s->c, &s->tool_c, &t->carrot_c, outward(t, FAR_C), s->tension_c, 2.0 * CLOSING, dt);
    if (s->tension_c > CLOSING || t->since > 8.0) {
        t->closed = t->since;
        t->carrot_w = s->tool_w.tip;
    }
    return false;
}

/* Both ends alike and downward: pulled unlike, a throw on another one locks before it is down. */
static void pull_alike(throw_run *t, double dt)
{
    senses *s = t->see;
    const double full = t->plan.pull, more = t->plan.down ? UNLIKE : full;
    double wanted = fmin(full, 0.1 + RISE * (t->since - t->closed));
    double of_w = fmin(wanted, s->tension_c + more), of_c = fmin(wanted, s->tension_w + more);
    pull(s->w, &s->tool_w, &t->carrot_w, outward(t, FAR_W), s->tension_w, of_w, dt);
    pull(s->c, &s->tool_c, &t->carrot_c, outward(t, FAR_C), s->tension_c, of_c, dt);
    t->clear += s->tension_w > 0.9 * full && s->tension_c > 0.9 * full ? dt : 0.0;
}

/* The tail gets straight, and the limb is hitched round it. */
static void pull_tail_alone(throw_run *t, double dt)
{
    senses *s = t->see;
    const double full = t->plan.pull;
    pull(s->w, &s->tool_w, &t->carrot_w, outward(t, FAR_W), s->tension_w, full, dt);
    throw_follow(t, dt);
    t->clear += s->tension_w > 0.9 * full ? dt : 0.0;
}

void throw_seat(throw_run *t, double dt)
{
    hand_turn(t->see->w, OUTWARD);
    if (!is_taken_up(t, dt) || !is_closed(t, dt)) {
        return;
    }
    if (t->plan.mistake == THROW_ONE_SIDED) {
        pull_tail_alone(t, dt);
    } else if (t->plan.alike) {
        pull_alike(t, dt);
    } else {
        pull_one_first(t, dt);
    }
    if (t->clear > 0.5) {
        throw_enter(t, THROW_DONE);
    } else if (t->since - t->closed > 12.0) {
        throw_fail(t, "not pulled tight");
    }
}
