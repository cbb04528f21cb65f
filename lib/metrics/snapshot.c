/* Serialisation of a measurement. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/snapshot.h"
#include "base/stream.h"
#include "metrics/metrics.h"

/* Largest value whose sums and squares stay finite. */
#define LARGEST_FIGURE 1e30

static void refuse(vbss_stream *stream, bool wrong)
{
    if (wrong) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no measurement is like this");
    }
}

static void visit_flag(vbss_stream *stream, uint16_t tag, uint32_t *flag)
{
    vbss_stream_u32(stream, tag, flag, 1);
    refuse(stream, *flag > 1);
}

static void visit_bounded(vbss_stream *stream, uint16_t tag, double *values, size_t count,
                          double bound)
{
    vbss_stream_f64(stream, tag, values, count);
    refuse(stream, !(vbss_max_abs(values, count) <= bound));
}

static void visit_config(vbss_stream *stream, const vbss_metrics_config *c)
{
    const uint32_t words[] = {(uint32_t)c->tightness_test, c->throw_capacity, c->phase_capacity,
                              c->incident_capacity, c->throws_wanted};
    const double numbers[] = {c->duration,         c->drain_radius,     c->stiffness,
                              c->pull_force,       c->pull_time,        c->slip_limit,
                              c->strain_threshold, c->idle_speed,       c->idle_release,
                              c->max_time,         c->weight_deviation, c->weight_gap,
                              c->weight_tightness, c->weight_throw,     c->weight_granny,
                              c->weight_attempt,   c->weight_drop,      c->weight_transfer,
                              c->weight_host,      c->max_speed,        c->lost_share};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        vbss_stream_expect(stream, 1, words[i]);
    }
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 2, numbers[i]);
    }
}

/* ---- motion */

static void visit_figures(vbss_stream *stream, uint16_t tag, double *values, uint32_t count)
{
    visit_bounded(stream, tag, values, count, LARGEST_FIGURE);
    for (uint32_t i = 0; i < count; i++) {
        refuse(stream, values[i] < 0.0);
    }
}

static void visit_flag_bytes(vbss_stream *stream, uint16_t tag, uint8_t *seen, uint32_t count)
{
    vbss_stream_u8(stream, tag, seen, count);
    for (uint32_t i = 0; i < count; i++) {
        refuse(stream, seen[i] > 1);
    }
}

/* The fine samples after the last tick must be exactly those that the next tick waits for. */
static bool is_tick_count_consistent(const metrics_object *m, const metrics_hand *h)
{
    uint64_t known = (uint64_t)h->tick_count * METRICS_FINE_PER_TICK;
    if (h->run_start > h->next_fine || h->run_start > known) {
        return false;
    }
    return h->tick_count >= m->tick_capacity ? h->next_fine <= known + METRICS_KERNEL_HALF_WIDTH + 1
                                             : h->next_fine <= known + METRICS_KERNEL_HALF_WIDTH &&
                                                   h->next_fine + METRICS_FINE_PER_TICK > known;
}

static void visit_outlier(vbss_stream *stream, metrics_hand *h)
{
    visit_flag(stream, 19, &h->has_outlier);
    visit_bounded(stream, 28, &h->outlier_time, 1, METRICS_LARGEST_TIME);
    visit_bounded(stream, 29, &h->outlier.x, 3, METRICS_LARGEST_POSITION);
    vbss_stream_u64(stream, 32, &h->outlier_count, 1);
    vbss_stream_u32(stream, 33, &h->jump_count, 1);
    refuse(stream, h->has_outlier != 0 &&
                       (h->point_count == 0 || h->outlier_time <= h->time[h->point_count - 1]));
}

static void visit_hand(vbss_stream *stream, const metrics_object *m, metrics_hand *h)
{
    uint32_t capacity = (uint32_t)m->tick_capacity;
    vbss_stream_count(stream, 10, &h->point_count, 3);
    vbss_stream_count(stream, 11, &h->tick_count, capacity);
    vbss_stream_count(stream, 12, &h->force_count, capacity);
    if (stream->result != VBSS_OK) {
        return;
    }
    visit_bounded(stream, 13, h->time, 3, METRICS_LARGEST_TIME);
    for (uint32_t i = 1; i < h->point_count; i++) {
        refuse(stream, !(h->time[i] > h->time[i - 1]));
    }
    for (int i = 0; i < 3; i++) {
        visit_bounded(stream, 14, &h->position[i].x, 3, METRICS_LARGEST_POSITION);
    }
    vbss_stream_u64(stream, 15, &h->run_start, 1);
    vbss_stream_u64(stream, 16, &h->next_fine, 1);
    vbss_stream_count(stream, 17, &h->still_count, METRICS_RING_SIZE);
    for (int i = 0; i < METRICS_RING_SIZE; i++) {
        visit_bounded(stream, 18, &h->ring[i].x, 3, LARGEST_FIGURE);
    }
    visit_outlier(stream, h);
    visit_flag(stream, 20, &h->has_force);
    visit_bounded(stream, 21, &h->force_time, 1, METRICS_LARGEST_TIME);
    visit_figures(stream, 22, &h->force, 1);
    visit_figures(stream, 23, h->speed, h->tick_count);
    visit_figures(stream, 24, h->jerk, h->tick_count);
    visit_flag_bytes(stream, 25, h->seen, h->tick_count);
    visit_figures(stream, 26, h->impulse, h->force_count);
    visit_figures(stream, 27, h->peak, h->force_count);
    refuse(stream, h->point_count == 0 ? h->next_fine != 0 || h->tick_count != 0
                                       : !is_tick_count_consistent(m, h));
}

