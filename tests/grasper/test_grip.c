/* What is held stays up to the limits of friction and pressure; beyond them it gives way to just them. */
#include "base/elementary.h"
#include "base/rotation.h"
#include "held.h"

static void grip_limit_is_friction_of_both_faces(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 1.0, 0.0));
    expect_same_bits(4.0, vbss_grasper_friction_limit(&s.g, 4.0));
    s.g.config.grip_friction = 0.2;
    expect_near(3.2, vbss_grasper_friction_limit(&s.g, 8.0), 1e-15);
    expect_same_bits(0.0, vbss_grasper_friction_limit(&s.g, 0.0));
}

static vec3 random_along(harness_source *source)
{
    double x = harness_draw_real(source, -0.5, 0.5);
    double turn = harness_draw_real(source, -3.2, 3.2);
    return vec3_make(x, cos(turn), sin(turn));
}

/* ---- below the limits */

static void a_small_pull_changes_nothing(harness_source *source, void *user)
{
    (void)user;
    held s = hold_along(random_along(source));
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        s.thread[i] = vec3_add(s.thread[i], harness_draw_vec3(source, -2e-5, 2e-5));
    }
    const held before = s;
    grasper_thread_slip change = yield(&s);
    expect_same_bits(0.0, change.slip);
    assert_false(change.has_escaped);
    assert_memory_equal(before.grip.anchor, s.grip.anchor, sizeof s.grip.anchor);
    expect_same_bits(OLD + s.h, s.grip.age);
}

static void load_within_limits_holds(void **state)
{
    (void)state;
    harness_property("a small pull changes nothing", 500, a_small_pull_changes_nothing, NULL);
}

/* ---- beyond them */

static void a_pull_meets_its_limit(harness_source *source, void *user)
{
    uint32_t *yielded = user;
    held s = hold_along(random_along(source));
    vec3 pull = harness_draw_vec3(source, -4e-3, 4e-3);
    displace_thread(&s, pull);
    double limit = vbss_grasper_friction_limit(&s.g, s.pressure), energy = energy_of(&s);
    vec3 before = force_on_thread(&s);
    grasper_thread_slip change = yield(&s);
    vec3 after = force_on_thread(&s);
    expect_near(vbss_min(fabs(before.x), s.pressure), fabs(after.x), 1e-12);
    assert_true(before.x * after.x >= 0.0);
    expect_near(vbss_min(along_faces_of(before), limit), along_faces_of(after), 1e-12);
    /* the same way as before */
    expect_near(0.0, before.y * after.z - before.z * after.y, 1e-11);
    assert_true(before.y * after.y + before.z * after.z > 0.0);
    assert_true(energy_of(&s) <= energy * (1.0 + 1e-15));
    if (along_faces_of(before) > limit) {
        (*yielded)++;
        double component = before.y * s.along.y + before.z * s.along.z;
        assert_true(component == 0.0 || change.slip * component > 0.0);
        /* across the thread the anchors give way, along it they stay */
        vec3 moved = vec3_sub(s.grip.anchor[1], vec3_make(0.0, 0.0, -8e-3));
        expect_near(0.0, moved.y * s.along.y + moved.z * s.along.z, 1e-15);
    } else {
        expect_same_bits(0.0, change.slip);
    }
}

static void load_above_limit_slips_at_limit(void **state)
{
    (void)state;
    uint32_t yielded = 0;
    harness_property("a pull meets its limit", 1000, a_pull_meets_its_limit, &yielded);
    assert_in_range(yielded, 50, 980); /* both are met, whatever the seed */
}

