/* Tools of any size that go anywhere, at up to 0.3 m/s: against a drain, through its slit, into its lumen, with a thread
 * in between at times. Every seed lives some lives of its own, five thousand steps in all. Nothing passes through
 * anything in any part of any step, decided exactly; nothing fails. */
#include <math.h>

#include "scene/small_watch.h"

enum { LIVES = 5, STEPS = 1000, MAX_TOOLS = 2 };

typedef struct poker {
    uint32_t body;
    vec3 at, to;
    double speed;
} poker;

typedef struct soak {
    harness_soak *out;
    vbss_random random;
    uint64_t steps, parts, clamped, paused, loose, forced;
    uint32_t inverted, torn;
    double deepest, fastest;
} soak;

static double draw(soak *s, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(&s->random);
}

static bool chance(soak *s, double probability)
{
    return vbss_random_uniform(&s->random) < probability;
}

/* ---- a life */

typedef struct life {
    small s;
    small_watch watch;
    vbss_drain *drain;
    vbss_thread *thread; /* or NULL */
    poker tools[MAX_TOOLS];
    uint32_t tool_count;
    double h;
} life;

/* In the lumen, above the slit or beside it all. */
static vec3 draw_place(soak *s)
{
    bool inside = chance(s, 0.4);
    double x = draw(s, -22e-3, 22e-3), wide = inside ? 5e-3 : 12e-3;
    double y = draw(s, -wide, wide), z = draw(s, -wide, wide);
    return vec3_make(x, y, z);
}

static vec3 draw_half(soak *s)
{
    double length = draw(s, 0.0, 15e-3), x = draw(s, -1.0, 1.0), y = draw(s, -1.0, 1.0),
           z = draw(s, -1.0, 1.0);
    return chance(s, 0.1)
               ? vec3_zero()
               : vec3_scale(vec3_unit_or(vec3_make(x, y, z), vec3_make(0, 1, 0)), length);
}

static void add_tools(soak *s, life *l)
{
    l->tool_count = 1 + vbss_random_below(&s->random, MAX_TOOLS);
    for (uint32_t i = 0; i < l->tool_count; i++) {
        vec3 half = draw_half(s);
        vec3 at = vec3_make(draw(s, -10e-3, 10e-3), 30e-3 + 45e-3 * i, 0.0); /* above all else */
        double radius = draw(s, 0.4e-3, 2.5e-3);
        l->s.rigid.friction = draw(s, 0.0, 0.6);
        l->s.rigid.stiffness = draw(s, 200.0, 2000.0);
        uint32_t body = small_stick(&l->s, VBSS_SCENE_RIGID_COUPLED, at, half, radius);
        l->tools[i] = (poker){body, at, draw_place(s), draw(s, 0.02, 0.3)};
    }
}

/* Over the drain, or through its lumen. */
static void add_thread(soak *s, life *l)
{
    bool inside = chance(s, 0.5);
    double aside = draw(s, -2e-3, 2e-3);
    vec3 begin = inside ? vec3_make(-25e-3, aside, 0.0) : vec3_make(aside, 9e-3, -20e-3);
    vec3 end = inside ? vec3_make(25e-3, aside, 0.0) : vec3_make(aside, 9e-3, 20e-3);
    l->s.thread.radius = draw(s, 0.1e-3, 0.2e-3);
    uint32_t body = small_thread(&l->s, begin, end, 40, &l->thread);
    if (chance(s, 0.5)) {
        (void)small_pin(&l->s, body, 0, 0);
    }
    if (chance(s, 0.5)) {
        (void)small_pin(&l->s, body, 40, 0);
    }
}

