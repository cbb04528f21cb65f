/* The size protocol of all structs that cross the border, in all directions. */
#include <string.h>

#include "base/error.h"
#include "device/rig.h"

/* ---- structs that come in */

static vbss_result adapter_init(void *adapter, uint32_t struct_size)
{
    vbss_device_adapter *a = adapter;
    VBSS_TRY(vbss_device_adapter_init(adapter, struct_size));
    a->read = NULL;
    return VBSS_OK;
}

static vbss_result read_nothing(void *user, double now, vbss_device_sample *sample)
{
    (void)user;
    (void)now;
    (void)sample;
    return VBSS_OK;
}

static const vbss_device_adapter smallest = {.struct_size = sizeof smallest, .read = read_nothing};

/* The struct under test is the second adapter, whose missing function is all that is wrong with it. */
static vbss_result use_adapter(vbss_context *context, const void *adapter)
{
    vbss_device *device;
    vbss_result result = vbss_device_create(context, &smallest, adapter, NULL, &device);
    VBSS_TRY(vbss_device_destroy(device));
    return result == VBSS_ERROR_NULL_ARGUMENT ? VBSS_OK : result;
}

static vbss_result config_init(void *config, uint32_t struct_size)
{
    return vbss_device_config_init(config, struct_size);
}

static vbss_result use_config(vbss_context *context, const void *config)
{
    vbss_device *device;
    VBSS_TRY(vbss_device_create(context, &smallest, NULL, config, &device));
    return vbss_device_destroy(device);
}

static vbss_result calibration_init(void *calibration, uint32_t struct_size)
{
    return vbss_device_calibration_init(calibration, struct_size);
}

static vbss_result use_calibration(vbss_context *context, const void *calibration)
{
    vbss_device *device;
    VBSS_TRY(vbss_device_create(context, &smallest, NULL, NULL, &device));
    vbss_result result = vbss_device_set_calibration(device, calibration);
    VBSS_TRY(vbss_device_destroy(device));
    return result;
}

static vbss_result mock_init(void *config, uint32_t struct_size)
{
    return vbss_mock_config_init(config, struct_size);
}

static vbss_result use_mock(vbss_context *context, const void *config)
{
    vbss_mock *mock;
    VBSS_TRY(vbss_mock_create(context, config, &mock));
    return vbss_mock_destroy(mock);
}

static vbss_result capabilities_init(void *capabilities, uint32_t struct_size)
{
    return vbss_device_capabilities_init(capabilities, struct_size);
}

static vbss_result use_capabilities(vbss_context *context, const void *capabilities)
{
    vbss_mock_config config;
    VBSS_TRY(vbss_mock_config_init(&config, sizeof config));
    config.capabilities = capabilities;
    return use_mock(context, &config);
}

static vbss_result sample_init(void *sample, uint32_t struct_size)
{
    return vbss_device_sample_init(sample, struct_size);
}

static vbss_result use_sample(vbss_context *context, const void *sample)
{
    vbss_mock *mock;
    VBSS_TRY(vbss_mock_create(context, NULL, &mock));
    vbss_result result = vbss_mock_set_sample(mock, sample);
    VBSS_TRY(vbss_mock_destroy(mock));
    return result;
}

static vbss_result use_command(vbss_context *context, const void *command)
{
    vbss_device *device;
    VBSS_TRY(vbss_device_create(context, &smallest, NULL, NULL, &device));
    vbss_result result = vbss_device_write(device, 0.0, command, NULL, 0);
    VBSS_TRY(vbss_device_destroy(device));
    return result;
}

static vbss_result command_init(void *command, uint32_t struct_size)
{
    return vbss_output_command_init(command, struct_size);
}

static void size_protocol(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = {{8 + 9 * sizeof(void *), 0},
                                        {72 + 2 * sizeof(void *), 0},
                                        {264, 0},
                                        {16 + 3 * sizeof(void *), 0},
                                        {128, 0},
                                        {160, 0},
                                        {88, 0}};
    const harness_config all[] = {{sizes[0], adapter_init, use_adapter},
                                  {sizes[1], config_init, use_config},
                                  {sizes[2], calibration_init, use_calibration},
                                  {sizes[3], mock_init, use_mock},
                                  {sizes[4], capabilities_init, use_capabilities},
                                  {sizes[5], sample_init, use_sample},
                                  {sizes[6], command_init, use_command}};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        harness_config_protocol(&all[i]);
    }
}

/* ---- structs that go out */

enum { STRUCTS = 6 };
static const uint32_t struct_sizes[STRUCTS] = {208, 96, 256, 160, 128, 40};

static vbss_result write_out(const device_rig *r, int which, void *out, uint32_t size)
{
    switch (which) {
    case 0:
        return vbss_device_read(r->device, 1.0, out, size);
    case 1:
        return vbss_device_write(r->device, 1.0, NULL, out, size);
    case 2:
        return vbss_device_get_statistics(r->device, out, size);
    case 3:
        return vbss_device_get_output_statistics(r->device, out, size);
    case 4:
        return vbss_device_get_capabilities(r->device, 2, out, size);
    default:
        return vbss_mock_get_statistics(r->mocks[0], out, size);
    }
}

static void output_struct_size_protocol(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    device_rig_open(&r, 1);
    for (int which = 0; which < STRUCTS; which++) {
        unsigned char out[400];
        uint32_t filled;
        for (uint32_t size = 0; size < struct_sizes[which]; size++) {
            expect_result(VBSS_ERROR_STRUCT_SIZE, write_out(&r, which, out, size));
        }
        memset(out, 0xff, sizeof out);
        expect_ok(write_out(&r, which, out, 300));
        memcpy(&filled, out, sizeof filled);
        assert_int_equal(filled, struct_sizes[which]);
        for (uint32_t i = filled; i < sizeof out; i++) {
            assert_int_equal(out[i], i < 300 ? 0 : 0xff);
        }
        if (which != 1) { /* a write needs no place for its result */
            expect_result(VBSS_ERROR_NULL_ARGUMENT,
                          write_out(&r, which, NULL, struct_sizes[which]));
        }
    }
    device_rig_end(&r);
}

int test_sizes(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(size_protocol),
        cmocka_unit_test(output_struct_size_protocol),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
