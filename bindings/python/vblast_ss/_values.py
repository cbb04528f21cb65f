"""From Python to the structs and arrays of the C interface, and back."""
from __future__ import annotations

import ctypes
import operator
from typing import Any, Callable, Iterable, Mapping, Optional, TypeVar

from ._api.baseline import vbss_baseline_config
from ._api.solver_options import vbss_solver_options
from ._library import lib
from .errors import OutOfRangeError, check

V = TypeVar("V")

_LIMITS = {ctypes.c_int8: (-2**7, 2**7), ctypes.c_uint8: (0, 2**8), ctypes.c_int16: (-2**15, 2**15),
           ctypes.c_uint16: (0, 2**16), ctypes.c_int32: (-2**31, 2**31), ctypes.c_uint32: (0, 2**32),
           ctypes.c_int64: (-2**63, 2**63), ctypes.c_uint64: (0, 2**64)}
_NUMPY: list[Any] = []


def numpy() -> Any:
    """The numpy module, loaded when it is first wanted; None where it is not installed."""
    if not _NUMPY:
        try:
            import numpy as found
        except ImportError:
            _NUMPY.append(None)
        else:
            _NUMPY.append(found)
    return _NUMPY[0]


# ---- numbers and arrays in

def integer(value: Any, kind: Any, name: str) -> int:
    number = operator.index(value)
    low, high = _LIMITS[kind]
    if not low <= number < high:
        raise OutOfRangeError(f"{name} is {number}, from {low} to {high - 1} is allowed")
    return number


def index(value: Any, name: str = "number") -> int:
    """A number that C takes as uint32_t."""
    return integer(value, ctypes.c_uint32, name)


def constant(value: Any, kind: Any, name: str, number: Any = ctypes.c_int32) -> int:
    """A number of an enumeration, which may be given by name: "vblast" for Method.VBLAST."""
    if isinstance(value, str):
        key = value.strip().upper().replace(" ", "_").replace("-", "_")
        if key not in kind.__members__:
            raise OutOfRangeError(f"{name} is '{value}'; there are: "
                                  f"{', '.join(member.lower() for member in kind.__members__)}")
        return int(kind[key])
    return integer(value, number, name)


def _flat(values: Any) -> Iterable[Any]:
    for value in values:
        if isinstance(value, (str, bytes)):
            raise TypeError(f"{value!r} is no number")
        try:
            yield from _flat(value)
        except TypeError:
            if hasattr(value, "__iter__"):
                raise
            yield value


def numbers(values: Any, kind: Any, name: str, count: Optional[int] = None, row: int = 1) -> Any:
    """A ctypes array of the numbers in a sequence, of sequences or not, or in an array. Copied."""
    if values is None:
        raise TypeError(f"{name} is None")
    if isinstance(values, (str, bytes)):
        raise TypeError(f"{name} is a text")
    np = numpy() if hasattr(values, "__array__") else None
    if np is not None:
        values = np.asarray(values)
        if values.dtype.kind not in ("fiu" if kind is ctypes.c_double else "iu"):
            raise TypeError(f"{name} is an array of {values.dtype}")
        if kind is not ctypes.c_double and values.size and not 0 <= int(values.min()) <= int(values.max()) < 2**32:
            raise OutOfRangeError(f"{name} has numbers that are not from 0 to {2**32 - 1}")
        if row > 1 and values.ndim > 1 and values.size != row * values.shape[0]:
            raise ValueError(f"{name} has the shape {values.shape}, and rows of {row} are wanted")
        data = np.ascontiguousarray(values, dtype=np.float64 if kind is ctypes.c_double else np.uint32)
        found = data.size
        array = (kind * found)()
        ctypes.memmove(array, data.ctypes.data, data.nbytes)
    else:
        if row > 1:
            values = list(values)
            lengths = {len(list(_flat(value))) for value in values if hasattr(value, "__iter__")}
            if lengths - {row}:
                raise ValueError(f"{name} has a row of {max(lengths - {row})} numbers, and rows of {row} are wanted")
        listed = list(_flat(values))
        found = len(listed)
        if kind is ctypes.c_double:
            array = (kind * found)(*map(float, listed))
        else:
            array = (kind * found)(*(integer(value, kind, name) for value in listed))
    if count is not None and found != count:
        raise ValueError(f"{name} has {found} numbers, and {count} are wanted")
    if found % row:
        raise ValueError(f"{name} has {found} numbers, which are no rows of {row}")
    return array


def doubles(values: Any, name: str, count: Optional[int] = None, row: int = 1) -> Any:
    return numbers(values, ctypes.c_double, name, count, row)


def optional(values: Any, name: str, count: int) -> Any:
    return None if values is None else doubles(values, name, count)


def data_of(data: Any, name: str = "data") -> Any:
    """A ctypes array with a copy of some bytes."""
    view = memoryview(data).cast("B")
    return (ctypes.c_uint8 * len(view)).from_buffer_copy(view)


# ---- structs in

