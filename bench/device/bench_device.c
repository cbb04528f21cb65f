/* Suite device: the layer between hand and scene. */
#include "bench_device.h"

#include <vblast_ss/base.h>

static void add_cases(bench *b)
{
    add_cost_cases(b);
    add_passivity_cases(b);
}

int main(int argc, char **argv)
{
    const bench_suite suite = {"device", vbss_build_info(), add_cases};
    return bench_main(argc, argv, &suite);
}
