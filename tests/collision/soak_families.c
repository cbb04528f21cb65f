/* CONSERVATIVE with thickness on 10 000 queries a seed of the hard families and the thread: 100 seeds are
 * the million of docs/explanation/collision.md. */
#include "query.h"

/* Of each family; with a part of the thread it is 10 000 in all. */
enum { COUNT = 333, THREAD_COUNT = 2008 };

static void check_queries(harness_soak *soak, const collision_set *set, uint32_t first,
                          uint32_t count, score *s)
{
    for (uint32_t i = first; i < first + count && i < set->count; i++) {
        const collision_query *query = &set->queries[i];
        vbss_collision_config config = config_of(query);
        vbss_collision_impact impact = ask(&config, query);
        score_add(s, query, &impact);
        bool invented = impact.hit && query->clearance > config.tolerance * query->thickness;
        if ((query->hit && !impact.hit) || invented) {
            print_query(invented ? "invented" : "missed", query);
            harness_soak_fail(soak, "%s, query %u", set->name, i);
        }
    }
}

static void run(harness_soak *soak)
{
    score s = {0};
    for (uint32_t i = 0; i < thick_set_count(); i++) {
        collision_set set;
        make_thick_set(i, COUNT, soak->seed, &set);
        bool thread = i + 1 == thick_set_count();
        uint32_t last = set.count > THREAD_COUNT ? set.count - THREAD_COUNT : 0;
        check_queries(soak, &set, thread ? (uint32_t)(soak->seed * 997 % (last + 1)) : 0,
                      thread ? THREAD_COUNT : COUNT, &s);
        collision_set_release(&set);
    }
    harness_soak_figure(soak, "queries", (double)s.queries);
    harness_soak_figure(soak, "hits", (double)s.hits);
    harness_soak_figure(soak, "missed", (double)s.missed);
    harness_soak_figure(soak, "invented", (double)s.invented);
    harness_soak_figure(soak, "undecided", (double)s.undecided);
    harness_soak_figure(soak, "worst_invented_by_D", s.worst);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
