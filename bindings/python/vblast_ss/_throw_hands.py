"""A scripted policy that ties a throw. Acts on observations alone, as examples/throw does."""
from __future__ import annotations

import math
from typing import Any, Mapping

import numpy as np

from ._pose import Vector, dot, length, rotate, unit
from ._throw import GRASP, MARK, REACH, STEP, TAIL, TAIL_NODE, axis_of_w, away_from_w, turn_from_z
from ._throw_space import C, FIELDS, GRIP, SHOWN, SPEED, TURN, TURNING, W
from .elementary import atan2, cos, sin

LEFT_MARK = np.array((-1.0, 1.0, 1.0)) * MARK
BESIDE = np.array((16e-3, -1e-3, 32e-3))
"""W goes back along itself before it rises: the tail may lie on its jaws. m."""
WOUND = np.array((32e-3, 2e-3, 36e-3))
"""Where W is wound about, m: so high that C goes round it above the drain, and so far to the right that the limb comes from the
handle's side, 20 mm behind the tip."""
BEYOND = 0.6  # rad that C winds on after a whole turn
NARROWEST, WIDEST = 8e-3, 60e-3  # of C's orbit, m
LOW, LOW_HANDLE = 2e-3, 12e-3  # m above the drain's top, of C and of its handle
ACROSS = np.array((0.0, 1.0, 0.0))  # of W's jaws, which lie side by side: the tail comes to rest on both
AHEAD = 3e-3  # of the tail, from where W comes to it sideways, m
SWING = 12  # observations in a swing of the tail, 0.12 s: over so many W takes the mean of where it is
TOUCHING = 0.9e-3  # of the tail from W's grasping point, m: it lies on the jaws, and no turn passes between
PUSHED = 0.5  # s: so long W comes to the tail from its own side, then from the other
LATE = 1.0  # s, after which all that is within reach is taken
FAR_ROUND = math.radians(145.0)  # of W about the mark: from there the tail leaves its jaws forward
TAUT = 0.97  # of the tail's length
PARTED = 70e-3  # from W along the tail: to where C draws the turns, m


def _toward(target: Vector, at: Vector, speed: float) -> Vector:
    """An action that goes there, slower when near, at most at a speed."""
    way = (target - at) / 0.04
    fast = length(way)
    return way * (min(1.0, speed / fast) if fast > 0.0 else 0.0) / SPEED


def _angle_about(w: Vector, point: Vector) -> float:
    off = point - w
    return atan2(dot(off, away_from_w(w, 0.5 * math.pi)), dot(off, away_from_w(w, 0.0)))


