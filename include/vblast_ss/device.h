/**
 * @file device.h
 * @brief Haptic arms, instrument handles and solenoids: sampled, checked and calibrated on the way in, made safe on
 * the way out. Works without a scene.
 *
 * An *adapter* is a table of functions that the host fills (or a built-in object hands out) for one piece of
 * hardware. A #vbss_device stands on one or two of them: the pose may come from a haptic arm, the jaw and the
 * solenoid from the handle's electronics. In each step of the host it is read once and written once; neither call
 * blocks, as adapters never wait (slow hardware has a thread of the adapter's own that keeps the newest sample).
 *
 * What goes out passes an output stage that is the same for every device (#vbss_output, also to be had alone). Each
 * part of it makes forces smaller or leaves them, in this order: finite numbers only, largest magnitude, continuous
 * load (I^2 t, motor temperature), rate of rise, watchdog, emergency stop. docs/devices.md has the formulas, and what
 * this means for passivity.
 *
 * Time: `now` is the host's clock in s, real time when a hand is on the device, at most 1e9 in magnitude, never
 * running backwards. Frames: an adapter speaks in the device's own frame, the host hears of the world's;
 * #vbss_device_calibration stands between them.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_DEVICE_H
#define VBLAST_SS_DEVICE_H

#include <vblast_ss/base.h>

/** A device: one or two adapters, calibration, and the output stage. */
typedef struct vbss_device vbss_device;

/** An output stage alone, for hosts with a device layer of their own. */
typedef struct vbss_output vbss_output;

/** An adapter without hardware: driven by a function of time or by samples, with faults on demand. */
typedef struct vbss_mock vbss_mock;

/* ---- what adapters and devices speak of */

/** Parts of a sample: bits. */
enum {
    VBSS_DEVICE_HAS_POSITION = 1,         /**< `position` */
    VBSS_DEVICE_HAS_ORIENTATION = 2,      /**< `orientation` */
    VBSS_DEVICE_HAS_VELOCITY = 4,         /**< `velocity` */
    VBSS_DEVICE_HAS_ANGULAR_VELOCITY = 8, /**< `angular_velocity` */
    VBSS_DEVICE_HAS_JAW_RAW = 16,         /**< `jaw_raw` */
    VBSS_DEVICE_HAS_JAW = 32,             /**< `jaw`, which then counts instead of `jaw_raw`. */
    VBSS_DEVICE_HAS_BUTTONS = 64,         /**< `buttons` */
    VBSS_DEVICE_HAS_TOOL = 128,           /**< `tool` */
    VBSS_DEVICE_HAS_TEMPERATURE = 256     /**< `temperature` */
};

/** What a device can put out: bits. */
enum {
    VBSS_DEVICE_OUT_FORCE = 1,   /**< Force. */
    VBSS_DEVICE_OUT_TORQUE = 2,  /**< Torque. */
    VBSS_DEVICE_OUT_SOLENOID = 4 /**< A solenoid in the handle. */
};

/** What a device says about itself with a sample: bits. */
enum {
    VBSS_DEVICE_FLAG_LOST = 1, /**< It is not there: unplugged, or its driver has given up. */
    VBSS_DEVICE_FLAG_STOP = 2, /**< Emergency stop: latches as #vbss_device_stop does. */
    /** It refuses forces for now: all outputs are off while this is set. */
    VBSS_DEVICE_FLAG_FAULT = 4
};

/** Which tool a device holds: a VBSS_DEVICE_TOOL_ constant. */
typedef int32_t vbss_device_tool;

/** The constants of #vbss_device_tool. */
enum {
    VBSS_DEVICE_TOOL_NONE = 0,          /**< None. */
    VBSS_DEVICE_TOOL_NEEDLE_DRIVER = 1, /**< A needle driver. */
    VBSS_DEVICE_TOOL_SHEARS = 2         /**< Shears. */
};

/**
 * What an adapter knows at the moment. The library hands out a cleared one; the adapter fills what it has and says
 * so in `valid`. The library's memory goes on for 4096 bytes from the beginning, so an adapter with a newer header
 * may fill fields that an older library does not know; they are ignored, as are unknown bits.
 */
