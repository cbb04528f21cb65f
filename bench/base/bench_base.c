/* Suite base: what the ground floor of the library costs, and how exact it is. */
#include "bench_base.h"

#include <vblast_ss/base.h>

static void add_cases(bench *b)
{
    static void (*const groups[])(bench *) = {
        add_api_call_cases,
        add_elementary_cases,
        add_kernel_cases,
        add_spinning_bodies_cases,
    };
    for (size_t i = 0; i < sizeof groups / sizeof groups[0]; i++) {
        groups[i](b);
    }
}

int main(int argc, char **argv)
{
    const bench_suite suite = {"base", vbss_build_info(), add_cases};
    return bench_main(argc, argv, &suite);
}
