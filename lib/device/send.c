/* Writes outputs to the adapters. */
#include "device/device.h"

uint32_t vbss_device_send(device_object *d, const vbss_output_result *result,
                          const vbss_device_coupling *coupling)
{
    d->write_failed = false;
    for (uint32_t i = 0; i < d->source_count; i++) {
        device_source *s = &d->sources[i];
        if (!vbss_device_write_source(d->context, s, d->now, result, coupling,
                                      vbss_device_driven_outputs(d, i))) {
            d->statistics.failed_writes[i]++;
            d->write_failed = true;
        }
    }
    return d->write_failed ? VBSS_OUTPUT_FLAG_NOT_WRITTEN : 0;
}

static void send_zeros(device_object *d, uint32_t flags)
{
    vbss_output_result zeros;
    vbss_output_fill_result(&d->limits, &d->output, flags, &zeros);
    vbss_device_send(d, &zeros, NULL);
}

void vbss_device_latch_stop(device_object *d)
{
    vbss_output_latch_stop(&d->output);
    send_zeros(d, VBSS_OUTPUT_FLAG_STOPPED);
}

void vbss_device_switch_off(device_object *d)
{
    vbss_output_set_zero(&d->output);
    send_zeros(d, VBSS_OUTPUT_FLAG_COMMAND_STALE);
}
