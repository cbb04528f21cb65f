/* Metrics of motion in a window of ticks. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/elementary.h"
#include "base/error.h"
#include "metrics/metrics.h"
#include "metrics/tuning.h"

_Static_assert(sizeof(vbss_metrics_motion) == 120, "published size");
_Static_assert(sizeof(vbss_metrics_bimanual) == 56, "published size");
static const uint32_t motion_sizes[] = {120, 0}, bimanual_sizes[] = {56, 0};
static const vbss_layout motion_layout = {"vbss_metrics_motion", NULL, motion_sizes};
static const vbss_layout bimanual_layout = {"vbss_metrics_bimanual", NULL, bimanual_sizes};

/* ---- windows of ticks; `end` is exclusive */

typedef struct tick_window {
    uint32_t begin, end;
} tick_window;

static vbss_result find_window(const metrics_object *m, int32_t phase, tick_window *w)
{
    uint64_t begin = 0, end = m->tick_capacity;
    if (phase != VBSS_METRICS_PHASE_ALL && (phase < 0 || (uint32_t)phase >= m->phase_count)) {
        return vbss_fail(m->context, VBSS_ERROR_NOT_FOUND, "phase %d of %u", phase, m->phase_count);
    }
    const metrics_entry *appeared = &m->facts[METRICS_APPEARED];
    if (phase >= 0) {
        begin = vbss_metrics_tick_from(m, m->phases[phase].start_time);
    } else if (appeared->is_active) {
        begin = vbss_metrics_tick_from(m, appeared->time);
    }
    if (phase >= 0 && (uint32_t)phase + 1 < m->phase_count) {
        end = vbss_metrics_tick_from(m, m->phases[phase + 1].start_time);
    } else if (vbss_metrics_is_stopped(m)) {
        end = vbss_metrics_tick_from(m, vbss_metrics_stop_time(m));
    }
    w->begin = (uint32_t)begin;
    w->end = (uint32_t)(end > begin ? end : begin);
    return VBSS_OK;
}

static tick_window clip_window(tick_window w, uint32_t count)
{
    w.end = w.end < count ? w.end : count;
    w.begin = w.begin < w.end ? w.begin : w.end;
    return w;
}

/* Integrals are sums by the trapezoidal rule over the intervals between ticks. An interval belongs
 * to the window of its first tick; it was seen if both ticks were. */
static uint32_t interval_count(const metrics_hand *h, tick_window w)
{
    return w.end > w.begin && w.end == h->tick_count ? w.end - w.begin - 1 : w.end - w.begin;
}

static bool is_interval_seen(const metrics_hand *h, uint32_t tick)
{
    return tick + 1 < h->tick_count && h->seen[tick] != 0 && h->seen[tick + 1] != 0;
}

/* ---- rest, with hysteresis; a window starts at rest if its first tick is slow */

static bool is_resting(const vbss_metrics_config *c, double speed, bool is_rested)
{
    return speed < c->idle_speed || (is_rested && speed <= c->idle_release);
}

/* ---- one tool */

static void add_kinematics(const metrics_object *m, const metrics_hand *h, tick_window w,
                           vbss_metrics_motion *out)
{
    double roughness = 0.0, length = 0.0;
    uint32_t seen = 0, idle = 0;
    bool is_rested = false;
    for (uint32_t i = w.begin; i < w.end; i++) {
        if (h->seen[i] == 0) {
            continue;
        }
        is_rested = is_resting(&m->config, h->speed[i], is_rested);
        out->peak_speed = vbss_max(out->peak_speed, h->speed[i]);
        if (is_interval_seen(h, i)) {
            seen++;
            idle += is_rested ? 1u : 0u;
            length += 0.5 * (h->speed[i] + h->speed[i + 1]);
            roughness += 0.5 * (h->jerk[i] + h->jerk[i + 1]);
        }
    }
    double t = out->time = seen * METRICS_TICK_SECONDS, peak = out->peak_speed;
    out->unseen_time = (interval_count(h, w) - seen) * METRICS_TICK_SECONDS;
    out->path_length = length * METRICS_TICK_SECONDS;
    out->idle_time = idle * METRICS_TICK_SECONDS;
    if (seen == 0) {
        return;
    }
    out->mean_speed = length / seen;
    out->idle_share = (double)idle / seen;
    roughness *= METRICS_TICK_SECONDS;
    if (roughness > 0.0 && out->path_length > 0.0) {
        double dimensionless = t * t * t * roughness, slowness = t / out->path_length;
        out->ldj_length = -vbss_log(dimensionless * slowness * slowness);
        out->ldj_speed = -vbss_log(dimensionless / (peak * peak));
        out->valid |= VBSS_METRICS_HAS_LDJ;
    }
}

/* Mean SPARC of the movements: intervals between rests and gaps in tracking that are long
 * enough. */
