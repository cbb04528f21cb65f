"""One throw as an environment in the manner of Gymnasium: reset, step, spaces, rewards from the metrics.

    from vblast_ss.environment import ScriptedThrow, ThrowEnvironment, run

    with ThrowEnvironment() as environment:
        outcome = run(environment, ScriptedThrow(), seed=1)
    print(outcome.tied, outcome.notation, outcome.score)

Two hands: W, round which the limb is wound and which then takes the tail, and C, which holds the limb. Where gymnasium
is installed, ThrowEnvironment is a gymnasium.Env and its spaces are gymnasium's; else small ones of the same names
stand in. Needs numpy. Equal seeds, options and actions give equal numbers."""
from __future__ import annotations

import json
import math
from typing import Any, Callable, Mapping, NamedTuple, Optional

import numpy as np

from . import _throw
from ._episode import Box, Episodes, register
from ._pose import across, dot, length, unit
from ._throw import STEP, ThrowScene, ThrowTask, axis_of_w, away_from_w
from .context import Context
from .elementary import atan2, cos, sin
from .errors import Error
from .knots import KnotVerdict
from .metrics import Metrics

__all__ = ["Box", "Outcome", "RandomHands", "ScriptedThrow", "ThrowEnvironment", "ThrowTask", "run", "scene_of_note"]

SHOWN = 32
"""Points of the thread that are observed."""
FIELDS = {"time": 0, "w": slice(1, 4), "c": slice(4, 7), "tail": slice(7, 10), "angle": 10, "holds": 11,
          "pull_w": 12, "pull_c": 13, "free": 14, "on_w": 15, "held_at": 16, "thread": slice(17, 17 + 3 * SHOWN)}
"""What is where in an observation. time: s; w, c: where the hands hold their tools, m; tail: where W is to take it, m;
angle: of C about W, rad; holds: 1, W holds the tail; pull_w, pull_c: tension of the thread there, N; free: of the limb,
from where it touches W last (or the drain) to C, m; on_w: contacts of the limb on W; held_at: the limb's length to C, m;
thread: points along it, from the tail's end on, m."""
SPEED = 0.2
"""m/s: of a hand at an action of 1."""
TURN = 10.0
"""rad/s: likewise, of C about W."""
W, C, TURNING, GRIP = slice(0, 3), slice(3, 6), 6, 7
"""What is where in an action: speeds of both hands, of C's turn about W, and W's jaws: above 0 they close."""


