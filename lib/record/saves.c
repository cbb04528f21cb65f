/* Snapshots of scenes and states of sessions in a log: written, packed where there is room for it, and unpacked. */
#include "base/error.h"
#include "base/snapshot.h"
#include "record/pack.h"
#include "record/record.h"

/* Versions of plain ones; a packed one has the next. */
enum { PLAIN_SNAPSHOT = 2, PLAIN_STATE = 1, CLOSE_BYTES = 8 };

static void visit(vbss_stream *stream, uint32_t code, uint16_t plain, log_snapshot *snapshot)
{
    const bool reading = stream->mode == VBSS_STREAM_READ;
    vbss_section outer = vbss_stream_open(
        stream, code, (uint16_t)(plain + (reading || snapshot->packed_count > 0 ? 1 : 0)));
    const bool packed = stream->version > plain;
    snapshot->packed_count = packed ? snapshot->packed_count : 0;
    vbss_stream_u64(stream, 1, &snapshot->number, 1);
    vbss_stream_u32(stream, 2, &snapshot->count, 1);
    if (packed) {
        vbss_stream_u32(stream, 4, &snapshot->packed_count, 1);
        if (snapshot->packed_count == 0) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "nothing is packed");
        }
    }
    const uint16_t tag = packed ? 5 : 3;
    const uint32_t count = packed ? snapshot->packed_count : snapshot->count;
    if (reading) {
        snapshot->bytes = vbss_stream_view_u8(stream, tag, count);
    } else {
        snapshot->place = vbss_stream_reserve_u8(stream, tag, count);
    }
    vbss_stream_close(stream, outer);
}

void vbss_log_visit_snapshot(vbss_stream *stream, log_snapshot *snapshot)
{
    visit(stream, LOG_SNAPSHOT, PLAIN_SNAPSHOT, snapshot);
}

void vbss_log_visit_state(vbss_stream *stream, log_snapshot *state)
{
    visit(stream, LOG_STATE, PLAIN_STATE, state);
}

static void visit_either(vbss_stream *stream, uint32_t code, log_snapshot *snapshot)
{
    visit(stream, code, code == LOG_SNAPSHOT ? PLAIN_SNAPSHOT : PLAIN_STATE, snapshot);
}

/* ---- writing */

size_t vbss_log_snapshot_bytes(size_t count)
{
    log_snapshot snapshot = {.count = (uint32_t)count};
    vbss_stream stream;
    vbss_stream_begin_measure(&stream);
    vbss_log_visit_snapshot(&stream, &snapshot);
    return log_record_bytes(&stream);
}

/* Saves at the end of the room and packs to where the record shall have it. The bytes that this takes; 0: there
 * is too little room, or it would be no shorter. */
static size_t pack(record_object *r, uint32_t code, const vbss_slot *slot, log_snapshot snapshot)
{
    log_writer *log = &r->log;
    vbss_stream stream;
    size_t written = 0, used = log->taken ? 0 : log->used;
    snapshot.packed_count = 1;
    vbss_stream_begin_measure(&stream);
    visit_either(&stream, code, &snapshot);
    const size_t place = used + LOG_BEFORE + stream.position - CLOSE_BYTES - 1;
    const size_t after = CLOSE_BYTES + LOG_AFTER;
    if (log->format < FORMAT_PACKED || log->capacity < place + after + snapshot.count) {
        return 0;
    }
    uint8_t *raw = log->bytes + log->capacity - snapshot.count;
    if (vbss_snapshot_save(slot, raw, snapshot.count, &written) != VBSS_OK) {
        return 0;
    }
    const size_t room = log->capacity - snapshot.count - place - after;
    written = vbss_log_pack(r->table, raw, snapshot.count, log->bytes + place, room);
    return written < snapshot.count ? written : 0;
}

vbss_result vbss_log_put_snapshot(record_object *r, uint32_t code, const vbss_slot *slot,
                                  size_t count)
{
    log_snapshot snapshot = {.number = r->step.number, .count = (uint32_t)count};
    vbss_stream stream;
    snapshot.packed_count = (uint32_t)pack(r, code, slot, snapshot);
    vbss_log_open(&r->log, &stream);
    visit_either(&stream, code, &snapshot);
    VBSS_TRY(stream.result);
    if (snapshot.packed_count == 0) {
        VBSS_TRY(vbss_snapshot_save(slot, snapshot.place, count, &count));
    }
    return vbss_log_seal(&r->log, &stream);
}

/* ---- reading */

vbss_result vbss_log_unpack_snapshot(vbss_context *context, const log_snapshot *snapshot,
                                     log_unpacked *unpacked)
{
    *unpacked = (log_unpacked){.bytes = snapshot->bytes, .count = snapshot->count};
    if (snapshot->packed_count == 0) {
        return VBSS_OK;
    }
    /* before memory is asked for, as the count may be any */
    if (!vbss_log_unpack(snapshot->bytes, snapshot->packed_count, NULL, snapshot->count)) {
        return vbss_fail(context, VBSS_ERROR_CORRUPT,
                         "log: the snapshot after step %llu cannot be unpacked",
                         (unsigned long long)snapshot->number);
    }
    unpacked->own = vbss_allocate(context, (size_t)snapshot->count + 1, 1, "snapshot of a log");
    if (unpacked->own == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    (void)vbss_log_unpack(snapshot->bytes, snapshot->packed_count, unpacked->own, snapshot->count);
    unpacked->bytes = unpacked->own;
    return VBSS_OK;
}

void vbss_log_release_snapshot(vbss_context *context, log_unpacked *unpacked)
{
    vbss_release(context, unpacked->own, (size_t)unpacked->count + 1, 1);
}

vbss_result vbss_log_restore_scene(vbss_context *context, vbss_scene *scene,
                                   const log_snapshot *snapshot)
{
    log_unpacked unpacked;
    VBSS_TRY(vbss_log_unpack_snapshot(context, snapshot, &unpacked));
    vbss_result result = vbss_scene_restore(scene, unpacked.bytes, unpacked.count);
    vbss_log_release_snapshot(context, &unpacked);
    return result;
}
