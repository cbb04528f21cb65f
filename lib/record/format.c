/* How a log is laid out, little-endian:
 *   front   "VBSL", u32 format
 *   record  u32 length, u32 its complement, a section of the stream (code, version, fields), u64 checksum
 *   or      u16 length, u16 its complement, a coded step (coded.c), u64 checksum; since format 3
 * The two highest bits of the first four bytes are set in the second kind only. The checksum is XXH64 of
 * the checksum before it (at first: the front) and all of the record before it. A record whose code begins
 * with a small letter may be passed over by who does not know it. */
#include <string.h>

#include "base/error.h"
#include "base/little_endian.h"
#include "record/record.h"

#define MAGIC VBSS_CODE('V', 'B', 'S', 'L')
/* The newest, which is written, and the oldest that is read. */
#define FORMAT (uint32_t) FORMAT_PACKED
#define FORMAT_OLDEST 2u
#define CODED 0xc0000000u
#define SMALL_LETTER 0x20u
/* The least a section needs. */
#define SECTION_BYTES 16u

static uint64_t link_of(uint64_t chain, const uint8_t *record, size_t count)
{
    uint8_t before[8];
    vbss_hash hash;
    store_little_endian(before, chain, 8);
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, before, sizeof before);
    vbss_hash_add(&hash, record, count);
    return vbss_hash_end(&hash);
}

/* ---- writing */

void vbss_log_begin(log_writer *log)
{
    log->format = FORMAT;
    store_little_endian(log->bytes, (uint64_t)FORMAT << 32 | MAGIC, LOG_FRONT);
    log->chain = load_little_endian(log->bytes, LOG_FRONT);
    log->used = LOG_FRONT;
}

size_t vbss_log_room(const log_writer *log)
{
    return log->taken ? log->capacity : log->capacity - log->used;
}

void vbss_log_open(log_writer *log, vbss_stream *stream)
{
    log->used = log->taken ? 0 : log->used;
    log->taken = false;
    vbss_stream_begin_write(stream, log->bytes + log->used + LOG_BEFORE,
                            log->capacity - log->used - LOG_BEFORE - LOG_AFTER);
}

static void append_checksum(log_writer *log, size_t covered)
{
    uint8_t *record = log->bytes + log->used;
    log->chain = link_of(log->chain, record, covered);
    store_little_endian(record + covered, log->chain, LOG_AFTER);
    log->used += covered + LOG_AFTER;
    log->grown += covered + LOG_AFTER;
}

vbss_result vbss_log_seal(log_writer *log, const vbss_stream *stream)
{
    uint8_t *record = log->bytes + log->used;
    if (stream->result != VBSS_OK) {
        return stream->result;
    }
    store_little_endian(record, stream->position, 4);
    store_little_endian(record + 4, ~(uint64_t)stream->position, 4);
    append_checksum(log, LOG_BEFORE + stream->position);
    return VBSS_OK;
}

uint8_t *vbss_log_open_coded(log_writer *log)
{
    log->used = log->taken ? 0 : log->used;
    log->taken = false;
    return log->bytes + log->used + LOG_BEFORE_CODED;
}

void vbss_log_seal_coded(log_writer *log, size_t count)
{
    uint8_t *record = log->bytes + log->used;
    store_little_endian(record, count, 2);
    store_little_endian(record + 2, ~(uint64_t)count, 2);
    append_checksum(log, LOG_BEFORE_CODED + count);
}

/* ---- reading */

static vbss_result fail_at(const log_reader *log, vbss_result result, size_t at,
                           const char *problem)
{
    if (log->fault != NULL) {
        const log_fault fault = {result, at, problem};
        *log->fault = fault;
        return result;
    }
    return vbss_fail(log->context, result, "log, byte %llu of %llu: %s", (unsigned long long)at,
                     (unsigned long long)log->count, problem);
}

vbss_result vbss_log_corrupt(const log_reader *log, size_t at, const char *problem)
{
    return fail_at(log, VBSS_ERROR_CORRUPT, at, problem);
}

vbss_result vbss_log_read_front(log_reader *log)
{
    if (log->count < LOG_FRONT) {
        return fail_at(log, VBSS_ERROR_TRUNCATED, log->count, "it ends before it begins");
    }
    log->chain = load_little_endian(log->bytes, LOG_FRONT);
    if ((uint32_t)log->chain != MAGIC) {
        return vbss_log_corrupt(log, 0, "this is no log");
    }
    log->format = (uint32_t)(log->chain >> 32);
    if (log->format < FORMAT_OLDEST || log->format > FORMAT) {
        return fail_at(log, VBSS_ERROR_DATA_VERSION, 4,
                       log->format < FORMAT_OLDEST
                           ? "a log of an older library, which this one does not read"
                           : "a log of a newer library, which this one does not read");
    }
    log->at = LOG_FRONT;
    return VBSS_OK;
}

