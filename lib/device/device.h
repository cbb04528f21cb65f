/* Internal interface of devices, shared by the files of lib/device.
 *
 * Some files only compute: calibration.c (frames), jaw.c (opening of the handle), motion.c
 * (velocities from poses), coupling.c (force of a virtual coupling), sample_check.c (validity of
 * samples), output_limiter.c and solenoid.c (limits of outputs). They know no handle and call no
 * adapter; adapter.c alone calls the functions of adapters. routing.c chooses between two adapters,
 * device.c creates devices, handle.c finds and destroys them. poll.c and read.c read them, send.c
 * and write.c write to them, takeover.c holds jaws until the handle has passed them, control.c has clutch, emergency stop, re-centring and calibration, and
 * views.c and snapshot.c report and save their state. output.c is the output stage
 * with a handle of its own, mock.c and mock_faults.c are an adapter without hardware, and mapping.c
 * is independent of devices.
 *
 * Units are SI. A time is in s on the host's clock unless the comment names another one. */
#ifndef VBSS_DEVICE_DEVICE_H
#define VBSS_DEVICE_DEVICE_H

#include <stddef.h>

#include <vblast_ss/device.h>
#include <vblast_ss/mapping.h>
#include <vblast_ss/mock.h>

#include "base/config.h"
#include "base/elementary.h"
#include "base/linear.h"
#include "base/slot.h"
#include "device/tuning.h"

/* ---- layouts of public structs */
extern const vbss_layout vbss_device_sample_layout, vbss_device_capabilities_layout;
extern const vbss_layout vbss_device_adapter_layout, vbss_device_calibration_layout;
extern const vbss_layout vbss_device_coupling_layout;
extern const vbss_layout vbss_output_config_layout, vbss_output_command_layout;
extern const vbss_layout vbss_output_result_layout, vbss_output_statistics_layout;

#define DEVICE_POSE_SIGNALS (VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION)
#define DEVICE_MOTION_SIGNALS (VBSS_DEVICE_HAS_VELOCITY | VBSS_DEVICE_HAS_ANGULAR_VELOCITY)
#define DEVICE_JAW_SIGNALS (VBSS_DEVICE_HAS_JAW_RAW | VBSS_DEVICE_HAS_JAW)
#define DEVICE_SIGNALS                                                                            \
    (DEVICE_POSE_SIGNALS | DEVICE_MOTION_SIGNALS | DEVICE_JAW_SIGNALS | VBSS_DEVICE_HAS_BUTTONS | \
     VBSS_DEVICE_HAS_TOOL | VBSS_DEVICE_HAS_TEMPERATURE)
#define DEVICE_OUTPUTS (VBSS_DEVICE_OUT_FORCE | VBSS_DEVICE_OUT_TORQUE | VBSS_DEVICE_OUT_SOLENOID)

/* Part of the way to a new value that a filter with a time constant goes in h seconds. */
static inline double device_smoothing_factor(double h, double time)
{
    return time > 0.0 ? 1.0 - vbss_exp(-vbss_max(h, 0.0) / time) : 1.0;
}

/* ---- calibration.c */

/* The transform between device and world that follows from a calibration. */
typedef struct device_frame {
    mat3 rotation; /* device to world, including exchanged and reversed axes */
    double parity; /* determinant of the rotation, -1 if the axes are mirrored, otherwise 1 */
    quat mount;    /* orientation of the tool at the device's identity, unit */
} device_frame;

/* Returns VBSS_OK, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE. */
vbss_result vbss_device_check_calibration(vbss_context *context, const vbss_device_calibration *c);
/* The calibration must be valid. */
device_frame vbss_device_make_frame(const vbss_device_calibration *c);
vec3 vbss_device_position_to_world(const vbss_device_calibration *c, const device_frame *f, vec3 p);
quat vbss_device_orientation_to_world(const device_frame *f, quat q);
vec3 vbss_device_velocity_to_world(const vbss_device_calibration *c, const device_frame *f, vec3 v);
/* Maps an angular velocity. */
vec3 vbss_device_spin_to_world(const device_frame *f, vec3 omega);
vec3 vbss_device_force_to_device(const vbss_device_calibration *c, const device_frame *f, vec3 v);
vec3 vbss_device_torque_to_device(const vbss_device_calibration *c, const device_frame *f, vec3 v);
/* Maps a difference of positions, or a velocity. */
vec3 vbss_device_displacement_to_device(const vbss_device_calibration *c, const device_frame *f,
                                        vec3 v);
