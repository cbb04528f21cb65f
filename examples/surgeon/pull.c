#include "surgeon/pull.h"

#include "surgeon/handing.h"

#define LEFT_HOLD 4.5e-3 /* from the tip: where the left hand takes the needle */
#define RIGHT_HOLD 0.64  /* of its length from there: where the right hand does */
#define CARRY 0.08       /* m/s */
#define TURNING 0.02     /* m/s, of the needle along its arc */
#define HALF_ROUND 2.5   /* rad: a drain that went along is left from then on by lifting too, */
#define MAX_TURN 4.5 /* and from here on by lifting alone: the needle's end is in the wall still */
#define MAX_LIFT 9.0 /* as if it turned on */
#define LEAVING v3(-5e-3, 0.0, 9e-3) /* so, m for each rad */
#define RISE 0.03                    /* m */
#define DRAWING 0.05                 /* m/s, of the needle away from the drain */
#define LONGEST 0.135                /* of what is drawn */
/* A tail whose end lies under the drain sticks, since what draws it presses the drain on it; the drain goes along then, and when
 * the thread comes free it runs on by as much. N; of the tail, which will do then; of the speed. */
#define STICKS 0.13
#define WILL_DO 19.7e-3
/* Jammed under the drain, a tail holds whatever is pulled at, or comes free and runs on beyond all that is left of it: then a longer
 * one will do, and the slit opens again only when much is eased. */
#define JAMS 0.3 /* N */
#define JAMMED_WILL_DO 22e-3
#define CAREFUL 0.2
#define EASING 0.01         /* m/s */
#define EASING_OFF 0.06     /* m/s, while it pulls as if it stuck */
#define NOTHING 0.05        /* N */
#define A_MOMENT 0.2        /* s */
#define MAX_EASING_TIME 3.0 /* s */
#define PATIENCE 6.0        /* s, of every state but the last, at the speed of an expert */
#define LEFT_PARK v3(-0.06, -0.05, 0.06)
#define RIGHT_PARK v3(0.05, -0.06, 0.05)

const char *pull_name(pull_state state)
{
    static const char *const names[] = {"reach", "onto",  "close", "part",   "turn",
                                        "lift",  "offer", "ask",   "accept", "take",
                                        "give",  "draw",  "ease",  "drawn",  "failed"};
    return names[state];
}

void pull_begin(pull_run *p, stitch *t)
{
    memset(p, 0, sizeof *p);
    p->stitch = t;
    p->tail = -1.0;
}

static void enter(pull_run *p, pull_state state)
{
    p->state = state;
    p->since = 0.0;
    p->from = site_needle(&p->stitch->site);
}

static void fail(pull_run *p, const char *why)
{
    p->why = why;
    enter(p, PULL_FAILED);
}

/* ---- one hand takes the needle from the other */

/* Open jaws to before the needle, on it, closed; true: it is held. */
static bool take(pull_run *p, hand *h, double arc_length, pull_state first)
{
    const site *s = &p->stitch->site;
    int part = (int)p->state - (int)first;
    handing_result handed = handing_take(s, h, arc_length, (handing_part)part, p->since);
    if (handed == HANDING_NEXT) {
        enter(p, (pull_state)(p->state + 1));
    } else if (handed == HANDING_HELD) {
        p->held = handing_held(s, h);
    }
    return handed == HANDING_HELD;
}

/* ---- the needle's way */

static bool is_through(const pull_run *p)
{
    const stitch *t = p->stitch;
    vbss_scene_hole hole;
    for (int side = 0; side < 2; side++) {
        if (!site_find_hole(&t->site, t->holes[side], &hole) || hole.needle != 0) {
            return false;
        }
    }
    return true;
}

static void turn(pull_run *p, double dt)
{
    stitch *t = p->stitch;
    p->turned += TURNING * t->left.nature.speed / t->site.radius * dt;
    pose needle = pose_turned(&p->from, v3(0.0, 0.0, 1.0), smaller(p->turned, MAX_TURN));
    needle.at = v_along(needle.at, larger(p->turned - HALF_ROUND, 0.0), LEAVING);
    hold_steer(&t->left, &p->held, &needle, CARRY);
    if (is_through(p)) {
        enter(p, PULL_LIFT);
    } else if (p->turned > MAX_LIFT) {
        fail(p, "the needle is not through");
    }
}

static void lift(pull_run *p)
{
    stitch *t = p->stitch;
    pose needle = p->from;
    needle.at.z += RISE;
    hold_steer(&t->left, &p->held, &needle, DRAWING);
    if (hold_off(&t->site, &needle) < 3e-3) {
        enter(p, PULL_OFFER);
    }
}

