/**
 * @file solver_options.h
 * @brief Options of a scene's solver: budgets of time, tolerances and limits.
 *
 * The field `solver` of #vbss_scene_config points to these options. A scene copies them when it is
 * created; NULL means the defaults. Scenes of method VBLAST check them, but use only the stretch and
 * penetration tolerances.
 *
 * Budgets are microseconds of a core that does `operations_per_us` operations per microsecond. The
 * scene counts operations and reads no clock. Its results are therefore the same on every machine,
 * and depend on the two products of budget and `operations_per_us` alone. By default there is no
 * calibration: the value is that of a core of 2.6 GHz. A host that calibrates measures it once
 * (core_speed.h), may store the number, and passes it to all its scenes.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_SOLVER_OPTIONS_H
#define VBLAST_SS_SOLVER_OPTIONS_H

#include <vblast_ss/base.h>

/** Options of a scene's solver. Fill them with #vbss_solver_options_init, then change fields. */
typedef struct vbss_solver_options {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** Largest number of linearisations of an attempt, 1 to 100; default 12. */
    uint32_t iteration_limit;
    /** Largest number of solves for the contact states in a linearisation, 1 to 1000; default 36. */
    uint32_t active_set_limit;
    uint32_t halving_limit; /**< How often a step may be halved, 0 to 10; default 5. */
    /** REAL_TIME: number of attempts in a step after which the rest of the step is left out, 1 to
     * 1000; default 3. Without a step budget each remaining part is tried once, and truncated if
     * necessary; after eight truncated parts the rest is left out. */
    uint32_t attempt_limit;
    uint32_t reserved; /**< Zero. */
    /** Largest stretch error that a step may leave, 1e-9 to 1e-1; default 1e-3. */
    double stretch_tolerance;
    /** Largest penetration that a step may leave, as a share of the diameter of the thinner body,
     * 1e-3 to 0.5; default 0.1. From a state with more penetration a step is accepted if it
     * reduces it. */
    double penetration_tolerance;
    /** Distance for the contact search, beyond the contact distance and the possible approach in
     * the step, m, 0 to 0.1; default 3e-5. A larger margin costs time; a smaller one costs
     * retries. */
    double contact_margin;
    /** REAL_TIME, method IMPLICIT: time of a step after which the search for contact states stops,
     * us, 0 to 1e7; 0: no limit; default 500. The budget in operations is the nearest integer of
     * step_budget_us times operations_per_us, 1 to 4294967295. An operation costs about as much as a
     * product of two 3x3 blocks (docs/explanation/real-time.md). At the limit the step uses the contact forces
     * found so far. They balance, but miss the contact law by up to
     * vbss_scene_statistics::last_residual. Lengths still converge, with a few solves beyond the
     * limit. The rest of the step is left out (vbss_scene_statistics::paused) when lengths do not
     * converge, after attempt_limit attempts, or when these forces add too much energy without
     * work: 20 uJ, or 1 mJ in a scene without drains. The next step then begins with smaller
     * parts, and driven bodies continue from where they stopped. In a scene's first step, whose
     * bodies may overlap as they were placed, an attempt has no limit. Between its attempts 32
     * times the step budget and attempt_limit apply, and it is never suspended. The smallest part
     * that halving_limit allows has no limit. If its contact states are not found, it is tried once
     * more with the full limit for itself. In a scene with drains the smallest part has the limit
     * too, and a part that exceeds it is halved up to three more times, after which it has none.
     * With less than a fifth of the default operations a step makes hardly any progress. */
    double step_budget_us;
    /** REAL_TIME with a step budget, method IMPLICIT: time of a call of #vbss_scene_step, us, 0 to
     * 1e7; 0: each call completes its step; default 420. It is converted to operations as the step
     * budget is. A step that needs more is suspended. The next call resumes it, with the bits that
     * it would have had without the suspension. With its remaining operations that call begins the
     * next step. After a call bodies are therefore up to two steps behind
     * (vbss_scene_statistics::behind), some of them by a part of a step. Time beyond that is left
     * out and counted in `paused`. New targets of graspers, driven bodies and attachments apply to
     * the next step. Any other change by the host abandons the suspended step, which also counts in
     * `paused`, and the next 1000 steps are not suspended. A call may exceed the limit by the final
     * work of a step and by attempts that the guard refuses. If other bodies wait for it, a step
     * that two calls have suspended is completed by the third, whatever it takes, and counted in
     * `overdue`. So bodies that touch nothing never miss more than three calls. */
    double call_budget_us;
    /** Speed of the core for which the budgets count, operations per us, 1e-3 to 1e6; default 500:
     * a core of 2.6 GHz. #vbss_core_speed_measure measures it. */
    double operations_per_us;
} vbss_solver_options;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills the options of a solver with the defaults.
 *
 * @param[out] options  the options to fill
 * @param struct_size   `sizeof *options` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_solver_options_init(vbss_solver_options *options, uint32_t struct_size);

/**
 * The default options of a solver.
 *
 * @return the struct that #vbss_solver_options_init fills
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_solver_options vbss_solver_options_default(void)
{
    vbss_solver_options vbss_filled;
    (void)vbss_solver_options_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

#ifdef __cplusplus
}
#endif

#endif