class ThrowEnvironment(Episodes):
    """Tie a single throw.

        time_limit   s simulated, after which an episode is truncated
        control      steps of 1 ms between actions
        throw_points what a throw is worth, in points of the score, of which a second costs one and a drop five
        record       keep a log of the episode (take_log())
        render_mode  "rgb_array": render() returns a picture

    reset(options=...) takes fields of ThrowTask, such as friction or tremor. Rewards are changes of what the metrics
    say: of the score, which falls with time and drops, and of the throws that stand. An episode is terminated when a
    throw is certified in the thread alone and nothing of the limb is left on W, or when the simulation fails
    (info["error"]).
    """

    def __init__(self, *, time_limit: float = 5.0, control: int = 10, throw_points: float = 100.0,
                 record: bool = False, render_mode: Optional[str] = None) -> None:
        super().__init__(time_limit, control, record, 8, FIELDS["thread"].stop, render_mode)  # type: ignore[attr-defined]
        self.throw_points = throw_points
        self._metrics: Optional[Metrics] = None

    # ---- an episode

    def reset(self, *, seed: Optional[int] = None,
              options: Optional[Mapping[str, Any]] = None) -> tuple[Any, dict[str, Any]]:
        """Begins anew; without a seed the next one of a series that the last seed began."""
        task = ThrowTask(**self._fields(seed, options))
        self.close()
        self._scene = ThrowScene(task, record=self.recorded, note=json.dumps({"throw": task._asdict()}).encode())
        self._metrics = Metrics(self._scene.context, throws_wanted=1, weight_drop=5.0,
                                duration=max(1.0, self.time_limit), stiffness=task.axial_stiffness)
        self._metrics.add_event("needle_appears", 0.0)
        self._log, self._over, self._tied, self._notation = b"", False, False, ""
        self._wraps, self._drops = 0, 0
        self._sample()
        self._worth = self._score = self._metrics.report.score
        return self._observe(), self._info()

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Both hands do something for `control` steps."""
        wanted = self._wanted(action)
        scene, metrics = self.scene, self.metrics
        error = ""
        try:
            self._grip(bool(wanted[GRIP] > 0.0))
            seconds = self.control * STEP
            scene.move(scene.w.at + SPEED * seconds * wanted[W], scene.c.at + SPEED * seconds * wanted[C],
                       scene.angle + TURN * seconds * float(wanted[TURNING]), self.control)
            if scene.record is not None:
                self._log += scene.record.take()
            self._sample()
            self._look_for_a_throw()
        except Error as failure:  # of the simulation: the end of the episode, and data
            error = f"{type(failure).__name__}: {failure}"
        report = metrics.report
        worth, self._score = report.score + self.throw_points * report.throw_count, report.score
        reward, self._worth = worth - self._worth, worth
        terminated = self._tied or bool(error)
        truncated = not terminated and scene.time >= self.time_limit - 0.5 * STEP
        self._over = terminated or truncated
        info = self._info()
        if error:
            info["error"] = error
        return self._observe(), reward, terminated, truncated, info

    def close(self) -> None:
        super().close()
        self._metrics = None

    # ---- what happens

    def _grip(self, closed: bool) -> None:
        assert self._scene is not None and self._metrics is not None
        if closed:
            self._scene.take()
        elif self._scene.holds:
            self._scene.let_go()
            self._metrics.add_event("drop", self._scene.time, number=self._drops, tool="right")
            self._drops += 1

    def _sample(self) -> None:
        """W is the right tool of the metrics."""
        assert self._scene is not None and self._metrics is not None
        scene = self._scene
        w, c = scene.tool(scene.w), scene.tool(scene.c)
        self._metrics.add_sample(scene.time, c.position, w.position, left_force=c.hand_force,
                                 right_force=w.hand_force, step=scene.steps)

    def _look_for_a_throw(self) -> None:
        """Asks for the knot once the loops have slid off W with the tail in its jaws."""
        assert self._scene is not None and self._metrics is not None
        scene = self._scene
        if not scene.holds or scene.on_w()[0]:
            return
        knot = scene.judge()
        if knot.throws and knot.throws[0].verdict == KnotVerdict.CERTIFIED:
            first = knot.throws[0]
            self._tied, self._notation, self._wraps = True, knot.notation, first.wraps
            pull = scene.tool(scene.w).hand_force
            self._metrics.add_event("throw", scene.time, number=0, wraps=first.wraps, handedness=first.handedness,
                                    relation="first", tool="right", step=scene.steps, force=pull)

    def _observe(self) -> Any:
        assert self._scene is not None
        scene = self._scene
        points = scene.positions
        shown = np.empty(self.observation_space.shape)
        touching, last = scene.on_w()
        shown[FIELDS["time"]] = scene.time
        shown[FIELDS["w"]], shown[FIELDS["c"]] = scene.w.at, scene.c.at
        shown[FIELDS["tail"]] = points[_throw.TAIL_NODE]
        shown[FIELDS["angle"]], shown[FIELDS["holds"]] = scene.angle, bool(scene.holds)
        shown[FIELDS["pull_w"]], shown[FIELDS["pull_c"]] = scene.pulls()
        shown[FIELDS["free"]] = (scene.held_node - (last or scene.left_mark)) * scene.task.segment
        shown[FIELDS["on_w"]], shown[FIELDS["held_at"]] = touching, scene.task.held_at
        places = np.linspace(0, len(points) - 1, SHOWN).round().astype(int)
        shown[FIELDS["thread"]] = points[places].ravel()
        return shown

    def _info(self) -> dict[str, Any]:
        assert self._scene is not None and self._metrics is not None
        return {"task": self._scene.task._asdict(), "time": self._scene.time, "steps": self._scene.steps,
                "tied": self._tied, "notation": self._notation, "wraps": self._wraps, "score": self._score}

    # ---- for who wants more

    @property
    def scene(self) -> ThrowScene:
        if self._scene is None:
            raise RuntimeError("there is no episode: reset()")
        scene: ThrowScene = self._scene
        return scene

    @property
    def metrics(self) -> Metrics:
        if self._metrics is None:
            raise RuntimeError("there is no episode: reset()")
        return self._metrics


def scene_of_note(note: bytes, context: Context) -> ThrowScene:
    """A scene like that of a recorded episode, by the note in its log."""
    fields: dict[str, Any] = json.loads(note)["throw"]
    fields["tip"] = tuple(fields["tip"])
    return ThrowScene(ThrowTask(**fields), context=context)


# ---- policies

def _toward(target: Any, at: Any, speed: float) -> Any:
    """An action that goes there, slower when near, at most at a speed."""
    way = (target - at) / 0.04
    fast = length(way)
    return way * (min(1.0, speed / fast) if fast > 0.0 else 0.0) / SPEED


class RandomHands:
    """Hands that do anything: each action is that before, and some chance. size: of an action."""

    def __init__(self, seed: int = 0, size: int = 8) -> None:
        self._random = np.random.default_rng(seed)
        self._action = np.zeros(size)

    def __call__(self, observation: Any) -> Any:
        # Nearly normal, and the same everywhere: numpy's normal() asks libm.
        chance = -6.0 * np.ones(self._action.shape)
        for _ in range(12):
            chance += self._random.random(self._action.shape)
        self._action = np.clip(0.9 * self._action + 0.3 * chance, -1.0, 1.0)
        return self._action


class ScriptedThrow:
    """Ties a throw by what is observed: C brings the limb to W, winds it round, W goes to the tail and takes it, and is
    drawn out of the loops while C gives way. A new one for each episode.

        speed   of C while it winds, m/s
        turns   of the limb about W
        pull    N: with which C winds
        haste   how many times faster the rest is done
        first   m: how far behind W's tip C begins; too far, and the turns lie the wrong way round, and tie nothing
        advance m: nearer to the tip with each turn
        give    N: from which on C gives way while W is drawn out; taut turns hang on its tip
        sink    how much C goes down as it goes aside
    """

    def __init__(self, *, speed: float = 0.18, turns: float = 1.0, pull: float = 0.05, haste: float = 1.4,
                 first: float = 12e-3, advance: float = 3e-3, give: float = 0.03, sink: float = 0.3) -> None:
        self.speed, self.turns, self.pull, self.haste = speed, turns, pull, haste
        self.first, self.advance, self.give, self.sink = first, advance, give, sink
        self.phase = "near"
        self._angle, self._radius, self._share = -0.5 * math.pi, 45e-3, 0.92
        self._over, self._leash = 0.0, 0.0
        self._since, self._then = 0.0, 0.0

    def __call__(self, observation: Any) -> Any:
        see = {name: observation[place] for name, place in FIELDS.items() if name != "thread"}
        points = observation[FIELDS["thread"]].reshape(SHOWN, 3)
        see["strand"] = points[0] - points[1]  # of the tail, toward its end
        h = float(see["time"]) - self._then
        self._then = float(see["time"])
        self._since += h
        action = np.zeros(8)
        action[GRIP] = -1.0
        getattr(self, f"_{self.phase}")(see, action, h)
        return np.clip(action, -1.0, 1.0)

    def _enter(self, phase: str) -> None:
        self.phase, self._since = phase, 0.0

    def _orbit_point(self, see: Mapping[str, Any]) -> Any:
        axis = axis_of_w(see["w"])
        turns = (self._angle + 0.5 * math.pi) / (2.0 * math.pi)
        out = away_from_w(see["w"], self._angle)
        at = see["w"] + (self.first - self.advance * turns - _throw.GRASP) * axis + self._radius * out
        # The handle points away from W: it shall not knock on drain and floor.
        at[2] = max(at[2], 2e-3 + 12e-3 * max(-out[2], 0.0))
        return at

    def _near(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        target = self._orbit_point(see)
        action[C] = _toward(target, see["c"], 0.10 * self.haste)
        off = target - see["c"]
        if length(off) < 2e-3 or self._since > 1.5:
            self._enter("wind")

    def _wind(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        pull, before = float(see["pull_c"]), self._angle
        # Slack is the worst that can be: loops fall off.
        if pull > self.pull:
            self._share -= 1.0 * h
        elif pull < 0.4 * self.pull and see["on_w"]:
            self._share += 0.4 * h
        self._share = min(max(self._share, 0.3), 1.1)
        free = float(see["free"]) if see["on_w"] else float(see["held_at"]) - 32e-3
        wanted = min(max(self._share * free, 8e-3), 45e-3) - self._radius
        self._radius += min(max(wanted, -0.1 * h), 0.1 * h)
        slow = 0.0 if pull > 3.0 * self.pull else 0.3 if pull > self.pull else 1.0
        self._angle += slow * min(self.speed / self._radius, TURN) * h
        action[6] = (self._angle - before) / (h * TURN) if h > 0.0 else 0.0
        action[C] = _toward(self._orbit_point(see), see["c"], SPEED)
        if self._angle >= 2.0 * math.pi * self.turns or self._since > 8.0:
            self._enter("travel")

    def _travel(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        """Beside the tail's end, then against it, until it is within reach."""
        axis, off = axis_of_w(see["w"]), see["w"] - see["tail"]
        side = unit(across(axis, see["strand"]))
        if dot(side, off) < 0.0:
            side = -side
        near = dot(off, off) - dot(off, side) * dot(off, side) < 1e-6
        aim = see["tail"] + (0.0 if near else 3e-3) * side
        action[W] = _toward(aim, see["w"], (0.03 if near else 0.06) * self.haste)
        action[C] = 0.83 * action[W]
        if length(off) < _throw.REACH:
            action[W] = action[C] = 0.0
            action[GRIP] = 1.0
            way = see["w"] - _throw.MARK
            self._over, self._leash = atan2(way[2], way[0]), length(way)
            self._enter("draw")

    def _draw(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        action[GRIP] = 1.0
        if not see["holds"]:  # it has slipped away
            action[GRIP] = -1.0
            self._enter("travel")
            return
        pull_w, pull_c = float(see["pull_w"]), float(see["pull_c"])
        slow = min(max((0.1 - pull_w) / 0.05, 0.0), 1.0)
        whole = _throw.TAIL - 0.5e-3 * _throw.TAIL_NODE
        self._leash += -0.02 * h if pull_w > 0.06 else (0.97 * whole - self._leash) * min(h / 0.2, 1.0)
        self._over = min(self._over + slow * 0.03 * self.haste * h / whole, math.radians(150.0))
        on_arc = np.array((cos(self._over), 0.0, sin(self._over)))
        action[W] = _toward(_throw.MARK + self._leash * on_arc, see["w"], SPEED)
        # C goes to the right while the limb is slack, and gives way to W when it is not.
        eager = (self.give - pull_c) / self.give
        way = eager * np.array((1.0, 0.0, -self.sink)) if eager > 0.0 else unit(see["w"] - see["c"]) * min(-eager, 2.0)
        if see["c"][0] > 95e-3:
            way[0] = min(way[0], 0.0)
        if see["c"][2] < 2e-3:
            way[2] = max(way[2], 0.0)
        action[C] = 0.03 * self.haste * way / SPEED


class Outcome(NamedTuple):
    """What came of an episode."""
    tied: bool
    notation: str
    wraps: int
    score: float
    total_reward: float
    time: float
    """s simulated."""
    steps: int
    error: str
    """"": none."""
    pull: float
    """Largest tension of the thread at C, N."""
    path_w: float
    """Length of W's way, m."""
    path_c: float


def run(environment: ThrowEnvironment, policy: Callable[[Any], Any], *, seed: Optional[int] = None,
        options: Optional[Mapping[str, Any]] = None) -> Outcome:
    """An episode from its reset to its end."""
    seen, info = environment.reset(seed=seed, options=options)
    total, pull, over = 0.0, 0.0, False
    while not over:
        seen, reward, terminated, truncated, info = environment.step(policy(seen))
        total, over = total + reward, terminated or truncated
        pull = max(pull, float(seen[FIELDS["pull_c"]]))
    metrics = environment.metrics
    metrics.finish()
    path_w, path_c = (metrics.motion(tool).path_length for tool in ("right", "left"))
    return Outcome(info["tied"], info["notation"], info["wraps"], info["score"], total, info["time"], info["steps"],
                   info.get("error", ""), pull, path_w, path_c)


register("vblast_ss/Throw-v0", f"{__name__}:ThrowEnvironment")
