/* Feeds what is known to the library's metrics, in the order of time. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "report/facts.h"

typedef struct feeder {
    facts *f;
    vbss_metrics *metrics;
    size_t event, reading, phase, puncture; /* next ones */
    uint32_t cuts, throws;
    int needle_side;
    double last; /* time of the last sample */
} feeder;

/* Beyond the room for it something is not counted; nothing else may be refused. */
static vbss_result feed_event(feeder *d, const vbss_metrics_event *e)
{
    vbss_result result = vbss_metrics_add_event(d->metrics, e);
    return result == VBSS_ERROR_CAPACITY ? VBSS_OK : result;
}

static vbss_metrics_event event_of(vbss_metrics_event_kind kind, uint64_t step, double time)
{
    vbss_metrics_event e;
    (void)vbss_metrics_event_init(&e, sizeof e);
    e.kind = kind;
    e.step = step;
    e.time = time;
    return e;
}

/* ---- what happened in the steps up to one */

static vbss_result report_phases(feeder *d, const moment *m)
{
    const facts *f = d->f;
    for (; d->phase < f->phase_count && f->phases[d->phase].from < m->time; d->phase++) {
        vbss_metrics_event e =
            event_of(VBSS_METRICS_EVENT_PHASE, f->phases[d->phase].step, d->last);
        e.number = (uint32_t)d->phase;
        TRY(feed_event(d, &e));
    }
    return VBSS_OK;
}

static vbss_result report_transfer(feeder *d, const happening *h)
{
    const facts *f = d->f;
    for (int side = 0; side < SIDES; side++) {
        if (h->second != f->tools[side] || h->first != f->again.needle) {
            continue;
        }
        if (d->needle_side >= 0 && d->needle_side != side) {
            vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_TRANSFER, h->step, h->time);
            e.tool = side;
            TRY(feed_event(d, &e));
        }
        d->needle_side = side;
    }
    return VBSS_OK;
}

static vbss_result report_events(feeder *d, uint64_t step)
{
    const facts *f = d->f;
    for (; d->event < f->event_count && f->events[d->event].step <= step; d->event++) {
        const happening *h = &f->events[d->event];
        if (h->kind == VBSS_SCENE_EVENT_GRASP && f->again.needle != 0) {
            TRY(report_transfer(d, h));
        } else if (h->kind == VBSS_SCENE_EVENT_CUT && h->second != 0 && d->cuts < 2) {
            vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_TAIL_CUT, h->step, h->time);
            e.number = d->cuts++;
            TRY(feed_event(d, &e));
        }
    }
    return VBSS_OK;
}

/* Told when all is known of them, as one that is withdrawn is told twice. */
static vbss_result report_punctures(feeder *d, uint64_t step, double time)
{
    const again *a = &d->f->again;
    for (; d->puncture < a->puncture_count && a->punctures[d->puncture].step <= step;
         d->puncture++) {
        const puncture *p = &a->punctures[d->puncture];
        vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_PUNCTURE, p->step, time);
        e.number = (uint32_t)p->mark;
        e.angle = p->angle;
        e.axial = p->axial;
        memcpy(e.force, p->force, sizeof e.force);
        TRY(feed_event(d, &e));
        if (p->withdrawn) {
            e.undone = 1;
            TRY(feed_event(d, &e));
        }
    }
    return VBSS_OK;
}

static vbss_result report_throws(feeder *d, uint64_t step)
{
    const again *a = &d->f->again;
    for (; d->reading < a->reading_count && a->readings[d->reading].step <= step; d->reading++) {
        const reading *r = &a->readings[d->reading];
        for (; d->throws > r->state.throw_count; d->throws--) {
            vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_THROW, r->step, r->time);
            e.number = d->throws - 1;
            e.undone = 1;
            TRY(feed_event(d, &e));
        }
        for (uint32_t i = 0; i < r->state.throw_count && i < MAX_THROWS; i++) {
            vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_THROW, r->step, r->time);
            bool granny = (r->throws[i].flags & VBSS_KNOT_THROW_GRANNY) != 0;
            e.number = i;
            e.wraps = r->throws[i].wraps;
            e.handedness = r->throws[i].handedness;
            e.relation = i == 0   ? VBSS_METRICS_RELATION_FIRST
                         : granny ? VBSS_METRICS_RELATION_GRANNY
                                  : VBSS_METRICS_RELATION_SQUARE;
            TRY(feed_event(d, &e));
            d->throws = d->throws > i + 1 ? d->throws : i + 1;
        }
    }
    return VBSS_OK;
}

/* ---- a step */

static bool is_place(const double *x)
{
    return fabs(x[0]) <= 1e3 && fabs(x[1]) <= 1e3 &&
           fabs(x[2]) <= 1e3; /* false for what is no number */
}

