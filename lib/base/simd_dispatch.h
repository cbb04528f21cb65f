/* Hot loops compiled twice: for any processor, and with AVX2 (the wide copy).
 *
 * A file with such loops names its functions VBSS_WIDE_NAME(function), and the build compiles it
 * again with VBSS_WIDE defined. Lanes are independent, so both copies give the same bits. */
#ifndef VBSS_BASE_SIMD_DISPATCH_H
#define VBSS_BASE_SIMD_DISPATCH_H

#include <stdbool.h>

#if defined(VBSS_WIDE)
#define VBSS_WIDE_NAME(function) function##_wide
#else
#define VBSS_WIDE_NAME(function) function##_plain
#endif
#if defined(VBSS_HAVE_WIDE)
#define VBSS_WIDE_CALL(wide, function, ...) \
    ((wide) ? function##_wide(__VA_ARGS__) : function##_plain(__VA_ARGS__))
#else
#define VBSS_WIDE_CALL(wide, function, ...) ((void)(wide), function##_plain(__VA_ARGS__))
#endif
/* Whether both this processor and this build support the wide copies. */
bool vbss_wide_is_available(void);

#endif
