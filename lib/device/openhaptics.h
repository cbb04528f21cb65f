/* Internal interface of haptic arms that are connected by OpenHaptics.
 *
 * openhaptics_library.c calls the vendor's library, openhaptics_servo.c is a tick of the servo, and
 * openhaptics.c has the host's side: creation and adapters.
 *
 * Types and constants follow the vendor's documentation; no header of the vendor is used. */
#ifndef VBSS_DEVICE_OPENHAPTICS_H
#define VBSS_DEVICE_OPENHAPTICS_H

#include <vblast_ss/haptics.h>

#include "base/triple_buffer.h"
#include "device/platform.h"

#ifdef _WIN32 /* matters in 32-bit builds only */
#define HD_CALL __stdcall
#else
#define HD_CALL
#endif

/* ---- the vendor's constants and functions */

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

/* Entry of the vendor's error stack. */
typedef struct hd_error {
    uint32_t code;
    int32_t internal;
    uint32_t device;
} hd_error;
_Static_assert(sizeof(hd_error) == 12, "as the vendor's library returns it");

typedef uint32_t(HD_CALL *hd_callback)(void *user);

/* Handles of the scheduler are `unsigned long`, which has 8 bytes on 64-bit Linux and 4 on
 * Windows. */
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

/* Loads the vendor's library and finds its functions. `name` is a path or file name; NULL: the
 * usual name. Returns VBSS_OK or VBSS_ERROR_DEVICE; the caller unloads the library in both
 * cases. */
vbss_result vbss_openhaptics_load(vbss_context *context, const char *name, hd_functions *hd);
/* Description of an error code, never NULL. */
const char *vbss_openhaptics_error_name(uint32_t code);
/* Empties the vendor's error stack. Returns VBSS_OK if it was empty; otherwise VBSS_ERROR_DEVICE,
 * with `what` and the oldest error in the error text. */
vbss_result vbss_openhaptics_check(vbss_context *context, const hd_functions *hd, const char *what);

/* ---- data exchanged between the host and the servo */

/* Command of the host, in the device's frame. */
typedef struct arm_command {
    bool is_given, is_coupled;     /* there was a command; `coupling` replaces `force` */
    vec3 force;                    /* N */
    vbss_device_coupling coupling; /* its `force` includes all other forces */
} arm_command;

/* Result of a tick. */
typedef struct arm_report {
    vbss_device_sample sample;
    vbss_openhaptics_status status;
} arm_report;

enum { OPENHAPTICS_ARMS = 2, ARM_NAME_BYTES = 64 };

typedef struct haptic_arm {
    vbss_triple_buffer to_servo, to_host;      /* say which of `commands` and `reports` is whose */
    vbss_slot *slot;                           /* the adapter's `user` */
    uint32_t device;                           /* the vendor's handle */
    bool is_slot_filled, is_open, is_attached; /* is_attached: a device uses the adapter */
    int32_t calibration_style;                 /* HD_STYLE_ constant */
    char model[ARM_NAME_BYTES], serial[ARM_NAME_BYTES];
    char text[DEVICE_TEXT_BYTES]; /* explains the last failure, for the host */
    vbss_device_capabilities capabilities;
    vbss_output_config limits; /* limits of the output stage in the servo */
    arm_command commands[3];
    arm_report reports[3];
    /* Used by the servo only. */
    output_state output;
    vbss_device_sample sample;
    vbss_openhaptics_status status;
    /* Tick that found the current command; tick of the last failure; ends of being lost and of
     * refusing forces. Ticks count from 1. */
    uint64_t command_tick, failed_tick, lost_until_tick, refused_until_tick;
    bool is_calibrated;
    double last_transform[16];      /* as the vendor's library gave it */
    uint64_t transform_change_tick; /* when it last changed */
} haptic_arm;

/* All arms; one servo drives them. */
typedef struct openhaptics_object {
    vbss_context *context;
    hd_functions hd;
    vbss_openhaptics_config config;
    uint32_t arm_count;
    haptic_arm arms[OPENHAPTICS_ARMS];
    unsigned long callback; /* the scheduler's handle of the tick */
    bool is_scheduled, is_started;
    uint64_t tick; /* number of the current tick; used by the servo only */
    atomic_bool stop_requested, has_stopped;
} openhaptics_object;

/* ---- openhaptics_servo.c */

/* Callback of the scheduler, in the vendor's thread. `user` is an openhaptics_object. Returns
 * HD_CONTINUE, or HD_DONE after stop_requested. */
uint32_t HD_CALL vbss_openhaptics_tick(void *user);

#endif
