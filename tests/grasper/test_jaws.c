/* Where the jaws are, how they follow the handle, how hard they press. */
#include "fixture.h"

static grasper_object tool(double length, double radius, double bend)
{
    grasper_object g = {.kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER, .opening = 1.0, .jaw_angle = 0.35};
    g.driver = (grasper_jaws){length, radius, bend, 0.35, 0.0};
    g.shears = (grasper_jaws){2.0 * length, 3.0 * radius, -bend, 0.5, 0.0};
    g.config.shaft_length = 0.15;
    g.config.shaft_radius = 2.5e-3;
    g.config.closing_force = 8.0;
    g.config.closing_angle = 0.1;
    g.config.jaw_speed = 8.0;
    return g;
}

/* ---- where they are */

static void tip_is_midpoint_of_closed_jaw_ends(void **state)
{
    (void)state;
    grasper_capsule c[GRASPER_CAPSULES];
    for (int i = -15; i <= 15; i++) {
        grasper_object g = tool(13e-3, 0.7e-3, 0.1 * i);
        vbss_grasper_compute_capsules(&g, 0.0, c);
        vec3 tip = vec3_lerp(c[1].axis[1], c[2].axis[1], 0.5);
        expect_near_vec3(vec3_zero(), tip, 1e-17);
        vec3 pivot = vec3_lerp(c[1].axis[0], c[2].axis[0], 0.5);
        expect_near_vec3(vec3_make(0.0, 13e-3 * sin(0.1 * i), 13e-3 * cos(0.1 * i)), pivot, 1e-16);
        expect_near_vec3(pivot, vbss_grasper_jaw_frame(&g).position, 1e-17);
        /* the shaft goes along z and is round up to the pivot */
        expect_near_vec3(vec3_add(pivot, vec3_make(0.0, 0.0, 2.5e-3)), c[0].axis[0], 1e-16);
        expect_near_vec3(vec3_add(pivot, vec3_make(0.0, 0.0, 0.15)), c[0].axis[1], 1e-16);
        expect_same_bits(2.5e-3, c[0].radius);
    }
}

/* The neck goes on in the line of the jaws, and the shaft begins where it ends. */
static void bend_lies_behind_neck(void **state)
{
    (void)state;
    grasper_capsule c[GRASPER_CAPSULES];
    grasper_object g = tool(13e-3, 0.7e-3, 0.8);
    g.driver.neck = 5e-3;
    g.config.neck_radius = 1.2e-3;
    vbss_grasper_compute_capsules(&g, 0.0, c);
    vec3 bend = vec3_make(0.0, 18e-3 * sin(0.8), 18e-3 * cos(0.8));
    expect_near_vec3(bend, vbss_grasper_bend_point(&g), 1e-17);
    expect_near_vec3(bend, c[GRASPER_NECK].axis[1], 1e-17);
    expect_near_vec3(vec3_make(0.0, 14.2e-3 * sin(0.8), 14.2e-3 * cos(0.8)),
                     c[GRASPER_NECK].axis[0], 1e-17); /* its cap ends at the pivot */
    expect_same_bits(1.2e-3, c[GRASPER_NECK].radius);
    expect_near_vec3(vec3_add(bend, vec3_make(0.0, 0.0, 2.5e-3)), c[GRASPER_SHAFT].axis[0], 1e-17);
}

static void thick_short_shaft_is_ball(void **state)
{
    (void)state;
    grasper_capsule c[GRASPER_CAPSULES];
    grasper_object g = tool(13e-3, 0.7e-3, 0.0);
    g.config.shaft_radius = 0.1;
    g.config.shaft_length = 1e-3;
    vbss_grasper_compute_capsules(&g, 0.0, c);
    expect_near_vec3(c[0].axis[0], c[0].axis[1], 0.0);
}

