/* Method VBLAST against hand-computed cases and against the algorithm as printed. What it misses and
 * invents: test_counter_examples.c. */
#include <stdlib.h>

#include "fixtures/baseline_of.h"
#include "collision/closest.h"
#include "collision/paper_ask.h"

/* a along x at rest. */
#define EDGE -1, 0, 0, 1, 0, 0
/* In the plane z = 0, at rest. */
#define TRIANGLE 0, 0, 0, 2, 0, 0, 0, 2, 0

static void expect_vector(double x, double y, double z, const double got[3])
{
    expect_near(x, got[0], 1e-14);
    expect_near(y, got[1], 1e-14);
    expect_near(z, got[2], 1e-14);
}

static void expect_weights(double first, double second, double third, double fourth,
                           const vbss_collision_impact *i)
{
    const double wanted[4] = {first, second, third, fourth};
    for (int k = 0; k < 4; k++) {
        expect_near(wanted[k], i->weights[k], 1e-14);
    }
}

static void crossing_edges_hit_at_linear_time(void **state)
{
    (void)state;
    /* b, along y above x = 0.5, sinks from 3 to -1. */
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, .5, -1, 3, .5, 3, 3}, {EDGE, .5, -1, -1, .5, 3, -1}};
    reported t = ask(VBSS_COLLISION_METHOD_VBLAST, 0.0, &q);
    assert_int_equal(1, t.impact.hit);
    assert_int_equal(VBSS_COLLISION_DECISION_CLAIMED, t.impact.decision);
    assert_int_equal(1, t.impact.passes);
    assert_int_equal(0, t.counters.sign_tests_ended);
    expect_near(0.75, t.impact.time, 1e-15);
    expect_near(0.0, t.impact.distance, 1e-15);
    expect_vector(0, 0, 1, t.impact.normal); /* from a to where b came from */
    expect_weights(.25, .75, .75, .25, &t.impact);
    expect_vector(.5, 0, 0, t.impact.point_a);
    expect_vector(.5, 0, 0, t.impact.point_b);

    question below = exchanged(&q, 0, 2);
    below = exchanged(&below, 1, 3); /* a is b */
    t = ask(VBSS_COLLISION_METHOD_VBLAST, 0.0, &below);
    expect_near(0.75, t.impact.time, 1e-15);
    expect_vector(0, 0, -1, t.impact.normal);
}

static void parallel_edges_use_start_point_of_a(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, -3, 2, 0, 0, 2, 0}, {EDGE, -3, -2, 0, 0, -2, 0}};
    reported t = ask(VBSS_COLLISION_METHOD_VBLAST, 0.0, &q);
    assert_int_equal(1, t.impact.hit);
    expect_near(0.5, t.impact.time, 1e-15);
    expect_vector(0, 1, 0, t.impact.normal);
    expect_weights(1, 0, 1.0 / 3.0, 2.0 / 3.0, &t.impact);
    /* Called parallel, so the cross product, here along z, is not asked for the normal. */
    q.start[10] += 1e-4;
    q.end[10] += 1e-4;
    t = ask(VBSS_COLLISION_METHOD_VBLAST, 0.0, &q);
    assert_int_equal(1, t.impact.hit);
    expect_near(1.0, t.impact.normal[1], 1e-7);
}

static void end_distance_test_comes_first_and_is_strict(void **state)
{
    (void)state;
    /* Through a, and stopped 0.25 beyond it: step (ii) would say 0.8. */
    question q = {VBSS_COLLISION_PAIR_EDGE_EDGE,
                  {EDGE, .5, -1, 1, .5, 3, 1},
                  {EDGE, .5, -1, -.25, .5, 3, -.25}};
    expect_near(0.8, ask(VBSS_COLLISION_METHOD_VBLAST, 0.25, &q).impact.time,
                1e-15); /* not below D */
    reported t = ask(VBSS_COLLISION_METHOD_VBLAST, 0.5, &q);
    assert_int_equal(1, t.impact.hit);
    assert_true(t.impact.time == 1.0);
    assert_int_equal(0, t.impact.passes);
    expect_near(0.25, t.impact.distance, 1e-15);
    expect_vector(0, 0, -1, t.impact.normal);
    expect_weights(.25, .75, .75, .25, &t.impact);
}

