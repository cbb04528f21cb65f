/* exp and log with the same bits everywhere.
 *
 * exp: x = k ln 2/64 + r with |r| <= ln 2/128, and exp x = 2^(k/64) (1 + p(r)). The power comes
 * from a table of 64 values with their errors. Only r + r^2/2 ... (below 0.0055) is rounded before
 * the last addition.
 * log: x = 2^k z with z in [0.70, 1.40). A table holds 1/c with at most 11 bits for c near z. Then
 * r = z/c - 1, |r| < 0.008, is an exact sum, and log x = k ln 2 + log c + log(1 + r). Around 1 the
 * table has c = 1 and log c = 0, so nothing cancels there and no other path is needed.
 * Documented maximal errors: exp 0.52 ulp, log 0.52 ulp. Derivation:
 * docs/explanation/elementary-functions.md. */
#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "base/double_double.h"
#include "base/elementary.h"

#define STEPS_PER_UNIT 0x1.71547652b82fep6 /* 64/ln 2 */
#define STEP_HEAD 0x1.62e42fefap-7         /* ln 2/64 in 36 bits, the rest */
#define STEP_TAIL 0x1.cf79abc9e3b3ap-46
#define ROUND_TO_INTEGER 0x1.8p52 /* adding it leaves the nearest integer in the low bits */

#define LN2_HEAD 0x1.62e42fefa38p-1 /* ln 2 as a multiple of 2^-42, the rest */
#define LN2_TAIL 0x1.ef35793c7673p-45

/* 2^(i/64): the nearest double and its relative error */
/* clang-format off */
static const double powers[64][2] = {
    {0x1p0, 0.0}, {0x1.02c9a3e778061p0, -0x1.160139cd8dc5dp-56},
    {0x1.059b0d3158574p0, 0x1.cd2523567f613p-55}, {0x1.0874518759bc8p0, 0x1.0f74e61e6c861p-57},
    {0x1.0b5586cf9890fp0, 0x1.79aa65d837b6dp-54}, {0x1.0e3ec32d3d1a2p0, 0x1.ebe3d702f9cd1p-60},
    {0x1.11301d0125b51p0, -0x1.556522a2fbd0ep-54}, {0x1.1429aaea92dep0, -0x1.1c923b9d5f416p-54},
    {0x1.172b83c7d517bp0, -0x1.01b15eaa59348p-55}, {0x1.1a35beb6fcb75p0, 0x1.b898c3f1353bfp-55},
    {0x1.1d4873168b9aap0, 0x1.aecf73e3a2f6p-54}, {0x1.2063b88628cd6p0, 0x1.a6f4144a6c38dp-55},
    {0x1.2387a6e756238p0, 0x1.68efde3a8a894p-54}, {0x1.26b4565e27cddp0, 0x1.0472b981fe7f2p-55},
    {0x1.29e9df51fdee1p0, 0x1.2f7e16d09ab31p-55}, {0x1.2d285a6e4030bp0, 0x1.b3782720c0ab4p-55},
    {0x1.306fe0a31b715p0, 0x1.34d754db0abb6p-55}, {0x1.33c08b26416ffp0, 0x1.fdd395dd3f84ap-55},
    {0x1.371a7373aa9cbp0, -0x1.24aedcc4b5068p-54}, {0x1.3a7db34e59ff7p0, -0x1.1d1e83e9436d2p-56},
    {0x1.3dea64c123422p0, 0x1.59f48a72a4c6dp-55}, {0x1.4160a21f72e2ap0, -0x1.8a78f4817895bp-58},
    {0x1.44e086061892dp0, 0x1.363ed60c2ac11p-59}, {0x1.486a2b5c13cdp0, 0x1.ecce1daa10379p-57},
    {0x1.4bfdad5362a27p0, 0x1.690cebb7aafbp-56}, {0x1.4f9b2769d2ca7p0, -0x1.f94340071a38ep-55},
    {0x1.5342b569d4f82p0, -0x1.8dec6bd0f385fp-56}, {0x1.56f4736b527dap0, 0x1.3350518fdd78ep-54},
    {0x1.5ab07dd485429p0, 0x1.063e1e21c5409p-54}, {0x1.5e76f15ad2148p0, 0x1.432e62b64c035p-54},
    {0x1.6247eb03a5585p0, -0x1.c33c53bef4da8p-55}, {0x1.6623882552225p0, -0x1.3cedd78565858p-54},
    {0x1.6a09e667f3bcdp0, -0x1.3b3efbf5e2228p-54}, {0x1.6dfb23c651a2fp0, -0x1.367efb86da9eep-57},
    {0x1.71f75e8ec5f74p0, -0x1.81f647e5a3ecfp-56}, {0x1.75feb564267c9p0, -0x1.619321e55e68ap-55},
    {0x1.7a11473eb0187p0, -0x1.b32dcb94da51dp-56}, {0x1.7e2f336cf4e62p0, 0x1.5ebe1abd66c55p-57},
    {0x1.82589994cce13p0, -0x1.369b6f13b3734p-54}, {0x1.868d99b4492edp0, -0x1.4d450d872576ep-54},
    {0x1.8ace5422aa0dbp0, 0x1.db72fc1f0eab4p-55}, {0x1.8f1ae99157736p0, 0x1.bf68359f35f44p-56},
    {0x1.93737b0cdc5e5p0, -0x1.da9b88b6c1e29p-58}, {0x1.97d829fde4e5p0, -0x1.2434322f4f9aap-54},
    {0x1.9c49182a3f09p0, 0x1.1affc2b91ce27p-56}, {0x1.a0c667b5de565p0, -0x1.7c50422622263p-55},
    {0x1.a5503b23e255dp0, -0x1.1bbd1d3bcbb15p-54}, {0x1.a9e6b5579fdbfp0, 0x1.469846e735ab3p-55},
    {0x1.ae89f995ad3adp0, 0x1.c1a7792cb3387p-55}, {0x1.b33a2b84f15fbp0, -0x1.5c3d956dcaebap-58},
    {0x1.b7f76f2fb5e47p0, -0x1.8d6f438ad9334p-57}, {0x1.bcc1e904bc1d2p0, 0x1.4ffd70a5fddcdp-56},
    {0x1.c199bdd85529cp0, 0x1.36eae30af0cb3p-56}, {0x1.c67f12e57d14bp0, 0x1.4e08fd10959acp-55},
    {0x1.cb720dcef9069p0, 0x1.76b2c6c921968p-57}, {0x1.d072d4a07897cp0, -0x1.fad5d3ffffa6fp-55},
    {0x1.d5818dcfba487p0, 0x1.4a385a63d07a7p-56}, {0x1.da9e603db3285p0, 0x1.e5a50d5c192acp-55},
    {0x1.dfc97337b9b5fp0, -0x1.2d52107b43e1fp-55}, {0x1.e502ee78b3ff6p0, 0x1.4b604603a88d3p-56},
    {0x1.ea4afa2a490dap0, -0x1.ff7128fd391fp-55}, {0x1.efa1bee615a27p0, 0x1.ec3bc41aa2008p-55},
    {0x1.f50765b6e454p0, 0x1.a64a931d185eep-55}, {0x1.fa7c1819e90d8p0, 0x1.7893b4d91cd9dp-56},
};
/* clang-format on */

