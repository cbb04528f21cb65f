/* The layout of a log, which is little-endian:
 *
 *     preamble  "VBSL", u32 format
 *     record    u32 length, u32 its complement, section (code, version, fields), u64 checksum
 *     or        u16 length, u16 its complement, coded step (step_codec.c), u64 checksum
 *
 * The second form exists since format 3; only there the two highest bits of the first four bytes
 * are set. The checksum is the XXH64 of the previous checksum and of the record up to its own; the
 * first record takes the preamble as the previous checksum. A reader may skip a record that it does
 * not know if the code begins with a lower-case letter. */
#include <string.h>

#include "base/error.h"
#include "base/little_endian.h"
#include "record/record.h"

#define MAGIC VBSS_CODE('V', 'B', 'S', 'L')
/* The newest, which is written, and the oldest that is read. */
#define FORMAT (uint32_t) LOG_FORMAT_COMPRESSED
#define FORMAT_OLDEST 2u
#define CODED_PREFIX 0xc0000000u
#define OPTIONAL_RECORD 0x20u
/* The least a section needs. */
#define MIN_SECTION_BYTES 16u

static uint64_t chain_checksum(uint64_t checksum, const uint8_t *record, size_t count)
{
    uint8_t previous[8];
    vbss_hash hash;
    store_little_endian(previous, checksum, 8);
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, previous, sizeof previous);
    vbss_hash_add(&hash, record, count);
    return vbss_hash_end(&hash);
}

/* ---- writing */

void vbss_log_write_preamble(log_writer *log)
{
    log->format = FORMAT;
    store_little_endian(log->bytes, (uint64_t)FORMAT << 32 | MAGIC, LOG_PREAMBLE_BYTES);
    log->checksum = load_little_endian(log->bytes, LOG_PREAMBLE_BYTES);
    log->used = LOG_PREAMBLE_BYTES;
}

size_t vbss_log_free_bytes(const log_writer *log)
{
    return log->is_handed_out ? log->capacity : log->capacity - log->used;
}

void vbss_log_begin_record(log_writer *log, vbss_stream *stream)
{
    log->used = log->is_handed_out ? 0 : log->used;
    log->is_handed_out = false;
    vbss_stream_begin_write(stream, log->bytes + log->used + LOG_PREFIX_BYTES,
                            log->capacity - log->used - LOG_PREFIX_BYTES - LOG_CHECKSUM_BYTES);
}

static void append_checksum(log_writer *log, size_t covered)
{
    uint8_t *record = log->bytes + log->used;
    log->checksum = chain_checksum(log->checksum, record, covered);
    store_little_endian(record + covered, log->checksum, LOG_CHECKSUM_BYTES);
    log->used += covered + LOG_CHECKSUM_BYTES;
    log->bytes_since_session_snapshot += covered + LOG_CHECKSUM_BYTES;
}

vbss_result vbss_log_end_record(log_writer *log, const vbss_stream *stream)
{
    uint8_t *record = log->bytes + log->used;
    if (stream->result != VBSS_OK) {
        return stream->result;
    }
    store_little_endian(record, stream->position, 4);
    store_little_endian(record + 4, ~(uint64_t)stream->position, 4);
    append_checksum(log, LOG_PREFIX_BYTES + stream->position);
    return VBSS_OK;
}

uint8_t *vbss_log_begin_coded_step(log_writer *log)
{
    log->used = log->is_handed_out ? 0 : log->used;
    log->is_handed_out = false;
    return log->bytes + log->used + LOG_CODED_PREFIX_BYTES;
}

void vbss_log_end_coded_step(log_writer *log, size_t count)
{
    uint8_t *record = log->bytes + log->used;
    store_little_endian(record, count, 2);
    store_little_endian(record + 2, ~(uint64_t)count, 2);
    append_checksum(log, LOG_CODED_PREFIX_BYTES + count);
}

/* ---- reading */

static vbss_result fail_at(const log_reader *log, vbss_result result, size_t position,
                           const char *problem)
{
    if (log->fault != NULL) {
        const log_fault fault = {result, position, problem};
        *log->fault = fault;
        return result;
    }
    return vbss_fail(log->context, result, "log, byte %llu of %llu: %s",
                     (unsigned long long)position, (unsigned long long)log->count, problem);
}

vbss_result vbss_log_fail_corrupt(const log_reader *log, size_t position, const char *problem)
{
    return fail_at(log, VBSS_ERROR_CORRUPT, position, problem);
}

vbss_result vbss_log_read_preamble(log_reader *log)
{
    if (log->count < LOG_PREAMBLE_BYTES) {
        return fail_at(log, VBSS_ERROR_TRUNCATED, log->count, "it ends before it begins");
    }
    log->checksum = load_little_endian(log->bytes, LOG_PREAMBLE_BYTES);
    if ((uint32_t)log->checksum != MAGIC) {
        return vbss_log_fail_corrupt(log, 0, "this is no log");
    }
    log->format = (uint32_t)(log->checksum >> 32);
    if (log->format < FORMAT_OLDEST || log->format > FORMAT) {
        return fail_at(log, VBSS_ERROR_DATA_VERSION, 4,
                       log->format < FORMAT_OLDEST
                           ? "a log of an older library, which this one does not read"
                           : "a log of a newer library, which this one does not read");
    }
    log->position = LOG_PREAMBLE_BYTES;
    return VBSS_OK;
}

