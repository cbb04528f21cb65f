/* Adapters of the host: opened, described, refused, closed; what they say, and newer ones than this library. */
#include <string.h>

#include "base/error.h"
#include "device/rig.h"

/* ---- an adapter of the host that keeps a diary */

typedef struct diary {
    vbss_result opens, describes;
    vbss_device_capabilities capabilities;
    int opened, closed, described, written, explained;
    vbss_output_result last;
    uint32_t flags; /* of its samples */
    bool longer;    /* from a newer header: fills and looks at more than this library knows */
    uint32_t seen_beyond;
} diary;

enum { BEYOND = 600 };

static vbss_result host_open(void *user)
{
    diary *d = user;
    d->opened++;
    return d->opens;
}

static void host_close(void *user)
{
    diary *d = user;
    d->closed++;
}

static vbss_result host_describe(void *user, vbss_device_capabilities *capabilities)
{
    diary *d = user;
    const vbss_device_capabilities cleared = {.struct_size = sizeof cleared};
    assert_memory_equal(capabilities, &cleared, sizeof cleared);
    d->described++;
    memcpy((unsigned char *)capabilities + 4, (const unsigned char *)&d->capabilities + 4,
           sizeof *capabilities - 4);
    if (d->longer) {
        memset((unsigned char *)capabilities + sizeof *capabilities, 0xff, BEYOND);
    }
    return d->describes;
}

static vbss_result host_read(void *user, double now, vbss_device_sample *sample)
{
    diary *d = user;
    const vbss_device_sample cleared = {.struct_size = sizeof cleared, .orientation = {1.0}};
    assert_memory_equal(sample, &cleared, sizeof cleared);
    device_rig_hand(NULL, now, sample);
    sample->time = now;
    sample->flags = d->flags;
    if (d->longer) {
        sample->valid |= 0xffff0000u;
        memset((unsigned char *)sample + sizeof *sample, 0xff, BEYOND);
    }
    return VBSS_OK;
}

static vbss_result host_write(void *user, double now, const vbss_output_result *output)
{
    diary *d = user;
    (void)now;
    d->written++;
    d->last = *output;
    for (size_t i = 0; d->longer && i < BEYOND; i++) {
        d->seen_beyond += ((const unsigned char *)output)[sizeof *output + i];
    }
    return VBSS_OK;
}

/* The first time without an end, then nothing at all. */
static void host_explain(void *user, char *text, uint32_t bytes)
{
    diary *d = user;
    if (d->explained++ == 0) {
        memset(text, 'x', bytes);
    }
}

static vbss_device_adapter adapter_of(diary *d)
{
    vbss_device_adapter a;
    memset(d, 0, sizeof *d);
    expect_ok(vbss_device_capabilities_init(&d->capabilities, sizeof d->capabilities));
    d->capabilities.outputs = DEVICE_OUTPUTS;
    d->capabilities.signals = DEVICE_SIGNALS;
    expect_ok(vbss_device_adapter_init(&a, sizeof a));
    a.name = "arm";
    a.user = d;
    a.open = host_open;
    a.close = host_close;
    a.describe = host_describe;
    a.read = host_read;
    a.write = host_write;
    a.explain = host_explain;
    return a;
}

static vbss_result create(device_rig *r, const vbss_device_adapter *a, const vbss_device_adapter *b)
{
    return vbss_device_create(r->context, a, b, &r->config, &r->device);
}

static void adapter_opens_once_and_closes_after_zeros(void **state)
{
    (void)state;
    device_rig r;
    diary d;
    device_rig_begin(&r);
    vbss_device_adapter a = adapter_of(&d);
    expect_ok(create(&r, &a, NULL));
    assert_int_equal(d.opened, 1);
    assert_int_equal(d.described, 1);
    r.command.force[0] = 0.4;
    r.command.solenoid = 1;
    device_rig_steps(&r, 5);
    expect_near(0.4, d.last.force[0], 1e-15);
    expect_ok(vbss_device_destroy(r.device));
    assert_int_equal(d.closed, 1);
    assert_true(d.last.force[0] == 0.0 && d.last.solenoid == 0);
    assert_int_equal(d.last.flags, VBSS_OUTPUT_FLAG_STOPPED);
    /* A context that ends does the same. */
    expect_ok(create(&r, &a, NULL));
    device_rig_steps(&r, 5);
    device_rig_end(&r);
    assert_int_equal(d.closed, 2);
    assert_true(d.last.force[0] == 0.0);
}

