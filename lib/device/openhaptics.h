/* The inside of haptic arms by OpenHaptics: the vendor's functions and numbers (openhaptics_library.c), a tick of the
 * servo (openhaptics_servo.c), and life and adapters on the host's side (openhaptics.c).
 *
 * Types and numbers are facts of the vendor's documentation, written down anew. */
#ifndef VBSS_DEVICE_OPENHAPTICS_H
#define VBSS_DEVICE_OPENHAPTICS_H

#include <vblast_ss/haptics.h>

#include "device/platform.h"

#ifdef _WIN32 /* of its own in 32 bits only */
#define HD_CALL __stdcall
#else
#define HD_CALL
#endif

/* ---- the vendor's numbers */

#define HD_NO_DEVICE 0xFFFFFFFFu
enum {
    HD_DONE = 0,
    HD_CONTINUE = 1,
    HD_CHECK_STATUS = 0,
    HD_MAX_PRIORITY = 65535,
    HD_WARM_MOTORS = 0x0200,
    HD_FORCE_ERROR = 0x0204,
    HD_CURRENT_BUTTONS = 0x2000,
    HD_CURRENT_VELOCITY = 0x2051,
    HD_CURRENT_TRANSFORM = 0x2052,
    HD_CURRENT_ANGULAR_VELOCITY = 0x2053,
    HD_DEVICE_MODEL_TYPE = 0x2501,
    HD_DEVICE_SERIAL_NUMBER = 0x2504,
    HD_MAX_WORKSPACE_DIMENSIONS = 0x2550,
    HD_INPUT_DOF = 0x2553,
    HD_OUTPUT_DOF = 0x2554,
    HD_CALIBRATION_STYLE = 0x2555,
    HD_NOMINAL_MAX_FORCE = 0x2603,
    HD_NOMINAL_MAX_CONTINUOUS_FORCE = 0x2604,
    HD_MOTOR_TEMPERATURE = 0x2605,
    HD_CURRENT_FORCE = 0x2700,
    HD_FORCE_OUTPUT = 0x4000,
    HD_CALIBRATION_OK = 0x5000,
    HD_CALIBRATION_NEEDS_UPDATE = 0x5001,
    HD_STYLE_ENCODER_RESET = 1,
    HD_STYLE_AUTO = 2,
    HD_STYLE_INKWELL = 4
};

/* Last in, first out; returned by value. */
typedef struct hd_error {
    uint32_t code;
    int32_t internal;
    uint32_t device;
} hd_error;
_Static_assert(sizeof(hd_error) == 12, "as the vendor's library returns it");

typedef uint32_t(HD_CALL *hd_callback)(void *user);

/* Handles of the scheduler are `unsigned long`: of 8 bytes on 64-bit Linux, 4 on Windows. */
typedef struct hd_functions {
    void *library;
    uint32_t(HD_CALL *init_device)(const char *name);
    void(HD_CALL *disable_device)(uint32_t device);
    void(HD_CALL *make_current_device)(uint32_t device);
    void(HD_CALL *begin_frame)(uint32_t device);
    void(HD_CALL *end_frame)(uint32_t device);
    hd_error(HD_CALL *get_error)(void);
    void(HD_CALL *enable)(uint32_t capability);
    void(HD_CALL *disable)(uint32_t capability);
    void(HD_CALL *get_doublev)(uint32_t name, double *values);
    void(HD_CALL *get_integerv)(uint32_t name, int32_t *values);
    void(HD_CALL *set_doublev)(uint32_t name, const double *values);
    const char *(HD_CALL *get_string)(uint32_t name);
    void(HD_CALL *start_scheduler)(void);
    void(HD_CALL *stop_scheduler)(void);
    void(HD_CALL *set_scheduler_rate)(unsigned long rate);
    unsigned long(HD_CALL *schedule)(hd_callback callback, void *user, uint16_t priority);
    void(HD_CALL *unschedule)(unsigned long handle);
    uint8_t(HD_CALL *wait_for_completion)(unsigned long handle, uint32_t code);
    double(HD_CALL *get_time_stamp)(void);
    uint32_t(HD_CALL *check_calibration)(void);
    void(HD_CALL *update_calibration)(uint32_t style);
} hd_functions;

/* ---- openhaptics_library.c */
vbss_result vbss_openhaptics_load(vbss_context *context, const char *name, hd_functions *hd);
const char *vbss_openhaptics_error_name(uint32_t code);
/* VBSS_ERROR_DEVICE with the oldest error that waits, or VBSS_OK; none waits afterwards. */
vbss_result vbss_openhaptics_check(vbss_context *context, const hd_functions *hd, const char *what);

/* ---- what goes between the host and the servo */

typedef struct arm_command {
    bool is_given, is_coupled;
    vec3 force;
    vbss_device_coupling coupling; /* device's frame */
} arm_command;

typedef struct arm_report {
    vbss_device_sample sample;
    vbss_openhaptics_status status;
} arm_report;

enum { OPENHAPTICS_ARMS = 2, ARM_NAME_BYTES = 64 };

typedef struct haptic_arm {
    device_triple_buffer to_servo, to_host;
    vbss_slot *slot; /* handle of its own, for adapters */
    uint32_t device;
    bool is_slot_filled, is_open, is_attached; /* attached: a device stands on it */
    int32_t calibration_style;                 /* of calibration */
    char model[ARM_NAME_BYTES], serial[ARM_NAME_BYTES];
    char text[DEVICE_TEXT_BYTES]; /* what failed last, on the host's side */
    vbss_device_capabilities capabilities;
    vbss_output_config limits; /* of the stage in the servo */
    arm_command commands[3];
    arm_report reports[3];
    /* the servo's alone */
    output_state output;
    vbss_device_sample sample;
    vbss_openhaptics_status status;
    uint64_t command_tick, failed_tick, lost_until_tick, refused_until_tick; /* ticks, from 1 on */
    bool is_calibrated;
} haptic_arm;

typedef struct openhaptics_object {
    vbss_context *context;
    hd_functions hd;
    vbss_openhaptics_config config;
    uint32_t arm_count;
    haptic_arm arms[OPENHAPTICS_ARMS];
    unsigned long callback;
    bool is_scheduled, is_started;
    uint64_t tick; /* the servo's */
    atomic_bool stop_requested, has_stopped;
} openhaptics_object;

/* ---- openhaptics_servo.c: in the vendor's thread */
uint32_t HD_CALL vbss_openhaptics_tick(void *user);

#endif
