/* Reports capabilities, failures and statistics of a device. */
#include "base/api_call.h"
#include "base/error.h"
#include "device/device.h"

_Static_assert(sizeof(vbss_device_statistics) == 256, "published size");
static const uint32_t statistics_sizes[] = {256, 0};
static const vbss_layout statistics_layout = {"vbss_device_statistics", NULL, statistics_sizes};

/* Capabilities of the device as a whole: the signals that it takes, and the limits in force. */
static vbss_device_capabilities merge_capabilities(const device_object *d)
{
    vbss_device_capabilities all = d->sources[0].capabilities;
    const vbss_output_config *l = &d->limits;
    all.signals = all.outputs = 0;
    for (uint32_t i = 0; i < d->source_count; i++) {
        all.signals |= d->sources[i].capabilities.signals & vbss_device_routed_signals(d, i);
        all.outputs |= vbss_device_driven_outputs(d, i);
    }
    all.max_force = l->max_force;
    all.max_continuous_force = l->continuous_force;
    all.max_torque = l->max_torque;
    all.max_continuous_torque = l->continuous_torque;
    all.max_stiffness = all.max_stiffness > 0.0
                            ? vbss_min(all.max_stiffness, d->config.max_stiffness)
                            : d->config.max_stiffness;
    all.max_damping = all.max_damping > 0.0 ? vbss_min(all.max_damping, d->config.max_damping)
                                            : d->config.max_damping;
    return all;
}

vbss_result vbss_device_get_capabilities(vbss_device *device, uint32_t which,
                                         vbss_device_capabilities *capabilities,
                                         uint32_t struct_size)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_device_open(device, &d));
    if (which != 2 && which >= d->source_count) {
        return vbss_fail(d->context, VBSS_ERROR_NOT_FOUND, "adapter %u of %u", which,
                         d->source_count);
    }
    vbss_device_capabilities own =
        which == 2 ? merge_capabilities(d) : d->sources[which].capabilities;
    return vbss_struct_write(d->context, &vbss_device_capabilities_layout, &own, capabilities,
                             struct_size);
}

vbss_result vbss_device_get_error(vbss_device *device, uint32_t which, vbss_result *result,
                                  const char **text)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_device_open(device, &d));
    if (which >= d->source_count) {
        return vbss_fail(d->context, VBSS_ERROR_NOT_FOUND, "adapter %u of %u", which,
                         d->source_count);
    }
    if (result != NULL) {
        *result = d->sources[which].last_failure;
    }
    if (text != NULL) {
        *text = d->sources[which].text;
    }
    return VBSS_OK;
}

vbss_result vbss_device_get_statistics(vbss_device *device, vbss_device_statistics *statistics,
                                       uint32_t struct_size)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_device_open(device, &d));
    return vbss_struct_write(d->context, &statistics_layout, &d->statistics, statistics,
                             struct_size);
}

vbss_result vbss_device_get_output_statistics(vbss_device *device,
                                              vbss_output_statistics *statistics,
                                              uint32_t struct_size)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_device_open(device, &d));
    return vbss_struct_write(d->context, &vbss_output_statistics_layout, &d->output.statistics,
                             statistics, struct_size);
}
