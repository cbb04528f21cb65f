/* Sums and products with their rounding errors, for the elementary functions.
 *
 * All of this is plain IEEE 754 double arithmetic, rounded to nearest, in the order written. */
#ifndef VBSS_BASE_DOUBLE_DOUBLE_H
#define VBSS_BASE_DOUBLE_DOUBLE_H

#include <stdint.h>
#include <string.h>

/* Bit pattern of x. */
static inline uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* The double with this bit pattern. */
static inline double double_of(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* The only NaN that the library returns: processors differ in the NaN that an operation gives. */
static inline double canonical_nan(void)
{
    return double_of(UINT64_C(0x7ff8000000000000));
}

/* x truncated to its leading 26 bits. A product of two heads is exact; x - head has 27 bits. */
static inline double head_of(double x)
{
    return double_of(bits_of(x) & ~UINT64_C(0x7ffffff));
}

/* Sum with its rounding error: x + y = result + *error exactly. Requires x = 0, |x| >= |y|, or x a
 * multiple of the last bit of y. */
static inline double two_sum_ordered(double x, double y, double *error)
{
    double sum = x + y;
    *error = (x - sum) + y;
    return sum;
}

/* Product with its rounding error: x * y = result + *error exactly. Each factor is split into 26
 * bits and a signed rest (Dekker). */
static inline double two_product(double x, double y, double *error)
{
    double x_big = x * 0x1.0000002p27, y_big = y * 0x1.0000002p27, product = x * y;
    double x_head = x_big - (x_big - x), y_head = y_big - (y_big - y);
    double x_tail = x - x_head, y_tail = y - y_head;
    *error = ((x_head * y_head - product) + x_head * y_tail + x_tail * y_head) + x_tail * y_tail;
    return product;
}

#endif
