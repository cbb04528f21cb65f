"""The suturing task over a scene."""
from __future__ import annotations

import ctypes
from typing import Any, Callable, Optional, Sequence

from ._api.session import (SessionAidBits, SessionEvent, SessionEventKind, SessionExercise, SessionFailure, SessionPhase, SessionStage, SessionStatus,
                           vbss_session, vbss_session_config, vbss_session_event, vbss_session_event_fn,
                           vbss_session_status)
from ._api.session_assistance import vbss_session_assistance, vbss_session_hand
from ._api.session_coaching import (SessionCoaching, SessionGeometryBits, SessionGoal, SessionMistake,
                                    vbss_session_coaching)
from ._api.session_exercise import (SessionExerciseState, SessionMeasure, SessionMeasureKind, SessionOutcome,
                                    vbss_session_exercise_state, vbss_session_measure)
from ._library import lib
from ._objects import Configured, Object, Saved, again, created
from ._values import initialised, integer, value_of
from .devices import Device
from .knots import KnotDetector
from .metrics import Metrics
from .records import Record, Replay
from .scene import Scene

__all__ = ["Session", "SessionAidBits", "SessionCoaching", "SessionEvent", "SessionEventKind", "SessionExercise", "SessionExerciseState",
           "SessionFailure", "SessionGeometryBits", "SessionGoal", "SessionMeasure", "SessionMeasureKind", "SessionMistake",
           "SessionPhase", "SessionStage", "SessionStatus", "SessionOutcome"]


def _handle_of(part: Any, kind: type[Object], name: str) -> Any:
    if part is None:
        return None
    if not isinstance(part, kind):
        raise TypeError(f"{name} is {type(part).__name__}, not a {kind.__name__}")
    if part.closed:
        part._refuse()
    return part._handle


