/* Sets are what their names say, and neither all hits nor all misses. */
#include "query.h"

enum { COUNT = 400 };

/* ---- capsules */

static vec3 edge(const collision_query *query, bool end, int which)
{
    return vec3_sub(vertex_of(query, end, 2 * which + 1), vertex_of(query, end, 2 * which));
}

static double sine_between(const collision_query *query, bool end)
{
    vec3 a = edge(query, end, 0), b = edge(query, end, 1);
    return vec3_norm(vec3_cross(a, b)) / (vec3_norm(a) * vec3_norm(b));
}

static double travel(const collision_query *query)
{
    double largest = 0.0;
    for (int i = 0; i < 4; i++) {
        largest = vbss_max_or_nan(
            largest, vec3_distance(vertex_of(query, false, i), vertex_of(query, true, i)));
    }
    return largest;
}

static bool is_slow(const collision_query *q)
{
    return travel(q) <= 0.05 * sqrt(3.0) + 1e-12;
}

/* b turns by 1.6 to 3. */
static bool is_turning(const collision_query *q)
{
    return vec3_dot(edge(q, false, 1), edge(q, true, 1)) < -0.02 * 25.0;
}

static bool is_parallel(const collision_query *q)
{
    return sine_between(q, false) < 1e-14 && sine_between(q, true) < 1e-14;
}

static bool is_near_parallel(const collision_query *q)
{
    double start = sine_between(q, false), end = sine_between(q, true);
    return start > 1e-13 && start < 2e-4 && end > 1e-13 && end < 2e-4;
}

static bool is_collinear(const collision_query *q)
{
    vec3 offset = vec3_sub(vertex_of(q, true, 2), vertex_of(q, false, 2)), a = edge(q, false, 0);
    return is_parallel(q) && vec3_norm(vec3_cross(offset, a)) < 1e-12;
}

static bool is_point(const collision_query *q)
{
    return vec3_norm(edge(q, false, 1)) < 1e-12 && vec3_norm(edge(q, true, 1)) < 1e-12;
}

/* b is normal to a, and as far beyond its end as it grazes. */
static bool is_graze(const collision_query *q)
{
    vec3 a = edge(q, false, 0), beyond = vec3_sub(vertex_of(q, false, 2), vertex_of(q, false, 1));
    double off = vec3_dot(beyond, a) / vec3_norm(a) - 0.25;
    return fabs(off) < 1.1e-3 && fabs(off) > 0.9e-6 && fabs(sine_between(q, false) - 1.0) < 1e-12;
}

static bool is_flat(const collision_query *q)
{
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        sum += fabs(q->start[3 * i + 2]) + fabs(q->end[3 * i + 2]);
    }
    return sum == 0.0;
}

static bool is_tiny(const collision_query *q)
{
    return vec3_norm(edge(q, true, 0)) < 4e-3 && vec3_norm(edge(q, true, 1)) < 4e-3;
}

static bool is_huge(const collision_query *q)
{
    return fabs(vec3_norm(edge(q, false, 0)) - 1000.0) < 1e-9;
}

static bool is_far(const collision_query *q)
{
    return q->start[0] > 9e3 && q->end[1] < -6e3;
}

static bool is_anything(const collision_query *q)
{
    return travel(q) < 30.0;
}

/* One end of b goes down, the other up or stays. */
static bool is_far_vertex(const collision_query *q)
{
    vec3 moved[2];
    for (int i = 0; i < 2; i++) {
        moved[i] = vec3_sub(vertex_of(q, true, 2 + i), vertex_of(q, false, 2 + i));
    }
    return vec3_distance(moved[0], moved[1]) >= 1.0;
}

/* b moves in a plane parallel to a and to itself, at a height of about D. */
static bool is_mid_step_graze(const collision_query *q)
{
    vec3 offset = vec3_sub(vertex_of(q, true, 2), vertex_of(q, false, 2)), a = edge(q, false, 0);
    vec3 up = vec3_cross(offset, a);
    double height = fabs(vec3_dot(up, vertex_of(q, false, 2))) / vec3_norm(up);
    return height > 0.12 && height < 0.38 && sine_between(q, false) < 0.31;
}

typedef struct family_facts {
    bool (*is)(const collision_query *q);
    double low, high; /* of the share of hits */
} family_facts;

static const family_facts facts[] = {
    {is_anything, 0.1, 0.3},   {is_slow, 0.1, 0.35},         {is_turning, 0.9, 1.0},
    {is_parallel, 0.4, 0.8},   {is_near_parallel, 0.4, 0.8}, {is_collinear, 0.5, 0.8},
    {is_point, 0.1, 0.4},      {is_graze, 0.4, 0.6},         {is_flat, 0.4, 0.75},
    {is_tiny, 0.05, 0.2},      {is_huge, 0.03, 0.25},        {is_far, 0.1, 0.3},
    {is_far_vertex, 0.3, 0.7}, {is_mid_step_graze, 0.4, 0.6}};

