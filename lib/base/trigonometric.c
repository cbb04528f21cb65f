/* Sine and cosine with the same bits everywhere, accurate over the whole range of double.
 *
 * x = k pi/64 + r, |r| <= pi/128. With S = sin(k pi/64) and C = cos(k pi/64) from one table of the
 * full circle,
 *     sin x = S + C r + [S (cos r - 1) + C (sin r - r)],
 * and cos x is the sine with k + 32. S, C and r are split into 26 bits and a rest, so the leading
 * product is exact and S + C r is summed with its error. The bracket is below 2^-10 of the result;
 * its few roundings and the error of the polynomials (2^-63) add little to the final rounding.
 * Documented maximal error: 0.51 ulp. Derivation: docs/explanation/elementary-functions.md. */
#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "base/double_double.h"
#include "base/elementary.h"

/* sin(k pi/64) as 26 bits and the rest. The table is odd and even to the bit. */
/* clang-format off */
static const double circle[128][2] = {
    {0.0, 0.0}, {0x1.91f65fp-5, 0x1.0dd813e6ed42fp-33},
    {0x1.917a6cp-4, -0x1.eb25ea0f138c7p-31}, {0x1.2c8107p-3, -0x1.719ec5dd9ffebp-31},
    {0x1.8f8b84p-3, -0x1.cb2cfaa4da337p-30}, {0x1.f19f978p-3, 0x1.90af8d57a4222p-30},
    {0x1.294063p-2, -0x1.2a60fa574a369p-30}, {0x1.58f9a78p-2, -0x1.2a701180f7eep-29},
    {0x1.87de2a8p-2, -0x1.51569d2e59dbap-30}, {0x1.b5d1008p-2, 0x1.e15cc02b66c59p-30},
    {0x1.e2b5d38p-2, 0x1.bd8ec78362475p-36}, {0x1.0738798p-1, 0x1.22ffed9697fafp-29},
    {0x1.1c73b38p-1, 0x1.ae68c86c9774ap-29}, {0x1.30ff8p-1, -0x1.8f47e58f7e631p-28},
    {0x1.44cf328p-1, -0x1.7b7114f3fc4afp-28}, {0x1.57d6938p-1, -0x1.b989b02eae413p-28},
    {0x1.6a09e68p-1, -0x1.80c4336f74d05p-29}, {0x1.7b5df2p-1, 0x1.3557d76f0ac85p-28},
    {0x1.8bc8068p-1, 0x1.8a8ba05a743dap-28}, {0x1.9b3e048p-1, -0x1.8f17e98771434p-34},
    {0x1.a9b6628p-1, 0x1.0ea1a3033ec62p-29}, {0x1.b728348p-1, -0x1.7348e1378d3e6p-28},
    {0x1.c38b2fp-1, 0x1.80bdb0d23e9d1p-29}, {0x1.ced7af8p-1, -0x1.e19c46879edafp-28},
    {0x1.d906bdp-1, -0x1.9ae573aea067cp-30}, {0x1.e212108p-1, -0x1.84bc8da0298eep-28},
    {0x1.e9f4158p-1, -0x1.39d225a27d387p-29}, {0x1.f0a7ef8p-1, 0x1.c9186b952c7aep-28},
    {0x1.f6297dp-1, -0x1.1469faa77a357p-34}, {0x1.fa7558p-1, -0x1.eeb5d2bd05465p-30},
    {0x1.fd88dap-1, 0x1.e89292cf04139p-28}, {0x1.ff621ep-1, 0x1.bcb6bef1d421fp-28},
    {0x1p0, 0.0}, {0x1.ff621ep-1, 0x1.bcb6bef1d421fp-28},
    {0x1.fd88dap-1, 0x1.e89292cf04139p-28}, {0x1.fa7558p-1, -0x1.eeb5d2bd05465p-30},
    {0x1.f6297dp-1, -0x1.1469faa77a357p-34}, {0x1.f0a7ef8p-1, 0x1.c9186b952c7aep-28},
    {0x1.e9f4158p-1, -0x1.39d225a27d387p-29}, {0x1.e212108p-1, -0x1.84bc8da0298eep-28},
    {0x1.d906bdp-1, -0x1.9ae573aea067cp-30}, {0x1.ced7af8p-1, -0x1.e19c46879edafp-28},
    {0x1.c38b2fp-1, 0x1.80bdb0d23e9d1p-29}, {0x1.b728348p-1, -0x1.7348e1378d3e6p-28},
    {0x1.a9b6628p-1, 0x1.0ea1a3033ec62p-29}, {0x1.9b3e048p-1, -0x1.8f17e98771434p-34},
    {0x1.8bc8068p-1, 0x1.8a8ba05a743dap-28}, {0x1.7b5df2p-1, 0x1.3557d76f0ac85p-28},
    {0x1.6a09e68p-1, -0x1.80c4336f74d05p-29}, {0x1.57d6938p-1, -0x1.b989b02eae413p-28},
    {0x1.44cf328p-1, -0x1.7b7114f3fc4afp-28}, {0x1.30ff8p-1, -0x1.8f47e58f7e631p-28},
    {0x1.1c73b38p-1, 0x1.ae68c86c9774ap-29}, {0x1.0738798p-1, 0x1.22ffed9697fafp-29},
    {0x1.e2b5d38p-2, 0x1.bd8ec78362475p-36}, {0x1.b5d1008p-2, 0x1.e15cc02b66c59p-30},
    {0x1.87de2a8p-2, -0x1.51569d2e59dbap-30}, {0x1.58f9a78p-2, -0x1.2a701180f7eep-29},
    {0x1.294063p-2, -0x1.2a60fa574a369p-30}, {0x1.f19f978p-3, 0x1.90af8d57a4222p-30},
    {0x1.8f8b84p-3, -0x1.cb2cfaa4da337p-30}, {0x1.2c8107p-3, -0x1.719ec5dd9ffebp-31},
    {0x1.917a6cp-4, -0x1.eb25ea0f138c7p-31}, {0x1.91f65fp-5, 0x1.0dd813e6ed42fp-33},
    {0.0, 0.0}, {-0x1.91f65fp-5, -0x1.0dd813e6ed42fp-33},
    {-0x1.917a6cp-4, 0x1.eb25ea0f138c7p-31}, {-0x1.2c8107p-3, 0x1.719ec5dd9ffebp-31},
    {-0x1.8f8b84p-3, 0x1.cb2cfaa4da337p-30}, {-0x1.f19f978p-3, -0x1.90af8d57a4222p-30},
    {-0x1.294063p-2, 0x1.2a60fa574a369p-30}, {-0x1.58f9a78p-2, 0x1.2a701180f7eep-29},
    {-0x1.87de2a8p-2, 0x1.51569d2e59dbap-30}, {-0x1.b5d1008p-2, -0x1.e15cc02b66c59p-30},
    {-0x1.e2b5d38p-2, -0x1.bd8ec78362475p-36}, {-0x1.0738798p-1, -0x1.22ffed9697fafp-29},
    {-0x1.1c73b38p-1, -0x1.ae68c86c9774ap-29}, {-0x1.30ff8p-1, 0x1.8f47e58f7e631p-28},
    {-0x1.44cf328p-1, 0x1.7b7114f3fc4afp-28}, {-0x1.57d6938p-1, 0x1.b989b02eae413p-28},
    {-0x1.6a09e68p-1, 0x1.80c4336f74d05p-29}, {-0x1.7b5df2p-1, -0x1.3557d76f0ac85p-28},
    {-0x1.8bc8068p-1, -0x1.8a8ba05a743dap-28}, {-0x1.9b3e048p-1, 0x1.8f17e98771434p-34},
    {-0x1.a9b6628p-1, -0x1.0ea1a3033ec62p-29}, {-0x1.b728348p-1, 0x1.7348e1378d3e6p-28},
    {-0x1.c38b2fp-1, -0x1.80bdb0d23e9d1p-29}, {-0x1.ced7af8p-1, 0x1.e19c46879edafp-28},
    {-0x1.d906bdp-1, 0x1.9ae573aea067cp-30}, {-0x1.e212108p-1, 0x1.84bc8da0298eep-28},
    {-0x1.e9f4158p-1, 0x1.39d225a27d387p-29}, {-0x1.f0a7ef8p-1, -0x1.c9186b952c7aep-28},
    {-0x1.f6297dp-1, 0x1.1469faa77a357p-34}, {-0x1.fa7558p-1, 0x1.eeb5d2bd05465p-30},
    {-0x1.fd88dap-1, -0x1.e89292cf04139p-28}, {-0x1.ff621ep-1, -0x1.bcb6bef1d421fp-28},
    {-0x1p0, 0.0}, {-0x1.ff621ep-1, -0x1.bcb6bef1d421fp-28},
    {-0x1.fd88dap-1, -0x1.e89292cf04139p-28}, {-0x1.fa7558p-1, 0x1.eeb5d2bd05465p-30},
    {-0x1.f6297dp-1, 0x1.1469faa77a357p-34}, {-0x1.f0a7ef8p-1, -0x1.c9186b952c7aep-28},
    {-0x1.e9f4158p-1, 0x1.39d225a27d387p-29}, {-0x1.e212108p-1, 0x1.84bc8da0298eep-28},
    {-0x1.d906bdp-1, 0x1.9ae573aea067cp-30}, {-0x1.ced7af8p-1, 0x1.e19c46879edafp-28},
    {-0x1.c38b2fp-1, -0x1.80bdb0d23e9d1p-29}, {-0x1.b728348p-1, 0x1.7348e1378d3e6p-28},
    {-0x1.a9b6628p-1, -0x1.0ea1a3033ec62p-29}, {-0x1.9b3e048p-1, 0x1.8f17e98771434p-34},
    {-0x1.8bc8068p-1, -0x1.8a8ba05a743dap-28}, {-0x1.7b5df2p-1, -0x1.3557d76f0ac85p-28},
    {-0x1.6a09e68p-1, 0x1.80c4336f74d05p-29}, {-0x1.57d6938p-1, 0x1.b989b02eae413p-28},
    {-0x1.44cf328p-1, 0x1.7b7114f3fc4afp-28}, {-0x1.30ff8p-1, 0x1.8f47e58f7e631p-28},
    {-0x1.1c73b38p-1, -0x1.ae68c86c9774ap-29}, {-0x1.0738798p-1, -0x1.22ffed9697fafp-29},
    {-0x1.e2b5d38p-2, -0x1.bd8ec78362475p-36}, {-0x1.b5d1008p-2, -0x1.e15cc02b66c59p-30},
    {-0x1.87de2a8p-2, 0x1.51569d2e59dbap-30}, {-0x1.58f9a78p-2, 0x1.2a701180f7eep-29},
    {-0x1.294063p-2, 0x1.2a60fa574a369p-30}, {-0x1.f19f978p-3, -0x1.90af8d57a4222p-30},
    {-0x1.8f8b84p-3, 0x1.cb2cfaa4da337p-30}, {-0x1.2c8107p-3, 0x1.719ec5dd9ffebp-31},
    {-0x1.917a6cp-4, 0x1.eb25ea0f138c7p-31}, {-0x1.91f65fp-5, -0x1.0dd813e6ed42fp-33},
};
/* clang-format on */

