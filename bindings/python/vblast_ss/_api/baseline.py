"""baseline.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32
from typing import Any, ClassVar


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


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_baseline_config_init": (c_int32, (POINTER(vbss_baseline_config), c_uint32)),
}
