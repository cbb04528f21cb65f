"""The whole task as an environment in the manner of Gymnasium: from the needle on the floor to the cut tails.

    from vblast_ss.suturing import ScriptedStitch, SutureEnvironment

    with SutureEnvironment(time_limit=20.0) as environment:
        policy = ScriptedStitch()
        observation, info = environment.reset(seed=1)
        over = False
        while not over and not policy.done:
            observation, reward, terminated, truncated, info = environment.step(policy(observation))
            over = terminated or truncated
    print(info["phase"], info["score"])

A drain with a slit and two marks, a needle with its thread on the floor, two graspers which hands move through devices,
a session that says how far the task is, and metrics. One throw alone, cheap enough for thousands: vblast_ss.environment.
Needs numpy. Equal seeds, options and actions give equal numbers."""
from __future__ import annotations

import json
import math
from typing import Any, Mapping, Optional

import numpy as np

from ._episode import Box, Episodes, register
from ._pull import ScriptedPull
from ._stitch import ScriptedStitch
from ._suture import LEFT, MAX_TIME, RIGHT, STEP, SutureScene, SutureTask
from ._suture_space import (ACTIONS, FIELDS, HIGH, JAWS, LOW, MOVE, ROTATE, SHEARS, SHOWN, SPEED, TURN, WIDTHS)
from ._values import constant
from .context import Context
from .devices import DeviceTool
from .environment import RandomHands
from .errors import Error
from .metrics import Metrics, MetricsFlagBits
from .records import Replay
from .sessions import Session, SessionEvent, SessionEventKind, SessionPhase

__all__ = ["ACTIONS", "Box", "EVENT_POINTS", "FIELDS", "HIGH", "JAWS", "LOW", "MOVE", "ROTATE", "RandomHands", "SHEARS",
           "SHOWN", "SPEED", "ScriptedPull", "ScriptedStitch", "SutureEnvironment", "SutureTask", "TURN", "played_back",
           "scene_of_note"]

EVENT_POINTS = {"taken": 5.0, "threaded": 10.0, "tail": 10.0, "throw": 20.0, "seated": 20.0, "transfer": 10.0,
                "cut": 10.0, "stray": -10.0, "fault": -10.0}
"""What events are worth; given back when they are undone."""


