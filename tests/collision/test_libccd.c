/* Against libccd, where it is reliable: whether two capsules overlap, and whether what a step can bring
 * together meets. */
#include "harness/harness.h"

#include <vblast_ss/collision.h>

#include "collision/capsule_pairs.h"
#include "collision/libccd_reference.h"
#include "fixtures/collision_sets.h"

/* ---- distance */

static void compare_overlap(harness_source *source, void *user)
{
    capsule_pair pair = draw_capsule_pair(source, *(const capsule_pair_kind *)user);
    vbss_collision_closest closest;
    expect_ok(vbss_collision_closest_capsules(pair.vertices, pair.radius_a, pair.vertices + 6,
                                              pair.radius_b, &closest, sizeof closest));
    if (fabs(closest.distance) <= LIBCCD_BLUR) {
        return; /* its known error: nearer than this GJK's rounding decides */
    }
    libccd_hull a, b;
    libccd_features(VBSS_COLLISION_PAIR_EDGE_EDGE, pair.vertices, 0.0, &a, &b);
    a.radius = pair.radius_a;
    b.radius = pair.radius_b;
    assert_int_equal(libccd_meet(&a, &b), closest.distance < 0.0);
}

static void capsule_overlap_matches_gjk(void **state)
{
    (void)state;
    for (int kind = 0; kind < CAPSULE_PAIR_KINDS; kind++) {
        capsule_pair_kind drawn = (capsule_pair_kind)kind;
        harness_property("overlap of capsules", 20000, compare_overlap, &drawn);
    }
}

/* ---- continuous tests */

enum { QUERIES = 300 };

/* Features that overlap at an end of the step are a hit; features whose differences never come near
 * are none. libccd knows no more about motion. */
static void check_between(const collision_query *q, const vbss_collision_config *config)
{
    libccd_hull a, b, difference;
    vbss_collision_impact impact;
    expect_ok(vbss_collision_test_edges(config, q->start, q->end, &impact, sizeof impact));
    for (int end = 0; end < 2; end++) {
        libccd_features(q->kind, end ? q->end : q->start, q->thickness - LIBCCD_BLUR, &a, &b);
        if (libccd_meet(&a, &b)) {
            assert_int_equal(impact.hit, 1);
        }
    }
    double farthest = q->thickness * (1.0 + config->tolerance) + LIBCCD_BLUR;
    libccd_swept_difference(q->kind, q->start, q->end, farthest, &difference);
    if (impact.hit == 1) {
        assert_true(libccd_holds_origin(&difference));
    }
}

static void hits_lie_between_end_and_swept_gjk(void **state)
{
    (void)state;
    vbss_collision_config config;
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    for (uint32_t family = 0; family < collision_family_count; family++) {
        collision_set set;
        assert_true(collision_set_family(family, QUERIES, 2, &set));
        for (uint32_t i = 0; i < set.count; i++) {
            config.thickness = set.queries[i].thickness;
            check_between(&set.queries[i], &config);
        }
        collision_set_release(&set);
    }
}

int test_libccd(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(capsule_overlap_matches_gjk),
        cmocka_unit_test(hits_lie_between_end_and_swept_gjk),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
