/* Events: each is checked completely, then stored, or undoes a stored one. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "metrics/metrics.h"

_Static_assert(sizeof(vbss_metrics_event) == 144, "published size");
static const vbss_metrics_event defaults = {.struct_size = sizeof(vbss_metrics_event),
                                            .tool = VBSS_METRICS_TOOL_NONE};
static const uint32_t sizes[] = {144, 0};
static const vbss_layout layout = {"vbss_metrics_event", &defaults, sizes};

#define MILLIMETRES 1e3

vbss_result vbss_metrics_event_init(vbss_metrics_event *event, uint32_t struct_size)
{
    return vbss_config_init(&layout, event, struct_size);
}

/* ---- range checks */

static bool find_fact(vbss_metrics_event_kind kind, metrics_fact *fact)
{
    switch (kind) {
    case VBSS_METRICS_EVENT_NEEDLE_APPEARS:
        *fact = METRICS_APPEARED;
        return true;
    case VBSS_METRICS_EVENT_PUNCTURE:
        *fact = METRICS_PUNCTURE;
        return true;
    case VBSS_METRICS_EVENT_TAIL:
        *fact = METRICS_TAIL;
        return true;
    case VBSS_METRICS_EVENT_TAIL_CUT:
        *fact = METRICS_CUT;
        return true;
    case VBSS_METRICS_EVENT_GAP:
        *fact = METRICS_GAP;
        return true;
    case VBSS_METRICS_EVENT_AVULSED:
        *fact = METRICS_AVULSED;
        return true;
    case VBSS_METRICS_EVENT_BROKEN:
        *fact = METRICS_BROKEN;
        return true;
    default:
        return false;
    }
}

static double max_number(vbss_metrics_event_kind kind)
{
    switch (kind) {
    case VBSS_METRICS_EVENT_PUNCTURE:
    case VBSS_METRICS_EVENT_TAIL:
    case VBSS_METRICS_EVENT_TAIL_CUT:
        return 1.0;
    case VBSS_METRICS_EVENT_THROW:
        return 63.0;
    default:
        return (double)UINT32_MAX;
    }
}

static vbss_result check_event(const metrics_object *m, const vbss_metrics_event *e)
{
    vbss_context *context = m->context;
    const struct {
        const char *name;
        double value, low, high;
    } ranges[] = {
        {"kind", e->kind, VBSS_METRICS_EVENT_NEEDLE_APPEARS, VBSS_METRICS_EVENT_ASSISTED},
        {"tool", e->tool, VBSS_METRICS_TOOL_LEFT, VBSS_METRICS_TOOL_NONE},
        {"number", e->number, 0.0, max_number(e->kind)},
        {"undone", e->undone, 0.0, e->kind == VBSS_METRICS_EVENT_PHASE ? 0.0 : 1.0},
        {"wraps", e->wraps, 0.0, 64.0},
        {"handedness", e->handedness, -1.0, 1.0},
        {"relation", e->relation, VBSS_METRICS_RELATION_UNKNOWN, VBSS_METRICS_RELATION_GRANNY},
        {"angle", e->angle, -3.15, 3.15},
        {"axial", e->axial, -METRICS_LARGEST_POSITION, METRICS_LARGEST_POSITION},
        {"amount", e->amount, 0.0, 1e6},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        VBSS_TRY(vbss_check_range(context, ranges[i].value, ranges[i].low, ranges[i].high,
                                  ranges[i].name));
    }
    VBSS_TRY(vbss_check_vector(context, e->position, METRICS_LARGEST_POSITION, "position"));
    VBSS_TRY(vbss_check_vector(context, e->other, METRICS_LARGEST_POSITION, "other"));
    VBSS_TRY(vbss_check_vector(context, e->force, METRICS_LARGEST_FORCE, "force"));
    return vbss_metrics_check_time(m, e->time);
}

/* ---- measured values */

/* Distance on the cylinder: sqrt(R^2 theta^2 + x^2), Qi et al. 2017, section 6. */
static double deviation_mm(const vbss_metrics_config *c, const vbss_metrics_event *e)
{
    double arc = c->drain_radius * e->angle;
    return MILLIMETRES * sqrt(arc * arc + e->axial * e->axial);
}

static metrics_entry make_entry(const metrics_object *m, const vbss_metrics_event *e)
{
    metrics_entry entry = {.kind = e->kind,
                           .number = e->number,
                           .is_active = 1,
                           .tool = e->tool,
                           .wraps = e->wraps,
                           .handedness = e->handedness,
                           .relation = e->relation,
                           .step = e->step,
                           .time = e->time,
                           .time_lost = m->time_lost,
                           .position = vec3_load(e->position),
                           .force = vec3_load(e->force)};
    entry.value[0] = e->amount;
    if (e->kind == VBSS_METRICS_EVENT_PUNCTURE) {
        entry.value[0] = deviation_mm(&m->config, e);
    } else if (e->kind == VBSS_METRICS_EVENT_GAP) {
        entry.value[0] = MILLIMETRES * vec3_distance(entry.position, vec3_load(e->other));
        entry.value[1] = vbss_max(entry.value[0], MILLIMETRES * e->amount);
    }
    return entry;
}

