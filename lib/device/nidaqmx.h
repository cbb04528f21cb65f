/* Internal interface of instrument handles and solenoids that are connected by NI-DAQmx.
 *
 * nidaqmx_library.c and nidaqmx_list.c call the vendor's library. nidaqmx_lines.c opens and closes
 * the lines. nidaqmx_cycle.c has the cycle of writing and reading, which runs in a thread of its own
 * or in one of the host, and nidaqmx_recovery.c its recovery from errors. nidaqmx.c has the host's
 * side: creation and adapters.
 *
 * Types and constants follow the vendor's documentation; no header of the vendor is used. */
#ifndef VBSS_DEVICE_NIDAQMX_H
#define VBSS_DEVICE_NIDAQMX_H

#include <vblast_ss/haptics.h>

#include "base/triple_buffer.h"
#include "device/platform.h"

#ifdef _WIN32 /* matters in 32-bit builds only */
#define DAQ_CALL __stdcall
#else
#define DAQ_CALL
#endif

/* ---- the vendor's constants and functions */

enum {
    DAQ_VOLTS = 10348,
    DAQ_RSE = 10083,
    DAQ_DIFFERENTIAL = 10106,
    DAQ_CHANNEL_FOR_ALL_LINES = 1,
    DAQ_GROUP_BY_CHANNEL = 0,
    DAQ_GROUP_BY_SCAN = 1,
    DAQ_NO_DEVICE = -200220
};

enum {
    DAQ_TIMEOUTS_IN_A_ROW = 2, /* a single timeout does not show a slow device */
    DAQ_OPENING_ATTEMPTS = 10  /* for the first write, while it times out */
};

/* An opaque pointer. */
typedef void *daq_task;

