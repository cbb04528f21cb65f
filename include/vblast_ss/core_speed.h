/**
 * @file core_speed.h
 * @brief Measures the speed of the processor core, so that the budgets of a scene's solver fit it.
 *
 * The budgets of vbss_solver_options are microseconds of a core with a given speed. Without a
 * measurement this is a core of 2.6 GHz. A host that wants budgets of its own core measures the
 * speed once, stores the number if it likes, and passes it to each scene that it creates:
 *
 *     vbss_core_speed speed;
 *     vbss_solver_options solver = vbss_solver_options_default();
 *     vbss_scene_config config = vbss_scene_config_default();
 *     vbss_core_speed_measure(context, seconds, NULL, &speed, sizeof speed);
 *     solver.operations_per_us = speed.operations_per_us;
 *     config.solver = &solver;
 *     vbss_scene_create(context, &config, &scene);
 *
 * #vbss_scene_set_budgets passes it to a running scene. The results of a scene depend on the number,
 * which differs between measurements. Logs and snapshots store it, so a replay gives the same bits on
 * every machine, whatever its speed. The replaying host creates the scene with the options of the
 * log, not with options of its own (#vbss_replay_get_scene_config).
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_CORE_SPEED_H
#define VBLAST_SS_CORE_SPEED_H

#include <vblast_ss/base.h>

/**
 * Reads a clock of the host. The function must return (no longjmp, no exception). Its calls that
 * would change the context return VBSS_ERROR_BUSY.
 *
 * @param user  the pointer that the host has passed with the function; may be NULL
 * @return time since any fixed moment, s; it never runs backwards
 */
typedef double (*vbss_core_speed_clock_fn)(void *user);

/** Speed of the processor core on which a measurement ran. */
typedef struct vbss_core_speed {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t steps;       /**< Number of timed steps of the fixed scene. */
    /** Speed for vbss_solver_options::operations_per_us, operations per us; > 0. A few hundred on a
     * core of 2.6 GHz. A quarter of the steps were at least as fast. Steps that other programs have
     * interrupted do not affect it, as long as they are fewer than three quarters. */
    double operations_per_us;
    /** Median time of the steps divided by their lower quartile, at least 1. A value far above 1
     * means that other programs have often interrupted the measurement. */
    double spread;
    double duration; /**< Time of all timed steps on the host's clock, s. */
} vbss_core_speed;

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
VBSS_API vbss_result vbss_core_speed_measure(vbss_context *context, vbss_core_speed_clock_fn clock,
                                             void *user, vbss_core_speed *speed,
                                             uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
