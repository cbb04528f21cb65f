#include "throw/states.h"

#define RISE 1.0                          /* N/s, of a pull at both ends */
#define FAR_SIDE 0.02                     /* m, of C from the knot while it comes down */
#define SLACK_TIME 3.0                    /* s: turns that hang on W's jaws so long are drawn off */
#define CLOSING 0.1                       /* N, of both, while a turn closes on the tail */
#define BESIDE (PI * 205.0 / 180.0)       /* of W then */
#define BESIDE_ASKEW (PI * 190.0 / 180.0) /* the drain is in the way */
#define ABOVE_ASKEW 0.01                  /* m, of C: the same */
/* From the stitch's line to where C goes then, away from a raised tail, which is on the near side. */
#define ACROSS (PI / 4.0)
#define UNLIKE 0.15               /* N, of one end more than of the other */
#define ROUND 1.5                 /* rad/s, of both hands about the knot when they go back */
#define SLACK_BACK 0.75           /* share of either end's length that they are from it then */
#define BACK (PI * 178.0 / 180.0) /* where they go: W's shaft is not over the knot */
#define BACK_W 1e-3               /* m above the drain's top, of W then */
#define BACK_C 2e-3
#define BACK_NEAR 8e-3 /* m, of C from where it goes: it is there */
/* Pulled again so often, it is left as it was pulled: squared it has sprung open as often. */
enum { SQUARED_NO_MORE = 2 };
#define BACK_LATEST 10.0    /* s */
#define FULL 2.0            /* N, of both ends from there, at most */
#define SQUARING 0.8        /* N, of both ends while the hands come from there again */
#define SLACK_FORCE 0.03    /* N */
#define EASING 3.0          /* s, at most */
#define MIN_SLACK_TIME 0.15 /* s, slack */
#define LOOSENED 0.45       /* s: until then both ends are given slack, */
#define LOOSENING 0.01      /* m/s */
#define LEFT_ALONE 1.3      /* s: then it is done; it slips late */
#define AHEAD 0.3           /* N, of what is asked for over what the weaker end bears */
#define UNLIKE_MIN 0.05     /* of slack ends */
#define UNLIKE_SHARE 0.3    /* in between, of the weaker one's */
#define LEAN 120.0          /* N/m: so much less, of the end to which the drain has gone */
#define LEAN_MAX 1.0        /* N */
/* A drain that does not come back for it is left where it is: no more of it from then on, and none in the end, s. */
#define LEAN_FADES 4.0
#define LEAN_FADED 6.0
#define EASY 0.1      /* N: less is nearly slack */
#define QUICK 0.4     /* m/s per N that is missing, while it is */
#define STIFF 0.02    /* then */
#define PULLING 0.02  /* m/s, at most */
#define FAR_W (-0.07) /* m, to where both pull in the end */
#define FAR_C 0.095
#define BEYOND 0.01 /* m, of the tip, at least */
/* Slip measure from which one end bends and the other does not; up to which both do alike. */
#define BENDS 0.2
#define EVEN 0.25
#define GIVING 6e-3  /* m/s, of W with a tail that is straight */
#define NO_PULL 5e-3 /* N: it is slack */
#define NEAREST 6e-3 /* m, of W to where the tail comes out of the knot */
#define AHEAD_W 3e-3 /* m, of where W goes, before it */
#define LOW 0.003    /* m above the drain's top, where it has come down */

/* C follows to the right, and gives way toward W. */
void throw_follow(throw_run *t, double smallest, double dt)
{
    const senses *s = t->see;
    double speed = 0.03;
    vec direction = v3(1.0, 0.0, -0.3);
    if (t->plan.soft) { /* down by the far side, then along the drain's top */
        double far = s->tool_c.tip.y < FAR_SIDE ? 0.6 : 0.0;
        direction = s->tool_c.tip.z > LOW ? v3(0.6, far, -0.7) : v3(1.0, 0.0, 0.0);
    }
    if (s->tension_c > smallest) {
        direction = v_unit(v_sub(s->tool_w.tip, s->tool_c.tip));
        speed = smaller(0.1, 0.03 * (s->tension_c / smallest - 1.0) + 0.005);
    }
    t->carrot_c = v_along(t->carrot_c, speed * dt, direction);
    t->carrot_c = v_add(s->tool_c.tip, v_limit(v_sub(t->carrot_c, s->tool_c.tip), 8e-3));
    hand_go(s->c, t->carrot_c, 0.15);
}

