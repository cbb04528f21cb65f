/* Hands that do anything to a thread for a long time: pins, clamps, springs, masses and forces come,
 * move and go, it is cut, and steps are of any size. Every seed makes 1e5 steps, every hundredth seed
 * 1e6; one life in four has many segments. Nothing fails, nothing is lost, and when the hands rest the
 * thread comes to rest. Method IMPLICIT: PAPER does not stand such hands. */
#include <math.h>

#include "harness/harness.h"

enum {
    PLACES = 6,
    CUTS = 2,
    LIFE = 2000,
    MAX_SEGMENTS = 60
}; /* LIFE: steps before a thread is made anew */

typedef struct tug {
    harness_soak *soak;
    vbss_random random;
    vbss_context *context;
    vbss_thread *thread, *pieces[CUTS];
    uint32_t segments, cuts, ids[PLACES], count;
    vec3 at[PLACES];
    bool moves[PLACES];  /* not what has no place: masses, forces */
    bool stores[PLACES]; /* energy that is not the thread's: forces, springs */
    uint64_t forced, substeps, failures, lives;
    double worst_error, fastest, worst_gain;
} tug;

static double draw(tug *t, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(&t->random);
}

static void must(tug *t, vbss_result result, const char *what)
{
    if (result != VBSS_OK) {
        const char *text = "";
        t->failures++;
        (void)vbss_context_get_last_error(t->context, NULL, &text);
        harness_soak_fail(t->soak, "life %llu: %s: %s", (unsigned long long)t->lives, what, text);
    }
}

static vec3 node_at(tug *t, uint32_t node)
{
    vbss_view view;
    must(t, vbss_thread_get_view(t->thread, VBSS_THREAD_VIEW_POSITIONS, &view, sizeof view),
         "view");
    return node < view.count ? ((const vec3 *)view.data)[node] : vec3_zero();
}

static void begin_life(tug *t)
{
    vbss_thread_config config;
    must(t, vbss_thread_config_init(&config, sizeof config), "init");
    uint32_t kind = vbss_random_below(&t->random, 4);
    t->segments = config.segment_count =
        2 + vbss_random_below(&t->random, kind == 1 ? MAX_SEGMENTS - 1 : 11);
    config.bending = (vbss_thread_bending)vbss_random_below(&t->random, 2);
    config.length = draw(t, 0.02, 0.15);
    config.attachment_capacity = PLACES;
    config.cut_capacity = CUTS;
    config.drag = draw(t, 0.0, 2.0);
    config.damping = draw(t, 0.0, 20.0);
    double curvature = draw(t, 0.0, 50.0);
    config.rest_curvature = vbss_random_below(&t->random, 2) == 0 ? 0.0 : curvature;
    must(t, vbss_thread_create(t->context, &config, &t->thread), "create");
    t->count = t->cuts = 0;
    t->lives++;
}

static void end_life(tug *t)
{
    vbss_thread_statistics s = {0};
    must(t, vbss_thread_get_statistics(t->thread, &s, sizeof s), "statistics");
    t->forced += s.forced;
    t->substeps += s.substeps;
    /* A state that was taken unconverged says so in its count. */
    t->worst_error = fmax(t->worst_error, s.forced == 0 ? s.stretch_error : 0.0);
    must(t, vbss_thread_destroy(t->thread), "destroy");
    for (uint32_t i = 0; i < t->cuts; i++) {
        must(t, vbss_thread_destroy(t->pieces[i]), "destroy a piece");
    }
}

/* ---- what hands do */

static void attach_one(tug *t)
{
    vbss_thread_attachment a;
    uint32_t id;
    must(t, vbss_thread_attachment_init(&a, sizeof a), "init");
    a.kind = (vbss_thread_attachment_kind)vbss_random_below(&t->random, 5);
    a.node = vbss_random_below(&t->random, t->segments + 1);
    t->at[t->count] = node_at(t, a.node);
    vec3_store(a.position, t->at[t->count]);
    vec3_store(a.direction, vbss_random_direction(&t->random));
    vec3_store(a.force, vec3_scale(vbss_random_direction(&t->random), 1e-4));
    a.stiffness = draw(t, 0.0, 50.0);
    a.damping = draw(t, 0.0, 0.01);
    a.mass = draw(t, 0.0, 1e-5);
    vbss_result result = vbss_thread_attach(t->thread, &a, &id);
    if (result == VBSS_OK) {
        t->moves[t->count] =
            a.kind != VBSS_THREAD_ATTACHMENT_MASS && a.kind != VBSS_THREAD_ATTACHMENT_FORCE;
        t->stores[t->count] =
            a.kind == VBSS_THREAD_ATTACHMENT_FORCE || a.kind == VBSS_THREAD_ATTACHMENT_SPRING;
        t->ids[t->count++] = id;
    } else if (result != VBSS_ERROR_OUT_OF_RANGE && result != VBSS_ERROR_IN_USE) {
        /* the node was neither cut off nor held already */
        must(t, result, "attach");
    }
}

static void detach(tug *t, uint32_t gone)
{
    (void)vbss_thread_detach(t->thread, t->ids[gone]); /* may have gone with a piece */
    t->count--;
    t->ids[gone] = t->ids[t->count];
    t->at[gone] = t->at[t->count];
    t->moves[gone] = t->moves[t->count];
    t->stores[gone] = t->stores[t->count];
}

static void detach_one(tug *t)
{
    detach(t, vbss_random_below(&t->random, t->count));
}

