"""haptics.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_char, c_char_p, c_double, c_int32, c_uint32, c_uint64, c_void_p
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .adapter import vbss_device_adapter
from .base import vbss_context
from .output import vbss_output_config


class HardwareState(IntEnum):
    """The constants of vbss_hardware_state."""
    WAITING = 0
    """Nothing was measured yet."""
    RUNNING = 1
    """All is well."""
    REFUSING = 2
    """It measures, but takes no forces for now: motors warm, force or speed too high."""
    UNCALIBRATED = 3
    """No forces until it is calibrated: put the stylus into the inkwell. Also an arm whose pose
    has not changed by a bit for 1 s: it is not calibrated, its encoders give no data, or nobody
    holds it. It gets forces again when its pose changes."""
    LOST = 4
    """It is not there: unplugged, or its driver has failed."""


class NidaqmxTerminal(IntEnum):
    """The constants of vbss_nidaqmx_terminal."""
    SINGLE_ENDED = 0
    """Against ground: 11 bits of a USB-6008."""
    DIFFERENTIAL = 1
    """Between two inputs: 12 bits."""


class vbss_openhaptics(ctypes.Structure):
    """One or two haptic arms under one servo."""


class vbss_nidaqmx(ctypes.Structure):
    """One or two handles: a potentiometer and a solenoid each."""


# Called in the vendor's servo thread at the end of each tick, after the forces have gone out: a
# host that steps inside the servo does so here, and its forces go out in the next tick. From the
# first call to the return of vbss_openhaptics_destroy nothing but this function may use the
# context that the devices belong to; it must not destroy the arms, and must not wait.
vbss_openhaptics_tick_fn = CFUNCTYPE(None, c_void_p, c_double)


class vbss_openhaptics_config(ctypes.Structure):
    """Which arms, and how. Fill it with vbss_openhaptics_config_init, then change what you need.
    Texts are copied.

    device_count: 1 (default) or 2.

    rate: Of the servo, Hz, 100 to 8000; default 1000. The vendor takes 500, 1000 and 2000, or
    other ones for some arms.

    library: Path or name; NULL (default): `libHD.so`, `libHD.so.3.4` or `libHD.so.3.0`;
    `hd.dll`; or `libHD.dylib`.

    first_name: As the vendor's set-up calls it; NULL (default): its default device, or the one
    that is called `Default Device` or `Default PHANToM`.

    second_name: The same of the second; default `Device2`.

    output: Limits of the stage in the servo, lowered to what the arms say they can; NULL
    (default): as initialised. Copied.

    tick: NULL (default): the host steps in a thread of its own.

    user: Handed to tick; may be NULL."""
    struct_size: int
    device_count: int
    rate: int
    reserved: int
    library: Any
    first_name: Any
    second_name: Any
    output: Any
    tick: Any
    user: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("device_count", c_uint32),
        ("rate", c_uint32),
        ("reserved", c_uint32),
        ("library", c_char_p),
        ("first_name", c_char_p),
        ("second_name", c_char_p),
        ("output", POINTER(vbss_output_config)),
        ("tick", vbss_openhaptics_tick_fn),
        ("user", c_void_p),
    ]


class vbss_openhaptics_status(ctypes.Structure):
    """What an arm went through.

    state: How it is.

    error: What the vendor's library said last of it, its code; 0: nothing.

    internal_error: The vendor's own number for that.

    ticks: Of the servo.

    late_ticks: Ticks after which more time had passed than the servo has for one.

    failed_ticks: Ticks without a pose.

    errors: Errors that the vendor's library told of this arm.

    orders: Outputs of the host that were taken.

    silent_ticks: Ticks with forces ramped down, as the host was silent.

    temperature: Of the hottest motor, 0 to 1.

    longest_tick: From the beginning of a tick to the end of our work in it, s.

    force: That went out last, device's frame, N.

    is_constant: 1: the pose has not changed by a bit for 1 s."""
    struct_size: int
    state: int
    error: int
    internal_error: int
    ticks: int
    late_ticks: int
    failed_ticks: int
    errors: int
    orders: int
    silent_ticks: int
    temperature: float
    longest_tick: float
    force: Any
    is_constant: int
    reserved: int
    _kinds_: ClassVar[dict[str, Any]] = {"state": HardwareState}
    _fields_ = [
        ("struct_size", c_uint32),
        ("state", c_int32),
        ("error", c_uint32),
        ("internal_error", c_int32),
        ("ticks", c_uint64),
        ("late_ticks", c_uint64),
        ("failed_ticks", c_uint64),
        ("errors", c_uint64),
        ("orders", c_uint64),
        ("silent_ticks", c_uint64),
        ("temperature", c_double),
        ("longest_tick", c_double),
        ("force", c_double * 3),
        ("is_constant", c_uint32),
        ("reserved", c_uint32),
    ]


class OpenhapticsStatus(NamedTuple):
    """What an arm went through. Fields as vbss_openhaptics_status says."""
    state: HardwareState
    error: int
    internal_error: int
    ticks: int
    late_ticks: int
    failed_ticks: int
    errors: int
    orders: int
    silent_ticks: int
    temperature: float
    longest_tick: float
    force: tuple[float, ...]
    is_constant: int


class vbss_nidaqmx_config(ctypes.Structure):
    """Which lines, and how. Fill it with vbss_nidaqmx_config_init, then change what you need.
    Texts are copied; a name has at most 127 bytes.

    handle_count: 1 or 2 (default).

    library: Path or name; NULL (default): `libnidaqmx.so.1` or, without it,
    `libnidaqmxbase.so`; `nicaiu.dll` on Windows. NI-DAQmx Base is recognised by its functions.
    It needs all lines on one port, such as `Dev1/port0/line0` and `Dev1/port0/line1`, and the
    other lines of that port stay high.

    first_input: Analog input of the first handle; default `Dev1/ai0`.

    second_input: Of the second; default `Dev1/ai1`.

    first_line: Digital line of the first solenoid, NULL: there are no solenoids; default
    `Dev1/port0/line0`.

    second_line: Of the second; default `Dev1/port0/line1`.

    terminal: Default VBSS_NIDAQMX_SINGLE_ENDED.

    active_low: 1 (default): a low line lets the current flow, so that lines that nobody drives,
    which are pulled high, are off; 0: a high one.

    own_thread: 1 (default): a thread of the library moves the data; 0: the host calls
    vbss_nidaqmx_pump.

    low: Lowest voltage, V, -10 to 10; default -10.

    high: Highest voltage, above `low`, to 10; default 10.

    period: Time between two samples, s, 5e-4 to 1; default 0.002.

    timeout: Longest wait of a call for the hardware, s, 1e-3 to 10, or 0 (default): the library
    chooses it. It starts with 0.004 s, and doubles it up to 0.064 s while calls time out. A
    wait that the host chooses stays; the text of the handle's error says when it is too short."""
    struct_size: int
    handle_count: int
    library: Any
    first_input: Any
    second_input: Any
    first_line: Any
    second_line: Any
    terminal: int
    active_low: int
    own_thread: int
    reserved: int
    low: float
    high: float
    period: float
    timeout: float
    _kinds_: ClassVar[dict[str, Any]] = {"terminal": NidaqmxTerminal}
    _fields_ = [
        ("struct_size", c_uint32),
        ("handle_count", c_uint32),
        ("library", c_char_p),
        ("first_input", c_char_p),
        ("second_input", c_char_p),
        ("first_line", c_char_p),
        ("second_line", c_char_p),
        ("terminal", c_int32),
        ("active_low", c_uint32),
        ("own_thread", c_uint32),
        ("reserved", c_uint32),
        ("low", c_double),
        ("high", c_double),
        ("period", c_double),
        ("timeout", c_double),
    ]


