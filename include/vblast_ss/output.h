/**
 * @file output.h
 * @brief The output stage: what makes forces and solenoids safe before they reach the hardware.
 *
 * It is the same for every device (device.h), and to be had alone by hosts with a device layer of their own. Each part of it
 * makes forces smaller or leaves them, in this order: finite numbers only, largest magnitude, continuous load (I^2 t, motor
 * temperature), rate of rise, watchdog, emergency stop. docs/devices.md has the formulas, and what this means for passivity.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_OUTPUT_H
#define VBLAST_SS_OUTPUT_H

#include <vblast_ss/base.h>

/** An output stage alone, for hosts with a device layer of their own. */
typedef struct vbss_output vbss_output;

/** What an output stage did in a step: bits. */
enum {
    VBSS_OUTPUT_NOT_FINITE = 1,      /**< A number was NaN or infinite: all off. */
    VBSS_OUTPUT_FAULT = 2,           /**< The device refuses forces: all off. */
    VBSS_OUTPUT_CLAMPED = 4,         /**< Above the largest magnitude. */
    VBSS_OUTPUT_CONTINUOUS = 8,      /**< Above what the load so far allows. */
    VBSS_OUTPUT_WARM = 16,           /**< Above what the temperature allows. */
    VBSS_OUTPUT_SLEWED = 32,         /**< Rises faster than it may. */
    VBSS_OUTPUT_INPUT_STALE = 64,    /**< The pose is too old: ramped to zero. */
    VBSS_OUTPUT_COMMAND_STALE = 128, /**< The command is too old: ramped to zero. */
    VBSS_OUTPUT_STOPPED = 256,       /**< The emergency stop is latched: all off. */
    VBSS_OUTPUT_LATE = 512,          /**< The last step is longer ago than the watchdog waits. */
    /** The solenoid was wanted, but is off: for one of these reasons; of a device also while the clutch is held, the
     * opening is stale, or an adapter is lost or failed last. */
    VBSS_OUTPUT_SOLENOID_OFF = 1024,
    VBSS_OUTPUT_SOLENOID_SPENT = 2048, /**< The solenoid was wanted for too long. */
    VBSS_OUTPUT_NOT_WRITTEN = 4096     /**< Devices: an adapter did not take it. */
};

/** Limits of an output stage. Fill it with #vbss_output_config_init, then change what you need. A device lowers
 * them to what its adapters say they can, and waits at least 2.5 of their periods. */
typedef struct vbss_output_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t reserved;    /**< Zero. */
    double max_force;     /**< N, 0 to 1e3; default 3. */
    double max_torque;    /**< N m, 0 to 1e3; default 0.1. */
    /** Root mean square that may go on for ever, N, 0 to 1e3; default 0.88, often said of the Touch, in no public
     * source we know. */
    double continuous_force;
    double continuous_torque; /**< The same, N m; default 0.03, chosen. */
    double load_time;  /**< Time constant of that mean, s, 1e-3 to 1e4; default 10, chosen. */
    double warm;       /**< Temperature from which forces are lowered, 0 to 1; default 0.7. */
    double hot;        /**< Temperature at which there are none, above `warm`, to 2; default 1. */
    double force_rise; /**< Fastest rise or turn, N/s, 1e-3 to 1e9; default 500. Falling is free. */
    double torque_rise;     /**< The same, N m/s; default 20. */
    double input_timeout;   /**< Age at which a pose is stale, s, 1e-4 to 10; default 0.005. */
    double command_timeout; /**< Age at which a command is, s, 1e-4 to 10; default 0.005. */
    double ramp_time;       /**< From there to zero, s, 0 to 10; default 0.005. */
    double solenoid_time;   /**< Longest time on, s, 0 to 1e4; default 1, chosen. */
    /** Part of the time it may be on in the long run, 0 to 0.99; default 0.25, chosen. */
    double solenoid_duty;
} vbss_output_config;

/** What is wanted of an output stage. Fill it with #vbss_output_command_init, then set what you want. */
typedef struct vbss_output_command {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t solenoid;    /**< 1: on; default 0. */
    uint32_t fault;       /**< 1: the device refuses forces; default 0. */
    uint32_t reserved;    /**< Zero. */
    /** N; to a device: in the world. Anything: what is not finite is told by a flag. */
    double force[3];
    double torque[3]; /**< N m, likewise. */
    /** How old the command is, s, such as the anchor it was computed from; default 0. */
    double age;
    /** How old the pose is, s; default 0. A device takes its own if that is older. */
    double input_age;
    double temperature; /**< Of the motors; default 0. A device takes its own if that is higher. */
} vbss_output_command;

