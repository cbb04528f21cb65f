/* Bytes in which words of four bytes repeat, as snapshots are, in fewer bytes. */
#ifndef VBSS_RECORD_COMPRESSION_H
#define VBSS_RECORD_COMPRESSION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LOG_HASH_TABLE_SIZE = 4096 };
/* The bytes that it takes; 0: there is no room for it. The table is overwritten. */
size_t vbss_log_compress(uint32_t table[LOG_HASH_TABLE_SIZE], const uint8_t *raw, size_t count,
                         uint8_t *compressed, size_t capacity);
/* Whether the bytes unpack to `count` others, which are written unless `raw` is NULL. */
bool vbss_log_decompress(const uint8_t *compressed, size_t compressed_count, uint8_t *raw,
                         size_t count);

#endif