class vbss_nidaqmx_status(ctypes.Structure):
    """What the lines went through.

    state: How they are. REFUSING: the last read failed, or the lines are being opened again
    after an error that passes; solenoids are off. LOST: an error that stays; the library opens
    the lines again when it can.

    error: What the vendor's library said last, its code; 0: nothing.

    solenoids: 1, 2: solenoids that are on.

    cycles: Rounds of write and read.

    failed_reads: Reads without a sample.

    failed_writes: Writes that were not taken.

    warnings: Calls that succeeded with a warning.

    silent_cycles: Rounds in which a solenoid was put off, as the host was silent.

    timeouts: Reads and writes that timed out.

    reopened: How often the lines were opened again after an error.

    late_rounds: Rounds at a pace at which a solenoid goes off later than its command expires.

    timeout: Longest wait of a call for the hardware, in force now, s.

    round_time: Time from round to round, mean of about the last 16, s.

    off_time: Longest time from the host's last command to a solenoid that is off, at that pace,
    s; 0: unknown. A command expires after vbss_output_result::expires, 10 ms by default; rounds
    above half of that are too slow for it."""
    struct_size: int
    state: int
    error: int
    solenoids: int
    cycles: int
    failed_reads: int
    failed_writes: int
    warnings: int
    silent_cycles: int
    timeouts: int
    reopened: int
    late_rounds: int
    timeout: float
    round_time: float
    off_time: float
    _kinds_: ClassVar[dict[str, Any]] = {"state": HardwareState}
    _fields_ = [
        ("struct_size", c_uint32),
        ("state", c_int32),
        ("error", c_int32),
        ("solenoids", c_uint32),
        ("cycles", c_uint64),
        ("failed_reads", c_uint64),
        ("failed_writes", c_uint64),
        ("warnings", c_uint64),
        ("silent_cycles", c_uint64),
        ("timeouts", c_uint64),
        ("reopened", c_uint64),
        ("late_rounds", c_uint64),
        ("timeout", c_double),
        ("round_time", c_double),
        ("off_time", c_double),
    ]


