/* The exact decision without thickness, and the certain crossings that spare it: against the oracle. */
#include "base/check.h"
#include "collision/conservative_advancement.h"
#include "collision/ccd_crossing.h"
#include "collision/ccd_exact.h"
#include "oracle/oracle.h"
#include "query.h"

enum { GUARDS = 64 };
static uint32_t limbs[COLLISION_LIMBS + GUARDS];

static collision_ccd_query question_of(const collision_query *query)
{
    collision_ccd_query q = {.kind = query->kind};
    vbss_collision_set_vertices(&q, query->start, query->end);
    return q;
}

/* Also sees to it that no memory but its own is written. */
static exact_result decide(const collision_query *query, uint32_t capacity)
{
    collision_ccd_query q = question_of(query);
    memset(limbs + capacity, 0x5a, GUARDS * sizeof limbs[0]);
    workspace w = {.limbs = limbs, .capacity = capacity};
    exact_result truth = vbss_collision_decide_exactly(&q, &w);
    for (uint32_t i = 0; i < GUARDS; i++) {
        assert_int_equal(limbs[capacity + i], 0x5a5a5a5a);
    }
    return truth;
}

static void expect_truth(const collision_query *query, exact_result reported)
{
    if (reported != (query->hit ? COLLISION_EXACT_HIT : COLLISION_EXACT_MISS)) {
        print_query(reported == COLLISION_EXACT_UNKNOWN ? "unknown" : "wrong", query);
        fail();
    }
}

static void make_set(uint32_t which, uint32_t count, uint64_t seed, collision_oracle oracle,
                     collision_set *set)
{
    assert_true(collision_set_degenerate(which / 2, (vbss_collision_pair_kind)(which % 2), count,
                                         seed, oracle, set));
}

static void degenerate_sets_are_decided_correctly(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 2 * collision_degenerate_count; i++) {
        collision_set set;
        make_set(i, 100, 61, oracle_meets, &set);
        for (uint32_t k = 0; k < set.count; k++) {
            expect_truth(&set.queries[k], decide(&set.queries[k], COLLISION_LIMBS));
        }
        collision_set_release(&set);
    }
}

/* ---- memory */

static void low_memory_answer_is_correct_or_unknown(void **state)
{
    (void)state;
    uint64_t unknown = 0, known = 0;
    for (uint32_t i = 0; i < 2 * collision_degenerate_count; i++) {
        collision_set set;
        make_set(i, 12, 62, oracle_meets, &set);
        for (uint32_t k = 0; k < set.count; k++) {
            bool was_known = false;
            for (uint32_t capacity = 0; capacity < 3000; capacity += 1 + capacity / 16) {
                exact_result truth = decide(&set.queries[k], capacity);
                assert_false(was_known && truth == COLLISION_EXACT_UNKNOWN);
                was_known = truth != COLLISION_EXACT_UNKNOWN;
                unknown += !was_known;
                known += was_known;
                if (was_known) {
                    expect_truth(&set.queries[k], truth);
                }
            }
        }
        collision_set_release(&set);
    }
    print_message("%llu known, %llu unknown\n", (unsigned long long)known,
                  (unsigned long long)unknown);
    assert_true(known > 1000 && unknown > 1000);
}

/* Each axis has its own power of two, as far apart as there are: what is true of small integers stays
 * true, and none of their places is lost. At -1023 some are subnormal. */
static void stretch(collision_query *query, uint32_t which)
{
    static const int powers[5][3] = {
        {90, 0, -1060}, {-1023, 90, 3}, {90, -1023, -1060}, {90, 90, -1023}, {-1060, -1023, -500}};
    for (int i = 0; i < 12; i++) {
        query->start[i] = ldexp(query->start[i], powers[which % 5][i % 3]);
        query->end[i] = ldexp(query->end[i], powers[which % 5][i % 3]);
    }
}

