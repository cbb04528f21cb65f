/**
 * @file baseline.h
 * @brief Parameters and counters of the method VBSS_METHOD_VBLAST, the baseline (VBLaST-SS, Qi et al. 2017).
 *
 * Objects of this method take these parameters from the field `baseline` of their configurations:
 * collision, thread, drain, grasper and scene. One struct serves all five, so that one comparison
 * sets it once. An object copies it when it is created; NULL means the defaults. Objects of other
 * methods check it and ignore it. docs/explanation/paper-thread.md, paper-drain.md, paper-scene.md and
 * paper-collision.md derive the defaults.
 *
 * What only this method counts is in a struct of its own, which #vbss_scene_get_baseline_statistics,
 * #vbss_thread_get_baseline_statistics and #vbss_collision_get_baseline_statistics return.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_BASELINE_H
#define VBLAST_SS_BASELINE_H

#include <vblast_ss/base.h>

/** Parameters of the baseline. Fill it with #vbss_baseline_config_init, then change fields. */
typedef struct vbss_baseline_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** Explicit steps of a thread in one step, 1 to 100000; 0 (default): as many as the stiffest
     * bending mode and the tension need. */
    uint32_t thread_substeps;
    /** Largest number of iterations of a thread's projection, 1 to 1000; default 50. */
    uint32_t thread_iteration_limit;
    /** Explicit steps of a drain in one step, 1 to 100000; 0 (default): as many as stability needs. */
    uint32_t drain_substeps;
    /** Number of passes of detection and response in a step of a scene, 1 to 1000; default 4. */
    uint32_t scene_pass_limit;
    uint32_t reserved; /**< Zero. */
    /** Of collision.h alone; scenes use the default. Edges are parallel when |a|^2 |b|^2 - (a.b)^2 is
     * below this, in collision_unit^4; 0 to 1; default 1e-6. */
    double collision_parallel;
    /** Of collision.h alone; scenes use the default. Unit of length, m, 1e-9 to 1e3; default 1e-3. */
    double collision_unit;
    /** Spring constant of a segment of a thread, N/m, 0 to 1e9; default 0: derived from mass and
     * step by docs/explanation/paper-thread.md. */
    double thread_stiffness;
    /** Share of the velocity relative to the rigid motion of a thread's section that each explicit
     * step removes, 0 to 1; default 0. */
    double thread_damping;
    /** Largest |C| / l of a section of a thread, 1e-14 to 1; default 1e-6. */
    double thread_tolerance;
    /** Stiffness of the spring that ties a particle of a drain to its rest position, N/m, 0 to 1e9;
     * default 125. */
    double drain_stiffness;
    /** Share of the velocity relative to the rigid motion of the drain that each explicit step
     * removes, 0 to 1; default 0.7. */
    double drain_damping;
    /** Factor k_s of the force on the hand of a grasper, k_s (stretched length - length), N/m, 0 to
     * 1e6; default 50. */
    double grasper_stiffness;
    /** Largest distance from the tip of a grasper at which closing jaws take a node, and from the
     * centre line of the jaws at which they take a needle, m, 0 to 0.1; default 2e-3 (the paper
     * gives no number). */
    double grasper_distance;
    /** Distance that a scene keeps beyond contact (the paper's eps_D), m, 0 to 1e-2; default 0. */
    double scene_thickness;
} vbss_baseline_config;

/** Counters of the baseline since the creation of an object, and results of its last step. One struct
 * serves scenes, threads and collision objects; each fills the fields of its kind, and the others are 0.
 * They are part of the state: a snapshot restores them. */
typedef struct vbss_baseline_statistics {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    /** Scene: pairs that the last search of the last step found. */
    uint32_t last_candidates;
    /** Scene: passes of detection and response in all steps; at least one a step. */
    uint64_t passes;
    uint64_t tested_pairs; /**< Scene: pairs that these passes tested, the floor excluded. */
    /** Scene: steps whose last pass still moved a body, because of
     * vbss_baseline_config::scene_pass_limit. */
    uint64_t unconverged_steps;
    /** Thread: iterations of the projection, summed over sections and explicit steps. */
    uint64_t projection_iterations;
    /** Thread: projections that did not converge, so that their section kept the positions from before. */
    uint64_t failed_projections;
    /** Collision object, and scene: continuous tests that the sign of w.w' ended
     * (docs/explanation/paper-collision.md). */
    uint64_t sign_tests_ended;
    uint32_t last_projection_iterations; /**< Thread: the part of the last step. */
    uint32_t reserved;                   /**< Zero. */
} vbss_baseline_statistics;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills the parameters of the baseline with the defaults.
 *
 * @param[out] config  the parameters to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_baseline_config_init(vbss_baseline_config *config, uint32_t struct_size);

/**
 * The default parameters of the baseline.
 *
 * @return the struct that #vbss_baseline_config_init fills
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_baseline_config vbss_baseline_config_default(void)
{
    vbss_baseline_config vbss_filled;
    (void)vbss_baseline_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

#ifdef __cplusplus
}
#endif

#endif
