"""The scene of the whole task: a drain with a slit on a floor, a needle that lies there with its thread, and two tools.

x right, y away, z up, the top of the drain at 0, its slit along y: as the scripted surgeon of examples/surgeon has it.
Tools are moved as hands move them: what is told is measured by a mock, read by a device, and brought to a grasper by
the session."""
from __future__ import annotations

import math
from typing import Any, NamedTuple, Optional

import numpy as np

from ._pose import Pose, Vector, dot, length, tremor, turn_by, turned, unit_rows
from ._objects import again
from .context import Context
from .devices import Device, DeviceTool, Mock
from .drain import Drain
from .elementary import cos, sin
from .grasper import Grasper, GrasperState
from .knots import KnotDetector
from .metrics import Metrics
from .needle import Needle
from .records import Record, Replay
from .scene import Scene
from .sessions import Session
from .thread import Thread

STEP = 1e-3  # s
TUBE, WALL = 6.5e-3, 1e-3  # of the drain: middle radius and thickness, m
CENTRE = -TUBE - 0.5 * WALL  # height of its axis
FLOOR = -2.0 * TUBE - WALL
NEEDLE_RADIUS, NEEDLE_ARC, WIRE = 10.5e-3, math.pi, 0.35e-3
THREAD = 0.15  # m
JAW = 0.25e-3  # radius of the right tool's: fine enough to take what lies flat on a floor
LEFT_JAW = 0.5e-3
NECK = 5e-3  # so that thread can be wound about a tool
STIFFNESS, DAMPING = 2000.0, 10.0  # of a coupling without an arm that would buzz, N/m and N s/m
JAW_SPEED = 8.0  # of a handle's opening, 1/s
CUTS = 4  # of the thread, at most
MAX_TIME = 600.0  # with which the score begins
LEFT, RIGHT = 0, 1


class SutureTask(NamedTuple):
    """What the task is done with. SI units; seed: of the hands' tremor and of where the needle lies."""
    seed: int = 0
    segments: int = 300
    """Of the thread. Knots want 0.5 mm each; 60 are enough for the needle's way."""
    tremor: float = 0.2e-3
    place: tuple[float, float] = (35e-3, -5e-3)
    """Where the needle lies on the floor."""
    scatter: float = 8e-3
    """Most that it lies beside that, on each axis."""
    turn_scatter: float = 0.8
    """Most that it is turned there, rad."""


class Tool:
    """What a hand tells its tool, and the way there."""

    def __init__(self, scene: Scene, context: Context, at: Vector, opening: float, shape: dict[str, Any],
                 phases: Vector) -> None:
        self.told = Pose(np.array(at), np.array((1.0, 0.0, 0.0, 0.0)))
        self.opening, self.tool = opening, DeviceTool.NEEDLE_DRIVER
        self.grasper = Grasper(context, stiffness=STIFFNESS, damping=DAMPING, driver_neck=NECK, **shape)
        self.grasper.set_target(self.told.at, self.told.q)
        self.grasper.set_opening(opening)
        self.body = scene.add(self.grasper)
        self._phases = phases
        self._shown: dict[str, Any] = {"position": list(at), "orientation": [1.0, 0.0, 0.0, 0.0], "jaw": opening}
        shown = self._shown  # the mock keeps that, and not this tool
        self.device = Device(Mock(context, measure=lambda now: shown, row_capacity=0), context=context, clock="shared")

    def way(self, to: Pose, opening: float, steps: int, first: int, size: float) -> list[tuple[Any, Any, float]]:
        """Evenly, in some steps, with a tremor of some size, m."""
        shares = (np.arange(steps) + 1.0)[:, None] / steps
        near = (to.q if dot(self.told.q, to.q) >= 0.0 else -to.q) / length(to.q)
        turns = unit_rows(self.told.q + shares * (near - self.told.q))
        times = STEP * (first + np.arange(steps))
        places = self.told.at + shares * (to.at - self.told.at) + size * tremor(times, self._phases)
        openings = self.opening + shares[:, 0] * (opening - self.opening)
        self.told, self.opening = Pose(to.at, near), opening
        return list(zip(places.tolist(), turns.tolist(), openings.tolist()))

    def save(self) -> tuple[Any, ...]:
        """What is no part of the scene: the hand, and the device."""
        return self.told, self.opening, self.tool, self._shown, self.device.save()

    def restore(self, state: tuple[Any, ...]) -> None:
        self.told, self.opening, self.tool, shown, device = state
        self._shown.update(shown)
        self.device.restore(device)

    def show(self, row: tuple[Any, Any, float]) -> None:
        self._shown.update(position=row[0], orientation=row[1], jaw=row[2], tool=self.tool)

    @property
    def state(self) -> GrasperState:
        return self.grasper.state


