"""Haptic arms, handles and solenoids: devices, output stages alone, mocks, mouse, keyboard and gamepad."""
from __future__ import annotations

import ctypes
from typing import Any, Callable, Mapping, Optional, Sequence, Union

from ._api.adapter import (DeviceCapabilities, DeviceFlagBits, DeviceHasBits, DeviceOutBits, DeviceSample, DeviceTool,
                           vbss_device_adapter, vbss_device_capabilities, vbss_device_coupling, vbss_device_sample)
from ._api.device import (DeviceClock, DeviceEventBits, DeviceInput, DeviceStatistics, DeviceStatus, vbss_device,
                          vbss_device_calibration, vbss_device_config, vbss_device_input, vbss_device_statistics)
from ._api.mapping import MappingMouseBits, vbss_mapping_config
from ._api.mock import (MockFault, MockField, MockStatistics, vbss_mock, vbss_mock_config, vbss_mock_measure_fn,
                        vbss_mock_statistics)
from ._api.output import (OutputFlagBits, OutputResult, OutputStatistics, vbss_output, vbss_output_command,
                          vbss_output_config, vbss_output_result, vbss_output_statistics)
from ._library import lib
from ._objects import Configured, Object, Saved, Viewed, context_or_new, created
from ._values import constant, doubles, index, initialised, optional, value_of
from .adapters import Adapter, Table, capabilities_struct, fill_sample, sample_struct
from .context import Context
from .errors import check
from .hardware import Part
from .views import Array

__all__ = ["Adapter", "Device", "DeviceCapabilities", "DeviceClock", "DeviceEventBits", "DeviceFlagBits",
           "DeviceHasBits", "DeviceInput", "DeviceOutBits", "DeviceSample", "DeviceStatistics", "DeviceStatus",
           "DeviceTool", "MappingMouseBits", "Mock", "MockFault", "MockStatistics", "Output", "OutputFlagBits",
           "OutputResult", "OutputStatistics", "map_gamepad", "map_keyboard", "map_mouse"]

Fields = Union[Mapping[str, Any], DeviceSample]


def _command(fields: Mapping[str, Any]) -> vbss_output_command:
    struct: vbss_output_command = initialised(vbss_output_command, lib.vbss_output_command_init, fields, "a command")
    return struct


def _calibration(fields: Optional[Mapping[str, Any]]) -> Any:
    return None if fields is None else initialised(
        vbss_device_calibration, lib.vbss_device_calibration_init, fields, "a calibration")


def _limits(fields: Mapping[str, Any]) -> vbss_output_config:
    struct: vbss_output_config = initialised(vbss_output_config, lib.vbss_output_config_init, fields,
                                             "an output stage")
    return struct


class Mock(Configured, Viewed):
    """An adapter without hardware.

        measure       called with a time, s; returns a mapping with fields of DeviceSample
        capabilities  a mapping with fields of DeviceCapabilities

    Other keywords are the settings of vbss_mock_config.
    """
    _prefix, _noun = "vbss_mock", "mock"
    _config, _init, _fields = vbss_mock_config, "vbss_mock_config_init", MockField

    def __init__(self, context: Optional[Context] = None, *, measure: Optional[Callable[[float], Fields]] = None,
                 capabilities: Optional[Mapping[str, Any]] = None, **settings: Any) -> None:
        owner = context_or_new(context)
        config = initialised(vbss_mock_config, lib.vbss_mock_config_init, settings, "a mock")
        if measure is not None:
            function = measure

            def fill(user: Any, time: float, sample: Any) -> None:
                def work() -> None:
                    fields = function(time)
                    given = dict(fields._asdict() if isinstance(fields, DeviceSample) else fields)
                    given.setdefault("time", time)
                    fill_sample(sample.contents, given)
                owner._guarded(None, work)

            self._measure = vbss_mock_measure_fn(fill)
            config.measure = self._measure
        if capabilities is not None:
            able = capabilities_struct(capabilities)
            config.capabilities = ctypes.pointer(able)
        super().__init__(owner, created(owner, vbss_mock, lib.vbss_mock_create, owner._handle,
                                          ctypes.byref(config)))

    def _adapter(self) -> vbss_device_adapter:
        table: vbss_device_adapter = initialised(vbss_device_adapter, lib.vbss_device_adapter_init, {}, "an adapter")
        self._call(lib.vbss_mock_get_adapter, ctypes.byref(table))
        return table

    def set_sample(self, **fields: Any) -> None:
        """The sample that is given from now on, wrong numbers too."""
        self._call(lib.vbss_mock_set_sample, ctypes.byref(sample_struct(fields)))

    def add_fault(self, fault: Any, start: float, until: float, value: float = 0.0) -> None:
        """Adds a fault, such as "stall" or "disconnect", from a time to another, s."""
        self._call(lib.vbss_mock_add_fault, constant(fault, MockFault, "fault"), start, until, value)

    def clear_faults(self) -> None:
        self._call(lib.vbss_mock_clear_faults)

    def clear_rows(self) -> None:
        """Forgets what was written."""
        self._call(lib.vbss_mock_clear_rows)

    @property
    def rows(self) -> Array:
        """n x 9: now, force, torque, solenoid, flags of each write."""
        return self._array(MockField.ROWS)

    @property
    def statistics(self) -> MockStatistics:
        return self._read("get_statistics", MockStatistics, vbss_mock_statistics)

    def _describe(self) -> str:
        figures = self.statistics
        return f"{'open' if figures.open else 'not open'}, {figures.reads} reads, {figures.writes} writes"


