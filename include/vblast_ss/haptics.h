/**
 * @file haptics.h
 * @brief Adapters for real hardware: haptic arms through OpenHaptics, handles and solenoids through
 *   NI-DAQmx.
 *
 * Both vendors' libraries are loaded at run time, without linking and without vendor headers. On a
 * machine without them creation fails with a status and a text. Each object opens its hardware when
 * it is created and supplies an adapter (adapter.h) for each arm or handle. Devices (device.h) use
 * these adapters:
 *
 *     vbss_openhaptics_create(context, &arms, &openhaptics);
 *     vbss_nidaqmx_create(context, &handles, &nidaqmx);
 *     vbss_openhaptics_get_adapter(openhaptics, 0, &arm);
 *     vbss_nidaqmx_get_adapter(nidaqmx, 0, &handle);
 *     vbss_device_create(context, &arm, &handle, NULL, &left);
 *
 * Threads: the vendor's servo thread drives the arms. It shares only the newest sample and the
 * newest output with the library, without waits. The analog and digital lines have their own
 * thread, because a call for them takes milliseconds. It lives from create to destroy, and
 * #vbss_nidaqmx_poll can replace it. docs/reference/hardware.md has the wiring and the set-up.
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
 * A function of the host that the vendor's servo thread calls at the end of each tick, after it has
 * applied the forces. A host can step its scene here; the new forces are applied in the next tick.
 * From the first call to the return of #vbss_openhaptics_destroy only this function may use the
 * context of the devices. It must not destroy the arms and must not wait.
 *
 * @param user  the config's `user`
 * @param now   number of ticks times the length of a tick, s: a clock for devices
 */
typedef void (*vbss_openhaptics_tick_fn)(void *user, double now);

/** Configuration of the arms. Fill it with #vbss_openhaptics_config_init, then change fields. The
 * library copies the texts. */
typedef struct vbss_openhaptics_config {
    uint32_t struct_size;  /**< Size of this struct in bytes, set by the init function. */
    uint32_t device_count; /**< Number of arms, 1 (default) or 2. */
    /** Rate of the servo, Hz, 100 to 8000; default 1000. The vendor accepts 500, 1000 and 2000, and
     * other rates for some arms. */
    uint32_t rate;
    uint32_t reserved; /**< Zero. */
    /** Path or name of the vendor's library; NULL (default): `libHD.so`, `libHD.so.3.4` or
     * `libHD.so.3.0`; `hd.dll`; or `libHD.dylib`. */
    const char *library;
    /** Name of the first arm in the vendor's set-up; NULL (default): its default device, or the one
     * called `Default Device` or `Default PHANToM`. */
    const char *first_name;
    /** Name of the second arm in the vendor's set-up; default `Device2`. */
    const char *second_name;
    /** Limits of the output stage in the servo, lowered to the limits that the arms report; NULL
     * (default): the initialised ones. The library copies them. */
    const vbss_output_config *output;
    /** Function called in each tick; NULL (default): the host steps in its own thread. */
    vbss_openhaptics_tick_fn tick;
    void *user; /**< Pointer that `tick` receives; may be NULL. */
} vbss_openhaptics_config;

/** State of an arm or a line: a VBSS_HAPTICS_STATE_ constant. */
typedef int32_t vbss_haptics_state;

/** The constants of #vbss_haptics_state. */
enum {
    VBSS_HAPTICS_STATE_WAITING = 0, /**< There is no measurement yet. */
    VBSS_HAPTICS_STATE_RUNNING = 1, /**< The hardware works. */
    /** It measures, but accepts no forces for now: motors warm, force or speed too high. */
    VBSS_HAPTICS_STATE_REFUSING = 2,
    /** It accepts no forces until it is calibrated: put the stylus into the inkwell. An arm whose
     * pose has been constant to the bit for 1 s is in this state, too: it is uncalibrated, its
     * encoders give no data, or no hand holds it. It accepts forces again when its pose changes. */
    VBSS_HAPTICS_STATE_UNCALIBRATED = 3,
    VBSS_HAPTICS_STATE_LOST =
        4 /**< The hardware is missing: unplugged, or its driver has failed. */
};

/** Status and counts of an arm. */
typedef struct vbss_openhaptics_status {
    uint32_t struct_size;     /**< Bytes of this struct that the library filled. */
    vbss_haptics_state state; /**< State of the arm. */
    uint32_t error;           /**< Last error code of the vendor's library for this arm; 0: none. */
    int32_t internal_error;   /**< The vendor's internal number of that error. */
    uint64_t ticks;           /**< Number of ticks of the servo. */
    uint64_t late_ticks; /**< Ticks that began later than one tick length after the tick before. */
    uint64_t failed_ticks; /**< Ticks without a pose. */
    uint64_t errors;       /**< Errors that the vendor's library reported for this arm. */
    uint64_t orders;       /**< Outputs of the host that the servo has received. */
    uint64_t silent_ticks; /**< Ticks with forces ramped down because the host was silent. */
    double temperature;    /**< Temperature of the hottest motor, 0 to 1. */
    /** Longest time from the beginning of a tick to the end of the library's work in it, s. */
    double longest_tick;
    double force[3];      /**< Force last applied, in the device's frame, N. */
    uint32_t is_constant; /**< 1: the pose has been constant to the bit for 1 s. */
    uint32_t reserved;    /**< Zero. */
} vbss_openhaptics_status;

