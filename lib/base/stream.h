/* Stream: one visitor writes, measures, hashes and reads a state.
 *
 * A body has one function that visits its fields in order; the stream's mode decides what a visit
 * does. The bytes are little-endian on every machine and self-describing:
 *   section  u16 0xfffe, u16 version, u32 code;  field  u16 tag, u8 type, u8 0, u32 count, values;
 *   section end  u16 0xffff, u16 0, u32 0.
 * The first failure is kept in `result` and turns all later visits into nothing, so a visitor reads
 * top to bottom without tests. A field that came with version k is visited if stream->version >= k,
 * and set to its default otherwise; data of a newer version are refused. Signed zeros are kept; any
 * NaN is written as the one quiet NaN; reading a value that is not finite is VBSS_ERROR_CORRUPT. */
#ifndef VBSS_BASE_STREAM_H
#define VBSS_BASE_STREAM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <vblast_ss/base.h>

#include "base/hash.h"

typedef enum vbss_stream_mode {
    VBSS_STREAM_MEASURE,
    VBSS_STREAM_WRITE,
    VBSS_STREAM_HASH,
    VBSS_STREAM_READ
} vbss_stream_mode;
typedef struct vbss_stream {
    vbss_stream_mode mode;
    vbss_result result;
    const char *problem; /* what went wrong, a constant text */
    uint32_t section;    /* code of the innermost open section, for error texts */
    uint16_t version;    /* its version: when reading, the one it was written with */
    uint16_t tag;        /* the field visited last */
    bool trusted;        /* our own bytes of a moment ago: visitors cannot refuse what they hold */
    uint8_t *out;
    const uint8_t *in;
    size_t capacity, position; /* in bytes; position counts in every mode */
    vbss_hash hash;
} vbss_stream;
void vbss_stream_begin_measure(vbss_stream *stream);
void vbss_stream_begin_write(vbss_stream *stream, uint8_t *bytes, size_t capacity);
void vbss_stream_begin_hash(vbss_stream *stream);
void vbss_stream_begin_read(vbss_stream *stream, const uint8_t *bytes, size_t count);
/* What the caller restores when it closes the section. */
typedef struct vbss_section {
    uint32_t code;
    uint16_t version;
} vbss_section;
vbss_section vbss_stream_open(vbss_stream *stream, uint32_t code, uint16_t version);
void vbss_stream_close(vbss_stream *stream, vbss_section outer);
void vbss_stream_f64(vbss_stream *stream, uint16_t tag, double *values, size_t count);
void vbss_stream_u64(vbss_stream *stream, uint16_t tag, uint64_t *values, size_t count);
void vbss_stream_u32(vbss_stream *stream, uint16_t tag, uint32_t *values, size_t count);
void vbss_stream_i32(vbss_stream *stream, uint16_t tag, int32_t *values, size_t count);
void vbss_stream_u8(vbss_stream *stream, uint16_t tag, uint8_t *values, size_t count);
/* Bytes without a copy: where they lie in what is read, or where to put them in what is written, before the
 * next visit; NULL otherwise. */
const uint8_t *vbss_stream_view_u8(vbss_stream *stream, uint16_t tag, size_t count);
uint8_t *vbss_stream_reserve_u8(vbss_stream *stream, uint16_t tag, size_t count);
/* A number of array entries that must not exceed what the body has room for, in any mode. */
void vbss_stream_count(vbss_stream *stream, uint16_t tag, uint32_t *value, uint32_t capacity);
/* A value that must be what it was when the state was saved, such as a node count fixed by the
 * configuration: anything else means the state belongs to another object. */
void vbss_stream_expect(vbss_stream *stream, uint16_t tag, uint64_t value);
void vbss_stream_expect_f64(vbss_stream *stream, uint16_t tag, double value); /* to the bit */
/* For visitors that find nonsense themselves: keeps the first problem. */
void vbss_stream_refuse(vbss_stream *stream, vbss_result result, const char *problem);
/* Four characters as the code of a section. */
#define VBSS_CODE(a, b, c, d) \
    ((uint32_t)(a) | ((uint32_t)(b) << 8) | ((uint32_t)(c) << 16) | ((uint32_t)(d) << 24))

#endif
