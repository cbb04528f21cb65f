/* Jaws that take a thread, hold it, and give it back: by contact from both sides, over a short length, in
 * position and direction. */
#include "scene/tools_rig.h"

static const vec3 home = {0.0, 0.0, -2e-3}; /* of the tip: the thread lies 2 mm up the jaws */

/* The angle at which jaws touch a thread of that radius from both sides, 2 mm up from the tip. */
static double touching_angle(const tools_rig *r)
{
    return asin(r->s.thread.radius / (r->config.driver_length - 2e-3));
}

/* ---- taking */

static void jaws_grasp_on_contact_from_both_sides(void **state)
{
    (void)state;
    tools_rig r;
    vbss_scene_event event = {0};
    uint32_t begun = 0;
    tools_begin_scene(&r);
    tools_thread(&r, TOOLS_NEITHER, 3e-4);
    tools_add(&r, home);
    tools_open(&r, 0, 0.0);
    for (uint32_t i = 1; i <= 100; i++) {
        vec3 before = tools_node(&r, 30);
        tools_steps(&r, 1);
        vec3 now = tools_node(&r, 30);
        bool touched = small_statistics(&r.s).contacts > 0;
        if (tools_happened(&r, VBSS_SCENE_EVENT_GRASP, &event) > 0) {
            assert_int_equal(begun, 0);
            begun = i;
            assert_int_equal(event.body_a, r.body);
            assert_int_equal(event.body_b, r.bodies[0]);
            expect_near(0.015, event.arc_length, 2e-6);
        }
        if (begun == 0 && !touched) { /* nothing draws it to the jaws */
            expect_near(0.0, vec3_distance(before, now), 1e-6);
        }
        expect_near(0.0, vec3_distance(before, now), 0.11e-3); /* nor faster than jaws move */
    }
    assert_true(begun > 0);
    vbss_grasper_state tool = tools_state(&r, 0);
    assert_int_equal(tool.grasp_count, 1);
    expect_near(touching_angle(&r), tool.jaw_angle, 1e-4);
    expect_near(r.config.closing_force, tool.pressure, 1e-12);
    vbss_scene_grasp grasp = tools_grasp(&r, 0, 0);
    assert_int_equal(grasp.body, r.body);
    expect_near(2.0 * r.config.grip_friction * r.config.closing_force, grasp.limit, 1e-12);
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_scene_get_grasp(r.s.scene, r.bodies[0], 1, &grasp, sizeof grasp));
    tools_end(&r);
}

/* Beyond the tip, beside the faces, behind a jaw: all within a millimetre of jaws that close. */
static void jaws_ignore_near_thread(void **state)
{
    (void)state;
    const vec3 tips[] = {{0.0, 0.0, 0.9e-3}, {0.0, 0.0158, -2e-3}, {-5.7e-3, 0.0, -2e-3}};
    for (int k = 0; k < 3; k++) {
        tools_rig r;
        vbss_scene_event event;
        tools_begin_scene(&r);
        tools_thread(&r, TOOLS_NEITHER, 0.0);
        tools_add(&r, tips[k]);
        vec3 before = tools_node(&r, 30);
        tools_open(&r, 0, 0.0);
        for (uint32_t i = 0; i < 100; i++) {
            tools_steps(&r, 1);
            assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_GRASP, &event), 0);
        }
        assert_int_equal(tools_state(&r, 0).grasp_count, 0);
        expect_near(0.0, tools_state(&r, 0).jaw_angle, 0.0);
        expect_near(0.0, vec3_distance(before, tools_node(&r, 30)), 1e-12);
        tools_end(&r);
    }
}

/* ---- holding */

/* A thread as stiff as a rod sticks 10 mm out of the jaws and is pulled aside: the clamp gives way by K, and, as
 * its springs are half a grip s from the middle, turns by 2/3 K s^2. */
