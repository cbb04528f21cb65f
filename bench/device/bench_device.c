/* Suite device: the layer between hand and scene, and what a hand feels of a scene's graspers. */
#include "bench_device.h"

#include <vblast_ss/base.h>

static void add_cases(bench *b)
{
    add_cost_cases(b);
    add_passivity_cases(b);
    add_tool_passivity_cases(b);
    add_tool_rest_cases(b);
    add_tool_wall_cases(b);
    add_tool_cost_cases(b);
    add_step_sizes(b);
}

int main(int argc, char **argv)
{
    const bench_suite suite = {"device", vbss_build_info(), add_cases};
    return bench_main(argc, argv, &suite);
}
