"""The memory of a context: blocks that Python owns.

An array that a caller keeps holds on to the very block it looks into. So when the library gives a block
back, because its object or the whole context is destroyed, the block goes away only with the last array:
until then the array shows frozen numbers, never freed memory."""
from __future__ import annotations

import bisect
import ctypes
from typing import Any

from ._api.base import vbss_allocate_fn, vbss_deallocate_fn


class Memory:
    """Blocks by address, and the two functions that a context asks."""

    def __init__(self) -> None:
        self.addresses: list[int] = []
        self.blocks: dict[int, Any] = {}  # address -> read-only memoryview from there to the block's end
        self.allocate_fn = vbss_allocate_fn(self.allocate)
        self.deallocate_fn = vbss_deallocate_fn(self.release)

    def allocate(self, user: Any, size: int, alignment: int) -> int | None:
        try:
            buffer = ctypes.create_string_buffer(size + alignment)
            begin = ctypes.addressof(buffer)
            address = -(-begin // alignment) * alignment
            view = memoryview(buffer).cast("B").toreadonly()
            self.blocks[address] = view[address - begin:address - begin + size]
            bisect.insort(self.addresses, address)
            return address
        except BaseException:  # it must return; None is "no memory"
            return None

    def release(self, user: Any, block: int, size: int, alignment: int) -> None:
        if self.blocks.pop(block, None) is not None:
            del self.addresses[bisect.bisect_left(self.addresses, block)]

    def look(self, address: int, size: int) -> Any:
        """A read-only memoryview of some bytes that keeps their block alive; a copy where they lie in none."""
        place = bisect.bisect_right(self.addresses, address) - 1
        if place >= 0:
            begin = self.addresses[place]
            block = self.blocks[begin]
            if address + size <= begin + len(block):
                return block[address - begin:address - begin + size]
        return memoryview(ctypes.string_at(address, size))
