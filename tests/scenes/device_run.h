/* A device on two mocks along a scripted hand, with everything that can go wrong one after the other, stepped at 1
 * kHz by reading and writing. What its tests, the determinism table and benches step. */
#ifndef VBSS_TESTS_SCENES_DEVICE_RUN_H
#define VBSS_TESTS_SCENES_DEVICE_RUN_H

#include "device/device.h"

/* Steps until the script repeats nothing any more. */
enum { DEVICE_RUN_STEPS = 500 };

typedef struct device_run {
    vbss_mock *mocks[2];
    vbss_device *device;
} device_run;
/* On failure nothing is left. */
vbss_result device_run_create(vbss_context *context, device_run *run);
vbss_result device_run_destroy(device_run *run);
/* The next step, by the device's own time: so a restored device goes on where it was. `result` may be NULL. */
vbss_result device_run_step(vbss_device *device, vbss_device_input *input,
                            vbss_output_result *result);
/* An output stage under the same forces. */
vbss_result device_run_output(vbss_output *output, uint64_t step, vbss_output_result *result);

#endif
