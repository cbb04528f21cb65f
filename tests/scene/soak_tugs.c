/* Two hands that do anything to a stitch at up to 0.5 m/s: they tug both ends, drop them, take ends again, cut. With and
 * without a throw above the slit. Every seed lives some lives of its own. After every step threads cross the wall in holes
 * only, every hole has its thread, as many holes are there as events tell, and all is finite. */
#include "scene/stitch_case.h"

enum { LIVES = 5, STEPS = 1000 };
/* Jaws would have lost it, N. */
#define MAX_PULL 8.0
/* Hands turn back from there, m. */
#define FAR 45e-3
/* And out of the tube and from near it, from its axis, m: a hand is no point. */
#define NEAR 14e-3
/* What a step has more than hands could have put in, J: the shells of a drain and a slack thread have some. */
#define JUMP 100e-6
/* What holes may have given a life, less what they took, J: while their directions jumped from span to span, 12 and 17 mJ were. */
#define GIVEN 3e-3

typedef struct hand_doing {
    vec3 direction;
    double speed;
    uint32_t steps;
} hand_doing;

typedef struct soak {
    harness_soak *out;
    vbss_random random;
    hand_doing doing[2];
    uint32_t bodies; /* most number of a thread */
    uint64_t steps, parts, clamped, paused, cuts, drops, lost_grips, takes, unthreaded,
        loose_stretch;
    double deepest, fastest, jump, shown, given, farthest, loosest, stretch;
} soak;

static stitch_case c;

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

static void begin(soak *s)
{
    static const uint32_t crossings[] = {0, 1, 1, 3, 5};
    stitch_case_begin(&c);
    c.options.scene.mode =
        draw(s, 0.0, 1.0) < 0.2 ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
    c.options.crossings = crossings[vbss_random_below(&s->random, 5)];
    c.options.segment = draw(s, 0.0, 1.0) < 0.3 ? 0.5e-3 : 1e-3;
    c.options.limb = draw(s, 10e-3, 30e-3);
    c.options.drain.hole_friction = draw(s, 0.0, 0.6);
    c.options.drain.tear_stress = draw(s, 0.0, 1.0) < 0.3 ? 5e3 : 5e4;
    stitch_case_make(&c);
    s->bodies = c.stitch.thread_body;
}

/* An end of any of the threads. */
static void take_again(soak *s, int hand)
{
    uint32_t body = 1 + vbss_random_below(&s->random, s->bodies);
    bool last = draw(s, 0.0, 1.0) < 0.5;
    uint32_t nodes = stitch_case_nodes(&c, body);
    if (nodes > 0 && stitch_case_take(&c, hand, body, last ? nodes - 1 : 0)) {
        s->takes++;
    }
}

static void cut(soak *s)
{
    uint32_t body = 1 + vbss_random_below(&s->random, s->bodies);
    double share = draw(s, 0.02, 0.98);
    if (stitch_case_nodes(&c, body) > 0) {
        uint32_t piece = stitch_case_cut(&c, body, share * stitch_case_length(&c, body));
        s->bodies = piece > s->bodies ? piece : s->bodies;
        s->cuts += piece != 0;
    }
}

static void choose(soak *s, int hand)
{
    double what = draw(s, 0.0, 1.0), share = draw(s, 0.0, 1.0), slow = draw(s, 0.0, 1.0);
    hand_doing *d = &s->doing[hand];
    d->direction = draw_direction(s);
    d->speed = slow < 0.2 ? 0.0 : 0.5 * share * share;
    d->steps = 20 + vbss_random_below(&s->random, 180);
    if (what < 0.1) {
        cut(s);
    }
    if (c.hands[hand].thread == NULL) {
        take_again(s, hand);
    } else if (what > 0.9) {
        stitch_case_drop(&c, hand);
        s->drops++;
    }
}

