/* Handles of devices: the kind with its end, and the object of a handle. */
#include "base/error.h"
#include "base/memory.h"
#include "base/stream.h"
#include "device/device.h"

void vbss_device_free(vbss_context *context, device_object *d)
{
    for (uint32_t i = 0; i < DEVICE_SOURCES; i++) {
        vbss_release(context, d->sources[i].buffer, DEVICE_BUFFER_BYTES / sizeof(uint64_t),
                     sizeof(uint64_t));
    }
    vbss_release(context, d, 1, sizeof *d);
}

static void destroy_device(vbss_context *context, void *object)
{
    device_object *d = object;
    vbss_device_latch_stop(d);
    for (uint32_t i = d->source_count; i > 0; i--) {
        vbss_device_close_source(context, &d->sources[i - 1]);
    }
    vbss_device_free(context, d);
}

const vbss_kind vbss_device_kind = {"device",       VBSS_CODE('D', 'E', 'V', 'I'), 1,
                                    destroy_device, vbss_device_serialise,         NULL};

vbss_result vbss_device_open(const vbss_device *handle, device_object **device)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_device_kind, &slot));
    *device = slot->object;
    return VBSS_OK;
}

vbss_result vbss_device_edit(vbss_device *handle, device_object **device)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_device_kind, &slot));
    *device = slot->object;
    return VBSS_OK;
}
