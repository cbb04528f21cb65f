/* Jaws that take a needle, hold it as it was turned, let it slide and turn where that is too much for them, hand it over. */
#include "scene/needles_rig.h"

/* ---- taking */

static void jaws_grasp_needle_in_place(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        needles_rig r;
        vbss_scene_event event = {0};
        uint32_t begun = 0;
        needles_begin_scene(&r);
        double arc = (0.25 + 0.25 * k) * r.config.arc * r.config.radius;
        needles_add_across(&r, arc, vec3_make(2e-4 * k, 0.0, 0.0));
        tools_add(&r.tools, vec3_make(0.0, 0.0, -2e-3));
        pose before = pose_mul(pose_inverse(needles_jaws(&r, 0)), needles_pose(&r));
        tools_open(&r.tools, 0, 0.0);
        for (uint32_t i = 0; i < 300; i++) {
            tools_steps(&r.tools, 1);
            begun += tools_happened(&r.tools, VBSS_SCENE_EVENT_GRASP, &event);
        }
        assert_int_equal(begun, 1);
        assert_int_equal(event.body_a, r.body);
        assert_int_equal(event.body_b, r.tools.bodies[0]);
        expect_near(arc, event.arc_length, 300e-6); /* a jaw may have pushed it before */
        pose after = pose_mul(pose_inverse(needles_jaws(&r, 0)), needles_pose(&r));
        double turned = fabs(quat_dot(before.orientation, after.orientation));
        expect_near(1.0, turned, 1e-4);
        vbss_grasper_state tool = tools_state(&r.tools, 0);
        assert_int_equal(tool.grasp_count, 1);
        expect_near(r.tools.config.closing_force, tool.pressure, 1e-12);
        vbss_scene_grasp grasp = tools_grasp(&r.tools, 0, 0);
        assert_int_equal(grasp.body, r.body);
        vec3 held = pose_apply_inverse(needles_jaws(&r, 0), vec3_load(grasp.position));
        expect_near(0.0, held.x, 1e-7); /* it has come to the middle */
        expect_near(-r.tools.config.driver_length + 2e-3, held.z, 1e-4);
        assert_int_equal(small_statistics(&r.tools.s).clamped, 0);
        needles_end(&r);
    }
}

static void jaws_ignore_near_needle(void **state)
{
    (void)state;
    const vec3 tips[] = {{0.0, 0.0, 1.5e-3}, {0.0, 30e-3, -2e-3}};
    for (int k = 0; k < 2; k++) {
        needles_rig r;
        vbss_scene_event event;
        needles_begin_scene(&r);
        needles_add_across(&r, 10e-3, vec3_zero());
        tools_add(&r.tools, tips[k]);
        tools_open(&r.tools, 0, 0.0);
        for (uint32_t i = 0; i < 100; i++) {
            tools_steps(&r.tools, 1);
            assert_int_equal(tools_happened(&r.tools, VBSS_SCENE_EVENT_GRASP, &event), 0);
        }
        expect_near(0.0, tools_state(&r.tools, 0).jaw_angle, 0.0);
        needles_end(&r);
    }
}

/* ---- holding */

/* It weighs as much as its friction bears, or all but; about its middle of mass the clamp bears all. */
static void hold_with_weight(needles_rig *r, vec3 gravity)
{
    needles_begin_scene(r);
    r->tools.config.stiffness = r->tools.config.turning_stiffness = 1e7; /* a tool that stays */
    vec3_store(r->config.gravity, gravity);
    r->tools.config.needle_torque = 100.0;
}

static void grasp_carries_weight(void **state)
{
    (void)state;
    needles_rig r;
    hold_with_weight(&r, vec3_make(0.0, -9.81, 0.0));
    r.config.drag = 5.0;
    needles_hold(&r);
    tools_steps(&r.tools, 1000);
    vbss_scene_grasp grasp = tools_grasp(&r.tools, 0, 0);
    double weight = 9.81 * needles_mass(&r).mass;
    expect_near(weight, grasp.force[1], 1e-6 * weight);
    expect_near(0.0, grasp.force[0], 1e-6 * weight);
    expect_near(0.0, grasp.force[2], 1e-6 * weight);
    vec3 before = vec3_load(needles_state(&r).tip);
    tools_steps(&r.tools, 1000);
    expect_near(0.0, vec3_distance(before, vec3_load(needles_state(&r).tip)), 1e-9);
    expect_near(0.0, tools_grasp(&r.tools, 0, 0).slid, 0.0);
    needles_end(&r);
}