/* At every place of the one jaw the other is just twice the radius away. */
static void closed_jaws_touch_along_length(void **state)
{
    (void)state;
    grasper_capsule c[GRASPER_CAPSULES];
    for (int i = -15; i <= 15; i++) {
        grasper_object g = tool(13e-3, 0.7e-3, 0.1 * i);
        vbss_grasper_compute_capsules(&g, 0.0, c);
        for (int k = 0; k <= 20; k++) {
            vec3 a = vec3_lerp(c[1].axis[0], c[1].axis[1], 0.05 * k);
            vec3 b = vec3_lerp(c[2].axis[0], c[2].axis[1], 0.05 * k);
            expect_near(c[1].radius + c[2].radius, vec3_distance(a, b), 1e-17);
            expect_near(0.0, a.x + b.x, 0.0);
        }
    }
}

static void a_mouth_is_the_distance_of_the_facing_surfaces(harness_source *source, void *user)
{
    (void)user;
    double length = harness_draw_real(source, 1e-3, 0.05);
    double radius = harness_draw_real(source, 1e-4, 1e-3);
    grasper_object g = tool(length, radius, harness_draw_real(source, -1.5, 1.5));
    double angle = harness_draw_real(source, 0.0, 1.2);
    double share = harness_draw_real(source, 0.0, 1.0);
    grasper_capsule c[GRASPER_CAPSULES];
    vbss_grasper_compute_capsules(&g, angle, c);
    vec3 a = vec3_lerp(c[1].axis[0], c[1].axis[1], share);
    vec3 b = vec3_lerp(c[2].axis[0], c[2].axis[1], share);
    double apart = vec3_distance(a, b) - 2.0 * radius;
    expect_near(apart, vbss_grasper_jaw_distance(angle, share * length), 1e-15);
    /* both open by the same angle, about the pivot, in the plane of x and the way they point */
    vec3 down = quat_rotate(vbss_grasper_jaw_frame(&g).orientation, vec3_make(0.0, 0.0, -1.0));
    for (int i = GRASPER_JAW; i < GRASPER_NECK; i++) {
        vec3 direction = vec3_scale(vec3_sub(c[i].axis[1], c[i].axis[0]), 1.0 / length);
        expect_near(cos(angle), vec3_dot(direction, down), 1e-12);
        expect_near(i == 1 ? sin(angle) : -sin(angle), direction.x, 1e-12);
    }
}

static void mouth_is_distance_between_jaws(void **state)
{
    (void)state;
    harness_property("a mouth is a distance", 1000, a_mouth_is_the_distance_of_the_facing_surfaces,
                     NULL);
}

static void jaws_touch_where_mouth_is_diameter(void **state)
{
    (void)state;
    const double diameter = 0.25e-3;
    for (int i = 1; i <= 200; i++) {
        double from_pivot = 0.126e-3 * i;
        double angle = vbss_grasper_touching_angle(diameter, from_pivot);
        expect_near(diameter, vbss_grasper_jaw_distance(angle, from_pivot), 1e-18);
        expect_near(asin(diameter / (2.0 * from_pivot)), angle, 1e-15);
    }
    const double near[] = {0.125e-3, 0.1e-3, 1e-300, 0.0, -1.0};
    for (int i = 0; i < 5; i++) {
        expect_same_bits(0.5 * 3.141592653589793, vbss_grasper_touching_angle(diameter, near[i]));
    }
    expect_same_bits(0.0, vbss_grasper_jaw_distance(0.0, 0.01));
}

static void jaw_shape_follows_kind(void **state)
{
    (void)state;
    grasper_object g = tool(13e-3, 0.7e-3, 0.2);
    assert_ptr_equal(vbss_grasper_current_jaws(&g), &g.driver);
    g.kind = VBSS_GRASPER_KIND_SHEARS;
    assert_ptr_equal(vbss_grasper_current_jaws(&g), &g.shears);
    expect_near(-26e-3 * sin(0.2), vbss_grasper_jaw_frame(&g).position.y, 1e-16);
    expect_same_bits(0.5, vbss_grasper_commanded_angle(&g));
}

/* ---- how they follow the handle */

