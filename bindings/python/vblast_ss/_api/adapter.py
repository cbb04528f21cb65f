"""adapter.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_char, c_char_p, c_double, c_int32, c_uint32, c_void_p
from enum import IntEnum, IntFlag
from typing import Any, ClassVar, NamedTuple

from .output import vbss_output_result


class DeviceHasBits(IntFlag):
    """Parts of a sample: bits."""
    POSITION = 1
    """`position`"""
    ORIENTATION = 2
    """`orientation`"""
    VELOCITY = 4
    """`velocity`"""
    ANGULAR_VELOCITY = 8
    """`angular_velocity`"""
    JAW_RAW = 16
    """`jaw_raw`"""
    JAW = 32
    """`jaw`, which then counts instead of `jaw_raw`."""
    BUTTONS = 64
    """`buttons`"""
    TOOL = 128
    """`tool`"""
    TEMPERATURE = 256
    """`temperature`"""


class DeviceOutBits(IntFlag):
    """What a device can put out: bits."""
    FORCE = 1
    """Force."""
    TORQUE = 2
    """Torque."""
    SOLENOID = 4
    """A solenoid in the handle."""


class DeviceFlagBits(IntFlag):
    """What a device says about itself with a sample: bits."""
    LOST = 1
    """It is not there: unplugged, or its driver has given up."""
    STOP = 2
    """Emergency stop: latches as vbss_device_stop does."""
    FAULT = 4
    """It refuses forces for now: all outputs are off while this is set."""
    SLOW = 8
    """It is too slow to put outputs off within vbss_output_result::expires. `explain` says how
    slow."""


class DeviceTool(IntEnum):
    """The constants of vbss_device_tool."""
    NONE = 0
    """None."""
    NEEDLE_DRIVER = 1
    """A needle driver."""
    SHEARS = 2
    """Shears."""


# Opens the hardware. May take its time, unlike `read` and `write`.
vbss_device_open_fn = CFUNCTYPE(c_int32, c_void_p)


# Closes it. Outputs have been put off before.
vbss_device_close_fn = CFUNCTYPE(None, c_void_p)


# Takes what is to be put out, at once.
vbss_device_write_fn = CFUNCTYPE(c_int32, c_void_p, c_double, POINTER(vbss_output_result))


# Says in words what failed last.
vbss_device_explain_fn = CFUNCTYPE(None, c_void_p, POINTER(c_char), c_uint32)


class vbss_device_sample(ctypes.Structure):
    """What an adapter knows at the moment. The library hands out a cleared one; the adapter fills
    what it has and says so in `valid`. The library's memory goes on for 4096 bytes from the
    beginning, so an adapter with a newer header may fill fields that an older library does not
    know; they are ignored, as are unknown bits.

    valid: VBSS_DEVICE_HAS_ bits.

    flags: VBSS_DEVICE_FLAG_ bits; looked at even if the read fails.

    buttons: One bit each.

    tool: Kind of tool.

    time: When this was measured, s, by any clock that only goes forward.

    position: m, each at most 1e3.

    orientation: w, x, y, z, unit: handle to device frame.

    velocity: m/s, each at most 1e3.

    angular_velocity: rad/s, in the device's frame, each at most 1e4.

    jaw_raw: Opening as the sensor tells it, such as V, at most 1e6.

    jaw: Opening, 0 closed to 1 open.

    temperature: Of the hottest motor: 0 cold to 1 about to fail."""
    struct_size: int
    valid: int
    flags: int
    buttons: int
    tool: int
    reserved: int
    time: float
    position: Any
    orientation: Any
    velocity: Any
    angular_velocity: Any
    jaw_raw: float
    jaw: float
    temperature: float
    _kinds_: ClassVar[dict[str, Any]] = {"valid": DeviceHasBits, "flags": DeviceFlagBits, "tool": DeviceTool}
    _fields_ = [
        ("struct_size", c_uint32),
        ("valid", c_uint32),
        ("flags", c_uint32),
        ("buttons", c_uint32),
        ("tool", c_int32),
        ("reserved", c_uint32),
        ("time", c_double),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("velocity", c_double * 3),
        ("angular_velocity", c_double * 3),
        ("jaw_raw", c_double),
        ("jaw", c_double),
        ("temperature", c_double),
    ]


class DeviceSample(NamedTuple):
    """What an adapter knows at the moment. The library hands out a cleared one; the adapter fills
    what it has and says so in `valid`. The library's memory goes on for 4096 bytes from the
    beginning, so an adapter with a newer header may fill fields that an older library does not
    know; they are ignored, as are unknown bits. Fields as vbss_device_sample says."""
    valid: DeviceHasBits
    flags: DeviceFlagBits
    buttons: int
    tool: DeviceTool
    time: float
    position: tuple[float, ...]
    orientation: tuple[float, ...]
    velocity: tuple[float, ...]
    angular_velocity: tuple[float, ...]
    jaw_raw: float
    jaw: float
    temperature: float


# Gives the newest sample, at once. The same sample may be given again: its time says so.
vbss_device_read_fn = CFUNCTYPE(c_int32, c_void_p, c_double, POINTER(vbss_device_sample))


class vbss_device_capabilities(ctypes.Structure):
    """What a device can do; 0 where it is not known. Handed to adapters and grown as
    vbss_device_sample.

    signals: VBSS_DEVICE_HAS_ bits that samples may have.

    outputs: VBSS_DEVICE_OUT_ bits.

    input_dof: Degrees of freedom that are measured.

    output_dof: Degrees of freedom that are driven.

    max_force: Peak, N.

    max_continuous_force: That it can keep up, N.

    max_torque: Peak, N m.

    max_continuous_torque: That it can keep up, N m.

    max_stiffness: That can be felt without buzzing, N/m.

    max_damping: The same, N s/m.

    update_rate: Samples a second, Hz.

    workspace_low: Corner of the box it reaches, device frame, m.

    workspace_high: The opposite corner; equal to `low`: not known."""
    struct_size: int
    signals: int
    outputs: int
    input_dof: int
    output_dof: int
    reserved: int
    max_force: float
    max_continuous_force: float
    max_torque: float
    max_continuous_torque: float
    max_stiffness: float
    max_damping: float
    update_rate: float
    workspace_low: Any
    workspace_high: Any
    _kinds_: ClassVar[dict[str, Any]] = {"signals": DeviceHasBits, "outputs": DeviceOutBits}
    _fields_ = [
        ("struct_size", c_uint32),
        ("signals", c_uint32),
        ("outputs", c_uint32),
        ("input_dof", c_uint32),
        ("output_dof", c_uint32),
        ("reserved", c_uint32),
        ("max_force", c_double),
        ("max_continuous_force", c_double),
        ("max_torque", c_double),
        ("max_continuous_torque", c_double),
        ("max_stiffness", c_double),
        ("max_damping", c_double),
        ("update_rate", c_double),
        ("workspace_low", c_double * 3),
        ("workspace_high", c_double * 3),
    ]


class DeviceCapabilities(NamedTuple):
    """What a device can do; 0 where it is not known. Handed to adapters and grown as
    vbss_device_sample. Fields as vbss_device_capabilities says."""
    signals: DeviceHasBits
    outputs: DeviceOutBits
    input_dof: int
    output_dof: int
    max_force: float
    max_continuous_force: float
    max_torque: float
    max_continuous_torque: float
    max_stiffness: float
    max_damping: float
    update_rate: float
    workspace_low: tuple[float, ...]
    workspace_high: tuple[float, ...]


# Tells what the hardware can do; called once, after `open`.
vbss_device_describe_fn = CFUNCTYPE(c_int32, c_void_p, POINTER(vbss_device_capabilities))


class vbss_device_coupling(ctypes.Structure):
    """A virtual coupling between the hand and the tool: to the hand goes

    force + stiffness (position - p) + damping (velocity - v)

    with p and v the hand's. Fill it with vbss_device_coupling_init, then set what you want. A
    device computes this force where it is written to, from what was read last; an adapter with
    a servo of its own (haptics.h) computes it again in every tick, from what it has just
    measured, so that no delay of the simulation stands between the hand and its spring.

    position: Of the tool that the hand is tied to, m, each at most 1e3.

    velocity: Of the tool, m/s, each at most 1e3; default 0.

    force: N, added, each at most 1e3; default 0.

    stiffness: N/m, 0 to 1e6; default 0.

    damping: N s/m, 0 to 1e6; default 0."""
    struct_size: int
    reserved: int
    position: Any
    velocity: Any
    force: Any
    stiffness: float
    damping: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("position", c_double * 3),
        ("velocity", c_double * 3),
        ("force", c_double * 3),
        ("stiffness", c_double),
        ("damping", c_double),
    ]


# As vbss_device_write_fn, and instead of it where there is a coupling and nothing speaks against
# it: the output's force is the coupling's at the pose that was read last. The adapter may put out
# the coupling's force at newer poses, within limits as in the output stage, until `expires` has
# passed.
vbss_device_couple_fn = CFUNCTYPE(c_int32, c_void_p, c_double, POINTER(vbss_output_result), POINTER(vbss_device_coupling))


class vbss_device_adapter(ctypes.Structure):
    """An adapter. Fill it with vbss_device_adapter_init, then set what there is. All functions are
    called on the thread that calls the device, must return (no longjmp, no exception), and must
    not change the context.

    name: For texts; NULL (default): "device". At most 31 bytes are kept.

    user: Handed to the functions; may be NULL.

    open: NULL (default): nothing to open.

    close: NULL (default): nothing to close.

    describe: NULL (default): all signals and outputs there are functions for.

    read: NULL (default) only beside another adapter, if `write` is not.

    write: NULL (default): no outputs.

    explain: NULL (default): no texts.

    couple: NULL (default): no servo of its own."""
    struct_size: int
    reserved: int
    name: Any
    user: Any
    open: Any
    close: Any
    describe: Any
    read: Any
    write: Any
    explain: Any
    couple: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("name", c_char_p),
        ("user", c_void_p),
        ("open", vbss_device_open_fn),
        ("close", vbss_device_close_fn),
        ("describe", vbss_device_describe_fn),
        ("read", vbss_device_read_fn),
        ("write", vbss_device_write_fn),
        ("explain", vbss_device_explain_fn),
        ("couple", vbss_device_couple_fn),
    ]


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_device_adapter_init": (c_int32, (POINTER(vbss_device_adapter), c_uint32)),
    "vbss_device_sample_init": (c_int32, (POINTER(vbss_device_sample), c_uint32)),
    "vbss_device_capabilities_init": (c_int32, (POINTER(vbss_device_capabilities), c_uint32)),
    "vbss_device_coupling_init": (c_int32, (POINTER(vbss_device_coupling), c_uint32)),
}
