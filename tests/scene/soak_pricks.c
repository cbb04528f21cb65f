/* A needle in a hand that does anything, at up to 0.5 m/s: pushes it on along its arc and back, moves it, turns it about its
 * tip, lets it go; against a drain that is held here and there. Every seed lives some lives of its own. After every step
 * the needle crosses the wall in holes only, as many holes are there as events tell, and all is finite. */
#include "base/rotation.h"
#include "scene/needle_case.h"

/* Who enters aslant, at a cosine down to 0.3, crosses the wall beside the hole: in distances of touching. */
#define ASLANT 4.0

enum { LIVES = 4, STEPS = 800 };

typedef enum action { ON, BACK, MOVE, TURN, WAIT, ACTIONS } action;

typedef struct soak {
    harness_soak *out;
    vbss_random random;
    uint64_t steps, parts, clamped, paused, entries, exits, passed, lost;
    double deepest, fastest;
} soak;

static needle_case c;

static double draw(soak *s, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(&s->random);
}

static vec3 draw_direction(soak *s)
{
    double x = draw(s, -1.0, 1.0), y = draw(s, -1.0, 1.0), z = draw(s, -1.0, 1.0);
    return vec3_unit_or(vec3_make(x, y, z), vec3_make(0.0, 1.0, 0.0));
}

/* ---- a life */

static void hold_drain(soak *s)
{
    drain_object *d;
    expect_ok(vbss_drain_open(c.d.drain, &d));
    for (int side = 0; side < 2; side++) {
        if (draw(s, 0.0, 1.0) < 0.6) {
            (void)drain_case_pin(&c.d, d->mesh.slit_middle[side]);
        }
    }
}

/* Before the wall somewhere above its block, pointing more or less into it. */
static void begin(soak *s)
{
    needle_case_begin(&c);
    c.at_hole = ASLANT;
    c.d.s.config.mode =
        draw(s, 0.0, 1.0) < 0.2 ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
    c.d.s.config.hole_capacity = draw(s, 0.0, 1.0) < 0.2 ? 1 : 16;
    c.d.config.puncture_force = draw(s, 0.1, 1.5);
    c.config.friction = draw(s, 0.0, 0.5);
    needle_case_make(&c);
    hold_drain(s);
    double angle = draw(s, -2.0, 2.0), x = draw(s, -12e-3, 12e-3);
    vec3 out = vec3_make(0.0, cos(angle), sin(angle));
    vec3 tip = vec3_add_scaled(vec3_make(x, 0.0, 0.0), 10.5e-3, out);
    vec3 aside = draw_direction(s), lean = draw_direction(s);
    needle_case_put(&c, tip, vec3_add_scaled(vec3_neg(out), 0.1, lean), aside);
    scene_rigid *r = &vbss_scene_body(small_object(&c.d.s), c.body)->rigid;
    r->body.coupling = (vbss_rigid_coupling){2000.0, 5.0, 0.5, 5e-3};
}

typedef struct doing {
    action what;
    vec3 direction;
    double speed;
    uint32_t steps;
} doing;

static doing draw_doing(soak *s)
{
    static const double often[ACTIONS] = {0.4, 0.6, 0.75, 0.9, 1.0};
    doing d = {.direction = draw_direction(s)};
    double which = draw(s, 0.0, 1.0), share = draw(s, 0.0, 1.0);
    while (which > often[d.what]) {
        d.what++;
    }
    d.speed = 0.5 * share * share;
    d.steps = 20 + vbss_random_below(&s->random, 180);
    return d;
}

static void act(const doing *d)
{
    double step = d->speed * c.d.h;
    vec3 tip = pose_apply(c.hand, vec3_make(c.config.radius, 0.0, 0.0));
    if (d->what == ON || d->what == BACK) {
        needle_case_turn(&c, d->what == ON ? step : -step);
    } else if (d->what == MOVE) {
        bool far = vec3_norm(tip) > 20e-3; /* it comes back */
        needle_case_shift(&c, vec3_scale(far ? vec3_unit_or(tip, d->direction) : d->direction,
                                         far ? -step : step));
    } else if (d->what == TURN) {
        quat by = vbss_quat_from_rotation_vector(vec3_scale(d->direction, step / c.config.radius));
        vec3 arm = quat_rotate(by, vec3_sub(c.hand.position, tip));
        c.hand = pose_make(vec3_add(tip, arm), quat_mul(by, c.hand.orientation));
    }
}

static bool fine(soak *s)
{
    vbss_scene_hole holes[NEEDLE_CASE_HOLES];
    uint32_t in = c.counts[VBSS_SCENE_EVENT_PUNCTURE];
    uint32_t out = c.counts[VBSS_SCENE_EVENT_WITHDRAWN] + c.counts[VBSS_SCENE_EVENT_PASSED];
    uint32_t count = needle_case_holes(&c, holes);
    double fastest = drain_case_fastest(&c.d);
    s->fastest = fmax(s->fastest, fastest);
    if (c.away > 0 || count != in - out || !(fastest < 1e3)) {
        harness_soak_fail(
            s->out, "step %llu: %u crossings away from holes; %u in, %u out, %u holes; %g m/s",
            (unsigned long long)s->steps, c.away, in, out, count, fastest);
        return false;
    }
    return true;
}

static void add_up(soak *s)
{
    vbss_scene_statistics t = small_statistics(&c.d.s);
    s->parts += t.parts;
    s->clamped += t.clamped;
    s->paused += t.paused;
    s->entries += c.counts[VBSS_SCENE_EVENT_PUNCTURE];
    s->exits += c.counts[VBSS_SCENE_EVENT_WITHDRAWN];
    s->passed += c.counts[VBSS_SCENE_EVENT_PASSED];
    s->lost += c.counts[VBSS_SCENE_EVENT_HOLE_LOST];
    s->deepest = fmax(s->deepest, t.penetration);
}

static void live(soak *s)
{
    doing d = {.what = ON, .speed = 0.05, .steps = 200}; /* it begins with a prick */
    bool good = true;
    begin(s);
    for (uint32_t i = 0; i < STEPS && good; i++) {
        s->steps++;
        if (d.steps-- == 0) {
            d = draw_doing(s);
        }
        act(&d);
        needle_case_step(&c);
        good = fine(s);
    }
    add_up(s);
    needle_case_end(&c);
}

static void run(harness_soak *out)
{
    soak s = {.out = out};
    vbss_random_seed(&s.random, out->seed, 7);
    for (int i = 0; i < LIVES && out->failures == 0; i++) {
        live(&s);
    }
    harness_soak_figure(out, "steps", (double)s.steps);
    harness_soak_figure(out, "parts", (double)s.parts);
    harness_soak_figure(out, "clamped", (double)s.clamped);
    harness_soak_figure(out, "paused", (double)s.paused);
    harness_soak_figure(out, "entries", (double)s.entries);
    harness_soak_figure(out, "exits", (double)s.exits);
    harness_soak_figure(out, "passed", (double)s.passed);
    harness_soak_figure(out, "lost", (double)s.lost);
    harness_soak_figure(out, "deepest", s.deepest);
    harness_soak_figure(out, "fastest", s.fastest);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