/* 2/pi after 64 zero bits, enough for the largest exponent. */
/* clang-format off */
static const uint32_t two_over_pi[39] = {
    0x00000000u, 0x00000000u, 0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u,
    0xdb629599u, 0x3c439041u, 0xfe5163abu, 0xdebbc561u, 0xb7246e3au, 0x424dd2e0u,
    0x06492eeau, 0x09d1921cu, 0xfe1deb1cu, 0xb129a73eu, 0xe88235f5u, 0x2ebb4484u,
    0xe99c7026u, 0xb45f7e41u, 0x3991d639u, 0x835339f4u, 0x9c845f8bu, 0xbdf9283bu,
    0x1ff897ffu, 0xde05980fu, 0xef2f118bu, 0x5a0a6d1fu, 0x6d367ecfu, 0x27cb09b7u,
    0x4f463f66u, 0x9e5fea2du, 0x7527bac7u, 0xebe5f17bu, 0x3d0739f7u, 0x8a5292eau,
    0x6bfb5fb1u, 0x1f8d5d08u, 0x56033046u,
};
/* clang-format on */

#define PI_64_A 0x1.921fb58p-5 /* pi/64 in 26 + 26 + 53 bits */
#define PI_64_B (-0x1.dde974p-32)
#define PI_64_C 0x1.1a62633145c07p-59
#define PI_64 0x1.921fb54442d18p-5 /* and in 53 + 53 bits */
#define PI_64_TAIL 0x1.1a62633145c07p-59
#define TURNS_PER_RADIAN 0x1.45f306dc9c883p4 /* 64/pi */
#define ROUND_TO_INTEGER 0x1.8p52 /* adding it leaves the nearest integer in the low bits */
#define QUARTER 32u               /* table entries in a quarter circle */

