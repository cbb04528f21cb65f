"""A scripted policy for the begin of the task: takes the needle off the floor, and drives it through both marks.

Acts on observations alone, as examples/needle/stitch.c does: the right hand drives, the left one bears the wall."""
from __future__ import annotations

import math
from typing import Any, Mapping, Optional

import numpy as np

from . import _suture_space as space
from ._pose import Pose, Vector, across, back, dot, length, rotate, rotation_of, turn_of, turned, unit
from ._suture import CENTRE, FLOOR, JAW, LEFT_JAW, NEEDLE_ARC, NEEDLE_RADIUS, WALL
from .elementary import cos, sin

HOLD = 0.64 * NEEDLE_ARC * NEEDLE_RADIUS  # where the needle is taken, from its tip, m
LEAN, UP = 0.14, 1.92  # of the tool from the needle's axis, rad; to where, in its plane
PRESS = 0.5e-3  # of jaws into the floor, so that they are on it
OVER = 12e-3
CARRY, CAREFUL, DRIVE = 0.1, 0.03, 12e-3  # m/s
LAG = 0.04  # s: of hands
SEEING = 0.1  # s: what is seen is known so late
WIDE, FORK = 0.6, 0.56  # of handles; a needle goes between the jaws of the fork
BEFORE = 5e-3  # of the mark, where the needle is brought
IN_LUMEN, HELPED, OUT = 5e-3, 2e-3, 8.5e-3  # of the tip: until the left hand is ready, helps; in the end
LONGEST = 27e-3  # of the way beyond the right mark
FORK_BEYOND = 1.8e-3  # of the fork's tips past the mark
FOLLOW, LOWER, PUSH, LEAD = 4e-3, 0.7e-3, 4e-3, 0.35e-3  # see examples/needle/stitch.c
TROCAR = np.array((-0.12, -0.015, 0.08))  # the left shaft goes through it
POINT = np.array((0.56, 0.0, 0.83))  # and its jaws open across that
AWAY, AXIS = np.array((0.0, 1.0, 0.0)), np.array((0.0, 0.0, 1.0))
TRIES = 5


def limited(vector: Vector, most: float) -> Vector:
    size = length(vector)
    return vector * (most / size) if size > most else vector


def flat(vector: Vector, normal: Vector) -> Vector:
    return vector - dot(vector, normal) * normal


def _outward(at: Vector) -> Vector:
    """Of the drain's wall."""
    return unit(np.array((at[0], 0.0, at[2] - CENTRE)))


def _through(tip: Vector) -> Pose:
    """The left tool with its shaft toward its trocar."""
    z = unit(TROCAR - tip)
    y = unit(flat(POINT, z))
    return Pose(tip, turn_of(across(y, z), y, z))


def grip(arc_length: float, behind: float, lean: float, up: Optional[float] = None) -> Pose:
    """The tool in the needle's frame: so far from the needle's tip and behind its own, it comes against the needle's axis,
    and leans to an angle in the needle's plane, or outward."""
    angle = -arc_length / NEEDLE_RADIUS
    out = np.array((cos(angle), sin(angle), 0.0))
    up = angle if up is None else up
    z = np.array((sin(lean) * cos(up), sin(lean) * sin(up), -cos(lean)))
    x = unit(flat(out, z))
    return Pose(NEEDLE_RADIUS * out - behind * z, turn_of(x, across(z, x), z))


def go(action: Any, now: Pose, to: Pose, speed: float) -> None:
    """Part of an action: toward a pose, slower when near."""
    action[space.MOVE] = limited((to.at - now.at) / LAG, speed) / space.SPEED
    rotation = rotation_of(turned(to.q, back(now.q)))
    action[space.ROTATE] = limited(rotation / LAG, space.TURN) / space.TURN


def seen_of(observation: Any) -> dict[str, Any]:
    """What is observed, by name; poses as such, without the thread."""
    see = {name: observation[place] for name, place in space.FIELDS.items() if name != "thread"}
    return {**see, **{name: Pose(see[name][:3], see[name][3:]) for name in ("needle", "left", "right")}}


def off(now: Pose, needle: Pose) -> float:
    """From where the needle is to there: of its centre, and of its arc by what it is turned, m."""
    return length(needle.at - now.at) + NEEDLE_RADIUS * needle.angle(now)


