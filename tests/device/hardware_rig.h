/* Devices on arms and handles as real hardware gives them, with the stand-ins in place of the vendors' libraries. Time is
 * simulated: a step is 1 ms, in which the servo ticks once, and the lines have a round every 2 ms, or when the calls of the
 * last one are over. */
#ifndef VBSS_TESTS_DEVICE_HARDWARE_RIG_H
#define VBSS_TESTS_DEVICE_HARDWARE_RIG_H

#include <vblast_ss/haptics.h>

#include "device/device.h"
#include "harness/harness.h"
#include "stand_ins/stand_ins.h"

typedef struct hardware_rig {
    harness_memory memory;
    vbss_context *context;
    const stand_in_hd_table *hd;
    const stand_in_daq_table *daq;
    vbss_openhaptics_config arms;
    vbss_nidaqmx_config lines;
    vbss_device_config config;
    vbss_openhaptics *openhaptics;
    vbss_nidaqmx *nidaqmx;
    vbss_device *devices[2];
    int device_count;
    uint64_t step;
    double now;
    vbss_device_input inputs[2];
    vbss_output_result results[2];
    uint64_t next_round; /* step of the lines' next round */
    vbss_output_command commands[2];
    vbss_device_coupling couplings[2]; /* used where there is any stiffness or damping */
    bool silent;                       /* the host does not write */
} hardware_rig;

/* The worlds anew; `threaded`: with a real scheduler and a thread for the lines. */
void hardware_rig_begin(hardware_rig *r, bool threaded);
/* The whole: arms, lines, devices. */
void hardware_rig_open(hardware_rig *r, int devices);
/* The hardware alone, in the present step. */
void hardware_rig_tick(hardware_rig *r);
void hardware_rig_steps(hardware_rig *r, int count);
/* Newton that the motors of an arm put out now. */
double hardware_rig_force(const hardware_rig *r, int arm);
bool hardware_rig_solenoid(const hardware_rig *r, int handle);
/* The text of the last error has this in it. */
void hardware_rig_expect_text(const hardware_rig *r, const char *wanted);
/* Ends all, and fails on any illegal call. */
void hardware_rig_end(hardware_rig *r);

#endif
