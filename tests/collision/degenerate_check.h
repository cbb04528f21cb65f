/* CONSERVATIVE with D = 0 against the oracle, on the degenerate sets: for tests and soak. */
#ifndef VBSS_TESTS_COLLISION_DEGENERATE_CHECK_H
#define VBSS_TESTS_COLLISION_DEGENERATE_CHECK_H

#include "oracle/oracle.h"
#include "query.h"

/* Binary places from the highest to the lowest bit of the coordinates. */
static inline int places_of(const collision_query *query)
{
    int highest = -2000, lowest = 2000;
    for (int i = 0; i < 24; i++) {
        double x = i % 2 == 0 ? query->start[i / 2] : query->end[i / 2];
        if (x != 0.0) {
            highest = ilogb(x) > highest ? ilogb(x) : highest;
            lowest = ilogb(x) - 52 < lowest ? ilogb(x) - 52 : lowest;
        }
    }
    return highest - lowest;
}

/* What is wrong with an answer; NULL: nothing. The time told is one before which nothing meets. Beyond
 * EXACT_PLACES, which a subnormal coordinate next to 1 exceeds, a hit may be told without proof. */
enum { EXACT_PLACES = 250 };
static inline const char *degenerate_wrong(const collision_query *query,
                                           const vbss_collision_impact *impact)
{
    if (impact->decision == VBSS_COLLISION_DECISION_UNDECIDED) {
        return places_of(query) > EXACT_PLACES && impact->hit ? NULL : "undecided";
    }
    if (query->hit != (impact->hit != 0)) {
        return query->hit ? "missed" : "invented";
    }
    return impact->hit && oracle_meets_before(query, impact->time) ? "contact before the time told"
                                                                   : NULL;
}

static inline score degenerate_score(uint32_t which, vbss_collision_pair_kind kind, uint32_t count,
                                     uint64_t seed)
{
    collision_set set;
    assert_true(collision_set_degenerate(which, kind, count, seed, oracle_meets, &set));
    score s = {0};
    for (uint32_t i = 0; i < set.count; i++) {
        const collision_query *query = &set.queries[i];
        vbss_collision_config config = config_of(query);
        vbss_collision_impact impact = ask(&config, query);
        score_add(&s, query, &impact);
        const char *wrong = degenerate_wrong(query, &impact);
        if (wrong != NULL && s.wrong++ < 3) {
            print_query(wrong, query);
        }
    }
    collision_set_release(&set);
    return s;
}

/* Both kinds, all sets; one line each. */
static inline void expect_degenerate_sets_right(uint32_t count, uint64_t seed)
{
    uint64_t wrong = 0;
    for (uint32_t i = 0; i < collision_degenerate_count; i++) {
        for (vbss_collision_pair_kind kind = 0; kind < 2; kind++) {
            score s = degenerate_score(i, kind, count, seed);
            print_message("%-22s %s %6llu queries, %5llu hits: missed %llu, invented %llu, "
                          "undecided %llu, wrong %llu\n",
                          collision_degenerate_names[i],
                          kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? "EE" : "VF",
                          (unsigned long long)s.queries, (unsigned long long)s.hits,
                          (unsigned long long)s.missed, (unsigned long long)s.invented,
                          (unsigned long long)s.undecided, (unsigned long long)s.wrong);
            wrong += s.wrong;
        }
    }
    assert_int_equal(wrong, 0);
}

#endif
