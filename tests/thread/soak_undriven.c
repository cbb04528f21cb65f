/* Threads that nothing drives: free, pinned or clamped, without gravity and drag, set into some smooth
 * motion. What they gain after the start-up they took from the integration. A seed is 20 random scenes,
 * once with the default spectral radius, which must hold, and once with 0.5, which is reported. */
#include <math.h>

#include "base/elementary.h"
#include "harness/harness.h"

enum { SCENES = 20, STEPS = 1000, START = 5, MAX_NODES = 111 };

/* At most this share of the energy after the start-up may come back after it was lost. */
#define MAX_GAIN 0.5

typedef struct scene {
    vbss_thread_config config;
    double h, x[3 * MAX_NODES], v[3 * MAX_NODES];
    uint32_t held[2], holders; /* nodes; the first one clamped if `clamped` */
    bool clamped;
} scene;

static double between(vbss_random *random, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(random);
}

/* Evenly in the logarithm. */
static double about(vbss_random *random, double low, double high)
{
    return vbss_exp(between(random, vbss_log(low), vbss_log(high)));
}

static void draw_motion(vbss_random *random, scene *s)
{
    uint32_t nodes = s->config.segment_count + 1, kind = vbss_random_below(random, 3);
    double l = s->config.length / s->config.segment_count;
    double amplitude = between(random, 0.0, 0.7), phase = between(random, -1.0, 1.0);
    double speed = about(random, 1e-2, 1.0), waves = between(random, 1.0, 4.0);
    uint32_t turns = vbss_random_below(random, 3);
    vec3 x = vec3_zero();
    for (uint32_t i = 0; i < nodes; i++) {
        double u = i / (nodes - 1.0), angle = amplitude * vbss_sin(6.3 * turns * u + phase);
        vec3 v = vec3_make(0.0, 0.0, speed * vbss_sin(3.1416 * waves * u));
        if (kind == 1) {
            v = vec3_scale(vec3_make(-x.y, x.x, 0.0), speed / s->config.length);
        } else if (kind == 2) {
            v = vec3_make(0.0, speed * u * (1.0 - u), speed * u * u);
        }
        vec3_store(s->x + 3 * (size_t)i, x);
        vec3_store(s->v + 3 * (size_t)i, v);
        x = vec3_add(x, vec3_make(l * vbss_cos(angle), l * vbss_sin(angle), 0.0));
    }
}

/* Silk, each of its numbers up to ten times larger or smaller. */
static void draw_scene(vbss_random *random, scene *s)
{
    vbss_thread_config *c = &s->config;
    (void)vbss_thread_config_init(c, sizeof *c);
    (void)vbss_thread_config_preset(c, VBSS_THREAD_PRESET_SILK_2_0);
    c->bending = (vbss_thread_bending)vbss_random_below(random, 2);
    c->segment_count = 10 + vbss_random_below(random, 100);
    c->length = between(random, 0.1, 0.3);
    c->linear_density *= about(random, 0.1, 10.0);
    c->axial_stiffness *= about(random, 0.1, 10.0);
    c->bending_stiffness *= about(random, 0.1, 10.0);
    c->gravity[1] = 0.0;
    s->h = about(random, 2e-4, 1e-2);
    draw_motion(random, s);
    s->holders = vbss_random_below(random, 3);
    s->clamped = vbss_random_below(random, 2) != 0;
    s->held[0] = 0;
    s->held[1] = c->segment_count - vbss_random_below(random, c->segment_count / 2);
}

static bool hold(vbss_thread *thread, const scene *s, uint32_t which)
{
    vbss_thread_attachment a;
    uint32_t id, node = s->held[which];
    (void)vbss_thread_attachment_init(&a, sizeof a);
    a.kind = which == 0 && s->clamped ? VBSS_THREAD_ATTACHMENT_CLAMP : VBSS_THREAD_ATTACHMENT_PIN;
    a.node = node;
    for (size_t c = 0; c < 3; c++) {
        a.position[c] = s->x[3 * (size_t)node + c];
        a.direction[c] = s->x[3 + c] - s->x[c];
    }
    return vbss_thread_attach(thread, &a, &id) == VBSS_OK;
}

static double energy_of(vbss_thread *thread)
{
    vbss_thread_energies e = {0};
    (void)vbss_thread_get_energies(thread, &e, sizeof e);
    return e.total;
}

/* The largest rise of the energy above an earlier value, over the energy after the start-up; negative:
 * something failed. */
static double gain_of(vbss_context *context, scene *s, double spectral_radius)
{
    vbss_thread *thread;
    s->config.positions = s->x;
    s->config.spectral_radius = spectral_radius;
    if (vbss_thread_create(context, &s->config, &thread) != VBSS_OK) {
        return -1.0;
    }
    bool well = vbss_thread_set_state(thread, NULL, s->v, s->config.segment_count + 1) == VBSS_OK;
    for (uint32_t k = 0; k < s->holders; k++) {
        well = well && hold(thread, s, k);
    }
    double smallest = 0.0, began = 0.0, gain = 0.0;
    for (int i = 1; well && i <= STEPS; i++) {
        well = vbss_thread_step(thread, s->h) == VBSS_OK;
        double now = energy_of(thread);
        if (i == START) {
            smallest = began = now;
        } else if (i > START) {
            gain = fmax(gain, now - smallest);
            smallest = fmin(smallest, now);
        }
    }
    (void)vbss_thread_destroy(thread);
    return well && isfinite(gain) ? gain / began : -1.0;
}

static void run(harness_soak *soak)
{
    static scene s;
    vbss_random random;
    vbss_context *context;
    double by_default = 0.0, at_half = 0.0;
    vbss_random_seed(&random, soak->seed, 11);
    if (vbss_context_create(NULL, &context) != VBSS_OK) {
        harness_soak_fail(soak, "no context");
        return;
    }
    for (int k = 0; k < SCENES; k++) {
        draw_scene(&random, &s);
        double wanted = s.config.spectral_radius;
        double gain = gain_of(context, &s, wanted), half = gain_of(context, &s, 0.5);
        if (!(gain >= 0.0 && half >= 0.0 && gain <= MAX_GAIN)) {
            harness_soak_fail(soak, "scene %d: gains %g of its energy, %g at 0.5", k, gain, half);
        }
        by_default = fmax(by_default, gain);
        at_half = fmax(at_half, half);
    }
    (void)vbss_context_destroy(context);
    harness_soak_figure(soak, "worst_gain", by_default);
    harness_soak_figure(soak, "worst_gain_at_half", at_half);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