/* Functions return 0, a negative error code, or a positive warning code. */
typedef struct daq_functions {
    void *library;
    bool is_base; /* NI-DAQmx Base: `write_digital` takes the bits of a port; no list of devices */
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

/* Loads the vendor's library and finds its functions. `name` is a path or file name; NULL: the
 * usual name. Returns VBSS_OK or VBSS_ERROR_DEVICE; the caller unloads the library in both
 * cases. */
vbss_result vbss_nidaqmx_load(vbss_context *context, const char *name, daq_functions *daq);
/* Description of an error code, never NULL. */
const char *vbss_nidaqmx_error_name(int32_t code);

/* Remedy after an error code of the vendor. */
typedef enum daq_remedy {
    DAQ_FINE,
    DAQ_RETRY,  /* a timeout: the next call may succeed */
    DAQ_REOPEN, /* a transient error that ends the task: the lines must be opened again */
    DAQ_LOST    /* the device is not there; the lines can be opened again when it is back */
} daq_remedy;

daq_remedy vbss_nidaqmx_remedy(int32_t code);
/* Returns VBSS_OK for success and warnings. For errors it returns VBSS_ERROR_DEVICE, with `what`
 * and the vendor's description in the error text. */
vbss_result vbss_nidaqmx_check(vbss_context *context, const daq_functions *daq, int32_t code,
                               const char *what);

/* ---- data exchanged between the host and the cycle */

enum { DAQ_HANDLES = 2, DAQ_NAME_BYTES = 128 };

/* Command of the host for the solenoid of a handle. */
typedef struct handle_command {
    bool is_on;
    double expires; /* age from which the command counts as off, s */
} handle_command;

/* Result of a cycle. */
typedef struct daq_report {
    bool has_sample, is_slow, has_late_reads; /* has_late_reads: the last ones have timed out */
    double time, volts[DAQ_HANDLES];          /* last good read: clock of the cycle, s; V */
    vbss_nidaqmx_status status;
} daq_report;

typedef struct nidaqmx_object nidaqmx_object;

/* One instrument handle. */
typedef struct daq_handle {
    vbss_triple_buffer to_cycle; /* says which of `commands` is whose */
    nidaqmx_object *owner;
    vbss_slot *slot; /* the adapter's `user` */
    uint32_t handle_index;
    bool is_slot_filled, is_attached; /* is_attached: a device uses the adapter */
    char text[DEVICE_TEXT_BYTES];     /* explains the last failure */
    handle_command commands[3];
    /* Used by the cycle only. */
    double commanded_at; /* when the cycle found the current command, s */
} daq_handle;

/* All handles; they share one analog and one digital task. */
struct nidaqmx_object {
    vbss_triple_buffer to_host; /* says which of `reports` is whose */
    daq_handle handles[DAQ_HANDLES];
    vbss_context *context;
    daq_functions daq;
    vbss_nidaqmx_config config;
    char inputs[DAQ_HANDLES][DAQ_NAME_BYTES],
        lines[DAQ_HANDLES][DAQ_NAME_BYTES]; /* channels per handle; line "": no solenoid */
    uint32_t handle_count;
    bool has_lines, lines_open;       /* a handle has a solenoid; the task has its channel */
    char channel[2 * DAQ_NAME_BYTES]; /* all lines, or their port for NI-DAQmx Base */
    uint32_t line_bits[DAQ_HANDLES];  /* bits of the lines in their port */
    daq_task analog, digital;         /* NULL while not created */
    device_thread thread;
    bool has_thread;
    atomic_bool stop_requested;
    daq_report reports[3];
    /* Used by the cycle only. */
    bool levels_written, read_failed, is_lost; /* levels_written: the lines have `levels` */
    bool must_reopen, is_slow;   /* is_slow: solenoids go off later than commands expire */
    uint8_t levels[DAQ_HANDLES]; /* 0 or 1 per line */
    uint32_t read_timeouts, write_timeouts, quick_calls; /* each in a row */
    double timeout, write_time;      /* current timeout of calls; duration of the last write, s */
    double trouble_since, reopen_at; /* first error; earliest next attempt to open the lines, s */
    /* Start of this cycle, and time since the start of the one before, at least a period, s. */
    double cycle_start, cycle_interval;
    daq_report report;
};

/* ---- nidaqmx_lines.c */

/* Finds the name of the channel of all lines. Returns false if NI-DAQmx Base cannot write to them
 * together: they must be lines of one port. */
bool vbss_nidaqmx_name_channel(nidaqmx_object *o);
/* Opens inputs and lines, with the solenoids off. Returns the vendor's code and, in `what`, the part
 * that it is about. After a failure the caller closes the tasks. */
int32_t vbss_nidaqmx_open_tasks(nidaqmx_object *o, const char **what);
/* Switches the solenoids off and closes the tasks that are open. */
void vbss_nidaqmx_close_tasks(nidaqmx_object *o);

/* ---- nidaqmx_recovery.c */

/* Stores the code of a read or write that took `duration` s. `in_a_row` counts its timeouts. */
void vbss_nidaqmx_record_code(nidaqmx_object *o, int32_t code, double duration, uint32_t *in_a_row);
/* Opens the lines again if an error has made that necessary. */
void vbss_nidaqmx_recover(nidaqmx_object *o, double now);
/* Compares the pace of the cycles with the time after which commands expire, s; 0: unknown. */
void vbss_nidaqmx_update_rate(nidaqmx_object *o, double expires);

/* ---- nidaqmx_cycle.c */

/* Runs one cycle: writes the solenoids, reads the inputs and publishes a report. Blocks for as long
 * as the hardware takes. `now` is the clock of the cycle, s. */
void vbss_nidaqmx_cycle(nidaqmx_object *o, double now);
/* Switches all solenoids off. Returns the vendor's code. */
int32_t vbss_nidaqmx_switch_off(nidaqmx_object *o);
/* Body of the thread: runs cycles until stop_requested. `user` is a nidaqmx_object. */
void vbss_nidaqmx_run(void *user);

#endif
