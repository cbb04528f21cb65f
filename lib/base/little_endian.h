/* Integers as little-endian bytes, whatever the machine's own order. */
#ifndef VBSS_BASE_LITTLE_ENDIAN_H
#define VBSS_BASE_LITTLE_ENDIAN_H

#include <stddef.h>
#include <stdint.h>

/* The lowest `count` bytes of value, at most 8. */
static inline void store_little_endian(uint8_t *bytes, uint64_t value, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        bytes[i] = (uint8_t)(value >> (8 * i));
    }
}

static inline uint64_t load_little_endian(const uint8_t *bytes, size_t count)
{
    uint64_t value = 0;
    for (size_t i = 0; i < count; i++) {
        value |= (uint64_t)bytes[i] << (8 * i);
    }
    return value;
}

#endif
