/* Tools that touch: each other, what they hold, the floor. */
#include "base/elementary.h"
#include "scene/small.h"

static const vec3 half = {0.0, 0.0, 5e-3};
static const vec3 along = {5e-3, 0.0, 0.0};

/* Two hands press their tools together by 1 mm: as much on the one as on the other, and as their springs say. */
static void pressed_tools_push_back_equally(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    uint32_t a =
        small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 1.1e-3, 0.0), along, 1e-3);
    uint32_t b =
        small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, -1.1e-3, 0.0), half, 1e-3);
    for (int i = 1; i <= 300; i++) {
        double y = 1.1e-3 - 1e-5 * vbss_min(i, 110.0);
        small_move(&s, a, vec3_make(0.0, y, 0.0));
        small_move(&s, b, vec3_make(0.0, -y, 0.0));
        small_steps(&s, 1, 1e-3);
        vbss_scene_rigid_state on_a = small_rigid(&s, a), on_b = small_rigid(&s, b);
        vec3 sum = vec3_add(vec3_load(on_a.contact_force), vec3_load(on_b.contact_force));
        expect_near_vec3(vec3_zero(), sum, 1e-12);
        /* By symmetry the point where they touch is the origin: so are the torques about it. */
        expect_near(on_a.position[1], -on_b.position[1], 1e-9);
    }
    vbss_scene_rigid_state on_a = small_rigid(&s, a), on_b = small_rigid(&s, b);
    /* 2000 N/m, 1 mm each, less half of what the contact gives way. */
    double force = 2.0 / (1.0 + 2000.0 / 4e5);
    expect_near(force, on_a.contact_force[1], 1e-6);
    expect_near(-force, on_b.contact_force[1], 1e-6);
    expect_near(force, on_a.hand_force[1], 1e-6);
    expect_near(-force, on_b.hand_force[1], 1e-6);
    expect_near(2e-3 - force / 2e5, on_a.position[1] - on_b.position[1], 1e-9);
    assert_int_equal(small_statistics(&s).clamped, 0);
    small_end(&s);
}

/* One tool drags across another: Coulomb's force along the way, with the mean coefficient. */
static void sliding_tool_rubs(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    s.rigid.friction = 0.1;
    small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
    s.rigid.friction = 0.4; /* the geometric mean is 0.2 */
    s.rigid.turning_stiffness = 1e4;
    uint32_t tool =
        small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 2e-3, 0.0), along, 1e-3);
    for (int i = 1; i <= 400; i++) {
        double down = 1e-5 * vbss_min(i, 100.0), z = i > 200 ? 1e-5 * (i - 200) : 0.0;
        small_move(&s, tool, vec3_make(0.0, 2e-3 - down, z));
        small_steps(&s, 1, 1e-3);
    }
    vbss_scene_rigid_state r = small_rigid(&s, tool);
    expect_near(2.0, r.contact_force[1], 0.03);
    expect_near(-0.2 * r.contact_force[1], r.contact_force[2], 2e-3);
    expect_near(r.contact_force[2], r.hand_force[2], 2e-3);
    expect_near(0.0, r.contact_force[0], 2e-3);
    small_end(&s);
}

/* A driven roller turns under a tool: its surface goes, though its axis does not. */
static void roller_rubs(void **state)
{
    (void)state;
    small s;
    const double zero[3] = {0.0, 0.0, 0.0};
    small_begin_scene(&s);
    s.rigid.friction = 0.2;
    uint32_t roller = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
    s.rigid.turning_stiffness = 1e4;
    uint32_t tool =
        small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 2e-3, 0.0), along, 1e-3);
    for (int i = 1; i <= 300; i++) {
        double turn = 0.01 * i;
        const double q[4] = {vbss_cos(turn), 0.0, 0.0, vbss_sin(turn)};
        small_move(&s, tool, vec3_make(0.0, 2e-3 - 1e-5 * vbss_min(i, 100.0), 0.0));
        expect_ok(vbss_scene_set_rigid_target(s.scene, roller, zero, q));
        small_steps(&s, 1, 1e-3);
    }
    vbss_scene_rigid_state r = small_rigid(&s, tool), on_roller = small_rigid(&s, roller);
    expect_near(-0.2 * r.contact_force[1], r.contact_force[0], 2e-3); /* z cross y is -x */
    assert_true(r.contact_force[1] > 1.5);
    expect_near(r.contact_force[0] * -1e-3, -on_roller.hand_torque[2], 1e-2 * 1e-3);
    small_end(&s);
}