/* Clamps a position in the world. Returns bits 1, 2, 4 for the x, y, z axes that were clamped. */
uint32_t vbss_device_clamp_to_workspace(const vbss_device_calibration *c, vec3 *p);

/* ---- jaw.c: raw value -> opening -> low-pass filter -> play -> closed state */

/* Filter of the opening of a handle, 0 closed to 1 open. */
typedef struct device_jaw {
    bool is_known, is_closed; /* there was an opening; the jaws count as closed */
    double filtered,
        after_play; /* after the low-pass filter; after the play, which follows half of it behind */
    double opening; /* after the play is compensated: the result */
} device_jaw;

/* Whether a raw value lies in the calibrated range, extended by jaw_margin. */
bool vbss_device_is_plausible_raw(const vbss_device_calibration *c, double raw);
/* Opening of a raw value, clamped to 0 to 1. */
double vbss_device_opening_from_raw(const vbss_device_calibration *c, double raw);
/* Adds an opening that was measured h seconds after the last one. */
void vbss_device_update_jaw(device_jaw *jaw, const vbss_device_calibration *c, double opening,
                            double h);

/* Jaws that wait for the handle to take them over. */
typedef struct device_takeover {
    bool is_waiting, is_new; /* is_new: not yet reported to the host; not saved */
    bool has_side, is_above; /* the handle was seen; it is further open than the jaws */
    double opening;          /* opening of the jaws, 0 to 1 */
} device_takeover;

/* ---- motion.c */

/* Estimate of velocities from poses, in the device's frame. */
typedef struct device_motion {
    bool has_position, has_velocity; /* the field of that name is known */
    bool has_orientation, has_spin;
    double time;                   /* when the last pose was measured, on the adapter's clock, s */
    vec3 position, velocity, spin; /* m, m/s, rad/s */
    quat orientation;
} device_motion;

void vbss_device_reset_motion(device_motion *m);
/* Adds a pose that was measured at `time`. `filter_time` is the time constant of the filter, s.
 * `orientation` is NULL if it is unknown. */
void vbss_device_update_motion(device_motion *m, double filter_time, double time, vec3 position,
                               const quat *orientation);

/* ---- adapter.c */

enum {
    DEVICE_SOURCES = 2,
    DEVICE_BUFFER_BYTES = 4096,
    DEVICE_NAME_BYTES = 32,
    DEVICE_TEXT_BYTES = 128
};

/* One adapter of a device. */
typedef struct device_source {
    vbss_device_adapter adapter;
    char name[DEVICE_NAME_BYTES], text[DEVICE_TEXT_BYTES]; /* text: explains the last failure */
    vbss_result last_failure; /* last result of a function that was not VBSS_OK */
    vbss_device_capabilities capabilities;
    uint64_t *buffer; /* DEVICE_BUFFER_BYTES bytes, room for a struct of any version */
    /* State, which snapshots save. */
    bool is_lost, has_fault, read_failed, /* read_failed: by the last read */
        has_time;                         /* `time` and `received_at` are known */
    double time, received_at; /* last accepted sample: adapter's clock, host's clock, s */
    bool is_slow; /* outputs go off too late; reported again after a restore, so not saved */
} device_source;

/* Copies a function table of this library to a struct of the host. Returns VBSS_OK,
 * VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE. */
vbss_result vbss_device_export_adapter(vbss_context *context, const vbss_device_adapter *own,
                                       vbss_device_adapter *adapter);
/* Copies a string. Truncates it to `capacity` bytes, which include the terminating zero. */
void vbss_device_copy_text(char *to, size_t capacity, const char *from);
/* Returns VBSS_ERROR_NULL_ARGUMENT if a required function is missing: `read` of the first adapter,
 * `read` or `write` of the second. */
vbss_result vbss_device_check_adapter(vbss_context *context, const vbss_device_adapter *a,
                                      bool first);
/* Opens an adapter, gets its capabilities and checks them. Returns VBSS_OK, VBSS_ERROR_DEVICE,
 * VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE; on failure the adapter is not open. */
vbss_result vbss_device_open_source(vbss_context *context, device_source *s);
void vbss_device_close_source(vbss_context *context, device_source *s);
/* Reads a sample and returns the adapter's result. `sample` is set also on failure, as its flags
 * count then; it lies in the buffer, so the next read or write overwrites it. */
vbss_result vbss_device_read_source(vbss_context *context, device_source *s, double now,
                                    const vbss_device_sample **sample);
/* Stores a result that is not VBSS_OK, and the adapter's explanation of it. */
void vbss_device_record_failure(vbss_context *context, device_source *s, vbss_result result);
/* Writes an output to an adapter; parts that are not in `outputs` (VBSS_DEVICE_OUT_ bits) are zero.
 * `coupling` is in the device's frame; NULL: none. Returns false if the adapter failed. */
