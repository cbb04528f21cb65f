/* Figures of motion in a window of ticks. */
#include "base/check.h"
#include "base/config.h"
#include "base/elementary.h"
#include "base/error.h"
#include "metrics/metrics.h"

_Static_assert(sizeof(vbss_metrics_motion) == 120, "published size");
_Static_assert(sizeof(vbss_metrics_bimanual) == 56, "published size");
static const uint32_t motion_sizes[] = {120, 0}, bimanual_sizes[] = {56, 0};
static const vbss_layout motion_layout = {"vbss_metrics_motion", NULL, motion_sizes};
static const vbss_layout bimanual_layout = {"vbss_metrics_bimanual", NULL, bimanual_sizes};

enum { SHORTEST_MOVEMENT = 20 }; /* ticks */

/* ---- windows: ticks from `begin` to before `end` */

typedef struct window {
    uint32_t begin, end;
} window;

static vbss_result find_window(const metrics_object *m, int32_t phase, window *w)
{
    uint64_t begin = 0, end = m->tick_capacity;
    if (phase != VBSS_METRICS_WHOLE && (phase < 0 || (uint32_t)phase >= m->phase_count)) {
        return vbss_fail(m->context, VBSS_ERROR_OUT_OF_RANGE, "phase %d of %u", phase,
                         m->phase_count);
    }
    const metrics_note *appeared = &m->facts[METRICS_APPEARED];
    if (phase >= 0) {
        begin = vbss_metrics_tick_of(m, m->phases[phase].begin);
    } else if (appeared->standing) {
        begin = vbss_metrics_tick_of(m, appeared->time);
    }
    if (phase >= 0 && (uint32_t)phase + 1 < m->phase_count) {
        end = vbss_metrics_tick_of(m, m->phases[phase + 1].begin);
    } else if (vbss_metrics_stopped(m)) {
        end = vbss_metrics_tick_of(m, vbss_metrics_stop_time(m));
    }
    w->begin = (uint32_t)begin;
    w->end = (uint32_t)(end > begin ? end : begin);
    return VBSS_OK;
}

static window cut(window w, uint32_t count)
{
    w.end = w.end < count ? w.end : count;
    w.begin = w.begin < w.end ? w.begin : w.end;
    return w;
}

/* ---- rest, with hysteresis; the first tick of a window is a rest if it is slow */

static bool rests(const vbss_metrics_config *c, double speed, bool rested)
{
    return speed < c->idle_speed || (rested && speed <= c->idle_release);
}

/* ---- one tool */

static void sum_up(const metrics_object *m, const metrics_hand *h, window w,
                   vbss_metrics_motion *out)
{
    double roughness = 0.0, length = 0.0;
    uint32_t seen = 0, idle = 0;
    bool rested = false;
    for (uint32_t i = w.begin; i < w.end; i++) {
        if (h->seen[i] == 0) {
            continue;
        }
        rested = rests(&m->config, h->speed[i], rested);
        seen++;
        idle += rested ? 1u : 0u;
        length += h->speed[i];
        roughness += h->jerk[i];
        out->peak_speed = vbss_max(out->peak_speed, h->speed[i]);
    }
    double t = out->time = seen * METRICS_TICK, peak = out->peak_speed;
    out->unseen_time = (w.end - w.begin - seen) * METRICS_TICK;
    out->path_length = length * METRICS_TICK;
    out->idle_time = idle * METRICS_TICK;
    if (seen == 0) {
        return;
    }
    out->mean_speed = length / seen;
    out->idle_share = (double)idle / seen;
    roughness *= METRICS_TICK;
    if (roughness > 0.0 && out->path_length > 0.0) {
        double whole = t * t * t * roughness, way = t / out->path_length;
        out->ldj_length = -vbss_log(whole * way * way);
        out->ldj_speed = -vbss_log(whole / (peak * peak));
        out->valid |= VBSS_METRICS_HAS_LDJ;
    }
}

/* Mean over what lies between rests and times of not being seen, if it is long enough to be a movement. */
static void add_movements(const metrics_object *m, const metrics_hand *h, window w,
                          vbss_metrics_motion *out)
{
    double sum = 0.0, sparc;
    uint32_t began = w.begin;
    bool rested = false;
    for (uint32_t i = w.begin; i <= w.end; i++) {
        bool moves = i < w.end && h->seen[i] != 0;
        rested = moves && rests(&m->config, h->speed[i], rested);
        if (moves && !rested) {
            continue;
        }
        uint32_t count = i - began;
        if (count >= SHORTEST_MOVEMENT && count <= METRICS_SPECTRUM_TICKS &&
            vbss_metrics_sparc(h->speed + began, count, m->spectrum, &sparc)) {
            sum += sparc;
            out->movement_count++;
        }
        began = i + 1;
    }
    if (out->movement_count > 0) {
        out->movement_sparc = sum / out->movement_count;
        out->valid |= VBSS_METRICS_HAS_MOVEMENTS;
    }
}

