/* A thousand random configurations of knots that are known, a seed: families, isotopies and what is derived of them
 * (derive.h). Nothing that is said is wrong, and less than one in a thousand is uncertain. */
#include "harness/harness.h"
#include "knot/derive.h"

enum { CASES = 40, CONFIGURATIONS = 25 };

static uint32_t draw_segments(vbss_random *random, const family *f)
{
    uint32_t largest = 400, smallest = f->min_segments > 50 ? f->min_segments : 50;
    return smallest + vbss_random_below(random, largest - smallest + 1);
}

static void run(harness_soak *out)
{
    judge j;
    judge_counts all = {0};
    vbss_random random;
    uint64_t made = 0;
    judge_begin(&j);
    if (!judge_make(&j)) {
        harness_soak_fail(out, "no detector");
        return;
    }
    vbss_random_seed(&random, out->seed, 11);
    for (uint32_t i = 0; i < CASES; i++) {
        uint32_t which = (i + (uint32_t)out->seed) % FAMILIES;
        uint32_t segments = draw_segments(&random, &families[which]);
        uint64_t seed = vbss_random_u64(&random) >> 20;
        uint64_t wrong = all.wrong;
        judge_counts counts = {0};
        made += derive_and_judge(&j, &families[which], seed, segments, CONFIGURATIONS, &counts);
        judge_add_up(&all, &counts);
        if (all.wrong > wrong) {
            harness_soak_fail(out, "%llu wrong; %s", (unsigned long long)counts.wrong,
                              counts.first);
        } else if (counts.uncertain > 0) { /* one in a thousand may be */
            fprintf(stderr, "%s\n", counts.first);
        }
    }
    if (100 * all.uncertain > all.heard) {
        harness_soak_fail(out, "%llu uncertain", (unsigned long long)all.uncertain);
    }
    judge_end(&j);
    harness_soak_figure(out, "made", (double)made);
    harness_soak_figure(out, "heard", (double)all.heard);
    harness_soak_figure(out, "wrong", (double)all.wrong);
    harness_soak_figure(out, "uncertain", (double)all.uncertain);
    harness_soak_figure(out, "certified", (double)all.certified);
    harness_soak_figure(out, "ordered", (double)all.ordered);
    harness_soak_figure(out, "located", (double)all.located);
    harness_soak_figure(out, "without_truth", (double)all.untrue);
    harness_soak_figure(out, "stacks", (double)all.stacks);
    harness_soak_figure(out, "recognised", (double)all.recognised);
    harness_soak_figure(out, "stacks_certified", (double)all.proved);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
