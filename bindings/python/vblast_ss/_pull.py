"""A scripted policy for what comes after the needle is through both marks: it is taken at its tip, turned and lifted out
of the drain, handed back, and the thread drawn through until its tail is short.

Acts on observations alone, as examples/surgeon/pull.c does."""
from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from . import _suture_space as space
from ._pose import Pose, length, rotate, turn_of, unit
from ._stitch import AXIS, HOLD, SEEING, TRIES, go, grip, off, seen_of
from ._suture import NEEDLE_RADIUS

TIP_HOLD = 4.5e-3  # from the tip: where the left hand takes the needle
BEHIND, LEAN = 1.5e-3, 0.3  # the tool's tip, m; of a tool from the needle's axis, rad
AHEAD = 0.02  # of jaws, along themselves, before they come
WIDE = 0.7  # of the handle
CARRY, CAREFUL, TURNING, DRAWING = 0.08, 0.03, 0.02, 0.05  # m/s
MOST_TURN, HALF_ROUND = 4.5, 2.5  # rad; a drain that went along is left from half a round on by lifting too,
LEAVING = np.array((-5e-3, 0.0, 9e-3))  # so, m for each rad
RISE, SHORT, LONGEST = 0.03, 18.5e-3, 0.135  # m: of the needle; of the tail in the end; of what is drawn
DRAW_WAY = unit(np.array((0.25, -0.2, 1.0)))
PATIENCE = 6.0  # s, of every phase but the last
LEFT, RIGHT = slice(0, space.ACTIONS // 2), slice(space.ACTIONS // 2, space.ACTIONS)
OFFERED = Pose(np.array((-0.02, -0.01, 0.055)),  # open above, the tip at the left, the thread at the right
               turn_of(np.array((-1.0, 0.0, 0.0)), np.array((0.0, 0.0, 1.0)), np.array((0.0, 1.0, 0.0))))


class ScriptedPull:
    """Draws needle and thread through, once ScriptedStitch is done. A new one for each episode."""

    PHASES = ("reach", "onto", "close", "part", "turn", "lift", "offer", "ask", "accept", "take", "give", "draw", "done")

    def __init__(self) -> None:
        self.phase = "reach"
        self.why = ""
        """Why it has given up."""
        self._since = self._turned = self._drawn = 0.0
        self._time = -1.0
        self._tries = 0
        self._jaws = {"left": 0.56, "right": 0.0}
        self._held = self._from = self._back = OFFERED

    @property
    def done(self) -> bool:
        return self.phase in ("done", "failed")

    def __call__(self, observation: Any) -> Any:
        see = seen_of(observation)
        h = float(see["time"]) - self._time if self._time >= 0.0 else 0.0
        self._time = float(see["time"])
        self._since += h
        action = np.zeros(space.ACTIONS)
        number = self.PHASES.index(self.phase) if self.phase != "failed" else len(self.PHASES)
        if 3 <= number < 12:  # somebody has it
            bearer, side = ("right", 1) if number > 9 else ("left", 0)
            self._held = self._held.mixed(see[bearer].inverse().after(see["needle"]), h / SEEING)
            if not see["holds"][side]:
                self._fail("the needle is lost")
        if self._since > PATIENCE and number < 11:
            self._fail(self.phase)
        getattr(self, f"_{self.phase}")(see, action, h)
        for part, name in ((LEFT, "left"), (RIGHT, "right")):
            action[part][space.JAWS], action[part][space.SHEARS] = 2.0 * self._jaws[name] - 1.0, -1.0
        return np.clip(action, -1.0, 1.0)

    def _next(self, see: Mapping[str, Any]) -> None:
        self.phase = self.PHASES[self.PHASES.index(self.phase) + 1]
        self._since, self._from = 0.0, see["needle"]

    def _fail(self, why: str) -> None:
        self.phase, self.why = "failed", why

    # ---- one hand takes the needle from the other

    def _taken(self, see: Mapping[str, Any], action: Any, name: str, arc_length: float, part: int) -> None:
        """Open jaws come to before it (0), one on either side (1), and close (2)."""
        # A hand that closes does not follow what it pushes aside.
        tool = (self._from if part == 2 else see["needle"]).after(grip(arc_length, BEHIND, LEAN))
        if part == 0:
            tool = Pose(tool.at + AHEAD * rotate(tool.q, AXIS), tool.q)
        go(action[LEFT if name == "left" else RIGHT], see[name], tool, (CARRY, CAREFUL, CAREFUL)[part])
        self._jaws[name] = (WIDE, WIDE, 0.0)[part]
        near = length(tool.at - see[name].at) < (1e-3, 0.3e-3, 0.0)[part] and tool.angle(see[name]) < 0.1
        if near or (part == 2 and self._since >= 0.3 and see["holds"][0 if name == "left" else 1]):
            if part == 2:
                self._held = see[name].inverse().after(see["needle"])
            self._next(see)
        elif part == 2 and self._since > 0.8:  # missed: once more
            self._tries += 1
            self.phase, self._since = ("reach" if name == "left" else "ask"), 0.0
            if self._tries == TRIES:
                self._fail("the needle is not taken")

    def _left(self, see: Mapping[str, Any], action: Any, name: str) -> None:
        """A hand opens, and goes back along itself."""
        self._jaws[name] = WIDE
        if self._since < 0.15:
            self._back = see[name]
            return
        away = Pose(self._back.at + 0.04 * rotate(self._back.q, AXIS), self._back.q)
        go(action[LEFT if name == "left" else RIGHT], see[name], away, CARRY)
        if self._since > 0.8:
            self._next(see)

    def _reach(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._taken(see, action, "left", TIP_HOLD, 0)

    def _onto(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._taken(see, action, "left", TIP_HOLD, 1)

    def _close(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._taken(see, action, "left", TIP_HOLD, 2)

    def _part(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._left(see, action, "right")

    def _ask(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._taken(see, action, "right", HOLD, 0)

    def _accept(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._taken(see, action, "right", HOLD, 1)

    def _take(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._taken(see, action, "right", HOLD, 2)

    def _give(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._left(see, action, "left")

    # ---- the needle's way

    def _steer(self, see: Mapping[str, Any], action: Any, name: str, needle: Pose, speed: float) -> None:
        go(action[LEFT if name == "left" else RIGHT], see[name], needle.after(self._held.inverse()), speed)

    def _turn(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._turned += TURNING / NEEDLE_RADIUS * h
        needle = self._from.rolled(AXIS, self._turned)
        needle = Pose(needle.at + max(self._turned - HALF_ROUND, 0.0) * LEAVING, needle.q)
        self._steer(see, action, "left", needle, CARRY)
        if see["threaded"].all():
            self._next(see)
        elif self._turned > MOST_TURN:
            self._fail("the needle is not through")

    def _lift(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        needle = Pose(self._from.at + RISE * AXIS, self._from.q)
        self._steer(see, action, "left", needle, DRAWING)
        if off(see["needle"], needle) < 3e-3:
            self._next(see)

    def _offer(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._steer(see, action, "left", OFFERED, DRAWING)
        if off(see["needle"], OFFERED) < 2e-3:
            self._next(see)

    def _draw(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        """Away from the left mark, slower as the tail becomes short."""
        mark = see["left_mark"]
        if self._drawn == 0.0:
            self._drawn = length(self._from.at - mark)
        slow = min(max((float(see["tail"]) - SHORT) / 10e-3, 0.1), 1.0)
        self._drawn = min(self._drawn + slow * DRAWING * h, LONGEST)
        way = mark + self._drawn * DRAW_WAY - self._from.at
        self._steer(see, action, "right", Pose(self._from.at + way, OFFERED.q), CARRY)
        if see["tail"] < SHORT:
            self._next(see)

    def _done(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        """Holds still."""

    _failed = _done
