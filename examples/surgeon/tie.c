#include "surgeon/surgeon.h"
#include "throw/steer.h"

/* Where a line through the shaft of W goes, which is the left tool in the first throw: level while it is wound about and draws, steep when it takes the tail,
 * which lies on the drain and beyond. */
#define LEVEL v3(-0.3, 0.03, 0.07)
/* Of W when it takes the tail of a tied throw, which hangs down to the right: its jaws are across that, not along it. */
#define OVER_TAIL v3(0.03, -0.12, 0.22)
#define NEAR_SIDE \
    v3(-0.05, -0.2, 0.15) /* so that the shaft is not over the knot when its tip is beyond it */
#define SWAY 0.2          /* m/s, from one to the other */
#define OTHER v3(0.3, -0.05, 0.1)
#define WRAP_TIP v3(0.014, 0.0, 0.07)
#define WINDING \
    0.03 /* N, that the right hand gives way to while it winds: more draws the tail in */
#define DRAWN_IN 9e-3 /* m of tail, that can be taken again */
/* Length of a tail, m, below which the limb is wound more loosely, and at which it is loosest; radius of the orbit over the free length there. Chosen:
 * tails of 4 mm have been enough, others have slipped out. */
#define ROOMY 14e-3
#define NEARLY_OUT 6e-3
#define LOOSE 0.85
#define LOW 0.012    /* m below the drain's top, to where both hands pull: just above the floor */
#define ENOUGH 1.0   /* N, of both hands, if the slit is shut */
#define SHUT 0.45e-3 /* m, between the edges' middles: closer than lips that meet */
/* Pulled from where the first was: open no wider than that between the lips, both hands pull so much; or less, if the drain goes with one of
 * them. */
#define SHUT_AGAIN 0.3e-3
#define ENOUGH_AGAIN 1.6
#define LESS_AGAIN 0.8
#define LONGER 1.5 /* s: so long then */
/* Eased, it is pulled again if it has sprung open wider than that, and so often. */
#define SPRUNG 0.4e-3
#define AGAIN 4
#define SPRUNG_THIRD 0.46e-3 /* that one comes to rest no tighter for it */
/* A throw over a wider slit is pulled from behind. Pulled flat it locks, and the slit stays open. */
#define OPEN 0.4e-3
#define HARD 2.0 /* N, of a throw that is closed evenly over a wider one: it makes no half hitch */
/* The last throw, if it was never shut under so much pull, N, or gapes that wide, m, since, is not seated, whatever it does eased. */
#define SEATED 0.5
#define GAPES 1e-3
/* Not tight in time it is done all the same if both ends bear so much, N, or the slit is nearly shut: harder pulled, its lips slip past each
 * other. */
#define LATE 11.0 /* s */
#define AT_ALL 0.3
#define INWARD 0.3   /* of ahead: the thread on the orbit */
#define A_MOMENT 0.3 /* s */

enum { CHECKED = 100 }; /* steps, between two counts of the throws */

/* Where the thread goes through the drain, as places along it from the tail's end. */
static void find_marks(surgeon *s)
{
    throw_rig *st = &s->stitch.site.rig;
    for (int side = 0; side < 2; side++) {
        vbss_scene_hole hole;
        if (site_find_hole(&s->stitch.site, s->stitch.holes[side], &hole) && hole.thread != 0) {
            st->marks[side == SITE_RIGHT ? 0 : 1] =
                (uint32_t)(throw_rig_place(st, hole.arc_length) + 0.5);
        }
    }
}

/* Both point at each other. */
void surgeon_hold_level(surgeon *s)
{
    hand *w = s->see.w, *c = s->see.c;
    hand_through(w, seen(w, LEVEL));
    hand_through(c, seen(c, OTHER));
}

void surgeon_plan_tie(throw_plan *plan)
{
    throw_plan_usual(plan, 2);
    plan->wrap_tip = WRAP_TIP;
    plan->tension = WINDING;
    plan->alike = true; /* unequal pulls drag the drain along */
    plan->low = LOW;
    plan->still = true;
    plan->minds = SURGEON_MINDS;
}

static void find_roots(surgeon *s)
{
    find_marks(s);
    s->see.tail_root = s->stitch.site.rig.marks[0];
    s->see.limb_root = s->stitch.site.rig.marks[1];
}