/* Pushed a little, it sticks, and does not creep. */
static void tool_on_floor_sticks_then_slides(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.floor = 1;
    s.config.floor_friction = 0.3;
    small_create(&s);
    s.rigid.friction = 0.3;
    s.rigid.turning_stiffness = 1e4;
    uint32_t tool =
        small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 1e-3, 0.0), half, 1e-3);
    for (int i = 1; i <= 200; i++) {
        small_move(&s, tool, vec3_make(0.0, 1e-3 - 1e-5 * vbss_min(i, 100.0), 0.0));
        small_steps(&s, 1, 1e-3);
    }
    double press =
        small_rigid(&s, tool).contact_force[1]; /* 2 N: up to 0.6 N across, 0.3 mm of spring */
    for (int i = 1; i <= 200; i++) {
        small_move(&s, tool, vec3_make(1e-6 * vbss_min(i, 100.0), 0.0, 0.0));
        small_steps(&s, 1, 1e-3);
    }
    vec3 stuck = small_position(&s, tool);
    assert_true(stuck.x < 5e-6);
    expect_near(-0.2, small_rigid(&s, tool).contact_force[0], 0.02);
    small_steps(&s, 1000, 1e-3);
    expect_near_vec3(stuck, small_position(&s, tool), 1e-12);
    for (int i = 1; i <= 200; i++) {
        small_move(&s, tool, vec3_make(1e-4 + 1e-5 * i, 0.0, 0.0));
        small_steps(&s, 1, 1e-3);
    }
    vbss_scene_rigid_state r = small_rigid(&s, tool);
    expect_near(-0.3 * press, r.contact_force[0], 0.01 * press);
    expect_near(r.target_position[0] - 0.15 * press / 1000.0, r.position[0], 2e-5);
    small_end(&s);
}

/* A free stick lies across two driven ones, which are drawn away below it: it rolls, and so comes along by
 * I / (I + m r^2) of their way. */
static void friction_rolls_stick_along(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    s.rigid.friction = 0.5;
    uint32_t left =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(-3e-3, 0.0, 0.0), half, 1e-3);
    uint32_t right =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(3e-3, 0.0, 0.0), half, 1e-3);
    s.rigid.gravity[1] = -9.81;
    s.rigid.mass = 1e-3;
    uint32_t load = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 2e-3, 0.0), along, 1e-3);
    /* A cylinder of 10 mm and two half balls, of 1 mm. */
    double inertia = (0.5 * 10.0 + 0.4 * 4.0 / 3.0) / (10.0 + 4.0 / 3.0);
    double share = inertia / (inertia + 1.0);
    small_steps(&s, 100, 1e-3);
    for (int i = 1; i <= 250; i++) { /* from rest at 0.2 m/s^2 */
        double t = 1e-3 * i, z = 0.1 * t * t;
        small_move(&s, left, vec3_make(-3e-3, 0.0, z));
        small_move(&s, right, vec3_make(3e-3, 0.0, z));
        small_steps(&s, 1, 1e-3);
        expect_near(share * z, small_position(&s, load).z, 1e-3 * z + 1e-9);
        expect_near(2e-3, small_position(&s, load).y, 1e-6);
    }
    vbss_scene_rigid_state r = small_rigid(&s, load);
    expect_near(9.81e-3, r.contact_force[1], 1e-5);
    expect_near(share * 0.2e-3, r.contact_force[2], 1e-6);
    vbss_scene_rigid_state a = small_rigid(&s, left), b = small_rigid(&s, right);
    expect_near(-9.81e-3, a.hand_force[1] + b.hand_force[1], 1e-5);
    small_end(&s);
}

/* Pressed from the side a ball goes off along the normal; a capsule about its end. */
static void off_centre_push_rotates(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    s.rigid.friction = 0.0;
    uint32_t pusher =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(4e-3, -2.001e-3, 0.0), half, 1e-3);
    s.rigid.mass = 1e-3;
    uint32_t stick = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_zero(), along, 1e-3);
    for (int i = 1; i <= 40; i++) {
        small_move(&s, pusher, vec3_make(4e-3, -2.001e-3 + 1e-6 * i * i, 0.0));
        small_steps(&s, 1, 1e-3);
    }
    vbss_scene_rigid_state r = small_rigid(&s, stick);
    assert_true(r.position[1] > 1e-5);
    assert_true(r.orientation[3] > 0.01); /* about +z */
    assert_true(r.contact_force[1] > 0.0);
    /* About the middle: the arm times the force. */
    expect_near(4e-3 * r.contact_force[1], r.contact_torque[2], 0.2 * 4e-3 * r.contact_force[1]);
    expect_near(0.0, r.position[2], 1e-12);
    small_end(&s);
}

int test_scene_tools(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pressed_tools_push_back_equally),
        cmocka_unit_test(sliding_tool_rubs),
        cmocka_unit_test(roller_rubs),
        cmocka_unit_test(tool_on_floor_sticks_then_slides),
        cmocka_unit_test(friction_rolls_stick_along),
        cmocka_unit_test(off_centre_push_rotates),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
