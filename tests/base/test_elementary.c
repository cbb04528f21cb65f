#include "base/elementary_ulp.h"
#include "harness/harness.h"

#define PI 0x1.921fb54442d18p1
#define CANONICAL_NAN UINT64_C(0x7ff8000000000000)

static const double infinite = (double)INFINITY;

static void expect_bits(const char *name, elementary_argument a, double wanted, double got)
{
    uint64_t wanted_bits = isnan(wanted) ? CANONICAL_NAN : bits_of(wanted);
    if (wanted_bits != bits_of(got)) {
        fail_msg("%s of x = %a, y = %a is %a and not %a", name, a.x, a.y, got, wanted);
    }
}

static void special_values_match_annex_f(void **state)
{
    (void)state;
    const double nan = (double)NAN, tiny = 0x1p-1074, huge = DBL_MAX;
    const struct {
        size_t function; /* in elementary_functions */
        double x, y, wanted;
    } table[] = {
        {SIN, 0.0, 0, 0.0},
        {SIN, -0.0, 0, -0.0},
        {SIN, tiny, 0, tiny},
        {SIN, -tiny, 0, -tiny},
        {SIN, infinite, 0, nan},
        {SIN, -infinite, 0, nan},
        {SIN, nan, 0, nan},
        {COS, 0.0, 0, 1.0},
        {COS, -0.0, 0, 1.0},
        {COS, tiny, 0, 1.0},
        {COS, infinite, 0, nan},
        {COS, -infinite, 0, nan},
        {COS, -nan, 0, nan},
        {ATAN2, 1.0, 0.0, 0.0},
        {ATAN2, 1.0, -0.0, -0.0},
        {ATAN2, -1.0, 0.0, PI},
        {ATAN2, -1.0, -0.0, -PI},
        {ATAN2, 0.0, 0.0, 0.0},
        {ATAN2, 0.0, -0.0, -0.0},
        {ATAN2, -0.0, 0.0, PI},
        {ATAN2, -0.0, -0.0, -PI},
        {ATAN2, 0.0, 1.0, PI / 2},
        {ATAN2, -0.0, 1.0, PI / 2},
        {ATAN2, 0.0, -1.0, -PI / 2},
        {ATAN2, -0.0, -tiny, -PI / 2},
        {ATAN2, infinite, 1.0, 0.0},
        {ATAN2, infinite, -1.0, -0.0},
        {ATAN2, -infinite, huge, PI},
        {ATAN2, -infinite, -huge, -PI},
        {ATAN2, -infinite, -0.0, -PI},
        {ATAN2, 1.0, infinite, PI / 2},
        {ATAN2, -huge, -infinite, -PI / 2},
        {ATAN2, 0.0, infinite, PI / 2},
        {ATAN2, infinite, infinite, PI / 4},
        {ATAN2, infinite, -infinite, -PI / 4},
        {ATAN2, -infinite, infinite, 0x1.2d97c7f3321d2p1},
        {ATAN2, -infinite, -infinite, -0x1.2d97c7f3321d2p1},
        {ATAN2, huge, tiny, 0.0},
        {ATAN2, huge, -tiny, -0.0},
        {ATAN2, -huge, tiny, PI},
        {ATAN2, tiny, huge, PI / 2},
        {ATAN2, -tiny, -huge, -PI / 2},
        {ATAN2, tiny, tiny, PI / 4},
        {ATAN2, huge, huge, PI / 4},
        {ATAN2, 1.0, tiny, tiny},
        {ATAN2, 1.0, -tiny, -tiny},
        {ATAN2, 0x1p30, 0x1.8p-1040, 0x1.8p-1070},
        {ATAN2, nan, 1.0, nan},
        {ATAN2, 1.0, nan, nan},
        {ATAN2, nan, infinite, nan},
        {ATAN2, -infinite, nan, nan},
        {ATAN2, nan, 0.0, nan},
        {ATAN2, -0.0, -nan, nan},
        {ACOS, 1.0, 0, 0.0},
        {ACOS, -1.0, 0, PI},
        {ACOS, 0.0, 0, PI / 2},
        {ACOS, -0.0, 0, PI / 2},
        {ACOS, tiny, 0, PI / 2},
        {ACOS, 0x1.0000000000001p0, 0, nan},
        {ACOS, -0x1.0000000000001p0, 0, nan},
        {ACOS, infinite, 0, nan},
        {ACOS, -infinite, 0, nan},
        {ACOS, nan, 0, nan},
        {EXP, 0.0, 0, 1.0},
        {EXP, -0.0, 0, 1.0},
        {EXP, tiny, 0, 1.0},
        {EXP, -tiny, 0, 1.0},
        {EXP, infinite, 0, infinite},
        {EXP, -infinite, 0, 0.0},
        {EXP, nan, 0, nan},
        {EXP, -nan, 0, nan},
        {EXP, 0x1.62e42fefa39fp9, 0, infinite},
        {EXP, 0x1.62e42fefa39efp9, 0, 0x1.fffffffffff2ap1023},
        {EXP, huge, 0, infinite},
        {EXP, -huge, 0, 0.0},
        {EXP, -0x1.74910d52d3051p9, 0, tiny},
        {EXP, -0x1.74910d52d3052p9, 0, 0.0},
        {EXP, -0x1.74p9, 0, 0x1p-1073},
        {LOG, 0.0, 0, -infinite},
        {LOG, -0.0, 0, -infinite},
        {LOG, 1.0, 0, 0.0},
        {LOG, -tiny, 0, nan},
        {LOG, -1.0, 0, nan},
        {LOG, -infinite, 0, nan},
        {LOG, infinite, 0, infinite},
        {LOG, nan, 0, nan},
        {LOG, tiny, 0, -0x1.74385446d71c3p9},
        {LOG, huge, 0, 0x1.62e42fefa39efp9},
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        const elementary_function *f = &elementary_functions[table[i].function];
        elementary_argument a = {table[i].x, table[i].y};
        expect_bits(f->name, a, table[i].wanted, f->ours(a));
    }
    double sine, cosine;
    vbss_sincos(-infinite, &sine, &cosine);
    expect_bits("sincos", (elementary_argument){-infinite, 0.0}, nan, sine);
    expect_bits("sincos", (elementary_argument){-infinite, 0.0}, nan, cosine);
    vbss_sincos(-0.0, &sine, &cosine);
    expect_bits("sincos", (elementary_argument){-0.0, 0.0}, -0.0, sine);
    expect_bits("sincos", (elementary_argument){-0.0, 0.0}, 1.0, cosine);
}

