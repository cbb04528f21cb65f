/* Compression of bytes in which words of four bytes repeat, such as snapshots (LZ77). */
#ifndef VBSS_RECORD_COMPRESSION_H
#define VBSS_RECORD_COMPRESSION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LOG_HASH_TABLE_SIZE = 4096 };
/* Compresses `count` bytes. Returns the compressed size, or 0 if it exceeds `capacity`. The table
 * is scratch. */
size_t vbss_log_compress(uint32_t table[LOG_HASH_TABLE_SIZE], const uint8_t *raw, size_t count,
                         uint8_t *compressed, size_t capacity);
/* Decompresses to `count` bytes; `raw` NULL: only checks. Returns false if the compressed bytes are
 * invalid or have another size. */
bool vbss_log_decompress(const uint8_t *compressed, size_t compressed_count, uint8_t *raw,
                         size_t count);

#endif
