/* The processor's floating-point mode.
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

/* Control bits of the floating-point register; the sticky exception flags in it are 0 here. */
typedef uint64_t float_mode;

/* FLOAT_MODE_FLAGS: bits of the register that are not control bits. FLOAT_MODE_UNKNOWN: this file
 * cannot set the mode, so a call has to check it instead. */
#if defined(__SSE2__)

#define FLOAT_MODE_NEEDED 0x1f80u /* MXCSR: six exceptions masked, all else 0 */
#define FLOAT_MODE_FLAGS 0x3fu
static inline uint64_t float_mode_read_register(void)
{
    return _mm_getcsr();
}
static inline void float_mode_write_register(uint64_t value)
{
    _mm_setcsr((unsigned)value);
}

#elif defined(__GNUC__) && (defined(__aarch64__) || (defined(__arm__) && defined(__ARM_FP)) || \
                            defined(__riscv_flen) || defined(__s390x__))

#if defined(__aarch64__)
#define FLOAT_MODE_FLAGS 0u /* they have a register of their own */
#define FLOAT_MODE_READ "mrs %0, fpcr"
#define FLOAT_MODE_WRITE "msr fpcr, %0"
#elif defined(__arm__)
#define FLOAT_MODE_FLAGS 0xf800009fu /* and results of comparisons */
#define FLOAT_MODE_READ "vmrs %0, fpscr"
#define FLOAT_MODE_WRITE "vmsr fpscr, %0"
#elif defined(__riscv_flen)
#define FLOAT_MODE_FLAGS 0x1fu
#define FLOAT_MODE_READ "frcsr %0"
#define FLOAT_MODE_WRITE "fscsr %0"
#else
#define FLOAT_MODE_FLAGS 0xf8ff00u /* and the code of the last exception */
#define FLOAT_MODE_READ "efpc %0"
#define FLOAT_MODE_WRITE "sfpc %0"
#endif
#define FLOAT_MODE_NEEDED 0u
static inline uint64_t float_mode_read_register(void)
{
    uintptr_t value; /* as wide as a general register */
    __asm__ volatile(FLOAT_MODE_READ : "=r"(value));
    return value;
}
static inline void float_mode_write_register(uint64_t value)
{
    __asm__ volatile(FLOAT_MODE_WRITE : : "r"((uintptr_t)value) : "memory");
}

#else

#if !defined(__wasm__) /* WebAssembly has one mode, the one that the library needs */
#define FLOAT_MODE_UNKNOWN
#endif
#define FLOAT_MODE_NEEDED 0u
#define FLOAT_MODE_FLAGS 0u
static inline uint64_t float_mode_read_register(void)
{
    return FLOAT_MODE_NEEDED;
}
static inline void float_mode_write_register(uint64_t value)
{
    (void)value;
}

#endif

static inline float_mode float_mode_get(void)
{
    return float_mode_read_register() & ~(uint64_t)FLOAT_MODE_FLAGS;
}

/* Keeps the flags, because on x86 a write that changes them takes ten times as long. */
static inline void float_mode_set(float_mode mode)
{
    const uint64_t value = float_mode_read_register();
    if ((value & ~(uint64_t)FLOAT_MODE_FLAGS) != mode) {
        float_mode_write_register(mode | (value & FLOAT_MODE_FLAGS));
    }
}

#endif