typedef struct vbss_device_sample {
    uint32_t struct_size;  /**< Size of this struct in bytes, as the library knows it. */
    uint32_t valid;        /**< VBSS_DEVICE_HAS_ bits. */
    uint32_t flags;        /**< VBSS_DEVICE_FLAG_ bits; looked at even if the read fails. */
    uint32_t buttons;      /**< One bit each. */
    vbss_device_tool tool; /**< Kind of tool. */
    uint32_t reserved;     /**< Zero. */
    double time;           /**< When this was measured, s, by any clock that only goes forward. */
    double position[3];    /**< m, each at most 1e3. */
    double orientation[4]; /**< w, x, y, z, unit: handle to device frame. */
    double velocity[3];    /**< m/s, each at most 1e3. */
    double angular_velocity[3]; /**< rad/s, in the device's frame, each at most 1e4. */
    double jaw_raw;             /**< Opening as the sensor tells it, such as V, at most 1e6. */
    double jaw;                 /**< Opening, 0 closed to 1 open. */
    double temperature;         /**< Of the hottest motor: 0 cold to 1 about to fail. */
} vbss_device_sample;

/** What a device can do; 0 where it is not known. Handed to adapters and grown as #vbss_device_sample. */
typedef struct vbss_device_capabilities {
    uint32_t struct_size;         /**< Size of this struct in bytes. */
    uint32_t signals;             /**< VBSS_DEVICE_HAS_ bits that samples may have. */
    uint32_t outputs;             /**< VBSS_DEVICE_OUT_ bits. */
    uint32_t input_dof;           /**< Degrees of freedom that are measured. */
    uint32_t output_dof;          /**< Degrees of freedom that are driven. */
    uint32_t reserved;            /**< Zero. */
    double max_force;             /**< Peak, N. */
    double max_continuous_force;  /**< That it can keep up, N. */
    double max_torque;            /**< Peak, N m. */
    double max_continuous_torque; /**< That it can keep up, N m. */
    double max_stiffness;         /**< That can be felt without buzzing, N/m. */
    double max_damping;           /**< The same, N s/m. */
    double update_rate;           /**< Samples a second, Hz. */
    double workspace_low[3];      /**< Corner of the box it reaches, device frame, m. */
    double workspace_high[3];     /**< The opposite corner; equal to `low`: not known. */
} vbss_device_capabilities;

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

/* ---- the adapter: functions of the host */

/**
 * Opens the hardware. May take its time, unlike `read` and `write`.
 *
 * @param user  the table's `user`
 * @return VBSS_OK, or any other number: it could not be opened
 */
typedef vbss_result (*vbss_device_open_fn)(void *user);

/**
 * Closes it. Outputs have been put off before.
 *
 * @param user  the table's `user`
 */
typedef void (*vbss_device_close_fn)(void *user);

/**
 * Tells what the hardware can do; called once, after `open`.
 *
 * @param user               the table's `user`
 * @param[out] capabilities  cleared but for struct_size
 * @return VBSS_OK, or any other number: it could not be told, and the device is not opened
 */
typedef vbss_result (*vbss_device_describe_fn)(void *user, vbss_device_capabilities *capabilities);

/**
 * Gives the newest sample, at once. The same sample may be given again: its time says so.
 *
 * @param user         the table's `user`
 * @param now          the host's clock, s
 * @param[out] sample  cleared, orientation (1, 0, 0, 0), but for struct_size
 * @return VBSS_OK, or any other number: there is no sample this time
 */
typedef vbss_result (*vbss_device_read_fn)(void *user, double now, vbss_device_sample *sample);

/**
 * Takes what is to be put out, at once.
 *
 * @param user    the table's `user`
 * @param now     the host's clock, s
 * @param output  what; all numbers are finite; parts that this adapter does not have are zero
 * @return VBSS_OK, or any other number: it was not put out
 */
typedef vbss_result (*vbss_device_write_fn)(void *user, double now,
                                            const vbss_output_result *output);

/**
 * Says in words what failed last.
 *
 * @param user       the table's `user`
 * @param[out] text  receives UTF-8 text and a final zero
 * @param bytes      room there is
 */
typedef void (*vbss_device_explain_fn)(void *user, char *text, uint32_t bytes);

/** An adapter. Fill it with #vbss_device_adapter_init, then set what there is. All functions are called on the thread
 * that calls the device, must return (no longjmp, no exception), and must not change the context. */
typedef struct vbss_device_adapter {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t reserved;    /**< Zero. */
    const char *name;     /**< For texts; NULL (default): "device". At most 31 bytes are kept. */
    void *user;           /**< Handed to the functions; may be NULL. */
    vbss_device_open_fn open;   /**< NULL (default): nothing to open. */
    vbss_device_close_fn close; /**< NULL (default): nothing to close. */
    /** NULL (default): all signals and outputs there are functions for. */
    vbss_device_describe_fn describe;
    vbss_device_read_fn read; /**< NULL (default) only beside another adapter, if `write` is not. */
    vbss_device_write_fn write;     /**< NULL (default): no outputs. */
    vbss_device_explain_fn explain; /**< NULL (default): no texts. */
} vbss_device_adapter;

