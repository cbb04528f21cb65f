#include "scenes/device_run.h"

#include "base/error.h"
#include "base/rotation.h"

/* ---- the hand */

static void measure_arm(void *user, double time, vbss_device_sample *sample)
{
    double slow, fast, other;
    (void)user;
    vbss_sincos(4.0 * time, &slow, &other);
    vbss_sincos(31.0 * time, &fast, &other);
    sample->valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION |
                    VBSS_DEVICE_HAS_BUTTONS | VBSS_DEVICE_HAS_TOOL | VBSS_DEVICE_HAS_TEMPERATURE;
    sample->position[0] = 0.04 * slow;
    sample->position[1] = 0.002 * fast;
    sample->position[2] = 0.03 * slow * fast;
    quat q = vbss_quat_from_rotation_vector(vec3_make(slow, 0.2 * fast, time));
    sample->orientation[0] = q.w;
    vec3_store(sample->orientation + 1, vec3_make(q.x, q.y, q.z));
    sample->buttons = fast > 0.5 ? 3 : 1;
    sample->tool = time > 0.2 ? VBSS_DEVICE_TOOL_SHEARS : VBSS_DEVICE_TOOL_NEEDLE_DRIVER;
    sample->temperature = 0.9 * slow * slow;
}

static void measure_handle(void *user, double time, vbss_device_sample *sample)
{
    (void)user;
    sample->valid = VBSS_DEVICE_HAS_JAW_RAW;
    sample->jaw_raw = 2.5 + 0.3 * vbss_sin(23.0 * time);
    sample->time = floor(200.0 * time) / 200.0; /* 200 Hz */
}

/* ---- what goes wrong, when */

static vbss_result add_faults(vbss_mock *arm, vbss_mock *handle)
{
    static const struct {
        vbss_mock_fault fault;
        double from, until, value;
    } faults[] = {{VBSS_MOCK_STALL, 0.0305, 0.0455, 0.0},   {VBSS_MOCK_NAN, 0.0605, 0.0625, 0.0},
                  {VBSS_MOCK_LATE, 0.0805, 0.0905, 0.0035}, {VBSS_MOCK_SHUFFLE, 0.1, 0.12, 0.0011},
                  {VBSS_MOCK_RATE, 0.13, 0.16, 0.004},      {VBSS_MOCK_NORM, 0.17, 0.172, 1.5},
                  {VBSS_MOCK_NORM, 0.173, 0.18, 1.0005},    {VBSS_MOCK_REFUSAL, 0.19, 0.2, 0.0},
                  {VBSS_MOCK_STOP, 0.21, 0.211, 0.0},       {VBSS_MOCK_DISCONNECT, 0.26, 0.28, 0.0},
                  {VBSS_MOCK_WRITE_FAILS, 0.32, 0.322, 0.0}};
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        VBSS_TRY(vbss_mock_add_fault(arm, faults[i].fault, faults[i].from, faults[i].until,
                                     faults[i].value));
    }
    VBSS_TRY(vbss_mock_add_fault(handle, VBSS_MOCK_JAW, 0.05, 0.06, 9.0));
    return vbss_mock_add_fault(handle, VBSS_MOCK_STALL, 0.35, 0.48, 0.0);
}

static vbss_result make_mock(vbss_context *context, vbss_mock_measure_fn measure,
                             vbss_device_adapter *adapter, vbss_mock **mock)
{
    vbss_mock_config config;
    VBSS_TRY(vbss_mock_config_init(&config, sizeof config));
    config.measure = measure;
    config.row_capacity = 0;
    VBSS_TRY(vbss_mock_create(context, &config, mock));
    VBSS_TRY(vbss_device_adapter_init(adapter, sizeof *adapter));
    return vbss_mock_get_adapter(*mock, adapter);
}

static vbss_result make_parts(vbss_context *context, const vbss_device_config *config,
                              device_run *run)
{
    vbss_device_adapter adapters[2];
    VBSS_TRY(make_mock(context, measure_arm, &adapters[0], &run->mocks[0]));
    VBSS_TRY(make_mock(context, measure_handle, &adapters[1], &run->mocks[1]));
    VBSS_TRY(add_faults(run->mocks[0], run->mocks[1]));
    return vbss_device_create(context, &adapters[0], &adapters[1], config, &run->device);
}

