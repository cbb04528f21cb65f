"""The scene in which one throw is tied: a thread that comes out of a drain, a tool W round which it is wound, and a
tool C that holds the limb.

x right, y away, z up, the top of the drain at 0. The drain is a cylinder that does not give, the thread is pinned
where it comes out of it at both marks. Tools are rods with jaws, coupled to where hands tell them to be; a grasp is
three pins, which bring the tail to the middle of the jaws: no jaws move. So this is a throw as far as thread, contact and
hands go, cheap enough for thousands."""
from __future__ import annotations

import math
from typing import Any, NamedTuple, Optional

import numpy as np

from ._pose import Pose, Vector, across, dot, length, tremor, turned, unit, unit_rows
from .context import Context
from .elementary import cos, sin
from .knots import Knot, KnotDetector
from .records import Record
from .scene import Capsule, SceneRigidState, Scene
from .thread import Thread

STEP = 1e-3  # s
GRASP = 0.5e-3  # m: hands hold the grasp, so far behind the tip
TROCAR = np.array((-0.110, -0.050, 0.080))  # W's axis goes through it
DRAIN_RADIUS = 6.5e-3
THREAD_RADIUS = 0.125e-3
MARK_ANGLE = 4.5e-3 / DRAIN_RADIUS  # rad from the top: where the thread comes out, on either side
MARK = DRAIN_RADIUS * np.array((sin(MARK_ANGLE), 0.0, cos(MARK_ANGLE))) - (0.0, 0.0, DRAIN_RADIUS)
FLOOR = -13e-3
TAIL = 30e-3  # of the thread beside the drain
LIMB = 117e-3
BEND = 15e-3  # of the limb, from where it comes out to the way to C
TAIL_NODE = 1  # where W takes it: a longer end gets in the way of the loops
HELD = range(TAIL_NODE - 1, TAIL_NODE + 2)
JAW_LENGTH, JAW_RADIUS = 13e-3, 0.7e-3
SHAFT_LENGTH, SHAFT_RADIUS = 0.12, 2.5e-3
CLEAR = 2.0 * JAW_RADIUS + 0.2e-3  # of the tail from the middle of W's jaws in the beginning, m
REACH = 1.2e-3  # of W's jaws for the tail, m: so near that no loop slips through between them


class ThrowTask(NamedTuple):
    """What a throw is tied with. SI units; seed: of the hands' tremor and of where W stands."""
    seed: int = 0
    segment: float = 0.5e-3
    axial_stiffness: float = 427.0
    bending_stiffness: float = 1e-8
    friction: float = 0.15
    """Of tools; the drain has twice as much."""
    held_at: float = 85e-3
    """Where C holds the limb: m from the drain along the thread."""
    tremor: float = 0.3e-3
    tip: tuple[float, float, float] = (29e-3, 2e-3, 14e-3)
    """Of W in the begin."""
    scatter: float = 1e-3
    """Most that it stands beside that, on each axis."""


def axis_of_w(grasp: Vector) -> Vector:
    """From tip to handle."""
    return unit(TROCAR - grasp)


def away_from_w(grasp: Vector, angle: float) -> Vector:
    """From W's axis, at an angle about it."""
    axis = axis_of_w(grasp)
    first = unit(np.array((1.0, 0.0, 0.0)) - axis[0] * axis)
    return cos(angle) * first + sin(angle) * across(axis, first)


def turn_from_z(to: Vector) -> Vector:
    """The quaternion of the shortest turn from z to a unit vector."""
    if to[2] < -1.0 + 1e-12:
        return np.array((0.0, 1.0, 0.0, 0.0))
    whole = np.array((1.0 + to[2], -to[1], to[0], 0.0))
    return whole / length(whole)


def z_of(q: Vector) -> Vector:
    """Where a quaternion turns z to."""
    w, x, y, z = q
    return np.array((2.0 * (x * z + w * y), 2.0 * (y * z - w * x), w * w - x * x - y * y + z * z))


class Hand:
    """Where a hand has told its tool to be, and how."""

    def __init__(self, at: Vector, stand: Vector) -> None:
        self.at, self.stand = at, stand
        self.body = 0


def stand_of_c(w: Vector, angle: float) -> Vector:
    """Its handle is away from W and goes round with it."""
    since = angle + 0.5 * math.pi
    half = 0.5 * (since - 2.0 * math.pi * math.floor(since / (2.0 * math.pi)))
    round_w = np.array((cos(half), *(sin(half) * axis_of_w(w))))
    return turned(round_w, turn_from_z(away_from_w(w, -0.5 * math.pi)))


