/* Serialisation: one visitor writes, measures, hashes and reads a state.
 *
 * An object has one function that visits its fields in order; the stream's mode decides what a
 * visit does. The bytes are little-endian on every machine and self-describing:
 *   section      u16 0xfffe, u16 version, u32 code
 *   field        u16 tag, u8 type, u8 0, u32 count, values
 *   section end  u16 0xffff, u16 0, u32 0
 * The first failure is stored in `result` and disables all later visits, so a visitor needs no
 * error checks. A visitor visits a field of version k only if stream->version >= k and otherwise
 * sets the field to its default. A section of a newer version is refused. Signed zeros are
 * preserved, and every NaN is written as one quiet NaN. Reading a value that is not finite gives
 * VBSS_ERROR_CORRUPT. */
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
    const char *problem; /* description of the first failure, a constant */
    uint32_t section;    /* code of the innermost open section, for error texts */
    /* version of that section; when reading, the version it was written with */
    uint16_t version;
    uint16_t tag; /* the field visited last */
    /* the library wrote these bytes itself a moment ago: visitors cannot refuse them */
    bool trusted;
    uint8_t *out;
    const uint8_t *in;
    size_t capacity, position; /* in bytes; position counts in every mode */
    vbss_hash hash;
} vbss_stream;
/* Starts a stream in one of the four modes. `capacity` and `count` are in bytes. */
void vbss_stream_begin_measure(vbss_stream *stream);
void vbss_stream_begin_write(vbss_stream *stream, uint8_t *bytes, size_t capacity);
void vbss_stream_begin_hash(vbss_stream *stream);
void vbss_stream_begin_read(vbss_stream *stream, const uint8_t *bytes, size_t count);
/* The enclosing section, which the caller restores when it closes the inner one. */
typedef struct vbss_section {
    uint32_t code;
    uint16_t version;
} vbss_section;
/* Opens a section of the current `version`. When reading, VBSS_ERROR_CORRUPT for another code,
 * VBSS_ERROR_DATA_VERSION for a newer version. */
vbss_section vbss_stream_open(vbss_stream *stream, uint32_t code, uint16_t version);
void vbss_stream_close(vbss_stream *stream, vbss_section outer);
/* When reading: whether a section with this code begins here. */
bool vbss_stream_has_section(const vbss_stream *stream, uint32_t code);
/* Visits an array of `count` values as one field. When reading, the field must have this tag, type
 * and count, otherwise VBSS_ERROR_CORRUPT. */
void vbss_stream_f64(vbss_stream *stream, uint16_t tag, double *values, size_t count);
void vbss_stream_u64(vbss_stream *stream, uint16_t tag, uint64_t *values, size_t count);
void vbss_stream_u32(vbss_stream *stream, uint16_t tag, uint32_t *values, size_t count);
void vbss_stream_i32(vbss_stream *stream, uint16_t tag, int32_t *values, size_t count);
void vbss_stream_u8(vbss_stream *stream, uint16_t tag, uint8_t *values, size_t count);
/* Fields of bytes without a copy. When reading, vbss_stream_view_u8 returns the address of the
 * bytes. When writing, vbss_stream_reserve_u8 returns the address that the caller must fill before
 * the next visit. Both return NULL after a failure; reserve also returns NULL in the other
 * modes. */
const uint8_t *vbss_stream_view_u8(vbss_stream *stream, uint16_t tag, size_t count);
uint8_t *vbss_stream_reserve_u8(vbss_stream *stream, uint16_t tag, size_t count);
/* A number of array entries. VBSS_ERROR_CAPACITY in every mode if it exceeds `capacity`, the room
 * that the object has. */
void vbss_stream_count(vbss_stream *stream, uint16_t tag, uint32_t *value, uint32_t capacity);
/* A value that must not have changed since the state was saved, such as a node count fixed by the
 * configuration. VBSS_ERROR_CORRUPT if the stored value differs: the state belongs to another
 * object. */
void vbss_stream_expect(vbss_stream *stream, uint16_t tag, uint64_t value);
/* compares the bits */
void vbss_stream_expect_f64(vbss_stream *stream, uint16_t tag, double value);
/* Reports a state that a visitor finds invalid. Only the first problem is stored; a trusted stream
 * ignores it. */
void vbss_stream_refuse(vbss_stream *stream, vbss_result result, const char *problem);
/* A flag, stored as 0 or 1. VBSS_ERROR_CORRUPT for any other stored value. */
void vbss_stream_bool(vbss_stream *stream, uint16_t tag, bool *value);
/* Four characters as the code of a section. */
#define VBSS_CODE(a, b, c, d) \
    ((uint32_t)(a) | ((uint32_t)(b) << 8) | ((uint32_t)(c) << 16) | ((uint32_t)(d) << 24))

#endif
