/* What a gamepad's state asks for, and how a tool's hand follows it; no pad has to be there. */
#include <math.h>
#include <string.h>

#include "harness/harness.h"
#include "viewer/mouse_hand.h"
#include "viewer/pad.h"

#define STEP 1e-3

static GLFWgamepadstate at_rest(void)
{
    GLFWgamepadstate s = {.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] = -1.0F,
                          .axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = -1.0F};
    return s;
}

static void sticks_shift_and_roll(void **state)
{
    (void)state;
    pad p = {.known = false};
    GLFWgamepadstate s = at_rest();
    s.axes[GLFW_GAMEPAD_AXIS_LEFT_X] = 0.25F;
    s.axes[GLFW_GAMEPAD_AXIS_LEFT_Y] = 0.5F; /* down */
    s.axes[GLFW_GAMEPAD_AXIS_RIGHT_X] = -1.0F;
    s.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y] = 0.75F; /* towards the user */
    static const double wanted[6] = {0.25, -0.5, 0.75, 0.0, 0.0, -1.0};
    const pad_wish w = pad_read(&p, &s);
    for (int i = 0; i < 6; i++) {
        assert_true(w.axes[i] == wanted[i]);
    }
    assert_false(w.fine);
    assert_int_equal(w.pressed, 0);
}

static void bumper_switches_to_rotation(void **state)
{
    (void)state;
    pad p = {.known = false};
    GLFWgamepadstate s = at_rest();
    s.axes[GLFW_GAMEPAD_AXIS_LEFT_X] = 1.0F;
    s.axes[GLFW_GAMEPAD_AXIS_LEFT_Y] = -1.0F;
    s.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] = 1.0F;
    s.buttons[GLFW_GAMEPAD_BUTTON_LEFT_BUMPER] = GLFW_PRESS;
    const pad_wish w = pad_read(&p, &s);
    assert_true(w.axes[0] == 0.0 && w.axes[1] == 0.0);
    assert_true(w.axes[3] == -1.0 &&
                w.axes[4] == 1.0); /* what faces the user goes up, and to the right */
    assert_true(w.fine);
}

static void presses_count_once(void **state)
{
    (void)state;
    static const float drawn[] = {-1.0F, -0.2F, 0.1F, -0.2F, 0.9F, -0.6F, 0.1F};
    static const uint32_t wanted[] = {0, 0, PAD_JAWS, 0, 0, 0, PAD_JAWS};
    pad p = {.known = false};
    GLFWgamepadstate s = at_rest();
    for (size_t i = 0; i < sizeof drawn / sizeof *drawn; i++) {
        s.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = drawn[i];
        assert_int_equal(pad_read(&p, &s).pressed, wanted[i]);
    }
    s.buttons[GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER] = s.buttons[GLFW_GAMEPAD_BUTTON_START] = GLFW_PRESS;
    assert_int_equal(pad_read(&p, &s).pressed, PAD_OTHER | PAD_PAUSE);
    assert_int_equal(pad_read(&p, &s).pressed, 0);
}

/* One that is plugged in with its trigger drawn, or is gone and comes back so, asks for nothing. */
static void press_before_connect_is_ignored(void **state)
{
    (void)state;
    pad p = {.known = false};
    GLFWgamepadstate s = at_rest();
    s.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = 1.0F;
    s.axes[GLFW_GAMEPAD_AXIS_LEFT_X] = 1.0F;
    assert_int_equal(pad_read(&p, &s).pressed, 0);
    const pad_wish gone = pad_read(&p, NULL);
    static const double nothing[6];
    assert_memory_equal(gone.axes, nothing, sizeof nothing);
    assert_int_equal(pad_read(&p, &s).pressed, 0);
    s.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = -1.0F;
    assert_int_equal(pad_read(&p, &s).pressed, 0);
    s.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = 1.0F;
    assert_int_equal(pad_read(&p, &s).pressed, PAD_JAWS);
}

/* ---- a tool */

typedef struct rig {
    vbss_context *context;
    vbss_grasper *tool;
    mouse_hand hand;
} rig;

static void set_up(rig *r)
{
    static const double at[3] = {0.01, 0.02, 0.03};
    memset(r, 0, sizeof *r);
    assert_int_equal(vbss_context_create(NULL, &r->context), VBSS_OK);
    assert_int_equal(vbss_grasper_create(r->context, NULL, &r->tool), VBSS_OK);
    assert_int_equal(vbss_grasper_set_target(r->tool, at, NULL), VBSS_OK);
    assert_int_equal(mouse_hand_create(&r->hand, r->context, r->tool), VBSS_OK);
    assert_int_equal(mouse_hand_read(&r->hand, 0.0), VBSS_OK);
}

static void run(rig *r, int from, int steps)
{
    for (int i = 1; i <= steps; i++) {
        assert_int_equal(mouse_hand_read(&r->hand, STEP * (from + i)), VBSS_OK);
    }
}