/* ---- calibration: data */

/**
 * From the device to the world. Fill it with #vbss_device_calibration_init, then change what you need. With C the
 * rotation times the matrix of `axes`:
 *
 *     position     offset + C scale p, then the clutch's shift, then into the workspace
 *     orientation  C R C^T mount: at the device's identity the tool is oriented as `mount`
 *     force        to the device: force_scale C^T f
 *
 * A stiffness k in the world is felt as k scale force_scale.
 */
typedef struct vbss_device_calibration {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** World axis i is device axis |axes[i]| (1 to 3), negative: reversed; default 1, 2, 3. An odd one mirrors. */
    int32_t axes[3];
    double rotation[9]; /**< Then this rotation, row by row, right to 1e-6; default identity. */
    double scale;       /**< World metres per device metre, 1e-3 to 1e3; default 1. */
    double offset[3];   /**< m, each at most 1e3; default 0. */
    double mount[4]; /**< Tool frame in the handle's, w, x, y, z, any length; default 1, 0, 0, 0. */
    double workspace_low[3]; /**< Corner of the box that poses are kept in, world, m; default -1. */
    double workspace_high[3]; /**< The opposite corner, above it; each within 1e3; default 1. */
    double force_scale;       /**< 1e-3 to 1e3; default 1. */
    double jaw_closed;        /**< `jaw_raw` of the closed handle; default 0. */
    double jaw_open; /**< The same of the open one; more or less, but 1e-9 apart; default 1. */
    /** How far outside this range, as a part of it, a raw value is believed, 0 to 10; default 0.25. Beyond, the
     * sensor is broken and the value refused. */
    double jaw_margin;
    /** Movements of the opening smaller than this are not seen, 0 to 0.5; default 0.02. */
    double jaw_play;
    double jaw_time; /**< Time constant of the filter of the opening, s, 0 to 10; default 0.01. */
    /** The jaws count as closed from this opening down, 0 to 1; default 0.05, */
    double jaw_close_at;
    /** and as not closed again from this one up, at least jaw_close_at; default 0.1. */
    double jaw_open_at;
} vbss_device_calibration;

/* ---- the output stage */

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

/* ---- devices */

/** How the times of samples are read: a VBSS_DEVICE_CLOCK_ constant. */
typedef int32_t vbss_device_clock;

/** The constants of #vbss_device_clock. */
enum {
    /** Of any origin: a sample is as old as the read that found its time advanced. */
    VBSS_DEVICE_CLOCK_OWN = 0,
    /** The host's own: a sample is as old as it says, so that one that comes late is known to. */
    VBSS_DEVICE_CLOCK_SHARED = 1
};

/** How to make a device. Fill it with #vbss_device_config_init, then change what you need. */
typedef struct vbss_device_config {
    uint32_t struct_size;  /**< Size of this struct in bytes, set by the init function. */
    vbss_device_tool tool; /**< Where no adapter tells; default VBSS_DEVICE_TOOL_NEEDLE_DRIVER. */
    /** VBSS_DEVICE_HAS_ bits that come from the second adapter, if there is one; default the jaw. One of the pose
     * (position, orientation, velocities) brings all of it, one opening the other. */
    uint32_t second_signals;
    vbss_device_clock clock; /**< Default VBSS_DEVICE_CLOCK_OWN. */
    /** 1 (default): a lost adapter latches the emergency stop; 0: its samples just grow old. */
    uint32_t stop_when_lost;
    /** 1: the clutch holds the orientation too; 0 (default): it always follows. */
    uint32_t clutch_orientation;
    /** Age at which the jaw's opening is stale, s, 1e-4 to 1e3; default 0.1. The pose's is the output's
     * input_timeout. */
    double jaw_timeout;
    double velocity_time; /**< Time constant of estimated velocities, s, 0 to 10; default 0.005. */
    /** |1 - length| of an orientation that is taken and made unit, 0 to 0.5; default 1e-3. */
    double norm_tolerance;
    double max_stiffness; /**< Ceiling for couplings, N/m, 0 to 1e6; default 400. Only told. */
    double max_damping;   /**< The same, N s/m; default 4. Only told. */
    const vbss_device_calibration *calibration; /**< NULL (default): as initialised. Copied. */
    const vbss_output_config *output;           /**< NULL (default): as initialised. Copied. */
} vbss_device_config;

/** How a device is: a VBSS_DEVICE_ status constant. */
typedef int32_t vbss_device_status;

