/* Questions in rows have the bits of single ones: every field, in both copies of the lanes. */
#include "fixtures/baseline_of.h"
#include "collision/ccd_batch.h"
#include "query.h"

enum { MAX_COUNT = 400, STRIDE = MAX_COUNT + 5 };

/* Columns of questions; rows are `stride` apart, at most STRIDE. */
typedef struct table {
    uint32_t count;
    vbss_collision_pair_kind kind;
    size_t stride;
    double start[12 * STRIDE], end[12 * STRIDE], thickness[STRIDE];
    collision_ccd_query single[MAX_COUNT]; /* the same */
} table;

typedef struct outputs {
    int32_t hit[STRIDE], decision[STRIDE];
    double time[STRIDE], distance[STRIDE], normal[3 * STRIDE], weights[4 * STRIDE];
} outputs;

static table questions;
static outputs wanted, reported;
static uint32_t limbs[COLLISION_LIMBS];

static collision_ccd_options rules_of(vbss_collision_method method, uint32_t pass_limit)
{
    vbss_collision_config config;
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    (void)baseline_of(&config.baseline);
    config.method = method;
    config.pass_limit = pass_limit;
    collision_ccd_options rules = vbss_collision_ccd_options_of(&config);
    rules.limbs = limbs;
    rules.limb_count = COLLISION_LIMBS;
    return rules;
}

/* ---- the table */

/* Questions from `first` of a set on; in cells that are of none stands what would spoil a sum. */
static void make_table(const collision_set *set, uint32_t first, uint32_t count, size_t stride,
                       bool mixed)
{
    static const double others[4] = {0.0, 1e-30, 0.1, 0.3};
    for (size_t i = 0; i < 12 * (size_t)STRIDE; i++) {
        questions.start[i] = questions.end[i] = (double)NAN;
    }
    questions.count = count;
    questions.stride = stride;
    questions.kind = set->queries[0].kind;
    for (uint32_t i = 0; i < count; i++) {
        const collision_query *query = &set->queries[(first + i) % set->count];
        for (size_t row = 0; row < 12; row++) {
            questions.start[row * stride + i] = query->start[row];
            questions.end[row * stride + i] = query->end[row];
        }
        questions.thickness[i] = mixed && i % 3 != 0 ? others[i / 3 % 4] : query->thickness;
        questions.single[i].kind = query->kind;
        vbss_collision_set_vertices(&questions.single[i], query->start, query->end);
    }
}

/* ---- answers */

static void ask_singly(const collision_ccd_options *rules, const table *t, outputs *o,
                       collision_counters *counters)
{
    memset(o, 0xa5, sizeof *o);
    for (uint32_t i = 0; i < t->count; i++) {
        collision_ccd_query q = t->single[i];
        collision_ccd_result a;
        q.thickness = t->thickness[i];
        vbss_collision_run_ccd(rules, &q, &a, counters);
        o->hit[i] = a.hit;
        o->decision[i] = a.decision;
        o->time[i] = a.time;
        o->distance[i] = a.distance;
        const double normal[3] = {a.normal.x, a.normal.y, a.normal.z};
        for (size_t k = 0; k < 4; k++) {
            o->weights[k * t->stride + i] = a.weights[k];
            if (k < 3) {
                o->normal[k * t->stride + i] = normal[k];
            }
        }
    }
}

/* `which` of the outputs are wanted, a bit each; -1: all. */
static void ask_in_rows(const collision_ccd_options *rules, const table *t, bool wide,
                        unsigned which, bool same_thickness, collision_counters *counters)
{
    memset(&reported, 0xa5, sizeof reported);
    collision_ccd_batch rows = {
        .kind = t->kind,
        .count = t->count,
        .stride = t->stride,
        .start = t->start,
        .end = t->end,
        .thickness = same_thickness ? NULL : t->thickness,
        .same_thickness = same_thickness ? t->thickness[0] : (double)NAN,
        .hit = reported.hit,
        .decision = (which & 1u) != 0 ? reported.decision : NULL,
        .time = (which & 2u) != 0 ? reported.time : NULL,
        .distance = (which & 4u) != 0 ? reported.distance : NULL,
        .normal = (which & 8u) != 0 ? reported.normal : NULL,
        .weights = (which & 16u) != 0 ? reported.weights : NULL,
    };
    vbss_collision_run_ccd_batch(rules, wide && vbss_wide_is_available(), &rows, counters);
}