/* Reads the prefix at the position of the reader. Returns false if no record begins there. */
static bool read_prefix(const log_reader *log, log_record *found)
{
    const uint8_t *record = log->bytes + log->position;
    uint64_t prefix = load_little_endian(record, 4);
    found->is_coded = log->format >= LOG_FORMAT_COMPRESSED && prefix >= CODED_PREFIX;
    if (found->is_coded) {
        found->payload = record + LOG_CODED_PREFIX_BYTES;
        found->length = (size_t)(prefix & UINT16_MAX);
        return (prefix >> 16 ^ found->length) == UINT16_MAX && found->length > 0;
    }
    found->payload = record + LOG_PREFIX_BYTES;
    found->length = (size_t)prefix;
    return (prefix ^ load_little_endian(record + 4, 4)) == UINT32_MAX &&
           prefix >= MIN_SECTION_BYTES;
}

/* Finds the record at the position of the reader. No record is shorter than LOG_PREFIX_BYTES, so
 * with fewer bytes the log is truncated. */
static vbss_result find_record(const log_reader *log, log_record *found)
{
    size_t remaining = log->count - log->position;
    if (remaining < LOG_PREFIX_BYTES) {
        return fail_at(log, VBSS_ERROR_TRUNCATED, log->count, "it is cut off: there is no end");
    }
    if (!read_prefix(log, found)) {
        return vbss_log_fail_corrupt(log, log->position, "no record begins here");
    }
    size_t prefix_bytes = found->is_coded ? LOG_CODED_PREFIX_BYTES : LOG_PREFIX_BYTES;
    if (remaining < prefix_bytes + LOG_CHECKSUM_BYTES ||
        found->length > remaining - prefix_bytes - LOG_CHECKSUM_BYTES) {
        return fail_at(log, VBSS_ERROR_TRUNCATED, log->position,
                       "it is cut off in the record here");
    }
    found->position = log->position;
    found->code = found->is_coded ? LOG_STEP : (uint32_t)load_little_endian(found->payload + 4, 4);
    return VBSS_OK;
}

/* Bytes of the record that its checksum covers. */
static size_t covered_bytes(const log_record *found)
{
    return (found->is_coded ? LOG_CODED_PREFIX_BYTES : LOG_PREFIX_BYTES) + found->length;
}

vbss_result vbss_log_next_any(log_reader *log, log_record *found)
{
    VBSS_TRY(find_record(log, found));
    size_t covered = covered_bytes(found);
    const uint8_t *record = log->bytes + log->position;
    uint64_t checksum = chain_checksum(log->checksum, record, covered);
    if (checksum != load_little_endian(record + covered, LOG_CHECKSUM_BYTES)) {
        return vbss_log_fail_corrupt(log, found->position,
                                     "the checksum of the record here differs");
    }
    log->checksum = checksum;
    log->position += covered + LOG_CHECKSUM_BYTES;
    return VBSS_OK;
}

vbss_result vbss_log_next(log_reader *log, log_record *found)
{
    log_reader next = *log;
    bool known = false;
    while (!known) {
        VBSS_TRY(vbss_log_next_any(&next, found));
        known = found->code == LOG_HEADER || found->code == LOG_SNAPSHOT ||
                found->code == LOG_STEP || found->code == LOG_REPLACEMENT || found->code == LOG_END;
        if (!known && (found->code & OPTIONAL_RECORD) == 0) {
            return fail_at(log, VBSS_ERROR_DATA_VERSION, found->position,
                           "a record of a kind that this library does not know");
        }
    }
    *log = next;
    return VBSS_OK;
}

bool vbss_log_skip_record(log_reader *log)
{
    log_record found;
    log_fault ignored;
    log_reader quiet = *log;
    quiet.fault = &ignored;
    if (find_record(&quiet, &found) != VBSS_OK) {
        return false;
    }
    size_t end = found.position + covered_bytes(&found);
    log->checksum = load_little_endian(log->bytes + end, LOG_CHECKSUM_BYTES);
    log->position = end + LOG_CHECKSUM_BYTES;
    return true;
}

vbss_result vbss_log_check_all_read(const log_reader *log, const log_record *found,
                                    const vbss_stream *stream)
{
    size_t position = found->position + LOG_PREFIX_BYTES + stream->position;
    vbss_result result = stream->result;
    if (result == VBSS_OK) {
        return stream->position == found->length
                   ? VBSS_OK
                   : vbss_log_fail_corrupt(log, position, "data follow the fields");
    }
    /* The record is complete, so fields beyond its end mean corruption, not truncation. */
    bool is_overrun = result == VBSS_ERROR_TRUNCATED || result == VBSS_ERROR_CAPACITY;
    return fail_at(log, is_overrun ? VBSS_ERROR_CORRUPT : result, position, stream->problem);
}
