/* Needles of method VBLAST in jaws: one follows the first tool that has closed on it, exactly; another changes nothing until
 * that lets go. And when a solenoid is wanted. */
#include <vblast_ss/device.h>

#include "fixtures/baseline_of.h"
#include "scene/needles_rig.h"

#define MIDDLE (0.5 * 3.14159265358979323846 * 10.5e-3)

static void begin(needles_rig *r)
{
    needles_begin(r);
    r->tools.s.config.method = r->config.method = VBSS_METHOD_VBLAST;
    r->tools.s.config.capsule_capacity = 64;
    r->tools.config.jaw_speed = 1e3; /* closed in one step */
    r->tools.s.thread.method = VBSS_METHOD_VBLAST;
    baseline_of(&r->tools.s.thread.baseline)->thread_damping = 0.01;
    small_create(&r->tools.s);
}

/* Across tools whose tips are at z = -2 mm: its middle at the origin, its direction along y. */
static void begin_across(needles_rig *r)
{
    begin(r);
    needles_add_across(r, MIDDLE, vec3_zero());
}

static void close_jaws(needles_rig *r, uint32_t tool)
{
    tools_open(&r->tools, tool, 0.0);
    tools_steps(&r->tools, 1);
}

static pose tool_pose(const needles_rig *r, uint32_t tool)
{
    vbss_grasper_state s = tools_state(&r->tools, tool);
    return pose_make(vec3_load(s.position), quat_make(s.orientation[0], s.orientation[1],
                                                      s.orientation[2], s.orientation[3]));
}

/* Where the needle is to a tool. */
static pose offset(const needles_rig *r, uint32_t tool)
{
    return pose_mul(pose_inverse(tool_pose(r, tool)), needles_pose(r));
}

static void expect_same_pose(pose wanted, pose got)
{
    expect_near(0.0, vec3_distance(wanted.position, got.position), 1e-14);
    expect_near(1.0, fabs(quat_dot(wanted.orientation, got.orientation)), 1e-14);
}

/* A hand that does anything, about where it began. */
static void wander(needles_rig *r, uint32_t tool, vec3 home, uint32_t steps, uint64_t seed)
{
    vbss_random random;
    vbss_random_seed(&random, seed, 1);
    for (uint32_t i = 0; i < steps; i++) {
        double tip[3], turn[4];
        for (int k = 0; k < 3; k++) {
            turn[k] = 0.6 * vbss_random_uniform(&random) - 0.3;
            tip[k] = 5e-3 * (vbss_random_uniform(&random) - 0.5);
        }
        turn[3] = 1.0;
        vec3_store(tip, vec3_add(home, vec3_load(tip)));
        expect_ok(vbss_grasper_set_target(r->tools.tools[tool], tip, turn));
        tools_steps(&r->tools, 1);
    }
}

static void needle_follows_tool_exactly(void **state)
{
    (void)state;
    needles_rig r;
    vbss_scene_event event = {0};
    const vec3 home = vec3_make(0.0, 0.0, -2e-3);
    begin_across(&r);
    tools_add(&r.tools, home);
    close_jaws(&r, 0);
    assert_int_equal(tools_happened(&r.tools, VBSS_SCENE_EVENT_GRASP, &event), 1);
    assert_int_equal(event.body_a, r.body);
    assert_int_equal(event.body_b, r.tools.bodies[0]);
    expect_near(MIDDLE, event.arc_length, 1e-6);
    assert_int_equal(tools_state(&r.tools, 0).needle, r.body);
    assert_int_equal(tools_state(&r.tools, 0).grasp_count, 1);
    const pose held = offset(&r, 0);
    for (uint64_t i = 0; i < 200; i++) {
        wander(&r, 0, home, 1, i);
        expect_same_pose(held, offset(&r, 0));
    }
    vbss_scene_grasp grasp = tools_grasp(&r.tools, 0, 0);
    assert_int_equal(grasp.body, r.body);
    expect_near(MIDDLE, grasp.arc_length, 1e-9);
    vec3 there = needles_place(&r, grasp.arc_length, NULL);
    expect_near(0.0, vec3_distance(there, vec3_load(grasp.position)), 1e-15);
    needles_end(&r);
}