vbss_result surgeon_see(surgeon *s)
{
    stitch *t = &s->stitch;
    if (s->see.rig == NULL) {
        find_marks(s);
        TRY(senses_create(&s->see, &t->site.rig, &t->left, &t->right));
    }
    find_roots(s);
    return senses_observe(&s->see);
}

vbss_result surgeon_begin_tie(surgeon *s)
{
    throw_plan plan;
    TRY(surgeon_see(s));
    surgeon_plan_tie(&plan);
    surgeon_spoil(s, &plan);
    surgeon_hold_level(s);
    s->slack = plan.slack;
    throw_begin(&s->tie, &s->see, &plan);
    return VBSS_OK;
}

static void sway(surgeon *s, double dt)
{
    hand *h = s->see.w;
    bool steep =
        s->tie.state == THROW_TAIL || s->tie.state == THROW_CLOSE || s->tie.state == THROW_RETAKE;
    bool back = s->tie.plan.back && s->tie.state >= THROW_LOWER;
    vec down = s->stage == SURGEON_TIE || s->tie.plan.wrong ? SURGEON_STEEP : OVER_TAIL;
    vec lag = v_sub(seen(h, steep ? down : back ? NEAR_SIDE : LEVEL), h->trocar);
    hand_through(h, v_add(h->trocar, v_limit(lag, SWAY * h->nature.speed * dt)));
}

/* Tool C rolls about its handle until `from`, a direction at its tip, points along `direction`. */
static void roll(surgeon *s, vec from, vec direction)
{
    const senses *e = &s->see;
    vec axis = e->tool_c.handle, now = v_unit(v_across(from, axis));
    vec wanted = v_unit(v_across(direction, axis)), is = seen(e->c, e->c->roll);
    hand_turn(e->c, v_along(v_scale(v_dot(is, now), wanted), v_dot(is, v_cross(axis, now)),
                            v_cross(axis, wanted)));
}

/* The needle's end with the thread goes ahead on the orbit, or the limb would be wound about C's jaws as well. */
static void lead_thread(surgeon *s)
{
    const senses *e = &s->see;
    vec to = v_sub(s->tie.plan.wrap_tip, e->held_c);
    vec inward = v_unit(v_across(to, e->tool_c.handle));
    vec ahead = v_scale(s->tie.plan.wrong ? -1.0 : 1.0, v3(0.0, -inward.z, inward.y));
    roll(s, v_sub(e->held_c, e->tool_c.tip), v_along(ahead, INWARD, inward));
    if (s->tie.state == THROW_PLACE) { /* the limb stays below W, however the needle turns */
        vec below = v3(0.004, -0.024, s->tie.plan.wrap_tip.z - 0.01);
        hand_go(e->c, steer_tip_of(&s->tie, below), 0.12);
    }
}

/* The first time the double is wound the needle still hangs as the jaws took it. */
static bool is_led(const surgeon *s)
{
    const throw_run *t = &s->tie;
    const bool is_retry = t->retries > 0 || s->lengthen.state != LENGTHEN_NOT;
    return t->state <= THROW_CHECK && !t->unwinds && (s->stage != SURGEON_TIE || is_retry);
}

/* Above its jaws, so that they can go low. */
static void raise_needle(surgeon *s)
{
    const senses *e = &s->see;
    vec middle = seen(e->c, site_needle(&s->stitch.site).at);
    roll(s, v_sub(middle, e->tool_c.tip), v3(0.0, 0.0, 1.0));
}

vbss_result surgeon_observe(surgeon *s)
{
    find_marks(s);
    TRY(senses_observe(&s->see));
    return s->steps % 10 == 0 ? senses_wind(&s->see) : VBSS_OK;
}

static double since_when(bool is, double time, double dt)
{
    return is ? time + dt : 0.0;
}

/* As the hands begin to close the turn: a slit that is open then stays open if they pull flat, but for a third throw with both ends bent. */
static void choose_direction(surgeon *s)
{
    throw_plan *p = &s->tie.plan;
    if (!p->again || s->tie.state != THROW_LOWER || s->gap <= OPEN) {
        return;
    }
    if (p->even) {
        p->pull = HARD;
    } else {
        throw_plan_back(p);
    }
}

/* A throw that is drawn down along a straight tail is a half hitch, so W gives. It does so only while the slit is shut, because slack can open the throw
 * below. */