/* ---- events, phases and the pull test */

static void visit_entry(vbss_stream *stream, metrics_entry *n)
{
    int32_t words[] = {n->kind, n->tool, n->wraps, n->handedness, n->relation};
    double numbers[] = {n->time, n->undone_time, n->value[0], n->value[1], n->time_lost};
    vbss_stream_i32(stream, 40, words, sizeof words / sizeof words[0]);
    vbss_stream_u32(stream, 41, &n->number, 1);
    visit_flag(stream, 42, &n->is_active);
    vbss_stream_u64(stream, 43, &n->step, 1);
    visit_bounded(stream, 44, numbers, sizeof numbers / sizeof numbers[0], LARGEST_FIGURE);
    visit_bounded(stream, 45, &n->position.x, 3, METRICS_LARGEST_POSITION);
    visit_bounded(stream, 46, &n->force.x, 3, METRICS_LARGEST_FORCE);
    n->kind = words[0];
    n->tool = words[1];
    n->wraps = words[2];
    n->handedness = words[3];
    n->relation = words[4];
    n->time = numbers[0];
    n->undone_time = numbers[1];
    n->value[0] = numbers[2];
    n->value[1] = numbers[3];
    n->time_lost = numbers[4];
    refuse(stream, n->kind == VBSS_METRICS_EVENT_PUNCTURE && n->number > 1);
    refuse(stream, n->tool < VBSS_METRICS_TOOL_LEFT || n->tool > VBSS_METRICS_TOOL_NONE);
}

static void visit_events(vbss_stream *stream, metrics_object *m)
{
    vbss_stream_count(stream, 50, &m->throw_count, m->config.throw_capacity);
    vbss_stream_count(stream, 51, &m->incident_count, m->config.incident_capacity);
    vbss_stream_count(stream, 52, &m->phase_count, m->config.phase_capacity);
    if (stream->result != VBSS_OK) {
        return;
    }
    for (int i = 0; i < METRICS_FACT_COUNT; i++) {
        visit_entry(stream, &m->facts[i]);
    }
    for (uint32_t i = 0; i < m->throw_count; i++) {
        visit_entry(stream, &m->throws[i]);
    }
    for (uint32_t i = 0; i < m->incident_count; i++) {
        visit_entry(stream, &m->incidents[i]);
    }
    for (uint32_t i = 0; i < m->phase_count; i++) {
        metrics_phase *phase = &m->phases[i];
        vbss_stream_u32(stream, 53, &phase->number, 1);
        vbss_stream_u64(stream, 54, &phase->step, 1);
        visit_bounded(stream, 55, &phase->start_time, 1, METRICS_LARGEST_TIME);
        refuse(stream, i > 0 && phase->start_time < phase[-1].start_time);
    }
}

static void visit_pull(vbss_stream *stream, metrics_pull *p)
{
    uint32_t *const flags[] = {&p->has_readings, &p->is_tight,           &p->has_slipped,
                               &p->is_untied,    &p->has_reached_strain, &p->is_holding};
    double *const numbers[] = {&p->hold_start, &p->longest_hold, &p->strain, &p->drawn_in};
    for (size_t i = 0; i < sizeof flags / sizeof flags[0]; i++) {
        visit_flag(stream, 60, flags[i]);
    }
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        visit_bounded(stream, 61, numbers[i], 1, LARGEST_FIGURE);
    }
    visit_entry(stream, &p->last_change);
}

void vbss_metrics_serialise(vbss_stream *stream, void *object)
{
    metrics_object *m = object;
    if (stream->version < 2) {
        vbss_stream_refuse(stream, VBSS_ERROR_DATA_VERSION, "it is from before lost time");
        return;
    }
    visit_config(stream, &m->config);
    vbss_stream_u64(stream, 3, &m->samples, 1);
    visit_flag(stream, 4, &m->has_time);
    visit_flag(stream, 5, &m->has_sample);
    visit_flag(stream, 6, &m->is_finished);
    visit_bounded(stream, 7, &m->origin_time, 1, METRICS_LARGEST_TIME);
    visit_bounded(stream, 8, &m->sample_time, 1, METRICS_LARGEST_TIME);
    visit_bounded(stream, 9, &m->last_time, 1, METRICS_LARGEST_TIME);
    visit_bounded(stream, 31, &m->time_lost, 1, METRICS_LARGEST_TIME);
    vbss_stream_u64(stream, 30, &m->last_step, 1);
    for (int i = 0; i < METRICS_HANDS; i++) {
        visit_hand(stream, m, &m->hands[i]);
    }
    visit_events(stream, m);
    visit_pull(stream, &m->pull);
    if (stream->mode == VBSS_STREAM_READ) {
        m->generation++;
    }
}

/* ---- public functions */

vbss_result vbss_metrics_save(vbss_metrics *metrics, uint8_t *bytes, uint64_t capacity,
                              uint64_t *written)
{
    VBSS_ENTER(metrics);
    return vbss_object_save(metrics, &vbss_metrics_kind, bytes, capacity, written);
}

vbss_result vbss_metrics_restore(vbss_metrics *metrics, const uint8_t *bytes, uint64_t count)
{
    VBSS_ENTER(metrics);
    return vbss_object_restore(metrics, &vbss_metrics_kind, bytes, count);
}

vbss_result vbss_metrics_get_hash(vbss_metrics *metrics, uint64_t *hash)
{
    VBSS_ENTER(metrics);
    return vbss_object_hash(metrics, &vbss_metrics_kind, hash);
}
