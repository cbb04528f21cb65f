/**
 * @file output.h
 * @brief The output stage limits forces and solenoids to safe values before they reach the hardware.
 *
 * Every device (device.h) has this stage. Hosts with their own device layer can use it alone. Each
 * of its limits reduces a force or leaves it unchanged, in this order: finite numbers only, largest
 * magnitude, continuous load (I^2 t, motor temperature), rate of rise, watchdog, emergency stop.
 * docs/reference/device-layer.md has the formulas, and the consequences for passivity.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_OUTPUT_H
#define VBLAST_SS_OUTPUT_H

#include <vblast_ss/base.h>

/** An output stage on its own, for hosts with their own device layer. */
typedef struct vbss_output vbss_output;

/** Bits for the actions of an output stage in a step. */
enum {
    VBSS_OUTPUT_FLAG_NOT_FINITE = 1,      /**< A number was NaN or infinite: all off. */
    VBSS_OUTPUT_FLAG_FAULT = 2,           /**< The device refuses forces: all off. */
    VBSS_OUTPUT_FLAG_CLAMPED = 4,         /**< The force was above the largest magnitude. */
    VBSS_OUTPUT_FLAG_CONTINUOUS = 8,      /**< The force was above the limit of the past load. */
    VBSS_OUTPUT_FLAG_WARM = 16,           /**< The force was above the limit of the temperature. */
    VBSS_OUTPUT_FLAG_SLEWED = 32,         /**< The force rose faster than the limit. */
    VBSS_OUTPUT_FLAG_INPUT_STALE = 64,    /**< The pose is too old: ramp to zero. */
    VBSS_OUTPUT_FLAG_COMMAND_STALE = 128, /**< The command is too old: ramp to zero. */
    VBSS_OUTPUT_FLAG_STOPPED = 256,       /**< The emergency stop is latched: all off. */
    VBSS_OUTPUT_FLAG_LATE = 512,          /**< The step came later than the watchdog allows. */
    /** The command asks for the solenoid, but it is off for one of these reasons. Devices switch it off also while
     * the clutch is engaged, the opening is stale, or an adapter is lost or has just failed. */
    VBSS_OUTPUT_FLAG_SOLENOID_OFF = 1024,
    VBSS_OUTPUT_FLAG_SOLENOID_SPENT = 2048, /**< The solenoid was on for too long. */
    VBSS_OUTPUT_FLAG_NOT_WRITTEN = 4096     /**< Devices: an adapter did not accept the result. */
};

/** Limits of an output stage. Fill it with #vbss_output_config_init, then change fields. A
 * device lowers them to the capabilities of its adapters, and its timeouts are at least 2.5 of
 * their periods. */
typedef struct vbss_output_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t reserved;    /**< Zero. */
    double max_force;     /**< Largest force, N, 0 to 1e3; default 3. */
    double max_torque;    /**< Largest torque, N m, 0 to 1e3; default 0.1. */
    /** Permitted root mean square of the force over an unlimited time, N, 0 to 1e3; default 0.88, a value often
     * given for the Touch, without a known public source. */
    double continuous_force;
    /** Permitted root mean square of the torque, N m; default 0.03, chosen. */
    double continuous_torque;
    double load_time; /**< Time constant of these means, s, 1e-3 to 1e4; default 10, chosen. */
    double warm;      /**< Temperature above which forces are reduced, 0 to 1; default 0.7. */
    double hot;       /**< Temperature at which forces are zero, above `warm`, to 2; default 1. */
    /** Fastest rise or turn, N/s, 1e-3 to 1e9; default 500. No limit for a fall. */
    double force_rise;
    double torque_rise;     /**< Fastest rise or turn of the torque, N m/s; default 20. */
    double input_timeout;   /**< Age at which a pose is stale, s, 1e-4 to 10; default 0.005. */
    double command_timeout; /**< Age at which a command is stale, s, 1e-4 to 10; default 0.005. */
    double ramp_time;       /**< Length of the ramp to zero, s, 0 to 10; default 0.005. */
    double solenoid_time;   /**< Longest time of the solenoid on, s, 0 to 1e4; default 1, chosen. */
    /** Largest long-term share of time of the solenoid on, 0 to 0.99; default 0.25, chosen. */
    double solenoid_duty;
} vbss_output_config;

/** Command to an output stage. Fill it with #vbss_output_command_init, then set its fields. */
typedef struct vbss_output_command {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t solenoid;    /**< 1: on; default 0. */
    uint32_t fault;       /**< 1: the device refuses forces; default 0. */
    uint32_t reserved;    /**< Zero. */
    /** Force, N; for a device, in the world's frame. A flag reports numbers that are not finite. */
    double force[3];
    double torque[3]; /**< Torque, N m; for a device, in the world's frame. */
    /** Age of the command, s, such as that of the anchor it was computed from; default 0. */
    double age;
    /** Age of the pose, s; default 0. A device uses the age of its own pose if that is older. */
    double input_age;
    /** Temperature of the motors; default 0. A device uses its own value if that is higher. */
    double temperature;
} vbss_output_command;

