/* The tail goes through the turns, and both hands pull. */
#include <math.h>

#include "base/elementary.h"
#include "base/error.h"
#include "tie.h"

#define PI 3.14159265358979324

static const double behind = 2e-3 /* m, of the thread in jaws from their tip */,
                    light = 0.02 /* N: the limb while the tail is drawn */,
                    drawn = 0.15 /* N: the tail then */,
                    pull_height = 4e-3 /* m over the skin: hands that pull */,
                    hitched = 0.1 /* N: the tail while the turns run down */,
                    locking = 0.5 /* N: the limb then, and after that both ends, */,
                    harder = 0.3 /* N: more with each pull */, rising = 0.4 /* N/s */,
                    kept = 0.4 /* s, with all that */,
                    hanging = 3.0 /* s: a tail that is not through by then */;
/* Lips that touch are a fifth of the skin's 2 mm apart (docs/explanation/drain-contact.md). Farther than this they have opened again. */
static const double opened = 0.48e-3 /* m */;
/* So often each throw is pulled, at most: until the last one the knot is held, and does not show whether it holds by itself. */
static const uint32_t pulls[TIE_THROWS] = {1, 1, 4};

static vec3 outward_of_w(const pad_tie *t)
{
    return vec3_make(t->side, 0.4, 0.3);
}

static double clamped(double x, double low, double high)
{
    return fmin(fmax(x, low), high);
}

/* The hand that holds the limb goes to the tail's first side, and gives in when it feels it. */
static void follow(pad_tie *t, double dt)
{
    vec3 direction = vec3_make(-t->side, -0.3, 0.0);
    double speed = 0.03;
    if (t->c.tension > light) {
        direction = vec3_unit_or(vec3_sub(t->w.tip, t->c.tip), vec3_zero());
        speed = fmin(0.1, 0.03 * (t->c.tension / light - 1.0) + 0.005);
    }
    t->lead_c = vec3_add_scaled(t->lead_c, speed * dt, direction);
    t->lead_c.y = fmax(t->lead_c.y, 6e-3);
    t->lead_c = vec3_add(t->c.tip, tie_limited(vec3_sub(t->lead_c, t->c.tip), 8e-3));
    tie_go(&t->c, t->lead_c, 0.15);
}

/* The tail is a leash of the hand that has it. `share`: of its length, how far the hand may go. */
static void keep_on_leash(pad_tie *t, double limit, double share, double dt)
{
    const tie_thread *s = &t->thread;
    const double whole = share * tie_length(s, s->tail_root, t->w.node);
    t->leash += (t->w.tension > limit ? -0.03 : 0.01) * dt;
    t->leash = clamped(t->leash, 0.3 * whole, whole);
    const vec3 direction = vec3_make(-t->side * vbss_cosine(t->angle), vbss_sine(t->angle), 0.0);
    vec3 jaws = vec3_add_scaled(s->x[s->tail_root], t->leash, direction);
    jaws.y = fmax(jaws.y, 5e-3);
    tie_go(&t->w, vec3_add_scaled(jaws, -behind, t->w.handle), 0.08);
}

vbss_result tie_draw(pad_tie *t, double dt)
{
    const double length = 0.97 * tie_length(&t->thread, t->thread.tail_root, t->w.node);
    if (t->w.tension < drawn + 0.05) {
        t->angle = fmin(t->angle + 0.04 / length * dt, PI * 160.0 / 180.0);
    }
    if (t->angle > 1.6) {
        tie_turn(&t->w, outward_of_w(t), t->w.across);
    }
    /* a tail that hangs is pulled straight, and not only led */
    keep_on_leash(t, drawn, t->since > hanging ? 1.1 : 0.98, dt);
    follow(t, dt);
    if (!t->w.holds) {
        tie_retry(t, "the tail is lost");
        return VBSS_OK;
    }
    const double every = 0.1;
    if (fmod(t->since, every) < dt) {
        double turns;
        VBSS_TRY(tie_count_turns(t, &turns));
        t->turns = turns;
        VBSS_TRY(tie_judge(t));
        const bool is_formed = t->knot.state.throw_count > t->throws &&
                               t->knot.state.verdict >= VBSS_KNOT_VERDICT_FORMED &&
                               t->knot.state.verdict != VBSS_KNOT_VERDICT_UNCERTAIN &&
                               fabs(turns) < 0.6;
        t->pulled = is_formed ? t->pulled + every : 0.0;
    }
    if (t->pulled > 0.35) {
        t->throws++;
        t->retries = 0;
        VBSS_TRY(tie_judge(t));
        t->pulled = 0.0;
        tie_enter(t, TIE_LOWER);
    } else if (t->since > 7.0) {
        tie_retry(t, "the tail is not drawn through");
    }
    return VBSS_OK;
}

static void begin_pull(pad_tie *t)
{
    t->lead_w = t->w.tip;
    t->lead_c = t->c.tip;
    t->pulled = t->wanted = 0.0;
    t->is_locking = false;
    t->pulls++;
    tie_enter(t, TIE_PULL);
}

