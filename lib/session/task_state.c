/* Queries about the state of the task that several files share, and the debouncing of facts. */
#include "session/session.h"

bool vbss_session_debounce(session_debounced_value *debounced, uint32_t candidate, double now,
                           double dwell)
{
    if (candidate != debounced->candidate) {
        debounced->candidate = candidate;
        debounced->since = now;
    }
    if (candidate == debounced->value || now - debounced->since < dwell) {
        return false;
    }
    debounced->value = candidate;
    return true;
}

bool vbss_session_is_over(const session_object *s)
{
    return s->phase >= VBSS_SESSION_PHASE_DONE || s->exercise.outcome != VBSS_SESSION_OUTCOME_NONE;
}

bool vbss_session_is_threaded(const session_object *s)
{
    return s->holes[SESSION_ENTRY].threaded != 0 && s->holes[SESSION_EXIT].threaded != 0;
}

bool vbss_session_is_tying(const session_object *s)
{
    return s->throw_count > 0 || s->throw_stage.value != VBSS_SESSION_STAGE_NONE;
}

const session_hole_observation *vbss_session_find_hole(const session_observation *observed,
                                                       uint32_t id)
{
    for (uint32_t i = 0; i < observed->hole_count && id > 0; i++) {
        if (observed->holes[i].id == id) {
            return &observed->holes[i];
        }
    }
    return NULL;
}
