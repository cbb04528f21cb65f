/* Brings a session in a replay to a step of the log: restores the newest snapshots of scene and
 * session at or before it, and replays the steps from there. */
#include "base/error.h"
#include "base/memory.h"
#include "base/snapshot.h"
#include "session/session.h"

static vbss_result check_scene(const session_object *s, const replay_object *p)
{
    scene_info scene;
    VBSS_TRY(vbss_scene_inspect(s->scene, &scene));
    return p->scene == s->scene
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "the replay is of another scene");
}

static vbss_result restore_snapshot(const vbss_slot *slot, const session_object *s,
                                    replay_object *p, const log_snapshot *snapshot)
{
    VBSS_TRY(vbss_replay_seek_step(p, snapshot->number));
    if (p->report.outcome != VBSS_REPLAY_OUTCOME_STEPPED) {
        return vbss_fail(s->context, VBSS_ERROR_CORRUPT,
                         "the scene after step %llu is not the recorded one",
                         (unsigned long long)snapshot->number);
    }
    log_snapshot_data data;
    VBSS_TRY(vbss_log_decompress_snapshot(s->context, snapshot, &data));
    vbss_result result = vbss_object_restore(slot, &vbss_session_kind, data.bytes, data.count);
    vbss_log_release_snapshot(s->context, &data);
    return result;
}

/* The session may refuse a snapshot with a valid checksum after the scene has been restored. The
 * state of the scene is therefore saved first, and restored on failure. */
static vbss_result restore_or_roll_back(const vbss_slot *slot, const session_object *s,
                                        replay_object *p, const log_snapshot *snapshot)
{
    const replay_position before = vbss_replay_get_position(p);
    size_t count = 0, written = 0;
    VBSS_TRY(vbss_snapshot_size((const vbss_slot *)s->scene, &count));
    uint8_t *bytes = vbss_allocate(s->context, count, 1, "way back of a session");
    if (bytes == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    vbss_result result = vbss_snapshot_save((const vbss_slot *)s->scene, bytes, count, &written);
    if (result == VBSS_OK) {
        result = restore_snapshot(slot, s, p, snapshot);
        if (result != VBSS_OK) {
            vbss_replay_roll_back(p, &before);
            (void)vbss_scene_restore(s->scene, bytes,
                                     count); /* cannot fail: it has just saved this state */
        }
    }
    vbss_release(s->context, bytes, count, 1);
    return result;
}

vbss_result vbss_session_seek_step(const vbss_slot *slot, session_object *s, uint64_t step)
{
    replay_object *p;
    log_snapshot snapshot;
    if (s->config.replay == NULL) {
        return vbss_fail(s->context, VBSS_ERROR_WRONG_STATE, "the session follows no replay");
    }
    VBSS_TRY(vbss_replay_edit(s->config.replay, &p));
    VBSS_TRY(check_scene(s, p));
    VBSS_TRY(vbss_log_find_session_snapshot(p, step, &snapshot));
    if (snapshot.bytes == NULL) {
        return vbss_fail(s->context, VBSS_ERROR_NOT_FOUND,
                         "the log has no state of a session before step %llu",
                         (unsigned long long)step);
    }
    VBSS_TRY(restore_or_roll_back(slot, s, p, &snapshot));
    while (p->report.step < step) {
        VBSS_TRY(vbss_session_advance(slot, s, 0.0, 0.0));
    }
    return VBSS_OK;
}
