/* For compilers without inline assembly: a store they must not leave out, in a file of its own. */
#include "harness/bench.h"

#if !defined(__GNUC__)
static volatile double kept_value;
static volatile uint64_t kept_number;
static const volatile void *volatile kept_memory;

void bench_keep(double value)
{
    kept_value = value;
}

void bench_keep_u64(uint64_t value)
{
    kept_number = value;
}

void bench_keep_memory(const void *memory)
{
    kept_memory = memory;
}
#else
typedef int bench_nothing_to_keep_here;
#endif
