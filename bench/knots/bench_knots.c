/* Suite knots: what a verdict costs beside how often it is wrong. */
#include "knots/bench_knots.h"

#include "knots/shown_set.h"

#include <vblast_ss/base.h>

static void add_cases(bench *b)
{
    add_family_cases(b);
    add_stage_cases(b);
    add_moving_cases(b);
    add_projection_cases(b);
}

int main(int argc, char **argv)
{
    const bench_suite suite = {"knots", vbss_build_info(), add_cases};
    int status = bench_main(argc, argv, &suite);
    shown_set_end();
    return status;
}
