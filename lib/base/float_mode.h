/* The processor's floating-point control register.
 *
 * The library computes with rounding to nearest, with subnormal numbers, and with all exceptions
 * masked. A host may have set something else in its thread, so each public call sets the mode that
 * the library needs and restores the host's (api_call.h). */
#ifndef VBSS_BASE_FLOAT_MODE_H
#define VBSS_BASE_FLOAT_MODE_H

#include <stdint.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

/* Contents of the control register. On x86, 32-bit ARM, RISC-V and s390x it includes the sticky
 * exception flags. */
typedef uint64_t float_mode;

/* FLOAT_MODE_UNKNOWN: this file cannot set the mode, so a call has to check it instead. */
#if defined(__SSE2__)

#define FLOAT_MODE_NEEDED 0x1f80u /* MXCSR: six exceptions masked, all else 0 */
static inline float_mode float_mode_get(void)
{
    return _mm_getcsr();
}
static inline void float_mode_set(float_mode mode)
{
    _mm_setcsr((unsigned)mode);
}

#elif defined(__GNUC__) && (defined(__aarch64__) || (defined(__arm__) && defined(__ARM_FP)) || \
                            defined(__riscv_flen) || defined(__s390x__))

#if defined(__aarch64__)
#define FLOAT_MODE_READ "mrs %0, fpcr"
#define FLOAT_MODE_WRITE "msr fpcr, %0"
#elif defined(__arm__)
#define FLOAT_MODE_READ "vmrs %0, fpscr"
#define FLOAT_MODE_WRITE "vmsr fpscr, %0"
#elif defined(__riscv_flen)
#define FLOAT_MODE_READ "frcsr %0"
#define FLOAT_MODE_WRITE "fscsr %0"
#else
#define FLOAT_MODE_READ "efpc %0"
#define FLOAT_MODE_WRITE "sfpc %0"
#endif
#define FLOAT_MODE_NEEDED 0u
static inline float_mode float_mode_get(void)
{
    uintptr_t mode; /* of the width of a general register */
    __asm__ volatile(FLOAT_MODE_READ : "=r"(mode));
    return mode;
}
static inline void float_mode_set(float_mode mode)
{
    __asm__ volatile(FLOAT_MODE_WRITE : : "r"((uintptr_t)mode) : "memory");
}

#else

#if !defined(__wasm__) /* WebAssembly has one mode, the one that the library needs */
#define FLOAT_MODE_UNKNOWN
#endif
#define FLOAT_MODE_NEEDED 0u
static inline float_mode float_mode_get(void)
{
    return FLOAT_MODE_NEEDED;
}
static inline void float_mode_set(float_mode mode)
{
    (void)mode;
}

#endif

#endif
