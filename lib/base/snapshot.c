/* The envelope of a snapshot: "VBSS", format, length of the state, in format 2 length of the
 * description, state, description, and XXH64 of all bytes before it. Kinds without a description
 * have format 1. */
#include <stdio.h>
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
enum { FORMAT_STATE = 1, FORMAT_DESCRIBED = 2 };
#define HEADER_BYTES 16u           /* magic u32, format u32, length of the state u64 */
#define DESCRIBED_HEADER_BYTES 24u /* the same, length of the description u64 */
#define ENVELOPE_TRAILER_BYTES 8u

static size_t header_bytes(uint32_t format)
{
    return format == FORMAT_DESCRIBED ? DESCRIBED_HEADER_BYTES : HEADER_BYTES;
}

static uint32_t format_of(const vbss_slot *slot)
{
    return slot->kind->serialise_description != NULL ? FORMAT_DESCRIBED : FORMAT_STATE;
}

static void visit(vbss_stream *stream, const vbss_slot *slot)
{
    vbss_section outer = vbss_stream_open(stream, slot->kind->code, slot->kind->version);
    slot->kind->serialise(stream, slot->object);
    vbss_stream_close(stream, outer);
}

static void visit_description(vbss_stream *stream, const vbss_slot *slot)
{
    if (slot->kind->serialise_description != NULL) {
        slot->kind->serialise_description(stream, slot->object);
    }
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
    visit_description(&stream, slot);
    *bytes = header_bytes(format_of(slot)) + stream.position + ENVELOPE_TRAILER_BYTES;
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
    const uint32_t format = format_of(slot);
    const size_t header = header_bytes(format);
    if (capacity < header + ENVELOPE_TRAILER_BYTES) {
        return vbss_fail(slot->context, VBSS_ERROR_CAPACITY, "%s save: the buffer is too small",
                         slot->kind->name);
    }
    vbss_stream stream;
    vbss_stream_begin_write(&stream, bytes + header, capacity - header - ENVELOPE_TRAILER_BYTES);
    visit(&stream, slot);
    const size_t state = stream.position;
    visit_description(&stream, slot);
    VBSS_TRY(report_result(slot, &stream, "save"));
    store_little_endian(bytes, (uint64_t)format << 32 | MAGIC, 8);
    store_little_endian(bytes + 8, state, 8);
    if (format == FORMAT_DESCRIBED) {
        store_little_endian(bytes + 16, stream.position - state, 8);
    }
    size_t covered = header + stream.position;
    store_little_endian(bytes + covered, checksum(bytes, covered), 8);
    *written = covered + ENVELOPE_TRAILER_BYTES;
    return VBSS_OK;
}

vbss_result vbss_snapshot_open(vbss_context *context, const char *what, const uint8_t *bytes,
                               size_t count, vbss_snapshot_parts *parts)
{
    if (count < HEADER_BYTES + ENVELOPE_TRAILER_BYTES) {
        return vbss_fail(context, VBSS_ERROR_TRUNCATED, "%s: %llu bytes are no snapshot", what,
                         (unsigned long long)count);
    }
    const uint64_t start = load_little_endian(bytes, 8);
    const uint32_t format = (uint32_t)(start >> 32);
    if ((uint32_t)start != MAGIC) {
        return vbss_fail(context, VBSS_ERROR_CORRUPT, "%s: this is no snapshot", what);
    }
    if (format != FORMAT_STATE && format != FORMAT_DESCRIBED) {
        return vbss_fail(context, VBSS_ERROR_DATA_VERSION,
                         "%s: snapshot format %u, this library reads up to %u", what, format,
                         (unsigned)FORMAT_DESCRIBED);
    }
    const size_t header = header_bytes(format);
    const uint64_t room =
        count >= header + ENVELOPE_TRAILER_BYTES ? count - header - ENVELOPE_TRAILER_BYTES : 0;
    const uint64_t state = load_little_endian(bytes + 8, 8);
    const uint64_t description = format == FORMAT_DESCRIBED ? load_little_endian(bytes + 16, 8) : 0;
    if (state > room || description != room - state) {
        return vbss_fail(context, VBSS_ERROR_TRUNCATED,
                         "%s: %llu bytes where the snapshot says %llu and %llu", what,
                         (unsigned long long)room, (unsigned long long)state,
                         (unsigned long long)description);
    }
    const size_t covered = header + (size_t)room;
    if (checksum(bytes, covered) != load_little_endian(bytes + covered, 8)) {
        return vbss_fail(context, VBSS_ERROR_CORRUPT, "%s: the checksum differs", what);
    }
    *parts = (vbss_snapshot_parts){.state = bytes + header,
                                   .state_bytes = (size_t)state,
                                   .description = bytes + header + (size_t)state,
                                   .description_bytes = (size_t)description};
    return VBSS_OK;
}

vbss_result vbss_snapshot_restore(vbss_slot *slot, const uint8_t *bytes, size_t count)
{
    vbss_context *context = slot->context;
    vbss_snapshot_parts parts = {0};
    char what[48];
    VBSS_TRY(vbss_context_edit(context));
    VBSS_TRY(vbss_check_pointer(context, bytes, "snapshot"));
    snprintf(what, sizeof what, "%s restore", slot->kind->name);
    VBSS_TRY(vbss_snapshot_open(context, what, bytes, count, &parts));

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
        vbss_stream_begin_read(&stream, parts.state, parts.state_bytes);
        visit(&stream, slot);
        if (stream.position != parts.state_bytes) {
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
