/* Mocks: what they measure, what goes wrong with them, what they keep. */
#include <string.h>

#include "device/mock.h"
#include "harness/harness.h"

typedef struct mock_rig {
    harness_memory memory;
    vbss_context *context;
    vbss_mock_config config;
    vbss_mock *mock;
    vbss_device_adapter adapter;
    vbss_device_sample sample;
} mock_rig;

/* Position (t, 2 t, 3 t). */
static void measure(void *user, double time, vbss_device_sample *sample)
{
    const double *factor = user;
    sample->valid = VBSS_DEVICE_HAS_POSITION;
    for (int i = 0; i < 3; i++) {
        sample->position[i] = (factor != NULL ? *factor : 1.0) * (i + 1) * time;
    }
}

static void begin(mock_rig *r)
{
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    expect_ok(vbss_mock_config_init(&r->config, sizeof r->config));
    r->config.measure = measure;
}

static void create(mock_rig *r)
{
    expect_ok(vbss_mock_create(r->context, &r->config, &r->mock));
    expect_ok(vbss_device_adapter_init(&r->adapter, sizeof r->adapter));
    expect_ok(vbss_mock_get_adapter(r->mock, &r->adapter));
}

static vbss_result read_at(mock_rig *r, double now)
{
    expect_ok(vbss_device_sample_init(&r->sample, sizeof r->sample));
    return r->adapter.read(r->adapter.user, now, &r->sample);
}

static void end(mock_rig *r)
{
    harness_context_end(r->context, &r->memory);
}

static void add(mock_rig *r, vbss_mock_fault fault, double value)
{
    expect_ok(vbss_mock_add_fault(r->mock, fault, 1.0, 2.0, value));
}

/* ---- what is measured */

static void function_of_time_is_sampled(void **state)
{
    (void)state;
    double factor = 0.5;
    mock_rig r;
    begin(&r);
    r.config.user = &factor;
    create(&r);
    expect_ok(read_at(&r, 3.0));
    expect_near(3.0, r.sample.time, 0.0);
    expect_near(4.5, r.sample.position[2], 0.0);
    end(&r);
}

static void host_sample_is_passed_through(void **state)
{
    (void)state;
    mock_rig r;
    vbss_device_sample handed;
    begin(&r);
    r.config.measure = NULL;
    create(&r);
    expect_ok(vbss_device_sample_init(&handed, sizeof handed));
    handed.valid = VBSS_DEVICE_HAS_JAW;
    handed.jaw = (double)NAN;
    handed.time = 7.0;
    expect_ok(vbss_mock_set_sample(r.mock, &handed));
    expect_ok(read_at(&r, 3.0));
    assert_memory_equal(&handed, &r.sample, sizeof handed);
    add(&r, VBSS_MOCK_FAULT_JUMP, 2.0);
    expect_ok(read_at(&r, 1.5));
    expect_near(2.0, r.sample.position[0], 0.0);
    const vbss_mock_fault timed[] = {VBSS_MOCK_FAULT_STALL, VBSS_MOCK_FAULT_RATE,
                                     VBSS_MOCK_FAULT_LATE, VBSS_MOCK_FAULT_SHUFFLE};
    for (int i = 0; i < 4; i++) {
        expect_result(VBSS_ERROR_INCOMPATIBLE,
                      vbss_mock_add_fault(r.mock, timed[i], 0.0, 1.0, 0.5));
    }
    end(&r);
}

/* ---- what goes wrong, from the first moment to before the last */

static double time_with(vbss_mock_fault fault, double value, double now)
{
    mock_rig r;
    begin(&r);
    create(&r);
    add(&r, fault, value);
    expect_ok(read_at(&r, now));
    double time = r.sample.time;
    expect_near(time, r.sample.position[0], 0.0); /* measured then, not only stamped */
    end(&r);
    return time;
}

