/* Detection of AVX2 at run time. */
#include "base/simd_dispatch.h"

#if defined(VBSS_HAVE_WIDE)

#include <cpuid.h>

/* Requires AVX2 in the processor and an operating system that saves the wide registers. */
bool vbss_wide_is_available(void)
{
    unsigned a, b, c, d;
    if (__get_cpuid(1, &a, &b, &c, &d) == 0 || (c & bit_OSXSAVE) == 0 || (c & bit_AVX) == 0) {
        return false;
    }
    unsigned low, high;
    __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    const unsigned sse_and_avx_state = 6;
    if ((low & sse_and_avx_state) != sse_and_avx_state ||
        __get_cpuid_count(7, 0, &a, &b, &c, &d) == 0) {
        return false;
    }
    return (b & bit_AVX2) != 0;
}

#else

bool vbss_wide_is_available(void)
{
    return false;
}

#endif
