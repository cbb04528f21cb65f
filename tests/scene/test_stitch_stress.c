/* A stitch that is jerked, cut, dropped, knotted, drawn out: it crosses the wall in its holes only, and gives back no
 * more than hands have put in. */
#include "scene/stitch_case.h"

static stitch_case c;

/* More energy than was put in, as a share of that. */
#define SHARE 0.05
/* An end that is so far from its hole has left it, m. */
#define LEFT 0.2e-3

static const vec3 right = {0.0, 0.0, 1.0}, up = {0.0, 1.0, 0.0};

static vec3 outward(int hand)
{
    return vec3_scale(right, hand == 0 ? -1.0 : 1.0);
}

/* Both hands go in their directions at that speed. */
static void pull_both(vec3 left_direction, vec3 right_direction, double distance, double speed)
{
    uint32_t steps = (uint32_t)ceil(distance / (speed * c.h));
    for (uint32_t i = 0; i < steps; i++) {
        stitch_case_shift(&c, 0, vec3_scale(left_direction, distance / steps));
        stitch_case_shift(&c, 1, vec3_scale(right_direction, distance / steps));
        stitch_case_step(&c);
    }
}

static void expect_two_holes(void)
{
    assert_int_equal(c.watch.holes, 2);
    assert_int_equal(c.watch.crossings, 2);
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_UNTHREADED], 0);
}

/* ---- drawn out */

/* In scenes for experiments; in real time: test_stitch_energy.c. */
static void thread_is_drawn_out_slowly_and_fast(void **state)
{
    (void)state;
    static const double speeds[] = {0.05, 0.5};
    for (int i = 0; i < 2; i++) {
        char name[32];
        snprintf(name, sizeof name, "drawn out, %g m/s", speeds[i]);
        stitch_case_begin(&c);
        c.options.scene.mode = VBSS_SCENE_MODE_OFFLINE;
        stitch_case_make(&c);
        stitch_case_wait(&c, 20);
        expect_two_holes();
        stitch_case_drop(&c, 0);
        stitch_case_pull(&c, 1, vec3_scale(right, 80e-3), speeds[i]);
        stitch_case_wait(&c, 50);
        assert_int_equal(c.counts[VBSS_SCENE_EVENT_UNTHREADED], 2);
        assert_int_equal(c.watch.holes + c.watch.crossings, 0);
        stitch_case_finish(&c, name, SHARE);
    }
}

/* ---- cut */

/* What is left in either hole is drawn out on its own side. */
static void draw_both_out(const char *name)
{
    stitch_case_wait(&c, 50);
    pull_both(outward(0), outward(1), 25e-3, 0.1);
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_UNTHREADED], 2);
    assert_int_equal(c.watch.holes + c.watch.crossings, 0);
    stitch_case_finish(&c, name, SHARE);
}

static void thread_cut_between_holes_comes_out_on_both_sides(void **state)
{
    (void)state;
    vbss_scene_hole holes[2];
    stitch_case_begin(&c);
    c.options.scene.mode = VBSS_SCENE_MODE_OFFLINE;
    stitch_case_make(&c);
    assert_true(stitch_case_hole(&c, 0, &holes[0]) && stitch_case_hole(&c, 1, &holes[1]));
    double middle = 0.5 * (holes[0].arc_length + holes[1].arc_length);
    uint32_t piece = stitch_case_cut(&c, c.stitch.thread_body, middle);
    assert_int_not_equal(piece, 0);
    double before = holes[1].arc_length;
    assert_true(stitch_case_hole(&c, 0, &holes[0]) && stitch_case_hole(&c, 1, &holes[1]));
    assert_int_equal(holes[0].thread, c.stitch.thread_body);
    assert_int_equal(holes[1].thread, piece);
    assert_true(fabs(holes[1].arc_length - (before - middle)) < 1e-9);
    draw_both_out("cut between");
}

/* Its wall is no deeper in the end that the hole does not know than where threads leave one. */
static void thread_cut_at_hole_stays_in_one_piece(void **state)
{
    (void)state;
    static const double beside[] = {0.0, 7e-6, -7e-6, 0.1e-3, -0.1e-3};
    for (int i = 0; i < 5; i++) {
        char name[32];
        vbss_scene_hole hole;
        snprintf(name, sizeof name, "cut at a hole, %+.3f mm", 1e3 * beside[i]);
        stitch_case_open(&c, 0);
        stitch_case_wait(&c, 10);
        assert_true(stitch_case_hole(&c, 1, &hole));
        uint32_t piece = stitch_case_cut(&c, c.stitch.thread_body, hole.arc_length + beside[i]);
        assert_int_not_equal(piece, 0);
        assert_true(stitch_case_hole(&c, 1, &hole));
        assert_int_equal(hole.thread, beside[i] < 0.0 ? piece : c.stitch.thread_body);
        double end = beside[i] < 0.0 ? 0.0 : stitch_case_length(&c, c.stitch.thread_body);
        assert_true(fabs(fabs(end - hole.arc_length) - LEFT) < 1e-2 * c.options.segment);
        uint64_t waited = small_statistics(&c.s).paused;
        stitch_case_wait(&c, 50);
        assert_true(small_statistics(&c.s).paused < waited + 5);
        draw_both_out(name);
    }
}

/* ---- let go */

static void dropped_limbs_come_to_rest(void **state)
{
    (void)state;
    stitch_case_begin(&c);
    c.options.thread.drag = 20.0;
    stitch_case_make(&c);
    pull_both(outward(0), outward(1), 3e-3, 0.05);
    stitch_case_drop(&c, 0);
    stitch_case_drop(&c, 1);
    stitch_case_wait(&c, 1500);
    expect_two_holes();
    assert_true(stitch_case_fastest(&c) < 0.02);
    stitch_case_finish(&c, "dropped", SHARE);
}

static void slack_thread_stays_in_holes(void **state)
{
    (void)state;
    stitch_case_open(&c, 0);
    vec3 in[2] = {vec3_add(right, up), vec3_sub(up, right)};
    pull_both(in[0], in[1], 8e-3, 0.1);
    stitch_case_wait(&c, 500);
    expect_two_holes();
    stitch_case_finish(&c, "slack", SHARE);
}

/* ---- a knot */

static void knot_is_pulled_against_hole(void **state)
{
    (void)state;
    stitch_case_open(&c, 5);
    pull_both(outward(0), outward(1), 20e-3, 0.05);
    stitch_case_drop(&c, 0);
    stitch_case_pull(&c, 1, vec3_scale(right, 15e-3), 0.1);
    stitch_case_wait(&c, 100);
    assert_int_equal(c.watch.holes, 2);
    stitch_case_finish(&c, "knot", SHARE);
}

int test_stitch_stress(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thread_is_drawn_out_slowly_and_fast),
        cmocka_unit_test(thread_cut_between_holes_comes_out_on_both_sides),
        cmocka_unit_test(thread_cut_at_hole_stays_in_one_piece),
        cmocka_unit_test(dropped_limbs_come_to_rest),
        cmocka_unit_test(slack_thread_stays_in_holes),
        cmocka_unit_test(knot_is_pulled_against_hole),
    };
    return cmocka_run_group_tests_name("scene.stitch_stress", tests, NULL, NULL);
}
