/* A suite of one case, for the harness that all suites share. */
#include <vblast_ss/base.h>

#include "harness/bench.h"

static void add_up(void *user)
{
    double *sum = user;
    *sum += 0.5;
    bench_keep(*sum);
}

static void add_counters(void *user, bench_result *result)
{
    (void)user;
    bench_counter(result, "half", 0.5);
}

static void add_cases(bench *b)
{
    static double sum;
    const bench_batch batch = {
        .name = "tiny/half/ours", .user = &sum, .items = 1, .run = add_up, .finish = add_counters};
    bench_add_batch(b, &batch);
}

int main(int argc, char **argv)
{
    const bench_suite suite = {"tiny", vbss_build_info(), add_cases};
    return bench_main(argc, argv, &suite);
}