/** The constants of #vbss_device_status. */
enum {
    VBSS_DEVICE_WAITING = 0, /**< There was no pose yet. */
    VBSS_DEVICE_READY = 1,   /**< The pose is new. */
    VBSS_DEVICE_STALE = 2,   /**< The pose is old and held. */
    VBSS_DEVICE_LOST = 3     /**< An adapter says that its hardware is not there. */
};

/** What happened in a read: bits. */
enum {
    VBSS_DEVICE_EVENT_LOST = 1,         /**< An adapter's hardware is gone, */
    VBSS_DEVICE_EVENT_FOUND = 2,        /**< or back. */
    VBSS_DEVICE_EVENT_STALE = 4,        /**< The pose became stale, */
    VBSS_DEVICE_EVENT_FRESH = 8,        /**< or new again, or came for the first time. */
    VBSS_DEVICE_EVENT_JAW_STALE = 16,   /**< The opening became stale, */
    VBSS_DEVICE_EVENT_JAW_FRESH = 32,   /**< or new again, or came for the first time. */
    VBSS_DEVICE_EVENT_REFUSED = 64,     /**< A sample or raw opening was refused. */
    VBSS_DEVICE_EVENT_FAILED = 128,     /**< An adapter gave no sample. */
    VBSS_DEVICE_EVENT_STOPPED = 256,    /**< The device latched the emergency stop. */
    VBSS_DEVICE_EVENT_FAULT = 512,      /**< A device began to refuse forces. */
    VBSS_DEVICE_EVENT_RESTARTED = 1024, /**< The clock of an adapter began anew. */
    VBSS_DEVICE_EVENT_TOOL = 2048       /**< The tool is another. */
};

/** What a read found, in the world's frame. */
typedef struct vbss_device_input {
    uint32_t struct_size;      /**< Bytes of this struct that the library filled. */
    vbss_device_status status; /**< How the device is. */
    uint32_t valid;    /**< VBSS_DEVICE_HAS_ bits of what is known; estimated velocities count. */
    uint32_t stale;    /**< Of them, those that are too old and held; stale velocities are zero. */
    uint32_t events;   /**< VBSS_DEVICE_EVENT_ bits. */
    uint32_t clamped;  /**< 1, 2, 4: x, y, z is held at the workspace. */
    uint32_t buttons;  /**< As told last. */
    uint32_t pressed;  /**< Those that were up in the last read. */
    uint32_t released; /**< Those that were down in the last read. */
    vbss_device_tool tool;      /**< Kind of tool. */
    int32_t jaw_closed;         /**< 1: the jaws count as closed. */
    int32_t clutched;           /**< 1: the clutch is held: the pose stays, there is no force. */
    int32_t stopped;            /**< 1: the emergency stop is latched. */
    uint32_t reserved;          /**< Zero. */
    double time;                /**< Of the pose, by the adapter's clock, s. */
    double age;                 /**< Of the pose, s; -1: there was none. */
    double jaw_age;             /**< Of the opening, s; -1: there was none. */
    double position[3];         /**< m. */
    double orientation[4];      /**< w, x, y, z, unit: tool to world. */
    double velocity[3];         /**< m/s. */
    double angular_velocity[3]; /**< rad/s, in the world's frame. */
    double jaw;                 /**< Opening, 0 closed to 1 open. */
    double jaw_raw;             /**< As told last. */
    double temperature;         /**< As told last. */
} vbss_device_input;

/** Figures of a device since creation; [0] and [1]: of the first and the second adapter. */
typedef struct vbss_device_statistics {
    uint32_t struct_size;      /**< Bytes of this struct that the library filled. */
    uint32_t reserved;         /**< Zero. */
    uint64_t reads;            /**< Calls of #vbss_device_read. */
    uint64_t writes;           /**< Calls of #vbss_device_write. */
    uint64_t accepted[2];      /**< Samples that were taken. */
    uint64_t repeated[2];      /**< Samples whose time had not advanced. */
    uint64_t out_of_order[2];  /**< Refused: older than the one before. */
    uint64_t not_finite[2];    /**< Refused: with a NaN or an infinity. */
    uint64_t out_of_range[2];  /**< Refused: outside what the fields allow. */
    uint64_t not_unit[2];      /**< Refused: an orientation outside norm_tolerance. */
    uint64_t failed_reads[2];  /**< Reads without a sample. */
    uint64_t failed_writes[2]; /**< Outputs that were not taken. */
    uint64_t lost[2];          /**< How often the hardware was lost. */
    uint64_t faults[2];        /**< How often it began to refuse forces. */
    uint64_t restarts[2];      /**< How often its clock began anew. */
    uint64_t jaw_refused;      /**< Raw openings outside jaw_margin. */
    uint64_t pose_stale;       /**< How often the pose became stale. */
    uint64_t pose_stale_reads; /**< Reads in which it was. */
    uint64_t jaw_stale;        /**< How often the opening became stale. */
    uint64_t clamped_reads;    /**< Reads in which the workspace held the pose. */
    uint64_t clutches;         /**< How often the clutch was held. */
    double oldest_pose;        /**< Largest age of a pose, s. */
} vbss_device_statistics;

