/* The inside of devices, shared by the files of lib/device.
 *
 * Pure parts know neither handles nor each other: calibration.c between frames, jaw.c the handle's opening,
 * motion.c velocities out of poses, coupling.c the force on a tied hand, sample_check.c what is wrong with a sample, output_limiter.c and solenoid.c what may go out.
 * Adapters are called in adapter.c alone. On these stand device.c (life), poll.c and read.c (a read), write.c (a
 * write), control.c (clutch, stop, calibrating), views.c and snapshot.c; output.c is the stage behind a handle of its
 * own; mock.c and mock_faults.c an adapter without hardware; mapping.c stands alone. */
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

/* ---- layouts of the structs that cross the border */
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

/* Later by less is no new sample, s. */
#define DEVICE_MIN_SAMPLE_SPACING 1e-6

/* Part of the way to a new value that a filter with a time constant goes in h seconds. */
static inline double device_smoothing_factor(double h, double time)
{
    return time > 0.0 ? 1.0 - vbss_exp(-vbss_max(h, 0.0) / time) : 1.0;
}

/* ---- calibration.c */

typedef struct device_frame {
    mat3 rotation; /* device to world */
    double parity; /* its determinant, 1 or -1 */
    quat mount;
} device_frame;
vbss_result vbss_device_check_calibration(vbss_context *context, const vbss_device_calibration *c);
device_frame vbss_device_make_frame(const vbss_device_calibration *c);
vec3 vbss_device_position_to_world(const vbss_device_calibration *c, const device_frame *f, vec3 p);
quat vbss_device_orientation_to_world(const device_frame *f, quat q);
vec3 vbss_device_velocity_to_world(const vbss_device_calibration *c, const device_frame *f, vec3 v);
vec3 vbss_device_spin_to_world(const device_frame *f, vec3 omega);
vec3 vbss_device_force_to_device(const vbss_device_calibration *c, const device_frame *f, vec3 v);
vec3 vbss_device_torque_to_device(const vbss_device_calibration *c, const device_frame *f, vec3 v);
/* A difference of positions or a velocity. */
vec3 vbss_device_displacement_to_device(const vbss_device_calibration *c, const device_frame *f,
                                        vec3 v);
/* Into the workspace; bits of the axes that were outside. */
uint32_t vbss_device_clamp_to_workspace(const vbss_device_calibration *c, vec3 *p);

/* ---- jaw.c: raw value -> opening -> filter -> play -> closed or not */

typedef struct device_jaw {
    bool is_known, is_closed;
    double filtered,
        after_play; /* play: where the filtered value was left behind by half the play */
    double opening;
} device_jaw;
bool vbss_device_is_plausible_raw(const vbss_device_calibration *c, double raw);
double vbss_device_opening_from_raw(const vbss_device_calibration *c, double raw);
void vbss_device_update_jaw(device_jaw *jaw, const vbss_device_calibration *c, double opening,
                            double h);

/* ---- motion.c: filtered differences over time stamps, in the device's frame */

typedef struct device_motion {
    bool has_position, has_velocity; /* there was a position; a velocity */
    bool has_orientation, has_spin;  /* an orientation; a spin */
    double time;
    vec3 position, velocity, spin;
    quat orientation;
} device_motion;
void vbss_device_reset_motion(device_motion *m);
/* `orientation` NULL: not known. */
void vbss_device_update_motion(device_motion *m, double filter_time, double time, vec3 position,
                               const quat *orientation);

/* ---- adapter.c: the host's functions, and what they are handed */

enum {
    DEVICE_SOURCES = 2,
    DEVICE_BUFFER_BYTES = 4096,
    DEVICE_NAME_BYTES = 32,
    DEVICE_TEXT_BYTES = 128
};

