"""Contexts: owners of all objects, their memory and their error texts."""
from __future__ import annotations

import atexit
import ctypes
import functools
import os
import sys
import threading
import weakref
from typing import Any, Callable, Optional

from ._api.base import (ContextStatistics, LogLevel, Result, vbss_context, vbss_context_config,
                        vbss_context_statistics, vbss_log_fn)
from ._library import lib
from ._memory import Memory
from ._values import fill, value_of
from .errors import InvalidHandleError, check, error_of

__all__ = ["Context", "LogLevel", "arithmetic_check", "build_info", "version"]

Log = Callable[[LogLevel, str], None]


def version() -> str:
    """Version of the library that is running, as Python packages write it: "1.0.0", or "1.0.0rc1" before a release."""
    return build_info().split()[1].replace("-", "")


def build_info() -> str:
    """How the library was built."""
    return str(lib.vbss_build_info().decode())


def arithmetic_check() -> None:
    """Raises ArithmeticModeError unless the calling thread rounds to nearest and keeps subnormal numbers. The library computes
    in its own mode; the answer concerns Python's arithmetic."""
    check(lib.vbss_arithmetic_check())


class Context:
    """Owner of objects. Objects that are made without one make one of their own.

    Contexts are independent: a scene each, and a Python thread each, run side by side, as calls let other
    threads run. Calls into one context wait for each other. To be closed, or used in `with`; otherwise it
    goes with its last object.

        log        called with a LogLevel and a text, on the thread that called the library
        log_level  least important level that is sent; default WARNING
    """

    def __init__(self, *, log: Optional[Log] = None, **settings: Any) -> None:
        self._handle: Any = None
        self._raised: Optional[BaseException] = None
        self._broken = False
        self._inherited = False  # by a forked child
        self._quiet = False
        self._dropped: list[tuple[Any, Any, Any]] = []
        self._lock = threading.RLock()
        self._memory = Memory()
        self._log = log
        self._settings = settings
        config = vbss_context_config()
        check(lib.vbss_context_config_init(ctypes.byref(config), ctypes.sizeof(config)))
        fill(config, settings, "a context")
        config.allocate, config.deallocate = self._memory.allocate_fn, self._memory.deallocate_fn
        if log is not None:
            # Not a bound method: the context would keep itself alive by what it hands out.
            itself = weakref.ref(self)
            self._log_fn = vbss_log_fn(lambda user, level, text: _write_log(itself(), level, text))
            config.log = self._log_fn
        handle = ctypes.POINTER(vbss_context)()
        with self._lock:
            status = lib.vbss_context_create(ctypes.byref(config), ctypes.byref(handle))
            if self._raised is not None or status:
                self._fail(status)
        self._handle = handle
        _alive.add(self)

    # ---- calls

    def _fail(self, status: int) -> None:
        """Raises what a callback raised, or what a status says."""
        error = None
        if status:
            text = ctypes.c_char_p()
            last = ctypes.c_int32()
            if self._handle is not None:
                lib.vbss_context_get_last_error(self._handle, ctypes.byref(last), ctypes.byref(text))
            told = last.value == status and text.value is not None
            error = error_of(status, (text.value or b"").decode(errors="replace") if told else "")
        raised, self._raised = self._raised, None
        if raised is not None:
            raise raised from error
        if error is not None:
            raise error

    def _call(self, function: Any, *arguments: Any) -> None:
        with self._lock:
            self._require()
            try:
                status = function(*arguments)
            except ctypes.ArgumentError as error:
                raise TypeError(str(error)) from None
            if status or self._raised is not None:
                self._fail(status)

    def _require(self) -> None:
        if self._handle is None:
            raise InvalidHandleError("the context is closed")
        if self._broken:
            raise InvalidHandleError("another thread was inside this context when the process was forked")

    def _guarded(self, default: Any, function: Callable[..., Any], *arguments: Any) -> Any:
        """Calls a function of the host from a callback; what it raises waits for the end of the outer call."""
        waiting, self._raised = self._raised, None
        try:
            result = function(*arguments)
        except BaseException as error:  # nothing may cross the library
            self._raised = waiting if waiting is not None else error
            return default
        self._raised = waiting
        return result

    def _drop(self, destroy: Any, handle: Any, kept: Any) -> None:
        """Takes over what lost its last reference: to be destroyed now, or when the context is free again. Nobody
        waits here, as references may go anywhere; what callbacks of it need is kept until then."""
        self._dropped.append((destroy, handle, kept))
        self._sweep()

    def _sweep(self) -> None:
        """Destroys what was dropped, unless somebody is inside the context."""
        if not self._dropped or not self._lock.acquire(blocking=False):
            return
        quiet, self._quiet = self._quiet, True  # one that is still in a scene is no error
        waiting, self._raised = self._raised, None
        try:
            for _ in range(len(self._dropped)):
                destroy, handle, kept = self._dropped.pop(0)
                if self._handle is not None and destroy(handle) == Result.ERROR_BUSY:
                    self._dropped.append((destroy, handle, kept))
                if self._raised is not None:  # by an adapter that was closed: nobody called for it
                    raised, self._raised = self._raised, None
                    sys.excepthook(type(raised), raised, raised.__traceback__)
        finally:
            self._quiet, self._raised = quiet, waiting
            self._lock.release()

    # ---- for hosts

    @property
    def closed(self) -> bool:
        return self._handle is None

    @property
    def last_error(self) -> tuple[int, str]:
        """Status and text of the last failure; (0, "") when nothing has failed yet."""
        status, text = ctypes.c_int32(), ctypes.c_char_p()
        self._call(lib.vbss_context_get_last_error, self._handle, ctypes.byref(status), ctypes.byref(text))
        return status.value, (text.value or b"").decode(errors="replace")

    @property
    def statistics(self) -> ContextStatistics:
        """Memory and objects."""
        numbers = vbss_context_statistics()
        self._call(lib.vbss_context_get_statistics, self._handle, ctypes.byref(numbers), ctypes.sizeof(numbers))
        return value_of(ContextStatistics, numbers)

    def close(self) -> None:
        """Destroys the context and every object in it. Arrays that are kept show what they showed last."""
        with self._lock:
            if self._handle is None:
                return
            self._require()
            status = lib.vbss_context_destroy(self._handle)
            if status:
                self._fail(status)
            self._handle = None
            self._dropped.clear()
            _alive.discard(self)
            self._fail(0)

    def __reduce__(self) -> Any:
        """A copy is a new context with the same settings; objects bring their states themselves."""
        self._require()
        return functools.partial(type(self), log=self._log, **self._settings), ()

    def __enter__(self) -> Context:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __del__(self) -> None:
        # An inherited one leaves devices alone; its memory goes all the same.
        if getattr(self, "_handle", None) is not None and not self._inherited:
            self.close()

    def __repr__(self) -> str:
        if self._handle is None:
            return "<Context, closed>"
        if self._broken:
            return "<Context, broken by a fork>"
        numbers = self.statistics
        return f"<Context, {numbers.objects_alive} objects, {numbers.bytes_allocated} bytes>"


def _write_log(context: Optional[Context], level: int, text: bytes) -> None:
    if context is not None and context._log is not None and not context._quiet:
        context._guarded(None, context._log, LogLevel(level), text.decode(errors="replace"))


_alive: weakref.WeakSet[Context] = weakref.WeakSet()


def _close_all() -> None:
    """Before the interpreter goes: adapters are still there to be closed."""
    for context in list(_alive):
        try:
            context.close()
        except BaseException:  # what an adapter raises keeps nobody from closing the others
            sys.excepthook(*sys.exc_info())


def _after_fork_in_child() -> None:
    """The child has a copy of every context; one that another thread was inside of is of no use. What the child does
    not close itself is not closed for it: the hardware of devices is the parent's."""
    for context in list(_alive):
        context._inherited = True
        if not context._lock.acquire(blocking=False):
            context._broken = True
        context._lock = threading.RLock()
    _alive.clear()


atexit.register(_close_all)
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork_in_child)