/* ---- storage */

static vbss_result fail_full(const metrics_object *m, const char *what, uint32_t capacity)
{
    return vbss_fail(m->context, VBSS_ERROR_CAPACITY, "there is room for %u %s", capacity, what);
}

static vbss_result fail_inactive(const metrics_object *m, const vbss_metrics_event *e)
{
    return vbss_fail(m->context, VBSS_ERROR_NOT_FOUND,
                     "event %d with number %u is undone, but does not stand", e->kind, e->number);
}

static vbss_result add_incident(metrics_object *m, const metrics_entry *entry)
{
    if (m->incident_count == m->config.incident_capacity) {
        return fail_full(m, "incidents", m->incident_count);
    }
    m->incidents[m->incident_count++] = *entry;
    return VBSS_OK;
}

static vbss_result set_fact(metrics_object *m, metrics_fact first, const vbss_metrics_event *e)
{
    bool is_numbered = max_number(e->kind) == 1.0;
    metrics_entry *fact = &m->facts[first + (is_numbered ? e->number : 0u)];
    metrics_entry entry = make_entry(m, e);
    if (e->undone == 0) {
        *fact = entry;
        return VBSS_OK;
    }
    if (!fact->is_active) {
        return fail_inactive(m, e);
    }
    if (e->kind == VBSS_METRICS_EVENT_PUNCTURE) {
        entry.value[0] = fact->value[0]; /* deviation of the attempt */
        VBSS_TRY(add_incident(m, &entry));
    }
    fact->is_active = 0;
    return VBSS_OK;
}

/* The youngest valid entry, or NULL. */
static metrics_entry *find_active_entry(metrics_entry *entries, uint32_t count,
                                        vbss_metrics_event_kind kind, uint32_t number)
{
    for (uint32_t i = count; i-- > 0;) {
        metrics_entry *entry = &entries[i];
        if (entry->is_active && entry->kind == kind && entry->number == number) {
            return entry;
        }
    }
    return NULL;
}

static vbss_result undo_entry(const metrics_object *m, metrics_entry *entry,
                              const vbss_metrics_event *e)
{
    if (entry == NULL) {
        return fail_inactive(m, e);
    }
    entry->is_active = 0;
    entry->undone_time = e->time;
    return VBSS_OK;
}

/* A repeated event for a valid throw updates it; the time of the first event stays. */
static vbss_result set_throw(metrics_object *m, const vbss_metrics_event *e)
{
    metrics_entry *existing = find_active_entry(m->throws, m->throw_count, e->kind, e->number);
    if (e->undone != 0) {
        return undo_entry(m, existing, e);
    }
    metrics_entry entry = make_entry(m, e);
    if (existing != NULL) {
        entry.step = existing->step;
        entry.time = existing->time;
        *existing = entry;
        return VBSS_OK;
    }
    if (m->throw_count == m->config.throw_capacity) {
        return fail_full(m, "throws", m->throw_count);
    }
    m->throws[m->throw_count++] = entry;
    return VBSS_OK;
}

static vbss_result begin_phase(metrics_object *m, const vbss_metrics_event *e)
{
    if (m->phase_count == m->config.phase_capacity) {
        return fail_full(m, "phases", m->phase_count);
    }
    m->phases[m->phase_count++] = (metrics_phase){e->number, e->step, e->time};
    return VBSS_OK;
}

static vbss_result store_event(metrics_object *m, const vbss_metrics_event *e)
{
    metrics_fact fact;
    if (find_fact(e->kind, &fact)) {
        return set_fact(m, fact, e);
    }
    if (e->kind == VBSS_METRICS_EVENT_PHASE) {
        return begin_phase(m, e);
    }
    if (e->kind == VBSS_METRICS_EVENT_THROW) {
        return set_throw(m, e);
    }
    if (e->undone != 0) {
        return undo_entry(m, find_active_entry(m->incidents, m->incident_count, e->kind, e->number),
                          e);
    }
    metrics_entry entry = make_entry(m, e);
    return add_incident(m, &entry);
}

vbss_result vbss_metrics_add_event(vbss_metrics *metrics, const vbss_metrics_event *event)
{
    VBSS_ENTER(metrics);
    metrics_object *m;
    vbss_metrics_event e;
    VBSS_TRY(vbss_metrics_edit(metrics, &m));
    VBSS_TRY(vbss_config_read(m->context, &layout, event, &e));
    VBSS_TRY(check_event(m, &e));
    VBSS_TRY(store_event(m, &e));
    vbss_metrics_advance_clock(m, e.time, e.step);
    return VBSS_OK;
}