/* Reduced argument: x = index pi/64 + angle + tail, modulo 2 pi. */
typedef struct reduced_angle {
    double angle, tail;
    uint32_t index;
} reduced_angle;

/* Slow reduction by integers, accurate for all finite |x| >= 2^-6.
 *
 * x 64/pi is the product of the significand and the bits of 2/pi. Leading bits that contribute only
 * whole circles are skipped. The product of 192 bits is taken modulo 2^192: 7 bits of index and 185
 * bits of fraction.
 * The truncation error is below 2^53 2^-185 = 2^-132 steps of pi/64. No double is closer than about
 * 2^-62 steps to a multiple of pi/64, so the relative error of the remainder is below 2^-70. */
static reduced_angle reduce_by_integers(double x)
{
    uint64_t bits = bits_of(x);
    uint64_t significand = (bits & UINT64_C(0xfffffffffffff)) | UINT64_C(0x10000000000000);
    /* table bit with the weight of 64 steps */
    unsigned first = ((unsigned)(bits >> 52) & 0x7ffu) - 1013u;
    unsigned word = first / 32u, shift = first % 32u;
    uint32_t window[6], product[6], fraction[6];
    for (unsigned i = 0; i < 6; i++) {
        uint64_t pair = (uint64_t)two_over_pi[word + i] << 32 | two_over_pi[word + i + 1];
        window[i] = (uint32_t)(pair >> (32u - shift));
    }
    uint64_t low = significand & 0xffffffffu, high = significand >> 32, carry = 0;
    for (unsigned i = 6; i-- > 0;) {
        carry += window[i] * low;
        product[i] = (uint32_t)carry;
        carry >>= 32;
    }
    carry = 0;
    for (unsigned i = 5; i-- > 0;) {
        carry += window[i + 1] * high + product[i];
        product[i] = (uint32_t)carry;
        carry >>= 32;
    }
    /* Round to the nearest multiple: a fraction of 1/2 or more becomes negative. The complement ~
     * differs from the negative by one last bit only. */
    uint32_t negative = product[0] >> 24 & 1u;
    for (unsigned i = 0; i < 6; i++) {
        uint32_t next = i < 5 ? product[i + 1] : 0u;
        fraction[i] = (product[i] << 7 | next >> 25) ^ (0u - negative);
    }
    unsigned start = 0;
    double scale = 0x1p-32;
    while (start < 2 && fraction[start] == 0) {
        start++;
        scale *= 0x1p-32;
    }
    double tail, head = two_sum_ordered((double)fraction[start],
                                        (double)fraction[start + 1] * 0x1p-32, &tail);
    tail += (double)fraction[start + 2] * 0x1p-64;
    tail += (double)fraction[start + 3] * 0x1p-96;
    double error, angle = two_product(head, PI_64, &error);
    error += head * PI_64_TAIL + tail * PI_64;
    bool minus = bits >> 63 != 0;
    scale = minus != (negative != 0) ? -scale : scale;
    reduced_angle result = {0.0, 0.0, (product[0] >> 25) + negative};
    result.angle = two_sum_ordered(angle, error, &result.tail) * scale;
    result.tail *= scale;
    result.index = minus ? 0u - result.index : result.index;
    return result;
}

