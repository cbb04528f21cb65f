/* The handle of sessions: allocation, kind, opening. */
#include "base/error.h"
#include "base/memory.h"
#include "session/session.h"

static vbss_array event_array(session_object *s)
{
    return (vbss_array){&s->events, s->config.event_capacity, sizeof *s->events};
}

void vbss_session_free(vbss_context *context, void *object)
{
    session_object *s = object;
    const vbss_array events = event_array(s);
    vbss_release_arrays(context, &events, 1);
    vbss_release(context, s, 1, sizeof *s);
}

vbss_result vbss_session_allocate(vbss_context *context, const vbss_session_config *config,
                                  session_object **session)
{
    session_object *s = vbss_allocate(context, 1, sizeof *s, "session");
    if (s == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    s->context = context;
    s->config = *config;
    s->thread = config->thread;
    s->last_holder = VBSS_METRICS_TOOL_NONE;
    s->assistance.set = vbss_session_default_assistance();
    vbss_session_reset_exercise(s);
    const vbss_array events = event_array(s);
    vbss_result result = vbss_allocate_arrays(context, &events, 1, "events of a session");
    if (result != VBSS_OK) {
        vbss_session_free(context, s);
        return result;
    }
    *session = s;
    return VBSS_OK;
}

const vbss_kind vbss_session_kind = {"session",         VBSS_CODE('S', 'E', 'S', 'S'), 2,
                                     vbss_session_free, vbss_session_serialise,        NULL};

vbss_result vbss_session_open(const vbss_session *handle, session_object **session)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_session_kind, &slot));
    *session = slot->object;
    return VBSS_OK;
}

vbss_result vbss_session_edit(vbss_session *handle, session_object **session)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_session_kind, &slot));
    *session = slot->object;
    return VBSS_OK;
}
