#include "throw/steer.h"

#define TAUT 0.01    /* N: the limb, when nothing may be */
#define NECK 1.3e-3  /* radius of what it is wound about */
#define NEAREST 6e-3 /* of C's jaws to the turns */

/* ---- geometry about W */

steer_frame steer_about_w(const throw_run *t, double s)
{
    steer_frame f;
    const hand_pose *w = &t->see->tool_w;
    f.u = w->handle;
    f.origin = v_along(w->tip, s, f.u);
    f.over = v_unit(v_across(v3(0.0, 0.0, 1.0), f.u));
    f.away = v_cross(f.u, f.over);
    return f;
}

vec steer_on_orbit(const steer_frame *f, double phi, double rho)
{
    return v_along(v_along(f->origin, rho * vbss_cos(phi), f->over), rho * vbss_sin(phi), f->away);
}

vec steer_limb_root(const throw_run *t)
{
    return t->see->x[t->limb_root];
}

vec steer_tail_root(const throw_run *t)
{
    return t->see->x[t->tail_root];
}

/* Where C's tip is when its jaws are at a place. */
vec steer_tip_of(const throw_run *t, vec jaws)
{
    return v_along(jaws, -1.0, v_sub(t->see->held_c, t->see->tool_c.tip));
}

vec steer_jaws_of(const hand_pose *p)
{
    return v_along(p->tip, GRASP_BEHIND, p->handle);
}

/* Of the limb beyond W, if it were taut. */
static double taut_length(const throw_run *t)
{
    steer_frame f = steer_about_w(t, t->plan.s0);
    double wound = larger(fabs(t->phi - t->begin) - PI, 0.0) * NECK;
    return t->hold - v_distance(steer_limb_root(t), f.origin) - wound;
}

/* Of the limb between W and C. */
static double steer_free_length(const throw_run *t)
{
    const senses *s = t->see;
    if (s->last == 0) {
        steer_frame f = steer_about_w(t, t->plan.s0);
        return t->hold - v_distance(steer_limb_root(t), f.origin);
    }
    double length = senses_length(s, s->last, s->c->node);
    /* Turns that come off jam on the way: the limb between them and C looks shorter than it is. */
    return t->plan.firm || t->unwinds ? larger(length, taut_length(t)) : length;
}

/* ---- C keeps the limb taut at its angle */

static double turn_height(const throw_run *t)
{
    double turns = fabs(t->phi - t->begin) / (2.0 * PI);
    return t->plan.s0 - t->plan.ds * turns;
}

void steer_keep_taut(throw_run *t, double speed, double dt)
{
    const senses *s = t->see;
    double wanted = t->plan.slack * t->give * steer_free_length(t);
    steer_frame f = steer_about_w(t, turn_height(t));
    if (s->tension_c > t->plan.tension) {
        t->give = larger(0.3, t->give - 1.0 * dt);
    } else {
        t->give = smaller(1.0, t->give + 0.2 * dt);
    }
    t->rho += clamp(wanted - t->rho, -0.1 * dt, 0.1 * dt);
    t->rho = clamp(t->rho, 0.006, t->plan.widest);
    vec jaws = steer_on_orbit(&f, t->phi, t->rho);
    jaws.z = larger(jaws.z, t->plan.clearance);
    hand_go(s->c, steer_tip_of(t, jaws), speed);
}

/* C goes with W as if both were one, and nearer to the turns as soon as the limb is taut. */
static void accompany(throw_run *t, double dt)
{
    const senses *s = t->see;
    vec turns = v_along(s->tool_w.tip, t->plan.s0, s->tool_w.handle);
    if (v_dot(t->beside, t->beside) == 0.0) {
        t->beside = v_sub(s->tool_c.tip, turns);
    }
    vec to = v_sub(s->last > 0 ? s->x[s->last] : turns, s->held_c);
    double excess = s->tension_c / TAUT - 1.0;
    if (excess > 0.0 && v_length(to) > NEAREST) {
        t->beside = v_along(t->beside, smaller(0.1, 0.02 * excess) * dt, v_unit(to));
    }
    hand_go(s->c, v_add(turns, t->beside), 0.2);
}

void steer_keep(throw_run *t, double dt)
{
    if (t->plan.soft) {
        accompany(t, dt);
    } else {
        steer_keep_taut(t, 0.15, dt);
    }
}

/* C gives way as soon as the limb is taut. */
void steer_yield(throw_run *t)
{
    const senses *s = t->see;
    bool taut = s->tension_c > t->plan.tension;
    vec direction = v_unit(v_sub(s->tool_w.tip, s->tool_c.tip));
    hand_go(s->c, taut ? v_along(s->tool_c.tip, 5e-3, direction) : s->tool_c.tip, 0.1);
}