static void known_values_match(void **state)
{
    (void)state;
    expect_same_bits(0x1.5bf0a8b145769p1, vbss_exp(1.0));
    expect_same_bits(0x1.78b56362cef38p-2, vbss_exp(-1.0));
    expect_same_bits(0x1.62e42fefa39efp-1, vbss_log(2.0));
    expect_same_bits(-0x1.62e42fefa39efp-1, vbss_log(0.5));
    expect_same_bits(0x1.0c152382d7366p0, vbss_acos(0.5));
    expect_same_bits(PI / 4.0, vbss_atan2(3.0, 3.0));
    expect_same_bits(3.0 * PI / 4.0, vbss_atan2(7.0, -7.0));
    /* What pi and pi/2 as doubles lack. */
    expect_same_bits(0x1.1a62633145c07p-53, vbss_sin(PI));
    expect_same_bits(0x1.1a62633145c07p-54, vbss_cos(0.5 * PI));
    expect_same_bits(1.0, vbss_sin(0.5 * PI));
    expect_same_bits(-1.0, vbss_cos(PI));
    /* The double closest to a multiple of pi/2 in its own scale, from integer arithmetic. */
    expect_same_bits(0x1.14ae72e6ba22fp-61, fabs(vbss_cos(0x1.6ac5b262ca1ffp849)));
    expect_same_bits(1.0, fabs(vbss_sin(0x1.6ac5b262ca1ffp849)));
}

