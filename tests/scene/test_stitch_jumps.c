/* What must not jump in a stitch: what a segment feels as it comes out of a hole, and where a hole is when the mesh changes. */
#include "scene/around_holes.h"
#include "scene/stitch_case.h"

static stitch_case c;

/* More energy than was put in, as a share of that. */
#define SHARE 0.05
/* Within which of a hole nothing touches, m. */
#define REACH 1e-3

/* ---- beside a hole */

/* At which share of the distance of touching a place of the thread touches that is so far from the first hole, along it. */
static double share_at(const suture_hole *hole, double away)
{
    const scene_object *s = small_object(&c.s);
    const scene_body *thread = vbss_scene_body(s, hole->thread);
    const scene_body *drain = vbss_scene_body(s, hole->drain);
    const thread_object *t = thread->thread.thread;
    const scene_spot spot = vbss_scene_spot(drain, hole->triangle, hole->weights);
    double arc = hole->arc + away;
    uint32_t segment = 0;
    while (vbss_thread_arc_length(t, segment + 1) < arc) {
        segment++;
    }
    double share = (arc - vbss_thread_arc_length(t, segment)) / t->rest[segment];
    return vbss_scene_share_touching(s, thread, false, segment, share, drain, &spot, REACH);
}

static void what_comes_out_of_a_hole_touches_little_by_little(void **state)
{
    (void)state;
    stitch_case_begin(&c);
    stitch_case_make(&c);
    const suture_hole *hole = &small_object(&c.s)->holes[0];
    assert_true(hole->thread == c.stitch.thread_body);
    double last = 0.0;
    for (uint32_t i = 0; i <= 100; i++) {
        double away = 0.03 * i * REACH, share = share_at(hole, away);
        assert_true(share >= last && share - last < 0.031);
        assert_true(away >= 0.999 * REACH || share == 0.0);
        assert_true(away <= 2.001 * REACH || share == 1.0);
        last = share;
    }
    assert_true(last == 1.0);
    stitch_case_end(&c);
}

/* ---- torn off */

static void it_tears_the_drain_off_its_block_and_stays_in_it(void **state)
{
    (void)state;
    stitch_case_begin(&c);
    c.options.rise = 1.5;
    c.options.drain.tear_stress = 5e3;
    stitch_case_make(&c);
    for (uint32_t i = 0; i < 300; i++) {
        stitch_case_shift(&c, 0, vec3_make(0.0, 0.1e-3, 0.0));
        stitch_case_shift(&c, 1, vec3_make(0.0, 0.1e-3, 0.0));
        stitch_case_step(&c);
    }
    vbss_drain_statistics d;
    expect_ok(vbss_drain_get_statistics(c.stitch.drain, &d, sizeof d));
    assert_true(d.torn > 0);
    assert_int_equal(c.watch.holes, 2);
    stitch_case_drop(&c, 0);
    stitch_case_drop(&c, 1);
    stitch_case_wait(&c, 300);
    assert_int_equal(c.watch.holes, 2);
    assert_int_equal(c.watch.crossings, 2);
    stitch_case_finish(&c, "torn off", SHARE);
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
            stitch_case_shift(&c, k, vec3_make(0.0, 0.0, k == 0 ? -0.05 * c.h : 0.05 * c.h));
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
    assert_int_equal(c.watch.holes, 2);
    assert_int_equal(c.watch.crossings, 2);
    stitch_case_finish(&c, "adaptive", SHARE);
}

int test_stitch_jumps(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_comes_out_of_a_hole_touches_little_by_little),
        cmocka_unit_test(it_tears_the_drain_off_its_block_and_stays_in_it),
        cmocka_unit_test(changes_of_the_mesh_leave_holes_where_they_are),
    };
    return cmocka_run_group_tests_name("scene.stitch_jumps", tests, NULL, NULL);
}
