/* One continuous question: what an answer holds, what it stands on, what is counted. Whether it is true:
 * test_conservative.c, test_degenerate.c. */
#include "base/check.h"
#include "query.h"
#include "shapes_model.h"

/* ---- what an answer holds */

static double size_of(const collision_query *query)
{
    return fmax(vbss_max_abs(query->start, 12), vbss_max_abs(query->end, 12));
}

static void expect_miss(const vbss_collision_impact *impact)
{
    const vbss_collision_impact wanted = {.struct_size = sizeof wanted,
                                          .decision = impact->decision,
                                          .passes = impact->passes,
                                          .time = 1.0};
    assert_memory_equal(impact, &wanted, sizeof wanted);
}

/* The point of the vertices first .. last, which are all of a feature. */
static void expect_point(const collision_query *query, const vbss_collision_impact *impact,
                         int first, int last, const double reported[3])
{
    vec3 point = vec3_zero();
    double all = 0.0;
    for (int k = first; k <= last; k++) {
        double w = impact->weights[k];
        assert_true(w >= -4e-16 && w <= 1.0);
        all += w;
        vec3 from = vertex_of(query, false, k), to = vertex_of(query, true, k);
        vec3 now = vec3_add_scaled(from, impact->time, vec3_sub(to, from));
        point = vec3_add_scaled(point, w, now);
    }
    expect_near(1.0, all, 1e-15);
    expect_near(0.0, vec3_distance(point, vec3_load(reported)), 1e-14 * size_of(query));
}

static void expect_hit(const collision_query *query, const vbss_collision_impact *impact)
{
    double rounding = 1e-14 * size_of(query);
    int last_of_a = query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 1 : 0;
    assert_int_equal(impact->struct_size, sizeof *impact);
    assert_int_equal(impact->hit, 1);
    assert_true(impact->time >= 0.0 && impact->time <= 1.0);
    expect_point(query, impact, 0, last_of_a, impact->point_a);
    expect_point(query, impact, last_of_a + 1, 3, impact->point_b);
    vec3 apart = vec3_sub(vec3_load(impact->point_b), vec3_load(impact->point_a));
    vec3 n = vec3_load(impact->normal);
    bool none = vec3_norm(n) == 0.0;
    expect_near(none ? 0.0 : 1.0, vec3_norm(n), 1e-15);
    if (impact->decision ==
        VBSS_COLLISION_DECISION_CLAIMED) { /* by a formula that parallel edges spoil */
        return;
    }
    expect_near(impact->distance, vec3_norm(apart), rounding);
    double no_direction = 1e-12 * size_of(query);
    assert_true(!none || impact->distance < no_direction);
    if (impact->decision == VBSS_COLLISION_DECISION_PROVED && impact->distance > no_direction) {
        expect_near(impact->distance, vec3_dot(n, apart), rounding);
    } else { /* the last direction that proved something */
        assert_true(vec3_dot(n, apart) >= -no_direction);
    }
}

/* CONSERVATIVE: nothing is within D at some times before that of a hit, or at all after a miss. */
static void expect_nothing_before(const collision_query *query, const vbss_collision_impact *impact)
{
    for (int i = 0; i <= 8 && impact->time > 0.0; i++) {
        long double t = (long double)impact->time * (i / (impact->hit ? 9.0L : 8.0L));
        assert_true((double)collision_distance(query, t) >
                    query->thickness - 1e-14 * size_of(query));
    }
}

/* What an object asked all this must have counted. */
typedef struct tally {
    uint64_t queries, hits, undecided, passes;
    uint64_t too_long; /* for the memory of the pure functions */
} tally;

/* The pure functions and an object with the same configuration. */
static void ask_set(const collision_set *set, const vbss_collision_config *config,
                    vbss_collision *object, tally *sum)
{
    for (uint32_t i = 0; i < set->count; i++) {
        const collision_query *query = &set->queries[i];
        vbss_collision_impact impact = ask(config, query), other;
        if (impact.hit) {
            expect_hit(query, &impact);
        } else {
            expect_miss(&impact);
            assert_true(impact.decision != VBSS_COLLISION_DECISION_UNDECIDED);
        }
        if (config->method == VBSS_COLLISION_METHOD_CONSERVATIVE) {
            expect_nothing_before(query, &impact);
        }
        expect_ok(vbss_collision_test(object, query->kind, query->start, query->end, &other,
                                      sizeof other));
        if (impact.decision == VBSS_COLLISION_DECISION_UNDECIDED) {
            sum->too_long++;
        } else {
            assert_memory_equal(&impact, &other, sizeof impact);
        }
        sum->queries++;
        sum->hits += other.hit != 0;
        sum->undecided += other.decision == VBSS_COLLISION_DECISION_UNDECIDED;
        sum->passes += other.passes;
        bool claimed = other.decision == VBSS_COLLISION_DECISION_CLAIMED;
        assert_true(claimed == (config->method != VBSS_COLLISION_METHOD_CONSERVATIVE));
        assert_true(other.decision != VBSS_COLLISION_DECISION_EXACT || config->thickness == 0.0);
    }
}