static void cut_one(tug *t)
{
    vbss_view rest;
    double length = 0.0, share = draw(t, 0.2, 0.9);
    must(t, vbss_thread_get_view(t->thread, VBSS_THREAD_VIEW_REST_LENGTHS, &rest, sizeof rest),
         "view");
    for (uint64_t i = 0; i < rest.count; i++) {
        length += ((const double *)rest.data)[i];
    }
    if (length > 0.01 &&
        vbss_thread_cut(t->thread, share * length, &t->pieces[t->cuts]) == VBSS_OK) {
        t->cuts++;
    }
}

static void move_all(tug *t, double h)
{
    for (uint32_t i = 0; i < t->count; i++) {
        vbss_thread_reaction r;
        double target[3];
        if (!t->moves[i] ||
            vbss_thread_get_reaction(t->thread, t->ids[i], &r, sizeof r) != VBSS_OK) {
            continue;
        }
        /* Hands give way before the thread is torn: 2 N pull them back. */
        double pull = vec3_norm(vec3_load(r.force));
        vec3 direction = vbss_random_direction(&t->random);
        /* Not further in a long step, or they would outrun what gives way. */
        t->at[i] = vec3_add_scaled(t->at[i], 0.3 * fmin(h, 1e-3), direction);
        if (pull > 2.0) {
            t->at[i] = vec3_add_scaled(t->at[i], -1e-4 / pull, vec3_load(r.force));
        }
        vec3_store(target, t->at[i]);
        must(t, vbss_thread_set_attachment_target(t->thread, t->ids[i], target, NULL), "move");
    }
}

/* ---- what must hold */

static void watch(tug *t)
{
    vbss_view v;
    vbss_thread_energies e = {0};
    must(t, vbss_thread_get_view(t->thread, VBSS_THREAD_VIEW_VELOCITIES, &v, sizeof v), "view");
    for (uint64_t i = 0; i < v.count; i++) {
        double speed = vec3_norm(((const vec3 *)v.data)[i]);
        t->fastest = fmax(t->fastest, speed);
        if (!(speed < 1e3)) {
            t->failures++;
            harness_soak_fail(t->soak, "life %llu: a node has %g m/s", (unsigned long long)t->lives,
                              speed);
            return;
        }
    }
    must(t, vbss_thread_get_energies(t->thread, &e, sizeof e), "energies");
    if (!isfinite(e.total)) {
        t->failures++;
        harness_soak_fail(t->soak, "life %llu: not finite", (unsigned long long)t->lives);
    }
}

/* The hands rest: in the end there is no more energy than at first. */
static void rest(tug *t)
{
    vbss_thread_energies first = {0}, last = {0};
    for (uint32_t i = t->count; i > 0; i--) {
        if (t->stores[i - 1]) {
            detach(t, i - 1);
        }
    }
    must(t, vbss_thread_get_energies(t->thread, &first, sizeof first), "energies");
    for (int i = 0; i < 100; i++) {
        must(t, vbss_thread_step(t->thread, 1e-3), "resting step");
    }
    must(t, vbss_thread_get_energies(t->thread, &last, sizeof last), "energies");
    double gain = last.total - first.total;
    double scale = first.kinetic + first.stretching + first.bending + 1e-6;
    t->worst_gain = fmax(t->worst_gain, gain / scale);
    if (!(gain <= 0.05 * scale)) {
        t->failures++;
        harness_soak_fail(t->soak, "life %llu: %g J became %g J at rest",
                          (unsigned long long)t->lives, first.total, last.total);
    }
}

static void run(harness_soak *soak)
{
    static const double sizes[] = {1e-3, 1e-3, 1e-3, 5e-4, 2e-3, 1e-4, 5e-3, 1e-2};
    tug t = {.soak = soak};
    uint32_t steps = soak->seed % 100 == 99 ? 1000000 : 100000;
    vbss_random_seed(&t.random, soak->seed, 5);
    must(&t, vbss_context_create(NULL, &t.context), "context");
    begin_life(&t);
    for (uint32_t i = 0; i < steps && t.failures < 20; i++) {
        uint32_t what = vbss_random_below(&t.random, 200);
        double h = sizes[vbss_random_below(&t.random, 8)];
        if (what < 4 && t.count < PLACES) {
            attach_one(&t);
        } else if (what < 7 && t.count > 0) {
            detach_one(&t);
        } else if (what == 7 && t.cuts < CUTS && vbss_random_below(&t.random, 4) == 0) {
            cut_one(&t);
        }
        move_all(&t, h);
        must(&t, vbss_thread_step(t.thread, h), "step");
        for (uint32_t k = 0; k < t.cuts; k++) {
            must(&t, vbss_thread_step(t.pieces[k], h), "step of a piece");
        }
        watch(&t);
        if (i % LIFE == LIFE - 1) {
            rest(&t);
            end_life(&t);
            begin_life(&t);
        }
    }
    end_life(&t);
    must(&t, vbss_context_destroy(t.context), "end");
    /* A violent moment forces all 32 parts of some steps; it must not last. */
    if (t.forced > t.substeps / 100) {
        harness_soak_fail(soak, "%llu of %llu parts forced", (unsigned long long)t.forced,
                          (unsigned long long)t.substeps);
    }
    if (!(t.worst_error <= 5e-6)) {
        harness_soak_fail(soak, "a stretch error of %g", t.worst_error);
    }
    harness_soak_figure(soak, "worst_error", t.worst_error);
    harness_soak_figure(soak, "fastest", t.fastest);
    harness_soak_figure(soak, "worst_gain", t.worst_gain);
    harness_soak_figure(soak, "forced_share", (double)t.forced / (double)(t.substeps + 1));
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
