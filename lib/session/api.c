/* The exported functions of existing sessions. They check their arguments before any change. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/snapshot.h"
#include "session/session.h"

_Static_assert(sizeof(vbss_session_status) == 168, "published size");
_Static_assert(sizeof(vbss_session_event) == 120, "published size");

static const uint32_t status_sizes[] = {136, 160, 168, 0};
static const vbss_layout status_layout = {"vbss_session_status", NULL, status_sizes};
static const uint32_t event_sizes[] = {120, 0};
static const vbss_layout event_layout = {"vbss_session_event", NULL, event_sizes};
/* Three pointers, each between fields of eight bytes. */
static const uint32_t coaching_sizes[] = {sizeof(vbss_session_coaching), 0};
static const vbss_layout coaching_layout = {"vbss_session_coaching", NULL, coaching_sizes};

/* ---- steps */

vbss_result vbss_session_step(vbss_session *session, double now, double h)
{
    VBSS_ENTER(session);
    session_object *s;
    VBSS_TRY(vbss_session_edit(session, &s));
    uint64_t steps = s->steps;
    vbss_result result = vbss_session_advance((const vbss_slot *)session, s, now, h);
    if (s->steps > steps) {
        vbss_session_dispatch_events(s);
    }
    return result;
}

vbss_result vbss_session_seek(vbss_session *session, uint64_t step)
{
    VBSS_ENTER(session);
    session_object *s;
    VBSS_TRY(vbss_session_edit(session, &s));
    return vbss_session_seek_step((const vbss_slot *)session, s, step);
}

vbss_result vbss_session_set_record(vbss_session *session, vbss_record *record)
{
    VBSS_ENTER(session);
    session_object *s;
    VBSS_TRY(vbss_session_edit(session, &s));
    VBSS_TRY(vbss_session_check_record(s, record));
    if (record != NULL || s->config.record != NULL) {
        VBSS_TRY(vbss_scene_set_recorder(s->scene, record));
    }
    VBSS_TRY(vbss_session_record_snapshot((const vbss_slot *)session, record));
    s->config.record = record;
    if (s->config.replay != NULL) { /* the aids of the log stay on until the host sets others */
        s->assistance.set.aids = s->assistance.aids;
    }
    s->config.replay = NULL;
    return VBSS_OK;
}

/* ---- assistance */

static vbss_result edit_live_session(vbss_session *session, session_object **s)
{
    VBSS_TRY(vbss_session_edit(session, s));
    return (*s)->config.replay == NULL
               ? VBSS_OK
               : vbss_fail((*s)->context, VBSS_ERROR_WRONG_STATE, "the session follows a replay");
}

vbss_result vbss_session_set_assistance(vbss_session *session,
                                        const vbss_session_assistance *assistance)
{
    VBSS_ENTER(session);
    session_object *s;
    vbss_session_assistance own;
    VBSS_TRY(edit_live_session(session, &s));
    if (assistance == NULL) {
        s->assistance.set.aids = 0;
        return VBSS_OK;
    }
    VBSS_TRY(vbss_session_read_assistance(s->context, assistance, &own));
    s->assistance.set = own;
    return VBSS_OK;
}

vbss_result vbss_session_get_assistance(vbss_session *session, vbss_session_assistance *assistance,
                                        uint32_t struct_size)
{
    VBSS_ENTER(session);
    session_object *s;
    VBSS_TRY(vbss_session_open(session, &s));
    return vbss_session_write_assistance(s, assistance, struct_size);
}

vbss_result vbss_session_move_hand(vbss_session *session, vbss_metrics_tool tool,
                                   const vbss_session_hand *hand)
{
    VBSS_ENTER(session);
    session_object *s;
    VBSS_TRY(edit_live_session(session, &s));
    VBSS_TRY(vbss_check_pointer(s->context, hand, "hand"));
    VBSS_TRY(vbss_check_range(s->context, tool, VBSS_METRICS_TOOL_LEFT, VBSS_METRICS_TOOL_RIGHT,
                              "tool"));
    return vbss_session_give_input(s, (uint32_t)tool, hand);
}

/* ---- progress and events */

static uint32_t count_bits(uint32_t bits)
{
    return (bits & 1u) + (bits >> 1 & 1u);
}

