/* The visitor behind snapshots, hashes and logs; only the mode decides what a visit does. */
#include <math.h>
#include <string.h>

#include "base/fields.h"
#include "base/hash.h"
#include "base/little_endian.h"
#include "base/stream.h"

enum { TYPE_F64 = 1, TYPE_U64 = 2, TYPE_U32 = 3, TYPE_I32 = 4, TYPE_U8 = 5 };
#define TAG_OPEN 0xfffeu
#define TAG_CLOSE 0xffffu
#define HEADER_BYTES 8u
/* The one NaN that is written: processors make NaNs with different signs. */
#define QUIET_NAN_BITS 0x7ff8000000000000u
/* Values converted at a time on the way to little-endian bytes. */
#define CHUNK 64u

/* ---- start and failure */

static void begin(vbss_stream *stream, vbss_stream_mode mode)
{
    memset(stream, 0, sizeof *stream);
    stream->mode = mode;
}

void vbss_stream_begin_measure(vbss_stream *stream)
{
    begin(stream, VBSS_STREAM_MEASURE);
}

void vbss_stream_begin_write(vbss_stream *stream, uint8_t *bytes, size_t capacity)
{
    begin(stream, VBSS_STREAM_WRITE);
    stream->out = bytes;
    stream->capacity = capacity;
}

void vbss_stream_begin_hash(vbss_stream *stream)
{
    begin(stream, VBSS_STREAM_HASH);
    vbss_hash_begin(&stream->hash);
}

void vbss_stream_begin_read(vbss_stream *stream, const uint8_t *bytes, size_t count)
{
    begin(stream, VBSS_STREAM_READ);
    stream->in = bytes;
    stream->capacity = count;
}

/* Failures of the format itself, which also apply to a trusted stream. */
static void stop(vbss_stream *stream, vbss_result result, const char *problem)
{
    if (stream->result == VBSS_OK) {
        stream->result = result;
        stream->problem = problem;
    }
}

void vbss_stream_refuse(vbss_stream *stream, vbss_result result, const char *problem)
{
    if (!stream->trusted) {
        stop(stream, result, problem);
    }
}

void vbss_stream_bool(vbss_stream *stream, uint16_t tag, bool *value)
{
    uint32_t word = *value;
    vbss_stream_u32(stream, tag, &word, 1);
    if (word > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "neither yes nor no");
    }
    *value = word != 0;
}

/* ---- bytes in and out */

/* Measuring needs no conversion of the values. */
static bool measure(vbss_stream *stream, size_t bytes)
{
    stream->position += stream->mode == VBSS_STREAM_MEASURE ? bytes : 0;
    return stream->mode == VBSS_STREAM_MEASURE;
}

/* Stops a writing stream that has no room for so many bytes. */
static bool has_room(vbss_stream *stream, size_t count)
{
    if (stream->mode == VBSS_STREAM_WRITE && count > stream->capacity - stream->position) {
        stop(stream, VBSS_ERROR_CAPACITY, "the buffer is too small");
        return false;
    }
    return true;
}

static void put(vbss_stream *stream, const uint8_t *bytes, size_t count)
{
    enum { SHORT = 64 };
    if (!has_room(stream, count)) {
        return;
    }
    if (stream->mode == VBSS_STREAM_WRITE) {
        if (count <= SHORT) {
            copy_short(stream->out + stream->position, bytes, count);
        } else {
            memcpy(stream->out + stream->position, bytes, count);
        }
    } else if (stream->mode == VBSS_STREAM_HASH) {
        vbss_hash_add(&stream->hash, bytes, count);
    }
    stream->position += count;
}

/* The next `count` bytes, or NULL with the failure stored. */
static const uint8_t *get(vbss_stream *stream, size_t count)
{
    if (count > stream->capacity - stream->position) {
        stop(stream, VBSS_ERROR_TRUNCATED, "the data end inside a field");
        return NULL;
    }
    const uint8_t *bytes = stream->in + stream->position;
    stream->position += count;
    return bytes;
}

/* ---- sections */

vbss_section vbss_stream_open(vbss_stream *stream, uint32_t code, uint16_t version)
{
    vbss_section outer = {stream->section, stream->version};
    if (stream->result != VBSS_OK) {
        return outer;
    }
    stream->section = code;
    stream->version = version;
    stream->tag = 0;
    if (stream->mode != VBSS_STREAM_READ) {
        uint8_t header[HEADER_BYTES];
        store_little_endian(header, TAG_OPEN, 2);
        store_little_endian(header + 2, version, 2);
        store_little_endian(header + 4, code, 4);
        put(stream, header, sizeof header);
        return outer;
    }
    const uint8_t *header = get(stream, HEADER_BYTES);
    if (header == NULL) {
        return outer;
    }
    if (load_little_endian(header, 2) != TAG_OPEN || load_little_endian(header + 4, 4) != code) {
        stop(stream, VBSS_ERROR_CORRUPT, "another section was expected");
    }
    stream->version = (uint16_t)load_little_endian(header + 2, 2);
    if (stream->version == 0) {
        stop(stream, VBSS_ERROR_CORRUPT, "no section has version 0");
    }
    if (stream->version > version) {
        stop(stream, VBSS_ERROR_DATA_VERSION, "the section was written by a newer library");
    }
    return outer;
}

