/* The oracle against cases worked out by hand, against distances in long double, and against itself. */
#include "oracle/oracle.h"
#include "query.h"
#include "fixtures/collision_integers.h"

/* ---- by hand */

typedef struct known_case {
    const char *name;
    bool hit;
    vbss_collision_pair_kind kind;
    double start[12], end[12];
} known_case;

#define EE VBSS_COLLISION_PAIR_EDGE_EDGE
#define VF VBSS_COLLISION_PAIR_POINT_TRIANGLE
#define REST_1 -1, 0, 0, 1, 0, 0
#define REST_5 -2.5, 0, 0, 2.5, 0, 0

static const known_case known_cases[] = {
    /* collision.md, section 2: what linear time, sign tests and parallel rules get wrong */
    {"crossing at 1/3 or 1/2",
     true,
     EE,
     {REST_1, 0, 1, -1, 0, 0, -1},
     {REST_1, 0, -2, 2, -1, 0, 1}},
    {"normal flips", true, EE, {REST_1, 0, -1, -2, 0, 0, 1}, {REST_1, 3, -1, 0, 0, 0, -1}},
    {"no crossing", false, EE, {REST_1, 1, 2, 0, 0, 0, 1}, {REST_1, 0, 0, 3, 0, -1, -1}},
    {"parallel", true, EE, {REST_5, 1, 1, 0, 6, 1, 0}, {REST_5, 1, -1, 0, 6, -1, 0}},
    {"coplanar", true, EE, {REST_5, 0, 3, 0, .2, 1, 0}, {REST_5, 0, 1, 0, .2, -1, 0}},
    {"passes at height .2",
     false,
     EE,
     {REST_5, -.5, 2, .2, .5, 3, .2},
     {REST_5, -.5, -3, .2, .5, -2, .2}},
    {"b is a point", true, EE, {REST_5, 1, 1, 0, 1, 1, 0}, {REST_5, 1, -1, 0, 1, -1, 0}},
    {"point, linear time",
     true,
     VF,
     {0, -3, 1, 0, 0, 0, 2, 0, 0, 0, 2, 0},
     {0, 0, 0, 0, 0, 2, 0, -1, 0, -1, -1, 0}},
    {"point, none",
     false,
     VF,
     {0, 0, -1, 0, 0, 0, 2, 0, 0, 0, 2, 0},
     {0, 1, 2, 0, 3, -1, -1, 1, 0, 0, 0, 0}},
    /* of nothing */
    {"all in one point, always", true, EE, {0}, {0}},
    {"all in one point, always", true, VF, {0}, {0}},
    {"two points that cross",
     true,
     EE,
     {-1, 0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0},
     {1, 0, 0, 1, 0, 0, -1, 0, 0, -1, 0, 0}},
    {"two points that pass",
     false,
     EE,
     {-1, 0, 0, -1, 0, 0, 1, 1e-300, 0, 1, 1e-300, 0},
     {1, 0, 0, 1, 0, 0, -1, 0, 0, -1, 0, 0}},
    {"two points at rest",
     false,
     EE,
     {0, 0, 0, 0, 0, 0, 0, 0, 5e-324, 0, 0, 5e-324},
     {0, 0, 0, 0, 0, 0, 0, 0, 5e-324, 0, 0, 5e-324}},
    /* touching at the very end, at the very start, and just not */
    {"ends at the end", true, EE, {REST_1, 2, 0, 1, 3, 0, 1}, {REST_1, 1, 0, 0, 3, 0, 1}},
    {"ends at the start", true, EE, {REST_1, 1, 0, 0, 3, 0, 1}, {REST_1, 2, 0, 1, 3, 0, 1}},
    {"not quite at the end",
     false,
     EE,
     {REST_1, 2, 0, 1, 3, 0, 1},
     {REST_1, 0x1.0000000000001p0, 0, 0, 3, 0, 1}},
    {"not quite at the end",
     false,
     EE,
     {REST_1, 2, 0, 1, 3, 0, 1},
     {REST_1, 1, 0, 5e-324, 3, 0, 1}},
    /* collinear */
    {"in line, apart", false, EE, {REST_1, 3, 0, 0, 2, 0, 0}, {REST_1, 5, 0, 0, 1.5, 0, 0}},
    {"in line, touching", true, EE, {REST_1, 3, 0, 0, 2, 0, 0}, {REST_1, 5, 0, 0, 1, 0, 0}},
    {"one within the other",
     true,
     EE,
     {-3, 0, 0, 3, 0, 0, 1, 0, 0, 2, 0, 0},
     {-3, 0, 0, 3, 0, 0, 1, 0, 0, 2, 0, 0}},
    {"triangle of length only",
     true,
     VF,
     {0, 0, 1, -1, 0, 0, 1, 0, 0, 2, 0, 0},
     {0, 0, -1, -1, 0, 0, 1, 0, 0, 2, 0, 0}},
    {"beside a triangle of length only",
     false,
     VF,
     {0, 1e-9, 1, -1, 0, 0, 1, 0, 0, 2, 0, 0},
     {0, 1e-9, -1, -1, 0, 0, 1, 0, 0, 2, 0, 0}},
    /* the point in the plane of the triangle */
    {"slides in over an edge",
     true,
     VF,
     {3, 3, 0, 0, 0, 0, 2, 0, 0, 0, 2, 0},
     {1, 1, 0, 0, 0, 0, 2, 0, 0, 0, 2, 0}},
    {"slides past a corner",
     false,
     VF,
     {3, -1, 0, 0, 0, 0, 2, 0, 0, 0, 2, 0},
     {1, -1, 0, 0, 0, 0, 2, 0, 0, 0, 2, 0}},
    /* double root at 1/2, where the turning plane holds the point; then just off it, on either side */
    {"graze",
     true,
     VF,
     {-1, 0, 0, -3, -3, 3, 3, -3, -3, 0, 3, 0},
     {1, 0, 0, -3, -3, -3, 3, -3, 3, 0, 3, 0}},
    {"cuts twice",
     true,
     VF,
     {-1, 0, 1e-30, -3, -3, 3, 3, -3, -3, 0, 3, 0},
     {1, 0, 1e-30, -3, -3, -3, 3, -3, 3, 0, 3, 0}},
    {"not quite",
     false,
     VF,
     {-1, 0, -1e-30, -3, -3, 3, 3, -3, -3, 0, 3, 0},
     {1, 0, -1e-30, -3, -3, -3, 3, -3, 3, 0, 3, 0}},
    {"graze outside",
     false,
     VF,
     {-1, 4, 0, -3, -3, 3, 3, -3, -3, 0, 3, 0},
     {1, 4, 0, -3, -3, -3, 3, -3, 3, 0, 3, 0}},
    /* b0 x b1 = 2 t^2 - 1 about the origin: contact at 1/sqrt(2) alone, with an edge in the plane, with an
     * edge of a triangle whose third corner is above, and just outside and inside that edge */
    {"irrational",
     true,
     EE,
     {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -1, 0},
     {0, 0, 0, 0, 0, 0, 1, 2, 0, -1, -1, 0}},
    {"irrational, off the plane",
     false,
     EE,
     {0, 0, 1e-40, 0, 0, 1e-40, 1, 0, 0, 0, -1, 0},
     {0, 0, 1e-40, 0, 0, 1e-40, 1, 2, 0, -1, -1, 0}},
    {"irrational, on an edge",
     true,
     VF,
     {0, 0, 0, 1, 0, 0, 0, -1, 0, 0, 0, 1},
     {0, 0, 0, 1, 2, 0, -1, -1, 0, 0, 0, 1}},
    {"irrational, outside",
     false,
     VF,
     {0, 0, -1e-40, 1, 0, 0, 0, -1, 0, 0, 0, 1},
     {0, 0, -1e-40, 1, 2, 0, -1, -1, 0, 0, 0, 1}},
    {"irrational, inside",
     true,
     VF,
     {0, 0, 1e-40, 1, 0, 0, 0, -1, 0, 0, 0, 1},
     {0, 0, 1e-40, 1, 2, 0, -1, -1, 0, 0, 0, 1}},
};

