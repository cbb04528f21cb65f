/* Requirements on the compiler, and macros for its extensions. */
#ifndef VBSS_BASE_COMPILER_H
#define VBSS_BASE_COMPILER_H

#include <float.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "-ffast-math breaks the argument reductions and exact sums of this library"
#endif
/* Excess precision (x87: 2) changes the bits of results. Mode 1 (s390x by default) widens float
 * only, and this library does not use float. */
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 1
#error "double must be evaluated in double: 32-bit x86 needs -msse2 -mfpmath=sse"
#endif
_Static_assert(sizeof(double) == 8 && DBL_MANT_DIG == 53, "double must be IEEE 754 binary64");

#if defined(__GNUC__)
/* Lets the compiler check a printf format. Both arguments are parameter positions, counted from
 * 1. */
#define VBSS_PRINTF(format_index, first_index) \
    __attribute__((format(printf, format_index, first_index)))
#else
#define VBSS_PRINTF(format_index, first_index)
#endif

/* VBSS_ALWAYS_INLINE lets the compiler specialise a function for constant arguments.
 * VBSS_NEVER_INLINE keeps a rare path out of a hot function. */
#if defined(__GNUC__)
#define VBSS_ALWAYS_INLINE static inline __attribute__((always_inline))
#define VBSS_NEVER_INLINE static __attribute__((noinline))
#else
#define VBSS_ALWAYS_INLINE static inline
#define VBSS_NEVER_INLINE static
#endif

#endif