bool vbss_stream_has_section(const vbss_stream *stream, uint32_t code)
{
    const uint8_t *header = stream->in + stream->position;
    return stream->mode == VBSS_STREAM_READ && stream->result == VBSS_OK &&
           HEADER_BYTES <= stream->capacity - stream->position &&
           load_little_endian(header, 2) == TAG_OPEN && load_little_endian(header + 4, 4) == code;
}

void vbss_stream_close(vbss_stream *stream, vbss_section outer)
{
    if (stream->result != VBSS_OK) {
        return; /* keeps the section for the error text */
    }
    uint8_t end[HEADER_BYTES] = {0};
    store_little_endian(end, TAG_CLOSE, 2);
    if (stream->mode == VBSS_STREAM_READ) {
        const uint8_t *header = get(stream, HEADER_BYTES);
        if (header != NULL && memcmp(header, end, HEADER_BYTES) != 0) {
            stop(stream, VBSS_ERROR_CORRUPT, "the section does not end where it should");
        }
    } else {
        put(stream, end, sizeof end);
    }
    if (stream->result == VBSS_OK) {
        stream->section = outer.code;
        stream->version = outer.version;
    }
}

/* ---- fields */

/* Writes or checks the header of a field; false when there is nothing more to do. */
static bool begin_field(vbss_stream *stream, uint16_t tag, uint8_t type, size_t count)
{
    if (stream->result != VBSS_OK) {
        return false;
    }
    stream->tag = tag;
    if (tag >= TAG_OPEN || count > UINT32_MAX) {
        stop(stream, VBSS_ERROR_CAPACITY, "the field is too large for the format");
        return false;
    }
    if (stream->mode != VBSS_STREAM_READ) {
        uint8_t header[HEADER_BYTES];
        store_little_endian(header, tag, 2);
        header[2] = type;
        header[3] = 0;
        store_little_endian(header + 4, count, 4);
        put(stream, header, sizeof header);
        return stream->result == VBSS_OK;
    }
    const uint8_t *header = get(stream, HEADER_BYTES);
    if (header == NULL) {
        return false;
    }
    if (load_little_endian(header, 2) != tag || header[2] != type || header[3] != 0 ||
        load_little_endian(header + 4, 4) != count) {
        stop(stream, VBSS_ERROR_CORRUPT, "another field was expected");
        return false;
    }
    return true;
}

static bool has_nan(const double *values, size_t count)
{
    bool found = false;
    for (size_t i = 0; i < count; i++) {
        found |= values[i] != values[i];
    }
    return found;
}

/* Puts values that need a conversion. */
static void put_converted_f64(vbss_stream *stream, const double *values, size_t count)
{
    uint8_t chunk[8 * CHUNK];
    for (size_t done = 0; done < count; done += CHUNK) {
        size_t now = count - done < CHUNK ? count - done : CHUNK;
        for (size_t i = 0; i < now; i++) {
            double value = values[done + i];
            uint64_t bits;
            memcpy(&bits, &value, sizeof bits);
            store_little_endian(chunk + 8 * i, value == value ? bits : QUIET_NAN_BITS, 8);
        }
        put(stream, chunk, 8 * now);
    }
}

void vbss_stream_f64(vbss_stream *stream, uint16_t tag, double *values, size_t count)
{
    if (!begin_field(stream, tag, TYPE_F64, count)) {
        return;
    }
    if (stream->mode == VBSS_STREAM_READ) {
        const uint8_t *bytes = get(stream, 8 * count);
        for (size_t i = 0; bytes != NULL && i < count; i++) {
            uint64_t bits = load_little_endian(bytes + 8 * i, 8);
            double value;
            memcpy(&value, &bits, sizeof value);
            if (!isfinite(value) && !stream->trusted) {
                stop(stream, VBSS_ERROR_CORRUPT, "a number is not finite");
                return;
            }
            values[i] = value;
        }
        return;
    }
    if (measure(stream, 8 * count) || !has_room(stream, 8 * count)) {
        return;
    }
    if (VBSS_LITTLE_ENDIAN && !has_nan(values, count)) {
        put(stream, (const uint8_t *)values, 8 * count);
    } else {
        put_converted_f64(stream, values, count);
    }
}

