/* Internal interface of mocks: an adapter without hardware (mock.c) and its faults
 * (mock_faults.c). */
#ifndef VBSS_DEVICE_MOCK_H
#define VBSS_DEVICE_MOCK_H

#include "device/device.h"

/* A fault that is active from `from` until before `until`, on the host's clock, s. The meaning of
 * `value` depends on the kind. */
typedef struct mock_fault {
    vbss_mock_fault kind;
    double from, until, value;
} mock_fault;

/* Format of a row, chosen: now, force, torque, solenoid, flags. */
enum { MOCK_ROW_NUMBERS = 9 };

typedef struct mock_object {
    vbss_context *context;
    vbss_mock_config config;
    vbss_device_capabilities capabilities;
    vbss_device_sample sample; /* given by the host; used if the config has no `measure` */
    mock_fault *faults;        /* in the order in which they apply */
    double *rows;              /* MOCK_ROW_NUMBERS per recorded write */
    uint32_t fault_count, row_count;
    uint64_t generation; /* number of times that the rows were cleared */
    const char *failure; /* explains the last failure; a string literal */
    vbss_mock_statistics statistics;
} mock_object;

/* ---- mock_faults.c */

/* Whether the fault changes the time of samples, which requires `measure` in the config. */
bool vbss_mock_needs_function(vbss_mock_fault fault);
/* Returns VBSS_OK, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE. */
vbss_result vbss_mock_check_fault(vbss_context *context, const mock_fault *f);
/* Time at which the sample of a read at `now` is measured, s. */
double vbss_mock_sample_time(const mock_object *m, double now);
void vbss_mock_apply_faults(const mock_object *m, double now, vbss_device_sample *sample);
/* Whether a read, or otherwise a write, fails at `now`. Sets `failure` if it does. */
bool vbss_mock_fails(mock_object *m, double now, bool reads);

#endif
