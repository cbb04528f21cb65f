/* Predictive coding: bits, varints, and numbers as Rice codes of the residual of a prediction. */
#include "record/predictive_coding.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define SIGN ((uint64_t)1 << 63)
/* A quotient of so many ones says that the length of the difference follows. */
enum { ESCAPE = 8, LENGTH_BITS = 6 };

/* ---- bits */

static bool has_bits(log_bits *bits, uint32_t width)
{
    if (!bits->overrun && width > 8 * bits->count - bits->position) {
        bits->overrun = true;
    }
    return !bits->overrun;
}

void vbss_log_put_bits(log_bits *bits, uint64_t value, uint32_t width)
{
    if (!has_bits(bits, width)) {
        return;
    }
    while (width > 0) {
        uint32_t shift = (uint32_t)(bits->position % 8),
                 chunk = 8 - shift < width ? 8 - shift : width;
        uint8_t *byte = &bits->out[bits->position / 8];
        uint32_t piece = (uint32_t)(value & ((1u << chunk) - 1u)) << shift;
        *byte = (uint8_t)(shift == 0 ? piece : *byte | piece);
        value >>= chunk;
        width -= chunk;
        bits->position += chunk;
    }
}

uint64_t vbss_log_get_bits(log_bits *bits, uint32_t width)
{
    uint64_t value = 0;
    if (!has_bits(bits, width)) {
        return 0;
    }
    for (uint32_t done = 0; done < width;) {
        uint32_t shift = (uint32_t)(bits->position % 8), remaining = width - done;
        uint32_t chunk = 8 - shift < remaining ? 8 - shift : remaining;
        uint32_t piece = (uint32_t)(bits->in[bits->position / 8] >> shift) & ((1u << chunk) - 1u);
        value |= (uint64_t)piece << done;
        done += chunk;
        bits->position += chunk;
    }
    return value;
}

void vbss_log_put_varint(log_bits *bits, uint32_t word)
{
    for (; word >= 0x80u; word >>= 7) {
        vbss_log_put_bits(bits, 0x80u | (word & 0x7fu), 8);
    }
    vbss_log_put_bits(bits, word, 8);
}

uint32_t vbss_log_get_varint(log_bits *bits)
{
    uint32_t word = 0;
    for (uint32_t shift = 0; shift < 35; shift += 7) {
        uint32_t group = (uint32_t)vbss_log_get_bits(bits, 8);
        word |= (group & 0x7fu) << shift;
        if ((group & 0x80u) == 0) {
            break;
        }
    }
    return word;
}

bool vbss_log_bits_are_complete(log_bits *bits)
{
    uint32_t remaining = (uint32_t)(8 * log_bits_bytes(bits) - bits->position);
    return vbss_log_get_bits(bits, remaining) == 0 && !bits->overrun &&
           bits->position == 8 * bits->count;
}

/* ---- numbers */

/* Integer with the order of the doubles. Neighbouring doubles differ by one, also across zero. */
static uint64_t ordered_bits(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & SIGN) != 0 ? ~bits : bits | SIGN;
}

static double from_ordered_bits(uint64_t ordered)
{
    uint64_t bits = (ordered & SIGN) != 0 ? ordered & ~SIGN : ~ordered;
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Maps small differences of either sign to small numbers. */
static uint64_t zigzag_encode(uint64_t difference)
{
    return difference << 1 ^ ((difference & SIGN) != 0 ? UINT64_MAX : 0);
}

static uint64_t zigzag_decode(uint64_t zigzag)
{
    return zigzag >> 1 ^ ((zigzag & 1) != 0 ? UINT64_MAX : 0);
}

static uint32_t bit_length(uint64_t value)
{
    uint32_t length = 0;
    for (uint32_t half = 32; half > 0; half /= 2) {
        if (value >> half != 0) {
            value >>= half;
            length += half;
        }
    }
    return length + (uint32_t)value;
}

/* A sum that overflows predicts 0, because processors differ in the NaNs that they make. */
static uint64_t ordered_prediction(double sum)
{
    return ordered_bits(fabs(sum) <= DBL_MAX ? sum : 0.0);
}

/* Prediction of the order with the lowest cost. `low_bits` receives the parameter of the Rice code:
 * the number of bits below the quotient. */
static uint64_t predict(const log_predictor *predictor, uint32_t *low_bits)
{
    uint32_t best = 0;
    double sum = 0.0;
    for (uint32_t i = 1; i < predictor->order_count; i++) {
        best = predictor->costs[i] < predictor->costs[best] ? i : best;
    }
    for (uint32_t i = 0; i <= best; i++) {
        sum += predictor->differences[i];
    }
    uint32_t length = predictor->costs[best] / 2u;
    *low_bits = length > 0 ? length - 1 : 0;
    return ordered_prediction(sum);
}

void vbss_log_put_number(log_bits *bits, const log_predictor *predictor, double x)
{
    uint32_t low_bits;
    uint64_t zigzag = zigzag_encode(ordered_bits(x) - predict(predictor, &low_bits));
    uint64_t quotient = zigzag >> low_bits;
    if (quotient < ESCAPE) {
        vbss_log_put_bits(bits, ((uint64_t)1 << quotient) - 1, (uint32_t)quotient + 1);
        vbss_log_put_bits(bits, zigzag, low_bits);
        return;
    }
    uint32_t length = bit_length(zigzag);
    vbss_log_put_bits(bits, (1u << ESCAPE) - 1, ESCAPE);
    vbss_log_put_bits(bits, length - 1, LENGTH_BITS);
    vbss_log_put_bits(bits, zigzag, length - 1); /* the highest bit is 1 and is left out */
}

double vbss_log_get_number(log_bits *bits, const log_predictor *predictor)
{
    uint32_t low_bits, quotient = 0;
    uint64_t predicted = predict(predictor, &low_bits), zigzag;
    while (quotient < ESCAPE && vbss_log_get_bits(bits, 1) == 1) {
        quotient++;
    }
    if (quotient < ESCAPE) {
        zigzag = (uint64_t)quotient << low_bits | vbss_log_get_bits(bits, low_bits);
    } else {
        uint32_t length = (uint32_t)vbss_log_get_bits(bits, LENGTH_BITS);
        zigzag = (uint64_t)1 << length | vbss_log_get_bits(bits, length);
    }
    return from_ordered_bits(predicted + zigzag_decode(zigzag));
}

void vbss_log_update_predictor(log_predictor *predictor, double x)
{
    const uint64_t ordered = ordered_bits(x);
    double sum = 0.0;
    for (uint32_t i = 0; i < predictor->order_count; i++) {
        sum += predictor->differences[i];
        uint32_t length = bit_length(zigzag_encode(ordered - ordered_prediction(sum)));
        predictor->costs[i] = (uint8_t)(predictor->costs[i] - predictor->costs[i] / 2u + length);
    }
    double difference = x;
    for (uint32_t i = 0; i <= predictor->order_count && i < LOG_ORDERS; i++) {
        double previous = predictor->differences[i];
        predictor->differences[i] = difference;
        difference -= previous;
    }
    if (predictor->order_count < LOG_ORDERS) {
        predictor->costs[predictor->order_count] =
            predictor->order_count > 0 ? predictor->costs[predictor->order_count - 1] : 0;
        predictor->order_count++;
    }
}
