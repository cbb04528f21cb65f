"""device.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_char, c_char_p, c_double, c_int32, c_uint32, c_uint64, c_uint8, c_void_p
from enum import IntEnum, IntFlag
from typing import Any, ClassVar, NamedTuple

from .base import vbss_context, vbss_view


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


class DeviceTool(IntEnum):
    """The constants of vbss_device_tool."""
    NONE = 0
    """None."""
    NEEDLE_DRIVER = 1
    """A needle driver."""
    SHEARS = 2
    """Shears."""


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


class DeviceClock(IntEnum):
    """The constants of vbss_device_clock."""
    OWN = 0
    """Of any origin: a sample is as old as the read that found its time advanced."""
    SHARED = 1
    """The host's own: a sample is as old as it says, so that one that comes late is known to."""


class DeviceStatus(IntEnum):
    """The constants of vbss_device_status."""
    WAITING = 0
    """There was no pose yet."""
    READY = 1
    """The pose is new."""
    STALE = 2
    """The pose is old and held."""
    LOST = 3
    """An adapter says that its hardware is not there."""


class DeviceEventBits(IntFlag):
    """What happened in a read: bits."""
    LOST = 1
    """An adapter's hardware is gone,"""
    FOUND = 2
    """or back."""
    STALE = 4
    """The pose became stale,"""
    FRESH = 8
    """or new again, or came for the first time."""
    JAW_STALE = 16
    """The opening became stale,"""
    JAW_FRESH = 32
    """or new again, or came for the first time."""
    REFUSED = 64
    """A sample or raw opening was refused."""
    FAILED = 128
    """An adapter gave no sample."""
    STOPPED = 256
    """The device latched the emergency stop."""
    FAULT = 512
    """A device began to refuse forces."""
    RESTARTED = 1024
    """The clock of an adapter began anew."""
    TOOL = 2048
    """The tool is another."""


class MockFault(IntEnum):
    """The constants of vbss_mock_fault; t0: when the fault begins, v: its value."""
    NAN = 1
    """A NaN in: 0 position, 1 orientation, 2 velocity, 3 jaw (raw and not), 4 time, as v says."""
    STALL = 2
    """The sample of t0 again and again."""
    DISCONNECT = 3
    """Reads and writes fail, with VBSS_DEVICE_FLAG_LOST."""
    RATE = 4
    """A new sample every v s only."""
    LATE = 5
    """Samples of v s ago."""
    SHUFFLE = 6
    """Every second interval of v s, samples of v s ago: their order is broken."""
    NORM = 7
    """Orientations of length v."""
    JUMP = 8
    """x further by v m."""
    TEMPERATURE = 9
    """A temperature of v."""
    JAW = 10
    """A raw opening of v, as of a broken wire."""
    STOP = 11
    """VBSS_DEVICE_FLAG_STOP."""
    REFUSAL = 12
    """VBSS_DEVICE_FLAG_FAULT."""
    READ_FAILS = 13
    """Reads fail."""
    WRITE_FAILS = 14
    """Writes fail."""


class MockField(IntEnum):
    """The constants of vbss_mock_field."""
    ROWS = 1
    """(n x 9) F64: now, force, torque, solenoid, flags of each write since vbss_mock_clear_rows."""


class MappingMouseBits(IntFlag):
    """Buttons of a mouse: bits."""
    TURN = 1
    """Movements turn instead of shift."""
    CLOSE = 2
    """The jaws close; otherwise they open."""


class vbss_device(ctypes.Structure):
    """A device: one or two adapters, calibration, and the output stage."""


class vbss_output(ctypes.Structure):
    """An output stage alone, for hosts with a device layer of their own."""


class vbss_mock(ctypes.Structure):
    """An adapter without hardware: driven by a function of time or by samples, with faults on
    demand."""


# Opens the hardware. May take its time, unlike `read` and `write`.
vbss_device_open_fn = CFUNCTYPE(c_int32, c_void_p)


# Closes it. Outputs have been put off before.
vbss_device_close_fn = CFUNCTYPE(None, c_void_p)


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


# What a mock measures: a function of time.
vbss_mock_measure_fn = CFUNCTYPE(None, c_void_p, c_double, POINTER(vbss_device_sample))


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