/* The integer types differ only in width; the values pass through 64 bits. */
/* NOLINTBEGIN(bugprone-macro-parentheses): C has no parentheses around a type */
#define DEFINE_INTEGER_FIELD(name, type_name, type_code)                                   \
    void name(vbss_stream *stream, uint16_t tag, type_name *values, size_t count)          \
    {                                                                                      \
        enum { WIDTH = sizeof(type_name) };                                                \
        if (!begin_field(stream, tag, type_code, count)) {                                 \
            return;                                                                        \
        }                                                                                  \
        if (stream->mode == VBSS_STREAM_READ) {                                            \
            const uint8_t *bytes = get(stream, WIDTH * count);                             \
            for (size_t i = 0; bytes != NULL && i < count; i++) {                          \
                values[i] = (type_name)load_little_endian(bytes + WIDTH * i, WIDTH);       \
            }                                                                              \
            return;                                                                        \
        }                                                                                  \
        if (measure(stream, WIDTH * count) || !has_room(stream, WIDTH * count)) {          \
            return;                                                                        \
        }                                                                                  \
        if (VBSS_LITTLE_ENDIAN) {                                                          \
            put(stream, (const uint8_t *)values, WIDTH *count);                            \
            return;                                                                        \
        }                                                                                  \
        uint8_t chunk[WIDTH * CHUNK];                                                      \
        for (size_t done = 0; done < count; done += CHUNK) {                               \
            size_t now = count - done < CHUNK ? count - done : CHUNK;                      \
            for (size_t i = 0; i < now; i++) {                                             \
                store_little_endian(chunk + WIDTH * i, (uint64_t)values[done + i], WIDTH); \
            }                                                                              \
            put(stream, chunk, sizeof(type_name) * now);                                   \
        }                                                                                  \
    }

/* NOLINTEND(bugprone-macro-parentheses) */
DEFINE_INTEGER_FIELD(vbss_stream_u64, uint64_t, TYPE_U64)
DEFINE_INTEGER_FIELD(vbss_stream_u32, uint32_t, TYPE_U32)
DEFINE_INTEGER_FIELD(vbss_stream_i32, int32_t, TYPE_I32)
DEFINE_INTEGER_FIELD(vbss_stream_u8, uint8_t, TYPE_U8)

const uint8_t *vbss_stream_view_u8(vbss_stream *stream, uint16_t tag, size_t count)
{
    return begin_field(stream, tag, TYPE_U8, count) ? get(stream, count) : NULL;
}

uint8_t *vbss_stream_reserve_u8(vbss_stream *stream, uint16_t tag, size_t count)
{
    if (!begin_field(stream, tag, TYPE_U8, count)) {
        return NULL;
    }
    uint8_t *target = stream->mode == VBSS_STREAM_WRITE ? stream->out + stream->position : NULL;
    if (target != NULL && count > stream->capacity - stream->position) {
        stop(stream, VBSS_ERROR_CAPACITY, "the buffer is too small");
        return NULL;
    }
    stream->position += count;
    return target;
}

/* ---- fields with a meaning */

void vbss_stream_count(vbss_stream *stream, uint16_t tag, uint32_t *value, uint32_t capacity)
{
    uint32_t count = *value;
    vbss_stream_u32(stream, tag, &count, 1);
    if (count > capacity) { /* checked when writing too: the visitor's next line relies on it */
        stop(stream, VBSS_ERROR_CAPACITY, "the state is larger than the object's capacity");
    }
    if (stream->result == VBSS_OK) {
        *value = count;
    }
}

void vbss_stream_expect(vbss_stream *stream, uint16_t tag, uint64_t value)
{
    uint64_t stored = value;
    vbss_stream_u64(stream, tag, &stored, 1);
    if (stored != value) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT,
                           "the state belongs to an object with another configuration");
    }
}

void vbss_stream_expect_f64(vbss_stream *stream, uint16_t tag, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    vbss_stream_expect(stream, tag, bits);
}

/* ---- structs */

void vbss_stream_field(vbss_stream *stream, uint16_t tag, const vbss_field *field, void *values)
{
    if (field->since > stream->version) {
        return;
    }
    if (field->type == VBSS_FIELD_U32) {
        vbss_stream_u32(stream, tag, values, field->count);
    } else {
        vbss_stream_f64(stream, tag, values, field->count);
    }
}

void vbss_stream_fields(vbss_stream *stream, const vbss_field *fields, size_t count, void *object)
{
    for (size_t i = 0; i < count; i++) {
        vbss_stream_field(stream, (uint16_t)i, &fields[i], (char *)object + fields[i].offset);
    }
}
