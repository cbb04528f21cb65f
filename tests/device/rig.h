/* A device on one or two mocks, stepped at 1 kHz: read, then write. */
#ifndef VBSS_TESTS_DEVICE_RIG_H
#define VBSS_TESTS_DEVICE_RIG_H

#include "device/device.h"
#include "harness/harness.h"

typedef struct device_rig {
    harness_memory memory;
    vbss_context *context;
    vbss_device_capabilities capabilities[2]; /* of the mocks */
    vbss_mock_config mock_configs[2];
    vbss_mock *mocks[2];
    vbss_device_adapter adapters[2];
    vbss_device_calibration calibration;
    vbss_output_config output;
    vbss_device_config config;
    vbss_device *device;
    uint64_t step; /* of the next read */
    double now;    /* of the last read: step / 1000 */
    vbss_output_command command;
    vbss_device_input input;
    vbss_output_result result;
    uint32_t events, flags; /* all that were told since device_rig_forget */
} device_rig;

/* Defaults everywhere; both mocks measure `device_rig_hand`; the second has a jaw and a solenoid. */
void device_rig_begin(device_rig *r);
void device_rig_open(device_rig *r, int adapters);
void device_rig_read(device_rig *r);
void device_rig_write(device_rig *r, const vbss_output_command *command);
void device_rig_steps(device_rig *r, int count);
void device_rig_forget(device_rig *r);
/* From the last read on, for so many ms. */
void device_rig_fault(device_rig *r, int mock, vbss_mock_fault fault, double ms, double value);
void device_rig_end(device_rig *r);
vbss_device_statistics device_rig_statistics(const device_rig *r);
vbss_output_statistics device_rig_output_statistics(const device_rig *r);
uint64_t device_rig_hash(const device_rig *r);
device_object *device_rig_object(const device_rig *r);

/* x moves at 0.1 m/s from -5 mm on, the handle turns about z at 1 rad/s, the raw opening is 0.5. */
void device_rig_hand(void *user, double time, vbss_device_sample *sample);

/* Every function that takes a device, all other arguments good: those that change something first. A restore has
 * nothing good to read. */
enum { DEVICE_EDITS = 9, DEVICE_CALLS = 15 };
extern const harness_handle_call device_calls[DEVICE_CALLS];
vbss_result device_call_restore(void *device);

#endif