static void faults_change_on_sampling(void **state)
{
    (void)state;
    const double before = 0.9999, after = 2.0;
    for (vbss_mock_fault fault = VBSS_MOCK_FAULT_STALL; fault <= VBSS_MOCK_FAULT_SHUFFLE; fault++) {
        if (fault != VBSS_MOCK_FAULT_DISCONNECT) {
            expect_near(before, time_with(fault, 0.25, before), 0.0);
            expect_near(after, time_with(fault, 0.25, after), 0.0);
        }
    }
    expect_near(1.0, time_with(VBSS_MOCK_FAULT_STALL, 0.0, 1.0), 0.0);
    expect_near(1.0, time_with(VBSS_MOCK_FAULT_STALL, 0.0, 1.9), 0.0);
    expect_near(1.0, time_with(VBSS_MOCK_FAULT_RATE, 0.25, 1.24), 0.0);
    expect_near(1.75, time_with(VBSS_MOCK_FAULT_RATE, 0.25, 1.76), 0.0);
    expect_near(1.25, time_with(VBSS_MOCK_FAULT_LATE, 0.25, 1.5), 0.0);
    expect_near(1.125, time_with(VBSS_MOCK_FAULT_SHUFFLE, 0.25, 1.125), 0.0);
    expect_near(1.125, time_with(VBSS_MOCK_FAULT_SHUFFLE, 0.25, 1.375), 0.0);
    expect_near(1.625, time_with(VBSS_MOCK_FAULT_SHUFFLE, 0.25, 1.625), 0.0);
}

static void faults_corrupt_sample_content(void **state)
{
    (void)state;
    mock_rig r;
    begin(&r);
    r.config.fault_capacity = 1;
    create(&r);
    for (int which = 0; which <= 4; which++) {
        add(&r, VBSS_MOCK_FAULT_NAN, which);
        expect_ok(read_at(&r, 1.0));
        const double numbers[] = {r.sample.position[0], r.sample.orientation[0],
                                  r.sample.velocity[0], r.sample.jaw_raw, r.sample.time};
        for (int i = 0; i <= 4; i++) {
            assert_int_equal(numbers[i] != numbers[i], i == which);
        }
        assert_int_equal(r.sample.jaw != r.sample.jaw, which == 3);
        expect_ok(vbss_mock_clear_faults(r.mock));
    }
    const struct {
        vbss_mock_fault fault;
        double value;
        size_t at;
    } cases[] = {{VBSS_MOCK_FAULT_NORM, 1.5, offsetof(vbss_device_sample, orientation)},
                 {VBSS_MOCK_FAULT_TEMPERATURE, 0.9, offsetof(vbss_device_sample, temperature)},
                 {VBSS_MOCK_FAULT_JAW, -3.0, offsetof(vbss_device_sample, jaw_raw)}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        double found;
        add(&r, cases[i].fault, cases[i].value);
        expect_ok(read_at(&r, 1.5));
        memcpy(&found, (unsigned char *)&r.sample + cases[i].at, sizeof found);
        expect_near(cases[i].value, found, 0.0);
        expect_ok(vbss_mock_clear_faults(r.mock));
    }
    add(&r, VBSS_MOCK_FAULT_STOP, 0.0);
    expect_ok(read_at(&r, 1.5));
    assert_int_equal(r.sample.flags, VBSS_DEVICE_FLAG_STOP);
    expect_ok(vbss_mock_clear_faults(r.mock));
    add(&r, VBSS_MOCK_FAULT_REFUSAL, 0.0);
    expect_ok(read_at(&r, 1.5));
    assert_int_equal(r.sample.flags, VBSS_DEVICE_FLAG_FAULT);
    expect_result(VBSS_ERROR_CAPACITY,
                  vbss_mock_add_fault(r.mock, VBSS_MOCK_FAULT_STOP, 0.0, 1.0, 0.0));
    expect_ok(read_at(&r, 2.0));
    assert_int_equal(r.sample.flags, 0);
    end(&r);
}

