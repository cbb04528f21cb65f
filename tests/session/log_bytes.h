/* The log of a session as a host keeps it. */
#ifndef VBSS_TESTS_SESSION_LOG_BYTES_H
#define VBSS_TESTS_SESSION_LOG_BYTES_H

#include <stdlib.h>
#include <string.h>

#include "harness/harness.h"

typedef struct log_bytes {
    uint8_t *bytes;
    size_t count;
} log_bytes;

static inline void log_take(log_bytes *log, vbss_record *record)
{
    const uint8_t *bytes;
    uint64_t count;
    expect_ok(vbss_record_take(record, &bytes, &count));
    log->bytes = realloc(log->bytes, log->count + count + 1);
    assert_non_null(log->bytes);
    memcpy(log->bytes + log->count, bytes, count);
    log->count += count;
}

#endif
