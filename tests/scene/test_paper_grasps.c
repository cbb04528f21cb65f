/* Grasping by method VBLAST: jaws that close near a node carry it exactly, and the first tool that has it leads. */
#include <stdlib.h>

#include "fixtures/baseline_of.h"
#include "scene/tools_rig.h"

static void begin(tools_rig *r, tools_ends ends)
{
    tools_begin(r);
    r->s.config.method = VBSS_METHOD_VBLAST;
    r->s.thread.bending_stiffness *= 0.1; /* a soft thread takes a third of the explicit steps */
    r->s.config.candidate_capacity = 16384;
    small_create(&r->s);
    baseline_of(&r->s.thread.baseline)->thread_damping = 0.01;
    tools_thread(r, ends, 0.0);
}

/* Closes and waits for what that brings; true: it has taken something then. */
static bool close_jaws(tools_rig *r, uint32_t tool, vbss_scene_event *event)
{
    uint32_t taken = 0;
    tools_open(r, tool, 0.0);
    for (int i = 0; i < 60; i++) {
        vbss_scene_event last;
        tools_steps(r, 1);
        if (tools_happened(r, VBSS_SCENE_EVENT_GRASP, &last) > 0) {
            taken++;
            *event = last;
        }
    }
    return taken == 1;
}

static void closed_jaws_carry_nearest_node(void **state)
{
    (void)state;
    tools_rig r;
    vbss_scene_event event = {0}, released = {0};
    begin(&r, TOOLS_FIRST);
    tools_add(&r, vec3_make(0.0, 5.1e-3, -0.5e-3));
    assert_true(close_jaws(&r, 0, &event));
    assert_int_equal(event.body_a, r.body);
    assert_int_equal(event.body_b, r.bodies[0]);
    assert_int_equal(tools_state(&r, 0).grasp_count, 1);
    uint32_t node = (uint32_t)(event.arc_length / 500e-6 + 0.5);
    vbss_scene_grasp grasp = tools_grasp(&r, 0, 0);
    expect_near(5e-4 * node, grasp.arc_length, 1e-12);
    vec3 tip = vec3_make(0.0, 5.1e-3, -0.5e-3);
    vec3 arm = vec3_sub(tools_node(&r, node), tip);
    for (int i = 1; i <= 200; i++) { /* whatever else acts on it */
        tip = vec3_make(1e-5 * i, 5.1e-3 - 1e-5 * i, -0.5e-3 + 2e-6 * i);
        tools_move(&r, 0, tip);
        tools_steps(&r, 1);
        expect_near(0.0, vec3_distance(vec3_add(tip, arm), tools_node(&r, node)), 1e-12);
    }
    expect_near(0.0, vec3_distance(vec3_load(tools_grasp(&r, 0, 0).position), tools_node(&r, node)),
                0.0);
    vec3 before = tools_node(&r, node);
    tools_open(&r, 0, 1.0);
    tools_steps(&r, 1);
    assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_RELEASE, &released), 1);
    assert_true(released.arc_length == event.arc_length);
    expect_near(0.0, vec3_distance(before, tools_node(&r, node)), 1e-12); /* it goes from here */
    assert_int_equal(tools_state(&r, 0).grasp_count, 0);
    tools_end(&r);
}

static void jaws_ignore_nodes_beyond_reach(void **state)
{
    (void)state;
    const vec3 tips[] = {{0.0, 0.0, 2.2e-3}, {0.0, 0.0176, 0.0}, {6e-3, 0.0, -1e-3}};
    for (int k = 0; k < 3; k++) {
        tools_rig r;
        vbss_scene_event event;
        begin(&r, TOOLS_BOTH);
        tools_add(&r, tips[k]);
        assert_false(close_jaws(&r, 0, &event));
        assert_int_equal(tools_state(&r, 0).grasp_count, 0);
        /* Nor when closed jaws come near: only closing takes. */
        tools_move_along(&r, 0, tips[k], vec3_scale(tips[k], 0.3), 50);
        assert_int_equal(tools_state(&r, 0).grasp_count, 0);
        tools_end(&r);
    }
}

/* The second changes nothing until the first lets go. */
static void first_tool_leads_and_second_takes_over(void **state)
{
    (void)state;
    tools_rig r;
    vbss_scene_event event = {0}, taken = {0};
    begin(&r, TOOLS_BOTH);
    baseline_of(&r.config.baseline)->grasper_distance = 0.1;
    tools_add(&r, vec3_make(0.0, 0.0, -3e-3));
    tools_add(&r, vec3_make(0.0, 0.0, 20e-3));
    assert_true(close_jaws(&r, 0, &event));
    vec3 first = tools_node(&r, 30);
    (void)close_jaws(&r, 1, &event);
    assert_int_equal(tools_state(&r, 1).grasp_count, 0);
    tools_move_along(&r, 1, vec3_make(0.0, 0.0, 20e-3), vec3_make(2e-3, 0.0, 22e-3), 100);
    expect_near(0.0, vec3_distance(first, tools_node(&r, 30)), 1e-12);
    tools_open(&r, 0, 1.0);
    tools_steps(&r, 1);
    assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_RELEASE, &event), 1);
    assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_GRASP, &taken), 1);
    assert_int_equal(taken.body_b, r.bodies[1]);
    assert_true(taken.arc_length == event.arc_length);
    expect_near(0.0, vec3_distance(first, tools_node(&r, 30)), 1e-12);
    assert_int_equal(tools_state(&r, 0).grasp_count, 0);
    assert_int_equal(tools_state(&r, 1).grasp_count, 1);
    tools_end(&r);
}