# Takes what is to be put out, at once.
vbss_device_write_fn = CFUNCTYPE(c_int32, c_void_p, c_double, POINTER(vbss_output_result))


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

    explain: NULL (default): no texts."""
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
    ]


class vbss_device_calibration(ctypes.Structure):
    """From the device to the world. Fill it with vbss_device_calibration_init, then change what
    you need. With C the rotation times the matrix of `axes`:

    position offset + C scale p, then the clutch's shift, then into the workspace orientation C
    R C^T mount: at the device's identity the tool is oriented as `mount` force to the device:
    force_scale C^T f

    A stiffness k in the world is felt as k scale force_scale.

    axes: World axis i is device axis |axes[i]| (1 to 3), negative: reversed; default 1, 2, 3.
    An odd one mirrors.

    rotation: Then this rotation, row by row, right to 1e-6; default identity.

    scale: World metres per device metre, 1e-3 to 1e3; default 1.

    offset: m, each at most 1e3; default 0.

    mount: Tool frame in the handle's, w, x, y, z, any length; default 1, 0, 0, 0.

    workspace_low: Corner of the box that poses are kept in, world, m; default -1.

    workspace_high: The opposite corner, above it; each within 1e3; default 1.

    force_scale: 1e-3 to 1e3; default 1.

    jaw_closed: `jaw_raw` of the closed handle; default 0.

    jaw_open: The same of the open one; more or less, but 1e-9 apart; default 1.

    jaw_margin: How far outside this range, as a part of it, a raw value is believed, 0 to 10;
    default 0.25. Beyond, the sensor is broken and the value refused.

    jaw_play: Movements of the opening smaller than this are not seen, 0 to 0.5; default 0.02.

    jaw_time: Time constant of the filter of the opening, s, 0 to 10; default 0.01.

    jaw_close_at: The jaws count as closed from this opening down, 0 to 1; default 0.05,

    jaw_open_at: and as not closed again from this one up, at least jaw_close_at; default 0.1."""
    struct_size: int
    axes: Any
    rotation: Any
    scale: float
    offset: Any
    mount: Any
    workspace_low: Any
    workspace_high: Any
    force_scale: float
    jaw_closed: float
    jaw_open: float
    jaw_margin: float
    jaw_play: float
    jaw_time: float
    jaw_close_at: float
    jaw_open_at: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("axes", c_int32 * 3),
        ("rotation", c_double * 9),
        ("scale", c_double),
        ("offset", c_double * 3),
        ("mount", c_double * 4),
        ("workspace_low", c_double * 3),
        ("workspace_high", c_double * 3),
        ("force_scale", c_double),
        ("jaw_closed", c_double),
        ("jaw_open", c_double),
        ("jaw_margin", c_double),
        ("jaw_play", c_double),
        ("jaw_time", c_double),
        ("jaw_close_at", c_double),
        ("jaw_open_at", c_double),
    ]


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


class vbss_device_config(ctypes.Structure):
    """How to make a device. Fill it with vbss_device_config_init, then change what you need.

    tool: Where no adapter tells; default VBSS_DEVICE_TOOL_NEEDLE_DRIVER.

    second_signals: VBSS_DEVICE_HAS_ bits that come from the second adapter, if there is one;
    default the jaw. One of the pose (position, orientation, velocities) brings all of it, one
    opening the other.

    clock: Default VBSS_DEVICE_CLOCK_OWN.

    stop_when_lost: 1 (default): a lost adapter latches the emergency stop; 0: its samples just
    grow old.

    clutch_orientation: 1: the clutch holds the orientation too; 0 (default): it always follows.

    jaw_timeout: Age at which the jaw's opening is stale, s, 1e-4 to 1e3; default 0.1. The
    pose's is the output's input_timeout.

    velocity_time: Time constant of estimated velocities, s, 0 to 10; default 0.005.

    norm_tolerance: |1 - length| of an orientation that is taken and made unit, 0 to 0.5;
    default 1e-3.

    max_stiffness: Ceiling for couplings, N/m, 0 to 1e6; default 400. Only told.

    max_damping: The same, N s/m; default 4. Only told.

    calibration: NULL (default): as initialised. Copied.

    output: NULL (default): as initialised. Copied."""
    struct_size: int
    tool: int
    second_signals: int
    clock: int
    stop_when_lost: int
    clutch_orientation: int
    jaw_timeout: float
    velocity_time: float
    norm_tolerance: float
    max_stiffness: float
    max_damping: float
    calibration: Any
    output: Any
    _kinds_: ClassVar[dict[str, Any]] = {"tool": DeviceTool, "second_signals": DeviceHasBits, "clock": DeviceClock}
    _fields_ = [
        ("struct_size", c_uint32),
        ("tool", c_int32),
        ("second_signals", c_uint32),
        ("clock", c_int32),
        ("stop_when_lost", c_uint32),
        ("clutch_orientation", c_uint32),
        ("jaw_timeout", c_double),
        ("velocity_time", c_double),
        ("norm_tolerance", c_double),
        ("max_stiffness", c_double),
        ("max_damping", c_double),
        ("calibration", POINTER(vbss_device_calibration)),
        ("output", POINTER(vbss_output_config)),
    ]


class vbss_device_input(ctypes.Structure):
    """What a read found, in the world's frame.

    status: How the device is.

    valid: VBSS_DEVICE_HAS_ bits of what is known; estimated velocities count.

    stale: Of them, those that are too old and held; stale velocities are zero.

    events: VBSS_DEVICE_EVENT_ bits.

    clamped: 1, 2, 4: x, y, z is held at the workspace.

    buttons: As told last.

    pressed: Those that were up in the last read.

    released: Those that were down in the last read.

    tool: Kind of tool.

    jaw_closed: 1: the jaws count as closed.

    clutched: 1: the clutch is held: the pose stays, there is no force.

    stopped: 1: the emergency stop is latched.

    time: Of the pose, by the adapter's clock, s.

    age: Of the pose, s; -1: there was none.

    jaw_age: Of the opening, s; -1: there was none.

    position: m.

    orientation: w, x, y, z, unit: tool to world.

    velocity: m/s.

    angular_velocity: rad/s, in the world's frame.

    jaw: Opening, 0 closed to 1 open.

    jaw_raw: As told last.

    temperature: As told last."""
    struct_size: int
    status: int
    valid: int
    stale: int
    events: int
    clamped: int
    buttons: int
    pressed: int
    released: int
    tool: int
    jaw_closed: int
    clutched: int
    stopped: int
    reserved: int
    time: float
    age: float
    jaw_age: float
    position: Any
    orientation: Any
    velocity: Any
    angular_velocity: Any
    jaw: float
    jaw_raw: float
    temperature: float
    _kinds_: ClassVar[dict[str, Any]] = {"status": DeviceStatus, "valid": DeviceHasBits, "events": DeviceEventBits, "tool": DeviceTool}
    _fields_ = [
        ("struct_size", c_uint32),
        ("status", c_int32),
        ("valid", c_uint32),
        ("stale", c_uint32),
        ("events", c_uint32),
        ("clamped", c_uint32),
        ("buttons", c_uint32),
        ("pressed", c_uint32),
        ("released", c_uint32),
        ("tool", c_int32),
        ("jaw_closed", c_int32),
        ("clutched", c_int32),
        ("stopped", c_int32),
        ("reserved", c_uint32),
        ("time", c_double),
        ("age", c_double),
        ("jaw_age", c_double),
        ("position", c_double * 3),
        ("orientation", c_double * 4),
        ("velocity", c_double * 3),
        ("angular_velocity", c_double * 3),
        ("jaw", c_double),
        ("jaw_raw", c_double),
        ("temperature", c_double),
    ]


class DeviceInput(NamedTuple):
    """What a read found, in the world's frame. Fields as vbss_device_input says."""
    status: DeviceStatus
    valid: DeviceHasBits
    stale: int
    events: DeviceEventBits
    clamped: int
    buttons: int
    pressed: int
    released: int
    tool: DeviceTool
    jaw_closed: int
    clutched: int
    stopped: int
    time: float
    age: float
    jaw_age: float
    position: tuple[float, ...]
    orientation: tuple[float, ...]
    velocity: tuple[float, ...]
    angular_velocity: tuple[float, ...]
    jaw: float
    jaw_raw: float
    temperature: float