/* 1/c, log c as a multiple of 2^-42, and its rest */
/* clang-format off */
static const double logarithms[64][3] = {
    {0x1.6cp0, -0x1.686c81e9b1p-2, -0x1.2bb110af84054p-44},
    {0x1.68p0, -0x1.5d1bdbf581p-2, 0x1.8d6bdc9c7c238p-44},
    {0x1.644p0, -0x1.5262deeb99p-2, 0x1.e1b9f70894a01p-44},
    {0x1.604p0, -0x1.46d2d9c28p-2, -0x1.59b275f67f75ap-44},
    {0x1.5c8p0, -0x1.3bdd24eb15p-2, 0x1.257b4970e6ed9p-44},
    {0x1.59p0, -0x1.31871c9544p-2, -0x1.84fab94cecfd9p-46},
    {0x1.554p0, -0x1.26561f1338p-2, -0x1.8b48866faa45fp-44},
    {0x1.51cp0, -0x1.1bc794fd1dp-2, 0x1.ccf0c747ba7bep-44},
    {0x1.4e4p0, -0x1.111ce4003fp-2, 0x1.b3237096b4b6bp-46},
    {0x1.4bp0, -0x1.071b85fcd6p-2, 0x1.bcb8ba3e01a11p-44},
    {0x1.47cp0, -0x1.fa01c3bb58p-3, 0x1.a1f71fae1d786p-46},
    {0x1.448p0, -0x1.e598ed5a88p-3, 0x1.d134bcf1e98a1p-47},
    {0x1.414p0, -0x1.d0fb7f2256p-3, 0x1.af52b20633b29p-47},
    {0x1.3e4p0, -0x1.bdc46ae344p-3, -0x1.625b4023d6505p-44},
    {0x1.3bp0, -0x1.a8becfc882p-3, -0x1.e3185cf21b9cfp-44},
    {0x1.38p0, -0x1.9525a9cf46p-3, 0x1.297137d9f158fp-44},
    {0x1.354p0, -0x1.83040c91bcp-3, -0x1.e5b71c6e66f32p-44},
    {0x1.324p0, -0x1.6f0d28ae56p-3, -0x1.69737c93373dap-44},
    {0x1.2f8p0, -0x1.5c94007598p-3, 0x1.a8d948cd23322p-44},
    {0x1.2c8p0, -0x1.483bccce6ep-3, -0x1.eea52723f6369p-46},
    {0x1.2ap0, -0x1.371fc201e8p-3, -0x1.ee8779b2d8abcp-44},
    {0x1.274p0, -0x1.2423113ba6p-3, 0x1.e3a0078ee9d9cp-44},
    {0x1.248p0, -0x1.10f8e42254p-3, 0x1.93b3843396307p-45},
    {0x1.22p0, -0x1.fec9131dcp-4, 0x1.54555d1ae6607p-44},
    {0x1.1f8p0, -0x1.db5270187cp-4, -0x1.9277856ae181fp-44},
    {0x1.1dp0, -0x1.b78c82bb1p-4, 0x1.25ef7bc3987e7p-44},
    {0x1.1a8p0, -0x1.9375e55594p-4, -0x1.eddc37380c364p-44},
    {0x1.18p0, -0x1.6f0d28ae58p-4, 0x1.4b4641b664613p-44},
    {0x1.15cp0, -0x1.4e01108a34p-4, -0x1.ae5cfdf2c5ae5p-44},
    {0x1.134p0, -0x1.28f83450ecp-4, -0x1.a8d75aa119769p-44},
    {0x1.11p0, -0x1.075983599p-4, 0x1.b8ecfe4b59987p-44},
    {0x1.0ecp0, -0x1.cae72fb96p-5, 0x1.efabf2025b1bep-44},
    {0x1.0c8p0, -0x1.868a83084p-5, 0x1.2623a134ac693p-46},
    {0x1.0a8p0, -0x1.494acc34d8p-5, -0x1.11c78a56fd247p-45},
    {0x1.084p0, -0x1.03d5d85e7p-5, -0x1.f778960ed29cfp-44},
    {0x1.064p0, -0x1.8b31facaap-6, 0x1.3fc78a96e4964p-44},
    {0x1.04p0, -0x1.fc0a8b0fcp-7, -0x1.f1e7cf6d3a69cp-50},
    {0x1.02p0, -0x1.fe02a6b1p-8, -0x1.9e23f0dda40e4p-46},
    {0x1p0, 0.0, 0.0},
    {0x1.f8p-1, 0x1.020565893p-6, 0x1.611d27c8e8417p-44},
    {0x1.f08p-1, 0x1.f7a9b1678p-6, 0x1.42ad9271be7d7p-45},
    {0x1.e9p-1, 0x1.788595a358p-5, -0x1.08b0d083b3a4cp-46},
    {0x1.e2p-1, 0x1.eea31c0068p-5, 0x1.c3dd83606d891p-44},
    {0x1.dbp-1, 0x1.333d7f8184p-4, -0x1.692b6a81b8848p-49},
    {0x1.d4p-1, 0x1.700d30aeacp-4, 0x1.c1e8da99ded32p-49},
    {0x1.cd8p-1, 0x1.a956d3ecacp-4, 0x1.e63794c02c4afp-44},
    {0x1.c7p-1, 0x1.e3707ee304p-4, 0x1.0f684e6766abdp-45},
    {0x1.c1p-1, 0x1.0ce7ecdcccp-3, 0x1.4652dabff5447p-46},
    {0x1.bbp-1, 0x1.28753bc11ap-3, 0x1.7494e359302e6p-44},
    {0x1.b5p-1, 0x1.4462b9dc9cp-3, -0x1.84858a711b062p-44},
    {0x1.afp-1, 0x1.60b3100b0ap-3, -0x1.71456c988f814p-44},
    {0x1.a98p-1, 0x1.7b00916516p-3, -0x1.ae75fcb067e57p-44},
    {0x1.a4p-1, 0x1.95a5adcf7p-3, 0x1.7f22858a0ff6fp-47},
    {0x1.9fp-1, 0x1.ae2ca6f672p-3, 0x1.7a8d5ae54f55p-44},
    {0x1.998p-1, 0x1.c97f8079d4p-3, 0x1.3b161a8c6e6c5p-45},
    {0x1.948p-1, 0x1.e2a877a6b2p-3, 0x1.823817787081ap-44},
    {0x1.8f8p-1, 0x1.fc218be62p-3, 0x1.4bba46f1cf6ap-44},
    {0x1.8bp-1, 0x1.09aa572e6cp-2, 0x1.b50a1e1734342p-44},
    {0x1.86p-1, 0x1.16b5ccbadp-2, -0x1.23299042d74bfp-44},
    {0x1.818p-1, 0x1.22981fbef8p-2, -0x1.a1421609580dap-44},
    {0x1.7dp-1, 0x1.2e9e2bce12p-2, 0x1.4300c128d1dc2p-45},
    {0x1.788p-1, 0x1.3ac8ca38e6p-2, -0x1.d0befbc02be4ap-45},
    {0x1.748p-1, 0x1.45b8c0a17ep-2, -0x1.d9120e7d0a853p-47},
    {0x1.7p-1, 0x1.522ae0738ap-2, 0x1.ebe708164c759p-45},
};
/* clang-format on */

