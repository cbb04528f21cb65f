/* Cost of a read, a write, both, and an output stage alone. The mock's own time is in it: it measures nothing but
 * a straight line. */
#include "base/error.h"
#include "device/device.h"

#include "bench_device.h"

enum { ITEMS = 1000 };

typedef struct cost {
    vbss_context *context;
    vbss_mock *mocks[2];
    vbss_device *device;
    vbss_output *output;
    vbss_output_command command;
    uint64_t step;
    int adapters;
} cost;

static cost state;

static void measure(void *user, double time, vbss_device_sample *sample)
{
    (void)user;
    sample->valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION |
                    VBSS_DEVICE_HAS_JAW_RAW | VBSS_DEVICE_HAS_BUTTONS;
    sample->position[0] = 1e-3 * (time - floor(time));
    sample->orientation[1] = 0.6;
    sample->orientation[0] = 0.8;
    sample->jaw_raw = 0.5;
}

static vbss_result make_adapter(cost *c, int which, vbss_device_adapter *adapter)
{
    vbss_mock_config config;
    VBSS_TRY(vbss_mock_config_init(&config, sizeof config));
    config.measure = measure;
    config.row_capacity = 0;
    VBSS_TRY(vbss_mock_create(c->context, &config, &c->mocks[which]));
    VBSS_TRY(vbss_device_adapter_init(adapter, sizeof *adapter));
    return vbss_mock_get_adapter(c->mocks[which], adapter);
}

static vbss_result make(cost *c)
{
    vbss_device_adapter adapters[2];
    VBSS_TRY(vbss_context_create(NULL, &c->context));
    VBSS_TRY(make_adapter(c, 0, &adapters[0]));
    VBSS_TRY(make_adapter(c, 1, &adapters[1]));
    VBSS_TRY(vbss_output_create(c->context, NULL, &c->output));
    VBSS_TRY(vbss_output_command_init(&c->command, sizeof c->command));
    c->command.force[0] = 0.5;
    c->command.torque[1] = 0.01;
    c->step = 0;
    return vbss_device_create(c->context, &adapters[0], c->adapters > 1 ? &adapters[1] : NULL, NULL,
                              &c->device);
}

static int setup_one(void *user)
{
    cost *c = user;
    c->adapters = 1;
    return make(c) == VBSS_OK ? 0 : 1;
}

static int setup_two(void *user)
{
    cost *c = user;
    c->adapters = 2;
    return make(c) == VBSS_OK ? 0 : 1;
}

static void teardown(void *user)
{
    cost *c = user;
    vbss_context_destroy(c->context);
}

static void run(cost *c, bool reads, bool writes)
{
    vbss_device_input input;
    vbss_output_result result;
    for (int i = 0; i < ITEMS; i++) {
        double now = 1e-3 * (double)c->step++;
        if (reads && vbss_device_read(c->device, now, &input, sizeof input) == VBSS_OK) {
            bench_keep(input.position[0]);
        }
        if (writes &&
            vbss_device_write(c->device, now, &c->command, &result, sizeof result) == VBSS_OK) {
            bench_keep(result.force[0]);
        }
    }
}

static void run_read(void *user)
{
    run(user, true, false);
}

static void run_write(void *user)
{
    run(user, false, true);
}

static void run_both(void *user)
{
    run(user, true, true);
}

static void run_stage(void *user)
{
    cost *c = user;
    vbss_output_result result;
    for (int i = 0; i < ITEMS; i++) {
        if (vbss_output_step(c->output, 1e-3, &c->command, &result, sizeof result) == VBSS_OK) {
            bench_keep(result.force[0]);
        }
    }
}

void add_cost_cases(bench *b)
{
    static const struct {
        const char *name;
        int (*setup)(void *user);
        void (*run)(void *user);
    } rows[] = {{"device/read/one-adapter", setup_one, run_read},
                {"device/read/two-adapters", setup_two, run_read},
                {"device/write/one-adapter", setup_one, run_write},
                {"device/write/two-adapters", setup_two, run_write},
                {"device/step/one-adapter", setup_one, run_both},
                {"device/step/two-adapters", setup_two, run_both},
                {"device/stage/ours", setup_one, run_stage}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const bench_batch batch = {.name = rows[i].name,
                                   .user = &state,
                                   .items = ITEMS,
                                   .setup = rows[i].setup,
                                   .run = rows[i].run,
                                   .teardown = teardown};
        bench_add_batch(b, &batch);
    }
}