/* It neither moves the needle nor holds it; when the first lets go, the needle is its own from where it is. */
static void second_tool_waits_and_takes_over(void **state)
{
    (void)state;
    needles_rig r;
    vbss_scene_event event = {0};
    const vec3 home = vec3_make(0.0, 0.0, -2e-3);
    begin_across(&r);
    for (int k = 0; k < 3; k++) {
        tools_add(&r.tools, home);
    }
    close_jaws(&r, 2);
    const pose held = offset(&r, 2);
    close_jaws(&r, 1); /* in this order, against that of their numbers */
    close_jaws(&r, 0);
    assert_int_equal(tools_happened(&r.tools, VBSS_SCENE_EVENT_GRASP, &event), 0);
    for (uint32_t waiting = 0; waiting < 2; waiting++) {
        vbss_scene_grasp grasp;
        assert_int_equal(tools_state(&r.tools, waiting).needle, 0);
        assert_int_equal(tools_state(&r.tools, waiting).grasp_count, 0);
        expect_result(VBSS_ERROR_NOT_FOUND,
                      vbss_scene_get_grasp(r.tools.s.scene, r.tools.bodies[waiting], 0, &grasp,
                                           sizeof grasp));
        wander(&r, waiting, home, 40, waiting);
    }
    wander(&r, 2, home, 40, 7);
    expect_same_pose(held, offset(&r, 2));

    for (uint32_t next = 2; next-- > 0;) { /* 1, who has closed before 0 */
        const pose before = needles_pose(&r);
        tools_open(&r.tools, next + 1, 1.0);
        tools_steps(&r.tools, 1);
        assert_int_equal(tools_happened(&r.tools, VBSS_SCENE_EVENT_RELEASE, &event), 1);
        assert_int_equal(event.body_b, r.tools.bodies[next + 1]);
        assert_int_equal(tools_happened(&r.tools, VBSS_SCENE_EVENT_GRASP, &event), 1);
        assert_int_equal(event.body_b, r.tools.bodies[next]);
        assert_int_equal(tools_state(&r.tools, next).needle, r.body);
        expect_same_pose(before, needles_pose(&r));
        const pose taken = offset(&r, next);
        wander(&r, next, home, 40, next);
        expect_same_pose(taken, offset(&r, next));
    }
    needles_end(&r);
}

static void leaving_waiter_does_not_take_over(void **state)
{
    (void)state;
    needles_rig r;
    vbss_scene_event event;
    begin_across(&r);
    tools_add(&r.tools, vec3_make(0.0, 0.0, -2e-3));
    tools_add(&r.tools, vec3_make(0.0, 0.0, -2e-3));
    close_jaws(&r, 0);
    close_jaws(&r, 1);
    tools_open(&r.tools, 1, 1.0);
    tools_steps(&r.tools, 1);
    assert_int_equal(tools_happened(&r.tools, VBSS_SCENE_EVENT_RELEASE, &event), 0);
    tools_open(&r.tools, 0, 1.0);
    tools_steps(&r.tools, 1);
    assert_int_equal(tools_happened(&r.tools, VBSS_SCENE_EVENT_RELEASE, &event), 1);
    assert_int_equal(tools_happened(&r.tools, VBSS_SCENE_EVENT_GRASP, &event), 0);
    needles_end(&r);
}

/* Jaws along -z from a tip at the origin, 13 mm long, that open along x. */
typedef struct location {
    vec3 there;
    double turn; /* about z, from across the jaws */
    bool taken;
} place;

static void jaws_grasp_near_transverse_needle(void **state)
{
    (void)state;
    static const place places[] = {
        {{0.0, 0.0, 1e-3}, 0.0, true},     {{1.9e-3, 0.0, 6e-3}, 0.0, true},
        {{2.1e-3, 0.0, 6e-3}, 0.0, false}, {{0.0, 0.0, -1.9e-3}, 0.0, true},
        {{0.0, 0.0, -2.1e-3}, 0.0, false}, {{0.0, 0.0, 14.9e-3}, 0.0, true},
        {{0.0, 0.0, 15.1e-3}, 0.0, false}, {{0.0, 0.0, 5e-3}, 0.78, true},
        {{0.0, 0.0, 5e-3}, -0.78, true}};
    for (size_t k = 0; k < sizeof places / sizeof places[0]; k++) {
        needles_rig r;
        begin(&r);
        r.config.arc = 0.2; /* nearly straight */
        needles_add_across(&r, 0.1 * r.config.radius, places[k].there);
        tools_add(&r.tools, vec3_zero());
        const double turn[4] = {cos(0.5 * places[k].turn), 0.0, 0.0, sin(0.5 * places[k].turn)};
        expect_ok(
            vbss_grasper_set_target(r.tools.tools[0], (const double[3]){0.0, 0.0, 0.0}, turn));
        tools_steps(&r.tools, 1);
        close_jaws(&r, 0);
        assert_int_equal(tools_state(&r.tools, 0).needle != 0, places[k].taken);
        needles_end(&r);
    }
}

static void jaws_ignore_parallel_or_late_needle(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        needles_rig r;
        begin(&r);
        r.config.arc = 0.2;
        needles_add_across(&r, 0.1 * r.config.radius, vec3_make(0.0, 0.0, k == 0 ? 5e-3 : 40e-3));
        tools_add(&r.tools, vec3_zero());
        const double turn[4] = {cos(0.5), 0.0, 0.0, sin(0.5)}; /* a radian aside */
        expect_ok(vbss_grasper_set_target(r.tools.tools[0], (const double[3]){0.0, 0.0, 0.0},
                                          k == 0 ? turn : NULL));
        tools_steps(&r.tools, 1);
        close_jaws(&r, 0);
        tools_move_along(&r.tools, 0, vec3_zero(), vec3_make(0.0, 0.0, k == 0 ? 0.0 : 36e-3), 20);
        assert_int_equal(tools_state(&r.tools, 0).needle, 0);
        needles_end(&r);
    }
}

