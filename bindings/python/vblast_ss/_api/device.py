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
    """The adapter's clock has its own origin. The age of a sample is the time since the first read
    that returned it."""
    SHARED = 1
    """The adapter uses the host's clock. The age of a sample follows from its own time, so that
    delays are known."""


class DeviceStatus(IntEnum):
    """The constants of vbss_device_status."""
    WAITING = 0
    """There is no pose yet."""
    READY = 1
    """The pose is current."""
    STALE = 2
    """The pose is stale; the last one is held."""
    LOST = 3
    """An adapter reports that its hardware is missing."""


class DeviceEventBits(IntFlag):
    """Bits of the events of a read."""
    LOST = 1
    """An adapter's hardware is missing."""
    FOUND = 2
    """An adapter's hardware is back."""
    STALE = 4
    """The pose became stale."""
    FRESH = 8
    """The pose is current again, or came for the first time."""
    JAW_STALE = 16
    """The opening became stale."""
    JAW_FRESH = 32
    """The opening is current again, or came for the first time."""
    REFUSED = 64
    """A sample or raw opening was refused."""
    FAILED = 128
    """An adapter returned no sample."""
    STOPPED = 256
    """The device latched the emergency stop."""
    FAULT = 512
    """A device began to refuse forces."""
    RESTARTED = 1024
    """The clock of an adapter restarted."""
    TOOL = 2048
    """The kind of tool has changed."""
    SLOW = 4096
    """An adapter became too slow to switch outputs off in time."""
    JAW_HELD = 8192
    """The opening is held until the handle has passed it."""
    JAW_TAKEN = 16384
    """The handle took over the opening."""


class vbss_device(ctypes.Structure):
    """A device: one or two adapters, calibration, and the output stage."""


