// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


/// Parameters of the baseline. Fill it with vbss_baseline_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_baseline_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Explicit steps of a thread in one step, 1 to 100000; 0 (default): as many as the stiffest
    /// bending mode and the tension need.
    pub thread_substeps: u32,
    /// Largest number of iterations of a thread's projection, 1 to 1000; default 50.
    pub thread_iteration_limit: u32,
    /// Explicit steps of a drain in one step, 1 to 100000; 0 (default): as many as stability needs.
    pub drain_substeps: u32,
    /// Number of passes of detection and response in a step of a scene, 1 to 1000; default 4.
    pub scene_pass_limit: u32,
    /// Zero.
    pub reserved: u32,
    /// Of collision.h alone; scenes use the default. Edges are parallel when |a|^2 |b|^2 - (a.b)^2 is
    /// below this, in collision_unit^4; 0 to 1; default 1e-6.
    pub collision_parallel: f64,
    /// Of collision.h alone; scenes use the default. Unit of length, m, 1e-9 to 1e3; default 1e-3.
    pub collision_unit: f64,
    /// Spring constant of a segment of a thread, N/m, 0 to 1e9; default 0: derived from mass and
    /// step by docs/explanation/paper-thread.md.
    pub thread_stiffness: f64,
    /// Share of the velocity relative to the rigid motion of a thread's section that each explicit
    /// step removes, 0 to 1; default 0.
    pub thread_damping: f64,
    /// Largest |C| / l of a section of a thread, 1e-14 to 1; default 1e-6.
    pub thread_tolerance: f64,
    /// Stiffness of the spring that ties a particle of a drain to its rest position, N/m, 0 to 1e9;
    /// default 125.
    pub drain_stiffness: f64,
    /// Share of the velocity relative to the rigid motion of the drain that each explicit step
    /// removes, 0 to 1; default 0.7.
    pub drain_damping: f64,
    /// Factor k_s of the force on the hand of a grasper, k_s (stretched length - length), N/m, 0 to
    /// 1e6; default 50.
    pub grasper_stiffness: f64,
    /// Largest distance from the tip of a grasper at which closing jaws take a node, and from the
    /// centre line of the jaws at which they take a needle, m, 0 to 0.1; default 2e-3 (the paper
    /// gives no number).
    pub grasper_distance: f64,
    /// Distance that a scene keeps beyond contact (the paper's eps_D), m, 0 to 1e-2; default 0.
    pub scene_thickness: f64,
}

/// Counters of the baseline since the creation of an object, and results of its last step. One struct
/// serves scenes, threads and collision objects; each fills the fields of its kind, and the others are 0.
/// They are part of the state: a snapshot restores them.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_baseline_statistics {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Scene: pairs that the last search of the last step found.
    pub last_candidates: u32,
    /// Scene: passes of detection and response in all steps; at least one a step.
    pub passes: u64,
    /// Scene: pairs that these passes tested, the floor excluded.
    pub tested_pairs: u64,
    /// Scene: steps whose last pass still moved a body, because of
    /// vbss_baseline_config::scene_pass_limit.
    pub unconverged_steps: u64,
    /// Thread: iterations of the projection, summed over sections and explicit steps.
    pub projection_iterations: u64,
    /// Thread: projections that did not converge, so that their section kept the positions from before.
    pub failed_projections: u64,
    /// Collision object, and scene: continuous tests that the sign of w.w' ended
    /// (docs/explanation/paper-collision.md).
    pub sign_tests_ended: u64,
    /// Thread: the part of the last step.
    pub last_projection_iterations: u32,
    /// Zero.
    pub reserved: u32,
}

extern "C" {
    /// Fills the parameters of the baseline with the defaults.
    ///
    /// @param config  the parameters to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_baseline_config_init(config: *mut vbss_baseline_config, struct_size: u32) -> vbss_result;
}
