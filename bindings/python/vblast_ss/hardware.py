"""Real hardware: haptic arms by OpenHaptics, handles and solenoids by NI-DAQmx, loaded at run time."""
from __future__ import annotations

import ctypes
from typing import Any, Mapping, Optional

from ._api.adapter import vbss_device_adapter
from ._api.haptics import (HapticsState, NidaqmxStatus, NidaqmxTerminal, OpenhapticsStatus, vbss_nidaqmx,
                           vbss_nidaqmx_config, vbss_nidaqmx_status, vbss_openhaptics, vbss_openhaptics_config,
                           vbss_openhaptics_status)
from ._library import lib
from ._objects import Configured, Object, context_or_new, created
from ._values import fill, index, initialised
from .context import Context

__all__ = ["HapticsState", "Nidaqmx", "NidaqmxStatus", "NidaqmxTerminal", "Openhaptics", "OpenhapticsStatus",
           "nidaqmx_devices"]


def _configured(struct_type: Any, function: Any, settings: Mapping[str, Any], noun: str) -> Any:
    """Names and paths are texts, or None where the library allows it; all else as everywhere."""
    struct = initialised(struct_type, function, {}, noun)
    texts = {name for name, kind in struct_type._fields_ if kind is ctypes.c_char_p}
    for name in texts & set(settings):
        setattr(struct, name, None if settings[name] is None else str(settings[name]).encode())
    fill(struct, {name: value for name, value in settings.items() if name not in texts}, noun)
    return struct


class Part:
    """One arm or one handle, for a device to stand on."""

    def __init__(self, whole: Object, which: int, name: str) -> None:
        self.whole = whole
        self.which = which
        self.name = name

    @property
    def context(self) -> Context:
        return self.whole.context

    def _adapter(self) -> vbss_device_adapter:
        table: vbss_device_adapter = initialised(vbss_device_adapter, lib.vbss_device_adapter_init, {}, "an adapter")
        self.whole._call(self.whole._function("get_adapter"), index(self.which), ctypes.byref(table))
        return table


class Openhaptics(Configured, Object):
    """One or two haptic arms under one servo. Keywords are the settings of vbss_openhaptics_config but for its
    function and limits: a host that steps in the servo's thread is no job for Python."""
    _prefix, _noun = "vbss_openhaptics", "haptic arms"
    _config, _init = vbss_openhaptics_config, "vbss_openhaptics_config_init"

    def __init__(self, context: Optional[Context] = None, **settings: Any) -> None:
        owner = context_or_new(context)
        config = _configured(vbss_openhaptics_config, lib.vbss_openhaptics_config_init, settings, "haptic arms")
        super().__init__(owner, created(owner, vbss_openhaptics, lib.vbss_openhaptics_create, owner._handle,
                                        ctypes.byref(config)))

    def arm(self, which: int = 0) -> Part:
        """An arm as the adapter of a device."""
        return Part(self, which, "haptic arm")

    def status(self, which: int = 0) -> OpenhapticsStatus:
        """How an arm is."""
        return self._read("get_status", OpenhapticsStatus, vbss_openhaptics_status, index(which))

    def identity(self, which: int = 0) -> tuple[str, str]:
        """Model and serial number."""
        model, serial = ctypes.c_char_p(), ctypes.c_char_p()
        with self._context._lock:
            self._call(lib.vbss_openhaptics_get_identity, index(which), ctypes.byref(model), ctypes.byref(serial))
            return (model.value or b"").decode(errors="replace"), (serial.value or b"").decode(errors="replace")

    def _describe(self) -> str:
        return f"{self.status().ticks} ticks"


class Nidaqmx(Configured, Object):
    """One or two handles: a potentiometer and a solenoid each. Keywords are the settings of vbss_nidaqmx_config."""
    _prefix, _noun = "vbss_nidaqmx", "handle lines"
    _config, _init = vbss_nidaqmx_config, "vbss_nidaqmx_config_init"

    def __init__(self, context: Optional[Context] = None, **settings: Any) -> None:
        owner = context_or_new(context)
        config = _configured(vbss_nidaqmx_config, lib.vbss_nidaqmx_config_init, settings, "handle lines")
        super().__init__(owner, created(owner, vbss_nidaqmx, lib.vbss_nidaqmx_create, owner._handle,
                                        ctypes.byref(config)))

    def handle(self, which: int = 0) -> Part:
        """A handle as the adapter of a device."""
        return Part(self, which, "handle")

    def poll(self, now: float) -> None:
        """One round in place of the library's thread (own_thread=0)."""
        self._call(lib.vbss_nidaqmx_poll, now)

    @property
    def status(self) -> NidaqmxStatus:
        """How the lines are."""
        return self._read("get_status", NidaqmxStatus, vbss_nidaqmx_status)

    def _describe(self) -> str:
        return f"{self.status.cycles} rounds"


def nidaqmx_devices(library: Optional[str] = None, context: Optional[Context] = None) -> list[tuple[str, str]]:
    """Name and product of each device that the vendor's driver knows."""
    owner = context_or_new(context)
    text = ctypes.create_string_buffer(4096)
    owner._call(lib.vbss_nidaqmx_list_devices, owner._handle, library.encode() if library else None, text,
                ctypes.sizeof(text))
    lines = text.value.decode(errors="replace").splitlines()
    return [(line.partition("  ")[0], line.partition("  ")[2]) for line in lines]
