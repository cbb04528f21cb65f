/* The records of sessions in the log of a scene: hashes after steps, and snapshots after those of
 * the scene. Readers that do not know sessions skip them. */
#include "base/error.h"
#include "base/snapshot.h"
#include "record/record.h"

/* A state is put in the log when that has grown by so many times its size: states are a third of it
 * at most. */
enum { SNAPSHOT_GROWTH_FACTOR = 2 };

/* ---- hashes */

/* Version 2 has the aids. It is written only if there are any, so that earlier versions of the library
 * can read other logs. */
static void visit_session_hash(vbss_stream *stream, log_session_hash *entry)
{
    uint64_t words[3] = {entry->number, entry->hash, entry->events}, aids = entry->aids;
    bool is_read = stream->mode == VBSS_STREAM_READ;
    vbss_section outer = vbss_stream_open(stream, LOG_SESSION_HASH, is_read || aids != 0 ? 2 : 1);
    vbss_stream_u64(stream, 1, words, 3);
    if (stream->version >= 2) {
        vbss_stream_u64(stream, 2, &aids, 1);
    }
    vbss_stream_close(stream, outer);
    entry->number = words[0];
    entry->hash = words[1];
    entry->events = words[2];
    entry->aids = aids;
}

vbss_result vbss_log_write_session_hash(record_object *r, log_session_hash *entry)
{
    vbss_stream stream;
    vbss_stream_begin_measure(&stream);
    visit_session_hash(&stream, entry);
    size_t need = log_record_bytes(&stream) + r->max_event_bytes + r->end_bytes;
    if (r->ended || need > vbss_log_free_bytes(&r->log)) {
        return VBSS_OK;
    }
    vbss_log_begin_record(&r->log, &stream);
    visit_session_hash(&stream, entry);
    return vbss_log_end_record(&r->log, &stream);
}

bool vbss_log_find_session_hash(const replay_object *p, log_session_hash *entry)
{
    log_reader next = p->log;
    log_fault ignored;
    log_record found;
    next.fault = &ignored;
    while (vbss_log_next_any(&next, &found) == VBSS_OK) {
        if (found.code == LOG_SESSION_HASH) {
            vbss_stream stream;
            vbss_stream_begin_read(&stream, found.payload, found.length);
            entry->aids = 0;
            visit_session_hash(&stream, entry);
            return stream.result == VBSS_OK && stream.position == found.length &&
                   entry->number == p->report.step;
        }
        if (found.code == LOG_STEP || found.code == LOG_END) {
            return false;
        }
    }
    return false;
}

/* ---- snapshots */

vbss_result vbss_log_write_session_snapshot(record_object *r, const vbss_slot *session)
{
    log_snapshot snapshot = {.number = r->step.number};
    vbss_stream stream;
    size_t count = 0;
    if (r->ended || !r->snapshot_is_last) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_snapshot_size(session, &count));
    snapshot.count = (uint32_t)count;
    vbss_stream_begin_measure(&stream);
    vbss_log_visit_session_snapshot(&stream, &snapshot);
    size_t need = log_record_bytes(&stream) + r->max_event_bytes + r->end_bytes;
    bool is_early = snapshot.number > 0 &&
                    r->log.bytes_since_session_snapshot < SNAPSHOT_GROWTH_FACTOR * (uint64_t)count;
    if (is_early || count > LOG_MAX_SNAPSHOT_BYTES || need > vbss_log_free_bytes(&r->log)) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_log_write_snapshot(r, LOG_SESSION_SNAPSHOT, session, count));
    r->log.bytes_since_session_snapshot = 0;
    r->snapshot_is_last = false;
    return VBSS_OK;
}

static vbss_result read_session_snapshot(const replay_object *p, const log_record *found,
                                         uint64_t steps, log_snapshot *snapshot)
{
    vbss_stream stream;
    vbss_stream_begin_read(&stream, found->payload, found->length);
    vbss_log_visit_session_snapshot(&stream, snapshot);
    VBSS_TRY(vbss_log_check_all_read(&p->start, found, &stream));
    return snapshot->number == steps
               ? VBSS_OK
               : vbss_log_fail_corrupt(&p->start, found->position, "a state of another step");
}

vbss_result vbss_log_find_session_snapshot(const replay_object *p, uint64_t step,
                                           log_snapshot *snapshot)
{
    log_reader log = p->start;
    uint64_t steps = 0, scene_step = 0; /* scene_step: step of the scene's newest snapshot */
    log_fault ignored;
    *snapshot = (log_snapshot){.bytes = NULL};
    for (;;) {
        log_record found;
        log.fault = steps == step ? &ignored : NULL; /* a fault after the step does not matter */
        vbss_result result = vbss_log_next_any(&log, &found);
        bool has_more = result == VBSS_OK && found.code != LOG_END;
        if (steps == step && (!has_more || found.code == LOG_STEP)) {
            return VBSS_OK;
        }
        VBSS_TRY(result);
        if (!has_more) {
            return vbss_fail(p->context, VBSS_ERROR_NOT_FOUND, "the log has no step %llu",
                             (unsigned long long)step);
        }
        steps += found.code == LOG_STEP;
        scene_step = found.code == LOG_SNAPSHOT ? steps : scene_step;
        if (found.code == LOG_SESSION_SNAPSHOT && scene_step == steps) {
            VBSS_TRY(read_session_snapshot(p, &found, steps, snapshot));
        }
    }
}