/* Reduces finite x, by floating point where that is accurate enough. */
static inline reduced_angle reduce(double x)
{
    reduced_angle result = {x, 0.0, 0};
    if (fabs(x) < 0x1.88p-6) { /* below pi/128, k is 0 */
        return result;
    }
    if (fabs(x) < 0x1p22) {
        double shifted = x * TURNS_PER_RADIAN + ROUND_TO_INTEGER;
        double k = shifted - ROUND_TO_INTEGER;
        /* |k| < 2^27, so k A and k B are exact. The first difference is exact too: where k != 0 it
         * is a multiple of 2^-58 below 2^-5. It is also a multiple of the last bit of k B, as
         * two_sum_ordered requires. */
        double error, angle = two_sum_ordered(x - k * PI_64_A, -(k * PI_64_B), &error);
        error -= k * PI_64_C;
        result.angle = two_sum_ordered(angle, error, &result.tail);
        result.index = (uint32_t)bits_of(shifted);
        /* The rounding error of k C is at most 2^-83, that is 2^-63 of the angle unless the angle
         * is tiny. */
        if (fabs(result.angle) >= 0x1p-20 || k == 0.0) {
            return result;
        }
    }
    return reduce_by_integers(x);
}

/* The reduced angle r, split for the final sum. */
typedef struct angle_split {
    /* head has 26 bits; head + rest is exact to 2^-80; angle is rounded */
    double angle, head, rest;
    double sine, cosine; /* sin r - r and cos r - 1 */
} angle_split;