static void object_memory_suffices_for_any_numbers(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 2 * collision_degenerate_count; i++) {
        const char *name = collision_degenerate_names[i / 2];
        bool last_places = strcmp(name, "last places") == 0;
        collision_set set;
        make_set(i, last_places ? 1000 : 40, 63, oracle_meets, &set);
        for (uint32_t k = 0; k < set.count; k++) {
            collision_query *query = &set.queries[k];
            bool whole = true; /* multiples of 1/8, which -1060 leaves as they are */
            for (int j = 0; j < 12; j++) {
                whole = whole && fmod(query->start[j], 0.125) == 0.0;
                whole = whole && fmod(query->end[j], 0.125) == 0.0;
            }
            if (whole) {
                stretch(query, k);
            }
            if (whole || last_places) {
                expect_truth(query, decide(query, COLLISION_LIMBS));
            }
        }
        collision_set_release(&set);
    }
}

static double any_coordinate(harness_source *source)
{
    double x;
    do {
        x = harness_draw_any_double(source);
    } while (!(fabs(x) <= COLLISION_MAX_COORDINATE));
    return x;
}

/* All 24 of any magnitude and all digits; on few axes, so that more than nothing may meet. */
static void any_numbers(harness_source *source, void *user)
{
    uint64_t *hits = user;
    collision_query query = {.kind = (vbss_collision_pair_kind)harness_draw_below(source, 2)};
    uint32_t axes = 1 + harness_draw_below(source, 3);
    for (uint32_t i = 0; i < 12; i++) {
        double start = any_coordinate(source), end = any_coordinate(source);
        query.start[i] = i % 3 < axes ? start : 0.0;
        query.end[i] = i % 3 < axes ? end : 0.0;
    }
    query.hit = oracle_meets(&query);
    *hits += query.hit;
    expect_truth(&query, decide(&query, COLLISION_LIMBS));
}

static void any_numbers_are_decided(void **state)
{
    (void)state;
    uint64_t hits = 0;
    harness_property("any numbers", 60, any_numbers, &hits); /* the oracle is slow at it */
    assert_true(hits > 10 && hits < 50);
}

/* ---- certain crossings */

static collision_relative_motion relative_of(const collision_query *query)
{
    collision_relative_motion m = {.size = 0.0};
    for (int k = 0; k < 3; k++) {
        m.start[k] = vec3_sub(vertex_of(query, false, k + 1), vertex_of(query, false, 0));
        m.end[k] = vec3_sub(vertex_of(query, true, k + 1), vertex_of(query, true, 0));
        double x[6];
        vec3_store(x, m.start[k]);
        vec3_store(x + 3, m.end[k]);
        m.size = fmax(m.size, vbss_max_abs(x, 6));
    }
    return m;
}

/* Returns whether a crossing is claimed; then they meet, and not more than 1e-6 later. */
static bool claims_truly(const collision_query *query, double t)
{
    collision_relative_motion m = relative_of(query);
    if (!vbss_collision_certifies_crossing(&m, query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE, t)) {
        return false;
    }
    if (!oracle_meets(query) || (t + 1e-6 < 1.0 && !oracle_meets_before(query, t + 1e-6))) {
        print_query("no crossing", query);
        fail();
    }
    return true;
}

static void degenerate_misses_have_no_crossing(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 2 * collision_degenerate_count; i++) {
        collision_set set;
        make_set(i, 250, 64, NULL, &set);
        for (uint32_t k = 0; k < set.count; k++) {
            vbss_collision_config config = config_of(&set.queries[k]);
            const double times[4] = {ask(&config, &set.queries[k]).time, 0.0, 0.5, 1.0};
            for (int j = 0; j < 4; j++) {
                claims_truly(&set.queries[k], times[j]);
            }
        }
        collision_set_release(&set);
    }
}