/* The length of the record at `at`; false: none begins there. */
static bool find_length(const log_reader *log, log_found *found)
{
    const uint8_t *record = log->bytes + log->at;
    uint64_t front = load_little_endian(record, 4);
    found->coded = log->format >= FORMAT_PACKED && front >= CODED;
    if (found->coded) {
        found->payload = record + LOG_BEFORE_CODED;
        found->length = (size_t)(front & UINT16_MAX);
        return (front >> 16 ^ found->length) == UINT16_MAX && found->length > 0;
    }
    found->payload = record + LOG_BEFORE;
    found->length = (size_t)front;
    return (front ^ load_little_endian(record + 4, 4)) == UINT32_MAX && front >= SECTION_BYTES;
}

/* The record at `at`, whatever it is. No record is shorter than LOG_BEFORE, so there are as many bytes or
 * it is cut off. */
static vbss_result find(const log_reader *log, log_found *found)
{
    size_t left = log->count - log->at;
    if (left < LOG_BEFORE) {
        return fail_at(log, VBSS_ERROR_TRUNCATED, log->count, "it is cut off: there is no end");
    }
    if (!find_length(log, found)) {
        return vbss_log_corrupt(log, log->at, "no record begins here");
    }
    size_t before = found->coded ? LOG_BEFORE_CODED : LOG_BEFORE;
    if (left < before + LOG_AFTER || found->length > left - before - LOG_AFTER) {
        return fail_at(log, VBSS_ERROR_TRUNCATED, log->at, "it is cut off in the record here");
    }
    found->at = log->at;
    found->code = found->coded ? LOG_STEP : (uint32_t)load_little_endian(found->payload + 4, 4);
    return VBSS_OK;
}

/* Of the record, all that its checksum covers but the checksum before. */
static size_t covered_by(const log_found *found)
{
    return (found->coded ? LOG_BEFORE_CODED : LOG_BEFORE) + found->length;
}

vbss_result vbss_log_next_of_any_kind(log_reader *log, log_found *found)
{
    VBSS_TRY(find(log, found));
    size_t covered = covered_by(found);
    const uint8_t *record = log->bytes + log->at;
    uint64_t chain = link_of(log->chain, record, covered);
    if (chain != load_little_endian(record + covered, LOG_AFTER)) {
        return vbss_log_corrupt(log, found->at, "the checksum of the record here differs");
    }
    log->chain = chain;
    log->at += covered + LOG_AFTER;
    return VBSS_OK;
}

vbss_result vbss_log_next(log_reader *log, log_found *found)
{
    log_reader next = *log;
    bool known = false;
    while (!known) {
        VBSS_TRY(vbss_log_next_of_any_kind(&next, found));
        known = found->code == LOG_HEAD || found->code == LOG_SNAPSHOT || found->code == LOG_STEP ||
                found->code == LOG_END;
        if (!known && (found->code & SMALL_LETTER) == 0) {
            return fail_at(log, VBSS_ERROR_DATA_VERSION, found->at,
                           "a record of a kind that this library does not know");
        }
    }
    *log = next;
    return VBSS_OK;
}

bool vbss_log_skip(log_reader *log)
{
    log_found found;
    log_fault unwanted;
    log_reader quiet = *log;
    quiet.fault = &unwanted;
    if (find(&quiet, &found) != VBSS_OK) {
        return false;
    }
    size_t end = found.at + covered_by(&found);
    log->chain = load_little_endian(log->bytes + end, LOG_AFTER);
    log->at = end + LOG_AFTER;
    return true;
}

vbss_result vbss_log_read_all(const log_reader *log, const log_found *found,
                              const vbss_stream *stream)
{
    size_t at = found->at + LOG_BEFORE + stream->position;
    vbss_result result = stream->result;
    if (result == VBSS_OK) {
        return stream->position == found->length
                   ? VBSS_OK
                   : vbss_log_corrupt(log, at, "data follow the fields");
    }
    /* The record is all there: fields that need more were never written. */
    bool beyond = result == VBSS_ERROR_TRUNCATED || result == VBSS_ERROR_CAPACITY;
    return fail_at(log, beyond ? VBSS_ERROR_CORRUPT : result, at, stream->problem);
}