static void known_answers(void **state)
{
    (void)state;
    size_t wrong = 0;
    for (size_t i = 0; i < sizeof known_cases / sizeof known_cases[0]; i++) {
        const known_case *c = &known_cases[i];
        collision_query query = {.kind = c->kind, .hit = c->hit};
        memcpy(query.start, c->start, sizeof query.start);
        memcpy(query.end, c->end, sizeof query.end);
        if (oracle_meets(&query) != c->hit) {
            print_query(c->name, &query);
            wrong++;
        }
    }
    assert_int_equal(wrong, 0);
}

/* The contact at 1/sqrt(2), which lies between two doubles. */
static void first_contact_is_exact_to_last_digit(void **state)
{
    (void)state;
    const collision_query query = {.kind = EE,
                                   .start = {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -1, 0},
                                   .end = {0, 0, 0, 0, 0, 0, 1, 2, 0, -1, -1, 0}};
    double above = sqrt(0.5), below = nextafter(above, 0.0);
    assert_true(oracle_meets_before(&query, above));
    assert_false(oracle_meets_before(&query, below));
    assert_false(oracle_meets_at(&query, above));
    assert_false(oracle_meets_at(&query, below));
    const collision_query at_half = {.kind = VF,
                                     .start = {0, 0, 1, -1, -1, 0, 1, -1, 0, 0, 1, 0},
                                     .end = {0, 0, -1, -1, -1, 0, 1, -1, 0, 0, 1, 0}};
    assert_false(oracle_meets_before(&at_half, 0.5));
    assert_true(oracle_meets_before(&at_half, nextafter(0.5, 1.0)));
    assert_true(oracle_meets_at(&at_half, 0.5));
}

/* ---- against distances */

