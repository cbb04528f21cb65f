/* Counter-examples to the paper's test, each with what the paper and the cubic say and what is true.
 * Lengths in mm: with D = 0.25 two threads of radius 0.125. */
#include "fixtures/baseline_of.h"
#include "collision/paper_ask.h"

enum { MISS = 0, HIT = 1 };
#define D 0.25

/* a at rest unless said. */
#define SHORT -1, 0, 0, 1, 0, 0
#define LONG -2.5, 0, 0, 2.5, 0, 0

static void expect_reported(int wanted, vbss_collision_method method, double thickness,
                            const question *q)
{
    assert_int_equal(wanted, ask(method, thickness, q).impact.hit);
}

static void expect_paper(int wanted, double thickness, const question *q)
{
    expect_reported(wanted, VBSS_COLLISION_METHOD_VBLAST, thickness, q);
}

static void expect_cubic(int wanted, double thickness, const question *q)
{
    expect_reported(wanted, VBSS_COLLISION_METHOD_CUBIC, thickness, q);
}

/* CONSERVATIVE is right; `time` is that of the first touch. */
static void expect_truth_hit(double time, double thickness, const question *q)
{
    vbss_collision_impact i = ask(VBSS_COLLISION_METHOD_CONSERVATIVE, thickness, q).impact;
    assert_int_equal(HIT, i.hit);
    assert_true(i.decision != VBSS_COLLISION_DECISION_UNDECIDED);
    assert_true(i.time <= time + 1e-12);
}

static void expect_truth_miss(double thickness, const question *q)
{
    vbss_collision_impact i = ask(VBSS_COLLISION_METHOD_CONSERVATIVE, thickness, q).impact;
    assert_int_equal(MISS, i.hit);
}

static printed_steps printed(const question *q)
{
    return printed_crossing(q, 1e-6, 1.0);
}

static void linear_time_fails_where_w_turns(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {SHORT, 0, 1, -1, 0, 0, -1}, {SHORT, 0, -2, 2, -1, 0, 1}};
    expect_near(-0.8, printed(&q).product, 1e-15);
    expect_near(0.5279, printed(&q).time, 5e-5);
    expect_paper(MISS, 0.0, &q);
    expect_near(1.0 / 3.0, ask(VBSS_COLLISION_METHOD_CUBIC, 0.0, &q).impact.time,
                1e-15); /* b0; 1/2: inside */
    expect_truth_hit(1.0 / 3.0, 0.0, &q);
}

static void sign_test_misses_flipping_cross_product(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {SHORT, 0, -1, -2, 0, 0, 1}, {SHORT, 3, -1, 0, 0, 0, -1}};
    expect_near(0.1, printed(&q).product, 1e-15);
    expect_paper(MISS, 0.0, &q);
    assert_int_equal(1, ask(VBSS_COLLISION_METHOD_VBLAST, 0.0, &q).counters.sign_tests_ended);
    expect_near(0.5, ask(VBSS_COLLISION_METHOD_CUBIC, 0.0, &q).impact.time, 1e-15);
    expect_truth_hit(0.5, 0.0, &q);
}

static void sign_test_invents_root(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {SHORT, 1, 2, 0, 0, 0, 1}, {SHORT, 0, 0, 3, 0, -1, -1}};
    expect_near(-0.141, printed(&q).product, 5e-4);
    expect_paper(HIT, 0.0, &q);
    expect_near(0.5514, ask(VBSS_COLLISION_METHOD_VBLAST, 0.0, &q).impact.time, 5e-5);
    expect_cubic(MISS, 0.0, &q);
    expect_truth_miss(0.0, &q);
    expect_truth_miss(D, &q); /* they stay 0.35 apart */
}

static void parallel_rule_tests_one_end_only(void **state)
{
    (void)state;
    question missed = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {LONG, 1, 1, 0, 6, 1, 0}, {LONG, 1, -1, 0, 6, -1, 0}};
    question found = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {LONG, -4, 1, 0, 1, 1, 0}, {LONG, -4, -1, 0, 1, -1, 0}};
    const double thicknesses[] = {0.0, D};
    for (int k = 0; k < 2; k++) {
        double thickness = thicknesses[k];
        expect_paper(MISS, thickness, &missed);
        expect_paper(HIT, thickness, &found);
        /* The same with the ends of a exchanged: the other way round. */
        question missed_turned = exchanged(&missed, 0, 1), found_turned = exchanged(&found, 0, 1);
        expect_paper(HIT, thickness, &missed_turned);
        expect_paper(MISS, thickness, &found_turned);
        expect_cubic(MISS, thickness, &missed);
        expect_cubic(MISS, thickness, &found);
        expect_truth_hit(0.5, thickness, &missed);
        expect_truth_hit(0.5, thickness, &found);
        expect_truth_hit(0.5, thickness, &missed_turned);
        expect_truth_hit(0.5, thickness, &found_turned);
    }
}

