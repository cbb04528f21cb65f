"""baseline.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64
from typing import Any, ClassVar, NamedTuple


class vbss_baseline_config(ctypes.Structure):
    """Parameters of the baseline. Fill it with vbss_baseline_config_init, then change fields.

    thread_substeps: Explicit steps of a thread in one step, 1 to 100000; 0 (default): as many
    as the stiffest bending mode and the tension need.

    thread_iteration_limit: Largest number of iterations of a thread's projection, 1 to 1000;
    default 50.

    drain_substeps: Explicit steps of a drain in one step, 1 to 100000; 0 (default): as many as
    stability needs.

    scene_pass_limit: Number of passes of detection and response in a step of a scene, 1 to
    1000; default 4.

    collision_parallel: Of collision.h alone; scenes use the default. Edges are parallel when
    |a|^2 |b|^2 - (a.b)^2 is below this, in collision_unit^4; 0 to 1; default 1e-6.

    collision_unit: Of collision.h alone; scenes use the default. Unit of length, m, 1e-9 to
    1e3; default 1e-3.

    thread_stiffness: Spring constant of a segment of a thread, N/m, 0 to 1e9; default 0:
    derived from mass and step by docs/explanation/paper-thread.md.

    thread_damping: Share of the velocity relative to the rigid motion of a thread's section
    that each explicit step removes, 0 to 1; default 0.

    thread_tolerance: Largest |C| / l of a section of a thread, 1e-14 to 1; default 1e-6.

    drain_stiffness: Stiffness of the spring that ties a particle of a drain to its rest
    position, N/m, 0 to 1e9; default 125.

    drain_damping: Share of the velocity relative to the rigid motion of the drain that each
    explicit step removes, 0 to 1; default 0.7.

    grasper_stiffness: Factor k_s of the force on the hand of a grasper, k_s (stretched length -
    length), N/m, 0 to 1e6; default 50.

    grasper_distance: Largest distance from the tip of a grasper at which closing jaws take a
    node, and from the centre line of the jaws at which they take a needle, m, 0 to 0.1; default
    2e-3 (the paper gives no number).

    scene_thickness: Distance that a scene keeps beyond contact (the paper's eps_D), m, 0 to
    1e-2; default 0."""
    struct_size: int
    thread_substeps: int
    thread_iteration_limit: int
    drain_substeps: int
    scene_pass_limit: int
    reserved: int
    collision_parallel: float
    collision_unit: float
    thread_stiffness: float
    thread_damping: float
    thread_tolerance: float
    drain_stiffness: float
    drain_damping: float
    grasper_stiffness: float
    grasper_distance: float
    scene_thickness: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("thread_substeps", c_uint32),
        ("thread_iteration_limit", c_uint32),
        ("drain_substeps", c_uint32),
        ("scene_pass_limit", c_uint32),
        ("reserved", c_uint32),
        ("collision_parallel", c_double),
        ("collision_unit", c_double),
        ("thread_stiffness", c_double),
        ("thread_damping", c_double),
        ("thread_tolerance", c_double),
        ("drain_stiffness", c_double),
        ("drain_damping", c_double),
        ("grasper_stiffness", c_double),
        ("grasper_distance", c_double),
        ("scene_thickness", c_double),
    ]


class vbss_baseline_statistics(ctypes.Structure):
    """Counters of the baseline since the creation of an object, and results of its last step. One
    struct serves scenes, threads and collision objects; each fills the fields of its kind, and
    the others are 0. They are part of the state: a snapshot restores them.

    last_candidates: Scene: pairs that the last search of the last step found.

    passes: Scene: passes of detection and response in all steps; at least one a step.

    tested_pairs: Scene: pairs that these passes tested, the floor excluded.

    unconverged_steps: Scene: steps whose last pass still moved a body, because of
    vbss_baseline_config::scene_pass_limit.

    projection_iterations: Thread: iterations of the projection, summed over sections and
    explicit steps.

    failed_projections: Thread: projections that did not converge, so that their section kept
    the positions from before.

    sign_tests_ended: Collision object, and scene: continuous tests that the sign of w.w' ended
    (docs/explanation/paper-collision.md).

    last_projection_iterations: Thread: the part of the last step."""
    struct_size: int
    last_candidates: int
    passes: int
    tested_pairs: int
    unconverged_steps: int
    projection_iterations: int
    failed_projections: int
    sign_tests_ended: int
    last_projection_iterations: int
    reserved: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("last_candidates", c_uint32),
        ("passes", c_uint64),
        ("tested_pairs", c_uint64),
        ("unconverged_steps", c_uint64),
        ("projection_iterations", c_uint64),
        ("failed_projections", c_uint64),
        ("sign_tests_ended", c_uint64),
        ("last_projection_iterations", c_uint32),
        ("reserved", c_uint32),
    ]


class BaselineStatistics(NamedTuple):
    """Counters of the baseline since the creation of an object, and results of its last step. One
    struct serves scenes, threads and collision objects; each fills the fields of its kind, and
    the others are 0. They are part of the state: a snapshot restores them. Fields as
    vbss_baseline_statistics says."""
    last_candidates: int
    passes: int
    tested_pairs: int
    unconverged_steps: int
    projection_iterations: int
    failed_projections: int
    sign_tests_ended: int
    last_projection_iterations: int


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_baseline_config_init": (c_int32, (POINTER(vbss_baseline_config), c_uint32)),
}
