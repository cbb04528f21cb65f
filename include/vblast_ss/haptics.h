/**
 * @file haptics.h
 * @brief Adapters for real hardware: haptic arms by OpenHaptics, handles and solenoids by NI-DAQmx.
 *
 * Both are loaded at run time from the vendor's library: nothing is linked, no header of a vendor is needed, and a
 * machine without them is told so by a status and a text. Each object opens its hardware when it is created and hands
 * out adapters (adapter.h), one for each arm or handle, on which devices (device.h) stand:
 *
 *     vbss_openhaptics_create(context, &arms, &openhaptics);
 *     vbss_nidaqmx_create(context, &handles, &nidaqmx);
 *     vbss_openhaptics_get_adapter(openhaptics, 0, &arm);
 *     vbss_nidaqmx_get_adapter(nidaqmx, 0, &handle);
 *     vbss_device_create(context, &arm, &handle, NULL, &left);
 *
 * Threads: arms are driven by the vendor's servo thread, which the library shares nothing with but the newest sample and
 * the newest order, without waits. The analog and digital lines have a thread of their own, as one call for them takes
 * milliseconds; it lives from create to destroy, and #vbss_nidaqmx_pump can stand in its place.
 * docs/devices.md has the wiring and the set-up.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_HAPTICS_H
#define VBLAST_SS_HAPTICS_H

#include <vblast_ss/adapter.h>

/** One or two haptic arms under one servo. */
typedef struct vbss_openhaptics vbss_openhaptics;

/** One or two handles: a potentiometer and a solenoid each. */
typedef struct vbss_nidaqmx vbss_nidaqmx;

/* ---- haptic arms */

/**
 * Called in the vendor's servo thread at the end of each tick, after the forces have gone out: a host that steps inside
 * the servo does so here, and its forces go out in the next tick. From the first call to the return of
 * #vbss_openhaptics_destroy nothing but this function may use the context that the devices belong to; it must not destroy
 * the arms, and must not wait.
 *
 * @param user  the config's `user`
 * @param now   ticks so far times the length of one, s: a clock for devices
 */
typedef void (*vbss_openhaptics_tick_fn)(void *user, double now);

/** Which arms, and how. Fill it with #vbss_openhaptics_config_init, then change what you need. Texts are copied. */
typedef struct vbss_openhaptics_config {
    uint32_t struct_size;  /**< Size of this struct in bytes, set by the init function. */
    uint32_t device_count; /**< 1 (default) or 2. */
    uint32_t
        rate; /**< Of the servo, Hz, 100 to 8000; default 1000. The vendor takes 500, 1000 and 2000, or other
                              * ones for some arms. */
    uint32_t reserved; /**< Zero. */
    const char *
        library; /**< Path or name; NULL (default): `libHD.so`, `libHD.so.3.4` or `libHD.so.3.0`; `hd.dll`; or
                   * `libHD.dylib`. */
    const char *
        first_name; /**< As the vendor's set-up calls it; NULL (default): its default device, or the one that is
                      * called `Default Device` or `Default PHANToM`. */
    const char *second_name; /**< The same of the second; default `Device2`. */
    /** Limits of the stage in the servo, lowered to what the arms say they can; NULL (default): as initialised. Copied. */
    const vbss_output_config *output;
    vbss_openhaptics_tick_fn tick; /**< NULL (default): the host steps in a thread of its own. */
    void *user;                    /**< Handed to tick; may be NULL. */
} vbss_openhaptics_config;

/** How an arm or a line is: a VBSS_HARDWARE_ constant. */
typedef int32_t vbss_hardware_state;

/** The constants of #vbss_hardware_state. */
enum {
    VBSS_HARDWARE_WAITING = 0, /**< Nothing was measured yet. */
    VBSS_HARDWARE_RUNNING = 1, /**< All is well. */
    VBSS_HARDWARE_REFUSING =
        2, /**< It measures, but takes no forces for now: motors warm, force or speed too high. */
    VBSS_HARDWARE_UNCALIBRATED =
        3, /**< No forces until it is calibrated: put the stylus into the inkwell. Also an arm whose pose has not changed
            * by a bit for 1 s: it is not calibrated, its encoders give no data, or nobody holds it. It gets forces again
            * when its pose changes. */
    VBSS_HARDWARE_LOST = 4 /**< It is not there: unplugged, or its driver has failed. */
};

