"""Vectors, quaternions (w, x, y, z) and poses, as arrays of numpy.

Hands are the same on every machine: this module computes with + - * /, math.sqrt and vblast_ss.elementary, entry by entry
or in a written order."""
from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from .elementary import acos, atan2, cos, sin

Vector = Any
"""Three numbers, an array of numpy."""
Turn = Any
"""A unit quaternion, likewise."""


def dot(a: Any, b: Any) -> float:
    """The sum of products, from the first on."""
    total = 0.0
    for x, y in zip(a.tolist(), b.tolist()):
        total += x * y
    return total


def length(vector: Any) -> float:
    return math.sqrt(dot(vector, vector))


def unit(vector: Vector) -> Vector:
    size = length(vector)
    return vector / size if size > 1e-150 else np.array((0.0, 0.0, 1.0))


def unit_rows(rows: Any) -> Any:
    """Each row of four made a unit quaternion."""
    w, x, y, z = rows.T
    return rows / np.sqrt(w * w + x * x + y * y + z * z)[:, None]


def tremor(times: Any, phases: Vector) -> Any:
    """What a hand adds to where it wants to be, as shares of the tremor's size: at 9, 12 and 10.3 Hz on the three axes."""
    rates = [2.0 * math.pi * hertz for hertz in (9.0, 12.0, 10.3)]
    return np.array([[sin(time * rate + phase) for rate, phase in zip(rates, phases.tolist())] for time in times.tolist()])


def across(a: Vector, b: Vector) -> Vector:
    return np.array((a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]))


def turned(by: Turn, then: Turn) -> Turn:
    """Product of quaternions."""
    a, b = by, then
    vector = a[0] * b[1:] + b[0] * a[1:] + across(a[1:], b[1:])
    return np.array((a[0] * b[0] - dot(a[1:], b[1:]), *vector))


def rotate(q: Turn, vector: Vector) -> Vector:
    t = 2.0 * across(q[1:], vector)
    return vector + q[0] * t + across(q[1:], t)


def back(q: Turn) -> Turn:
    return np.array((q[0], -q[1], -q[2], -q[3]))


def turn_by(rotation: Vector) -> Turn:
    """Of a rotation vector, rad."""
    angle = length(rotation)
    return np.array((cos(0.5 * angle), *(sin(0.5 * angle) * unit(rotation))))


def rotation_of(q: Turn) -> Vector:
    """The rotation vector, rad, the shorter way round."""
    q = q if q[0] >= 0.0 else -q
    sine = length(q[1:])
    return 2.0 * atan2(sine, float(q[0])) * unit(q[1:]) if sine > 0.0 else np.zeros(3)


def turn_of(x: Vector, y: Vector, z: Vector) -> Turn:
    """To a frame of these axes."""
    trace = float(x[0] + y[1] + z[2])
    if trace > 0.0:
        q = np.array((1.0 + trace, y[2] - z[1], z[0] - x[2], x[1] - y[0]))
    elif x[0] > y[1] and x[0] > z[2]:
        q = np.array((y[2] - z[1], 1.0 + x[0] - y[1] - z[2], y[0] + x[1], z[0] + x[2]))
    elif y[1] > z[2]:
        q = np.array((z[0] - x[2], y[0] + x[1], 1.0 + y[1] - x[0] - z[2], z[1] + y[2]))
    else:
        q = np.array((x[1] - y[0], z[0] + x[2], z[1] + y[2], 1.0 + z[2] - x[0] - y[1]))
    return q / length(q)


class Pose(NamedTuple):
    """A place and how something is turned there."""
    at: Vector
    q: Turn

    def point(self, local: Vector) -> Vector:
        return self.at + rotate(self.q, local)

    def after(self, other: Pose) -> Pose:
        """Of what is `other` in the frame of this."""
        return Pose(self.point(other.at), turned(self.q, other.q))

    def inverse(self) -> Pose:
        q = back(self.q)
        return Pose(-rotate(q, self.at), q)

    def mixed(self, other: Pose, share: float) -> Pose:
        """A share of the way there, the shorter way round."""
        near = other.q if dot(self.q, other.q) >= 0.0 else -other.q
        q = (1.0 - share) * self.q + share * near
        return Pose((1.0 - share) * self.at + share * other.at, q / length(q))

    def rolled(self, axis: Vector, angle: float) -> Pose:
        """About an axis of its own frame."""
        return Pose(self.at, turned(self.q, turn_by(angle * axis)))

    def angle(self, other: Pose) -> float:
        """Between the two, rad."""
        return 2.0 * acos(min(1.0, abs(dot(self.q, other.q))))
