/* A hand's grip on a tool: which tool it shall be. */
#include <string.h>

#include <vblast_ss/mock.h>

#include "harness/harness.h"
#include "trainer/grip.h"

typedef struct grip_rig {
    harness_memory memory;
    vbss_context *context;
    vbss_device *device;
    vbss_device_sample sample;
    grip grip;
    double now;
} grip_rig;

static void measure(void *user, double time, vbss_device_sample *sample)
{
    const grip_rig *r = user;
    *sample = r->sample;
    sample->time = time;
}

static void begin(grip_rig *r, uint32_t valid)
{
    const double here[3] = {0.0, 0.0, 0.0};
    vbss_mock_config c;
    vbss_mock *mock;
    vbss_device_adapter adapter;
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    expect_ok(vbss_mock_config_init(&c, sizeof c));
    c.measure = measure;
    c.user = r;
    expect_ok(vbss_mock_create(r->context, &c, &mock));
    expect_ok(vbss_device_adapter_init(&adapter, sizeof adapter));
    expect_ok(vbss_mock_get_adapter(mock, &adapter));
    expect_ok(vbss_device_create(r->context, &adapter, NULL, NULL, &r->device));
    expect_ok(vbss_device_sample_init(&r->sample, sizeof r->sample));
    r->sample.valid =
        VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION | VBSS_DEVICE_HAS_BUTTONS | valid;
    grip_begin(&r->grip, here);
}

/* A slot with these buttons down, and that tool in the scene. Whether another is asked for. */
static bool slot(grip_rig *r, uint32_t buttons, vbss_grasper_kind kind)
{
    vbss_grasper_state tool = {.kind = kind};
    bool known;
    r->now += 1e-3;
    r->sample.buttons = buttons;
    expect_ok(grip_read(&r->grip, r->device, r->now, 1e-3, &known));
    assert_true(known);
    expect_ok(grip_write(&r->grip, r->device, r->now, &tool, 0.0));
    return r->grip.exchanges;
}

/* One press one exchange, from the tool that is there, also where one was refused; a button that is stuck is none. */
static void button_exchanges_where_handle_closes(void **state)
{
    (void)state;
    grip_rig r;
    const vbss_grasper_kind driver = VBSS_GRASPER_KIND_NEEDLE_DRIVER,
                            shears = VBSS_GRASPER_KIND_SHEARS;
    begin(&r, VBSS_DEVICE_HAS_JAW);
    r.sample.jaw = 0.7;
    assert_false(slot(&r, 1, driver));
    assert_false(slot(&r, 1, driver));
    assert_false(slot(&r, 0, driver));
    assert_true(slot(&r, 1, driver));
    assert_int_equal(r.grip.wants, shears);
    assert_false(slot(&r, 1, driver));
    assert_false(slot(&r, 0, driver));
    assert_true(slot(&r, 1, driver)); /* it was refused: once more */
    assert_int_equal(r.grip.wants, shears);
    assert_false(slot(&r, 0, shears));
    assert_true(slot(&r, 1, shears));
    assert_int_equal(r.grip.wants, driver);
    assert_true(r.grip.jaw == 0.7);
    harness_context_end(r.context, &r.memory);
}

static void button_closes_jaws_without_handle(void **state)
{
    (void)state;
    grip_rig r;
    begin(&r, 0);
    for (int i = 0; i < 300; i++) {
        assert_false(slot(&r, i > 0 ? 1 : 0, VBSS_GRASPER_KIND_NEEDLE_DRIVER));
    }
    assert_true(r.grip.jaw == 0.0);
    harness_context_end(r.context, &r.memory);
}

static void device_may_report_tool(void **state)
{
    (void)state;
    grip_rig r;
    begin(&r, VBSS_DEVICE_HAS_JAW | VBSS_DEVICE_HAS_TOOL);
    r.sample.tool = VBSS_DEVICE_TOOL_NEEDLE_DRIVER;
    assert_false(slot(&r, 0, VBSS_GRASPER_KIND_NEEDLE_DRIVER));
    r.sample.tool = VBSS_DEVICE_TOOL_SHEARS;
    assert_true(slot(&r, 0, VBSS_GRASPER_KIND_NEEDLE_DRIVER));
    assert_int_equal(r.grip.wants, VBSS_GRASPER_KIND_SHEARS);
    assert_false(slot(&r, 0, VBSS_GRASPER_KIND_SHEARS));
    harness_context_end(r.context, &r.memory);
}

/* A tool that is where it was 2 ms ago has gone on: a spring to where it was would draw the hand back. */
static void late_tool_force_uses_current_pose(void **state)
{
    (void)state;
    double felt[2];
    for (int k = 0; k < 2; k++) {
        grip_rig r;
        begin(&r, VBSS_DEVICE_HAS_JAW);
        while (!r.grip.joined) {
            (void)slot(&r, 0, VBSS_GRASPER_KIND_NEEDLE_DRIVER);
        }
        vbss_grasper_state tool = {.kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER};
        memcpy(tool.position, r.grip.in.position, sizeof tool.position);
        tool.position[1] += k == 0 ? 1e-3 : 0.8e-3;
        tool.velocity[1] = 0.1;
        for (int i = 0; i < 200; i++) { /* the force rises by so much in a slot */
            bool known;
            r.now += 1e-3;
            expect_ok(grip_read(&r.grip, r.device, r.now, 1e-3, &known));
            expect_ok(grip_write(&r.grip, r.device, r.now, &tool, k == 0 ? 0.0 : 2e-3));
        }
        felt[k] = r.grip.force;
        harness_context_end(r.context, &r.memory);
    }
    assert_true(felt[0] > 0.3);
    expect_near(felt[0], felt[1], 1e-9);
}

int test_grip(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(button_exchanges_where_handle_closes),
        cmocka_unit_test(button_closes_jaws_without_handle),
        cmocka_unit_test(device_may_report_tool),
        cmocka_unit_test(late_tool_force_uses_current_pose),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
