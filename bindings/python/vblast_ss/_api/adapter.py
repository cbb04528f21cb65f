"""adapter.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_char, c_char_p, c_double, c_int32, c_uint32, c_void_p
from enum import IntEnum, IntFlag
from typing import Any, ClassVar, NamedTuple

from .output import vbss_output_result


class DeviceHasBits(IntFlag):
    """Bits for the parts of a sample."""
    POSITION = 1
    """`position` is valid."""
    ORIENTATION = 2
    """`orientation` is valid."""
    VELOCITY = 4
    """`velocity` is valid."""
    ANGULAR_VELOCITY = 8
    """`angular_velocity` is valid."""
    JAW_RAW = 16
    """`jaw_raw` is valid."""
    JAW = 32
    """`jaw` is valid and replaces `jaw_raw`."""
    BUTTONS = 64
    """`buttons` is valid."""
    TOOL = 128
    """`tool` is valid."""
    TEMPERATURE = 256
    """`temperature` is valid."""


class DeviceOutBits(IntFlag):
    """Bits for the outputs of a device."""
    FORCE = 1
    """Force on the hand."""
    TORQUE = 2
    """Torque on the hand."""
    SOLENOID = 4
    """Solenoid in the handle."""


class DeviceFlagBits(IntFlag):
    """Bits for the state that a device reports with a sample."""
    LOST = 1
    """The hardware is missing: unplugged, or its driver has failed."""
    STOP = 2
    """Emergency stop; it latches as vbss_device_latch_emergency_stop does."""
    FAULT = 4
    """The hardware refuses forces for now; all outputs are off while this bit is set."""
    SLOW = 8
    """The hardware is too slow to switch outputs off within vbss_output_result::expires. `explain`
    gives its speed."""


class DeviceTool(IntEnum):
    """The constants of vbss_device_tool."""
    NONE = 0
    """No tool."""
    NEEDLE_DRIVER = 1
    """A needle driver."""
    SHEARS = 2
    """Shears."""


# Opens the hardware. Unlike `read` and `write`, it may block.
vbss_device_open_fn = CFUNCTYPE(c_int32, c_void_p)


# Closes the hardware. The library has switched its outputs off before.
vbss_device_close_fn = CFUNCTYPE(None, c_void_p)


# Writes the outputs without waiting.
vbss_device_write_fn = CFUNCTYPE(c_int32, c_void_p, c_double, POINTER(vbss_output_result))


# Describes the last failure in words.
vbss_device_explain_fn = CFUNCTYPE(None, c_void_p, POINTER(c_char), c_uint32)


class vbss_device_sample(ctypes.Structure):
    """A sample of an adapter. The library passes a cleared one; the adapter fills the fields that
    it has and sets their bits in `valid`. The library's memory has 4096 bytes, so an adapter
    with a newer header may fill fields that an older library does not know. The library ignores
    them, and unknown bits.

    valid: VBSS_DEVICE_HAS_ bits.

    flags: VBSS_DEVICE_FLAG_ bits; evaluated even if the read fails.

    buttons: Pressed buttons, one bit each.

    tool: Kind of tool.

    time: Time of the measurement, s, by any clock that never runs backwards.

    position: Position, m, each coordinate at most 1e3 in magnitude.

    orientation: Orientation from handle to device frame, unit quaternion w, x, y, z.

    velocity: Velocity, m/s, each component at most 1e3 in magnitude.

    angular_velocity: Angular velocity in the device's frame, rad/s, each component at most 1e4
    in magnitude.

    jaw_raw: Opening in the sensor's unit, such as V, at most 1e6 in magnitude.

    jaw: Opening, 0 (closed) to 1 (open).

    temperature: Temperature of the hottest motor, 0 (cold) to 1 (about to fail)."""
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
    """A sample of an adapter. The library passes a cleared one; the adapter fills the fields that
    it has and sets their bits in `valid`. The library's memory has 4096 bytes, so an adapter
    with a newer header may fill fields that an older library does not know. The library ignores
    them, and unknown bits. Fields as vbss_device_sample says."""
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


# Returns the newest sample without waiting. It may return a sample again, with an unchanged time.
vbss_device_read_fn = CFUNCTYPE(c_int32, c_void_p, c_double, POINTER(vbss_device_sample))


class vbss_device_capabilities(ctypes.Structure):
    """Capabilities of a device; 0 means unknown. The library passes a cleared struct of 4096
    bytes, as with vbss_device_sample.

    signals: VBSS_DEVICE_HAS_ bits that samples may have.

    outputs: VBSS_DEVICE_OUT_ bits of the available outputs.

    input_dof: Degrees of freedom that are measured.

    output_dof: Degrees of freedom that are driven.

    max_force: Peak force, N.

    max_continuous_force: Largest continuous force, N.

    max_torque: Peak torque, N m.

    max_continuous_torque: Largest continuous torque, N m.

    max_stiffness: Largest stiffness that does not make the arm buzz, N/m.

    max_damping: Largest damping that does not make the arm buzz, N s/m.

    update_rate: Sample rate, Hz.

    workspace_low: Lower corner of the reachable box, device frame, m.

    workspace_high: Upper corner of the reachable box; equal to `workspace_low` if unknown."""
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
    """Capabilities of a device; 0 means unknown. The library passes a cleared struct of 4096
    bytes, as with vbss_device_sample. Fields as vbss_device_capabilities says."""
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


# Reports the capabilities of the hardware. The library calls it once, after `open`.
vbss_device_describe_fn = CFUNCTYPE(c_int32, c_void_p, POINTER(vbss_device_capabilities))


class vbss_device_coupling(ctypes.Structure):
    """A virtual coupling between the hand and the tool. The force on the hand is

    force + stiffness (position - p) + damping (velocity - v)

    with p and v the hand's position and velocity. Fill it with vbss_device_coupling_init, then
    set its fields. A device computes this force in each write, from the pose that was read
    last. An adapter with its own servo (haptics.h) recomputes it in every tick from the pose
    just measured. The simulation then adds no delay between the hand and its spring.

    position: Position of the tool that is coupled to the hand, m, each coordinate at most 1e3
    in magnitude.

    velocity: Velocity of the tool, m/s, each component at most 1e3 in magnitude; default 0.

    force: Force that is added, N, each component at most 1e3 in magnitude; default 0.

    stiffness: Stiffness, N/m, 0 to 1e6; default 0.

    damping: Damping, N s/m, 0 to 1e6; default 0."""
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


# Writes like vbss_device_write_fn, and replaces it when there is a coupling and forces are on.
# The output has the coupling's force at the pose that was read last. Until `expires` has passed,
# the adapter may apply the coupling's force at newer poses, within the limits of the output
# stage.
vbss_device_couple_fn = CFUNCTYPE(c_int32, c_void_p, c_double, POINTER(vbss_output_result), POINTER(vbss_device_coupling))


class vbss_device_adapter(ctypes.Structure):
    """An adapter. Fill it with vbss_device_adapter_init, then set the functions that exist. The
    library calls them on the thread that calls the device. They must return (no longjmp, no
    exception) and must not change the context.

    name: Name in messages; NULL (default): "device". At most 31 bytes are kept.

    user: Pointer that the functions receive; may be NULL.

    open: Opens the hardware; NULL (default): nothing to open.

    close: Closes the hardware; NULL (default): nothing to close.

    describe: Reports the capabilities; NULL (default): all signals, and the outputs that there
    are functions for.

    read: Reads a sample; NULL (default) only beside another adapter, and if `write` is set.

    write: Writes outputs; NULL (default): no outputs.

    explain: Describes failures; NULL (default): no texts.

    couple: Writes outputs with a coupling; NULL (default): the adapter has no servo."""
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
