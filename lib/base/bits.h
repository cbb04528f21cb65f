/* Bit sets stored in 64-bit words. */
#ifndef VBSS_BASE_BITS_H
#define VBSS_BASE_BITS_H

#include <stdint.h>

enum { BITS_PER_WORD = 64 };

/* Number of set bits. */
static inline uint32_t count_bits(uint64_t x)
{
#if defined(__GNUC__) && defined(__POPCNT__)
    return (uint32_t)__builtin_popcountll(x);
#else
    x -= x >> 1 & UINT64_C(0x5555555555555555);
    x = (x & UINT64_C(0x3333333333333333)) + (x >> 2 & UINT64_C(0x3333333333333333));
    x = (x + (x >> 4)) & UINT64_C(0x0f0f0f0f0f0f0f0f);
    return (uint32_t)(x * UINT64_C(0x0101010101010101) >> 56);
#endif
}

/* Index of the lowest set bit; x must not be 0. */
static inline uint32_t lowest_bit(uint64_t x)
{
#if defined(__GNUC__)
    return (uint32_t)__builtin_ctzll(x);
#else
    return count_bits((x & (0 - x)) - 1);
#endif
}

/* Mask of bit i within its word; i may exceed 63. */
static inline uint64_t bit_of(uint32_t i)
{
    return UINT64_C(1) << i % BITS_PER_WORD;
}

#endif
