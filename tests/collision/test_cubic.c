/* Method CUBIC: roots in order, closed inside test, distance at the end. What it misses:
 * test_counter_examples.c. */
#include <stdlib.h>

#include "collision/paper_ask.h"

#define EDGE -1, 0, 0, 1, 0, 0
#define TRIANGLE 0, 0, 0, 2, 0, 0, 0, 2, 0

static vbss_collision_impact cubic(double thickness, const question *q)
{
    return ask(VBSS_COLLISION_METHOD_CUBIC, thickness, q).impact;
}

static void expect_normal(double z, const vbss_collision_impact *i)
{
    assert_true(i->normal[0] == 0.0 && i->normal[1] == 0.0 && i->normal[2] == z);
}

static void crossing_reports_time_and_place(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, .5, -1, 3, .5, 3, 3}, {EDGE, .5, -1, -1, .5, 3, -1}};
    vbss_collision_impact i = cubic(0.0, &q);
    assert_int_equal(1, i.hit);
    assert_int_equal(VBSS_COLLISION_DECISION_CLAIMED, i.decision);
    assert_int_equal(1, i.passes);
    expect_near(0.75, i.time, 1e-15);
    expect_near(0.0, i.distance, 1e-15);
    expect_normal(1.0, &i);
    const double wanted[] = {.25, .75, .75, .25};
    for (int k = 0; k < 4; k++) {
        expect_near(wanted[k], i.weights[k], 1e-15);
    }
    question from_below = exchanged(&q, 2, 3); /* the cross product turns, the side does not */
    i = cubic(0.0, &from_below);
    expect_normal(1.0, &i);

    question point = {
        VBSS_COLLISION_PAIR_POINT_TRIANGLE, {.5, .5, 3, TRIANGLE}, {.5, .5, -1, TRIANGLE}};
    i = cubic(0.0, &point);
    assert_int_equal(1, i.hit);
    expect_near(0.75, i.time, 1e-15);
    expect_normal(-1.0, &i);
    const double corners[] = {1, .5, .25, .25};
    for (int k = 0; k < 4; k++) {
        expect_near(corners[k], i.weights[k], 1e-15);
    }
}

static void roots_are_tried_in_order(void **state)
{
    (void)state;
    /* Beside the triangle at 0.151, inside at 0.803. */
    question q = {VBSS_COLLISION_PAIR_POINT_TRIANGLE,
                  {0, -3, 1, 0, 0, 0, 2, 0, 0, 0, 2, 0},
                  {0, 0, 0, 0, 0, 2, 0, -1, 0, -1, -1, 0}};
    vbss_collision_impact i = cubic(0.0, &q);
    assert_int_equal(1, i.hit);
    assert_int_equal(2, i.passes);
    expect_near(0.8030511823723544, i.time, 1e-14);
    /* Three roots, 2/9, 1/2 and 2/3, all outside. */
    question outside = {VBSS_COLLISION_PAIR_POINT_TRIANGLE,
                        {0, 0, -1, 0, 0, 0, 2, 0, 0, 0, 2, 0},
                        {0, 1, 2, 0, 3, -1, -1, 1, -1, 0, 0, 0}};
    i = cubic(0.0, &outside);
    assert_int_equal(0, i.hit);
    assert_int_equal(3, i.passes);
    /* Inside at 1/3 and at 1/2: the first counts. */
    question twice = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, 1, -1, 0, 0, -1}, {EDGE, 0, -2, 2, -1, 0, 1}};
    i = cubic(0.0, &twice);
    assert_int_equal(1, i.passes);
    expect_near(1.0 / 3.0, i.time, 1e-15);
}