/* What it waits for is not its own, and shears do not wait. */
static void waiting_tool_holds_nothing(void **state)
{
    (void)state;
    tools_rig r;
    vbss_scene_event event = {0};
    vbss_scene_grasp grasp;
    begin(&r, TOOLS_BOTH);
    baseline_of(&r.config.baseline)->grasper_distance = 0.1;
    tools_add(&r, vec3_make(0.0, 0.0, -3e-3));
    tools_add(&r, vec3_make(0.0, 0.0, 20e-3));
    assert_true(close_jaws(&r, 0, &event));
    assert_false(close_jaws(&r, 1, &event));
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_scene_get_grasp(r.s.scene, r.bodies[1], 0, &grasp, sizeof grasp));
    expect_ok(vbss_grasper_exchange(r.tools[1], VBSS_GRASPER_KIND_SHEARS));
    tools_steps(&r, 1);
    assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_EXCHANGED, &event), 1);
    tools_open(&r, 0, 1.0);
    tools_steps(&r, 1);
    assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_RELEASE, &event), 1);
    assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_GRASP, &event), 0);
    tools_open(&r, 1, 1.0);
    tools_steps(&r, 1);
    assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_RELEASE, &event), 0);
    tools_end(&r);
}

/* k_s (stretched length - length) of both sections beside the node. */
static void hand_feels_section_stretch(void **state)
{
    (void)state;
    tools_rig r;
    vbss_scene_event event = {0};
    begin(&r, TOOLS_BOTH);
    tools_add(&r, vec3_make(0.0, 0.0, -0.5e-3));
    assert_true(close_jaws(&r, 0, &event));
    uint32_t node = (uint32_t)(event.arc_length / 500e-6 + 0.5);
    expect_near(0.0, vec3_norm(tools_hand_force(&r, 0)), 0.02);
    tools_move_along(&r, 0, vec3_make(0.0, 0.0, -0.5e-3), vec3_make(3e-3, 1e-3, -0.5e-3), 200);
    vec3 wanted = vec3_zero();
    for (uint32_t side = 0; side < 2; side++) {
        uint32_t from = side == 0 ? 0 : node, to = side == 0 ? node : TOOLS_NODES - 1;
        double length = 0.0;
        for (uint32_t i = from; i < to; i++) {
            length += vec3_distance(tools_node(&r, i), tools_node(&r, i + 1));
        }
        vec3 offset = vec3_sub(tools_node(&r, side == 0 ? from : to), tools_node(&r, node));
        double stretch = vbss_max(length - 5e-4 * (to - from), 0.0);
        wanted =
            vec3_add_scaled(wanted, baseline_of(&r.config.baseline)->grasper_stiffness * stretch,
                            vec3_unit_or(offset, vec3_zero()));
    }
    assert_true(vec3_norm(wanted) > 1e-3);
    expect_near(0.0, vec3_distance(wanted, tools_hand_force(&r, 0)), 1e-9);
    tools_end(&r);
}

/* Also of the last node, which no segment begins at. */
static void carried_node_is_restored(void **state)
{
    (void)state;
    const double y[] = {0.0, 0.0149, -0.0149};
    for (int k = 0; k < 3; k++) {
        tools_rig r;
        vbss_scene_event event = {0};
        begin(&r, k == 0 ? TOOLS_BOTH : TOOLS_NEITHER);
        tools_add(&r, vec3_make(0.0, y[k], -0.5e-3));
        assert_true(close_jaws(&r, 0, &event));
        small_state kept = small_save(&r.s);
        uint64_t hashes[20];
        for (int life = 0; life < 2; life++) {
            for (int i = 0; i < 20; i++) {
                tools_move(&r, 0, vec3_make(1e-5 * i, y[k], -0.5e-3));
                tools_open(&r, 0, i < 12 ? 0.0 : 1.0);
                tools_steps(&r, 1);
                assert_true(life == 0 || hashes[i] == small_hash(&r.s));
                hashes[i] = small_hash(&r.s);
            }
            expect_ok(vbss_scene_restore(r.s.scene, kept.bytes, kept.count));
        }
        free(kept.bytes);
        tools_end(&r);
    }
}

int test_paper_grasps(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_jaws_carry_nearest_node),
        cmocka_unit_test(jaws_ignore_nodes_beyond_reach),
        cmocka_unit_test(first_tool_leads_and_second_takes_over),
        cmocka_unit_test(waiting_tool_holds_nothing),
        cmocka_unit_test(hand_feels_section_stretch),
        cmocka_unit_test(carried_node_is_restored),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