class Session(Configured, Saved):
    """Runs the task on a scene: steps it, says how far it is, and tells what happened.

        thread, needle, drain, tools, shears  numbers of bodies, as Scene.add returned them
        devices                               of the left and the right hand; None: who moves the tools is up to you
        knots, metrics, record                a KnotDetector, Metrics and a Record of the scene; None: none
        replay                                a Replay that has begun with the scene, in the place of devices and record
        listen                                called with each SessionEvent; must not change anything

    Other keywords are the settings of vbss_session_config (Session.settings_help(), Session.defaults()).
    """
    _prefix, _noun = "vbss_session", "session"
    _config, _init = vbss_session_config, "vbss_session_config_init"

    def __init__(self, scene: Scene, *, devices: Sequence[Optional[Device]] = (None, None),
                 knots: Optional[KnotDetector] = None, metrics: Optional[Metrics] = None,
                 record: Optional[Record] = None, replay: Optional[Replay] = None,
                 listen: Optional[Callable[[SessionEvent], Any]] = None, **settings: Any) -> None:
        _handle_of(scene, Scene, "scene")
        config = initialised(vbss_session_config, lib.vbss_session_config_init, settings, "a session")
        if len(devices) != 2:
            raise ValueError(f"{len(devices)} devices are given, and there are two hands")
        for hand, device in enumerate(devices):
            config.devices[hand] = _handle_of(device, Device, "a device")
        config.knots = _handle_of(knots, KnotDetector, "knots")
        config.metrics = _handle_of(metrics, Metrics, "metrics")
        config.record = _handle_of(record, Record, "record")
        config.replay = _handle_of(replay, Replay, "replay")
        context = scene.context
        if listen is not None:
            function = listen

            def hear(user: Any, event: Any) -> None:
                context._guarded(None, lambda: function(value_of(SessionEvent, event.contents)))

            config.listen = self._listen = vbss_session_event_fn(hear)
        self._parts: tuple[Any, ...] = (scene, devices, knots, metrics, record, replay)  # they live as long as it does
        self._settings = {**settings, "knots": knots, "metrics": metrics, "listen": listen}
        self._has_devices = any(device is not None for device in devices)
        self._record, self._replay = record, replay
        super().__init__(context, created(context, vbss_session, lib.vbss_session_create, scene._handle,
                                          ctypes.byref(config)))

    def step(self, h: float = 1e-3, now: float = 0.0) -> None:
        """One step of the task: devices, scene, knots, metrics, forces out, record. now: the clock of the devices, s."""
        self._call(lib.vbss_session_step, now, h)

    def seek(self, step: int) -> None:
        """To after that step of the log that is followed, from the newest states in it; listeners hear nothing of the way."""
        self._call(lib.vbss_session_seek, integer(step, ctypes.c_uint64, "step"))

    def begin_at(self, state: Any) -> None:
        """Begins the task at the place that another session had reached, before the first step: the facts of its save()
        stay, and clock, events, metrics and exercise begin. Restore the scene first; set_record() comes after."""
        view = memoryview(state).cast("B")
        buffer = (ctypes.c_uint8 * len(view)).from_buffer_copy(view)
        self._call(lib.vbss_session_begin_at, buffer, len(view))

    def set_record(self, record: Optional[Record]) -> None:
        """Writes to this record from now on; a replay is left."""
        self._call(lib.vbss_session_set_record, _handle_of(record, Record, "record"))
        self._parts += (record,)
        self._record, self._replay = record, None

    def __reduce__(self) -> Any:
        """Copies of the scene, the knot detector and the metrics, with a session over them."""
        if self._has_devices or self._record is not None or self._replay is not None:
            raise TypeError("a session with devices, a record or a replay cannot be copied or pickled: make a session over a copy "
                            "of its scene, and restore() what save() of this one gives")
        return again, (type(self), (self._parts[0],), self._settings), self.save()

    def __setstate__(self, state: bytes) -> None:
        self.restore(state)

    @property
    def status(self) -> SessionStatus:
        """How far the task is. time is on the session clock, which runs with the hands: time_lost of it was left out,
        time_simulated was simulated; is_lossy: more than lost_share of it is lost."""
        return self._read("get_status", SessionStatus, vbss_session_status)

    @property
    def coaching(self) -> SessionCoaching:
        """The coach's goal with its geometry and distances, and the newest mistake; the session was made with coaching=1."""
        return self._read("get_coaching", SessionCoaching, vbss_session_coaching)

    @property
    def assistance(self) -> vbss_session_assistance:
        """A copy of the aids that are on, SessionAidBits, and their settings."""
        struct = vbss_session_assistance()
        self._call(lib.vbss_session_get_assistance, ctypes.byref(struct), ctypes.sizeof(struct))
        return struct

    def assist(self, aids: int, **settings: Any) -> None:
        """Switches aids on, SessionAidBits, and all others off, from the next step on; settings are those of
        vbss_session_assistance. A task in which an aid was on gets no score."""
        struct = initialised(vbss_session_assistance, lib.vbss_session_assistance_init, {"aids": aids, **settings},
                             "assistance")
        self._call(lib.vbss_session_set_assistance, ctypes.byref(struct))

    def move_hand(self, tool: int, position: Any, orientation: Any = (1.0, 0.0, 0.0, 0.0), opening: float = 0.0,
                  is_origin: bool = False) -> None:
        """Passes the pose of a hand (0 left, 1 right) for the next step, which moves its tool there as the aids permit."""
        struct = initialised(vbss_session_hand, lib.vbss_session_hand_init,
                             {"position": position, "orientation": orientation, "opening": opening,
                              "is_origin": int(is_origin)}, "the input of a hand")
        self._call(lib.vbss_session_move_hand, integer(tool, ctypes.c_int32, "tool"), ctypes.byref(struct))

    @property
    def exercise(self) -> SessionExerciseState:
        """The exercise that the session was made with (exercise=SessionExercise...), and its outcome."""
        return self._read("get_exercise", SessionExerciseState, vbss_session_exercise_state)

    @property
    def measures(self) -> list[SessionMeasure]:
        """The measures of the exercise with their pass marks; none without an exercise."""
        return [self._read("get_measure", SessionMeasure, vbss_session_measure, number)
                for number in range(self.exercise.measure_count)]

    @staticmethod
    def exercise_text(exercise: int) -> tuple[str, str]:
        """Name of an exercise, and its goal as a sentence."""
        return (lib.vbss_session_exercise_name(exercise).decode(), lib.vbss_session_exercise_string(exercise).decode())

    @staticmethod
    def mistake_text(mistake: int) -> tuple[str, str]:
        """A mistake of the coach as a sentence, and how to mend it."""
        return (lib.vbss_session_mistake_string(mistake).decode(), lib.vbss_session_remedy_string(mistake).decode())

    def event(self, number: int) -> SessionEvent:
        """The event of that index; NotFoundError when it is lost."""
        return self._read("get_event", SessionEvent, vbss_session_event, integer(number, ctypes.c_uint64, "number"))

    @property
    def events(self) -> list[SessionEvent]:
        """Those that are kept, the oldest first."""
        status = self.status
        return [self.event(number) for number in range(status.first_event, status.event_count)]

    def _describe(self) -> str:
        status = self.status
        phase = status.phase.name if isinstance(status.phase, SessionPhase) else status.phase
        lost = f", {status.time_lost:.3g} s of it lost" if status.is_lossy else ""
        return f"{phase} after {status.time:g} s{lost}, {status.throws} throws"
