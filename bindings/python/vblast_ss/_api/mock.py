"""mock.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_double, c_int32, c_uint32, c_uint64, c_void_p
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .adapter import vbss_device_adapter, vbss_device_capabilities, vbss_device_sample
from .base import vbss_context, vbss_view


class MockFault(IntEnum):
    """The constants of vbss_mock_fault; t0: start of the fault, v: its value."""
    NAN = 1
    """A NaN in the position (v = 0), orientation (1), velocity (2), jaw and jaw_raw (3), or time
    (4)."""
    STALL = 2
    """Each read repeats the sample of t0."""
    DISCONNECT = 3
    """Reads and writes fail, with VBSS_DEVICE_FLAG_LOST."""
    RATE = 4
    """Only one new sample every v s."""
    LATE = 5
    """Samples of v s ago."""
    SHUFFLE = 6
    """In every second interval of v s, samples of v s ago, so that their order is broken."""
    NORM = 7
    """Orientations of length v."""
    JUMP = 8
    """The x coordinate is larger by v m."""
    TEMPERATURE = 9
    """A temperature of v."""
    JAW = 10
    """A raw opening of v, like that of a broken wire."""
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


class vbss_mock(ctypes.Structure):
    """An adapter without hardware: driven by a function of time or by samples, with faults on
    demand."""


# Sample of a mock as a function of time.
vbss_mock_measure_fn = CFUNCTYPE(None, c_void_p, c_double, POINTER(vbss_device_sample))


class vbss_mock_config(ctypes.Structure):
    """Configuration of a mock. Fill it with vbss_mock_config_init, then change fields.

    fault_capacity: Largest number of faults, 0 to 4096; default 16.

    row_capacity: Largest number of stored rows, one for each write, 0 to 2^20; default 1024.

    measure: Function of time for samples; NULL (default): the sample of vbss_mock_set_sample.

    user: Argument of measure; may be NULL.

    capabilities: Capabilities; NULL (default): 6 and 3 degrees of freedom, 3.3 N, 400 N/m, 4 N
    s/m, 1 kHz, a box of 0.15 m, all signals and outputs. The library copies them."""
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
    """Counters of a mock.

    open: 1: the mock is open.

    opens: Number of calls that opened it.

    reads: Number of reads.

    writes: Number of writes, also those that failed.

    rows_lost: Rows beyond row_capacity."""
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
    """Counters of a mock. Fields as vbss_mock_statistics says."""
    open: int
    opens: int
    reads: int
    writes: int
    rows_lost: int


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_mock_config_init": (c_int32, (POINTER(vbss_mock_config), c_uint32)),
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
}