bool vbss_device_write_source(vbss_context *context, device_source *s, double now,
                              const vbss_output_result *output,
                              const vbss_device_coupling *coupling, uint32_t outputs);

/* ---- sample_check.c */

typedef enum device_sample_status {
    DEVICE_SAMPLE_ACCEPTED,
    DEVICE_SAMPLE_REPEATED, /* its time has not advanced */
    DEVICE_SAMPLE_OUT_OF_ORDER,
    DEVICE_SAMPLE_NOT_FINITE,
    DEVICE_SAMPLE_OUT_OF_RANGE,
    DEVICE_SAMPLE_NOT_UNIT /* its orientation is not a unit quaternion */
} device_sample_status;

/* Checks the parts of a sample that `valid` names (VBSS_DEVICE_HAS_ bits). If it is accepted,
 * `restarted` tells whether it is older than the last one: the adapter's clock was reset. */
device_sample_status vbss_device_check_sample(const device_source *s,
                                              const vbss_device_sample *sample, uint32_t valid,
                                              double now, const vbss_device_config *config,
                                              bool *restarted);

/* ---- output_limiter.c and solenoid.c: without handles and contexts, for any thread */

/* Older than anything. */
#define OUTPUT_NEVER 1e9

/* Input of a step of the output stage. Forces are in the device's frame. */
typedef struct output_demand {
    vec3 force, torque;                 /* N, N m */
    double age, input_age, temperature; /* command's age, s; pose's age, s; 0 cold to 1 hot */
    bool solenoid, has_fault;           /* solenoid: it is wanted */
    bool block_solenoid; /* the solenoid must be off in this step; snapshots do not save it */
} output_demand;

typedef struct output_solenoid {
    bool is_on, is_exhausted; /* is_exhausted: it was on for too long, and is still wanted */
    double time_left;         /* time it may be on from now, s */
} output_solenoid;

typedef struct output_state {
    vec3 force, torque;             /* last outputs, N and N m */
    double force_load, torque_load; /* mean squares of the outputs, N^2 and N^2 m^2 */
    output_demand last_demand;      /* demand of the last command */
    bool is_stopped, is_ramping;    /* emergency stop latched; watchdog ramps forces to zero */
    double ramp_force, ramp_torque; /* magnitudes at the start of the ramp, N and N m */
    output_solenoid solenoid;
    vbss_output_statistics statistics;
} output_state;

/* Return VBSS_OK, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE. */
vbss_result vbss_output_check_config(vbss_context *context, const vbss_output_config *c);
vbss_result vbss_output_check_command(vbss_context *context, const vbss_output_command *c);
void vbss_output_init_state(const vbss_output_config *c, output_state *s);
/* Demand of a step without a new command: the last one, h seconds older. */
output_demand vbss_output_repeat_demand(const output_state *s, double h);
/* Stores a demand for such steps, without numbers that are not finite. */
void vbss_output_store_demand(output_state *s, const output_demand *demand);
/* Computes the outputs of a step of h seconds in the state. Returns VBSS_OUTPUT_FLAG_ bits. */
uint32_t vbss_output_advance(const vbss_output_config *c, output_state *s, double h,
                             const output_demand *demand);
/* Latches the emergency stop and sets the outputs to zero. */
void vbss_output_latch_stop(output_state *s);
/* Sets the outputs to zero, as those of the last step. */
void vbss_output_set_zero(output_state *s);
/* Fills the public result from the state. `flags` are VBSS_OUTPUT_FLAG_ bits. */
void vbss_output_fill_result(const vbss_output_config *c, const output_state *s, uint32_t flags,
                             vbss_output_result *result);
output_demand vbss_output_make_demand(const vbss_output_command *command);
/* Switches the solenoid for a step of h seconds. Returns VBSS_OUTPUT_FLAG_ bits that say why a wanted
 * solenoid is off. */
uint32_t vbss_output_switch_solenoid(const vbss_output_config *c, output_solenoid *s, double h,
                                     bool wanted, bool blocked, vbss_output_statistics *statistics);
extern const vbss_kind vbss_output_kind;
/* Visitors for the snapshots of devices and of output stages. */
void vbss_output_visit_config(vbss_stream *stream, const vbss_output_config *c);
void vbss_output_visit_state(vbss_stream *stream, const vbss_output_config *c, output_state *s);

/* ---- coupling.c */

