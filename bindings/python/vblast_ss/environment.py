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
from typing import Any, Callable, Mapping, NamedTuple, Optional

import numpy as np

from . import _throw
from ._episode import Box, Episodes, register
from ._throw import STEP, ThrowScene, ThrowTask
from ._throw_hands import ScriptedThrow
from ._throw_space import C, FIELDS, GRIP, SHOWN, SPEED, TURN, TURNING, W
from .context import Context
from .errors import Error
from .knots import KnotVerdict
from .metrics import Metrics

__all__ = ["Box", "C", "FIELDS", "GRIP", "Outcome", "RandomHands", "SHOWN", "SPEED", "ScriptedThrow", "TURN", "TURNING", "ThrowEnvironment",
           "ThrowTask", "W", "run", "scene_of_note"]

class ThrowEnvironment(Episodes):
    """Tie a single throw.

        time_limit   s simulated, after which an episode is truncated
        control      steps of 1 ms between actions
        throw_points what a throw is worth, in points of the score, of which a second costs one and a drop five
        record       keep a log of the episode (take_log())
        render_mode  "rgb_array": render() returns a picture; "human": a window, by pygame

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
        self._end()
        self._scene = ThrowScene(task, record=self.recorded, note=json.dumps({"throw": task._asdict()}).encode())
        self._metrics = Metrics(self._scene.context, throws_wanted=1, weight_drop=5.0,
                                duration=max(1.0, self.time_limit), stiffness=task.axial_stiffness)
        self._metrics.add_event("needle_appears", 0.0)
        self._log, self._over, self._tied, self._notation = b"", False, False, ""
        self._wraps, self._drops = 0, 0
        self._sample()
        self._worth = self._score = self._metrics.report.score
        self._show()
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
        self._show()
        return self._observe(), reward, terminated, truncated, info

    def _end(self) -> None:
        super()._end()
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
