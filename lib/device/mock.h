/* The inside of mocks: an adapter without hardware (mock.c), and what goes wrong with it (mock_faults.c). */
#ifndef VBSS_DEVICE_MOCK_H
#define VBSS_DEVICE_MOCK_H

#include "device/device.h"

typedef struct mock_fault {
    vbss_mock_fault kind;
    double from, until, value;
} mock_fault;

/* now, force, torque, solenoid, flags */
enum { MOCK_ROW_NUMBERS = 9 };

typedef struct mock_object {
    vbss_context *context;
    vbss_mock_config config;
    vbss_device_capabilities capabilities;
    vbss_device_sample sample; /* the host's, when there is no function of time */
    mock_fault *faults;
    double *rows;
    uint32_t fault_count, row_count;
    uint64_t generation; /* grows when rows are forgotten */
    const char *failure; /* what failed last, a constant text */
    vbss_mock_statistics statistics;
} mock_object;

/* ---- mock_faults.c */
bool vbss_mock_needs_function(vbss_mock_fault fault);
vbss_result vbss_mock_check_fault(vbss_context *context, const mock_fault *f);
/* The time that a sample read now is of. */
double vbss_mock_sample_time(const mock_object *m, double now);
void vbss_mock_apply_faults(const mock_object *m, double now, vbss_device_sample *sample);
/* Whether a read or write fails now. */
bool vbss_mock_fails(mock_object *m, double now, bool reads);

#endif
