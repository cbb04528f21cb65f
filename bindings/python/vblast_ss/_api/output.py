"""output.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64
from enum import IntFlag
from typing import Any, ClassVar, NamedTuple

from .base import vbss_context


class OutputFlagBits(IntFlag):
    """Bits for the actions of an output stage in a step."""
    NOT_FINITE = 1
    """A number was NaN or infinite: all off."""
    FAULT = 2
    """The device refuses forces: all off."""
    CLAMPED = 4
    """The force was above the largest magnitude."""
    CONTINUOUS = 8
    """The force was above the limit of the past load."""
    WARM = 16
    """The force was above the limit of the temperature."""
    SLEWED = 32
    """The force rose faster than the limit."""
    INPUT_STALE = 64
    """The pose is too old: ramp to zero."""
    COMMAND_STALE = 128
    """The command is too old: ramp to zero."""
    STOPPED = 256
    """The emergency stop is latched: all off."""
    LATE = 512
    """The step came later than the watchdog allows."""
    SOLENOID_OFF = 1024
    """The command asks for the solenoid, but it is off for one of these reasons. Devices switch it
    off also while the clutch is engaged, the opening is stale, or an adapter is lost or has
    just failed."""
    SOLENOID_SPENT = 2048
    """The solenoid was on for too long."""
    NOT_WRITTEN = 4096
    """Devices: an adapter did not accept the result."""


class vbss_output(ctypes.Structure):
    """An output stage on its own, for hosts with their own device layer."""


class vbss_output_config(ctypes.Structure):
    """Limits of an output stage. Fill it with vbss_output_config_init, then change fields. A
    device lowers them to the capabilities of its adapters, and its timeouts are at least 2.5 of
    their periods.

    max_force: Largest force, N, 0 to 1e3; default 3.

    max_torque: Largest torque, N m, 0 to 1e3; default 0.1.

    continuous_force: Permitted root mean square of the force over an unlimited time, N, 0 to
    1e3; default 0.88, a value often given for the Touch, without a known public source.

    continuous_torque: Permitted root mean square of the torque, N m; default 0.03, chosen.

    load_time: Time constant of these means, s, 1e-3 to 1e4; default 10, chosen.

    warm: Temperature above which forces are reduced, 0 to 1; default 0.7.

    hot: Temperature at which forces are zero, above `warm`, to 2; default 1.

    force_rise: Fastest rise or turn, N/s, 1e-3 to 1e9; default 500. No limit for a fall.

    torque_rise: Fastest rise or turn of the torque, N m/s; default 20.

    input_timeout: Age at which a pose is stale, s, 1e-4 to 10; default 0.005.

    command_timeout: Age at which a command is stale, s, 1e-4 to 10; default 0.005.

    ramp_time: Length of the ramp to zero, s, 0 to 10; default 0.005.

    solenoid_time: Longest time of the solenoid on, s, 0 to 1e4; default 1, chosen.

    solenoid_duty: Largest long-term share of time of the solenoid on, 0 to 0.99; default 0.25,
    chosen."""
    struct_size: int
    reserved: int
    max_force: float
    max_torque: float
    continuous_force: float
    continuous_torque: float
    load_time: float
    warm: float
    hot: float
    force_rise: float
    torque_rise: float
    input_timeout: float
    command_timeout: float
    ramp_time: float
    solenoid_time: float
    solenoid_duty: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("max_force", c_double),
        ("max_torque", c_double),
        ("continuous_force", c_double),
        ("continuous_torque", c_double),
        ("load_time", c_double),
        ("warm", c_double),
        ("hot", c_double),
        ("force_rise", c_double),
        ("torque_rise", c_double),
        ("input_timeout", c_double),
        ("command_timeout", c_double),
        ("ramp_time", c_double),
        ("solenoid_time", c_double),
        ("solenoid_duty", c_double),
    ]


class vbss_output_command(ctypes.Structure):
    """Command to an output stage. Fill it with vbss_output_command_init, then set its fields.

    solenoid: 1: on; default 0.

    fault: 1: the device refuses forces; default 0.

    force: Force, N; for a device, in the world's frame. A flag reports numbers that are not
    finite.

    torque: Torque, N m; for a device, in the world's frame.

    age: Age of the command, s, such as that of the anchor it was computed from; default 0.

    input_age: Age of the pose, s; default 0. A device uses the age of its own pose if that is
    older.

    temperature: Temperature of the motors; default 0. A device uses its own value if that is
    higher."""
    struct_size: int
    solenoid: int
    fault: int
    reserved: int
    force: Any
    torque: Any
    age: float
    input_age: float
    temperature: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("solenoid", c_uint32),
        ("fault", c_uint32),
        ("reserved", c_uint32),
        ("force", c_double * 3),
        ("torque", c_double * 3),
        ("age", c_double),
        ("input_age", c_double),
        ("temperature", c_double),
    ]


class vbss_output_statistics(ctypes.Structure):
    """Counters of an output stage. Each counter of a flag is the number of steps with that flag.

    steps: Steps so far.

    not_finite: Steps with VBSS_OUTPUT_FLAG_NOT_FINITE.

    faults: Steps with VBSS_OUTPUT_FLAG_FAULT.

    clamped: Steps with VBSS_OUTPUT_FLAG_CLAMPED.

    continuous: Steps with VBSS_OUTPUT_FLAG_CONTINUOUS.

    warm: Steps with VBSS_OUTPUT_FLAG_WARM.

    slewed: Steps with VBSS_OUTPUT_FLAG_SLEWED.

    input_stale: Steps with VBSS_OUTPUT_FLAG_INPUT_STALE.

    command_stale: Steps with VBSS_OUTPUT_FLAG_COMMAND_STALE.

    stopped: Steps with VBSS_OUTPUT_FLAG_STOPPED.

    late: Steps with VBSS_OUTPUT_FLAG_LATE.

    solenoid_off: Steps with VBSS_OUTPUT_FLAG_SOLENOID_OFF.

    solenoid_spent: Steps with VBSS_OUTPUT_FLAG_SOLENOID_SPENT.

    watchdogs: Ramps that the watchdog started.

    stops: Times that the emergency stop was latched.

    pulses: Times that the solenoid was switched on.

    largest_force: Largest force in a result, N.

    largest_torque: Largest torque in a result, N m.

    solenoid_on: Total time of the solenoid on, s."""
    struct_size: int
    reserved: int
    steps: int
    not_finite: int
    faults: int
    clamped: int
    continuous: int
    warm: int
    slewed: int
    input_stale: int
    command_stale: int
    stopped: int
    late: int
    solenoid_off: int
    solenoid_spent: int
    watchdogs: int
    stops: int
    pulses: int
    largest_force: float
    largest_torque: float
    solenoid_on: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("steps", c_uint64),
        ("not_finite", c_uint64),
        ("faults", c_uint64),
        ("clamped", c_uint64),
        ("continuous", c_uint64),
        ("warm", c_uint64),
        ("slewed", c_uint64),
        ("input_stale", c_uint64),
        ("command_stale", c_uint64),
        ("stopped", c_uint64),
        ("late", c_uint64),
        ("solenoid_off", c_uint64),
        ("solenoid_spent", c_uint64),
        ("watchdogs", c_uint64),
        ("stops", c_uint64),
        ("pulses", c_uint64),
        ("largest_force", c_double),
        ("largest_torque", c_double),
        ("solenoid_on", c_double),
    ]


class OutputStatistics(NamedTuple):
    """Counters of an output stage. Each counter of a flag is the number of steps with that flag.
    Fields as vbss_output_statistics says."""
    steps: int
    not_finite: int
    faults: int
    clamped: int
    continuous: int
    warm: int
    slewed: int
    input_stale: int
    command_stale: int
    stopped: int
    late: int
    solenoid_off: int
    solenoid_spent: int
    watchdogs: int
    stops: int
    pulses: int
    largest_force: float
    largest_torque: float
    solenoid_on: float


class vbss_output_result(ctypes.Structure):
    """Result of an output stage, for the hardware. In a call of an adapter it is followed by zeros
    up to 4096 bytes.

    flags: VBSS_OUTPUT_FLAG_ bits: actions of the stage.

    solenoid: 1: on, 0: off.

    force: Force, N; for an adapter, in the device's frame.

    torque: Torque, N m; for an adapter, in the device's frame.

    force_load: Mean square force over the square of its limit; 1: at the limit.

    torque_load: Mean square torque over the square of its limit.

    solenoid_left: Time that the solenoid may stay on from now on, s.

    expires: Time after which an adapter without a new call switches all outputs off itself, s."""
    struct_size: int
    flags: int
    solenoid: int
    reserved: int
    force: Any
    torque: Any
    force_load: float
    torque_load: float
    solenoid_left: float
    expires: float
    _kinds_: ClassVar[dict[str, Any]] = {"flags": OutputFlagBits}
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("solenoid", c_uint32),
        ("reserved", c_uint32),
        ("force", c_double * 3),
        ("torque", c_double * 3),
        ("force_load", c_double),
        ("torque_load", c_double),
        ("solenoid_left", c_double),
        ("expires", c_double),
    ]


class OutputResult(NamedTuple):
    """Result of an output stage, for the hardware. In a call of an adapter it is followed by zeros
    up to 4096 bytes. Fields as vbss_output_result says."""
    flags: OutputFlagBits
    solenoid: int
    force: tuple[float, ...]
    torque: tuple[float, ...]
    force_load: float
    torque_load: float
    solenoid_left: float
    expires: float


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_output_config_init": (c_int32, (POINTER(vbss_output_config), c_uint32)),
    "vbss_output_command_init": (c_int32, (POINTER(vbss_output_command), c_uint32)),
    "vbss_output_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_output_config),
        POINTER(POINTER(vbss_output)))),
    "vbss_output_destroy": (c_int32, (POINTER(vbss_output),)),
    "vbss_output_step": (c_int32, (POINTER(vbss_output), c_double, POINTER(vbss_output_command),
        POINTER(vbss_output_result), c_uint32)),
    "vbss_output_latch_emergency_stop": (c_int32, (POINTER(vbss_output),)),
    "vbss_output_clear_emergency_stop": (c_int32, (POINTER(vbss_output),)),
    "vbss_output_get_statistics": (c_int32, (POINTER(vbss_output), POINTER(vbss_output_statistics),
        c_uint32)),
}
