/* Events of the task: a ring of the newest ones, and their dispatch to the listener of the host. */
#include "base/error.h"
#include "session/session.h"

vbss_session_event *vbss_session_event_at(const session_object *s, uint64_t index)
{
    return &s->events[index % s->config.event_capacity];
}

vbss_session_event *vbss_session_emit_event(session_object *s, vbss_session_event_kind kind,
                                            uint32_t number, uint32_t undone, uint32_t tool)
{
    vbss_session_event *e = vbss_session_event_at(s, s->event_count);
    *e = (vbss_session_event){.struct_size = sizeof *e,
                              .kind = kind,
                              .tool = (vbss_metrics_tool)tool,
                              .number = number,
                              .undone = undone,
                              .phase = s->phase,
                              .ordinal = s->event_count++,
                              .step = s->steps,
                              .time = s->time};
    if (tool < SESSION_HANDS) {
        vec3_store(e->position, s->observation.tools[tool].tip);
        vec3_store(e->force, s->observation.tools[tool].force);
    }
    return e;
}

/* A step with more events than the ring has room for loses the first of them. */
static uint64_t first_event_of_step(const session_object *s)
{
    uint64_t capacity = s->config.event_capacity;
    uint64_t oldest = s->event_count > capacity ? s->event_count - capacity : 0;
    return s->events_before_step > oldest ? s->events_before_step : oldest;
}

void vbss_session_dispatch_events(session_object *s)
{
    if (s->config.listen == NULL) {
        return;
    }
    for (uint64_t i = first_event_of_step(s); i < s->event_count; i++) {
        const vbss_session_event e = *vbss_session_event_at(s, i);
        bool outer = vbss_callback_begin(s->context);
        s->config.listen(s->config.user, &e);
        vbss_callback_end(s->context, outer);
    }
}
