"""Logs of scenes, and their replay."""
from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Optional, Sequence, Union

from ._api.base import Result
from ._api.record import (RecordEventKind, RecordInputKind, ReplayOutcome, ReplayReport, SceneSetting, vbss_record_input, vbss_record_log_report,
                          vbss_replay_logged_step, vbss_record, vbss_record_config, vbss_replay, vbss_replay_info, vbss_replay_report)
from ._api.scene import vbss_scene, vbss_scene_config
from ._library import lib
from ._objects import Configured, Object, context_or_new, created
from ._values import constant, constant_of, data_of, initialised, integer, settable
from .context import Context
from .scene import SceneEventKind, Scene

__all__ = ["RecordEventKind", "RecordInputKind", "LogFault", "LogInput", "LogReport", "LogStep", "LoggedEvent", "Record", "Replay", "ReplayOutcome",
           "ReplayReport", "SceneSetting", "check_log"]


class Record(Configured, Object):
    """Writes the log of a scene, once it is attached (attach_to_scene).

        note  bytes to be found in the log again, such as what the scene is made from

    Other keywords are the settings of vbss_record_config. take() hands out what the log has grown by.
    """
    _prefix, _noun = "vbss_record", "record"
    _config, _init = vbss_record_config, "vbss_record_config_init"

    def __init__(self, scene: Scene, *, note: bytes = b"", **settings: Any) -> None:
        if not isinstance(scene, Scene):
            raise TypeError(f"scene is {type(scene).__name__}, not a Scene")
        if "note_bytes" in settings:
            raise TypeError("a record has no setting 'note_bytes': give the note")
        config = initialised(vbss_record_config, lib.vbss_record_config_init, settings, "a record")
        text = data_of(note, "note")
        if len(text):
            config.note, config.note_bytes = ctypes.cast(text, ctypes.c_void_p), len(text)
        if scene.closed:
            scene._refuse()
        super().__init__(scene.context, created(scene.context, vbss_record, lib.vbss_record_create, scene._handle,
                                                ctypes.byref(config)))
        self._scene = scene

    @classmethod
    def resume(cls, replay: Replay, **settings: Any) -> tuple[Record, int]:
        """Goes on with the log of a replay that has begun, complete or cut off: brings its scene to the last complete
        step. Returns the record, and the byte at which what it takes is to be appended, where the log is cut off
        first. Settings that count: buffer_bytes, snapshot_interval."""
        if not isinstance(replay, Replay):
            raise TypeError(f"replay is {type(replay).__name__}, not a Replay")
        config = initialised(vbss_record_config, lib.vbss_record_config_init, settings, "a record")
        handle, position = ctypes.POINTER(vbss_record)(), ctypes.c_uint64()
        replay._call(lib.vbss_record_resume, ctypes.byref(config), ctypes.byref(handle), ctypes.byref(position))
        record = cls.__new__(cls)
        Object.__init__(record, replay.context, handle)
        assert replay._scene is not None  # it has begun
        record._scene = replay._scene
        return record, position.value

    def take(self) -> bytes:
        """What the log has grown by since it was asked last: to be appended to a file."""
        data, count = ctypes.POINTER(ctypes.c_uint8)(), ctypes.c_uint64()
        with self._context._lock:
            self._call(lib.vbss_record_take, ctypes.byref(data), ctypes.byref(count))
            return ctypes.string_at(data, count.value)

    def attach_to_scene(self) -> None:
        """From now on the record logs all edits and steps of its scene, made by functions of the scene and its
        bodies. end() and close() detach it, and detach_from_scene()."""
        self._scene._call(lib.vbss_scene_set_recorder, self._handle)

    def detach_from_scene(self) -> None:
        """Detaches the record that is attached to the scene."""
        self._scene._call(lib.vbss_scene_set_recorder, None)

    def end(self) -> None:
        """Ends the log. Afterwards there is only take()."""
        self._call(lib.vbss_record_end)

    def apply_input(self, kind: Any, words: Sequence[int] = (), numbers: Sequence[float] = ()) -> int:
        """Applies an input, such as one of another log (RecordInputKind says what its words and numbers are), and logs
        it, whether the record is attached or not; returns the number of a new pin, attachment or piece, or 0."""
        given, name = vbss_record_input(), ctypes.c_uint32()
        given.kind = constant(kind, RecordInputKind, "kind")
        if len(words) > len(given.words) or len(numbers) > len(given.numbers):
            raise ValueError("an input has at most 4 words and 12 numbers")
        given.words[:len(words)] = list(words)
        given.numbers[:len(numbers)] = list(numbers)
        self._call(lib.vbss_record_apply_input, ctypes.byref(given), ctypes.byref(name))
        return name.value


class Info(NamedTuple):
    """What a log says about itself."""
    library_version: int
    hash_interval: int
    snapshot_bytes: int
    log_bytes: int
    build_info: str
    note: bytes


class LogInput(NamedTuple):
    """What a host has told a scene; InputKind says what the words and numbers are."""
    kind: Union[RecordInputKind, int]
    words: tuple[int, ...]
    numbers: tuple[float, ...]


class LoggedEvent(NamedTuple):
    """An event as a log stores it: RecordEventKind says what number is."""
    kind: Union[RecordEventKind, SceneEventKind]
    body_a: int
    body_b: int
    number: int


def _logged_kind(kind: int) -> Any:
    return constant_of(RecordEventKind if kind in [int(own) for own in RecordEventKind] else SceneEventKind)(kind)


