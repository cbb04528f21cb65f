/* Marks: what a session notes of itself behind a step. Who knows no sessions passes over them. */
#include "record/record.h"

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