vbss_result vbss_session_get_status(vbss_session *session, vbss_session_status *status,
                                    uint32_t struct_size)
{
    VBSS_ENTER(session);
    session_object *s;
    VBSS_TRY(vbss_session_open(session, &s));
    uint64_t capacity = s->config.event_capacity;
    vbss_session_status own = {
        .struct_size = sizeof own,
        .phase = s->phase,
        .stage = (vbss_session_stage)(s->throw_stage.value % 8),
        .failure = s->failure,
        .holder = s->holding_tools.value == 0          ? VBSS_METRICS_TOOL_NONE
                  : (s->holding_tools.value & 1u) != 0 ? VBSS_METRICS_TOOL_LEFT
                                                       : VBSS_METRICS_TOOL_RIGHT,
        .tail_set = s->tail_set.value,
        .throws = s->throw_count,
        .seated = s->seated_count,
        .transfers = count_bits(s->transferred),
        .cut = s->cut_limbs,
        .faults = vbss_session_faults(s),
        .metrics_lost = s->metrics_lost,
        .steps = s->steps,
        .first_event = s->event_count > capacity ? s->event_count - capacity : 0,
        .event_count = s->event_count,
        .time = vbss_session_is_over(s) ? s->end_time : s->time,
        .tail = s->tail_length,
        .gap = s->gap,
        .time_lost = vbss_session_is_over(s) ? s->end_time_lost : s->time_lost,
        .is_lossy = s->is_lossy,
        .aids = s->assistance.aids,
        .aids_used = s->assistance.used,
    };
    own.time_simulated = own.time - own.time_lost;
    for (uint32_t k = 0; k < SESSION_SIDES; k++) {
        const session_hole *hole = &s->holes[k];
        own.punctured |= (uint32_t)(hole->id != 0) << k;
        own.threaded |= hole->threaded << k;
        own.tension[k] = s->tension[k];
        own.deviation_mm[k] = hole->deviation_mm;
    }
    return vbss_struct_write(s->context, &status_layout, &own, status, struct_size);
}

vbss_result vbss_session_get_coaching(vbss_session *session, vbss_session_coaching *coaching,
                                      uint32_t struct_size)
{
    VBSS_ENTER(session);
    session_object *s;
    VBSS_TRY(vbss_session_open(session, &s));
    if (s->config.coaching == 0) {
        return vbss_fail(s->context, VBSS_ERROR_WRONG_STATE,
                         "the session does not coach: its config has coaching 0");
    }
    vbss_session_coaching own = {.struct_size = sizeof own};
    vbss_session_fill_coaching(s, &own);
    return vbss_struct_write(s->context, &coaching_layout, &own, coaching, struct_size);
}

vbss_result vbss_session_get_event(vbss_session *session, uint64_t index, vbss_session_event *event,
                                   uint32_t struct_size)
{
    VBSS_ENTER(session);
    session_object *s;
    VBSS_TRY(vbss_session_open(session, &s));
    uint64_t capacity = s->config.event_capacity;
    if (index >= s->event_count || s->event_count - index > capacity) {
        return vbss_fail(s->context, VBSS_ERROR_NOT_FOUND,
                         "event %llu is not kept: there were %llu, with room for %llu",
                         (unsigned long long)index, (unsigned long long)s->event_count,
                         (unsigned long long)capacity);
    }
    return vbss_struct_write(s->context, &event_layout, vbss_session_event_at(s, index), event,
                             struct_size);
}

/* ---- exercises */

vbss_result vbss_session_get_exercise(vbss_session *session, vbss_session_exercise_state *state,
                                      uint32_t struct_size)
{
    VBSS_ENTER(session);
    session_object *s;
    VBSS_TRY(vbss_session_open(session, &s));
    return vbss_session_write_exercise(s, state, struct_size);
}

vbss_result vbss_session_get_measure(vbss_session *session, uint32_t index,
                                     vbss_session_measure *measure, uint32_t struct_size)
{
    VBSS_ENTER(session);
    session_object *s;
    VBSS_TRY(vbss_session_open(session, &s));
    return vbss_session_write_measure(s, index, measure, struct_size);
}

/* ---- snapshots */

vbss_result vbss_session_save(vbss_session *session, uint8_t *bytes, uint64_t capacity,
                              uint64_t *written)
{
    VBSS_ENTER(session);
    return vbss_object_save(session, &vbss_session_kind, bytes, capacity, written);
}

vbss_result vbss_session_restore(vbss_session *session, const uint8_t *bytes, uint64_t count)
{
    VBSS_ENTER(session);
    session_object *s;
    VBSS_TRY(vbss_session_open(session, &s));
    return vbss_object_restore(session, &vbss_session_kind, bytes, count);
}

vbss_result vbss_session_get_hash(vbss_session *session, uint64_t *hash)
{
    VBSS_ENTER(session);
    return vbss_object_hash(session, &vbss_session_kind, hash);
}