class vbss_device_statistics(ctypes.Structure):
    """Figures of a device since creation; [0] and [1]: of the first and the second adapter.

    reads: Calls of vbss_device_read.

    writes: Calls of vbss_device_write.

    accepted: Samples that were taken.

    repeated: Samples whose time had not advanced.

    out_of_order: Refused: older than the one before.

    not_finite: Refused: with a NaN or an infinity.

    out_of_range: Refused: outside what the fields allow.

    not_unit: Refused: an orientation outside norm_tolerance.

    failed_reads: Reads without a sample.

    failed_writes: Outputs that were not taken.

    lost: How often the hardware was lost.

    faults: How often it began to refuse forces.

    restarts: How often its clock began anew.

    jaw_refused: Raw openings outside jaw_margin.

    pose_stale: How often the pose became stale.

    pose_stale_reads: Reads in which it was.

    jaw_stale: How often the opening became stale.

    clamped_reads: Reads in which the workspace held the pose.

    clutches: How often the clutch was held.

    oldest_pose: Largest age of a pose, s."""
    struct_size: int
    reserved: int
    reads: int
    writes: int
    accepted: Any
    repeated: Any
    out_of_order: Any
    not_finite: Any
    out_of_range: Any
    not_unit: Any
    failed_reads: Any
    failed_writes: Any
    lost: Any
    faults: Any
    restarts: Any
    jaw_refused: int
    pose_stale: int
    pose_stale_reads: int
    jaw_stale: int
    clamped_reads: int
    clutches: int
    oldest_pose: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("reads", c_uint64),
        ("writes", c_uint64),
        ("accepted", c_uint64 * 2),
        ("repeated", c_uint64 * 2),
        ("out_of_order", c_uint64 * 2),
        ("not_finite", c_uint64 * 2),
        ("out_of_range", c_uint64 * 2),
        ("not_unit", c_uint64 * 2),
        ("failed_reads", c_uint64 * 2),
        ("failed_writes", c_uint64 * 2),
        ("lost", c_uint64 * 2),
        ("faults", c_uint64 * 2),
        ("restarts", c_uint64 * 2),
        ("jaw_refused", c_uint64),
        ("pose_stale", c_uint64),
        ("pose_stale_reads", c_uint64),
        ("jaw_stale", c_uint64),
        ("clamped_reads", c_uint64),
        ("clutches", c_uint64),
        ("oldest_pose", c_double),
    ]