class vbss_device_calibration(ctypes.Structure):
    """Transform from the device to the world. Fill it with vbss_device_calibration_init, then
    change fields. Let p be a position and R an orientation of the device, f a force of the
    world, and C the rotation times the matrix of `axes`:

    position offset + C scale p, then the clutch's shift, then into the workspace orientation C
    R C^T mount: at the device's identity the tool is oriented as `mount` force to the device:
    force_scale C^T f

    A stiffness k in the world is felt as k scale force_scale.

    axes: World axis i is device axis |axes[i]| (1 to 3), reversed if negative; default 1, 2, 3.
    A left-handed choice mirrors.

    rotation: Rotation applied after `axes`, row by row, orthonormal to 1e-6; default identity.

    scale: World metres per device metre, 1e-3 to 1e3; default 1.

    offset: Offset, m, each coordinate at most 1e3 in magnitude; default 0.

    mount: Orientation of the tool frame in the handle's frame, w, x, y, z, any length; default
    1, 0, 0, 0.

    workspace_low: Lower corner of the box to which poses are confined, world, m; default -1.

    workspace_high: Upper corner of the box, above the lower one, at most 1e3 in magnitude;
    default 1.

    force_scale: Device force per world force, 1e-3 to 1e3; default 1.

    jaw_closed: `jaw_raw` of the closed handle; default 0.

    jaw_open: `jaw_raw` of the open handle, at least 1e-9 away from jaw_closed, above or below;
    default 1.

    jaw_margin: Largest distance of a raw value outside the range from closed to open, as a
    share of the range, 0 to 10; default 0.25. A value farther outside is refused, because the
    sensor must be broken.

    jaw_play: Backlash: largest movement of the opening that is ignored, 0 to 0.5; default 0.02.

    jaw_time: Time constant of the opening's filter, s, 0 to 10; default 0.01.

    jaw_close_at: Opening at and below which the jaws become closed, 0 to 1; default 0.05.

    jaw_open_at: Opening at and above which closed jaws become open, jaw_close_at to 1; default
    0.1."""
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
    """Configuration of a device. Fill it with vbss_device_config_init, then change fields.

    tool: Kind of tool, where no adapter reports one; default VBSS_DEVICE_TOOL_NEEDLE_DRIVER.

    second_signals: VBSS_DEVICE_HAS_ bits of the signals that come from the second adapter, if
    there is one; default the jaw. A bit of the pose (position, orientation, velocities) selects
    the whole pose; either bit of the opening selects both.

    clock: Interpretation of sample times; default VBSS_DEVICE_CLOCK_OWN.

    stop_when_lost: 1 (default): a lost adapter latches the emergency stop; 0: its samples only
    become stale.

    clutch_orientation: 1: the clutch holds the orientation too; 0 (default): the orientation
    always follows the hand.

    jaw_takeover: 1: the reported opening never jumps. It is held while the clutch is held, and
    after vbss_device_restore, a change of tool or vbss_device_hold_jaw, until the handle has
    passed it. A session also holds it in its first step and after vbss_session_restore. 0
    (default): the opening always follows the handle.

    jaw_timeout: Age at which the jaw's opening is stale, s, 1e-4 to 1e3; default 0.1. The pose
    uses input_timeout of the output stage.

    velocity_time: Time constant of estimated velocities, s, 0 to 10; default 0.005.

    norm_tolerance: Largest |1 - length| of an orientation that is accepted and normalised, 0 to
    0.5; default 1e-3.

    max_stiffness: Upper limit of couplings, N/m, 0 to 1e6; default 400. The device only reports
    it.

    max_damping: Upper limit of couplings, N s/m, 0 to 1e6; default 4. The device only reports
    it.

    calibration: Calibration; NULL (default): the initialised one. The library copies it.

    output: Output stage; NULL (default): the initialised one. The library copies it."""
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
    """Result of a read, in the world's frame.

    status: Status of the device.

    valid: VBSS_DEVICE_HAS_ bits of the known values; estimated velocities count.

    stale: VBSS_DEVICE_HAS_ bits of the values that are stale and held; stale velocities are
    zero.

    events: VBSS_DEVICE_EVENT_ bits.

    clamped: Bits 1, 2, 4: the workspace limits x, y, z.

    buttons: Buttons as last reported, one bit each.

    pressed: Buttons that were up in the last read and are down now.

    released: Buttons that were down in the last read and are up now.

    tool: Kind of tool.

    jaw_closed: 1: the jaws count as closed.

    clutched: 1: the clutch is held, so the pose stays and there is no force.

    stopped: 1: the emergency stop is latched.

    jaw_held: 1: `jaw` is held until the handle has passed it.

    time: Time of the pose, by the adapter's clock, s.

    age: Age of the pose, s; -1: there is none.

    jaw_age: Age of the opening, s; -1: there is none.

    position: Position, m.

    orientation: Orientation from tool to world, unit quaternion w, x, y, z.

    velocity: Velocity, m/s.

    angular_velocity: Angular velocity in the world's frame, rad/s.

    jaw: Opening, 0 (closed) to 1 (open).

    jaw_raw: Raw opening as last reported.

    temperature: Temperature as last reported, 0 to 1."""
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
    _kinds_: ClassVar[dict[str, Any]] = {"status": DeviceStatus, "valid": DeviceHasBits, "stale": DeviceHasBits, "events": DeviceEventBits, "tool": DeviceTool}
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
    """Result of a read, in the world's frame. Fields as vbss_device_input says."""
    status: DeviceStatus
    valid: DeviceHasBits
    stale: DeviceHasBits
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
    """Counts of a device since creation. Entry [0] is of the first adapter and [1] of the second.

    reads: Calls of vbss_device_read.

    writes: Calls of vbss_device_write.

    accepted: Samples accepted.

    repeated: Samples whose time had not advanced.

    out_of_order: Samples refused because they are older than the one before.

    not_finite: Samples refused because of a NaN or an infinity.

    out_of_range: Samples refused because a field is out of range.

    not_unit: Samples refused because of an orientation outside norm_tolerance.

    failed_reads: Reads without a sample.

    failed_writes: Outputs that an adapter did not accept.

    lost: Times the hardware was lost.

    faults: Times the hardware began to refuse forces.

    restarts: Times the adapter's clock restarted.

    jaw_refused: Raw openings refused because they are outside jaw_margin.

    pose_stale: Times the pose became stale.

    pose_stale_reads: Reads with a stale pose.

    jaw_stale: Times the opening became stale.

    clamped_reads: Reads in which the workspace limited the pose.

    clutches: Times the clutch was held.

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
    """Counts of a device since creation. Entry [0] is of the first adapter and [1] of the second.
    Fields as vbss_device_statistics says."""
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
    "vbss_device_latch_emergency_stop": (c_int32, (POINTER(vbss_device),)),
    "vbss_device_clear_emergency_stop": (c_int32, (POINTER(vbss_device),)),
    "vbss_device_set_clutch": (c_int32, (POINTER(vbss_device), c_int32)),
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