static void grasp_keeps_thread_direction(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin(&r);
    r.s.thread.bending_stiffness = 1e-4;
    r.s.thread.axial_stiffness = 4000.0;
    r.s.thread.damping = 50.0;
    r.s.thread.drag = 50.0;
    r.config.stiffness = r.config.turning_stiffness = 1e7; /* a tool that stays */
    small_create(&r.s);
    tools_thread(&r, TOOLS_NEITHER, 0.0);
    tools_add(&r, vec3_make(0.0, 5e-3, -2e-3));
    tools_close(&r, 0);
    const double force = 1e-4, length = 10e-3, k = r.config.grip_stiffness;
    const double s = 0.5 * r.config.grip_length;
    double turn = force * length / (2.0 / 3.0 * k * s * s);
    double bent = force * length * length * length / (3.0 * 1e-4);
    double wanted = force / k + turn * length; /* and across the faces 64 times less */
    for (int axis = 0; axis < 3; axis += 2) {
        vbss_thread_attachment a;
        uint32_t id;
        expect_ok(vbss_thread_attachment_init(&a, sizeof a));
        a.kind = VBSS_THREAD_ATTACHMENT_FORCE;
        a.node = TOOLS_NODES - 1;
        a.force[axis] = force;
        vec3 before = tools_node(&r, TOOLS_NODES - 1);
        expect_ok(vbss_thread_attach(r.thread, &a, &id));
        tools_steps(&r, 2000);
        vec3 moved = vec3_sub(tools_node(&r, TOOLS_NODES - 1), before);
        if (axis == 0) {
            expect_near(wanted / 64.0 + bent, moved.x, 0.1 * bent);
        } else {
            expect_near(wanted + bent, moved.z, 0.02 * wanted);
        }
        expect_ok(vbss_thread_detach(r.thread, id));
        tools_steps(&r, 2000);
        expect_near(0.0, vec3_distance(before, tools_node(&r, TOOLS_NODES - 1)), 1e-7);
    }
    tools_end(&r);
}

/* At rest what the hand bears is what holds the thread's ends. */
static void hand_feels_grasped_thread(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin_scene(&r);
    tools_thread(&r, TOOLS_BOTH, 0.0);
    tools_add(&r, home);
    tools_close(&r, 0);
    vec3 aside = vec3_make(0.4e-3, 1e-3, -5e-3);
    tools_move_along(&r, 0, home, aside, 300);
    tools_steps(&r, 1500);
    vec3 hand = tools_hand_force(&r, 0);
    vec3 pins = vec3_add(tools_pin_force(&r, 0), tools_pin_force(&r, 1));
    vbss_scene_grasp grasp = tools_grasp(&r, 0, 0);
    vbss_scene_rigid_state body = small_rigid(&r.s, r.bodies[0]);
    assert_true(vec3_norm(hand) > 0.5);
    expect_near(0.0, vec3_norm(vec3_add(pins, vec3_load(grasp.force))), 1e-6);
    expect_near(0.0, vec3_distance(hand, vec3_load(body.contact_force)), 1e-6);
    expect_near(0.0, vec3_norm(vec3_add(hand, vec3_load(grasp.force))), 1e-6);
    expect_near(0.0, vec3_norm(vec3_sub(hand, pins)), 1e-6);
    expect_near(0.0, grasp.slid, 0.0);
    /* About the tip: of the force where the thread is held, and of what its direction bears. */
    vec3 arm = vec3_sub(vec3_load(grasp.position), vec3_load(tools_state(&r, 0).position));
    vbss_grasper_state tool = tools_state(&r, 0);
    vec3 torque = vec3_sub(vec3_load(tool.hand_torque), vec3_cross(arm, hand));
    assert_true(vec3_norm(torque) < 0.5 * grasp.limit * 0.5 * r.config.grip_length);
    tools_end(&r);
}

/* Ten seconds at 2 N. */
static void grasp_does_not_creep(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin_scene(&r);
    tools_thread(&r, TOOLS_BOTH, 0.0);
    tools_add(&r, home);
    tools_close(&r, 0);
    double z = home.z;
    while (vec3_norm(tools_hand_force(&r, 0)) < 2.0) {
        z -= 1e-5;
        tools_move(&r, 0, vec3_make(0.0, 0.0, z));
        tools_steps(&r, 1);
    }
    tools_steps(&r, 2000);
    vbss_scene_grasp before = tools_grasp(&r, 0, 0);
    vec3 hand = tools_hand_force(&r, 0);
    tools_steps(&r, 10000);
    vbss_scene_grasp after = tools_grasp(&r, 0, 0);
    expect_same_bits(before.arc_length, after.arc_length);
    expect_near(0.0, vec3_distance(vec3_load(before.position), vec3_load(after.position)), 1e-9);
    expect_near(0.0, vec3_distance(hand, tools_hand_force(&r, 0)), 1e-9);
    tools_end(&r);
}

