/* The envelope of a snapshot: "VBSS", format, payload length, payload, and XXH64 of all bytes
 * before it. */
#include <string.h>

#include "base/check.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/little_endian.h"
#include "base/memory.h"
#include "base/slot.h"
#include "base/snapshot.h"
#include "base/stream.h"

#define MAGIC VBSS_CODE('V', 'B', 'S', 'S')
#define FORMAT 1u
#define ENVELOPE_HEADER_BYTES 16u /* magic u32, format u32, payload length u64 */
#define ENVELOPE_TRAILER_BYTES 8u

static void visit(vbss_stream *stream, const vbss_slot *slot)
{
    vbss_section outer = vbss_stream_open(stream, slot->kind->code, slot->kind->version);
    slot->kind->serialise(stream, slot->object);
    vbss_stream_close(stream, outer);
}

static vbss_result report_result(const vbss_slot *slot, const vbss_stream *stream, const char *what)
{
    if (stream->result == VBSS_OK) {
        return VBSS_OK;
    }
    uint32_t code = stream->section;
    return vbss_fail(slot->context, stream->result,
                     "%s %s: %s (section %c%c%c%c, field %u, byte %llu)", slot->kind->name, what,
                     stream->problem, (char)(code & 0x7fu), (char)(code >> 8 & 0x7fu),
                     (char)(code >> 16 & 0x7fu), (char)(code >> 24 & 0x7fu), stream->tag,
                     (unsigned long long)stream->position);
}

vbss_result vbss_snapshot_size(const vbss_slot *slot, size_t *bytes)
{
    vbss_stream stream;
    vbss_stream_begin_measure(&stream);
    visit(&stream, slot);
    *bytes = ENVELOPE_HEADER_BYTES + stream.position + ENVELOPE_TRAILER_BYTES;
    return report_result(slot, &stream, "size");
}

vbss_result vbss_snapshot_hash(const vbss_slot *slot, uint64_t *hash)
{
    vbss_stream stream;
    vbss_stream_begin_hash(&stream);
    visit(&stream, slot);
    *hash = vbss_hash_end(&stream.hash);
    return report_result(slot, &stream, "hash");
}

static uint64_t checksum(const uint8_t *bytes, size_t count)
{
    vbss_hash hash;
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, bytes, count);
    return vbss_hash_end(&hash);
}

vbss_result vbss_snapshot_save(const vbss_slot *slot, uint8_t *bytes, size_t capacity,
                               size_t *written)
{
    if (capacity < ENVELOPE_HEADER_BYTES + ENVELOPE_TRAILER_BYTES) {
        return vbss_fail(slot->context, VBSS_ERROR_CAPACITY, "%s save: the buffer is too small",
                         slot->kind->name);
    }
    vbss_stream stream;
    vbss_stream_begin_write(&stream, bytes + ENVELOPE_HEADER_BYTES,
                            capacity - ENVELOPE_HEADER_BYTES - ENVELOPE_TRAILER_BYTES);
    visit(&stream, slot);
    VBSS_TRY(report_result(slot, &stream, "save"));
    store_little_endian(bytes, (uint64_t)FORMAT << 32 | MAGIC, 8);
    store_little_endian(bytes + 8, stream.position, 8);
    size_t covered = ENVELOPE_HEADER_BYTES + stream.position;
    store_little_endian(bytes + covered, checksum(bytes, covered), 8);
    *written = covered + ENVELOPE_TRAILER_BYTES;
    return VBSS_OK;
}

/* Checks everything that does not need the object, and returns the length of the payload. */
static vbss_result open_envelope(const vbss_slot *slot, const uint8_t *bytes, size_t count,
                                 size_t *payload)
{
    const char *name = slot->kind->name;
    if (count < ENVELOPE_HEADER_BYTES + ENVELOPE_TRAILER_BYTES) {
        return vbss_fail(slot->context, VBSS_ERROR_TRUNCATED,
                         "%s restore: %llu bytes are no snapshot", name, (unsigned long long)count);
    }
    uint64_t header = load_little_endian(bytes, 8);
    if ((uint32_t)header != MAGIC) {
        return vbss_fail(slot->context, VBSS_ERROR_CORRUPT, "%s restore: this is no snapshot",
                         name);
    }
    if (header >> 32 != FORMAT) {
        return vbss_fail(slot->context, VBSS_ERROR_DATA_VERSION,
                         "%s restore: snapshot format %u, this library reads %u", name,
                         (unsigned)(header >> 32), FORMAT);
    }
    uint64_t length = load_little_endian(bytes + 8, 8);
    if (length != count - ENVELOPE_HEADER_BYTES - ENVELOPE_TRAILER_BYTES) {
        return vbss_fail(
            slot->context, VBSS_ERROR_TRUNCATED,
            "%s restore: %llu bytes where the snapshot says %llu", name,
            (unsigned long long)(count - ENVELOPE_HEADER_BYTES - ENVELOPE_TRAILER_BYTES),
            (unsigned long long)length);
    }
    size_t covered = ENVELOPE_HEADER_BYTES + (size_t)length;
    if (checksum(bytes, covered) != load_little_endian(bytes + covered, 8)) {
        return vbss_fail(slot->context, VBSS_ERROR_CORRUPT, "%s restore: the checksum differs",
                         name);
    }
    *payload = (size_t)length;
    return VBSS_OK;
}