/** Counters of an output stage. Each counter of a flag is the number of steps with that flag. */
typedef struct vbss_output_statistics {
    uint32_t struct_size;    /**< Bytes of this struct that the library filled. */
    uint32_t reserved;       /**< Zero. */
    uint64_t steps;          /**< Steps so far. */
    uint64_t not_finite;     /**< Steps with VBSS_OUTPUT_FLAG_NOT_FINITE. */
    uint64_t faults;         /**< Steps with VBSS_OUTPUT_FLAG_FAULT. */
    uint64_t clamped;        /**< Steps with VBSS_OUTPUT_FLAG_CLAMPED. */
    uint64_t continuous;     /**< Steps with VBSS_OUTPUT_FLAG_CONTINUOUS. */
    uint64_t warm;           /**< Steps with VBSS_OUTPUT_FLAG_WARM. */
    uint64_t slewed;         /**< Steps with VBSS_OUTPUT_FLAG_SLEWED. */
    uint64_t input_stale;    /**< Steps with VBSS_OUTPUT_FLAG_INPUT_STALE. */
    uint64_t command_stale;  /**< Steps with VBSS_OUTPUT_FLAG_COMMAND_STALE. */
    uint64_t stopped;        /**< Steps with VBSS_OUTPUT_FLAG_STOPPED. */
    uint64_t late;           /**< Steps with VBSS_OUTPUT_FLAG_LATE. */
    uint64_t solenoid_off;   /**< Steps with VBSS_OUTPUT_FLAG_SOLENOID_OFF. */
    uint64_t solenoid_spent; /**< Steps with VBSS_OUTPUT_FLAG_SOLENOID_SPENT. */
    uint64_t watchdogs;      /**< Ramps that the watchdog started. */
    uint64_t stops;          /**< Times that the emergency stop was latched. */
    uint64_t pulses;         /**< Times that the solenoid was switched on. */
    double largest_force;    /**< Largest force in a result, N. */
    double largest_torque;   /**< Largest torque in a result, N m. */
    double solenoid_on;      /**< Total time of the solenoid on, s. */
} vbss_output_statistics;

/** Result of an output stage, for the hardware. In a call of an adapter it is followed by zeros up to 4096
 * bytes. */
typedef struct vbss_output_result {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t flags;       /**< VBSS_OUTPUT_FLAG_ bits: actions of the stage. */
    uint32_t solenoid;    /**< 1: on, 0: off. */
    uint32_t reserved;    /**< Zero. */
    double force[3];      /**< Force, N; for an adapter, in the device's frame. */
    double torque[3];     /**< Torque, N m; for an adapter, in the device's frame. */
    double force_load;    /**< Mean square force over the square of its limit; 1: at the limit. */
    double torque_load;   /**< Mean square torque over the square of its limit. */
    double solenoid_left; /**< Time that the solenoid may stay on from now on, s. */
    /** Time after which an adapter without a new call switches all outputs off itself, s. */
    double expires;
} vbss_output_result;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills the limits of an output stage with the defaults.
 *
 * @param[out] config  the limits to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_output_config_init(vbss_output_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_output_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_output_config vbss_output_config_default(void)
{
    vbss_output_config vbss_filled;
    (void)vbss_output_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Fills a command with the defaults: all off, ages zero.
 *
 * @param[out] command  the command to fill
 * @param struct_size   `sizeof *command` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_output_command_init(vbss_output_command *command, uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_output_command_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_output_command vbss_output_command_default(void)
{
    vbss_output_command vbss_filled;
    (void)vbss_output_command_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Creates an output stage.
 *
 * @param context      owner
 * @param config       its limits; NULL for the defaults
 * @param[out] output  the new stage; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_output_create(vbss_context *context, const vbss_output_config *config,
                                        vbss_output **output);

/**
 * Destroys an output stage.
 *
 * @param output  the stage; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_output_destroy(vbss_output *output);

/**
 * Applies the limits to a command. The call allocates nothing.
 *
 * @param output       the stage
 * @param h            time since the last step, s, 0 to 1e6
 * @param command      the command; NULL: no new command since the last one, which ages together with its pose
 * @param[out] result  receives the limited result
 * @param struct_size  `sizeof *result` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE (h), VBSS_ERROR_ARITHMETIC_MODE
 *         or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_output_step(vbss_output *output, double h,
                                      const vbss_output_command *command,
                                      vbss_output_result *result, uint32_t struct_size);

/**
 * Latches the emergency stop: all results are zero until #vbss_output_clear_emergency_stop.
 *
 * @param output  the stage
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_output_latch_emergency_stop(vbss_output *output);

/**
 * Clears the emergency stop.
 *
 * @param output  the stage
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_output_clear_emergency_stop(vbss_output *output);

/**
 * Returns the counters since creation.
 *
 * @param output           the stage
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_output_get_statistics(vbss_output *output,
                                                vbss_output_statistics *statistics,
                                                uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