class DeviceStatistics(NamedTuple):
    """Figures of a device since creation; [0] and [1]: of the first and the second adapter. Fields
    as vbss_device_statistics says."""
    reads: int
    writes: int
    accepted: tuple[int, ...]
    repeated: tuple[int, ...]
    out_of_order: tuple[int, ...]
    not_finite: tuple[int, ...]
    out_of_range: tuple[int, ...]
    not_unit: tuple[int, ...]
    failed_reads: tuple[int, ...]
    failed_writes: tuple[int, ...]
    lost: tuple[int, ...]
    faults: tuple[int, ...]
    restarts: tuple[int, ...]
    jaw_refused: int
    pose_stale: int
    pose_stale_reads: int
    jaw_stale: int
    clamped_reads: int
    clutches: int
    oldest_pose: float


class vbss_mock_config(ctypes.Structure):
    """How to make a mock. Fill it with vbss_mock_config_init, then change what you need.

    fault_capacity: Most faults at a time, 0 to 4096; default 16.

    row_capacity: Most rows of what was written that are kept, 0 to 2^20; default 1024.

    measure: NULL (default): the sample of vbss_mock_set_sample.

    user: Handed to measure; may be NULL.

    capabilities: NULL (default): 6 and 3 degrees of freedom, 3.3 N, 400 N/m, 4 N s/m, 1 kHz, a
    box of 0.15 m, all signals and outputs. Copied."""
    struct_size: int
    fault_capacity: int
    row_capacity: int
    reserved: int
    measure: Any
    user: Any
    capabilities: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("fault_capacity", c_uint32),
        ("row_capacity", c_uint32),
        ("reserved", c_uint32),
        ("measure", vbss_mock_measure_fn),
        ("user", c_void_p),
        ("capabilities", POINTER(vbss_device_capabilities)),
    ]