class Device(Configured, Saved):
    """One or two adapters, calibration, and the output stage.

        first, second  adapters: of Python (see Adapter), mocks, or parts of hardware (Openhaptics.arm, Nidaqmx.handle)
        calibration    a mapping with settings of vbss_device_calibration
        output         a mapping with limits of vbss_output_config

    Other keywords are the settings of vbss_device_config. What an adapter of Python raises is raised by the
    call during which it did.
    """
    _prefix, _noun = "vbss_device", "device"
    _config, _init = vbss_device_config, "vbss_device_config_init"

    def __init__(self, first: Any, second: Any = None, *, context: Optional[Context] = None,
                 calibration: Optional[Mapping[str, Any]] = None, output: Optional[Mapping[str, Any]] = None,
                 **settings: Any) -> None:
        if context is None and isinstance(first, (Mock, Part)):
            context = first.context
        context = context_or_new(context)
        self._adapters = (first, second)
        self._tables = [one if one is None or isinstance(one, (Mock, Part)) else Table(context, one)
                        for one in self._adapters]
        structs = [None if one is None else
                   ctypes.byref(one._adapter() if isinstance(one, (Mock, Part)) else one.struct)
                   for one in self._tables]
        config = initialised(vbss_device_config, lib.vbss_device_config_init, settings, "a device")
        if calibration is not None:
            config.calibration = ctypes.pointer(_calibration(calibration))
        if output is not None:
            config.output = ctypes.pointer(_limits(output))
        # Where a callback raises after the device was made, nobody else could destroy it.
        handle = ctypes.POINTER(vbss_device)()
        try:
            context._call(lib.vbss_device_create, context._handle, structs[0], structs[1], ctypes.byref(config),
                          ctypes.byref(handle))
        finally:
            super().__init__(context, handle if handle else None)

    def read(self, now: float) -> DeviceInput:
        """Reads each adapter once."""
        return self._read("read", DeviceInput, vbss_device_input, now)

    def write(self, now: float, **command: Any) -> OutputResult:
        """Writes a command (force, torque, solenoid, age, ...) through the output stage; without one the last
        grows old. Returns what went out."""
        result = vbss_output_result()
        given = ctypes.byref(_command(command)) if command else None
        self._call(lib.vbss_device_write, now, given, ctypes.byref(result), ctypes.sizeof(result))
        return value_of(OutputResult, result)

    def write_coupled(self, now: float, coupling: Mapping[str, Any], **command: Any) -> OutputResult:
        """Writes a command without a force, with that of a virtual coupling: position, velocity, force, stiffness,
        damping. Other forces are the coupling's `force`."""
        result = vbss_output_result()
        struct = initialised(vbss_device_coupling, lib.vbss_device_coupling_init, coupling, "a coupling")
        self._call(lib.vbss_device_write_coupled, now, ctypes.byref(_command(command)), ctypes.byref(struct),
                   ctypes.byref(result), ctypes.sizeof(result))
        return value_of(OutputResult, result)

    def latch_emergency_stop(self) -> None:
        """Emergency stop, at once, until release()."""
        self._call(lib.vbss_device_latch_emergency_stop)

    def clear_emergency_stop(self) -> None:
        """Lets the emergency stop go."""
        self._call(lib.vbss_device_clear_emergency_stop)

    def set_clutch(self, held: bool) -> None:
        """Holds or lets go the clutch."""
        self._call(lib.vbss_device_set_clutch, int(held))

    def hold_jaw(self, opening: float) -> None:
        """Holds the opening that reads report until the handle has passed it."""
        self._call(lib.vbss_device_hold_jaw, float(opening))

    def recentre(self, position: Optional[Sequence[float]] = None,
                 orientation: Optional[Sequence[float]] = None) -> None:
        """Shifts and turns the pose so that the last sample stands for a given one."""
        self._call(lib.vbss_device_recentre, optional(position, "position", 3),
                   optional(orientation, "orientation", 4))

    def set_calibration(self, **calibration: Any) -> None:
        """Calibrates anew, from the defaults on."""
        self._call(lib.vbss_device_set_calibration, ctypes.byref(_calibration(calibration)))

    def capabilities(self, which: int = 2) -> DeviceCapabilities:
        """What the hardware can do: 0, 1 the first or second adapter, 2 both within the limits."""
        return self._read("get_capabilities", DeviceCapabilities, vbss_device_capabilities, index(which))

    def error(self, which: int = 0) -> tuple[int, str]:
        """What failed last in an adapter: what its function returned, and what it said."""
        status, text = ctypes.c_int32(), ctypes.c_char_p()
        with self._context._lock:
            self._call(lib.vbss_device_get_error, index(which), ctypes.byref(status), ctypes.byref(text))
            return status.value, (text.value or b"").decode(errors="replace")

    @property
    def statistics(self) -> DeviceStatistics:
        """Figures of what came in."""
        return self._read("get_statistics", DeviceStatistics, vbss_device_statistics)

    @property
    def output_statistics(self) -> OutputStatistics:
        """Figures of the output stage."""
        return self._read("get_output_statistics", OutputStatistics, vbss_output_statistics)

    def _describe(self) -> str:
        figures = self.statistics
        names = " and ".join(repr(getattr(one, "name", type(one).__name__)) for one in self._adapters
                             if one is not None)
        return f"on {names}, {figures.reads} reads, {figures.writes} writes"