/* ---- handles and solenoids */

/** Wiring of a potentiometer: a VBSS_NIDAQMX_TERMINAL_ constant. */
typedef int32_t vbss_nidaqmx_terminal;

/** The constants of #vbss_nidaqmx_terminal. */
enum {
    VBSS_NIDAQMX_TERMINAL_SINGLE_ENDED = 0, /**< Against ground: 11 bits of a USB-6008. */
    VBSS_NIDAQMX_TERMINAL_DIFFERENTIAL = 1  /**< Between two inputs: 12 bits. */
};

/** Configuration of the lines. Fill it with #vbss_nidaqmx_config_init, then change fields. The
 * library copies the texts; a name has at most 127 bytes. */
typedef struct vbss_nidaqmx_config {
    uint32_t struct_size;  /**< Size of this struct in bytes, set by the init function. */
    uint32_t handle_count; /**< Number of handles, 1 or 2 (default). */
    /** Path or name of the vendor's library; NULL (default): `libnidaqmx.so.1` or, without it,
     * `libnidaqmxbase.so`; `nicaiu.dll` on Windows. NI-DAQmx Base is recognised by its
     * functions. It needs all lines on one port, such as `Dev1/port0/line0` and
     * `Dev1/port0/line1`, and the other lines of that port stay high. */
    const char *library;
    const char *first_input;  /**< Analog input of the first handle; default `Dev1/ai0`. */
    const char *second_input; /**< Analog input of the second handle; default `Dev1/ai1`. */
    /** Digital line of the first solenoid; NULL: there are no solenoids; default
     * `Dev1/port0/line0`. */
    const char *first_line;
    /** Digital line of the second solenoid; default `Dev1/port0/line1`. */
    const char *second_line;
    /** Wiring of the potentiometers; default VBSS_NIDAQMX_TERMINAL_SINGLE_ENDED. */
    vbss_nidaqmx_terminal terminal;
    /** 1 (default): a low line switches the solenoid's current on, so undriven lines, which are
     * pulled high, keep it off. 0: a high line switches it on. */
    uint32_t active_low;
    /** 1 (default): a thread of the library moves the data; 0: the host calls #vbss_nidaqmx_poll. */
    uint32_t own_thread;
    uint32_t reserved; /**< Zero. */
    double low;        /**< Lowest input voltage, V, -10 to 10; default -10. */
    double high;       /**< Highest input voltage, V, above `low`, to 10; default 10. */
    double period;     /**< Time between two samples, s, 5e-4 to 1; default 0.002. */
    /** Longest wait of a call for the hardware, s, 1e-3 to 10, or 0 (default): the library
     * chooses it. It starts with 0.004 s and doubles the wait up to 0.064 s while calls time
     * out. A wait that the host sets does not change; the error text of the handle reports when
     * it is too short. */
    double timeout;
} vbss_nidaqmx_config;