class NidaqmxStatus(NamedTuple):
    """What the lines went through. Fields as vbss_nidaqmx_status says."""
    state: HardwareState
    error: int
    solenoids: int
    cycles: int
    failed_reads: int
    failed_writes: int
    warnings: int
    silent_cycles: int
    timeouts: int
    reopened: int
    late_rounds: int
    timeout: float
    round_time: float
    off_time: float


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_openhaptics_config_init": (c_int32, (POINTER(vbss_openhaptics_config), c_uint32)),
    "vbss_openhaptics_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_openhaptics_config),
        POINTER(POINTER(vbss_openhaptics)))),
    "vbss_openhaptics_destroy": (c_int32, (POINTER(vbss_openhaptics),)),
    "vbss_openhaptics_get_adapter": (c_int32, (POINTER(vbss_openhaptics), c_uint32,
        POINTER(vbss_device_adapter))),
    "vbss_openhaptics_get_status": (c_int32, (POINTER(vbss_openhaptics), c_uint32,
        POINTER(vbss_openhaptics_status), c_uint32)),
    "vbss_openhaptics_get_identity": (c_int32, (POINTER(vbss_openhaptics), c_uint32,
        POINTER(c_char_p), POINTER(c_char_p))),
    "vbss_nidaqmx_config_init": (c_int32, (POINTER(vbss_nidaqmx_config), c_uint32)),
    "vbss_nidaqmx_create": (c_int32, (POINTER(vbss_context), POINTER(vbss_nidaqmx_config),
        POINTER(POINTER(vbss_nidaqmx)))),
    "vbss_nidaqmx_destroy": (c_int32, (POINTER(vbss_nidaqmx),)),
    "vbss_nidaqmx_get_adapter": (c_int32, (POINTER(vbss_nidaqmx), c_uint32,
        POINTER(vbss_device_adapter))),
    "vbss_nidaqmx_pump": (c_int32, (POINTER(vbss_nidaqmx), c_double)),
    "vbss_nidaqmx_get_status": (c_int32, (POINTER(vbss_nidaqmx), POINTER(vbss_nidaqmx_status),
        c_uint32)),
    "vbss_nidaqmx_list": (c_int32, (POINTER(vbss_context), c_char_p, POINTER(c_char), c_uint32)),
}