class SutureScene:
    """Bodies, hands, and the session that watches them."""

    def __init__(self, task: SutureTask, *, duration: float = 600.0, record: bool = False, note: bytes = b"",
                 context: Optional[Context] = None, replay: Optional[Replay] = None) -> None:
        self.task = task
        self.steps = 0
        self._duration = duration
        self.context = Context() if context is None else context
        random = np.random.Generator(np.random.PCG64(task.seed))
        phases = 2.0 * math.pi * random.random((2, 3))
        x, y = np.array(task.place) + task.scatter * (2.0 * random.random(2) - 1.0)
        turn = math.pi + task.turn_scatter * (2.0 * random.random() - 1.0)
        self._build(np.array((x, y, FLOOR + WIRE)), turn, phases)
        self.record = Record(self.scene, note=note, hash_interval=100) if record else None
        if replay is not None:  # takes the place of hands
            replay.begin(self.scene)
        self.metrics = Metrics(self.context, drain_radius=TUBE, max_time=MAX_TIME, weight_drop=5.0,
                               duration=duration)
        self.session = Session(
            self.scene, thread=self.thread_body, needle=self.needle_body, drain=self.drain_body,
            tools=[tool.body for tool in self.tools],
            devices=[tool.device if replay is None else None for tool in self.tools],
            knots=KnotDetector(self.context), metrics=self.metrics, record=self.record, replay=replay)

    def _build(self, place: Vector, turn: float, phases: Vector) -> None:
        context = self.context
        self.drain = Drain(context, radius=TUBE, thickness=WALL, position=(0.0, 0.0, CENTRE),
                           orientation=(0.5, 0.5, 0.5, 0.5))  # its x, y, z are the world's y, z, x
        self.marks = self.drain.places.marks
        self.scene = Scene(context, thread_capacity=1 + CUTS, node_capacity=2048, contact_capacity=4096,
                           candidate_capacity=65536, floor=1, floor_normal=(0.0, 0.0, 1.0), floor_height=FLOOR)
        self.drain_body = self.scene.add(self.drain)
        # It lies so that turning it clockwise, as seen from above, drives its tip.
        self.needle = Needle(context, radius=NEEDLE_RADIUS, arc=NEEDLE_ARC, wire_radius=WIRE, gravity=(0.0, 0.0, -9.81),
                             position=place, orientation=(0.0, cos(0.5 * turn), sin(0.5 * turn), 0.0))
        self.needle_body = self.scene.add(self.needle)
        lies = self.needle.state
        along = np.arange(self.task.segments + 1)[:, None] * THREAD / self.task.segments
        self.thread = Thread(context, preset="vblast", segment_count=self.task.segments, length=THREAD,
                             positions=np.array(lies.swage) + along * np.array(lies.swage_direction),
                             gravity=(0.0, 0.0, -9.81), damping=2.0, drag=1.0, cut_capacity=CUTS)
        self.thread_body = self.scene.add(self.thread)
        self.scene.pin_thread(self.thread_body, 0, self.needle_body, (-NEEDLE_RADIUS, 0.0, 0.0))
        right = Tool(self.scene, context, (0.05, -0.05, 0.03), 0.6, {"driver_radius": JAW}, phases[RIGHT])
        left = Tool(self.scene, context, (-0.04, -0.01, 0.03), 0.56, {"driver_radius": LEFT_JAW}, phases[LEFT])
        self.tools = (left, right)

    def move(self, ways: tuple[tuple[Vector, Vector, float], ...], steps: int) -> bytes:
        """Both tools by a displacement, a rotation vector, and to an opening; gives what the log has grown by."""
        rows = []
        for tool, (by, rotation, opening) in zip(self.tools, ways):
            most = JAW_SPEED * STEP * steps
            to = Pose(tool.told.at + by, turned(turn_by(rotation), tool.told.q))  # made unit in way()
            wanted = tool.opening + min(max(opening - tool.opening, -most), most)
            rows.append(tool.way(to, wanted, steps, self.steps, self.task.tremor))
        log = b""
        for row in zip(*rows):
            for tool, shown in zip(self.tools, row):
                tool.show(shown)
            self.session.step(STEP, now=STEP * self.steps)
            self.steps += 1
            if self.record is not None:
                log += self.record.take()
        return log

    # ---- copies

    def __reduce__(self) -> Any:
        """Bodies, hands and session are made again, and then get their states."""
        states = self.steps, self.scene.save(), self.session.save(), [tool.save() for tool in self.tools]
        return again, (SutureScene, (self.task,), {"duration": self._duration}), states

    def __setstate__(self, states: tuple[Any, ...]) -> None:
        self.steps, scene, session, tools = states
        self.scene.restore(scene)
        self.session.restore(session)
        for tool, state in zip(self.tools, tools):
            tool.restore(state)

    # ---- what is seen

    @property
    def time(self) -> float:
        return STEP * self.steps

    @property
    def needle_pose(self) -> Pose:
        state = self.needle.state
        return Pose(np.array(state.position), np.array(state.orientation))

    def mark_places(self) -> Vector:
        """The left one and the right one."""
        return self.drain.positions[list(self.marks)]

    def depths(self) -> tuple[Optional[float], Optional[float]]:
        """How far the needle's tip is beyond the wall that it went into, and beyond the one it came out of, m; None: it is
        in no such hole."""
        found: list[Optional[float]] = [None, None]
        for hole in self.scene.holes:
            if hole.needle:
                found[hole.outward] = hole.arc_length
        return found[0], found[1]

    def close(self) -> None:
        self.context.close()
