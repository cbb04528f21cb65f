#include "throw/states.h"

#include <string.h>

#define SLIP_INTERVAL 0.02 /* s, between two readings of it */

static const char *const names[THROW_STATES] = {
    "pick", "near",  "place", "orbit",  "check", "unwind", "tail", "close",
    "draw", "lower", "seat",  "square", "part",  "retake", "done", "failed"};

const char *throw_state_name(throw_state state)
{
    return names[state];
}

void throw_plan_usual(throw_plan *p, int wraps)
{
    *p = (throw_plan){
        .wraps = wraps,
        .wrap_tip = v3(0.014, 0.0, wraps > 1 ? 0.034 : 0.028),
        .wrap_point = v3(-1.0, 0.1, 0.0),
        .hold = wraps > 1 ? 0.072 : 0.06,
        .s0 = 0.012,
        .ds = 0.002,
        .slack = 0.96,
        .speed = 0.12,
        .tension = 0.04,
        .clearance = 0.003,
        .widest = 0.05,
        .drawn = 0.15,
        .sweep = 0.08,
        .reach = REACH,
        .min_height = -1.0,
        .pull = 2.0,
        .retries = 5,
        .light = 0.02,
        .opening = 0.6,
        .beyond = 0.6,
        .tail_node = 3,
        .behind = GRASP_BEHIND,
    };
}

/* The tail lies down along the drain, so W's jaws come to it from above. Drawn low, it leaves what is below where
 * it is. */
void throw_plan_on_top(throw_plan *p)
{
    throw_plan_usual(p, 1);
    p->wrap_tip = v3(0.010, 0.0, 0.026);
    p->slack = 0.82;
    p->behind = 0.7e-3;
    p->soft = true;
    p->drawn = 0.05;
    p->tilt = 1.2;
    p->alike = true;
    p->low = 0.03;
    p->retries = 0; /* unwinding pulls what is tied apart */
}

#define FROM_TIP 5e-3       /* of the first turn, when the next are nearer to the handle */
#define TIP_BEFORE (-12e-3) /* W then, so that the limb stands up to it on the tip's side */
#define NARROW \
    0.03 /* m: round the limb, which is below C's way then and which a wider circle hooks */
enum { TAIL_MIDDLE = 30 }; /* nodes from its end */

void throw_plan_spoil(throw_plan *p, throw_mistake mistake)
{
    p->mistake = mistake;
    p->wrong = mistake == THROW_REVERSED;
    p->unchecked = mistake != THROW_NO_MISTAKE;
    if (mistake == THROW_TO_HANDLE) {
        p->s0 = FROM_TIP;
        p->ds = -2.0 * p->ds;
        p->wrap_tip.x = TIP_BEFORE;
        p->widest = NARROW;
        p->firm = true;
    } else if (mistake == THROW_BIGHT) {
        p->tail_node = TAIL_MIDDLE;
    }
}

int throw_handedness(const throw_run *t)
{
    return t->see->w->side * mirror_sign(t->see->rig->mirrored) > 0.0 ? -1 : 1;
}

void throw_begin(throw_run *t, senses *see, const throw_plan *plan)
{
    memset(t, 0, sizeof *t);
    t->see = see;
    t->plan = *plan;
    t->give = 1.0;
    t->tail_root = see->tail_root;
    t->limb_root = see->limb_root;
    t->throws_before = see->throws;
    if (see->c->holds) {
        t->hold = senses_length(see, t->limb_root, see->c->node);
        t->state = THROW_NEAR;
    } else {
        catch_begin(&t->grip, see, see->c, t->limb_root + (uint32_t)(plan->hold / SEGMENT + 0.5),
                    1.0, 0.12);
        t->grip.state = CATCH_CLOSE;
    }
}

void throw_enter(throw_run *t, throw_state state)
{
    t->state = state;
    t->since = t->slip = t->slip_read = 0.0;
}

/* Once more, from the beginning, if it is not too late. */
void throw_fail(throw_run *t, const char *why)
{
    t->why = why;
    bool again = t->state < THROW_LOWER && t->retries < t->plan.retries;
    t->retries += again ? 1 : 0;
    t->elsewhere = 0;
    throw_enter(t, again ? THROW_UNWIND : THROW_FAILED);
}

/* Negative: the limb bends about a straight tail. */
static vbss_result read_slip(throw_run *t)
{
    senses_knot k;
    if (!t->plan.even || t->state != THROW_SEAT || t->since < t->slip_read + SLIP_INTERVAL) {
        return VBSS_OK;
    }
    TRY(senses_judge(t->see, false, &k));
    t->slip_read = t->since;
    t->slip = k.state.throw_count > t->throws_before ? k.slip : 0.0;
    return VBSS_OK;
}

vbss_result throw_step(throw_run *t, double dt)
{
    t->since += dt;
    TRY(read_slip(t));
    if (t->state != THROW_PICK && t->state < THROW_DONE && !t->see->c->holds) {
        t->why = "limb lost";
        throw_enter(t, THROW_FAILED);
    }
    switch (t->state) {
    case THROW_PICK:
        return throw_pick(t, dt);
    case THROW_NEAR:
        throw_near(t);
        break;
    case THROW_PLACE:
        throw_place(t);
        break;
    case THROW_ORBIT:
        throw_orbit(t, dt);
        break;
    case THROW_CHECK:
        throw_check(t, dt);
        break;
    case THROW_UNWIND:
        throw_unwind(t);
        break;
    case THROW_TAIL:
        throw_tail(t, dt);
        break;
    case THROW_CLOSE:
        return throw_close(t, dt);
    case THROW_DRAW:
        return throw_draw(t, dt);
    case THROW_LOWER:
        throw_lower(t, dt);
        break;
    case THROW_SEAT:
        throw_seat(t, dt);
        break;
    case THROW_SQUARE:
        throw_square(t, dt);
        break;
    case THROW_PART:
        throw_part(t, dt);
        break;
    case THROW_RETAKE:
        throw_take_again(t, dt);
        break;
    default:
        break;
    }
    return VBSS_OK;
}