static void choose_giving(surgeon *s)
{
    throw_plan *p = &s->tie.plan;
    if (s->stage == SURGEON_THIRD && p->even) {
        p->gives = s->gap < SHUT_AGAIN;
    }
}

static void watch_seat(surgeon *s, double weaker, double dt)
{
    bool met = s->tie.state == THROW_SEAT && s->gap < SPRUNG_THIRD && weaker > SEATED;
    s->met = since_when(met, s->met, dt);
    s->seated = s->stage < SURGEON_THIRD || (s->gap < GAPES && (s->seated || s->met > A_MOMENT));
}

/* Pulled on when the slit is shut, its lips might slip past each other. */
static void watch_slit(surgeon *s, double dt)
{
    throw_run *t = &s->tie;
    bool first = !t->plan.again, back = !first && t->plan.back;
    double weaker = smaller(s->see.tension_w, s->see.tension_c);
    bool met = t->state == THROW_SEAT && (first ? s->edges < SHUT : s->gap < SHUT_AGAIN);
    bool hard = weaker > (first ? ENOUGH : ENOUGH_AGAIN);
    double sprung = s->stage == SURGEON_THIRD ? SPRUNG_THIRD : SPRUNG;
    watch_seat(s, weaker, dt);
    s->shut = since_when(met && (first || back) && hard, s->shut, dt);
    bool at_rest = back ? weaker > LESS_AGAIN : !first && weaker > ENOUGH_AGAIN;
    s->at_rest = since_when(met && at_rest, s->at_rest, dt);
    bool late = !first && t->closed > 0.0 && throw_pulled_for(t) > LATE &&
                (weaker > AT_ALL || s->gap < SPRUNG);
    if (s->shut > A_MOMENT || s->at_rest > LONGER || late) {
        throw_seated(t);
        s->shut = s->at_rest = 0.0;
    } else if (t->pulls < AGAIN && throw_is_slack(t) && (s->gap > sprung || !s->seated)) {
        throw_pull_again(t);
    }
}

/* A throw below may come undone while the limb is wound. The next would be tied on nothing. */
static vbss_result watch_below(surgeon *s)
{
    const throw_run *t = &s->tie;
    const bool winds = t->state >= THROW_PLACE && t->state <= THROW_CLOSE;
    bool is_undone = false;
    if (s->stage == SURGEON_TIE || !winds || t->state == THROW_UNWIND || s->steps % CHECKED != 0) {
        return VBSS_OK;
    }
    TRY(surgeon_read_throws(s, &is_undone));
    s->undone = since_when(is_undone, s->undone, 1e-3 * CHECKED);
    if (s->undone > A_MOMENT) {
        s->undone = 0.0;
        throw_leave(&s->tie);
    }
    return VBSS_OK;
}

/* C draws the thread through the drain as it winds. The shorter the tail, the more loosely the limb is wound. */
static void choose_slack(surgeon *s)
{
    if (s->stage == SURGEON_TIE && !s->tie.unwinds) {
        const double more = pull_tail(&s->stitch) - NEARLY_OUT;
        const double share = clamp(more / (ROOMY - NEARLY_OUT), 0.0, 1.0);
        s->tie.plan.slack = LOOSE + (s->slack - LOOSE) * share;
    }
}

/* A coach asks for a short tail to be drawn out again. Without one the hands wind on: a tail of 4 mm has been enough. */
static void watch_tail(surgeon *s)
{
    const bool winds = s->tie.state == THROW_ORBIT && s->stage == SURGEON_TIE;
    if (s->mends && winds && !s->tie.unwinds && pull_tail(&s->stitch) < DRAWN_IN) {
        throw_fail(&s->tie, "tail drawn in");
    }
}

vbss_result surgeon_tie(surgeon *s, double dt)
{
    sway(s, dt);
    choose_slack(s);
    watch_tail(s);
    if (s->stage == SURGEON_TIE) { /* both come out of the drain */
        find_roots(s);
        s->tie.tail_root = s->see.tail_root;
        s->tie.limb_root = s->see.limb_root;
    }
    TRY(surgeon_observe(s));
    TRY(watch_below(s));
    choose_giving(s);
    TRY(throw_step(&s->tie, dt));
    if (is_led(s)) {
        lead_thread(s);
    } else if (s->tie.state >= THROW_DRAW) {
        raise_needle(s);
    }
    choose_direction(s);
    watch_slit(s, dt);
    return VBSS_OK;
}
