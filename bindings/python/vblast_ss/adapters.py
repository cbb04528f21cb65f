"""Adapters: hardware, or what stands for it, written in Python."""
from __future__ import annotations

import ctypes
from typing import Any, Mapping, Optional

from ._api.base import Result
from ._api.adapter import (DeviceCapabilities, DeviceHasBits, DeviceSample, vbss_device_adapter,
                           vbss_device_capabilities, vbss_device_close_fn, vbss_device_describe_fn,
                           vbss_device_explain_fn, vbss_device_open_fn, vbss_device_read_fn, vbss_device_sample,
                           vbss_device_write_fn)
from ._api.output import OutputResult
from ._library import lib
from ._values import fill, initialised, value_of
from .context import Context

FAILED = int(Result.ERROR_DEVICE)
SIGNALS = {bit.name.lower(): bit for bit in DeviceHasBits if bit.name}


class Adapter:
    """One piece of hardware. A class of the host's own: it needs `read`, the rest may be missing.

        open(), close()     raise where the hardware cannot be opened
        describe()          a mapping with fields of DeviceCapabilities
        read(now)           at once: a mapping with fields of DeviceSample, of which those it holds are valid
                            (or `valid` says which), or None: there is no sample this time
        write(now, output)  at once: takes an OutputResult
        explain()           says in words what failed last

    All are called on the thread that calls the device. What they raise is raised by that call, after it has
    done its work: a read that raises counts as no sample.
    """
    name = "python"

    def read(self, now: float) -> Optional[Mapping[str, Any]]:
        raise NotImplementedError


def fill_sample(struct: Any, fields: Any) -> None:
    """Sets what a mapping or a DeviceSample holds."""
    given = dict(fields._asdict() if isinstance(fields, DeviceSample) else fields)
    if "valid" not in given:
        given["valid"] = sum(bit for name, bit in SIGNALS.items() if name in given)
    fill(struct, given, "a sample")


def sample_struct(fields: Any) -> vbss_device_sample:
    struct: vbss_device_sample = initialised(vbss_device_sample, lib.vbss_device_sample_init, {}, "a sample")
    fill_sample(struct, fields)
    return struct


def capabilities_struct(fields: Any) -> vbss_device_capabilities:
    given = fields._asdict() if isinstance(fields, DeviceCapabilities) else fields
    struct: vbss_device_capabilities = initialised(
        vbss_device_capabilities, lib.vbss_device_capabilities_init, given, "capabilities")
    return struct


class Table:
    """The functions of an adapter as C calls them; kept as long as the device."""

    def __init__(self, context: Context, adapter: Any) -> None:
        if not callable(getattr(adapter, "read", None)) and not callable(getattr(adapter, "write", None)):
            raise TypeError(f"{type(adapter).__name__} has neither read nor write: it is no adapter")
        self.context = context
        self.adapter = adapter
        self.struct = initialised(vbss_device_adapter, lib.vbss_device_adapter_init, {}, "an adapter")
        self.name = str(getattr(adapter, "name", type(adapter).__name__)).encode()[:31]
        self.struct.name = self.name
        # None of these may be collected while the device lives.
        self.functions = {
            "open": vbss_device_open_fn(self.open), "close": vbss_device_close_fn(self.close),
            "describe": vbss_device_describe_fn(self.describe), "read": vbss_device_read_fn(self.read),
            "write": vbss_device_write_fn(self.write), "explain": vbss_device_explain_fn(self.explain)}
        for name, function in self.functions.items():
            if callable(getattr(adapter, name, None)):
                setattr(self.struct, name, function)

    def open(self, user: Any) -> int:
        def work() -> int:
            self.adapter.open()
            return 0
        return int(self.context._guarded(FAILED, work))

    def close(self, user: Any) -> None:
        self.context._guarded(None, self.adapter.close)

    def describe(self, user: Any, capabilities: Any) -> int:
        def work() -> int:
            fill(capabilities.contents, dict(self.adapter.describe()), "capabilities")
            return 0
        return int(self.context._guarded(FAILED, work))

    def read(self, user: Any, now: float, sample: Any) -> int:
        def work() -> int:
            fields = self.adapter.read(now)
            if fields is None:
                return FAILED
            fill_sample(sample.contents, fields)
            return 0
        return int(self.context._guarded(FAILED, work))

    def write(self, user: Any, now: float, output: Any) -> int:
        def work() -> int:
            self.adapter.write(now, value_of(OutputResult, output.contents))
            return 0
        return int(self.context._guarded(FAILED, work))

    def explain(self, user: Any, text: Any, size: int) -> None:
        def work() -> None:
            words = str(self.adapter.explain()).encode()[:max(0, size - 1)]
            words = words.decode(errors="ignore").encode() + b"\0"  # no character cut in two
            ctypes.memmove(text, words, len(words))
        if size:
            self.context._guarded(None, work)