/* By forces of 0.9 and 1.1 times the friction of both faces. */
static void needle_slides_above_friction_of_both_faces(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        needles_rig r;
        vbss_scene_event event;
        uint32_t slips = 0, torn = 0;
        needles_begin_scene(&r);
        r.tools.config.stiffness = r.tools.config.turning_stiffness = 1e7;
        r.tools.config.needle_torque = 100.0;
        vbss_needle_config c = r.config;
        vbss_needle *other;
        expect_ok(vbss_needle_create(r.tools.s.context, &c, &other)); /* to weigh it */
        vbss_needle_mass mass;
        expect_ok(vbss_needle_get_mass(other, &mass, sizeof mass));
        double limit = 2.0 * r.tools.config.grip_friction * r.tools.config.closing_force;
        double gravity = (k == 0 ? 0.9 : 1.1) * limit / mass.mass;
        needles_hold(&r);
        /* Weight comes when it is held. */
        scene_body *b = vbss_scene_body(small_object(&r.tools.s), r.body);
        double middle = 0.5 * r.config.arc * r.config.radius;
        vec3 before = needles_place(&r, middle, NULL);
        for (uint32_t i = 0; i < 200; i++) {
            b->rigid.body.gravity = vec3_make(0.0, 0.0, -gravity * vbss_min(1.0, (i + 1) / 20.0));
            tools_steps(&r.tools, 1);
            slips += tools_happened(&r.tools, VBSS_SCENE_EVENT_SLIP, &event);
            torn += tools_happened(&r.tools, VBSS_SCENE_EVENT_TORN, &event);
        }
        double fallen = before.z - needles_place(&r, middle, NULL).z;
        if (k == 0) {
            assert_int_equal(slips + torn, 0);
            assert_true(fallen < 1e-3);
        } else {
            assert_int_equal(slips, 1);
            assert_int_equal(torn, 1); /* out over the end of the jaws */
            assert_true(fallen > 3e-3);
            assert_int_equal(tools_state(&r.tools, 0).grasp_count, 0);
        }
        expect_ok(vbss_needle_destroy(other));
        needles_end(&r);
    }
}

/* A torque about the normal of the faces: weight at the middle of mass, which is aside of where it is held. */
static void needle_turns_above_torque_limit(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        needles_rig r;
        vbss_scene_event event;
        uint32_t slips = 0;
        needles_begin_scene(&r);
        r.tools.config.stiffness = r.tools.config.turning_stiffness = 1e7;
        r.tools.config.grip_friction = 10.0;
        needles_hold(&r);
        scene_body *b = vbss_scene_body(small_object(&r.tools.s), r.body);
        vec3 held = vec3_load(tools_grasp(&r.tools, 0, 0).position);
        vec3 arm = vec3_sub(b->rigid.body.now.pose.position, held); /* along x */
        double torque = (k == 0 ? 0.9 : 1.3) * r.tools.config.needle_torque;
        double weight = torque / vec3_norm(arm);
        quat before = needles_pose(&r).orientation;
        for (uint32_t i = 0; i < 40; i++) {
            double share = vbss_min(1.0, (i + 1) / 20.0);
            b->rigid.body.gravity = vec3_make(0.0, -share * weight / b->rigid.body.mass, 0.0);
            tools_steps(&r.tools, 1);
            slips += tools_happened(&r.tools, VBSS_SCENE_EVENT_SLIP, &event);
        }
        double cosine = fabs(quat_dot(before, needles_pose(&r).orientation));
        if (k == 0) {
            assert_int_equal(slips, 0);
            assert_true(cosine > 0.99); /* the clamp gives way by 0.05 to 0.1 */
        } else {
            assert_true(slips > 0 && cosine < 0.98);
        }
        needles_end(&r);
    }
}

/* ---- moving */

static void needle_follows_tool_rigidly(void **state)
{
    (void)state;
    needles_rig r;
    needles_begin_scene(&r);
    needles_hold(&r);
    pose before = pose_mul(pose_inverse(needles_jaws(&r, 0)), needles_pose(&r));
    for (uint32_t i = 1; i <= 500; i++) {
        double turn = 0.5 * i / 500.0, to[3] = {20e-3 * i / 500.0, 0.0, -2e-3 + 10e-3 * i / 500.0};
        const double orientation[4] = {cos(turn), 0.0, 0.0, sin(turn)};
        expect_ok(vbss_grasper_set_target(r.tools.tools[0], to, orientation));
        tools_steps(&r.tools, 1);
    }
    tools_steps(&r.tools, 500);
    pose after = pose_mul(pose_inverse(needles_jaws(&r, 0)), needles_pose(&r));
    expect_near(0.0, vec3_distance(before.position, after.position), 1e-6);
    expect_near(1.0, fabs(quat_dot(before.orientation, after.orientation)), 1e-9);
    expect_near(20e-3, tools_state(&r.tools, 0).position[0], 1e-5);
    expect_near(0.0, tools_grasp(&r.tools, 0, 0).slid, 0.0);
    needles_end(&r);
}