static void symmetries_are_bit_exact(void **state)
{
    (void)state;
    vbss_random random;
    vbss_random_seed(&random, 2, 0);
    for (int i = 0; i < 100000; i++) {
        elementary_argument a = draw_angle(&random), minus = {-a.x, 0.0};
        double sine, cosine;
        vbss_sincos(a.x, &sine, &cosine);
        expect_bits("sine by sincos", a, vbss_sin(a.x), sine);
        expect_bits("cosine by sincos", a, vbss_cos(a.x), cosine);
        expect_bits("sine", minus, -sine, vbss_sin(-a.x));
        expect_bits("cosine", minus, cosine, vbss_cos(-a.x));
        a = draw_direction(&random);
        expect_bits("atan2", a, -vbss_atan2(a.y, a.x), vbss_atan2(-a.y, a.x));
    }
}

static void monotonic_at_range_ends(void **state)
{
    (void)state;
    double one = 1.0, minus_one = -1.0, below = -745.2, logarithm = 0.999999999999;
    for (int i = 0; i < 20000; i++) {
        double next = nextafter(one, 0.0);
        assert_true(vbss_acos(next) > vbss_acos(one));
        one = next;
        next = nextafter(minus_one, 0.0);
        assert_true(vbss_acos(next) <= vbss_acos(minus_one));
        minus_one = next;
        next = below + 0.002; /* through the subnormals */
        assert_true(vbss_exp(next) >= vbss_exp(below));
        below = next;
        next = nextafter(logarithm, 2.0);
        assert_true(vbss_log(next) > vbss_log(logarithm));
        logarithm = next;
    }
}

static void error_bounds_hold(void **state)
{
    (void)state;
    /* Fewer where long double is software. */
    const uint64_t count = LDBL_MANT_DIG > 64 ? 20000 : 200000;
    for (size_t i = 0; i < ELEMENTARY_FUNCTIONS; i++) {
        const elementary_function *f = &elementary_functions[i];
        elementary_argument where = {0.0, 0.0};
        double worst = worst_ulp_error(f, 3, count, &where);
        if (!(worst <= f->bound + REFERENCE_ERROR)) {
            fail_msg("%s is %.4f ulp off at x = %a, y = %a", f->name, worst, where.x, where.y);
        }
    }
}

/* Half of the arguments are any bit patterns at all, NaN included. */
static void golden_bits(void **state)
{
    (void)state;
    static const uint64_t golden[ELEMENTARY_FUNCTIONS] = {
        UINT64_C(0xdddf380397dbeccd), UINT64_C(0xa976a0b4437f26eb), UINT64_C(0x4a1eaa53e1dc2528),
        UINT64_C(0x3a48502ededce254), UINT64_C(0x9a6573679aeb71da), UINT64_C(0x8fb5b502e6328fd2),
    };
    for (size_t i = 0; i < ELEMENTARY_FUNCTIONS; i++) {
        const elementary_function *f = &elementary_functions[i];
        vbss_random random;
        vbss_random_seed(&random, 4, 0);
        uint64_t hash = UINT64_C(0xcbf29ce484222325); /* FNV-1a over 64-bit words */
        for (int k = 0; k < 50000; k++) {
            elementary_argument any = {double_of(vbss_random_u64(&random)), 0.0};
            any.y = double_of(vbss_random_u64(&random));
            hash = (hash ^ bits_of(f->ours(f->draw(&random)))) * UINT64_C(0x100000001b3);
            hash = (hash ^ bits_of(f->ours(any))) * UINT64_C(0x100000001b3);
        }
        if (hash != golden[i]) {
            fail_msg("%s hashes to 0x%016llx", f->name, (unsigned long long)hash);
        }
    }
}

int test_elementary(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(special_values_match_annex_f),
        harness_test(known_values_match),
        harness_test(symmetries_are_bit_exact),
        harness_test(monotonic_at_range_ends),
        harness_test(error_bounds_hold),
        harness_test(golden_bits),
    };
    return cmocka_run_group_tests_name("base.elementary", tests, NULL, NULL);
}