/* Outputs that were not asked for stay as they were, as all cells beyond the columns do. */
static void expect_reported(unsigned which)
{
    static outputs w;
    memcpy(&w, &wanted, sizeof w);
    memset(w.decision, 0xa5, (which & 1u) != 0 ? 0 : sizeof w.decision);
    memset(w.time, 0xa5, (which & 2u) != 0 ? 0 : sizeof w.time);
    memset(w.distance, 0xa5, (which & 4u) != 0 ? 0 : sizeof w.distance);
    memset(w.normal, 0xa5, (which & 8u) != 0 ? 0 : sizeof w.normal);
    memset(w.weights, 0xa5, (which & 16u) != 0 ? 0 : sizeof w.weights);
    assert_memory_equal(reported.hit, w.hit, sizeof w.hit);
    assert_memory_equal(reported.decision, w.decision, sizeof w.decision);
    assert_memory_equal(reported.time, w.time, sizeof w.time);
    assert_memory_equal(reported.distance, w.distance, sizeof w.distance);
    assert_memory_equal(reported.normal, w.normal, sizeof w.normal);
    assert_memory_equal(reported.weights, w.weights, sizeof w.weights);
}

enum { ALL = 31 };

/* Where there is no wide copy, the plain one goes twice. Returns what was counted. */
static collision_counters expect_same(const collision_ccd_options *rules)
{
    collision_counters singly = {0};
    ask_singly(rules, &questions, &wanted, &singly);
    for (int wide = 0; wide < 2; wide++) {
        collision_counters counters = {0};
        ask_in_rows(rules, &questions, wide != 0, ALL, false, &counters);
        expect_reported(ALL);
        assert_memory_equal(&counters, &singly, sizeof singly);
    }
    return singly;
}

static void add(collision_counters *sum, collision_counters c)
{
    sum->queries += c.queries;
    sum->hits += c.hits;
    sum->undecided += c.undecided;
    sum->exact += c.exact;
    sum->passes += c.passes;
}

/* ---- all sets, those with thickness first */

static uint32_t set_count(void)
{
    return thick_set_count() + 2 * collision_degenerate_count;
}

static void make_set(uint32_t which, uint64_t seed, collision_set *set)
{
    if (which < thick_set_count()) {
        make_thick_set(which, MAX_COUNT, seed, set);
        return;
    }
    which -= thick_set_count();
    assert_true(collision_set_degenerate(which / 2, (vbss_collision_pair_kind)(which % 2),
                                         MAX_COUNT / 2, seed, NULL, set));
}

static void batched_rows_match_in_every_set(void **state)
{
    (void)state;
    collision_counters all = {0};
    print_message("%s\n",
                  vbss_wide_is_available() ? "both copies" : "no wide copy: the plain one twice");
    for (uint32_t i = 0; i < set_count(); i++) {
        collision_set set;
        make_set(i, 41, &set);
        uint32_t count = set.count < MAX_COUNT ? set.count : MAX_COUNT;
        for (vbss_collision_method method = 0; method < 3; method++) {
            collision_ccd_options rules = rules_of(method, 10000);
            make_table(&set, 0, count, STRIDE, false);
            add(&all, expect_same(&rules));
            make_table(&set, set.count / 2, count - i % 4, STRIDE - 1, true);
            add(&all, expect_same(&rules));
        }
        collision_set_release(&set);
    }
    print_message("%llu questions, %llu hits, %llu exact\n", (unsigned long long)all.queries,
                  (unsigned long long)all.hits, (unsigned long long)all.exact);
    assert_true(all.hits > all.queries / 10 && all.exact > 1000);
}