static void ask_all(vbss_context *context, vbss_collision_method method, double thickness)
{
    uint32_t thick = thick_set_count(), sets = thick + 2 * collision_degenerate_count;
    vbss_collision_config config;
    vbss_collision *object;
    tally sum = {0};
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    config.method = method;
    config.thickness = thickness;
    expect_ok(vbss_collision_create(context, &config, &object));
    for (uint32_t i = thickness > 0.0 ? 0 : thick; i < (thickness > 0.0 ? thick - 1 : sets); i++) {
        collision_set set;
        if (i < thick) {
            make_thick_set(i, 60, 31, &set);
        } else {
            assert_true(collision_set_degenerate(
                (i - thick) / 2, (vbss_collision_pair_kind)((i - thick) % 2), 100, 32, NULL, &set));
        }
        ask_set(&set, &config, object, &sum);
        collision_set_release(&set);
    }
    vbss_collision_statistics s = shapes_statistics(object);
    print_message("method %d, D = %.2f: %llu queries, %llu hits, %llu undecided, %llu exact\n",
                  method, thickness, (unsigned long long)s.queries, (unsigned long long)s.hits,
                  (unsigned long long)s.undecided, (unsigned long long)s.exact);
    assert_true(sum.hits > sum.queries / 10 && sum.hits < sum.queries);
    assert_true(sum.too_long < sum.queries / 100);
    assert_true(s.queries == sum.queries && s.hits == sum.hits && s.undecided == sum.undecided);
    bool conservative = method == VBSS_COLLISION_METHOD_CONSERVATIVE;
    assert_true(s.passes == (conservative ? sum.passes : 0));
    assert_true((s.exact > 0) == (conservative && thickness == 0.0));
    assert_true((shapes_sign_tests_ended(object) > 0) == (method == VBSS_COLLISION_METHOD_VBLAST));
}

static void answers_are_complete_and_counted(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    for (vbss_collision_method method = 0; method < 3; method++) {
        ask_all(context, method, COLLISION_THICKNESS);
        ask_all(context, method, 0.0);
    }
    harness_context_end(context, &memory);
}

/* ---- what an answer stands on */

/* A point, as an edge or as it is, goes round the end of an edge or a corner of a triangle, 0.14 away. */
static collision_query round_a_corner(vbss_collision_pair_kind kind, double thickness)
{
    collision_query query = {
        .kind = kind,
        .thickness = thickness,
        .start = {-1, 1.2, 0, -1, 1.2, 0, 0, 0, 0, -4, 0, 0},
        .end = {1.2, -1, 0, 1.2, -1, 0, 0, 0, 0, -4, 0, 0},
    };
    if (kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE) {
        const double triangle[9] = {0, 0, 0, -4, 0, 0, 0, -4, 0};
        memcpy(query.start + 3, triangle, sizeof triangle);
        memcpy(query.end + 3, triangle, sizeof triangle);
    }
    return query;
}

static void expect_answer(const collision_query *query, vbss_collision_method method,
                          uint32_t pass_limit, int hit, vbss_collision_decision decision)
{
    vbss_collision_config config = config_of(query);
    config.method = method;
    config.pass_limit = pass_limit;
    vbss_collision_impact impact = ask(&config, query);
    assert_int_equal(impact.hit, hit);
    assert_int_equal(impact.decision, decision);
    assert_true(impact.passes <= pass_limit);
    if (hit) {
        expect_hit(query, &impact);
    } else {
        expect_miss(&impact);
    }
}

