#include "surgeon/surgeon.h"

#include <string.h>

#define SLACK 15e-3 /* m, by which the needle comes nearer to the drain */
/* Where the tail is taken: in its middle, but so far from the hole, m, that the jaws stay clear of the drain. Missed, it is taken so much farther out, but that far
 * from its end. */
#define FROM_HOLE 4.5e-3
#define FARTHER 1.5e-3
#define FROM_END 2.5e-3
#define OPENING 0.6   /* of the handle */
#define COMING 0.06   /* m/s */
#define GIVING 0.05   /* m/s, of the needle */
#define DRAWING 0.012 /* m/s, of the jaws with the tail */
#define EASING 0.01   /* m/s, back toward the hole */
#define UP 0.7 /* height for a length of 1 along the tail, of the direction in which it is drawn */
#define TOO_HARD 1.5   /* N */
#define NOTHING 0.03   /* N */
#define OFF 20e-3      /* m, upward, of jaws that have let go, before they go aside */
#define RISING 0.8     /* s: until then */
#define RETURNING 0.12 /* m/s */
#define ASIDE v3(-0.042, -0.046, 0.048)
#define NEAR_ENOUGH 4e-3
#define PATIENCE 12.0 /* s, of every state */

const char *lengthen_name(lengthen_state state)
{
    static const char *const names[] = {"not",  "slack", "take the tail", "lengthen",
                                        "ease", "leave", "lengthened",    "failed"};
    return names[state];
}

static void enter(lengthen_run *l, lengthen_state state)
{
    l->state = state;
    l->since = 0.0;
}

/* On the near side, from where its way to the tail and back is clear of the limb. */
static bool is_aside(const lengthen_run *l)
{
    return v_distance(l->see->tool_w.tip, ASIDE) < NEAR_ENOUGH;
}

static uint32_t place(const lengthen_run *l)
{
    const double tail = SEGMENT * l->see->tail_root;
    const double middle = larger(FROM_HOLE, 0.5 * tail) + FARTHER * l->grip.tries;
    const double from_end = larger(tail - middle, smaller(FROM_END, tail - FROM_HOLE));
    return (uint32_t)(larger(from_end, 0.0) / SEGMENT);
}

void lengthen_begin(lengthen_run *l, pull_run *pull, senses *see)
{
    hand *w = see->w;
    memset(l, 0, sizeof *l);
    l->pull = pull;
    l->see = see;
    l->needle = site_needle(&pull->stitch->site);
    vec mark = site_mark(&pull->stitch->site, SITE_LEFT);
    l->needle.at = v_along(l->needle.at, SLACK, v_unit(v_sub(mark, l->needle.at)));
    hand_through(w, seen(w, SURGEON_STEEP));
    enter(l, LENGTHEN_SLACK);
}

static void take(lengthen_run *l, double dt)
{
    const senses *s = l->see;
    if (l->grip.state == CATCH_COME) {
        l->grip.node = place(l);
        hand_turn(s->w, catch_point(s, s->w, l->grip.node));
    }
    catch_step(&l->grip, dt);
    if (l->grip.state == CATCH_MISSED) {
        enter(l, LENGTHEN_FAILED);
    } else if (l->grip.state == CATCH_HELD) {
        vec along = v_unit(v_sub(s->x[place(l)], s->x[s->tail_root]));
        l->carrot = s->tool_w.tip;
        l->away = v_unit(v_along(along, UP, v3(0.0, 0.0, 1.0)));
        enter(l, LENGTHEN_DRAW);
    }
}

static void draw(lengthen_run *l, double dt)
{
    hand *w = l->see->w;
    const bool hard = v_length(w->felt) > TOO_HARD;
    l->carrot = v_along(l->carrot, hard ? 0.0 : DRAWING * dt, l->away);
    hand_go(w, l->carrot, COMING);
    if (l->pull->tail > PULL_TAIL) {
        enter(l, LENGTHEN_EASE);
    } else if (!senses_holds(l->see, w)) {
        enter(l, LENGTHEN_FAILED);
    }
}

static void ease(lengthen_run *l, double dt)
{
    hand *w = l->see->w;
    if (v_length(w->felt) > NOTHING) {
        l->carrot = v_along(l->carrot, -EASING * dt, l->away);
    }
    hand_go(w, l->carrot, COMING);
    if (l->since > 1.0) {
        enter(l, LENGTHEN_LEAVE);
    }
}

static void leave(lengthen_run *l)
{
    hand *w = l->see->w;
    hand_open(w, OPENING);
    if (l->since > RISING) {
        hand_go(w, ASIDE, RETURNING);
    } else if (l->since > 0.3) {
        hand_go(w, v_along(l->carrot, OFF, v3(0.0, 0.0, 1.0)), COMING);
    }
    if (l->since > RISING && is_aside(l)) {
        enter(l, LENGTHEN_DONE);
    }
}

void lengthen_step(lengthen_run *l, double dt)
{
    const site *at = &l->pull->stitch->site;
    l->since += dt;
    l->pull->tail = pull_tail(l->pull->stitch);
    hold_steer(l->see->c, &l->pull->held, &l->needle, GIVING);
    switch (l->state) {
    case LENGTHEN_SLACK:
        hand_go(l->see->w, ASIDE, RETURNING);
        if ((hold_off(at, &l->needle) < 3e-3 || l->since > 2.0) && is_aside(l)) {
            catch_begin(&l->grip, l->see, l->see->w, place(l), OPENING, COMING);
            l->grip.minds = SURGEON_MINDS;
            enter(l, LENGTHEN_TAKE);
        }
        break;
    case LENGTHEN_TAKE:
        take(l, dt);
        break;
    case LENGTHEN_DRAW:
        draw(l, dt);
        break;
    case LENGTHEN_EASE:
        ease(l, dt);
        break;
    case LENGTHEN_LEAVE:
        leave(l);
        break;
    default:
        break;
    }
    if (l->since > PATIENCE) {
        enter(l, LENGTHEN_FAILED);
    }
}
