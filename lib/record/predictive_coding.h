/* Numbers and words as bits: each number as its difference from what its own past predicts.
 *
 * A prediction extrapolates the last values by a polynomial of degree 0 to 7. The degree that has cost the
 * fewest bits lately is taken; writer and reader choose alike, since both know the same past. The
 * difference is taken between ordered integer images, so every finite double comes back to the bit. */
#ifndef VBSS_RECORD_PREDICTIVE_CODING_H
#define VBSS_RECORD_PREDICTIVE_CODING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- bits, the lowest of a byte first */

typedef struct log_bits {
    uint8_t *out;      /* NULL when reading */
    const uint8_t *in; /* NULL when writing */
    size_t count;      /* bytes to read, or room to write */
    size_t position;   /* bit */
    bool overrun;      /* more was asked for than there is; zeros were read, nothing was written */
} log_bits;
/* Room that no value exceeds, in bits. */
enum { LOG_MAX_NUMBER_BITS = 77, LOG_MAX_VARINT_BITS = 40 };
void vbss_log_put_bits(log_bits *bits, uint64_t value, uint32_t width); /* width: 0 to 64 */
uint64_t vbss_log_get_bits(log_bits *bits, uint32_t width);
/* Groups of seven bits, as many as it needs. */
void vbss_log_put_varint(log_bits *bits, uint32_t word);
uint32_t vbss_log_get_varint(log_bits *bits);
/* The bytes that the bits take. */
static inline size_t log_bits_bytes(const log_bits *bits)
{
    return (bits->position + 7) / 8;
}
/* Whether all bytes were read and the last one is filled up with zeros. */
bool vbss_log_bits_are_complete(log_bits *bits);

/* ---- numbers */

enum { LOG_ORDERS = 8 };
/* The past of one number; all zeros: it has none. */
typedef struct log_predictor {
    double differences[LOG_ORDERS]; /* backward ones of the last values, of order 0, 1, ... */
    uint8_t costs[LOG_ORDERS];      /* twice the bits that prediction has lately taken, by order */
    uint8_t order_count;            /* of these */
} log_predictor;
void vbss_log_put_number(log_bits *bits, const log_predictor *predictor, double x);
/* Any bits may come: the value may be no finite one. */
double vbss_log_get_number(log_bits *bits, const log_predictor *predictor);
/* The value is the last one from now on. */
void vbss_log_update_predictor(log_predictor *predictor, double x);

#endif
