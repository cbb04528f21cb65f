/* Degenerate queries without thickness, default suite: all as the oracle has them. */
#include "degenerate_check.h"

static void degenerate_sets_match_oracle(void **state)
{
    (void)state;
    expect_degenerate_sets_right(400, 1);
}

/* Exact answers do not depend on how a direction is found or when it is given up. */
static void degenerate_sets_match_oracle_at_any_pass_limit(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 2 * collision_degenerate_count; i++) {
        collision_set set;
        assert_true(collision_set_degenerate(i / 2, (vbss_collision_pair_kind)(i % 2), 100, 2,
                                             oracle_meets, &set));
        for (uint32_t k = 0; k < set.count; k++) {
            const collision_query *query = &set.queries[k];
            vbss_collision_config config = config_of(query);
            config.pass_limit = 1 + k % 4;
            vbss_collision_impact impact = ask(&config, query);
            if (degenerate_wrong(query, &impact) != NULL) {
                print_query(degenerate_wrong(query, &impact), query);
                fail_msg("with %u passes", config.pass_limit);
            }
        }
        collision_set_release(&set);
    }
}

int test_degenerate(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(degenerate_sets_match_oracle),
        cmocka_unit_test(degenerate_sets_match_oracle_at_any_pass_limit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
