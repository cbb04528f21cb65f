"""What all objects of the library have in common."""
from __future__ import annotations

import copy
import ctypes
from typing import Any, ClassVar, Optional, TypeVar

from ._library import lib
from ._values import constant, defaults, value_of
from .context import Context
from .errors import Error, InvalidHandleError
from .views import Array, View, array_of, empty_view

O = TypeVar("O", bound="Object")
V = TypeVar("V")


class Object:
    """An object of a context. To be closed, or used in `with`; otherwise it goes with its last reference."""
    _prefix: ClassVar[str]
    _noun: ClassVar[str]

    def __init__(self, context: Context, handle: Any) -> None:
        self._context = context
        self._handle = handle

    def _function(self, name: str) -> Any:
        return getattr(lib, f"{self._prefix}_{name}")

    def _call(self, function: Any, *arguments: Any) -> None:
        """A function of the library that takes this object first."""
        context = self._context
        with context._lock:
            if self._handle is None or context._handle is None or context._broken:
                self._refuse()
            try:
                status = function(self._handle, *arguments)
            except ctypes.ArgumentError as error:
                raise TypeError(str(error)) from None
            if status or context._raised is not None:
                context._fail(status)
        if context._dropped:
            context._sweep()

    def _refuse(self) -> None:
        self._context._require()
        raise InvalidHandleError(f"the {self._noun} is closed")

    def _read(self, name: str, value_type: type[V], struct_type: Any, *arguments: Any) -> V:
        """A get function that fills a struct."""
        struct = struct_type()
        self._call(self._function(name), *arguments, ctypes.byref(struct), ctypes.sizeof(struct))
        return value_of(value_type, struct)

    @classmethod
    def _of(cls: type[O], context: Context, handle: Any) -> O:
        """The object of a handle that the library has made."""
        made = cls.__new__(cls)
        Object.__init__(made, context, handle)
        return made

    def __reduce__(self) -> Any:
        raise TypeError(f"a {self._noun} cannot be copied or pickled; scenes, sessions, metrics and knot detectors can")

    def __copy__(self: O) -> O:
        """A copy in the same context; copy.deepcopy makes one in a context of its own."""
        return copy.deepcopy(self, {id(self._context): self._context})

    @property
    def context(self) -> Context:
        return self._context

    @property
    def closed(self) -> bool:
        return self._handle is None or self._context.closed

    def close(self) -> None:
        """Destroys the object. Arrays of it that are kept show what they showed last."""
        if self._handle is not None and not self._context.closed:
            try:
                self._call(self._function("destroy"))
            except Error:
                raise
            except BaseException:  # of an adapter; the object is gone all the same
                self._handle = None
                raise
        self._handle = None

    def __enter__(self: O) -> O:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __del__(self) -> None:
        if vars(self).get("_handle") is not None and not self._context.closed and not self._context._inherited:
            kept = [value for name, value in vars(self).items() if name != "_context"]
            self._context._drop(self._function("destroy"), self._handle, kept)

    def _describe(self) -> str:
        return ""

    def __repr__(self) -> str:
        name = type(self).__name__
        if self.closed:
            return f"<{name}, closed>"
        try:
            about = self._describe()
        except Exception as error:
            about = f"({error})"
        return f"<{name} {about}>" if about else f"<{name}>"


def created(context: Context, struct: Any, function: Any, *arguments: Any) -> Any:
    """A new handle from a create function."""
    handle = ctypes.POINTER(struct)()
    context._sweep()
    context._call(function, *arguments, ctypes.byref(handle))
    return handle


def context_or_new(context: Optional[Context]) -> Context:
    if context is None:
        return Context()
    if not isinstance(context, Context):
        raise TypeError(f"context is {type(context).__name__}, not a Context")
    context._require()
    return context


def again(kind: Any, arguments: Any, keywords: Any) -> Any:
    """An object as it was made: how copies begin."""
    return kind(*arguments, **keywords)


class Configured:
    """Objects with settings."""
    _config: ClassVar[Any]
    _init: ClassVar[str]

    @classmethod
    def defaults(cls) -> dict[str, Any]:
        """Every setting that keywords may change, with its default."""
        return defaults(cls._config, getattr(lib, cls._init))

    @classmethod
    def settings_help(cls) -> str:
        """What each setting means, with unit and range."""
        return str(cls._config.__doc__)


class Body(Object):
    """Objects that can be in a scene."""

    def discard(self) -> None:
        """Closes the object; the library destroys it now, or when it leaves the scene that it belongs to."""
        self._call(self._function("discard"))
        self._handle = None

    def __reduce__(self) -> Any:
        raise TypeError(f"a {self._noun} cannot be copied or pickled alone; copy a scene that has it: body(number) of the "
                        "copy is its copy")


class Viewed(Object):
    """Objects with arrays."""
    _fields: ClassVar[Any]

    def _look(self, field: int) -> tuple[Any, Array]:
        view, size = empty_view()
        with self._context._lock:  # nothing is given back between the two
            self._call(self._function("get_view"), field, ctypes.byref(view), size)
            return view, array_of(self._context._memory, view)

    def _array(self, field: int) -> Array:
        return self._look(field)[1]

    def view(self, field: Any) -> View:
        """A view that knows when it has become old. The field by name or constant."""
        number = constant(field, self._fields, "field")
        name = self._fields(number).name.lower() if number in set(map(int, self._fields)) else str(number)
        return View(lambda: self._look(number), f"{self._noun}.{name}")


class Saved(Object):
    """Objects whose state can be saved, restored and hashed."""

    def save(self) -> bytes:
        """The state, to go back to it or to go on elsewhere to the same bits."""
        written = ctypes.c_uint64()
        function = self._function("save")
        with self._context._lock:
            if self._handle is None or self._context.closed or self._context._broken:
                self._refuse()
            function(self._handle, None, 0, ctypes.byref(written))
            buffer = (ctypes.c_uint8 * written.value)()
            self._call(function, buffer, written.value, ctypes.byref(written))
        return bytes(buffer)

    def restore(self, state: Any) -> None:
        """Goes to a state that was saved from this object, or one made alike. On failure nothing has changed."""
        view = memoryview(state).cast("B")
        buffer = (ctypes.c_uint8 * len(view)).from_buffer_copy(view)
        self._call(self._function("restore"), buffer, len(view))

    @property
    def state_hash(self) -> int:
        """XXH64 of the state: equal for equal states, on every machine."""
        number = ctypes.c_uint64()
        self._call(self._function("get_hash"), ctypes.byref(number))
        return number.value


class Remade(Configured, Saved):
    """Objects that settings and a saved state describe completely."""
    _settings: dict[str, Any]

    def __reduce__(self) -> Any:
        return again, (type(self), (self._context,), self._settings), self.save()

    def __setstate__(self, state: bytes) -> None:
        self.restore(state)
