"""output.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_double, c_int32, c_uint32, c_uint64
from enum import IntFlag
from typing import Any, ClassVar, NamedTuple

from .base import vbss_context


class OutputBits(IntFlag):
    """What an output stage did in a step: bits."""
    NOT_FINITE = 1
    """A number was NaN or infinite: all off."""
    FAULT = 2
    """The device refuses forces: all off."""
    CLAMPED = 4
    """Above the largest magnitude."""
    CONTINUOUS = 8
    """Above what the load so far allows."""
    WARM = 16
    """Above what the temperature allows."""
    SLEWED = 32
    """Rises faster than it may."""
    INPUT_STALE = 64
    """The pose is too old: ramped to zero."""
    COMMAND_STALE = 128
    """The command is too old: ramped to zero."""
    STOPPED = 256
    """The emergency stop is latched: all off."""
    LATE = 512
    """The last step is longer ago than the watchdog waits."""
    SOLENOID_OFF = 1024
    """The solenoid was wanted, but is off: for one of these reasons; of a device also while the
    clutch is held, the opening is stale, or an adapter is lost or failed last."""
    SOLENOID_SPENT = 2048
    """The solenoid was wanted for too long."""
    NOT_WRITTEN = 4096
    """Devices: an adapter did not take it."""


class vbss_output(ctypes.Structure):
    """An output stage alone, for hosts with a device layer of their own."""


class vbss_output_config(ctypes.Structure):
    """Limits of an output stage. Fill it with vbss_output_config_init, then change what you need.
    A device lowers them to what its adapters say they can, and waits at least 2.5 of their
    periods.

    max_force: N, 0 to 1e3; default 3.

    max_torque: N m, 0 to 1e3; default 0.1.

    continuous_force: Root mean square that may go on for ever, N, 0 to 1e3; default 0.88, often
    said of the Touch, in no public source we know.

    continuous_torque: The same, N m; default 0.03, chosen.

    load_time: Time constant of that mean, s, 1e-3 to 1e4; default 10, chosen.

    warm: Temperature from which forces are lowered, 0 to 1; default 0.7.

    hot: Temperature at which there are none, above `warm`, to 2; default 1.

    force_rise: Fastest rise or turn, N/s, 1e-3 to 1e9; default 500. Falling is free.

    torque_rise: The same, N m/s; default 20.

    input_timeout: Age at which a pose is stale, s, 1e-4 to 10; default 0.005.

    command_timeout: Age at which a command is, s, 1e-4 to 10; default 0.005.

    ramp_time: From there to zero, s, 0 to 10; default 0.005.

    solenoid_time: Longest time on, s, 0 to 1e4; default 1, chosen.

    solenoid_duty: Part of the time it may be on in the long run, 0 to 0.99; default 0.25,
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
    """What is wanted of an output stage. Fill it with vbss_output_command_init, then set what you
    want.

    solenoid: 1: on; default 0.

    fault: 1: the device refuses forces; default 0.

    force: N; to a device: in the world. Anything: what is not finite is told by a flag.

    torque: N m, likewise.

    age: How old the command is, s, such as the anchor it was computed from; default 0.

    input_age: How old the pose is, s; default 0. A device takes its own if that is older.

    temperature: Of the motors; default 0. A device takes its own if that is higher."""
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
    """Steps in which an output stage did something, and what it went through.

    steps: Steps so far.

    not_finite: Of them with VBSS_OUTPUT_NOT_FINITE;

    faults: VBSS_OUTPUT_FAULT;

    clamped: VBSS_OUTPUT_CLAMPED;

    continuous: VBSS_OUTPUT_CONTINUOUS;

    warm: VBSS_OUTPUT_WARM;

    slewed: VBSS_OUTPUT_SLEWED;

    input_stale: VBSS_OUTPUT_INPUT_STALE;

    command_stale: VBSS_OUTPUT_COMMAND_STALE;

    stopped: VBSS_OUTPUT_STOPPED;

    late: VBSS_OUTPUT_LATE;

    solenoid_off: VBSS_OUTPUT_SOLENOID_OFF;

    solenoid_spent: VBSS_OUTPUT_SOLENOID_SPENT.

    watchdogs: How often the watchdog began to ramp.

    stops: How often the emergency stop was latched.

    pulses: How often the solenoid went on.

    largest_force: That was put out, N.

    largest_torque: That was put out, N m.

    solenoid_on: Time it was on, s."""
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
    """Steps in which an output stage did something, and what it went through. Fields as
    vbss_output_statistics says."""
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
    """What goes to the hardware: the result of an output stage. In an adapter's call it lies in
    4096 bytes of which the rest is zero.

    flags: VBSS_OUTPUT_ bits: what the stage did.

    solenoid: 1: on, 0: off.

    force: N; to an adapter: in the device's frame.

    torque: N m.

    force_load: Mean square force over the continuous limit's square: 1 is full.

    torque_load: The same of the torque.

    solenoid_left: Time that the solenoid may stay on from now, s.

    expires: An adapter that hears nothing for so long puts everything off itself, s."""
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
    _kinds_: ClassVar[dict[str, Any]] = {"flags": OutputBits}
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
    """What goes to the hardware: the result of an output stage. In an adapter's call it lies in
    4096 bytes of which the rest is zero. Fields as vbss_output_result says."""
    flags: OutputBits
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
    "vbss_output_stop": (c_int32, (POINTER(vbss_output),)),
    "vbss_output_release": (c_int32, (POINTER(vbss_output),)),
    "vbss_output_get_statistics": (c_int32, (POINTER(vbss_output), POINTER(vbss_output_statistics),
        c_uint32)),
}