/* ---- two tools */

/* The second comes from the other side, along -z, and takes it nearer to its tip. */
static void second_hand(needles_rig *r)
{
    const double back[4] = {0.0, 1.0, 0.0, 0.0}; /* half a turn about x */
    double quarter = 0.25 * r->config.arc * r->config.radius;
    vec3 tangent, at = needles_place(r, quarter, &tangent);
    /* Its jaws open along what is across the needle there. */
    double half = 0.5 * atan2(tangent.y, tangent.x) - 0.78539816339744831;
    quat roll = quat_make(cos(half), 0.0, 0.0, sin(half));
    quat turn = quat_mul(roll, quat_make(back[0], back[1], back[2], back[3]));
    vec3 tip = vec3_add(at, vec3_make(0.0, 0.0, 2e-3));
    tools_close(&r->tools, tools_add_turned(&r->tools, tip, turn));
}

static void two_tools_share_load(void **state)
{
    (void)state;
    needles_rig r;
    needles_begin_scene(&r);
    r.config.drag = 5.0;
    needles_hold(&r);
    second_hand(&r);
    scene_body *b = vbss_scene_body(small_object(&r.tools.s), r.body);
    b->rigid.body.gravity = vec3_make(0.0, -1000.0, 0.0); /* 0.1 N */
    tools_steps(&r.tools, 1000);
    vbss_scene_grasp one = tools_grasp(&r.tools, 0, 0), other = tools_grasp(&r.tools, 1, 0);
    double weight = 1000.0 * needles_mass(&r).mass;
    expect_near(weight, one.force[1] + other.force[1], 1e-4 * weight);
    assert_true(fabs(other.force[1]) > 0.0);
    needles_end(&r);
}

static void needle_is_handed_over(void **state)
{
    (void)state;
    needles_rig r;
    vbss_scene_event event;
    uint32_t let_go = 0;
    needles_begin_scene(&r);
    r.config.gravity[1] = -9.81;
    needles_hold(&r);
    second_hand(&r);
    vec3 before = vec3_load(needles_state(&r).tip);
    tools_open(&r.tools, 0, 1.0);
    for (uint32_t i = 0; i < 300; i++) {
        tools_steps(&r.tools, 1);
        let_go += tools_happened(&r.tools, VBSS_SCENE_EVENT_RELEASE, &event);
    }
    assert_int_equal(let_go, 1);
    assert_int_equal(event.body_a, r.body);
    assert_int_equal(event.body_b, r.tools.bodies[0]);
    assert_int_equal(tools_state(&r.tools, 0).grasp_count, 0);
    assert_int_equal(tools_state(&r.tools, 1).grasp_count, 1);
    expect_near(0.0, vec3_distance(before, vec3_load(needles_state(&r).tip)), 0.2e-3);
    tools_open(&r.tools, 1, 1.0);
    tools_steps(&r.tools, 300);
    assert_true(needles_state(&r).tip[1] < before.y - 0.1); /* nobody holds it any more */
    needles_end(&r);
}

/* Each pulls with more than the clamp bears: one slides, and nothing is lost or thrown. */
static void opposing_tools_slip_without_loss(void **state)
{
    (void)state;
    needles_rig r;
    needles_begin_scene(&r);
    r.tools.config.stiffness = 2000.0;
    r.tools.config.damping = 10.0;
    needles_hold(&r);
    second_hand(&r);
    vec3 first = vec3_make(0.0, 0.0, -2e-3);
    for (uint32_t i = 1; i <= 400; i++) {
        tools_move(&r.tools, 0, vec3_add(first, vec3_make(-30e-3 * i / 400.0, 0.0, 0.0)));
        tools_steps(&r.tools, 1);
        vbss_needle_state s = needles_state(&r);
        assert_true(vec3_norm(vec3_load(s.velocity)) < 5.0);
    }
    uint32_t held = tools_state(&r.tools, 0).grasp_count + tools_state(&r.tools, 1).grasp_count;
    assert_true(held <= 1);
    assert_int_equal(small_statistics(&r.tools.s).clamped, 0);
    needles_end(&r);
}

int test_needle_grasp(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(jaws_grasp_needle_in_place),
        harness_test(jaws_ignore_near_needle),
        harness_test(grasp_carries_weight),
        harness_test(needle_slides_above_friction_of_both_faces),
        harness_test(needle_turns_above_torque_limit),
        harness_test(needle_follows_tool_rigidly),
        harness_test(two_tools_share_load),
        harness_test(needle_is_handed_over),
        harness_test(opposing_tools_slip_without_loss),
    };
    return cmocka_run_group_tests_name("scene.needle_grasp", tests, NULL, NULL);
}