typedef struct device_source {
    vbss_device_adapter adapter;
    char name[DEVICE_NAME_BYTES], text[DEVICE_TEXT_BYTES];
    vbss_result last_failure; /* what it returned last that was not VBSS_OK */
    vbss_device_capabilities capabilities;
    uint64_t *buffer; /* DEVICE_BUFFER_BYTES bytes for a struct of any version */
    /* state */
    bool is_lost, has_fault, read_failed,
        has_time;             /* mute: the last read failed; timed: `time` is the last sample's */
    double time, received_at; /* heard: the host's time then */
} device_source;

/* A table of this library's functions for a host. */
vbss_result vbss_device_export_adapter(vbss_context *context, const vbss_device_adapter *own,
                                       vbss_device_adapter *adapter);
/* As much as there is room for. */
void vbss_device_copy_text(char *to, size_t capacity, const char *from);
vbss_result vbss_device_check_adapter(vbss_context *context, const vbss_device_adapter *a,
                                      bool first);
/* VBSS_ERROR_DEVICE, told, and the adapter is closed; capabilities are checked. */
vbss_result vbss_device_open_source(vbss_context *context, device_source *s);
void vbss_device_close_source(vbss_context *context, device_source *s);
/* `sample` is the adapter's until the next call; filled as far as this library knows it. */
vbss_result vbss_device_read_source(vbss_context *context, device_source *s, double now,
                                    const vbss_device_sample **sample);
/* Keeps what the adapter returned, and what it says of that. */
void vbss_device_record_failure(vbss_context *context, device_source *s, vbss_result result);
/* Only what the adapter has; true when there was nothing to write. `coupling` NULL: there is none. */
bool vbss_device_write_source(vbss_context *context, device_source *s, double now,
                              const vbss_output_result *output,
                              const vbss_device_coupling *coupling, uint32_t outputs);

/* ---- sample_check.c: what is wrong with a sample, first to last */

typedef enum device_sample_status {
    DEVICE_SAMPLE_ACCEPTED,
    DEVICE_SAMPLE_REPEATED,
    DEVICE_SAMPLE_OUT_OF_ORDER,
    DEVICE_SAMPLE_NOT_FINITE,
    DEVICE_SAMPLE_OUT_OF_RANGE,
    DEVICE_SAMPLE_NOT_UNIT
} device_sample_status;
/* Of the parts in `valid`. `restarted` of one that is taken: older than the last, it is the begin of a new time. */
device_sample_status vbss_device_check_sample(const device_source *s,
                                              const vbss_device_sample *sample, uint32_t valid,
                                              double now, const vbss_device_config *config,
                                              bool *restarted);

/* ---- output_limiter.c and solenoid.c: what may go out. No handles, no context. */

/* Older than anything. */
#define OUTPUT_NEVER 1e9
/* The longest step that forces may rise for, s. */
#define OUTPUT_MAX_RISE_TIME 0.01

typedef struct output_demand {
    vec3 force, torque;
    double age, input_age, temperature;
    bool solenoid, has_fault;
    bool block_solenoid; /* the solenoid must be off; not kept */
} output_demand;

typedef struct output_solenoid {
    bool is_on, is_exhausted; /* spent: wanted for too long, and wanted still */
    double time_left;         /* s that it may be on */
} output_solenoid;

typedef struct output_state {
    vec3 force, torque;             /* that went out last */
    double force_load, torque_load; /* mean squares, N^2, N^2 m^2 */
    output_demand last_demand;      /* the last command */
    bool is_stopped, is_ramping;
    double ramp_force, ramp_torque; /* where the ramp began, N, N m */
    output_solenoid solenoid;
    vbss_output_statistics statistics;
} output_state;

vbss_result vbss_output_check_config(vbss_context *context, const vbss_output_config *c);
vbss_result vbss_output_check_command(vbss_context *context, const vbss_output_command *c);
void vbss_output_init_state(const vbss_output_config *c, output_state *s);
/* What a step without a new command goes by: the last, older by h. */
output_demand vbss_output_repeat_demand(const output_state *s, double h);
/* Keeps a command for such steps, with numbers that can be saved. */
void vbss_output_store_demand(output_state *s, const output_demand *demand);
/* Bits of what was done; the results stand in the state. */
uint32_t vbss_output_advance(const vbss_output_config *c, output_state *s, double h,
                             const output_demand *demand);
