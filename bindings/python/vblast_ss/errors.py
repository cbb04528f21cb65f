"""Exceptions: one for each status of the library, all of them Error.

Where Python has an exception of the same meaning the class is one of these too, so that a value out of
range is a ValueError. `status` is the number, `text` what the context says about this very call."""
from __future__ import annotations

from ._api.base import Result
from ._library import lib

__all__ = ["Error", "NullArgumentError", "OutOfRangeError", "NotFiniteError", "StructSizeError",
           "UnknownFieldError", "InvalidHandleError", "OutOfMemoryError", "CapacityError", "BusyError",
           "ArithmeticModeError", "TruncatedError", "CorruptError", "DataVersionError", "InSceneError",
           "DeviceError", "ClockStoppedError", "ClockJumpedError", "ClockCoarseError", "NotFoundError",
           "WrongStateError", "IncompatibleError", "InUseError", "StaleViewError"]


class Error(Exception):
    """A call of the library failed; nothing has changed by it."""
    status = 0

    def __init__(self, text: str = "", status: int = 0) -> None:
        self.status = status or self.status
        self.text = text or lib.vbss_result_string(self.status).decode()
        super().__init__(self.text)

    @property
    def name(self) -> str:
        """Of the status, such as "VBSS_ERROR_CAPACITY"."""
        return str(lib.vbss_result_name(self.status).decode())


class NullArgumentError(Error, TypeError):
    """Something that is needed was None."""
    status = Result.ERROR_NULL_ARGUMENT


class OutOfRangeError(Error, ValueError):
    """An argument is outside its range."""
    status = Result.ERROR_OUT_OF_RANGE


class NotFiniteError(Error, ValueError):
    """An argument, or the state after the step, is NaN or infinite."""
    status = Result.ERROR_NOT_FINITE


class StructSizeError(Error):
    """A struct has a size that it never had: package and library do not fit."""
    status = Result.ERROR_STRUCT_SIZE


class UnknownFieldError(Error):
    """The library is older than what is asked of it."""
    status = Result.ERROR_UNKNOWN_FIELD


class InvalidHandleError(Error, ReferenceError):
    """The object, or its context, is closed, or it belongs to another context."""
    status = Result.ERROR_INVALID_HANDLE


class OutOfMemoryError(Error, MemoryError):
    """No memory."""
    status = Result.ERROR_OUT_OF_MEMORY


class CapacityError(Error):
    """A capacity that was fixed at creation is exhausted."""
    status = Result.ERROR_CAPACITY


class BusyError(Error, RuntimeError):
    """Another thread, or the call whose callback this is, uses the context."""
    status = Result.ERROR_BUSY


class ArithmeticModeError(Error, ArithmeticError):
    """The thread does not round to nearest, or flushes subnormal numbers, and the library cannot set another mode."""
    status = Result.ERROR_ARITHMETIC_MODE


class TruncatedError(Error, ValueError):
    """The data end too early."""
    status = Result.ERROR_TRUNCATED


class CorruptError(Error, ValueError):
    """The data are damaged, or not what this call reads."""
    status = Result.ERROR_CORRUPT


class DataVersionError(Error, ValueError):
    """The data were written by a newer library."""
    status = Result.ERROR_DATA_VERSION


class InSceneError(Error, RuntimeError):
    """Not allowed while the object belongs to a scene."""
    status = Result.ERROR_IN_SCENE


class DeviceError(Error, RuntimeError):
    """A device failed, or is not there."""
    status = Result.ERROR_DEVICE


class ClockStoppedError(Error, RuntimeError):
    """The clock of a measurement does not advance."""
    status = Result.ERROR_CLOCK_STOPPED


class ClockJumpedError(Error, RuntimeError):
    """The clock of a measurement runs backwards or jumps."""
    status = Result.ERROR_CLOCK_JUMPED


class ClockCoarseError(Error, RuntimeError):
    """The clock of a measurement is too coarse."""
    status = Result.ERROR_CLOCK_COARSE


class NotFoundError(Error, LookupError):
    """The object, entry or step that an argument names does not exist."""
    status = Result.ERROR_NOT_FOUND


class WrongStateError(Error, RuntimeError):
    """The object is not in a state that allows the call."""
    status = Result.ERROR_WRONG_STATE


class IncompatibleError(Error, ValueError):
    """An object or a setting does not fit the others of the call."""
    status = Result.ERROR_INCOMPATIBLE


class InUseError(Error, RuntimeError):
    """Something else already uses what an argument names."""
    status = Result.ERROR_IN_USE


class StaleViewError(Error, RuntimeError):
    """The object was stepped or changed since the view was taken."""


_BY_STATUS: dict[int, type[Error]] = {
    int(kind.status): kind for kind in Error.__subclasses__() if kind.status}


def error_of(status: int, text: str = "") -> Error:
    """The exception for a status."""
    return _BY_STATUS.get(status, Error)(text, status)


def check(status: int) -> None:
    """Raises for a failed call that belongs to no context."""
    if status:
        raise error_of(status)
