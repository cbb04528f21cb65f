#include "harness/float_modes.h"

#include "base/float_mode.h"
#include "harness/harness.h"

/* Rounding down, up and to zero; subnormal numbers flushed; all exceptions unmasked, where the
 * processor has that. */
#if defined(__SSE2__)
static const float_mode modes[] = {0x3f80, 0x5f80, 0x7f80, 0x9fc0, 0x0000};
#define IS_KNOWN 1
#elif defined(__aarch64__)
static const float_mode modes[] = {0x800000, 0x400000, 0xc00000, 0x1000000};
#define IS_KNOWN 1
#else
static const float_mode modes[] = {FLOAT_MODE_NEEDED};
#define IS_KNOWN 0
#endif

const size_t harness_mode_count = IS_KNOWN ? sizeof modes / sizeof modes[0] : 0;

void harness_mode_set(size_t k)
{
    float_mode_set(modes[k]);
}

void harness_mode_reset(void)
{
    float_mode_set(FLOAT_MODE_NEEDED);
}

bool harness_mode_is(size_t k)
{
    return float_mode_get() == modes[k];
}

void harness_mode_end(size_t k)
{
    bool kept = harness_mode_is(k);
    harness_mode_reset(); /* an assertion that fails must not leave the mode behind */
    assert_true(kept);
}
