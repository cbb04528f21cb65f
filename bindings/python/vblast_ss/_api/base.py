"""base.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_char_p, c_int32, c_uint32, c_uint64, c_void_p
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

VBSS_VERSION_MAJOR = 1
VBSS_VERSION_MINOR = 0
VBSS_VERSION_PATCH = 0


class Result(IntEnum):
    """The constants of vbss_result, one for each row of VBSS_RESULTS."""
    OK = 0
    """success"""
    ERROR_NULL_ARGUMENT = -1
    """a required pointer is NULL"""
    ERROR_OUT_OF_RANGE = -2
    """an argument is outside its range"""
    ERROR_NOT_FINITE = -3
    """an argument is NaN or infinite"""
    ERROR_STRUCT_SIZE = -4
    """struct_size is no size that the struct has had or could have"""
    ERROR_UNKNOWN_FIELD = -5
    """a field unknown to this library version is not zero"""
    ERROR_INVALID_HANDLE = -6
    """the handle is NULL, destroyed or of another type"""
    ERROR_OUT_OF_MEMORY = -7
    """the allocator gave no usable block"""
    ERROR_CAPACITY = -8
    """a capacity fixed at creation or a given buffer is exhausted"""
    ERROR_BUSY = -9
    """another thread, or the caller of this callback, uses the context"""
    ERROR_ARITHMETIC_MODE = -10
    """rounding is not to nearest or subnormal numbers are flushed to zero"""
    ERROR_TRUNCATED = -11
    """the data end too early"""
    ERROR_CORRUPT = -12
    """the data are damaged or not what this call reads"""
    ERROR_DATA_VERSION = -13
    """the data were written by a newer version of the library"""
    ERROR_IN_SCENE = -14
    """not allowed while the object belongs to a scene"""
    ERROR_DEVICE = -15
    """a device failed, or is not there"""
    ERROR_CLOCK_STOPPED = -16
    """the host's clock does not advance"""
    ERROR_CLOCK_JUMPED = -17
    """the host's clock runs backwards or jumps"""
    ERROR_CLOCK_COARSE = -18
    """the host's clock is too coarse"""
    ERROR_NOT_FOUND = -19
    """the object, entry or step that an argument names does not exist"""
    ERROR_WRONG_STATE = -20
    """the object is not in a state that allows the call"""
    ERROR_INCOMPATIBLE = -21
    """an object or a setting does not fit the others of the call"""
    ERROR_IN_USE = -22
    """something else already uses what an argument names"""


class LogLevel(IntEnum):
    """The constants of vbss_log_level."""
    NONE = 0
    """As a limit: no messages at all."""
    ERROR = 1
    """A call failed; the message is its error text."""
    WARNING = 2
    """A setting is probably not the intended one."""
    INFO = 3
    """Rare milestones, such as the creation of a context."""


class Method(IntEnum):
    """The constants of vbss_method."""
    IMPLICIT = 0
    """The library's own method, the default."""
    VBLAST = 1
    """The method of VBLaST-SS (Qi et al. 2017), as a baseline."""


class ViewType(IntEnum):
    """The constants of vbss_view_type."""
    F64 = 1
    """double"""
    U32 = 2
    """uint32_t"""
    F32 = 3
    """float, of 32 bits; only in meshes for drawing"""


class vbss_context(ctypes.Structure):
    """Owner of all objects, their memory and their error texts. One thread at a time may use it;
    the library detects a second one (VBSS_ERROR_BUSY)."""


# Allocates memory for a context. The function must return (no longjmp, no exception). Its calls
# that would change the same context return VBSS_ERROR_BUSY.
vbss_allocate_fn = CFUNCTYPE(c_void_p, c_void_p, c_uint64, c_uint64)


# Releases a block of a vbss_allocate_fn. The function must return (no longjmp, no exception). Its
# calls that would change the same context return VBSS_ERROR_BUSY.
vbss_deallocate_fn = CFUNCTYPE(None, c_void_p, c_void_p, c_uint64, c_uint64)