static void closed_intervals_of_time_and_feature(void **state)
{
    (void)state;
    question lands = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, 3, 0, 1, 3}, {EDGE, 0, -1, 0, 0, 1, 0}};
    vbss_collision_impact i = cubic(0.0, &lands);
    assert_true(i.hit == 1 && i.time == 1.0);
    expect_normal(1.0, &i);
    question leaves = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, 0, 0, 1, 0}, {EDGE, 0, -1, 3, 0, 1, 3}};
    i = cubic(0.0, &leaves);
    assert_true(i.hit == 1 && i.time == 0.0);
    expect_normal(1.0, &i);
    question ends_meet = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 1, 0, 1, 1, 2, 1}, {EDGE, 1, 0, -1, 1, 2, -1}};
    i = cubic(0.0, &ends_meet);
    assert_true(i.hit == 1 && i.weights[1] == 1.0 && i.weights[2] == 1.0);
    question corner = {
        VBSS_COLLISION_PAIR_POINT_TRIANGLE, {2, 0, 1, TRIANGLE}, {2, 0, -1, TRIANGLE}};
    i = cubic(0.0, &corner);
    assert_true(i.hit == 1 && i.weights[2] == 1.0);
    question side = {VBSS_COLLISION_PAIR_POINT_TRIANGLE, {1, 1, 1, TRIANGLE}, {1, 1, -1, TRIANGLE}};
    i = cubic(0.0, &side);
    assert_true(i.hit == 1 && i.weights[1] == 0.0);
    question beside = {VBSS_COLLISION_PAIR_POINT_TRIANGLE,
                       {1, 1.0000001, 1, TRIANGLE},
                       {1, 1.0000001, -1, TRIANGLE}};
    assert_int_equal(0, cubic(0.0, &beside).hit);
}

static void thick_features_hit_at_step_end(void **state)
{
    (void)state;
    question near = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, 3, 0, 1, 3}, {EDGE, 0, -1, .25, 0, 1, .25}};
    assert_int_equal(0, cubic(0.2499, &near).hit);
    vbss_collision_impact i = cubic(0.25, &near); /* closed, unlike the paper's */
    assert_true(i.hit == 1 && i.time == 1.0 && i.distance == 0.25);
    expect_normal(1.0, &i);
    expect_near(0.5, i.weights[3], 1e-15);
    question through = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, .5, 0, 1, .5}, {EDGE, 0, -1, -.5, 0, 1, -.5}};
    i = cubic(1.0, &through); /* the root is earlier */
    expect_near(0.5, i.time, 1e-15);
    question point = {
        VBSS_COLLISION_PAIR_POINT_TRIANGLE, {-3, -4, 9, TRIANGLE}, {-3, -4, 0, TRIANGLE}};
    i = cubic(5.0, &point);
    assert_true(i.hit == 1 && i.distance == 5.0 && i.weights[1] == 1.0);
    /* In one plane at all times: told at the end, where they overlap, without a side. */
    question flat = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, 3, 0, 0, 1, 0}, {EDGE, 0, 1, 0, 0, -1, 0}};
    i = cubic(0.25, &flat);
    assert_true(i.hit == 1 && i.time == 1.0);
    expect_normal(0.0, &i);
}

/* ---- properties */

static void agrees_with_exact_arithmetic(harness_source *source, void *user)
{
    uint32_t *hits = user;
    question q = draw_question(source, DRAWN_EVENLY);
    vbss_collision_impact i = cubic(0.0, &q),
                          truth = ask(VBSS_COLLISION_METHOD_CONSERVATIVE, 0.0, &q).impact;
    assert_int_equal(truth.hit, i.hit);
    if (i.hit != 0) {
        ++*hits;
        assert_true(truth.time <= i.time + 1e-9); /* nothing happens before its time */
        expect_near(0.0, i.distance, 1e-12);
        expect_near(0.0, vec3_distance(vec3_load(i.point_a), vec3_load(i.point_b)), 1e-9);
    }
}

static void arbitrary_motion_matches_exact_arithmetic(void **state)
{
    (void)state;
    uint32_t hits = 0;
    harness_property("cubic is right", 10000, agrees_with_exact_arithmetic, &hits);
    assert_true(getenv("VBSS_PROPERTY_CASE") != NULL || hits > 1000);
}

static void answers_are_whole(harness_source *source, void *user)
{
    (void)user;
    question q =
        draw_question(source, harness_draw_below(source, 2) != 0 ? DRAWN_WILD : DRAWN_INTEGERS);
    cubic(harness_draw_below(source, 2), &q);
}

static void degenerate_features_give_no_nan(void **state)
{
    (void)state;
    harness_property("cubic answers are whole", 20000, answers_are_whole, NULL);
}

int test_cubic(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(crossing_reports_time_and_place),
        harness_test(roots_are_tried_in_order),
        harness_test(closed_intervals_of_time_and_feature),
        harness_test(thick_features_hit_at_step_end),
        harness_test(arbitrary_motion_matches_exact_arithmetic),
        harness_test(degenerate_features_give_no_nan),
    };
    return cmocka_run_group_tests_name("cubic", tests, NULL, NULL);
}
