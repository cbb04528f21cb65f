/* A solenoid in the handle is wanted while jaws that are closed far enough hold a needle, and for nothing else; what the
 * output stage makes of it is counted against a script. */
#include <vblast_ss/device.h>

#include "scene/needles_rig.h"

typedef struct daq_handle {
    needles_rig rig;
    vbss_output *output;
    uint32_t on;
} handle;

static void begin(handle *h)
{
    vbss_output_config c;
    memset(h, 0, sizeof *h);
    needles_begin_scene(&h->rig);
    expect_ok(vbss_output_config_init(&c, sizeof c));
    c.solenoid_time = 0.5;
    expect_ok(vbss_output_create(h->rig.tools.s.context, &c, &h->output));
}

static void end(handle *h)
{
    expect_ok(vbss_output_destroy(h->output));
    needles_end(&h->rig);
}

/* As a host does it: one write a step. */
static void steps(handle *h, uint32_t count, double age)
{
    for (uint32_t i = 0; i < count; i++) {
        vbss_output_command command;
        vbss_output_result result;
        tools_steps(&h->rig.tools, 1);
        expect_ok(vbss_output_command_init(&command, sizeof command));
        command.solenoid = tools_state(&h->rig.tools, 0).solenoid;
        command.input_age = age;
        expect_ok(vbss_output_step(h->output, 1e-3, &command, &result, sizeof result));
        h->on = result.solenoid;
    }
}

static uint64_t pulses(const handle *h)
{
    vbss_output_statistics s;
    expect_ok(vbss_output_get_statistics(h->output, &s, sizeof s));
    return s.pulses;
}

static void across(handle *h)
{
    needles_add_across(&h->rig, 15e-3, vec3_zero());
}

/* In the step in which the jaws have touched it from both sides, if the handle is closed then. */
static void solenoid_follows_grasp_and_release(void **state)
{
    (void)state;
    handle h;
    begin(&h);
    across(&h);
    tools_add(&h.rig.tools, vec3_make(0.0, 0.0, -2e-3));
    steps(&h, 50, 0.0);
    assert_int_equal(pulses(&h), 0);
    tools_open(&h.rig.tools, 0, 0.0);
    uint32_t until = 0;
    while (tools_state(&h.rig.tools, 0).needle == 0) {
        assert_true(until++ < 100);
        assert_int_equal(h.on, 0);
        steps(&h, 1, 0.0);
    }
    assert_int_equal(h.on, 1);
    steps(&h, 200, 0.0);
    assert_int_equal(h.on, 1);
    assert_int_equal(pulses(&h), 1);
    tools_open(&h.rig.tools, 0, 1.0);
    steps(&h, 1, 0.0);
    assert_int_equal(h.on, 0);
    steps(&h, 200, 0.0);
    assert_int_equal(pulses(&h), 1);
    end(&h);
}

/* Held by a handle that is half open: nothing, until it is squeezed; then, as long as it is held. */
static void solenoid_waits_for_squeezed_handle(void **state)
{
    (void)state;
    handle h;
    begin(&h);
    across(&h);
    h.rig.tools.config.driver_opening = 0.1; /* 0.35 of it stops at the wire already */
    h.rig.tools.config.closing_angle = 0.05;
    tools_add(&h.rig.tools, vec3_make(0.0, 0.0, -2e-3));
    tools_open(&h.rig.tools, 0, 0.3);
    steps(&h, 100, 0.0);
    assert_int_equal(tools_state(&h.rig.tools, 0).needle, h.rig.body);
    assert_int_equal(pulses(&h), 0);
    tools_open(&h.rig.tools, 0, 0.19);
    steps(&h, 1, 0.0);
    assert_int_equal(h.on, 1);
    tools_open(&h.rig.tools, 0, 0.3);
    steps(&h, 50, 0.0);
    assert_int_equal(h.on, 1);
    assert_int_equal(pulses(&h), 1);
    end(&h);
}

static void no_solenoid_for_thread_or_empty_jaws(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        handle h;
        begin(&h);
        if (k == 0) {
            tools_thread(&h.rig.tools, TOOLS_NEITHER, 0.0);
        }
        tools_add(&h.rig.tools, vec3_make(0.0, 0.0, -2e-3));
        tools_open(&h.rig.tools, 0, 0.0);
        steps(&h, 200, 0.0);
        assert_int_equal(tools_state(&h.rig.tools, 0).grasp_count, k == 0);
        assert_int_equal(pulses(&h), 0);
        end(&h);
    }
}

static void stale_input_stop_and_timeout_switch_solenoid_off(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        handle h;
        begin(&h);
        across(&h);
        tools_add(&h.rig.tools, vec3_make(0.0, 0.0, -2e-3));
        tools_open(&h.rig.tools, 0, 0.0);
        steps(&h, 200, 0.0);
        assert_int_equal(h.on, 1);
        if (k == 1) {
            expect_ok(vbss_output_latch_emergency_stop(h.output));
        }
        steps(&h, k == 2 ? 400 : 1, k == 0 ? 0.1 : 0.0);
        assert_int_equal(h.on, 0);
        assert_int_equal(pulses(&h), 1);
        end(&h);
    }
}

static void slipping_needle_switches_solenoid_off(void **state)
{
    (void)state;
    handle h;
    begin(&h);
    h.rig.tools.config.stiffness = h.rig.tools.config.turning_stiffness = 1e7;
    across(&h);
    tools_add(&h.rig.tools, vec3_make(0.0, 0.0, -2e-3));
    tools_open(&h.rig.tools, 0, 0.0);
    steps(&h, 100, 0.0);
    assert_int_equal(h.on, 1);
    scene_body *b = vbss_scene_body(small_object(&h.rig.tools.s), h.rig.body);
    b->rigid.body.gravity = vec3_make(0.0, 0.0, -12.0 / b->rigid.body.mass);
    steps(&h, 100, 0.0);
    assert_int_equal(tools_state(&h.rig.tools, 0).needle, 0);
    assert_int_equal(h.on, 0);
    assert_int_equal(pulses(&h), 1);
    end(&h);
}

int test_needle_solenoid(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(solenoid_follows_grasp_and_release),
        harness_test(solenoid_waits_for_squeezed_handle),
        harness_test(no_solenoid_for_thread_or_empty_jaws),
        harness_test(stale_input_stop_and_timeout_switch_solenoid_off),
        harness_test(slipping_needle_switches_solenoid_off),
    };
    return cmocka_run_group_tests_name("scene.needle_solenoid", tests, NULL, NULL);
}