class LogStep(NamedTuple):
    """What a log says of a step: fields as in vbss_replay_logged_step; no hash: None."""
    number: int
    hash: Optional[int]
    position: int
    h: float
    time: float
    inputs: tuple[LogInput, ...]
    events: tuple[LoggedEvent, ...]


class LogFault(NamedTuple):
    """Something wrong in a log, and at which byte."""
    position: int
    result: Union[Result, int]
    problem: str


class LogReport(NamedTuple):
    """What is in a log, before its first fault, and the first eight of its faults: fields as in vbss_record_log_report."""
    result: Union[Result, int]
    ended: bool
    log_bytes: int
    good_bytes: int
    steps: int
    inputs: int
    events: int
    snapshots: int
    time: float
    fault_count: int
    faults: tuple[LogFault, ...]


def check_log(log: Any, context: Optional[Context] = None) -> LogReport:
    """Walks through all of a log, which may be any bytes, and says what is in it, what is wrong, and where."""
    context = context_or_new(context)
    data, found = data_of(log, "log"), vbss_record_log_report()
    context._call(lib.vbss_record_check_log, context._handle, data, len(data), ctypes.byref(found), ctypes.sizeof(found))
    result = constant_of(Result)
    faults = tuple(LogFault(position, result(status), (problem or b"").decode(errors="replace"))
                   for position, status, problem in zip(found.fault_positions, found.fault_results,
                                                        found.fault_problems))
    return LogReport(result(found.result), bool(found.ended), found.log_bytes, found.good_bytes, found.steps,
                     found.inputs, found.events, found.snapshots, found.time, found.fault_count,
                     faults[:found.fault_count])


def _settings_of(struct: Any) -> dict[str, Any]:
    """Keywords that set the fields of a struct as they are."""
    return {name: value if isinstance(value, (int, float)) else tuple(value)
            for name in settable(type(struct)) for value in [getattr(struct, name)]}


class Replay(Object):
    """Reads a log. begin() brings a scene that was made like the recorded one to where the record began; step()
    does one step of it and compares hashes; run() does all; seek() goes to any step. read() needs no scene."""
    _prefix, _noun = "vbss_replay", "replay"

    def __init__(self, log: Any, context: Optional[Context] = None) -> None:
        context = context_or_new(context)
        self._log = data_of(log, "log")  # stays as it is while the replay lives
        self._scene: Optional[Scene] = None
        super().__init__(context, created(context, vbss_replay, lib.vbss_replay_create, context._handle, self._log,
                                          len(self._log)))

    @property
    def info(self) -> Info:
        info = vbss_replay_info()
        with self._context._lock:
            self._call(lib.vbss_replay_get_info, ctypes.byref(info), ctypes.sizeof(info))
            return Info(info.library_version, info.hash_interval, info.snapshot_bytes, info.log_bytes,
                        (info.build_info or b"").decode(errors="replace"),
                        ctypes.string_at(info.note, info.note_bytes))

    @property
    def scene_settings(self) -> dict[str, Any]:
        """Keywords for a Scene like the recorded one."""
        config = initialised(vbss_scene_config, lib.vbss_scene_config_init, {}, "a scene")
        self._call(lib.vbss_replay_get_scene_config, ctypes.byref(config))
        return {**_settings_of(config), "baseline": _settings_of(config.baseline.contents),
                "solver": _settings_of(config.solver.contents)}

    def check(self) -> int:
        """Reads the log to its end without a scene; returns the steps in it."""
        steps = ctypes.c_uint64()
        self._call(lib.vbss_replay_check, ctypes.byref(steps))
        return steps.value

    def begin(self, scene: Scene) -> None:
        """Brings a scene of the same context to where the record began."""
        if not isinstance(scene, Scene):
            raise TypeError(f"scene is {type(scene).__name__}, not a Scene")
        if scene.closed:
            scene._refuse()
        self._call(lib.vbss_replay_begin, scene._handle)
        self._scene = scene

    def load_scene(self) -> Scene:
        """Makes the recorded scene from the log alone, and begins in it."""
        self._scene = Scene._of(self._context, created(self._context, vbss_scene, lib.vbss_replay_load_scene, self._handle))
        return self._scene

    def step(self) -> ReplayReport:
        """Replays the next step and compares the hash."""
        return self._read("step", ReplayReport, vbss_replay_report)

    def seek(self, step: int) -> ReplayReport:
        """Brings the scene to after a step, 0 for the begin; step() goes on from there."""
        return self._read("seek", ReplayReport, vbss_replay_report, integer(step, ctypes.c_uint64, "step"))

    def read(self, number: int) -> LogStep:
        """What the log says of a step, from 1 on; the replay stays where it is."""
        step, kind = vbss_replay_logged_step(), constant_of(RecordInputKind)
        with self._context._lock:  # the arrays are good until the next call
            self._call(lib.vbss_replay_read, integer(number, ctypes.c_uint64, "number"), ctypes.byref(step),
                       ctypes.sizeof(step))
            inputs = tuple(LogInput(kind(one.kind), tuple(one.words[:one.word_count]),
                                    tuple(one.numbers[:one.number_count])) for one in step.inputs[:step.input_count])
            words = step.events[:4 * step.event_count]
        events = tuple(LoggedEvent(_logged_kind(words[i]), *words[i + 1:i + 4]) for i in range(0, len(words), 4))
        return LogStep(step.number, step.hash if step.hashed else None, step.position, step.h, step.time, inputs, events)

    def run(self) -> ReplayReport:
        """Replays until the end, or the first step that differs."""
        while True:
            report = self.step()
            if report.outcome != ReplayOutcome.STEPPED:
                return report
