"""needle.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64, c_uint8
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import Method, vbss_context, vbss_view


class NeedlePreset(IntEnum):
    """The constants of vbss_needle_preset."""
    VBLAST = 0
    """Half circle of radius 10.5 mm (Qi et al. 2017): the defaults."""
    SH = 1
    """Half circle of 26 mm, radius 8.28 mm (not verified)."""


class NeedleField(IntEnum):
    """The constants of vbss_needle_field."""
    POINTS = 0
    """x 3: ends of the capsules' axes, m, from the tip to the swage; segment_count + 1 rows."""


class vbss_needle(ctypes.Structure):
    """A needle."""


class vbss_needle_config(ctypes.Structure):
    """Configuration of a needle. Fill it with vbss_needle_config_init, then change fields.

    method: Must be that of the scene; default VBSS_METHOD_IMPLICIT.

    segment_count: Capsules along the arc, 2 to 64; default 8.

    radius: Radius of the arc's centre line, m, 1e-4 to 1; default 10.5e-3, the paper's radius.

    wire_radius: Radius of the wire, m, 1e-6 to radius / 5; default 0.35e-3 (not verified).

    arc: Angle from tip to swage, rad, 0.1 to 6; default pi.

    density: Density, kg/m^3, 1 to 1e5; default 7900, steel.

    friction: Coefficient of friction with other bodies of a scene, 0 to 10; default 0.2.

    drag: Decay rate of linear and angular momentum, 1/s, 0 to 1e6; default 0.

    gravity: Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default
    0.

    position: Position of the frame's origin, m, each coordinate at most 1e3 in magnitude;
    default 0.

    orientation: Orientation w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0.

    velocity: Velocity of the origin, m/s, each component at most 1e5 in magnitude; default 0.

    angular_velocity: Angular velocity, rad/s, each component at most 1e6 in magnitude; default
    0."""
    struct_size: int
    method: int
    segment_count: int
    reserved: int
    radius: float
    wire_radius: float
    arc: float
    density: float
    friction: float
    drag: float
    gravity: Any
    position: Any
    orientation: Any
    velocity: Any
    angular_velocity: Any
    _kinds_: ClassVar[dict[str, Any]] = {"method": Method}
    _fields_ = [
        ("struct_size", c_uint32),
        ("method", c_int32),
        ("segment_count", c_uint32),
        ("reserved", c_uint32),
        ("radius", c_double),
        ("wire_radius", c_double),
        ("arc", c_double),
        ("density", c_double),
        ("friction", c_double),
        ("drag", c_double),
        ("gravity", c_double * 3),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("velocity", c_double * 3),
        ("angular_velocity", c_double * 3),
    ]


class vbss_needle_state(ctypes.Structure):
    """Pose and velocity of a needle.

    body: Number of the needle in its scene; 0: not in a scene.

    position: Position of the frame's origin, m.

    orientation: Orientation, unit quaternion w, x, y, z.

    velocity: Velocity of the origin, m/s.

    angular_velocity: Angular velocity, rad/s.

    tip: Position of the tip, m.

    tip_direction: Unit vector out of the tip.

    swage: Position of the swage, m.

    swage_direction: Unit vector of the thread, away from the needle."""
    struct_size: int
    body: int
    position: Any
    orientation: Any
    velocity: Any
    angular_velocity: Any
    tip: Any
    tip_direction: Any
    swage: Any
    swage_direction: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("body", c_uint32),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("velocity", c_double * 3),
        ("angular_velocity", c_double * 3),
        ("tip", c_double * 3),
        ("tip_direction", c_double * 3),
        ("swage", c_double * 3),
        ("swage_direction", c_double * 3),
    ]


class NeedleState(NamedTuple):
    """Pose and velocity of a needle. Fields as vbss_needle_state says."""
    body: int
    position: tuple[float, ...]
    orientation: tuple[float, ...]
    velocity: tuple[float, ...]
    angular_velocity: tuple[float, ...]
    tip: tuple[float, ...]
    tip_direction: tuple[float, ...]
    swage: tuple[float, ...]
    swage_direction: tuple[float, ...]


class vbss_needle_mass(ctypes.Structure):
    """Mass and inertia of a needle.

    mass: Mass, kg.

    length: Length of the centre line, m.

    centre: Centre of mass in the needle's frame, m.

    inertia: Principal moments about it, kg m^2.

    axes: Their unit axes in the needle's frame, in the same order."""
    struct_size: int
    reserved: int
    mass: float
    length: float
    centre: Any
    inertia: Any
    axes: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("mass", c_double),
        ("length", c_double),
        ("centre", c_double * 3),
        ("inertia", c_double * 3),
        ("axes", (c_double * 3) * 3),
    ]


class NeedleMass(NamedTuple):
    """Mass and inertia of a needle. Fields as vbss_needle_mass says."""
    mass: float
    length: float
    centre: tuple[float, ...]
    inertia: tuple[float, ...]
    axes: tuple[tuple[float, ...], ...]


class vbss_needle_energies(ctypes.Structure):
    """Energies, J.

    kinetic: Kinetic energy of translation and rotation.

    gravity: Potential energy, zero at the world's origin.

    total: Their sum."""
    struct_size: int
    reserved: int
    kinetic: float
    gravity: float
    total: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("kinetic", c_double),
        ("gravity", c_double),
        ("total", c_double),
    ]


class NeedleEnergies(NamedTuple):
    """Energies, J. Fields as vbss_needle_energies says."""
    kinetic: float
    gravity: float
    total: float


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_needle_config_init": (c_int32, (POINTER(vbss_needle_config), c_uint32)),
    "vbss_needle_config_preset": (c_int32, (POINTER(vbss_needle_config), c_int32)),
    "vbss_needle_config_shape": (c_int32, (POINTER(vbss_needle_config), c_double, c_double,
        c_double)),
    "vbss_needle_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_needle_config),
        POINTER(POINTER(vbss_needle)))),
    "vbss_needle_destroy": (c_int32, (POINTER(vbss_needle),)),
    "vbss_needle_discard": (c_int32, (POINTER(vbss_needle),)),
    "vbss_needle_step": (c_int32, (POINTER(vbss_needle), c_double)),
    "vbss_needle_set_state": (c_int32, (POINTER(vbss_needle), POINTER(c_double), POINTER(c_double),
        POINTER(c_double), POINTER(c_double))),
    "vbss_needle_get_state": (c_int32, (POINTER(vbss_needle), POINTER(vbss_needle_state),
        c_uint32)),
    "vbss_needle_get_mass": (c_int32, (POINTER(vbss_needle), POINTER(vbss_needle_mass), c_uint32)),
    "vbss_needle_get_place": (c_int32, (POINTER(vbss_needle), c_double, POINTER(c_double),
        POINTER(c_double))),
    "vbss_needle_get_energies": (c_int32, (POINTER(vbss_needle), POINTER(vbss_needle_energies),
        c_uint32)),
    "vbss_needle_get_view": (c_int32, (POINTER(vbss_needle), c_int32, POINTER(vbss_view),
        c_uint32)),
    "vbss_needle_save": (c_int32, (POINTER(vbss_needle), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_needle_restore": (c_int32, (POINTER(vbss_needle), POINTER(c_uint8), c_uint64)),
    "vbss_needle_get_hash": (c_int32, (POINTER(vbss_needle), POINTER(c_uint64))),
}