static void stop_is_written_at_once(void **state)
{
    (void)state;
    device_rig r;
    diary d;
    device_rig_begin(&r);
    vbss_device_adapter a = adapter_of(&d);
    expect_ok(create(&r, &a, NULL));
    r.command.force[0] = 0.4;
    device_rig_steps(&r, 5);
    int before = d.written;
    expect_ok(vbss_device_latch_emergency_stop(r.device));
    assert_int_equal(d.written, before + 1);
    assert_true(d.last.force[0] == 0.0);
    device_rig_steps(&r, 5);
    assert_true(d.last.force[0] == 0.0);
    assert_int_equal(r.input.stopped, 1);
    expect_ok(vbss_device_clear_emergency_stop(r.device));
    device_rig_steps(&r, 1);
    expect_near(0.4, d.last.force[0], 1e-15);
    device_rig_end(&r);
}

/* ---- what cannot be opened */

static void failing_open_closes_other_adapter(void **state)
{
    (void)state;
    for (int which = 0; which < 2; which++) {
        for (int stage = 0; stage < 3; stage++) {
            device_rig r;
            diary d[2];
            const char *text;
            device_rig_begin(&r);
            vbss_device_adapter a = adapter_of(&d[0]), b = adapter_of(&d[1]);
            a.name = b.name = "one whose name is longer than there is room for it";
            d[which].opens = stage == 0 ? -77 : VBSS_OK;
            d[which].describes = stage == 1 ? 5 : VBSS_OK;
            d[which].capabilities.max_force = stage == 2 ? -1.0 : 0.0;
            vbss_result wanted = stage < 2 ? VBSS_ERROR_DEVICE : VBSS_ERROR_OUT_OF_RANGE;
            r.device = (vbss_device *)r.context;
            expect_result(wanted, create(&r, &a, &b));
            assert_null(r.device);
            assert_int_equal(d[which].closed, stage == 0 ? 0 : 1);
            assert_int_equal(d[1 - which].opened, which); /* the second comes after the first */
            assert_int_equal(d[1 - which].closed, which);
            expect_ok(vbss_context_get_last_error(r.context, NULL, &text));
            if (stage < 2) {
                assert_non_null(strstr(text, "one whose name is longer than t cannot"));
                assert_non_null(strstr(text, stage == 0 ? "-77" : "5"));
                assert_non_null(strstr(text, "xxxx"));
            }
            device_rig_end(&r);
        }
    }
}

static void function_table_without_functions_is_rejected(void **state)
{
    (void)state;
    device_rig r;
    diary d;
    device_rig_begin(&r);
    vbss_device_adapter good = adapter_of(&d), a = good;
    expect_result(VBSS_ERROR_NULL_ARGUMENT, create(&r, NULL, NULL));
    a.read = NULL;
    expect_result(VBSS_ERROR_NULL_ARGUMENT, create(&r, &a, NULL));
    a.write = NULL;
    expect_result(VBSS_ERROR_NULL_ARGUMENT, create(&r, &good, &a));
    a = good;
    a.reserved = 1;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, create(&r, &a, NULL));
    assert_int_equal(d.opened, 0);
    /* As few as there can be: signals and no outputs. */
    expect_ok(vbss_device_adapter_init(&a, sizeof a));
    a.read = host_read;
    a.user = &d;
    expect_ok(create(&r, &a, NULL));
    vbss_device_capabilities all;
    expect_ok(vbss_device_get_capabilities(r.device, 0, &all, sizeof all));
    assert_int_equal(all.signals, DEVICE_SIGNALS);
    assert_int_equal(all.outputs, 0);
    r.command.force[0] = 1.0;
    device_rig_steps(&r, 10);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_int_equal(r.flags, 0);
    assert_true(r.result.force[0] == 0.0);
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_device_get_capabilities(r.device, 1, &all, sizeof all));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_device_get_error(r.device, 1, NULL, NULL));
    device_rig_end(&r);
}

/* Without a description all is there that there are functions for. */
static void undescribed_adapter_has_all_capabilities(void **state)
{
    (void)state;
    device_rig r;
    diary d;
    device_rig_begin(&r);
    vbss_device_adapter a = adapter_of(&d);
    a.describe = NULL;
    a.open = NULL;
    a.close = NULL;
    a.name = NULL;
    expect_ok(create(&r, &a, NULL));
    r.command.force[0] = 0.4;
    r.command.torque[0] = 0.01;
    r.command.solenoid = 1;
    device_rig_steps(&r, 3);
    expect_near(0.4, d.last.force[0], 1e-15);
    expect_near(0.01, d.last.torque[0], 1e-15);
    assert_int_equal(d.last.solenoid, 1);
    device_rig_end(&r);
}

