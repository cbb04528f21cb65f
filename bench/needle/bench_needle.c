/* Suite needle: what a needle in flight costs, and a step in which hands pass one through a drain. */
#include "needle/bench_needle.h"

#include <vblast_ss/base.h>

static void add_cases(bench *b)
{
    add_flights(b);
    add_passed(b);
}

int main(int argc, char **argv)
{
    const bench_suite suite = {"needle", vbss_build_info(), add_cases};
    return bench_main(argc, argv, &suite);
}
