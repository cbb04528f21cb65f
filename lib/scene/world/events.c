/* Events: those of the step that is not complete, the list that hosts take from, and the events of the
 * last call as logs store them. */
#include "scene/world/world.h"

/* ---- the log */

void vbss_scene_clear_logged_events(scene_object *s)
{
    s->report.logged_event_count = s->report.lost_logged_events = 0;
}

/* The kind in a log; 0: logs have no such event. */
static uint32_t logged_kind(vbss_scene_event_kind kind)
{
    switch (kind) {
    case VBSS_SCENE_EVENT_TRUNCATED:
    case VBSS_SCENE_EVENT_PAUSED:
        return SCENE_LOGGED_TIME_LOST;
    case VBSS_SCENE_EVENT_DEFERRED:
    case VBSS_SCENE_EVENT_CAUGHT_UP:
    case VBSS_SCENE_EVENT_OVERDUE:
        return 0;
    default:
        return (uint32_t)kind;
    }
}

static void log_event(scene_object *s, const vbss_scene_event *event, uint32_t number)
{
    const uint32_t kind = logged_kind(event->kind);
    if (kind == 0) {
        return;
    }
    if (s->report.logged_event_count == s->config.event_capacity) {
        s->report.lost_logged_events++;
        return;
    }
    uint32_t *words = s->report.logged_events[s->report.logged_event_count++];
    words[0] = kind;
    words[1] = kind != SCENE_LOGGED_TIME_LOST ? event->body_a : 0;
    words[2] = kind != SCENE_LOGGED_TIME_LOST ? event->body_b : 0;
    words[3] = number;
}

void vbss_scene_log_lost_events(scene_object *s)
{
    if (s->report.lost_logged_events > 0 && s->config.event_capacity > 0) { /* replaces the last */
        uint32_t *last = s->report.logged_events[s->config.event_capacity - 1];
        last[0] = SCENE_LOGGED_LOST;
        last[1] = last[2] = 0;
        last[3] = s->report.lost_logged_events + 1;
    }
}

/* ---- the step that is not complete */

void vbss_scene_add_event(scene_object *s, const vbss_scene_event *event, uint32_t logged_number)
{
    scene_events *events = &s->events;
    log_event(s, event, logged_number);
    if (events->pending_count == s->config.event_capacity) {
        events->pending_lost++;
        return;
    }
    vbss_scene_event *added = &events->pending[events->pending_count++];
    *added = *event;
    added->struct_size = sizeof *added;
}

void vbss_scene_add_event_at(scene_object *s, vbss_scene_event *event, vec3 position,
                             uint32_t logged_number)
{
    event->flags |= VBSS_SCENE_EVENT_FLAG_POSITION;
    vec3_store(event->position, position);
    vbss_scene_add_event(s, event, logged_number);
}

void vbss_scene_emit_cut_event(scene_object *s, const scene_body *thread, const scene_body *piece,
                               double arc_length, vec3 position)
{
    uint32_t um = (uint32_t)(vbss_min(1e6 * arc_length, 4e9) + 0.5);
    vbss_scene_event event = {.kind = VBSS_SCENE_EVENT_CUT,
                              .body_a = thread->number,
                              .body_b = piece != NULL ? piece->number : 0,
                              .arc_length = arc_length};
    vbss_scene_add_event_at(s, &event, position, um);
    vbss_scene_log_lost_events(s);
}

/* ---- the list that hosts take from */

static vbss_scene_event *event_at(const scene_object *s, uint32_t index)
{
    const uint64_t position = (uint64_t)s->events.first + index;
    return &s->events.ring[position % s->config.event_capacity];
}

static void publish_event(scene_object *s, const vbss_scene_event *event, double h)
{
    scene_events *events = &s->events;
    const vbss_scene_statistics *statistics = &s->report.statistics;
    if (events->count == s->config.event_capacity) { /* the oldest gives its place */
        events->first = (events->first + 1) % s->config.event_capacity;
        events->count--;
        events->lost++;
    }
    vbss_scene_event *published = event_at(s, events->count++);
    *published = *event;
    published->step = statistics->steps + (h > 0.0);
    published->time = statistics->time + h;
}

void vbss_scene_publish_events(scene_object *s, uint32_t from, double h)
{
    scene_events *events = &s->events;
    for (uint32_t i = from; i < events->pending_count; i++) {
        publish_event(s, &events->pending[i], h);
    }
    events->pending_count = from < events->pending_count ? from : events->pending_count;
    if (events->pending_count == 0) {
        events->lost += events->pending_lost;
        events->pending_lost = 0;
    }
}

bool vbss_scene_take_event(scene_object *s, vbss_scene_event *event)
{
    scene_events *events = &s->events;
    if (events->count == 0) {
        return false;
    }
    *event = *event_at(s, 0);
    events->first = (events->first + 1) % s->config.event_capacity;
    events->count--;
    return true;
}