def settable(struct_type: Any) -> list[str]:
    """Fields that keywords may set: no pointers, which belong to a keyword of their own."""
    return [name for name, kind in struct_type._fields_
            if name != "struct_size" and not name.startswith("reserved") and
            (kind in _LIMITS or kind is ctypes.c_double or
             issubclass(kind, ctypes.Array) and not hasattr(kind._type_, "contents"))]


def _set_array(array: Any, values: Any, name: str) -> None:
    """Into an array of numbers, of rows of numbers too."""
    total = ctypes.sizeof(array)
    kind = array._type_
    while issubclass(kind, ctypes.Array):
        kind = kind._type_
    found = numbers(values, kind, name, total // ctypes.sizeof(kind)) if kind in (ctypes.c_double, ctypes.c_uint32) \
        else (kind * len(values))(*(integer(value, kind, name) for value in values))
    if ctypes.sizeof(found) != total:
        raise ValueError(f"{name} has {len(found)} numbers, and {total // ctypes.sizeof(kind)} are wanted")
    ctypes.memmove(array, found, total)


def fill(struct: Any, settings: Mapping[str, Any], noun: str) -> None:
    """Sets fields by name; an unknown one is a TypeError that says what there is."""
    fields = dict(struct._fields_)
    allowed = settable(type(struct))
    for name, value in settings.items():
        if name not in allowed:
            import difflib  # slow to load, and seldom wanted
            near = difflib.get_close_matches(name, allowed, 1)
            raise TypeError(f"{noun} has no setting '{name}'" + (f"; did you mean '{near[0]}'?" if near else ""))
        kind = fields[name]
        if value is None:
            raise TypeError(f"{name} is None")
        if name in struct._kinds_:
            setattr(struct, name, constant(value, struct._kinds_[name], name, kind))
        elif kind is ctypes.c_double:
            setattr(struct, name, float(value))
        elif kind in _LIMITS:
            setattr(struct, name, integer(value, kind, name))
        else:
            _set_array(getattr(struct, name), value, name)


def initialised(struct_type: Any, function: Any, settings: Mapping[str, Any], noun: str,
                prepare: Optional[Callable[[Any], None]] = None) -> Any:
    """A struct with the library's defaults, and what keywords say."""
    struct = struct_type()
    check(function(ctypes.byref(struct), ctypes.sizeof(struct)))
    if prepare is not None:
        prepare(struct)
    settings = dict(settings)
    for name, (nested_type, initialise, nested_noun) in _NESTED.items():
        if name in settings and hasattr(struct, name):
            nested = settings.pop(name)
            if not isinstance(nested, Mapping):
                raise TypeError(f"{name} is {type(nested).__name__}, not a mapping")
            setattr(struct, name, ctypes.pointer(initialised(nested_type, initialise, nested, nested_noun)))
    fill(struct, settings, noun)
    return struct


# Keywords that are mappings: structs to which a field of a configuration points.
_NESTED = {"baseline": (vbss_baseline_config, lib.vbss_baseline_config_init, "the baseline"),
           "solver": (vbss_solver_options, lib.vbss_solver_options_init, "the solver")}


def baseline_defaults() -> dict[str, Any]:
    """The parameters of the method "vblast", with their defaults: what the mapping ``baseline`` of a thread, a drain, a
    grasper, a scene or a collision may set."""
    return defaults(vbss_baseline_config, lib.vbss_baseline_config_init)


def solver_defaults() -> dict[str, Any]:
    """The options of a solver, with their defaults: what the mapping ``solver`` of a scene may set."""
    return defaults(vbss_solver_options, lib.vbss_solver_options_init)


# ---- structs out

def _number(value: Any) -> Any:
    return tuple(map(_number, value)) if isinstance(value, ctypes.Array) else value


def _text(value: Any) -> str:
    return (value or b"").decode(errors="replace")


def constant_of(kind: Any) -> Callable[[int], Any]:
    def convert(value: int) -> Any:
        try:
            return kind(value)
        except ValueError:  # of a newer library
            return value
    return convert


_PLANS: dict[Any, list[tuple[str, Any]]] = {}


def value_of(value_type: type[V], struct: Any) -> V:
    """A filled struct as the tuple with names that belongs to it."""
    plan = _PLANS.get(value_type)
    if plan is None:
        kinds = dict(struct._fields_)
        plan = _PLANS[value_type] = [
            (name, constant_of(struct._kinds_[name]) if name in struct._kinds_ else
             _number if issubclass(kinds[name], ctypes.Array) else
             _text if kinds[name] is ctypes.c_char_p else None)
            for name in value_type._fields]  # type: ignore[attr-defined]
    return value_type(*[getattr(struct, name) if convert is None else convert(getattr(struct, name))
                        for name, convert in plan])


def defaults(struct_type: Any, function: Any) -> dict[str, Any]:
    """Every setting with the library's default."""
    struct = initialised(struct_type, function, {}, "")
    return {name: constant_of(struct._kinds_[name])(getattr(struct, name)) if name in struct._kinds_
            else _number(getattr(struct, name)) for name in settable(struct_type)}
