/* Integers as little-endian bytes on any machine. */
#ifndef VBSS_BASE_LITTLE_ENDIAN_H
#define VBSS_BASE_LITTLE_ENDIAN_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define VBSS_LITTLE_ENDIAN 1
#else
#define VBSS_LITTLE_ENDIAN 0
#endif

/* Stores the lowest `count` bytes of value; count is at most 8. On a little-endian machine with a
 * constant count this is one move. */
static inline void store_little_endian(uint8_t *bytes, uint64_t value, size_t count)
{
#if VBSS_LITTLE_ENDIAN
    memcpy(bytes, &value, count);
#else
    for (size_t i = 0; i < count; i++) {
        bytes[i] = (uint8_t)(value >> (8 * i));
    }
#endif
}

/* Reads `count` bytes, at most 8, as an unsigned integer. */
static inline uint64_t load_little_endian(const uint8_t *bytes, size_t count)
{
    uint64_t value = 0;
#if VBSS_LITTLE_ENDIAN
    memcpy(&value, bytes, count);
#else
    for (size_t i = 0; i < count; i++) {
        value |= (uint64_t)bytes[i] << (8 * i);
    }
#endif
    return value;
}

/* memcpy for few bytes. What compilers make of a memcpy of unknown size has a slow start. */
static inline void copy_short(uint8_t *to, const uint8_t *from, size_t count)
{
    for (; count >= 8; count -= 8, to += 8, from += 8) {
        memcpy(to, from, 8);
    }
    for (size_t i = 0; i < count; i++) {
        to[i] = from[i];
    }
}

#endif
