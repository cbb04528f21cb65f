/* A stitch that is jerked, torn off, cut, dropped, knotted, drawn out: it crosses the wall in its holes only, and gives back no
 * more than hands have put in. */
#include "scene/stitch_case.h"

static stitch_case c;

/* More energy than was put in, as a share of that. */
#define SHARE 0.05

static const vec3 right = {0.0, 0.0, 1.0}, up = {0.0, 1.0, 0.0};

static vec3 outward(int hand)
{
    return vec3_scale(right, hand == 0 ? -1.0 : 1.0);
}

/* Both hands go their ways at that speed. */
static void pull_both(vec3 left_way, vec3 right_way, double way, double speed)
{
    uint32_t steps = (uint32_t)ceil(way / (speed * c.h));
    for (uint32_t i = 0; i < steps; i++) {
        stitch_case_shift(&c, 0, vec3_scale(left_way, way / steps));
        stitch_case_shift(&c, 1, vec3_scale(right_way, way / steps));
        stitch_case_step(&c);
    }
}

static void expect_two_holes(void)
{
    assert_int_equal(c.watch.holes, 2);
    assert_int_equal(c.watch.crossings, 2);
    assert_int_equal(c.counts[VBSS_EVENT_UNTHREADED], 0);
}

/* ---- drawn out */

/* In scenes for experiments; in real time: test_stitch_work.c. */
static void a_thread_is_drawn_out_by_its_end_slowly_and_fast(void **state)
{
    (void)state;
    static const double speeds[] = {0.05, 0.5};
    for (int i = 0; i < 2; i++) {
        char name[32];
        snprintf(name, sizeof name, "drawn out, %g m/s", speeds[i]);
        stitch_case_begin(&c);
        c.options.scene.mode = VBSS_MODE_OFFLINE;
        stitch_case_make(&c);
        stitch_case_wait(&c, 20);
        expect_two_holes();
        stitch_case_drop(&c, 0);
        stitch_case_pull(&c, 1, vec3_scale(right, 80e-3), speeds[i]);
        stitch_case_wait(&c, 50);
        assert_int_equal(c.counts[VBSS_EVENT_UNTHREADED], 2);
        assert_int_equal(c.watch.holes + c.watch.crossings, 0);
        stitch_case_finish(&c, name, SHARE);
    }
}

/* ---- torn off */

static void it_tears_the_drain_off_its_block_and_stays_in_it(void **state)
{
    (void)state;
    stitch_case_begin(&c);
    c.options.rise = 1.5;
    c.options.drain.tear_stress = 5e3;
    stitch_case_make(&c);
    pull_both(up, up, 30e-3, 0.1);
    vbss_drain_statistics d;
    expect_ok(vbss_drain_get_statistics(c.stitch.drain, &d, sizeof d));
    assert_true(d.torn > 0);
    expect_two_holes();
    stitch_case_drop(&c, 0);
    stitch_case_drop(&c, 1);
    stitch_case_wait(&c, 300);
    expect_two_holes();
    stitch_case_finish(&c, "torn off", SHARE);
}

/* ---- cut */

/* What is left in either hole is drawn out on its own side. */
static void draw_both_out(const char *name)
{
    stitch_case_wait(&c, 50);
    pull_both(outward(0), outward(1), 25e-3, 0.1);
    assert_int_equal(c.counts[VBSS_EVENT_UNTHREADED], 2);
    assert_int_equal(c.watch.holes + c.watch.crossings, 0);
    stitch_case_finish(&c, name, SHARE);
}