/* Open above, the tip at the left, the thread at the right. */
static pose offered(void)
{
    return pose_of(v3(-0.02, -0.01, 0.055), v3(-1.0, 0.0, 0.0), v3(0.0, 0.0, 1.0),
                   v3(0.0, 1.0, 0.0));
}

static void offer(pull_run *p)
{
    stitch *t = p->stitch;
    pose needle = offered();
    hold_steer(&t->left, &p->held, &needle, DRAWING);
    if (hold_off(&t->site, &needle) < 2e-3) {
        enter(p, PULL_ASK);
    }
}

static vec away_from_drain(void)
{
    return v_unit(v3(0.25, -0.2, 1.0));
}

static void draw(pull_run *p, double dt)
{
    stitch *t = p->stitch;
    vec mark = site_mark(&t->site, SITE_LEFT);
    double slow = clamp((p->tail - PULL_TAIL) / 10e-3, 0.1, 1.0);
    double felt = v_length(t->right.felt);
    bool sticks = felt > STICKS;
    p->jammed = felt > JAMS && p->tail >= WILL_DO && p->tail < JAMMED_WILL_DO;
    slow = sticks ? smaller(slow, CAREFUL) : slow;
    if (p->drawn == 0.0) {
        p->drawn = v_distance(p->from.at, mark);
    }
    p->drawn = smaller(p->drawn + slow * DRAWING * t->right.nature.speed * dt, LONGEST);
    pose needle = offered();
    vec to = v_along(mark, p->drawn, away_from_drain());
    needle.at = v_add(p->from.at, v_limit(v_sub(to, p->from.at), 1.0));
    hold_steer(&t->right, &p->held, &needle, CARRY);
    if (p->tail < PULL_TAIL || (sticks && p->tail < WILL_DO) || p->jammed) {
        enter(p, PULL_EASE);
    }
}

static void ease(pull_run *p, double dt)
{
    hand *right = &p->stitch->right;
    double felt = v_length(right->felt);
    bool slack = felt < NOTHING;
    p->slack = slack ? p->slack + dt : 0.0;
    p->retraction += slack && !p->jammed ? 0.0 : (felt > STICKS ? EASING_OFF : EASING) * dt;
    pose needle = p->from;
    needle.at = v_along(needle.at, -p->retraction, away_from_drain());
    hold_steer(right, &p->held, &needle, CARRY);
    if ((p->slack > A_MOMENT && !p->jammed) || p->since > MAX_EASING_TIME) {
        enter(p, PULL_DONE);
    }
}

/* ---- all of it */

double pull_tail(const stitch *t)
{
    vbss_scene_hole hole;
    bool is_thread = site_find_hole(&t->site, t->holes[SITE_RIGHT], &hole) && hole.thread != 0;
    return is_thread ? SEGMENT * (t->site.rig.nodes - 1) - hole.arc_length : -1.0;
}

void pull_step(pull_run *p, double dt)
{
    stitch *t = p->stitch;
    double length = t->site.arc * t->site.radius;
    p->since += dt;
    p->tail = pull_tail(t);
    if (p->state > PULL_CLOSE && p->state < PULL_DONE) {
        hand *bearer = p->state > PULL_TAKE ? &t->right : &t->left;
        hold_see(&p->held, bearer, &t->site, dt);
        if (!bearer->holds) {
            fail(p, "the needle is lost");
        }
    }
    switch (p->state) {
    case PULL_REACH:
    case PULL_ONTO:
    case PULL_CLOSE:
        if (take(p, &t->left, LEFT_HOLD, PULL_REACH)) {
            enter(p, PULL_PART);
        }
        break;
    case PULL_PART:
        if (handing_leave(&t->right, p->since, &p->back, RIGHT_PARK)) {
            enter(p, PULL_TURN);
        }
        break;
    case PULL_TURN:
        turn(p, dt);
        break;
    case PULL_LIFT:
        lift(p);
        break;
    case PULL_OFFER:
        offer(p);
        break;
    case PULL_ASK:
    case PULL_ACCEPT:
    case PULL_TAKE:
        if (take(p, &t->right, RIGHT_HOLD * length, PULL_ASK)) {
            enter(p, PULL_GIVE);
        }
        break;
    case PULL_GIVE:
        if (handing_leave(&t->left, p->since, &p->back, LEFT_PARK)) {
            enter(p, PULL_DRAW);
        }
        break;
    case PULL_DRAW:
        draw(p, dt);
        break;
    case PULL_EASE:
        ease(p, dt);
        break;
    default:
        break;
    }
    if (p->since * t->left.nature.speed > PATIENCE && p->state < PULL_DRAW) {
        fail(p, pull_name(p->state));
    }
}
