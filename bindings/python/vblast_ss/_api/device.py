"""device.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_uint32, c_uint64, c_uint8
from enum import IntEnum, IntFlag
from typing import Any, ClassVar, NamedTuple

from .adapter import (
    DeviceHasBits, DeviceTool, vbss_device_adapter, vbss_device_capabilities,
    vbss_device_coupling
)
from .base import vbss_context
from .output import (
    vbss_output_command, vbss_output_config, vbss_output_result, vbss_output_statistics
)


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
    SLOW = 4096
    """An adapter became too slow to put outputs off in time."""
    JAW_HELD = 8192
    """The opening is held until the handle has passed it."""
    JAW_TAKEN = 16384
    """The handle took over the opening."""


class vbss_device(ctypes.Structure):
    """A device: one or two adapters, calibration, and the output stage."""


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

    jaw_takeover: 1: the opening does not jump. It stays as it was reported last while the
    clutch is held, after vbss_device_restore, after another tool was taken, and after
    vbss_device_hold_jaw, until the handle has passed it; a session also does so in its first
    step and after vbss_session_restore. 0 (default): it always follows.

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
    jaw_takeover: int
    reserved: int
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
        ("jaw_takeover", c_uint32),
        ("reserved", c_uint32),
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

    jaw_held: 1: `jaw` is held until the handle has passed it.

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
    jaw_held: int
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
        ("jaw_held", c_uint32),
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
    jaw_held: int
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


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_device_calibration_init": (c_int32, (POINTER(vbss_device_calibration), c_uint32)),
    "vbss_device_config_init": (c_int32, (POINTER(vbss_device_config), c_uint32)),
    "vbss_device_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_device_adapter),
        POINTER(vbss_device_adapter), POINTER(vbss_device_config), POINTER(POINTER(vbss_device)))),
    "vbss_device_destroy": (c_int32, (POINTER(vbss_device),)),
    "vbss_device_read": (c_int32, (POINTER(vbss_device), c_double, POINTER(vbss_device_input),
        c_uint32)),
    "vbss_device_write": (c_int32, (POINTER(vbss_device), c_double, POINTER(vbss_output_command),
        POINTER(vbss_output_result), c_uint32)),
    "vbss_device_write_coupled": (c_int32, (POINTER(vbss_device), c_double,
        POINTER(vbss_output_command), POINTER(vbss_device_coupling), POINTER(vbss_output_result),
        c_uint32)),
    "vbss_device_stop": (c_int32, (POINTER(vbss_device),)),
    "vbss_device_release": (c_int32, (POINTER(vbss_device),)),
    "vbss_device_clutch": (c_int32, (POINTER(vbss_device), c_int32)),
    "vbss_device_recentre": (c_int32, (POINTER(vbss_device), POINTER(c_double), POINTER(c_double))),
    "vbss_device_hold_jaw": (c_int32, (POINTER(vbss_device), c_double)),
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
}