/* (value + value * fraction) 2^exponent, rounded once, near and below the ends of the range. */
static double scaled_slowly(double value, double fraction, int exponent)
{
    double tail, y = two_sum_ordered(value, value * fraction, &tail);
    if (exponent > 0) {
        return (y + tail) * double_of((uint64_t)(exponent + 1022) << 52) * 2.0;
    }
    /* 2^exponent = power 2^-100, and limit 2^exponent is the smallest normal number. */
    double power = double_of((uint64_t)(exponent + 1123) << 52);
    double limit = double_of((uint64_t)(1 - exponent) << 52);
    if (y < limit) {
        /* The last bit of limit + y has the weight of the smallest subnormal. */
        double error, sum = two_sum_ordered(limit, y, &error);
        y = (sum + (error + tail)) - limit;
    }
    return y * power * 0x1p-100;
}

double vbss_exp(double x)
{
    bool rare = !(fabs(x) < 700.0); /* above 700, value * fraction below would lose bits */
    if (rare) {
        if (x != x) {
            return canonical_nan();
        }
        if (x > 0x1.62e42fefa39efp9) { /* ln of the largest double */
            return (double)INFINITY;
        }
        if (x < -0x1.74910d52d3052p9) { /* ln 2^-1075: the result rounds to zero */
            return 0.0;
        }
    }
    double k = x * STEPS_PER_UNIT + ROUND_TO_INTEGER;
    uint64_t steps = bits_of(k); /* the low 32 bits hold the integer in two's complement */
    k -= ROUND_TO_INTEGER;
    /* k STEP_HEAD is exact: 17 + 36 bits */
    double r = (x - k * STEP_HEAD) - k * STEP_TAIL, r2 = r * r;
    const double *power = powers[steps % 64u];
    double high = (0x1.5555555555188p-5 + r * 0x1.111120b76b116p-7) + r2 * 0x1.6c16d11e43ff8p-10;
    double fraction = (power[1] + r) + r2 * ((0x1p-1 + r * 0x1.5555555554dcdp-3) + r2 * high);
    if (rare) {
        return scaled_slowly(power[0], fraction, ((int)k - (int)(steps % 64u)) / 64);
    }
    double value = double_of(bits_of(power[0]) + ((steps - steps % 64u) << 46));
    return value + value * fraction;
}

