/* CONSERVATIVE without thickness against the oracle: 12 000 degenerate queries a seed, 100 seeds are the
 * million of docs/explanation/collision.md. */
#include "degenerate_check.h"

static void run(harness_soak *soak)
{
    score all = {0};
    for (uint32_t i = 0; i < 2 * collision_degenerate_count; i++) {
        score s =
            degenerate_score(i / 2, (vbss_collision_pair_kind)(i % 2), 400, 1000 + soak->seed);
        all.queries += s.queries;
        all.hits += s.hits;
        all.missed += s.missed;
        all.invented += s.invented;
        all.undecided += s.undecided;
        if (s.wrong > 0) {
            harness_soak_fail(soak, "%s: %llu wrong", collision_degenerate_names[i / 2],
                              (unsigned long long)s.wrong);
        }
    }
    harness_soak_figure(soak, "queries", (double)all.queries);
    harness_soak_figure(soak, "hits", (double)all.hits);
    harness_soak_figure(soak, "missed", (double)all.missed);
    harness_soak_figure(soak, "invented", (double)all.invented);
    harness_soak_figure(soak, "undecided", (double)all.undecided);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