static void answer_reports_its_certainty(void **state)
{
    (void)state;
    const vbss_collision_method ours = VBSS_COLLISION_METHOD_CONSERVATIVE;
    for (vbss_collision_pair_kind kind = 0; kind < 2; kind++) {
        collision_query misses = round_a_corner(kind, 0.1), hits = misses, through = misses;
        hits.thickness = 0.15;
        through.end[0] = -1.2;
        if (kind == VBSS_COLLISION_PAIR_EDGE_EDGE) {
            through.end[3] = -1.2;
        }
        expect_answer(&misses, ours, 10000, 0, VBSS_COLLISION_DECISION_PROVED);
        expect_answer(&misses, ours, 1, 1, VBSS_COLLISION_DECISION_UNDECIDED);
        expect_answer(&hits, ours, 10000, 1, VBSS_COLLISION_DECISION_PROVED);
        expect_answer(&hits, ours, 1, 1, VBSS_COLLISION_DECISION_UNDECIDED);
        misses.thickness = through.thickness = 0.0;
        expect_answer(&misses, ours, 10000, 0, VBSS_COLLISION_DECISION_PROVED);
        expect_answer(&through, ours, 10000, 1, VBSS_COLLISION_DECISION_EXACT);
        for (vbss_collision_method method = 1; method < 3; method++) {
            expect_answer(&misses, method, 10000, 0, VBSS_COLLISION_DECISION_CLAIMED);
            hits.end[0] = -0.9; /* ends in contact */
            hits.end[1] = 0.1;
            if (kind == VBSS_COLLISION_PAIR_EDGE_EDGE) {
                memcpy(hits.end + 3, hits.end, 3 * sizeof(double));
            }
            expect_answer(&hits, method, 10000, 1, VBSS_COLLISION_DECISION_CLAIMED);
        }
    }
}

/* ---- zero thickness, with magnitudes that no short integer holds */

static const double tiny = 0x1p-1074;

static void wide_magnitudes_are_decided_with_object(void **state)
{
    (void)state;
    const struct {
        double from, to; /* height of feature b above a */
        int hit;
    } heights[] = {{tiny, tiny, 0}, {tiny, -tiny, 1}, {tiny, 1.0, 0}, {1.0, tiny, 0},
                   {1.0, 0.0, 1},   {1.0, -tiny, 1},  {0.0, 1.0, 1},  {-tiny, -1.0, 0}};
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_collision *object;
    uint64_t undecided = 0, exact = 0;
    expect_ok(vbss_collision_create(context, NULL, &object));
    for (uint32_t i = 0; i < 4 * sizeof heights / sizeof heights[0]; i++) {
        /* The crossing, or the point over the triangle; some move aside with many digits. */
        collision_query query = {.kind = (vbss_collision_pair_kind)(i % 2)};
        const double edges[12] = {-1, 0, 0, 1, 0, 0, 0.1, -1, 0, 0.1, 1, 0};
        const double triangle[12] = {0.1, 0.1, 0, -1, -1, 0, 1, -1, 0, 0, 1, 0};
        memcpy(query.start, i % 2 == 0 ? edges : triangle, sizeof edges);
        memcpy(query.end, query.start, sizeof edges);
        for (size_t k = i % 2 == 0 ? 2 : 1; k < 4; k++) {
            query.start[3 * k + 2] = heights[i / 4].from;
            query.end[3 * k + 2] = heights[i / 4].to;
            query.end[3 * k] += i / 2 % 2 == 0 ? 0.0 : 1.0 / 3.0;
            query.start[3 * k + 1] += i / 2 % 2 == 0 ? 0.0 : 0.1;
        }
        vbss_collision_impact impact, pure = ask(NULL, &query);
        expect_ok(vbss_collision_test(object, query.kind, query.start, query.end, &impact,
                                      sizeof impact));
        assert_int_equal(impact.hit, heights[i / 4].hit);
        assert_true(impact.decision == VBSS_COLLISION_DECISION_EXACT);
        exact++;
        if (pure.decision == VBSS_COLLISION_DECISION_UNDECIDED) { /* its memory is the stack */
            assert_int_equal(pure.hit, 1);
            undecided++;
        } else {
            assert_memory_equal(&pure, &impact, sizeof pure);
        }
    }
    print_message("%llu of %llu were more than the stack holds\n", (unsigned long long)undecided,
                  (unsigned long long)exact);
    assert_true(undecided > 0 && undecided < exact);
    vbss_collision_statistics s = shapes_statistics(object);
    assert_true(s.queries == exact && s.exact > 0 && s.exact <= exact && s.undecided == 0);
    harness_context_end(context, &memory);
}

int test_continuous(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(answers_are_complete_and_counted),
        cmocka_unit_test(answer_reports_its_certainty),
        cmocka_unit_test(wide_magnitudes_are_decided_with_object),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