static vec turned(vec direction, double about)
{
    double c = vbss_cos(about), s = vbss_sin(about);
    return v3(c * direction.x - s * direction.y, s * direction.x + c * direction.y, direction.z);
}

/* W is on a leash: the tail, or what is left of it. */
void throw_on_leash(throw_run *t, double limit, double dt)
{
    const senses *s = t->see;
    bool slack = s->last > 0 && t->state == THROW_DRAW && t->far_round < SLACK_TIME;
    double share = slack ? t->plan.reach : REACH;
    double full = share * senses_length(s, s->w->node, t->tail_root);
    t->leash += s->tension_w > limit ? -0.03 * dt : 0.01 * dt;
    t->leash = clamp(t->leash, 0.3 * full, full);
    double up = vbss_sin(t->angle), tilt = up > 0.0 ? t->plan.tilt : 0.0;
    vec direction = v3(vbss_cos(t->angle), -up * vbss_sin(tilt), up * vbss_cos(tilt));
    direction = t->state == THROW_SEAT ? turned(direction, t->plan.askew) : direction;
    vec jaws = v_along(steer_tail_root(t), t->leash, direction);
    if (t->state == THROW_DRAW) {
        jaws.z = larger(jaws.z, t->plan.min_height);
    }
    hand_go(s->w, v_along(jaws, -GRASP_BEHIND, s->tool_w.handle), t->plan.sweep);
}

static void begin_seat(throw_run *t)
{
    t->carrot_w = t->see->tool_w.tip;
    t->carrot_c = t->see->tool_c.tip;
    t->clear = 0.0;
    throw_enter(t, THROW_SEAT);
}

/* Low on both sides before anything is tight; a raised tail is not laid down. */
void throw_lower(throw_run *t, double dt)
{
    senses *s = t->see;
    hand_turn(s->w, OUTWARD);
    if (t->plan.raised) {
        begin_seat(t);
        return;
    }
    t->angle = smaller(t->angle + 0.04 / t->leash * dt, PI * 173.0 / 180.0);
    throw_on_leash(t, 0.05, dt);
    throw_follow(t, t->plan.light, dt);
    bool low = (t->angle > PI * 172.0 / 180.0 && s->tool_w.tip.z < 6e-3) || t->since > 3.0;
    if (low && t->plan.mistake == THROW_SLACK) {
        if (!t->plan.waits) {
            throw_enter(t, THROW_DONE);
        }
    } else if (low) {
        begin_seat(t);
    }
}