static void parallel_constant_depends_on_unit(void **state)
{
    (void)state;
    question mm = {VBSS_COLLISION_PAIR_EDGE_EDGE,
                   {LONG, 0, -2.5, 1, .5, 2.5, 1},
                   {LONG, 0, -2.5, -1, .5, 2.5, -1}};
    question m = scaled(&mm, 1e-3);
    for (int k = 0; k < 2; k++) {
        double thickness = k * D;
        vbss_collision_config config = rules_for(VBSS_COLLISION_METHOD_VBLAST, 1e-3 * thickness);
        expect_paper(HIT, thickness, &mm);
        assert_int_equal(MISS, ask_with(&config, &m).impact.hit);
        baseline_of(&config.baseline)->collision_unit =
            1e-3; /* metres are given, and taken to the paper's mm */
        assert_int_equal(HIT, ask_with(&config, &m).impact.hit);
        expect_cubic(HIT, 1e-3 * thickness, &m);
        expect_truth_hit(0.5, thickness, &mm);
        expect_truth_hit(0.5, 1e-3 * thickness, &m);
    }
    expect_near(0.5, printed(&mm).time, 1e-15);
    expect_near(0.00075525, printed(&m).product, 1e-12);        /* both pairs are called parallel */
    printed_steps squares = printed_crossing(&m, 6.2e-10, 1.0); /* |a|^2 |b|^2 = 6.3e-10 m^4 */
    assert_true(squares.hit);
}

static void coplanar_motion_has_no_w(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {LONG, 0, 3, 0, .2, 1, 0}, {LONG, 0, 1, 0, .2, -1, 0}};
    assert_true(printed(&q).product == 0.0);
    expect_paper(MISS, 0.0, &q);
    expect_paper(HIT, D, &q); /* (i): they overlap at the end */
    expect_truth_hit(0.5, 0.0, &q);
    expect_truth_hit(0.5, D, &q);
    /* Out again on the other side: nothing is left for (i). */
    question through = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {LONG, 0, 3, 0, .2, 1, 0}, {LONG, 0, -1, 0, .2, -3, 0}};
    expect_paper(MISS, D, &through);
    expect_cubic(MISS, D, &through);
    expect_truth_hit(0.25, D, &through);
}

static void thick_edges_pass_below_their_thickness(void **state)
{
    (void)state;
    question q = {VBSS_COLLISION_PAIR_EDGE_EDGE,
                  {LONG, -.5, 2, .2, .5, 3, .2},
                  {LONG, -.5, -3, .2, .5, -2, .2}};
    expect_near(0.04, printed(&q).product, 1e-15); /* 0.2 above at both ends */
    expect_paper(MISS, D, &q);
    expect_cubic(MISS, D, &q);
    expect_truth_hit(0.4, D, &q); /* the lower end is above a */
    expect_truth_miss(0.0, &q);
}

static void zero_length_edge_is_ignored(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {LONG, 0, 1, 0, 0, 1, 0}, {LONG, 0, -1, 0, 0, -1, 0}};
    assert_true(isnan(printed(&q).product));
    for (int k = 0; k < 2; k++) {
        double thickness = k * D;
        expect_paper(MISS, thickness, &q);
        expect_cubic(MISS, thickness, &q);
        expect_truth_hit(0.5, thickness, &q);
    }
}

static void point_triangle_test_fails_alike(void **state)
{
    (void)state;
    question missed = {VBSS_COLLISION_PAIR_POINT_TRIANGLE,
                       {0, -3, 1, 0, 0, 0, 2, 0, 0, 0, 2, 0},
                       {0, 0, 0, 0, 0, 2, 0, -1, 0, -1, -1, 0}};
    expect_near(-0.4, printed(&missed).product, 1e-15);
    expect_near(0.5279, printed(&missed).time, 5e-5);
    expect_paper(MISS, 0.0, &missed);
    double touch = ask(VBSS_COLLISION_METHOD_CUBIC, 0.0, &missed).impact.time;
    expect_near(0.80305, touch, 5e-6);
    expect_truth_hit(touch, 0.0, &missed);

    question invented = {VBSS_COLLISION_PAIR_POINT_TRIANGLE,
                         {0, 0, -1, 0, 0, 0, 2, 0, 0, 0, 2, 0},
                         {0, 1, 2, 0, 3, -1, -1, 1, -1, 0, 0, 0}};
    expect_near(-1.5, printed(&invented).product, 1e-14);
    expect_paper(HIT, 0.0, &invented);
    expect_near(0.34833, ask(VBSS_COLLISION_METHOD_VBLAST, 0.0, &invented).impact.time, 5e-6);
    expect_cubic(MISS, 0.0, &invented);
    expect_truth_miss(0.0, &invented);
}

int test_counter_examples(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(linear_time_fails_where_w_turns),
        harness_test(sign_test_misses_flipping_cross_product),
        harness_test(sign_test_invents_root),
        harness_test(parallel_rule_tests_one_end_only),
        harness_test(parallel_constant_depends_on_unit),
        harness_test(coplanar_motion_has_no_w),
        harness_test(thick_edges_pass_below_their_thickness),
        harness_test(zero_length_edge_is_ignored),
        harness_test(point_triangle_test_fails_alike),
    };
    return cmocka_run_group_tests_name("counter_examples", tests, NULL, NULL);
}