/* ---- the mock */

/**
 * What a mock measures: a function of time.
 *
 * @param user         the config's `user`
 * @param time         when, s: the host's clock, or earlier if a fault says so
 * @param[out] sample  `time` is set, all else is cleared, orientation (1, 0, 0, 0)
 */
typedef void (*vbss_mock_measure_fn)(void *user, double time, vbss_device_sample *sample);

/** How to make a mock. Fill it with #vbss_mock_config_init, then change what you need. */
typedef struct vbss_mock_config {
    uint32_t struct_size;    /**< Size of this struct in bytes, set by the init function. */
    uint32_t fault_capacity; /**< Most faults at a time, 0 to 4096; default 16. */
    /** Most rows of what was written that are kept, 0 to 2^20; default 1024. */
    uint32_t row_capacity;
    uint32_t reserved;            /**< Zero. */
    vbss_mock_measure_fn measure; /**< NULL (default): the sample of #vbss_mock_set_sample. */
    void *user;                   /**< Handed to measure; may be NULL. */
    /** NULL (default): 6 and 3 degrees of freedom, 3.3 N, 400 N/m, 4 N s/m, 1 kHz, a box of 0.15 m, all signals and
     * outputs. Copied. */
    const vbss_device_capabilities *capabilities;
} vbss_mock_config;

/** What goes wrong with a mock: a VBSS_MOCK_ fault constant. */
typedef int32_t vbss_mock_fault;

/** The constants of #vbss_mock_fault; t0: when the fault begins, v: its value. */
enum {
    /** A NaN in: 0 position, 1 orientation, 2 velocity, 3 jaw (raw and not), 4 time, as v says. */
    VBSS_MOCK_NAN = 1,
    VBSS_MOCK_STALL = 2,      /**< The sample of t0 again and again. */
    VBSS_MOCK_DISCONNECT = 3, /**< Reads and writes fail, with VBSS_DEVICE_FLAG_LOST. */
    VBSS_MOCK_RATE = 4,       /**< A new sample every v s only. */
    VBSS_MOCK_LATE = 5,       /**< Samples of v s ago. */
    /** Every second interval of v s, samples of v s ago: their order is broken. */
    VBSS_MOCK_SHUFFLE = 6,
    VBSS_MOCK_NORM = 7,        /**< Orientations of length v. */
    VBSS_MOCK_JUMP = 8,        /**< x further by v m. */
    VBSS_MOCK_TEMPERATURE = 9, /**< A temperature of v. */
    VBSS_MOCK_JAW = 10,        /**< A raw opening of v, as of a broken wire. */
    VBSS_MOCK_STOP = 11,       /**< VBSS_DEVICE_FLAG_STOP. */
    VBSS_MOCK_REFUSAL = 12,    /**< VBSS_DEVICE_FLAG_FAULT. */
    VBSS_MOCK_READ_FAILS = 13, /**< Reads fail. */
    VBSS_MOCK_WRITE_FAILS = 14 /**< Writes fail. */
};

/** What a mock went through. */
typedef struct vbss_mock_statistics {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    int32_t open;         /**< 1: it is open. */
    uint64_t opens;       /**< How often it was opened. */
    uint64_t reads;       /**< How often it was read. */
    uint64_t writes;      /**< How often it was written to, also in vain. */
    uint64_t rows_lost;   /**< Rows there was no room for. */
} vbss_mock_statistics;

/** What can be looked at in a mock: a VBSS_MOCK_VIEW_ constant. */
typedef int32_t vbss_mock_field;

/** The constants of #vbss_mock_field. */
enum {
    /** (n x 9) F64: now, force, torque, solenoid, flags of each write since #vbss_mock_clear_rows. */
    VBSS_MOCK_VIEW_ROWS = 1
};

/* ---- mapping of mouse, keyboard, gamepad */

/** How movements of hands on a desk become a pose. Fill it with #vbss_mapping_config_init, then change what you
 * need. Turns are about axes of the frame the pose is in. */