/* Both hands come down beside the stitch, and nothing is taut yet. */
void tie_lower(pad_tie *t, double dt)
{
    const tie_thread *s = &t->thread;
    const double limb = 0.85 * tie_length(s, t->c.node, s->limb_root);
    const vec3 root = s->x[s->limb_root];
    tie_turn(&t->w, outward_of_w(t), t->w.across);
    t->angle = fmin(t->angle + 0.06 / t->leash * dt, PI * 173.0 / 180.0);
    keep_on_leash(t, 0.05, 0.98, dt);
    const double far = limb;
    const vec3 goal = vec3_make(root.x - far * t->side, pull_height, t->stitch.z);
    if (t->c.tension < 0.03) {
        tie_go(&t->c, goal, 0.08);
    } else {
        tie_go(&t->c, vec3_add_scaled(t->c.tip, 5e-3, vec3_unit_or(vec3_sub(root, t->c.tip), goal)),
               0.05);
    }
    if ((t->angle >= PI * 172.0 / 180.0 && t->c.tip.y < 2.0 * pull_height) || t->since > 2.0) {
        t->pulls = 0;
        begin_pull(t);
    }
}

/* Gives in at once to more than is wanted. */
static void draw(tie_hand *h, vec3 *lead, vec3 to, double wanted, double dt)
{
    const double missing = wanted - h->tension;
    const double speed = missing < 0.0       ? fmax(0.1 * missing, -0.06)
                         : h->tension < 0.05 ? 0.03
                                             : fmin(0.03 * missing, 0.012);
    const vec3 direction = vec3_unit_or(vec3_sub(to, h->tip), vec3_zero());
    *lead = vec3_add_scaled(*lead, speed * dt, direction);
    *lead = vec3_add(h->tip, tie_limited(vec3_sub(*lead, h->tip), 5e-3));
    tie_go(h, *lead, 0.08);
}

static vec3 beside(const pad_tie *t, double x)
{
    return vec3_add(vec3_add(t->stitch, t->off), vec3_make(x * t->side, pull_height, 0.0));
}

/* The limb runs straight to the knot, and the tail is hitched about it: so the turns run down to the skin. Then both ends bear the
 * same, which locks the turns. */
vbss_result tie_pull(pad_tie *t, double dt)
{
    const double largest = locking + harder * (t->pulls - 1.0);
    t->wanted = t->is_locking ? largest : fmin(t->wanted + rising * dt, locking);
    draw(&t->w, &t->lead_w, beside(t, 75e-3), t->is_locking ? largest : hitched, dt);
    draw(&t->c, &t->lead_c, beside(t, -95e-3), t->wanted, dt);
    t->pulled += t->is_locking && fmin(t->w.tension, t->c.tension) > 0.9 * largest ? dt : 0.0;
    t->is_locking = t->is_locking || t->c.tension > 0.95 * locking;
    if (t->pulled > kept) {
        VBSS_TRY(tie_judge(t));
        tie_enter(t, TIE_EASE);
    } else if (t->since > 10.0) {
        tie_fail(t, "not pulled tight");
    }
    return VBSS_OK;
}

static void ease(tie_hand *h, vec3 *lead, vec3 knot, double dt)
{
    const double speed = clamped(0.02 * h->tension, 0.003, 0.02);
    *lead = vec3_add_scaled(*lead, speed * dt, vec3_unit_or(vec3_sub(knot, h->tip), vec3_zero()));
    tie_go(h, *lead, 0.05);
}

/* The ends are slack, and the lips wider apart than they may be. */
static bool is_pulled_again(const pad_tie *t)
{
    return t->pulls < pulls[t->throws - 1] && vec3_norm(t->lips) > opened;
}

vbss_result tie_ease(pad_tie *t, double dt)
{
    if (t->since < 0.8) {
        ease(&t->w, &t->lead_w, t->stitch, dt);
        ease(&t->c, &t->lead_c, t->stitch, dt);
        if (t->since + dt >= 0.8) {
            t->lead_w = vec3_add_scaled(t->w.tip, 25e-3, t->w.handle);
            if (is_pulled_again(t)) {
                begin_pull(t);
            }
        }
        return VBSS_OK;
    }
    t->w.opening = 0.7;
    if (t->since > 1.0) {
        tie_go(&t->w, t->lead_w, 0.08);
    }
    if (t->since > 1.6) {
        VBSS_TRY(tie_judge(t));
        t->side = -t->side;
        t->slack = 0.96;
        tie_enter(t, t->throws < TIE_THROWS ? TIE_PLACE : TIE_LEAVE);
    }
    return VBSS_OK;
}

/* The limb is let go, and both hands go up and away. */
void tie_leave(pad_tie *t)
{
    t->c.opening = 0.7;
    t->w.opening = 0.0;
    if (t->since > 0.2 && t->since < 0.21) {
        t->lead_c = vec3_add_scaled(t->c.tip, 25e-3, t->c.handle);
    }
    if (t->since > 0.21) {
        tie_go(&t->c, t->lead_c, 0.1);
    }
    if (t->since > 1.0) {
        tie_enter(t, TIE_DONE);
    }
}