/* Returns VBSS_OK, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE. */
vbss_result vbss_device_check_coupling(vbss_context *context, const vbss_device_coupling *c);
/* Force on a hand with this position and velocity, N. All are in the frame of the coupling. */
vec3 vbss_device_coupling_force(const vbss_device_coupling *c, vec3 position, vec3 velocity);

/* ---- device.c */

/* When a signal was measured, and whether it is stale. */
typedef struct device_reading {
    bool is_known, is_stale;
    double time, received_at, age; /* adapter's clock, s; host's clock, s; s, -1 while unknown */
} device_reading;

typedef struct device_object {
    vbss_context *context;
    vbss_device_config config;
    vbss_device_calibration calibration;
    device_frame frame;        /* follows from the calibration */
    vbss_output_config limits; /* limits of the host, reduced to the adapters' capabilities */
    double jaw_timeout;        /* age from which the opening is stale, s */
    uint32_t source_count;
    device_source sources[DEVICE_SOURCES];
    /* State, which snapshots save. */
    bool has_time, has_written;      /* there was a read or write; there was a write */
    double now, read_at, written_at; /* times of the last call, read and write, s */
    uint32_t known_signals;          /* VBSS_DEVICE_HAS_ bits of signals seen so far */
    device_reading pose_reading, opening_reading;
    vec3 position, velocity, spin; /* last sample, device's frame: m, m/s, rad/s */
    quat orientation;              /* last sample, handle to device frame */
    device_motion motion;
    device_jaw jaw;
    device_takeover takeover;
    double jaw_raw, temperature;
    uint32_t buttons;
    vbss_device_tool tool;
    bool is_clutched, write_failed;  /* write_failed: by the last write */
    vec3 position_offset;            /* by clutch and re-centring, in the world, m */
    quat orientation_offset;         /* by clutch and re-centring, in the tool's frame */
    pose clutch_pose, reported_pose; /* kept by the clutch; result of the last read */
    uint32_t events;                 /* VBSS_DEVICE_EVENT_ bits of this read; not saved */
    double off_until;                /* end of the pause after a jump of the clock, s; not saved */
    output_state output;
    vbss_device_statistics statistics;
} device_object;

/* Returns VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE unless `now` is finite, at most 1e9 s
 * in magnitude, and not before the last call. On an error it writes zeros to the adapters, because
 * the host cannot write anything else while its clock is wrong. */
vbss_result vbss_device_check_now(device_object *d, double now);

/* ---- routing.c */

/* VBSS_DEVICE_HAS_ bits that the device takes from a source. */
uint32_t vbss_device_routed_signals(const device_object *d, uint32_t source);
/* VBSS_DEVICE_OUT_ bits that the device writes to a source. */
uint32_t vbss_device_driven_outputs(const device_object *d, uint32_t source);

/* ---- handle.c */

/* The kind of all handles of devices. */
extern const vbss_kind vbss_device_kind;
/* The object of a handle, for calls that only read it and for calls that change it. */
vbss_result vbss_device_open(const vbss_device *handle, device_object **device);
vbss_result vbss_device_edit(vbss_device *handle, device_object **device);
/* Frees the memory of a device whose adapters are closed. */
void vbss_device_free(vbss_context *context, device_object *d);

/* ---- takeover.c: for devices with `jaw_takeover` */

/* Holds the reported opening until the handle has passed it. */
void vbss_device_hold_opening(device_object *d, double opening);
/* Lets the handle take over if it has passed the opening. */
void vbss_device_update_takeover(device_object *d);
double vbss_device_reported_opening(const device_object *d);
/* Whether the reported opening counts as closed. */
bool vbss_device_reports_closed(const device_object *d);

/* ---- poll.c, read.c, send.c, snapshot.c */

/* Reads one adapter and updates the state from its sample; does nothing if it has no `read`. */
void vbss_device_poll(device_object *d, uint32_t source, double now);
/* Pose of the last sample in the world, without the offsets of clutch and re-centring. */
pose vbss_device_calibrated_pose(const device_object *d);
/* Writes an output to each adapter that drives a part of it. `coupling` is in the device's frame;
 * NULL: none. Returns VBSS_OUTPUT_FLAG_NOT_WRITTEN if an adapter failed, otherwise 0. */
uint32_t vbss_device_send(device_object *d, const vbss_output_result *result,
                          const vbss_device_coupling *coupling);
/* Latches the emergency stop and writes zeros at once. */
void vbss_device_latch_stop(device_object *d);
/* Writes zeros at once; the next write may put out forces again. */
void vbss_device_switch_off(device_object *d);
/* Visitor for snapshots. */
void vbss_device_serialise(vbss_stream *stream, void *object);

#endif