class Output(Configured, Object):
    """An output stage alone, for hosts with a device layer of their own. Keywords are the limits of
    vbss_output_config."""
    _prefix, _noun = "vbss_output", "output stage"
    _config, _init = vbss_output_config, "vbss_output_config_init"

    def __init__(self, context: Optional[Context] = None, **settings: Any) -> None:
        context = context_or_new(context)
        config = _limits(settings)
        super().__init__(context, created(context, vbss_output, lib.vbss_output_create, context._handle,
                                          ctypes.byref(config)))

    def step(self, h: float, **command: Any) -> OutputResult:
        """Puts a command through the stage, h seconds after the last; without one the last grows old."""
        result = vbss_output_result()
        given = ctypes.byref(_command(command)) if command else None
        self._call(lib.vbss_output_step, h, given, ctypes.byref(result), ctypes.sizeof(result))
        return value_of(OutputResult, result)

    def latch_emergency_stop(self) -> None:
        """Latches the emergency stop."""
        self._call(lib.vbss_output_latch_emergency_stop)

    def clear_emergency_stop(self) -> None:
        """Lets it go."""
        self._call(lib.vbss_output_clear_emergency_stop)

    @property
    def statistics(self) -> OutputStatistics:
        return self._read("get_statistics", OutputStatistics, vbss_output_statistics)

    def _describe(self) -> str:
        return f"{self.statistics.steps} steps"


# ---- mouse, keyboard and gamepad

def _mapped(function: Any, sample: Optional[Fields], settings: dict[str, Any], *arguments: Any) -> DeviceSample:
    config = initialised(vbss_mapping_config, lib.vbss_mapping_config_init, settings, "a mapping")
    struct: vbss_device_sample = sample_struct({} if sample is None else sample)
    check(function(ctypes.byref(config), *arguments, ctypes.byref(struct)))
    return value_of(DeviceSample, struct)


def map_mouse(sample: Optional[Fields], motion: Sequence[float], buttons: int = 0, h: float = 1e-3,
              **settings: Any) -> DeviceSample:
    """The sample moved by a mouse: counts to the right, up, notches of the wheel; MappingMouseBits."""
    return _mapped(lib.vbss_mapping_mouse, sample, settings, doubles(motion, "motion", 3), index(buttons), h)


def map_keyboard(sample: Optional[Fields], presses: Sequence[float], h: float = 1e-3, **settings: Any) -> DeviceSample:
    """The sample moved by presses of keys: right, up, towards the user, turns about these three, opening."""
    return _mapped(lib.vbss_mapping_keyboard, sample, settings, doubles(presses, "presses", 7), h)


def map_gamepad(sample: Optional[Fields], axes: Sequence[float], opening: float, h: float = 1e-3,
                **settings: Any) -> DeviceSample:
    """The sample moved by a gamepad: right, up, towards the user, turns about these three, -1 to 1."""
    return _mapped(lib.vbss_mapping_gamepad, sample, settings, doubles(axes, "axes", 6), opening, h)
