"""Arrays of the library: read-only and not copied.

With numpy they are numpy arrays; without it, memoryviews of numbers, and Rows of vectors. Each keeps the
memory it looks into alive. After a step, or an edit, it shows later numbers, or those of an earlier state (the
library changes between buffers), and after the destruction of its object the last ones: never freed memory.
Who wants to be told takes a View, which refuses once the object has changed."""
from __future__ import annotations

import ctypes
import operator
from typing import Any, Callable, Iterator

from ._api.base import ViewType, vbss_view
from ._memory import Memory
from ._values import numpy
from .errors import StaleViewError

Array = Any
"""A read-only numpy array; where numpy is not installed a memoryview, or Rows."""


class Rows:
    """Vectors in the memory of the library, where numpy is not installed: rows[i] is a tuple, rows[i, j] a number."""

    def __init__(self, memory: memoryview, count: int, components: int, stride: int) -> None:
        self.memory = memory
        self.shape = (count, components)
        self._stride = stride

    def __len__(self) -> int:
        return self.shape[0]

    def _row(self, number: int) -> tuple[Any, ...]:
        row = number + len(self) if number < 0 else number
        if not 0 <= row < len(self):
            raise IndexError(f"row {number} of {len(self)}")
        return tuple(self.memory[row * self._stride:row * self._stride + self.shape[1]])

    def __getitem__(self, item: Any) -> Any:
        if isinstance(item, tuple):
            row, column = item
            return self._row(operator.index(row))[column]
        if isinstance(item, slice):
            return [self._row(row) for row in range(*item.indices(len(self)))]
        return self._row(operator.index(item))

    def __iter__(self) -> Iterator[tuple[Any, ...]]:
        return map(self._row, range(len(self)))

    def tolist(self) -> list[list[Any]]:
        """A copy."""
        return [list(row) for row in self]

    def __repr__(self) -> str:
        return f"<Rows {self.shape[0]} x {self.shape[1]}>"


def array_of(memory: Memory, view: vbss_view) -> Array:
    """What a view of the library describes."""
    size = 8 if view.type == ViewType.F64 else 4
    letter = {ViewType.F64: "d", ViewType.U32: "I", ViewType.F32: "f"}[ViewType(view.type)]
    count, components, stride = view.count, view.components, view.stride_bytes
    used = (count - 1) * stride + components * size if count else 0
    data = memory.look(view.data, used) if count else memoryview(b"")
    np = numpy()
    if np is not None:
        kind = {"d": np.float64, "I": np.uint32, "f": np.float32}[letter]
        shape = (count,) if components == 1 else (count, components)
        if not count:
            empty = np.empty(shape, kind)
            empty.flags.writeable = False
            return empty
        if stride == components * size:
            flat = np.frombuffer(data, kind)
            return flat if components == 1 else flat.reshape(shape)
        # Through frombuffer: of a bare memoryview numpy would take what is behind it, which can be written.
        raw = np.frombuffer(data, np.uint8)
        return np.ndarray(shape, kind, raw, 0, (stride,) if components == 1 else (stride, size))
    numbers = data.cast(letter)
    return numbers if components == 1 else Rows(numbers, count, components, stride // size)


class View:
    """One array of an object, as it was when the view was taken.

    `array` gives it as long as the object has not changed, and raises StaleViewError afterwards."""

    def __init__(self, look: Callable[[], tuple[vbss_view, Array]], name: str) -> None:
        self._look = look
        self._name = name
        self.generation = look()[0].generation

    @property
    def is_current(self) -> bool:
        return bool(self._look()[0].generation == self.generation)

    @property
    def array(self) -> Array:
        view, array = self._look()
        if view.generation != self.generation:
            raise StaleViewError(f"{self._name} has changed since the view was taken (generation {self.generation}, "
                                 f"now {view.generation}): take a new one")
        return array

    def __len__(self) -> int:
        return len(self.array)

    def __getitem__(self, item: Any) -> Any:
        return self.array[item]

    def tolist(self) -> list[Any]:
        """A copy."""
        return list(self.array.tolist())

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        array = self.array
        return array if dtype is None else array.astype(dtype)

    def __repr__(self) -> str:
        return f"<View of {self._name}, generation {self.generation}>"


def empty_view() -> tuple[vbss_view, int]:
    view = vbss_view()
    return view, ctypes.sizeof(view)