/* ---- giving back */

/* Same length, same place of the thread, no jump: where it is at the end of the step and how fast follows from
 * the forces that held it. */
static void released_thread_is_unchanged(void **state)
{
    (void)state;
    tools_rig r;
    vbss_scene_event taken = {0}, released = {0};
    tools_begin_scene(&r);
    tools_thread(&r, TOOLS_BOTH, 2e-4);
    double length = tools_length(&r);
    tools_add(&r, home);
    tools_open(&r, 0, 0.0);
    for (int i = 0; i < 60; i++) {
        vbss_scene_event event;
        tools_steps(&r, 1);
        if (tools_happened(&r, VBSS_SCENE_EVENT_GRASP, &event) > 0) {
            taken = event;
        }
    }
    tools_steps(&r, 300);
    tools_move_along(&r, 0, home, vec3_make(0.0, 1e-3, -2e-3), 300);
    tools_steps(&r, 300);
    double held = tools_grasp(&r, 0, 0).arc_length;
    vec3 before[TOOLS_NODES];
    for (uint32_t i = 0; i < TOOLS_NODES; i++) {
        before[i] = tools_node(&r, i);
    }
    uint64_t hash = small_hash(&r.s);
    tools_open(&r, 0, 1.0); /* said, not done */
    assert_true(hash != small_hash(&r.s));
    for (uint32_t i = 0; i < TOOLS_NODES; i++) {
        expect_near(0.0, vec3_distance(before[i], tools_node(&r, i)), 0.0);
    }
    vec3 force = vec3_load(tools_grasp(&r, 0, 0).force);
    const double h = 1e-6; /* so short that only what is not force shows */
    expect_ok(vbss_scene_step(r.s.scene, h));
    assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_RELEASE, &released), 1);
    expect_near(taken.arc_length, released.arc_length, 1e-6);
    expect_near(held, released.arc_length, 1e-6);
    double node = 5e-4 * r.s.thread.linear_density;
    double speed = h * vec3_norm(force) / node;
    assert_true(vec3_norm(force) > 0.1);
    for (uint32_t i = 0; i < TOOLS_NODES; i++) {
        expect_near(0.0, vec3_distance(before[i], tools_node(&r, i)), h * speed + 1e-9);
        expect_near(0.0, vec3_norm(tools_node_velocity(&r, i)), speed + 1e-6);
    }
    expect_same_bits(length, tools_length(&r));
    assert_int_equal(tools_state(&r, 0).grasp_count, 0);
    expect_near(0.0, tools_state(&r, 0).pressure, 0.0);
    tools_end(&r);
}

/* What was held without force lies on as it did. */
static void release_does_not_disturb_resting_thread(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin_scene(&r);
    r.s.thread.damping = 50.0;
    r.s.thread.drag = 20.0;
    tools_thread(&r, TOOLS_NEITHER, 0.0);
    tools_add(&r, home);
    tools_close(&r, 0);
    tools_steps(&r, 1000);
    vec3 before[TOOLS_NODES];
    for (uint32_t i = 0; i < TOOLS_NODES; i++) {
        before[i] = tools_node(&r, i);
    }
    tools_open(&r, 0, 1.0);
    tools_steps(&r, 200);
    for (uint32_t i = 0; i < TOOLS_NODES; i++) {
        expect_near(0.0, vec3_distance(before[i], tools_node(&r, i)), 1e-6);
    }
    tools_end(&r);
}

int test_grasps(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(jaws_grasp_on_contact_from_both_sides),
        cmocka_unit_test(jaws_ignore_near_thread),
        cmocka_unit_test(grasp_keeps_thread_direction),
        cmocka_unit_test(hand_feels_grasped_thread),
        cmocka_unit_test(grasp_does_not_creep),
        cmocka_unit_test(released_thread_is_unchanged),
        cmocka_unit_test(release_does_not_disturb_resting_thread),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