static void add_forces(const metrics_hand *h, window w, vbss_metrics_motion *out)
{
    for (uint32_t i = w.begin; i < w.end; i++) {
        out->force_integral += h->impulse[i];
        out->force_peak = vbss_max(out->force_peak, h->peak[i]);
    }
}

vbss_result vbss_metrics_get_motion(vbss_metrics *metrics, vbss_metrics_tool tool, int32_t phase,
                                    vbss_metrics_motion *motion, uint32_t struct_size)
{
    metrics_object *m;
    window all = {0, 0};
    vbss_metrics_motion own = {.struct_size = sizeof own};
    VBSS_TRY(vbss_metrics_open(metrics, &m));
    VBSS_TRY(vbss_check_arithmetic(m->context));
    VBSS_TRY(vbss_check_range(m->context, tool, VBSS_METRICS_LEFT, VBSS_METRICS_RIGHT, "tool"));
    VBSS_TRY(find_window(m, phase, &all));
    const metrics_hand *h = &m->hands[tool];
    window w = cut(all, h->tick_count);
    sum_up(m, h, w, &own);
    add_movements(m, h, w, &own);
    add_forces(h, cut(all, h->force_count), &own);
    uint32_t count = w.end - w.begin;
    if (count >= 2 && count <= METRICS_SPECTRUM_TICKS &&
        vbss_metrics_sparc(h->speed + w.begin, count, m->spectrum, &own.sparc)) {
        own.valid |= VBSS_METRICS_HAS_SPARC;
    }
    return vbss_struct_write(m->context, &motion_layout, &own, motion, struct_size);
}

/* ---- both tools */

/* In two passes: what is summed second is small where speeds hardly vary. */
static void correlate(const metrics_object *m, window w, uint32_t seen, vbss_metrics_bimanual *out)
{
    const metrics_hand *a = &m->hands[0], *b = &m->hands[1];
    double mean_a = 0.0, mean_b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
    for (uint32_t i = w.begin; i < w.end; i++) {
        bool both = a->seen[i] != 0 && b->seen[i] != 0;
        mean_a += both ? a->speed[i] / seen : 0.0;
        mean_b += both ? b->speed[i] / seen : 0.0;
    }
    for (uint32_t i = w.begin; i < w.end; i++) {
        if (a->seen[i] != 0 && b->seen[i] != 0) {
            double da = a->speed[i] - mean_a, db = b->speed[i] - mean_b;
            aa += da * da;
            bb += db * db;
            ab += da * db;
        }
    }
    if (aa > 0.0 && bb > 0.0) {
        out->correlation = vbss_max(-1.0, vbss_min(1.0, ab / (sqrt(aa) * sqrt(bb))));
        out->valid |= VBSS_METRICS_HAS_CORRELATION;
    }
}

static uint32_t share(const metrics_object *m, window w, vbss_metrics_bimanual *out)
{
    const metrics_hand *h = m->hands;
    uint32_t seen = 0, moving[METRICS_HANDS + 1] = {0, 0, 0};
    bool rested[METRICS_HANDS] = {false, false};
    for (uint32_t i = w.begin; i < w.end; i++) {
        uint32_t active = 0;
        for (int k = 0; k < METRICS_HANDS; k++) {
            rested[k] = rests(&m->config, h[k].speed[i], rested[k]);
            active += rested[k] ? 0u : 1u;
        }
        if (h[0].seen[i] != 0 && h[1].seen[i] != 0) {
            seen++;
            moving[active]++;
        }
    }
    out->time = seen * METRICS_TICK;
    out->still_time = moving[0] * METRICS_TICK;
    out->one_moving_time = moving[1] * METRICS_TICK;
    out->both_moving_time = moving[2] * METRICS_TICK;
    out->both_moving_share = seen > 0 ? (double)moving[2] / seen : 0.0;
    return seen;
}

vbss_result vbss_metrics_get_bimanual(vbss_metrics *metrics, int32_t phase,
                                      vbss_metrics_bimanual *bimanual, uint32_t struct_size)
{
    metrics_object *m;
    window w = {0, 0};
    vbss_metrics_bimanual own = {.struct_size = sizeof own};
    VBSS_TRY(vbss_metrics_open(metrics, &m));
    VBSS_TRY(vbss_check_arithmetic(m->context));
    VBSS_TRY(find_window(m, phase, &w));
    w = cut(cut(w, m->hands[0].tick_count), m->hands[1].tick_count);
    uint32_t seen = share(m, w, &own);
    correlate(m, w, seen, &own);
    return vbss_struct_write(m->context, &bimanual_layout, &own, bimanual, struct_size);
}