static void draw(hand *h, const hand_pose *p, vec *carrot, vec to, double speed, double dt)
{
    vec to_goal = v_sub(to, p->tip);
    if (v_length(to_goal) > 2e-3) {
        *carrot = v_along(*carrot, speed * dt, v_unit(to_goal));
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

/* Far out, and so low; farther than where the tip is already, as a long limb is slack there still. */
static vec outward(const throw_run *t, const hand_pose *p, double x)
{
    const double side = x > 0.0 ? 1.0 : -1.0;
    const double far = larger(side * x + t->plan.far, side * p->tip.x + BEYOND);
    return v3(side * far, 0.0, -t->plan.low);
}

/* The tail was drawn through straight, and the limb lies about it: pulled like that, the throw is a half hitch. W gives until the tail bends as
 * well, while C draws the turn down. What it gives may open the throw below. */
static bool is_even(throw_run *t, double dt)
{
    senses *s = t->see;
    const vec to_root = v_sub(steer_tail_root(t), s->tool_w.tip);
    if (t->plan.gives && t->slip < -BENDS && s->tension_w > NO_PULL &&
        v_length(to_root) > NEAREST) {
        t->carrot_w = v_along(t->carrot_w, GIVING * dt, v_unit(to_root));
    } else if (t->slip > BENDS) {
        t->carrot_w = v_along(t->carrot_w, -GIVING * dt, v_unit(to_root));
    }
    t->carrot_w = v_add(s->tool_w.tip, v_limit(v_sub(t->carrot_w, s->tool_w.tip), AHEAD_W));
    hand_go(s->w, t->carrot_w, 0.05);
    const double speed = clamp(0.4 * (CLOSING - s->tension_c), -0.02, 0.02);
    draw(s->c, &s->tool_c, &t->carrot_c, outward(t, &s->tool_c, FAR_C), speed, dt);
    const bool is = s->tension_c > 0.5 * CLOSING && fabs(t->slip) < EVEN;
    t->clear = is ? t->clear + dt : 0.0;
    return t->clear > 0.1;
}

/* Share of what C pulls with, that W does: what bears more becomes straight. */
static double share_of_w(const throw_run *t)
{
    return clamp(1.0 + 2.0 * (t->slip + 0.5 * BENDS), 0.3, 1.0);
}

/* Both hands are low on either side, the tail is straight, and C draws the limb round it: the turn runs down to the throw below.
 * Closed from above, or by W, it locks up to 14 mm away. In line with the stitch the ends go back over the throw below, which opens
 * at 0.05 N; at 45 degrees it holds. A tail that is raised on the near side also holds it. C goes away from such a tail, or the
 * turn stays at W. */
static bool is_closed(throw_run *t, double dt)
{
    senses *s = t->see;
    if (!t->plan.down || t->closed > 0.0) {
        return true;
    }
    if (t->plan.even) {
        if (is_even(t, dt) || t->since > 8.0) {
            t->closed = t->since;
            t->clear = 0.0;
            t->carrot_w = s->tool_w.tip;
        }
        return false;
    }
    bool raised = t->plan.raised, askew = raised || t->plan.askew != 0.0;
    if (!raised) {
        t->angle = smaller(t->angle + 0.04 / t->leash * dt, askew ? BESIDE_ASKEW : BESIDE);
    }
    throw_on_leash(t, CLOSING, dt);
    double speed = clamp(0.4 * (CLOSING - s->tension_c), -0.02, 0.02);
    vec to = turned(outward(t, &s->tool_c, FAR_C), raised ? ACROSS : t->plan.askew);
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
    pull(s->c, &s->tool_c, &t->carrot_c, outward(t, &s->tool_c, FAR_C), s->tension_c, 2.0 * CLOSING,
         dt);
    if (s->tension_c > CLOSING || t->since > 8.0) {
        t->closed = t->since;
        t->carrot_w = s->tool_w.tip;
    }
    return false;
}

/* About the knot, toward an angle. */
static vec go_round(double *angle, double to, double rate, double radius, double height, double dt)
{
    *angle += clamp(to - *angle, -rate * dt, rate * dt);
    return v3(radius * vbss_cos(*angle), radius * vbss_sin(*angle), height);
}

/* Both hands go back to where the throw below was pulled from, W by the near side, C by the far one, and both ends stay slack.
 * Pulled from there a turn is a hitch that runs down, and what is below is drawn tight again; pulled the flat way it is rolled open, and locked so. */
static bool are_back(throw_run *t, double dt)
{
    senses *s = t->see;
    if (!t->plan.back || t->closed > 0.0) {
        return true;
    }
    if (t->round_w == 0.0) {
        vec w = steer_jaws_of(&s->tool_w);
        double angle = vbss_atan2(w.y, w.x);
        t->round_w = angle > 0.0 ? angle - 2.0 * PI : angle;
        t->round_c = vbss_atan2(s->held_c.y, s->held_c.x);
    }
    double rate = ROUND * s->c->nature.speed;
    double of_w = SLACK_BACK * senses_length(s, s->w->node, t->tail_root);
    double of_c = SLACK_BACK * senses_length(s, t->limb_root, s->c->node);
    vec w = go_round(&t->round_w, BACK - PI, rate, of_w, BACK_W, dt);
    vec c = go_round(&t->round_c, BACK, rate, of_c, BACK_C, dt);
    hand_go(s->w, v_along(w, -GRASP_BEHIND, s->tool_w.handle), 0.08);
    hand_go(s->c, steer_tip_of(t, c), 0.15);
    bool round = t->round_c == BACK && t->round_w == BACK - PI;
    if ((round && v_distance(s->held_c, c) < BACK_NEAR) || t->since > BACK_LATEST) {
        t->closed = t->since;
        t->carrot_w = s->tool_w.tip;
        t->carrot_c = s->tool_c.tip;
    }
    return false;
}

/* So much less W pulls than C because the drain has gone its way, N. */
static double lean_to_w(const throw_run *t)
{
    const senses *s = t->see;
    vec jaws = steer_jaws_of(&s->tool_w), direction = v_unit(v3(jaws.x, jaws.y, 0.0));
    return clamp(LEAN * v_dot(senses_drain(s), direction), -LEAN_MAX, LEAN_MAX);
}

static void draw_to(hand *h, const hand_pose *p, vec *carrot, vec to, double felt, double wanted,
                    double dt)
{
    double gain = felt < EASY ? QUICK : STIFF;
    draw(h, p, carrot, to, clamp(gain * (wanted - felt), -PULLING, PULLING), dt);
}

/* From there both ends alike, and what the hands feel is not all: the thread rubs on the drain, which must not go with either. */
static void pull_back(throw_run *t, double dt)
{
    senses *s = t->see;
    const double full = t->plan.pull;
    double weaker = smaller(s->tension_w, s->tension_c);
    double unlike = smaller(UNLIKE_MIN + UNLIKE_SHARE * weaker, UNLIKE);
    double stays = (LEAN_FADED - throw_pulled_for(t)) / (LEAN_FADED - LEAN_FADES);
    double lean = lean_to_w(t) * clamp(stays, 0.0, 1.0);
    t->asked = smaller(smaller(t->asked + RISE * dt, weaker + AHEAD), full);
    double of_w = smaller(t->asked, s->tension_c + unlike - lean);
    double of_c = smaller(t->asked, s->tension_w + unlike + lean);
    vec w = outward(t, &s->tool_w, FAR_C), c = outward(t, &s->tool_c, FAR_W);
    draw_to(s->w, &s->tool_w, &t->carrot_w, w, s->tension_w, of_w, dt);
    draw_to(s->c, &s->tool_c, &t->carrot_c, c, s->tension_c, of_c, dt);
    t->clear += weaker > 0.9 * full ? dt : 0.0;
}

/* Both ends alike and downward: pulled unlike, a throw on another one locks before it is down, and the drain goes along: the slit of
 * one that has gone 9 mm with the tail gaped by a millimetre. */
static void pull_alike(throw_run *t, double dt)
{
    senses *s = t->see;
    const double full = t->plan.pull, more = t->plan.again || t->plan.down ? UNLIKE : full;
    double lean = t->plan.again ? lean_to_w(t) : 0.0;
    double wanted = smaller(full, 0.1 + RISE * (t->since - t->closed));
    double of_w = smaller(wanted, s->tension_c + more - lean);
    double of_c = smaller(wanted, s->tension_w + more + lean);
    const double share = t->plan.even ? share_of_w(t) : 1.0;
    if (t->plan.even) {
        of_w = smaller(of_w, share * wanted);
        of_c = smaller(wanted, s->tension_w / share + more + lean);
    }
    pull(s->w, &s->tool_w, &t->carrot_w, outward(t, &s->tool_w, FAR_W), s->tension_w, of_w, dt);
    pull(s->c, &s->tool_c, &t->carrot_c, outward(t, &s->tool_c, FAR_C), s->tension_c, of_c, dt);
    t->clear += s->tension_w > 0.9 * share * full && s->tension_c > 0.9 * full ? dt : 0.0;
}

/* The tail gets straight, and the limb is hitched round it. */
static void pull_tail_alone(throw_run *t, double dt)
{
    senses *s = t->see;
    const double full = t->plan.pull;
    pull(s->w, &s->tool_w, &t->carrot_w, outward(t, &s->tool_w, FAR_W), s->tension_w, full, dt);
    throw_follow(t, t->plan.light, dt);
    t->clear += s->tension_w > 0.9 * full ? dt : 0.0;
}

static void pull_limb_alone(throw_run *t, double dt)
{
    senses *s = t->see;
    pull(s->c, &s->tool_c, &t->carrot_c, outward(t, &s->tool_c, FAR_C), s->tension_c, t->plan.pull,
         dt);
    hand_yield(s->w, &s->tool_w, &t->carrot_w, steer_tail_root(t), s->tension_w, dt);
}

static void begin_square(throw_run *t);

void throw_seat(throw_run *t, double dt)
{
    hand_turn(t->see->w, OUTWARD);
    if (!is_taken_up(t, dt) || !are_back(t, dt) || !is_closed(t, dt)) {
        return;
    }
    if (t->plan.mistake == THROW_ONE_SIDED) {
        pull_tail_alone(t, dt);
    } else if (t->plan.other_end) {
        pull_limb_alone(t, dt);
    } else if (t->plan.back) {
        pull_back(t, dt);
    } else if (t->plan.alike) {
        pull_alike(t, dt);
    } else {
        pull_one_first(t, dt);
    }
    if (t->plan.again && v_length(senses_drain(t->see)) > THROW_DRAGGED) {
        t->clear = 0.0;
        throw_enter(t, THROW_PART); /* a hand has hooked something: it would tear the drain off */
    } else if (t->clear > 0.5) {
        throw_seated(t);
    } else if (throw_pulled_for(t) > 12.0) {
        throw_fail(t, "not pulled tight");
    }
}

double throw_pulled_for(const throw_run *t)
{
    return t->state == THROW_SEAT ? t->since - t->closed : 0.0;
}

/* What has run down from there the flat way locks: both hands come round again, with nothing slack meanwhile. Eased before that, or pulled
 * flat from the start, it opens. */
void throw_square(throw_run *t, double dt)
{
    senses *s = t->see;
    double rate = ROUND * s->c->nature.speed;
    hand_turn(s->w, OUTWARD);
    t->far_w += clamp(STIFF * (SQUARING - s->tension_w), -PULLING, PULLING) * dt;
    t->far_c += clamp(STIFF * (SQUARING - s->tension_c), -PULLING, PULLING) * dt;
    vec w = go_round(&t->round_w, -PI, rate, t->far_w, BACK_W, dt);
    vec c = go_round(&t->round_c, 0.0, rate, t->far_c, BACK_C, dt);
    hand_go(s->w, v_along(w, -GRASP_BEHIND, s->tool_w.handle), 0.08);
    hand_go(s->c, steer_tip_of(t, c), 0.15);
    if ((t->round_w == -PI && t->round_c == 0.0) || t->since > BACK_LATEST) {
        t->plan.back = false;
        t->carrot_w = s->tool_w.tip;
        t->carrot_c = s->tool_c.tip;
        t->clear = 0.0;
        throw_enter(t, THROW_SEAT);
        t->closed = dt;
        t->since = SQUARING / RISE; /* as if it had been pulled so far already */
    }
}

/* As far out as they were told to be, not as they are: the difference is what pulls, and without it slits spring open. */
static void begin_square(throw_run *t)
{
    const senses *s = t->see;
    vec w = v_along(t->carrot_w, GRASP_BEHIND, s->tool_w.handle);
    vec c = v_add(s->held_c, v_sub(t->carrot_c, s->tool_c.tip));
    t->far_w = v_hypotenuse(w.x, w.y);
    t->far_c = v_hypotenuse(c.x, c.y);
    throw_enter(t, THROW_SQUARE);
}

void throw_seated(throw_run *t)
{
    if (t->plan.back && t->pulls < SQUARED_NO_MORE) {
        begin_square(t);
        return;
    }
    if (t->plan.flat) {
        throw_pull_evenly(t);
        return;
    }
    t->clear = 0.0;
    throw_enter(t, t->plan.again ? THROW_PART : THROW_DONE);
}

bool throw_is_slack(const throw_run *t)
{
    return t->state == THROW_PART && t->clear >= MIN_SLACK_TIME;
}

void throw_plan_back(throw_plan *p)
{
    p->back = true;
    p->raised = p->flat = p->down = p->even = p->gives = false;
    p->pull = FULL;
}

/* From where the throw below was pulled from: the flat way what has sprung open stays so. */
void throw_pull_again(throw_run *t)
{
    t->pulls++;
    throw_plan_back(&t->plan);
    t->clear = t->asked = t->closed = t->round_w = 0.0;
    throw_enter(t, THROW_SEAT);
}

void throw_pull_evenly(throw_run *t)
{
    t->plan.back = t->plan.raised = t->plan.flat = false;
    t->plan.down = t->plan.even = t->plan.gives = true;
    t->plan.pull = FULL;
    t->closed = 0.0;
    begin_seat(t);
}

/* Toward where its thread comes out of the knot. */
static void loosen(hand *h, const hand_pose *p, vec *carrot, vec root, double dt)
{
    *carrot = v_along(*carrot, LOOSENING * dt, v_unit(v_sub(root, p->tip)));
    hand_go(h, *carrot, 0.05);
}

/* Both ease, and then give the ends some slack before any is let go: what stands at 0.02 N may spring open at none. Whoever watches may
 * want it pulled again. */
void throw_part(throw_run *t, double dt)
{
    senses *s = t->see;
    bool slack = larger(s->draws_w, s->draws_c) < SLACK_FORCE;
    bool is_slack = t->clear >= MIN_SLACK_TIME;
    t->clear += slack || t->since > EASING || is_slack ? dt : 0.0;
    if (!is_slack) {
        hand_yield(s->w, &s->tool_w, &t->carrot_w, s->x[t->tail_root], s->draws_w, dt);
        hand_yield(s->c, &s->tool_c, &t->carrot_c, s->x[t->limb_root], s->draws_c, dt);
        return;
    }
    if (t->clear < LOOSENED) {
        loosen(s->w, &s->tool_w, &t->carrot_w, s->x[t->tail_root], dt);
        loosen(s->c, &s->tool_c, &t->carrot_c, s->x[t->limb_root], dt);
    }
    if (t->clear > LEFT_ALONE) {
        throw_enter(t, THROW_DONE);
    }
}