static void families_match_their_names(void **state)
{
    (void)state;
    assert_int_equal(collision_family_count, sizeof facts / sizeof facts[0]);
    for (uint32_t i = 0; i < collision_family_count; i++) {
        collision_set set;
        assert_true(collision_set_family(i, COUNT, 5, &set));
        uint32_t hits = 0;
        for (uint32_t k = 0; k < set.count; k++) {
            hits += set.queries[k].hit ? 1 : 0;
            if (!facts[i].is(&set.queries[k]) || set.queries[k].thickness != 0.25) {
                print_query(set.name, &set.queries[k]);
                fail();
            }
        }
        if (!(hits >= facts[i].low * COUNT && hits <= facts[i].high * COUNT)) {
            fail_msg("%s: %u hits of %u", set.name, hits, set.count);
        }
        collision_set_release(&set);
    }
    for (uint32_t i = 0; i < collision_sheet_count; i++) {
        collision_set set;
        assert_true(collision_set_sheet(i, COUNT, 5, &set));
        uint32_t hits = 0;
        for (uint32_t k = 0; k < set.count; k++) {
            hits += set.queries[k].hit ? 1 : 0;
            assert_int_equal(set.queries[k].kind, VBSS_COLLISION_PAIR_POINT_TRIANGLE);
        }
        assert_in_range(hits, COUNT / 25, COUNT * 3 / 4);
        collision_set_release(&set);
    }
}

static void thread_set_is_a_thread(void **state)
{
    (void)state;
    collision_set set;
    assert_true(collision_set_thread(1, &set));
    uint32_t hits = 0, close = 0;
    for (uint32_t i = 0; i < set.count; i++) {
        const collision_query *q = &set.queries[i];
        hits += q->hit ? 1 : 0;
        close += !q->hit && q->clearance < 0.01 * q->thickness ? 1 : 0;
        assert_true(travel(q) < 0.05); /* 50 mm/s */
        for (int e = 0; e < 2; e++) {
            double length = vec3_norm(edge(q, false, e));
            assert_true(length > 0.3 && length < 0.4);
        }
    }
    assert_in_range(set.count, 5000, 12000);
    assert_in_range(hits, set.count * 2 / 5, set.count * 3 / 5);
    assert_true(close > 50);
    collision_set_release(&set);
}

/* ---- degenerate sets */

static double volume(const collision_query *query, double t)
{
    vec3 x[4];
    for (int i = 0; i < 4; i++) {
        x[i] = vec3_lerp(vertex_of(query, false, i), vertex_of(query, true, i), t);
    }
    return vec3_dot(vec3_sub(x[1], x[0]), vec3_cross(vec3_sub(x[2], x[0]), vec3_sub(x[3], x[0])));
}

/* Shares of queries without volume at all times, with vertices that are one, and with the volume a
 * square about 1/2. */
typedef struct shares {
    uint32_t flat, shared, square; /* of COUNT */
} shares;

static shares shares_of(uint32_t which, vbss_collision_pair_kind kind)
{
    collision_set set;
    assert_true(collision_set_degenerate(which, kind, COUNT, 7, NULL, &set));
    shares s = {0, 0, 0};
    for (uint32_t i = 0; i < set.count; i++) {
        const collision_query *q = &set.queries[i];
        double at[5];
        for (int k = 0; k < 5; k++) {
            at[k] = volume(q, 0.25 * k);
        }
        s.flat += at[0] == 0.0 && at[1] == 0.0 && at[2] == 0.0 && at[3] == 0.0 ? 1 : 0;
        s.square += at[2] == 0.0 && at[1] * at[3] > 0.0 ? 1 : 0;
        bool shared = false;
        for (int a = 0; a < (kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 2 : 1); a++) {
            for (int b = kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 2 : 1; b < 4; b++) {
                shared = shared ||
                         vec3_distance(vertex_of(q, false, a), vertex_of(q, false, b)) == 0.0 ||
                         vec3_distance(vertex_of(q, true, a), vertex_of(q, true, b)) == 0.0;
            }
        }
        s.shared += shared ? 1 : 0;
    }
    collision_set_release(&set);
    return s;
}

static uint32_t called(const char *name)
{
    uint32_t i = 0;
    while (strcmp(collision_degenerate_names[i], name) != 0) {
        i++;
        assert_true(i < collision_degenerate_count);
    }
    return i;
}

static void degenerate_sets_match_their_names(void **state)
{
    (void)state;
    for (vbss_collision_pair_kind kind = 0; kind < 2; kind++) {
        assert_true(shares_of(called("integers"), kind).flat < COUNT / 5);
        assert_true(shares_of(called("planar"), kind).flat == COUNT);
        assert_true(shares_of(called("collinear"), kind).flat == COUNT);
        assert_true(shares_of(called("zero length"), kind).flat > COUNT * 2 / 5);
        assert_true(shares_of(called("shared vertices"), kind).shared > COUNT * 3 / 5);
        assert_true(shares_of(called("graze"), kind).square > COUNT * 2 / 5);
        assert_true(shares_of(called("last places"), kind).flat < COUNT * 2 / 5);
    }
    assert_true(shares_of(called("parallel"), VBSS_COLLISION_PAIR_EDGE_EDGE).flat > COUNT / 4);
}

int test_set_names(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(families_match_their_names),
        cmocka_unit_test(thread_set_is_a_thread),
        cmocka_unit_test(degenerate_sets_match_their_names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
