/* Snapshots of scenes and sessions in a log: writes them, compressed if there is room for that, and
 * reads them. */
#include "base/error.h"
#include "base/memory.h"
#include "base/snapshot.h"
#include "record/compression.h"
#include "record/record.h"

/* Versions of plain ones; a packed one has the next. */
enum {
    SCENE_SNAPSHOT_VERSION = 2,
    SESSION_SNAPSHOT_VERSION = 1,
    REPLACEMENT_VERSION = 1,
    SECTION_END_BYTES = 8
};

static void visit_snapshot_record(vbss_stream *stream, uint32_t code, uint16_t plain_version,
                                  log_snapshot *snapshot)
{
    const bool reading = stream->mode == VBSS_STREAM_READ;
    vbss_section outer = vbss_stream_open(
        stream, code,
        (uint16_t)(plain_version + (reading || snapshot->compressed_bytes > 0 ? 1 : 0)));
    const bool is_compressed = stream->version > plain_version;
    snapshot->compressed_bytes = is_compressed ? snapshot->compressed_bytes : 0;
    vbss_stream_u64(stream, 1, &snapshot->number, 1);
    vbss_stream_u32(stream, 2, &snapshot->count, 1);
    if (is_compressed) {
        vbss_stream_u32(stream, 4, &snapshot->compressed_bytes, 1);
        if (snapshot->compressed_bytes == 0) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "nothing is packed");
        }
    }
    const uint16_t tag = is_compressed ? 5 : 3;
    const uint32_t count = is_compressed ? snapshot->compressed_bytes : snapshot->count;
    if (reading) {
        snapshot->bytes = vbss_stream_view_u8(stream, tag, count);
    } else {
        snapshot->destination = vbss_stream_reserve_u8(stream, tag, count);
    }
    vbss_stream_close(stream, outer);
}

void vbss_log_visit_snapshot(vbss_stream *stream, log_snapshot *snapshot)
{
    visit_snapshot_record(stream, LOG_SNAPSHOT, SCENE_SNAPSHOT_VERSION, snapshot);
}

void vbss_log_visit_session_snapshot(vbss_stream *stream, log_snapshot *snapshot)
{
    visit_snapshot_record(stream, LOG_SESSION_SNAPSHOT, SESSION_SNAPSHOT_VERSION, snapshot);
}

void vbss_log_visit_replacement(vbss_stream *stream, log_snapshot *snapshot)
{
    visit_snapshot_record(stream, LOG_REPLACEMENT, REPLACEMENT_VERSION, snapshot);
}

static void visit_by_code(vbss_stream *stream, uint32_t code, log_snapshot *snapshot)
{
    const uint16_t version = code == LOG_SNAPSHOT      ? SCENE_SNAPSHOT_VERSION
                             : code == LOG_REPLACEMENT ? REPLACEMENT_VERSION
                                                       : SESSION_SNAPSHOT_VERSION;
    visit_snapshot_record(stream, code, version, snapshot);
}

/* ---- writing */

size_t vbss_log_max_snapshot_bytes(size_t count)
{
    log_snapshot snapshot = {.count = (uint32_t)count};
    vbss_stream stream;
    vbss_stream_begin_measure(&stream);
    vbss_log_visit_snapshot(&stream, &snapshot);
    return log_record_bytes(&stream);
}

/* Saves a snapshot at the end of the free room, and compresses it to its place in the record.
 * Returns the compressed size, or 0 if there is too little room or the snapshot does not become
 * smaller. */
static size_t write_compressed(record_object *r, uint32_t code, const vbss_slot *slot,
                               log_snapshot snapshot)
{
    log_writer *log = &r->log;
    vbss_stream stream;
    size_t written = 0, used = log->is_handed_out ? 0 : log->used;
    snapshot.compressed_bytes = 1;
    vbss_stream_begin_measure(&stream);
    visit_by_code(&stream, code, &snapshot);
    const size_t start = used + LOG_PREFIX_BYTES + stream.position - SECTION_END_BYTES - 1;
    const size_t suffix_bytes = SECTION_END_BYTES + LOG_CHECKSUM_BYTES;
    if (log->format < LOG_FORMAT_COMPRESSED ||
        log->capacity < start + suffix_bytes + snapshot.count) {
        return 0;
    }
    uint8_t *raw = log->bytes + log->capacity - snapshot.count;
    if (vbss_snapshot_save(slot, raw, snapshot.count, &written) != VBSS_OK) {
        return 0;
    }
    const size_t capacity = log->capacity - snapshot.count - start - suffix_bytes;
    written = vbss_log_compress(r->hash_table, raw, snapshot.count, log->bytes + start, capacity);
    return written < snapshot.count ? written : 0;
}

vbss_result vbss_log_write_snapshot(record_object *r, uint32_t code, const vbss_slot *slot,
                                    size_t count)
{
    log_snapshot snapshot = {.number = r->step.number, .count = (uint32_t)count};
    vbss_stream stream;
    snapshot.compressed_bytes = (uint32_t)write_compressed(r, code, slot, snapshot);
    vbss_log_begin_record(&r->log, &stream);
    visit_by_code(&stream, code, &snapshot);
    VBSS_TRY(stream.result);
    if (snapshot.compressed_bytes == 0) {
        VBSS_TRY(vbss_snapshot_save(slot, snapshot.destination, count, &count));
    }
    return vbss_log_end_record(&r->log, &stream);
}

/* ---- reading */

vbss_result vbss_log_decompress_snapshot(vbss_context *context, const log_snapshot *snapshot,
                                         log_snapshot_data *data)
{
    *data = (log_snapshot_data){.bytes = snapshot->bytes, .count = snapshot->count};
    if (snapshot->compressed_bytes == 0) {
        return VBSS_OK;
    }
    /* Checked before memory is allocated, because a corrupt count may be huge. */
    if (!vbss_log_decompress(snapshot->bytes, snapshot->compressed_bytes, NULL, snapshot->count)) {
        return vbss_fail(context, VBSS_ERROR_CORRUPT,
                         "log: the snapshot after step %llu cannot be unpacked",
                         (unsigned long long)snapshot->number);
    }
    data->allocated = vbss_allocate(context, (size_t)snapshot->count + 1, 1, "snapshot of a log");
    if (data->allocated == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    (void)vbss_log_decompress(snapshot->bytes, snapshot->compressed_bytes, data->allocated,
                              snapshot->count);
    data->bytes = data->allocated;
    return VBSS_OK;
}

void vbss_log_release_snapshot(vbss_context *context, log_snapshot_data *data)
{
    vbss_release(context, data->allocated, (size_t)data->count + 1, 1);
}

vbss_result vbss_log_restore_scene(vbss_context *context, vbss_scene *scene, bool is_loaded,
                                   const log_snapshot *snapshot)
{
    log_snapshot_data data;
    VBSS_TRY(vbss_log_decompress_snapshot(context, snapshot, &data));
    vbss_result result = vbss_scene_restore(scene, data.bytes, data.count);
    if (result == VBSS_ERROR_CORRUPT && is_loaded) {
        result = vbss_scene_inspect_reload(scene, data.bytes, data.count);
    }
    vbss_log_release_snapshot(context, &data);
    return result;
}
