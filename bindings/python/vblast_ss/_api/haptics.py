"""haptics.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_char, c_char_p, c_double, c_int32, c_uint32, c_uint64, c_void_p
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .adapter import vbss_device_adapter
from .base import vbss_context
from .output import vbss_output_config


class HapticsState(IntEnum):
    """The constants of vbss_haptics_state."""
    WAITING = 0
    """There is no measurement yet."""
    RUNNING = 1
    """The hardware works."""
    REFUSING = 2
    """It measures, but accepts no forces for now: motors warm, force or speed too high."""
    UNCALIBRATED = 3
    """It accepts no forces until it is calibrated: put the stylus into the inkwell. An arm whose
    pose has been constant to the bit for 1 s is in this state, too: it is uncalibrated, its
    encoders give no data, or no hand holds it. It accepts forces again when its pose changes."""
    LOST = 4
    """The hardware is missing: unplugged, or its driver has failed."""


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


# A function of the host that the vendor's servo thread calls at the end of each tick, after it
# has applied the forces. A host can step its scene here; the new forces are applied in the next
# tick. From the first call to the return of vbss_openhaptics_destroy only this function may use
# the context of the devices. It must not destroy the arms and must not wait.
vbss_openhaptics_tick_fn = CFUNCTYPE(None, c_void_p, c_double)


class vbss_openhaptics_config(ctypes.Structure):
    """Configuration of the arms. Fill it with vbss_openhaptics_config_init, then change fields.
    The library copies the texts.

    device_count: Number of arms, 1 (default) or 2.

    rate: Rate of the servo, Hz, 100 to 8000; default 1000. The vendor accepts 500, 1000 and
    2000, and other rates for some arms.

    library: Path or name of the vendor's library; NULL (default): `libHD.so`, `libHD.so.3.4` or
    `libHD.so.3.0`; `hd.dll`; or `libHD.dylib`.

    first_name: Name of the first arm in the vendor's set-up; NULL (default): its default
    device, or the one called `Default Device` or `Default PHANToM`.

    second_name: Name of the second arm in the vendor's set-up; default `Device2`.

    output: Limits of the output stage in the servo, lowered to the limits that the arms report;
    NULL (default): the initialised ones. The library copies them.

    tick: Function called in each tick; NULL (default): the host steps in its own thread.

    user: Pointer that `tick` receives; may be NULL."""
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
    """Status and counts of an arm.

    state: State of the arm.

    error: Last error code of the vendor's library for this arm; 0: none.

    internal_error: The vendor's internal number of that error.

    ticks: Number of ticks of the servo.

    late_ticks: Ticks that began later than one tick length after the tick before.

    failed_ticks: Ticks without a pose.

    errors: Errors that the vendor's library reported for this arm.

    orders: Outputs of the host that the servo has received.

    silent_ticks: Ticks with forces ramped down because the host was silent.

    temperature: Temperature of the hottest motor, 0 to 1.

    longest_tick: Longest time from the beginning of a tick to the end of the library's work in
    it, s.

    force: Force last applied, in the device's frame, N.

    is_constant: 1: the pose has been constant to the bit for 1 s."""
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
    _kinds_: ClassVar[dict[str, Any]] = {"state": HapticsState}
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
    """Status and counts of an arm. Fields as vbss_openhaptics_status says."""
    state: HapticsState
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
    """Configuration of the lines. Fill it with vbss_nidaqmx_config_init, then change fields. The
    library copies the texts; a name has at most 127 bytes.

    handle_count: Number of handles, 1 or 2 (default).

    library: Path or name of the vendor's library; NULL (default): `libnidaqmx.so.1` or, without
    it, `libnidaqmxbase.so`; `nicaiu.dll` on Windows. NI-DAQmx Base is recognised by its
    functions. It needs all lines on one port, such as `Dev1/port0/line0` and
    `Dev1/port0/line1`, and the other lines of that port stay high.

    first_input: Analog input of the first handle; default `Dev1/ai0`.

    second_input: Analog input of the second handle; default `Dev1/ai1`.

    first_line: Digital line of the first solenoid; NULL: there are no solenoids; default
    `Dev1/port0/line0`.

    second_line: Digital line of the second solenoid; default `Dev1/port0/line1`.

    terminal: Wiring of the potentiometers; default VBSS_NIDAQMX_TERMINAL_SINGLE_ENDED.

    active_low: 1 (default): a low line switches the solenoid's current on, so undriven lines,
    which are pulled high, keep it off. 0: a high line switches it on.

    own_thread: 1 (default): a thread of the library moves the data; 0: the host calls
    vbss_nidaqmx_poll.

    low: Lowest input voltage, V, -10 to 10; default -10.

    high: Highest input voltage, V, above `low`, to 10; default 10.

    period: Time between two samples, s, 5e-4 to 1; default 0.002.

    timeout: Longest wait of a call for the hardware, s, 1e-3 to 10, or 0 (default): the library
    chooses it. It starts with 0.004 s and doubles the wait up to 0.064 s while calls time out.
    A wait that the host sets does not change; the error text of the handle reports when it is
    too short."""
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
    """Status and counts of the lines.

    state: State of the lines. REFUSING: the last read failed, or the lines are being reopened
    after a transient error; solenoids are off. LOST: a permanent error; the library reopens the
    lines when it can.

    error: Last error code of the vendor's library; 0: none.

    solenoids: Bits 1, 2: the first, the second solenoid is on.

    cycles: Rounds of one write and one read.

    failed_reads: Reads without a sample.

    failed_writes: Writes that failed.

    warnings: Calls that succeeded with a warning.

    silent_cycles: Rounds in which a solenoid was switched off because the host was silent.

    timeouts: Reads and writes that timed out.

    reopened: Times the lines were reopened after an error.

    late_rounds: Rounds so slow that a solenoid would switch off later than its command expires.

    timeout: Current longest wait of a call for the hardware, s.

    round_time: Time from round to round, mean over about the last 16 rounds, s.

    off_time: Longest time from the host's last command until a solenoid is off, at the current
    round time, s; 0: unknown. A command expires after vbss_output_result::expires, 10 ms by
    default; rounds longer than half of that are too slow."""
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
    _kinds_: ClassVar[dict[str, Any]] = {"state": HapticsState}
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
    """Status and counts of the lines. Fields as vbss_nidaqmx_status says."""
    state: HapticsState
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
    "vbss_nidaqmx_poll": (c_int32, (POINTER(vbss_nidaqmx), c_double)),
    "vbss_nidaqmx_get_status": (c_int32, (POINTER(vbss_nidaqmx), POINTER(vbss_nidaqmx_status),
        c_uint32)),
    "vbss_nidaqmx_list_devices": (c_int32, (POINTER(vbss_context), c_char_p, POINTER(c_char),
        c_uint32)),
}
