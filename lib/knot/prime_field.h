/* The field of integers modulo the prime 2^31 - 1. Elements are numbers below the prime. */
#ifndef VBSS_KNOT_PRIME_FIELD_H
#define VBSS_KNOT_PRIME_FIELD_H

#include <stdint.h>

#define FIELD_PRIME 2147483647u

static inline uint32_t field_add(uint32_t a, uint32_t b)
{
    uint32_t sum = a + b;
    return sum >= FIELD_PRIME ? sum - FIELD_PRIME : sum;
}

static inline uint32_t field_negative(uint32_t a)
{
    return a == 0 ? 0 : FIELD_PRIME - a;
}

static inline uint32_t field_multiply(uint32_t a, uint32_t b)
{
    uint64_t product = (uint64_t)a * b;
    return field_add((uint32_t)(product & FIELD_PRIME), (uint32_t)(product >> 31));
}

static inline uint32_t field_power(uint32_t a, uint32_t exponent)
{
    uint32_t result = 1;
    for (; exponent > 0; exponent >>= 1) {
        result = (exponent & 1) != 0 ? field_multiply(result, a) : result;
        a = field_multiply(a, a);
    }
    return result;
}

/* Requires a != 0. */
static inline uint32_t field_inverse(uint32_t a)
{
    return field_power(a, FIELD_PRIME - 2);
}

#endif