/** Steps in which an output stage did something, and what it went through. */
typedef struct vbss_output_statistics {
    uint32_t struct_size;    /**< Bytes of this struct that the library filled. */
    uint32_t reserved;       /**< Zero. */
    uint64_t steps;          /**< Steps so far. */
    uint64_t not_finite;     /**< Of them with VBSS_OUTPUT_NOT_FINITE; */
    uint64_t faults;         /**< VBSS_OUTPUT_FAULT; */
    uint64_t clamped;        /**< VBSS_OUTPUT_CLAMPED; */
    uint64_t continuous;     /**< VBSS_OUTPUT_CONTINUOUS; */
    uint64_t warm;           /**< VBSS_OUTPUT_WARM; */
    uint64_t slewed;         /**< VBSS_OUTPUT_SLEWED; */
    uint64_t input_stale;    /**< VBSS_OUTPUT_INPUT_STALE; */
    uint64_t command_stale;  /**< VBSS_OUTPUT_COMMAND_STALE; */
    uint64_t stopped;        /**< VBSS_OUTPUT_STOPPED; */
    uint64_t late;           /**< VBSS_OUTPUT_LATE; */
    uint64_t solenoid_off;   /**< VBSS_OUTPUT_SOLENOID_OFF; */
    uint64_t solenoid_spent; /**< VBSS_OUTPUT_SOLENOID_SPENT. */
    uint64_t watchdogs;      /**< How often the watchdog began to ramp. */
    uint64_t stops;          /**< How often the emergency stop was latched. */
    uint64_t pulses;         /**< How often the solenoid went on. */
    double largest_force;    /**< That was put out, N. */
    double largest_torque;   /**< That was put out, N m. */
    double solenoid_on;      /**< Time it was on, s. */
} vbss_output_statistics;

/** What goes to the hardware: the result of an output stage. In an adapter's call it lies in 4096 bytes of
 * which the rest is zero. */
typedef struct vbss_output_result {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t flags;       /**< VBSS_OUTPUT_ bits: what the stage did. */
    uint32_t solenoid;    /**< 1: on, 0: off. */
    uint32_t reserved;    /**< Zero. */
    double force[3];      /**< N; to an adapter: in the device's frame. */
    double torque[3];     /**< N m. */
    double force_load;    /**< Mean square force over the continuous limit's square: 1 is full. */
    double torque_load;   /**< The same of the torque. */
    double solenoid_left; /**< Time that the solenoid may stay on from now, s. */
    double expires; /**< An adapter that hears nothing for so long puts everything off itself, s. */
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
 * @since 0.1
 */
VBSS_API vbss_result vbss_output_config_init(vbss_output_config *config, uint32_t struct_size);

/**
 * Fills a command: nothing wanted, nothing old.
 *
 * @param[out] command  the command to fill
 * @param struct_size   `sizeof *command` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_output_command_init(vbss_output_command *command, uint32_t struct_size);

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
 * @since 0.1
 */
VBSS_API vbss_result vbss_output_create(vbss_context *context, const vbss_output_config *config,
                                        vbss_output **output);

/**
 * Destroys an output stage.
 *
 * @param output  the stage; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_output_destroy(vbss_output *output);

/**
 * Puts a command through the stage. Nothing is allocated.
 *
 * @param output       the stage
 * @param h            time since the last step, s, 0 to 1e6
 * @param command      what is wanted; NULL: there is no new command since the last, which grows old, as does its pose
 * @param[out] result  receives what may go out
 * @param struct_size  `sizeof *result` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE (h), VBSS_ERROR_ARITHMETIC_MODE
 *         or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_output_step(vbss_output *output, double h,
                                      const vbss_output_command *command,
                                      vbss_output_result *result, uint32_t struct_size);

/**
 * Latches the emergency stop: all results are zero until #vbss_output_release.
 *
 * @param output  the stage
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_output_stop(vbss_output *output);

/**
 * Lets the emergency stop go.
 *
 * @param output  the stage
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_output_release(vbss_output *output);

/**
 * Figures since creation.
 *
 * @param output           the stage
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_output_get_statistics(vbss_output *output,
                                                vbss_output_statistics *statistics,
                                                uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