static void end_distance_uses_edges_when_foot_is_outside(void **state)
{
    (void)state;
    /* Lines cross at x = 1.5, 0.5 beyond a's end. */
    question q = {VBSS_COLLISION_PAIR_EDGE_EDGE,
                  {EDGE, 1.5, -1, 2, 1.5, 3, 2},
                  {EDGE, 1.5, -1, 0, 1.5, 3, 0}};
    assert_int_equal(0, ask(VBSS_COLLISION_METHOD_VBLAST, 0.5, &q).impact.hit);
    reported t = ask(VBSS_COLLISION_METHOD_VBLAST, 0.625, &q);
    assert_int_equal(1, t.impact.hit);
    expect_near(0.5, t.impact.distance, 1e-15);
    expect_vector(1, 0, 0, t.impact.normal);
    expect_weights(0, 1, .75, .25, &t.impact);
}

static void early_sign_rejections_are_counted(void **state)
{
    (void)state;
    question approach = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, 3, 0, 1, 3}, {EDGE, 0, -1, 1, 0, 1, 1}};
    question point = {
        VBSS_COLLISION_PAIR_POINT_TRIANGLE, {.5, .5, 3, TRIANGLE}, {.5, .5, 1, TRIANGLE}};
    /* Crosses the plane beside the triangle, so it is the inside test that ends this one. */
    question beside = {
        VBSS_COLLISION_PAIR_POINT_TRIANGLE, {2, 2, 3, TRIANGLE}, {2, 2, -1, TRIANGLE}};
    question onto = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, 3, 0, 1, 3}, {EDGE, 0, -1, 0, 0, 1, 0}};
    const question *asked[] = {&approach, &point, &beside, &onto};
    const uint64_t ended[] = {1, 1, 0, 1}, ended_thick[] = {1, 1, 0, 0};
    for (int k = 0; k < 4; k++) {
        reported thin = ask(VBSS_COLLISION_METHOD_VBLAST, 0.0, asked[k]);
        assert_int_equal(0, thin.impact.hit);
        assert_int_equal(ended[k], thin.counters.sign_tests_ended);
        reported thick = ask(VBSS_COLLISION_METHOD_VBLAST, 0.25, asked[k]);
        assert_int_equal(k == 3, thick.impact.hit);
        assert_int_equal(ended_thick[k], thick.counters.sign_tests_ended);
    }
}

static void point_triangle_test_is_analogous(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_POINT_TRIANGLE, {.5, .5, 3, TRIANGLE}, {.5, .5, -1, TRIANGLE}};
    reported t = ask(VBSS_COLLISION_METHOD_VBLAST, 0.5, &q);
    assert_int_equal(1, t.impact.hit);
    expect_near(0.75, t.impact.time, 1e-15);
    expect_near(0.0, t.impact.distance, 1e-15);
    expect_vector(0, 0, -1, t.impact.normal); /* from the point to the triangle */
    expect_weights(1, .5, .25, .25, &t.impact);
    expect_vector(.5, .5, 0, t.impact.point_b);
    t = ask(VBSS_COLLISION_METHOD_VBLAST, 1.5, &q);
    assert_true(t.impact.time == 1.0);
    expect_near(1.0, t.impact.distance, 1e-15);
    expect_vector(0, 0, 1, t.impact.normal);
    /* Beside it at the end: the closest corner counts. */
    question out = {
        VBSS_COLLISION_PAIR_POINT_TRIANGLE, {-3, -4, 9, TRIANGLE}, {-3, -4, 0, TRIANGLE}};
    assert_int_equal(0, ask(VBSS_COLLISION_METHOD_VBLAST, 5.0, &out).impact.hit);
    t = ask(VBSS_COLLISION_METHOD_VBLAST, 5.5, &out);
    assert_int_equal(1, t.impact.hit);
    expect_near(5.0, t.impact.distance, 1e-15);
    expect_weights(1, 1, 0, 0, &t.impact);
}

/* ---- properties */

static double printed_distance_at_end(const question *q, double eps)
{
    vec3 x[4];
    load_at(q, 1.0, 1.0, x);
    printed_lines last = printed_w(q->kind, x, eps);
    bool edges = q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
    bool inside = true;
    for (int k = 0; k < (edges ? 2 : 3); k++) {
        inside = inside && last.feet[k] >= 0.0 && last.feet[k] <= 1.0;
    }
    if (inside) {
        return vec3_norm(last.w);
    }
    vec3 to[3] = {vec3_sub(x[1], x[0]), vec3_sub(x[2], x[0]), vec3_sub(x[3], x[0])};
    double s, u, weights[3];
    return vec3_norm(edges ? closest_between_edges(to[0], vec3_sub(to[2], to[1]), to[1], &s, &u)
                           : closest_on_triangle(to, weights));
}

