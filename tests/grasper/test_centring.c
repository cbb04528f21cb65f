/* What was just taken comes to lie straight in the middle of the jaws; what is drawn out of them is torn. */
#include "held.h"

/* Taken as it lay: crooked, beside the middle, and already with the springs at rest. */
static held just_taken(harness_source *source)
{
    held s = hold_along(vec3_make(0.2, 1.0, 0.3));
    s.grip.age = 0.0;
    s.pressure = 8.0;
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        s.grip.anchor[i] = vec3_add(s.grip.anchor[i], harness_draw_vec3(source, -2e-4, 2e-4));
    }
    return s;
}

/* The thread follows its anchors: nothing pulls. */
static grasper_thread_slip follow(held *s)
{
    memcpy(s->thread, s->grip.anchor, sizeof s->thread);
    return yield(s);
}

static void it_comes_to_rest(harness_source *source, void *user)
{
    (void)user;
    held s = just_taken(source);
    const grasper_thread_clamp first = s.grip;
    vec3 direction = vec3_sub(first.anchor[2], first.anchor[0]);
    direction = vec3_unit_or(vec3_make(0.0, direction.y, direction.z), vec3_zero());
    vec3 middle = vec3_make(0.0, first.anchor[1].y, first.anchor[1].z), goal[GRASPER_THREAD_POINTS];
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        goal[i] = vec3_add_scaled(middle, (i - 1) * HALF_GRIP, direction);
    }
    s.h = harness_draw_real(source, 1e-4, 3e-3);
    double steps = 0.08 / s.h;
    for (int k = 1; k < steps; k++) {
        const grasper_thread_clamp before = s.grip;
        assert_false(follow(&s).has_escaped);
        expect_near(k * s.h, s.grip.age, 1e-14);
        for (int i = 0; i < GRASPER_THREAD_POINTS; i++) { /* evenly, straight to its goal */
            double whole = vec3_distance(first.anchor[i], goal[i]);
            double step = vec3_distance(before.anchor[i], s.grip.anchor[i]);
            expect_near(whole / steps, step, 1e-11);
            vec3 wanted = vec3_lerp(first.anchor[i], goal[i], k / steps);
            expect_near_vec3(wanted, s.grip.anchor[i], 1e-15);
        }
    }
    follow(&s);
    follow(&s);
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        expect_near_vec3(goal[i], s.grip.anchor[i], 1e-16);
        expect_same_bits(0.0, s.grip.anchor[i].x);
    }
    const grasper_thread_clamp at_rest = s.grip;
    follow(&s);
    assert_memory_equal(at_rest.anchor, s.grip.anchor, sizeof at_rest.anchor);
}

static void grasped_thread_centres_in_jaws(void **state)
{
    (void)state;
    harness_property("it settles", 200, it_comes_to_rest, NULL);
}

static void long_step_centres_at_once(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 1.0, 0.0));
    s.grip.age = 0.0;
    s.h = 0.1;
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        s.grip.anchor[i].x = 3e-4;
    }
    follow(&s);
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        expect_same_bits(0.0, s.grip.anchor[i].x);
    }
}

static void coincident_points_spread_along_thread(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 0.6, 0.8));
    s.grip.age = 0.0;
    s.h = 0.1;
    s.grip.anchor[0] = s.grip.anchor[2] = s.grip.anchor[1];
    follow(&s);
    expect_near_vec3(vec3_make(0.0, 0.6 * HALF_GRIP, -8e-3 + 0.8 * HALF_GRIP), s.grip.anchor[2],
                     1e-17);
    expect_near_vec3(vec3_make(0.0, -0.6 * HALF_GRIP, -8e-3 - 0.8 * HALF_GRIP), s.grip.anchor[0],
                     1e-17);
}

/* ---- the end of a thread */

static void grasp_near_end_uses_available_length(void **state)
{
    (void)state;
    for (int end = 0; end < GRASPER_THREAD_POINTS; end += 2) {
        held s = hold_along(vec3_make(0.0, 1.0, 0.0));
        for (int k = 4; k >= 0; k--) { /* an old grip, too: the thread runs out of it */
            double left = 0.2 * k * HALF_GRIP;
            s.ahead[end] = end == 0 ? -left : left;
            assert_false(follow(&s).has_escaped);
            expect_near(s.ahead[end], s.grip.anchor[end].y, 1e-18);
            expect_near(-s.ahead[2 - end], -s.grip.anchor[2 - end].y, 1e-18);
        }
        s = hold_along(vec3_make(0.0, 1.0, 0.0));
        s.ahead[end] *= 0.5;
        s.grip.age = 0.0;
        s.h = 0.1;
        s.grip.anchor[end].z += 1e-4;
        follow(&s);
        vec3 direction = vec3_unit_or(vec3_sub(s.grip.anchor[2], s.grip.anchor[0]), vec3_zero());
        for (int i = 0; i < GRASPER_THREAD_POINTS; i++) { /* straight, and so far apart */
            expect_near_vec3(vec3_scale(direction, s.ahead[i]),
                             vec3_sub(s.grip.anchor[i], s.grip.anchor[1]), 1e-17);
        }
    }
}