static void draw_query(harness_source *source, collision_query *query)
{
    vbss_random random;
    collision_motion motion;
    vbss_random_seed(&random, harness_draw_u64(source), 1);
    vbss_collision_pair_kind kind = harness_draw_below(source, 2) == 0 ? EE : VF;
    collision_make_any(&random, kind, &motion);
    collision_query_fill(query, kind, 0.0, &motion);
}

static bool is_multiple_of(const collision_query *query, double unit)
{
    for (int i = 0; i < 12; i++) {
        if (query->start[i] != rint(query->start[i] / unit) * unit ||
            query->end[i] != rint(query->end[i] / unit) * unit) {
            return false;
        }
    }
    return true;
}

/* At sixteenths of the time small integers are on a lattice, where features that do not meet are far
 * from doing so; what was nudged may come as near as it likes. */
static void meets_where_the_distance_is_zero(harness_source *source, void *user)
{
    uint32_t *count = user;
    collision_query query;
    draw_query(source, &query);
    bool ever = false, whole = is_multiple_of(&query, 1.0);
    for (int i = 0; i <= 16; i++) {
        bool meets = oracle_meets_at(&query, i / 16.0);
        double distance = (double)collision_distance(&query, i / 16.0L);
        assert_true(!meets || distance < 1e-15);
        *count += meets ? 1 : 0;
        assert_true(meets || !whole || distance > 1e-6);
        ever = ever || meets;
        assert_int_equal(oracle_meets_before(&query, (i + 0.5) / 16.0) ||
                             oracle_meets_at(&query, (i + 0.5) / 16.0),
                         oracle_meets_before(&query, nextafter((i + 0.5) / 16.0, 2.0)));
        assert_true(!ever || oracle_meets_before(&query, (i + 0.5) / 16.0));
    }
    assert_true(!ever || oracle_meets(&query));
}

static void oracle_at_one_time(void **state)
{
    (void)state;
    uint32_t count = 0;
    harness_property("meets_where_the_distance_is_zero", 200, meets_where_the_distance_is_zero,
                     &count);
    assert_true(count > 400);
}

/* By branch and bound on the distance, which cannot tell contact from 1e-6: nor do small integers come
 * as near as that without meeting. */
static void meets_if_the_smallest_distance_is_zero(harness_source *source, void *user)
{
    uint32_t *counts = user;
    collision_query query;
    draw_query(source, &query);
    bool meets = oracle_meets(&query);
    query.thickness = 1e-6;
    if (collision_truth(&query)) {
        assert_true(!meets || query.hit);
        assert_true(meets || !query.hit || !is_multiple_of(&query, 1.0));
        counts[query.hit ? 1 : 0]++;
    }
}

static void oracle_over_time(void **state)
{
    (void)state;
    uint32_t counts[2] = {0, 0};
    harness_property("meets_if_the_smallest_distance_is_zero", 1500,
                     meets_if_the_smallest_distance_is_zero, counts);
    assert_true(counts[0] > 400 && counts[1] > 400);
}

/* ---- against itself */

/* A shear, which keeps integers, and a motion of everything. */
static void map(harness_source *source, collision_query *query)
{
    uint32_t to = harness_draw_below(source, 3);
    uint32_t from = (to + 1 + harness_draw_below(source, 2)) % 3;
    double times = (double)harness_draw_below(source, 7) - 3.0;
    for (int end = 0; end < 2; end++) {
        double *x = end == 0 ? query->start : query->end;
        double away = (double)harness_draw_below(source, 2001) - 1000.0;
        for (uint32_t i = 0; i < 4; i++) {
            x[3 * i + to] += times * x[3 * i + from] + away;
        }
    }
}

static void answers_keep(harness_source *source, void *user)
{
    (void)user;
    collision_query query, other;
    draw_query(source, &query);
    bool meets = oracle_meets(&query);
    other = query;
    exchange_vertices(&other, 2, 3);
    assert_int_equal(oracle_meets(&other), meets);
    exchange_vertices(&other, query.kind == EE ? 0 : 1, query.kind == EE ? 1 : 2);
    assert_int_equal(oracle_meets(&other), meets);
    reverse_time(&other);
    assert_int_equal(oracle_meets(&other), meets);
    if (query.kind == EE) {
        exchange_pair(&other);
        assert_int_equal(oracle_meets(&other), meets);
    }
    scale_all(&other, harness_draw_below(source, 2) == 0 ? 0x1p-40 : -0x1p300);
    assert_int_equal(oracle_meets(&other), meets);
    other = query;
    if (is_multiple_of(&query, 0x1p-30)) { /* what follows is exact */
        scale_all(&other, 1.0 + harness_draw_below(source, 9));
        map(source, &other);
        map(source, &other);
        assert_int_equal(oracle_meets(&other), meets);
    }
}

static void oracle_invariances(void **state)
{
    (void)state;
    harness_property("answers_keep", 800, answers_keep, NULL);
}

int test_oracle(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_answers),  cmocka_unit_test(first_contact_is_exact_to_last_digit),
        harness_test(oracle_at_one_time), harness_test(oracle_over_time),
        harness_test(oracle_invariances),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