/** What an arm went through. */
typedef struct vbss_openhaptics_status {
    uint32_t struct_size;      /**< Bytes of this struct that the library filled. */
    vbss_hardware_state state; /**< How it is. */
    uint32_t error;         /**< What the vendor's library said last of it, its code; 0: nothing. */
    int32_t internal_error; /**< The vendor's own number for that. */
    uint64_t ticks;         /**< Of the servo. */
    uint64_t late_ticks; /**< Ticks after which more time had passed than the servo has for one. */
    uint64_t failed_ticks; /**< Ticks without a pose. */
    uint64_t errors;       /**< Errors that the vendor's library told of this arm. */
    uint64_t orders;       /**< Outputs of the host that were taken. */
    uint64_t silent_ticks; /**< Ticks with forces ramped down, as the host was silent. */
    double temperature;    /**< Of the hottest motor, 0 to 1. */
    double longest_tick;   /**< From the beginning of a tick to the end of our work in it, s. */
    double force[3];       /**< That went out last, device's frame, N. */
    uint32_t is_constant;  /**< 1: the pose has not changed by a bit for 1 s. */
    uint32_t reserved;     /**< Zero. */
} vbss_openhaptics_status;

/* ---- handles and solenoids */

/** How a potentiometer is wired: a VBSS_NIDAQMX_ constant. */
typedef int32_t vbss_nidaqmx_terminal;

/** The constants of #vbss_nidaqmx_terminal. */
enum {
    VBSS_NIDAQMX_SINGLE_ENDED = 0, /**< Against ground: 11 bits of a USB-6008. */
    VBSS_NIDAQMX_DIFFERENTIAL = 1  /**< Between two inputs: 12 bits. */
};

/** Which lines, and how. Fill it with #vbss_nidaqmx_config_init, then change what you need. Texts are copied; a name has
 * at most 127 bytes. */
typedef struct vbss_nidaqmx_config {
    uint32_t struct_size;  /**< Size of this struct in bytes, set by the init function. */
    uint32_t handle_count; /**< 1 or 2 (default). */
    /** Path or name; NULL (default): `libnidaqmx.so.1` or, without it, `libnidaqmxbase.so`; `nicaiu.dll` on Windows.
     * NI-DAQmx Base is recognised by its functions. It needs all lines on one port, such as `Dev1/port0/line0` and
     * `Dev1/port0/line1`, and the other lines of that port stay high. */
    const char *library;
    const char *first_input;  /**< Analog input of the first handle; default `Dev1/ai0`. */
    const char *second_input; /**< Of the second; default `Dev1/ai1`. */
    /** Digital line of the first solenoid, NULL: there are no solenoids; default `Dev1/port0/line0`. */
    const char *first_line;
    const char *second_line;        /**< Of the second; default `Dev1/port0/line1`. */
    vbss_nidaqmx_terminal terminal; /**< Default VBSS_NIDAQMX_SINGLE_ENDED. */
    /** 1 (default): a low line lets the current flow, so that lines that nobody drives, which are pulled high, are off; 0: a
     * high one. */
    uint32_t active_low;
    uint32_t
        own_thread; /**< 1 (default): a thread of the library moves the data; 0: the host calls #vbss_nidaqmx_pump. */
    uint32_t reserved; /**< Zero. */
    double low;        /**< Lowest voltage, V, -10 to 10; default -10. */
    double high;       /**< Highest voltage, above `low`, to 10; default 10. */
    double period;     /**< Time between two samples, s, 5e-4 to 1; default 0.002. */
    /** Longest wait of a call for the hardware, s, 1e-3 to 10, or 0 (default): the library chooses it. It starts with
     * 0.004 s, and doubles it up to 0.064 s while calls time out. A wait that the host chooses stays; the text of the
     * handle's error says when it is too short. */
    double timeout;
} vbss_nidaqmx_config;

/** What the lines went through. */
typedef struct vbss_nidaqmx_status {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    vbss_hardware_state
        state; /**< How they are. REFUSING: the last read failed, or the lines are being opened again after an error that
                * passes; solenoids are off. LOST: an error that stays; the library opens the lines again when it can. */
    int32_t error;          /**< What the vendor's library said last, its code; 0: nothing. */
    uint32_t solenoids;     /**< 1, 2: solenoids that are on. */
    uint64_t cycles;        /**< Rounds of write and read. */
    uint64_t failed_reads;  /**< Reads without a sample. */
    uint64_t failed_writes; /**< Writes that were not taken. */
    uint64_t warnings;      /**< Calls that succeeded with a warning. */
    uint64_t silent_cycles; /**< Rounds in which a solenoid was put off, as the host was silent. */
    uint64_t timeouts;      /**< Reads and writes that timed out. */
    uint64_t reopened;      /**< How often the lines were opened again after an error. */
    uint64_t
        late_rounds; /**< Rounds at a pace at which a solenoid goes off later than its command expires. */
    double timeout;    /**< Longest wait of a call for the hardware, in force now, s. */
    double round_time; /**< Time from round to round, mean of about the last 16, s. */
    /** Longest time from the host's last command to a solenoid that is off, at that pace, s; 0: unknown. A command
     * expires after vbss_output_result::expires, 10 ms by default; rounds above half of that are too slow for it. */
    double off_time;
} vbss_nidaqmx_status;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a configuration of arms with the defaults: one, the vendor's default device.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_openhaptics_config_init(vbss_openhaptics_config *config,
                                                  uint32_t struct_size);