static void batched_rows_match_at_any_pass_limit(void **state)
{
    (void)state;
    const uint32_t limits[] = {1, 2, 3, 5, 9, 31, 32, 33};
    collision_counters all = {0};
    for (uint32_t i = 0; i < set_count(); i++) {
        collision_set set;
        make_set(i, 42, &set);
        for (int k = 0; k < 8; k++) {
            collision_ccd_options rules = rules_of(VBSS_COLLISION_METHOD_CONSERVATIVE, limits[k]);
            make_table(&set, 50 * (uint32_t)k, 97, 97, k % 2 != 0);
            add(&all, expect_same(&rules));
        }
        collision_set_release(&set);
    }
    assert_true(all.undecided > 100);
}

/* Without thickness nothing so small is proved: fourth powers of lengths underflow. */
static void underflowing_products_are_decided(void **state)
{
    (void)state;
    collision_counters all = {0};
    collision_ccd_options rules = rules_of(VBSS_COLLISION_METHOD_CONSERVATIVE, 10000);
    for (uint32_t i = thick_set_count(); i < set_count(); i++) {
        collision_set set;
        make_set(i, 45, &set);
        for (uint32_t k = 0; k < set.count; k++) {
            scale_all(&set.queries[k], k % 2 == 0 ? 0x1p-170 : 0x1p-300);
        }
        make_table(&set, 0, 40, 40, false);
        add(&all, expect_same(&rules));
        collision_set_release(&set);
    }
    assert_true(all.exact > all.queries / 2);
}

/* More than the list of those that wait holds, all of them slow: the rotating and grazing ones. */
static void many_slow_pairs_converge(void **state)
{
    (void)state;
    collision_ccd_options rules = rules_of(VBSS_COLLISION_METHOD_CONSERVATIVE, 10000);
    rules.tolerance = 1e-9;
    collision_set picked;
    assert_true(collision_set_begin(&picked, "slow", MAX_COUNT));
    for (uint32_t i = 0; i < collision_family_count; i++) {
        collision_set set;
        make_set(i, 43, &set);
        for (uint32_t k = 0; k < set.count && picked.count < MAX_COUNT; k++) {
            vbss_collision_config config = config_of(&set.queries[k]);
            config.tolerance = rules.tolerance;
            if (ask(&config, &set.queries[k]).passes > 8) {
                picked.queries[picked.count++] = set.queries[k];
            }
        }
        collision_set_release(&set);
    }
    print_message("%u questions\n", picked.count);
    assert_true(picked.count > 200);
    make_table(&picked, 0, picked.count, STRIDE, false);
    collision_counters c = expect_same(&rules);
    assert_true(c.passes > 10 * (uint64_t)picked.count);
    collision_set_release(&picked);
}

/* ---- sizes and outputs */

static void any_number_of_queries_and_outputs(void **state)
{
    (void)state;
    collision_ccd_options rules = rules_of(VBSS_COLLISION_METHOD_CONSERVATIVE, 10000);
    for (uint32_t i = 0; i < set_count(); i++) {
        collision_set set;
        make_set(i, 44, &set);
        for (uint32_t count = 0; count < 10; count++) {
            bool same = (i + count) % 2 == 0;
            unsigned which = (7 * i + 11 * count) % (ALL + 1u);
            make_table(&set, 10 * count, count, count + i % 3, !same);
            for (uint32_t k = 0; same && k < count; k++) {
                questions.thickness[k] = i % 5 == 0 ? 0.0 : 0.25;
            }
            collision_counters singly = {0}, counters = {0};
            ask_singly(&rules, &questions, &wanted, &singly);
            ask_in_rows(&rules, &questions, i % 2 == 0, which, same, &counters);
            expect_reported(which);
            assert_memory_equal(&counters, &singly, sizeof singly);
        }
        collision_set_release(&set);
    }
}

int test_rows(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(batched_rows_match_in_every_set),
        cmocka_unit_test(batched_rows_match_at_any_pass_limit),
        cmocka_unit_test(underflowing_products_are_decided),
        cmocka_unit_test(many_slow_pairs_converge),
        cmocka_unit_test(any_number_of_queries_and_outputs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