static void full_stick_moves_at_mapping_speed(void **state)
{
    (void)state;
    static const double axes[6] = {1.0, 0.0, -1.0}, nothing[6];
    rig r;
    set_up(&r);
    const vbss_device_input before = r.hand.in;
    mouse_hand_pull(&r.hand, axes, 1.0);
    run(&r, 0, 100);
    const double travel = 0.1 * r.hand.mapping.pad_speed;
    assert_true(fabs(r.hand.in.position[0] - before.position[0] - travel) < 1e-9);
    assert_true(fabs(r.hand.in.position[2] - before.position[2] + travel) < 1e-9);
    mouse_hand_pull(&r.hand, axes, 0.25);
    run(&r, 100, 100);
    assert_true(fabs(r.hand.in.position[0] - before.position[0] - 1.25 * travel) < 1e-9);
    mouse_hand_pull(&r.hand, nothing, 1.0);
    run(&r, 200, 100);
    assert_true(fabs(r.hand.in.position[0] - before.position[0] - 1.25 * travel) < 1e-9);
    assert_true(r.hand.in.jaw == before.jaw);
    assert_int_equal(vbss_context_destroy(r.context), VBSS_OK);
}

static void last_axis_rolls_tool_about_its_axis(void **state)
{
    (void)state;
    static const double axes[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    rig r;
    set_up(&r);
    mouse_hand_pull(&r.hand, axes, 1.0);
    run(&r, 0, 100);
    const double half = 0.5 * 0.1 * r.hand.mapping.pad_turning, *q = r.hand.in.orientation;
    assert_true(fabs(q[0] - cos(half)) < 1e-9 && fabs(fabs(q[3]) - sin(half)) < 1e-9);
    assert_true(fabs(q[1]) < 1e-12 && fabs(q[2]) < 1e-12);
    assert_int_equal(vbss_context_destroy(r.context), VBSS_OK);
}

/* Without it a mouse stops at the edge of the tools' space; while the mouse moves freely, the tool stays. */
static void centred_hand_has_no_edge(void **state)
{
    (void)state;
    rig r;
    double travel = 0.0;
    set_up(&r);
    for (int i = 0; i < 4; i++) {
        mouse_hand_move(&r.hand, false, 1000.0, 0.0, 0.0);
        for (int k = 0; k < 1000; k++) {
            mouse_hand_centre(&r.hand);
            run(&r, 1000 * i + k, 1);
            travel += r.hand.in.position[0];
        }
    }
    assert_true(fabs(travel - 4000.0 * r.hand.mapping.mouse_metres) < 1e-6);
    assert_int_equal(mouse_hand_clutch(&r.hand, true), VBSS_OK);
    const double before = r.hand.in.position[0];
    mouse_hand_centre(&r.hand);
    assert_true(r.hand.in.position[0] == before);
    assert_int_equal(vbss_context_destroy(r.context), VBSS_OK);
}

/* 0.2 m into the floor by mouse, and back at once: neither force nor way back grow with the excess. */
static void hand_stops_with_a_tool_that_is_held(void **state)
{
    (void)state;
    rig r;
    vbss_scene *scene;
    vbss_scene_config c;
    vbss_grasper_state tool;
    double max_force = 0.0;
    set_up(&r);
    assert_int_equal(vbss_scene_config_init(&c, sizeof c), VBSS_OK);
    c.floor = 1;
    memcpy(c.floor_normal, (const double[3]){0.0, 1.0, 0.0}, sizeof c.floor_normal);
    assert_int_equal(vbss_scene_create(r.context, &c, &scene), VBSS_OK);
    assert_int_equal(vbss_scene_add_grasper(scene, r.tool, &r.hand.body), VBSS_OK);
    mouse_hand_move(&r.hand, false, 0.0, -0.2 / r.hand.mapping.mouse_metres, 0.0);
    for (int i = 1; i <= 1500; i++) {
        run(&r, i - 1, 1);
        assert_int_equal(vbss_grasper_set_target(r.tool, r.hand.in.position, r.hand.in.orientation),
                         VBSS_OK);
        assert_int_equal(vbss_scene_step(scene, STEP), VBSS_OK);
        assert_int_equal(vbss_grasper_get_state(r.tool, &tool, sizeof tool), VBSS_OK);
        max_force = fmax(max_force, tool.hand_force[1]);
        if (i == 1000) {
            assert_true(tool.hand_force[1] > 7.0);
            mouse_hand_move(&r.hand, false, 0.0, 0.1 / r.hand.mapping.mouse_metres, 0.0);
        }
    }
    assert_true(max_force < 10.0);
    assert_true(tool.position[1] > 0.07);
    assert_int_equal(vbss_context_destroy(r.context), VBSS_OK);
}

int test_pad(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sticks_shift_and_roll),
        cmocka_unit_test(bumper_switches_to_rotation),
        cmocka_unit_test(presses_count_once),
        cmocka_unit_test(press_before_connect_is_ignored),
        cmocka_unit_test(full_stick_moves_at_mapping_speed),
        cmocka_unit_test(last_axis_rolls_tool_about_its_axis),
        cmocka_unit_test(centred_hand_has_no_edge),
        cmocka_unit_test(hand_stops_with_a_tool_that_is_held),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