vbss_result vbss_snapshot_restore(vbss_slot *slot, const uint8_t *bytes, size_t count)
{
    vbss_context *context = slot->context;
    size_t payload = 0;
    VBSS_TRY(vbss_context_edit(context));
    VBSS_TRY(vbss_check_pointer(context, bytes, "snapshot"));
    VBSS_TRY(open_envelope(slot, bytes, count, &payload));

    /* A valid envelope can still hold the state of another object, which shows only halfway
     * through. A backup of the present state allows the object to return to it. The backup is
     * trusted: it may contain values that a visitor would refuse. A NaN returns as the canonical
     * NaN. */
    vbss_stream stream;
    vbss_stream_begin_measure(&stream);
    stream.trusted = true;
    visit(&stream, slot);
    size_t backup_bytes = stream.position;
    uint8_t *backup = vbss_allocate(context, backup_bytes, 1, "way back of a restore");
    if (backup == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    vbss_stream_begin_write(&stream, backup, backup_bytes);
    stream.trusted = true;
    visit(&stream, slot);
    vbss_result result = report_result(slot, &stream, "restore");

    if (result == VBSS_OK) {
        vbss_stream_begin_read(&stream, bytes + ENVELOPE_HEADER_BYTES, payload);
        visit(&stream, slot);
        if (stream.position != payload) {
            vbss_stream_refuse(&stream, VBSS_ERROR_CORRUPT, "data follow the state");
        }
        const vbss_stream found = stream;
        if (found.result != VBSS_OK) {
            /* Restore before reporting, because a log callback may read the object. */
            vbss_stream_begin_read(&stream, backup, backup_bytes);
            stream.trusted = true;
            visit(&stream, slot);
        }
        result = report_result(slot, &found, "restore");
    }
    vbss_release(context, backup, backup_bytes, 1);
    return result;
}

/* ---- bodies of public functions */

vbss_result vbss_object_save(const void *handle, const vbss_kind *kind, uint8_t *bytes,
                             uint64_t capacity, uint64_t *written)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, kind, &slot));
    VBSS_TRY(vbss_check_pointer(slot->context, written, "written"));
    size_t need = 0;
    VBSS_TRY(vbss_snapshot_size(slot, &need));
    *written = need;
    if (bytes == NULL && capacity == 0) {
        return VBSS_ERROR_CAPACITY; /* a size query does not fail, so it leaves no error text */
    }
    if (capacity < need) {
        return vbss_fail(slot->context, VBSS_ERROR_CAPACITY, "%s save: %llu bytes of %llu",
                         kind->name, (unsigned long long)capacity, (unsigned long long)need);
    }
    if (bytes == NULL) {
        return vbss_check_pointer(slot->context, bytes, "bytes");
    }
    return vbss_snapshot_save(slot, bytes, need, &need);
}

vbss_result vbss_object_restore(const void *handle, const vbss_kind *kind, const uint8_t *bytes,
                                uint64_t count)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, kind, &slot));
    if (slot->owner != NULL) {
        return vbss_fail(slot->context, VBSS_ERROR_IN_SCENE, "%s restore: it belongs to a scene",
                         kind->name);
    }
    if (count > SIZE_MAX) {
        return vbss_fail(slot->context, VBSS_ERROR_CORRUPT, "%s restore: count is too large",
                         kind->name);
    }
    return vbss_snapshot_restore(slot, bytes, (size_t)count);
}

vbss_result vbss_object_hash(const void *handle, const vbss_kind *kind, uint64_t *hash)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, kind, &slot));
    VBSS_TRY(vbss_check_pointer(slot->context, hash, "hash"));
    return vbss_snapshot_hash(slot, hash);
}
