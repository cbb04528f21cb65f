/* Begins a task at the place that a saved session had reached. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/snapshot.h"
#include "metrics/metrics.h"
#include "session/session.h"

/* The metrics of the new task, which the saved state would replace. The bytes are trusted, so that reading
 * them cannot fail. */
typedef struct kept_metrics {
    metrics_object *metrics; /* NULL: the session has none */
    uint8_t *bytes;
    size_t count;
} kept_metrics;

static void visit_metrics(vbss_stream *stream, const kept_metrics *kept)
{
    stream->trusted = true;
    vbss_section outer =
        vbss_stream_open(stream, vbss_metrics_kind.code, vbss_metrics_kind.version);
    vbss_metrics_serialise(stream, kept->metrics);
    vbss_stream_close(stream, outer);
}

static vbss_result keep_metrics(const session_object *s, kept_metrics *kept)
{
    vbss_stream stream;
    if (s->config.metrics == NULL) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_metrics_open(s->config.metrics, &kept->metrics));
    vbss_stream_begin_measure(&stream);
    visit_metrics(&stream, kept);
    kept->count = stream.position;
    kept->bytes = vbss_allocate(s->context, kept->count, 1, "metrics of a session");
    if (kept->bytes == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    vbss_stream_begin_write(&stream, kept->bytes, kept->count);
    visit_metrics(&stream, kept);
    return VBSS_OK;
}

static void return_metrics(const kept_metrics *kept)
{
    vbss_stream stream;
    if (kept->metrics != NULL) {
        vbss_stream_begin_read(&stream, kept->bytes, kept->count);
        visit_metrics(&stream, kept);
    }
}

/* The clock starts at zero. Earlier observations get negative times. */
static void shift_times(session_object *s)
{
    session_debounced_value *const values[] = {&s->holding_tools, &s->tail_set,    &s->throw_stage,
                                               &s->newest_seated, &s->knot_faults, &s->half_hitch,
                                               &s->broken};
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        values[i]->since -= s->time;
    }
    for (uint32_t i = 0; i < SESSION_MAX_THROWS; i++) {
        s->throws[i].since -= s->time;
    }
    s->time = s->end_time = s->time_lost = s->end_time_lost = 0.0;
    s->is_lossy = 0;
}

static void begin_coach(session_object *s)
{
    session_coach *c = &s->coach;
    c->observed = c->open = 0;
    c->goal = (session_debounced_value){.value = 0};
    c->goal_since = 0.0;
    for (uint32_t i = 0; i < VBSS_SESSION_MISTAKE_COUNT; i++) {
        c->since[i] = c->begun[i] = 0.0;
    }
}

static void begin_task(session_object *s)
{
    shift_times(s);
    begin_coach(s);
    s->assistance = (session_assistance){.set = vbss_session_default_assistance()};
    s->steps = s->event_count = s->events_before_step = s->coach_event_count = 0;
    s->metrics_lost = 0;
}

vbss_result vbss_session_begin_at(vbss_session *session, const uint8_t *bytes, uint64_t count)
{
    VBSS_ENTER(session);
    session_object *s;
    kept_metrics kept = {.metrics = NULL};
    VBSS_TRY(vbss_session_edit(session, &s));
    VBSS_TRY(vbss_check_pointer(s->context, bytes, "bytes"));
    if (s->steps > 0 || s->config.record != NULL || s->config.replay != NULL) {
        return vbss_fail(s->context, VBSS_ERROR_WRONG_STATE,
                         s->steps > 0 ? "the session has made a step"
                                      : "the session has a record or a replay");
    }
    vbss_result result = keep_metrics(s, &kept);
    if (result == VBSS_OK) {
        const vbss_session_assistance set = s->assistance.set;
        s->begins_at = true;
        result = vbss_object_restore(session, &vbss_session_kind, bytes, count);
        s->begins_at = false;
        if (result == VBSS_OK) {
            return_metrics(&kept);
            begin_task(s);
            s->assistance.set = set;
        }
    }
    vbss_release(s->context, kept.bytes, kept.count, 1);
    return result;
}
