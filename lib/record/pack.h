/* Bytes in which words of four bytes repeat, as snapshots are, in fewer bytes. */
#ifndef VBSS_RECORD_PACK_H
#define VBSS_RECORD_PACK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LOG_PACK_PLACES = 4096 };
/* The bytes that it takes; 0: there is no room for it. The table is overwritten. */
size_t vbss_log_pack(uint32_t table[LOG_PACK_PLACES], const uint8_t *raw, size_t count,
                     uint8_t *packed, size_t room);
/* Whether the bytes unpack to `count` others, which are written unless `raw` is NULL. */
bool vbss_log_unpack(const uint8_t *packed, size_t packed_count, uint8_t *raw, size_t count);

#endif