/* Tension on the low side draws the thread toward smaller arc lengths: what is held then is further on. */
static void thread_slips_along_pull(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 1.0, 0.0));
    displace_thread(&s, vec3_make(0.0, -2e-3, 0.0));
    expect_near(6.0, force_on_thread(&s).y, 1e-12);
    grasper_thread_slip change = yield(&s);
    expect_near((6.0 - 4.0) / 3000.0, change.slip, 1e-17);
    assert_false(change.has_escaped);
    expect_near(4.0, force_on_thread(&s).y, 1e-12);
    displace_thread(&s, vec3_make(0.0, 4e-3, 0.0));
    change = yield(&s);
    expect_near(-(8.0 - 4.0) / 3000.0, change.slip, 1e-17);
    expect_near(-4.0, force_on_thread(&s).y, 1e-12);
    expect_same_bits(0.0, yield(&s).slip);
}

static void transverse_thread_slips_sideways(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 1.0, 0.0));
    displace_thread(&s, vec3_make(0.0, 0.0, -2e-3));
    grasper_thread_slip change = yield(&s);
    expect_near(0.0, change.slip, 1e-18);
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        expect_near(-8e-3 - 2.0 / 3000.0, s.grip.anchor[i].z, 1e-17);
    }
}

static void thread_across_faces_does_not_slip_axially(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(1.0, 0.5, 0.0));
    displace_thread(&s, vec3_make(0.0, -2e-3, 0.0));
    expect_same_bits(0.0, yield(&s).slip);
    expect_near(4.0, along_faces_of(force_on_thread(&s)), 1e-12);
    s = hold_along(vec3_make(1.0, 0.0, 0.0));
    displace_thread(&s, vec3_make(0.0, -2e-3, 1e-3));
    expect_same_bits(0.0, yield(&s).slip);
    expect_near(4.0, along_faces_of(force_on_thread(&s)), 1e-12);
}

static void zero_pressure_holds_nothing(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 1.0, 1.0));
    s.pressure = 0.0;
    displace_thread(&s, vec3_make(1e-4, 2e-4, -3e-4));
    yield(&s);
    expect_near(0.0, vec3_norm(force_on_thread(&s)), 1e-13);
    expect_near(0.0, energy_of(&s), 1e-28);
}

/* ---- torque */

static void turn_thread(held *s, double angle)
{
    quat turn = vbss_quat_from_rotation_vector(vec3_make(angle, 0.0, 0.0));
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        vec3 arm = vec3_sub(s->thread[i], s->grip.anchor[1]);
        s->thread[i] = vec3_add(s->grip.anchor[1], quat_rotate(turn, arm));
    }
    s->along = quat_rotate(turn, s->along);
}

static void a_turn_meets_its_limit(harness_source *source, void *user)
{
    uint32_t *yielded = user;
    held s = hold_along(random_along(source));
    s.pressure = harness_draw_real(source, 0.0, 0.4);
    double limit = vbss_grasper_friction_limit(&s.g, s.pressure) * 2.0 * HALF_GRIP / 4.0;
    turn_thread(&s, harness_draw_real(source, -3.1, 3.1));
    double before = torque_on_thread(&s), energy = energy_of(&s);
    vec3 middle = s.grip.anchor[1];
    yield(&s);
    double after = torque_on_thread(&s);
    *yielded += fabs(before) > limit;
    expect_near(vbss_min(fabs(before), limit), fabs(after), 1e-12 * limit + 1e-16);
    assert_true(before * after > -1e-18);
    assert_true(energy_of(&s) <= energy * (1.0 + 1e-14));
    expect_near_vec3(middle, s.grip.anchor[1], 1e-18);
    for (int i = 0; i < GRASPER_THREAD_POINTS; i += 2) { /* they stay as far from the middle */
        expect_near(HALF_GRIP, vec3_distance(middle, s.grip.anchor[i]), 1e-17);
    }
}

static void torque_above_limit_turns_at_limit(void **state)
{
    (void)state;
    uint32_t yielded = 0;
    harness_property("a turn meets its limit", 1000, a_turn_meets_its_limit, &yielded);
    assert_in_range(yielded, 500, 999);
}