static void short_end_carries_less_torque(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 1.0, 0.0));
    s.pressure = 0.01;
    s.ahead[2] = s.grip.anchor[2].y = 0.0;
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) { /* turned by 0.1, by its low end alone */
        s.thread[i] = s.grip.anchor[i];
    }
    s.thread[0].z -= 0.1 * HALF_GRIP;
    s.thread[1].z += 0.1 * HALF_GRIP; /* so that no force is left */
    double limit = vbss_grasper_friction_limit(&s.g, s.pressure) * HALF_GRIP / 4.0;
    assert_true(fabs(torque_on_thread(&s)) > 2.0 * limit);
    yield(&s);
    expect_near(limit, fabs(torque_on_thread(&s)), 1e-12 * limit);
}

/* ---- out of the jaws */

/* Steps that pull the thread on by `by` each until it is torn; 0: never. */
static int torn_after(held *s, vec3 by)
{
    for (int k = 1; k <= 200; k++) {
        displace_thread(s, by);
        if (yield(s).has_escaped) {
            return k;
        }
    }
    return 0;
}

static void thread_slides_out_over_jaw_end(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 1.0, 0.0));
    /* the springs are 4/3 mm behind when it yields, and it has 5.7 mm to go */
    assert_int_equal(torn_after(&s, vec3_make(0.0, 0.0, -0.1e-3)), 71);
    assert_true(-s.grip.anchor[1].z > 13.7e-3 && -s.grip.anchor[1].z < 13.81e-3);
}

static void thread_stops_at_pivot(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 1.0, 0.0));
    assert_int_equal(torn_after(&s, vec3_make(0.0, 0.0, 0.1e-3)), 0);
    expect_same_bits(0.0, s.grip.anchor[1].z);
    expect_near(0.0, s.grip.anchor[0].z, 1e-17);
    expect_near(0.0, s.grip.anchor[2].z, 1e-17);
    /* and comes back */
    displace_thread(&s, vec3_make(0.0, 0.0, -20e-3));
    assert_false(yield(&s).has_escaped);
    expect_near(4.0 / 3000.0, s.grip.anchor[1].z - s.thread[1].z, 1e-15);
}

static void thread_slides_out_sideways(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        held s = hold_along(vec3_make(0.0, 0.0, 1.0));
        assert_int_equal(torn_after(&s, vec3_make(0.0, side * 0.1e-3, 0.0)), 31);
        expect_near(1.7e-3, fabs(s.grip.anchor[1].y), 1e-4);
    }
}

static void jaws_are_pried_open(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        held s = hold_along(vec3_make(0.0, 1.0, 0.0));
        s.pressure = 1.0;
        assert_int_equal(torn_after(&s, vec3_make(side * 0.1e-3, 0.0, 0.0)), 15);
        expect_near(1.4e-3, fabs(s.grip.anchor[1].x), 1e-4);
    }
}

/* It runs on for as long as it is pulled: whether that is its end only a scene knows. */
static void thread_slides_through_without_tearing(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 1.0, 0.0));
    assert_int_equal(torn_after(&s, vec3_make(0.0, 0.5e-3, 0.0)), 0);
    expect_near(0.0, s.grip.anchor[1].y, 1e-17);
    expect_near(4.0, fabs(force_on_thread(&s).y), 1e-11);
}

static void non_finite_place_is_torn(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 1.0, 0.0));
    s.grip.anchor[1].y = (double)NAN;
    assert_true(yield(&s).has_escaped);
}

int test_centring(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(grasped_thread_centres_in_jaws),
        harness_test(long_step_centres_at_once),
        harness_test(coincident_points_spread_along_thread),
        harness_test(grasp_near_end_uses_available_length),
        harness_test(short_end_carries_less_torque),
        harness_test(thread_slides_out_over_jaw_end),
        harness_test(thread_stops_at_pivot),
        harness_test(thread_slides_out_sideways),
        harness_test(jaws_are_pried_open),
        harness_test(thread_slides_through_without_tearing),
        harness_test(non_finite_place_is_torn),
    };
    return cmocka_run_group_tests_name("grasper.centring", tests, NULL, NULL);
}
