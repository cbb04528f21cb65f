/**
 * @file adapter.h
 * @brief What stands between a device (device.h) and one piece of hardware: a table of functions, and what they speak of.
 *
 * Hosts fill the table for hardware of their own; mock.h and haptics.h hand out filled ones.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_ADAPTER_H
#define VBLAST_SS_ADAPTER_H

#include <vblast_ss/output.h>

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
    VBSS_DEVICE_FLAG_FAULT = 4,
    /** It is too slow to put outputs off within vbss_output_result::expires. `explain` says how slow. */
    VBSS_DEVICE_FLAG_SLOW = 8
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

/**
 * A virtual coupling between the hand and the tool: to the hand goes
 *
 *     force + stiffness (position - p) + damping (velocity - v)
 *
 * with p and v the hand's. Fill it with #vbss_device_coupling_init, then set what you want. A device computes this force
 * where it is written to, from what was read last; an adapter with a servo of its own (haptics.h) computes it again in
 * every tick, from what it has just measured, so that no delay of the simulation stands between the hand and its spring.
 */
typedef struct vbss_device_coupling {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t reserved;    /**< Zero. */
    double position[3];   /**< Of the tool that the hand is tied to, m, each at most 1e3. */
    double velocity[3];   /**< Of the tool, m/s, each at most 1e3; default 0. */
    double force[3];      /**< N, added, each at most 1e3; default 0. */
    double stiffness;     /**< N/m, 0 to 1e6; default 0. */
    double damping;       /**< N s/m, 0 to 1e6; default 0. */
} vbss_device_coupling;

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

/**
 * As #vbss_device_write_fn, and instead of it where there is a coupling and nothing speaks against it: the output's force
 * is the coupling's at the pose that was read last. The adapter may put out the coupling's force at newer poses, within
 * limits as in the output stage, until `expires` has passed.
 *
 * @param user      the table's `user`
 * @param now       the host's clock, s
 * @param output    what; all numbers are finite
 * @param coupling  the coupling, in the device's frame
 * @return VBSS_OK, or any other number: it was not put out
 */
typedef vbss_result (*vbss_device_couple_fn)(void *user, double now,
                                             const vbss_output_result *output,
                                             const vbss_device_coupling *coupling);

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
    vbss_device_couple_fn couple;   /**< NULL (default): no servo of its own. */
} vbss_device_adapter;

#ifdef __cplusplus
extern "C" {
#endif

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
 * Fills a coupling: none.
 *
 * @param[out] coupling  the coupling to fill
 * @param struct_size    `sizeof *coupling` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_coupling_init(vbss_device_coupling *coupling,
                                               uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
