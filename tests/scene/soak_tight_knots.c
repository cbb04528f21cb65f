/* Tight knots of all kinds, threads and frictions, at whose ends hands tug at random. Every seed lives through
 * some knots of its own, ten thousand steps in all. Nothing passes through anything in any part of any step,
 * decided exactly; a thread that never met the rays along which it is closed is the knot that it was; nothing fails. */
#include <math.h>

#include "base/elementary.h"
#include "fixtures/solver_of.h"
#include "harness/harness.h"
#include "oracle/knot_type.h"
#include "scene/watch.h"
#include "fixtures/contact_scenes.h"

enum { LIVES = 4, PULLED = 300, TUGGED = 2000, TAUT = 200 };

typedef struct soak {
    harness_soak *out;
    vbss_random random;
    uint64_t steps, parts, attempts, clamped, paused, recovering, loose, typed, closed_anew;
    double deepest, stretch, fastest;
} soak;

static double draw(soak *s, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(&s->random);
}

static double draw_power_of_ten(soak *s, double low, double high)
{
    return vbss_exp(2.302585092994046 * draw(s, low, high));
}

static bool chance(soak *s, double probability)
{
    return vbss_random_uniform(&s->random) < probability;
}

/* ---- a life */

static void draw_knot(soak *s, contact_scene_options *o, double stiffness)
{
    /* Most are small, as steps are many. */
    static const knot_kind rare[] = {KNOT_SQUARE, KNOT_GRANNY,       KNOT_SURGEON,
                                     KNOT_FLS,    KNOT_HALF_HITCHES, KNOT_REVERSED_HALF_HITCHES};
    uint32_t which = vbss_random_below(&s->random, 18);
    knot_kind kind = which < 6 ? rare[which] : which < 14 ? KNOT_OVERHAND : KNOT_DOUBLE_OVERHAND;
    knot_shape_init(&o->knot, kind);
    /* What is stiff is tied loosely, or it springs open at once. */
    double size = stiffness > 1e-8 ? vbss_exp(vbss_log(stiffness / 1e-8) / 4.0) : 1.0;
    o->knot.size *= size;
    o->knot.cylinder = chance(s, 0.15);
    o->knot.mirrored = chance(s, 0.5);
    double parts = kind == KNOT_OVERHAND || kind == KNOT_DOUBLE_OVERHAND ? 0.05
                   : kind == KNOT_FLS                                    ? 0.12
                                                                         : 0.09;
    o->knot.length = parts * size * (o->knot.cylinder ? 1.3 : 1.0) + draw(s, 0.0, 0.02);
    o->knot.finest = draw(s, 0.25e-3, 0.5e-3) * (size > 1.5 ? 1.5 : 1.0);
    if (chance(s, 0.1)) {
        o->knot.finest = o->knot.coarsest = draw(s, 0.8e-3, 1.25e-3);
    }
}

static void draw_options(soak *s, contact_scene_options *o)
{
    double stiffness = draw_power_of_ten(s, -10.0, -6.0), spring = draw_power_of_ten(s, 2.5, 3.7);
    (void)contact_scene_init(o, CONTACT_SCENE_TUGGED);
    o->thread.bending_stiffness = chance(s, 0.05) ? 0.0 : stiffness;
    draw_knot(s, o, o->thread.bending_stiffness);
    o->thread.axial_stiffness = draw_power_of_ten(s, 1.0, 4.0);
    o->thread.bending = (vbss_thread_bending)vbss_random_below(&s->random, 2);
    o->thread.gravity[1] = chance(s, 0.5) ? -9.81 : 0.0;
    /* Without it nothing holds: bounded, but slow. */
    o->scene.thread_friction = chance(s, 0.01) ? draw(s, 0.0, 0.1) : draw(s, 0.1, 1.0);
    o->tool_friction = draw(s, 0.0, 0.5);
    o->scene.mode = chance(s, 0.25) ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
    o->pull.force = draw_power_of_ten(s, -0.5, 0.4);
    o->pull.speed = draw_power_of_ten(s, -1.7, -0.6);
    o->pull.stiffness = chance(s, 0.5) ? spring : 0.0;
    o->seed = vbss_random_u64(&s->random) >> 8;
    o->begin = PULLED;
    o->loose = chance(s, 0.3);
}

static bool fine(soak *s, const contact_scene *scene, const watch *w, vbss_result result)
{
    vbss_view v;
    const char *text = "";
    if (result != VBSS_OK) {
        scene_object *inside = w->scene;
        (void)vbss_context_get_last_error(inside->context, NULL, &text);
        harness_soak_fail(s->out, "step %llu: %s: %s", (unsigned long long)scene->steps,
                          vbss_result_name(result), text);
        return false;
    }
    if (watch_faults(w) > 0) {
        harness_soak_fail(s->out, "step %llu: %llu pairs passed, %llu below, %llu jumps",
                          (unsigned long long)scene->steps, (unsigned long long)w->passed,
                          (unsigned long long)w->below, (unsigned long long)w->jumps);
        return false;
    }
    (void)vbss_thread_get_view(scene->threads[0], VBSS_THREAD_VIEW_VELOCITIES, &v, sizeof v);
    double fastest = 0.0;
    for (uint64_t i = 0; i < v.count; i++) {
        fastest = vbss_max_or_nan(vec3_norm(((const vec3 *)v.data)[i]), fastest);
    }
    s->fastest = fmax(s->fastest, fastest);
    if (!(fastest < 1e3)) {
        harness_soak_fail(s->out, "step %llu: a node has %g m/s", (unsigned long long)scene->steps,
                          fastest);
    }
    return fastest < 1e3;
}

