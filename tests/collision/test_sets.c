/* The sets themselves: the same for a seed, and true. */
#include "query.h"

enum { COUNT = 400 };

/* ---- repeatable */

/* Sets with thickness, then degenerate ones of both kinds, without truth. */
static uint32_t set_count(void)
{
    return thick_set_count() + 2 * collision_degenerate_count;
}

static void make_set(uint32_t which, uint64_t seed, collision_set *set)
{
    if (which < thick_set_count()) {
        make_thick_set(which, COUNT, seed, set);
        return;
    }
    which -= thick_set_count();
    assert_true(collision_set_degenerate(which / 2, (vbss_collision_pair_kind)(which % 2), COUNT,
                                         seed, NULL, set));
}

static uint64_t hash_of(uint32_t which, uint64_t seed)
{
    collision_set set;
    make_set(which, seed, &set);
    uint64_t hash = collision_set_hash(&set);
    collision_set_release(&set);
    return hash;
}

static void seed_determines_set(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < set_count(); i++) {
        uint64_t first = hash_of(i, 1);
        assert_true(hash_of(i, 1) == first);
        assert_true(hash_of(i, 2) != first);
    }
}

/* ---- true */

/* The largest speed of a vertex of b relative to one of a. */
static double relative_speed(const collision_query *query)
{
    int first_b = query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 2 : 1;
    double largest = 0.0;
    for (int i = 0; i < first_b; i++) {
        for (int j = first_b; j < 4; j++) {
            vec3 start = vec3_sub(vertex_of(query, false, j), vertex_of(query, false, i));
            vec3 end = vec3_sub(vertex_of(query, true, j), vertex_of(query, true, i));
            largest = vbss_max_or_nan(largest, vec3_distance(start, end));
        }
    }
    return largest;
}

/* The minimum between two times, if there is only one. */
static double refined(const collision_query *query, long double low, long double high)
{
    for (int i = 0; i < 60; i++) {
        long double third = (high - low) / 3.0L;
        if (collision_distance(query, low + third) < collision_distance(query, high - third)) {
            high -= third;
        } else {
            low += third;
        }
    }
    return (double)collision_distance(query, 0.5L * (low + high));
}

static void expect_true_by_samples(const collision_query *query)
{
    enum { SAMPLES = 300 };
    double smallest = (double)INFINITY;
    int where = 0;
    for (int i = 0; i <= SAMPLES; i++) {
        double d = (double)collision_distance(query, (long double)i / SAMPLES);
        where = d < smallest ? i : where;
        smallest = fmin(d, smallest);
    }
    double near_min = relative_speed(query) / (2 * SAMPLES), thickness = query->thickness;
    bool wrong;
    if (query->hit) {
        wrong = !(query->clearance < 0.0) || smallest - near_min > thickness;
    } else {
        wrong = !(query->clearance > 0.0) || smallest <= thickness;
        if (query->clearance < 0.01 * thickness) { /* then the clearance itself is promised */
            long double low = (long double)(where > 0 ? where - 1 : 0) / SAMPLES;
            long double high = (long double)(where < SAMPLES ? where + 1 : SAMPLES) / SAMPLES;
            double clearance = refined(query, low, high) - thickness;
            wrong = wrong || query->clearance > clearance + 1e-9 ||
                    query->clearance < clearance - near_min;
        }
    }
    if (wrong) {
        print_query("not the truth", query);
        fail();
    }
}

static void truth_matches_samples(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < thick_set_count(); i++) {
        collision_set set;
        make_thick_set(i, 150, 3, &set);
        for (uint32_t k = 0; k < set.count && k < 150; k++) {
            expect_true_by_samples(&set.queries[k]);
        }
        collision_set_release(&set);
    }
}

/* A pass at a known smallest distance: over the middle of an edge in its plane's normal, or past the
 * corner of a triangle. */
static collision_query known_pass(vbss_collision_pair_kind kind, double distance)
{
    collision_motion edges = {
        .start = {{-1, 0, 0}, {1, 0, 0}, {-2, 1, distance}, {1, 2, distance}},
        .end = {{-1, 0, 0}, {1, 0, 0}, {-2, -3, distance}, {1, -1, distance}}};
    double s = sqrt(0.5) * distance; /* at 45 degrees past the corner (1, 0, 0) */
    collision_motion point = {.start = {{s + 2, s - 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}},
                              .end = {{s, s + 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}}};
    collision_query query;
    collision_query_fill(&query, kind, 0.25,
                         kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? &edges : &point);
    return query;
}

static void truth_of_known_crossings(void **state)
{
    (void)state;
    for (int i = -4; i < 4; i++) {
        double off = 1e-9 * i + 5e-10;
        for (vbss_collision_pair_kind kind = 0; kind < 2; kind++) {
            collision_query query = known_pass(kind, 0.25 + off);
            assert_true(collision_truth(&query));
            assert_int_equal(query.hit, off < 0.0);
            if (!query.hit) {
                expect_near(off, query.clearance, 1e-9);
            }
            query =
                known_pass(kind, 0.25 + 0.1 * off); /* +-0.5, 1.5, ... times what is uncertain */
            assert_int_equal(collision_truth(&query), i < -1 || i > 0);
        }
    }
}

int test_sets(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(seed_determines_set),
        cmocka_unit_test(truth_matches_samples),
        cmocka_unit_test(truth_of_known_crossings),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