typedef struct vbss_mapping_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t pad_curve;   /**< Gamepad: power of the deflection, 1 to 4; default 2. */
    double right[3];      /**< Direction of the screen's right, unit to 1e-6; default x. */
    double up[3];   /**< Of its top, normal to it; default y. Right x up points towards the user. */
    double low[3];  /**< Corner of the box that positions are kept in, m; default -0.1. */
    double high[3]; /**< The opposite corner; each within 1e3; default 0.1. */
    double mouse_metres;  /**< Mouse: m a count; default 1e-4. */
    double mouse_depth;   /**< Mouse: m away from the user a notch of the wheel; default 2e-3. */
    double mouse_radians; /**< Mouse, turning: rad a count; default 5e-3. */
    /** Mouse, turning: rad about the direction of depth a notch; default 0.1. */
    double mouse_roll;
    double jaw_rate;    /**< Mouse: how fast the jaws close and open, 1/s, 0 to 1e3; default 4. */
    double key_metres;  /**< Keyboard: m a press; default 1e-3. */
    double key_radians; /**< Keyboard: rad a press; default 0.05. */
    double key_jaw;     /**< Keyboard: opening a press; default 0.1. */
    double pad_speed;   /**< Gamepad: m/s at full deflection; default 0.1. */
    double pad_turning; /**< Gamepad: rad/s at full deflection; default 1. */
    double pad_dead;    /**< Gamepad: deflection that counts as none, 0 to 0.9; default 0.15. */
} vbss_mapping_config;

/** Buttons of a mouse: bits. */
enum {
    VBSS_MAPPING_MOUSE_TURN = 1, /**< Movements turn instead of shift. */
    VBSS_MAPPING_MOUSE_CLOSE = 2 /**< The jaws close; otherwise they open. */
};