/* In any unit; eps_E up to where every second pair is called parallel. */
static void does_what_is_printed(harness_source *source, void *user)
{
    uint32_t *compared = user;
    question q = draw_question(source, DRAWN_EVENLY);
    vbss_collision_config config = rules_for(VBSS_COLLISION_METHOD_VBLAST, 0.0);
    double thickness = harness_draw_below(source, 2) != 0 ? harness_draw_real(source, 0, .5) : 0.0;
    const double units[] = {1.0, 1e-3, 25.4e-3, 1e3};
    baseline_of(&config.baseline)->collision_unit = units[harness_draw_below(source, 4)];
    config.thickness = thickness * baseline_of(&config.baseline)->collision_unit;
    baseline_of(&config.baseline)->collision_parallel =
        harness_draw_below(source, 2) != 0 ? 1e-6 : 1.0;
    question in_metres = scaled(&q, baseline_of(&config.baseline)->collision_unit);
    reported t = ask_with(&config, &in_metres);
    double distance =
        printed_distance_at_end(&q, baseline_of(&config.baseline)->collision_parallel);
    printed_steps steps =
        printed_crossing(&q, baseline_of(&config.baseline)->collision_parallel, 1.0);
    if (fabs(distance - thickness) < 1e-9 || !(steps.margin > 1e-9)) {
        return; /* rounding decides */
    }
    if (distance < thickness) {
        assert_int_equal(1, t.impact.hit);
        assert_true(t.impact.time == 1.0);
        expect_near(distance, t.impact.distance / baseline_of(&config.baseline)->collision_unit,
                    1e-9);
        assert_int_equal(0, t.counters.sign_tests_ended);
    } else {
        assert_int_equal(steps.hit, t.impact.hit);
        expect_near(steps.hit ? steps.time : 1.0, t.impact.time, 1e-9);
        assert_int_equal(steps.ended, t.counters.sign_tests_ended);
    }
    compared[steps.ended ? 0 : t.impact.hit ? 1 : 2]++;
}

static void test_matches_printed_algorithm(void **state)
{
    (void)state;
    uint32_t compared[3] = {0}; /* ended by the sign, hits, outside */
    harness_property("paper as printed", 4000, does_what_is_printed, compared);
    assert_true(getenv("VBSS_PROPERTY_CASE") != NULL ||
                (compared[0] > 1000 && compared[1] > 300 && compared[2] > 300));
}

/* `ask` looks at every number. */
static void answers_are_whole(harness_source *source, void *user)
{
    (void)user;
    question q =
        draw_question(source, harness_draw_below(source, 2) != 0 ? DRAWN_WILD : DRAWN_INTEGERS);
    vbss_collision_config config =
        rules_for(VBSS_COLLISION_METHOD_VBLAST, harness_draw_below(source, 3));
    const double constants[] = {0.0, 1e-6, 1.0};
    baseline_of(&config.baseline)->collision_parallel = constants[harness_draw_below(source, 3)];
    ask_with(&config, &q);
}

static void degenerate_features_give_no_nan(void **state)
{
    (void)state;
    harness_property("paper answers are whole", 20000, answers_are_whole, NULL);
    /* At right angles, called parallel: w has no length that could be told. */
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, 3, 0, 1, 3}, {EDGE, 0, -1, -3, 0, 1, -3}};
    vbss_collision_config config = rules_for(VBSS_COLLISION_METHOD_VBLAST, 0.25);
    baseline_of(&config.baseline)->collision_unit = 1e3;
    assert_int_equal(0, ask_with(&config, &q).impact.hit);
}

int test_paper(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(crossing_edges_hit_at_linear_time),
        harness_test(parallel_edges_use_start_point_of_a),
        harness_test(end_distance_test_comes_first_and_is_strict),
        harness_test(end_distance_uses_edges_when_foot_is_outside),
        harness_test(early_sign_rejections_are_counted),
        harness_test(point_triangle_test_is_analogous),
        harness_test(test_matches_printed_algorithm),
        harness_test(degenerate_features_give_no_nan),
    };
    return cmocka_run_group_tests_name("paper", tests, NULL, NULL);
}
