"""Logs of scenes, and their replay."""
from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Optional, Sequence

from ._api.grasper import GrasperKind
from ._api.record import (ReplayOutcome, ReplayReport, vbss_record, vbss_record_config, vbss_replay, vbss_replay_info,
                          vbss_replay_report)
from ._api.scene import vbss_scene_config
from ._library import lib
from ._objects import Configured, Object, context_or_new, created
from ._values import constant, data_of, doubles, index, initialised, optional, settable
from .context import Context
from .scene import Scene
from .thread import attachment_of

__all__ = ["Record", "Replay", "ReplayOutcome", "ReplayReport"]


class Record(Configured, Object):
    """Writes the log of a scene, which is moved, pinned, cut and stepped by the record from then on.

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

    def take(self) -> bytes:
        """What the log has grown by since it was asked last: to be appended to a file."""
        data, count = ctypes.POINTER(ctypes.c_uint8)(), ctypes.c_uint64()
        with self._context._lock:
            self._call(lib.vbss_record_take, ctypes.byref(data), ctypes.byref(count))
            return ctypes.string_at(data, count.value)

    def step(self, h: float = 1e-3) -> None:
        """Steps the scene."""
        self._call(lib.vbss_record_step, h)

    def end(self) -> None:
        """Ends the log. Afterwards there is only take()."""
        self._call(lib.vbss_record_end)

    def move_rigid(self, body: int, position: Sequence[float], orientation: Optional[Sequence[float]] = None) -> None:
        self._call(lib.vbss_record_move_rigid, index(body), doubles(position, "position", 3),
                   optional(orientation, "orientation", 4))

    def move_grasper(self, body: int, position: Sequence[float],
                     orientation: Optional[Sequence[float]] = None) -> None:
        self._call(lib.vbss_record_move_grasper, index(body), doubles(position, "position", 3),
                   optional(orientation, "orientation", 4))

    def set_opening(self, body: int, opening: float) -> None:
        self._call(lib.vbss_record_set_opening, index(body), opening)

    def exchange(self, body: int, kind: Any) -> None:
        self._call(lib.vbss_record_exchange, index(body), constant(kind, GrasperKind, "kind"))

    def pin_thread(self, thread: int, node: int, body: int = 0, point: Optional[Sequence[float]] = None) -> int:
        pin = ctypes.c_uint32()
        self._call(lib.vbss_record_pin_thread, index(thread), index(node), index(body), optional(point, "point", 3),
                   ctypes.byref(pin))
        return pin.value

    def unpin_thread(self, pin: int) -> None:
        self._call(lib.vbss_record_unpin_thread, index(pin))

    def cut_thread(self, thread: int, arc_length: float) -> int:
        piece = ctypes.c_uint32()
        self._call(lib.vbss_record_cut_thread, index(thread), arc_length, ctypes.byref(piece))
        return piece.value

    def attach(self, thread: int, kind: Any = "pin", node: int = 0, **settings: Any) -> int:
        attachment = attachment_of(kind, {"node": node, **settings})
        name = ctypes.c_uint32()
        self._call(lib.vbss_record_attach, index(thread), ctypes.byref(attachment), ctypes.byref(name))
        return name.value

    def move_attachment(self, thread: int, attachment: int, target: Sequence[float],
                        direction: Optional[Sequence[float]] = None) -> None:
        self._call(lib.vbss_record_move_attachment, index(thread), index(attachment), doubles(target, "target", 3),
                   optional(direction, "direction", 3))

    def detach(self, thread: int, attachment: int) -> None:
        self._call(lib.vbss_record_detach, index(thread), index(attachment))


class Info(NamedTuple):
    """What a log says about itself."""
    library_version: int
    hash_interval: int
    snapshot_bytes: int
    log_bytes: int
    build_info: str
    note: bytes


class Replay(Object):
    """Reads a log. begin() brings a scene that was made like the recorded one to where the record began; step()
    does one step of it and compares hashes; run() does all."""
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
        return {name: value if isinstance(value, (int, float)) else tuple(value)
                for name in settable(vbss_scene_config) for value in [getattr(config, name)]}

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

    def step(self) -> ReplayReport:
        """Replays the next step and compares the hash."""
        return self._read("step", ReplayReport, vbss_replay_report)

    def run(self) -> ReplayReport:
        """Replays until the end, or the first step that differs."""
        while True:
            report = self.step()
            if report.outcome != ReplayOutcome.STEPPED:
                return report
