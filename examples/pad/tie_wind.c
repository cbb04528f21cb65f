/* The limb goes round the jaws of one tool, which then take the tail. */
#include <math.h>

#include "base/elementary.h"
#include "base/error.h"
#include "tie.h"

#define PI 3.14159265358979324

static const double behind = 2e-3, shallow = 0.7e-3 /* m, of the thread in jaws from their tip */,
                    first_turn = 11e-3, per_turn = 2e-3 /* m, of turns from the tip */,
                    neck = 1.3e-3 /* m, radius of the jaws with thread about them */,
                    held = 66e-3 /* m, of the limb to where it is taken */,
                    beyond = 0.6 /* rad, that the limb is wound more than it need be */,
                    taut = 0.04 /* N */, backing = 30e-3 /* m, of jaws out of turns */;
enum { FROM_END = 4 /* nodes, of the tail to where it is taken */, TRIES = 4, RETRIES = 2 };

static double wraps(const pad_tie *t)
{
    return t->throws == 0 ? 2.0 : 1.0;
}

/* ---- directions */

/* The tool that is wound about comes from the limb's side, the other from the tail's, both from the near side and from above. */
static vec3 handle_of_w(const pad_tie *t)
{
    return vec3_make(t->side, 0.25, 0.3);
}

static vec3 handle_of_c(const pad_tie *t)
{
    return vec3_make(-t->side, 0.4, 0.3);
}

static vec3 place_of_w(const pad_tie *t)
{
    const vec3 over = vec3_make(-12e-3 * t->side, t->throws == 0 ? 34e-3 : 28e-3, 0.0);
    return vec3_add(vec3_add(t->stitch, over), t->off);
}

/* Where its tip is if its jaws hold at a place. */
static vec3 tip_for(const tie_hand *h, vec3 jaws)
{
    return vec3_add(jaws, vec3_sub(h->tip, h->jaws));
}

/* ---- about the jaws */

typedef struct ring {
    vec3 centre, up, far;
} ring;

static ring ring_at(const pad_tie *t, double from_tip)
{
    const vec3 u = t->w.handle, centre = vec3_add_scaled(t->w.tip, from_tip, u);
    const vec3 y = vec3_make(0.0, 1.0, 0.0),
               up = vec3_unit_or(vec3_add_scaled(y, -vec3_dot(y, u), u), y);
    return (ring){centre, up, vec3_scale(vec3_cross(u, up), -t->side)};
}

static double angle_on(const ring *r, vec3 x)
{
    const vec3 to = vec3_sub(x, r->centre);
    return vbss_arc_tangent(vec3_dot(to, r->far), vec3_dot(to, r->up));
}

/* ---- the limb is taken */

void tie_take(pad_tie *t)
{
    const tie_thread *s = &t->thread;
    tie_hand *c = &t->c;
    const uint32_t node = s->limb_root - (uint32_t)(held / s->segment + 0.5);
    const vec3 along = vec3_unit_or(vec3_sub(s->x[node - 3], s->x[node + 3]), vec3_zero());
    const vec3 handle = vec3_unit_or(vec3_make(-0.8, 0.2, 0.6), vec3_zero());
    const vec3 across = vec3_cross(along, handle);
    const vec3 tip = vec3_add_scaled(s->x[node], -behind, handle);
    tie_turn(c, handle, across);
    c->opening = 1.0;
    if (t->since < 0.8) {
        tie_go(c, vec3_add_scaled(tip, 20e-3, handle), 0.15);
    } else if (t->since < 1.4) {
        tie_go(c, tip, 0.06);
    } else {
        c->opening = 0.0;
    }
    if (t->since > 1.8) {
        if (c->holds) {
            tie_enter(t, TIE_PLACE);
        } else {
            tie_fail(t, "the limb is not caught");
        }
    }
}

/* ---- winding */

void tie_place(pad_tie *t)
{
    const vec3 w = place_of_w(t);
    const vec3 jaws = vec3_make(-4e-3 * t->side, w.y - 10e-3, t->stitch.z + 24e-3);
    tie_turn(&t->c, handle_of_c(t), t->c.across);
    tie_go(&t->c, tip_for(&t->c, jaws), 0.12);
    tie_turn(&t->w, handle_of_w(t), vec3_make(0.0, 0.0, 1.0));
    t->w.opening = 0.0;
    /* first away, then over the far side, so that it does not meet the limb */
    const vec3 aside = vec3_make(w.x + 30e-3 * t->side, w.y + 30e-3, t->stitch.z - 30e-3);
    tie_go(&t->w, t->since < 0.9 ? aside : w, 0.15);
    if (t->since > 1.2 && vec3_distance(t->w.tip, w) < 1.5e-3 &&
        vec3_distance(t->c.jaws, jaws) < 3e-3) {
        const ring r = ring_at(t, first_turn);
        const double root = angle_on(&r, t->thread.x[t->thread.limb_root]);
        t->begun = root > 0.0 ? root - 2.0 * PI : root;
        t->turned = angle_on(&r, t->c.jaws);
        tie_enter(t, TIE_WIND);
    } else if (t->since > 4.0) {
        tie_fail(t, "the hands are not in place");
    }
}

static double free_length(const pad_tie *t, const ring *r)
{
    const tie_thread *s = &t->thread;
    const double wound = neck * fmax(t->turned - t->begun - PI, 0.0);
    return tie_length(s, t->c.node, s->limb_root) - vec3_distance(s->x[s->limb_root], r->centre) -
           wound;
}

