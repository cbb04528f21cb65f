/* The inside of handles and solenoids by NI-DAQmx: the vendor's functions and numbers (nidaqmx_library.c, nidaqmx_list.c), a round of
 * write and read (nidaqmx_cycle.c) in a thread of its own or the host's, and life and adapters on the host's side
 * (nidaqmx.c).
 *
 * Types and numbers are facts of the vendor's documentation, written down anew. */
#ifndef VBSS_DEVICE_NIDAQMX_H
#define VBSS_DEVICE_NIDAQMX_H

#include <vblast_ss/haptics.h>

#include "device/platform.h"

#ifdef _WIN32 /* of its own in 32 bits only */
#define DAQ_CALL __stdcall
#else
#define DAQ_CALL
#endif

/* ---- the vendor's numbers */

enum {
    DAQ_VOLTS = 10348,
    DAQ_RSE = 10083,
    DAQ_DIFFERENTIAL = 10106,
    DAQ_CHANNEL_FOR_ALL_LINES = 1,
    DAQ_GROUP_BY_CHANNEL = 0,
    DAQ_GROUP_BY_SCAN = 1
};

/* Results: 0 good, below an error, above a warning. A task is a pointer. */
typedef void *daq_task;

typedef struct daq_functions {
    void *library;
    int32_t(DAQ_CALL *create_task)(const char *name, daq_task *task);
    int32_t(DAQ_CALL *start_task)(daq_task task);
    int32_t(DAQ_CALL *stop_task)(daq_task task);
    int32_t(DAQ_CALL *clear_task)(daq_task task);
    int32_t(DAQ_CALL *create_voltage_input)(daq_task task, const char *physical, const char *name,
                                            int32_t terminal, double low, double high,
                                            int32_t units, const char *scale);
    int32_t(DAQ_CALL *create_digital_output)(daq_task task, const char *lines, const char *names,
                                             int32_t grouping);
    int32_t(DAQ_CALL *read_analog)(daq_task task, int32_t samples, double timeout, uint32_t fill,
                                   double *values, uint32_t room, int32_t *read,
                                   uint32_t *reserved);
    int32_t(DAQ_CALL *write_digital)(daq_task task, int32_t samples, uint32_t auto_start,
                                     double timeout, uint32_t layout, const uint8_t *lines,
                                     int32_t *written, uint32_t *reserved);
    int32_t(DAQ_CALL *get_extended_error)(char *text, uint32_t bytes);
    int32_t(DAQ_CALL *get_device_names)(char *text, uint32_t bytes);
    int32_t(DAQ_CALL *get_product)(const char *device, char *text, uint32_t bytes);
} daq_functions;

/* ---- nidaqmx_library.c */
vbss_result vbss_nidaqmx_load(vbss_context *context, const char *name, daq_functions *daq);
const char *vbss_nidaqmx_error_name(int32_t code);
/* Errors after which the hardware is not there any more. */
bool vbss_nidaqmx_is_lost(int32_t code);
/* VBSS_ERROR_DEVICE with what the vendor's library says; warnings are VBSS_OK. */
vbss_result vbss_nidaqmx_check(vbss_context *context, const daq_functions *daq, int32_t code,
                               const char *what);

/* ---- what goes between the host and the rounds */

enum { DAQ_HANDLES = 2, DAQ_NAME_BYTES = 128 };

typedef struct handle_command {
    bool is_on;
    double expires; /* s */
} handle_command;

typedef struct daq_report {
    bool has_sample;
    double time, volts[DAQ_HANDLES];
    vbss_nidaqmx_status status;
} daq_report;

typedef struct nidaqmx_object nidaqmx_object;

/* One handle as the host sees it. */
typedef struct daq_handle {
    device_triple_buffer to_cycle;
    nidaqmx_object *owner;
    vbss_slot *slot; /* handle of its own, for adapters */
    uint32_t handle_index;
    bool is_slot_filled, is_attached; /* attached: a device stands on it */
    char text[DEVICE_TEXT_BYTES];
    handle_command commands[3];
    /* the round's alone */
    double commanded_at;
} daq_handle;

struct nidaqmx_object {
    device_triple_buffer to_host;
    daq_handle handles[DAQ_HANDLES];
    vbss_context *context;
    daq_functions daq;
    vbss_nidaqmx_config config;
    char inputs[DAQ_HANDLES][DAQ_NAME_BYTES],
        lines[DAQ_HANDLES][DAQ_NAME_BYTES]; /* line empty: there is no solenoid */
    uint32_t handle_count;
    bool has_lines, lines_open; /* driving: the lines are open */
    daq_task analog, digital;
    device_thread thread;
    bool has_thread;
    atomic_bool stop_requested;
    daq_report reports[3];
    /* the round's alone */
    bool levels_written, read_failed,
        is_lost; /* written: `out` is what the lines have; failing: the last read did */
    uint8_t levels[DAQ_HANDLES];
    double cycle_start, cycle_interval; /* s; spacing: from the round before, a period at least */
    daq_report report;
};

/* ---- nidaqmx_cycle.c */
void vbss_nidaqmx_cycle(nidaqmx_object *o, double now);
/* Solenoids off. */
int32_t vbss_nidaqmx_switch_off(nidaqmx_object *o);
void vbss_nidaqmx_run(void *user);

#endif
