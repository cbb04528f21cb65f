/**
 * @file budget.h
 * @brief Work limits of a scene that fit the processor: a measurement, and limits computed from it.
 *
 * A real-time scene limits its work in operations (vbss_scene_config::step_budget and
 * vbss_scene_config::call_budget), so that its results are the same on every machine. How long an
 * operation takes depends on the processor. A host measures the speed of its core once, before it
 * creates a scene, and sets the limits of the configuration from that speed:
 *
 *     vbss_budget_speed speed;
 *     vbss_budget_config budget;
 *     vbss_scene_config config;
 *     vbss_budget_measure_speed(context, seconds, NULL, &speed, sizeof speed);
 *     vbss_budget_config_init(&budget, sizeof budget);
 *     budget.operations_per_microsecond = speed.operations_per_microsecond;
 *     vbss_scene_config_init(&config, sizeof config);
 *     vbss_budget_fit_scene(context, &budget, &config);
 *     vbss_scene_create(context, &config, &scene);
 *
 * The limits of a scene never change after its creation. Logs and snapshots store them, so a replay
 * gives the same bits on every machine, whatever its speed. The replaying host creates the scene
 * with the limits of the log, not with limits of its own (#vbss_replay_get_scene_config).
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_BUDGET_H
#define VBLAST_SS_BUDGET_H

#include <vblast_ss/scene.h>

/**
 * Reads a clock of the host. The function must return (no longjmp, no exception). Its calls that
 * would change the context return VBSS_ERROR_BUSY.
 *
 * @param user  the pointer that the host has passed with the function; may be NULL
 * @return time since any fixed moment, s; it never runs backwards
 */
typedef double (*vbss_budget_clock_fn)(void *user);

/** Speed of the processor core on which a measurement ran. */
typedef struct vbss_budget_speed {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t steps;       /**< Number of timed steps of the fixed scene. */
    /** Speed in operations, as vbss_scene_config::step_budget counts them, per microsecond; > 0. A few
     * hundred on a core of 2.6 GHz. A quarter of the steps were at least as fast. Steps that other
     * programs have interrupted do not affect it, as long as they are fewer than three quarters. */
    double operations_per_microsecond;
    /** Median time of the steps divided by their lower quartile, at least 1. A value far above 1
     * means that other programs have often interrupted the measurement. */
    double spread;
    double duration; /**< Time of all timed steps on the host's clock, s. */
} vbss_budget_speed;

/** Time that a call of #vbss_scene_step may take. Fill it with #vbss_budget_config_init, then set
 * the speed. */
typedef struct vbss_budget_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** 1: the limits may exceed the defaults of vbss_scene_config on a fast core; default 0. */
    uint32_t allows_more;
    /** Speed of the core, operations per microsecond, 1e-3 to 1e6; no default. */
    double operations_per_microsecond;
    double slot; /**< Time between two calls of #vbss_scene_step, s, 1e-5 to 1; default 1e-3. */
    /** Share of the slot that the operations of a call may take, 0.01 to 1; default 0.5. The rest is
     * for the work that operations do not count, for calls that exceed their limit, and for the
     * host. */
    double share;
} vbss_budget_config;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Measures the speed of the core on which the call runs. The call creates a small fixed scene in
 * the context, makes 64 steps, times 48 of them, and destroys the scene. This takes some 40 ms on a
 * core of 2.6 GHz, and proportionally longer on a slower one. The host passes a clock, as the library reads
 * none itself: a monotonic clock, or better one of the thread's CPU time. No existing object changes,
 * and no later result depends on the call.
 *
 * The status names a clock that cannot measure. A few late readings are no fault of a clock, as
 * other programs may interrupt the host.
 *
 * @param context      the context, in whose memory the fixed scene lives during the call
 * @param clock        the clock
 * @param user         pointer that the clock receives; may be NULL
 * @param[out] speed   receives the speed
 * @param struct_size  `sizeof *speed` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_NOT_FINITE (a reading of the clock), VBSS_ERROR_CLOCK_STOPPED (all readings are
 *         equal), VBSS_ERROR_CLOCK_JUMPED (a reading is before the previous one, or more than 1 s
 *         after it), VBSS_ERROR_CLOCK_COARSE (the clock does not resolve a tenth of a step, some
 *         0.05 ms),
 *         VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_budget_measure_speed(vbss_context *context, vbss_budget_clock_fn clock,
                                               void *user, vbss_budget_speed *speed,
                                               uint32_t struct_size);

/**
 * Fills a budget with the defaults.
 *
 * @param[out] budget  the budget to fill
 * @param struct_size  `sizeof *budget` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_budget_config_init(vbss_budget_config *budget, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_budget_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_budget_config vbss_budget_config_default(void)
{
    vbss_budget_config vbss_filled;
    (void)vbss_budget_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Sets `step_budget` and `call_budget` of a scene's configuration, so that the operations of a call
 * take the given share of its slot. call_budget is the number of operations that the core does in
 * that time, and step_budget is 25/21 of it, as in the defaults. Both are at most the defaults
 * (250000 and 210000), unless `allows_more` is set; then they are at most 2500000 and 2100000. They are
 * at least 50000 and 42000: a step with less work completes hardly any motion. A core that is too
 * slow for this floor causes a warning in the log, and calls exceed their share of the slot.
 *
 * @param context         the context that receives error texts and the warning
 * @param budget          the budget, with the speed of the core
 * @param[in,out] config  the configuration; other fields stay as they are
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_budget_fit_scene(vbss_context *context, const vbss_budget_config *budget,
                                           vbss_scene_config *config);

#ifdef __cplusplus
}
#endif

#endif