static void calls_fail_on_request(void **state)
{
    (void)state;
    const vbss_output_result nothing = {.struct_size = sizeof nothing};
    char text[64];
    mock_rig r;
    begin(&r);
    create(&r);
    r.adapter.explain(r.adapter.user, text, sizeof text);
    assert_string_equal(text, "nothing has failed yet");
    add(&r, VBSS_MOCK_FAULT_READ_FAILS, 0.0);
    expect_result(VBSS_ERROR_DEVICE, read_at(&r, 1.0));
    assert_int_equal(r.sample.flags, 0);
    expect_ok(r.adapter.write(r.adapter.user, 1.0, &nothing));
    expect_ok(vbss_mock_clear_faults(r.mock));
    add(&r, VBSS_MOCK_FAULT_WRITE_FAILS, 0.0);
    expect_ok(read_at(&r, 1.0));
    expect_result(VBSS_ERROR_DEVICE, r.adapter.write(r.adapter.user, 1.0, &nothing));
    r.adapter.explain(r.adapter.user, text, sizeof text);
    assert_non_null(strstr(text, "a write fails"));
    add(&r, VBSS_MOCK_FAULT_DISCONNECT, 0.0);
    expect_result(VBSS_ERROR_DEVICE, read_at(&r, 1.0));
    assert_int_equal(r.sample.flags, VBSS_DEVICE_FLAG_LOST);
    r.adapter.explain(r.adapter.user, text, 9);
    assert_string_equal(text, "unplugge"); /* ends where the room does */
    text[32] = '#';
    r.adapter.explain(r.adapter.user, text, 32);
    assert_string_equal(text, "unplugged by a fault of the moc");
    assert_int_equal(text[32], '#');
    end(&r);
}

/* ---- what is kept */

static void writes_are_recorded_by_row(void **state)
{
    (void)state;
    mock_rig r;
    vbss_view view;
    vbss_mock_statistics statistics;
    begin(&r);
    r.config.row_capacity = 3;
    create(&r);
    for (int i = 0; i < 5; i++) {
        const vbss_output_result out = {.struct_size = sizeof out,
                                        .flags = 4,
                                        .solenoid = i == 1,
                                        .force = {i, 2.0, 3.0},
                                        .torque = {4.0, 5.0, 6.0}};
        expect_ok(r.adapter.write(r.adapter.user, 0.5 * i, &out));
    }
    expect_ok(vbss_mock_get_view(r.mock, VBSS_MOCK_VIEW_ROWS, &view, sizeof view));
    assert_int_equal(view.count, 3);
    assert_int_equal(view.components, 9);
    assert_int_equal(view.type, VBSS_VIEW_TYPE_F64);
    assert_int_equal(view.stride_bytes, 72);
    const double second[9] = {0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 1.0, 4.0};
    assert_memory_equal((const double *)view.data + 9, second, sizeof second);
    expect_ok(vbss_mock_get_statistics(r.mock, &statistics, sizeof statistics));
    assert_int_equal(statistics.writes, 5);
    assert_int_equal(statistics.rows_lost, 2);
    uint64_t generation = view.generation;
    const vbss_output_result nothing = {.struct_size = sizeof nothing};
    expect_ok(r.adapter.write(r.adapter.user, 3.0, &nothing));
    expect_ok(vbss_mock_get_view(r.mock, VBSS_MOCK_VIEW_ROWS, &view, sizeof view));
    assert_true(view.generation > generation);
    generation = view.generation;
    expect_ok(vbss_mock_clear_rows(r.mock));
    expect_ok(vbss_mock_get_view(r.mock, VBSS_MOCK_VIEW_ROWS, &view, sizeof view));
    assert_int_equal(view.count, 0);
    assert_true(view.generation > generation);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_mock_get_view(r.mock, 2, &view, sizeof view));
    end(&r);
}

static void mock_opens_for_one_device_at_a_time(void **state)
{
    (void)state;
    mock_rig r;
    vbss_device *one, *two;
    vbss_mock_statistics statistics;
    const char *text;
    begin(&r);
    create(&r);
    expect_ok(vbss_device_create(r.context, &r.adapter, NULL, NULL, &one));
    expect_result(VBSS_ERROR_DEVICE, vbss_device_create(r.context, &r.adapter, NULL, NULL, &two));
    expect_ok(vbss_context_get_last_error(r.context, NULL, &text));
    assert_non_null(strstr(text, "open already"));
    expect_ok(vbss_device_destroy(one));
    expect_ok(vbss_device_create(r.context, &r.adapter, NULL, NULL, &two));
    expect_ok(vbss_mock_get_statistics(r.mock, &statistics, sizeof statistics));
    assert_int_equal(statistics.open, 1);
    assert_int_equal(statistics.opens, 2);
    end(&r);
}