#ifdef __cplusplus
extern "C" {
#endif

/* ---- structs that hosts fill */

/**
 * Fills an adapter with the defaults: no functions.
 *
 * @param[out] adapter  the table to fill
 * @param struct_size   `sizeof *adapter` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_adapter_init(vbss_device_adapter *adapter, uint32_t struct_size);

/**
 * Fills a sample: nothing valid, orientation (1, 0, 0, 0).
 *
 * @param[out] sample  the sample to fill
 * @param struct_size  `sizeof *sample` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_sample_init(vbss_device_sample *sample, uint32_t struct_size);

/**
 * Fills capabilities: nothing known.
 *
 * @param[out] capabilities  what to fill
 * @param struct_size        `sizeof *capabilities` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_capabilities_init(vbss_device_capabilities *capabilities,
                                                   uint32_t struct_size);

/**
 * Fills a calibration with the defaults: the device's frame is the world's.
 *
 * @param[out] calibration  the calibration to fill
 * @param struct_size       `sizeof *calibration` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_calibration_init(vbss_device_calibration *calibration,
                                                  uint32_t struct_size);

/**
 * Fills a device's configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_config_init(vbss_device_config *config, uint32_t struct_size);

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
 * Fills a mock's configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_mock_config_init(vbss_mock_config *config, uint32_t struct_size);

/**
 * Fills a mapping with the defaults.
 *
 * @param[out] config  the mapping to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_mapping_config_init(vbss_mapping_config *config, uint32_t struct_size);

/* ---- devices */

/**
 * Opens a device: opens and describes its adapters, whose tables are copied.
 *
 * @param context      owner
 * @param first        the adapter of the pose; must have `read`
 * @param second       another for what `second_signals` says, and for outputs: the solenoid is the second's if it has
 *                     one, forces are the first's if it has them; NULL: there is none
 * @param config       how; NULL for the defaults
 * @param[out] device  the new device; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_DEVICE (an adapter could not be opened or described; the text says what it says),
 *         VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE (also: capabilities), VBSS_ERROR_OUT_OF_MEMORY or
 *         VBSS_ERROR_BUSY; on failure no adapter is open
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_create(vbss_context *context, const vbss_device_adapter *first,
                                        const vbss_device_adapter *second,
                                        const vbss_device_config *config, vbss_device **device);

/**
 * Puts all outputs off, closes the adapters and destroys the device.
 *
 * @param device  the device; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_destroy(vbss_device *device);

/**
 * Reads each adapter once. Whatever is wrong with the hardware is told by status, stale, events and statistics, and
 * what asks for somebody (lost, back, stopped, refuses forces, counts time anew) by a warning in the log; the call
 * succeeds. Nothing is allocated.
 *
 * @param device       the device
 * @param now          the host's clock, s; not before the `now` of an earlier call
 * @param[out] input   receives what was found
 * @param struct_size  `sizeof *input` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; then no
 *         adapter was read
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_read(vbss_device *device, double now, vbss_device_input *input,
                                      uint32_t struct_size);

/**
 * Puts a command through the output stage and writes what is left of it to the adapters. While the clutch is held,
 * forces and solenoid are off. Nothing is allocated.
 *
 * @param device       the device
 * @param now          the host's clock, s; not before the `now` of an earlier call
 * @param command      what is wanted, forces in the world's frame; NULL: there is no new command since the last, which
 *                     grows old
 * @param[out] result  receives what went out, in the device's frame; may be NULL
 * @param struct_size  `sizeof *result` as the caller was compiled
 * @return as #vbss_device_read, further VBSS_ERROR_UNKNOWN_FIELD; then nothing was written
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_write(vbss_device *device, double now,
                                       const vbss_output_command *command,
                                       vbss_output_result *result, uint32_t struct_size);

/**
 * Emergency stop: writes zeros at once, and latches: nothing goes out until #vbss_device_release.
 *
 * @param device  the device
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_stop(vbss_device *device);

/**
 * Lets the emergency stop go. Forces rise from zero; a cause that is still there latches again in the next read.
 *
 * @param device  the device
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_release(vbss_device *device);

/**
 * Holds or lets go the clutch. While it is held the pose stays and the hand moves freely; let go, the pose goes on
 * from where it stayed.
 *
 * @param device  the device
 * @param held    1: hold, 0: let go; as it was: nothing happens
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_clutch(vbss_device *device, int32_t held);

/**
 * Shifts and turns the calibrated pose so that the last sample stands for a given pose; lets the clutch go.
 *
 * @param device       the device
 * @param position     of the tool, world, m, each at most 1e3; NULL leaves it
 * @param orientation  w, x, y, z, of any length from 1e-100 to 1e100; NULL leaves it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE (also: there was no pose yet),
 *         VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_recentre(vbss_device *device, const double *position,
                                          const double *orientation);

/**
 * Calibrates a device anew, from the next read on; what clutch and re-centring did is forgotten, as is the filter
 * of the opening.
 *
 * @param device       the device
 * @param calibration  the calibration; NULL for the defaults
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_set_calibration(vbss_device *device,
                                                 const vbss_device_calibration *calibration);

/**
 * What the hardware can do.
 *
 * @param device             the device
 * @param which              0, 1: the first or second adapter, as it says; 2: both together, within the limits of the
 *                           configuration
 * @param[out] capabilities  receives it
 * @param struct_size        `sizeof *capabilities` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such adapter)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_get_capabilities(vbss_device *device, uint32_t which,
                                                  vbss_device_capabilities *capabilities,
                                                  uint32_t struct_size);

/**
 * What failed last in an adapter.
 *
 * @param device       the device
 * @param which        0, 1: the first or second adapter
 * @param[out] result  what its function returned, VBSS_OK when nothing has failed yet; may be NULL
 * @param[out] text    what it said of that, valid until the next call that reads, writes or restores the device; never
 *                     NULL; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_OUT_OF_RANGE (no such adapter)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_get_error(vbss_device *device, uint32_t which, vbss_result *result,
                                           const char **text);

/**
 * Figures of what came in.
 *
 * @param device           the device
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_get_statistics(vbss_device *device,
                                                vbss_device_statistics *statistics,
                                                uint32_t struct_size);

/**
 * Figures of the device's output stage.
 *
 * @param device           the device
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_get_output_statistics(vbss_device *device,
                                                       vbss_output_statistics *statistics,
                                                       uint32_t struct_size);

/**
 * Saves the device layer: calibration, clutch, filters, ages, output stage, latch, figures. What the adapters keep
 * is not in it.
 *
 * @param device        the device
 * @param[out] bytes    receives the snapshot; NULL is allowed when capacity is 0
 * @param capacity      bytes there is room for
 * @param[out] written  bytes written or, with VBSS_ERROR_CAPACITY, wanted
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_save(vbss_device *device, uint8_t *bytes, uint64_t capacity,
                                      uint64_t *written);

/**
 * Restores what was saved from a device with the same configuration and capabilities. All or nothing. The latch of the
 * emergency stop comes back as it was saved: with a hand on the device, call #vbss_device_stop after it.
 *
 * @param device  the device
 * @param bytes   the snapshot
 * @param count   its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT
 *         (also: of another device), VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on
 *         failure nothing has changed
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_restore(vbss_device *device, const uint8_t *bytes, uint64_t count);

/**
 * A hash of the device layer: equal for equal histories, on every machine.
 *
 * @param device     the device
 * @param[out] hash  receives it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_get_hash(vbss_device *device, uint64_t *hash);

/* ---- output stages alone */

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

/* ---- mocks */

/**
 * Creates a mock.
 *
 * @param context    owner
 * @param config     how; NULL for the defaults
 * @param[out] mock  the new mock; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_mock_create(vbss_context *context, const vbss_mock_config *config,
                                      vbss_mock **mock);

/**
 * Destroys a mock. A device that stands on it finds it lost.
 *
 * @param mock  the mock; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_mock_destroy(vbss_mock *mock);

/**
 * The mock as an adapter, for one device at a time.
 *
 * @param mock             the mock
 * @param[in,out] adapter  an initialised table; every field of it is set
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_mock_get_adapter(vbss_mock *mock, vbss_device_adapter *adapter);

/**
 * Hands in the sample that is given from now on, unless the mock has a function of time. It is given as it is, wrong
 * numbers too; faults come on top.
 *
 * @param mock    the mock
 * @param sample  an initialised sample
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_mock_set_sample(vbss_mock *mock, const vbss_device_sample *sample);

/**
 * Adds a fault. STALL, RATE, LATE and SHUFFLE need a function of time; faults act in the order they were added.
 *
 * @param mock   the mock
 * @param fault  what goes wrong
 * @param from   first `now` at which it does, s
 * @param until  first `now` at which it does not any more, s, not before `from`; up to 1e9
 * @param value  as the fault says; RATE, SHUFFLE: 1e-6 to 1e3, LATE: 0 to 1e3, NAN: 0 to 4, others: up to 1e9
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE (also: there is no function of time),
 *         VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_mock_add_fault(vbss_mock *mock, vbss_mock_fault fault, double from,
                                         double until, double value);

/**
 * Removes all faults.
 *
 * @param mock  the mock
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_mock_clear_faults(vbss_mock *mock);

/**
 * Forgets the rows of what was written.
 *
 * @param mock  the mock
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_mock_clear_rows(vbss_mock *mock);

/**
 * Looks at what was written.
 *
 * @param mock         the mock
 * @param field        which
 * @param[out] view    receives it; valid until the next write or change
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_mock_get_view(vbss_mock *mock, vbss_mock_field field, vbss_view *view,
                                        uint32_t struct_size);

/**
 * Figures since creation.
 *
 * @param mock             the mock
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_mock_get_statistics(vbss_mock *mock, vbss_mock_statistics *statistics,
                                              uint32_t struct_size);

/* ---- mapping: pure functions. Each moves the position, orientation and opening of a sample, makes them valid,
 * and adds h to its time. On failure the sample is as it was. */

/**
 * Moves by a mouse: shifts in the plane of the screen and, by the wheel, in depth; turning, turns the far side of
 * the tool the way the mouse goes, and rolls by the wheel.
 *
 * @param config          the mapping; NULL for the defaults
 * @param motion          counts to the right, counts up, notches of the wheel away from the user; each at most 1e6
 * @param buttons         VBSS_MAPPING_MOUSE_ bits
 * @param h               time since the last call, s, 0 to 10
 * @param[in,out] sample  an initialised sample
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_mapping_mouse(const vbss_mapping_config *config, const double motion[3],
                                        uint32_t buttons, double h, vbss_device_sample *sample);

/**
 * Moves by presses of keys.
 *
 * @param config          the mapping; NULL for the defaults
 * @param presses         how often since the last call, negative for the opposite key: right, up, towards the user,
 *                        turns about these three, opening; each at most 1e6
 * @param h               time since the last call, s, 0 to 10
 * @param[in,out] sample  an initialised sample
 * @return as #vbss_mapping_mouse
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_mapping_keyboard(const vbss_mapping_config *config,
                                           const double presses[7], double h,
                                           vbss_device_sample *sample);

/**
 * Moves by a gamepad: axes are rates, with a dead zone and a curve.
 *
 * @param config          the mapping; NULL for the defaults
 * @param axes            -1 to 1: right, up, towards the user, turns about these three; more counts as full
 * @param opening         of the jaws, 0 to 1, as a trigger says
 * @param h               time since the last call, s, 0 to 10
 * @param[in,out] sample  an initialised sample
 * @return as #vbss_mapping_mouse
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_mapping_gamepad(const vbss_mapping_config *config, const double axes[6],
                                          double opening, double h, vbss_device_sample *sample);

#ifdef __cplusplus
}
#endif

#endif