/* The thread is fixed to the swage, pulls at nothing, and is felt by the hand that has the needle. */
static void swaged_thread_follows_needle(void **state)
{
    (void)state;
    needles_rig r;
    uint32_t pin;
    const vec3 home = vec3_make(0.0, 0.0, -2e-3);
    begin_across(&r);
    vbss_needle_state n = needles_state(&r);
    vec3 swage = vec3_load(n.swage), out = vec3_load(n.swage_direction);
    r.tools.body =
        small_thread(&r.tools.s, swage, vec3_add_scaled(swage, 0.03, out), 15, &r.tools.thread);
    expect_ok(vbss_scene_pin_thread(r.tools.s.scene, r.tools.body, 0, r.body, NULL, &pin));
    small_pin(&r.tools.s, r.tools.body, 15, 0);
    tools_add(&r.tools, home);
    close_jaws(&r, 0);
    const pose held = offset(&r, 0);
    for (uint64_t i = 0; i < 100; i++) {
        wander(&r, 0, home, 1, i);
        n = needles_state(&r);
        expect_near(0.0, vec3_distance(vec3_load(n.swage), tools_node(&r.tools, 0)), 1e-15);
    }
    tools_move_along(&r.tools, 0, home, vec3_make(2e-3, 0.0, -2e-3), 200);
    expect_same_pose(held, offset(&r, 0)); /* no load moves it */
    double length = 0.0;
    for (uint32_t i = 0; i < 15; i++) {
        length += vec3_distance(tools_node(&r.tools, i), tools_node(&r.tools, i + 1));
    }
    vec3 chord = vec3_sub(tools_node(&r.tools, 15), tools_node(&r.tools, 0));
    vec3 wanted = vec3_scale(chord, baseline_of(&r.tools.config.baseline)->grasper_stiffness *
                                        (length - 0.03) / vec3_norm(chord));
    assert_true(length > 0.0301);
    expect_near(0.0, vec3_distance(wanted, tools_hand_force(&r.tools, 0)), 1e-9);
    needles_end(&r);
}

/* Of a handle: opening, steps, and whether the solenoid is on after each of them. */
typedef struct stretch {
    double opening;
    uint32_t steps, wanted;
} stretch;

static void solenoid_follows_grasp(void **state)
{
    (void)state;
    static const stretch script[] = {{1.0, 20, 0}, {0.21, 20, 0}, {0.1, 20, 1}, {0.21, 20, 1},
                                     {0.5, 20, 0}, {0.0, 20, 1},  {1.0, 20, 0}};
    for (int with = 0; with < 2; with++) {
        needles_rig r;
        vbss_output_config c;
        vbss_output *output;
        vbss_output_statistics reported;
        begin(&r);
        if (with == 1) {
            needles_add_across(&r, MIDDLE, vec3_zero());
        }
        tools_add(&r.tools, vec3_make(0.0, 0.0, -2e-3));
        expect_ok(vbss_output_config_init(&c, sizeof c));
        expect_ok(vbss_output_create(r.tools.s.context, &c, &output));
        for (size_t k = 0; k < sizeof script / sizeof script[0]; k++) {
            tools_open(&r.tools, 0, script[k].opening);
            for (uint32_t i = 0; i < script[k].steps; i++) {
                vbss_output_command command;
                vbss_output_result result;
                tools_steps(&r.tools, 1);
                expect_ok(vbss_output_command_init(&command, sizeof command));
                command.solenoid = tools_state(&r.tools, 0).solenoid;
                expect_ok(vbss_output_step(output, 1e-3, &command, &result, sizeof result));
                assert_int_equal(result.solenoid, with == 1 ? script[k].wanted : 0);
            }
        }
        expect_ok(vbss_output_get_statistics(output, &reported, sizeof reported));
        assert_int_equal(reported.pulses, with == 1 ? 2 : 0);
        expect_ok(vbss_output_destroy(output));
        needles_end(&r);
    }
}

int test_paper_needles(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(needle_follows_tool_exactly),
        harness_test(second_tool_waits_and_takes_over),
        harness_test(leaving_waiter_does_not_take_over),
        harness_test(jaws_grasp_near_transverse_needle),
        harness_test(jaws_ignore_parallel_or_late_needle),
        harness_test(swaged_thread_follows_needle),
        harness_test(solenoid_follows_grasp),
    };
    return cmocka_run_group_tests_name("scene.paper_needles", tests, NULL, NULL);
}
