/**
 * @file mock.h
 * @brief An adapter without hardware, for tests, demonstrations and replays.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_MOCK_H
#define VBLAST_SS_MOCK_H

#include <vblast_ss/adapter.h>

/** An adapter without hardware: driven by a function of time or by samples, with faults on demand. */
typedef struct vbss_mock vbss_mock;

/**
 * Sample of a mock as a function of time.
 *
 * @param user         the config's `user`
 * @param time         time of the sample, s: the host's clock, or earlier by a fault
 * @param[out] sample  `time` is set, all else is cleared, orientation (1, 0, 0, 0)
 */
typedef void (*vbss_mock_measure_fn)(void *user, double time, vbss_device_sample *sample);

/** Configuration of a mock. Fill it with #vbss_mock_config_init, then change fields. */
typedef struct vbss_mock_config {
    uint32_t struct_size;    /**< Size of this struct in bytes, set by the init function. */
    uint32_t fault_capacity; /**< Largest number of faults, 0 to 4096; default 16. */
    /** Largest number of stored rows, one for each write, 0 to 2^20; default 1024. */
    uint32_t row_capacity;
    uint32_t reserved; /**< Zero. */
    /** Function of time for samples; NULL (default): the sample of #vbss_mock_set_sample. */
    vbss_mock_measure_fn measure;
    void *user; /**< Argument of measure; may be NULL. */
    /** Capabilities; NULL (default): 6 and 3 degrees of freedom, 3.3 N, 400 N/m, 4 N s/m, 1 kHz,
     * a box of 0.15 m, all signals and outputs. The library copies them. */
    const vbss_device_capabilities *capabilities;
} vbss_mock_config;

/** Fault of a mock: a VBSS_MOCK_FAULT_ constant. */
typedef int32_t vbss_mock_fault;

/** The constants of #vbss_mock_fault; t0: start of the fault, v: its value. */
enum {
    /** A NaN in the position (v = 0), orientation (1), velocity (2), jaw and jaw_raw (3), or
     * time (4). */
    VBSS_MOCK_FAULT_NAN = 1,
    VBSS_MOCK_FAULT_STALL = 2,      /**< Each read repeats the sample of t0. */
    VBSS_MOCK_FAULT_DISCONNECT = 3, /**< Reads and writes fail, with VBSS_DEVICE_FLAG_LOST. */
    VBSS_MOCK_FAULT_RATE = 4,       /**< Only one new sample every v s. */
    VBSS_MOCK_FAULT_LATE = 5,       /**< Samples of v s ago. */
    /** In every second interval of v s, samples of v s ago, so that their order is broken. */
    VBSS_MOCK_FAULT_SHUFFLE = 6,
    VBSS_MOCK_FAULT_NORM = 7,        /**< Orientations of length v. */
    VBSS_MOCK_FAULT_JUMP = 8,        /**< The x coordinate is larger by v m. */
    VBSS_MOCK_FAULT_TEMPERATURE = 9, /**< A temperature of v. */
    VBSS_MOCK_FAULT_JAW = 10,        /**< A raw opening of v, like that of a broken wire. */
    VBSS_MOCK_FAULT_STOP = 11,       /**< VBSS_DEVICE_FLAG_STOP. */
    VBSS_MOCK_FAULT_REFUSAL = 12,    /**< VBSS_DEVICE_FLAG_FAULT. */
    VBSS_MOCK_FAULT_READ_FAILS = 13, /**< Reads fail. */
    VBSS_MOCK_FAULT_WRITE_FAILS = 14 /**< Writes fail. */
};

/** Counters of a mock. */
typedef struct vbss_mock_statistics {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    int32_t open;         /**< 1: the mock is open. */
    uint64_t opens;       /**< Number of calls that opened it. */
    uint64_t reads;       /**< Number of reads. */
    uint64_t writes;      /**< Number of writes, also those that failed. */
    uint64_t rows_lost;   /**< Rows beyond row_capacity. */
} vbss_mock_statistics;

/** An array: a VBSS_MOCK_VIEW_ constant. */
typedef int32_t vbss_mock_field;

/** The constants of #vbss_mock_field. */
enum {
    /** (n x 9) F64: now, force, torque, solenoid, flags of each write since #vbss_mock_clear_rows. */
    VBSS_MOCK_VIEW_ROWS = 1
};

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a mock's configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_mock_config_init(vbss_mock_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_mock_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_mock_config vbss_mock_config_default(void)
{
    vbss_mock_config vbss_filled;
    (void)vbss_mock_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Creates a mock.
 *
 * @param context    owner
 * @param config     the configuration; NULL for the defaults
 * @param[out] mock  the new mock; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_mock_create(vbss_context *context, const vbss_mock_config *config,
                                      vbss_mock **mock);

/**
 * Destroys a mock. A device that uses it reports it as lost.
 *
 * @param mock  the mock; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_mock_destroy(vbss_mock *mock);

/**
 * Fills an adapter table for the mock, for one device at a time.
 *
 * @param mock             the mock
 * @param[in,out] adapter an initialised table; the call sets every field
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_mock_get_adapter(vbss_mock *mock, vbss_device_adapter *adapter);

/**
 * Sets the sample that later reads return, unless the mock has a function of time. Reads return it
 * unchecked, even with invalid numbers; faults act on it afterwards.
 *
 * @param mock    the mock
 * @param sample  an initialised sample
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_mock_set_sample(vbss_mock *mock, const vbss_device_sample *sample);

/**
 * Adds a fault. STALL, RATE, LATE and SHUFFLE need a function of time; faults act in the order they were added.
 *
 * @param mock   the mock
 * @param fault  the fault
 * @param from   first `now` with the fault, s
 * @param until  first `now` without the fault, s, not before `from`; up to 1e9
 * @param value  value of the fault; RATE, SHUFFLE: 1e-6 to 1e3, LATE: 0 to 1e3, NAN: 0 to 4,
 *         others: up to 1e9
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_INCOMPATIBLE
 *         (there is no function of time), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_mock_add_fault(vbss_mock *mock, vbss_mock_fault fault, double from,
                                         double until, double value);

/**
 * Removes all faults.
 *
 * @param mock  the mock
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_mock_clear_faults(vbss_mock *mock);

/**
 * Clears the rows of the writes.
 *
 * @param mock  the mock
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_mock_clear_rows(vbss_mock *mock);

/**
 * Returns a view of the rows of the writes.
 *
 * @param mock         the mock
 * @param field        the array
 * @param[out] view    receives the view; valid until the next write or change
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_mock_get_view(vbss_mock *mock, vbss_mock_field field, vbss_view *view,
                                        uint32_t struct_size);

/**
 * Returns the counters since creation.
 *
 * @param mock             the mock
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_mock_get_statistics(vbss_mock *mock, vbss_mock_statistics *statistics,
                                              uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