/** Status and counts of the lines. */
typedef struct vbss_nidaqmx_status {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    /** State of the lines. REFUSING: the last read failed, or the lines are being reopened after a
     * transient error; solenoids are off. LOST: a permanent error; the library reopens the lines
     * when it can. */
    vbss_haptics_state state;
    int32_t error;          /**< Last error code of the vendor's library; 0: none. */
    uint32_t solenoids;     /**< Bits 1, 2: the first, the second solenoid is on. */
    uint64_t cycles;        /**< Rounds of one write and one read. */
    uint64_t failed_reads;  /**< Reads without a sample. */
    uint64_t failed_writes; /**< Writes that failed. */
    uint64_t warnings;      /**< Calls that succeeded with a warning. */
    /** Rounds in which a solenoid was switched off because the host was silent. */
    uint64_t silent_cycles;
    uint64_t timeouts; /**< Reads and writes that timed out. */
    uint64_t reopened; /**< Times the lines were reopened after an error. */
    /** Rounds so slow that a solenoid would switch off later than its command expires. */
    uint64_t late_rounds;
    double timeout;    /**< Current longest wait of a call for the hardware, s. */
    double round_time; /**< Time from round to round, mean over about the last 16 rounds, s. */
    /** Longest time from the host's last command until a solenoid is off, at the current round
     * time, s; 0: unknown. A command expires after vbss_output_result::expires, 10 ms by default;
     * rounds longer than half of that are too slow. */
    double off_time;
} vbss_nidaqmx_status;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a configuration of arms with the defaults: one arm, the vendor's default device.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_openhaptics_config_init(vbss_openhaptics_config *config,
                                                  uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_openhaptics_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_openhaptics_config vbss_openhaptics_config_default(void)
{
    vbss_openhaptics_config vbss_filled;
    (void)vbss_openhaptics_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Loads the vendor's library, opens the arms and starts the servo. There is no force until the host
 * writes to a device.
 *
 * @param context           owner
 * @param config            configuration; NULL for the defaults
 * @param[out] openhaptics  the arms; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_DEVICE (no such library, no such arm, or the servo does not start:
 *         the error text says which), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT,
 *         VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE,
 *         VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on failure everything
 *         is closed again
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_openhaptics_create(vbss_context *context,
                                             const vbss_openhaptics_config *config,
                                             vbss_openhaptics **openhaptics);

/**
 * Switches forces off, stops the servo and closes the arms. Their devices report them as lost.
 *
 * @param openhaptics  the arms; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_openhaptics_destroy(vbss_openhaptics *openhaptics);

/**
 * Returns an arm as an adapter for one device at a time.
 *
 * @param openhaptics      the arms
 * @param which            0 or 1
 * @param[in,out] adapter an initialised table; the call sets every field
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such arm)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_openhaptics_get_adapter(vbss_openhaptics *openhaptics, uint32_t which,
                                                  vbss_device_adapter *adapter);

/**
 * Returns the status of an arm after its newest tick.
 *
 * @param openhaptics  the arms
 * @param which        0 or 1
 * @param[out] status      receives the status
 * @param struct_size  `sizeof *status` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such arm)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_openhaptics_get_status(vbss_openhaptics *openhaptics, uint32_t which,
                                                 vbss_openhaptics_status *status,
                                                 uint32_t struct_size);

/**
 * Returns model and serial number of an arm from the vendor's library.
 *
 * @param openhaptics  the arms
 * @param which        0 or 1
 * @param[out] model   its model, never NULL, valid as long as the arms exist; the argument may be
 *         NULL
 * @param[out] serial  its serial number, never NULL, valid as long as the arms exist; the argument
 *         may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NOT_FOUND (no such arm)
 * @threads one thread at a time per context
 * @since 1.0
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
 * @since 1.0
 */
VBSS_API vbss_result vbss_nidaqmx_config_init(vbss_nidaqmx_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_nidaqmx_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_nidaqmx_config vbss_nidaqmx_config_default(void)
{
    vbss_nidaqmx_config vbss_filled;
    (void)vbss_nidaqmx_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Loads the vendor's library, opens the lines with solenoids off, and starts their thread.
 *
 * @param context       owner
 * @param config        configuration; NULL for the defaults
 * @param[out] nidaqmx  the lines; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_DEVICE (no such library, no such line, or no thread: the error text
 *         says which), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT (also: a name is NULL),
 *         VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE,
 *         VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on failure everything
 *         is closed again
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_nidaqmx_create(vbss_context *context, const vbss_nidaqmx_config *config,
                                         vbss_nidaqmx **nidaqmx);

/**
 * Switches solenoids off, ends the thread and closes the lines. Their devices report them as lost.
 *
 * @param nidaqmx  the lines; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_nidaqmx_destroy(vbss_nidaqmx *nidaqmx);

/**
 * Returns a handle as an adapter for one device at a time, with `jaw_raw` in V and its solenoid.
 *
 * @param nidaqmx          the lines
 * @param which            0 or 1
 * @param[in,out] adapter an initialised table; the call sets every field
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such handle)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_nidaqmx_get_adapter(vbss_nidaqmx *nidaqmx, uint32_t which,
                                              vbss_device_adapter *adapter);

/**
 * Makes one round in place of the library's thread: writes the newest outputs and reads one sample.
 * The call waits for the hardware, up to twice `timeout`.
 *
 * @param nidaqmx  the lines, created without a thread
 * @param now      a clock that never runs backwards, s, at most 1e9 in magnitude; when it does,
 *         solenoids are switched off
 * @return VBSS_OK (also when the hardware fails, which the status reports),
 *         VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_WRONG_STATE (there is a thread),
 *         VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE, all without an error text
 * @threads any one thread, also while another uses the context, except during the destruction of
 *   the lines
 * @since 1.0
 */
VBSS_API vbss_result vbss_nidaqmx_poll(vbss_nidaqmx *nidaqmx, double now);

/**
 * Returns the status of the lines after their newest round.
 *
 * @param nidaqmx      the lines
 * @param[out] status      receives the status
 * @param struct_size  `sizeof *status` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_nidaqmx_get_status(vbss_nidaqmx *nidaqmx, vbss_nidaqmx_status *status,
                                             uint32_t struct_size);

/**
 * Lists the devices of the vendor's driver: a line of text for each, with its name and its product.
 *
 * @param context    the context for errors
 * @param library    path or name of the vendor's library; NULL as in #vbss_nidaqmx_config
 * @param[out] text  receives UTF-8 text and a final zero, truncated to `bytes`
 * @param bytes      size of `text`, at least 1
 * @return VBSS_OK, VBSS_ERROR_DEVICE (no such library, it failed, it knows no device, or it is NI-DAQmx Base, which
 *         has no list), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_nidaqmx_list_devices(vbss_context *context, const char *library,
                                               char *text, uint32_t bytes);

#ifdef __cplusplus
}
#endif

#endif