class ScriptedStitch:
    """Takes the needle and drives it through both marks. A new one for each episode.

        through  whether it goes on from the taking
    """

    def __init__(self, *, through: bool = True) -> None:
        self.through = through
        self.phase, self.support = "lie", "away"
        self.why = ""
        """Why it has given up."""
        self._since = self._support_since = 0.0
        self._time = 0.0
        self._tries = 0
        self._rest: Optional[Vector] = None
        self._gone, self._along = -BEFORE, 0.0
        self._trim = np.zeros(3)
        self._held = self._from = Pose(np.zeros(3), np.array((1.0, 0.0, 0.0, 0.0)))

    @property
    def done(self) -> bool:
        return self.phase in ("done", "failed")

    def __call__(self, observation: Any) -> Any:
        see = seen_of(observation)
        h, self._time = float(see["time"]) - self._time, float(see["time"])
        self._since += h
        self._support_since += h
        marks = np.array((see["left_mark"], see["right_mark"]))
        if self._rest is None:
            self._rest, self._marks = marks, marks
            self._entry = marks[1]
        share = h / SEEING
        self._marks = (1.0 - share) * self._marks + share * marks
        action = np.zeros(space.ACTIONS)
        left, right = action[:space.ACTIONS // 2], action[space.ACTIONS // 2:]
        left[space.JAWS], right[space.JAWS] = 2.0 * FORK - 1.0, -1.0
        left[space.SHEARS] = right[space.SHEARS] = -1.0
        if self.phase not in ("lie", "reach", "lower", "close"):
            now = see["right"].inverse().after(see["needle"])
            self._held = self._held.mixed(now, share)
            if not see["holds"][1] and not self.done:
                self._fail("the needle is lost")
        getattr(self, f"_{self.phase}")(see, right, h)
        self._bear(see, left)
        return np.clip(action, -1.0, 1.0)

    def _enter(self, phase: str) -> None:
        self.phase, self._since = phase, 0.0

    def _fail(self, why: str) -> None:
        self.why = why
        self._enter("failed")

    # ---- the needle is taken

    def _lie(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        action[space.JAWS] = 2.0 * WIDE - 1.0
        if self._since > 0.2:
            self._enter("reach")

    def _over(self, see: Mapping[str, Any], height: Optional[float]) -> Pose:
        tool: Pose = see["needle"].after(grip(HOLD, 0.0, LEAN, UP))
        at = tool.at.copy()
        at[2] = at[2] + OVER if height is None else height
        return Pose(at, tool.q)

    def _reach(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        tool = self._over(see, None)
        action[space.JAWS] = 2.0 * WIDE - 1.0
        go(action, see["right"], tool, CARRY)
        if length(tool.at - see["right"].at) < 1e-3 and tool.angle(see["right"]) < 0.1:
            self._enter("lower")

    def _lower(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        tool = self._over(see, FLOOR + JAW - PRESS)
        action[space.JAWS] = 2.0 * WIDE - 1.0
        go(action, see["right"], tool, CAREFUL)
        if abs(see["right"].at[2] - tool.at[2]) < 0.1e-3:
            self._enter("close")

    def _close(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        go(action, see["right"], self._over(see, FLOOR + JAW - PRESS), CAREFUL)
        if see["holds"][1] and self._since > 0.25:
            self._held, self._from = see["right"].inverse().after(see["needle"]), see["right"]
            self._enter("lift")
        elif self._since > 0.8:
            self._tries += 1
            self._enter("reach")
            if self._tries == TRIES:
                self._fail("the needle is not taken")

    # ---- to the mark

    def _steer(self, see: Mapping[str, Any], action: Any, needle: Pose, speed: float) -> None:
        """So that the needle comes there; what gives way between it and the hand is seen, a little late."""
        go(action, see["right"], needle.after(self._held.inverse()), speed)

    def _lift(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        up = Pose(self._from.at + np.array((0.0, 0.0, 0.03)), self._from.q)
        go(action, see["right"], up, CARRY)
        if length(up.at - see["right"].at) < 5e-3:
            self._enter("bring" if self.through else "done")

    def _entering(self) -> Pose:
        """Straight through the wall at the entry, turned on by what it has gone."""
        assert self._rest is not None
        y = -_outward(self._rest[1])
        x = across(y, AWAY)
        return Pose(self._entry - NEEDLE_RADIUS * x, turn_of(x, y, AWAY)).rolled(AXIS, self._gone / NEEDLE_RADIUS)

    def _bring(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._entry = self._marks[1]
        needle = self._entering()
        needle = Pose(needle.at + np.array((0.012, 0.0, 0.015)), needle.q)
        self._steer(see, action, needle, CARRY)
        if off(see["needle"], needle) < 4e-3:
            self._enter("aim")

    def _aim(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._entry = self._marks[1]
        needle = self._entering()
        self._steer(see, action, needle, CAREFUL)
        if off(see["needle"], needle) < 1e-3 and self.support == "under" and self._support_since > 0.5:
            self._enter("pierce")

    # ---- through both walls

    def _pierce(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        assert self._rest is not None
        if see["pierced"][0]:
            self._gone, self._entry = float(see["depth"][0]), self._rest[1]
            self._enter("cross")
        elif self._gone < 14e-3:
            self._gone += DRIVE * h
        elif self._since > 5.0:
            self._fail("the right wall is not entered")
        self._steer(see, action, self._entering(), CARRY)

    def _exit(self) -> Vector:
        """The left mark as it is seen; where the needle pushes it out, it is not followed."""
        assert self._rest is not None
        rest, normal = self._rest[0], _outward(self._rest[0])
        moved = self._marks[0] - rest
        moved = moved - max(dot(moved, normal), 0.0) * normal
        return rest + LEAD * across(AWAY, normal) + self._trim + limited(moved, FOLLOW)

    def _crossing(self) -> Pose:
        """On the circle through entry and exit, above which its centre lies."""
        start, end = self._entry, self._exit()
        e1 = unit(start - end)
        e3 = unit(flat(AXIS, e1))
        half = 0.5 * length(start - end)
        centre = 0.5 * (start + end) + math.sqrt(NEEDLE_RADIUS * NEEDLE_RADIUS - half * half) * e3
        x, z = unit(start - centre), across(e3, e1)
        return Pose(centre, turn_of(x, across(z, x), z)).rolled(AXIS, self._gone / NEEDLE_RADIUS)

    def _on(self, see: Mapping[str, Any], action: Any, step: float, h: float) -> None:
        self._gone = min(self._gone + step, LONGEST)
        self._along = min(1.0, self._along + h / 0.5)
        self._steer(see, action, self._entering().mixed(self._crossing(), self._along), CARRY)
        if see["pierced"][1] and self.phase != "draw":
            self._enter("draw")
        elif self._since > 8.0:
            self._fail("the left wall is not left")

    def _cross(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        waits = self._gone >= IN_LUMEN
        self._on(see, action, 0.0 if waits else DRIVE * h, h)
        if self.phase == "cross" and waits and self.support == "on" and self._support_since > 0.4:
            self._enter("leave")

    def _leave(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        needle = see["needle"]
        to = self._marks[0] - needle.at
        z = rotate(needle.q, AXIS)
        in_plane = flat(to, z)
        miss = (length(in_plane) - NEEDLE_RADIUS) * unit(in_plane) + dot(to, z) * z
        self._trim = limited(self._trim + h / 0.1 * miss, FOLLOW)  # the wall drives the tip aside
        self._on(see, action, 0.5 * DRIVE * h * min(max(2.0 - length(miss) / 0.4e-3, 0.05), 1.0), h)

    def _draw(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        self._on(see, action, DRIVE * h, h)
        if self.phase == "draw" and see["depth"][1] > OUT:
            self._enter("done")

    def _done(self, see: Mapping[str, Any], action: Any, h: float) -> None:
        """Holds still."""

    _failed = _done

    # ---- the left hand bears the wall against the needle

    def _bear_on(self, support: str) -> None:
        self.support, self._support_since = support, 0.0

    def _bear(self, see: Mapping[str, Any], action: Any) -> None:
        assert self._rest is not None
        thick = 0.5 * WALL + LEFT_JAW
        left, normals = see["left"], [_outward(mark) for mark in self._rest]
        inside = self._rest[1] + (0.2e-3 - thick) * normals[1]
        outside = self._rest[0] + thick * normals[0] - LOWER * across(AWAY, normals[0])
        way, beside = unit(TROCAR - inside), unit(TROCAR - outside)
        tip = inside - FORK_BEYOND * way
        # support: where to, how fast
        places = {"away": (left.at, CARRY), "over": (tip + 0.02 * way, CARRY), "under": (tip, CAREFUL),
                  "out": (tip + 0.025 * way, CARRY), "beside": (outside + 4e-3 * beside, CARRY),
                  "on": (outside - PUSH * beside, CAREFUL), "back": (outside + 0.03 * beside, CARRY)}
        to, speed = places[self.support]
        go(action, left, _through(to if self.support != "away" else left.at), speed)
        near = length(to - left.at)
        if self.support == "away" and self.phase != "lie":
            self._bear_on("over")
        elif self.support == "over" and near < 0.5e-3:
            self._bear_on("under")
        elif self.support == "under" and self.phase == "cross" and self._gone >= IN_LUMEN:
            self._bear_on("out")
        elif self.support == "out" and near < 1e-3:
            self._bear_on("beside")
        elif self.support == "beside" and near < 0.5e-3:
            self._bear_on("on")
        elif self.support == "on" and see["depth"][1] > HELPED:
            self._bear_on("back")
