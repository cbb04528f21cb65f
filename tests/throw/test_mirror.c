/* Left-handed hands: reflections, and that the two hands of a stitch see and do the same in the mirror. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "needle/stitch.h" /* whose pose is another than the library's: so no harness here */

#define STEP 1e-3
#define ROUNDING 1e-12
#define TOLERANCE 1e-6 /* m, after some hundred steps that are rounded in another order */
#define expect_ok(call) assert_int_equal(VBSS_OK, (call))
enum { ROTATIONS = 100, STEPS = 300, SEED = 3 };

/* ---- reflections */

static double chance(uint64_t *random)
{
    return 2.0 * hand_chance(random) - 1.0;
}

static vec any_vec(uint64_t *random)
{
    return v3(chance(random), chance(random), chance(random));
}

static void any_rotation(uint64_t *random, double q[4])
{
    double length = 0.0;
    for (int i = 0; i < 4; i++) {
        q[i] = chance(random);
        length += q[i] * q[i];
    }
    for (int i = 0; i < 4; i++) {
        q[i] /= sqrt(length);
    }
}

static bool is_same(const double a[4], const double b[4])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2] && a[3] == b[3];
}

static void reflections_are_involutions(void **state)
{
    (void)state;
    uint64_t random = 1;
    for (int i = 0; i < ROTATIONS; i++) {
        const vec v = any_vec(&random), back = mirror_vec(true, mirror_vec(true, v));
        double q[4], once[4], twice[4];
        any_rotation(&random, q);
        assert_true(v_distance(v, back) == 0.0);
        mirror_tool(true, q, once);
        mirror_tool(true, once, twice);
        assert_true(is_same(q, twice));
        mirror_needle(true, q, once);
        mirror_needle(true, once, twice);
        assert_true(is_same(q, twice));
    }
    assert_int_equal(mirror_side(true, mirror_side(true, SITE_LEFT)), SITE_LEFT);
    assert_int_equal(mirror_side(true, SITE_LEFT), SITE_RIGHT);
    assert_true(mirror_sign(true) * mirror_sign(true) == 1.0);
}

static void right_handed_see_scene_as_it_is(void **state)
{
    (void)state;
    uint64_t random = 2;
    const vec v = any_vec(&random);
    double q[4], image[4];
    any_rotation(&random, q);
    assert_true(v_distance(v, mirror_vec(false, v)) == 0.0);
    mirror_tool(false, q, image);
    assert_true(is_same(q, image));
    mirror_needle(false, q, image);
    assert_true(is_same(q, image));
    assert_int_equal(mirror_side(false, SITE_RIGHT), SITE_RIGHT);
    assert_true(mirror_sign(false) == 1.0);
}

/* A unit quaternion is a proper rotation. It takes each point's image in the body to the point's image in the world. */
static void images_of_bodies_are_turned_properly(void **state)
{
    (void)state;
    uint64_t random = 3;
    for (int i = 0; i < ROTATIONS; i++) {
        const vec v = any_vec(&random), across_x = v3(-v.x, v.y, v.z),
                  across_z = v3(v.x, v.y, -v.z);
        double q[4], tool[4], needle[4], length = 0.0;
        any_rotation(&random, q);
        mirror_tool(true, q, tool);
        mirror_needle(true, q, needle);
        const vec image = mirror_vec(true, hand_rotate(q, v));
        assert_true(v_distance(hand_rotate(tool, across_x), image) < ROUNDING);
        assert_true(v_distance(hand_rotate(needle, across_z), image) < ROUNDING);
        for (int k = 0; k < 4; k++) {
            length += tool[k] * tool[k];
        }
        assert_true(fabs(length - 1.0) < ROUNDING);
    }
}

/* ---- hands at work */

static void begin(stitch *t, bool mirrored)
{
    stitch_plan plan;
    stitch_plan_usual(&plan);
    plan.free_left = true;
    plan.site.mirrored = mirrored;
    expect_ok(stitch_create(t, SEED, &plan));
}

static void expect_same_pose(const pose *a, const pose *b)
{
    assert_true(v_distance(a->at, b->at) < TOLERANCE);
    assert_true(pose_angle(a, b) < 1e-3); /* a cosine tells no less */
}

static void expect_same_sight(const stitch *a, const stitch *b)
{
    const pose needle = site_needle(&a->site), other = site_needle(&b->site);
    expect_same_pose(&needle, &other);
    for (int side = 0; side < 2; side++) {
        assert_true(v_distance(site_mark(&a->site, side), site_mark(&b->site, side)) < TOLERANCE);
        assert_true(v_distance(site_mark_at_rest(&a->site, side),
                               site_mark_at_rest(&b->site, side)) < TOLERANCE);
        assert_true(v_distance(site_normal_at_rest(&a->site, side),
                               site_normal_at_rest(&b->site, side)) < TOLERANCE);
    }
}

static void expect_same_tool(const hand *a, const hand *b)
{
    hand_pose p, q;
    expect_ok(hand_observe(a, &p));
    expect_ok(hand_observe(b, &q));
    assert_true(v_distance(a->at, b->at) < TOLERANCE);
    assert_true(v_distance(p.tip, q.tip) < TOLERANCE);
    assert_true(v_distance(p.trocar, q.trocar) < TOLERANCE);
    assert_true(fabs(fabs(v_dot(p.opening, q.opening)) - 1.0) < TOLERANCE); /* to either side */
}

/* In the scene they are at opposite sides. */
static void expect_mirrored_tool(const hand *a, const hand *b)
{
    vbss_grasper_state s, image;
    expect_ok(vbss_grasper_get_state(a->grasper, &s, sizeof s));
    expect_ok(vbss_grasper_get_state(b->grasper, &image, sizeof image));
    assert_true(v_distance(v_load(image.position), mirror_vec(true, v_load(s.position))) <
                TOLERANCE);
    assert_true(s.position[0] * image.position[0] < 0.0);
}

static void step(stitch *t)
{
    expect_ok(stitch_lead(t, STEP));
    expect_ok(vbss_scene_step(t->site.rig.scene, STEP));
    expect_ok(hand_feel(&t->right));
    expect_ok(hand_feel(&t->left));
}

static void left_handed_hands_do_the_same_in_the_mirror(void **state)
{
    (void)state;
    static stitch right, left;
    begin(&right, false);
    begin(&left, true);
    expect_same_sight(&right, &left);
    for (int i = 0; i < STEPS; i++) {
        step(&right);
        step(&left);
    }
    assert_int_equal(right.state, STITCH_REACH);
    assert_int_equal(left.state, STITCH_REACH);
    expect_same_sight(&right, &left);
    expect_same_tool(&right.right, &left.right);
    expect_same_tool(&right.left, &left.left);
    expect_mirrored_tool(&right.right, &left.right);
    expect_mirrored_tool(&right.left, &left.left);
    assert_ptr_equal(stitch_hand(&right, SITE_RIGHT), &right.right);
    assert_ptr_equal(stitch_hand(&left, SITE_LEFT), &left.right);
    throw_rig_destroy(&right.site.rig);
    throw_rig_destroy(&left.site.rig);
}

int test_mirror(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reflections_are_involutions),
        cmocka_unit_test(right_handed_see_scene_as_it_is),
        cmocka_unit_test(images_of_bodies_are_turned_properly),
        cmocka_unit_test(left_handed_hands_do_the_same_in_the_mirror),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
