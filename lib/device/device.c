/* Creation and destruction of devices. The limits of a device follow from its configuration and
 * from the capabilities of its adapters. */

#include "base/number_text.h"
#include "device/device.h"

#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/snapshot.h"

_Static_assert(sizeof(vbss_device_config) == 72 + 2 * sizeof(void *), "no hidden padding");

static const vbss_device_config config_defaults = {
    .struct_size = sizeof(vbss_device_config),
    .tool = VBSS_DEVICE_TOOL_NEEDLE_DRIVER,
    .second_signals = DEVICE_JAW_SIGNALS,
    .clock = VBSS_DEVICE_CLOCK_OWN,
    .stop_when_lost = 1,
    .jaw_timeout = 0.1,
    .velocity_time = 0.005,
    .norm_tolerance = 1e-3,
    .max_stiffness = 400.0,
    .max_damping = 4.0,
};
static const uint32_t config_sizes[] = {72u + 2u * (uint32_t)sizeof(void *), 0};
static const vbss_layout config_layout = {"vbss_device_config", &config_defaults, config_sizes};

vbss_result vbss_device_config_init(vbss_device_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

static vbss_result check_config(vbss_context *context, const vbss_device_config *c)
{
    VBSS_TRY(
        vbss_check_range(context, c->tool, VBSS_DEVICE_TOOL_NONE, VBSS_DEVICE_TOOL_SHEARS, "tool"));
    VBSS_TRY(vbss_check_range(context, c->second_signals, 0.0, DEVICE_SIGNALS, "second_signals"));
    VBSS_TRY(vbss_check_range(context, c->clock, VBSS_DEVICE_CLOCK_OWN, VBSS_DEVICE_CLOCK_SHARED,
                              "clock"));
    VBSS_TRY(vbss_check_range(context, c->stop_when_lost, 0.0, 1.0, "stop_when_lost"));
    VBSS_TRY(vbss_check_range(context, c->clutch_orientation, 0.0, 1.0, "clutch_orientation"));
    VBSS_TRY(vbss_check_range(context, c->jaw_takeover, 0.0, 1.0, "jaw_takeover"));
    VBSS_TRY(vbss_check_range(context, c->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_range(context, c->jaw_timeout, 1e-4, 1e3, "jaw_timeout"));
    VBSS_TRY(vbss_check_range(context, c->velocity_time, 0.0, 10.0, "velocity_time"));
    VBSS_TRY(vbss_check_range(context, c->norm_tolerance, 0.0, 0.5, "norm_tolerance"));
    VBSS_TRY(vbss_check_range(context, c->max_stiffness, 0.0, 1e6, "max_stiffness"));
    return vbss_check_range(context, c->max_damping, 0.0, 1e6, "max_damping");
}

/* ---- limits of the adapters together */

static double tighter_limit(double limit, double device)
{
    return device > 0.0 ? vbss_min(limit, device) : limit;
}

/* A slow device is not stale between two of its samples. */
static double effective_timeout(double timeout, const vbss_device_capabilities *c)
{
    return c->update_rate > 0.0 ? vbss_max(timeout, 2.5 / c->update_rate) : timeout;
}

static const vbss_device_capabilities *output_capabilities(const device_object *d, uint32_t output)
{
    uint32_t second = d->source_count == 2 && (vbss_device_driven_outputs(d, 1) & output) != 0;
    return &d->sources[second].capabilities;
}

static void set_limits(device_object *d)
{
    const vbss_device_capabilities *force = output_capabilities(d, VBSS_DEVICE_OUT_FORCE);
    const vbss_device_capabilities *torque = output_capabilities(d, VBSS_DEVICE_OUT_TORQUE);
    uint32_t jaw =
        d->source_count == 2 && (vbss_device_routed_signals(d, 1) & DEVICE_JAW_SIGNALS) != 0;
    uint32_t arm =
        d->source_count == 2 && (vbss_device_routed_signals(d, 1) & VBSS_DEVICE_HAS_POSITION) != 0;
    vbss_output_config *l = &d->limits;
    l->max_force = tighter_limit(l->max_force, force->max_force);
    l->continuous_force = tighter_limit(l->continuous_force, force->max_continuous_force);
    l->max_torque = tighter_limit(l->max_torque, torque->max_torque);
    l->continuous_torque = tighter_limit(l->continuous_torque, torque->max_continuous_torque);
    l->input_timeout = effective_timeout(l->input_timeout, &d->sources[arm].capabilities);
    d->jaw_timeout = effective_timeout(d->config.jaw_timeout, &d->sources[jaw].capabilities);
}

/* ---- creation and destruction */

static void init_state(device_object *d)
{
    d->orientation = quat_identity();
    d->orientation_offset = quat_identity();
    d->clutch_pose = d->reported_pose = pose_identity();
    d->tool = d->config.tool;
    d->jaw.opening = 1.0;
    d->off_until = -1e9;
    d->pose_reading.age = d->opening_reading.age = -1.0;
    vbss_device_reset_motion(&d->motion);
    vbss_output_init_state(&d->limits, &d->output);
}

static vbss_result open_sources(device_object *d)
{
    for (uint32_t i = 0; i < d->source_count; i++) {
        vbss_result result = vbss_device_open_source(d->context, &d->sources[i]);
        if (result != VBSS_OK) {
            while (i-- > 0) {
                vbss_device_close_source(d->context, &d->sources[i]);
            }
            return result;
        }
    }
    return VBSS_OK;
}

static vbss_result create_device(vbss_context *context, const device_object *wanted,
                                 vbss_slot **slot)
{
    device_object *d = vbss_allocate(context, 1, sizeof *d, "device");
    if (d == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    *d = *wanted;
    vbss_array buffers[DEVICE_SOURCES];
    for (uint32_t i = 0; i < DEVICE_SOURCES; i++) {
        buffers[i] = (vbss_array){&d->sources[i].buffer, DEVICE_BUFFER_BYTES / sizeof(uint64_t),
                                  sizeof(uint64_t)};
    }
    vbss_result result = vbss_allocate_arrays(context, buffers, DEVICE_SOURCES, "device");
    if (result == VBSS_OK) {
        result = vbss_slot_reserve(context, &vbss_device_kind, slot);
    }
    if (result == VBSS_OK) { /* last, because it acts on hardware */
        result = open_sources(d);
    }
    if (result != VBSS_OK) {
        vbss_device_free(context, d);
        return result;
    }
    set_limits(d);
    init_state(d);
    vbss_slot_fill(*slot, d);
    return VBSS_OK;
}

static vbss_result read_adapter(device_object *d, const vbss_device_adapter *adapter)
{
    vbss_device_adapter *own = &d->sources[d->source_count].adapter;
    VBSS_TRY(vbss_config_read(d->context, &vbss_device_adapter_layout, adapter, own));
    VBSS_TRY(vbss_device_check_adapter(d->context, own, d->source_count == 0));
    d->source_count++;
    return VBSS_OK;
}

static vbss_result read_configs(device_object *d, const vbss_device_config *config)
{
    vbss_context *context = d->context;
    d->config = config_defaults;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &config_layout, config, &d->config));
    }
    VBSS_TRY(check_config(context, &d->config));
    VBSS_TRY(vbss_device_calibration_init(&d->calibration, sizeof d->calibration));
    VBSS_TRY(vbss_output_config_init(&d->limits, sizeof d->limits));
    if (d->config.calibration != NULL) {
        VBSS_TRY(vbss_config_read(context, &vbss_device_calibration_layout, d->config.calibration,
                                  &d->calibration));
    }
    if (d->config.output != NULL) {
        VBSS_TRY(
            vbss_config_read(context, &vbss_output_config_layout, d->config.output, &d->limits));
    }
    d->config.calibration = NULL; /* the host may free them after this call */
    d->config.output = NULL;
    VBSS_TRY(vbss_device_check_calibration(context, &d->calibration));
    d->frame = vbss_device_make_frame(&d->calibration);
    return vbss_output_check_config(context, &d->limits);
}

