/* Method VBLAST of scenes: rules where the paper is silent, and what is told of contacts. */
#include "fixtures/baseline_of.h"
#include "scene/paper_fixture.h"

/* ---- rules where the paper is silent */

/* Two segments of 5 mm that cross, at heights y and with velocities v up; the second is along z. */
static void cross(stage *s, const double y[2], const double v[2])
{
    for (int k = 0; k < 2; k++) {
        vbss_thread_config c = paper_thread(1);
        const double start[3] = {k == 0 ? -0.0025 : 0.0, y[k], k == 0 ? 0.0 : -0.0025};
        const double direction[3] = {k == 0, 0.0, k != 0},
                     speeds[6] = {0.0, v[k], 0.0, 0.0, v[k], 0.0};
        memcpy(c.start, start, sizeof start);
        memcpy(c.direction, direction, sizeof direction);
        c.length = 0.005;
        c.gravity[1] = c.drag = 0.0;
        add(s, k, &c);
        expect_ok(vbss_thread_set_state(s->threads[k], NULL, speeds, 2));
    }
}

static double height(stage *s, int which)
{
    uint32_t n;
    return places(s->threads[which], &n)[0].y;
}

/* Printed, shares of 1e4 would throw both away. */
static void comoving_threads_are_not_pushed(void **state)
{
    (void)state;
    stage s;
    const double y[2] = {0.0, 1.8 * RADIUS}, v[2] = {1.0001, 1.0};
    begin(&s);
    make(&s);
    cross(&s, y, v);
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    for (int k = 0; k < 2; k++) {
        expect_near(y[k] + 1e-3, height(&s, k), 0.3 * RADIUS);
    }
    expect_near(2.0 * RADIUS, height(&s, 1) - height(&s, 0), 1e-9);
    end(&s);
}

/* Found between begin and end, not at the end: whoever moved is put back to its side. */
static void thread_passing_within_step_is_moved_back(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        stage s;
        const double y[2] = {k == 0 ? 1e-3 : 0.0, k == 0 ? 0.0 : 1e-3};
        const double v[2] = {k == 0 ? -2.0 : 0.0, k == 0 ? 0.0 : -2.0};
        begin(&s);
        make(&s);
        cross(&s, y, v);
        expect_ok(vbss_scene_step(s.scene, 1e-3));
        expect_near(2.0 * RADIUS, height(&s, k), 1e-9);
        expect_near(0.0, height(&s, 1 - k), 1e-9);
        end(&s);
    }
}

/* A tool beside a held node: the other end of its segment is a lever of 50 to 1. */
static void neighbour_of_held_node_is_not_thrown(void **state)
{
    (void)state;
    stage s;
    uint32_t n;
    begin(&s);
    make(&s);
    vbss_thread_config c = paper_thread(1);
    c.length = 0.005;
    c.gravity[1] = 0.0;
    add(&s, 0, &c);
    hold_ends(&s, 0);
    expect_ok(vbss_thread_detach(s.threads[0], 2));
    uint32_t tool = add_capsule(s.scene, VBSS_SCENE_RIGID_DRIVEN, vec3_make(1e-4, -1e-3, -1e-3),
                                vec3_make(1e-4, -1e-3, 1e-3), 2e-4);
    expect_ok(
        vbss_scene_set_rigid_target(s.scene, tool, (const double[3]){0.0, 7.5e-4, 0.0}, NULL));
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    expect_near(0.0, vec3_norm(places(s.threads[0], &n)[0]), 0.0);
    double up = places(s.threads[0], &n)[1].y;
    assert_true(up > 0.0 && up < 4.0 * 1.25 * 1e-4);
    end(&s);
}

static void thickness_keeps_features_beyond_radii(void **state)
{
    (void)state;
    stage s;
    begin(&s);
    baseline_of(&s.config.baseline)->scene_thickness = 2e-4;
    make(&s);
    vec3 axis[2] = {vec3_make(0, 0, -0.02), vec3_make(0, 0, 0.02)};
    add_capsule(s.scene, VBSS_SCENE_RIGID_DRIVEN, axis[0], axis[1], 2.5e-3);
    place_over(&s, 0.003);
    for (int i = 0; i < 300; i++) {
        expect_ok(vbss_scene_step(s.scene, 1e-3));
    }
    expect_near(2.5e-3 + RADIUS + 2e-4, distance_to_axis(&s, axis[0], axis[1]), 2e-5);
    expect_near(0.0, statistics_of(&s).penetration, 0.0);
    end(&s);
}

/* ---- what is told */

static void place_segment(stage *s)
{
    vbss_thread_config c = paper_thread(1);
    c.length = 0.005;
    c.start[0] = -0.0025;
    c.gravity[1] = 0.0;
    add(s, 0, &c);
}

static void add_jaw(stage *s, double radius, double from, double to)
{
    const double displacement[3] = {0.0, to - from, 0.0};
    uint32_t jaw = add_capsule(s->scene, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0, from, -0.01),
                               vec3_make(0, from, 0.01), radius);
    expect_ok(vbss_scene_set_rigid_target(s->scene, jaw, displacement, NULL));
}

/* A segment between two jaws that close on it: the second drives it through the first, and one pass sees no
 * more of it. */