# Receives log messages, on the thread that called the library. The function must return (no
# longjmp, no exception). Its calls that would change the same context return VBSS_ERROR_BUSY.
vbss_log_fn = CFUNCTYPE(None, c_void_p, c_int32, c_char_p)


class vbss_view(ctypes.Structure):
    """A read-only array inside the library. Item i starts `i * stride_bytes` after data and has
    `components` contiguous values of the type. It is valid until the next step, edit or
    destruction of its object; a step or an edit changes the generation.

    type: Type of each value.

    components: Number of values in an item, such as 3 for a vector.

    stride_bytes: Distance from one item to the next, bytes.

    count: Number of items.

    data: The first item; never NULL.

    generation: Number that changes with every step or edit of the object."""
    struct_size: int
    type: int
    components: int
    stride_bytes: int
    count: int
    data: Any
    generation: int
    _kinds_: ClassVar[dict[str, Any]] = {"type": ViewType}
    _fields_ = [
        ("struct_size", c_uint32),
        ("type", c_int32),
        ("components", c_uint32),
        ("stride_bytes", c_uint32),
        ("count", c_uint64),
        ("data", c_void_p),
        ("generation", c_uint64),
    ]


class vbss_context_config(ctypes.Structure):
    """Configuration of a context. Fill it with vbss_context_config_init, then change fields.

    log_level: Least important level that is sent; default VBSS_LOG_WARNING.

    allocate: Allocator; NULL (default): the C library; set both functions or neither.

    deallocate: Counterpart of allocate; NULL (default): the C library; set both functions or
    neither.

    allocator_user: Pointer that allocate and release receive; may be NULL.

    log: Function for log messages; NULL (default): messages are dropped.

    log_user: Pointer that log receives; may be NULL."""
    struct_size: int
    log_level: int
    allocate: Any
    deallocate: Any
    allocator_user: Any
    log: Any
    log_user: Any
    _kinds_: ClassVar[dict[str, Any]] = {"log_level": LogLevel}
    _fields_ = [
        ("struct_size", c_uint32),
        ("log_level", c_int32),
        ("allocate", vbss_allocate_fn),
        ("deallocate", vbss_deallocate_fn),
        ("allocator_user", c_void_p),
        ("log", vbss_log_fn),
        ("log_user", c_void_p),
    ]


class vbss_context_statistics(ctypes.Structure):
    """Memory and objects of a context.

    bytes_allocated: Memory currently allocated, bytes.

    bytes_peak: Largest value of bytes_allocated so far, bytes.

    allocation_count: Successful calls of the allocator so far.

    objects_alive: Objects created and not yet destroyed.

    objects_created: Objects created so far; the last creation ordinal."""
    struct_size: int
    reserved: int
    bytes_allocated: int
    bytes_peak: int
    allocation_count: int
    objects_alive: int
    objects_created: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("bytes_allocated", c_uint64),
        ("bytes_peak", c_uint64),
        ("allocation_count", c_uint64),
        ("objects_alive", c_uint64),
        ("objects_created", c_uint64),
    ]


class ContextStatistics(NamedTuple):
    """Memory and objects of a context. Fields as vbss_context_statistics says."""
    bytes_allocated: int
    bytes_peak: int
    allocation_count: int
    objects_alive: int
    objects_created: int


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_version": (c_uint32, ()),
    "vbss_build_info": (c_char_p, ()),
    "vbss_result_name": (c_char_p, (c_int32,)),
    "vbss_result_string": (c_char_p, (c_int32,)),
    "vbss_arithmetic_check": (c_int32, ()),
    "vbss_context_config_init": (c_int32, (POINTER(vbss_context_config), c_uint32)),
    "vbss_context_create": (c_int32, (POINTER(vbss_context_config),
        POINTER(POINTER(vbss_context)))),
    "vbss_context_destroy": (c_int32, (POINTER(vbss_context),)),
    "vbss_context_get_last_error": (c_int32, (POINTER(vbss_context), POINTER(c_int32),
        POINTER(c_char_p))),
    "vbss_context_get_statistics": (c_int32, (POINTER(vbss_context),
        POINTER(vbss_context_statistics), c_uint32)),
}