class ScriptedThrow:
    """Ties a throw. A new one for each episode.

    W goes back from under the tail and up, C comes beside it (near) and winds the limb round it, always as taut as it can be, each turn
    nearer to the tip than where the limb comes from (wind). W goes down to the tail and takes it (travel), and carries it over
    the drain; C goes along, so that the turns stay on W until the tail leaves its jaws forward (draw). Only then C draws the
    turns off along the tail (strip): drawn off earlier they hang between tail and jaws, or come off over the tail's end.

        speed   of C while it winds, m/s
        pull    N: with which C winds
        haste   how many times faster the rest is done
        first   m: how far behind W's tip C begins; too far, and the turns lie the wrong way round, and tie nothing
        advance m: nearer to the tip with each turn
        give    N: from which on C gives way while W is drawn out
    """

    def __init__(self, *, speed: float = 0.18, pull: float = 0.05, haste: float = 1.4, first: float = 6e-3, advance: float = 3e-3,
                 give: float = 0.03) -> None:
        self.speed, self.pull, self.haste = speed, pull, haste
        self.first, self.advance, self.give = first, advance, give
        self.phase = "near"
        self._angle, self._contact = 0.0, 0.5 * math.pi
        self._radius, self._share = 45e-3, 0.95
        self._rises = False
        self._over, self._leash = 0.0, 0.0
        self._since, self._then = 0.0, 0.0
        self._tails: list[Vector] = []

    def __call__(self, observation: Any) -> Any:
        see = {name: observation[place] for name, place in FIELDS.items() if name != "thread"}
        h = float(see["time"]) - self._then
        self._then = float(see["time"])
        self._since += h
        action = np.zeros(8)
        action[GRIP] = -1.0
        getattr(self, f"_{self.phase}")(see, action, h)
        return np.clip(action, -1.0, 1.0)

    def _enter(self, phase: str) -> None:
        self.phase, self._since = phase, 0.0

    # ---- C on its orbit about W

    def _orbit_point(self, see: Mapping[str, Any], w: Vector, h: float) -> Vector:
        """Where C keeps the limb taut at its angle, with W there; without time at once, else not faster than a hand can."""
        turns = max(self._angle - self._contact, 0.0) / (2.0 * math.pi)
        centre = w + (self.first - self.advance * turns - GRASP) * axis_of_w(w)
        out = away_from_w(w, self._angle)
        if see["on_w"]:
            wanted = self._share * float(see["free"])
        else:  # straight from the drain
            off, reach = centre - LEFT_MARK, self._share * float(see["held_at"])
            along = dot(off, out)
            square = along * along - dot(off, off) + reach * reach
            wanted = math.sqrt(square) - along if square > 0.0 else NARROWEST
        wanted = min(max(wanted, NARROWEST), WIDEST)
        self._radius = wanted if h == 0.0 else self._radius + min(max(wanted - self._radius, -0.1 * h), 0.1 * h)
        at = centre + self._radius * out
        # The handle points away from W: it shall not knock on drain and floor.
        at[2] = max(at[2], LOW + LOW_HANDLE * max(-out[2], 0.0))
        return at

    def _turn(self, see: Mapping[str, Any], action: Any) -> None:
        action[TURNING] = (self._angle - float(see["angle"])) / (20.0 * STEP * TURN)

    def _feel(self, see: Mapping[str, Any], h: float) -> None:
        """Slack is the worst that can be: loops fall off."""
        pull = float(see["pull_c"])
        if pull > self.pull:
            self._share -= 1.0 * h
        elif pull < 0.4 * self.pull and see["on_w"]:
            self._share += 0.4 * h
        self._share = min(max(self._share, 0.3), 1.1)

    # ---- the limb round W

    def _near(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._rises = self._rises or length(BESIDE - see["w"]) < 8e-3
        action[W] = _toward(WOUND if self._rises else BESIDE, see["w"], 0.1 * self.haste)
        # Opposite to where the limb comes from it will touch W.
        root = _angle_about(WOUND, LEFT_MARK)
        self._contact = root + (math.pi if root < 0.0 else -math.pi)
        target = self._orbit_point(see, WOUND, 0.0)
        action[C] = _toward(target, see["c"], 0.12 * self.haste)
        self._turn(see, action)
        if (length(target - see["c"]) < 3e-3 and length(WOUND - see["w"]) < 2e-3) or self._since > 1.5:
            self._enter("wind")

    def _wind(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._feel(see, h)
        pull = float(see["pull_c"])
        slow = 0.0 if pull > 3.0 * self.pull else 0.3 if pull > self.pull else 1.0
        self._angle += slow * min(self.speed / self._radius, TURN) * h
        self._turn(see, action)
        action[W] = _toward(WOUND, see["w"], 0.05)
        action[C] = _toward(self._orbit_point(see, see["w"], h), see["c"], SPEED)
        if self._angle >= self._contact + 2.0 * math.pi + BEYOND or self._since > 8.0:
            self._enter("travel")

    # ---- the tail

    def _travel(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        """Beside the tail's end, then against it, until it lies on the jaws."""
        self._feel(see, h)
        # A tail that swings cannot be followed; its mean can be met, and it comes to rest against the jaws.
        self._tails = (self._tails + [np.array(see["tail"])])[-SWING:]
        tail = sum(self._tails) / len(self._tails)
        off = see["w"] - tail
        side = rotate(turn_from_z(axis_of_w(see["w"])), ACROSS)
        # From the side where W is; pushed away from there, the tail is taken from behind.
        if self._since < PUSHED and dot(side, off) < 0.0:
            side = -side
        near = dot(off, off) - dot(off, side) * dot(off, side) < 1e-6
        aim = tail + (0.0 if near else AHEAD) * side
        action[W] = _toward(aim, see["w"], (0.03 if near else 0.08) * self.haste)
        action[C] = _toward(self._orbit_point(see, see["w"] + 10.0 * STEP * SPEED * action[W], h), see["c"], SPEED)
        self._turn(see, action)
        distance = length(see["w"] - see["tail"])
        if distance < TOUCHING or (self._since > LATE and distance < REACH):
            action[W] = action[C] = 0.0
            action[GRIP] = 1.0
            way = see["w"] - MARK
            self._over, self._leash = atan2(way[2], way[0]), length(way)
            self._enter("draw")

    def _carry(self, see: Mapping[str, Any], action: Any, h: float) -> bool:
        """W on an arc about the mark, the tail nearly taut; whether it still holds the tail."""
        if not see["holds"]:  # it has slipped away
            self._enter("travel")
            return False
        action[GRIP] = 1.0
        pull = float(see["pull_w"])
        slow = min(max((0.1 - pull) / 0.05, 0.0), 1.0)
        whole = TAIL - 0.5e-3 * TAIL_NODE
        self._leash += -0.02 * h if pull > 0.06 else (TAUT * whole - self._leash) * min(h / 0.2, 1.0)
        self._over = min(self._over + slow * 0.05 * self.haste * h / whole, FAR_ROUND)
        on_arc = np.array((cos(self._over), 0.0, sin(self._over)))
        action[W] = _toward(MARK + self._leash * on_arc, see["w"], SPEED)
        return True

    def _draw(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        if not self._carry(see, action, h):
            return
        action[C] = action[W]
        excess = float(see["pull_c"]) / self.give - 1.0
        if excess > 0.0:
            action[C] += 0.02 * min(excess, 2.0) * unit(see["w"] - see["c"]) / SPEED
        if self._over == FAR_ROUND:
            self._enter("strip")

    def _strip(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        if not self._carry(see, action, h):
            return
        goal = see["w"] + PARTED * unit(MARK - see["w"])
        goal[2] = max(goal[2], 2.0 * LOW)
        eager = 1.0 - float(see["pull_c"]) / self.give
        way = eager * unit(goal - see["c"]) if eager > 0.0 else min(-eager, 2.0) * unit(see["w"] - see["c"])
        action[C] = 0.06 * self.haste * way / SPEED
