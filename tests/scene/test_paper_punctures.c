/* Algorithm 3 of the paper: when a needle has gone through a wall. */
#include "scene/paper_prick.h"

static void first_sub_segment_alone_makes_no_hole(void **state)
{
    (void)state;
    prick p;
    begin(&p);
    drive(&p, 0.5e-3);
    assert_int_equal(toggles(&p), 1);
    tremble(&p, 0.5e-3, 0.45e-3, 200);
    assert_int_equal(toggles(&p), 1);
    drive(&p, START);
    assert_int_equal(toggles(&p), 0);
    assert_int_equal(p.in + p.out + p.lost, 0);
    needles_end(&p.r);
}

/* It is one wall in when the second sub-segment is crossed. */
static void hole_is_counted_one_wall_behind_tip(void **state)
{
    (void)state;
    prick p;
    begin(&p);
    while (p.in == 0) {
        go(&p, p.depth + 1e-5);
        assert_true(p.depth < 2e-3);
    }
    expect_near(1e-3, p.depth, 2.1e-5); /* the first segment leans by 6 thousandths */
    assert_int_equal(toggles(&p), 0);
    vbss_scene_hole hole = hole_of(&p, 0);
    assert_int_equal(hole.needle, p.r.body);
    assert_int_equal(hole.drain, p.wall);
    assert_int_equal(hole.triangle, p.triangle);
    assert_int_equal(hole.outward, 0);
    expect_near(1e-3, hole.arc_length, 3e-5);
    for (int k = 0; k < 3; k++) {
        expect_near(1.0 / 3.0, hole.weights[k], 0.02);
    }
    needles_end(&p.r);
}

static void tremor_is_counted_once(void **state)
{
    (void)state;
    prick p;
    begin(&p);
    tremble(&p, 0.0, 0.3e-3, 300);
    assert_int_equal(p.in, 0);
    tremble(&p, 1e-3, 0.3e-3, 300);
    assert_int_equal(p.in, 1);
    tremble(&p, 1e-3, 0.9e-3, 300);
    tremble(&p, 2e-3, 0.3e-3, 300);
    tremble(&p, 0.0, 0.15e-3, 300); /* less than what it takes to leave */
    assert_int_equal(p.in, 1);
    assert_int_equal(p.out, 0);
    needles_end(&p.r);
}

static void withdrawn_needle_leaves_and_reenters(void **state)
{
    (void)state;
    prick p;
    vbss_scene_hole hole;
    begin(&p);
    for (uint32_t round = 1; round <= 3; round++) {
        drive(&p, 5e-3);
        assert_int_equal(p.in, round);
        assert_int_equal(hole_of(&p, 0).id, round);
        drive(&p, -0.1e-3);
        assert_int_equal(p.out, round - 1);
        drive(&p, START);
        assert_int_equal(p.out, round);
        expect_result(VBSS_ERROR_NOT_FOUND,
                      vbss_scene_get_hole(p.r.tools.s.scene, 0, &hole, sizeof hole));
    }
    for (int i = 0; i < 200; i++) {
        go(&p, START);
    }
    assert_true(moved_max(&p) < 1e-6);
    needles_end(&p.r);
}

static void two_walls_are_counted_twice(void **state)
{
    (void)state;
    prick p;
    begin(&p);
    drive(&p, 17e-3);
    assert_int_equal(p.in, 2);
    vbss_scene_hole near = hole_of(&p, 0), far = hole_of(&p, 1);
    assert_int_equal(near.outward, 0);
    assert_int_equal(far.outward, 1);
    assert_true(far.position[2] < -4e-3);
    /* The needle goes on, the holes stay: arc length slides along it. */
    expect_near(17e-3, near.arc_length, 0.2e-3);
    double apart = vec3_distance(vec3_load(near.position), vec3_load(far.position));
    expect_near(apart, near.arc_length - far.arc_length, 0.02e-3);
    drive(&p, START);
    assert_int_equal(p.in, 2);
    assert_int_equal(p.out, 2);
    needles_end(&p.r);
}

/* More than a wall in a step: the tip is never seen between two steps on its way, which is the paper's limit. */
static void tip_crossing_both_walls_in_one_step_is_missed(void **state)
{
    (void)state;
    prick p;
    begin(&p);
    go(&p, -0.1e-3);
    go(&p, 1.5e-3);
    drive(&p, 4e-3);
    assert_int_equal(p.in, 0);
    needles_end(&p.r);
}

static void hole_above_capacity_is_reported(void **state)
{
    (void)state;
    prick p;
    vbss_scene_hole hole;
    begin_with(&p, middle, 1);
    go(&p, START);
    tools_open(&p.r.tools, 0, 0.0);
    go(&p, START);
    drive(&p, 17e-3);
    assert_int_equal(p.in, 1);
    assert_int_equal(p.lost, 1);
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_scene_get_hole(p.r.tools.s.scene, 1, &hole, sizeof hole));
    needles_end(&p.r);
}

int test_paper_punctures(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(first_sub_segment_alone_makes_no_hole),
        harness_test(hole_is_counted_one_wall_behind_tip),
        harness_test(tremor_is_counted_once),
        harness_test(withdrawn_needle_leaves_and_reenters),
        harness_test(two_walls_are_counted_twice),
        harness_test(tip_crossing_both_walls_in_one_step_is_missed),
        harness_test(hole_above_capacity_is_reported),
    };
    return cmocka_run_group_tests_name("scene.paper_punctures", tests, NULL, NULL);
}
