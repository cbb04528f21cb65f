/* Feeds the metrics with the positions and forces of the tools, and with converted events. */
#include "base/error.h"
#include "session/session.h"

/* The kind of a session event in the metrics; 0: they have no such kind. */
static vbss_metrics_event_kind metrics_kind(const vbss_session_event *e)
{
    switch (e->kind) {
    case VBSS_SESSION_EVENT_APPEARED:
        return VBSS_METRICS_EVENT_NEEDLE_APPEARS;
    case VBSS_SESSION_EVENT_PHASE:
        return VBSS_METRICS_EVENT_PHASE;
    case VBSS_SESSION_EVENT_DROPPED:
        return VBSS_METRICS_EVENT_DROP;
    case VBSS_SESSION_EVENT_PUNCTURE:
        return VBSS_METRICS_EVENT_PUNCTURE;
    case VBSS_SESSION_EVENT_TAIL:
        return VBSS_METRICS_EVENT_TAIL;
    case VBSS_SESSION_EVENT_THROW:
        return VBSS_METRICS_EVENT_THROW;
    case VBSS_SESSION_EVENT_SEATED:
        return VBSS_METRICS_EVENT_GAP;
    case VBSS_SESSION_EVENT_TRANSFER:
        return VBSS_METRICS_EVENT_TRANSFER;
    case VBSS_SESSION_EVENT_TRANSFER_MISSED:
        return VBSS_METRICS_EVENT_TRANSFER_MISSED;
    case VBSS_SESSION_EVENT_CUT:
        return VBSS_METRICS_EVENT_TAIL_CUT;
    case VBSS_SESSION_EVENT_AID:
        return VBSS_METRICS_EVENT_ASSISTED;
    default:
        return 0;
    }
}

/* 0 for a timeout, which the metrics detect themselves. */
static vbss_metrics_event_kind metrics_kind_of_failure(uint32_t failure)
{
    switch (failure) {
    case VBSS_SESSION_FAILURE_AVULSED:
        return VBSS_METRICS_EVENT_AVULSED;
    case VBSS_SESSION_FAILURE_CUT_EARLY:
    case VBSS_SESSION_FAILURE_CUT_KNOT:
    case VBSS_SESSION_FAILURE_BROKEN:
        return VBSS_METRICS_EVENT_BROKEN;
    default:
        return 0;
    }
}

static void fill_metrics_event(const session_object *s, const session_observation *observed,
                               const vbss_session_event *e, vbss_metrics_event *m)
{
    m->tool = e->tool;
    m->number = e->number;
    m->undone = e->undone;
    m->wraps = e->wraps;
    m->handedness = e->handedness;
    m->relation = e->relation;
    m->step = e->step;
    m->time = e->time;
    m->amount = e->amount;
    for (int k = 0; k < 3; k++) {
        m->position[k] = e->position[k];
        m->force[k] = e->force[k];
    }
    if (e->kind == VBSS_SESSION_EVENT_PUNCTURE) {
        const session_hole *hole = &s->holes[e->number];
        m->amount = 0.0;
        m->angle = hole->angle;
        m->axial = hole->axial;
    } else if (e->kind == VBSS_SESSION_EVENT_PHASE) {
        m->undone = 0; /* the metrics accept no other value for phases */
    } else if (e->kind == VBSS_SESSION_EVENT_SEATED) {
        m->number = 0;
        m->amount = observed->max_gap;
        vec3_store(m->position, observed->lips[0]);
        vec3_store(m->other, observed->lips[1]);
    }
}

/* Whether the metrics get the event. A lost seat is left out: the next seat reports the gap. Of an aid,
 * only the first use counts. */
static bool is_for_metrics(const vbss_session_event *e, vbss_metrics_event_kind *kind)
{
    bool is_repeated = e->kind == VBSS_SESSION_EVENT_AID && e->amount == 0.0;
    *kind =
        e->kind == VBSS_SESSION_EVENT_FAILED ? metrics_kind_of_failure(e->number) : metrics_kind(e);
    return *kind != 0 && !is_repeated && !(e->kind == VBSS_SESSION_EVENT_SEATED && e->undone != 0);
}

static vbss_result feed_event(session_object *s, const session_observation *observed,
                              const vbss_session_event *e)
{
    vbss_metrics_event_kind kind;
    vbss_metrics_event m;
    if (!is_for_metrics(e, &kind)) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_metrics_event_init(&m, sizeof m));
    m.kind = kind;
    fill_metrics_event(s, observed, e, &m);
    return vbss_metrics_add_event(s->config.metrics, &m);
}

static vbss_result feed_sample(const session_object *s, const session_observation *observed)
{
    vbss_metrics_sample sample;
    VBSS_TRY(vbss_metrics_sample_init(&sample, sizeof sample));
    sample.valid = (uint32_t)(VBSS_METRICS_HAS_LEFT | VBSS_METRICS_HAS_RIGHT |
                              VBSS_METRICS_HAS_LEFT_FORCE | VBSS_METRICS_HAS_RIGHT_FORCE);
    sample.step = s->steps;
    sample.time = s->time;
    sample.time_lost = s->time_lost;
    for (int i = 0; i < SESSION_HANDS; i++) {
        vec3_store(sample.position[i], observed->tools[i].tip);
        vec3_store(sample.force[i], observed->tools[i].force);
    }
    return vbss_metrics_add_sample(s->config.metrics, &sample);
}

/* An event that the metrics refuse is counted, and the task continues. */
static vbss_result feed_events(session_object *s, const session_observation *observed)
{
    uint64_t capacity = s->config.event_capacity;
    for (uint64_t i = s->events_before_step; i < s->event_count; i++) {
        if (s->event_count - i > capacity) {
            continue;
        }
        vbss_result result = feed_event(s, observed, vbss_session_event_at(s, i));
        if (result == VBSS_ERROR_CAPACITY || result == VBSS_ERROR_OUT_OF_RANGE ||
            result == VBSS_ERROR_NOT_FOUND) {
            s->metrics_lost++;
        } else {
            VBSS_TRY(result);
        }
    }
    return VBSS_OK;
}

/* The step in which the task ends has events. It adds the last sample and finishes the metrics. */
vbss_result vbss_session_feed_metrics(session_object *s, const session_observation *observed)
{
    bool has_events = s->event_count > s->events_before_step;
    if (s->config.metrics == NULL || (vbss_session_is_over(s) && !has_events)) {
        return VBSS_OK;
    }
    if (!observed->has_lost_body) {
        VBSS_TRY(feed_sample(s, observed));
    }
    VBSS_TRY(feed_events(s, observed));
    return vbss_session_is_over(s) ? vbss_metrics_finish(s->config.metrics) : VBSS_OK;
}