/**
 * Loads the vendor's library, opens the arms and starts the servo, which puts out no force until a device is written to.
 *
 * @param context           owner
 * @param config            which; NULL for the defaults
 * @param[out] openhaptics  the arms; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_DEVICE (no such library, no such arm, or the servo does not start: the text says which),
 *         VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on failure
 *         everything is closed again
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_openhaptics_create(vbss_context *context,
                                             const vbss_openhaptics_config *config,
                                             vbss_openhaptics **openhaptics);

/**
 * Puts forces off, stops the servo and closes the arms. Devices that stand on them find them lost.
 *
 * @param openhaptics  the arms; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_openhaptics_destroy(vbss_openhaptics *openhaptics);

/**
 * An arm as an adapter, for one device at a time.
 *
 * @param openhaptics      the arms
 * @param which            0 or 1
 * @param[in,out] adapter  an initialised table; every field of it is set
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such arm)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_openhaptics_get_adapter(vbss_openhaptics *openhaptics, uint32_t which,
                                                  vbss_device_adapter *adapter);

/**
 * How an arm is, as of its newest tick.
 *
 * @param openhaptics  the arms
 * @param which        0 or 1
 * @param[out] status  receives it
 * @param struct_size  `sizeof *status` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such arm)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_openhaptics_get_status(vbss_openhaptics *openhaptics, uint32_t which,
                                                 vbss_openhaptics_status *status,
                                                 uint32_t struct_size);

/**
 * What the vendor's library calls an arm.
 *
 * @param openhaptics  the arms
 * @param which        0 or 1
 * @param[out] model   its model, never NULL, valid as long as the arms; may be NULL
 * @param[out] serial  its serial number, likewise
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_OUT_OF_RANGE (no such arm)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_openhaptics_get_identity(vbss_openhaptics *openhaptics, uint32_t which,
                                                   const char **model, const char **serial);

/**
 * Fills a configuration of lines with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_nidaqmx_config_init(vbss_nidaqmx_config *config, uint32_t struct_size);

/**
 * Loads the vendor's library, opens the lines with solenoids off, and starts their thread.
 *
 * @param context       owner
 * @param config        which; NULL for the defaults
 * @param[out] nidaqmx  the lines; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_DEVICE (no such library, no such line, or no thread: the text says which),
 *         VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT (also: a name), VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or
 *         VBSS_ERROR_BUSY; on failure everything is closed again
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_nidaqmx_create(vbss_context *context, const vbss_nidaqmx_config *config,
                                         vbss_nidaqmx **nidaqmx);

/**
 * Puts solenoids off, ends the thread and closes the lines. Devices that stand on them find them lost.
 *
 * @param nidaqmx  the lines; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_nidaqmx_destroy(vbss_nidaqmx *nidaqmx);

/**
 * A handle as an adapter, for one device at a time: `jaw_raw` in V, and its solenoid.
 *
 * @param nidaqmx          the lines
 * @param which            0 or 1
 * @param[in,out] adapter  an initialised table; every field of it is set
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such handle)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_nidaqmx_get_adapter(vbss_nidaqmx *nidaqmx, uint32_t which,
                                              vbss_device_adapter *adapter);

/**
 * One round in place of the library's thread: the newest orders are written, one sample is read. It waits for the
 * hardware, up to twice `timeout`.
 *
 * @param nidaqmx  the lines, made without a thread
 * @param now      a clock that only goes forward, s, at most 1e9 in magnitude; when it goes back, solenoids go off
 * @return VBSS_OK (also when the hardware fails, which its status tells), VBSS_ERROR_INVALID_HANDLE,
 *         VBSS_ERROR_OUT_OF_RANGE (also: there is a thread) or VBSS_ERROR_NOT_FINITE, all without a text
 * @threads any one thread, also while another uses the context, but for the end of the lines
 * @since 0.1
 */
VBSS_API vbss_result vbss_nidaqmx_pump(vbss_nidaqmx *nidaqmx, double now);

/**
 * How the lines are, as of their newest round.
 *
 * @param nidaqmx      the lines
 * @param[out] status  receives it
 * @param struct_size  `sizeof *status` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_nidaqmx_get_status(vbss_nidaqmx *nidaqmx, vbss_nidaqmx_status *status,
                                             uint32_t struct_size);

/**
 * What there is to choose from: a line for each device of the vendor's driver, its name and its product.
 *
 * @param context    for errors
 * @param library    path or name; NULL as in #vbss_nidaqmx_config
 * @param[out] text  receives UTF-8 text and a final zero, cut off where there is no more room
 * @param bytes      room there is, at least 1
 * @return VBSS_OK, VBSS_ERROR_DEVICE (no such library, it failed, it knows no device, or it is NI-DAQmx Base, which
 *         has no list), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_nidaqmx_list(vbss_context *context, const char *library, char *text,
                                       uint32_t bytes);

#ifdef __cplusplus
}
#endif

#endif