/* At x at time t. */
static void place(collision_query *query, size_t k, double t, vec3 x, vec3 displacement)
{
    vec3_store(query->start + 3 * k, vec3_add_scaled(x, -t, displacement));
    vec3_store(query->end + 3 * k, vec3_add_scaled(x, 1.0 - t, displacement));
}

/* Along which the area of what has this normal is seen largest: where the places in features are read. */
static vec3 steepest_axis(vec3 n)
{
    double x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    return x >= y && x >= z ? vec3_make(1.0, 0.0, 0.0)
           : y >= z         ? vec3_make(0.0, 1.0, 0.0)
                            : vec3_make(0.0, 0.0, 1.0);
}

/* Lines, or a line and a plane, that cross at about time 0.5, a hair inside or outside of the border of
 * a feature; or well inside, at a hair before or after the beginning or the end. Vertices have their own
 * ways; or features do not turn and move along that axis, so that the place in them stays. */
static void draw_near(harness_source *source, collision_query *query, double *when)
{
    bool in_time = harness_draw_below(source, 2) != 0, rigid = harness_draw_below(source, 2) != 0;
    double hair = harness_draw_real(source, -1.0, 1.0);
    hair = ldexp(hair, -(int)harness_draw_below(source, 35) - 20);
    double border = (double)harness_draw_below(source, 2);
    double first = in_time ? harness_draw_real(source, 0.1, 0.4) : border + hair;
    double second = harness_draw_real(source, 0.1, 0.4), t = in_time ? border + hair : 0.5;
    bool edges = query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
    if (!edges && !in_time && border == 1.0) { /* of the three, the border where they sum to 1 */
        first = 1.0 - second + hair;
    }
    vec3 x[4], where = harness_draw_vec3(source, -1.0, 1.0);
    vec3 e = harness_draw_vec3(source, -1.0, 1.0), f = harness_draw_vec3(source, -1.0, 1.0);
    vec3 from_e = vec3_add_scaled(where, -first, e);
    x[0] = edges ? from_e : where;
    x[1] = edges ? vec3_add(from_e, e) : vec3_add_scaled(from_e, -second, f);
    x[2] = edges ? vec3_add_scaled(where, -second, f) : vec3_add(x[1], e);
    x[3] = vec3_add(edges ? x[2] : x[1], f);
    vec3 n = steepest_axis(vec3_cross(e, f)), all = harness_draw_vec3(source, -1.0, 1.0);
    for (size_t k = 0; k < 4; k++) {
        vec3 own = harness_draw_vec3(source, -1.0, 1.0);
        bool of_a = k < (edges ? 2u : 1u);
        place(query, k, t, x[k], rigid ? vec3_add_scaled(all, of_a ? 1.0 : -1.0, n) : own);
    }
    if (harness_draw_below(source, 4) == 0) { /* where volumes are subnormal */
        scale_all(query, ldexp(1.0, -325 - (int)harness_draw_below(source, 30)));
    }
    *when = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
}

static void near_crossings(harness_source *source, void *user)
{
    uint64_t *claimed = user;
    collision_query query = {.kind = (vbss_collision_pair_kind)harness_draw_below(source, 2)};
    double t;
    draw_near(source, &query, &t);
    claimed[0] += claims_truly(&query, t);
    claimed[1]++;
}

static void near_misses_have_no_crossing(void **state)
{
    (void)state;
    uint64_t claimed[2] = {0};
    harness_property("near crossings", 20000, near_crossings, claimed);
    print_message("%llu of %llu are certain\n", (unsigned long long)claimed[0],
                  (unsigned long long)claimed[1]);
    assert_true(claimed[0] > claimed[1] / 8);
}

int test_exact(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(degenerate_sets_are_decided_correctly),
        cmocka_unit_test(low_memory_answer_is_correct_or_unknown),
        cmocka_unit_test(object_memory_suffices_for_any_numbers),
        harness_test(any_numbers_are_decided),
        cmocka_unit_test(degenerate_misses_have_no_crossing),
        harness_test(near_misses_have_no_crossing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