static void segment_driven_through_tool_reports_depth(void **state)
{
    (void)state;
    stage s;
    begin(&s);
    baseline_of(&s.config.baseline)->scene_pass_limit = 1;
    make(&s);
    const double radius[2] = {1e-3, 3e-3}, to[2] = {-0.2e-3, 1.5e-3};
    place_segment(&s);
    add_jaw(&s, radius[0], -2e-3, to[0]);
    add_jaw(&s, radius[1], 4e-3, to[1]);
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    double y = to[1] - radius[1] - RADIUS, gap = y - to[0] - radius[0] - RADIUS;
    const uint32_t *features = view_of(&s, VBSS_SCENE_VIEW_CONTACTS).data;
    const double *gaps = view_of(&s, VBSS_SCENE_VIEW_CONTACT_GAPS).data;
    const vec3 *normals = view_of(&s, VBSS_SCENE_VIEW_CONTACT_NORMALS).data;
    const vec3 *points = view_of(&s, VBSS_SCENE_VIEW_CONTACT_POINTS).data;
    const uint32_t wanted[10] = {VBSS_SCENE_CONTACT_SEGMENT_CAPSULE, 1, 0, 2, 0,
                                 VBSS_SCENE_CONTACT_SEGMENT_CAPSULE, 1, 0, 3, 0};
    assert_memory_equal(wanted, features, sizeof wanted);
    expect_near(gap, gaps[0], 1e-12);
    expect_near(0.0, gaps[1], 1e-12);
    expect_near(1.0, normals[0].y, 1e-12);
    expect_near(-1.0, normals[1].y, 1e-12);
    expect_near(0.5 * (to[0] + radius[0] + y - RADIUS), points[0].y, 1e-12);
    expect_near(to[1] - radius[1], points[1].y, 1e-12);
    expect_near(-gap, statistics_of(&s).penetration, 1e-12);
    assert_int_equal(1, baseline_statistics_of(&s).unconverged_steps);
    assert_int_equal(1, baseline_statistics_of(&s).passes);
    end(&s);
}

/* After its turn in the only pass: no contact, but an overlap. */
static void segment_pushed_into_tool_reports_depth(void **state)
{
    (void)state;
    stage s;
    begin(&s);
    baseline_of(&s.config.baseline)->scene_pass_limit = 1;
    make(&s);
    place_segment(&s);
    add_jaw(&s, 1e-3, -2e-3, -2e-3);
    add_jaw(&s, 3e-3, 4e-3, 1.5e-3);
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    assert_int_equal(1, statistics_of(&s).contacts);
    double axes = 1.5e-3 - 3e-3 - RADIUS + 2e-3;
    expect_near(1e-3 + RADIUS - axes, statistics_of(&s).last_penetration, 1e-12);
    end(&s);
}

/* Two tools that were there before the thread: found by tool, told by segment, each pair once. */
static void contacts_are_in_feature_order(void **state)
{
    (void)state;
    stage s;
    uint64_t seen = 0;
    begin(&s);
    make(&s);
    for (int k = 0; k < 2; k++) {
        double x = k == 0 ? 0.02 : -0.02;
        add_capsule(s.scene, VBSS_SCENE_RIGID_DRIVEN, vec3_make(x, 0, -0.01), vec3_make(x, 0, 0.01),
                    5e-3);
    }
    place_over(&s, 5.2e-3);
    for (int i = 0; i < 200; i++) {
        expect_ok(vbss_scene_step(s.scene, 1e-3));
        vbss_view v = view_of(&s, VBSS_SCENE_VIEW_CONTACTS);
        const contact_key *keys = v.data;
        for (uint64_t k = 1; k < v.count; k++) {
            assert_true(vbss_contact_compare_keys(&keys[k - 1], &keys[k]) < 0);
        }
        seen = v.count > seen ? v.count : seen;
    }
    assert_true(seen >= 4);
    end(&s);
}

/* Nothing can move: neither a contact nor a reason for another pass. Nor is rounding, where something rests. */
static void immobile_and_resting_features_need_no_extra_pass(void **state)
{
    (void)state;
    stage s;
    begin(&s);
    s.config.floor = 1;
    s.config.floor_normal[0] = 0.3;
    make(&s);
    vbss_thread_config c = paper_thread(1);
    c.start[1] = -0.01;
    add(&s, 0, &c);
    hold_ends(&s, 0);
    for (int i = 0; i < 5; i++) {
        expect_ok(vbss_scene_step(s.scene, 1e-3));
    }
    assert_int_equal(0, statistics_of(&s).contacts);
    assert_int_equal(5, baseline_statistics_of(&s).passes);
    end(&s);
}

int test_paper_rules(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(comoving_threads_are_not_pushed),
        harness_test(thread_passing_within_step_is_moved_back),
        harness_test(segment_driven_through_tool_reports_depth),
        harness_test(segment_pushed_into_tool_reports_depth),
        harness_test(contacts_are_in_feature_order),
        harness_test(immobile_and_resting_features_need_no_extra_pass),
        harness_test(neighbour_of_held_node_is_not_thrown),
        harness_test(thickness_keeps_features_beyond_radii),
    };
    return cmocka_run_group_tests_name("scene.paper_rules", tests, NULL, NULL);
}