/* Zeros at once, and for good. */
void vbss_output_latch_stop(output_state *s);
void vbss_output_fill_result(const vbss_output_config *c, const output_state *s, uint32_t flags,
                             vbss_output_result *result);
output_demand vbss_output_make_demand(const vbss_output_command *command);
uint32_t vbss_output_switch_solenoid(const vbss_output_config *c, output_solenoid *s, double h,
                                     bool wanted, bool blocked, vbss_output_statistics *statistics);
extern const vbss_kind vbss_output_kind;
/* In both handles' states. */
void vbss_output_visit_config(vbss_stream *stream, const vbss_output_config *c);
void vbss_output_visit_state(vbss_stream *stream, const vbss_output_config *c, output_state *s);

/* ---- coupling.c */
vbss_result vbss_device_check_coupling(vbss_context *context, const vbss_device_coupling *c);
/* On a hand; of a coupling in the same frame. */
vec3 vbss_device_coupling_force(const vbss_device_coupling *c, vec3 position, vec3 velocity);

/* ---- device.c */

/* A value that grows old. */
typedef struct device_reading {
    bool is_known, is_stale;
    double time, received_at, age; /* by the adapter's clock; by the host's; s */
} device_reading;

typedef struct device_object {
    vbss_context *context;
    vbss_device_config config;
    vbss_device_calibration calibration;
    device_frame frame;        /* out of it */
    vbss_output_config limits; /* within what the adapters can */
    double jaw_timeout;
    uint32_t source_count;
    device_source sources[DEVICE_SOURCES];
    /* state */
    bool has_time, has_written; /* there was a call; a write */
    double now, read_at, written_at;
    uint32_t known_signals; /* VBSS_DEVICE_HAS_ bits */
    device_reading pose_reading, opening_reading;
    vec3 position, velocity, spin; /* last sample, device frame */
    quat orientation;
    device_motion motion;
    device_jaw jaw;
    double jaw_raw, temperature;
    uint32_t buttons;
    vbss_device_tool tool;
    bool is_clutched, write_failed; /* unwritten: the last write failed */
    vec3 position_offset;           /* of clutch and re-centring */
    quat orientation_offset;
    pose clutch_pose, reported_pose; /* held by the clutch; as the last read told it */
    uint32_t events;                 /* of the read that goes on; no state */
    output_state output;
    vbss_device_statistics statistics;
} device_object;

extern const vbss_kind vbss_device_kind;
vbss_result vbss_device_open(const vbss_device *handle, device_object **device);
vbss_result vbss_device_edit(vbss_device *handle, device_object **device);
/* Finite, and not before the last. */
vbss_result vbss_device_check_now(const device_object *d, double now);
/* Which signals a source is asked for, and which outputs it is given. */
uint32_t vbss_device_routed_signals(const device_object *d, uint32_t source);
uint32_t vbss_device_driven_outputs(const device_object *d, uint32_t source);

/* ---- poll.c, read.c, write.c, control.c, snapshot.c */

/* Reads one adapter, if it can be read. */
void vbss_device_poll(device_object *d, uint32_t source, double now);
/* The pose that the last sample stands for, before clutch and re-centring. */
pose vbss_device_calibrated_pose(const device_object *d);
/* Writes to the adapters what they have of it; VBSS_OUTPUT_NOT_WRITTEN when one did not take it. `coupling`
 * in the device's frame, NULL: there is none. */
uint32_t vbss_device_send(device_object *d, const vbss_output_result *result,
                          const vbss_device_coupling *coupling);
/* Latches the emergency stop and writes zeros at once. */
void vbss_device_latch_stop(device_object *d);
void vbss_device_serialise(vbss_stream *stream, void *object);
void vbss_device_visit_bool(vbss_stream *stream, uint16_t tag, bool *value);

#endif