vbss_result vbss_device_create(vbss_context *context, const vbss_device_adapter *first,
                               const vbss_device_adapter *second, const vbss_device_config *config,
                               vbss_device **device)
{
    VBSS_ENTER_WITH_RESULT(context, device);
    if (device == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, device, "device");
    }
    VBSS_TRY(vbss_context_edit(context));
    device_object wanted = {.context = context};
    vbss_slot *slot = NULL;
    VBSS_TRY(read_adapter(&wanted, first));
    if (second != NULL) {
        VBSS_TRY(read_adapter(&wanted, second));
    }
    VBSS_TRY(read_configs(&wanted, config));
    VBSS_TRY(create_device(context, &wanted, &slot));
    *device = (vbss_device *)slot;
    return VBSS_OK;
}

vbss_result vbss_device_destroy(vbss_device *device)
{
    VBSS_ENTER(device);
    return vbss_slot_destroy(device, &vbss_device_kind);
}

static vbss_result check_clock(const device_object *d, double now)
{
    VBSS_TRY(vbss_check_range(d->context, now, -1e9, 1e9, "now"));
    return !d->has_time || now >= d->now
               ? VBSS_OK
               : vbss_fail(d->context, VBSS_ERROR_OUT_OF_RANGE,
                           "now is %s, after %s: the clock stepped back, and the outputs are off",
                           vbss_format_number(now, 9).text, vbss_format_number(d->now, 9).text);
}

vbss_result vbss_device_check_now(device_object *d, double now)
{
    vbss_result result = check_clock(d, now);
    if (result != VBSS_OK) {
        vbss_device_switch_off(d);
    }
    return result;
}

vbss_result vbss_device_save(vbss_device *device, uint8_t *bytes, uint64_t capacity,
                             uint64_t *written)
{
    VBSS_ENTER(device);
    return vbss_object_save(device, &vbss_device_kind, bytes, capacity, written);
}

vbss_result vbss_device_restore(vbss_device *device, const uint8_t *bytes, uint64_t count)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_object_restore(device, &vbss_device_kind, bytes, count));
    VBSS_TRY(vbss_device_open(device, &d));
    d->off_until = -1e9;
    if (d->config.jaw_takeover != 0) {
        vbss_device_hold_opening(d, vbss_device_reported_opening(d));
    }
    return VBSS_OK;
}

vbss_result vbss_device_get_hash(vbss_device *device, uint64_t *hash)
{
    VBSS_ENTER(device);
    return vbss_object_hash(device, &vbss_device_kind, hash);
}