vbss_result device_run_create(vbss_context *context, device_run *run)
{
    vbss_device_calibration calibration;
    vbss_output_config output;
    vbss_device_config config;
    *run = (device_run){.device = NULL};
    VBSS_TRY(vbss_device_calibration_init(&calibration, sizeof calibration));
    VBSS_TRY(vbss_output_config_init(&output, sizeof output));
    VBSS_TRY(vbss_device_config_init(&config, sizeof config));
    calibration.axes[0] = -3;
    calibration.axes[2] = 1;
    calibration.scale = 1.7;
    calibration.rotation[0] = calibration.rotation[4] = 0.8;
    calibration.rotation[1] = -0.6;
    calibration.rotation[3] = 0.6;
    calibration.offset[2] = 0.03;
    calibration.mount[2] = -0.5;
    calibration.workspace_high[0] = 0.02;
    calibration.workspace_low[1] = -0.01;
    calibration.jaw_closed = 2.2;
    calibration.jaw_open = 2.8;
    output.load_time = 0.1; /* so that it shows in half a second */
    output.solenoid_time = 0.05;
    config.calibration = &calibration;
    config.output = &output;
    config.clutch_orientation = 1;
    vbss_result result = make_parts(context, &config, run);
    if (result != VBSS_OK) {
        device_run_destroy(run);
    }
    return result;
}

vbss_result device_run_destroy(device_run *run)
{
    VBSS_TRY(vbss_device_destroy(run->device));
    VBSS_TRY(vbss_mock_destroy(run->mocks[1]));
    return vbss_mock_destroy(run->mocks[0]);
}

/* ---- the host */

static vbss_result control(vbss_device *device, uint64_t step)
{
    const double place[3] = {0.0, 0.01, 0.0};
    switch (step) {
    case 150:
        return vbss_device_clutch(device, 1);
    case 165:
        return vbss_device_clutch(device, 0);
    case 230:
    case 300:
        return vbss_device_release(device);
    case 310:
        return vbss_device_recentre(device, place, NULL);
    default:
        return VBSS_OK;
    }
}

static void wanted(uint64_t step, const double position[3], vbss_output_command *command)
{
    double slow, fast;
    vbss_sincos(0.02 * (double)step, &slow, &fast);
    for (int i = 0; i < 3; i++) {
        command->force[i] = -60.0 * position[i] + (i == 1 ? 2.0 * slow : 0.0);
        command->torque[i] = 0.12 * fast * slow;
    }
    command->solenoid = step % 100 < 70;
    if (step == 345) {
        command->force[2] = (double)NAN;
    }
}

vbss_result device_run_step(vbss_device *device, vbss_device_input *input,
                            vbss_output_result *result)
{
    device_object *d;
    vbss_output_command command;
    VBSS_TRY(vbss_device_open(device, &d));
    uint64_t step = d->statistics.reads;
    double now = (double)step / 1000.0;
    VBSS_TRY(control(device, step));
    VBSS_TRY(vbss_device_read(device, now, input, sizeof *input));
    VBSS_TRY(vbss_output_command_init(&command, sizeof command));
    wanted(step, input->position, &command);
    /* In between, steps without a command. */
    return vbss_device_write(device, now,
                             step % 10 == 9 || (step >= 400 && step < 420) ? NULL : &command,
                             result, sizeof *result);
}

vbss_result device_run_output(vbss_output *output, uint64_t step, vbss_output_result *result)
{
    const double position[3] = {0.03, -0.01, 0.02};
    vbss_output_command command;
    VBSS_TRY(vbss_output_command_init(&command, sizeof command));
    wanted(step, position, &command);
    if (step == 200) {
        VBSS_TRY(vbss_output_stop(output));
    } else if (step == 220) {
        VBSS_TRY(vbss_output_release(output));
    }
    return vbss_output_step(output, 1e-3, step % 30 < 8 ? NULL : &command, result, sizeof *result);
}