class ThrowScene:
    """Thread, drain and both tools, and the hands that move them."""

    def __init__(self, task: ThrowTask, *, record: bool = False, note: bytes = b"",
                 context: Optional[Context] = None) -> None:
        self.task = task
        random = np.random.Generator(np.random.PCG64(task.seed))
        self._phases = 2.0 * math.pi * random.random((2, 3))
        tip = np.array(task.tip) + task.scatter * (2.0 * random.random(3) - 1.0)
        self.context = Context() if context is None else context
        self.angle = -0.5 * math.pi  # of C about W
        self.steps = 0
        self.holds: list[int] = []  # pins of W on the tail
        self._held = np.zeros((3, 3))  # where it was taken, in W's frame
        self._closing = False
        points, marks, self.held_node = self._lay(unit(np.array((-0.05, -0.6, 0.75))))
        w = self._clear_of(points[:marks[0]], tip) + GRASP * axis_of_w(tip)
        self.right_mark, self.left_mark = marks
        self.w = Hand(w, turn_from_z(axis_of_w(w)))
        self.c = Hand(points[self.held_node], stand_of_c(w, self.angle))
        self._build(points)
        self.record = Record(self.scene, note=note) if record else None
        if self.record is not None:
            self.record.attach_to_scene()
        self.detector = KnotDetector(self.context, point_capacity=len(points))

    # ---- how it begins

    def _lay(self, limb_way: Vector) -> tuple[Vector, tuple[int, int], int]:
        """Tail, through the drain, and the limb, which bends to its way."""
        task = self.task
        surface = DRAIN_RADIUS + THREAD_RADIUS + 0.03e-3
        centre = np.array((0.0, 0.0, -DRAIN_RADIUS))
        out = {side: np.array((sin(side * MARK_ANGLE), 0.0, cos(side * MARK_ANGLE))) for side in (1, -1)}
        tail, limb = (round(length / task.segment) for length in (TAIL, LIMB))
        points = [centre + (surface + (tail - i) * task.segment) * out[1] for i in range(tail + 1)]
        points += [centre + (surface - 1e-3) * out[1], centre + (surface - 1e-3) * out[-1], centre + surface * out[-1]]
        left = len(points) - 1
        for i in range(limb):
            share = min((i + 0.5) * task.segment / BEND, 1.0)
            points.append(points[-1] + task.segment * unit((1.0 - share) * out[-1] + share * limb_way))
        return np.array(points), (tail, left), left + round(task.held_at / task.segment)

    @staticmethod
    def _clear_of(tail: Vector, tip: Vector) -> Vector:
        """W's tip, drawn back along its axis until the tail is beside its jaws: bodies must not begin in each other."""
        axis = axis_of_w(tip)
        while True:
            off = tail - tip
            along = np.clip(off[:, 0] * axis[0] + off[:, 1] * axis[1] + off[:, 2] * axis[2], 0.0, JAW_LENGTH)
            aside = off - along[:, None] * axis
            if (aside[:, 0] ** 2 + aside[:, 1] ** 2 + aside[:, 2] ** 2).min() >= CLEAR ** 2:
                return tip
            tip = tip + 0.5e-3 * axis

    def _build(self, points: Vector) -> None:
        task = self.task
        self.scene = Scene(self.context, node_capacity=512, contact_capacity=2048, candidate_capacity=32768,
                           capsule_capacity=8, floor=1, floor_normal=(0.0, 0.0, 1.0), floor_height=FLOOR)
        self.thread = Thread(self.context, positions=points, axial_stiffness=task.axial_stiffness,
                             rest_lengths=[length(way) for way in np.diff(points, axis=0)],
                             bending_stiffness=task.bending_stiffness, radius=THREAD_RADIUS, gravity=(0.0, 0.0, -9.81))
        self.thread_body = self.scene.add(self.thread)
        for node in range(self.right_mark, self.left_mark + 1):
            self.thread.attach("pin", node)
        parts = [Capsule((JAW_RADIUS, 0.0, 0.0), (JAW_RADIUS, 0.0, JAW_LENGTH), JAW_RADIUS),
                 Capsule((-JAW_RADIUS, 0.0, 0.0), (-JAW_RADIUS, 0.0, JAW_LENGTH), JAW_RADIUS),
                 Capsule((0.0, 0.0, JAW_LENGTH), (0.0, 0.0, SHAFT_LENGTH), SHAFT_RADIUS)]
        for hand, count in ((self.w, 3), (self.c, 2)):
            hand.body = self.scene.add_rigid(parts[:count], kind="coupled", position=self._frame(hand.at, hand.stand),
                                             orientation=hand.stand, friction=task.friction)
        self.scene.add_rigid([((0.0, -30e-3, -DRAIN_RADIUS), (0.0, 30e-3, -DRAIN_RADIUS), DRAIN_RADIUS)],
                             friction=2.0 * task.friction)
        for node in range(self.held_node - 1, self.held_node + 2):
            self.scene.pin_thread(self.thread_body, node, self.c.body)

    @staticmethod
    def _frame(grasp: Vector, stand: Vector) -> Vector:
        return grasp - GRASP * z_of(stand)

    # ---- what hands do

    def take(self) -> bool:
        """W closes its jaws: holds the tail if it is within reach."""
        tail = self.positions[TAIL_NODE]
        off = tail - self.w.at
        if self.holds or length(off) >= REACH:
            return bool(self.holds)
        tool = self.tool(self.w)
        pose = Pose(np.array(tool.position), np.array(tool.orientation)).inverse()
        self._held = np.array([pose.point(self.positions[node]) for node in HELD])
        self._pin(0.0)
        self._closing = True
        return True

    def _pin(self, share: float) -> None:
        """Holds the tail a share of the way from where it was taken to the middle of the jaws."""
        self.let_go()
        points = self._held + share * (np.array((0.0, 0.0, GRASP)) - self._held[1])
        self.holds = [self.scene.pin_thread(self.thread_body, node, self.w.body, point) for node, point in zip(HELD, points)]

    def let_go(self) -> None:
        for pin in self.holds:
            self.scene.unpin_thread(pin)
        self.holds = []
        self._closing = False

    def move(self, w: Vector, c: Vector, angle: float, steps: int) -> None:
        """Both hands go evenly to where they shall be after some steps, C by then at an angle about W."""
        shares = (np.arange(steps) + 1.0)[:, None] / steps
        times = STEP * np.arange(self.steps, self.steps + steps)
        self.angle = angle
        ways = []
        for number, (hand, to, stand) in enumerate(((self.w, w, turn_from_z(axis_of_w(w))),
                                                    (self.c, c, stand_of_c(w, angle)))):
            if dot(hand.stand, stand) < 0.0:
                stand = -stand
            stands = unit_rows(hand.stand + shares * (stand - hand.stand))
            places = hand.at + shares * (to - hand.at) + self.task.tremor * tremor(times, self._phases[number])
            ways.append((hand.body, places - GRASP * np.array([z_of(q) for q in stands]), stands))
            hand.at, hand.stand = np.array(to), stand
        scene = self.scene
        for i in range(steps):
            if self._closing:
                self._pin((i + 1) / steps)
                self._closing = i + 1 < steps
            for body, places, stands in ways:
                scene.set_rigid_target(body, places[i], stands[i])
            scene.step(STEP)
        self.steps += steps

    # ---- what they see and feel

    @property
    def time(self) -> float:
        return STEP * self.steps

    @property
    def positions(self) -> Vector:
        return self.thread.positions

    def pulls(self) -> tuple[float, float]:
        """Tension of the thread at W and at C, N; at W 0 as long as it does not hold it."""
        tensions = self.thread.tensions
        return float(tensions[TAIL_NODE + 2]) if self.holds else 0.0, float(tensions[self.held_node - 3])

    def on_w(self) -> tuple[int, int]:
        """How often the limb touches W, and with which node last; 0: it does not."""
        keys = self.scene.contact_features
        mine = keys[(keys[:, 1] == self.thread_body) & (keys[:, 3] == self.w.body)][:, 2]
        limb = mine[(mine > self.left_mark) & (mine < self.held_node)]
        return len(limb), int(limb.max()) if len(limb) else 0

    def tool(self, hand: Hand) -> SceneRigidState:
        return self.scene.rigid(hand.body)

    def judge(self) -> Knot:
        """The knot in the thread alone, whatever the tools hold."""
        points = self.positions
        return self.detector.judge(points, holes=(points[self.right_mark], points[self.left_mark]),
                                   hole_places=(self.right_mark, self.left_mark), away=(0.0, 0.0, -1.0))

    # ---- copies

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "thread"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        self.thread = self.scene.thread(self.thread_body)

    def close(self) -> None:
        self.context.close()