double vbss_log(double x)
{
    /* Each cell of z spans 1/64 of a binade about its centre; the first centre is 45/64. */
    const uint64_t first = UINT64_C(0x3fe6800000000000), half_cell = UINT64_C(1) << 45;
    uint64_t bits = bits_of(x);
    double k = 0.0;
    if (bits - UINT64_C(0x0010000000000000) >= UINT64_C(0x7fe0000000000000)) {
        if (x == 0.0) {
            return -(double)INFINITY;
        }
        if (!(x > 0.0)) {
            return canonical_nan();
        }
        if (x > DBL_MAX) {
            return x;
        }
        bits = bits_of(x * 0x1p54);
        k = -54.0;
    }
    /* The offset of 1024 binades makes the unsigned shift round down. */
    uint64_t from_first = bits - first + half_cell + (UINT64_C(1024) << 52);
    k += (double)(int)(from_first >> 52) - 1024.0;
    uint64_t cell = from_first >> 46 & 63u;
    double z = double_of(bits - (from_first & UINT64_C(0xfff) << 52) + (UINT64_C(1024) << 52));
    const double *c = logarithms[cell];
    /* 26 + 11 and 27 + 11 bits: both products and the difference are exact. */
    double z_head = head_of(z), r_error;
    double r = two_sum_ordered(z_head * c[0] - 1.0, (z - z_head) * c[0], &r_error);
    double r2 = r * r;
    double series = (0x1.5555555555565p-2 + r * -0x1.000000000000ep-2) +
                    r2 * ((0x1.999999911666fp-3 + r * -0x1.5555554dad847p-3) +
                          r2 * (0x1.2497c98f2816bp-3 + r * -0x1.0004f338975d3p-3));
    /* k LN2_HEAD + log c is exact: both are multiples of 2^-42 below 2^10. */
    double error, sum = two_sum_ordered(k * LN2_HEAD + c[1], r, &error);
    double rest = (error + r_error) + (k * LN2_TAIL + c[2]);
    return sum + (rest + (r2 * (r * series - 0.5)));
}