static void act(soak *s, int hand)
{
    hand_doing *d = &s->doing[hand];
    const stitch_case_hand *own = &c.hands[hand];
    if (d->steps-- == 0) {
        choose(s, hand);
    }
    if (own->thread != NULL && vec3_norm(own->force) > MAX_PULL) {
        stitch_case_drop(&c, hand);
        s->lost_grips++;
    }
    if (own->thread != NULL) {
        vec3 off = vec3_make(0.0, own->at.y, own->at.z);
        bool far = vec3_norm(own->at) > FAR, near = !far && vec3_norm(off) < NEAR;
        vec3 direction = far    ? vec3_neg(vec3_unit_or(own->at, d->direction))
                         : near ? vec3_unit_or(vec3_add_scaled(vec3_make(0.0, 3e-3, 0.0), 1.0, off),
                                               d->direction)
                                : d->direction;
        stitch_case_target(&c, hand, vec3_add_scaled(own->at, d->speed * c.h, direction));
    }
}

static bool fine(soak *s)
{
    uint32_t left = 2 - c.counts[VBSS_SCENE_EVENT_UNTHREADED];
    double fastest = stitch_case_fastest(&c);
    s->fastest = fmax(s->fastest, fastest);
    if (c.watch.away > 0 || c.watch.missed > 0 || c.watch.holes != left || !(fastest < 1e3) ||
        !(c.shown < JUMP) || !(c.max_given < GIVEN)) {
        harness_soak_fail(
            s->out,
            "step %llu (%u of its life, %u crossings): %llu crossings away from holes, %llu holes "
            "without suture; %u holes, %u left; %g m/s; a step with %g J too much, %g of it there "
            "in the next; holes gave %g J",
            (unsigned long long)s->steps, c.steps, c.options.crossings,
            (unsigned long long)c.watch.away, (unsigned long long)c.watch.missed, c.watch.holes,
            left, fastest, c.shown, c.jump, c.max_given);
        return false;
    }
    return true;
}

static void add_up(soak *s)
{
    vbss_scene_statistics t = small_statistics(&c.s);
    s->parts += t.parts;
    s->clamped += t.clamped;
    s->paused += t.paused;
    s->loose_stretch += t.loose_stretch;
    s->unthreaded += c.counts[VBSS_SCENE_EVENT_UNTHREADED];
    s->deepest = fmax(s->deepest, t.penetration);
    s->stretch = fmax(s->stretch, t.stretch_error);
    s->jump = fmax(s->jump, c.jump);
    s->shown = fmax(s->shown, c.shown);
    s->given = fmax(s->given, c.max_given);
    s->farthest = fmax(s->farthest, c.watch.farthest);
    s->loosest = fmax(s->loosest, c.watch.loosest);
}

static void live(soak *s)
{
    bool good = true;
    begin(s);
    memset(s->doing, 0, sizeof s->doing);
    for (uint32_t i = 0; i < STEPS && good; i++) {
        s->steps++;
        act(s, 0);
        act(s, 1);
        stitch_case_step(&c);
        good = fine(s);
    }
    add_up(s);
    stitch_case_end(&c);
}

static void run(harness_soak *out)
{
    soak s = {.out = out};
    vbss_random_seed(&s.random, out->seed, 11);
    for (int i = 0; i < LIVES && out->failures == 0; i++) {
        live(&s);
    }
    harness_soak_figure(out, "steps", (double)s.steps);
    harness_soak_figure(out, "parts", (double)s.parts);
    harness_soak_figure(out, "clamped", (double)s.clamped);
    harness_soak_figure(out, "paused", (double)s.paused);
    harness_soak_figure(out, "cuts", (double)s.cuts);
    harness_soak_figure(out, "drops", (double)s.drops);
    harness_soak_figure(out, "lost_grips", (double)s.lost_grips);
    harness_soak_figure(out, "takes", (double)s.takes);
    harness_soak_figure(out, "unthreaded", (double)s.unthreaded);
    harness_soak_figure(out, "loose_stretch", (double)s.loose_stretch);
    harness_soak_figure(out, "stretch", s.stretch);
    harness_soak_figure(out, "deepest", s.deepest);
    harness_soak_figure(out, "fastest", s.fastest);
    harness_soak_figure(out, "jump", s.jump);
    harness_soak_figure(out, "shown", s.shown);
    harness_soak_figure(out, "given", s.given);
    harness_soak_figure(out, "farthest", s.farthest);
    harness_soak_figure(out, "loosest", s.loosest);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