static void handle_maps_squeezed_to_open(void **state)
{
    (void)state;
    grasper_object g = tool(13e-3, 0.7e-3, 0.0);
    expect_same_bits(0.35, vbss_grasper_commanded_angle(&g));
    g.opening = 0.0;
    expect_same_bits(-0.1, vbss_grasper_commanded_angle(&g));
    double last = -1.0;
    for (int i = 0; i <= 100; i++) {
        g.opening = 0.01 * i;
        double reported = vbss_grasper_commanded_angle(&g);
        expect_near(-0.1 + 0.45 * g.opening, reported, 1e-15);
        assert_true(reported > last);
        last = reported;
    }
}

static void jaw_speed_is_limited(void **state)
{
    (void)state;
    const double h = 1e-3, step = 8e-3;
    grasper_object g = tool(13e-3, 0.7e-3, 0.0);
    g.opening = 0.0;
    for (int i = 0; i < 60; i++) {
        double next = vbss_grasper_next_angle(&g, h, 0.0);
        assert_true(next >= 0.0);
        expect_near(vbss_max(0.35 - step * (i + 1), 0.0), next, 1e-15);
        g.jaw_angle = next;
    }
    expect_same_bits(0.0, g.jaw_angle);
    expect_same_bits(0.0, vbss_grasper_next_angle(&g, h, -1.0));
    g.opening = 1.0;
    for (int i = 0; i < 60; i++) {
        g.jaw_angle = vbss_grasper_next_angle(&g, h, 0.0);
        expect_near(vbss_min(step * (i + 1), 0.35), g.jaw_angle, 1e-15);
    }
    expect_same_bits(0.35, g.jaw_angle);
    expect_same_bits(0.35, vbss_grasper_next_angle(&g, h, -1.0));
}

static void obstacle_stops_jaws(void **state)
{
    (void)state;
    const double h = 1e-3;
    grasper_object g = tool(13e-3, 0.7e-3, 0.0);
    g.opening = 0.0;
    for (int i = 0; i < 60; i++) {
        g.jaw_angle = vbss_grasper_next_angle(&g, h, 0.02);
    }
    expect_same_bits(0.02, g.jaw_angle);
    /* what comes between them opens them, faster than they go */
    expect_same_bits(0.2, vbss_grasper_next_angle(&g, h, 0.2));
    expect_same_bits(0.02, vbss_grasper_next_angle(&g, h, 0.02));
    /* and does not keep them from opening */
    g.opening = 1.0;
    expect_near(0.028, vbss_grasper_next_angle(&g, h, 0.02), 1e-16);
}

static void pressure_grows_with_blocked_angle(void **state)
{
    (void)state;
    grasper_object g = tool(13e-3, 0.7e-3, 0.0);
    g.opening = 0.0;
    expect_same_bits(8.0, vbss_grasper_jaw_force_at(&g, 0.0));
    expect_same_bits(8.0, vbss_grasper_jaw_force_at(&g, 0.3));
    g.opening = 0.1 / 0.45; /* they would just close */
    for (int i = 0; i <= 10; i++) {
        expect_near(0.8 * i, vbss_grasper_jaw_force_at(&g, 0.01 * i), 1e-13);
    }
    g.opening = 1.0;
    expect_same_bits(0.0, vbss_grasper_jaw_force_at(&g, 0.0));
    expect_same_bits(0.0, vbss_grasper_jaw_force_at(&g, 0.35));
}

int test_jaws(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(tip_is_midpoint_of_closed_jaw_ends),
        harness_test(bend_lies_behind_neck),
        harness_test(thick_short_shaft_is_ball),
        harness_test(closed_jaws_touch_along_length),
        harness_test(mouth_is_distance_between_jaws),
        harness_test(jaws_touch_where_mouth_is_diameter),
        harness_test(jaw_shape_follows_kind),
        harness_test(handle_maps_squeezed_to_open),
        harness_test(jaw_speed_is_limited),
        harness_test(obstacle_stops_jaws),
        harness_test(pressure_grows_with_blocked_angle),
    };
    return cmocka_run_group_tests_name("grasper.jaws", tests, NULL, NULL);
}
