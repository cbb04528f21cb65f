/* Samples of the tools, and the clock of all input. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/number_text.h"
#include "metrics/metrics.h"

_Static_assert(sizeof(vbss_metrics_sample) == 128, "published size");
static const vbss_metrics_sample defaults = {.struct_size = sizeof(vbss_metrics_sample)};
static const uint32_t sizes[] = {120, 128, 0};
static const vbss_layout layout = {"vbss_metrics_sample", &defaults, sizes};

vbss_result vbss_metrics_sample_init(vbss_metrics_sample *sample, uint32_t struct_size)
{
    return vbss_config_init(&layout, sample, struct_size);
}

/* ---- the clock */

vbss_result vbss_metrics_check_time(const metrics_object *m, double time)
{
    VBSS_TRY(
        vbss_check_range(m->context, time, -METRICS_LARGEST_TIME, METRICS_LARGEST_TIME, "time"));
    if (m->has_time && time < m->last_time) {
        return vbss_fail(m->context, VBSS_ERROR_OUT_OF_RANGE, "time is %s, after %s",
                         vbss_format_number(time, 9).text,
                         vbss_format_number(m->last_time, 9).text);
    }
    return VBSS_OK;
}

void vbss_metrics_advance_clock(metrics_object *m, double time, uint64_t step)
{
    m->has_time = 1;
    m->last_time = time;
    m->last_step = step;
    m->generation++;
}

/* ---- samples */

static const uint32_t position_flags[METRICS_HANDS] = {VBSS_METRICS_HAS_LEFT,
                                                       VBSS_METRICS_HAS_RIGHT};
static const uint32_t force_flags[METRICS_HANDS] = {VBSS_METRICS_HAS_LEFT_FORCE,
                                                    VBSS_METRICS_HAS_RIGHT_FORCE};

static vbss_result check_sample(const metrics_object *m, const vbss_metrics_sample *s)
{
    if (m->is_finished) {
        return vbss_fail(m->context, VBSS_ERROR_WRONG_STATE,
                         "a sample at %s: the measurement is finished",
                         vbss_format_number(s->time, 9).text);
    }
    VBSS_TRY(vbss_check_range(m->context, s->valid, 0.0, 15.0, "valid"));
    VBSS_TRY(vbss_metrics_check_time(m, s->time));
    if (m->has_sample && s->time <= m->sample_time) {
        return vbss_fail(
            m->context, VBSS_ERROR_OUT_OF_RANGE, "time of the sample is %s, that of the last is %s",
            vbss_format_number(s->time, 9).text, vbss_format_number(m->sample_time, 9).text);
    }
    VBSS_TRY(vbss_check_range(m->context, s->time_lost, m->time_lost, METRICS_LARGEST_TIME,
                              "time_lost"));
    for (int i = 0; i < METRICS_HANDS; i++) {
        if ((s->valid & position_flags[i]) != 0) {
            VBSS_TRY(vbss_check_vector(m->context, s->position[i], METRICS_LARGEST_POSITION,
                                       "position"));
        }
        if ((s->valid & force_flags[i]) != 0) {
            VBSS_TRY(vbss_check_vector(m->context, s->force[i], METRICS_LARGEST_FORCE, "force"));
        }
    }
    return VBSS_OK;
}

vbss_result vbss_metrics_add_sample(vbss_metrics *metrics, const vbss_metrics_sample *sample)
{
    VBSS_ENTER(metrics);
    metrics_object *m;
    vbss_metrics_sample s;
    VBSS_TRY(vbss_metrics_edit(metrics, &m));
    VBSS_TRY(vbss_config_read(m->context, &layout, sample, &s));
    VBSS_TRY(check_sample(m, &s));
    if (!m->has_sample) {
        m->has_sample = 1;
        m->origin_time = s.time;
    }
    for (uint32_t i = 0; i < METRICS_HANDS; i++) {
        if ((s.valid & position_flags[i]) != 0) {
            vbss_metrics_track_position(m, i, s.time, vec3_load(s.position[i]));
        }
        if ((s.valid & force_flags[i]) != 0) {
            vbss_metrics_track_force(m, i, s.time, vec3_norm(vec3_load(s.force[i])));
        }
    }
    m->samples++;
    m->sample_time = s.time;
    m->time_lost = s.time_lost;
    vbss_metrics_advance_clock(m, s.time, s.step);
    return VBSS_OK;
}

vbss_result vbss_metrics_finish(vbss_metrics *metrics)
{
    VBSS_ENTER(metrics);
    metrics_object *m;
    VBSS_TRY(vbss_metrics_edit(metrics, &m));
    if (m->is_finished) {
        return VBSS_OK;
    }
    for (uint32_t i = 0; i < METRICS_HANDS; i++) {
        vbss_metrics_finish_track(m, i);
    }
    m->is_finished = 1;
    m->generation++;
    return VBSS_OK;
}
