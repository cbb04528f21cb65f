/* How evenly a hand that rests, or draws evenly, feels what it should: a taut thread in the jaws, a cylinder under
 * the tip, a thread that slips through. Timed is a step. */
#include <stdio.h>

#include "base/error.h"
#include "bench_device.h"
#include "tool_rig.h"

enum { AT_REST = 2000, SAMPLES = 1000 };
static const double draw_speed = 2e-3; /* m/s */

typedef enum tool_rest_kind { TAUT, PRESSED, SLIPPING, KINDS } tool_rest_kind;

typedef struct tool_rest {
    char name[64];
    tool_rest_kind kind;
    tool_rig rig;
    vec3 home, mean;
    double rms, peak_to_peak; /* N */
} tool_rest;

/* Where the hand is so many steps after it has settled or begun to draw. */
static vec3 hand_at(const tool_rest *s, uint32_t step)
{
    double travel = s->kind == SLIPPING ? draw_speed * step / TOOL_RIG_ROUND : 0.0;
    return vec3_add(s->home, vec3_make(0.0, travel, 0.0));
}

/* The taut thread is drawn aside by 4 mm; the one that slips has a free end. */
static vbss_result make(tool_rest *s)
{
    tool_rig *r = &s->rig;
    if (s->kind == PRESSED) {
        VBSS_TRY(tool_rig_begin(r));
        double stiffness = r->config.stiffness, damping = r->config.damping;
        tool_rig_end(r);
        return tool_rig_meet(r, TOOL_WALL_BELOW, stiffness, damping, &s->home);
    }
    vec3 tip = vec3_make(0.0, s->kind == SLIPPING ? -8e-3 : 0.0, -2e-3);
    VBSS_TRY(tool_rig_begin(r));
    r->config.closing_force = s->kind == SLIPPING ? 1.0 : r->config.closing_force;
    VBSS_TRY(tool_rig_thread(r, 60, s->kind == TAUT ? TOOL_RIG_BOTH : TOOL_RIG_FIRST));
    VBSS_TRY(tool_rig_add(r, tip));
    VBSS_TRY(tool_rig_close(r));
    s->home = s->kind == TAUT ? vec3_add(tip, vec3_make(4e-3, 0.0, 0.0)) : tip;
    for (int i = 1; i <= 100; i++) {
        VBSS_TRY(tool_rig_step_to(r, 0, vec3_lerp(tip, s->home, i / 100.0)));
    }
    return VBSS_OK;
}

static vbss_result relax(tool_rest *s)
{
    for (uint32_t i = 1; i <= AT_REST; i++) {
        VBSS_TRY(tool_rig_step_to(&s->rig, 0, hand_at(s, i)));
    }
    return tool_rig_save(&s->rig);
}

static vbss_result measure(tool_rest *s)
{
    static vec3 force[SAMPLES]; /* minus the first, so that the mean of equal forces is exact */
    vec3 low = vec3_zero(), high = low, mean = low, first = low;
    double sum = 0.0;
    for (uint32_t i = 0; i < SAMPLES; i++) {
        VBSS_TRY(tool_rig_step_to(&s->rig, 0, hand_at(s, AT_REST + 1 + i)));
        VBSS_TRY(tool_rig_force(&s->rig, 0, &force[i]));
        first = i == 0 ? force[0] : first;
        force[i] = vec3_sub(force[i], first);
        mean = vec3_add_scaled(mean, 1.0 / SAMPLES, force[i]);
    }
    for (int i = 0; i < SAMPLES; i++) {
        vec3 f = force[i];
        sum += vec3_norm_squared(vec3_sub(f, mean));
        low = vec3_make(vbss_min(low.x, f.x), vbss_min(low.y, f.y), vbss_min(low.z, f.z));
        high = vec3_make(vbss_max(high.x, f.x), vbss_max(high.y, f.y), vbss_max(high.z, f.z));
    }
    vec3 range = vec3_sub(high, low);
    s->mean = vec3_add(first, mean);
    s->rms = sqrt(sum / SAMPLES);
    s->peak_to_peak = vbss_max(range.x, vbss_max(range.y, range.z));
    return VBSS_OK;
}

static int setup(void *user)
{
    tool_rest *s = user;
    vbss_result result = make(s);
    result = result == VBSS_OK ? relax(s) : result;
    result = result == VBSS_OK ? measure(s) : result;
    if (result != VBSS_OK) {
        tool_rig_end(&s->rig);
    }
    return result;
}

static int restore(void *user)
{
    tool_rest *s = user;
    return tool_rig_restore(&s->rig);
}

static int step(void *user, uint32_t index)
{
    tool_rest *s = user;
    return tool_rig_step_to(&s->rig, 0, hand_at(s, AT_REST + 1 + index));
}

static uint64_t hash(void *user)
{
    const tool_rest *s = user;
    return tool_rig_hash(&s->rig);
}

static void finish(void *user, bench_result *result)
{
    const tool_rest *s = user;
    bench_counter(result, "mean_N", vec3_norm(s->mean));
    bench_counter(result, "rms_N", s->rms);
    bench_counter(result, "peak_to_peak_N", s->peak_to_peak);
}

static void teardown(void *user)
{
    tool_rest *s = user;
    tool_rig_end(&s->rig);
}

void add_tool_rest_cases(bench *b)
{
    static const char *const names[KINDS] = {"thread-taut", "pressed-on-cylinder",
                                             "thread-slipping"};
    static tool_rest cases[KINDS];
    for (int kind = 0; kind < KINDS; kind++) {
        tool_rest *s = &cases[kind];
        s->kind = (tool_rest_kind)kind;
        snprintf(s->name, sizeof s->name, "device/tool-rest/%s", names[kind]);
        const bench_stepped stepped = {.name = s->name,
                                       .user = s,
                                       .steps = 300,
                                       .dt_us = 1e3,
                                       .setup = setup,
                                       .restore = restore,
                                       .step = step,
                                       .hash = hash,
                                       .finish = finish,
                                       .teardown = teardown};
        bench_add_stepped(b, &stepped);
    }
}