static vbss_result report_sample(feeder *d, uint64_t step, const moment *m)
{
    static const uint32_t places[SIDES] = {VBSS_METRICS_HAS_LEFT, VBSS_METRICS_HAS_RIGHT};
    static const uint32_t forces[SIDES] = {VBSS_METRICS_HAS_LEFT_FORCE,
                                           VBSS_METRICS_HAS_RIGHT_FORCE};
    const again *a = &d->f->again;
    vbss_metrics_sample s;
    (void)vbss_metrics_sample_init(&s, sizeof s);
    s.step = step;
    s.time = m->time;
    s.time_lost = m->lost;
    for (int side = 0; side < SIDES; side++) {
        if (m->reported[side] && is_place(m->at[side])) {
            s.valid |= places[side];
            memcpy(s.position[side], m->at[side], sizeof s.position[side]);
        }
        if (d->f->tools[side] != 0 && step <= a->count) {
            s.valid |= forces[side];
            memcpy(s.force[side], a->steps[step - 1].pulls[side], sizeof s.force[side]);
        }
    }
    return vbss_metrics_add_sample(d->metrics, &s);
}

static vbss_result feed(feeder *d)
{
    const facts *f = d->f;
    vbss_metrics_event appears = event_of(VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 0.0);
    TRY(feed_event(d, &appears));
    for (uint64_t step = 1; step <= f->steps; step++) {
        const moment *m = &f->moments[step - 1];
        if (!(m->time > d->last)) { /* a log may say anything */
            continue;
        }
        TRY(report_phases(d, m));
        TRY(report_sample(d, step, m));
        d->last = m->time;
        TRY(report_events(d, step));
        TRY(report_punctures(d, step, m->time));
        TRY(report_throws(d, step));
    }
    if (f->again.count > 0 && f->again.steps[f->again.count - 1].gap >= 0.0) {
        const again_step *end = &f->again.steps[f->again.count - 1];
        vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_GAP, f->again.count, d->last);
        e.other[0] = end->gap; /* only how far the two points are apart is of use */
        e.amount = end->widest;
        TRY(feed_event(d, &e));
    }
    return vbss_metrics_finish(d->metrics);
}

/* ---- what came of it */

static vbss_result copy_rows(vbss_metrics *metrics, vbss_metrics_field field, double **rows,
                             size_t *count)
{
    vbss_view view;
    TRY(vbss_metrics_get_view(metrics, field, &view, sizeof view));
    *count = (size_t)view.count;
    *rows = calloc(*count > 0 ? *count : 1, sizeof **rows);
    if (*rows == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    for (size_t i = 0; i < *count; i++) {
        memcpy(*rows + i, (const char *)view.data + i * view.stride_bytes, sizeof **rows);
    }
    return VBSS_OK;
}

vbss_result facts_take(facts *f, vbss_metrics *metrics)
{
    measured *m = &f->measured;
    static const vbss_metrics_field speeds[SIDES] = {VBSS_METRICS_VIEW_LEFT_SPEED,
                                                     VBSS_METRICS_VIEW_RIGHT_SPEED},
                                    forces[SIDES] = {VBSS_METRICS_VIEW_LEFT_FORCE,
                                                     VBSS_METRICS_VIEW_RIGHT_FORCE};
    m->begin = f->steps > 0 ? f->moments[0].time : 0.0;
    TRY(vbss_metrics_get_report(metrics, &m->report, sizeof m->report));
    for (int side = 0; side < SIDES; side++) {
        TRY(vbss_metrics_get_motion(metrics, side, VBSS_METRICS_PHASE_ALL, &m->motion[side],
                                    sizeof m->motion[side]));
        TRY(copy_rows(metrics, forces[side], &m->force[side], &m->force_rows[side]));
        TRY(copy_rows(metrics, speeds[side], &m->speed[side], &m->rows[side]));
    }
    TRY(vbss_metrics_get_bimanual(metrics, VBSS_METRICS_PHASE_ALL, &m->bimanual,
                                  sizeof m->bimanual));
    m->penalties = calloc((size_t)m->report.penalty_count + 1, sizeof *m->penalties);
    m->throws = calloc((size_t)m->report.throw_records + 1, sizeof *m->throws);
    if (m->penalties == NULL || m->throws == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    for (uint32_t i = 0; i < m->report.penalty_count; i++) {
        TRY(vbss_metrics_get_penalty(metrics, i, &m->penalties[i], sizeof m->penalties[i]));
    }
    for (uint32_t i = 0; i < m->report.throw_records; i++) {
        TRY(vbss_metrics_get_throw(metrics, i, &m->throws[i], sizeof m->throws[i]));
    }
    return VBSS_OK;
}

vbss_result facts_measure(facts *f)
{
    measured *m = &f->measured;
    feeder d = {.f = f, .needle_side = -1};
    if (f->again.session.measured) {
        return VBSS_OK;
    }
    TRY(vbss_metrics_config_init(&m->config, sizeof m->config));
    m->config.duration = fmin(7200.0, fmax(1.0, facts_end(f) + 1.0));
    TRY(vbss_metrics_create(f->context, &m->config, &d.metrics));
    TRY(feed(&d));
    TRY(facts_take(f, d.metrics));
    return vbss_metrics_destroy(d.metrics);
}