class vbss_mock_statistics(ctypes.Structure):
    """What a mock went through.

    open: 1: it is open.

    opens: How often it was opened.

    reads: How often it was read.

    writes: How often it was written to, also in vain.

    rows_lost: Rows there was no room for."""
    struct_size: int
    open: int
    opens: int
    reads: int
    writes: int
    rows_lost: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("open", c_int32),
        ("opens", c_uint64),
        ("reads", c_uint64),
        ("writes", c_uint64),
        ("rows_lost", c_uint64),
    ]


class MockStatistics(NamedTuple):
    """What a mock went through. Fields as vbss_mock_statistics says."""
    open: int
    opens: int
    reads: int
    writes: int
    rows_lost: int


class vbss_mapping_config(ctypes.Structure):
    """How movements of hands on a desk become a pose. Fill it with vbss_mapping_config_init, then
    change what you need. Turns are about axes of the frame the pose is in.

    pad_curve: Gamepad: power of the deflection, 1 to 4; default 2.

    right: Direction of the screen's right, unit to 1e-6; default x.

    up: Of its top, normal to it; default y. Right x up points towards the user.

    low: Corner of the box that positions are kept in, m; default -0.1.

    high: The opposite corner; each within 1e3; default 0.1.

    mouse_metres: Mouse: m a count; default 1e-4.

    mouse_depth: Mouse: m away from the user a notch of the wheel; default 2e-3.

    mouse_radians: Mouse, turning: rad a count; default 5e-3.

    mouse_roll: Mouse, turning: rad about the direction of depth a notch; default 0.1.

    jaw_rate: Mouse: how fast the jaws close and open, 1/s, 0 to 1e3; default 4.

    key_metres: Keyboard: m a press; default 1e-3.

    key_radians: Keyboard: rad a press; default 0.05.

    key_jaw: Keyboard: opening a press; default 0.1.

    pad_speed: Gamepad: m/s at full deflection; default 0.1.

    pad_turning: Gamepad: rad/s at full deflection; default 1.

    pad_dead: Gamepad: deflection that counts as none, 0 to 0.9; default 0.15."""
    struct_size: int
    pad_curve: int
    right: Any
    up: Any
    low: Any
    high: Any
    mouse_metres: float
    mouse_depth: float
    mouse_radians: float
    mouse_roll: float
    jaw_rate: float
    key_metres: float
    key_radians: float
    key_jaw: float
    pad_speed: float
    pad_turning: float
    pad_dead: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("pad_curve", c_uint32),
        ("right", c_double * 3),
        ("up", c_double * 3),
        ("low", c_double * 3),
        ("high", c_double * 3),
        ("mouse_metres", c_double),
        ("mouse_depth", c_double),
        ("mouse_radians", c_double),
        ("mouse_roll", c_double),
        ("jaw_rate", c_double),
        ("key_metres", c_double),
        ("key_radians", c_double),
        ("key_jaw", c_double),
        ("pad_speed", c_double),
        ("pad_turning", c_double),
        ("pad_dead", c_double),
    ]


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_device_adapter_init": (c_int32, (POINTER(vbss_device_adapter), c_uint32)),
    "vbss_device_sample_init": (c_int32, (POINTER(vbss_device_sample), c_uint32)),
    "vbss_device_capabilities_init": (c_int32, (POINTER(vbss_device_capabilities), c_uint32)),
    "vbss_device_calibration_init": (c_int32, (POINTER(vbss_device_calibration), c_uint32)),
    "vbss_device_config_init": (c_int32, (POINTER(vbss_device_config), c_uint32)),
    "vbss_output_config_init": (c_int32, (POINTER(vbss_output_config), c_uint32)),
    "vbss_output_command_init": (c_int32, (POINTER(vbss_output_command), c_uint32)),
    "vbss_mock_config_init": (c_int32, (POINTER(vbss_mock_config), c_uint32)),
    "vbss_mapping_config_init": (c_int32, (POINTER(vbss_mapping_config), c_uint32)),
    "vbss_device_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_device_adapter),
        POINTER(vbss_device_adapter), POINTER(vbss_device_config), POINTER(POINTER(vbss_device)))),
    "vbss_device_destroy": (c_int32, (POINTER(vbss_device),)),
    "vbss_device_read": (c_int32, (POINTER(vbss_device), c_double, POINTER(vbss_device_input),
        c_uint32)),
    "vbss_device_write": (c_int32, (POINTER(vbss_device), c_double, POINTER(vbss_output_command),
        POINTER(vbss_output_result), c_uint32)),
    "vbss_device_stop": (c_int32, (POINTER(vbss_device),)),
    "vbss_device_release": (c_int32, (POINTER(vbss_device),)),
    "vbss_device_clutch": (c_int32, (POINTER(vbss_device), c_int32)),
    "vbss_device_recentre": (c_int32, (POINTER(vbss_device), POINTER(c_double), POINTER(c_double))),
    "vbss_device_set_calibration": (c_int32, (POINTER(vbss_device),
        POINTER(vbss_device_calibration))),
    "vbss_device_get_capabilities": (c_int32, (POINTER(vbss_device), c_uint32,
        POINTER(vbss_device_capabilities), c_uint32)),
    "vbss_device_get_error": (c_int32, (POINTER(vbss_device), c_uint32, POINTER(c_int32),
        POINTER(c_char_p))),
    "vbss_device_get_statistics": (c_int32, (POINTER(vbss_device), POINTER(vbss_device_statistics),
        c_uint32)),
    "vbss_device_get_output_statistics": (c_int32, (POINTER(vbss_device),
        POINTER(vbss_output_statistics), c_uint32)),
    "vbss_device_save": (c_int32, (POINTER(vbss_device), POINTER(c_uint8), c_uint64,
        POINTER(c_uint64))),
    "vbss_device_restore": (c_int32, (POINTER(vbss_device), POINTER(c_uint8), c_uint64)),
    "vbss_device_get_hash": (c_int32, (POINTER(vbss_device), POINTER(c_uint64))),
    "vbss_output_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_output_config),
        POINTER(POINTER(vbss_output)))),
    "vbss_output_destroy": (c_int32, (POINTER(vbss_output),)),
    "vbss_output_step": (c_int32, (POINTER(vbss_output), c_double, POINTER(vbss_output_command),
        POINTER(vbss_output_result), c_uint32)),
    "vbss_output_stop": (c_int32, (POINTER(vbss_output),)),
    "vbss_output_release": (c_int32, (POINTER(vbss_output),)),
    "vbss_output_get_statistics": (c_int32, (POINTER(vbss_output), POINTER(vbss_output_statistics),
        c_uint32)),
    "vbss_mock_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_mock_config),
        POINTER(POINTER(vbss_mock)))),
    "vbss_mock_destroy": (c_int32, (POINTER(vbss_mock),)),
    "vbss_mock_get_adapter": (c_int32, (POINTER(vbss_mock), POINTER(vbss_device_adapter))),
    "vbss_mock_set_sample": (c_int32, (POINTER(vbss_mock), POINTER(vbss_device_sample))),
    "vbss_mock_add_fault": (c_int32, (POINTER(vbss_mock), c_int32, c_double, c_double, c_double)),
    "vbss_mock_clear_faults": (c_int32, (POINTER(vbss_mock),)),
    "vbss_mock_clear_rows": (c_int32, (POINTER(vbss_mock),)),
    "vbss_mock_get_view": (c_int32, (POINTER(vbss_mock), c_int32, POINTER(vbss_view), c_uint32)),
    "vbss_mock_get_statistics": (c_int32, (POINTER(vbss_mock), POINTER(vbss_mock_statistics),
        c_uint32)),
    "vbss_mapping_mouse": (c_int32, (POINTER(vbss_mapping_config), POINTER(c_double), c_uint32,
        c_double, POINTER(vbss_device_sample))),
    "vbss_mapping_keyboard": (c_int32, (POINTER(vbss_mapping_config), POINTER(c_double), c_double,
        POINTER(vbss_device_sample))),
    "vbss_mapping_gamepad": (c_int32, (POINTER(vbss_mapping_config), POINTER(c_double), c_double,
        c_double, POINTER(vbss_device_sample))),
}