static void cut_between_its_holes_it_comes_out_on_both_sides(void **state)
{
    (void)state;
    vbss_hole holes[2];
    stitch_case_begin(&c);
    c.options.scene.mode = VBSS_MODE_OFFLINE;
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

static void cut_at_a_hole_it_is_in_one_piece_or_the_other(void **state)
{
    (void)state;
    static const double beside[] = {0.0, 0.1e-3, -0.1e-3};
    for (int i = 0; i < 3; i++) {
        char name[32];
        vbss_hole hole;
        snprintf(name, sizeof name, "cut at a hole, %+.1f mm", 1e3 * beside[i]);
        stitch_case_open(&c, 0);
        stitch_case_wait(&c, 10);
        assert_true(stitch_case_hole(&c, 1, &hole));
        uint32_t piece = stitch_case_cut(&c, c.stitch.thread_body, hole.arc_length + beside[i]);
        assert_int_not_equal(piece, 0);
        assert_true(stitch_case_hole(&c, 1, &hole));
        assert_int_equal(hole.thread, beside[i] < 0.0 ? piece : c.stitch.thread_body);
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

static void a_slack_thread_stays_in_its_holes(void **state)
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

static void a_knot_is_pulled_against_a_hole(void **state)
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

/* ---- a mesh that adapts */

/* What has slid by less in the step before is still, m. */
#define STILL 1e-6

/* A change of the mesh is no slip: friction and arc length stay, but for what the curve is another. */
static void changes_of_the_mesh_leave_holes_where_they_are(void **state)
{
    (void)state;
    double moved = 0.0, jump = 0.0, last[2] = {1.0, 1.0};
    uint32_t changes = 0, still = 0;
    stitch_case_begin(&c);
    c.options.crossings = 1;
    c.options.scene.node_capacity = 2048;
    c.options.thread.mesh = VBSS_MESH_ADAPTIVE;
    c.options.segment = 1.2e-3;
    stitch_case_make(&c);
    for (uint32_t i = 0; i < 400; i++) {
        vbss_hole before[2], after[2];
        uint32_t nodes = stitch_case_nodes(&c, c.stitch.thread_body);
        assert_true(stitch_case_hole(&c, 0, &before[0]) && stitch_case_hole(&c, 1, &before[1]));
        for (int k = 0; k < 2 && i < 200; k++) {
            stitch_case_shift(&c, k, vec3_scale(outward(k), 0.05 * c.h));
        }
        stitch_case_step(&c);
        assert_true(stitch_case_hole(&c, 0, &after[0]) && stitch_case_hole(&c, 1, &after[1]));
        bool changed = nodes != stitch_case_nodes(&c, c.stitch.thread_body);
        changes += changed;
        for (int k = 0; k < 2; k++) {
            double way = fabs(after[k].arc_length - before[k].arc_length);
            if (changed && i >= 200 && last[k] < STILL) { /* hands rest */
                still++;
                moved = fmax(moved, way);
                jump = fmax(jump,
                            vec3_distance(vec3_load(after[k].force), vec3_load(before[k].force)));
            }
            last[k] = way;
        }
    }
    print_message("mesh: %u changes, beside holes at rest %u: arc %.1f um, force %.4f N at most\n",
                  changes, still, 1e6 * moved, jump);
    assert_true(still > 0);
    assert_true(moved < 5e-6 && jump < 0.06);
    expect_two_holes();
    stitch_case_finish(&c, "adaptive", SHARE);
}

int test_stitch_hard(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_thread_is_drawn_out_by_its_end_slowly_and_fast),
        cmocka_unit_test(it_tears_the_drain_off_its_block_and_stays_in_it),
        cmocka_unit_test(cut_between_its_holes_it_comes_out_on_both_sides),
        cmocka_unit_test(cut_at_a_hole_it_is_in_one_piece_or_the_other),
        cmocka_unit_test(dropped_limbs_come_to_rest),
        cmocka_unit_test(a_slack_thread_stays_in_its_holes),
        cmocka_unit_test(a_knot_is_pulled_against_a_hole),
        cmocka_unit_test(changes_of_the_mesh_leave_holes_where_they_are),
    };
    return cmocka_run_group_tests_name("scene.stitch_hard", tests, NULL, NULL);
}