class SutureEnvironment(Episodes):
    """Make a stitch: needle, drain, thread, two tools.

        time_limit    s simulated, after which an episode is truncated
        control       steps of 1 ms between actions
        phase_points  what each further phase of the session is worth, in points of the metrics' score
        event_points  what events of the session are worth, by name; default EVENT_POINTS
        record        keep a log of the episode (take_log())
        render_mode   "rgb_array": render() returns a picture; "human": a window, by pygame

    reset(options=...) takes fields of SutureTask, such as segments or tremor. Rewards are changes of the metrics' score (a
    point a second, five a needle dropped, deviations, gap), of the phase, and of events that stand. An episode is terminated
    when the task is done or failed, as the session has it, or when the simulation fails (info["error"]).
    """

    def __init__(self, *, time_limit: float = 120.0, control: int = 10, phase_points: float = 50.0,
                 event_points: Optional[Mapping[str, float]] = None, record: bool = False,
                 render_mode: Optional[str] = None) -> None:
        super().__init__(time_limit, control, record, ACTIONS, sum(WIDTHS.values()), render_mode)
        self.phase_points = phase_points
        points = EVENT_POINTS if event_points is None else event_points
        self._points = {SessionEventKind(constant(name, SessionEventKind, "an event")): value
                        for name, value in points.items()}

    # ---- an episode

    def reset(self, *, seed: Optional[int] = None,
              options: Optional[Mapping[str, Any]] = None) -> tuple[Any, dict[str, Any]]:
        """Begins anew; without a seed the next one of a series that the last seed began."""
        task = SutureTask(**self._fields(seed, options))
        self._end()
        duration = self.time_limit + 1.0  # of the metrics
        self._scene = SutureScene(task, duration=duration, record=self.recorded,
                                  note=json.dumps({"suture": {**task._asdict(), "duration": duration}}).encode())
        self._log, self._over, self._heard, self._phase = b"", False, 0, int(SessionPhase.LOADING)
        self._standing: set[tuple[SessionEventKind, int]] = set()
        self._worth = self._worth_now([])
        self._show()
        return self._observe(), self._info([])

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Both hands do something for `control` steps."""
        wanted = self._wanted(action).reshape(2, ACTIONS // 2)
        scene, seconds, error = self.scene, self.control * STEP, ""
        ways = []
        for tool, part in zip(scene.tools, wanted):
            tool.tool = DeviceTool.SHEARS if part[SHEARS] > 0.0 else DeviceTool.NEEDLE_DRIVER
            at = np.clip(tool.told.at + SPEED * seconds * part[MOVE], LOW, HIGH)
            ways.append((at - tool.told.at, TURN * seconds * part[ROTATE], 0.5 + 0.5 * float(part[JAWS])))
        try:
            self._log += scene.move((ways[LEFT], ways[RIGHT]), self.control)
        except Error as failure:  # of the simulation: the end of the episode, and data
            error = f"{type(failure).__name__}: {failure}"
        events = self._hear()
        worth = self._worth_now(events)
        reward, self._worth = worth - self._worth, worth
        terminated = bool(error) or scene.session.status.phase in (SessionPhase.DONE, SessionPhase.FAILED)
        truncated = not terminated and scene.time >= self.time_limit - 0.5 * STEP
        self._over = terminated or truncated
        info = self._info(events)
        if error:
            info["error"] = error
        self._show()
        return self._observe(), reward, terminated, truncated, info

    # ---- what happens

    def _hear(self) -> list[SessionEvent]:
        session, status = self.scene.session, self.scene.session.status
        events = [session.event(number) for number in range(max(self._heard, status.first_event), status.event_count)]
        self._heard = status.event_count
        return events

    def _worth_now(self, events: list[SessionEvent]) -> float:
        """Of all that stands: what is undone gives its points back."""
        for event in events:
            if event.kind in self._points:
                # A throw is told again as it is known better; two tools may hold the needle.
                told = (event.kind, event.tool if event.kind == SessionEventKind.TAKEN else event.number)
                (self._standing.discard if event.undone else self._standing.add)(told)
        phase, report = self.scene.session.status.phase, self.metrics.report
        if phase not in (SessionPhase.IDLE, SessionPhase.FAILED):  # which is no further than where it failed
            self._phase = int(phase)
        score = report.score if report.flags & MetricsFlagBits.STARTED else MAX_TIME  # the clock waits for the first step
        return score + self.phase_points * self._phase + math.fsum(self._points[kind] for kind, _ in self._standing)

    def _observe(self) -> Any:
        scene = self.scene
        status, tools = scene.session.status, scene.tools
        states = [tool.state for tool in tools]
        seen = np.empty(self.observation_space.shape)
        depths, points = scene.depths(), scene.thread.positions
        marks = scene.mark_places()
        for name, value in (
                ("time", scene.time), ("phase", status.phase), ("holder", status.holder),
                ("needle", np.concatenate(scene.needle_pose)), ("left", np.concatenate(tools[LEFT].told)),
                ("right", np.concatenate(tools[RIGHT].told)), ("jaws", [tool.opening for tool in tools]),
                ("left_force", states[LEFT].hand_force), ("right_force", states[RIGHT].hand_force),
                ("holds", [state.grasp_count > 0 for state in states]), ("left_mark", marks[LEFT]),
                ("right_mark", marks[RIGHT]), ("pierced", [depth is not None for depth in depths]),
                ("depth", [depth or 0.0 for depth in depths]),
                ("threaded", [status.threaded & 1, status.threaded >> 1 & 1]), ("gap", status.gap), ("tail", status.tail),
                ("throws", status.throws), ("seated", status.seated),
                ("thread", points[np.linspace(0, len(points) - 1, SHOWN).round().astype(int)].ravel())):
            seen[FIELDS[name]] = value
        return seen

    def _info(self, events: list[SessionEvent]) -> dict[str, Any]:
        scene, status = self.scene, self.scene.session.status
        return {"task": scene.task._asdict(), "time": scene.time, "steps": scene.steps, "phase": status.phase.name,
                "failure": status.failure.name, "events": events, "score": self.metrics.report.score,
                "deviation_mm": tuple(status.deviation_mm), "gap": status.gap, "tail": status.tail,
                "throws": status.throws, "seated": status.seated}

    # ---- for who wants more

    @property
    def scene(self) -> SutureScene:
        if self._scene is None:
            raise RuntimeError("there is no episode: reset()")
        scene: SutureScene = self._scene
        return scene

    @property
    def session(self) -> Session:
        return self.scene.session

    @property
    def metrics(self) -> Metrics:
        return self.scene.metrics


def _task_of(note: bytes) -> tuple[SutureTask, float]:
    fields: dict[str, Any] = json.loads(note)["suture"]
    duration = float(fields.pop("duration"))
    fields["place"] = tuple(fields["place"])
    return SutureTask(**fields), duration


def scene_of_note(note: bytes, context: Context) -> SutureScene:
    """A scene like that of a recorded episode, by the note in its log."""
    task, duration = _task_of(note)
    return SutureScene(task, duration=duration, context=context)


def played_back(log: bytes) -> SutureScene:
    """Scene, session and metrics as they were in the end of a recorded episode, found by making its steps again;
    CorruptError if these are others. To be closed."""
    context = Context()
    replay = Replay(log, context)
    task, duration = _task_of(replay.info.note)
    steps = replay.check()
    scene = SutureScene(task, duration=duration, context=context, replay=replay)
    for _ in range(steps):
        scene.session.step(STEP)
    scene.steps = steps
    return scene


register("vblast_ss/Suture-v0", f"{__name__}:SutureEnvironment")
