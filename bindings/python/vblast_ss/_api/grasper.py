"""grasper.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import Method, vbss_context, vbss_view
from .baseline import vbss_baseline_config


class GrasperKind(IntEnum):
    """The constants of vbss_grasper_kind."""
    NEEDLE_DRIVER = 1
    """Jaws that hold."""
    SHEARS = 2
    """Blades that cut."""


class GrasperPreset(IntEnum):
    """The constants of vbss_grasper_preset."""
    STRAIGHT = 0
    """A needle driver with straight jaws: the defaults."""
    ANGLED = 1
    """Jaws on a neck of 5 mm, bent by 0.8 rad. Rolled about its shaft, the tool points its jaws at
    the other tool, which can then go round them without meeting the shaft."""


class GrasperField(IntEnum):
    """The constants of vbss_grasper_field."""
    CAPSULES = 0
    """x 7: start and end of the axis, radius, m. Order: shaft, jaw at +x, jaw at -x, neck."""


class vbss_grasper(ctypes.Structure):
    """A tool with two jaws."""


class vbss_grasper_config(ctypes.Structure):
    """Configuration of a grasper. Fill it with vbss_grasper_config_init, then change fields.

    method: Must be that of the scene; default VBSS_METHOD_IMPLICIT.

    kind: Initial kind; default VBSS_GRASPER_KIND_NEEDLE_DRIVER.

    has_trocar: 1: the shaft goes through `trocar`; default 0: free.

    trocar: Point of entry of the shaft, m, each at most 1e3; default 0.

    driver_length: Length of a driver's jaws, pivot to tip, m, 1e-4 to 1; default 13e-3.

    driver_radius: Radius of each jaw, m, 1e-6 to 0.1, below the length; default 0.5e-3.

    driver_bend: Angle between jaws and shaft, rad, -1.5 to 1.5; default 0.

    driver_opening: Angle of each jaw from the middle when the handle is open, rad, 1e-3 to 1.2;
    default 0.35.

    shears_length: Length of the blades of shears, pivot to tip, m, 1e-4 to 1; default 15e-3.

    shears_radius: Radius of each blade, m, 1e-6 to 0.1, below the length; default 0.5e-3.

    shears_bend: Angle between blades and shaft, rad, -1.5 to 1.5; default 0.

    shears_opening: Angle of each blade from the middle when the handle is open, rad, 1e-3 to
    1.2; default 0.35.

    driver_neck: Length from the pivot back to the bend, m, 0 to 1; default 0.

    shears_neck: Length from the pivot of the blades back to the bend, m, 0 to 1; default 0.

    neck_radius: Radius of either neck, m, 1e-6 to 0.1; default 1.2e-3.

    shaft_length: Length from the bend on, m, 1e-3 to 10; default 0.15.

    shaft_radius: Radius of the shaft, m, 1e-6 to 0.1; default 2.5e-3.

    friction: Coefficient for contacts outside the grasp, 0 to 10; default 0.15.

    closing_force: Pressure of the jaws on a grasped body when the handle is closed, N, 0 to
    1e4; default 8.

    closing_angle: Angle by which the jaws of a closed handle would close further without a
    grasped body, rad, 1e-3 to 1. The pressure grows over this angle from zero to closing_force.
    Default 0.1.

    jaw_speed: Largest speed of each jaw, rad/s, 1e-2 to 1e3; default 8.

    grip_friction: Coefficient of each face in the grasp, 0 to 10; default 0.5.

    grip_length: Length of thread that a grasp holds, m, 1e-5 to 1e-1; default 1e-3.

    grip_stiffness: Stiffness of the whole clamp of a thread along the faces, N/m, 1 to 1e6;
    default 3000. From face to face it is 64 times as stiff.

    mass: Mass of the proxy, kg, 1e-4 to 1e2; default 0.02. It is at the tip, with a radius of
    gyration of 30 mm.

    stiffness: Stiffness of the virtual coupling, N/m, 0 to 1e9. The default of 400 suits haptic
    arms; scripted hands may use 2000 with a damping of 10 N s/m.

    damping: Damping of the virtual coupling, N s/m, 0 to 1e6; default 5. If a hand receives its
    force a time d after its pose was read, and holds it for h, the damping must be at least
    stiffness (d + h / 2). Otherwise the coupling adds energy to a hand that presses on a rigid
    obstacle. At an elastic one the hand itself needs a little damping, which
    docs/reference/device-layer.md derives.

    turning_stiffness: Rotational stiffness of the coupling, N m/rad, 0 to 1e9; default 5.

    turning_damping: Rotational damping of the coupling, N m s/rad, 0 to 1e6; default 0.05.

    exchange_centre: Tools are exchanged only with empty jaws and with the tip farther than
    exchange_distance from this point, m, each at most 1e3; default 0.

    exchange_distance: Distance, m, 0 to 1e3; default 0: no limit.

    baseline: VBLAST: its parameters; NULL (default): their defaults. The library copies them.

    needle_stiffness: Stiffness of the clamp on either, equal in all directions, N/m, 1 to 1e7;
    default 3e4.

    needle_turning_stiffness: Rotational stiffness of the clamp on a needle about the normal of
    the jaws' faces, N m/rad, 1e-6 to 1e4; default 0.5. About axes in the faces it is half of
    this.

    needle_torque: Torque at which a needle turns in the jaws of a closed handle, N m, 0 to 1e2;
    default 0.03 (not verified). The torque is proportional to the pressure of the jaws.

    solenoid_opening: See vbss_grasper_state::solenoid; 0 to 1; default 0.2."""
    struct_size: int
    method: int
    kind: int
    has_trocar: int
    trocar: Any
    driver_length: float
    driver_radius: float
    driver_bend: float
    driver_opening: float
    shears_length: float
    shears_radius: float
    shears_bend: float
    shears_opening: float
    driver_neck: float
    shears_neck: float
    neck_radius: float
    shaft_length: float
    shaft_radius: float
    friction: float
    closing_force: float
    closing_angle: float
    jaw_speed: float
    grip_friction: float
    grip_length: float
    grip_stiffness: float
    mass: float
    stiffness: float
    damping: float
    turning_stiffness: float
    turning_damping: float
    exchange_centre: Any
    exchange_distance: float
    baseline: Any
    needle_stiffness: float
    needle_turning_stiffness: float
    needle_torque: float
    solenoid_opening: float
    _kinds_: ClassVar[dict[str, Any]] = {"method": Method, "kind": GrasperKind}
    _fields_ = [
        ("struct_size", c_uint32),
        ("method", c_int32),
        ("kind", c_int32),
        ("has_trocar", c_int32),
        ("trocar", c_double * 3),
        ("driver_length", c_double),
        ("driver_radius", c_double),
        ("driver_bend", c_double),
        ("driver_opening", c_double),
        ("shears_length", c_double),
        ("shears_radius", c_double),
        ("shears_bend", c_double),
        ("shears_opening", c_double),
        ("driver_neck", c_double),
        ("shears_neck", c_double),
        ("neck_radius", c_double),
        ("shaft_length", c_double),
        ("shaft_radius", c_double),
        ("friction", c_double),
        ("closing_force", c_double),
        ("closing_angle", c_double),
        ("jaw_speed", c_double),
        ("grip_friction", c_double),
        ("grip_length", c_double),
        ("grip_stiffness", c_double),
        ("mass", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("turning_stiffness", c_double),
        ("turning_damping", c_double),
        ("exchange_centre", c_double * 3),
        ("exchange_distance", c_double),
        ("baseline", POINTER(vbss_baseline_config)),
        ("needle_stiffness", c_double),
        ("needle_turning_stiffness", c_double),
        ("needle_torque", c_double),
        ("solenoid_opening", c_double),
    ]


class vbss_grasper_state(ctypes.Structure):
    """Pose of a grasper, and the forces that act on it.

    kind: Present kind.

    body: Number of the grasper in its scene; 0: not in a scene.

    grasp_count: Number of grasps: places of threads, a needle, a wall.

    position: Position of the tip, m.

    orientation: Unit quaternion, w, x, y, z.

    velocity: Velocity of the tip, m/s.

    angular_velocity: Angular velocity, rad/s.

    target_position: Target of the tip, m.

    target_orientation: Target, after the trocar has turned it.

    opening: Opening of the handle that the host set.

    jaw_angle: Angle of each jaw from the middle, rad.

    pressure: Pressure of the jaws on all grasped bodies, N.

    hand_force: Force on the hand at the tip, which a device shall exert, N: a command for
    vbss_device_write. A device that gets the pose of the tool by vbss_device_write_coupled has
    this force already. VBLAST: the force of stretched threads that it carries.

    hand_torque: Torque on the hand about the tip, N m; VBLAST: 0.

    needle: Number of the held needle in its scene; 0: none.

    drain: Number of the drain whose wall it holds; 0: none.

    solenoid: 1: a solenoid shall lock the handle (vbss_output_command::solenoid). It is set
    once the tool holds a needle and the opening of the handle is below solenoid_opening, and
    cleared when the tool holds no needle."""
    struct_size: int
    kind: int
    body: int
    grasp_count: int
    position: Any
    orientation: Any
    velocity: Any
    angular_velocity: Any
    target_position: Any
    target_orientation: Any
    opening: float
    jaw_angle: float
    pressure: float
    hand_force: Any
    hand_torque: Any
    needle: int
    drain: int
    solenoid: int
    reserved: int
    _kinds_: ClassVar[dict[str, Any]] = {"kind": GrasperKind}
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("body", c_uint32),
        ("grasp_count", c_uint32),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("velocity", c_double * 3),
        ("angular_velocity", c_double * 3),
        ("target_position", c_double * 3),
        ("target_orientation", c_double * 4),
        ("opening", c_double),
        ("jaw_angle", c_double),
        ("pressure", c_double),
        ("hand_force", c_double * 3),
        ("hand_torque", c_double * 3),
        ("needle", c_uint32),
        ("drain", c_uint32),
        ("solenoid", c_uint32),
        ("reserved", c_uint32),
    ]


class GrasperState(NamedTuple):
    """Pose of a grasper, and the forces that act on it. Fields as vbss_grasper_state says."""
    kind: GrasperKind
    body: int
    grasp_count: int
    position: tuple[float, ...]
    orientation: tuple[float, ...]
    velocity: tuple[float, ...]
    angular_velocity: tuple[float, ...]
    target_position: tuple[float, ...]
    target_orientation: tuple[float, ...]
    opening: float
    jaw_angle: float
    pressure: float
    hand_force: tuple[float, ...]
    hand_torque: tuple[float, ...]
    needle: int
    drain: int
    solenoid: int


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_grasper_config_init": (c_int32, (POINTER(vbss_grasper_config), c_uint32)),
    "vbss_grasper_config_preset": (c_int32, (POINTER(vbss_grasper_config), c_int32)),
    "vbss_grasper_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_grasper_config),
        POINTER(POINTER(vbss_grasper)))),
    "vbss_grasper_destroy": (c_int32, (POINTER(vbss_grasper),)),
    "vbss_grasper_discard": (c_int32, (POINTER(vbss_grasper),)),
    "vbss_grasper_set_target": (c_int32, (POINTER(vbss_grasper), POINTER(c_double),
        POINTER(c_double))),
    "vbss_grasper_set_opening": (c_int32, (POINTER(vbss_grasper), c_double)),
    "vbss_grasper_exchange": (c_int32, (POINTER(vbss_grasper), c_int32)),
    "vbss_grasper_get_state": (c_int32, (POINTER(vbss_grasper), POINTER(vbss_grasper_state),
        c_uint32)),
    "vbss_grasper_get_view": (c_int32, (POINTER(vbss_grasper), c_int32, POINTER(vbss_view),
        c_uint32)),
}