static inline angle_split split_angle(reduced_angle t)
{
    angle_split p;
    double r = t.angle, u = r * r;
    p.angle = r;
    p.head = head_of(r);
    p.rest = (r - p.head) + t.tail;
    p.sine = -0x1.5555555555555p-3 + u * (0x1.11111110c196p-7 + u * -0x1.a018aab67ee38p-13);
    p.sine *= r * u;
    p.cosine = -0x1.ffffffffffffdp-2 + u * (0x1.55555554a2808p-5 + u * -0x1.6c153fa56aee4p-10);
    p.cosine *= u;
    return p;
}

/* sin(index pi/64 + r) */
static inline double turned_sine(uint32_t index, angle_split r)
{
    const double *sine = circle[index % 128u], *cosine = circle[(index + QUARTER) % 128u];
    double error, sum = two_sum_ordered(sine[0], cosine[0] * r.head, &error);
    double exact_rest = error + (sine[1] + (cosine[0] * r.rest + cosine[1] * r.angle));
    double bracket = (sine[0] + sine[1]) * r.cosine + (cosine[0] + cosine[1]) * r.sine;
    return sum + (exact_rest + bracket);
}

double vbss_sine(double x)
{
    double magnitude = fabs(x);
    if (magnitude < 0x1p-27) {
        return x; /* x^3/6 is below 2^-56 x; this also preserves -0 and subnormals */
    }
    if (!(magnitude <= DBL_MAX)) {
        return canonical_nan();
    }
    reduced_angle t = reduce(x);
    return turned_sine(t.index, split_angle(t));
}

double vbss_cosine(double x)
{
    if (!(fabs(x) <= DBL_MAX)) {
        return canonical_nan();
    }
    reduced_angle t = reduce(x);
    return turned_sine(t.index + QUARTER, split_angle(t));
}

void vbss_sincos(double x, double *sine, double *cosine)
{
    double magnitude = fabs(x);
    if (!(magnitude <= DBL_MAX)) {
        *sine = *cosine = canonical_nan();
        return;
    }
    reduced_angle t = reduce(x);
    angle_split r = split_angle(t);
    double tiny_sine = x;
    *cosine = turned_sine(t.index + QUARTER, r);
    *sine = magnitude < 0x1p-27 ? tiny_sine : turned_sine(t.index, r);
}
