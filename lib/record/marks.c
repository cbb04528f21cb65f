/* What a session notes of itself behind a step: marks, and its state behind a snapshot of its scene. Who knows no sessions
 * passes over them. */
#include "base/error.h"
#include "base/snapshot.h"
#include "record/record.h"

/* A state is put in the log when that has grown by so many times its size: states are a third of it at most. */
enum { STATES_APART = 2 };

/* ---- marks */

static void visit(vbss_stream *stream, log_mark *mark)
{
    uint64_t words[3] = {mark->number, mark->hash, mark->events};
    vbss_section outer = vbss_stream_open(stream, LOG_MARK, 1);
    vbss_stream_u64(stream, 1, words, 3);
    vbss_stream_close(stream, outer);
    mark->number = words[0];
    mark->hash = words[1];
    mark->events = words[2];
}

vbss_result vbss_log_put_mark(record_object *r, log_mark *mark)
{
    vbss_stream stream;
    vbss_stream_begin_measure(&stream);
    visit(&stream, mark);
    size_t need = log_record_bytes(&stream) + r->event_bytes + r->end_bytes;
    if (r->ended || need > vbss_log_room(&r->log)) {
        return VBSS_OK;
    }
    vbss_log_open(&r->log, &stream);
    visit(&stream, mark);
    return vbss_log_seal(&r->log, &stream);
}

bool vbss_log_find_mark(const replay_object *p, log_mark *mark)
{
    log_reader next = p->log;
    log_fault unwanted;
    log_found found;
    next.fault = &unwanted;
    while (vbss_log_next_of_any_kind(&next, &found) == VBSS_OK) {
        if (found.code == LOG_MARK) {
            vbss_stream stream;
            vbss_stream_begin_read(&stream, found.payload, found.length);
            visit(&stream, mark);
            return stream.result == VBSS_OK && stream.position == found.length &&
                   mark->number == p->report.step;
        }
        if (found.code == LOG_STEP || found.code == LOG_END) {
            return false;
        }
    }
    return false;
}

/* ---- states */

vbss_result vbss_log_put_state(record_object *r, const vbss_slot *session)
{
    log_snapshot state = {.number = r->step.number};
    vbss_stream stream;
    size_t count = 0;
    if (r->ended || !r->snapshot_is_last) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_snapshot_size(session, &count));
    state.count = (uint32_t)count;
    vbss_stream_begin_measure(&stream);
    vbss_log_visit_state(&stream, &state);
    size_t need = log_record_bytes(&stream) + r->event_bytes + r->end_bytes;
    bool early = state.number > 0 && r->log.grown < STATES_APART * (uint64_t)count;
    if (early || count > LOG_SNAPSHOT_MOST || need > vbss_log_room(&r->log)) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_log_put_snapshot(r, LOG_STATE, session, count));
    r->log.grown = 0;
    r->snapshot_is_last = false;
    return VBSS_OK;
}

static vbss_result read_state(const replay_object *p, const log_found *found, uint64_t steps,
                              log_snapshot *state)
{
    vbss_stream stream;
    vbss_stream_begin_read(&stream, found->payload, found->length);
    vbss_log_visit_state(&stream, state);
    VBSS_TRY(vbss_log_read_all(&p->begin, found, &stream));
    return state->number == steps
               ? VBSS_OK
               : vbss_log_corrupt(&p->begin, found->at, "a state of another step");
}

vbss_result vbss_log_find_state(const replay_object *p, uint64_t step, log_snapshot *state)
{
    log_reader log = p->begin;
    uint64_t steps = 0, scene = 0; /* scene: of its newest snapshot */
    log_fault beyond;
    *state = (log_snapshot){.bytes = NULL};
    for (;;) {
        log_found found;
        log.fault = steps == step ? &beyond : NULL; /* what follows the step is read in its turn */
        vbss_result result = vbss_log_next_of_any_kind(&log, &found);
        bool on = result == VBSS_OK && found.code != LOG_END;
        if (steps == step && (!on || found.code == LOG_STEP)) {
            return VBSS_OK;
        }
        VBSS_TRY(result);
        if (!on) {
            return vbss_fail(p->context, VBSS_ERROR_OUT_OF_RANGE, "the log has no step %llu",
                             (unsigned long long)step);
        }
        steps += found.code == LOG_STEP;
        scene = found.code == LOG_SNAPSHOT ? steps : scene;
        if (found.code == LOG_STATE && scene == steps) {
            VBSS_TRY(read_state(p, &found, steps, state));
        }
    }
}