static void device_outlives_mock(void **state)
{
    (void)state;
    mock_rig r;
    vbss_device *device;
    vbss_device_input input;
    begin(&r);
    create(&r);
    expect_ok(vbss_device_create(r.context, &r.adapter, NULL, NULL, &device));
    expect_ok(vbss_device_read(device, 0.0, &input, sizeof input));
    assert_int_equal(input.status, VBSS_DEVICE_STATUS_READY);
    expect_ok(vbss_mock_destroy(r.mock));
    expect_ok(vbss_device_read(device, 0.001, &input, sizeof input));
    assert_int_equal(input.status, VBSS_DEVICE_STATUS_LOST);
    expect_ok(vbss_device_write(device, 0.001, NULL, NULL, 0));
    expect_ok(vbss_device_destroy(device));
    end(&r);
}

static void default_mock(void **state)
{
    (void)state;
    mock_rig r;
    vbss_mock *none;
    begin(&r);
    expect_ok(vbss_mock_create(r.context, NULL, &r.mock));
    for (int i = 0; i < 16; i++) {
        expect_ok(vbss_mock_add_fault(r.mock, VBSS_MOCK_FAULT_STOP, 0.0, 1.0, 0.0));
    }
    expect_result(VBSS_ERROR_CAPACITY,
                  vbss_mock_add_fault(r.mock, VBSS_MOCK_FAULT_STOP, 0.0, 1.0, 0.0));
    union {
        vbss_device_adapter known;
        unsigned char bytes[sizeof(vbss_device_adapter) + 64];
    } longer;
    expect_ok(vbss_device_adapter_init(&longer.known, sizeof longer));
    expect_ok(vbss_mock_get_adapter(r.mock, &longer.known));
    assert_int_equal(longer.known.struct_size, sizeof longer);
    r.config.fault_capacity = 5000;
    none = r.mock;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_mock_create(r.context, &r.config, &none));
    assert_null(none);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_mock_create(r.context, NULL, NULL));
    end(&r);
}

static void bad_faults_are_rejected(void **state)
{
    (void)state;
    mock_rig r;
    begin(&r);
    create(&r);
    for (int i = 0; i < 3; i++) {
        double bad = harness_bad_numbers[i];
        expect_result(VBSS_ERROR_NOT_FINITE,
                      vbss_mock_add_fault(r.mock, VBSS_MOCK_FAULT_JUMP, bad, 1.0, 0.0));
        expect_result(VBSS_ERROR_NOT_FINITE,
                      vbss_mock_add_fault(r.mock, VBSS_MOCK_FAULT_JUMP, 0.0, bad, 0.0));
        expect_result(VBSS_ERROR_NOT_FINITE,
                      vbss_mock_add_fault(r.mock, VBSS_MOCK_FAULT_JUMP, 0.0, 1.0, bad));
    }
    const struct {
        vbss_mock_fault fault;
        double from, until, value;
    } bad[] = {{0, 0.0, 1.0, 0.0},
               {15, 0.0, 1.0, 0.0},
               {VBSS_MOCK_FAULT_JUMP, 1.0, 0.5, 0.0},
               {VBSS_MOCK_FAULT_RATE, 0.0, 1.0, 0.0},
               {VBSS_MOCK_FAULT_SHUFFLE, 0.0, 1.0, -1.0},
               {VBSS_MOCK_FAULT_LATE, 0.0, 1.0, -1e-3},
               {VBSS_MOCK_FAULT_NAN, 0.0, 1.0, 5.0}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        expect_result(
            VBSS_ERROR_OUT_OF_RANGE,
            vbss_mock_add_fault(r.mock, bad[i].fault, bad[i].from, bad[i].until, bad[i].value));
    }
    end(&r);
}

int test_mock(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(function_of_time_is_sampled),
        cmocka_unit_test(host_sample_is_passed_through),
        cmocka_unit_test(faults_change_on_sampling),
        cmocka_unit_test(faults_corrupt_sample_content),
        cmocka_unit_test(calls_fail_on_request),
        cmocka_unit_test(writes_are_recorded_by_row),
        cmocka_unit_test(mock_opens_for_one_device_at_a_time),
        cmocka_unit_test(device_outlives_mock),
        cmocka_unit_test(default_mock),
        cmocka_unit_test(bad_faults_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