static bool run_steps(soak *s, contact_scene *scene, watch *w, uint32_t count, double h)
{
    for (uint32_t i = 0; i < count; i++) {
        s->steps++;
        if (!fine(s, scene, w, contact_scene_step(scene, h))) {
            return false;
        }
    }
    return true;
}

static knot_type type_of(const contact_scene *scene)
{
    vbss_view v;
    knot_type type = {0, 0, 0};
    (void)vbss_thread_get_view(scene->threads[0], VBSS_THREAD_VIEW_POSITIONS, &v, sizeof v);
    (void)knot_type_of(v.data, scene->nodes[0], &type);
    return type;
}

/* Where an end was led through a loop another knot is right. */
static void compare_knots(soak *s, contact_scene *scene, watch *w, knot_type first, double h)
{
    scene->options.begin = UINT32_MAX; /* hands pull again */
    if (!run_steps(s, scene, w, TAUT, h)) {
        return;
    }
    if (w->closed_anew > 0) {
        s->closed_anew++;
        return;
    }
    knot_type last = type_of(scene);
    if (first.determinant == 0 || last.determinant == 0) {
        return;
    }
    s->typed++;
    if (!knot_type_same(first, last)) {
        harness_soak_fail(s->out, "%s of determinant %lld became one of %lld",
                          knot_names[scene->options.knot.kind], (long long)first.determinant,
                          (long long)last.determinant);
    }
}

static void add_up(soak *s, const contact_scene *scene)
{
    vbss_scene_statistics t;
    (void)vbss_scene_get_statistics(scene->scene, &t, sizeof t);
    s->parts += t.parts;
    s->attempts += t.attempts;
    s->clamped += t.clamped;
    s->paused += t.paused;
    s->recovering += t.recovering;
    s->loose += t.loose_stretch;
    s->deepest = fmax(s->deepest, t.penetration / (2.0 * scene->options.thread.radius));
    s->stretch = fmax(s->stretch, t.stretch_error);
    if (t.stretch_error > solver_values(&scene->options.scene).stretch_tolerance &&
        t.loose_stretch == 0 && t.clamped == 0) {
        harness_soak_fail(s->out, "a stretch error of %g, not counted", t.stretch_error);
    }
}

static void live(soak *s, vbss_context *context, watch *w)
{
    contact_scene_options o;
    contact_scene scene;
    draw_options(s, &o);
    double h = 0.5e-3 * (1 + vbss_random_below(&s->random, 4));
    vbss_result result = contact_scene_create(context, &o, &scene);
    if (result != VBSS_OK) {
        harness_soak_fail(s->out, "%s of %g m: %s", knot_names[o.knot.kind], o.knot.length,
                          vbss_result_name(result));
        return;
    }
    watch_begin(w, scene.scene);
    w->closes = true;
    w->closed_anew = 0;
    knot_type first = type_of(&scene);
    if (run_steps(s, &scene, w, PULLED + TUGGED, h)) {
        compare_knots(s, &scene, w, first, h);
    }
    add_up(s, &scene);
    (void)contact_scene_destroy(&scene);
}

static void run(harness_soak *out)
{
    static watch w;
    soak s = {.out = out};
    vbss_context *context;
    vbss_random_seed(&s.random, out->seed, 7);
    for (int life = 0; life < LIVES && out->failures == 0; life++) {
        if (vbss_context_create(NULL, &context) != VBSS_OK) {
            harness_soak_fail(out, "no context");
            return;
        }
        live(&s, context, &w);
        (void)vbss_context_destroy(context);
    }
    harness_soak_figure(out, "steps", (double)s.steps);
    harness_soak_figure(out, "parts", (double)w.parts);
    harness_soak_figure(out, "pairs", (double)w.pairs);
    harness_soak_figure(out, "asked", (double)w.asked);
    harness_soak_figure(out, "attempts", (double)s.attempts);
    harness_soak_figure(out, "clamped", (double)s.clamped);
    harness_soak_figure(out, "paused", (double)s.paused);
    harness_soak_figure(out, "recovering", (double)s.recovering);
    harness_soak_figure(out, "loose_stretch", (double)s.loose);
    harness_soak_figure(out, "knots_compared", (double)s.typed);
    harness_soak_figure(out, "closed_anew", (double)s.closed_anew);
    harness_soak_figure(out, "deepest", s.deepest);
    harness_soak_figure(out, "stretch_error", s.stretch);
    harness_soak_figure(out, "fastest", s.fastest);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