/* Crooked, as it was taken, and pulled and turned at once: the torque is that of the force that is left. */
static void a_turn_beside_a_pull_meets_its_limit(harness_source *source, void *user)
{
    uint32_t *both = user;
    held s = hold_along(random_along(source));
    s.pressure = harness_draw_real(source, 0.1, 1.0);
    double limit = vbss_grasper_friction_limit(&s.g, s.pressure),
           largest = limit * 2.0 * HALF_GRIP / 4.0;
    for (int i = 0; i < GRASPER_THREAD_POINTS; i += 2) {
        s.grip.anchor[i] = vec3_add(s.grip.anchor[i], harness_draw_vec3(source, -3e-4, 3e-4));
    }
    turn_thread(&s, harness_draw_real(source, -1.5, 1.5));
    displace_thread(&s, harness_draw_vec3(source, -1e-3, 1e-3));
    bool pulled = along_faces_of(force_on_thread(&s)) > limit;
    yield(&s);
    double torque = fabs(torque_on_thread(&s));
    assert_true(torque <= largest * (1.0 + 1e-9));
    *both += pulled && torque >= largest * (1.0 - 1e-9);
}

static void combined_pull_and_torque_meet_both_limits(void **state)
{
    (void)state;
    uint32_t both = 0;
    harness_property("a turn beside a pull", 1000, a_turn_beside_a_pull_meets_its_limit, &both);
    assert_true(both > 300);
}

static void small_excess_torque_turns_as_linear_spring(void **state)
{
    (void)state;
    held s = hold_along(vec3_make(0.0, 1.0, 0.0));
    double stiffness = 2.0 * stiffness_of(&s) * HALF_GRIP * HALF_GRIP;
    s.pressure = 0.01;
    double limit = vbss_grasper_friction_limit(&s.g, s.pressure) * 2.0 * HALF_GRIP / 4.0;
    turn_thread(&s, 1e-2);
    double excess = -torque_on_thread(&s) - limit; /* it turns the thread back */
    assert_true(excess > 0.0);
    yield(&s);
    vec3 anchor_line = vec3_sub(s.grip.anchor[2], s.grip.anchor[0]);
    expect_near(excess / stiffness, vbss_atan2(anchor_line.z, anchor_line.y), 1e-6);
}

/* ---- everything at once: no yielding makes the springs stronger */

static void any_yielding_loses_energy(harness_source *source, void *user)
{
    (void)user;
    held s = hold_along(random_along(source));
    s.pressure = harness_draw_real(source, 0.0, 1.0);
    double size = harness_draw_real(source, 0.0, 1e-3);
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        s.thread[i] = vec3_add(s.thread[i], harness_draw_vec3(source, -size, size));
        s.grip.anchor[i] = vec3_add(s.grip.anchor[i], harness_draw_vec3(source, -1e-4, 1e-4));
    }
    double energy = energy_of(&s);
    for (int k = 0; k < 5; k++) {
        yield(&s);
        assert_true(energy_of(&s) <= energy * (1.0 + 1e-12));
        energy = energy_of(&s);
    }
}

static void yielding_dissipates_energy(void **state)
{
    (void)state;
    harness_property("any yielding loses energy", 2000, any_yielding_loses_energy, NULL);
}

int test_grip(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(grip_limit_is_friction_of_both_faces),
        harness_test(load_within_limits_holds),
        harness_test(load_above_limit_slips_at_limit),
        harness_test(thread_slips_along_pull),
        harness_test(transverse_thread_slips_sideways),
        harness_test(thread_across_faces_does_not_slip_axially),
        harness_test(zero_pressure_holds_nothing),
        harness_test(torque_above_limit_turns_at_limit),
        harness_test(combined_pull_and_torque_meet_both_limits),
        harness_test(small_excess_torque_turns_as_linear_spring),
        harness_test(yielding_dissipates_energy),
    };
    return cmocka_run_group_tests_name("grasper.grip", tests, NULL, NULL);
}
