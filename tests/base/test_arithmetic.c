#include <fenv.h>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "harness/harness.h"

static void round_to_nearest_is_accepted(void **state)
{
    (void)state;
    expect_ok(vbss_arithmetic_check());
}

static void other_rounding_modes_are_rejected(void **state)
{
    (void)state;
    const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    for (int i = 0; i < 3; i++) {
        assert_int_equal(fesetround(modes[i]), 0);
        vbss_result result = vbss_arithmetic_check();
        fesetround(FE_TONEAREST);
        expect_result(VBSS_ERROR_ARITHMETIC_MODE, result);
    }
    expect_ok(vbss_arithmetic_check());
}

#if defined(__SSE2__)
static void flush_to_zero_is_rejected(void **state)
{
    (void)state;
    const unsigned flush_to_zero = 0x8000u, denormals_are_zero = 0x0040u;
    unsigned normal = _mm_getcsr();
    _mm_setcsr(normal | flush_to_zero);
    vbss_result flushed = vbss_arithmetic_check();
    _mm_setcsr(normal | denormals_are_zero);
    vbss_result zeroed = vbss_arithmetic_check();
    _mm_setcsr(normal);
    expect_result(VBSS_ERROR_ARITHMETIC_MODE, flushed);
    expect_result(VBSS_ERROR_ARITHMETIC_MODE, zeroed);
    expect_ok(vbss_arithmetic_check());
}
#endif

int test_arithmetic(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(round_to_nearest_is_accepted),
        harness_test(other_rounding_modes_are_rejected),
#if defined(__SSE2__)
        harness_test(flush_to_zero_is_rejected),
#endif
    };
    return cmocka_run_group_tests_name("base.arithmetic", tests, NULL, NULL);
}
