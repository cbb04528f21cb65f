/* Routing: which of two adapters gives each signal and takes each output. */
#include "device/device.h"

uint32_t vbss_device_routed_signals(const device_object *d, uint32_t source)
{
    if (d->source_count == 1) {
        return DEVICE_SIGNALS;
    }
    const uint32_t groups[] = {DEVICE_POSE_SIGNALS | DEVICE_MOTION_SIGNALS, DEVICE_JAW_SIGNALS};
    uint32_t second = d->config.second_signals;
    for (int i = 0; i < 2; i++) { /* one adapter gives all signals of a group */
        second |= (second & groups[i]) != 0 ? groups[i] : 0u;
    }
    return source == 1 ? second : DEVICE_SIGNALS & ~second;
}

/* If both adapters can do it, forces go to the first (the arm), and the solenoid is driven by the
 * second (the electronics of the handle). */
uint32_t vbss_device_driven_outputs(const device_object *d, uint32_t source)
{
    uint32_t own = d->sources[source].capabilities.outputs;
    if (d->source_count == 1) {
        return own;
    }
    uint32_t other = d->sources[1 - source].capabilities.outputs;
    return source == 0 ? own & ~(other & VBSS_DEVICE_OUT_SOLENOID)
                       : own & ~(other & ~(uint32_t)VBSS_DEVICE_OUT_SOLENOID);
}
