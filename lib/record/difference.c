#include "record/difference.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define SIGN ((uint64_t)1 << 63)
/* A quotient of so many ones says that the length of the difference follows. */
enum { ESCAPE = 8, LENGTH_BITS = 6 };

/* ---- bits */

static bool has_room(log_bits *bits, uint32_t width)
{
    if (!bits->beyond && width > 8 * bits->count - bits->at) {
        bits->beyond = true;
    }
    return !bits->beyond;
}

void vbss_log_put_bits(log_bits *bits, uint64_t value, uint32_t width)
{
    if (!has_room(bits, width)) {
        return;
    }
    while (width > 0) {
        uint32_t shift = (uint32_t)(bits->at % 8), now = 8 - shift < width ? 8 - shift : width;
        uint8_t *byte = &bits->out[bits->at / 8];
        uint32_t piece = (uint32_t)(value & ((1u << now) - 1u)) << shift;
        *byte = (uint8_t)(shift == 0 ? piece : *byte | piece);
        value >>= now;
        width -= now;
        bits->at += now;
    }
}

uint64_t vbss_log_get_bits(log_bits *bits, uint32_t width)
{
    uint64_t value = 0;
    if (!has_room(bits, width)) {
        return 0;
    }
    for (uint32_t done = 0; done < width;) {
        uint32_t shift = (uint32_t)(bits->at % 8), left = width - done;
        uint32_t now = 8 - shift < left ? 8 - shift : left;
        uint32_t piece = (uint32_t)(bits->in[bits->at / 8] >> shift) & ((1u << now) - 1u);
        value |= (uint64_t)piece << done;
        done += now;
        bits->at += now;
    }
    return value;
}

void vbss_log_put_word(log_bits *bits, uint32_t word)
{
    for (; word >= 0x80u; word >>= 7) {
        vbss_log_put_bits(bits, 0x80u | (word & 0x7fu), 8);
    }
    vbss_log_put_bits(bits, word, 8);
}

uint32_t vbss_log_get_word(log_bits *bits)
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

bool vbss_log_bits_end(log_bits *bits)
{
    uint32_t left = (uint32_t)(8 * log_bits_bytes(bits) - bits->at);
    return vbss_log_get_bits(bits, left) == 0 && !bits->beyond && bits->at == 8 * bits->count;
}

/* ---- numbers */

/* Ordered as the numbers are; neighbours differ by one, also across zero. */
static uint64_t image_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & SIGN) != 0 ? ~bits : bits | SIGN;
}

static double number_of(uint64_t image)
{
    uint64_t bits = (image & SIGN) != 0 ? image & ~SIGN : ~image;
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Small for small differences of either sign. */
static uint64_t fold(uint64_t difference)
{
    return difference << 1 ^ ((difference & SIGN) != 0 ? UINT64_MAX : 0);
}

static uint64_t unfold(uint64_t folded)
{
    return folded >> 1 ^ ((folded & 1) != 0 ? UINT64_MAX : 0);
}

static uint32_t length_of(uint64_t value)
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

/* What overflows predicts nothing; processors differ in the NaNs that they make. */
static uint64_t image_of_prediction(double sum)
{
    return image_of(fabs(sum) <= DBL_MAX ? sum : 0.0);
}

/* The prediction of the order that was cheapest, and the bits below the quotient. */
static uint64_t predict(const log_past *past, uint32_t *low)
{
    uint32_t best = 0;
    double sum = 0.0;
    for (uint32_t i = 1; i < past->known; i++) {
        best = past->costs[i] < past->costs[best] ? i : best;
    }
    for (uint32_t i = 0; i <= best; i++) {
        sum += past->differences[i];
    }
    uint32_t length = past->costs[best] / 2u;
    *low = length > 0 ? length - 1 : 0;
    return image_of_prediction(sum);
}

void vbss_log_put_number(log_bits *bits, const log_past *past, double x)
{
    uint32_t low;
    uint64_t folded = fold(image_of(x) - predict(past, &low));
    uint64_t quotient = folded >> low;
    if (quotient < ESCAPE) {
        vbss_log_put_bits(bits, ((uint64_t)1 << quotient) - 1, (uint32_t)quotient + 1);
        vbss_log_put_bits(bits, folded, low);
        return;
    }
    uint32_t length = length_of(folded);
    vbss_log_put_bits(bits, (1u << ESCAPE) - 1, ESCAPE);
    vbss_log_put_bits(bits, length - 1, LENGTH_BITS);
    vbss_log_put_bits(bits, folded, length - 1); /* the highest is one */
}

double vbss_log_get_number(log_bits *bits, const log_past *past)
{
    uint32_t low, quotient = 0;
    uint64_t predicted = predict(past, &low), folded;
    while (quotient < ESCAPE && vbss_log_get_bits(bits, 1) == 1) {
        quotient++;
    }
    if (quotient < ESCAPE) {
        folded = (uint64_t)quotient << low | vbss_log_get_bits(bits, low);
    } else {
        uint32_t above = (uint32_t)vbss_log_get_bits(bits, LENGTH_BITS);
        folded = (uint64_t)1 << above | vbss_log_get_bits(bits, above);
    }
    return number_of(predicted + unfold(folded));
}

void vbss_log_push_number(log_past *past, double x)
{
    const uint64_t image = image_of(x);
    double sum = 0.0;
    for (uint32_t i = 0; i < past->known; i++) {
        sum += past->differences[i];
        uint32_t length = length_of(fold(image - image_of_prediction(sum)));
        past->costs[i] = (uint8_t)(past->costs[i] - past->costs[i] / 2u + length);
    }
    double difference = x;
    for (uint32_t i = 0; i <= past->known && i < LOG_ORDERS; i++) {
        double before = past->differences[i];
        past->differences[i] = difference;
        difference -= before;
    }
    if (past->known < LOG_ORDERS) {
        past->costs[past->known] = past->known > 0 ? past->costs[past->known - 1] : 0;
        past->known++;
    }
}