static void begin(soak *s, life *l)
{
    vbss_drain_config config;
    uint32_t body;
    memset(l, 0, sizeof *l);
    small_begin(&l->s);
    expect_ok(vbss_drain_config_init(&config, sizeof config));
    l->h = chance(s, 0.2) ? 0.5e-3 : 1e-3;
    l->s.config.contact_capacity = 4096;
    l->s.config.candidate_capacity = 65536;
    l->s.config.mode = chance(s, 0.25) ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
    l->s.config.floor = chance(s, 0.5);
    l->s.config.floor_height = -9e-3;
    l->s.thread.gravity[1] = -9.81;
    config.thickness = chance(s, 0.2) ? 0.5e-3 : 1e-3;
    config.tear_stress = chance(s, 0.5) ? 1e9 : 5e4;
    config.friction = draw(s, 0.0, 0.6);
    config.gravity[1] = chance(s, 0.5) ? -9.81 : 0.0;
    small_create(&l->s);
    expect_ok(vbss_drain_create(l->s.context, &config, &l->drain));
    expect_ok(vbss_scene_add_drain(l->s.scene, l->drain, &body));
    add_tools(s, l);
    if (chance(s, 0.3)) {
        add_thread(s, l);
    }
    small_watch_begin(&l->s, &l->watch);
}

static void move_tools(soak *s, life *l)
{
    for (uint32_t i = 0; i < l->tool_count; i++) {
        poker *p = &l->tools[i];
        vec3 displacement = vec3_sub(p->to, p->at);
        double far = vec3_norm(displacement), step = p->speed * l->h;
        if (far <= step) {
            p->to = draw_place(s);
            p->speed = draw(s, 0.02, 0.3);
        } else {
            p->at = vec3_add_scaled(p->at, step / far, displacement);
        }
        small_move(&l->s, p->body, p->at);
    }
}

static bool fine(soak *s, const life *l, vbss_result result)
{
    vbss_view v;
    const small_watch *w = &l->watch;
    if (result != VBSS_OK) {
        const char *text = "";
        (void)vbss_context_get_last_error(l->s.context, NULL, &text);
        harness_soak_fail(s->out, "step %llu: %s: %s", (unsigned long long)s->steps,
                          vbss_result_name(result), text);
        return false;
    }
    if (w->passed + w->passed_drain + w->below > 0) {
        harness_soak_fail(s->out, "step %llu: %llu passed, %llu a drain, %llu below",
                          (unsigned long long)s->steps, (unsigned long long)w->passed,
                          (unsigned long long)w->passed_drain, (unsigned long long)w->below);
        return false;
    }
    expect_ok(vbss_drain_get_view(l->drain, VBSS_DRAIN_VIEW_VELOCITIES, &v, sizeof v));
    double fastest = 0.0;
    for (uint64_t i = 0; i < v.count; i++) {
        fastest = vbss_max_or_nan(vec3_norm(((const vec3 *)v.data)[i]), fastest);
    }
    s->fastest = fmax(s->fastest, fastest);
    if (!(fastest < 1e3)) {
        harness_soak_fail(s->out, "step %llu: a node has %g m/s", (unsigned long long)s->steps,
                          fastest);
    }
    return fastest < 1e3;
}

static void add_up(soak *s, const life *l)
{
    vbss_scene_statistics t = small_statistics(&l->s);
    vbss_drain_statistics d;
    expect_ok(vbss_drain_get_statistics(l->drain, &d, sizeof d));
    s->parts += l->watch.parts;
    s->clamped += t.clamped;
    s->paused += t.paused;
    s->loose += t.loose_states;
    s->forced += d.forced;
    s->inverted = d.inverted > s->inverted ? d.inverted : s->inverted;
    s->torn = d.torn > s->torn ? d.torn : s->torn;
    s->deepest = fmax(s->deepest, t.penetration);
}

static void live(soak *s)
{
    static life l;
    begin(s, &l);
    bool good = true;
    for (uint32_t i = 0; i < STEPS && good; i++) {
        s->steps++;
        move_tools(s, &l);
        good = fine(s, &l, vbss_scene_step(l.s.scene, l.h));
    }
    add_up(s, &l);
    small_end(&l.s);
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
    harness_soak_figure(out, "loose", (double)s.loose);
    harness_soak_figure(out, "forced", (double)s.forced);
    harness_soak_figure(out, "inverted", (double)s.inverted);
    harness_soak_figure(out, "torn", (double)s.torn);
    harness_soak_figure(out, "deepest", s.deepest);
    harness_soak_figure(out, "fastest", s.fastest);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