vbss_result tie_wind(pad_tie *t, double dt)
{
    const double end = t->begun + 2.0 * PI * (wraps(t) + 0.5) + beyond;
    const ring r = ring_at(t, first_turn - per_turn * (t->turned - t->begun) / (2.0 * PI));
    const double radius = fmin(fmax(t->slack * free_length(t, &r), 6e-3), 40e-3);
    const double rate = t->c.tension > taut ? 0.0 : fmin(0.15 / radius, 8.0);
    t->slack += (t->c.tension > taut ? -0.5 : 0.1) * dt;
    t->slack = fmin(fmax(t->slack, 0.4), 0.96);
    t->turned += fmin(rate * dt, end - t->turned);
    vec3 jaws = vec3_add_scaled(r.centre, radius * vbss_cosine(t->turned), r.up);
    jaws = vec3_add_scaled(jaws, radius * vbss_sine(t->turned), r.far);
    jaws.y = fmax(jaws.y, 14e-3);
    tie_go(&t->c, tip_for(&t->c, jaws), 0.3);
    if (end - t->turned > 1e-9) {
        if (t->since > 8.0) {
            tie_retry(t, "winding takes too long");
        }
        return VBSS_OK;
    }
    double turns;
    VBSS_TRY(tie_count_turns(t, &turns));
    t->turns = turns;
    t->tries = 0;
    t->beside = vec3_sub(t->c.tip, r.centre);
    if (fabs(turns) > wraps(t) - 0.5) {
        tie_enter(t, TIE_REACH);
    } else {
        tie_retry(t, "the turns have come off");
    }
    return VBSS_OK;
}

void tie_retry(pad_tie *t, const char *why)
{
    if (t->retries == RETRIES) {
        tie_fail(t, why);
        return;
    }
    t->retries++;
    t->lead_w = vec3_add_scaled(t->w.tip, backing, t->w.handle);
    tie_enter(t, TIE_BACK);
}

void tie_back(pad_tie *t)
{
    t->w.opening = t->since < 0.8 ? 0.7 : 0.0;
    if (t->since > 0.2) {
        tie_go(&t->w, t->lead_w, 0.08);
    }
    if (t->since > 1.0) {
        t->slack = 0.96;
        tie_enter(t, TIE_PLACE);
    }
}

/* ---- the tail is taken */

/* The limb goes with the turns, nearer as soon as it is taut. */
static void accompany(pad_tie *t, double dt)
{
    const vec3 turns = vec3_add_scaled(t->w.tip, first_turn - per_turn * wraps(t), t->w.handle);
    if (t->c.tension > 0.02) {
        t->beside = vec3_scale(t->beside, 1.0 - 2.0 * dt);
    }
    tie_go(&t->c, vec3_add(turns, t->beside), 0.2);
}

static vec3 tail_at(const tie_thread *s, vec3 *along)
{
    const uint32_t node = s->count - 1 - FROM_END;
    *along = vec3_unit_or(vec3_sub(s->x[node + 3], s->x[node - 3]), vec3_zero());
    return s->x[node];
}

/* The jaws come along their own line, with the tail across it and between them. */
void tie_reach(pad_tie *t, double dt)
{
    vec3 along;
    const vec3 place = tail_at(&t->thread, &along);
    vec3 handle = vec3_make(0.7 * t->side, 0.65, 0.3);
    handle = vec3_add_scaled(handle, -0.8 * vec3_dot(handle, along), along);
    handle = vec3_unit_or(handle, vec3_make(0.0, 1.0, 0.0));
    vec3 across = vec3_unit_or(vec3_cross(along, handle), vec3_zero());
    across = vec3_dot(across, t->w.across) < 0.0 ? vec3_neg(across) : across;
    /* no deeper than the skin lets the jaws go */
    const double deep = fmin(behind, fmax(shallow, (place.y - 1.2e-3) / fmax(handle.y, 0.1)));
    const vec3 tip = vec3_add_scaled(place, -deep, handle);
    accompany(t, dt);
    if (t->since < 1.2) {
        tie_turn(&t->w, handle, across);
        tie_go(&t->w, vec3_add_scaled(tip, 8e-3, handle), 0.1);
        t->w.opening = t->since > 0.8 ? 0.7 : 0.0;
    } else {
        /* aims by sight: the place between the jaws */
        const vec3 off = vec3_sub(place, vec3_add_scaled(t->w.tip, deep, t->w.handle));
        tie_go(&t->w, vec3_add(t->w.at, off), 0.03);
        if (vec3_norm(off) < 0.5e-3 || t->since > 2.5) {
            tie_enter(t, TIE_CLOSE);
        }
    }
}

vbss_result tie_close(pad_tie *t, double dt)
{
    accompany(t, dt);
    t->w.opening = 0.0;
    if (t->since < 0.3) {
        return VBSS_OK;
    }
    if (t->w.holds) {
        double turns;
        VBSS_TRY(tie_count_turns(t, &turns));
        VBSS_TRY(tie_judge(t));
        t->turns = turns;
        t->pulled = 0.0;
        const vec3 from = vec3_sub(t->w.jaws, t->thread.x[t->thread.tail_root]);
        t->angle = vbss_arc_tangent(from.y, -t->side * from.x);
        t->leash = vec3_norm(from);
        t->lead_c = t->c.tip;
        tie_enter(t, TIE_DRAW);
    } else if (++t->tries < TRIES) {
        tie_enter(t, TIE_REACH);
    } else {
        tie_retry(t, "the tail is not caught");
    }
    return VBSS_OK;
}
