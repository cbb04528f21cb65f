"""The three problems that all peers solve: parameters, references, and how a result is judged.

Lengths in m, masses in kg, times in s, forces in N, unless a name says otherwise."""
import math

import numpy as np

RADIUS = 0.125e-3  # of the thread
DIAMETER = 2.0 * RADIUS
LINEAR_DENSITY = 6.4e-5
BENDING = 1e-8  # EI
# EA of a homogeneous round rod with this EI. A peer may take a stiffer one where that suits it better.
SOFT_AXIAL = 4.0 * BENDING / RADIUS**2

# thread: a horizontal cantilever is released and falls.
LENGTH = 0.15
GRAVITY = 9.81
FALL = 0.1
# 480 segments by BDF2 with steps of 10 us; 240 segments agree within 5 um. No peer and not this library made it.
FALLEN_TIP = np.array([132.9157e-3, -46.2432e-3, 0.0])

# capstan: the thread hangs over half of a fixed cylinder whose axis is z; one end bears a load, the other is pulled down.
CYLINDER = 5e-3
MIDDLE = CYLINDER + RADIUS  # radius of the centre line
FRICTION = 0.3
LOAD = 0.02
LOAD_LENGTH, PULL_LENGTH = 15e-3, 10e-3
LOADING = 0.05  # the load grows to LOAD, then the pull begins
PULL_SPEED = 10e-3
SLIDING, PULLED = 0.25, 0.4  # s after the pull starts; the pull is averaged between these times

# trefoil: an open trefoil is pulled until it takes up TIGHT of length, and held.
KNOT_SIZE = 0.75e-3
TAIL = 12e-3
KNOT_FRICTION = 0.1
KNOT_SPEED = 50e-3  # of each end
TIGHT = 14.0 * DIAMETER
HELD = 0.02
MAX_STRETCH = 0.1
DRAG = 200.0  # 1/s, of the capstan and of the trefoil: it damps the start


def capstan_error_percent(pull):
    """How far ln(T2/T1) is from mu pi. A bent rod bears EI/(2 R^2) less than a straight one under the same pull."""
    less = BENDING / (2.0 * MIDDLE**2)
    if not pull > less:
        return math.nan
    return 100.0 * abs(math.log((pull - less) / (LOAD - less)) / (FRICTION * math.pi) - 1.0)


def check_capstan(points):
    """A pull means nothing if the thread is torn, has left the cylinder or lies inside it."""
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    stretch = length / (LOAD_LENGTH + math.pi * MIDDLE + PULL_LENGTH) - 1.0
    nearest = np.hypot(points[:, 0], points[:, 1]).min()
    if not (abs(stretch) < MAX_STRETCH and abs(nearest - MIDDLE) < DIAMETER):
        raise ArithmeticError(f"not a thread on a cylinder: stretched by {100.0 * stretch:.0f} %, {1e3 * nearest:.2f} mm from the axis")


def along(curve, count):
    """The curve, an array of points, cut into `count` segments of equal length."""
    at = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))))
    wanted = np.linspace(0.0, at[-1], count + 1)
    return np.stack([np.interp(wanted, at, curve[:, k]) for k in range(3)], axis=1)


def capstan_points(segments):
    """From the loaded end over the cylinder to the pulled end."""
    angle = np.linspace(0.0, math.pi, 2000)
    arc = np.stack([-MIDDLE * np.cos(angle), MIDDLE * np.sin(angle), 0.0 * angle], axis=1)
    first, last = arc[:1] - [[0.0, LOAD_LENGTH, 0.0]], arc[-1:] - [[0.0, PULL_LENGTH, 0.0]]
    return along(np.concatenate((first, arc, last)), segments)


def trefoil_points(segments):
    """Shastri's polynomial trefoil (Tohoku Math. J. 44, 1992) with straight ends along z."""
    t = np.linspace(-2.2, 2.2, 20001)
    knot = KNOT_SIZE * np.stack([t**3 - 3 * t, t**4 - 4 * t**2, 0.2 * (t**5 - 10 * t)], axis=1)
    tail = np.array([[0.0, 0.0, TAIL]])
    return along(np.concatenate((knot[:1] - tail, knot, knot[-1:] + tail)), segments)


def trefoil_seconds(points):
    """How long the ends of the trefoil move."""
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    apart = np.linalg.norm(points[-1] - points[0])
    return (length - TIGHT - apart) / (2.0 * KNOT_SPEED)