static void add_movements(const metrics_object *m, const metrics_hand *h, tick_window w,
                          vbss_metrics_motion *out)
{
    double sum = 0.0, sparc;
    uint32_t start = w.begin;
    bool is_rested = false;
    for (uint32_t i = w.begin; i <= w.end; i++) {
        bool is_moving = i < w.end && h->seen[i] != 0;
        is_rested = is_moving && is_resting(&m->config, h->speed[i], is_rested);
        if (is_moving && !is_rested) {
            continue;
        }
        uint32_t count = i - start;
        if (count >= METRICS_SHORTEST_MOVEMENT && count <= METRICS_SPECTRUM_TICKS &&
            vbss_metrics_sparc(h->speed + start, count, m->spectrum_buffer, &sparc)) {
            sum += sparc;
            out->movement_count++;
        }
        start = i + 1;
    }
    if (out->movement_count > 0) {
        out->movement_sparc = sum / out->movement_count;
        out->valid |= VBSS_METRICS_HAS_MOVEMENTS;
    }
}

static void add_forces(const metrics_hand *h, tick_window w, vbss_metrics_motion *out)
{
    for (uint32_t i = w.begin; i < w.end; i++) {
        out->force_integral += h->impulse[i];
        out->force_peak = vbss_max(out->force_peak, h->peak[i]);
    }
}

vbss_result vbss_metrics_get_motion(vbss_metrics *metrics, vbss_metrics_tool tool, int32_t phase,
                                    vbss_metrics_motion *motion, uint32_t struct_size)
{
    VBSS_ENTER(metrics);
    metrics_object *m;
    tick_window all = {0, 0};
    vbss_metrics_motion own = {.struct_size = sizeof own};
    VBSS_TRY(vbss_metrics_open(metrics, &m));
    VBSS_TRY(vbss_check_range(m->context, tool, VBSS_METRICS_TOOL_LEFT, VBSS_METRICS_TOOL_RIGHT,
                              "tool"));
    VBSS_TRY(find_window(m, phase, &all));
    const metrics_hand *h = &m->hands[tool];
    tick_window w = clip_window(all, h->tick_count);
    add_kinematics(m, h, w, &own);
    add_movements(m, h, w, &own);
    add_forces(h, clip_window(all, h->force_count), &own);
    uint32_t count = w.end - w.begin;
    if (count >= 2 && count <= METRICS_SPECTRUM_TICKS &&
        vbss_metrics_sparc(h->speed + w.begin, count, m->spectrum_buffer, &own.sparc)) {
        own.valid |= VBSS_METRICS_HAS_SPARC;
    }
    return vbss_struct_write(m->context, &motion_layout, &own, motion, struct_size);
}

/* ---- both tools */

static bool are_both_seen(const metrics_object *m, uint32_t tick)
{
    return is_interval_seen(&m->hands[0], tick) && is_interval_seen(&m->hands[1], tick);
}

/* Two passes, which lose no digits where speeds hardly vary. */
static void correlate(const metrics_object *m, tick_window w, uint32_t seen,
                      vbss_metrics_bimanual *out)
{
    const metrics_hand *a = &m->hands[0], *b = &m->hands[1];
    double mean_a = 0.0, mean_b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
    for (uint32_t i = w.begin; i < w.end; i++) {
        bool both = are_both_seen(m, i);
        mean_a += both ? a->speed[i] / seen : 0.0;
        mean_b += both ? b->speed[i] / seen : 0.0;
    }
    for (uint32_t i = w.begin; i < w.end; i++) {
        if (are_both_seen(m, i)) {
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

static uint32_t add_activity(const metrics_object *m, tick_window w, vbss_metrics_bimanual *out)
{
    const metrics_hand *h = m->hands;
    uint32_t seen = 0, moving[METRICS_HANDS + 1] = {0, 0, 0};
    bool is_rested[METRICS_HANDS] = {false, false};
    for (uint32_t i = w.begin; i < w.end; i++) {
        uint32_t active = 0;
        for (int k = 0; k < METRICS_HANDS; k++) {
            is_rested[k] = is_resting(&m->config, h[k].speed[i], is_rested[k]);
            active += is_rested[k] ? 0u : 1u;
        }
        if (are_both_seen(m, i)) {
            seen++;
            moving[active]++;
        }
    }
    out->time = seen * METRICS_TICK_SECONDS;
    out->still_time = moving[0] * METRICS_TICK_SECONDS;
    out->one_moving_time = moving[1] * METRICS_TICK_SECONDS;
    out->both_moving_time = moving[2] * METRICS_TICK_SECONDS;
    out->both_moving_share = seen > 0 ? (double)moving[2] / seen : 0.0;
    return seen;
}

vbss_result vbss_metrics_get_bimanual(vbss_metrics *metrics, int32_t phase,
                                      vbss_metrics_bimanual *bimanual, uint32_t struct_size)
{
    VBSS_ENTER(metrics);
    metrics_object *m;
    tick_window w = {0, 0};
    vbss_metrics_bimanual own = {.struct_size = sizeof own};
    VBSS_TRY(vbss_metrics_open(metrics, &m));
    VBSS_TRY(find_window(m, phase, &w));
    w = clip_window(clip_window(w, m->hands[0].tick_count), m->hands[1].tick_count);
    uint32_t seen = add_activity(m, w, &own);
    correlate(m, w, seen, &own);
    return vbss_struct_write(m->context, &bimanual_layout, &own, bimanual, struct_size);
}