/* What an adapter says of a failure is kept until the next, and cut where its room ends. */
static void adapter_error_text_is_kept_and_truncated(void **state)
{
    (void)state;
    device_rig r;
    diary d;
    vbss_result result;
    const char *text;
    device_rig_begin(&r);
    vbss_device_adapter a = adapter_of(&d);
    expect_ok(create(&r, &a, NULL));
    device_rig_steps(&r, 3);
    expect_ok(vbss_device_get_error(r.device, 0, &result, &text));
    assert_int_equal(result, VBSS_OK);
    assert_string_equal(text, "");
    d.flags = VBSS_DEVICE_FLAG_LOST; /* lost, although it gives a sample */
    device_rig_steps(&r, 1);
    expect_ok(vbss_device_get_error(r.device, 0, &result, &text));
    assert_int_equal(result, VBSS_ERROR_DEVICE);
    assert_int_equal(strlen(text), DEVICE_TEXT_BYTES - 1);
    d.flags = 0;
    device_rig_steps(&r, 1);
    d.flags = VBSS_DEVICE_FLAG_LOST;
    device_rig_steps(&r, 1);
    expect_ok(vbss_device_get_error(r.device, 0, NULL, &text));
    assert_string_equal(text, "");
    device_rig_end(&r);
}

/* Lost, says the adapter, and gives samples: no solenoid, even where a loss does not stop. */
static void disconnect_turns_solenoid_off(void **state)
{
    (void)state;
    device_rig r;
    diary d;
    device_rig_begin(&r);
    r.config.stop_when_lost = 0;
    vbss_device_adapter a = adapter_of(&d);
    expect_ok(create(&r, &a, NULL));
    r.command.solenoid = 1;
    device_rig_steps(&r, 3);
    assert_int_equal(d.last.solenoid, 1);
    d.flags = VBSS_DEVICE_FLAG_LOST;
    device_rig_steps(&r, 1);
    assert_int_equal(d.last.solenoid, 0);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_LOST);
    device_rig_end(&r);
}

/* ---- an adapter from the future */

static void newer_adapter_header_fits(void **state)
{
    (void)state;
    device_rig r;
    diary d;
    device_rig_begin(&r);
    vbss_device_adapter a = adapter_of(&d);
    d.longer = true;
    d.capabilities.signals = 0xffffffffu;
    d.capabilities.outputs = 0xffffffffu;
    expect_ok(create(&r, &a, NULL));
    vbss_device_capabilities all;
    expect_ok(vbss_device_get_capabilities(r.device, 0, &all, sizeof all));
    assert_int_equal(all.signals, DEVICE_SIGNALS);
    assert_int_equal(all.outputs, DEVICE_OUTPUTS);
    device_rig_steps(&r, 10);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_int_equal(r.input.valid & ~(uint32_t)DEVICE_SIGNALS, 0);
    assert_int_equal(d.seen_beyond, 0); /* whatever it left there in its samples */
    device_rig_end(&r);
}

/* ---- memory */

static diary watched;

static vbss_result open_watched(vbss_context *context, void *user)
{
    vbss_device *device;
    VBSS_TRY(vbss_device_create(context, user, NULL, NULL, &device));
    return vbss_device_destroy(device);
}

/* Nothing of the hardware is touched for a device that cannot be had. */
static void failed_allocation_opens_nothing(void **state)
{
    (void)state;
    vbss_device_adapter a = adapter_of(&watched);
    harness_fail_every_allocation(open_watched, &a);
    assert_int_equal(watched.opened, 2); /* the two that succeeded in the end */
    assert_int_equal(watched.closed, 2);
}

int test_adapters(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(adapter_opens_once_and_closes_after_zeros),
        cmocka_unit_test(stop_is_written_at_once),
        cmocka_unit_test(failing_open_closes_other_adapter),
        cmocka_unit_test(function_table_without_functions_is_rejected),
        cmocka_unit_test(undescribed_adapter_has_all_capabilities),
        cmocka_unit_test(adapter_error_text_is_kept_and_truncated),
        cmocka_unit_test(disconnect_turns_solenoid_off),
        cmocka_unit_test(newer_adapter_header_fits),
        cmocka_unit_test(failed_allocation_opens_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
