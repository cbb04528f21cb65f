/* Predictive coding: numbers and words as bits, a number as the residual of a prediction.
 *
 * The predictor extrapolates the last values by a polynomial of degree 0 to 7. It uses the degree
 * that cost the fewest bits lately; writer and reader choose alike, because they have the same
 * history. The residual is the difference of two integers with the order of the doubles, so every
 * finite double is restored to the bit. */
#ifndef VBSS_RECORD_PREDICTIVE_CODING_H
#define VBSS_RECORD_PREDICTIVE_CODING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- bits, from the lowest of each byte */

typedef struct log_bits {
    uint8_t *out;      /* NULL when reading */
    const uint8_t *in; /* NULL when writing */
    size_t count;      /* bytes to read, or room to write */
    size_t position;   /* the next bit */
    bool overrun;      /* a call exceeded `count`; since then bits read as 0 and are not written */
} log_bits;

/* Room that no value exceeds, in bits. */
enum { LOG_MAX_NUMBER_BITS = 77, LOG_MAX_VARINT_BITS = 40 };
/* `width` is 0 to 64. */
void vbss_log_put_bits(log_bits *bits, uint64_t value, uint32_t width);
uint64_t vbss_log_get_bits(log_bits *bits, uint32_t width);
/* A varint is a word in groups of seven bits, as many as it needs. */
void vbss_log_put_varint(log_bits *bits, uint32_t word);
uint32_t vbss_log_get_varint(log_bits *bits);
/* Number of bytes that the bits so far take. */
static inline size_t log_bits_bytes(const log_bits *bits)
{
    return (bits->position + 7) / 8;
}
/* Whether all bytes were read and the unused bits of the last one are 0. */
bool vbss_log_bits_are_complete(log_bits *bits);

/* ---- numbers */

enum { LOG_ORDERS = 8 };
/* History of one number. A predictor of all zeros has none. */
typedef struct log_predictor {
    double differences[LOG_ORDERS]; /* backward differences of order 0, 1, ... */
    uint8_t costs[LOG_ORDERS];      /* per order: about twice the recent mean bits of a residual */
    uint8_t order_count;            /* orders in use */
} log_predictor;

void vbss_log_put_number(log_bits *bits, const log_predictor *predictor, double x);
/* The result may be NaN or infinite if the bits are corrupt. */
double vbss_log_get_number(log_bits *bits, const log_predictor *predictor);
/* Adds a value to the history. */
void vbss_log_update_predictor(log_predictor *predictor, double x);

#endif
