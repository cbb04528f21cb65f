/* Keeps the session and the log of its scene in step: adds session hashes and snapshots to the log,
 * and compares the hashes in a replay. */
#include "base/error.h"
#include "session/session.h"

vbss_result vbss_session_check_record(const session_object *s, vbss_record *record)
{
    record_object *r;
    if (record == NULL) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_slot_check_other(s->context, record, "record"));
    VBSS_TRY(vbss_record_edit(record, &r));
    return r->scene == s->scene
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "the record is of another scene");
}

vbss_result vbss_session_attach_record(const session_object *s)
{
    return s->config.record != NULL ? vbss_scene_set_recorder(s->scene, s->config.record) : VBSS_OK;
}

/* ---- the step of the scene */

static vbss_result replay_scene_step(session_object *s)
{
    vbss_replay_report report;
    replay_object *p;
    VBSS_TRY(vbss_replay_edit(s->config.replay, &p));
    if (p->scene != s->scene) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "the replay is of another scene");
    }
    VBSS_TRY(vbss_replay_step(s->config.replay, &report, sizeof report));
    s->h = p->step.h;
    if (report.outcome == VBSS_REPLAY_OUTCOME_ENDED) {
        return vbss_fail(s->context, VBSS_ERROR_WRONG_STATE, "the log has ended");
    }
    return report.outcome == VBSS_REPLAY_OUTCOME_STEPPED
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_CORRUPT,
                           "the scene after step %llu is not the recorded one",
                           (unsigned long long)report.step);
}

vbss_result vbss_session_step_scene(session_object *s, double h)
{
    if (s->config.replay != NULL) {
        return replay_scene_step(s);
    }
    VBSS_TRY(vbss_scene_step(s->scene, vbss_session_scaled_step(s, h)));
    s->h = vbss_session_scaled_step(s, h);
    return VBSS_OK;
}

/* ---- session hashes and snapshots */

/* A log is the same whether the session coaches or not. */
static uint64_t count_logged_events(const session_object *s)
{
    return s->event_count - s->coach_event_count;
}

/* A log without an entry after this step has no change of the aids in it. */
uint32_t vbss_session_logged_aids(const session_object *s)
{
    replay_object *p;
    log_session_hash entry;
    bool is_found =
        vbss_replay_edit(s->config.replay, &p) == VBSS_OK && vbss_log_find_session_hash(p, &entry);
    return is_found ? (uint32_t)entry.aids : s->assistance.aids;
}

static vbss_result compare_log_hash(session_object *s)
{
    replay_object *p;
    log_session_hash entry;
    VBSS_TRY(vbss_replay_edit(s->config.replay, &p));
    if (!vbss_log_find_session_hash(p, &entry)) {
        return VBSS_OK;
    }
    return entry.events == count_logged_events(s) && entry.hash == vbss_session_task_hash(s)
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_CORRUPT,
                           "the session after step %llu of the log is not the recorded one",
                           (unsigned long long)entry.number);
}

vbss_result vbss_session_record_snapshot(const vbss_slot *slot, vbss_record *record)
{
    record_object *r;
    if (record == NULL) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_record_edit(record, &r));
    return vbss_log_write_session_snapshot(r, slot);
}

/* A hash is due after a step with events, and every config.hash_interval steps. */
static vbss_result write_log_hash(session_object *s)
{
    record_object *r;
    if (s->config.record == NULL ||
        (s->event_count == s->events_before_step && s->steps % s->config.hash_interval != 0)) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_record_edit(s->config.record, &r));
    log_session_hash entry = {.number = r->step.number,
                              .hash = vbss_session_task_hash(s),
                              .events = count_logged_events(s),
                              .aids = s->assistance.aids};
    return vbss_log_write_session_hash(r, &entry);
}

vbss_result vbss_session_sync_log(const vbss_slot *slot, session_object *s)
{
    if (s->config.replay != NULL) {
        return compare_log_hash(s);
    }
    VBSS_TRY(write_log_hash(s));
    return vbss_session_record_snapshot(slot, s->config.record);
}
